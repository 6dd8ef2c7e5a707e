/* unit.c -- a number in other units, and its bar.
 *
 * With eps = 2^-52, twice the unit roundoff: f, a product or quotient of two
 * doubles, is off by eps/2 |f|, a product with it by as much again; e^x, ln x
 * are right to eps (elementary.c). */
#include "unit.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const struct unit units[] = {
    { "V_star", "m/s", UNIT_FACTOR, 1, 0 },
    { "L", "m", UNIT_FACTOR, 0, 1 },
    { "L/V_star", "s", UNIT_FACTOR, -1, 1 },
    { "V_star/L", "1/s", UNIT_FACTOR, 1, -1 },
    { "ln(V_star)", "ln(m/s)", UNIT_LN, 1, 0 },
    { "log10(V_star/L)", "log10(1/s)", UNIT_LOG10, 1, -1 },
    { "psi", "1", UNIT_STATE, 0, 0 },
    { "ln(psi)", "1", UNIT_LN_STATE, 0, 0 },
    { "kick of psi", "1", UNIT_KICK, 0, 0 },
    { "rad", "rad", UNIT_ANGLE, 0, 0 },
};

const struct unit *unit_find(const char *own)
{
    for (size_t i = 0; own && i < sizeof units / sizeof *units; i++)
        if (strcmp(units[i].own, own) == 0)
            return &units[i];
    return NULL;
}

const char *unit_plain(const char *own)
{
    const struct unit *unit = unit_find(own);

    return unit && unit->kind != UNIT_ANGLE ? "1" : own;
}

const char *unit_factor(const char *own)
{
    const struct unit *unit = unit_find(own);

    return unit && unit->kind == UNIT_FACTOR ? own : NULL;
}

static const char *const angle_names[] = { "rad", "degree", "1" };

const char *unit_name(const struct unit_system *u, const char *own)
{
    const struct unit *unit = unit_find(own);
    const bool si = u && u->si;

    if (unit == NULL)
        return own;
    if (unit->kind == UNIT_ANGLE)
        return angle_names[u ? u->angle : ANGLE_RAD];
    if (unit->kind < UNIT_STATE)
        return si ? unit->si : unit->own;
    if (!si || unit->kind == UNIT_KICK || strcmp(u->phi, "1") == 0)
        return "1";
    return unit->kind == UNIT_STATE ? u->phi : "ln(s)";
}

double unit_scale(const struct unit_system *u, const struct unit *unit)
{
    const double over =
        (unit->rate > 0 ? u->V_star : 1.0) * (unit->length > 0 ? u->L : 1.0);
    const double under =
        (unit->rate < 0 ? u->V_star : 1.0) * (unit->length < 0 ? u->L : 1.0);

    if (unit->kind == UNIT_ANGLE)
        return 180.0 / M_PI;
    return unit->kind >= UNIT_STATE ? u->phi_1 : over / under;
}

bool unit_system_is_own(const struct unit_system *u)
{
    return !u->si && u->angle == ANGLE_RAD;
}

/* Whether a number of this unit is told as it is. */
static bool is_own(const struct unit_system *u, const struct unit *unit)
{
    if (u == NULL || unit == NULL)
        return true;
    return unit->kind == UNIT_ANGLE ? u->angle == ANGLE_RAD : !u->si;
}

double unit_value(const struct unit_system *u, const struct unit *unit,
                  double x)
{
    if (is_own(u, unit))
        return x;
    const double f = unit_scale(u, unit);
    switch (unit->kind) {
        case UNIT_LN:
        case UNIT_LN_STATE:
            return x + log(f);
        case UNIT_LOG10:
            return x + log10(f);
        case UNIT_KICK:
            return u->psi_is_log ? exp(x) : x;
        case UNIT_STATE:
            return u->psi_is_log ? f * exp(x) : f * x;
        case UNIT_ANGLE:
            return u->angle == ANGLE_TAN ? tan(x) : f * x;
        case UNIT_FACTOR:
            break;
    }
    return f * x;
}

