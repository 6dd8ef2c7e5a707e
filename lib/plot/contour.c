/* Marching squares (Lorensen & Cline, SIGGRAPH 1987, 163-169, in the plane):
 * a line goes from edge to edge of the squares between four centres.  Where it
 * could go two ways, the mean of the four decides; where neighbours differ by a
 * sixth of the scale there is a step, and no line runs along it. */
#include "contour.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "room.h"

/* An edge of the grid of centres: from (i, j) to the right, or up. */
struct edge {
    size_t i, j;
    bool up;
};

struct tracer {
    const struct figure_raster *r; /* borrowed */
    double level;
    double jump; /* what neighbours differ by at most, or there is a step */
    struct vec2 box;
    uint8_t *done; /* owned: bits 1 (right) and 2 (up) of each centre */
};

static double value_at(const struct tracer *t, size_t i, size_t j)
{
    const double v = t->r->value[j * t->r->nx + i];

    return t->r->scale.is_log ? log(v) : v;
}

/* The values at both ends of an edge. */
static void edge_values(const struct tracer *t, struct edge e, double v[2])
{
    v[0] = value_at(t, e.i, e.j);
    v[1] = value_at(t, e.i + !e.up, e.j + e.up);
}

static bool crosses(const struct tracer *t, struct edge e)
{
    double v[2];

    edge_values(t, e, v);
    return fabs(v[1] - v[0]) <= t->jump &&
           (v[0] < t->level) != (v[1] < t->level);
}

static struct vec2 edge_point(const struct tracer *t, struct edge e)
{
    double v[2];

    edge_values(t, e, v);
    const double part = (t->level - v[0]) / (v[1] - v[0]);
    const double x = (double) e.i + 0.5 + (e.up ? 0 : part);
    const double y = (double) e.j + 0.5 + (e.up ? part : 0);
    return (struct vec2){ x / (double) t->r->nx * t->box.x,
                          y / (double) t->r->ny * t->box.y };
}

/* The edges of a square: below, above, left, right. */
static struct edge edge_of(size_t i, size_t j, int side)
{
    return (struct edge){ i + (side == 3), j + (side == 1), side > 1 };
}

/* The side by which a line that comes in by `from` leaves the square; -1: by
 * none. */
static int leave(const struct tracer *t, size_t i, size_t j, int from)
{
    static const int beside[2][4] = { { 2, 3, 0, 1 }, { 3, 2, 1, 0 } };
    bool cut[4];
    double sum = 0.0;
    int count = 0, other = -1;

    for (size_t k = 0; k < 4; k++) {
        cut[k] = crosses(t, edge_of(i, j, (int) k));
        count += cut[k];
        sum += value_at(t, i + k % 2, j + k / 2) / 4.0;
        if (cut[k] && (int) k != from)
            other = (int) k;
    }
    if (!isfinite(sum))
        return -1;
    if (count < 4)
        return other;
    return beside[(sum < t->level) == (value_at(t, i, j) < t->level)][from];
}

static uint8_t *mark_of(const struct tracer *t, struct edge e)
{
    return &t->done[e.j * t->r->nx + e.i];
}

/* From an edge into the square on one side of it, on and on until there is no
 * way or the line was there. */
static enum status follow(const struct tracer *t, struct edge e, bool ahead,
                          struct stroke *s)
{
    enum status status = STATUS_OK;

    while (status == STATUS_OK) {
        const size_t i = e.i - (e.up && !ahead), j = e.j - (!e.up && !ahead);
        if (i >= t->r->nx - 1 || j >= t->r->ny - 1) /* also below 0 */
            break;
        const int out =
            leave(t, i, j, e.up ? (ahead ? 2 : 3) : (ahead ? 0 : 1));
        if (out < 0)
            break;
        e = edge_of(i, j, out);
        ahead = out == 1 || out == 3;
        status = stroke_push(s, edge_point(t, e));
        if (*mark_of(t, e) & (1 << e.up))
            break;
        *mark_of(t, e) |= (uint8_t) (1 << e.up);
    }
    return status;
}

/* One piece: both ways from an edge. */
static enum status trace_piece(const struct tracer *t, struct edge e,
                               struct stroke *s)
{
    enum status status = STATUS_OK;

    if (s->count > 0)
        status = stroke_push(s, (struct vec2){ (double) NAN, (double) NAN });
    const size_t first = s->count;
    *mark_of(t, e) |= (uint8_t) (1 << e.up);
    if (status == STATUS_OK)
        status = stroke_push(s, edge_point(t, e));
    if (status == STATUS_OK)
        status = follow(t, e, true, s);
    const struct vec2 begin = s->at[first], end = s->at[s->count - 1];
    if (status != STATUS_OK ||
        (s->count > first + 1 && begin.x == end.x && begin.y == end.y))
        return status; /* closed */
    for (size_t a = first, b = s->count; a + 1 < b; a++, b--) {
        const struct vec2 p = s->at[a];
        s->at[a] = s->at[b - 1];
        s->at[b - 1] = p;
    }
    return follow(t, e, false, s);
}

enum status contour_trace(const struct figure_raster *r, double level,
                          struct vec2 box, struct stroke *out)
{
    const struct figure_axis *a = &r->scale;
    const double range = a->is_log ? log(a->hi / a->lo) : a->hi - a->lo;
    const struct tracer t = { r, a->is_log ? log(level) : level, range / 6, box,
                              calloc(r->nx * r->ny, 1) };
    enum status status = t.done ? STATUS_OK : STATUS_NO_MEMORY;

    out->count = 0;
    for (size_t k = 0; k < 2 * r->nx * r->ny && status == STATUS_OK; k++) {
        const struct edge e = { k / 2 % r->nx, k / 2 / r->nx, k % 2 == 1 };
        if (e.i + !e.up < r->nx && e.j + e.up < r->ny &&
            !(*mark_of(&t, e) & (1 << e.up)) && crosses(&t, e))
            status = trace_piece(&t, e, out);
    }
    free(t.done);
    if (status != STATUS_OK)
        out->count = 0;
    return status;
}

/* ---- labels -------------------------------------------------------------- */

/* The longest piece [from, to) and its length. */
static double longest(const struct stroke *s, size_t *from, size_t *to)
{
    double best = 0.0, length = 0.0;
    size_t begin = 0;

    *from = *to = 0;
    for (size_t k = 0; k <= s->count; k++) {
        const bool ends = k == s->count || isnan(s->at[k].x);
        if (ends && length > best) {
            best = length;
            *from = begin;
            *to = k;
        }
        if (ends) {
            begin = k + 1;
            length = 0.0;
        } else if (k > begin) {
            length += vec2_length(vec2_sub(s->at[k], s->at[k - 1]));
        }
    }
    return best;
}

bool contour_place(const struct stroke *s, struct vec2 size,
                   const struct keep *keep, uint8_t own, struct vec2 *at)
{
    const struct vec2 half = { size.x / 2.0 + CONTOUR_CLEAR,
                               size.y / 2.0 + CONTOUR_CLEAR };
    size_t from, to;

    if (!(longest(s, &from, &to) > 3.0 * size.x))
        return false;
    for (size_t k = 0; k < to - from; k++) { /* the middle first */
        const size_t middle = (to - from) / 2, off = (k + 1) / 2;
        const size_t here = from + (k % 2 ? middle + off : middle - off);
        if (here < from || here >= to)
            continue;
        if (keep_is_free(keep, s->at[here], half, own)) {
            *at = s->at[here];
            return true;
        }
    }
    return false;
}
