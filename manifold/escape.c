#include "escape.h"

#include <math.h>

#include "tolerance.h"

enum { SAMPLES = 16, CROSSINGS = 32 };

/* ---- touching ------------------------------------------------------------ */

/* How much outside a range, in units of its length. */
static double outside(double at, double lo, double hi)
{
    return hi - lo < HUGE_VAL ? fmax(fmax(lo - at, at - hi), 0.0) / (hi - lo)
                              : 0.0;
}

static double between(double a, double b, double lo, double hi)
{
    return hi - lo < HUGE_VAL ? (b - a) / (hi - lo) : 0.0;
}

bool escape_may_touch(const struct curve *c, size_t piece, struct vec2 origin,
                      struct box box)
{
    double here[CURVE_DIM_MAX], next[CURVE_DIM_MAX], last = 0.0;

    curve_at(c, piece, 0.0, here);
    for (int i = 0; i <= SAMPLES; i++) {
        const double far =
            hypot(outside(origin.x + here[0], box.lo.x, box.hi.x),
                  outside(origin.y + here[1], box.lo.y, box.hi.y));
        curve_at(c, piece, fmin((i + 1.0) / SAMPLES, 1.0), next);
        const double step =
            hypot(between(here[0], next[0], box.lo.x, box.hi.x),
                  between(here[1], next[1], box.lo.y, box.hi.y));
        if (!(far > TOL_ESCAPE_CHORD * fmax(step, last)))
            return true;
        last = step;
        here[0] = next[0];
        here[1] = next[1];
    }
    return false;
}

struct box escape_around(const struct curve *c, size_t piece, struct vec2 size)
{
    struct vec2 last = curve_point(c, piece, 0.0);
    struct box b = { last, last };
    double most = 0.0;

    for (int i = 1; i <= SAMPLES; i++) {
        const struct vec2 z = curve_point(c, piece, (double) i / SAMPLES);
        most = fmax(most, hypot(between(last.x, z.x, 0.0, size.x),
                                between(last.y, z.y, 0.0, size.y)));
        b = box_around(b, z);
        last = z;
    }
    const struct vec2 off = vec2_scale(TOL_ESCAPE_CHORD * most, size);
    return (struct box){ vec2_sub(b.lo, off), vec2_add(b.hi, off) };
}

/* ---- in half sides, from the window's middle ----------------------------- */

struct frame {
    struct vec2 middle, half;
};

static struct frame frame_of(const struct planar *sys, struct box w)
{
    const struct vec2 middle = { 0.5 * (w.lo.x + w.hi.x),
                                 0.5 * (w.lo.y + w.hi.y) };

    return (
        struct frame){ vec2_sub(middle, sys->origin),
                       { 0.5 * (w.hi.x - w.lo.x), 0.5 * (w.hi.y - w.lo.y) } };
}

static struct vec2 place(const struct frame *f, const struct curve *c,
                         size_t piece, double theta)
{
    double at[CURVE_DIM_MAX];

    curve_at(c, piece, theta, at);
    return (struct vec2){ (at[0] - f->middle.x) / f->half.x,
                          (at[1] - f->middle.y) / f->half.y };
}

/* Whether all orbits cross the ray between two places in that sense. */
static bool leads_out(const struct planar *sys, const struct frame *f,
                      double from, double to, double sense)
{
    for (int i = 0; i <= CROSSINGS; i++) {
        const double x = from + (double) i / CROSSINGS * (to - from);
        struct planar_field at;
        sys->field(sys->ctx,
                   (struct vec2){ f->middle.x + f->half.x * x, f->middle.y },
                   &at);
        if (!(sense * at.direction.y > 0.0))
            return false;
    }
    return true;
}

/* Where the piece crosses the axis through the middle between lo and hi. */
static double on_axis(const struct frame *f, const struct curve *c,
                      size_t piece, double lo, double hi)
{
    const bool above = place(f, c, piece, lo).y > 0.0;

    for (int i = 0; i < 52; i++) {
        const double middle = 0.5 * (lo + hi);
        *((place(f, c, piece, middle).y > 0.0) == above ? &lo : &hi) = middle;
    }
    return place(f, c, piece, hi).x;
}

/* At a crossing of the ray, in a sense; true where that ends a round. */
static bool come_round(struct escape *e, const struct planar *sys,
                       const struct frame *f, double at, double sense)
{
    const bool round = e->at > 0.0 && e->half && sense == e->sense;

    e->left =
        e->left || (round && at > e->at && leads_out(sys, f, e->at, at, sense));
    e->at = at;
    e->sense = sense;
    e->half = false;
    return round;
}

/* The part of a piece from lo to hi, after e->here. */
static bool look_on(struct escape *e, const struct planar *sys,
                    const struct frame *f, const struct curve *c, size_t piece,
                    double lo, double hi)
{
    const struct vec2 before = e->here, next = place(f, c, piece, hi);
    const bool up = next.y > 0.0;

    e->here = next;
    if ((before.y > 0.0) == up)
        return false;
    const double at = on_axis(f, c, piece, lo, hi);
    if (at > 0.0)
        return come_round(e, sys, f, at, up ? 1.0 : -1.0);
    if (e->half || (up ? -1.0 : 1.0) != e->sense)
        e->at = 0.0; /* it turns back */
    e->half = true;
    return false;
}

bool escape_add(struct escape *e, const struct planar *sys, struct box window,
                const struct curve *c, size_t piece)
{
    const struct frame f = frame_of(sys, window);
    bool round = false;

    if (escape_may_touch(c, piece, sys->origin, window)) {
        *e = (struct escape){ .left = e->left };
        return false;
    }
    if (!e->outside)
        *e = (struct escape){ .outside = true,
                              .here = place(&f, c, piece, 0.0),
                              .left = e->left };
    for (int i = 0; i < SAMPLES; i++)
        round = look_on(e, sys, &f, c, piece, (double) i / SAMPLES,
                        (i + 1.0) / SAMPLES) ||
                round;
    return round;
}
