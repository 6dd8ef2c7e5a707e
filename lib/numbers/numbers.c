/*
 * Numbers from curves.  Error bars: what the integration reports (last terms
 * of every step, tail) plus a floor for rounding, which grows with the size of
 * the logarithms involved and with the cancellation in the determinant of the
 * saddle's Jacobian - the measure of how near a fold is - and what the saddle's
 * own place makes of them (place.h).
 */
#include "numbers.h"

#include <float.h>
#include <math.h>

#include "cusp.h"
#include "knee.h"
#include "limit.h"
#include "numbers_tolerance.h"
#include "place.h"
#include "tolerance.h"

double numbers_cancellation(const struct equilibrium *e)
{
    const struct mat2 m = e->matrix;
    const double det = e->scaled[0] * e->scaled[1];

    return det == 0.0 ? 1.0 / DBL_EPSILON
                      : (fabs(m.xx * m.yy) + fabs(m.xy * m.yx)) / fabs(det);
}

double numbers_floor(const struct block *b)
{
    return TOL_ROUNDING + b->bar;
}

/* The logarithm in mu = a asinh(e^w/2), as far as exp of it is what counts: its
 * rounding is relative to mu then. */
static double log_of_friction(const struct block *b)
{
    return b->law.form == FRICTION_ASINH ? fmax(-b->at.w0, 0.0) : 0.0;
}

struct steady_number numbers_steady(const struct block *b,
                                    const struct equilibrium *e)
{
    const double floor = numbers_floor(b), lost = numbers_cancellation(e);
    const double unit =
        8.0 * DBL_EPSILON *
        (1.0 + 0.25 * (fabs(e->log_scale) + fabs(b->at.log_inertia) +
                       log_of_friction(b)));
    /* rates that go like e^-psi */
    const double rate = law_timescale(&b->law)->psi_ss != 0 || b->law.typed
                            ? floor * (1.0 + fabs(b->at.psi0))
                            : floor;
    const double digits =
        (b->law.typed ? 2.0 * DBL_EPSILON : TOL_ROUNDING) * fabs(b->at.psi0);
    const double psi_floor = b->bar * fabs(block_psi_slope(b)) + digits;
    struct steady_number s = {
        .type = (int8_t) e->type,
        .v = quantity_of(b->at.v0, floor * b->at.v0),
        .psi = quantity_of(b->at.psi0, psi_floor),
        .mu = quantity_of(b->at.mu0, 2.0 * DBL_EPSILON * fabs(b->at.mu0)),
    };

    for (int i = 0; i < 2; i++) {
        const double size = fabs(e->lambda[i]);
        const bool near = fabs(e->scaled[i]) < fabs(e->scaled[1 - i]);
        *(i == 0 ? &s.lambda_minus : &s.lambda_plus) =
            (near || size == 0.0) && equilibrium_is_beyond(e)
                ? quantity_none("the eigenvalue is beyond the range of a "
                                "double")
                : quantity_of(e->lambda[i],
                              size * (unit + rate) * (near ? 1.0 + lost : 4.0));
    }
    return s;
}

static const char no_saddle[] = "there is no saddle at this slope";

struct saddle_numbers numbers_saddle(const struct steady_number *s)
{
    const struct quantity none = quantity_none(no_saddle);

    return s ? (struct saddle_numbers){ s->v, s->psi, s->lambda_minus,
                                        s->lambda_plus }
             : (struct saddle_numbers){ none, none, none, none };
}

/* ---- folds ---------------------------------------------------------- */

static struct quantity fold_angle(const struct law *law,
                                  const struct material *m, long double x)
{
    const double alpha = (double) atanl(steady_mu(law, m, x));

    if (!(alpha > 0.0))
        return quantity_none("mu_ss is not positive there");
    return quantity_of(alpha, 4.0 * DBL_EPSILON * fabs(alpha));
}

static struct quantity fold_rate(long double x)
{
    const double v = (double) expl(x);
    return quantity_of(v, v * (4.0 + fabs((double) x)) * DBL_EPSILON);
}

/* The cusp of Fig 4. */
static void fold_cusp(const struct law *law, const struct material *m,
                      struct fold_numbers *f)
{
    const struct cusp at = cusp_find(law, m);
    struct material there = *m;

    if (at.reason)
        return;
    there.c = (double) at.c;
    f->c_cusp = quantity_of(there.c, 16.0 * DBL_EPSILON * there.c);
    f->alpha_cusp = fold_angle(law, &there, at.x);
}

/* (11), (12), for spinodal laws with theta = ln(c + psi). */
static void fold_estimates(const struct law *law, const struct material *m,
                           struct fold_numbers *f)
{
    const double a = m->a, b = m->b, d = b - a;
    const bool spinodal = law_is_spinodal(law, m);
    const double eps = 16.0 * DBL_EPSILON;

