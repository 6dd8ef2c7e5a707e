/* Points are computed in any order and by any thread, but each by itself, and
 * what depends on the order of arrival - the numbering of reasons - is put
 * right at the end: the same scene gives the same sweep. */
#include "sweep.h"

#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sweep_finish.h"
#include "sweep_left.h"
#include "sweep_refine.h"
#include "tolerance.h"

struct run {
    struct sweep *s;
    unsigned products;      /* of the study at a point */
    bool takes_long;        /* a point: worth listening within it */
    struct sweep_rows left; /* of an earlier run, sorted */
    const struct monitor *monitor;
    struct fault *why;
    const char *reason; /* static; the last that was met, often the next */
    int8_t reason_code;
    const struct sweep_share *share; /* borrowed; NULL: all are ours */
    size_t done;                     /* rows that are computed */
    enum status failed; /* the first failure; others follow it out */
};

/* What a thread computes in; a point is too large for its stack. */
struct worker {
    struct run *run; /* borrowed */
    char *block;     /* of a row's layers; NULL: there are none */
    struct sweep_point point[STUDY_JOBS];
};

/* ---- one point ----------------------------------------------------------- */

static void set_entry(const struct sweep *s, size_t i,
                      const struct sweep_column *c, size_t n,
                      const struct sweep_point *p)
{
    double *real = sweep_rows_real(&s->rows, i, c->first + n);
    int8_t *code = sweep_rows_code(&s->rows, i, c->first + n);
    struct quantity q = quantity_none(NULL);

    if (c->codes)
        *code = sweep_column_code(c, p, n);
    else
        q = sweep_column_quantity(c, p, n);
    real[0] = q.value;
    real[1] = q.error;
    if (s->columns.conditioning)
        real[2] = q.conditioning;
    if (!c->codes)
        *code = quantity_exists(&q) ? REASON_PRESENT : REASON_ABSENT;
}

/* All but why numbers are missing. */
static void set_row(const struct sweep *s, size_t i,
                    const struct sweep_point *p)
{
    for (size_t k = 0; k < s->columns.count; k++)
        for (size_t n = 0; n < s->columns.at[k].entries; n++)
            set_entry(s, i, &s->columns.at[k], n, p);
}

/* The code of a reason; a new one goes into the side file, too. */
static enum status code_of(struct run *r, const char *reason, int8_t *code)
{
    const size_t known = r->s->reasons.count;
    enum status status = STATUS_OK;

    if (reason != r->reason)
        status = sweep_reasons_code(&r->s->reasons, reason, &r->reason_code);
    r->reason = status == STATUS_OK ? reason : NULL;
    *code = r->reason_code;
    if (status != STATUS_OK || r->s->reasons.count == known)
        return status;
    return sweep_journal_reason(&r->s->journal, reason, r->why);
}

static enum status set_reasons(struct run *r, size_t i,
                               const struct sweep_column *c,
                               const struct sweep_point *p)
{
    int8_t *code = sweep_rows_code(&r->s->rows, i, c->first);
    enum status status = STATUS_OK;

    for (size_t n = 0; n < c->entries && status == STATUS_OK; n++)
        if (code[n] == REASON_ABSENT)
            status =
                code_of(r, sweep_column_quantity(c, p, n).reason, &code[n]);
    return status;
}

/* The reasons of a row, of which one thread at a time can add new ones; then it
 * is whole. */
static enum status end_row(struct run *r, size_t i, const struct sweep_point *p,
                           const char *block)
{
    struct sweep *s = r->s;
    enum status status = STATUS_OK;

    for (size_t k = 0; k < s->columns.count && status == STATUS_OK; k++)
        if (!s->columns.at[k].codes)
            status = set_reasons(r, i, &s->columns.at[k], p);
    return status ? status
                  : sweep_journal_row(&s->journal, &s->rows, i, block, r->why);
}

