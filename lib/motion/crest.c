#include "crest.h"

#include <math.h>
#include <stdbool.h>

#include "motion_tolerance.h"

/* As crest_between; *at: where. */
static double between(double (*value)(const void *ctx, double t),
                      const void *ctx, double lo, double hi, double width,
                      double *at)
{
    const double part = 0.5 * (sqrt(5.0) - 1.0);
    double left = hi - part * (hi - lo), right = lo + part * (hi - lo);
    double at_left = value(ctx, left), at_right = value(ctx, right);

    while (hi - lo > width) {
        if (at_left > at_right) {
            hi = right;
            right = left;
            at_right = at_left;
            left = hi - part * (hi - lo);
            at_left = value(ctx, left);
        } else {
            lo = left;
            left = right;
            at_left = at_right;
            right = lo + part * (hi - lo);
            at_right = value(ctx, right);
        }
    }
    *at = at_left > at_right ? left : right;
    return fmax(at_left, at_right);
}

double crest_between(double (*value)(const void *ctx, double t),
                     const void *ctx, double lo, double hi, double width)
{
    double at;

    return between(value, ctx, lo, hi, width, &at);
}

/* Whether a function goes uphill to its end: the parabola by what it is there
 * and one and two strides before rises at the end by more than it bends on half
 * a stride.  (What it gains on a step that is far shorter is rounding.) */
static bool is_uphill(double end, double before, double further)
{
    return 3.0 * end - 4.0 * before + further >
           fabs(end - 2.0 * before + further);
}

double crest_of(double (*value)(const void *ctx, double t), const void *ctx,
                double *at)
{
    enum { LAST = TOL_EVENT_SAMPLES };
    const double stride = 1.0 / LAST;
    double v[LAST + 1], nearer;
    int best = 0;

    for (int i = 0; i <= LAST; i++) {
        v[i] = value(ctx, i * stride);
        best = v[i] > v[best] ? i : best;
    }
    const double where = best * stride;
    double top = v[best];
    if (!(best == 0 && is_uphill(v[0], v[1], v[2])) &&
        !(best == LAST && is_uphill(v[LAST], v[LAST - 1], v[LAST - 2])))
        top = between(value, ctx, fmax(where - stride, 0.0),
                      fmin(where + stride, 1.0), TOL_ROOT, &nearer);
    if (at)
        *at = top > v[best] ? nearer : where;
    return fmax(v[best], top);
}