    if (!spinodal || !law_uses(law, MATERIAL_C) || !isfinite(m->R) || !(d > 0))
        return;
    f->v_M_eq11 = quantity_of(a / (d * m->R), eps * a / (d * m->R));
    if (m->c > 0.0)
        f->v_m_eq12 = quantity_of(d / (a * m->c), eps * d / (a * m->c));
}

struct fold_numbers numbers_folds(const struct law *law,
                                  const struct material *m)
{
    static const char monotone[] =
        "mu_ss has no such extremum for this law and material";
    static const char no_estimate[] =
        "the estimate needs a spinodal law with theta = ln(c + psi), finite R "
        "and b > a";
    const struct quantity none = quantity_none(monotone);
    const struct quantity not_this = quantity_none(no_estimate);
    struct fold_numbers f = { none,     none,     none,     none,    none,
                              not_this, not_this, not_this, not_this };
    long double x[4];
    const size_t n = steady_extrema(law, m, x);

    for (size_t i = 0; i < n; i++) {
        const long double h = 1e-4L;
        const long double here = steady_mu_log(law, m, x[i]);
        const bool maximum = here > steady_mu_log(law, m, x[i] - h);
        if (maximum) {
            const double mu = (double) steady_mu(law, m, x[i]);
            f.v_M = fold_rate(x[i]);
            f.alpha_cM = fold_angle(law, m, x[i]);
            f.mu_s = quantity_of(mu, 4.0 * DBL_EPSILON * fabs(mu));
        } else {
            f.v_m = fold_rate(x[i]);
            f.alpha_cm = fold_angle(law, m, x[i]);
        }
    }
    fold_estimates(law, m, &f);
    fold_cusp(law, m, &f);
    return f;
}

/* ---- critical numbers ----------------------------------------------- */

/* Relative rounding of the stable eigenvalue, and direction, in units of
 * roundoff: what cancels in the determinant, shared by both in proportion to
 * the other one. */
static double stable_cancellation(const struct equilibrium *e)
{
    const double minus = fabs(e->scaled[0]), plus = fabs(e->scaled[1]);

    return numbers_cancellation(e) * plus / (plus + minus);
}

/* What rounding of the anchor's numbers does to an offset of size |z| on a
 * branch, absolute: the ratio of both rates is kept to the last bit (steady.h),
 * the logarithm of friction is not. */
static double branch_floor(const struct block *b, const struct equilibrium *e,
                           double z)
{
    const double weak = fmin(fabs(z), 1.0); /* a short branch moves little */

    return DBL_EPSILON * weak *
           (4.0 + 0.5 * log_of_friction(b) + 0.25 * stable_cancellation(e));
}

/* Of v at the saddle, relative: its own rounding and, where nobody need ask how
 * numbers go with its place, what that makes of them. */
#define AT_SADDLE (2.0 * DBL_EPSILON)

/* To an integral over time, relative. */
static double integral_floor(const struct block *b, const struct equilibrium *e)
{
    return branch_floor(b, e, 1.0) +
           DBL_EPSILON * (2.0 + 0.5 * fabs(b->at.log_rate));
}

/* Of a coordinate at the end of a branch, where nobody asks how it goes with
 * the saddle's place: what a power of it makes of that. */
static double place_floor(const struct block *b)
{
    return place_is_felt(b) ? 0.0 : TOL_PLACE_POWER * b->bar;
}

struct limit {
    struct quantity value, log; /* v (or psi) and its ln */
};

/* at e^X with X known to `error`, at the end of a branch; ln = ln(at). */
static struct limit limit_of(long double at, long double ln, double X,
                             double error)
{
    const double value = (double) (at * expl((long double) X));
    const double log = (double) (ln + (long double) X);

    return (struct limit){
        quantity_of(value, value * (expm1(error) + TOL_ROUNDING)),
        quantity_of(log, error + TOL_ROUNDING * fabs(log)),
    };
}

struct builder {
    const struct block *b;
    const struct equilibrium *e;
    const struct branch *upper, *lower;
    struct critical_numbers *out;
};

static enum end_code upper_code(const struct block *b, const struct branch *u)
{
    const struct planar sys = block_planar(b);
    const bool goes_on = u->end == BRANCH_DOMAIN && u->limit.y > 0.0;

    return u->end == BRANCH_LIMIT_X && u->sign > 0            ? END_PSI_INF
           : goes_on && limit_is_none(&sys, 1, 1, u->limit.x) ? END_OPEN
                                                              : END_TRUNCATED;
}