/* Notes a failure, or asks whether there was one. */
static enum status failure(struct run *r, enum status status)
{
#pragma omp critical(sweep)
    {
        if (r->failed == STATUS_OK)
            r->failed = status;
        status = r->failed;
    }
    return status;
}

/* Tells of one more row. */
static enum status tell(struct run *r)
{
    enum status status = STATUS_OK;

#pragma omp critical(sweep)
    if (monitor_tell(r->monitor, "points", ++r->done, r->s->rows.count))
        status = STATUS_STOPPED;
    return status;
}

/* Within a point that takes long nobody tells, but all listen. */
static int listen(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    struct run *r = ctx;
    int stop;

    (void) stage, (void) done, (void) total;
#pragma omp critical(sweep)
    stop = r->failed != STATUS_OK ||
           monitor_tell(r->monitor, "points", r->done, r->s->rows.count);
    return stop;
}

/* What is known of a point, into its row and the side file. */
static enum status keep(struct run *r, size_t i, const struct sweep_point *p,
                        char *block)
{
    const struct monitor monitor = { listen, r };
    enum status status = STATUS_OK;

    if (block)
        status = sweep_layers_fill(&r->s->layers, p, &monitor, block);
    if (status != STATUS_OK)
        return status;
    set_row(r->s, i, p);
#pragma omp critical(sweep)
    status = end_row(r, i, p, block);
    return status;
}

/* Rows i[0] .. i[n - 1] side by side. What one of them ends with does not lose
 * the others. */
static enum status compute(struct worker *w, const size_t i[], size_t n)
{
    struct run *r = w->run;
    const struct monitor monitor = { listen, r };
    enum status ran[STUDY_JOBS], status = STATUS_OK;
    const double *x[STUDY_JOBS];

    for (size_t k = 0; k < n; k++)
        x[k] = sweep_rows_x(&r->s->rows, i[k]);
    sweep_points_at(w->point, r->s->scene, x, n, r->products,
                    r->takes_long ? &monitor : NULL, ran);
    for (size_t k = 0; k < n; k++) {
        enum status ends = ran[k];
        if (ends == STATUS_OK) {
            ends = keep(r, i[k], &w->point[k], w->block);
            sweep_point_free(&w->point[k]);
        }
        if (ends == STATUS_OK)
            ends = tell(r);
        if (status == STATUS_OK)
            status = ends;
    }
    return status;
}

/* Takes a row that an earlier run left, if it did. */
static bool take(struct run *r, size_t i)
{
    struct sweep_rows *rows = &r->s->rows;
    const size_t k = sweep_rows_find(&r->left, sweep_rows_x(rows, i));

    if (k == r->left.count)
        return false;
    memcpy(sweep_rows_row(rows, i), sweep_rows_row(&r->left, k),
           rows->width * sizeof *rows->at);
    r->s->taken++;
    r->done++;
    return true;
}

/* ---- many points --------------------------------------------------------- */

/* The next of `count` rows, *at first; any thread. */
static size_t next(const struct run *r, size_t count, size_t *at)
{
    size_t k;

#pragma omp critical(sweep)
    k = r->share ? r->share->next(r->share->ctx, count) : (*at)++;
    return k;
}

/* Rows that a thread takes at once: one where each takes long, and few where
 * threads would wait for each other. */
static size_t rows_at_once(const struct run *r, size_t count)
{
    const size_t fair = count / (4 * (size_t) omp_get_num_threads()) + 1;

    if (r->takes_long)
        return 1;
    return fair < STUDY_JOBS ? fair : STUDY_JOBS;
}

/* The next of those that are not there; false: no more. */
static bool compute_some(struct worker *w, size_t first, size_t count,
                         size_t *at, const bool there[])
{
    struct run *r = w->run;
    const size_t most = rows_at_once(r, count);
    size_t row[STUDY_JOBS], n = 0, k = 0;

    while (n < most && (k = next(r, count, at)) < count)
        if (!there[k])
            row[n++] = first + k;
    if (n > 0)
        (void) failure(r, compute(w, row, n));
    return k < count && failure(r, STATUS_OK) == STATUS_OK;
}

