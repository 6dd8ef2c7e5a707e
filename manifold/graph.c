#include "graph.h"

#include <math.h>

#include "tolerance.h"

/* The series of both. */
struct expansion {
    const struct planar *sys;
    const struct carry *carry;
    const struct graph_start *start;
    jet_pair unit;
    jet_mask over_y; /* the lanes whose independent coordinate is y */
    struct jet_work work;
    jet_pair at[2][JET_SIZE], f[2][JET_SIZE];
    jet_pair ind[JET_SIZE], dep[JET_SIZE]; /* f by the part each plays */
    jet_pair slope[JET_SIZE];
    jet_pair rate[LOCAL_CARRY_MAX][JET_SIZE];
    jet_pair swift[LOCAL_CARRY_MAX][JET_SIZE]; /* d integral/d ind */
    jet_pair integral[LOCAL_CARRY_MAX][JET_SIZE];
};

static void set_start(struct expansion *e)
{
    for (int i = 0; i < JET_LANES; i++) {
        const struct graph_start *start = &e->start[i];
        e->at[0][0][i] = start->z.x;
        e->at[1][0][i] = start->z.y;
        e->unit[i] = start->unit;
        e->over_y[i] = start->ind == 1 ? -1 : 0;
    }
    e->work.linear =
        e->start[0].ind == e->start[1].ind ? e->at[e->start[0].ind] : NULL;
    for (size_t i = 0; i < e->carry->count; i++)
        e->integral[i][0] = JET_PAIR(0.0);
}

/* Coefficient k + 1 of the unknowns from coefficient k of the field. */
static void unknown_order(struct expansion *e, size_t k)
{
    const jet_pair ahead = k == 0 ? e->unit : JET_PAIR(0.0);

    e->ind[k] = jet_choose(e->over_y, e->f[1][k], e->f[0][k]);
    e->dep[k] = jet_choose(e->over_y, e->f[0][k], e->f[1][k]);
    e->slope[k] = jet_quotient(k, e->dep, e->ind, e->slope);
    const jet_pair next = e->slope[k] * (e->unit * jet_inverse[k + 1]);
    e->at[0][k + 1] = jet_choose(e->over_y, next, ahead);
    e->at[1][k + 1] = jet_choose(e->over_y, ahead, next);
}

static void carry_order(struct expansion *e, size_t i, size_t k)
{
    const jet_pair scale = e->work.log_scale;

    if (e->carry->which[i] != CARRY_TIME)
        e->sys->rate_jet(e->sys->ctx, (size_t) e->carry->which[i], &e->work, k,
                         e->at[0], e->at[1], e->rate[i]);
    else if (k == 0)
        e->rate[i][0] = (jet_pair){ exp(-scale[0]), exp(-scale[1]) };
    else
        e->rate[i][k] = JET_PAIR(0.0);
    e->swift[i][k] = jet_quotient(k, e->rate[i], e->ind, e->swift[i]);
    e->integral[i][k + 1] = e->swift[i][k] * e->unit * jet_inverse[k + 1];
}

void graph_expand(const struct planar *sys, const struct carry *carry,
                  size_t order, const struct graph_start start[2],
                  struct graph_series out[2])
{
    struct expansion e;

    e.sys = sys;
    e.carry = carry;
    e.start = start;
    set_start(&e);
    for (size_t k = 0; k < order; k++) {
        sys->jet(sys->ctx, &e.work, k, e.at[0], e.at[1], e.f[0], e.f[1]);
        unknown_order(&e, k);
        for (size_t i = 0; i < carry->count; i++)
            carry_order(&e, i, k);
    }
    for (int i = 0; i < JET_LANES; i++) {
        jet_take(order, e.at[0], (size_t) i, out[i].at[0]);
        jet_take(order, e.at[1], (size_t) i, out[i].at[1]);
        for (size_t j = 0; j < carry->count; j++) {
            jet_take(order, e.integral[j], (size_t) i, out[i].integral[j]);
            local_integral_floor(order, e.ind[0][i] / e.unit[i],
                                 out[i].integral[j]);
        }
        out[i].slope = e.slope[0][i];
    }
}

