#include "patchwork.h"

#include <math.h>
#include <stdlib.h>

#include "fate.h"
#include "room.h"
#include "slow_tolerance.h"

/* A rectangle of cells, with states inside it that have been looked at. */
struct piece {
    size_t column, row, columns, rows;
    size_t tests;
    struct patch_sample test[PATCH_TESTS];
};

/* Those of one generation, and the next. */
struct pieces {
    struct piece *at; /* owned */
    size_t count, room;
};

struct patchwork_span patchwork_span_of(const int8_t label[], size_t n,
                                        unsigned fates)
{
    struct patchwork_span s = { 0, n };

    while (s.end > 0 && !(fates >> label[s.end - 1] & 1u))
        s.end--;
    while (s.first < s.end && !(fates >> label[s.first] & 1u))
        s.first++;
    return s;
}

/* What is left of it beside rows and columns of cells without fields; columns =
 * 0: nothing. */
static void trim(const struct patchwork_grid *g, struct piece *p)
{
    const size_t right = p->column + p->columns, above = p->row + p->rows;
    size_t first = right, end = p->column, low = above, high = p->row;

    for (size_t j = p->row; j < above; j++) {
        const struct patchwork_span s = g->span[j];
        const size_t from = s.first > p->column ? s.first : p->column;
        const size_t to = s.end < right ? s.end : right;
        if (from >= to)
            continue;
        first = from < first ? from : first;
        end = to > end ? to : end;
        low = j < low ? j : low;
        high = j + 1;
    }
    p->column = first;
    p->columns = end > first ? end - first : 0;
    p->row = low;
    p->rows = high > low ? high - low : 0;
}

/* One more, uninitialised; NULL: no memory. */
static struct piece *new_piece(struct pieces *p)
{
    return ROOM_FOR(p->at, p->room, p->count + 1) ? NULL : &p->at[p->count++];
}

/* ---- sampling ------------------------------------------------------------ */

/* A piece on its way to become a patch. */
struct trial {
    const struct piece *piece;
    struct patch_side x, y;
    struct patch_sample sample[PATCH_STATES];
    size_t fresh, count; /* to be looked at, and with older ones */
    struct patch patch;
    struct patch_verdict verdict;
};

static struct trial *begin(struct trial *t, const struct patchwork_grid *g,
                           const struct piece *p)
{
    t->piece = p;
    t->x = patch_side_of(g->x + p->column, p->columns);
    t->y = patch_side_of(g->y + p->row, p->rows);
    return t;
}

/* Pieces with few more cells than nodes are found cell by cell. */
static bool is_small(const struct piece *p)
{
    const size_t x = p->columns < PATCH_SIDE ? p->columns : PATCH_SIDE;
    const size_t y = p->rows < PATCH_SIDE ? p->rows : PATCH_SIDE;

    return (double) (p->columns * p->rows) <=
           TOL_PATCH_SMALLEST * (double) (x * y);
}

static bool is_test(const struct trial *t, struct vec2 z)
{
    double basis[PATCH_SIDE];

    return patch_side_basis(&t->x, z.x, basis) &&
           patch_side_basis(&t->y, z.y, basis);
}

/* On the edges, where errors of polynomials are largest. */
static void add_edges(struct trial *t)
{
    const size_t column[] = { 0, t->x.cells / 2, t->x.cells - 1 };
    const size_t row[] = { 0, t->y.cells / 2, t->y.cells - 1 };

    for (size_t k = 0; k < 9; k++)
        if (k != 4)
            t->sample[t->fresh++].z =
                (struct vec2){ t->x.at[column[k % 3]], t->y.at[row[k / 3]] };
}

/* The nodes, edges, cells where older tests are too few, spread by multiples of
 * the golden ratio, and the older tests. */
static void choose_states(struct trial *t)
{
    const struct piece *p = t->piece;
    const size_t cells = t->x.cells * t->y.cells;
    struct vec2 z[PATCH_NODES];
    size_t older = 0;

    t->fresh = patch_nodes(&t->x, &t->y, z);
    for (size_t i = 0; i < t->fresh; i++)
        t->sample[i].z = z[i];
    add_edges(t);
    for (size_t i = 0; i < p->tests; i++)
        older += is_test(t, p->test[i].z);
    for (size_t i = 1; older < TOL_PATCH_LEAST_TESTS; i++, older++) {
        const double share = fmod(0.6180339887498949 * (double) i, 1.0);
        const size_t k = (size_t) (share * (double) cells);
        t->sample[t->fresh++].z =
            (struct vec2){ t->x.at[k % t->x.cells], t->y.at[k / t->x.cells] };
    }
    t->count = t->fresh;
    for (size_t i = 0; i < p->tests && t->count < PATCH_STATES; i++)
        if (is_test(t, p->test[i].z))
            t->sample[t->count++] = p->test[i];
}

/* Looks at the fresh states of all trials at once. */
static enum status look(struct patchwork *w, struct trial trial[], size_t n)
{
    const struct patchwork_source *s = &w->source;
    size_t states = 0, k = 0;