/* One thread's share of them. */
static void work(struct run *r, size_t first, size_t count, size_t *at,
                 const bool there[])
{
    const size_t size = r->s->layers.size;
    struct worker *w = malloc(sizeof *w);
    char *block = size ? malloc(size) : NULL;

    if (w == NULL || (size && block == NULL)) {
        (void) failure(r, STATUS_NO_MEMORY);
    } else {
        w->run = r;
        w->block = block;
        while (compute_some(w, first, count, at, there))
            ;
    }
    free(block);
    free(w);
}

/* Every row from `first` on, whose x is set; of a share, its rows. */
static enum status compute_from(struct run *r, size_t first)
{
    const size_t count = r->s->rows.count - first;
    bool *there = malloc(count * sizeof *there + 1);
    size_t at = 0, known = 0;

    if (there == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < count; i++)
        known += there[i] = take(r, first + i);
    if (known < count) {
#pragma omp parallel
        work(r, first, count, &at, there);
    }
    free(there);
    r->s->missing = r->s->rows.count - r->done;
    return r->failed;
}

static enum status compute_grid(struct run *r)
{
    const struct scene_axis *a = r->s->scene->sweep.axis;
    const size_t rows = a[0].count, columns = r->s->axes > 1 ? a[1].count : 1;
    enum status status = sweep_rows_add(&r->s->rows, rows * columns);

    for (size_t i = 0; status == STATUS_OK && i < rows * columns; i++) {
        double *x = sweep_rows_x(&r->s->rows, i);
        x[0] = a[0].value[i / columns];
        x[1] = r->s->axes > 1 ? a[1].value[i % columns] : 0.0;
    }
    return status ? status : compute_from(r, 0);
}

static enum status compute_middles(struct run *r, const struct sweep_refine *f)
{
    const size_t first = r->s->rows.count;
    enum status status = sweep_rows_add(&r->s->rows, f->spans);

    for (size_t k = 0; status == STATUS_OK && k < f->spans; k++)
        sweep_rows_x(&r->s->rows, first + k)[0] = sweep_refine_middle(f, k);
    if (status == STATUS_OK)
        status = compute_from(r, first);
    if (status == STATUS_OK && r->s->missing == 0)
        sweep_rows_sort(&r->s->rows);
    return status;
}

/* The entry of a column of one; -1 if there is none. */
static int entry_of(const struct sweep *s, const char *name)
{
    const int column = sweep_find(s, name);

    return column < 0 ? -1 : (int) s->columns.at[column].first;
}

static enum status refine(struct run *r)
{
    struct sweep *s = r->s;
    struct sweep_refine f = {
        .curve = { entry_of(s, "ln_v_plus"), entry_of(s, "ln_v_minus") },
        .tol = s->scene->sweep.refine,
        .is_log = s->scene->sweep.axis[0].scale == SWEEP_LOG,
    };
    enum status status = sweep_refine_init(&f, &s->rows);

    while (status == STATUS_OK && f.spans > 0 && f.depth < REFINE_DEPTH &&
           s->rows.count + f.spans <= SCENE_POINTS) {
        status = compute_middles(r, &f);
        if (s->missing > 0)
            break;
        if (status == STATUS_OK)
            status = sweep_refine_next(&f, &s->rows);
    }
    s->unrefined = f.spans > 0;
    sweep_refine_free(&f);
    return status;
}

/* ---- the whole ----------------------------------------------------------- */

/* Runs and maps are not done in microseconds. */
static bool takes_long(const struct run *r)
{
    const unsigned runs = 1u << PRODUCT_TRAJECTORIES;

    if (r->s->scene->system)
        return true;
    return plan_has(plan_stages(r->products), STAGE_BASINS) ||
           r->s->scene->products & runs;
}

