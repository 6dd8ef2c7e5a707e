#include "sweep_dim.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study.h"
#include "study_tolerance.h"
#include "transient.h"

static const struct sweep_dim_axis known[SWEEP_DIMS] = {
    [DIM_START] = { .name = "start", .unit = "1", .text = "number of a start" },
    [DIM_PHASE] = { .name = "phase", .unit = "1", .text = "phase of sliding" },
    [DIM_LEVEL] = { .name = "level",
                    .unit = "1",
                    .text = "value of |mu - tan(alpha)|" },
    [DIM_TERM] = { .name = "order",
                   .unit = "1",
                   .text = "order of a term of the power series" },
    [DIM_CHI_ALPHA] = { .name = "chi_alpha",
                        .unit = "rad",
                        .text = "slope angle of chi(v)" },
    [DIM_PSI] = { .name = "psi" },
    [DIM_V] = { .name = "v" },
    [DIM_ARROW_PSI] = { .name = "arrow_psi" },
    [DIM_ARROW_V] = { .name = "arrow_v" },
    [DIM_CHI_V] = { .name = "chi_v",
                    .unit = "V_star",
                    .text = "slip rate in units of V_star" },
};

/* Room for `count` values; NULL without memory. */
static double *room(struct sweep_dims *d, enum sweep_dim dim, size_t count)
{
    struct sweep_dim_axis *axis = &d->of[dim];

    axis->value = malloc((count + 1) * sizeof *axis->value);
    axis->count = axis->value ? count : 0;
    return axis->value;
}

/* first, first + 1, ... */
static enum status count_from(struct sweep_dims *d, enum sweep_dim dim,
                              size_t first, size_t count)
{
    double *value = room(d, dim, count);

    for (size_t i = 0; i < count && value; i++)
        value[i] = (double) (first + i);
    return value ? STATUS_OK : STATUS_NO_MEMORY;
}

static enum status copy(struct sweep_dims *d, enum sweep_dim dim,
                        const double from[], size_t count)
{
    double *value = room(d, dim, count);

    for (size_t i = 0; i < count && value; i++)
        value[i] = from[i];
    return value ? STATUS_OK : STATUS_NO_MEMORY;
}

/* ---- runs ---------------------------------------------------------------- */

static enum status add_runs(struct sweep_dims *d, const struct scene *scene)
{
    const struct transient_options o = transient_defaults(scene);
    double level[MOMENT_LEVELS_MAX];
    enum status status = count_from(d, DIM_START, 0, scene->starts);

    for (size_t i = 0; i < o.levels; i++)
        level[i] = o.level[i].value;
    if (status == STATUS_OK)
        status = count_from(d, DIM_PHASE, 1, PHASES);
    return status ? status : copy(d, DIM_LEVEL, level, o.levels);
}

/* ---- grids --------------------------------------------------------------- */

/* n cells along an axis of the window. */
static enum status add_cells(struct sweep_dims *d, enum sweep_dim dim,
                             const struct study *s, enum basin_axis axis,
                             size_t n)
{
    double *value = room(d, dim, n), *chart = malloc(n * sizeof *chart);

    if (value && chart)
        basin_map_axis(s->scene, axis, n, chart, value);
    free(chart);
    d->of[dim].unit = s->slider.plane.system.axis[axis].unit;
    d->of[dim].text = s->slider.plane.system.axis[axis].long_name;
    return value && chart ? STATUS_OK : STATUS_NO_MEMORY;
}

static enum status add_map(struct sweep_dims *d, const struct study *s)
{
    const enum status status =
        add_cells(d, DIM_PSI, s, BASIN_PSI, s->scene->cells[1]);

    return status ? status
                  : add_cells(d, DIM_V, s, BASIN_V, s->scene->cells[0]);
}

static enum status add_arrows(struct sweep_dims *d, const struct study *s)
{
    const enum status status =
        add_cells(d, DIM_ARROW_PSI, s, BASIN_PSI, PORTRAIT_ARROWS);

    return status ? status
                  : add_cells(d, DIM_ARROW_V, s, BASIN_V, PORTRAIT_ARROWS);
}

/* The window in the chart of the scene's law, wherever the saddle is. */
static enum status add_grids(struct sweep_dims *d, const struct scene *scene,
                             unsigned stages)
{
    struct study s = { .scene = scene };
    enum status status = STATUS_OK;

    block_init(&s.slider.block, &scene->law, &scene->material,
               scene->tan_alpha);
    block_anchor(&s.slider.block, 0.0L, false);
    s.slider.plane.system = block_planar(&s.slider.block);
    if (plan_has(stages, STAGE_BASINS))
        status = add_map(d, &s);
    if (status == STATUS_OK && plan_has(stages, STAGE_ARROWS))
        status = add_arrows(d, &s);
    return status;
}

static enum status add_chi(struct sweep_dims *d, const struct scene *scene)
{
    double v[STUDY_CURVE_POINTS];
    const enum status status =
        copy(d, DIM_CHI_ALPHA, scene->chi_alpha, scene->chi_alphas);

    chi_curves_points(scene->window.v, v);
    return status ? status : copy(d, DIM_CHI_V, v, STUDY_CURVE_POINTS);
}

enum status sweep_dims_init(struct sweep_dims *d, const struct scene *scene)
{
    const unsigned stages = plan_stages(scene->products);
    enum status status = STATUS_OK;

    for (int i = 0; i < SWEEP_DIMS; i++)
        d->of[i] = known[i];
    if (scene->system)
        return STATUS_OK;
    if (plan_has(stages, STAGE_TRAJECTORIES))
        status = add_runs(d, scene);
    if (status == STATUS_OK && plan_has(stages, STAGE_TAYLOR))
        status = count_from(d, DIM_TERM, 0, JET_SIZE);
    if (status == STATUS_OK && plan_has(stages, STAGE_CHI))
        status = add_chi(d, scene);
    if (status == STATUS_OK)
        status = add_grids(d, scene, stages);
    if (status != STATUS_OK)
        sweep_dims_free(d);
    return status;
}

/* The first that is called `name`; SWEEP_DIMS if none is. */
static enum sweep_dim find(const char *name)
{
    int dim = 0;

    while (dim < SWEEP_DIMS && strcmp(known[dim].name, name) != 0)
        dim++;
    return (enum sweep_dim) dim;
}

size_t sweep_dims_of(const char *axis, const char *path,
                     enum sweep_dim dim[SWEEP_RANK])
{
    size_t n = 0;

    for (const char *at = axis; at && *at && n < SWEEP_RANK; n++) {
        const int size = (int) strcspn(at, ",");
        char name[32], own[64];
        snprintf(name, sizeof name, "%.*s", size, at);
        snprintf(own, sizeof own, "%.30s_%s", path + (*path == '/'), name);
        dim[n] = find(own) < SWEEP_DIMS ? find(own) : find(name);
        at += size + (int) strspn(at + size, ", ");
    }
    return n;
}

void sweep_dims_free(struct sweep_dims *d)
{
    for (int i = 0; i < SWEEP_DIMS; i++) {
        free(d->of[i].value);
        d->of[i].value = NULL;
        d->of[i].count = 0;
    }
}
