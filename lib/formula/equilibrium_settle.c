/* Newton's method in 113 bits, then Krawczyk's operator in 113 bits on a box
 * around what it found: the bar is the half-width of K.  Eigenvalues are
 * enclosed over that box: t/2 -+ sqrt(h^2 + bc), t = a + d, h = (a - d)/2, the
 * smaller of two real ones also as det/larger. */
#include <math.h>

#include "equilibrium_search.h"
#include "formula_tolerance.h"
#include "quad.h"

typedef struct interval_quad range;

static range around(formula_real c, formula_real r)
{
    return (range){ c - r, c + r };
}

static range point(formula_real x)
{
    return around(x, 0);
}

static formula_real middle(range u)
{
    return (u.lo + u.hi) / 2;
}

static bool holds_zero(range u)
{
    return u.lo <= 0 && u.hi >= 0;
}

/* The middle, and a bar rounded up. */
static struct system_number number_of(range u)
{
    const formula_real c = middle(u);
    const formula_real half = c - u.lo > u.hi - c ? c - u.lo : u.hi - c;

    return (struct system_number){
        c, nextafter((double) (half + fabsq(c) * (formula_real) 0x1p-112L),
                     HUGE_VAL)
    };
}

/* ---- place --------------------------------------------------------------- */

static bool invert(formula_real m[2][2], formula_real inverse[2][2])
{
    const formula_real det = m[0][0] * m[1][1] - m[0][1] * m[1][0];

    inverse[0][0] = m[1][1] / det;
    inverse[0][1] = -m[0][1] / det;
    inverse[1][0] = -m[1][0] / det;
    inverse[1][1] = m[0][0] / det;
    const formula_real size = fabsq(inverse[0][0]) + fabsq(inverse[0][1]) +
                              fabsq(inverse[1][0]) + fabsq(inverse[1][1]);
    return size < (formula_real) 0x1p16000L;
}

/* One step from c; its size in step[]. */
static bool newton(struct equilibrium_search *s, formula_real c[2],
                   formula_real step[2], formula_real inverse[2][2])
{
    const range at[2] = { point(c[0]), point(c[1]) };
    struct interval_slope_quad f[2];
    formula_real slope[2][2];

    if (interval_over_quad(&s->equation, at, f) != INTERVAL_WHOLE)
        return false;
    for (int i = 0; i < 4; i++)
        slope[i / 2][i % 2] = middle(f[i / 2].by[i % 2]);
    if (!invert(slope, inverse))
        return false;
    for (int i = 0; i < 2; i++) {
        const formula_real d = inverse[i][0] * middle(f[0].value) +
                               inverse[i][1] * middle(f[1].value);
        step[i] = fabsq(d);
        c[i] -= d;
    }
    return step[0] < (formula_real) 1e300L && step[1] < (formula_real) 1e300L;
}

/* K of the box c -+ r in place[]; whether it is inside. */
static bool krawczyk(struct equilibrium_search *s, const formula_real c[2],
                     const formula_real r[2], formula_real inverse[2][2],
                     range place[2])
{
    const range at[2] = { point(c[0]), point(c[1]) };
    const range box[2] = { around(c[0], r[0]), around(c[1], r[1]) };
    struct interval_slope_quad f[2], over[2];
    bool inside = true;

    if (interval_over_quad(&s->equation, box, over) != INTERVAL_WHOLE)
        return false;
    interval_over_quad(&s->equation, at, f);
    for (int i = 0; i < 2; i++) {
        range sum = at[i];
        for (int k = 0; k < 2; k++)
            sum = interval_less_quad(
                sum, interval_times_quad(point(inverse[i][k]), f[k].value));
        for (int j = 0; j < 2; j++) {
            range left = point(i == j);
            for (int k = 0; k < 2; k++)
                left = interval_less_quad(
                    left,
                    interval_times_quad(point(inverse[i][k]), over[k].by[j]));
            sum = interval_add_quad(
                sum,
                interval_times_quad(left, interval_less_quad(box[j], at[j])));
        }
        place[i] = sum;
        inside = inside && sum.lo > box[i].lo && sum.hi < box[i].hi;
    }
    return inside;
}

static bool find_place(struct equilibrium_search *s,
                       const struct interval_double start[2], range place[2])
{
    formula_real c[2], step[2] = { 0, 0 }, inverse[2][2], r[2];

    for (int k = 0; k < 2; k++)
        c[k] = ((formula_real) start[k].lo + start[k].hi) / 2;
    for (int i = 0; i < 8; i++)
        if (!newton(s, c, step, inverse))
            return false;
    for (int k = 0; k < 2; k++)
        r[k] = TOL_SETTLE_PART * fabsq(c[k]) + 4 * step[k] +
               TOL_SETTLE_PART * (s->window.hi[k] - s->window.lo[k]) *
                   (formula_real) 0x1p-20L;
    for (int tries = 0; tries < 5; tries++) {
        if (krawczyk(s, c, r, inverse, place))
            return true;
        for (int k = 0; k < 2; k++)
            r[k] *= TOL_SETTLE_GROWTH;
    }
    return false;
}

/* ---- eigenvalues --------------------------------------------------------- */

static void set_pair(struct system_equilibrium *q, range re0, range im0,
                     range re1, range im1)
{
    q->eigenvalue[0].re = number_of(re0);
    q->eigenvalue[0].im = number_of(im0);
    q->eigenvalue[1].re = number_of(re1);
    q->eigenvalue[1].im = number_of(im1);
}

static range cut(range u, range w)
{
    return (range){ u.lo > w.lo ? u.lo : w.lo, u.hi < w.hi ? u.hi : w.hi };
}

