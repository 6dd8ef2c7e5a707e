/* Gragg's midpoint rule with 2, 4, 6, ... substeps, extrapolated to none
 * (Gragg 1965; Hairer, Norsett & Wanner 1993, II.9): no coefficients to know in
 * 113 bits, and nothing in common with Taylor series.  Without Gragg's
 * smoothing, which matters for stiff equations only. */
#include "quad_step.h"

#include <string.h>

enum { COLUMNS = 10 };

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

void quad_step(quad_rates *f, const void *ctx, quad s, quad h,
               const quad y[QUAD_DIM], quad out[QUAD_DIM], quad error[QUAD_DIM])
{
    quad row[COLUMNS][QUAD_DIM]; /* of Aitken and Neville's tableau */

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
    for (int i = 0; i < QUAD_DIM; i++) {
        out[i] = row[COLUMNS - 1][i];
        error[i] = fabsq(out[i] - row[COLUMNS - 2][i]);
    }
}
