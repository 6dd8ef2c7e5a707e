#include "patchwork.h"

#include <stdlib.h>

#include "fate.h"
#include "patch.h"
#include "study_tolerance.h"

/* Squares no larger are found cell by cell: they need no fewer states. */
enum { SMALLEST = 8 };

struct square {
    size_t column, row, columns, rows; /* of cells */
};

/* Squares of one size, and cells that were given up on. */
struct work {
    const struct patchwork_grid *g;
    const struct patchwork_source *source;
    double rtol;
    unsigned which;
    struct cell *out;
    struct square *now, *next; /* owned */
    size_t count, next_count, room;
    size_t *left; /* owned: cells, row * columns + column */
    size_t left_count, left_room, sampled;
};

static struct vec2 centre(const struct patchwork_grid *g, size_t row,
                          size_t column)
{
    return (struct vec2){ g->x[column], g->y[row] };
}

static struct box box_of(const struct patchwork_grid *g, const struct square *q)
{
    return (struct box){
        centre(g, q->row, q->column),
        centre(g, q->row + q->rows - 1, q->column + q->columns - 1),
    };
}

static bool has_one_fate(const struct patchwork_grid *g, const struct square *q)
{
    const int8_t first = g->label[q->row * g->columns + q->column];

    for (size_t j = q->row; j < q->row + q->rows; j++)
        for (size_t i = q->column; i < q->column + q->columns; i++)
            if (g->label[j * g->columns + i] != first)
                return false;
    return first != FATE_UNDECIDED;
}

/* Some of its cells, spread by multiples of the golden ratio. */
static void test_cells(const struct patchwork_grid *g, const struct square *q,
                       struct vec2 z[PATCH_TESTS])
{
    const size_t cells = q->columns * q->rows;

    for (size_t i = 0; i < PATCH_TESTS; i++) {
        const double share = 0.6180339887498949 * (double) (i + 1);
        const size_t k =
            (size_t) ((share - (double) (size_t) share) * (double) cells);
        z[i] = centre(g, q->row + k / q->columns, q->column + k % q->columns);
    }
}

static enum status make_room(void **p, size_t size, size_t need, size_t *room)
{
    if (need <= *room)
        return STATUS_OK;
    const size_t more = need + need / 2;
    void *const wider = realloc(*p, more * size);
    if (wider == NULL)
        return STATUS_NO_MEMORY;
    *p = wider;
    *room = more;
    return STATUS_OK;
}

/* Its cells are left to be found one by one. */
static enum status leave(struct work *w, const struct square *q)
{
    void *p = w->left;
    const enum status status =
        make_room(&p, sizeof *w->left, w->left_count + q->columns * q->rows,
                  &w->left_room);

    w->left = p;
    if (status != STATUS_OK)
        return status;
    for (size_t j = q->row; j < q->row + q->rows; j++)
        for (size_t i = q->column; i < q->column + q->columns; i++)
            w->left[w->left_count++] = j * w->g->columns + i;
    return STATUS_OK;
}

/* Its quarters, to be looked at next. */
static enum status quarter(struct work *w, const struct square *q)
{
    const size_t half_c = q->columns / 2, half_r = q->rows / 2;
    enum status status = STATUS_OK;

    if (q->columns <= 2 * SMALLEST || q->rows <= 2 * SMALLEST)
        return leave(w, q);
    for (int k = 0; k < 4 && status == STATUS_OK; k++) {
        const bool right = k & 1, up = k & 2;
        const struct square part = { q->column + (right ? half_c : 0),
                                     q->row + (up ? half_r : 0),
                                     right ? q->columns - half_c : half_c,
                                     up ? q->rows - half_r : half_r };
        w->next[w->next_count++] = part;
    }
    return status;
}

static void fill(struct work *w, const struct square *q, const struct patch *p)
{
    const struct patchwork_grid *g = w->g;

    for (size_t j = q->row; j < q->row + q->rows; j++)
        patch_row(p, g->x + q->column, q->columns, g->y[j],
                  w->out + j * g->columns + q->column);
}

/* Squares first .. first + count - 1: sampled, and filled where a polynomial
 * holds; done[] says where. */
