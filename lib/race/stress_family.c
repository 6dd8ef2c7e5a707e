#include "stress_family.h"

#include <math.h>
#include <stdlib.h>

#include "labels.h"
#include "slider.h"
#include "steady.h"
#include "stress_tolerance.h"

#define LIST(...)                                                              \
    {                                                                          \
        (const double[]){ __VA_ARGS__ },                                       \
            sizeof((const double[]){ __VA_ARGS__ }) / sizeof(double)           \
    }
#define STARTS(list) .kind = STRESS_START, .start = list, .starts = COUNT(list)
#define PLACES(list) .kind = STRESS_FIELD, .place = list, .places = COUNT(list)
#define COUNT(list)  (sizeof(list) / sizeof *(list))
#define ONCE         STRESS_NOTHING, LIST(1.0)

static const char two[] = "dieterich_gen spinodal_gen";
static const char folded[] = "spinodal spinodal_gen spinodal_phi_gen";
static const char presets[] = "presets";

/* Far corners of the plane, and the smoothest and roughest interfaces. */
static const struct scene_start corners[] = {
    { 1e-200, 1e6 }, { 1e-200, 1e-3 }, { 1e-300, 1e300 }, { 1e300, 1e300 },
    { 1e50, 1e-50 }, { 1.0, 1e6 },     { 1e5, 1e6 },      { 1e6, 1e-6 },
};

/* So fast that inertia carries a block through the slip rates of rest and of
 * nodes; and beside a saddle's fast fibre. */
static const struct scene_start carried[] = { { 1e28, 1e-46 }, { 1e60, 1e10 } };
static const struct scene_start beside[] = { { 6e-13, 8e3 } };

/* The saddle, and points of either branch one and four e-folds away. */
static const struct stress_place close[] = {
    { 0.0, 1e-1 },  { 0.0, 1e-2 },   { 0.0, 1e-3 },  { 0.0, 1e-4 },
    { 0.0, 1e-5 },  { 0.0, 1e-6 },   { 0.0, 1e-7 },  { 0.0, 1e-8 },
    { 0.0, 1e-9 },  { 0.0, 1e-10 },  { 0.0, 1e-11 }, { 0.0, 1e-12 },
    { 0.0, 1e-13 }, { 0.0, 1e-14 },  { 1.0, 1e-1 },  { -1.0, 1e-2 },
    { 4.0, 1e-3 },  { -4.0, 1e-4 },  { 1.0, 1e-5 },  { -1.0, 1e-6 },
    { 4.0, 1e-7 },  { -4.0, 1e-8 },  { 1.0, 1e-9 },  { -1.0, 1e-10 },
    { 4.0, 1e-11 }, { -4.0, 1e-12 }, { 1.0, 1e-13 }, { -1.0, 1e-14 },
};
static const struct stress_place few[] = { { 0.0, 1e-5 },
                                           { 1.0, 1e-8 },
                                           { -1.0, 1e-11 } };