    for (size_t i = 0; i < n; i++)
        states += trial[i].fresh;
    struct patch_sample *all = malloc((states + 1) * sizeof *all);
    if (all == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < trial[i].fresh; j++)
            all[k++] = trial[i].sample[j];
    const enum status status =
        s->sample(s->ctx, all, states, TOL_PATCH_SAMPLES * w->rtol, w->which);
    w->sampled += states;
    k = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < trial[i].fresh; j++)
            trial[i].sample[j] = all[k++];
    free(all);
    return status;
}

static void fit_all(const struct patchwork *w, struct trial trial[], size_t n)
{
#pragma omp parallel for schedule(dynamic)
    for (size_t i = 0; i < n; i++) {
        struct trial *const t = &trial[i];
        t->verdict = patch_fit(&t->patch, &t->x, &t->y, w->which, w->rtol,
                               &w->source.teller, t->sample, t->count);
    }
}

/* ---- cutting ------------------------------------------------------------- */

/* Into how many parts: errors go like the power `nodes` of a part's size. */
static size_t parts_of(const struct patch_side *s, double excess, double other,
                       bool is_smooth)
{
    const double part =
        pow(excess / TOL_SHARE, 1.0 / (double) (PATCH_SIDE - 1));
    size_t parts = 2;

    if (!is_smooth)
        return excess > 0.0 && s->cells > 1 ? 2 : 1;
    if (s->is_exact || !(excess > TOL_SHARE) ||
        excess < TOL_PATCH_ASIDE * other)
        return 1;
    while ((double) parts < TOL_AIM * part && parts < PATCH_SIDE &&
           s->cells > PATCH_SIDE * parts)
        parts *= 2;
    return parts;
}

/* Where no side is to blame, the one with more cells to its nodes. */
static void choose_parts(const struct trial *t, size_t *x, size_t *y)
{
    const struct patch_verdict *v = &t->verdict;

    *x = parts_of(&t->x, v->excess_x, v->excess_y, v->is_smooth);
    *y = parts_of(&t->y, v->excess_y, v->excess_x, v->is_smooth);
    if (*x * *y == 1 && t->x.cells >= t->y.cells)
        *x = 2;
    else if (*x * *y == 1)
        *y = 2;
}

static bool lies_in(const struct piece *p, const struct patchwork_grid *g,
                    struct vec2 z)
{
    return z.x >= g->x[p->column] && z.x <= g->x[p->column + p->columns - 1] &&
           z.y >= g->y[p->row] && z.y <= g->y[p->row + p->rows - 1];
}

static void cut_out(const struct trial *t, const struct patchwork_grid *g,
                    const size_t x[2], const size_t y[2], struct piece *part)
{
    part->column = t->piece->column + x[0];
    part->row = t->piece->row + y[0];
    part->columns = x[1] - x[0];
    part->rows = y[1] - y[0];
    trim(g, part);
    part->tests = 0;
    for (size_t i = 0; i < t->count && part->tests < PATCH_TESTS; i++)
        if (lies_in(part, g, t->sample[i].z))
            part->test[part->tests++] = t->sample[i];
}

static enum status cut(const struct trial *t, const struct patchwork_grid *g,
                       struct pieces *next)
{
    size_t nx, ny;

    choose_parts(t, &nx, &ny);
    for (size_t j = 0; j < ny; j++)
        for (size_t i = 0; i < nx; i++) {
            const size_t x[2] = { patch_side_cut(&t->x, nx, i),
                                  patch_side_cut(&t->x, nx, i + 1) };
            const size_t y[2] = { patch_side_cut(&t->y, ny, j),
                                  patch_side_cut(&t->y, ny, j + 1) };
            struct piece *const part = new_piece(next);
            if (part == NULL)
                return STATUS_NO_MEMORY;
            cut_out(t, g, x, y, part);
            next->count -= part->columns == 0;
        }
    return STATUS_OK;
}

/* ---- planning ------------------------------------------------------------ */

static enum status keep(struct patchwork *w, const struct patch *p)
{
    const enum status status = ROOM_FOR(w->patch, w->room, w->count + 1);

    if (status == STATUS_OK)
        w->patch[w->count++] = *p;
    return status;
}

enum { TOGETHER = 64 };

static enum status try_some(struct patchwork *w, struct trial trial[], size_t n,
                            struct pieces *next)
{
    for (size_t i = 0; i < n; i++)
        choose_states(&trial[i]);
    enum status status = n > 0 ? look(w, trial, n) : STATUS_OK;
    if (status == STATUS_OK)
        fit_all(w, trial, n);
    for (size_t i = 0; i < n && status == STATUS_OK; i++)
        status = trial[i].verdict.holds ? keep(w, &trial[i].patch)
                                        : cut(&trial[i], &w->grid, next);
    return status;
}

