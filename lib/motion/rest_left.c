/* v_s by iteration: without inertia, with that of the curve without it, and
 * with that of this one; each leaves about the square of the last change.
 * Panels of Gauss's and Kronrod's points (Piessens et al., QUADPACK, 1983),
 * which grow as the integrands, sums of exponentials, allow. */
#include "rest_left.h"

#include <float.h>
#include <math.h>

#include "moment.h"
#include "motion_tolerance.h"
#include "quasistatic.h"
#include "rest_form.h"
#include "rest_lag.h"
#include "slider.h"

/* ---- where friction balances the slope ----------------------------------- */

/* X on the curve of slope `slope`, less that without inertia. */
static double lift(const struct block *b, double Y, double x, double slope)
{
    const double least = 0x1p-52, nothing = 0x1p-60;
    double d = 0.0, change = HUGE_VAL;

    for (int i = 0; i < TOL_ITERATIONS && fabs(change) > least * (d + nothing);
         i++) {
        const double rate = quasistatic_log_rate(b, x + d, Y);
        const double force = exp(x + d - b->at.log_inertia + rate);
        change = quasistatic_above(b, x, Y, -slope * force) - d;
        d += change;
    }
    return fabs(change) < TOL_REST_SETTLED * (d + nothing) ? d : (double) NAN;
}

/* A point of the curve. */
struct point {
    double x, log_rate; /* ln(dY/dt) */
    double d, slope;    /* above what it were without inertia; dX/dY */
    double wrong;       /* of x */
};

static double first_lift(const struct block *b, double Y)
{
    double slope;
    const double x = quasistatic_x(b, Y, &slope);

    return lift(b, Y, x, slope);
}

static struct point point_at(const struct block *b, double Y)
{
    const double h = TOL_REST_DIFFERENCE;
    struct point p;
    const double x = quasistatic_x(b, Y, &p.slope);
    const double d = lift(b, Y, x, p.slope);
    const double bend = (first_lift(b, Y + h) - first_lift(b, Y - h)) / (2 * h);
    const double part = fabs(bend / p.slope) + h;

    p.d = d > 0x1p-60 ? lift(b, Y, x, p.slope + bend) : d;
    p.x = x + p.d;
    p.wrong = part < 1.0 ? part * fabs(p.d - d) : (double) NAN;
    p.log_rate = quasistatic_log_rate(b, p.x, Y);
    return p;
}

/* What `off` in X changes of ln(dY/dt). */
static double change_of_rate(const struct block *b, const struct point *p,
                             double Y, double off)
{
    return off > 0x1p-52
               ? fabs(quasistatic_log_rate(b, p->x + off, Y) - p->log_rate)
               : 0.0;
}

/* ---- whether it is known ------------------------------------------------- */

/* No steady state is in the way. */
static bool is_bound(const struct slider *s, struct vec2 z)
{
    return s->plane.equilibria == 0 ||
           (slider_saddle(s) == 0 && z.x < 0.0 && z.y > 0.0);
}

/* Whether z is on the curve as far as peaks of v can tell, or falls onto it
 * from where the plane ends, in no time. */
static bool is_on(const struct slider *s, struct vec2 z, const struct point *p)
{
    const bool falls =
        z.x > p->x && s->plane.system.origin.x + z.x < -TOL_RESCALED_FAR;

    return p->wrong < TOL_REST_WRONG && isfinite(p->log_rate) &&
           (falls || fabs(z.x - p->x) < TOL_REST_WRONG);
}

/* `late`: about what time is left. */
static bool is_small(double wrong, double late, double time)
{
    return wrong < TOL_REST_WRONG ||
           wrong * late < TOL_ROUNDINGS_MANY * DBL_EPSILON * time;
}

static bool is_behind(const struct slider *s, struct vec2 z, double time)
{
    const struct rest_lag l = rest_lag_at(s, z.x);

    return s->plane.system.origin.x + z.x < TOL_REST_SLOW &&
           is_small(l.wrong, l.slowness, time) && fabs(z.y - l.y) < TOL_SEEN;
}

static bool is_there(const struct slider *s, struct vec2 z, double time)
{
    const struct block *b = &s->block;
    const struct rest_form form = rest_form_at(b);

    if (form.fate == FATE_CREEP || form.fate == FATE_UNDECIDED ||
        !is_bound(s, z))
        return false;
    if (form.inertial)
        return is_behind(s, z, time);
    const struct point p = point_at(b, z.y);
    return is_on(s, z, &p);
}

/* ---- integrals ----------------------------------------------------------- */

enum { TIME, SLIP, TIME_WRONG, SLIP_WRONG, PARTS };

/* From z on. */
struct way {
    const struct slider *slider;
    struct vec2 z;
    bool inertial;
};