/* clang-format off */
static const struct stress_family table[] = {
    { "laws", presets, FRICTION_LOG, ONCE,
      STRESS_ALPHA, LIST(0.30, 0.34, 0.38), .kind = STRESS_SLOPE },
    { "compositions", "compositions", FRICTION_ASINH, ONCE,
      STRESS_LN_V, LIST(0.5), .kind = STRESS_SLOPE },
    { "eps2", two, FRICTION_LOG,
      STRESS_EPS2, LIST(1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9),
      STRESS_ALPHA, LIST(0.30, 0.34, 0.38), .kind = STRESS_SLOPE },
    { "R", "spinodal spinodal_gen", FRICTION_LOG,
      STRESS_R, LIST(1e-3, 1e-2, 0.1, 1.0, 4.0, 1e4, 1e8, 1e12, HUGE_VAL),
      STRESS_ALPHA, LIST(0.34), .kind = STRESS_SLOPE },
    { "c", "spinodal spinodal_gen", FRICTION_LOG,
      STRESS_C, LIST(0.0, 1e-6, 0.5, 0.9, 1 - 1e-3, 1 - 1e-6, 1 - 1e-9, 1.1),
      STRESS_BETWEEN, LIST(0.5), .kind = STRESS_SLOPE },
    { "b/a-1", two, FRICTION_LOG,
      STRESS_B_OVER_A, LIST(1e-6, 1e-4, 1e-2, 1.0, 4.0, 1e2, 1e3),
      STRESS_LN_V, LIST(-2.0, 2.0), .kind = STRESS_SLOPE },
    { "far", "dieterich_gen perrin", FRICTION_ASINH,
      STRESS_B_OVER_A, LIST(1e-6, 1e-3),
      STRESS_LN_V, LIST(-680.0, -300.0, -100.0, 100.0, 300.0, 680.0),
      .kind = STRESS_SLOPE },
    { "a", two, FRICTION_LOG, STRESS_A, LIST(1e-5, 1e-4, 1e-3, 0.1, 1.0),
      STRESS_LN_V, LIST(-2.0, 2.0), .kind = STRESS_SLOPE },
    { "fold-max", folded, FRICTION_LOG, ONCE,
      STRESS_MAXIMUM, LIST(-1e-6, -1e-9, -1e-12, 0.0, 1e-12, 1e-6),
      .kind = STRESS_SLOPE },
    { "fold-min", folded, FRICTION_LOG, ONCE,
      STRESS_MINIMUM, LIST(-1e-6, -1e-12, 0.0, 1e-12, 1e-9, 1e-6),
      .kind = STRESS_SLOPE },
    { "flat", presets, FRICTION_LOG, ONCE,
      STRESS_ALPHA, LIST(1e-150, 1e-12, 1e-6, 1e-3), .kind = STRESS_SLOPE },
    { "steep", presets, FRICTION_LOG, ONCE,
      STRESS_STEEP, LIST(1e-12, 1e-6, 1e-3, 0.1), .kind = STRESS_SLOPE },
    { "mu_star", "dieterich_gen perrin spinodal_gen", FRICTION_LOG,
      STRESS_MU_STAR, LIST(0.0, 0.1, 1.0, 3.0),
      STRESS_LN_V, LIST(-1.0, 1.0), .kind = STRESS_SLOPE },
    { "V_c", "kato_tullis", FRICTION_LOG,
      STRESS_V_C, LIST(1e-6, 1e-3, 1.0, 1e3, 1e6),
      STRESS_LN_V, LIST(0.0), .kind = STRESS_SLOPE },
    /* the balance of a steady state all but vanishes at the fold's end */
    { "near-fold", "ln_psi.spinodal_unit.slip.sinh ln_psi.spinodal.slip.sinh "
      "ln_c_psi.spinodal.ageing44.sinh psi.inverse.spinodal.linear",
      FRICTION_LOG, STRESS_A, LIST(6e-4, 0.1),
      STRESS_MAXIMUM, LIST(-1e-10, -1e-15, -1e-17), .kind = STRESS_SLOPE },
    /* v of the saddle is 1 to all digits, and psi = -ln v */
    { "edge", "ln_psi.minus_log.slip45.sinh ln_c_psi.minus_log.slip.sinh",
      FRICTION_ASINH, STRESS_A, LIST(1e-4),
      STRESS_LN_V, LIST(-1e-200, -1e-100, -1e-6), .kind = STRESS_SLOPE },
    /* psi, which is a logarithm there, is beyond the plane */
    { "far-psi", "psi.inverse.slip.sinh psi.spinodal.ageing44.linear",
      FRICTION_ASINH, ONCE,
      STRESS_LN_V, LIST(-7.0, -30.0), .kind = STRESS_SLOPE },
    /* mu meets zero on the way of a branch to its asymptote */
    { "kink", "psi.spinodal.ageing44.sinh", FRICTION_ASINH,
      STRESS_B_OVER_A, LIST(10.0, 155.0),
      STRESS_LN_V, LIST(1.0, 4.4), .kind = STRESS_SLOPE },
    { "carried", "dieterich perrin spinodal spinodal_gen", FRICTION_ASINH, ONCE,
      STRESS_ALPHA, LIST(0.34), STARTS(carried) },
    { "fibre", "dieterich_gen", FRICTION_LOG, STRESS_EPS2, LIST(1e-5),
      STRESS_ALPHA, LIST(0.34), STARTS(beside) },
    { "start", presets, FRICTION_ASINH, ONCE,
      STRESS_ALPHA, LIST(0.34), STARTS(corners) },
    { "window", presets, FRICTION_ASINH, ONCE,
      STRESS_ALPHA, LIST(0.30, 0.38), .kind = STRESS_WINDOW },
    { "field", presets, FRICTION_LOG, ONCE,
      STRESS_ALPHA, LIST(0.34), PLACES(close) },
    { "fields", "compositions", FRICTION_ASINH, ONCE,
      STRESS_LN_V, LIST(0.5), PLACES(few) },
};
/* clang-format on */

const struct stress_family *stress_family_at(size_t i)
{
    return i < COUNT(table) ? &table[i] : NULL;
}

/* c at the cusp of Fig 4; zero where nothing weakens. */
static double cusp_c(const struct material *m)
{
    const double rise = fmax(m->b - m->a, 0.0);

    return (1.0 + m->R) * rise * rise / (4.0 * m->a * m->b);
}

bool stress_material(const struct law *law, enum stress_knob knob, double value,
                     struct material *m)
{
    *m = material_bristol_board();
    switch (knob) {
        case STRESS_NOTHING:
            return true;
        case STRESS_EPS2:
            m->g /= value;
            return true;
        case STRESS_R:
            m->R = value;
            return law_uses(law, MATERIAL_R);
        case STRESS_C:
            m->c = value * cusp_c(m);
            return law_uses(law, MATERIAL_C);
        case STRESS_B_OVER_A:
            m->b = m->a * (1.0 + value);
            return true;
        case STRESS_A:
            m->b *= value / m->a;
            m->a = value;
            return true;
        case STRESS_MU_STAR:
            m->mu_star = value;
            return true;
        case STRESS_V_C:
            m->V_c = value;
            return law_uses(law, MATERIAL_V_C);
    }
    return false;
}