static enum status begin(struct run *r, const struct sweep_options *o)
{
    struct sweep *s = r->s;
    enum status status = sweep_dims_init(&s->dims, s->scene);

    if (status == STATUS_OK)
        status = sweep_columns_init(&s->columns, s->scene, &s->dims);
    if (status == STATUS_OK && o->journal)
        status = sweep_layers_init(&s->layers, s->scene, &s->dims);
    if (status == STATUS_OK)
        status = sweep_reasons_init(&s->reasons);
    s->rows = r->left =
        sweep_rows_of(s->columns.entries, s->columns.conditioning);
    r->products = sweep_point_products(s->scene, s->layers.count > 0);
    r->takes_long = takes_long(r);
    return status ? status : sweep_left_open(s, o, &r->left, r->why);
}

enum status sweep_run(struct sweep *s, const struct scene *scene,
                      const struct sweep_options *options,
                      const struct monitor *monitor, struct fault *why)
{
    struct run r = {
        .s = s, .monitor = monitor, .why = why, .share = options->share
    };

    *s = (struct sweep){ .scene = scene,
                         .axes = scene->sweep.axes,
                         .journal = { .file = -1 } };
    why->text[0] = '\0';
    enum status status = begin(&r, options);
    if (status == STATUS_OK)
        status = compute_grid(&r);
    if (status == STATUS_OK && s->missing == 0 && scene->sweep.refine > 0.0)
        status = refine(&r);
    if (status == STATUS_OK && s->missing == 0)
        status = sweep_finish(s);
    if (s->layers.count == 0)
        sweep_journal_close(&s->journal);
    sweep_rows_free(&r.left);
    if (status == STATUS_OK)
        return STATUS_OK;
    if (why->text[0] == '\0')
        snprintf(why->text, sizeof why->text, "%s", status_text(status));
    sweep_free(s);
    return status;
}

void sweep_free(struct sweep *s)
{
    for (size_t k = 0; k < SCENE_AXES; k++)
        free(s->axis[k].value);
    sweep_dims_free(&s->dims);
    sweep_columns_free(&s->columns);
    sweep_reasons_free(&s->reasons);
    sweep_rows_free(&s->rows);
    sweep_layers_free(&s->layers);
    sweep_journal_close(&s->journal);
    *s = (struct sweep){ .scene = NULL };
}

void sweep_forget(const char *journal)
{
    (void) unlink(journal);
}

/* ---- reading ------------------------------------------------------------- */

int sweep_find(const struct sweep *s, const char *name)
{
    for (size_t k = 0; k < s->columns.count; k++)
        if (strcmp(s->columns.at[k].name, name) == 0)
            return (int) k;
    return -1;
}

struct quantity sweep_entry(const struct sweep *s, int column, size_t point,
                            size_t entry)
{
    const size_t k = s->columns.at[column].first + entry;
    const double *real = sweep_rows_real(&s->rows, point, k);
    const int8_t code = *sweep_rows_code(&s->rows, point, k);

    if (code != REASON_PRESENT)
        return quantity_none(s->reasons.text[code]);
    struct quantity q = quantity_of(real[0], real[1]);
    if (s->columns.conditioning)
        q.conditioning = real[2];
    return q;
}

int sweep_entry_code(const struct sweep *s, int column, size_t point,
                     size_t entry)
{
    return *sweep_rows_code(&s->rows, point,
                            s->columns.at[column].first + entry);
}

struct quantity sweep_quantity(const struct sweep *s, int column, size_t point)
{
    return sweep_entry(s, column, point, 0);
}

int sweep_code(const struct sweep *s, int column, size_t point)
{
    return sweep_entry_code(s, column, point, 0);
}

enum status sweep_read(const struct sweep *s, size_t k, size_t point, void *out,
                       struct fault *why)
{
    const struct sweep_layer *layer = &s->layers.at[k];

    return sweep_journal_read(&s->journal, &s->rows, point, layer->offset, out,
                              sweep_layer_size(layer), why);
}