double graph_reach(const double u[], size_t order, double scale, double tol)
{
    const double goal = log(tol * scale);
    double least = HUGE_VAL;

    for (size_t k = order - 1; k <= order; k++)
        if (u[k] != 0.0)
            least = fmin(least, (goal - log(fabs(u[k]))) / (double) k);
    return exp(least);
}

/* |u[order - 1]| h^(order - 1) + |u[order]| h^order. */
static double two_terms(const double u[], size_t order, double h)
{
    double top = 1.0, square = h;

    for (size_t k = order - 1; k > 0; k >>= 1, square *= square)
        top *= k & 1 ? square : 1.0;
    return top * (fabs(u[order - 1]) + h * fabs(u[order]));
}

/* The ratio in which terms beyond the last ones fall, of a size `last`: as
 * these and the next do in pairs, over two orders and, where that is less than
 * smooth, over one. */
static double fall_of(const double u[], size_t order, double h, double last,
                      double next)
{
    const double before = fabs(u[order - 1]) / h, end = fabs(u[order]);
    const double pairs = sqrt(last / two_terms(u, order - 2, h));
    const double single = h * sqrt(fabs(u[order] / u[order - 2]));
    const double step = end / (before + end) + next / last;
    const double ratio = TOL_STEP_FALL * fmax(pairs, next / last);

    if (ratio > TOL_STEP_SMOOTH)
        return ratio;
    return fmax(ratio,
                fmin(TOL_STEP_FALL * fmax(single, step), TOL_STEP_SMOOTH));
}

/* Where terms fall, by `ratio`, from `last` on: what the slope and its change
 * make of the next two terms.  Where it is no series', past a kink, that is off
 * from what the slope alone makes of one, which then counts. */
static struct graph_miss smooth_missing(const double u[], size_t order,
                                        double s, const struct graph_rate *rate,
                                        double ratio, double last)
{
    const double off = rate->value - jet_slope_at(order, u, s), h = fabs(s);
    const double turn = rate->change - jet_bend_at(order, u, s);
    const double part = (double) (order + 1) - rate->growth;
    const double both = part + (double) (order + 1), square = part * (part + 1);
    const double value = (both * off * s - turn * s * s) / square;
    const double noise = both * fmin(fabs(off), rate->noise) * h +
                         fmin(fabs(turn), rate->change_noise) * h * h;
    const double fall = ratio / (1.0 - ratio);
    const double rest = 2.0 * fall * fall * fall * last;
    const double last_off = (2.0 + rate->bend) * fabs(value);
    const double one = fabs(value - off * s / part);

    return (struct graph_miss){ value,
                                (rest + last_off + noise) / square + one };
}

struct graph_miss graph_missing(const double u[], size_t order, double s,
                                const struct graph_rate *rate, bool smooth)
{
    const double off = rate->value - jet_slope_at(order, u, s), h = fabs(s);
    const double rounding = TOL_ROUNDED * (fabs(u[1]) + fabs(rate->value));
    const double terms = (double) (order + 1), part = terms - rate->growth;
    const double last = two_terms(u, order, h), next = fabs(off) * h / terms;
    const double most = TOL_STEP_BAR_NEXT * last;
    const double ratio = fabs(off) <= rounding && last == 0.0
                             ? 0.0
                             : fall_of(u, order, h, last, next);

    if (smooth && ratio <= TOL_STEP_SMOOTH && part > 0.5 * terms)
        return smooth_missing(u, order, s, rate, ratio, last);
    /* no series' rest: as far as the slope is off at the end, all the way */
    if ((next > most || ratio >= 1.0) && fabs(off) > rounding)
        return (struct graph_miss){ 0.0, fabs(off) * h };
    return (struct graph_miss){ 0.0, TOL_STEP_BAR_NEXT * fmin(next, most) +
                                         TOL_STEP_BAR_LAST * last };
}
