/* Pseudo-arclength continuation (Allgower & Georg, Numerical Continuation
 * Methods, 1990, ch. 6) with the corrector replaced by a bracketed root on the
 * normal, so that signs suffice where a component has underflowed, and the
 * step length by the height of the cubic between two tangents, which is what
 * the straight line of the drawing misses. */
#include "trace.h"

#include <float.h>
#include <math.h>

#include "tolerance.h"

enum { BULGE_SAMPLES = 16 };

/* A point of the curve and the unit tangent there, in the sense of travel. */
struct station {
    struct vec2 at, tangent;
};

static double dot(struct vec2 u, struct vec2 v)
{
    return u.x * v.x + u.y * v.y;
}

static bool inside(struct vec2 u)
{
    return u.x >= 0.0 && u.x <= 1.0 && u.y >= 0.0 && u.y <= 1.0;
}

/* The cubic over the chord from a to b with their tangents: its slopes against
 * the chord, its height as a bound.  False where a tangent turns too far. */
struct cubic {
    struct vec2 a, chord;
    double length2, slope[2], height;
};

static bool cubic_between(const struct station *a, const struct station *b,
                          double steepest, struct cubic *c)
{
    const struct station *end[2] = { a, b };

    c->a = a->at;
    c->chord = vec2_sub(b->at, a->at);
    c->length2 = dot(c->chord, c->chord);
    for (int i = 0; i < 2; i++) {
        const double ahead = dot(c->chord, end[i]->tangent);
        c->slope[i] = vec2_cross(c->chord, end[i]->tangent) / ahead;
        if (!(ahead > 0.0 && fabs(c->slope[i]) <= steepest))
            return false;
    }
    /* max of s (1 - s)^2 is 4/27 */
    c->height =
        4.0 / 27.0 * (fabs(c->slope[0]) + fabs(c->slope[1])) * sqrt(c->length2);
    return true;
}

/* Height of the cubic over the chord at the fraction s of it. */
static double cubic_at(const struct cubic *c, double s)
{
    return sqrt(c->length2) * s * (1.0 - s) *
           (c->slope[0] * (1.0 - s) - c->slope[1] * s);
}

/* Whether there is a zero within tol of the cubic, straight across the chord,
 * at the fraction s of it, or a little further, in case another piece crosses
 * just there. */
static bool cubic_holds(struct zero *q, const struct cubic *c, double s,
                        double tol)
{
    const double length = sqrt(c->length2);
    const struct vec2 up = { -c->chord.y / length, c->chord.x / length };
    bool holds = false;

    for (int i = 0; i < 2 && !holds; i++) {
        const double at = s + 0.05 * i;
        const struct vec2 u = vec2_add(vec2_add(c->a, vec2_scale(at, c->chord)),
                                       vec2_scale(cubic_at(c, at), up));
        double width;
        holds = zero_within(q, u, up, TOL_WITHIN, tol, &width);
    }
    return holds;
}

/* How far from its cubic a smooth curve may be. */
static double cubic_tolerance(const struct cubic *c)
{
    return TOL_WITHIN + TOL_NULLCLINE_SMOOTH * c->height;
}

/* Whether the zeros a and b lie on one smooth curve, which the cubic between
 * them then follows, to its own tolerance or `tol`.  Where two pieces cross at
 * a small angle a step from one to the other looks like a bend, but no cubic
 * at two places. */
static bool smooth(struct zero *q, const struct station *a,
                   const struct station *b, double tol, struct cubic *c)
{
    if (!cubic_between(a, b, TOL_NULLCLINE_ANGLE, c))
        return false;
    tol = fmax(tol, cubic_tolerance(c));
    return cubic_holds(q, c, 1.0 / 3.0, tol) &&
           cubic_holds(q, c, 2.0 / 3.0, tol);
}

