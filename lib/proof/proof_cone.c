#include "proof_cone.h"

#include <float.h>

#include "proof_flow.h"
#include "proof_short.h"
#include "proof_tolerance.h"

/* ---- the saddle ---------------------------------------------------------- */

/* lambda^2 - tr lambda + det = 0 with det < 0: the root away from 0 first. */
bool proof_is_saddle(struct interval_tape *t, struct proof_saddle *out)
{
    struct proof_flow j[2];

    proof_flow_slopes(t, 0, point(0), point(0), j);
    const struct interval xx = j[0].ind.c[1], xy = j[1].ind.c[1];
    const struct interval yx = j[0].dep.c[1], yy = j[1].dep.c[1];
    const struct interval det = interval_less(times(xx, yy), times(xy, yx));
    const struct interval trace = add(xx, yy), four = point(4);
    const struct interval root =
        interval_sqrt(interval_less(times(trace, trace), times(four, det)));
    const struct interval unit = interval_exp(point(j[0].log_scale));

    if (!(det.hi < 0) || !interval_is_finite(root))
        return false;
    const struct interval minus = times(point(0.5), interval_less(trace, root));
    out->lambda_minus = times(unit, minus);
    out->lambda_plus = times(unit, interval_divide(det, minus));
    return true;
}

/* ---- on the polynomial --------------------------------------------------- */

/* f_ind/theta, f_dep/theta and (v - v_sp)/theta along p, polynomials of degree
 * n - 1 whose last coefficient is Lagrange's: f = 0 at the saddle. */
struct along {
    struct interval ind[JET_SIZE], dep[JET_SIZE], excess[JET_SIZE];
};

static void divide_by_theta(size_t n, const struct proof_flow *centre,
                            const struct proof_flow *all, struct along *out)
{
    for (size_t k = 0; k < n; k++) {
        const struct proof_flow *f = k + 1 < n ? centre : all;
        out->ind[k] = f->ind.c[k + 1];
        out->dep[k] = f->dep.c[k + 1];
        out->excess[k] = f->excess.c[k + 1];
    }
}

/* Both flows have to have the same factor: one call's is taken for all. */
static bool expand(struct interval_tape *t, const struct proof_piece *piece,
                   double reach, struct along *out)
{
    const size_t n = piece->degree;
    const struct interval box = { 0, reach };
    struct interval c[JET_SIZE], wide[JET_SIZE];
    struct proof_flow centre, all;

    proof_points(n, piece->coef, c);
    proof_shift(n, c, box, wide);
    proof_flow_along(t, piece->ind, point(0), piece->step, c, n, &centre);
    proof_flow_along(t, piece->ind, times(box, point(piece->step)), piece->step,
                     wide, n, &all);
    const struct interval factor = interval_exp(
        interval_less(point(all.log_scale), point(centre.log_scale)));
    all.ind.c[n] = times(all.ind.c[n], factor);
    all.dep.c[n] = times(all.dep.c[n], factor);
    all.excess.c[n] = times(all.excess.c[n], factor);
    divide_by_theta(n, &centre, &all, out);
    return interval_is_finite(factor);
}

/* u - q w: coefficients to order 2 (n - 1) of polynomials of n terms. */
static void residual(size_t n, const struct interval u[],
                     const struct interval q[], const struct interval w[],
                     struct interval out[])
{
    for (size_t k = 0; k < 2 * n - 1; k++) {
        struct interval sum = k < n ? u[k] : point(0);
        for (size_t j = k < n ? 0 : k - n + 1; j <= k && j < n; j++)
            sum = interval_less(sum, times(q[j], w[k - j]));
        out[k] = sum;
    }
}

/* sup |step f_dep/f_ind - p'| = sup |step N - p' M|/inf |M|. */
static double defect_of(const struct proof_piece *piece, const struct along *f,
                        double reach, double least)
{
    const size_t n = piece->degree;
    struct interval slope[JET_SIZE], n_of[JET_SIZE], off[2 * JET_SIZE];

    for (size_t k = 0; k < n; k++) {
        slope[k] = times(point((double) (k + 1)), point(piece->coef[k + 1]));
        n_of[k] = times(point(piece->step), f->dep[k]);
    }
    residual(n, n_of, slope, f->ind, off);
    return interval_up(
        interval_divide(point(proof_size(off, 0, 2 * n - 2, reach)),
                        point(least))
            .hi);
}

/* ---- in the cone --------------------------------------------------------- */

/* What holds at every point of 0 < theta <= reach, |dep - p| <= slope theta,
 * in one factor. */
struct inside {
    struct interval m;      /* f_ind/theta */
    struct interval slope;  /* f_dep/f_ind */
    struct interval g;      /* theta d(step G)/d dep */
    struct interval across; /* theta d(step (v - v_sp)/f_ind)/d dep */
};

/* dep/theta = p/theta +- slope; differences from the saddle by mean values of
 * the Jacobian over the box [0, reach] x dep. */
