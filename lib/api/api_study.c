/* A study is one point of a sweep over no key: so its numbers have the names
 * of a sweep's columns. */
#include <stdlib.h>
#include <string.h>

#include "api.h"
#include "curve_rows.h"
#include "scene_slope.h"
#include "sweep_column.h"

struct slipway_study {
    struct scene scene;
    struct sweep_point point;
    struct sweep_dims dims;
    struct sweep_columns columns;
    struct rows branch[SLIPWAY_UNSTABLE_LOWER + 1]; /* owned */
};

API_LENT(slipway_point, arc, branch_row, arc);
API_LENT(slipway_point, v, branch_row, v);
API_LENT(slipway_point, psi, branch_row, psi);
API_LENT(slipway_point, slope, branch_row, slope);
API_LENT(slipway_point, slip, branch_row, slip);
API_LENT(slipway_point, time, branch_row, time);
API_LENT(slipway_point, work, branch_row, work);
API_LENT(slipway_point, excess, branch_row, excess);
API_LENT(slipway_point, error, branch_row, error);

/* ---- a run --------------------------------------------------------------- */

static enum status fill(const struct sweep_point *p, size_t which,
                        struct rows *rows)
{
    const size_t side = which % SIDES;

    if (which < SLIPWAY_UNSTABLE_UPPER)
        return curve_rows_branch(&p->study, &p->study.stable[side], rows);
    return curve_rows_unstable(&p->study, &p->study.unstable[side], rows);
}

static enum status fill_branches(slipway_study *study)
{
    const struct sweep_point *p = &study->point;
    enum status s = STATUS_OK;

    if (!plan_has(p->study.stages, STAGE_UNSTABLE) ||
        !slider_has_manifolds(&p->study.slider))
        return s;
    for (size_t i = 0; i <= SLIPWAY_UNSTABLE_LOWER && s == STATUS_OK; i++) {
        study->branch[i] = rows_of(&record_branch);
        s = fill(p, i, &study->branch[i]);
    }
    return s;
}

static slipway_status run(slipway_study *study, const slipway_monitor *monitor,
                          slipway_fault *why)
{
    struct scene one = study->scene, *scene = &one;
    struct monitor tell;
    struct fault fault = { "" };

    if (scene->system)
        return api_fault(why, SLIPWAY_BAD_SCENE,
                         "a system of formulas: slipway_plane_run takes it");
    one.sweep.axes = 0;
    one.products = api_products(scene);
    enum status s = scene_slope_demand(scene, scene->products, &fault);
    if (s != STATUS_OK)
        return api_answer(why, s, &fault);
    s = sweep_dims_init(&study->dims, scene);
    if (s == STATUS_OK)
        s = sweep_columns_init(&study->columns, scene, &study->dims);
    if (s == STATUS_OK)
        s = sweep_point_at(&study->point, scene, NULL, scene->products,
                           api_monitor(monitor, &tell));
    if (s == STATUS_OK && study->point.failed == NULL)
        s = fill_branches(study);
    return study->point.failed
               ? api_fault(why, SLIPWAY_NUMERICAL, study->point.failed)
               : api_answer(why, s, NULL);
}