static void upper_numbers(struct builder *n)
{
    const struct branch *u = n->upper;
    const struct block *b = n->b;
    struct critical_numbers *out = n->out;

    out->upper_end = (int8_t) upper_code(b, u);
    if (out->upper_end != END_PSI_INF) {
        const struct quantity none = quantity_none(
            out->upper_end == END_OPEN
                ? "the upper branch is open: v has no limit as psi grows"
            : u->end == BRANCH_STEPS
                ? "the upper branch takes more steps than the bound allows"
                : "whether v has a limit as psi grows is undecided");
        out->v_plus = out->ln_v_plus = none;
        out->x_excess = out->mu_s_num = out->mu_s_mean = none;
        out->fracture_energy = none;
        return;
    }
    const double X = u->limit.x;
    const double floor = place_floor(b) + branch_floor(b, n->e, X);
    const struct limit v = limit_of(expl(b->x), b->x, X, u->error.x + floor);
    out->v_plus = v.value;
    out->ln_v_plus = v.log;
}

/* tan(alpha) + energy/excess, where energy changes by `rise` of itself with the
 * limit of X. */
static struct quantity friction_of(const struct builder *n, double energy,
                                   double rise)
{
    const struct branch *u = n->upper;
    const double t = (double) n->b->tan_alpha, excess = 0.0 - u->total[0];
    const double ratio = energy / excess;
    const double floor = rise * branch_floor(n->b, n->e, u->limit.x) +
                         integral_floor(n->b, n->e) + AT_SADDLE +
                         4.0 * DBL_EPSILON;
    const double relative = branch_error(u, 0, rise, 1.0 / excess) + floor;

    return quantity_of(t + ratio, ratio * relative + DBL_EPSILON * (t + ratio));
}

/* x_excess and the static friction numbers, (32), (41) with exact slip. */
static void static_friction(struct builder *n)
{
    const struct block *b = n->b;
    const struct branch *u = n->upper;
    struct critical_numbers *out = n->out;
    const double t = (double) b->tan_alpha, X = u->limit.x;
    const double k =
        0.5 * material_eps2(&b->material) * hypot(1.0, t) * b->at.v0 * b->at.v0;
    const double excess = 0.0 - u->total[0];
    const double floor = integral_floor(b, n->e) + AT_SADDLE;
    const double dX = u->error.x + branch_floor(b, n->e, X);
    /* relative changes of expm1(X)^2 and expm1(2 X) with X */
    const double square = 2.0 * exp(X) / expm1(X);
    const double rise = 2.0 * exp(2.0 * X) / expm1(2.0 * X);
    const double energy = k * expm1(2.0 * X), mean = k * expm1(X) * expm1(X);
    const double rest = 2.0 * AT_SADDLE + 4.0 * DBL_EPSILON;

    out->x_excess = quantity_of(excess, u->total_error[0] + excess * floor);
    out->fracture_energy = quantity_of(energy, energy * (rise * dX + rest));
    if (!(excess > INTEGRAL_NIL && excess > 2.0 * u->total_error[0])) {
        out->mu_s_num = out->mu_s_mean =
            quantity_none("x_excess is too small for a double to divide by");
        return;
    }
    out->mu_s_num = friction_of(n, energy, rise);
    out->mu_s_mean = friction_of(n, mean, square);
}

static enum end_code lower_code(const struct branch *l)
{
    if (l->end == BRANCH_LIMIT_X && l->sign < 0)
        return END_PSI_0;
    if (l->end == BRANCH_LIMIT_Y && l->sign < 0)
        return END_V_0;
    return END_TRUNCATED;
}

/* Why a lower branch that goes on has no end. */
static const char *why_open(const struct block *b, const struct branch *l)
{
    const double y = b->at.y0 + l->limit.y;

    if (l->end == BRANCH_STEPS)
        return "the lower branch takes more steps than the bound allows";
    return law_psi_is_log(&b->law) && y <= -(1.0 - TOL_SAME) * TOL_RANGE
               ? "the lower branch leaves psi > -1e300 while v > 0"
               : "the lower branch leaves [1e-300, 1e300] without a limit";
}

static void lower_numbers(struct builder *n)
{
    const struct branch *l = n->lower;
    const struct block *b = n->b;
    struct critical_numbers *out = n->out;
    const bool is_log = law_psi_is_log(&b->law);

    out->lower_end = (int8_t) lower_code(l);
    if (out->lower_end == END_PSI_0) {
        const double floor = place_floor(b) + branch_floor(b, n->e, l->limit.x);
        const struct limit v =
            limit_of(expl(b->x), b->x, l->limit.x, l->error.x + floor);
        out->v_minus = v.value;
        out->ln_v_minus = v.log;
        out->psi_at_v0 = quantity_none(
            "the lower branch ends at v_minus > 0 and never meets v = 0");
    } else {
        out->v_minus = out->ln_v_minus =
            quantity_none(out->lower_end == END_V_0
                              ? "the lower branch meets v = 0 at a finite psi"
                              : why_open(b, l));
        out->psi_at_v0 = quantity_none(why_open(b, l));
    }
    if (out->lower_end == END_V_0) {
        const double floor = place_floor(b) + branch_floor(b, n->e, l->limit.y);
        const struct limit psi = limit_of(is_log ? 0.0L : expl(b->y), b->y,
                                          l->limit.y, l->error.y + floor);
        out->psi_at_v0 = is_log ? psi.log : psi.value;
    }
    const double deficit = fabs(l->total[0]);
    /* It goes like v_sp^2, as the way of whatever friction stops. */
    const double floor = integral_floor(b, n->e);

    out->x_deficit =
        l->carry.count == 0 ? quantity_none("nobody asked")
        : out->lower_end == END_TRUNCATED
            ? quantity_none("the lower branch has no end to integrate to")
            : quantity_of(deficit, l->total_error[0] +
                                       deficit * (floor + 2.0 * AT_SADDLE));
}

