/* By iteration: as fast as psi_ss, and as fast as what that gives; each leaves
 * about v times the last change. */
#include "rest_lag.h"

#include <math.h>

#include "moment.h"
#include "motion_tolerance.h"
#include "newton.h"
#include "quasistatic.h"
#include "slider.h"
#include "steady.h"

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

    for (int i = 0; i < TOL_ITERATIONS && lag != last; i++) {
        const double late = rest_lag_slowness(s, x, y_behind(s, x, lag));
        const double rate = -log(late) - clock;
        last = lag;
        lag = rate > 30.0 ? rate + log(2.0) : asinh(exp(rate));
    }
    return lag;
}

/* ---- laws of formulas ---------------------------------------------------- */

/* The offset of psi_ss, whatever it is. */
static double y_steady(const struct slider *s, double x)
{
    const struct block *b = &s->block;

    return (double) (steady_y(&b->law, &b->material, b->x + (long double) x) -
                     b->y);
}

/* psi grows as fast as `slope` asks, ln(behind) below psi_ss. */
struct behind {
    const struct slider *s;
    double x, top, slope;
};

static double too_fast(const void *ctx, double ln_behind)
{
    const struct behind *w = ctx;
    const double y = w->top - exp(ln_behind);
    const double rate = quasistatic_log_rate(&w->s->block, w->x, y);
    const double asked = log(-w->slope / rest_lag_slowness(w->s, w->x, y));

    return isnan(rate) ? -HUGE_VAL : rate - asked;
}

/* How far behind; 0: less than digits hold. */
static double behind_at(const struct slider *s, double x, double slope)
{
    const struct behind w = { s, x, y_steady(s, x), slope };
    const double least = log(0x1p-50 * (1.0 + fabs(w.top)));
    struct newton_root root;

    if (too_fast(&w, least) >= 0.0)
        return 0.0;
    return newton_find(too_fast, &w, least, 1.0, TOL_REST_DIFFERENCE, &root) ==
                   STATUS_OK
               ? exp(root.x)
               : (double) NAN;
}

static double steady_slope(const struct slider *s, double x)
{
    const double h = TOL_REST_DIFFERENCE;

    return (y_steady(s, x + h) - y_steady(s, x - h)) / (2.0 * h);
}

static double first_behind(const struct slider *s, double x)
{
    return behind_at(s, x, steady_slope(s, x));
}

static struct rest_lag lag_of_formulas(const struct slider *s, double x)
{
    const double h = 0.01, slope = steady_slope(s, x);
    const double first = behind_at(s, x, slope);
    const double bend =
        first > 0.0
            ? (first_behind(s, x + h) - first_behind(s, x - h)) / (2.0 * h)
            : 0.0;
    const double lag = first > 0.0 ? behind_at(s, x, slope - bend) : 0.0;
    const double top = y_steady(s, x), hide = 0x1p-50 * (1.0 + fabs(top));
    struct rest_lag l = { .y = top - lag, .y_slope = slope - bend };

    l.slowness = rest_lag_slowness(s, x, l.y);
    const double off = fabs(lag - first) * fabs(bend) + lag * h + hide;
    l.wrong = fabs(rest_lag_slowness(s, x, l.y - off) / l.slowness - 1.0);
    if (!(fabs(bend) < 0.5 && lag < 0.5))
        l.wrong = (double) NAN;
    return l;
}

struct rest_lag rest_lag_at(const struct slider *s, double x)
{
    if (s->block.law.typed)
        return lag_of_formulas(s, x);
    const double h = TOL_REST_DIFFERENCE, v = exp(s->plane.system.origin.x + x);
    const double first = lag_at(s, x, 0.0);
    double bend = 0.0, lag = first;

    if (v > TOL_ROOT) {
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
    if (!(psi_v > TOL_CLEARLY && part < 1.0))
        l.wrong = (double) NAN;
    return l;
}
