/*
 * The branches are grown once more, finer, and until v no longer changes at
 * all, so that no tail is left to vary.  Error: the difference from a second,
 * coarser run with fewer points, what the equation still asks for at the end,
 * rounding, and near a fold the uncertainty of the saddle's place.
 */
#include "sensitivity.h"

#include <float.h>
#include <math.h>

#include "numbers_tolerance.h"
#include "variation.h"

struct sensitivities sensitivity_none(const char *reason)
{
    struct sensitivities s;

    for (int p = 0; p < PARAMETERS; p++)
        s.v_plus.by[p] = s.v_minus.by[p] = quantity_none(reason);
    return s;
}

/* One run: both sides, +1 towards v > v_sp first. */
struct run {
    double rtol;
    size_t nodes;
    bool limit[2]; /* v has one */
    double by[2][PARAMETERS], rest[2][PARAMETERS];
    size_t evaluations;
};

static enum status run_side(const struct planar *sys,
                            const struct local_series *u, int sign, int i,
                            struct run *r)
{
    const struct variation v = { PARAMETERS, parameter_field, sys->ctx,
                                 r->nodes, r->rtol };
    struct grow_options o = grow_defaults(r->rtol);
    struct branch branch;

    o.reach = &sys->domain;
    const enum status status = grow_branch(sys, u, sign, &o, &branch);
    if (status == STATUS_NO_CONVERGENCE) /* then there is no limit to vary */
        return STATUS_OK;
    if (status != STATUS_OK)
        return status;
    r->limit[i] = branch.end == BRANCH_LIMIT_X;
    r->evaluations += branch.evaluations * o.order;
    if (r->limit[i]) {
        variation_along(sys, &branch, &v, r->by[i], r->rest[i]);
        r->evaluations += branch.curve.count * r->nodes;
    }
    branch_free(&branch);
    return STATUS_OK;
}

static enum status run_both(const struct planar *sys,
                            const struct equilibrium *e, struct run *r)
{
    const struct carry none = { .count = 0 };
    struct local_series u;
    enum status status =
        local_at(sys, e, MANIFOLD_STABLE, &none, grow_order(r->rtol),
                 TOL_TAYLOR_STEP * r->rtol, &u);

    if (status == STATUS_NO_CONVERGENCE)
        return STATUS_OK;
    if (status != STATUS_OK)
        return status;
    const int up = u.ind == 0 || u.c[1] > 0.0 ? 1 : -1;
    status = run_side(sys, &u, up, 0, r);
    return status ? status : run_side(sys, &u, -up, 1, r);
}

/* One side's numbers; `relative`: least error there can be. */
static void numbers_of(const struct block *b, const struct run *fine,
                       const struct run *coarse, int i,
                       const struct quantity *limit, double relative,
                       struct sensitivity_numbers *out)
{
    for (int p = 0; p < PARAMETERS; p++) {
        const char *missing =
            parameter_missing(&b->law, &b->material, (enum parameter) p);
        const double value = fine->by[i][p], rest = fine->rest[i][p];
        const double error = fabs(value - coarse->by[i][p]) +
                             TOL_VARIATION_REST * rest + relative * fabs(value);
        if (missing)
            out->by[p] = quantity_none(missing);
        else if (!quantity_exists(limit))
            out->by[p] = quantity_none(limit->reason);
        else if (!fine->limit[i] || !coarse->limit[i])
            out->by[p] = quantity_none("the branch cannot be followed to where "
                                       "v no longer changes");
        else if (!(rest <= TOL_VARIATION_OPEN * fabs(value)) ||
                 !isfinite(error))
            out->by[p] = quantity_none("the limit has no derivative by this "
                                       "parameter at its value");
        else
            out->by[p] = quantity_of(value, error);
    }
}

enum status sensitivity_find(const struct block *b, const struct equilibrium *e,
                             const struct critical_numbers *c, double rtol,
                             struct sensitivities *out, size_t *evaluations)
{
    const struct planar sys = block_planar(b);
    struct run fine = {
        .rtol = fmax(TOL_PART * rtol, TOL_FINEST),
        .nodes = TOL_VARIATION_NODES,
    };
    struct run coarse = { .rtol = fmax(rtol, TOL_RTOL_DEFAULT),
                          .nodes = TOL_VARIATION_FEWER };
    const double relative =
        TOL_BAR_CHANCE * fine.rtol + TOL_ROUNDINGS_MANY * DBL_EPSILON +
        TOL_FAR_BELOW * numbers_floor(b) * numbers_cancellation(e);

    enum status status = run_both(&sys, e, &fine);
    if (status == STATUS_OK)
        status = run_both(&sys, e, &coarse);
    if (status != STATUS_OK)
        return status;
    numbers_of(b, &fine, &coarse, 0, &c->v_plus, relative, &out->v_plus);
    numbers_of(b, &fine, &coarse, 1, &c->v_minus, relative, &out->v_minus);
    *evaluations += fine.evaluations + coarse.evaluations;
    return STATUS_OK;
}
