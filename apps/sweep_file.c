#include "sweep_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "provenance.h"
#include "result_file.h"
#include "store.h"
#include "store_grid.h"
#include "study_results.h"
#include "sweep_told.h"
#include "tolerance.h"

static const char group[] = "/sweep";

/* What all columns of a file share. */
struct cube {
    const struct sweep *s;
    struct store *out;
    double *real; /* owned; room for all values of a column, or of a layer */
    int8_t *code; /* owned; likewise */
};

/* ---- data sets ----------------------------------------------------------- */

/* Over the keys, then so many dimensions of its own. */
static enum status create(const struct cube *c, const struct record_field *f,
                          const enum sweep_dim dim[], size_t dims)
{
    const char *name[STORE_AXES];
    size_t n = 0;

    for (; n < c->s->axes; n++)
        name[n] = c->s->axis[n].name;
    for (size_t i = 0; i < dims; i++)
        name[n++] = c->s->dims.of[dim[i]].name;
    return store_put_cube(c->out, group, f, n, name);
}

/* A data set of a column, all its values: `like` without a name, a text about
 * what is told of the column. */
static enum status put(const struct cube *c, const struct sweep_column *column,
                       const char *suffix, struct record_field like,
                       const void *values)
{
    char name[96], long_name[256];

    snprintf(name, sizeof name, "%s%s", column->name, suffix);
    snprintf(long_name, sizeof long_name, "%s%s", column->text, like.text);
    like.name = name;
    like.text = long_name;
    const enum status status = create(c, &like, column->dim, column->dims);
    return status ? status
                  : store_put_slab(c->out, group, &like, 0, NULL, values);
}

/* A member of the quantities of a column. */
static enum status put_real(const struct cube *c, int k, const char *suffix,
                            const char *text, const char *unit, size_t member)
{
    const struct sweep_column *column = &c->s->columns.at[k];
    double *to = c->real;

    for (size_t i = 0; i < c->s->points; i++)
        for (size_t e = 0; e < column->entries; e++) {
            const struct quantity q = sweep_entry(c->s, k, i, e);
            memcpy(to++, (const char *) &q + member, sizeof *to);
        }
    return put(c, column, suffix,
               (struct record_field){
                   .text = text, .unit = unit, .kind = RECORD_REAL },
               c->real);
}

static enum status put_codes(const struct cube *c, int k, const char *suffix,
                             const char *text, const char *const *words)
{
    const struct sweep_column *column = &c->s->columns.at[k];
    int8_t *to = c->code;

    for (size_t i = 0; i < c->s->points; i++)
        for (size_t e = 0; e < column->entries; e++)
            *to++ = (int8_t) sweep_entry_code(c->s, k, i, e);
    return put(
        c, column, suffix,
        (struct record_field){
            .text = text, .unit = "1", .kind = RECORD_CODE, .codes = words },
        c->code);
}

static enum status put_column(const struct cube *c, int k)
{
    const struct sweep_column *column = &c->s->columns.at[k];
    const bool has_bar = column->kind == RECORD_QUANTITY;

    if (column->codes)
        return put_codes(c, k, "", "", column->codes);
    enum status status =
        put_real(c, k, "", "", column->unit, offsetof(struct quantity, value));
    if (status == STATUS_OK && has_bar)
        status = put_real(c, k, "_error", ": bound on the absolute error",
                          column->unit, offsetof(struct quantity, error));
    if (status == STATUS_OK && has_bar && c->s->columns.conditioning)
        status = put_real(c, k, "_conditioning",
                          ": relative error from rounding the inputs", "1",
                          offsetof(struct quantity, conditioning));
    if (status == STATUS_OK)
        status = put_codes(c, k, "_exists", ": whether it exists, or why not",
                           sweep_reasons_words(&c->s->reasons));
    return status;
}

/* ---- layers -------------------------------------------------------------- */

static enum status put_points(const struct cube *c, size_t k,
                              const struct record_field *f, void *values,
                              struct fault *why)
{
    const struct sweep *s = c->s;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < s->points && status == STATUS_OK; i++) {
        const size_t inner = s->axes > 1 ? s->axis[1].count : 1;
        const size_t at[SCENE_AXES] = { i / inner, i % inner };
        status = sweep_read(s, k, i, values, why);
        if (status == STATUS_OK)
            status = store_put_slab(c->out, group, f, s->axes, at, values);
    }
    return status;
}

static enum status put_layer(const struct cube *c, size_t k, struct fault *why)
{
    const struct sweep_layer *layer = &c->s->layers.at[k];
    const struct record_field f = { .name = layer->name,
                                    .unit = layer->unit,
                                    .text = layer->text,
                                    .kind = layer->codes ? RECORD_CODE
                                                         : RECORD_REAL,
                                    .codes = layer->codes };
    const enum status status = create(c, &f, layer->dim, 2);

    return status
               ? status
               : put_points(c, k, &f,
                            layer->codes ? (void *) c->code : (void *) c->real,
                            why);
}

/* What the fields of the cells were computed to. */
static enum status put_accuracy(const struct cube *c)
{
    const struct scene *scene = c->s->scene;
    const unsigned fields = 1u << PRODUCT_SLIP | 1u << PRODUCT_TIME |
                            1u << PRODUCT_FRICTION | 1u << PRODUCT_PEAK;

