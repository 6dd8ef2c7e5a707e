#include "branch.h"

#include <math.h>
#include <stdlib.h>

void branch_free(struct branch *b)
{
    curve_free(&b->curve);
    free(b->miss);
    b->miss = NULL;
}

enum { FIRST_ROOM = 32 }; /* a power of 2 */

enum status branch_push(struct branch *b, size_t degree,
                        const struct branch_miss *miss, double **coef)
{
    const size_t n = b->curve.count;

    if (n == 0 || (n >= FIRST_ROOM && (n & (n - 1)) == 0)) {
        const size_t room = n == 0 ? FIRST_ROOM : 2 * n;
        struct branch_miss *grown = realloc(b->miss, room * sizeof *grown);
        if (grown == NULL)
            return STATUS_NO_MEMORY;
        b->miss = grown;
    }
    b->miss[n] = *miss;
    return curve_push(&b->curve, degree, coef);
}

/* Sums over the pieces, from the end back: what their bounds make of the
 * limit, of the integral and of the combination. */
struct sums {
    double limit, total, both;
};

static struct sums sum_up(const struct branch *b, size_t i, double by_limit,
                          double by_total)
{
    struct sums s = { 0 };
    double limit = 1.0, total = 0.0; /* made of an error of dep by then */

    for (size_t k = b->miss == NULL ? 0 : b->curve.count; k-- > 0;) {
        const struct branch_miss *m = &b->miss[k];
        s.limit += fabs(limit) * m->bar;
        s.total += fabs(total) * m->bar + m->total_bar[i];
        s.both += fabs(by_limit * limit + by_total * total) * m->bar +
                  fabs(by_total) * m->total_bar[i];
        total = m->drift[i] + m->grown * total;
        limit *= m->grown;
    }
    return s;
}

/* What the sums leave of a bar, and its estimate. */
static double rest_of(double bar, double off, double sum)
{
    return fmax(bar - fabs(off) - sum, 0.0);
}

double branch_error(const struct branch *b, size_t i, double by_limit,
                    double by_total)
{
    const double bar = b->end == BRANCH_LIMIT_X ? b->error.x : b->error.y;
    const double off = by_limit * b->limit_off + by_total * b->total_off[i];
    const struct sums s = sum_up(b, i, by_limit, by_total);

    return fabs(off) + s.both +
           fabs(by_limit) * rest_of(bar, b->limit_off, s.limit) +
           fabs(by_total) *
               rest_of(b->total_error[i], b->total_off[i], s.total);
}

int branch_graph(const struct branch *b, size_t piece)
{
    const double *x = curve_component(&b->curve, piece, 0);
    bool linear = x[1] != 0.0;

    for (size_t k = 2; k <= b->curve.piece[piece].degree; k++)
        linear &= x[k] == 0.0;
    return linear ? 0 : 1;
}

double branch_slope(const struct planar *sys, const struct branch *b,
                    size_t piece, double theta)
{
    double at[CURVE_DIM_MAX], slope[CURVE_DIM_MAX];

    if (piece == 0) { /* the series: the field is 0/0 at the saddle */
        curve_slope_at(&b->curve, piece, theta, slope);
        return slope[1] / slope[0];
    }
    curve_at(&b->curve, piece, theta, at);
    return local_slope(sys, 0, (struct vec2){ at[0], at[1] });
}
