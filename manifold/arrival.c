/* The form of a trap solves A'P + PA = -1 (Lyapunov); how far V falls along the
 * field at least half as fast as along its linear part is looked at on
 * ellipses, four for each half of the size: between two of them nothing stops
 * it, unless the field changes by half of itself there and back. */
#include "arrival.h"

#include <math.h>
#include <string.h>

#include "tolerance.h"

static double shortest(double d, double period)
{
    return period > 0.0 ? remainder(d, period) : d;
}

struct vec2 arrival_from(const struct arrival_scale *s, struct vec2 a,
                         struct vec2 b)
{
    return (struct vec2){ shortest(a.x - b.x, s->period.x) / s->side.x,
                          shortest(a.y - b.y, s->period.y) / s->side.y };
}

/* A piece of a curve, and where it may come to. */
struct approach {
    const struct arrival_scale *s;
    const struct curve *c;
    size_t piece;
    struct vec2 origin, to;
    double speed; /* |dz/dtheta| is nowhere larger */
};

static double distance_at(const struct approach *a, double theta)
{
    double at[CURVE_DIM_MAX];

    curve_at(a->c, a->piece, theta, at);
    const struct vec2 z = vec2_add(a->origin, (struct vec2){ at[0], at[1] });
    return vec2_length(arrival_from(a->s, z, a->to));
}

/* sum of j |coefficient j| */
static double speed_of(const struct approach *a)
{
    const double *x = curve_component(a->c, a->piece, 0),
                 *y = curve_component(a->c, a->piece, 1);
    double sum = 0.0;

    for (size_t j = 1; j <= a->c->piece[a->piece].degree; j++)
        sum += (double) j *
               (fabs(x[j]) / a->s->side.x + fabs(y[j]) / a->s->side.y);
    return sum;
}

/* Whether it may come so near between lo and hi: the distance changes no faster
 * than the curve moves. */
static bool may_come(const struct approach *a, double lo, double hi,
                     double most)
{
    const double middle = 0.5 * (lo + hi), half = 0.5 * (hi - lo);

    if (distance_at(a, middle) - a->speed * half > most)
        return false;
    return half < 0.01 || may_come(a, lo, middle, most) ||
           may_come(a, middle, hi, most);
}

double arrival_nearest(const struct arrival_scale *s, const struct curve *c,
                       size_t piece, struct vec2 origin, struct vec2 to,
                       double most, double *theta)
{
    enum { SAMPLES = 16, REFINE = 60 };
    struct approach a = { s, c, piece, origin, to, 0.0 };
    double best = HUGE_VAL, width = 1.0 / SAMPLES;

    a.speed = speed_of(&a);
    *theta = 1.0;
    if (!may_come(&a, 0.0, 1.0, most))
        return HUGE_VAL;
    for (int i = -SAMPLES; i < 2 * REFINE && best > 0.0; i++) {
        const double step = i % 2 ? width : -width;
        const double t = i <= 0 ? (double) (i + SAMPLES) / SAMPLES
                                : fmin(fmax(*theta + step, 0.0), 1.0);
        const double d = distance_at(&a, t);
        if (d < best) {
            best = d;
            *theta = t;
        } else if (i > 0 && i % 2 == 0) {
            width *= 0.5;
        }
    }
    return best;
}

/* ---- traps --------------------------------------------------------------- */

static double form_at(const struct trap_form *t, struct vec2 u)
{
    return t->pxx * u.x * u.x + 2.0 * t->pxy * u.x * u.y + t->pyy * u.y * u.y;
}

/* Whether V falls all along V = size^2; along the linear part it falls by
 * `rate` u'u, in units of e^log_unit. */
static bool falls(const struct planar *sys, const struct arrival_scale *s,
                  const struct trap_form *t, double rate, double log_unit,
                  double size)
{
    enum { DIRECTIONS = 48 };

    for (int i = 0; i < DIRECTIONS; i++) {
        const double angle = 2.0 * M_PI * i / DIRECTIONS;
        struct vec2 u = { cos(angle), sin(angle) };
        struct planar_field f;
        u = vec2_scale(size / sqrt(form_at(t, u)), u);
        sys->field(sys->ctx, (struct vec2){ u.x * s->side.x, u.y * s->side.y },
                   &f);
        const struct vec2 d = { f.direction.x / s->side.x,
                                f.direction.y / s->side.y };
        const double rise = 2.0 * ((t->pxx * u.x + t->pxy * u.y) * d.x +
                                   (t->pxy * u.x + t->pyy * u.y) * d.y);
        if (!(rise * exp(f.log_scale - log_unit) <
              -0.5 * rate * (u.x * u.x + u.y * u.y)))
            return false;
    }
    return true;
}

static double largest_size(const struct planar *sys,
                           const struct arrival_scale *s,
                           const struct trap_form *t, double rate,
                           double log_unit)
{
    double size = 0.0;
    int fell = 0;

    for (int k = 4 * TOL_TRAP_LEVELS; k >= 4; k--) {
        const double next = exp2(-k / 4.0);
        if (!falls(sys, s, t, rate, log_unit, next))
            break;
        size = next;
        fell++;
    }
    return fell >= TOL_TRAP_LEAST ? size : 0.0;
}

