/* Points are computed in any order and by any thread, but each by itself, and
 * what depends on the order of arrival - the numbering of reasons - is put
 * right at the end: the same scene gives the same sweep. */
#include "sweep.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "scene_sweep.h"
#include "study_tolerance.h"
#include "sweep_journal.h"
#include "sweep_refine.h"
#include "tolerance.h"

struct run {
    struct sweep *s;
    struct sweep_rows left; /* of an earlier run, sorted */
    struct sweep_journal journal;
    const struct monitor *monitor;
    struct fault *why;
    size_t done;        /* rows that are computed */
    enum status failed; /* the first failure; others follow it out */
};

/* ---- one point ------------------------------------------------------------
 */

static void set_row(const struct sweep *s, size_t i, const struct study *study)
{
    for (size_t k = 0; k < s->columns.count; k++) {
        const struct sweep_column *c = &s->columns.at[k];
        double *real = sweep_rows_real(&s->rows, i, k);
        struct quantity q = quantity_none(NULL);
        if (c->codes == NULL)
            q = sweep_column_quantity(c, study);
        real[0] = q.value;
        real[1] = q.error;
        if (s->columns.conditioning)
            real[2] = q.conditioning;
    }
}

/* The code of a reason; a new one goes into the side file, too. */
static enum status code_of(struct run *r, const char *reason, int8_t *code)
{
    const size_t known = r->s->reasons.count;
    const enum status status = sweep_reasons_code(&r->s->reasons, reason, code);

    if (status != STATUS_OK || r->s->reasons.count == known)
        return status;
    return sweep_journal_reason(&r->journal, reason, r->why);
}

/* The codes of a row, of which one thread at a time can add new ones. */
static enum status set_codes(struct run *r, size_t i, const struct study *study)
{
    const struct sweep *s = r->s;
    enum status status = STATUS_OK;

    for (size_t k = 0; k < s->columns.count && status == STATUS_OK; k++) {
        const struct sweep_column *c = &s->columns.at[k];
        int8_t *code = sweep_rows_code(&s->rows, i, k);
        if (c->codes != NULL) {
            *code = sweep_column_code(c, study);
            continue;
        }
        const struct quantity q = sweep_column_quantity(c, study);
        *code = REASON_PRESENT;
        if (!quantity_exists(&q))
            status = code_of(r, q.reason, code);
    }
    return status ? status
                  : sweep_journal_row(&r->journal, &s->rows, i, r->why);
}

/* The study of a point that failed: nothing, and why. */
static void make_empty(struct study *study, const struct sweep_columns *columns,
                       const char *reason)
{
    const struct quantity none = quantity_none(reason);
    const int8_t no_code = -1;

    for (size_t k = 0; k < columns->count; k++) {
        char *member = (char *) study + columns->at[k].offset;
        if (columns->at[k].codes)
            memcpy(member, &no_code, sizeof no_code);
        else
            memcpy(member, &none, sizeof none);
    }
}

/* Only STATUS_NO_MEMORY is an error. */
static enum status study_point(const struct run *r, size_t i,
                               struct study *study, struct scene *point)
{
    struct fault why;

    scene_at(r->s->scene, sweep_rows_x(&r->s->rows, i), point);
    const enum status status = study_run(study, point, NULL, &why);
    if (status == STATUS_NO_MEMORY)
        return status;
    sweep_columns_complete(study);
    if (status != STATUS_OK)
        make_empty(study, &r->s->columns, status_text(status));
    return STATUS_OK;
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

static enum status compute(struct run *r, size_t i)
{
    struct study study;
    struct scene point;
    enum status status = study_point(r, i, &study, &point);

    if (status != STATUS_OK)
        return status;
    set_row(r->s, i, &study);
#pragma omp critical(sweep)
    status = set_codes(r, i, &study);
    study_free(&study);
    return status ? status : tell(r);
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

/* ---- many points ----------------------------------------------------------
 */

/* Every row from `first` on, whose x is set. */
static enum status compute_from(struct run *r, size_t first)
{
    const size_t end = r->s->rows.count;
    size_t missing = 0;
    size_t *row = malloc((end - first + 1) * sizeof *row);

