/* Time and slip never fall along an orbit: bisection finds the piece, and
 * newton_find the point on it. */
#include "sample.h"

#include <float.h>
#include <math.h>

#include "newton.h"

/* Components of the curve. */
enum { TIME = 2, SLIP = 3 + BLOCK_SLIP };

/* One component less a value, along a piece. */
struct along {
    const struct curve *curve;
    size_t piece, component;
    double value;
};

static double excess(const void *ctx, double theta)
{
    const struct along *a = ctx;
    double u[CURVE_DIM_MAX];

    curve_at(a->curve, a->piece, theta, u);
    return u[a->component] - a->value;
}

/* The last piece that starts at or below the value. */
static size_t find_piece(struct along a)
{
    size_t lo = 0, hi = a.curve->count;

    while (hi - lo > 1) {
        a.piece = lo + (hi - lo) / 2;
        if (excess(&a, 0.0) <= 0.0)
            lo = a.piece;
        else
            hi = a.piece;
    }
    return lo;
}

struct trajectory_row sample_row(const struct slider *s, const double u[])
{
    const struct block *b = &s->block;

    return (struct trajectory_row){
        .time = u[TIME],
        .v = block_v(b, u[0]),
        .psi = block_psi(b, u[1]),
        .slip = u[SLIP],
        .mu = block_mu(b, (struct vec2){ u[0], u[1] }),
        .work = u[3 + BLOCK_WORK],
    };
}

/* The point where the component has the value; the nearer end where there is
 * none. */
static struct trajectory_row sample(const struct slider *s,
                                    const struct transient *t, size_t component,
                                    double value)
{
    struct along a = { &t->curve, 0, component, value };
    struct newton_root root;
    double u[CURVE_DIM_MAX];

    a.piece = find_piece(a);
    double theta = excess(&a, 0.0) >= 0.0 ? 0.0 : 1.0;
    if (newton_find(excess, &a, 0.0, 1.0, 0.0, &root) == STATUS_OK)
        theta = root.x;
    curve_at(&t->curve, a.piece, theta, u);
    return sample_row(s, u);
}

struct trajectory_row sample_at_time(const struct slider *s,
                                     const struct transient *t, double time)
{
    return sample(s, t, TIME, time);
}

struct trajectory_row sample_at_slip(const struct slider *s,
                                     const struct transient *t, double slip)
{
    return sample(s, t, SLIP, slip);
}

/* Of the component where a piece ends. */
static double end_of(const struct transient *t, size_t piece, size_t component)
{
    double u[CURVE_DIM_MAX];

    curve_at(&t->curve, piece, 1.0, u);
    return u[component];
}

void sample_linear_slip(const struct slider *s, const struct transient *t,
                        size_t n, struct trajectory_row row[])
{
    const double all = end_of(t, t->curve.count - 1, SLIP);

    for (size_t i = 0; i < n; i++) {
        const double slip = all * (double) i / (double) (n - 1);
        row[i] = sample_at_slip(s, t, slip);
        row[i].slip = slip;
    }
}

/* Where psi leaps by a sinh of hundreds, the first steps take no time that
 * doubles hold. */
static double first_time(const struct transient *t)
{
    size_t piece = 0;

    while (piece + 1 < t->curve.count &&
           end_of(t, piece, TIME) < DBL_MIN / DBL_EPSILON)
        piece++;
    return end_of(t, piece, TIME);
}

void sample_log_time(const struct slider *s, const struct transient *t,
                     size_t n, struct trajectory_row row[])
{
    const double last = end_of(t, t->curve.count - 1, TIME);
    const double first = first_time(t);

    for (size_t i = 0; i < n; i++) {
        const double part = (double) i / (double) (n - 1);
        const double time = pow(first, 1.0 - part) * pow(last, part);
        row[i] = sample_at_time(s, t, time);
        row[i].time = time;
    }
}
