#include "export_sweep.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "export.h"
#include "library.h"
#include "store.h"
#include "store_grid.h"

static const char group[] = "/sweep";

/* What all columns of a file share. */
struct cube {
    const struct sweep *s;
    struct store *out;
    double *real; /* owned; one value a point */
    int8_t *code; /* owned */
};

/* `values`: one a point. */
static enum status put(const struct cube *c, const struct record_field *f,
                       const void *values)
{
    const struct sweep_axis *a = c->s->axis;

    if (c->s->axes == 1)
        return store_put_column(c->out, group, f, a[0].name, values);
    const enum status status =
        store_put_layer(c->out, group, f, a[0].name, a[1].name);
    return status ? status
                  : store_put_rows(c->out, group, f, 0, a[0].count, values);
}

static enum status put_real(const struct cube *c, const char *suffix,
                            const char *text, const char *unit,
                            const struct sweep_column *column)
{
    char name[96], long_name[256];
    const struct record_field f = {
        .name = name, .unit = unit, .text = long_name, .kind = RECORD_REAL
    };

    snprintf(name, sizeof name, "%s%s", column->name, suffix);
    snprintf(long_name, sizeof long_name, "%s%s", column->text, text);
    return put(c, &f, c->real);
}

static enum status put_codes(const struct cube *c, const char *suffix,
                             const char *text, const char *const *words,
                             const struct sweep_column *column)
{
    char name[96], long_name[256];
    const struct record_field f = { .name = name,
                                    .unit = "1",
                                    .text = long_name,
                                    .kind = RECORD_CODE,
                                    .codes = words };

    snprintf(name, sizeof name, "%s%s", column->name, suffix);
    snprintf(long_name, sizeof long_name, "%s%s", column->text, text);
    return put(c, &f, c->code);
}

/* A member of the quantities of a column. */
static void gather(const struct cube *c, int column, size_t member)
{
    for (size_t i = 0; i < c->s->points; i++) {
        const struct quantity q = sweep_quantity(c->s, column, i);
        memcpy(&c->real[i], (const char *) &q + member, sizeof *c->real);
    }
}

static void gather_codes(const struct cube *c, int column)
{
    for (size_t i = 0; i < c->s->points; i++)
        c->code[i] = (int8_t) sweep_code(c->s, column, i);
}

static enum status put_quantity(const struct cube *c, int k)
{
    const struct sweep_column *column = &c->s->columns.at[k];

    gather(c, k, offsetof(struct quantity, value));
    enum status status = put_real(c, "", "", column->unit, column);
    gather(c, k, offsetof(struct quantity, error));
    if (status == STATUS_OK)
        status = put_real(c, "_error", ": bound on the absolute error",
                          column->unit, column);
    gather(c, k, offsetof(struct quantity, conditioning));
    if (status == STATUS_OK && c->s->columns.conditioning)
        status =
            put_real(c, "_conditioning",
                     ": relative error from rounding the inputs", "1", column);
    gather_codes(c, k);
    if (status == STATUS_OK)
        status = put_codes(c, "_exists", ": whether it exists, or why not",
                           sweep_reasons_words(&c->s->reasons), column);
    return status;
}

static enum status put_column(const struct cube *c, int k)
{
    const struct sweep_column *column = &c->s->columns.at[k];

    if (column->codes == NULL)
        return put_quantity(c, k);
    gather_codes(c, k);
    return put_codes(c, "", "", column->codes, column);
}

static enum status put_axes(const struct cube *c)
{
    char keys[128] = "";
    enum status status = STATUS_OK;

    for (size_t i = 0; i < c->s->axes && status == STATUS_OK; i++) {
        const struct sweep_axis *a = &c->s->axis[i];
        status = store_put_axis(c->out, group, a->name, a->key.unit,
                                a->key.text, a->count, a->value);
        snprintf(keys + strlen(keys), sizeof keys - strlen(keys), "%s%s",
                 i > 0 ? " " : "", a->key.path);
    }
    if (status == STATUS_OK)
        status = store_put_text(c->out, group, "keys", keys);
    if (status == STATUS_OK && c->s->scene->sweep.refine > 0.0)
        status =
            store_put_real(c->out, group, "refine", c->s->scene->sweep.refine);
    return status;
}

static enum status put_all(const struct sweep *s, struct store *out)
{
    struct cube c = { .s = s,
                      .out = out,
                      .real = calloc(s->points, sizeof *c.real),
                      .code = calloc(s->points, sizeof *c.code) };
    enum status status =
        c.real && c.code ? export_provenance(s->scene, out) : STATUS_NO_MEMORY;

    if (status == STATUS_OK)
        status = put_axes(&c);
    for (size_t k = 0; k < s->columns.count && status == STATUS_OK; k++)
        status = put_column(&c, (int) k);
    free(c.real);
    free(c.code);
    return status;
}

enum status export_sweep(const struct sweep *s, const char *path,
                         struct fault *why)
{
    const char *title =
        s->scene->title[0] ? s->scene->title : s->scene->law.preset;
    struct store *out = NULL;

    store_silence();
    enum status status = store_create(path, title, &out, why);
    if (status != STATUS_OK)
        return status;
    status = put_all(s, out);
    if (status == STATUS_OK || status == STATUS_IO)
        status = store_commit(out, why);
    else
        snprintf(why->text, sizeof why->text, "%.300s: %s", path,
                 status_text(status));
    store_free(&out);
    return status;
}
