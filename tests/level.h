/* level.h -- planar systems whose nullclines are the level sets of simple
 * functions, moved by shears, and what every nullcline must satisfy. */
#pragma once

#include <math.h>
#include <string.h>

#include "check.h"
#include "nullcline.h"
#include "shear.h"
#include "tolerance.h"

/* A scalar function with its gradient. */
typedef double scalar(const double p[], struct vec2 z, struct vec2 *gradient);

/* z' = (x(z), y(z)) exp(log_scale), both moved by shears. */
struct plain {
    scalar *x, *y;
    double p[4];
    struct shear shear[3];
    size_t shears;
    struct vec2 origin;
    double log_scale;
};

static inline double moved(const struct plain *s, scalar *f, struct vec2 z,
                           struct vec2 *gradient)
{
    struct shear_frame frame = { .z = vec2_add(z, s->origin) };

    for (size_t i = s->shears; i-- > 0;)
        frame.z = shear_undo(&s->shear[i], frame.z);
    const double value = f(s->p, frame.z, &frame.gradient);
    for (size_t i = 0; i < s->shears; i++)
        shear_carry(&s->shear[i], &frame);
    *gradient = frame.gradient;
    return value;
}

static inline void plain_jacobian(const void *ctx, struct vec2 z,
                                  struct planar_jacobian *J)
{
    const struct plain *s = ctx;
    struct vec2 gx, gy;

    J->field.direction.x = moved(s, s->x, z, &gx);
    J->field.direction.y = moved(s, s->y, z, &gy);
    J->field.log_scale = s->log_scale;
    J->matrix = (struct mat2){ gx.x, gx.y, gy.x, gy.y };
}

static inline void plain_field(const void *ctx, struct vec2 z,
                               struct planar_field *f)
{
    struct planar_jacobian J;

    plain_jacobian(ctx, z, &J);
    *f = J.field;
}

static inline struct planar planar_of(const struct plain *s)
{
    return (struct planar){
        .name = "plain",
        .domain = { { -50.0, -50.0 }, { 50.0, 50.0 } },
        .origin = s->origin,
        .field = plain_field,
        .jacobian = plain_jacobian,
        .ctx = s,
    };
}

static inline double one(const double p[], struct vec2 z, struct vec2 *g)
{
    (void) p, (void) z;
    *g = (struct vec2){ 0.0, 0.0 };
    return 1.0;
}

static inline double height(const double p[], struct vec2 z, struct vec2 *g)
{
    *g = (struct vec2){ 0.0, 1.0 };
    return z.y - p[1];
}

#define LEVEL_CHORD 1e-3

static inline void find(const struct planar *sys, const struct window *w,
                        struct nullcline out[NULLCLINES])
{
    const enum status s = nullcline_find(sys, w, LEVEL_CHORD, out);
    CHECK(s == STATUS_OK, "%s", status_text(s));
}

static inline void drop(struct nullcline n[NULLCLINES])
{
    for (int k = 0; k < NULLCLINES; k++) {
        nullcline_free(&n[k]);
        nullcline_free(&n[k]);
    }
}

static inline bool on_edge(struct box b, struct vec2 z)
{
    return z.x == b.lo.x || z.x == b.hi.x || z.y == b.lo.y || z.y == b.hi.y;
}

static inline bool is_closed(const struct polyline *p)
{
    return memcmp(&p->at[0], &p->at[p->count - 1], sizeof p->at[0]) == 0;
}

/* Inside the window, closed or with both ends exactly on its edge. */
static inline void check_ends(const struct nullcline *n, const struct window *w)
{
    assert_int_equal(n->loose, 0);
    for (size_t i = 0; i < n->count; i++) {
        const struct polyline *p = &n->piece[i];
        const struct vec2 a = p->at[0], b = p->at[p->count - 1];
        CHECK(p->count >= 2, "%zu points", p->count);
        CHECK(is_closed(p) || (on_edge(w->box, a) && on_edge(w->box, b)),
              "from (%.17g, %.17g) to (%.17g, %.17g)", a.x, a.y, b.x, b.y);
        for (size_t k = 0; k < p->count; k++)
            CHECK(box_holds(w->box, p->at[k]), "(%g, %g)", p->at[k].x,
                  p->at[k].y);
    }
}

/* The largest distance in chart coordinates from a point to the zero set. */
static inline double worst(const struct plain *s, scalar *f,
                           const struct nullcline *n)
{
    double most = 0.0;

    for (size_t i = 0; i < n->count; i++)
        for (size_t k = 0; k < n->piece[i].count; k++) {
            struct vec2 g;
            const struct vec2 z = vec2_sub(n->piece[i].at[k], s->origin);
            const double v = moved(s, f, z, &g);
            most = fmax(most, fabs(v) / fmax(vec2_length(g), 1e-6));
        }
    return most;
}

static inline double length_of(const struct polyline *p)
{
    double sum = 0.0;

    for (size_t k = 1; k < p->count; k++)
        sum += vec2_length(vec2_sub(p->at[k], p->at[k - 1]));
    return sum;
}

/* Distance from a point to a polyline, in units of the window's sides. */
static inline double distance(const struct nullcline *n, const struct window *w,
                              struct vec2 z)
{
    const struct vec2 u = window_unit(w, z);
    double least = INFINITY;

    for (size_t i = 0; i < n->count; i++)
        for (size_t k = 1; k < n->piece[i].count; k++) {
            const struct vec2 a = window_unit(w, n->piece[i].at[k - 1]);
            const struct vec2 b = window_unit(w, n->piece[i].at[k]);
            const struct vec2 d = vec2_sub(b, a), e = vec2_sub(u, a);
            const double l2 = d.x * d.x + d.y * d.y;
            const double t =
                l2 > 0.0 ? fmin(1, fmax(0, (d.x * e.x + d.y * e.y) / l2)) : 0.0;
            least = fmin(least, vec2_length(vec2_sub(e, vec2_scale(t, d))));
        }
    return least;
}
