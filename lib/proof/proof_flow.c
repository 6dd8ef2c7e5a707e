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

/* out_i = sum_m (i + m)! p_{i+m} s^m/m! over i!: factorials to 25 are exact. */
void proof_shift(size_t n, const struct interval p[], struct interval s,
                 struct interval out[])
{
    struct interval large[JET_SIZE], power[JET_SIZE], factorial = one;

    power[n] = one; /* downward */
    for (size_t k = 0; k <= n; k++) {
        large[k] = interval_times(p[k], factorial);
        factorial = interval_times(factorial, interval_point((double) (k + 1)));
        if (k < n)
            power[n - k - 1] =
                interval_divide(interval_times(power[n - k], s),
                                interval_point((double) (k + 1)));
    }
    const struct interval_row up = interval_row_of(large, n);
    const struct interval_row down = interval_row_of(power, n);
    factorial = one;
    for (size_t i = 0; i <= n; i++) {
        out[i] = interval_divide(
            interval_sum(n - i + 1, 0, &up, i, &down, n, 1), factorial);
        factorial = interval_times(factorial, interval_point((double) (i + 1)));
    }
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

static struct interval poly_of(size_t n, const struct interval p[],
                               struct interval s)
{
    struct interval sum = zero;

    for (size_t k = n + 1; k-- > 0;)
        sum = interval_add(p[k], interval_times(sum, s));
    return sum;
}

struct interval proof_poly_over(size_t n, const double p[], struct interval s)
{
    const struct interval middle = interval_point(interval_middle(s));
    struct interval c[JET_SIZE];

    proof_points(n, p, c);
    proof_shift(n, c, middle, c);
    return poly_of(n, c, interval_less(s, middle));
}

void proof_quotient(size_t n, const struct interval u[],
                    const struct interval w[], struct interval out[])
{
    const struct interval_row by = interval_row_of(w, n);
    struct interval_row made = { .c = out };

    for (size_t k = 0; k <= n; k++) {
        const struct interval known = interval_sum(k, 0, &made, 0, &by, k, 1);
        out[k] = interval_divide(interval_less(u[k], known), w[0]);
        interval_row_take(&made, k);
    }
}

double proof_up_sum(long double u, long double w)
{
    return interval_up(interval_add(interval_point(u), interval_point(w)).hi);
}

double proof_up_times(long double u, long double w)
{
    return interval_up(interval_times(interval_point(u), interval_point(w)).hi);
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