/* Whether the cubic leaves the window between its ends. */
static bool cubic_bulges(const struct cubic *c)
{
    const double length = sqrt(c->length2), tol = TOL_WITHIN;
    const struct vec2 up = { -c->chord.y / length, c->chord.x / length };
    const struct box b = { { -tol, -tol }, { 1.0 + tol, 1.0 + tol } };
    bool out = false;

    for (int i = 1; i < BULGE_SAMPLES && !out; i++) {
        const double s = (double) i / BULGE_SAMPLES;
        const struct vec2 foot = vec2_add(c->a, vec2_scale(s, c->chord));
        out = !box_holds(b, vec2_add(foot, vec2_scale(cubic_at(c, s), up)));
    }
    return out;
}

/* The same station in the drawing; false where exp() leaves no direction. */
static bool drawn(const struct trace *t, const struct station *p,
                  struct station *out)
{
    const struct box b = t->window->box;
    const struct vec2 z = window_mix(b, p->at);
    const struct vec2 size = vec2_sub(b.hi, b.lo);
    const struct vec2 v = { p->tangent.x * size.x, p->tangent.y * size.y };

    out->at = window_unit(t->window, z);
    out->tangent = window_push(t->window, z, v);
    const double length = vec2_length(out->tangent);
    out->tangent = vec2_scale(1.0 / length, out->tangent);
    return length > DBL_MIN;
}

/* How far the straight line from a to b is from the curve in the drawing. */
static double deviation(const struct trace *t, const struct station *a,
                        const struct station *b, const struct cubic *chart)
{
    struct station p, q;
    struct cubic c;

    if (!t->window->exponential[0] && !t->window->exponential[1])
        return chart->height;
    if (!drawn(t, a, &p) || !drawn(t, b, &q))
        return 0.0;
    if (!cubic_between(&p, &q, INFINITY, &c))
        return vec2_length(vec2_sub(q.at, p.at));
    return c.height;
}

/* What a step came to. */
enum landing { LANDED_INSIDE, LANDED_ON_EDGE, LANDED_NOWHERE };

struct step {
    struct station to;
    struct cubic cubic;
    double deviation;
};

/* Whether b, on the zero set, continues the curve from a. */
static bool accept(const struct trace *t, const struct station *a,
                   struct vec2 b, struct step *out)
{
    const struct vec2 chord = vec2_sub(b, a->at);
    const double length = vec2_length(chord);

    if (!(length > 0.0))
        return false;
    out->to.at = b;
    if (!zero_tangent(t->zero, b, vec2_scale(1.0 / length, chord),
                      &out->to.tangent) ||
        !smooth(t->zero, a, &out->to, 0.0, &out->cubic))
        return false;
    out->deviation = deviation(t, a, &out->to, &out->cubic);
    return out->deviation <= t->chord;
}

/* Whether the zero u lies on the step from a: the curve is smooth on both sides
 * of it.  Less strict than the step itself was: u may be where the cubic to it
 * is flat or where the first one was worse than at the places looked at, and
 * a point taken for passed is the lesser evil; its piece has others. */
static bool passes(const struct trace *t, const struct station *a,
                   const struct step *step, struct vec2 u)
{
    const struct cubic *c = &step->cubic;
    const double length = sqrt(c->length2);
    const struct vec2 d = vec2_sub(u, a->at);
    const struct vec2 forward = vec2_scale(1.0 / length, c->chord);
    const double near = TOL_NULLCLINE_NEAR * length + TOL_WITHIN;
    const double ahead = dot(d, forward), tol = 4.0 * cubic_tolerance(c);
    struct station at = { .at = u };
    struct cubic unused;

    if (!(fabs(vec2_cross(forward, d)) <= near && ahead >= -near &&
          ahead <= length + near))
        return false;
    if (vec2_length(d) <= TOL_WITHIN ||
        vec2_length(vec2_sub(u, step->to.at)) <= TOL_WITHIN)
        return true;
    return zero_tangent(t->zero, u, forward, &at.tangent) &&
           smooth(t->zero, a, &at, tol, &unused) &&
           smooth(t->zero, &at, &step->to, tol, &unused);
}

/* Where the curve from a, which goes on to b outside, meets the edge on the
 * given side: axis 0 (x) or 1 (y) at 0 or 1. */
static bool land_on_side(const struct trace *t, const struct station *a,
                         struct vec2 b, int axis, double side, struct step *out)
{
    const struct vec2 d = vec2_sub(b, a->at);
    const double s =
        axis == 0 ? (side - a->at.x) / d.x : (side - a->at.y) / d.y;
    const double reach = vec2_length(d);
    struct vec2 guess = vec2_add(a->at, vec2_scale(s, d)), edge;

