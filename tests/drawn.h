/* drawn.h -- random slopes with a saddle, and its branches in 113 bits. */
#pragma once

#include <math.h>

#include "block.h"
#include "cusp.h"
#include "laws.h"
#include "quad_branch.h"
#include "tolerance.h"

/* A random slope, solved in 113 bits; the same slope in double needs no
 * rounding of any input. */
struct draw {
    struct law law;
    struct material m;
    long double tan_alpha;
    struct quad_anchor at;
    struct quad_branch upper, lower;
    char name[200];
};

/* Whether doubles hold the system around x: psi within its domain with room to
 * spare, and for (45) a rate exp(-psi_ss) that does not underflow. */
static inline bool draw_is_in_range(const struct draw *d, long double x)
{
    const long double psi = steady_psi(&d->law, &d->m, x);

    return !(law_psi_is_log(&d->law) || law_freezes(&d->law)) ||
           fabsl(psi) < 0.5L * (long double) TOL_PSI_ROOM;
}

/* The slope whose saddle is at x, if there is one there; friction must fall
 * from x - h to x + h. */
static inline bool draw_at(struct draw *d, long double x, long double h)
{
    if (x + h >= steady_x_max(&d->law))
        return false;
    const long double below = steady_mu_log(&d->law, &d->m, x - h);
    const long double above = steady_mu_log(&d->law, &d->m, x + h);
    d->tan_alpha = steady_mu(&d->law, &d->m, x);
    return below > above && d->tan_alpha > 0.02L && d->tan_alpha < 5.0L &&
           draw_is_in_range(d, x);
}

/* Within the range where friction is measured, and beyond. */
static inline bool draw_slope(struct draw *d, uint64_t *seed)
{
    return draw_at(d, (long double) check_uniform(seed, -16, 16), 1e-6L);
}

/* Beside a fold, 1 to 1e-7 from it. */
static inline bool draw_near_fold(struct draw *d, uint64_t *seed)
{
    long double x[4];
    const size_t n = steady_extrema(&d->law, &d->m, x);

    if (n == 0)
        return false;
    const long double aside = (long double) laws_power(seed, -7, 0);
    const long double fold = x[check_bits(seed) % n];
    return draw_at(d, check_bits(seed) % 2 ? fold + aside : fold - aside,
                   1e-9L);
}

/* Between two folds that meet at c*, 1e-2 to 1e-10 of c* before they do, where
 * long doubles tell a slope's place from the folds'. */
static inline bool draw_near_cusp(struct draw *d, uint64_t *seed)
{
    const struct cusp cusp = cusp_find(&d->law, &d->m);
    long double x[4];

    if (cusp.reason)
        return false;
    d->m.c = (double) (cusp.c * (1 - (long double) laws_power(seed, -10, -2)));
    if (steady_extrema(&d->law, &d->m, x) != 2)
        return false;
    const long double wide = x[1] - x[0];
    const long double part = (long double) check_uniform(seed, 0, 1);
    const long double at = x[0] + part * wide;
    const long double h = wide * fminl(part, 1 - part) / 2;
    return steady_mu_log(&d->law, &d->m, at - h) >
               steady_mu_log(&d->law, &d->m, at + h) + 64 * LDBL_EPSILON &&
           draw_at(d, at, h);
}

static inline void draw_name(struct draw *d)
{
    snprintf(
        d->name, sizeof d->name, "%s %s %s %s %s, tan alpha %.17Lg",
        friction_form_names[d->law.form], theta_names[d->law.theta],
        d->law.kinetics == KINETICS_COMPOSITE ? "kato_tullis"
                                              : psi_ss_names[d->law.psi_ss],
        timescale_names[d->law.timescale],
        d->law.kinetics == KINETICS_LINEAR ? "linear" : "sinh", d->tan_alpha);
}

typedef bool draw_how(struct draw *d, uint64_t *seed);

/* The law and the material are there already. */
static inline bool draw_by(draw_how *slope, uint64_t *seed, struct draw *d)
{
    for (int attempt = 0; attempt < 20; attempt++)
        if (slope(d, seed)) {
            draw_name(d);
            return true;
        }
    return false;
}

/* Law i of laws.h and a slope by one of these. */
static inline bool draw_one(size_t i, uint64_t *seed, draw_how *slope,
                            struct draw *d)
{
    return laws_draw(i % LAWS, seed, &d->law, &d->m) && draw_by(slope, seed, d);
}

/* A preset in any form, of Table 2 one time in two. */
static inline bool draw_preset(uint64_t *seed, draw_how *slope, struct draw *d)
{
    struct fault why;
    size_t presets = 0;

    while (law_preset_at(presets))
        presets++;
    d->law = *law_preset_at(check_bits(seed) % presets);
    d->law.form = check_bits(seed) % 2 ? FRICTION_LOG : FRICTION_ASINH;
    d->m = laws_material(seed);
    if (check_bits(seed) % 2) {
        const double V_c = d->m.V_c;
        d->m = material_bristol_board();
        d->m.V_c = V_c;
    }
    return law_check(&d->law, &d->m, &why) == STATUS_OK &&
           draw_by(slope, seed, d);
}

/* The saddle that the numbers are of, to the last of 113 bits. */
static inline bool draw_solve_saddle(struct draw *d, const struct block *b)
{
    for (double width = 1e-15; width < 1e-3; width *= 10) {
        const quad wide = width * (1 + fabs(b->at.x0));
        const quad x = b->at.x0, lo = x - wide, hi = x + wide;
        if (!(quad_block_mu_ss(&d->law, &d->m, lo) > d->tan_alpha &&
              quad_block_mu_ss(&d->law, &d->m, hi) < d->tan_alpha))
            continue;
        quad_block_anchor(
            &d->law, &d->m, d->tan_alpha,
            quad_block_equilibrium(&d->law, &d->m, d->tan_alpha, lo, hi), true,
            &d->at);
        return true;
    }
    return false;
}

/* And its branches. */
static inline bool draw_solve(struct draw *d, const struct block *b)
{
    const double tol = 1e-18;

    return draw_solve_saddle(d, b) &&
           quad_branch_grow(&d->law, &d->at, 1, tol, &d->upper) &&
           quad_branch_grow(&d->law, &d->at, -1, tol, &d->lower);
}
