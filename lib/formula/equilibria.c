#include "equilibria.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "equilibrium_search.h"
#include "formula_tolerance.h"
#include "room.h"

/* ---- what is undecided --------------------------------------------------- */

static struct system_window window_of(const struct search_box *b)
{
    return (struct system_window){ { b->side[0].lo, b->side[1].lo },
                                   { b->side[0].hi, b->side[1].hi } };
}

static void swell(struct system_window *w, const struct system_window *by)
{
    for (int k = 0; k < 2; k++) {
        w->lo[k] = fmin(w->lo[k], by->lo[k]);
        w->hi[k] = fmax(w->hi[k], by->hi[k]);
    }
}

static bool touch(const struct system_window *a, const struct system_window *b)
{
    for (int k = 0; k < 2; k++) {
        const double room = 0.1 * (a->hi[k] - a->lo[k] + b->hi[k] - b->lo[k]);
        if (a->lo[k] > b->hi[k] + room || b->lo[k] > a->hi[k] + room)
            return false;
    }
    return true;
}

/* Boxes that come from the same part of the window follow each other: runs of
 * them become one until there is room, then those that touch, if what they
 * make is small: a spot, no curve. */
static void merge(struct equilibrium_search *s)
{
    struct system_equilibria *out = s->out;
    const size_t runs = 4 * SYSTEM_UNDECIDED, n = s->left.count;
    struct system_window run[4 * SYSTEM_UNDECIDED];
    size_t count = n < runs ? n : runs;

    for (size_t i = 0; i < count; i++) {
        const size_t from = i * n / count, to = (i + 1) * n / count;
        run[i] = window_of(&s->left.at[from]);
        for (size_t j = from + 1; j < to; j++) {
            const struct system_window w = window_of(&s->left.at[j]);
            swell(&run[i], &w);
        }
    }
    for (size_t i = 0; i < count; i++)
        for (size_t j = i + 1; j < count; j++) {
            struct system_window both = run[i];
            swell(&both, &run[j]);
            bool small = touch(&run[i], &run[j]);
            for (int k = 0; k < 2; k++)
                small = small && both.hi[k] - both.lo[k] <
                                     1e-4 * (s->window.hi[k] - s->window.lo[k]);
            if (!small)
                continue;
            run[i] = both;
            run[j] = run[--count];
            j = i; /* once more from the next one */
        }
    const size_t most = count < SYSTEM_UNDECIDED ? count : SYSTEM_UNDECIDED;
    for (size_t i = 0; i < most; i++) {
        out->undecided[i] = run[i * count / most];
        for (size_t j = i * count / most; j < (i + 1) * count / most; j++)
            swell(&out->undecided[i], &run[j]);
    }
    out->undecided_count = (int) most;
    out->complete = most == 0;
}

/* ---- search -------------------------------------------------------------- */

static int by_place(const void *a, const void *b)
{
    const struct system_equilibrium *p = a, *q = b;

    for (int k = 0; k < 2; k++)
        if (p->chart[k].value < q->chart[k].value ||
            p->chart[k].value > q->chart[k].value)
            return p->chart[k].value < q->chart[k].value ? -1 : 1;
    return 0;
}

static enum status open_window(struct equilibrium_search *s,
                               const struct formula_system *f,
                               const struct system_window *window,
                               struct fault *why)
{
    s->window = *window;
    for (int k = 0; k < 2; k++) {
        s->turn[k] = f->state[k].period;
        s->period[k] = (double) f->state[k].period;
        if (s->period[k] > 0)
            s->window.hi[k] = nextafter(window->lo[k] + s->period[k], HUGE_VAL);
        s->is_log[k] = f->graph.node[f->state[k].node].positive;
        s->least[k] = TOL_BOX_LEAST * (s->window.hi[k] - s->window.lo[k]);
        if (!(s->window.lo[k] < s->window.hi[k]) ||
            !(fabs(s->least[k]) < 1e300))
            return snprintf(why->text, sizeof why->text,
                            "the window of %s, expected lo < hi",
                            f->graph.node[f->state[k].node].name),
                   STATUS_BAD_ARGUMENT;
    }
    return STATUS_OK;
}

static enum status search(struct equilibrium_search *s,
                          const struct formula_system *f,
                          const struct system_window *window, struct fault *why)
{
    const int state[] = { f->state[0].node, f->state[1].node };
    formula_real value[FORMULA_NODES] = { 0 };
    enum status status = open_window(s, f, window, why);

    if (status != STATUS_OK)
        return status;
    for (int i = 0; i < f->parameters; i++)
        value[f->parameter[i].node] = f->parameter[i].value;
    if (!equations_make(&s->e, &f->graph, state, f->rate, value))
        return fault_set(why, STATUS_BAD_ARGUMENT,
                         "the equations have more than %d parts",
                         FORMULA_NODES);
    status = interval_plan(&s->equation, &s->e.graph, s->e.variable,
                           s->e.equation, 2, s->e.value, why);
    if (status == STATUS_OK)
        status = interval_plan(&s->rate, &s->e.graph, s->e.variable, s->e.rate,
                               2, s->e.value, why);
    if (status == STATUS_OK)
        status = ROOM_FOR(s->boxes.at, s->boxes.room, 1);
    if (status != STATUS_OK)
        return status;
    for (int k = 0; k < 2; k++)
        s->boxes.at[0].side[k] =
            (struct interval_double){ s->window.lo[k], s->window.hi[k] };
    s->boxes.count = 1;
    return search_boxes(s);
}

enum status system_equilibria_find(const struct formula_system *f,
                                   const struct system_window *window,
                                   struct system_equilibria *out,
                                   struct fault *why)
{
    struct equilibrium_search *s = calloc(1, sizeof *s);

    why->text[0] = '\0';
    if (s == NULL)
        return STATUS_NO_MEMORY;
    out->count = out->undecided_count = 0;
    out->boxes = 0;
    s->out = out;
    const enum status status = search(s, f, window, why);
    if (status == STATUS_OK) {
        merge(s);
        qsort(out->equilibrium, (size_t) out->count, sizeof *out->equilibrium,
              by_place);
    }
    free(s->boxes.at);
    free(s->left.at);
    free(s);
    return status;
}
