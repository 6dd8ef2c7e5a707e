/* Changed against the book: the growth after a rejection is at most 1, as in
 * the authors' own programs, NaN shrinks the step like a huge error, and a
 * tiny error before does not hold the step back: with it a step that hardly
 * matters would grow by half only. */
#include "control.h"

#include <math.h>

#include "tolerance.h"

/* Below this an error carries no information on the next one. */
static double floored(double error)
{
    return fmax(error, TOL_STEP_ERROR_FLOOR);
}

bool control_judge(struct control *c, double error, double *factor)
{
    if (!(error <= 1.0)) {
        const double f = TOL_STEP_SAFETY * pow(error, -1.0 / c->order);
        *factor = f > TOL_STEP_SHRINK ? fmin(f, 1.0) : TOL_STEP_SHRINK;
        c->rejected = true;
        return false;
    }
    const double f = TOL_STEP_SAFETY * pow(floored(error), -0.7 / c->order) *
                     pow(fmax(c->previous, TOL_FAR_BELOW), 0.4 / c->order);

    *factor =
        fmin(fmax(f, TOL_STEP_SHRINK), c->rejected ? 1.0 : TOL_STEP_GROWTH);
    c->previous = floored(error);
    c->rejected = false;
    return true;
}
