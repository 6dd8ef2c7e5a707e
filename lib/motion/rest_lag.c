/* By iteration: as fast as psi_ss, and as fast as what that gives; each leaves
 * about v times the last change. */
#include "rest_lag.h"

#include <math.h>

#include "moment.h"
#include "motion_tolerance.h"
#include "slider.h"

double rest_lag_slowness(const struct slider *s, double x, double y)
{
    const double force = moment_excess_friction(s, (struct vec2){ x, y });

    return exp(x - s->block.at.log_inertia) / force;
}

/* ln psi_ss ~ -ln v, as it is for v -> 0. */
static double y_behind(const struct slider *s, double x, double lag)
{
    const double ln_v = s->plane.system.origin.x + x;

    return s->plane.system.axis[1].is_log
               ? -ln_v + log1p(-lag * exp(ln_v)) - s->plane.system.origin.y
               : exp(-ln_v) - lag - s->plane.system.origin.y;
}

/* With psi as fast as psi_ss + bend. */
static double lag_at(const struct slider *s, double x, double bend)
{
    const struct block *b = &s->block;
    const long double ln_v = (long double) (s->plane.system.origin.x + x);
    const double clock =
        (double) (steady_log_rate(&b->law, &b->material, ln_v) + ln_v) -
        log1p(bend * exp((double) ln_v));
    double lag = 0.0, last = HUGE_VAL;

    for (int i = 0; i < TOL_REST_ROUNDS && lag != last; i++) {
        const double late = rest_lag_slowness(s, x, y_behind(s, x, lag));
        const double rate = -log(late) - clock;
        last = lag;
        lag = rate > 30.0 ? rate + log(2.0) : asinh(exp(rate));
    }
    return lag;
}

struct rest_lag rest_lag_at(const struct slider *s, double x)
{
    const double h = TOL_REST_DIFFERENCE, v = exp(s->plane.system.origin.x + x);
    const double first = lag_at(s, x, 0.0);
    double bend = 0.0, lag = first;

    if (v > TOL_REST_STRAIGHT) {
        bend = (lag_at(s, x + h, 0.0) - lag_at(s, x - h, 0.0)) / (2.0 * h);
        lag = lag_at(s, x, bend);
    }
    const double part = fabs(bend) * v + h;
    const double off = bend == 0.0 ? v * first : part * fabs(lag - first);
    const double psi_v = 1.0 - lag * v;
    struct rest_lag l = { .y = y_behind(s, x, lag), .lag = lag };

    l.y_slope = s->plane.system.axis[1].is_log ? -(1.0 + bend * v) / psi_v
                                               : -1.0 / v - bend;
    l.slowness = rest_lag_slowness(s, x, l.y);
    l.wrong = fabs(
        rest_lag_slowness(s, x, y_behind(s, x, lag + off)) / l.slowness - 1.0);
    if (!(psi_v > TOL_REST_BEHIND && part < 1.0))
        l.wrong = (double) NAN;
    return l;
}
