/* Jobard & Lefer, Visualization in Scientific Computing 1997, 43-55: a line
 * ends where it comes too near to others.  Changed: too near is a cell of a
 * grid, not half the spacing, so that orbits are seen to the curve that
 * attracts them; and a line goes on where it has left the others again. */
#include "crowd.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "plane.h"
#include "room.h"

/* Cells: between points looked at, added at the ends, left out. */
static const double stride = 0.5, tail = 3.0, crumb = 6.0;

void crowd_init(struct crowd *c, const struct figure *f)
{
    *c = (struct crowd){ .x = scale_of(&f->x, CROWD_CELLS),
                         .y = scale_of(&f->y, CROWD_CELLS) };
}

static bool in_box(struct vec2 u)
{
    return u.x >= 0.0 && u.x <= CROWD_CELLS && u.y >= 0.0 && u.y <= CROWD_CELLS;
}

static size_t cell_of(double u)
{
    return u < CROWD_CELLS ? (size_t) u : CROWD_CELLS - 1;
}

/* Whether a cell beside that of u is taken, or it is not in the box. */
static bool is_near(const struct crowd *c, struct vec2 u)
{
    if (!in_box(u))
        return true;
    const size_t i = cell_of(u.x), k = cell_of(u.y);
    for (size_t y = k > 0 ? k - 1 : 0; y <= k + 1 && y < CROWD_CELLS; y++)
        for (size_t x = i > 0 ? i - 1 : 0; x <= i + 1 && x < CROWD_CELLS; x++)
            if (c->taken[y][x])
                return true;
    return false;
}

/* Points in cells, no two further apart than a stride where they can be seen.
 */
struct fine {
    struct fine_point {
        struct vec2 u;
        size_t own; /* index of the line's point; SIZE_MAX: between two */
    } * at;         /* owned */
    size_t count, room;
    enum status status;
};

static void fine_add(struct fine *f, struct vec2 u, size_t own)
{
    if (f->status == STATUS_OK)
        f->status = ROOM_FOR(f->at, f->room, f->count + 1);
    if (f->status == STATUS_OK)
        f->at[f->count++] = (struct fine_point){ u, own };
}

static struct fine crowd_refine(const struct crowd *c, const struct line *l)
{
    struct fine f = { .status = l->failed ? STATUS_NO_MEMORY : STATUS_OK };
    struct vec2 a = { (double) NAN, (double) NAN };

    for (size_t i = 0; i < l->count; i++) {
        const struct vec2 b = { scale_pixel(&c->x, l->x[i]),
                                scale_pixel(&c->y, l->y[i]) };
        const double far = vec2_length(vec2_sub(b, a)) / stride;
        const size_t n = far < 4 * CROWD_CELLS && (in_box(a) || in_box(b))
                             ? (size_t) far + 1
                             : 1;
        for (size_t k = 1; k < n; k++) {
            const struct vec2 u = vec2_add(
                a, vec2_scale((double) k / (double) n, vec2_sub(b, a)));
            if (in_box(u))
                fine_add(&f, u, SIZE_MAX);
        }
        fine_add(&f, b, i);
        a = b;
    }
    return f;
}

static void take_points(struct crowd *c, const struct fine_point *p,
                        size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (in_box(p[i].u))
            c->taken[cell_of(p[i].u.y)][cell_of(p[i].u.x)] = 1;
}

void crowd_take(struct crowd *c, const struct line *l)
{
    struct fine f = crowd_refine(c, l);

    c->failed = c->failed || f.status != STATUS_OK;
    take_points(c, f.at, f.count);
    free(f.at);
}

/* From point i - 1 to point i, cells. */
static double step(const struct fine *f, size_t i)
{
    return vec2_length(vec2_sub(f->at[i].u, f->at[i - 1].u));
}

/* The free part that begins at `from`: the index behind it, and how long it
 * is; the same index where there is none. */
static size_t free_part(const struct crowd *c, const struct fine *f,
                        size_t from, double *length)
{
    size_t to = from;

    *length = 0.0;
    for (; to < f->count && !is_near(c, f->at[to].u); to++)
        *length += to > from ? step(f, to) : 0.0;
    return to;
}

/* Moves an end by up to a tail; never beyond `stop`. */
static size_t grow_end(const struct fine *f, size_t at, size_t stop, int way)
{
    double gone = 0.0;

    while (at != stop) {
        const size_t next = way > 0 ? at + 1 : at - 1;
        gone += step(f, way > 0 ? next : at);
        if (!(gone <= tail)) /* also where the line is broken */
            break;
        at = next;
    }
    return at;
}

/* One part, from first to last, of what was the line l. */
static void put_part(const struct crowd *c, const struct fine *f, size_t first,
                     size_t last, const struct line *l, struct line *out)
{
    if (out->count > 0)
        line_add(out, (double) NAN, (double) NAN);
    for (size_t k = first; k <= last; k++) {
        const struct fine_point *p = &f->at[k];
        if (p->own < SIZE_MAX)
            line_add(out, l->x[p->own], l->y[p->own]);
        else if (k == first || k == last)
            line_add(out, scale_value(&c->x, p->u.x),
                     scale_value(&c->y, p->u.y));
    }
}

void crowd_cut(struct crowd *c, struct line *l)
{
    struct fine f = crowd_refine(c, l);
    struct line left = { .failed = c->failed || f.status != STATUS_OK };
    size_t done = 0;

    for (size_t i = 0; i < f.count; i++) {
        double length;
        const size_t to = free_part(c, &f, i, &length);
        if (length >= crumb) {
            const size_t first = grow_end(&f, i, done, -1);
            done = grow_end(&f, to - 1, f.count - 1, 1);
            put_part(c, &f, first, done, l, &left);
            take_points(c, f.at + first, done - first + 1);
            i = done;
        } else if (to > i) {
            i = to - 1;
        }
    }
    free(f.at);
    line_free(l);
    *l = left;
}
