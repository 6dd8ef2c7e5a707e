#include "crest.h"

#include <math.h>

#include "study_tolerance.h"

double crest_between(double (*value)(const void *ctx, double t),
                     const void *ctx, double lo, double hi, double width)
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
    return fmax(at_left, at_right);
}

double crest_of(double (*value)(const void *ctx, double t), const void *ctx)
{
    const double stride = 1.0 / TOL_CREST_SAMPLES;
    double best = value(ctx, 0.0), at = 0.0;

    for (int i = 1; i <= TOL_CREST_SAMPLES; i++) {
        const double here = value(ctx, i * stride);
        at = here > best ? i * stride : at;
        best = fmax(best, here);
    }
    return fmax(best, crest_between(value, ctx, fmax(at - stride, 0.0),
                                    fmin(at + stride, 1.0), TOL_CREST_WIDTH));
}
