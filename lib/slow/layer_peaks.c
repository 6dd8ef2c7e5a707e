/* On a step's polynomial (explicit8.h): its further stages, and the shorter
 * steps that judge it, are of one orbit alone. */
#include "layer_peaks.h"

#include <math.h>
#include <string.h>

#include "crest.h"
#include "explicit8_table.h"
#include "slider.h"
#include "slow_tolerance.h"

enum { COEFS = EXPLICIT8_DEGREE + 1, LAST = EXPLICIT8_STAGES };

/* d(x, y, t, slip)/ds, s the arc length. */
static void along(const void *ctx, double s, const double u[], double du[])
{
    const struct slider *slider = ctx;
    struct planar_field f;

    (void) s;
    slider->plane.system.field(slider->plane.system.ctx,
                               (struct vec2){ u[LAYER_X], u[LAYER_Y] }, &f);
    const double size = vec2_length(f.direction);
    du[LAYER_X] = f.direction.x / size;
    du[LAYER_Y] = f.direction.y / size;
    du[LAYER_TIME] = exp(-f.log_scale) / size;
    du[LAYER_SLIP] = exp(slider->block.at.x0 + u[LAYER_X]) * du[LAYER_TIME];
}

/* A number of a point of the orbit. */
typedef double point_value(const struct block *b, struct vec2 z);

static double x_of(const struct block *b, struct vec2 z)
{
    (void) b;
    return z.x;
}

static double mu_of(const struct block *b, struct vec2 z)
{
    return block_mu(b, z);
}

/* A step's polynomial. */
struct arc {
    const struct block *block;
    point_value *value;
    double coef[LAYER_DIM * COEFS];
};

static double on_arc(const void *ctx, double t)
{
    const struct arc *a = ctx;
    const double *c = a->coef;
    struct vec2 z = { 0.0, 0.0 };

    for (int j = COEFS; j-- > 0;)
        z = (struct vec2){ z.x * t + c[j], z.y * t + c[COEFS + j] };
    return a->value(a->block, z);
}

static double at_point(const struct arc *a, const double u[])
{
    return a->value(a->block, (struct vec2){ u[LAYER_X], u[LAYER_Y] });
}

/* Whether it rises along the orbit. */
static bool is_rising(const struct arc *a, const double u[], const double du[])
{
    const double ahead[2] = { u[LAYER_X] + TOL_ASIDE * du[LAYER_X],
                              u[LAYER_Y] + TOL_ASIDE * du[LAYER_Y] };

    return at_point(a, ahead) > at_point(a, u);
}

/* The largest value on the step to u1, whose places err by as much as `error`
 * of it.  At corners polynomials are worse than steps: a shorter step to their
 * peak tells, and on which side of it to look again. */
static void raise_on(const struct landing *l, double h,
                     const struct explicit8 *stages, point_value *value,
                     const double u1[], double error_of, struct layer_peak *p)
{
    const struct slider *slider = l->curve->slider;
    const struct ode ode = { LAYER_DIM, along, slider };
    const double tol = l->options.rtol, atol[LAYER_DIM] = { tol, tol, 1., 1. };
    struct explicit8 work = *stages;
    struct arc a = { &slider->block, value, { 0.0 } };
    double u[LAYER_DIM], end[LAYER_DIM], mid[LAYER_DIM], error[LAYER_DIM];
    double t, doubt = 0.0, seen = at_point(&a, u1);

    memcpy(u, l->u, sizeof u);
    memcpy(end, u1, sizeof end);
    for (int i = 0; i < TOL_ITERATIONS; i++) {
        explicit8_dense(&work, &ode, 0.0, u, h, end, a.coef);
        const double top = crest_of(on_arc, &a, &t);
        if (!(top > fmax(p->value, seen))) {
            layer_peak_raise(p, top, error_of);
            doubt = 0.0;
            break;
        }
        explicit8_try(&work, &ode, 0.0, u, t * h, atol, tol, mid, error);
        const double here = at_point(&a, mid);
        seen = fmax(seen, here);
        doubt = fabs(here - top);
        if (doubt <= tol)
            break;
        along(slider, 0.0, mid, work.k[LAST]);
        if (is_rising(&a, mid, work.k[LAST])) {
            memcpy(u, mid, sizeof u);
            memcpy(work.k[0], work.k[LAST], sizeof work.k[0]);
            h *= 1.0 - t;
            explicit8_try(&work, &ode, 0.0, u, h, atol, tol, end, error);
        } else {
            memcpy(end, mid, sizeof end);
            h *= t;
        }
    }
    layer_peak_raise(p, seen, error_of + doubt);
}

/* The most that friction, from mu0 to mu1, can be on an arc of length h: it
 * changes by a at most per unit of ln v, and by b of y. */
static double most_on(const struct block *b, double mu0, double mu1, double h)
{
    return 0.5 * (mu0 + mu1 + h * hypot(b->steep.x, b->steep.y));
}

void layer_peaks_start(struct landing *l)
{
    const struct arc mu = { &l->curve->slider->block, mu_of, { 0.0 } };
    const double back[] = { -l->du[LAYER_X], -l->du[LAYER_Y] };

    l->out->falls[0] = l->du[LAYER_X] <= 0.0;
    l->out->falls[1] =
        !is_rising(&mu, l->u, l->du) && is_rising(&mu, l->u, back);
    l->out->mu_next = -HUGE_VAL;
}

void layer_peak_raise(struct layer_peak *p, double value, double error)
{
    if (value > p->value) {
        p->value = value;
        p->error = error;
    }
    p->most = fmax(p->most, value + error);
}

double layer_peak_error(const struct layer_peak *p)
{
    return fmax(p->error, p->most - p->value);
}

/* v has a peak where it rises at first and falls at last, mu may have one
 * anywhere. */
void layer_peaks_step(struct landing *l, double h, double across,
                      const struct explicit8 *stages, const double u1[],
                      const double du1[])
{
    const struct block *block = &l->curve->slider->block;
    struct layer *const out = l->out;
    const double mu0 = l->mu;
    const double x_error = TOL_LAYER_TRANSPORT * across;
    const double mu_error = (block->steep.x + block->steep.y) * x_error;

    l->mu = block_mu(block, (struct vec2){ u1[LAYER_X], u1[LAYER_Y] });
    layer_peak_raise(&out->x, u1[LAYER_X], x_error);
    out->mu_next = fmax(out->mu_next, l->mu);
    layer_peak_raise(&out->mu, l->mu, mu_error);
    if (l->du[LAYER_X] > 0.0 && du1[LAYER_X] <= 0.0)
        raise_on(l, h, stages, x_of, u1, x_error, &out->x);
    if (most_on(block, mu0, l->mu, h) > out->mu.most)
        raise_on(l, h, stages, mu_of, u1, mu_error, &out->mu);
}