    if (!(scene->products & fields) || c->s->layers.count == 0)
        return STATUS_OK;
    const enum status status =
        store_put_real(c->out, group, "cell_rtol", scene->cell_rtol);
    return status ? status
                  : store_put_real(c->out, group, "cell_arrest", TOL_ARREST);
}

/* ---- axes ---------------------------------------------------------------- */

static enum status put_keys(const struct cube *c)
{
    char keys[128] = "";
    enum status status = STATUS_OK;

    for (size_t i = 0; i < c->s->axes && status == STATUS_OK; i++) {
        const struct sweep_axis *a = &c->s->axis[i];
        status = store_put_axis(c->out, group, a->name,
                                sweep_told_unit(c->s, a->key.unit), a->key.text,
                                a->count, a->value);
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

/* Maps have none without a side file, but no file is written then. */
static enum status put_dims(const struct cube *c)
{
    enum status status = STATUS_OK;

    for (int i = 0; i < SWEEP_DIMS && status == STATUS_OK; i++) {
        const struct sweep_dim_axis *a = &c->s->dims.of[i];
        if (a->count > 0)
            status = store_put_axis(c->out, group, a->name, a->unit, a->text,
                                    a->count, a->value);
    }
    return status;
}

static const struct record_type record_start = RECORD_OF(
    double, "start", "starts",
    FIELD_OF(REAL, "start_v", "V_star",
             "slip rate at the start in units of V_star"),
    FIELD_OF(REAL, "start_psi", "psi", "interfacial state at the start"));
static const struct record_type record_keys = RECORD_OF(
    char *, "keys", "keys",
    FIELD_OF(TEXT, "keys", "1", "the keys of the axes, in their order"),
    FIELD_OF(REAL, "refine", "1", "sweep.refine, where the scene has it"));

static const struct result sweep_results[] = {
    { "/sweep", NULL,
      "sweep: the numbers of a study over one key or more; its axes and "
      "columns "
      "are below",
      RESULT_ATTRIBUTES, .type = &record_keys },
    { "/sweep", NULL, "with fields of cells", RESULT_ATTRIBUTES,
      .type = &record_accuracy },
    { "/sweep", NULL, "with starts, the same at all points", RESULT_COLUMNS,
      .axis = "start", .type = &record_start },
    { .path = NULL },
};

const struct result *const sweep_tables[] = { sweep_results, NULL };

/* Where the runs start: the same at all points. */
static enum status put_starts(const struct cube *c)
{
    const struct scene *scene = c->s->scene;
    const size_t n = c->s->dims.of[DIM_START].count;
    enum status status = STATUS_OK;

    for (int k = 0; k < 2 && n > 0 && status == STATUS_OK; k++) {
        for (size_t i = 0; i < n; i++)
            c->real[i] = k == 0 ? scene->start[i].v : scene->start[i].psi;
        status = store_put_cube(c->out, group, &record_start.fields[k], 1,
                                &c->s->dims.of[DIM_START].name);
        if (status == STATUS_OK)
            status = store_put_slab(c->out, group, &record_start.fields[k], 0,
                                    NULL, c->real);
    }
    return status;
}

/* ---- the whole ----------------------------------------------------------- */

/* Values of the largest column or layer. */
static size_t most_values(const struct sweep *s)
{
    size_t most = s->dims.of[DIM_START].count;

    for (size_t k = 0; k < s->columns.count; k++)
        if (s->columns.at[k].entries * s->points > most)
            most = s->columns.at[k].entries * s->points;
    for (size_t k = 0; k < s->layers.count; k++)
        if (s->layers.at[k].rows * s->layers.at[k].columns > most)
            most = s->layers.at[k].rows * s->layers.at[k].columns;
    return most;
}

static enum status put_all(const struct sweep *s, struct store *out,
                           struct fault *why)
{
    const size_t most = most_values(s);
    struct cube c = { .s = s,
                      .out = out,
                      .real = calloc(most, sizeof *c.real),
                      .code = calloc(most, sizeof *c.code) };
    enum status status = c.real && c.code
                             ? provenance_put("sweep", s->scene, out)
                             : STATUS_NO_MEMORY;

    if (status == STATUS_OK)
        status = put_keys(&c);
    if (status == STATUS_OK)
        status = put_dims(&c);
    if (status == STATUS_OK)
        status = put_starts(&c);
    for (size_t k = 0; k < s->columns.count && status == STATUS_OK; k++)
        status = put_column(&c, (int) k);
    if (status == STATUS_OK)
        status = put_accuracy(&c);
    for (size_t k = 0; k < s->layers.count && status == STATUS_OK; k++)
        status = put_layer(&c, k, why);
    free(c.real);
    free(c.code);
    return status;
}

enum status sweep_file_write(const struct sweep *s, const char *path,
                             struct fault *why)
{
    struct store *out;
    enum status status = result_file_begin(
        &out, path, s->scene,
        s->scene->system ? "system" : s->scene->law.preset, false, why);

    if (status == STATUS_OK)
        status = result_file_end(&out, path, put_all(s, out, why), why);
    return status;
}
