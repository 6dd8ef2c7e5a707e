/*
 * Clipping: Liang & Barsky, ACM Trans. Graph. 3 (1984) 1-22; the coordinate
 * that hits the frame is set to the frame's, not computed.
 * Thinning: a wedge from the last kept point holds every direction that
 * passes within the tolerance of all points since (Williams, Comput. Graph.
 * Image Process. 8 (1978) 286-293); one pass, no recursion.  Changed: a point
 * nearer to the anchor than one before it is kept, so turning back is not lost.
 */
#include "stroke.h"

#include <math.h>
#include <stdlib.h>

#include "room.h"

enum status stroke_push(struct stroke *s, struct vec2 p)
{
    const enum status status = ROOM_FOR(s->at, s->room, s->count + 1);
    if (status == STATUS_OK)
        s->at[s->count++] = p;
    return status;
}

static bool is_break(struct vec2 p)
{
    return isnan(p.x);
}

static struct vec2 to_page(const struct scale *sx, const struct scale *sy,
                           double x, double y)
{
    const struct vec2 p = { scale_pixel(sx, x), scale_pixel(sy, y) };
    return isfinite(p.x) && isfinite(p.y) ? p : (struct vec2){ NAN, NAN };
}

/* One direction of Liang & Barsky: keeps t with 0 <= p + t d <= size. */
static bool stroke_narrow(double p, double d, double size, double *t0,
                          double *t1)
{
    if (d == 0)
        return p >= 0 && p <= size;
    const double enter = ((d > 0 ? 0 : size) - p) / d;
    const double leave = ((d > 0 ? size : 0) - p) / d;
    *t0 = fmax(*t0, enter);
    *t1 = fmin(*t1, leave);
    return *t0 <= *t1;
}

static double stroke_clamp(double p, double size)
{
    return fmin(fmax(p, 0), size);
}

/* One coordinate of the point at t, where the segment enters (leaves) the box:
 * exactly on the frame if it is this direction that cuts. */
static double stroke_cut(double p, double d, double size, double t, bool enters)
{
    const double side = (d > 0) == enters ? 0 : size;
    return t == (side - p) / d ? side : stroke_clamp(p + t * d, size);
}

static struct vec2 cut_at(struct vec2 p, struct vec2 d, struct vec2 size,
                          double t, bool enters)
{
    return (struct vec2){ stroke_cut(p.x, d.x, size.x, t, enters),
                          stroke_cut(p.y, d.y, size.y, t, enters) };
}

/* Appends the visible part of p -> q; the pen may still be at p. */
static enum status push_segment(struct stroke *s, struct vec2 p, struct vec2 q,
                                struct vec2 size, bool *pen_down)
{
    const struct vec2 d = vec2_sub(q, p);
    double t0 = 0, t1 = 1;
    enum status status = STATUS_OK;
    if (!isfinite(d.x) || !isfinite(d.y) ||
        !stroke_narrow(p.x, d.x, size.x, &t0, &t1) ||
        !stroke_narrow(p.y, d.y, size.y, &t0, &t1)) {
        *pen_down = false;
        return STATUS_OK;
    }
    if (!*pen_down || t0 > 0) {
        if (s->count > 0)
            status = stroke_push(s, (struct vec2){ NAN, NAN });
        if (status == STATUS_OK)
            status = stroke_push(s, t0 > 0 ? cut_at(p, d, size, t0, true) : p);
    }
    if (status == STATUS_OK)
        status = stroke_push(s, t1 < 1 ? cut_at(p, d, size, t1, false) : q);
    *pen_down = t1 >= 1;
    return status;
}

/* How far along the way from a to b is what a log axis shows. */
static double shown_part(const struct scale *s, double a, double b)
{
    return s->is_log && a > 0 && b <= 0 ? (a - s->lo) / (a - b) : 1;
}

/* The last point of a straight way from a that can be drawn: where a log axis
 * ends, if b is not on it at all. */
static struct vec2 last_shown(const struct scale *sx, const struct scale *sy,
                              struct vec2 a, struct vec2 b)
{
    const double t = fmin(shown_part(sx, a.x, b.x), shown_part(sy, a.y, b.y));

    return t >= 1 ? to_page(sx, sy, b.x, b.y)
           : t > 0
               ? to_page(sx, sy, a.x + t * (b.x - a.x), a.y + t * (b.y - a.y))
               : (struct vec2){ NAN, NAN };
}

