#include "graph.h"

#include <math.h>

#include "graph_kernels.h"
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

/* By registers that suit n, *some at a time. */
static const struct graph_kernels *step_of(size_t n, size_t *some)
{
#ifdef HAVE_WIDE_LANES
    const int width = jet_width();

    if (n > 2 && width > 2) {
        *some = n < JET_MANY ? n : JET_MANY;
        return width == 8 ? &graph_kernels_8 : &graph_kernels_4;
    }
#endif
    *some = n < 2 ? n : 2;
    return &graph_kernels_2;
}

void graph_reach(size_t order, size_t n, const double *const u[],
                 const double to[], double s[])
{
    for (size_t i = 0, some; i < n; i += some)
        step_of(n - i, &some)->reach(order, some, u + i, to + i, s + i);
}

void graph_ends(size_t order, size_t n, const double *const u[],
                const double s[], struct graph_end out[])
{
    for (size_t i = 0, some; i < n; i += some)
        step_of(n - i, &some)->ends(order, some, u + i, s + i, out + i);
}

/* The ratio in which terms beyond the last ones fall, of a size `last`: as
 * these and the next do in pairs, over two orders and, where that is less than
 * smooth, over one. */
static double fall_of(const double u[], size_t order, double h,
                      const struct graph_end *at, double next)
{
    const double before = fabs(u[order - 1]) / h, end = fabs(u[order]);
    const double last = at->last, pairs = sqrt(last / at->before);
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
static struct graph_miss smooth_missing(size_t order, double s,
                                        const struct graph_end *end,
                                        const struct graph_rate *rate,
                                        double ratio)
{
    const double off = rate->value - end->slope, h = fabs(s);
    const double turn = rate->change - end->bend;
    const double part = (double) (order + 1) - rate->growth;
    const double both = part + (double) (order + 1), square = part * (part + 1);
    const double value = (both * off * s - turn * s * s) / square;
    const double noise = both * fmin(fabs(off), rate->noise) * h +
                         fmin(fabs(turn), rate->change_noise) * h * h;
    const double fall = ratio / (1.0 - ratio);
    const double rest = 2.0 * fall * fall * fall * end->last;
    const double last_off = (2.0 + rate->bend) * fabs(value);
    const double one = fabs(value - off * s / part);

    return (struct graph_miss){ value,
                                (rest + last_off + noise) / square + one };
}

struct graph_miss graph_missing(const double u[], size_t order, double s,
                                const struct graph_end *end,
                                const struct graph_rate *rate, bool smooth)
{
    const double off = rate->value - end->slope, h = fabs(s);
    const double rounding = TOL_ROUNDED * (fabs(u[1]) + fabs(rate->value));
    const double terms = (double) (order + 1), part = terms - rate->growth;
    const double last = end->last, next = fabs(off) * h / terms;
    const double most = TOL_STEP_BAR_NEXT * last;
    const double ratio = fabs(off) <= rounding && last == 0.0
                             ? 0.0
                             : fall_of(u, order, h, end, next);

    if (smooth && ratio <= TOL_STEP_SMOOTH && part > 0.5 * terms)
        return smooth_missing(order, s, end, rate, ratio);
    /* no series' rest: as far as the slope is off at the end, all the way */
    if ((next > most || ratio >= 1.0) && fabs(off) > rounding)
        return (struct graph_miss){ 0.0, fabs(off) * h };
    return (struct graph_miss){ 0.0, TOL_STEP_BAR_NEXT * fmin(next, most) +
                                         TOL_STEP_BAR_LAST * last };
}
