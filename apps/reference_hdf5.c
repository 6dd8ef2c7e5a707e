#include "reference.h"

#include <string.h>

#include "batch.h"
#include "ensemble_results.h"
#include "plane_numbers.h"
#include "plane_results.h"
#include "provenance.h"
#include "push_file.h"
#include "release.h"
#include "scene_shape.h"
#include "scene_system.h"
#include "simulation.h"
#include "stress_run.h"
#include "study_results.h"
#include "sweep_column.h"
#include "sweep_file.h"
#include "sweep_key.h"
#include "sweep_layer.h"
#include "system.h"
#include "texts.h"
#include "value.h"
#include "workprec.h"

enum { RESULTS_MAX = 128 };

static const char *const kind_names[] = {
    [RECORD_REAL] = "real",       [RECORD_COUNT] = "count",
    [RECORD_CODE] = "code",       [RECORD_TEXT] = "text",
    [RECORD_QUANTITY] = "number",
};

/* ---- lines of tables ----------------------------------------------------- */

static const char *unit_of(const struct record_field *f)
{
    return unit_factor(f->unit) ? f->unit : unit_plain(f->unit);
}

static void put_set(FILE *out, const struct record_field *f, const char *along)
{
    fprintf(out, "| `%s` | %s | %s | %s | ", f->name, kind_names[f->kind],
            f->kind == RECORD_TEXT ? "" : unit_of(f), along ? along : "");
    markdown_text(out, f->text);
    if (f->codes) {
        fputs(": ", out);
        markdown_words(out, f->codes);
    }
    fputs(" |\n", out);
}

static void put_attribute_line(FILE *out, const char *name, const char *kind,
                               const struct record_field *f, const char *text)
{
    fprintf(out, "| `%s` | %s | %s | ", name, kind,
            f->kind == RECORD_TEXT || f->kind == RECORD_CODE ? "" : unit_of(f));
    markdown_text(out, text);
    fputs(" |\n", out);
}

/* A number has its error beside it. */
static void put_attribute(FILE *out, const struct result *r,
                          const struct record_field *f)
{
    const char *member = r->member ? r->member : "*",
               *star = strchr(member, '*');
    const char *kind = f->kind == RECORD_QUANTITY ? "real"
                       : f->kind == RECORD_CODE   ? "text"
                                                  : kind_names[f->kind];
    char name[RESULT_NAME];

    snprintf(name, sizeof name, "%.*s%s%s", (int) (star - member), member,
             f->name, star + 1);
    put_attribute_line(out, name, kind, f, f->text);
    if (f->kind != RECORD_QUANTITY)
        return;
    strncat(name, "_error", sizeof name - strlen(name) - 1);
    put_attribute_line(out, name, kind, f, "bound on its error");
}

static void put_sets_head(FILE *out)
{
    fputs("\n| data set | kind | unit | along | meaning |\n"
          "|---|---|---|---|---|\n",
          out);
}

static void put_attributes_head(FILE *out)
{
    fputs("\n| attribute | kind | unit | meaning |\n|---|---|---|---|\n", out);
}

/* ---- groups -------------------------------------------------------------- */

static void put_index(FILE *out)
{
    static const struct record_field n = {
        .name = "n", .unit = "1", .text = "index", .kind = RECORD_COUNT
    };
    put_set(out, &n, "n");
}

static void put_fields(FILE *out, const struct result *r)
{
    const bool counted = r->shape == RESULT_COLUMNS && r->axis == NULL;

    if (counted)
        put_index(out);
    for (size_t i = 0; i < r->type->count; i++) {
        const struct record_field *f = &r->type->fields[i];
        if (r->shape == RESULT_ATTRIBUTES)
            put_attribute(out, r, f);
        else
            put_set(out, f, counted ? "n" : r->axis);
    }
}

/* What a page has said already: the group it is at, and of each group which
 * records it has. */
struct told {
    const char *path;
    const struct result *of[RESULTS_MAX];
    size_t count;
};

/* Two commands may fill the same group. */
static bool is_told(struct told *t, const struct result *r)
{
    for (size_t i = 0; i < t->count; i++)
        if (t->of[i]->type == r->type && strcmp(t->of[i]->path, r->path) == 0)
            return true;
    if (t->count < RESULTS_MAX)
        t->of[t->count++] = r;
    return false;
}

static void put_part(FILE *out, const struct result *r, struct told *t)
{
    if (t->path == NULL || strcmp(t->path, r->path) != 0)
        fprintf(out, "\n### `%s`\n", r->path);
    t->path = r->path;
    if (r->text) {
        fputs("\n", out);
        markdown_text(out, r->text);
        fputs(":\n", out);
    }
    if (r->shape == RESULT_ATTRIBUTES)
        put_attributes_head(out);
    else
        put_sets_head(out);
    put_fields(out, r);
}

