/* Gragg's midpoint rule with 2, 4, 6, ... substeps, extrapolated to none
 * (Gragg 1965; Hairer, Norsett & Wanner 1993, II.9): no coefficients to know in
 * 113 bits, and nothing in common with Taylor series.  Without Gragg's
 * smoothing, which matters for stiff equations only.  A rate that decays within
 * a substep never enters an even number of them: the trapezoidal rule, which
 * sees it, must not be further off than a step that resolves anything is. */
#include "quad_step.h"

#include <string.h>

enum { COLUMNS = 10 };

/* As a part of the larger rate; that of e^-z for z = 4. */
static const double unseen = 0.25;

static void midpoint(quad_rates *f, const void *ctx, quad s, quad h, int n,
                     const quad y[QUAD_DIM], quad out[QUAD_DIM])
{
    quad last[QUAD_DIM], here[QUAD_DIM], rate[QUAD_DIM];
    const quad step = h / n;

    f(ctx, s, y, rate);
    for (int i = 0; i < QUAD_DIM; i++) {
        last[i] = y[i];
        here[i] = y[i] + step * rate[i];
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

/* At least how far `change` is off where it cannot have seen the rates. */
static quad missed(quad change, quad h, quad from, quad to)
{
    const quad off = fabsq(change - h * (from + to) / 2);
    const quad larger = fabsq(from) > fabsq(to) ? fabsq(from) : fabsq(to);

    return off <= (quad) unseen * fabsq(h) * larger ? 0 : off;
}

void quad_step(quad_rates *f, const void *ctx, quad s, quad h,
               const quad y[QUAD_DIM], quad out[QUAD_DIM], quad error[QUAD_DIM])
{
    quad row[COLUMNS][QUAD_DIM]; /* of Aitken and Neville's tableau */
    quad from[QUAD_DIM], to[QUAD_DIM];

    for (int j = 0; j < COLUMNS; j++) {
        quad fresh[QUAD_DIM];
        midpoint(f, ctx, s, h, 2 * (j + 1), y, fresh);
        for (int i = 0; i < QUAD_DIM; i++)
            for (int k = 0; k <= j; k++) {
                const quad old = row[k][i];
                row[k][i] = fresh[i];
                const quad ratio = (quad) (j + 1) / (j - k);
                if (k < j)
                    fresh[i] += (fresh[i] - old) / (ratio * ratio - 1);
            }
    }
    f(ctx, s, y, from);
    f(ctx, s + h, row[COLUMNS - 1], to);
    for (int i = 0; i < QUAD_DIM; i++) {
        out[i] = row[COLUMNS - 1][i];
        error[i] = fabsq(out[i] - row[COLUMNS - 2][i]) +
                   missed(out[i] - y[i], h, from[i], to[i]);
    }
}
