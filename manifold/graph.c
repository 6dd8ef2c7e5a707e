#include "graph.h"

#include <math.h>

#include "graph_lanes.h"
#include "tolerance.h"

size_t graph_expand(const struct planar *const sys[], const struct carry *carry,
                    size_t order, size_t most, const struct graph_start start[],
                    struct graph_series *const out[])
{
    const struct planar_many *many = most > 2 ? sys[0]->many : NULL;
    const size_t pair = most > 1 && sys[1] == sys[0] ? 2 : 1;
    const size_t n = !many ? pair : most < JET_MANY ? most : JET_MANY;

#ifdef HAVE_WIDE_LANES
    if (many && many->width == 8)
        graph_expand_8(sys, carry, order, n, start, out);
    else if (many)
        graph_expand_4(sys, carry, order, n, start, out);
    else
#endif
        graph_expand_2(sys, carry, order, n, start, out);
    return n;
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
    const double ratio = TOL_AS_BEFORE * fmax(pairs, next / last);

    if (ratio > TOL_STEP_SMOOTH)
        return ratio;
    return fmax(ratio,
                fmin(TOL_AS_BEFORE * fmax(single, step), TOL_STEP_SMOOTH));
}

/* Where terms fall, by `ratio`, from `last` on: what the slope and its change
 * make of the next two terms.  Where it is no series', past a kink, that is off
 * from what the slope alone makes of one, which then counts. */
static struct graph_miss smooth_missing(const double u[], size_t order,
                                        double s, const struct graph_rate *rate,
                                        double ratio, double last)
{
    const double off = rate->value - rate->found, h = fabs(s);
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
    const double off = rate->value - rate->found, h = fabs(s);
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