static void put_groups(FILE *out)
{
    const struct result *const *const list[] = {
        provenance_tables, study_tables,    simulation_tables,
        sweep_tables,      ensemble_tables, release_tables,
        push_tables,       workprec_tables, stress_tables
    };
    struct told told = { .path = NULL };

    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        for (size_t t = 0; list[i][t]; t++)
            for (const struct result *r = list[i][t]; r->type; r++)
                if (r->path && !is_told(&told, r))
                    put_part(out, r, &told);
}

/* ---- sweeps -------------------------------------------------------------- */

static void put_axes(FILE *out)
{
    fputs("\nThe axes of a sweep, by its keys:\n"
          "\n| key | data set | unit | meaning |\n|---|---|---|---|\n",
          out);
    for (const struct schema_key *k = schema_table; k->path; k++) {
        const struct sweep_key key = sweep_key_of(k->path);
        const char *dot = strrchr(k->path, '.');
        if (value_is_real(k))
            fprintf(out, "| `%s` | `%s` | %s | %s |\n", k->path,
                    dot ? dot + 1 : k->path, key.unit, key.text);
    }
}

/* "equilibria_0_v" as "equilibria_I_v"; false for further ones of its kind. */
static bool number_to_letter(char *name)
{
    for (char *c = name; *c; c++)
        if (c > name && c[-1] == '_' && c[1] == '_' && *c >= '0' && *c <= '9') {
            const bool first = *c == '0';
            *c = 'I';
            return first;
        }
    return true;
}

/* "the axes, start, level" */
static void along_of(const struct sweep_dims *d, const enum sweep_dim dim[],
                     size_t dims, char *text, size_t size)
{
    size_t end = (size_t) snprintf(text, size, "the axes");

    for (size_t i = 0; i < dims && end < size; i++)
        end += (size_t) snprintf(text + end, size - end, ", %s",
                                 d->of[dim[i]].name);
}

static void put_column(FILE *out, const struct sweep_dims *d,
                       struct sweep_column *c)
{
    char along[64];

    if (!number_to_letter(c->name))
        return;
    along_of(d, c->dim, c->dims, along, sizeof along);
    put_set(out,
            &(struct record_field){
                .name = c->name,
                .unit = c->unit,
                .text = c->text,
                .codes = c->codes,
                .kind = c->kind == RECORD_COUNT ? RECORD_REAL : c->kind },
            along);
}

static void put_layer(FILE *out, const struct sweep_dims *d,
                      const struct sweep_layer *l)
{
    char along[64];

    along_of(d, l->dim, 2, along, sizeof along);
    put_set(
        out,
        &(struct record_field){ .name = l->name,
                                .unit = l->unit,
                                .text = l->text,
                                .codes = l->codes,
                                .kind = l->codes ? RECORD_CODE : RECORD_REAL },
        along);
}

static void put_dims(FILE *out, const struct sweep_dims *d)
{
    fputs("\nAlong what there is more than one number a point:\n", out);
    put_sets_head(out);
    for (int i = 0; i < SWEEP_DIMS; i++)
        put_set(out,
                &(struct record_field){ .name = d->of[i].name,
                                        .unit = d->of[i].unit,
                                        .text = d->of[i].text,
                                        .kind = RECORD_REAL },
                d->of[i].name);
}

/* Those of all products, of one xi, one start and one chi. */
static enum status find_columns(struct scene *all, double *xi,
                                struct scene_start *start,
                                struct sweep_dims *dims,
                                struct sweep_columns *columns)
{
    *all = (struct scene){
        .law = *law_preset_find("spinodal_gen"),
        .material = material_bristol_board(),
        .alpha = 0.34,
        .tan_alpha = 0.35L,
        .window = { { 0.1, 10.0 }, { 0.1, 10.0 }, AXES_LOG },
        .products = ((1u << PRODUCTS) - 1) & ~scene_shape_curves,
        .xi = xi,
        .xi_count = 1,
        .start = start,
        .starts = 1,
        .cells = { 1, 1 },
        .audit = 1,
        .rabinowicz = { .restitution = 0.5 },
        .chi_alpha = xi,
        .chi_alphas = 1,
    };
    *columns = (struct sweep_columns){ .at = NULL };
    const enum status status = sweep_dims_init(dims, all);
    return status ? status : sweep_columns_init(columns, all, dims);
}

static enum status put_sweep(FILE *out)
{
    double xi = 0.85;
    struct scene_start start = { 1.0, 1.0 };
    struct scene all;
    struct sweep_dims dims;
    struct sweep_columns columns;
    struct sweep_layers layers = { .at = NULL };
    enum status status = find_columns(&all, &xi, &start, &dims, &columns);