slipway_status slipway_study_run(const slipway_scene *scene,
                                 const slipway_monitor *monitor,
                                 slipway_study **out, slipway_fault *why)
{
    slipway_study *study = calloc(1, sizeof *study);

    if (study == NULL)
        return api_fault(why, SLIPWAY_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    slipway_status s = api_read(scene, &study->scene, why);
    if (s == SLIPWAY_OK)
        s = run(study, monitor, why);
    if (s == SLIPWAY_OK)
        *out = study;
    else
        slipway_study_free(study);
    return s;
}

void slipway_study_free(slipway_study *study)
{
    if (study == NULL)
        return;
    for (size_t i = 0; i <= SLIPWAY_UNSTABLE_LOWER; i++)
        rows_free(&study->branch[i]);
    sweep_point_free(&study->point);
    sweep_columns_free(&study->columns);
    sweep_dims_free(&study->dims);
    scene_free(&study->scene);
    free(study);
}

/* ---- numbers ------------------------------------------------------------- */

slipway_status slipway_study_number(const slipway_study *study,
                                    const char *name, slipway_number *out)
{
    for (size_t i = 0; i < study->columns.count; i++) {
        const struct sweep_column *c = &study->columns.at[i];
        if (!api_is_number(c) || strcmp(c->name, name) != 0)
            continue;
        const struct quantity q = sweep_column_quantity(c, &study->point, 0);
        *out = api_number(&q);
        return SLIPWAY_OK;
    }
    return SLIPWAY_BAD_ARGUMENT;
}

slipway_label slipway_study_label(const slipway_study *study, size_t k)
{
    return api_label(&study->columns, k);
}

size_t slipway_study_equilibria(const slipway_study *study,
                                slipway_equilibrium out[], size_t room)
{
    const struct slider *s = &study->point.study.slider;

    for (size_t i = 0; i < s->plane.equilibria && i < room; i++) {
        const struct steady_number *n = &s->steady[i];
        out[i] = (slipway_equilibrium){
            .type = (slipway_type) s->plane.equilibrium[i].type,
            .v = api_number(&n->v),
            .psi = api_number(&n->psi),
            .mu = api_number(&n->mu),
            .lambda_minus = api_number(&n->lambda_minus),
            .lambda_plus = api_number(&n->lambda_plus),
        };
    }
    return s->plane.equilibria;
}

/* ---- curves -------------------------------------------------------------- */

slipway_axis slipway_study_axis(const slipway_study *study, int axis)
{
    return api_axis(&study->scene, axis);
}

const slipway_point *slipway_study_branch(const slipway_study *study,
                                          slipway_branch which, size_t *count)
{
    *count = study->branch[which].count;
    return study->branch[which].at;
}

/* ---- basins -------------------------------------------------------------- */

static const struct basin_map *map_of(const slipway_study *study)
{
    return &study->point.study.basins;
}

void slipway_basin_size(const slipway_study *study, size_t *columns,
                        size_t *rows)
{
    *columns = map_of(study)->columns;
    *rows = map_of(study)->rows;
}

slipway_status slipway_basin_axes(const slipway_study *study, double v[],
                                  double psi[])
{
    const struct basin_map *m = map_of(study);

    if (m->rows == 0)
        return SLIPWAY_BAD_ARGUMENT;
    memcpy(v, m->v, m->columns * sizeof *v);
    memcpy(psi, m->psi, m->rows * sizeof *psi);
    return SLIPWAY_OK;
}

static bool holds(const slipway_study *study, size_t first, size_t rows)
{
    const size_t all = map_of(study)->rows;

    return all > 0 && first <= all && rows <= all - first;
}

slipway_status slipway_basin_labels(const slipway_study *study, size_t first,
                                    size_t rows, int8_t label[])
{
    if (!holds(study, first, rows))
        return SLIPWAY_BAD_ARGUMENT;
    return api_status(basin_map_rows(map_of(study), first, rows, label));
}

slipway_status slipway_basin_margins(const slipway_study *study, size_t first,
                                     size_t rows, double v[], double psi[])
{
    if (!holds(study, first, rows))
        return SLIPWAY_BAD_ARGUMENT;
    return api_status(basin_map_margins(map_of(study), first, rows, v, psi));
}

/* The number of a field by its name; CELL_FIELDS: there is none. */
static size_t field_named(const char *name)
{
    size_t k = 0;

    while (k < CELL_FIELDS &&
           strcmp(record_cell.fields[1 + 2 * k].name, name) != 0)
        k++;
    return k;
}

static double read_member(const struct cell *c, size_t field)
{
    const struct record_array one = { &record_cell, c, 1 };

    return *(const double *) record_member(&one, 0, &record_cell.fields[field]);
}

slipway_status slipway_basin_field(const slipway_study *study,
                                   const char *which, size_t first, size_t rows,
                                   double value[], double error[])
{
    const struct fields *f = &study->point.study.fields;
    const size_t k = field_named(which), n = rows * map_of(study)->columns;

    if (!holds(study, first, rows) || k == CELL_FIELDS || !(f->which >> k & 1))
        return SLIPWAY_BAD_ARGUMENT;
    struct cell *cell = malloc((n + 1) * sizeof *cell);
    if (cell == NULL)
        return SLIPWAY_NO_MEMORY;
    const enum status s = fields_find(f, first, rows, NULL, cell);
    for (size_t i = 0; i < n && s == STATUS_OK; i++) {
        value[i] = read_member(&cell[i], 1 + 2 * k);
        error[i] = read_member(&cell[i], 2 + 2 * k);
    }
    free(cell);
    return api_status(s);
}