    if (row == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = first; i < end; i++)
        if (!take(r, i))
            row[missing++] = i;
#pragma omp parallel for schedule(dynamic, 1)
    for (size_t k = 0; k < missing; k++)
        if (failure(r, STATUS_OK) == STATUS_OK)
            (void) failure(r, compute(r, row[k]));
    free(row);
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
    if (status == STATUS_OK)
        sweep_rows_sort(&r->s->rows);
    return status;
}

static enum status refine(struct run *r)
{
    struct sweep *s = r->s;
    struct sweep_refine f = {
        .curve = { sweep_find(s, "ln_v_plus"), sweep_find(s, "ln_v_minus") },
        .tol = s->scene->sweep.refine,
        .is_log = s->scene->sweep.axis[0].scale == SWEEP_LOG,
    };
    enum status status = sweep_refine_init(&f, &s->rows);

    while (status == STATUS_OK && f.spans > 0 && f.depth < STUDY_REFINE_DEPTH &&
           s->rows.count + f.spans <= SCENE_POINTS) {
        status = compute_middles(r, &f);
        if (status == STATUS_OK)
            status = sweep_refine_next(&f, &s->rows);
    }
    s->unrefined = f.spans > 0;
    sweep_refine_free(&f);
    return status;
}

/* ---- the end --------------------------------------------------------------
 */

static bool is_failure(const char *reason)
{
    for (int s = STATUS_OK + 1; s < STATUS_COUNT; s++)
        if (strcmp(reason, status_text((enum status) s)) == 0)
            return true;
    return false;
}

/* Reasons numbered as they come from the first point to the last. */
static enum status sort_reasons(struct sweep *s)
{
    struct sweep_reasons sorted;
    enum status status = sweep_reasons_init(&sorted);

    for (size_t i = 0; i < s->rows.count && status == STATUS_OK; i++)
        for (size_t k = 0; k < s->columns.count && status == STATUS_OK; k++) {
            int8_t *code = sweep_rows_code(&s->rows, i, k);
            if (s->columns.at[k].codes == NULL && *code >= REASON_FIRST)
                status =
                    sweep_reasons_code(&sorted, s->reasons.text[*code], code);
        }
    sweep_reasons_free(&s->reasons);
    s->reasons = sorted;
    return status;
}

/* The last columns, those of steady states that no point has, go. */
static void trim_columns(struct sweep *s)
{
    const struct sweep_column *c = s->columns.at;

    while (s->columns.count > 0 &&
           strncmp(c[s->columns.count - 1].name, "equilibria_", 11) == 0) {
        for (size_t i = 0; i < s->rows.count; i++)
            if (*sweep_rows_code(&s->rows, i, s->columns.count - 1) ==
                REASON_PRESENT)
                return;
        s->columns.count--;
    }
}

static void count_failures(struct sweep *s)
{
    for (size_t i = 0; i < s->points; i++) {
        const struct quantity q = sweep_quantity(s, 0, i);
        s->failed += !quantity_exists(&q) && is_failure(q.reason);
    }
}

static enum status set_axes(struct sweep *s)
{
    for (size_t k = 0; k < s->axes; k++) {
        const struct scene_axis *from = &s->scene->sweep.axis[k];
        const char *dot = strrchr(from->key, '.');
        struct sweep_axis *axis = &s->axis[k];
        *axis = (struct sweep_axis){
            .key = sweep_key_of(from->key),
            .name = dot ? dot + 1 : from->key,
            .count = s->axes == 1 ? s->rows.count : from->count,
            .is_log = from->scale == SWEEP_LOG,
        };
        axis->value = malloc(axis->count * sizeof *axis->value);
        if (axis->value == NULL)
            return STATUS_NO_MEMORY;
        for (size_t i = 0; i < axis->count; i++)
            axis->value[i] =
                s->axes == 1 ? sweep_rows_x(&s->rows, i)[0] : from->value[i];
    }
    return STATUS_OK;
}

static enum status finish(struct sweep *s)
{
    enum status status = set_axes(s);

