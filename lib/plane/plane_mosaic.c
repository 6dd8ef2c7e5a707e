/* By levels, of 2^level cells a side, the largest first: what few orbits tell
 * is known even where there is no work for more. */
#include "plane_mosaic.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plane_beyond.h"
#include "plane_label.h"
#include "plane_rest.h"
#include "plane_tolerance.h"
#include "room.h"

/* LEAST: levels of any region. */
enum { UNKNOWN = -1, OPEN = -2, GOALS_MOST = 120, LEAST = 2 };

/* ---- goals --------------------------------------------------------------- */

/* The number of a goal among those of the basins, of which it keeps what all
 * have in common. */
static enum status number_of(struct plane_study *s,
                             const struct plane_goal *goal, int8_t *number)
{
    struct plane_basin *b = &s->basin;
    size_t i = 0;

    *number = UNKNOWN;
    if (goal->kind == PLANE_GOAL_NONE)
        return STATUS_OK;
    while (i < b->goals && !plane_goal_is_same(s, &b->goal[i], goal))
        i++;
    if (i == GOALS_MOST)
        return STATUS_OK;
    const enum status status = ROOM_FOR(b->goal, b->goal_room, i + 1);
    if (status != STATUS_OK)
        return status;
    if (i == b->goals)
        b->goal[b->goals++] = *goal;
    else
        plane_beyond_meet(s, &b->goal[i].beyond, &goal->beyond);
    *number = (int8_t) i;
    return STATUS_OK;
}

/* ---- the square ---------------------------------------------------------- */

/* Of a region in the window: its rows, and of one of these, c being its
 * crossings, from where to where it goes. */
struct square {
    const struct plane_study *s;
    const struct band *band;
    size_t k; /* number in the band */
    double from, to;
};

static struct square square_of(const struct plane_study *s, size_t region)
{
    const struct band *b = plane_patch_band(&s->basin.regions, region);
    const struct box w = s->window.box;

    return (struct square){ s, b, region - b->first, fmax(b->lo, w.lo.y),
                            fmin(b->hi, w.hi.y) };
}

/* The square as a window, of which all but the ends of a row is known. */
static struct window window_of(const struct square *q,
                               const struct crossing c[])
{
    const size_t n = q->band->strands;
    struct window w = q->s->window;

    if (c) {
        w.box.lo.x = plane_patch_end(q->s, c, n, q->k);
        w.box.hi.x = plane_patch_end(q->s, c, n, q->k + 1);
    }
    w.box.lo.y = q->from;
    w.box.hi.y = q->to;
    return w;
}

/* false: the row is as thin as rounding. */
static bool place_at(const struct square *q, struct vec2 part,
                     struct crossing scratch[], struct vec2 *z)
{
    struct window w = window_of(q, NULL);
    const double y = window_at(&w, part).y;

    if (separatrix_row(&q->s->basin.cuts, y, scratch) != q->band->strands)
        return false;
    w = window_of(q, scratch);
    *z = window_at(&w, part);
    return w.box.lo.x < w.box.hi.x;
}

/* ---- cells --------------------------------------------------------------- */

struct dividing {
    struct plane_study *s;
    struct patches *p;
    const struct plane_parts *parts; /* borrowed */
    size_t patch;
    struct square square;
    int levels, n;     /* n = 2^levels */
    int8_t *middle[9]; /* of the cells of each level and those around; or OPEN
                        */
    int8_t *label;     /* borrowed: of the finest */
    struct vec2 *rest; /* owned; by equilibrium, where one that attracts is in
                          the square; else below 0 */
    int64_t most;
    plane_ask *ask;
    void *ctx;
};

/* Inside the square. */
static double inside(double part)
{
    return fmin(fmax(part, TOL_SEEN), 1.0 - TOL_SEEN);
}

static int cell_at(int n, double part)
{
    return (int) fmin(fmax(part * n, 0.0), n - 1.0);
}

static void place_rests(struct dividing *d, size_t region)
{
    const struct plane_study *s = d->s;

    for (size_t k = 0; k < s->listed; k++) {
        const struct vec2 z = s->rest[k].z;
        const bool in = plane_rest_attracts(&s->rest[k], false) &&
                        box_holds(s->window.box, z) &&
                        regions_at(d->p->r, z, d->p->above) == region;
        const struct window w = window_of(&d->square, in ? d->p->above : NULL);
        d->rest[k] = in ? window_unit(&w, z) : (struct vec2){ -1.0, -1.0 };
    }
}