static bool look_inside(struct interval_tape *t,
                        const struct proof_piece *piece, double reach,
                        double slope, struct inside *out)
{
    const struct interval box = { 0, reach };
    const struct interval step = point(piece->step);
    const struct interval sigma =
        add(proof_poly_at(piece->degree - 1, piece->coef + 1, box),
            interval_within(slope));
    struct proof_flow j[2];

    proof_flow_slopes(t, piece->ind, times(step, box), times(sigma, box), j);
    if (!interval_is_finite(sigma) || j[0].log_scale < j[1].log_scale ||
        j[0].log_scale > j[1].log_scale)
        return false;
    out->m = add(times(step, j[0].ind.c[1]), times(sigma, j[1].ind.c[1]));
    if (!(times(out->m, step).hi < 0))
        return false;
    const struct interval G = out->slope = interval_divide(
        add(times(step, j[0].dep.c[1]), times(sigma, j[1].dep.c[1])), out->m);
    const struct interval q = interval_divide(
        add(times(step, j[0].excess.c[1]), times(sigma, j[1].excess.c[1])),
        out->m);
    out->g = interval_divide(
        times(step, interval_less(j[1].dep.c[1], times(G, j[1].ind.c[1]))),
        out->m);
    out->across = interval_divide(
        times(step, interval_less(j[1].excess.c[1], times(q, j[1].ind.c[1]))),
        out->m);
    return interval_is_finite(out->g) && interval_is_finite(out->across);
}

struct interval proof_cone_slope(struct interval_tape *t,
                                 const struct proof_piece *piece, double reach,
                                 double slope)
{
    struct inside in;

    return look_inside(t, piece, reach, slope, &in)
               ? in.slope
               : (struct interval){ -HUGE_VAL, HUGE_VAL };
}

/* The least |M| on p: M_0 and what the other terms can take from it. */
static double least_of(size_t n, const struct along *f, double reach)
{
    const double rest = proof_size(f->ind, 1, n - 1, reach);

    return interval_down(
        interval_less(point(interval_least(f->ind[0])), point(rest)).lo);
}

/* The integral of q = step (v - v_sp)/(-f_ind) over the cone: a polynomial
 * quotient, its residual over inf |M|, and |dep - p| <= slope theta. */
static struct interval excess_of(const struct proof_piece *piece,
                                 const struct along *f, const struct inside *in,
                                 const struct proof_cone *cone, double least)
{
    const size_t n = piece->degree;
    const struct interval r = point(cone->reach);
    struct interval q[JET_SIZE], off[2 * JET_SIZE], sum = { 0, 0 }, power = r;

    proof_quotient(n - 2, f->excess, f->ind, q);
    q[n - 1] = point(0);
    residual(n, f->excess, q, f->ind, off);
    for (size_t k = 0; k + 1 < n; k++) {
        sum = add(sum,
                  interval_divide(times(q[k], power), point((double) (k + 1))));
        power = times(power, r);
    }
    const struct interval beside = interval_divide(
        point(proof_size(off, 0, 2 * n - 2, cone->reach)), point(least));
    const double aside = proof_up_times(
        proof_up_times(cone->slope, interval_most(in->across)), cone->reach);
    sum = add(sum, interval_within(proof_up_times(beside.hi, cone->reach)));
    sum = times(point(-piece->step), sum);
    return add(sum, interval_within(aside));
}

static bool cone_of(struct interval_tape *t, const struct proof_piece *piece,
                    double reach, struct proof_cone *out,
                    struct proof_front *front)
{
    struct along f;
    struct inside in;

    if (!expand(t, piece, reach, &f))
        return false;
    const double least = least_of(piece->degree, &f, reach);
    if (!(least > 0))
        return false;
    const double defect = defect_of(piece, &f, reach, least);
    double slope = 2 * defect + DBL_MIN;
    for (int i = 0; i < 3; i++) {
        if (!isfinite(slope) || !look_inside(t, piece, reach, slope, &in))
            return false;
        const long double room =
            interval_times(point(slope),
                           interval_less(point(1), interval_high(in.g)))
                .lo;
        if (defect < room)
            break;
        if (i == 2 || !(in.g.hi < 1))
            return false;
        slope = 4 * defect / (double) (1 - in.g.hi) + DBL_MIN;
    }
    *out = (struct proof_cone){ .reach = reach, .slope = slope };
    out->excess = interval_of_double(
        interval_outward(excess_of(piece, &f, &in, out, least)));
    front->error = proof_up_times(slope, reach);
    front->excess = out->excess;
    return interval_is_finite(out->excess);
}

/* From near that part of the piece down, as long as that narrows the cone: what
 * is left then is rounding. */
bool proof_cone(struct interval_tape *t, const struct proof_piece *piece,
                double most, struct proof_cone *out, struct proof_front *front)
{
    double reach = PROOF_CONE_SHRINK * most;
    bool found = false;

    for (int i = 0; i < PROOF_CONE_TRIES; i++, reach *= PROOF_CONE_SHRINK) {
        struct proof_cone cone;
        struct proof_front f = { 0 };
        if (!cone_of(t, piece, reach, &cone, &f))
            continue;
        if (found && !(cone.slope < PROOF_CONE_NARROWER * out->slope))
            break;
        found = true;
        *out = cone;
        *front = f;
    }
    return found;
}
