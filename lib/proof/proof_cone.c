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
    const bool falls = interval_middle(trace) < 0;
    const struct interval sum =
        falls ? interval_less(trace, root) : add(trace, root);
    const struct interval away = times(point(0.5), sum);
    const struct interval near = interval_divide(det, away);
    out->lambda_minus = times(unit, falls ? away : near);
    out->lambda_plus = times(unit, falls ? near : away);
    return true;
}

/* ---- on the polynomial --------------------------------------------------- */

/* The field along p, at the saddle and over all of [0, reach]. */
struct along {
    struct proof_flow centre, all;
};

static void expand(struct interval_tape *t, const struct proof_piece *piece,
                   double reach, struct along *out)
{
    const size_t n = piece->degree;
    const struct interval box = { 0, reach };
    struct interval c[JET_SIZE], wide[JET_SIZE];

    proof_points(n, piece->coef, c);
    proof_shift(n, c, box, wide);
    proof_flow_along(t, piece->ind, point(0), piece->step, c, n, &out->centre);
    proof_flow_along(t, piece->ind, times(box, point(piece->step)), piece->step,
                     wide, n, &out->all);
}

/* Terms 0 .. n - 1 of step u/f_ind, the last one Lagrange's: f and u are 0 at
 * the saddle, and the k-th derivative of f/theta over k! is a mean of that of
 * order k + 1 of f. */
static void terms_of(const struct proof_piece *piece, const struct along *f,
                     const struct interval centre[],
                     const struct interval all[], struct interval out[])
{
    const size_t n = piece->degree;
    struct interval wide[JET_SIZE];

    proof_quotient(n - 1, centre + 1, f->centre.ind.c + 1, out);
    proof_quotient(n - 1, all + 1, f->all.ind.c + 1, wide);
    out[n - 1] = wide[n - 1];
    for (size_t k = 0; k < n; k++)
        out[k] = times(point(piece->step), out[k]);
}

/* sup |step f_dep/f_ind - p'| */
static double defect_of(const struct proof_piece *piece, const struct along *f,
                        double reach)
{
    struct interval off[JET_SIZE];

    terms_of(piece, f, f->centre.dep.c, f->all.dep.c, off);
    for (size_t k = 0; k < piece->degree; k++)
        off[k] = interval_less(
            off[k], times(point((double) (k + 1)), point(piece->coef[k + 1])));
    return proof_size(off, 0, piece->degree - 1, reach);
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

/* The integral of q = step (v - v_sp)/(-f_ind) over the cone: that on p, and
 * |dep - p| <= slope theta. */
static struct interval excess_of(const struct proof_piece *piece,
                                 const struct along *f, const struct inside *in,
                                 const struct proof_cone *cone)
{
    const struct interval r = point(cone->reach);
    struct interval q[JET_SIZE], sum = { 0, 0 }, power = r;

    terms_of(piece, f, f->centre.excess.c, f->all.excess.c, q);
    for (size_t k = 0; k < piece->degree; k++) {
        sum = interval_less(
            sum, interval_divide(times(q[k], power), point((double) (k + 1))));
        power = times(power, r);
    }
    const double aside = proof_up_times(
        proof_up_times(cone->slope, interval_most(in->across)), cone->reach);
    return add(sum, interval_within(aside));
}

static bool cone_of(struct interval_tape *t, const struct proof_piece *piece,
                    double reach, struct proof_cone *out,
                    struct proof_front *front)
{
    struct along f;
    struct inside in;

    expand(t, piece, reach, &f);
    const double defect = defect_of(piece, &f, reach);
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
    out->excess =
        interval_of_double(interval_outward(excess_of(piece, &f, &in, out)));
    front->error = proof_up_times(slope, reach);
    front->excess = out->excess;
    return interval_is_finite(out->excess);
}

/* If the piece begins at the saddle: from near that part of it down, as long as
 * that narrows the cone: what is left then is rounding. */
bool proof_cone(struct interval_tape *t, const struct proof_piece *piece,
                double most, struct proof_cone *out, struct proof_front *front)
{
    const bool begins = interval_is_zero(point(piece->start)) &&
                        interval_is_zero(point(piece->coef[0]));
    double reach = PROOF_CONE_SHRINK * most;
    bool found = false;

    for (int i = 0; i < PROOF_CONE_TRIES && begins;
         i++, reach *= PROOF_CONE_SHRINK) {
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