struct trap_form trap_form_at(const struct planar *sys,
                              const struct arrival_scale *s)
{
    struct trap_form t = { .z = sys->origin };
    struct planar_jacobian J;

    sys->jacobian(sys->ctx, (struct vec2){ 0.0, 0.0 }, &J);
    const double across = s->side.y / s->side.x;
    const struct mat2 A = { J.matrix.xx, J.matrix.xy * across,
                            J.matrix.yx / across, J.matrix.yy };
    const double trace = A.xx + A.yy, det = mat2_det(A);
    if (!(trace < 0.0 && det > 0.0))
        return t;
    /* det + (A - trace)'(A - trace), over -2 trace det */
    const struct mat2 B = { -A.yy, A.xy, A.yx, -A.xx };
    t.pxx = det + B.xx * B.xx + B.yx * B.yx;
    t.pxy = B.xx * B.xy + B.yx * B.yy;
    t.pyy = det + B.xy * B.xy + B.yy * B.yy;
    const struct eigen2 e =
        mat2_eigenvalues((struct mat2){ t.pxx, t.pxy, t.pxy, t.pyy });
    if (!(e.re[0] > 0.0))
        return t;
    t.pxx /= e.re[0];
    t.pxy /= e.re[0];
    t.pyy /= e.re[0];
    t.size = largest_size(sys, s, &t, -2.0 * trace * det / e.re[0],
                          J.field.log_scale);
    return t;
}

double trap_form_distance(const struct trap_form *t,
                          const struct arrival_scale *s, struct vec2 z)
{
    return sqrt(form_at(t, arrival_from(s, z, t->z)));
}

/* ---- closed orbits ------------------------------------------------------- */

static double rate_of_y(const struct planar *sys, const struct curve *c,
                        size_t piece, double theta, struct vec2 *z)
{
    double at[CURVE_DIM_MAX];
    struct planar_field f;

    curve_at(c, piece, theta, at);
    *z = (struct vec2){ at[0], at[1] };
    sys->field(sys->ctx, *z, &f);
    return f.direction.y;
}

/* Where the piece goes from up to down: seen from any side, in either
 * direction of time; *up: what the field said where it began, then where it
 * ends. */
static bool returns(const struct planar *sys, const struct curve *c,
                    size_t piece, bool *up, struct vec2 *z)
{
    double lo = 0.0, hi = 1.0, along[CURVE_DIM_MAX];
    const bool first = *up;

    *up = rate_of_y(sys, c, piece, hi, z) > 0.0;
    curve_slope_at(c, piece, lo, along);
    if (*up == first || !(along[1] > 0.0))
        return false;
    for (int i = 0; i < 52; i++) {
        const double middle = 0.5 * (lo + hi);
        const bool same = (rate_of_y(sys, c, piece, middle, z) > 0.0) == first;
        *(same ? &lo : &hi) = middle;
    }
    *z = vec2_add(sys->origin, *z);
    return true;
}

static double between(const struct winding *w, const struct arrival_scale *s,
                      size_t i, size_t j)
{
    return vec2_length(arrival_from(s, w->at[i], w->at[j]));
}

/* Whether rounds of so many returns close. */
static bool closes(struct winding *w, const struct arrival_scale *s,
                   size_t turns, const struct vec2 equilibrium[], size_t n)
{
    if (w->count <= turns)
        return false;
    const double gap = between(w, s, 0, turns);
    if (w->count < 3 * turns + 1)
        return false;
    const double before = between(w, s, turns, 2 * turns);
    const bool rounded = gap <= fmax(TOL_ROUNDED, w->noise);
    const bool shrinks = gap <= TOL_WINDING_SHRINK * before || rounded;
    const double left = rounded ? gap : gap / (1.0 - gap / before);
    if (!(gap <= TOL_WITHIN && shrinks && w->away >= TOL_BESIDE &&
          w->round > TOL_SAME + 10.0 * left))
        return false;
    for (size_t i = 0; i < n; i++)
        if (vec2_length(arrival_from(s, w->at[0], equilibrium[i])) <=
            TOL_SAME + 10.0 * left)
            return false;
    w->turns = turns;
    w->gap = gap;
    return true;
}

bool winding_is_closed(const struct winding *w, const struct arrival_scale *s)
{
    return w->count > 2 && between(w, s, 0, 1) <= w->off &&
           between(w, s, 1, 2) <= w->off && w->away < TOL_BESIDE;
}

bool winding_add(struct winding *w, const struct planar *sys,
                 const struct arrival_scale *s, const struct curve *c,
                 size_t piece, const struct vec2 equilibrium[], size_t n)
{
    double at[CURVE_DIM_MAX], theta;
    struct vec2 z;

    if (!w->begun) {
        w->begun = true;
        curve_at(c, 0, 0.0, at);
        w->up = rate_of_y(sys, c, piece, 0.0, &z) > 0.0;
        w->start = vec2_add(sys->origin, (struct vec2){ at[0], at[1] });
        w->near = HUGE_VAL;
    } else {
        w->near = fmin(w->near, arrival_nearest(s, c, piece, sys->origin,
                                                w->start, TOL_BESIDE, &theta));
    }
    curve_at(c, piece, 1.0, at);
    w->more += w->noise * (1.0 + hypot(at[0] / s->side.x, at[1] / s->side.y));
    z = vec2_add(sys->origin, (struct vec2){ at[0], at[1] });
    if (w->count > 0)
        w->extent = fmax(w->extent, vec2_length(arrival_from(s, z, w->at[0])));
    if (!returns(sys, c, piece, &w->up, &z))
        return false;
    w->round = w->extent;
    w->extent = 0.0;
    w->off = w->more;
    w->more = 0.0;
    w->away = w->near;
    w->near = HUGE_VAL;
    memmove(w->at + 1, w->at, (WINDING_KEPT - 1) * sizeof *w->at);
    w->at[0] = z;
    w->count++;
    for (size_t turns = 1; turns <= WINDING_MOST; turns++)
        if (closes(w, s, turns, equilibrium, n))
            return true;
    return false;
}