enum status stroke_clip(const struct scale *sx, const struct scale *sy,
                        const double x[], const double y[], size_t count,
                        struct stroke *out)
{
    const struct vec2 size = { sx->pixels, sy->pixels };
    bool pen_down = false;
    out->count = 0;
    for (size_t k = 1; k < count; k++) {
        const struct vec2 a = { x[k - 1], y[k - 1] }, b = { x[k], y[k] };
        const struct vec2 p = last_shown(sx, sy, b, a);
        const struct vec2 q = last_shown(sx, sy, a, b);
        if (is_break(p) || is_break(q)) {
            pen_down = false;
        } else if (push_segment(out, p, q, size, &pen_down) != STATUS_OK) {
            out->count = 0;
            return STATUS_NO_MEMORY;
        }
        pen_down = pen_down && !is_break(to_page(sx, sy, b.x, b.y));
    }
    return STATUS_OK;
}

/* Distance inside one side of the box: 0 left, 1 right, 2 below, 3 above. */
static double stroke_inside(int side, struct vec2 size, struct vec2 p)
{
    switch (side) {
        case 0:
            return p.x;
        case 1:
            return size.x - p.x;
        case 2:
            return p.y;
        default:
            return size.y - p.y;
    }
}

/* Keeps what is inside one side. */
static enum status keep_side(int side, struct vec2 size,
                             const struct stroke *in, struct stroke *out)
{
    enum status s = STATUS_OK;
    out->count = 0;
    for (size_t k = 0; k < in->count && s == STATUS_OK; k++) {
        const struct vec2 p = in->at[k ? k - 1 : in->count - 1], q = in->at[k];
        const double a = stroke_inside(side, size, p),
                     b = stroke_inside(side, size, q);
        if ((a < 0) != (b < 0)) {
            const double t = a / (a - b);
            struct vec2 r = { p.x * (1 - t) + q.x * t,
                              p.y * (1 - t) + q.y * t };
            *(side < 2 ? &r.x : &r.y) = side == 1   ? size.x
                                        : side == 3 ? size.y
                                                    : 0;
            s = stroke_push(out, r);
        }
        if (b >= 0 && s == STATUS_OK)
            s = stroke_push(out, q);
    }
    return s;
}

enum status stroke_clip_region(const struct scale *sx, const struct scale *sy,
                               const double x[], const double y[], size_t count,
                               struct stroke *out)
{
    const struct vec2 size = { sx->pixels, sy->pixels };
    struct stroke other = STROKE_EMPTY;
    enum status s = STATUS_OK;
    out->count = 0;
    for (size_t k = 0; k < count && s == STATUS_OK; k++) {
        const struct vec2 p = to_page(sx, sy, x[k], y[k]);
        if (!is_break(p))
            s = stroke_push(out, p);
    }
    for (int side = 0; side < 4 && s == STATUS_OK; side++) {
        const struct stroke in = *out;
        s = keep_side(side, size, &in, &other);
        *out = other;
        other = in;
    }
    stroke_free(&other);
    if (s != STATUS_OK)
        out->count = 0;
    return s;
}

/* Directions from the anchor, counterclockwise from lo to hi, unit vectors less
 * than half a turn apart. */
struct wedge {
    struct vec2 anchor, lo, hi;
    double reach; /* largest distance from the anchor so far */
};

