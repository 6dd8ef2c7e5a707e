/*
 * The graph of an invariant manifold over one coordinate, by the recursion of
 * its invariance equation  S(s) f_ind(s) = f_dep(s),  S = d dep/d ind, order
 * by order: at a saddle both sides vanish and order k gives
 *     c[k] (k lambda - mu) = known,   lambda this, mu the other eigenvalue,
 * which is never singular (Poincare; Cabre, Fontich & de la Llave 2005).
 * What is ours: the field comes as jets, so no formula is differentiated by
 * hand, and the radius is checked against the field itself.
 */
#include "local.h"

#include <assert.h>
#include <float.h>
#include <math.h>

#include "local_lanes.h"
#include "many.h"
#include "tolerance.h"

void local_integral_floor(size_t order, double along, double u[])
{
    if (fmin(fabs(u[order - 1]), fabs(u[order])) * fabs(along) > DBL_MIN)
        return; /* far above: TOL_ROUNDINGS DBL_TRUE_MIN are less */
    const double lost = TOL_ROUNDINGS * DBL_TRUE_MIN / fabs(along);
    const bool nil = fmax(fabs(u[1]), lost) <= INTEGRAL_NIL;

    for (size_t k = order - 1; k <= order && !nil; k++)
        if (fabs(u[k]) < lost)
            u[k] = lost;
}

double local_slope(const struct planar *sys, int ind, struct vec2 z)
{
    struct planar_field f;

    sys->field(sys->ctx, z, &f);
    return local_quotient(ind, f.direction);
}

struct vec2 local_series_at(const struct local_series *u, double s)
{
    return local_point(u->ind, s * u->unit, jet_at(u->order, u->c, s));
}

/* Radius at which the last two terms of u fall to tol times its first - or,
 * where that is zero by symmetry, its largest - coefficient. */
static double radius_of(const double u[], size_t order, double tol)
{
    double radius = HUGE_VAL, size = fabs(u[1]);

    for (size_t k = 2; u[1] == 0.0 && k <= order; k++)
        size = fmax(size, fabs(u[k]));
    for (size_t k = order - 1; k <= order; k++)
        if (u[k] != 0.0)
            radius = fmin(radius,
                          pow(tol * size / fabs(u[k]), 1.0 / (double) (k - 1)));
    return radius;
}

/* The series' slope at -s and s against that of the field, which is seen there,
 * relative; terms below the least double are lost. */
static double slope_defect(const struct local_series *u, double s,
                           const struct planar_look seen[2])
{
    double worst = 0.0;

    for (int i = 0; i < 2; i++) {
        const double t = i == 0 ? -s : s;
        const double slope = jet_slope_at(u->order, u->c, t) / u->unit;
        const double field = local_quotient(u->ind, seen[i].J.field.direction);
        const double lost = TOL_ROUNDINGS * DBL_TRUE_MIN / u->unit;
        const double off = fdim(fabs(slope - field), lost);
        const double size = fabs(slope) + fabs(u->c[1] / u->unit);
        const double defect = off == 0.0 ? 0.0 : off / size;
        if (!(defect <= worst))
            worst = defect;
    }
    return worst;
}

/* Relative rounding of the field's slope near the saddle along the manifold:
 * on a slow manifold each component is a small difference of large terms. */
static double slope_rounding(const struct equilibrium *e, double lambda,
                             const struct local_series *u)
{
    const struct mat2 m = e->matrix;
    const double c = u->c[1] / u->unit, size = fabs(lambda);
    const double ind =
        u->ind == 0 ? fabs(m.xx) + fabs(m.xy * c) : fabs(m.yy) + fabs(m.yx * c);
    const double dep =
        u->ind == 0 ? fabs(m.yx) + fabs(m.yy * c) : fabs(m.xy) + fabs(m.xx * c);
    const double lost = ind / size + (c == 0.0 ? 0.0 : dep / fabs(size * c));
    return 8.0 * DBL_EPSILON * (lost + 32.0);
}

/* By its terms. */
static double radius_at_most(const struct local_job *j)
{
    const struct local_series *u = j->out;
    double radius = radius_of(u->c, u->order, j->tol);

    for (size_t i = 0; i < j->carry->count; i++)
        if (u->converges[i] && fabs(u->integral[i][1]) > INTEGRAL_NIL)
            radius = fmin(radius, radius_of(u->integral[i], u->order, j->tol));
    return fmin(0.9 * radius, TOL_SERIES_RADIUS_MAX);
}

/* Whether the field agrees with j's series at its radius. */
static bool holds(const struct local_job *j, const struct planar_look seen[2])
{
    const struct local_series *u = j->out;
    const double rounding = slope_rounding(
        j->e, j->e->scaled[j->kind == MANIFOLD_STABLE ? 0 : 1], u);

    return slope_defect(u, u->radius, seen) <=
           TOL_SLOPE_CHECK * j->tol + rounding;
}

/* Halves the radii of those where it does not; returns how many these are, the
 * first ones of job then.  All are of planes that are alike. */
static size_t halve(struct local_job *job[], size_t n)
{
    const struct planar *sys[2 * LOCAL_JOBS];
    struct planar_look seen[2 * LOCAL_JOBS];
    struct vec2 z[2 * LOCAL_JOBS];
    size_t left = 0;

    for (size_t i = 0; i < 2 * n; i++) {
        const struct local_series *u = job[i / 2]->out;
        sys[i] = job[i / 2]->sys;
        z[i] = local_series_at(u, i % 2 ? u->radius : -u->radius);
    }
    many_at(sys, 2 * n, z, -1, false, seen);
    for (size_t i = 0; i < n; i++)
        if (holds(job[i], &seen[2 * i])) {
            job[i]->status = STATUS_OK;
        } else {
            job[i]->out->radius *= 0.5;
            job[left++] = job[i];
        }
    return left;
}

