#include "proof_flow.h"

#include <assert.h>
#include <string.h>

static const struct interval zero = { 0, 0 }, one = { 1, 1 };

static void flow(struct interval_tape *t, int ind, const struct interval at[],
                 const struct interval dep[], size_t n, struct proof_flow *out)
{
    struct interval_series f[3];

    assert(t->rates <= 3);
    f[2] = (struct interval_series){ .c = { zero } };
    interval_tape_jet(t, n, ind == 0 ? at : dep, ind == 0 ? dep : at, f,
                      &out->log_scale);
    out->ind = f[ind];
    out->dep = f[1 - ind];
    out->excess = f[2];
}

void proof_flow_along(struct interval_tape *t, int ind, struct interval at,
                      double step, const struct interval dep[], size_t n,
                      struct proof_flow *out)
{
    struct interval line[JET_SIZE] = { at, interval_point(step) };

    flow(t, ind, line, dep, n, out);
}

void proof_flow_aside(struct interval_tape *t, int ind, struct interval at,
                      struct interval dep, struct proof_flow *out)
{
    const struct interval x[] = { at, zero }, y[] = { dep, one };

    flow(t, ind, x, y, 1, out);
}

void proof_flow_slopes(struct interval_tape *t, int ind, struct interval at,
                       struct interval dep, struct proof_flow out[2])
{
    const struct interval x[] = { at, one }, y[] = { dep, zero };

    flow(t, ind, x, y, 1, &out[0]);
    proof_flow_aside(t, ind, at, dep, &out[1]);
}

void proof_shift(size_t n, const struct interval p[], struct interval s,
                 struct interval out[])
{
    if (out != p)
        memcpy(out, p, (n + 1) * sizeof *p);
    for (size_t i = 0; i < n; i++)
        for (size_t j = n; j-- > i;)
            out[j] = interval_add(out[j], interval_times(s, out[j + 1]));
}

void proof_points(size_t n, const double p[], struct interval out[])
{
    for (size_t k = 0; k <= n; k++)
        out[k] = interval_point(p[k]);
}

struct interval proof_poly_at(size_t n, const double p[], struct interval s)
{
    struct interval sum = zero;

    for (size_t k = n + 1; k-- > 0;)
        sum = interval_add(interval_point(p[k]), interval_times(sum, s));
    return sum;
}

struct interval proof_poly_over(size_t n, const double p[], struct interval s)
{
    const struct interval middle = interval_point(interval_middle(s));
    const struct interval way = interval_less(s, middle);
    struct interval c[JET_SIZE], sum = zero;

    proof_points(n, p, c);
    proof_shift(n, c, middle, c);
    for (size_t k = n + 1; k-- > 0;)
        sum = interval_add(c[k], interval_times(sum, way));
    return sum;
}

void proof_quotient(size_t n, const struct interval u[],
                    const struct interval w[], struct interval out[])
{
    for (size_t k = 0; k <= n; k++) {
        struct interval left = u[k];
        for (size_t j = 0; j < k; j++)
            left = interval_less(left, interval_times(out[j], w[k - j]));
        out[k] = interval_divide(left, w[0]);
    }
}

double proof_up_sum(double u, double w)
{
    return interval_add(interval_point(u), interval_point(w)).hi;
}

double proof_up_times(double u, double w)
{
    return interval_times(interval_point(u), interval_point(w)).hi;
}

double proof_size(const struct interval u[], size_t first, size_t last,
                  double h)
{
    double sum = 0;

    for (size_t k = last + 1; k-- > first;)
        sum = proof_up_sum(interval_most(u[k]), proof_up_times(sum, h));
    for (size_t k = 0; k < first; k++)
        sum = proof_up_times(sum, h);
    return sum;
}
