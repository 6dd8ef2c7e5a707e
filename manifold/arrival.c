/* The form of a trap solves A'P + PA = -1 (Lyapunov); how far V falls along the
 * field at least half as fast as along its linear part is looked at on
 * ellipses, four for each half of the size: between two of them nothing stops
 * it, unless the field changes by half of itself there and back. */
#include "arrival.h"

#include <math.h>

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
    const struct vec2 z =
        vec2_add(a->origin, curve_point(a->c, a->piece, theta));
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
