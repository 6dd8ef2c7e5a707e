#include "result_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ensemble.h"
#include "ensemble_results.h"
#include "provenance.h"
#include "store.h"
#include "store_grid.h"
#include "store_results.h"
#include "sweep_key.h"

/* ---- an ensemble --------------------------------------------------------- */

static const char group[] = "/ensemble";

/* What all columns share. */
struct file {
    const struct ensemble *e;
    struct store *out;
    void *values; /* owned; of a block */
    struct fault *why;
};

/* ---- columns ------------------------------------------------------------- */

static enum status put_column(const struct file *f, enum spool_kind kind,
                              size_t k, const struct record_field *field)
{
    static const char *const draw[] = { "draw" };
    const struct spool *s = &f->e->spool;
    enum status status = store_put_cube(f->out, group, field, 1, draw);

    for (size_t b = 0; b < spool_blocks(s) && status == STATUS_OK; b++) {
        status = spool_read(s, b, kind, k, f->values, f->why);
        if (status == STATUS_OK)
            status = store_put_rows(f->out, group, field, b * SPOOL_DRAWS,
                                    spool_count(s, b), f->values);
    }
    return status;
}

/* The last word of its path; of two keys with the same, the path. */
static const char *name_of(const struct draws *d, size_t k)
{
    const char *name = strrchr(d->key[k], '.') + 1;

    for (size_t i = 0; i < d->keys; i++)
        if (i != k && strcmp(strrchr(d->key[i], '.') + 1, name) == 0)
            return d->key[k];
    return name;
}

static enum status put_key(const struct file *f, size_t k)
{
    const struct draws *d = &f->e->draws;
    const struct sweep_key key = sweep_key_of(d->key[k]);

    return put_column(f, SPOOL_KEY, k,
                      &(struct record_field){ .name = name_of(d, k),
                                              .unit = key.unit,
                                              .text = key.text,
                                              .kind = RECORD_REAL });
}

static enum status put_number(const struct file *f, size_t k)
{
    const struct result_number *n = &f->e->batch.number[k];
    struct record_field field = { .name = n->name,
                                  .unit = n->field->unit,
                                  .text = n->field->text,
                                  .kind = RECORD_REAL };
    char name[RESULT_NAME + 8], text[256];
    enum status status = put_column(f, SPOOL_VALUE, k, &field);

    field.name = name;
    field.text = text;
    snprintf(name, sizeof name, "%s_error", n->name);
    snprintf(text, sizeof text, "%.200s: bound on the absolute error",
             n->field->text);
    if (status == STATUS_OK)
        status = put_column(f, SPOOL_ERROR, k, &field);
    field.unit = "1";
    field.kind = RECORD_CODE;
    field.codes = sweep_reasons_words(&f->e->reasons);
    snprintf(name, sizeof name, "%s_exists", n->name);
    snprintf(text, sizeof text, "%.200s: whether it exists, or why not",
             n->field->text);
    return status ? status : put_column(f, SPOOL_CODE, k, &field);
}

static enum status put_fates(const struct file *f, size_t k)
{
    const bool plane = f->e->scene->system != NULL;
    char name[32];
    const struct record_field field = {
        .name = name,
        .unit = "1",
        .text = plane ? "whereto the pushed state goes, or why there is none"
                      : "what becomes of the pushed state",
        .kind = RECORD_CODE,
        .codes = plane ? sweep_reasons_words(&f->e->reasons) : fate_names
    };

    snprintf(name, sizeof name, "push_%zu", k);
    return put_column(f, plane ? SPOOL_FATE_REASON : SPOOL_FATE, k, &field);
}

/* ---- the whole ----------------------------------------------------------- */

static enum status put_all(const struct file *f)
{
    const struct ensemble *e = f->e;
    const struct results all = { ensemble_tables, .run = e };
    enum status status = store_put_results(f->out, &all, NULL);

    if (status == STATUS_OK && e->draws.id < 0)
        status = store_put_index(f->out, group, "draw", "number of the draw",
                                 e->draws.count);
    for (size_t k = 0; k < e->draws.keys && status == STATUS_OK; k++)
        status = put_key(f, k);
    for (size_t k = 0; k < e->batch.numbers && status == STATUS_OK; k++)
        status = put_number(f, k);
    for (size_t k = 0; k < e->batch.pushes && status == STATUS_OK; k++)
        status = put_fates(f, k);
    return status;
}

/* Group /ensemble: along `draw` each parameter by the last word of its key,
 * each number with _error and _exists, the fate of each push as push_K; `id` of
 * samples that have one.  What they say together: /ensemble_numbers, _variance,
 * _pushes.  Draws go from the spool to the file block by block.  Errors as
 * result_file_write. */
static enum status ensemble_file_put(const struct ensemble *e,
                                     struct store *out, struct fault *why)
{
    struct file f = { e, out, malloc(SPOOL_DRAWS * sizeof(double)), why };
    const enum status status = f.values ? put_all(&f) : STATUS_NO_MEMORY;

    free(f.values);
    return status;
}

enum status result_file_begin(struct store **out, const char *path,
                              const struct scene *scene, const char *untitled,
                              bool large, struct fault *why)
{
    const char *title = scene && scene->title[0] ? scene->title : untitled;

    store_silence();
    const enum status s = large ? store_create_on_disk(path, title, out, why)
                                : store_create(path, title, out, why);
    if (s == STATUS_OK)
        why->text[0] = '\0';
    return s;
}

enum status result_file_end(struct store **out, const char *path, enum status s,
                            struct fault *why)
{
    const bool told = why->text[0] != '\0';

    if (!told && (s == STATUS_OK || s == STATUS_IO))
        s = store_commit(*out, why);
    else if (!told)
        snprintf(why->text, sizeof why->text, "%.300s: %s", path,
                 status_text(s));
    store_free(out);
    return s;
}

enum status result_file_write(const char *command, const struct results *all,
                              const struct scene *scene,
                              const struct ensemble *drawn,
                              const char *untitled, const char *path,
                              const struct monitor *monitor, struct fault *why)
{
    struct store *out;
    enum status s =
        result_file_begin(&out, path, scene, untitled, drawn != NULL, why);

    if (s != STATUS_OK)
        return s;
    s = provenance_put(command, scene, out);
    if (s == STATUS_OK)
        s = store_put_results(out, all, monitor);
    if (s == STATUS_OK && drawn)
        s = ensemble_file_put(drawn, out, why);
    return result_file_end(&out, path, s, why);
}
