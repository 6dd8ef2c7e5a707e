#include "nullcline.h"

#include <math.h>
#include <stdlib.h>

#include "room.h"
#include "tolerance.h"
#include "trace.h"

/* ---- lattice ------------------------------------------------------------- */

/* Nodes in u coordinates of zero.h, even in the chart and, where that is not
 * the same, also in the drawing; ascending from 0 to 1. */
struct lattice {
    double *node[2]; /* owned; along x, along y */
    size_t count[2];
    signed char *sign[2]; /* owned; of direction.x, .y at node [0][i], [1][j]
                             as [i + j count[0]]; 0: NaN */
};

static int compare(const void *a, const void *b)
{
    const double x = *(const double *) a, y = *(const double *) b;
    return (x > y) - (x < y);
}

/* Writes the nodes along one axis; returns how many. */
static size_t place(double node[], size_t cells, const struct window *w,
                    int axis)
{
    const struct box b = w->box;
    const double lo = axis == 0 ? b.lo.x : b.lo.y;
    const double size = (axis == 0 ? b.hi.x : b.hi.y) - lo;
    size_t n = 0;

    for (size_t i = 0; i <= cells; i++)
        node[n++] = (double) i / (double) cells;
    for (size_t i = 1; w->exponential[axis] && i < cells; i++) {
        const double u = (double) i / (double) cells;
        const struct vec2 z = window_at(w, (struct vec2){ u, u });
        const double at = ((axis == 0 ? z.x : z.y) - lo) / size;
        node[n++] = fmin(fmax(at, 0.0), 1.0);
    }
    qsort(node, n, sizeof *node, compare);
    return n;
}

static signed char sign_of(double component)
{
    if (isnan(component))
        return 0;
    return signbit(component) ? -1 : 1;
}

static void sample(struct lattice *l, const struct planar *system,
                   const struct window *w)
{
    for (size_t j = 0; j < l->count[1]; j++)
        for (size_t i = 0; i < l->count[0]; i++) {
            const struct vec2 u = { l->node[0][i], l->node[1][j] };
            const struct vec2 z = window_mix(w->box, u);
            struct planar_field f;
            system->field(system->ctx, vec2_sub(z, system->origin), &f);
            l->sign[0][i + j * l->count[0]] = sign_of(f.direction.x);
            l->sign[1][i + j * l->count[0]] = sign_of(f.direction.y);
        }
}

/* A second call is harmless. */
static void lattice_free(struct lattice *l)
{
    for (int k = 0; k < 2; k++) {
        free(l->node[k]);
        free(l->sign[k]);
    }
    *l = (struct lattice){ .node = { NULL, NULL } };
}

/* Evaluates the field at every node.  STATUS_NO_MEMORY: *l is empty. */
static enum status lattice_init(struct lattice *l, const struct planar *system,
                                const struct window *window, size_t cells)
{
    bool good = true;

    *l = (struct lattice){ .node = { NULL, NULL } };
    for (int axis = 0; axis < 2; axis++) {
        l->node[axis] = malloc(2 * (cells + 1) * sizeof *l->node[axis]);
        good = good && l->node[axis];
        if (good)
            l->count[axis] = place(l->node[axis], cells, window, axis);
    }
    for (int k = 0; good && k < 2; k++) {
        l->sign[k] = malloc(l->count[0] * l->count[1]);
        good = l->sign[k] != NULL;
    }
    if (!good) {
        lattice_free(l);
        return STATUS_NO_MEMORY;
    }
    sample(l, system, window);
    return STATUS_OK;
}

struct collector {
    const struct lattice *l;
    struct zero *zero;
    struct seed *seed;
    size_t count, room;
};

static enum status push(struct collector *c, struct seed s)
{
    const enum status status = ROOM_FOR(c->seed, c->room, c->count + 1);

    if (status == STATUS_OK)
        c->seed[c->count++] = s;
    return status;
}

/* The edge from node (i, j) to the next along `axis`. */
static enum status look(struct collector *c, int axis, size_t i, size_t j)
{
    const struct lattice *l = c->l;
    const size_t i1 = i + (axis == 0), j1 = j + (axis == 1);
    const signed char *sign = l->sign[c->zero->which];
    const struct vec2 a = { l->node[0][i], l->node[1][j] };
    const struct vec2 b = { l->node[0][i1], l->node[1][j1] };
    /* The line that carries the edge: which one, and how many there are. */
    const size_t line = axis == 0 ? j : i, lines = l->count[1 - axis];
    const bool last = line == lines - 1;
    const double inward = last ? -1.0 : 1.0;
    struct seed s = {
        .along = { axis == 0 ? 0.0 : inward, axis == 0 ? inward : 0.0 },
        .on_edge = line == 0 || last,
    };

    if (sign[i + j * l->count[0]] * sign[i1 + j1 * l->count[0]] >= 0 ||
        !zero_between(c->zero, a, b, &s.at))
        return STATUS_OK;
    return push(c, s);
}

