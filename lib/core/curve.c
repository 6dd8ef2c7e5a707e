#include "curve.h"

#include <stdlib.h>

#include "room.h"

enum status curve_push(struct curve *c, size_t degree, double **coef)
{
    const size_t size = c->dim * (degree + 1);
    enum status s = ROOM_FOR(c->piece, c->piece_room, c->count + 1);

    if (s == STATUS_OK)
        s = ROOM_FOR(c->coef, c->coef_room,
                     c->coefs ? c->coefs + size : c->piece_room * size);
    if (s != STATUS_OK)
        return s;
    c->piece[c->count++] = (struct curve_piece){ degree, c->coefs, 0.0, 0.0 };
    *coef = c->coef + c->coefs;
    c->coefs += size;
    return STATUS_OK;
}

const double *curve_component(const struct curve *c, size_t piece, size_t i)
{
    const struct curve_piece *p = &c->piece[piece];
    return c->coef + p->first + i * (p->degree + 1);
}

static double value_of(const struct curve *c, size_t piece, size_t i,
                       double theta)
{
    const size_t degree = c->piece[piece].degree;
    const double *u = curve_component(c, piece, i);
    double sum = u[degree];

    for (size_t j = degree; j-- > 0;)
        sum = sum * theta + u[j];
    return sum;
}

void curve_at(const struct curve *c, size_t piece, double theta, double out[])
{
    for (size_t i = 0; i < c->dim; i++)
        out[i] = value_of(c, piece, i, theta);
}

struct vec2 curve_point(const struct curve *c, size_t piece, double theta)
{
    return (struct vec2){ value_of(c, piece, 0, theta),
                          value_of(c, piece, 1, theta) };
}

void curve_slope_at(const struct curve *c, size_t piece, double theta,
                    double out[])
{
    const size_t degree = c->piece[piece].degree;

    for (size_t i = 0; i < c->dim; i++) {
        const double *u = curve_component(c, piece, i);
        double sum = 0.0;
        for (size_t j = degree; j >= 1; j--)
            sum = sum * theta + (double) j * u[j];
        out[i] = sum;
    }
}

void curve_free(struct curve *c)
{
    free(c->piece);
    free(c->coef);
    *c = CURVE_EMPTY(c->dim);
}
