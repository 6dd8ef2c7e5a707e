#include "curve.h"

#include <stdlib.h>

static enum status reserve_pieces(struct curve *c)
{
    if (c->count < c->piece_room)
        return STATUS_OK;
    const size_t room = c->piece_room ? 2 * c->piece_room : 64;
    struct curve_piece *piece = realloc(c->piece, room * sizeof *piece);
    if (piece == NULL)
        return STATUS_NO_MEMORY;
    c->piece = piece;
    c->piece_room = room;
    return STATUS_OK;
}

static enum status reserve_coefs(struct curve *c, size_t more)
{
    if (c->coefs + more <= c->coef_room)
        return STATUS_OK;
    const size_t room = 2 * c->coef_room + 64 * more;
    double *coef = realloc(c->coef, room * sizeof *coef);
    if (coef == NULL)
        return STATUS_NO_MEMORY;
    c->coef = coef;
    c->coef_room = room;
    return STATUS_OK;
}

enum status curve_push(struct curve *c, size_t degree, double **coef)
{
    const size_t size = c->dim * (degree + 1);
    enum status s = reserve_pieces(c);

    if (s == STATUS_OK)
        s = reserve_coefs(c, size);
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

void curve_at(const struct curve *c, size_t piece, double theta, double out[])
{
    const size_t degree = c->piece[piece].degree;

    for (size_t i = 0; i < c->dim; i++) {
        const double *u = curve_component(c, piece, i);
        double sum = u[degree];
        for (size_t j = degree; j-- > 0;)
            sum = sum * theta + u[j];
        out[i] = sum;
    }
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
