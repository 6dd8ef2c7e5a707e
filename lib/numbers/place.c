/*
 * N' is the difference of two runs, at the saddle's place and a bit further
 * into the part of the steady curve that holds saddles, over their distance;
 * what their own bars leave open is added.
 */
#include "place.h"

#include <float.h>
#include <math.h>

#include "numbers_tolerance.h"

struct vec2 place_bars(const struct block *b)
{
    const double x = b->bar, psi = fmax(fabs(b->at.psi0), DBL_MIN);
    const double slope =
        law_psi_is_log(&b->law) ? block_psi_slope(b) : block_psi_slope(b) / psi;

    return (struct vec2){ x, slope * x };
}

bool place_is_felt(const struct block *b)
{
    return TOL_PLACE_POWER * b->bar > DBL_EPSILON;
}

/* Away from the nearer fold. */
static long double step_of(const struct block *b)
{
    const struct planar_steady *s = &b->steady;
    long double lo = s->lo, hi = s->hi;

    for (size_t i = 0; i < s->turnings; i++)
        if (s->turning[i] < b->x)
            lo = fmaxl(lo, s->turning[i]);
        else
            hi = fminl(hi, s->turning[i]);
    const long double down = b->x - lo, up = hi - b->x;
    return up > down ? fminl(up / 2, TOL_EXTREMUM_REACH)
                     : -fminl(down / 2, TOL_EXTREMUM_REACH);
}

static enum status run_at(const struct block *b, long double x, double rtol,
                          struct critical_numbers *out)
{
    struct block here = *b;
    struct grow_options o = grow_defaults(rtol);
    struct equilibrium e;
    struct local_series u;
    struct branch branch[2];

    block_anchor(&here, x, true);
    const struct planar sys = block_planar(&here);
    equilibrium_at(&sys, false, &e);
    o.carry = (struct carry){ { BLOCK_EXCESS }, 1 };
    enum status status = local_at(&sys, &e, MANIFOLD_STABLE, &o.carry, o.order,
                                  TOL_TAYLOR_STEP * rtol, &u);
    if (status == STATUS_OK)
        status = grow_branches(&sys, &u, &o, branch);
    if (status != STATUS_OK)
        return status;
    const int up = u.ind == 0 || u.c[1] > 0.0 ? 0 : 1;
    *out = numbers_placed(&here, &e, &branch[up], &branch[1 - up]);
    branch_free(&branch[0]);
    branch_free(&branch[1]);
    return STATUS_OK;
}

static void spread(double by, const struct quantity *near,
                   const struct quantity *far, struct quantity *q)
{
    if (!quantity_exists(q))
        return;
    const double change =
        quantity_exists(near) && quantity_exists(far)
            ? fabs(far->value - near->value) + near->error + far->error
            : HUGE_VAL;
    *q = quantity_of(q->value, q->error + by * change);
}

void place_spread(const struct block *b, struct critical_numbers *out)
{
    static const size_t member[] = {
        offsetof(struct critical_numbers, v_plus),
        offsetof(struct critical_numbers, ln_v_plus),
        offsetof(struct critical_numbers, v_minus),
        offsetof(struct critical_numbers, ln_v_minus),
        offsetof(struct critical_numbers, psi_at_v0),
        offsetof(struct critical_numbers, x_excess),
        offsetof(struct critical_numbers, x_deficit),
        offsetof(struct critical_numbers, mu_s_num),
        offsetof(struct critical_numbers, mu_s_mean),
        offsetof(struct critical_numbers, fracture_energy),
    };
    const struct critical_numbers none = numbers_no_critical();
    struct critical_numbers run[2] = { none, none };
    const long double step = step_of(b);
    const double far = (double) fabsl(step);
    const double rtol = fmax((double) TOL_EXTREMUM_REACH * far, TOL_FINEST);

    for (int i = 0; i < 2; i++)
        if (run_at(b, b->x + i * step, rtol, &run[i]) != STATUS_OK)
            run[i] = none;
    for (size_t i = 0; i < sizeof member / sizeof *member; i++) {
        const char *near = (const char *) &run[0] + member[i];
        const char *away = (const char *) &run[1] + member[i];
        char *at = (char *) out + member[i];
        spread(b->bar / far, (const struct quantity *) (const void *) near,
               (const struct quantity *) (const void *) away,
               (struct quantity *) (void *) at);
    }
}