/* One generation of pieces, some at a time. */
static enum status try_all(struct patchwork *w, const struct pieces *now,
                           struct trial trial[TOGETHER], struct pieces *next,
                           const struct monitor *monitor)
{
    enum status status = STATUS_OK;
    size_t i = 0;

    while (i < now->count && status == STATUS_OK) {
        size_t n = 0;
        for (; i < now->count && n < TOGETHER; i++)
            if (!is_small(&now->at[i]))
                begin(&trial[n++], &w->grid, &now->at[i]);
        status = try_some(w, trial, n, next);
        if (status == STATUS_OK &&
            monitor_tell(monitor, "patches", w->count, 0))
            status = STATUS_STOPPED;
    }
    return status;
}

static enum status run(struct patchwork *w, struct pieces *now,
                       struct pieces *next, const struct monitor *monitor)
{
    struct trial *trial = malloc(TOGETHER * sizeof *trial);
    struct piece *const all = new_piece(now);
    enum status status = trial && all ? STATUS_OK : STATUS_NO_MEMORY;

    if (all) {
        *all =
            (struct piece){ .columns = w->grid.columns, .rows = w->grid.rows };
        trim(&w->grid, all);
        now->count -= all->columns == 0;
    }
    while (status == STATUS_OK && now->count > 0) {
        next->count = 0;
        status = try_all(w, now, trial, next, monitor);
        const struct pieces swap = *now;
        *now = *next;
        *next = swap;
    }
    free(trial);
    return status;
}

enum status patchwork_plan(struct patchwork *w,
                           const struct patchwork_grid *grid,
                           const struct patchwork_source *source, double rtol,
                           unsigned which, const struct monitor *monitor)
{
    struct pieces now = { .count = 0 }, next = { .count = 0 };

    *w = (struct patchwork){
        .grid = *grid, .source = *source, .rtol = rtol, .which = which
    };
    const enum status status = run(w, &now, &next, monitor);
    free(now.at);
    free(next.at);
    if (status != STATUS_OK)
        patchwork_free(w);
    return status;
}

void patchwork_free(struct patchwork *w)
{
    free(w->patch);
    *w = (struct patchwork){ .count = 0 };
}

/* ---- filling ------------------------------------------------------------- */

/* The part of a patch on these rows. */
static void fill(const struct patchwork *w, const struct patch *p, size_t first,
                 size_t count, const int8_t label[], struct cell out[])
{
    const size_t n = w->grid.columns;
    const size_t column = (size_t) (p->x.at - w->grid.x);
    const size_t row = (size_t) (p->y.at - w->grid.y);
    const size_t from = row > first ? row : first;
    const size_t last = row + p->y.cells, end = first + count;

    const size_t to = last < end ? last : end;
    const size_t at = (from - first) * n + column;
    if (from < to)
        patch_rows(p, from - row, to - from, n, label + at, w->rtol,
                   &w->source.teller, out + at);
}

/* Cells of fates that have no field. */
static void leave_bare(unsigned fates, const int8_t label[], size_t cells,
                       struct cell out[])
{
    for (size_t i = 0; i < cells; i++)
        if (!(fates >> label[i] & 1u)) {
            out[i] = cell_unknown;
            out[i].exit_reason = label[i];
        }
}

/* Cells that no patch told, one by one. */
static enum status find_left(const struct patchwork *w, size_t first,
                             size_t cells, struct cell out[], size_t *sampled)
{
    const struct patchwork_source *s = &w->source;
    const size_t columns = w->grid.columns;
    size_t left = 0, k = 0;

    for (size_t i = 0; i < cells; i++)
        left += out[i].exit_reason == FATE_NONE;
    struct vec2 *z = malloc((left + 1) * sizeof *z);
    struct cell *cell = malloc((left + 1) * sizeof *cell);
    enum status status = z && cell ? STATUS_OK : STATUS_NO_MEMORY;
    for (size_t i = 0; i < cells && status == STATUS_OK; i++)
        if (out[i].exit_reason == FATE_NONE)
            z[k++] = (struct vec2){ w->grid.x[i % columns],
                                    w->grid.y[first + i / columns] };
    if (status == STATUS_OK)
        status = s->find(s->ctx, z, left, w->rtol, w->which, cell);
    k = 0;
    for (size_t i = 0; i < cells && status == STATUS_OK; i++)
        if (out[i].exit_reason == FATE_NONE)
            out[i] = cell[k++];
    if (sampled)
        *sampled += left;
    free(z);
    free(cell);
    return status;
}

enum status patchwork_rows(const struct patchwork *w, size_t first,
                           size_t count, const int8_t label[],
                           struct cell out[], size_t *sampled)
{
    const size_t cells = count * w->grid.columns;

    for (size_t i = 0; i < cells; i++)
        out[i].exit_reason = FATE_NONE;
#pragma omp parallel for schedule(dynamic)
    for (size_t i = 0; i < w->count; i++)
        fill(w, &w->patch[i], first, count, label, out);
    leave_bare(w->source.fates, label, cells, out);
    return find_left(w, first, cells, out, sampled);
}