    if (axis == 0)
        guess.x = side;
    else
        guess.y = side;
    const struct vec2 across = { axis == 0 ? 0.0 : 1.0, axis == 0 ? 1.0 : 0.0 };
    return zero_near(t->zero, guess, across, reach / 64.0, reach, &edge) &&
           inside(edge) && accept(t, a, edge, out);
}

static bool land_on_edge(const struct trace *t, const struct station *a,
                         struct vec2 b, struct step *out)
{
    return (b.x < 0.0 && land_on_side(t, a, b, 0, 0.0, out)) ||
           (b.x > 1.0 && land_on_side(t, a, b, 0, 1.0, out)) ||
           (b.y < 0.0 && land_on_side(t, a, b, 1, 0.0, out)) ||
           (b.y > 1.0 && land_on_side(t, a, b, 1, 1.0, out));
}

static enum landing try_step(const struct trace *t, const struct station *a,
                             double h, struct step *out)
{
    const struct vec2 guess = vec2_add(a->at, vec2_scale(h, a->tangent));
    const struct vec2 across = { -a->tangent.y, a->tangent.x };
    struct vec2 b;

    if (!zero_near(t->zero, guess, across, h / 64.0, 0.5 * h, &b))
        return LANDED_NOWHERE;
    if (inside(b))
        return accept(t, a, b, out) && !cubic_bulges(&out->cubic)
                   ? LANDED_INSIDE
                   : LANDED_NOWHERE;
    return land_on_edge(t, a, b, out) ? LANDED_ON_EDGE : LANDED_NOWHERE;
}

static void mark(const struct trace *t, const struct station *a,
                 const struct step *step)
{
    for (size_t i = 0; i < t->seeds; i++)
        if (!t->seed[i].passed && passes(t, a, step, t->seed[i].at))
            t->seed[i].passed = true;
}

/* One accepted step, of length at most *h, which becomes what to try next. */
static enum landing step(const struct trace *t, const struct station *a,
                         double *h, struct step *out)
{
    enum landing l = LANDED_NOWHERE;

    while (l == LANDED_NOWHERE && *h > TOL_WITHIN) {
        l = try_step(t, a, *h, out);
        if (l == LANDED_NOWHERE)
            *h *= 0.5;
    }
    if (l == LANDED_NOWHERE)
        return l;
    mark(t, a, out);
    const double wish = TOL_AIM * t->chord;
    const double slope =
        fmax(fabs(out->cubic.slope[0]), fabs(out->cubic.slope[1]));
    *h *= fmin(fmin(2.0, sqrt(wish / fmax(out->deviation, DBL_MIN))),
               TOL_AIM * TOL_NULLCLINE_ANGLE / fmax(slope, DBL_MIN));
    *h = fmin(*h, TOL_NULLCLINE_STEP_MAX);
    return l;
}

enum status trace_run(const struct trace *t, struct vec2 tangent,
                      struct polyline *line, enum trace_end *end)
{
    const size_t first = line->count - 1;
    struct station at = { line->at[first], tangent };
    const struct station start = at;
    double h = TOL_NULLCLINE_STEP_MAX / 8.0;

    *end = TRACE_LOOSE;
    for (size_t n = 0; n < TOL_CURVE_STEPS; n++) {
        struct step s;
        const enum landing l = step(t, &at, &h, &s);
        if (l == LANDED_NOWHERE)
            return STATUS_OK;
        const bool closed = first == 0 && n > 0 && l == LANDED_INSIDE &&
                            dot(s.to.tangent, start.tangent) > 0.0 &&
                            passes(t, &at, &s, start.at);
        const enum status status =
            polyline_push(line, closed ? start.at : s.to.at);
        if (status != STATUS_OK)
            return status;
        if (closed || l == LANDED_ON_EDGE) {
            *end = closed ? TRACE_CLOSED : TRACE_EDGE;
            return STATUS_OK;
        }
        at = s.to;
    }
    return STATUS_OK;
}
