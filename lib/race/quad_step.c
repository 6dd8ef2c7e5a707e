/* Gragg's midpoint rule with 2, 4, 6, ... substeps, extrapolated to none
 * (Gragg 1965; Hairer, Norsett & Wanner 1993, II.9) until it is good enough:
 * no coefficients to know in 113 bits, and nothing in common with Taylor
 * series.  Without Gragg's smoothing, which matters for stiff equations only.
 * A rate that decays within a substep never enters an even number of them: the
 * trapezoidal rule, which sees it, must not be further off than a step that
 * resolves anything is. */
#include "quad_step.h"

#include <math.h>
#include <string.h>

enum { COLUMNS_LEAST = 4 };

/* A correction may be small by chance. */
static const double by_chance = 1.0 / 16.0;

/* As a part of the larger rate; that of e^-z for z = 4. */
static const double unseen = 0.25;

/* From the rates `from` at (s, y). */
static void midpoint(quad_rates *f, const void *ctx, quad s, quad h, int n,
                     const quad y[QUAD_DIM], const quad from[QUAD_DIM],
                     quad out[QUAD_DIM])
{
    quad last[QUAD_DIM], here[QUAD_DIM], rate[QUAD_DIM];
    const quad step = h / n;

    for (int i = 0; i < QUAD_DIM; i++) {
        last[i] = y[i];
        here[i] = y[i] + step * from[i];
    }
    for (int k = 1; k < n; k++) {
        f(ctx, s + k * step, here, rate);
        for (int i = 0; i < QUAD_DIM; i++) {
            const quad next = last[i] + 2 * step * rate[i];
            last[i] = here[i];
            here[i] = next;
        }
    }
    memcpy(out, here, sizeof here);
}

/* Row j of Aitken and Neville's tableau over the one before; row[j] is the best
 * and error its last correction, or a part of what it is better by than the
 * best of the row before. */
static void extrapolate(quad row[][QUAD_DIM], int j, const quad first[QUAD_DIM],
                        quad error[QUAD_DIM])
{
    for (int i = 0; i < QUAD_DIM; i++) {
        const quad best = j > 0 ? row[j - 1][i] : (quad) HUGE_VAL;
        quad fresh = first[i], last = 0;
        for (int k = 0; k < j; k++) {
            const quad old = row[k][i];
            const quad ratio = (quad) (j + 1) / (j - k);
            row[k][i] = fresh;
            last = (fresh - old) / (ratio * ratio - 1);
            fresh += last;
        }
        row[j][i] = fresh;
        const quad part = (quad) by_chance * fabsq(fresh - best);
        error[i] = fabsq(last) > part ? fabsq(last) : part;
    }
}

static bool is_enough(const quad error[QUAD_DIM], const quad enough[QUAD_DIM])
{
    for (int i = 0; i < QUAD_DIM; i++)
        if (!(error[i] <= enough[i]))
            return false;
    return true;
}

/* Adds to the error of one component at least how far it is off where it cannot
 * have seen the rates; as a part of what tells that, how far off. */
static double miss(quad change, quad h, quad from, quad to, quad *error)
{
    const quad off = fabsq(change - h * (from + to) / 2);
    const quad larger = fabsq(from) > fabsq(to) ? fabsq(from) : fabsq(to);
    const quad most = (quad) unseen * fabsq(h) * larger;

    if (!(off <= most))
        *error += off;
    return off == 0 ? 0.0 : (double) (off / most);
}

struct quad_step quad_step(quad_rates *f, const void *ctx, quad s, quad h,
                           const quad y[QUAD_DIM], const quad enough[QUAD_DIM],
                           quad out[QUAD_DIM], quad error[QUAD_DIM])
{
    quad row[QUAD_STEP_COLUMNS][QUAD_DIM];
    quad from[QUAD_DIM], to[QUAD_DIM], fresh[QUAD_DIM];
    struct quad_step step = { .columns = 0 };

    f(ctx, s, y, from);
    do {
        const int j = step.columns++;
        midpoint(f, ctx, s, h, 2 * (j + 1), y, from, fresh);
        extrapolate(row, j, fresh, error);
    } while (step.columns < QUAD_STEP_COLUMNS &&
             (step.columns < COLUMNS_LEAST || !is_enough(error, enough)));
    memcpy(out, row[step.columns - 1], sizeof fresh);
    f(ctx, s + h, out, to);
    for (int i = 0; i < QUAD_DIM; i++)
        step.blind =
            fmax(step.blind, miss(out[i] - y[i], h, from[i], to[i], &error[i]));
    return step;
}

double quad_step_factor(const struct quad_step *step, double error)
{
    const double least = 0.2, most = 3.0, safety = 0.8, aside = 0.95;
    const bool good = error <= 1.0;
    double factor = most;

    if (!(error < HUGE_VAL))
        return least;
    if (error > 0.0)
        factor = safety * pow(error, -1.0 / (2 * step->columns - 1));
    if (step->blind > 1.0)
        factor = good ? fmin(factor, 1.0) : aside / (step->blind * step->blind);
    else if (step->blind > 0.0)
        factor = fmin(factor, aside / sqrt(step->blind));
    return fmin(fmax(factor, least), most);
}