/* What attracts in a cell, if something does. */
static bool rest_in(const struct dividing *d, int n, int i, int j,
                    struct vec2 *z)
{
    for (size_t k = 0; k < d->s->listed; k++)
        if (d->rest[k].x >= 0.0 && cell_at(n, d->rest[k].x) == i &&
            cell_at(n, d->rest[k].y) == j) {
            *z = d->s->rest[k].z;
            return true;
        }
    return false;
}

/* Whereto the middle of a cell goes, or what attracts in it; of one beside the
 * square, its edge. */
static enum status ask_middle(struct dividing *d, int level, int i, int j,
                              int8_t *out)
{
    const int n = 1 << level;
    const int number = (j + 1) * (n + 2) + i + 1;
    int8_t *known = &d->middle[level][number];
    const struct vec2 in = vec2_spread(0.5, number),
                      part = { inside((i + in.x) / n), inside((j + in.y) / n) };
    struct plane_goal goal = { .kind = PLANE_GOAL_NONE };
    struct vec2 z;
    enum status status = STATUS_OK;

    d->s->basin.unknown[PLANE_UNKNOWN_WORK] |=
        *known == OPEN && d->s->basin.steps >= d->most;
    if (*known == OPEN && d->s->basin.steps < d->most) {
        if (rest_in(d, n, i, j, &z) ||
            place_at(&d->square, part, d->p->above, &z))
            status = d->ask(d->ctx, z, &goal);
        if (status == STATUS_OK)
            status = number_of(d->s, &goal, known);
    }
    *out = *known == OPEN ? UNKNOWN : *known;
    return status;
}

/* Whether the box about the corners of a cell meets two parts of its patch. */
static bool is_parted(struct dividing *d, int level, int i, int j)
{
    const double n = 1 << level;
    struct box b = BOX_NOTHING;
    struct vec2 z;

    for (int k = 0; k < 4 && d->parts->n > 0; k++)
        if (place_at(&d->square,
                     (struct vec2){ inside((i + k % 2) / n),
                                    inside((j + k / 2) / n) },
                     d->p->above, &z))
            b = box_around(b, z);
    return b.lo.x <= b.hi.x && plane_parts_divide(d->parts, d->s, d->patch, b);
}

/* What is known of a cell: the goal of its middle and of all beside it, or that
 * none of them has one; or OPEN. */
static enum status ask_cell(struct dividing *d, int level, int i, int j,
                            int8_t *out)
{
    int8_t other;
    enum status status = ask_middle(d, level, i, j, out);

    for (int k = 0; k < 9 && status == STATUS_OK && *out != OPEN; k++) {
        status = ask_middle(d, level, i + k % 3 - 1, j + k / 3 - 1, &other);
        if (other != *out)
            *out = OPEN;
    }
    if (*out != OPEN && level < d->levels && is_parted(d, level, i, j))
        *out = OPEN;
    return status;
}

static void fill(struct dividing *d, int level, int i, int j, int8_t label)
{
    const int size = d->n >> level;

    for (int y = j * size; y < (j + 1) * size; y++)
        memset(d->label + y * d->n + i * size, label, (size_t) size);
}

static enum status divide(struct dividing *d, int level)
{
    const int n = 1 << level, size = d->n >> level;
    enum status status = STATUS_OK;
    int8_t label;

    for (int k = 0; k < n * n && status == STATUS_OK; k++) {
        const int i = k % n, j = k / n;
        if (d->label[j * size * d->n + i * size] != OPEN)
            continue;
        status = ask_cell(d, level, i, j, &label);
        if (label != OPEN)
            fill(d, level, i, j, label);
    }
    return status;
}

static enum status divide_all(struct dividing *d, int first)
{
    enum status status = STATUS_OK;

    for (int l = first; l <= d->levels && status == STATUS_OK; l++) {
        const size_t n = ((size_t) 1 << l) + 2;
        d->middle[l] = malloc(n * n);
        if (d->middle[l] == NULL)
            return STATUS_NO_MEMORY;
        memset(d->middle[l], OPEN, n * n);
        status = divide(d, l);
    }
    return status;
}

/* What is left is not known; the ends beyond the window that there are. */
static enum status close_cells(struct dividing *d)
{
    bool used[GOALS_MOST] = { false };
    enum status status = STATUS_OK;

    for (int i = 0; i < d->n * d->n; i++) {
        d->s->basin.unknown[PLANE_UNKNOWN_CELLS] |= d->label[i] == OPEN;
        if (d->label[i] == OPEN)
            d->label[i] = UNKNOWN;
        if (d->label[i] >= 0)
            used[d->label[i]] = true;
    }
    for (size_t i = 0; i < d->s->basin.goals && status == STATUS_OK; i++)
        if (used[i] && d->s->basin.goal[i].kind == PLANE_GOAL_BEYOND)
            status = plane_beyond_add(d->s, &d->s->basin.goal[i].beyond);
    return status;
}