/* What the sums that rates are the exponentials of round by. */
static double rounding(const struct point *p, double Y)
{
    return 0x1p-52 * (fabs(p->x) + fabs(Y) + fabs(p->log_rate));
}

/* Time and slip per unit of the way, so far along it. */
static void rates_at(const struct way *w, double at, double rate[PARTS])
{
    const struct slider *s = w->slider;
    const struct block *b = &s->block;

    if (w->inertial) {
        const double x = w->z.x - at, v = exp(b->at.x0 + x);
        const struct rest_lag l = rest_lag_at(s, x);
        rate[TIME] = l.slowness;
        rate[SLIP] = v * l.slowness;
        rate[TIME_WRONG] = l.wrong * l.slowness;
        rate[SLIP_WRONG] = v * rate[TIME_WRONG];
        return;
    }
    const double Y = w->z.y + at;
    const struct point p = point_at(b, Y);
    const double wrong = change_of_rate(b, &p, Y, p.wrong) + rounding(&p, Y);
    rate[TIME] = exp(-p.log_rate);
    rate[SLIP] = exp(b->at.x0 + p.x - p.log_rate);
    rate[TIME_WRONG] = wrong * rate[TIME];
    rate[SLIP_WRONG] = (wrong + p.wrong) * rate[SLIP];
}

/* Both rules on a panel; `missed`: their difference. */
static void sum_panel(const struct way *w, double from, double h,
                      double sum[PARTS], double missed[PARTS])
{
    static const double node[] = { 0.9914553711208126, 0.9491079123427585,
                                   0.8648644233597691, 0.7415311855993944,
                                   0.5860872354676911, 0.4058451513773972,
                                   0.2077849550078985, 0.0 };
    static const double kronrod[] = { 0.0229353220105292, 0.0630920926299786,
                                      0.1047900103222502, 0.1406532597155259,
                                      0.1690047266392679, 0.1903505780647854,
                                      0.2044329400752989, 0.2094821410847278 };
    static const double gauss[] = { 0.1294849661688697, 0.2797053914892767,
                                    0.3818300505051189, 0.4179591836734694 };

    for (int k = 0; k < PARTS; k++)
        sum[k] = missed[k] = 0.0;
    for (int i = 0; i < 15; i++) {
        const int n = i < 8 ? i : 14 - i;
        const double t = 0.5 * h * (1.0 + (i < 8 ? -node[n] : node[n]));
        double rate[PARTS];
        rates_at(w, from + t, rate);
        for (int k = 0; k < PARTS; k++) {
            sum[k] += 0.5 * h * kronrod[n] * rate[k];
            missed[k] +=
                0.5 * h * rate[k] * (kronrod[n] - (n % 2 ? gauss[n / 2] : 0.0));
        }
    }
}

/* The larger of what both integrals (`first` on) are of their sums; NaN if
 * either is. */
static double part_of(const double some[], const double all[], int first)
{
    const double slip = fabs(some[SLIP]) / (fabs(all[SLIP]) + 0x1p-1000);

    if (first == SLIP)
        return slip;
    const double time = fabs(some[TIME]) / (fabs(all[TIME]) + 0x1p-1000);
    return time <= slip || isnan(slip) ? slip : time;
}

/* Of the better rule, by QUADPACK's experience with both. */
static double panel_error(double missed, double all)
{
    const double part = fabs(missed) / (fabs(all) + 0x1p-1000);

    return fmin(fabs(missed), pow(TOL_REST_QUADPACK * part, 1.5) * fabs(all));
}

/* The integrals; false where they have no end, or rates change over less than
 * the differences that they are made of. */
static bool sum_up(const struct way *w, int first, double sum[PARTS])
{
    double at = 0.0, h = TOL_REST_PANEL;

    for (int k = 0; k < PARTS; k++)
        sum[k] = 0.0;
    for (int i = 0; i < TOL_BRANCH_STEPS && h > TOL_REST_DIFFERENCE; i++) {
        double more[PARTS], missed[PARTS], all[PARTS];
        sum_panel(w, at, h, more, missed);
        for (int k = 0; k < PARTS; k++)
            all[k] = sum[k] + more[k];
        const double error = part_of(missed, all, first);
        const double noise = part_of(more + TIME_WRONG, all, first);
        if (!(error < fmax(TOL_RTOL_DEFAULT, noise))) {
            h *= 0.5;
            continue;
        }
        for (int k = 0; k < PARTS; k++)
            sum[k] = all[k];
        for (int k = TIME; k <= SLIP; k++)
            sum[TIME_WRONG + k] += panel_error(missed[k], all[k]);
        if (part_of(more, sum, first) < TOL_NOTHING)
            return true;
        at += h;
        if (error < fmax(TOL_RTOL_DEFAULT * TOL_REST_EASY, noise))
            h *= 2.0;
    }
    return false;
}