/* e^x - 1 <= x (1 + x) for 0 <= x <= 1.79. */
static double growth(double x)
{
    return x <= 1.0 ? x * (1.0 + x) : exp(x);
}

/* |tan(x + e) - t| <= (1 + t^2) d/(1 - |t| d) with t = tan x, d = tan e. */
static double tangent_bar(double t, double error)
{
    const double d = tan(error), left = 1 - fabs(t) * d;

    if (!(left > 0 && d >= 0))
        return (double) INFINITY;
    return ((1 + t * t) * d / left + 2 * DBL_EPSILON * fabs(t)) *
           (1 + 8 * DBL_EPSILON);
}

/* What `error` becomes, and rounding; of what is below all normal doubles a
 * step of those. */
static double bar_of(const struct unit_system *u, const struct unit *unit,
                     double to, double error)
{
    const double f = unit_scale(u, unit), eps = DBL_EPSILON;
    const double size = fabs(to);

    switch (unit->kind) {
        case UNIT_LN:
        case UNIT_LN_STATE:
        case UNIT_LOG10:
            return (error + 2 * eps * (size + fabs(log(f)) + 1)) *
                   (1 + 4 * eps);
        case UNIT_KICK:
        case UNIT_STATE:
            if (u->psi_is_log)
                return size * (growth(error) + 4 * eps) * (1 + 8 * eps) +
                       2 * DBL_TRUE_MIN;
            break;
        case UNIT_ANGLE:
            if (u->angle == ANGLE_TAN)
                return tangent_bar(to, error);
            break;
        case UNIT_FACTOR:
            break;
    }
    const double tiny =
        to != 0.0 && (size < DBL_MIN || f * error < DBL_MIN) ? DBL_TRUE_MIN : 0;
    return (f * error + 2 * eps * size) * (1 + 4 * eps) + 2 * tiny;
}

/* Relative: of a logarithm as its value is, of an exponential as the exponent
 * is; V_star and L are inputs, too. */
static double conditioning_of(const struct unit *unit, double from, double to,
                              double c, bool is_log)
{
    const double inputs = 2 * 0x1p-53;

    if (unit->kind == UNIT_ANGLE)
        return c * fmax(1.0, (1 + to * to) * fabs(from / to));
    if (unit->kind >= UNIT_STATE && is_log)
        return c * fabs(from) + inputs;
    if (unit->kind == UNIT_FACTOR || unit->kind >= UNIT_STATE)
        return c + inputs;
    return (c * fabs(from) + inputs) / fabs(to);
}

/* An angle's is linear, as the spread is; what V_star, L and phi_1 add is known
 * to whoever found it. */
static double spread_of(const struct unit_system *u, const struct unit *unit,
                        double to, const struct quantity *q)
{
    if (unit->kind != UNIT_ANGLE)
        return q->spread_si;
    return q->spread *
           (u->angle == ANGLE_TAN ? 1 + to * to : unit_scale(u, unit));
}

struct quantity unit_quantity(const struct unit_system *u,
                              const struct unit *unit, struct quantity q)
{
    if (is_own(u, unit) || !quantity_exists(&q) ||
        (unit->kind == UNIT_KICK && !u->psi_is_log))
        return q;
    const double to = unit_value(u, unit, q.value);
    const double error = bar_of(u, unit, to, q.error);
    if (!isfinite(to) || !isfinite(error))
        return quantity_none("in SI units it is beyond the largest double");
    q.conditioning =
        conditioning_of(unit, q.value, to, q.conditioning, u->psi_is_log);
    q.spread = q.spread_si = spread_of(u, unit, to, &q);
    q.proved = q.proved && unit->kind != UNIT_ANGLE ? q.proved + 1 : NULL;
    q.value = to;
    q.error = error;
    return q;
}
