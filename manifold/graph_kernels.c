/* One source, once for each width of the processor's registers: GRAPH_KERNELS
 * is the name, JET_LANES how many series. */
#include "graph_kernels.h"

#include <math.h>

#include "elementary_lanes.h"

/* Those beyond n are as the first. */
struct bundle {
    const double *u[JET_LANES];
    double number[JET_LANES];
};

static struct bundle bundle_of(size_t n, const double *const u[],
                               const double number[])
{
    struct bundle b;

    for (size_t l = 0; l < JET_LANES; l++) {
        b.u[l] = u[l < n ? l : 0];
        b.number[l] = number[l < n ? l : 0];
    }
    return b;
}

#define NUMBER(l)      b.number[l]
#define COEFFICIENT(l) b.u[l][k]

static inline jet_pair exp_of(jet_pair x)
{
    if (!each_any(~(each_size(x) < 700.0)))
        return each_exp(x);
    for (int l = 0; l < JET_LANES; l++)
        x[l] = exp(x[l]);
    return x;
}

static inline jet_pair log_of(jet_pair x)
{
    if (!each_any(~(x > 1e-300) | ~(x < 1e300)))
        return each_ln(~each_all(), x);
    for (int l = 0; l < JET_LANES; l++)
        x[l] = log(x[l]);
    return x;
}

static void reach(size_t order, size_t n, const double *const u[],
                  const double to[], double s[])
{
    const struct bundle b = bundle_of(n, u, to);
    const jet_pair goal = log_of(JET_EACH(NUMBER)), one = JET_PAIR(1.0);
    jet_pair least = JET_PAIR(HUGE_VAL);

    for (size_t k = order - 1; k <= order; k++) {
        const jet_pair size = each_size(JET_EACH(COEFFICIENT));
        const jet_mask is = size != 0.0;
        const jet_pair at =
            (goal - log_of(jet_choose(is, size, one))) / (double) k;
        least = jet_choose(is & (at < least), at, least);
    }
    least = exp_of(least);
    for (size_t l = 0; l < n; l++)
        s[l] = least[l];
}

/* |u[k - 1]| h^(k - 1) + |u[k]| h^k. */
static inline jet_pair two_terms(const struct bundle *all, size_t order,
                                 jet_pair h)
{
    const struct bundle b = *all;
    jet_pair top = JET_PAIR(1.0), square = h;
    size_t k = order;

    for (size_t j = order - 1; j > 0; j >>= 1, square *= square)
        top = j & 1 ? top * square : top;
    const jet_pair last = each_size(JET_EACH(COEFFICIENT));
    k = order - 1;
    return top * (each_size(JET_EACH(COEFFICIENT)) + h * last);
}

static void ends(size_t order, size_t n, const double *const u[],
                 const double s[], struct graph_end out[])
{
    const struct bundle b = bundle_of(n, u, s);
    const jet_pair at = JET_EACH(NUMBER);
    size_t k = order;
    jet_pair c = JET_EACH(COEFFICIENT), value = c;
    jet_pair slope = JET_PAIR(0.0), bend = slope;

    while (k > 0) {
        const double number = (double) k;
        slope = slope * at + number * c;
        if (k > 1)
            bend = bend * at + (number * (number - 1.0)) * c;
        k--;
        c = JET_EACH(COEFFICIENT);
        value = value * at + c;
    }
    const jet_pair h = each_size(at), last = two_terms(&b, order, h),
                   before = two_terms(&b, order - 2, h);
    for (size_t l = 0; l < n; l++)
        out[l] = (struct graph_end){ value[l], slope[l], bend[l], last[l],
                                     before[l] };
}

const struct graph_kernels GRAPH_KERNELS = { reach, ends };