/* All edges along one axis on the lines from `first` to `last`. */
static enum status sweep(struct collector *c, int axis, size_t first,
                         size_t last, size_t stride)
{
    const size_t n = c->l->count[axis] - 1;
    enum status s = STATUS_OK;

    for (size_t line = first; line <= last; line += stride)
        for (size_t k = 0; k < n && s == STATUS_OK; k++)
            s = axis == 0 ? look(c, axis, k, line) : look(c, axis, line, k);
    return s;
}

/* One seed for each change of sign of component q->which between neighbours,
 * those on the window's edge first: *seed is owned by the caller.
 * STATUS_NO_MEMORY: *seed is NULL. */
static enum status lattice_seeds(const struct lattice *l, struct zero *q,
                                 struct seed **seed, size_t *count)
{
    struct collector c = { .l = l, .zero = q };
    enum status s = STATUS_OK;

    for (int axis = 0; axis < 2 && s == STATUS_OK; axis++) {
        const size_t last = l->count[1 - axis] - 1;
        s = sweep(&c, axis, 0, last, last);
    }
    for (int axis = 0; axis < 2 && s == STATUS_OK; axis++)
        s = sweep(&c, axis, 1, l->count[1 - axis] - 2, 1);
    if (s != STATUS_OK) {
        free(c.seed);
        c.seed = NULL;
        c.count = 0;
    }
    *seed = c.seed;
    *count = c.count;
    return s;
}

/* Hands the line over to n, which owns it then. */
static enum status keep(struct nullcline *n, struct polyline *line)
{
    if (ROOM_FOR(n->piece, n->room, n->count + 1) != STATUS_OK)
        return STATUS_NO_MEMORY;
    n->piece[n->count++] = *line;
    *line = POLYLINE_EMPTY;
    return STATUS_OK;
}

/* The whole piece through a seed, in u coordinates, and its loose ends. */
static enum status follow(const struct trace *t, const struct seed *from,
                          struct polyline *line, size_t *loose)
{
    enum trace_end end = TRACE_LOOSE;
    struct vec2 tangent;
    enum status s = polyline_push(line, from->at);

    *loose = 0;
    if (s != STATUS_OK ||
        !zero_tangent(t->zero, from->at, from->along, &tangent))
        return s;
    s = trace_run(t, tangent, line, &end);
    *loose += end == TRACE_LOOSE;
    if (s != STATUS_OK || end == TRACE_CLOSED || from->on_edge)
        return s;
    polyline_reverse(line);
    s = trace_run(t, vec2_scale(-1.0, tangent), line, &end);
    *loose += end == TRACE_LOOSE;
    return s;
}

static enum status follow_all(const struct trace *t, struct nullcline *out)
{
    enum status s = STATUS_OK;

    for (size_t i = 0; i < t->seeds && s == STATUS_OK; i++) {
        struct polyline line = POLYLINE_EMPTY;
        size_t loose;
        if (t->seed[i].passed)
            continue;
        t->seed[i].passed = true;
        s = follow(t, &t->seed[i], &line, &loose);
        for (size_t k = 0; k < line.count; k++)
            line.at[k] = window_mix(t->window->box, line.at[k]);
        if (s == STATUS_OK && line.count > 1) {
            out->loose += loose;
            s = keep(out, &line);
        }
        polyline_free(&line);
    }
    return s;
}

static enum status find_one(const struct planar *system,
                            const struct window *window, double chord,
                            const struct lattice *l, int which,
                            struct nullcline *out)
{
    struct zero zero = { system, window->box, which, 0 };
    struct trace t = { .zero = &zero, .window = window, .chord = chord };
    enum status s = lattice_seeds(l, &zero, &t.seed, &t.seeds);

    *out = NULLCLINE_EMPTY;
    if (s == STATUS_OK)
        s = follow_all(&t, out);
    free(t.seed);
    out->evaluations = zero.calls + l->count[0] * l->count[1] / 2;
    return s;
}

enum status nullcline_find(const struct planar *system,
                           const struct window *window, double chord,
                           struct nullcline out[NULLCLINES])
{
    struct nullcline found[NULLCLINES] = { NULLCLINE_EMPTY, NULLCLINE_EMPTY };
    struct lattice l;
    enum status s = window_check(window, system);

    if (s != STATUS_OK || !(chord > 0.0))
        return STATUS_BAD_ARGUMENT;
    s = lattice_init(&l, system, window, TOL_NULLCLINE_CELLS);
    for (int k = 0; k < NULLCLINES && s == STATUS_OK; k++)
        s = find_one(system, window, chord, &l, k, &found[k]);
    for (int k = 0; k < NULLCLINES; k++) {
        if (s == STATUS_OK)
            out[k] = found[k];
        else
            nullcline_free(&found[k]);
    }
    lattice_free(&l);
    return s;
}

void nullcline_free(struct nullcline *n)
{
    for (size_t i = 0; i < n->count; i++)
        polyline_free(&n->piece[i]);
    free(n->piece);
    *n = NULLCLINE_EMPTY;
}
