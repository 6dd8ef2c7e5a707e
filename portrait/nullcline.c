#include "nullcline.h"

#include <stdlib.h>

#include "lattice.h"
#include "room.h"
#include "tolerance.h"

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