    s->points = s->rows.count;
    trim_columns(s);
    if (status == STATUS_OK)
        status = sort_reasons(s);
    if (status == STATUS_OK)
        count_failures(s);
    return status;
}

/* ---- the whole ------------------------------------------------------------
 */

/* The same for the same scene and version, wherever the results go. */
static uint64_t key_of(const struct sweep *s, const char *version)
{
    const struct scene *c = s->scene;
    uint64_t sum = sweep_journal_nil;

    for (const char *line = c->overrides; *line;) {
        const size_t size = strcspn(line, "\n") + 1;
        if (strncmp(line, "output.", 7) != 0 && strncmp(line, "output=", 7))
            sum = sweep_journal_sum(sum, line, size);
        line += size;
    }
    sum = sweep_journal_sum(sum, c->text, strlen(c->text) + 1);
    sum = sweep_journal_sum(sum, &c->products, sizeof c->products);
    for (size_t k = 0; k < s->columns.count; k++)
        sum = sweep_journal_sum(sum, s->columns.at[k].name,
                                strlen(s->columns.at[k].name) + 1);
    return version ? sweep_journal_sum(sum, version, strlen(version)) : sum;
}

static enum status open_journal(struct run *r, const struct sweep_options *o)
{
    struct sweep *s = r->s;

    if (o->journal == NULL)
        return STATUS_OK;
    const enum status status = sweep_journal_open(
        &r->journal, o->journal, key_of(s, o->version), o->resume, &r->left,
        &s->reasons, &s->replaced, r->why);
    sweep_rows_sort(&r->left);
    return status;
}

static enum status begin(struct run *r, const struct sweep_options *o)
{
    struct sweep *s = r->s;
    enum status status = sweep_columns_init(&s->columns, s->scene);

    if (status == STATUS_OK)
        status = sweep_reasons_init(&s->reasons);
    s->rows = r->left =
        sweep_rows_of(s->columns.count, s->columns.conditioning);
    return status ? status : open_journal(r, o);
}

enum status sweep_run(struct sweep *s, const struct scene *scene,
                      const struct sweep_options *options,
                      const struct monitor *monitor, struct fault *why)
{
    struct run r = {
        .s = s, .journal = { .file = -1 }, .monitor = monitor, .why = why
    };

    *s = (struct sweep){ .scene = scene, .axes = scene->sweep.axes };
    why->text[0] = '\0';
    enum status status = begin(&r, options);
    if (status == STATUS_OK)
        status = compute_grid(&r);
    if (status == STATUS_OK && scene->sweep.refine > 0.0)
        status = refine(&r);
    if (status == STATUS_OK)
        status = finish(s);
    sweep_journal_close(&r.journal);
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
    sweep_columns_free(&s->columns);
    sweep_reasons_free(&s->reasons);
    sweep_rows_free(&s->rows);
    *s = (struct sweep){ .scene = NULL };
}

void sweep_forget(const char *journal)
{
    (void) unlink(journal);
}

/* ---- reading --------------------------------------------------------------
 */

int sweep_find(const struct sweep *s, const char *name)
{
    for (size_t k = 0; k < s->columns.count; k++)
        if (strcmp(s->columns.at[k].name, name) == 0)
            return (int) k;
    return -1;
}

struct quantity sweep_quantity(const struct sweep *s, int column, size_t point)
{
    const size_t k = (size_t) column;
    const double *real = sweep_rows_real(&s->rows, point, k);
    const int8_t code = *sweep_rows_code(&s->rows, point, k);

    if (code != REASON_PRESENT)
        return quantity_none(s->reasons.text[code]);
    struct quantity q = quantity_of(real[0], real[1]);
    if (s->columns.conditioning)
        q.conditioning = real[2];
    return q;
}

int sweep_code(const struct sweep *s, int column, size_t point)
{
    return *sweep_rows_code(&s->rows, point, (size_t) column);
}