static enum system_equilibrium_type type_of(range first, range second,
                                            bool complex)
{
    if (holds_zero(first) || holds_zero(second))
        return SYSTEM_NONHYPERBOLIC;
    if (first.hi < 0 && second.lo > 0)
        return SYSTEM_SADDLE;
    if (second.hi < 0)
        return complex ? SYSTEM_STABLE_FOCUS : SYSTEM_STABLE_NODE;
    return complex ? SYSTEM_UNSTABLE_FOCUS : SYSTEM_UNSTABLE_NODE;
}

static range halved(range u)
{
    return (range){ u.lo / 2, u.hi / 2 };
}

/* Real ones, or nearly: bars hold both. */
static void set_real(struct system_equilibrium *q, range half_trace,
                     range squared, range det)
{
    const range root = interval_sqrt_quad(squared);
    const range none =
        interval_sqrt_quad((range){ 0, squared.lo < 0 ? -squared.lo : 0 });
    const range im = { -none.hi, squared.lo < 0 ? none.hi : 0 };
    range low = interval_less_quad(half_trace, root);
    range high = interval_add_quad(half_trace, root);
    const range larger = middle(half_trace) < 0 ? low : high;

    if (squared.lo > 0 && !holds_zero(larger)) {
        const range smaller = interval_divide_quad(det, larger);
        *(middle(half_trace) < 0 ? &high : &low) =
            cut(middle(half_trace) < 0 ? high : low, smaller);
    }
    q->type = type_of(low, high, false);
    set_pair(q, low, squared.lo < 0 ? im : point(0), high,
             squared.lo < 0 ? im : point(0));
}

static bool set_eigenvalues(struct equilibrium_search *s, const range place[2],
                            struct system_equilibrium *q)
{
    struct interval_slope_quad f[2];

    if (interval_over_quad(&s->rate, place, f) != INTERVAL_WHOLE ||
        !holds_zero(f[0].value) || !holds_zero(f[1].value))
        return false;
    const range a = f[0].by[0], b = f[0].by[1], c = f[1].by[0], d = f[1].by[1];
    const range half = halved(interval_less_quad(a, d));
    const range product = interval_times_quad(b, c);
    const range squared =
        interval_add_quad(interval_times_quad(half, half), product);
    const range half_trace = halved(interval_add_quad(a, d));
    const range det = interval_less_quad(interval_times_quad(a, d), product);

    if (squared.hi < 0) {
        const range im =
            interval_sqrt_quad((range){ -squared.hi, -squared.lo });
        q->type = type_of(half_trace, half_trace, true);
        set_pair(q, half_trace, (range){ -im.hi, -im.lo }, half_trace, im);
    } else {
        set_real(q, half_trace, squared, det);
    }
    return true;
}

/* ---- all ----------------------------------------------------------------- */

/* Angles go to where the window has them; outside of it: false. */
static bool bring_into_window(const struct equilibrium_search *s,
                              struct system_equilibrium *q)
{
    for (int k = 0; k < 2; k++) {
        const double error = q->chart[k].error;
        const formula_real lo = s->window.lo[k], hi = s->window.hi[k];
        formula_real *at = &q->chart[k].value;
        if (s->period[k] > 0) {
            const formula_real turns = *at + error < lo                ? 1
                                       : *at - error > lo + s->turn[k] ? -1
                                                                       : 0;
            const formula_real shift =
                turns +
                (*at + turns * s->turn[k] + error >= lo + s->turn[k] ? -1 : 0);
            *at += shift * s->turn[k];
            for (int i = 0; i < 2; i++)
                q->box[k][i] += (double) (shift * s->turn[k]);
        } else if (*at + error < lo || *at - error > hi) {
            return false;
        }
    }
    return true;
}

static bool is_known(const struct equilibrium_search *s,
                     const struct system_equilibrium *q)
{
    for (int i = 0; i < s->out->count; i++) {
        const struct system_equilibrium *known = &s->out->equilibrium[i];
        bool same = true;
        for (int k = 0; k < 2; k++) {
            const formula_real apart =
                fabsq(q->chart[k].value - known->chart[k].value);
            const formula_real turn = s->period[k] > 0 ? s->turn[k] : 0;
            const formula_real bar =
                q->chart[k].error + known->chart[k].error + TOL_PERIODIC * turn;
            same = same && (apart <= bar || fabsq(apart - turn) <= bar);
        }
        if (same)
            return true;
    }
    return false;
}

/* The state itself: e^chart and its bar, (e^error - 1) times as much. */
static void set_state(const struct equilibrium_search *s, int k,
                      struct system_equilibrium *q)
{
    const struct system_number at = q->chart[k];

    q->state[k] = at;
    if (!s->is_log[k])
        return;
    q->state[k].value = expq(at.value);
    q->state[k].error =
        nextafter((double) (q->state[k].value *
                            (expm1q(at.error) + (formula_real) 0x1p-108L)),
                  HUGE_VAL);
}

bool search_settle(struct equilibrium_search *s,
                   const struct interval_double unique[2],
                   const struct interval_double start[2])
{
    struct system_equilibrium q = { .type = SYSTEM_NONHYPERBOLIC };
    range place[2];

    if (!find_place(s, start, place))
        return false;
    for (int k = 0; k < 2; k++) {
        if (place[k].lo < unique[k].lo || place[k].hi > unique[k].hi)
            return false;
        q.chart[k] = number_of(place[k]);
        q.box[k][0] = unique[k].lo;
        q.box[k][1] = unique[k].hi;
    }
    if (!bring_into_window(s, &q) || is_known(s, &q))
        return true;
    if (s->out->count == SYSTEM_EQUILIBRIA || !set_eigenvalues(s, place, &q))
        return false;
    for (int k = 0; k < 2; k++)
        set_state(s, k, &q);
    s->out->equilibrium[s->out->count++] = q;
    return true;
}