static void find_radii(struct local_job *const job[], size_t n)
{
    struct local_job *left[LOCAL_JOBS];

    for (size_t i = 0; i < n; i++) {
        left[i] = job[i];
        job[i]->out->radius = radius_at_most(job[i]);
        job[i]->status = STATUS_NO_CONVERGENCE;
    }
    for (int i = 0; i < 60 && n > 0; i++)
        n = halve(left, n);
}

/* The length over which the field changes, in units: from the larger of the
 * last two coefficients, for one may vanish by symmetry; 0 where they have
 * overflowed, infinite where both vanish. */
static double length_of(const struct local_series *u)
{
    const double first = u->c[1] == 0.0 ? u->unit : u->c[1];
    double length = HUGE_VAL;

    for (size_t k = u->order - 1; k <= u->order; k++) {
        const double ratio = fabs(u->c[k] / first);
        if (!isfinite(ratio))
            return 0.0;
        if (ratio > 0.0)
            length = fmin(length, pow(ratio, -1.0 / (double) (k - 1)));
    }
    return length;
}

/* A series in the making. */
static struct local_seed seed_of(const struct local_job *j, double unit)
{
    const int stable = j->kind == MANIFOLD_STABLE ? 0 : 1;
    const double along = j->e->scaled[stable],
                 across = j->e->scaled[1 - stable];
    const struct vec2 v = mat2_eigenvector(j->e->matrix, along);

    return (struct local_seed){ .ind = j->ind,
                                .unit = unit,
                                .slope = local_quotient(j->ind, v),
                                .along = along,
                                .across = across,
                                .log_scale = j->e->log_scale };
}

/* Those of the first jobs that go side by side; returns how many. */
static size_t build(struct local_job *const job[], size_t n, double unit)
{
    const struct planar *sys[JET_MANY];
    struct local_series *out[JET_MANY];
    struct local_seed seed[JET_MANY];
    const struct planar_many *many = n > 1 ? job[0]->sys->many : NULL;
    size_t some = 0;

    for (; some < (many ? n : 1) && some < JET_MANY; some++) {
        const struct local_job *j = job[some];
        if (!many_alike(job[0]->sys, j->sys) || j->order != job[0]->order ||
            !many_carry_alike(j->carry, job[0]->carry))
            break;
        sys[some] = j->sys;
        out[some] = j->out;
        seed[some] = seed_of(j, unit);
    }
#ifdef HAVE_WIDE_LANES
    if (many)
        (many->width == 8 ? local_build_8 : local_build_4)(
            sys, job[0]->carry, job[0]->order, some, seed, out);
    else
#endif
        local_build_2(sys, job[0]->carry, job[0]->order, 1, seed, out);
    return many ? some : 1;
}

/* Once more in a smaller unit - found by bisection of its exponent - where
 * powers of the length over which the field changes would overflow. */
static void shrink(struct local_job *j)
{
    const double near = TOL_SAME;
    int least = DBL_MIN_EXP, most = 0, exponent = 0;

    for (;;) {
        const double length = length_of(j->out);
        if (length > near && (length < 1.0 / near || exponent == 0))
            break;
        const bool ends = most - least < 2;
        if (ends && (length > near || exponent == least))
            break;
        *(length > near ? &least : &most) = exponent;
        exponent = ends ? least : least + (most - least) / 2;
        build(&j, 1, ldexp(1.0, exponent));
    }
}

static enum status check(const struct local_job *j)
{
    const struct local_seed s = seed_of(j, 1.0);

    if (j->sys->jet == NULL || j->order < 4 || j->order >= JET_SIZE)
        return STATUS_BAD_ARGUMENT;
    if (j->kind == MANIFOLD_STABLE ? !(s.along < 0.0 && s.across >= 0.0)
                                   : !(s.along > 0.0 && s.across <= 0.0))
        return STATUS_NOT_HYPERBOLIC;
    if (equilibrium_is_beyond(j->e))
        return STATUS_NOT_HYPERBOLIC;
    return isfinite(s.slope) ? STATUS_OK : STATUS_NO_CONVERGENCE;
}

void local_jobs(struct local_job job[], size_t n)
{
    struct local_job *good[LOCAL_JOBS];
    size_t count = 0;

    assert(n <= LOCAL_JOBS);
    for (size_t i = 0; i < n; i++) {
        job[i].status = check(&job[i]);
        if (job[i].status == STATUS_OK)
            good[count++] = &job[i];
    }
    for (size_t i = 0, some; i < count; i += some) {
        some = build(good + i, count - i, 1.0);
        for (size_t k = i; k < i + some; k++)
            shrink(good[k]);
        find_radii(good + i, some);
    }
}

int local_flatter(const struct equilibrium *e, enum manifold_kind kind)
{
    const double along = e->scaled[kind == MANIFOLD_STABLE ? 0 : 1];
    const struct vec2 v = mat2_eigenvector(e->matrix, along);

    return fabs(v.y) <= fabs(v.x) ? 0 : 1;
}

enum status local_over(const struct planar *sys, const struct equilibrium *e,
                       enum manifold_kind kind, int ind,
                       const struct carry *carry, size_t order, double tol,
                       struct local_series *out)
{
    struct local_job job = { sys,   e,   kind, ind,      carry,
                             order, tol, out,  STATUS_OK };

    local_jobs(&job, 1);
    return job.status;
}

enum status local_at(const struct planar *sys, const struct equilibrium *e,
                     enum manifold_kind kind, const struct carry *carry,
                     size_t order, double tol, struct local_series *out)
{
    return local_over(sys, e, kind, local_flatter(e, kind), carry, order, tol,
                      out);
}