    if (status == STATUS_OK)
        status = sweep_layers_init(&layers, &all, &dims);
    fputs("\n## Columns of `/sweep`\n"
          "\nThose that the scene's products give, over the axes. I: 0, 1, "
          "... by slip rate of the steady\nstates, and in the order of "
          "estimates.xi. The words of NAME_exists are absent, present, and\n"
          "then the reasons met, with underscores for blanks; NAME_reason is "
          "not needed here. A real\nnumber has NAME_exists and no error; "
          "those along the cells of a map have neither: of a cell\n"
          "basin_exit_reason says why there is none.\n",
          out);
    put_axes(out);
    put_dims(out, &dims);
    fputs("\nThe numbers:\n", out);
    put_sets_head(out);
    for (size_t i = 0; i < columns.count; i++)
        put_column(out, &dims, &columns.at[i]);
    for (size_t i = 0; i < layers.count; i++)
        put_layer(out, &dims, &layers.at[i]);
    sweep_layers_free(&layers);
    sweep_columns_free(&columns);
    sweep_dims_free(&dims);
    return status;
}

/* ---- ensembles ----------------------------------------------------------- */

static enum status put_ensemble(FILE *out)
{
    static const struct record_field push = {
        .name = "push_K",
        .unit = "1",
        .text = "what becomes of the pushed state",
        .kind = RECORD_CODE,
        .codes = fate_names
    };
    double xi = 0.85;
    struct scene_start start = { 1.0, 1.0 };
    struct scene all;
    struct sweep_dims dims;
    struct sweep_columns columns;
    const enum status status = find_columns(&all, &xi, &start, &dims, &columns);

    fputs(
        "\n## Columns of `/ensemble`\n"
        "\nAlong the draws: each parameter, named, with its unit and meaning, "
        "as the axis of a sweep\nover its key; the fate of push K; of these "
        "numbers those that ensemble.numbers names or\nthe products give, "
        "with NAME_exists as in `/sweep`.\n",
        out);
    put_sets_head(out);
    put_set(out, &push, "draw");
    for (size_t i = 0; i < columns.count; i++)
        if (batch_draws(&columns.at[i]))
            put_set(out,
                    &(struct record_field){ .name = columns.at[i].name,
                                            .unit = columns.at[i].unit,
                                            .text = columns.at[i].text,
                                            .kind = RECORD_QUANTITY },
                    "draw");
    sweep_columns_free(&columns);
    sweep_dims_free(&dims);
    return status;
}

/* ---- systems ------------------------------------------------------------- */

/* One group of a system's file in a line: what it holds, along what. */
static void put_group(FILE *out, const struct result *r)
{
    fprintf(out, "- `%s`, ", r->path);
    markdown_text(out, r->type->text);
    fputs(":", out);
    for (size_t i = 0; i < r->type->count; i++) {
        const struct record_field *f = &r->type->fields[i];
        char name[RESULT_NAME];
        result_member(r, 0, f, name);
        fprintf(out, "%s `%s`", i ? "," : "", name);
        if (f->kind == RECORD_QUANTITY)
            fprintf(out, ", `%s_error`", name);
    }
    if (r->shape == RESULT_ATTRIBUTES)
        fputs("; attributes\n", out);
    else
        fprintf(out, "; along `%s`\n", r->axis ? r->axis : "n");
}

/* States x and y, a parameter p. */
static enum status make_system(struct formula_system *f)
{
    const struct formula_place here = { "reference", 0, 0 };
    struct fault why;

    formula_system_init(f);
    enum status status =
        formula_system_state(f, "x", CHART_REAL, NULL, here, &why);
    if (status == STATUS_OK)
        status = formula_system_state(f, "y", CHART_REAL, NULL, here, &why);
    return status ? status : formula_system_parameter(f, "p", "1", here, &why);
}

static enum status put_systems(FILE *out)
{
    static struct formula_system system;
    const struct scene scene = { .system = &system,
                                 .products = scene_system_products };
    struct plane_study frame;
    enum status status = make_system(&system);

    if (status == STATUS_OK)
        status = plane_numbers_frame(&frame, &scene);
    if (status != STATUS_OK)
        return status;
    fputs("\n## Systems of formulas\n"
          "\nA file of a system has these groups, with the names of its states "
          "for x and y, of\nits parameters for p, and `/manifold/saddle_K/` "
          "for each of its saddles:\n\n",
          out);
    const struct results all = plane_results(&frame);
    for (size_t t = 0; all.table[t]; t++)
        for (const struct result *r = all.table[t]; r->type; r++)
            if (r->path)
                put_group(out, r);
    plane_numbers_free(&frame);
    return STATUS_OK;
}

enum status reference_hdf5(FILE *out)
{
    fputs(text_hdf5, out);
    fputs("\n## Groups\n", out);
    put_groups(out);
    enum status status = put_sweep(out);
    if (status == STATUS_OK)
        status = put_ensemble(out);
    return status ? status : put_systems(out);
}