/* Positive where b lies counterclockwise of a. */
static double turn_of(struct vec2 a, struct vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

/* Takes q in; false if no line from the anchor to q serves all points. */
static bool wedge_take(struct wedge *w, struct vec2 q, double tolerance)
{
    const struct vec2 d = vec2_sub(q, w->anchor);
    const double r = vec2_length(d);
    if (r < w->reach)
        return false;
    if (r <= tolerance)
        return true;
    const double s = tolerance / r, c = sqrt(1.0 - s * s);
    const struct vec2 u = vec2_scale(1.0 / r, d);
    const struct vec2 lo = { c * u.x + s * u.y, c * u.y - s * u.x };
    const struct vec2 hi = { c * u.x - s * u.y, c * u.y + s * u.x };
    if (w->reach == 0)
        *w = (struct wedge){ w->anchor, lo, hi, r };
    if (turn_of(w->lo, u) < 0 || turn_of(u, w->hi) < 0)
        return false;
    if (turn_of(w->lo, lo) > 0)
        w->lo = lo;
    if (turn_of(hi, w->hi) > 0)
        w->hi = hi;
    w->reach = r;
    return true;
}

void stroke_thin(struct stroke *s, double tolerance)
{
    size_t kept = 0;
    struct wedge w = { .anchor = { NAN, NAN } };
    bool in_piece = false;
    for (size_t k = 0; k < s->count; k++) {
        const struct vec2 p = s->at[k];
        const bool ends = k + 1 == s->count || is_break(s->at[k + 1]);
        if (is_break(p) || !in_piece) {
            s->at[kept++] = p;
            in_piece = !is_break(p);
            w = (struct wedge){ .anchor = p };
            continue;
        }
        if (!wedge_take(&w, p, tolerance)) {
            const struct vec2 corner = s->at[k - 1];
            s->at[kept++] = corner;
            w = (struct wedge){ .anchor = corner };
            (void) wedge_take(&w, p, tolerance);
        }
        if (ends)
            s->at[kept++] = p;
    }
    s->count = kept;
}

static double segment_length(const struct stroke *s, size_t k)
{
    const double length = vec2_length(vec2_sub(s->at[k + 1], s->at[k]));
    return isnan(length) ? 0 : length;
}

double stroke_length(const struct stroke *s)
{
    double sum = 0;
    for (size_t k = 0; k + 1 < s->count; k++)
        sum += segment_length(s, k);
    return sum;
}

/* Point at distance d along the segments [from, to). */
static struct vec2 point_at(const struct stroke *s, size_t from, size_t to,
                            double d)
{
    for (size_t k = from; k + 1 < to; k++) {
        const double length = segment_length(s, k);
        if (d <= length && length > 0) {
            const struct vec2 step = vec2_sub(s->at[k + 1], s->at[k]);
            return vec2_add(s->at[k], vec2_scale(d / length, step));
        }
        d -= length;
    }
    return s->at[to - 1];
}

void stroke_barb(struct vec2 tail, struct vec2 tip, struct vec2 head[3])
{
    const struct vec2 d = vec2_sub(tip, tail);
    const struct vec2 side = { -0.36 * d.y, 0.36 * d.x };
    head[0] = vec2_add(tail, side);
    head[1] = tip;
    head[2] = vec2_sub(tail, side);
}

/* The piece [from, to) at a distance along the stroke, which becomes the
 * distance along the piece; the last piece takes what lies beyond. */
static bool piece_at(const struct stroke *s, double *d, size_t *from,
                     size_t *to, double *length)
{
    for (*from = 0; *from < s->count; *from = *to + 1) {
        *length = 0;
        for (*to = *from + 1; *to < s->count && !is_break(s->at[*to]); ++*to)
            *length += segment_length(s, *to - 1);
        if (*d <= *length || *to >= s->count)
            return true;
        *d -= *length;
    }
    return false;
}

/* The way that a head of that length has to go, centred at c of a piece. */
static struct vec2 way_at(const struct stroke *s, size_t from, size_t to,
                          double c, double length, struct vec2 *tail)
{
    *tail = point_at(s, from, to, c - length / 2);
    return vec2_sub(point_at(s, from, to, c + length / 2), *tail);
}

/* The place nearest to d along a piece at which it is straight over a head's
 * length: the chord is no shorter than that of an arc of 60 degrees.  d itself
 * where there is none. */
static double straight_at(const struct stroke *s, size_t from, size_t to,
                          double piece, double d, double length)
{
    const double chord = 3 / M_PI, lo = length / 2, hi = piece - length / 2;
    struct vec2 tail;

    for (int k = 0; k * length / 2 < piece; k++)
        for (int side = -1; side <= 1; side += 2) {
            const double c = d + side * k * length / 2;
            if (c >= lo && c <= hi &&
                vec2_length(way_at(s, from, to, c, length, &tail)) >=
                    chord * length)
                return c;
        }
    return d;
}

bool stroke_head(const struct stroke *s, double fraction, double length,
                 struct vec2 head[3])
{
    double d = fraction * stroke_length(s), piece;
    size_t from, to;
    if (!piece_at(s, &d, &from, &to, &piece) || !(piece >= 2 * length))
        return false;
    d = fmin(fmax(d, length / 2), piece - length / 2);
    const double c = straight_at(s, from, to, piece, d, length);
    struct vec2 tail;
    const struct vec2 way = way_at(s, from, to, c, length, &tail);
    const double r = vec2_length(way);
    if (!(r > length / 2))
        return false;
    stroke_barb(tail, vec2_add(tail, vec2_scale(length / r, way)), head);
    return true;
}

void stroke_free(struct stroke *s)
{
    free(s->at);
    *s = STROKE_EMPTY;
}
