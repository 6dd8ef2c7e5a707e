#include "crest.h"

#include <math.h>

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

double crest_of(double (*value)(const void *ctx, double t), const void *ctx,
                double *at)
{
    const double stride = 1.0 / TOL_EVENT_SAMPLES;
    double best = value(ctx, 0.0), where = 0.0, nearer;

    for (int i = 1; i <= TOL_EVENT_SAMPLES; i++) {
        const double here = value(ctx, i * stride);
        where = here > best ? i * stride : where;
        best = fmax(best, here);
    }
    /* an end that is approached uphill is the only maximum beside it */
    const double inside = fmin(fmax(where, TOL_ROOT), 1.0 - TOL_ROOT);
    double top = value(ctx, inside);
    if (inside == where || !(top < best))
        top = between(value, ctx, fmax(where - stride, 0.0),
                      fmin(where + stride, 1.0), TOL_ROOT, &nearer);
    if (at)
        *at = top > best ? nearer : where;
    return fmax(best, top);
}