/* Levels down to cells of that side, in a part of the window. */
static int levels_to(double side, double part)
{
    return (int) fmax(ceil(0.5 * log2(part / (side * side))), LEAST);
}

enum status plane_mosaic_add(struct plane_study *s, struct patches *p,
                             const struct plane_parts *parts, size_t region,
                             double part, int64_t most, plane_ask *ask,
                             void *ctx)
{
    struct plane_basin *b = &s->basin;
    const int levels = levels_to(TOL_PLANE_CELL, fmin(part, 1.0));
    struct dividing d = { .s = s,
                          .p = p,
                          .parts = parts,
                          .patch = plane_patch_of(p, region),
                          .square = square_of(s, region),
                          .levels = levels,
                          .n = 1 << levels,
                          .most = most,
                          .ask = ask,
                          .ctx = ctx };
    enum status status = ROOM_FOR(b->mosaic, b->mosaic_room, b->mosaics + 1);

    if (status == STATUS_OK)
        d.label = malloc((size_t) (d.n * d.n));
    if (d.label == NULL)
        return STATUS_NO_MEMORY;
    d.rest = calloc(s->listed + 1, sizeof *d.rest);
    if (d.rest)
        place_rests(&d, region);
    b->mosaic[b->mosaics++] = (struct plane_mosaic){ region, d.n, d.label };
    memset(d.label, OPEN, (size_t) (d.n * d.n));
    status = d.rest
                 ? divide_all(&d, levels_to(TOL_PLANE_CELLS, fmin(part, 1.0)))
                 : STATUS_NO_MEMORY;
    free(d.rest);
    for (int l = 0; l <= levels; l++)
        free(d.middle[l]);
    return status ? status : close_cells(&d);
}

void plane_mosaic_name(struct plane_study *s)
{
    for (size_t k = 0; k < s->basin.mosaics; k++) {
        const struct plane_mosaic *m = &s->basin.mosaic[k];
        for (int i = 0; i < m->n * m->n; i++)
            if (m->label[i] >= 0)
                m->label[i] = plane_goal_label(s, &s->basin.goal[m->label[i]]);
    }
}

/* ---- answers ------------------------------------------------------------- */

int8_t plane_mosaic_at(const struct plane_study *s, size_t region,
                       struct vec2 z, const struct crossing c[])
{
    const struct plane_basin *b = &s->basin;
    const int8_t label = b->regions.region[region].label;

    for (size_t k = 0; k < b->mosaics && label < 0; k++) {
        const struct plane_mosaic *m = &b->mosaic[k];
        if (m->region != region)
            continue;
        const struct square q = square_of(s, region);
        const struct window w = window_of(&q, c);
        const struct vec2 part = window_unit(&w, z);
        if (w.box.lo.x < w.box.hi.x)
            return m
                ->label[cell_at(m->n, part.y) * m->n + cell_at(m->n, part.x)];
    }
    return label < 0 ? (int8_t) -1 : label;
}

static bool same_rows(const struct plane_mosaic *m, int a, int b)
{
    return memcmp(m->label + a * m->n, m->label + b * m->n, (size_t) m->n) == 0;
}

void plane_mosaic_areas(const struct plane_study *s, struct patches *p,
                        size_t k, struct measure measure, struct area sum[],
                        size_t others)
{
    const struct plane_mosaic *m = &s->basin.mosaic[k];
    const struct square q = square_of(s, m->region);
    const struct window w = window_of(&q, NULL);
    int next;

    for (int j = 0; j < m->n; j = next) {
        struct box rows = s->window.box;
        for (next = j + 1; next < m->n && same_rows(m, j, next);)
            next++;
        rows.lo.y = window_at(&w, (struct vec2){ 0.0, (double) j / m->n }).y;
        rows.hi.y = window_at(&w, (struct vec2){ 0.0, (double) next / m->n }).y;
        regions_areas(p->r, rows, measure, p->below, p->part);
        const struct area a = p->part[m->region];
        for (int i = 0; i < m->n; i++) {
            const int8_t *label = m->label + j * m->n + i;
            struct area *to = &sum[*label < 0 ? others : (size_t) *label];
            to->value += a.value / m->n;
            if (i == 0 || label[0] != label[-1])
                to->error += a.error;
        }
    }
}