/* mu_ss at its last maximum or minimum; false where it has none. */
static bool extreme_friction(const struct law *law, const struct material *m,
                             bool maximum, long double *mu)
{
    const long double aside = 1e-4L;
    long double x[4];
    bool found = false;

    for (size_t i = 0, n = steady_extrema(law, m, x); i < n; i++) {
        const bool high =
            steady_mu_log(law, m, x[i]) > steady_mu_log(law, m, x[i] - aside);
        if (high == maximum) {
            *mu = steady_mu(law, m, x[i]);
            found = true;
        }
    }
    return found;
}

static bool fold_alpha(const struct law *law, const struct material *m,
                       bool maximum, double beyond, double *alpha)
{
    long double mu;

    if (!extreme_friction(law, m, maximum, &mu))
        return false;
    *alpha = (double) (atanl(mu) + (long double) beyond);
    return true;
}

static bool alpha_between(const struct law *law, const struct material *m,
                          double part, double *alpha)
{
    long double low, high;

    *alpha = 0.34;
    if (!extreme_friction(law, m, true, &high))
        return true; /* beyond the cusp any slope will do */
    if (!extreme_friction(law, m, false, &low))
        low = 0.5L * high;
    *alpha = (double) atanl(low + (long double) part * (high - low));
    return true;
}

bool stress_alpha(const struct law *law, const struct material *m,
                  enum stress_slope slope, double at, double *alpha)
{
    bool found = true;

    switch (slope) {
        case STRESS_ALPHA:
            *alpha = at;
            break;
        case STRESS_STEEP:
            *alpha = M_PI_2 - at;
            break;
        case STRESS_LN_V:
            *alpha = (double) atanl(steady_mu(law, m, (long double) at));
            found = (long double) at < steady_x_max(law);
            break;
        case STRESS_MAXIMUM:
        case STRESS_MINIMUM:
            found = fold_alpha(law, m, slope == STRESS_MAXIMUM, at, alpha);
            break;
        case STRESS_BETWEEN:
            found = alpha_between(law, m, at, alpha);
            break;
    }
    return found && *alpha > 0.0 && *alpha < M_PI_2;
}

/* ---- where fields are looked at ------------------------------------------ */

/* What does not fit on a stack, and must not move. */
struct work {
    struct slider slider;
    struct labels labels;
};

/* The first end of a piece of the branch that far from the saddle, or the point
 * there of a branch that is straight beyond its last one. */
static bool find_offset(const struct branch *b, double far, struct vec2 *out)
{
    for (size_t i = 0; i < b->curve.count; i++) {
        *out = curve_point(&b->curve, i, 1.0);
        if (fmax(fabs(out->x), fabs(out->y)) >= far)
            return true;
    }
    *out = b->limit;
    if (b->end == BRANCH_LIMIT_X)
        out->y = copysign(far, b->limit.y);
    else if (b->end == BRANCH_LIMIT_Y)
        out->x = copysign(far, b->limit.x);
    return b->curve.count > 0 &&
           (b->end == BRANCH_LIMIT_X || b->end == BRANCH_LIMIT_Y);
}

/* On one of the stable branches, which begin at the saddle on either side. */
static bool find_point(const struct labels *l, double along, struct vec2 *out)
{
    for (int i = 0; i < 2; i++)
        if (find_offset(&l->stable[i], fabs(along), out) &&
            out->x * along > 0.0)
            return true;
    return false;
}

static void put(const struct slider *s, struct vec2 offset,
                struct stress_centre *out)
{
    const struct planar *system = &s->plane.system;
    const struct vec2 z = vec2_add(system->origin, offset);

    *out = (struct stress_centre){ true, exp(z.x),
                                   system->axis[1].is_log ? exp(z.y) : z.y };
}

static enum status find(struct work *w, double along, struct stress_centre *out)
{
    struct vec2 offset = { 0.0, 0.0 };

    if (!slider_has_manifolds(&w->slider))
        return STATUS_OK;
    if (along == 0.0) {
        put(&w->slider, offset, out);
        return STATUS_OK;
    }
    const enum status s =
        labels_init(&w->labels, &w->slider, STRESS_PLACE_RTOL, NULL);
    if (s == STATUS_OK && find_point(&w->labels, along, &offset))
        put(&w->slider, offset, out);
    return s == STATUS_NO_MEMORY ? s : STATUS_OK;
}

enum status stress_place_find(const struct law *law, const struct material *m,
                              double alpha, double along,
                              struct stress_centre *out)
{
    struct work *w = calloc(1, sizeof *w);

    *out = (struct stress_centre){ .exists = false };
    if (w == NULL)
        return STATUS_NO_MEMORY;
    slider_init(&w->slider, law, m, tanl((long double) alpha));
    const enum status s = find(w, along, out);
    labels_free(&w->labels);
    free(w);
    return s;
}