struct critical_numbers numbers_none(const char *reason)
{
    const struct quantity none = quantity_none(reason);
    const struct knee_number knee = { none, none };

    return (struct critical_numbers){
        .upper_end = -1,
        .lower_end = -1,
        .v_plus = none,
        .ln_v_plus = none,
        .v_minus = none,
        .ln_v_minus = none,
        .psi_at_v0 = none,
        .knee_upper = knee,
        .knee_lower = knee,
        .x_excess = none,
        .x_deficit = none,
        .mu_s_num = none,
        .mu_s_mean = none,
        .fracture_energy = none,
    };
}

struct critical_numbers numbers_no_critical(void)
{
    return numbers_none(no_saddle);
}

struct critical_numbers numbers_placed(const struct block *b,
                                       const struct equilibrium *e,
                                       const struct branch *upper,
                                       const struct branch *lower)
{
    struct critical_numbers out = numbers_no_critical();
    struct builder n = { b, e, upper, lower, &out };

    upper_numbers(&n);
    if (out.upper_end == END_PSI_INF)
        static_friction(&n);
    lower_numbers(&n);
    return out;
}

struct critical_numbers numbers_critical(const struct block *b,
                                         const struct equilibrium *e,
                                         const struct branch *upper,
                                         const struct branch *lower)
{
    struct critical_numbers out = numbers_placed(b, e, upper, lower);

    if (place_is_felt(b))
        place_spread(b, &out);
    return out;
}

/* ---- knees ----------------------------------------------------------- */

static struct knee_number knee_number(const struct block *b,
                                      const struct knee *k)
{
    const double v = block_v(b, k->z.x), psi = block_psi(b, k->z.y);
    const double ex = k->error.x + 2.0 * DBL_EPSILON;
    const double ey = k->error.y + 2.0 * DBL_EPSILON;

    return (struct knee_number){
        quantity_of(v, v * expm1(ex)),
        law_psi_is_log(&b->law) ? quantity_of(psi, ey + DBL_EPSILON * fabs(psi))
                                : quantity_of(psi, psi * expm1(ey)),
    };
}

/* Those of one branch. */
struct knee_list {
    struct knee_number *first, *all;
    size_t *count, *crossings;
};

static void knees_of(const struct block *b, const struct planar *sys,
                     const struct branch *branch, const struct knee_list *out)
{
    static const char never[] = "the slope of this branch never rises through "
                                "1";
    static const char undecided[] = "the slope of this branch comes too near 1 "
                                    "to tell whether it rises through it";
    struct knee found[2 * KNEES_MAX];
    const struct quantity none = quantity_none(never);
    const struct quantity unknown = quantity_none(undecided);
    const size_t n =
        knee_find(sys, branch, place_bars(b), found, 2 * KNEES_MAX);

    *out->count = *out->crossings = 0;
    for (size_t i = 0; i < n && i < 2 * KNEES_MAX; i++) {
        const struct knee *k = &found[i];
        *out->crossings += k->kind != KNEE_UNDECIDED;
        if (k->kind == KNEE_FALLING || *out->count == KNEES_MAX)
            continue;
        out->all[(*out->count)++] =
            k->kind == KNEE_RISING ? knee_number(b, k)
                                   : (struct knee_number){ unknown, unknown };
    }
    *out->first =
        *out->count ? out->all[0] : (struct knee_number){ none, none };
}

void numbers_knees(const struct block *b, const struct planar *sys,
                   const struct branch *upper, const struct branch *lower,
                   struct critical_numbers *out)
{
    const struct knee_list up = { &out->knee_upper, out->knees_upper,
                                  &out->knees_upper_count,
                                  &out->crossings_upper };
    const struct knee_list low = { &out->knee_lower, out->knees_lower,
                                   &out->knees_lower_count,
                                   &out->crossings_lower };

    knees_of(b, sys, upper, &up);
    knees_of(b, sys, lower, &low);
}