/* Where only inertia slows it: psi_ss rises by 1 while ln v falls by v.  psi
 * behind the curve leaps onto it in less than that; ahead of it by g it falls
 * by a sinh to 2 lag, at once, and from there on waits until psi_ss has risen
 * by g, while its lead fades like a line. */
static void add_wait(const struct way *w, struct rest_left *r)
{
    const struct slider *s = w->slider;
    const struct vec2 z = w->z;
    const struct rest_lag l = rest_lag_at(s, z.x);
    const bool is_log = s->plane.system.axis[1].is_log;
    const double v = exp(s->block.at.x0 + z.x);
    const double psi = exp(s->plane.system.origin.y + l.y), above = z.y - l.y;
    const double lead = is_log ? psi * expm1(above) : above;
    const double g = fmin(fmax(lead, 0.0), 2.0 * (1.0 + l.lag));
    const double y =
        lead > g && g > 0.0 ? l.y + (is_log ? log1p(g / psi) : g) : z.y;
    const double shift = fabs(rest_lag_slowness(s, z.x, y) - l.slowness);
    const double late = (2.0 + g) * v * shift;

    r->time_error += late;
    r->slip_error += v * late;
}

/* An orbit that is not quite on the curve gets there by as much earlier or
 * later as its rates differ meanwhile: as long as inertia tells, the longer the
 * further off it is. */
static void add_landing(const struct way *w, struct rest_left *r)
{
    const struct block *b = &w->slider->block;
    const struct vec2 z = w->z;
    const double v = exp(b->at.x0 + z.x);

    const struct point p = point_at(b, z.y);
    const double off = fabs(z.x - p.x), wait = 2.0 * fabs(p.d / p.slope);
    const double shift = change_of_rate(b, &p, z.y, off);

    if (isfinite(r->time))
        r->time_error += wait * shift * exp(-p.log_rate);
    r->slip_error += wait * (shift + off) * exp(b->at.x0 + p.x - p.log_rate);
    if (off > TOL_REST_WRONG) {
        const double fall =
            fmax(off, 1.0) * rest_lag_slowness(w->slider, z.x, z.y);
        const double moved =
            fall * moment_rates(w->slider, (double[]){ z.x, z.y }).y;
        if (isfinite(r->time))
            r->time_error += fall + fabs(moved) * exp(-p.log_rate);
        r->slip_error +=
            v * fall + fabs(moved) * exp(b->at.x0 + p.x - p.log_rate);
    }
}

/* Beside all of it; the slip so far is about v times the time, or more. */
static bool is_good(const struct slider *s, struct vec2 z, double time,
                    const struct rest_left *r)
{
    const double v = exp(s->block.at.x0 + z.x);

    return (isinf(r->time) ||
            r->time_error <= TOL_REST_GOOD * (r->time + time)) &&
           r->slip_error <= TOL_REST_GOOD * (r->slip + v * time);
}

bool rest_left_find(const struct slider *s, struct vec2 z, double time,
                    struct rest_left *out)
{
    const struct block *b = &s->block;
    const struct rest_form form = rest_form_at(b);
    const bool ends = form.fate == FATE_REST_FINITE;
    const struct way w = { s, z, form.inertial };
    double sum[PARTS], rate[PARTS];
    struct rest_left r = { .time = HUGE_VAL, .slip = HUGE_VAL };

    if (!is_there(s, z, time))
        return false;
    if (form.has_slip) {
        if (!sum_up(&w, ends ? TIME : SLIP, sum))
            return false;
        rates_at(&w, 0.0, rate);
        r.slip = sum[SLIP];
        r.slip_error = sum[SLIP_WRONG] + 0x1p-46 * r.slip;
        r.slip_slope = rate[SLIP];
        if (ends) {
            r.time = sum[TIME];
            r.time_error = sum[TIME_WRONG] + 0x1p-46 * r.time;
            r.time_slope = rate[TIME];
        }
        if (form.inertial)
            add_wait(&w, &r);
        else
            add_landing(&w, &r);
    }
    if (!is_good(s, z, time, &r))
        return false;
    *out = r;
    return true;
}

struct vec2 rest_left_section(const struct slider *s)
{
    const bool x = rest_form_at(&s->block).inertial;

    return (struct vec2){ x, !x };
}

struct rest_left rest_left_between(const struct slider *s, double x, double h)
{
    const struct way w = { s, { x, 0.0 }, true };
    double sum[PARTS], missed[PARTS];

    sum_panel(&w, 0.0, h, sum, missed);
    return (struct rest_left){
        .time = sum[TIME],
        .slip = sum[SLIP],
        .time_error = sum[TIME_WRONG] + panel_error(missed[TIME], sum[TIME]),
        .slip_error = sum[SLIP_WRONG] + panel_error(missed[SLIP], sum[SLIP]),
    };
}