static enum status try_squares(struct work *w, const struct square q[],
                               size_t count, bool done[])
{
    struct vec2 *z = malloc(count * PATCH_STATES * sizeof *z);
    struct cell *cell = malloc(count * PATCH_STATES * sizeof *cell);
    enum status status = z && cell ? STATUS_OK : STATUS_NO_MEMORY;

    for (size_t i = 0; i < count && status == STATUS_OK; i++) {
        const struct box box = box_of(w->g, &q[i]);
        patch_nodes(&box, z + i * PATCH_STATES);
        test_cells(w->g, &q[i], z + i * PATCH_STATES + PATCH_NODES);
    }
    if (status == STATUS_OK)
        status = w->source->find(w->source->ctx, z, count * PATCH_STATES,
                                 TOL_PATCH_SAMPLES * w->rtol, w->which, cell);
    if (status == STATUS_OK) {
        w->sampled += count * PATCH_STATES;
#pragma omp parallel for schedule(dynamic)
        for (size_t i = 0; i < count; i++) {
            const struct box box = box_of(w->g, &q[i]);
            struct patch p;
            done[i] = patch_fit(&p, &box, w->which, w->rtol,
                                z + i * PATCH_STATES + PATCH_NODES,
                                cell + i * PATCH_STATES) &&
                      p.exit_reason ==
                          w->g->label[q[i].row * w->g->columns + q[i].column];
            if (done[i])
                fill(w, &q[i], &p);
        }
    }
    free(z);
    free(cell);
    return status;
}

/* Of the squares of one size, those of one fate are tried, some at a time; the
 * others are quartered at once. */
static enum status level(struct work *w)
{
    enum { BATCH = 64 };
    enum status status = STATUS_OK;
    size_t i = 0;

    w->next_count = 0;
    while (i < w->count && status == STATUS_OK) {
        struct square some[BATCH];
        bool done[BATCH];
        size_t n = 0;
        for (; i < w->count && n < BATCH && status == STATUS_OK; i++) {
            const struct square *q = &w->now[i];
            if (q->columns <= SMALLEST || q->rows <= SMALLEST)
                status = leave(w, q);
            else if (has_one_fate(w->g, q))
                some[n++] = *q;
            else
                status = quarter(w, q);
        }
        if (n > 0 && status == STATUS_OK)
            status = try_squares(w, some, n, done);
        for (size_t k = 0; k < n && status == STATUS_OK; k++)
            if (!done[k])
                status = quarter(w, &some[k]);
    }
    return status;
}

static enum status find_left(struct work *w)
{
    struct vec2 *z = malloc((w->left_count + 1) * sizeof *z);
    struct cell *cell = malloc((w->left_count + 1) * sizeof *cell);
    enum status status = z && cell ? STATUS_OK : STATUS_NO_MEMORY;

    for (size_t i = 0; i < w->left_count && status == STATUS_OK; i++)
        z[i] = centre(w->g, w->left[i] / w->g->columns,
                      w->left[i] % w->g->columns);
    if (status == STATUS_OK)
        status = w->source->find(w->source->ctx, z, w->left_count, w->rtol,
                                 w->which, cell);
    for (size_t i = 0; i < w->left_count && status == STATUS_OK; i++)
        w->out[w->left[i]] = cell[i];
    w->sampled += w->left_count;
    free(z);
    free(cell);
    return status;
}

/* Rows from the first on, columns in equal parts. */
static void cut_into_tiles(struct work *w)
{
    const size_t tile = PATCHWORK_TILE, columns = w->g->columns;
    const size_t across = (columns + tile - 1) / tile;

    for (size_t j = 0; j < w->g->rows; j += tile)
        for (size_t i = 0; i < across; i++) {
            const size_t from = i * columns / across;
            const size_t to = (i + 1) * columns / across;
            const size_t left = w->g->rows - j;
            w->now[w->count++] = (struct square){ from, j, to - from,
                                                  left < tile ? left : tile };
        }
}

enum status patchwork_fill(const struct patchwork_grid *g,
                           const struct patchwork_source *source, double rtol,
                           unsigned which, struct cell out[], size_t *sampled)
{
    struct work w = {
        .g = g, .source = source, .rtol = rtol, .which = which, .out = out
    };
    /* quarters of squares of more than 2 SMALLEST cells a side */
    w.room = (g->columns / SMALLEST + 2) * (g->rows / SMALLEST + 2);
    w.now = malloc(w.room * sizeof *w.now);
    w.next = malloc(w.room * sizeof *w.next);
    enum status status = w.now && w.next ? STATUS_OK : STATUS_NO_MEMORY;

    if (status == STATUS_OK)
        cut_into_tiles(&w);
    while (status == STATUS_OK && w.count > 0) {
        status = level(&w);
        struct square *const swap = w.now;
        w.now = w.next;
        w.count = w.next_count;
        w.next = swap;
    }
    if (status == STATUS_OK)
        status = find_left(&w);
    if (sampled)
        *sampled = w.sampled;
    free(w.now);
    free(w.next);
    free(w.left);
    return status;
}
