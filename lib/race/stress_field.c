/* A cell is the state that its file says, v and psi as stored, not the chart
 * point that the program made of it. */
#include "stress_field.h"

#include <math.h>
#include <stdlib.h>

#include "clock.h"
#include "stress_judge.h"
#include "stress_tolerance.h"
#include "stress_work.h"

static struct stress_number_told {
    double value, error;
} told(const struct cell *c, int k)
{
    const struct record_array a = { &record_cell, c, 1 };
    const struct record_field *value = &cell_fields[1 + 2 * k];
    const struct record_field *error = &cell_fields[2 + 2 * k];

    return (struct stress_number_told){
        *(const double *) record_member(&a, 0, value),
        *(const double *) record_member(&a, 0, error)
    };
}

/* ---- one cell ------------------------------------------------------------ */

static void judge_field(const struct cell *c, const struct quad_orbit *o, int k,
                        struct stress_row *row)
{
    const struct stress_number_told t = told(c, k);
    const char *name = cell_fields[1 + 2 * k].name;

    if (isnan(t.value) && isnan(o->error[k]))
        return;
    if (isnan(t.value)) {
        stress_row_say(row, STRESS_DEGRADED, "a cell lacks a number", name);
        return;
    }
    if (isnan(o->error[k])) {
        stress_row_say(row, STRESS_LIE, "a cell has a number that is none",
                       name);
        return;
    }
    const quad off = fabsq((quad) t.value - o->value[k]);
    const bool sure = o->error[k] <= STRESS_SETTLED * t.error;
    if (sure)
        row->bar = fmax(row->bar, (double) (off / (quad) t.error));
    if (!(off <= (quad) t.error + (quad) o->error[k]))
        stress_row_say(row, STRESS_LIE, "a number is further off than its bar",
                       name);
    if (!sure)
        stress_row_say(row, STRESS_DEGRADED,
                       "the oracle is not sure of a number", name);
}

void stress_field_judge(const struct stress_cell *c, const struct quad_orbit *o,
                        struct stress_row *row)
{
    if (o->fate == FATE_UNDECIDED) {
        stress_row_say(row, STRESS_DEGRADED,
                       "the oracle cannot follow a cell's orbit", NULL);
        return;
    }
    if (c->label != FATE_UNDECIDED && c->label != (int8_t) o->fate)
        stress_row_say(row, STRESS_LIE, "a cell has the fate of another side",
                       NULL);
    else if (c->cell.exit_reason == FATE_UNDECIDED && c->which != 0)
        stress_row_say(row, STRESS_DEGRADED, "a cell has a fate, but no number",
                       NULL);
    else
        for (int k = 0; k < CELL_FIELDS; k++)
            if (c->which >> k & 1u)
                judge_field(&c->cell, o, k, row);
}

/* ---- grids --------------------------------------------------------------- */

struct grid {
    const struct stress_work *work;
    struct quad_slope slope;
    int8_t *label;     /* owned: PATCHWORK_TILE rows */
    struct cell *cell; /* owned: as many */
};

/* Whether states as far aside of the separatrix, which rises, as doubles know
 * it at the least share one fate. */
static bool is_certain(const struct quad_slope *q, quad x, quad y,
                       struct stress_row *row)
{
    const quad near = (quad) STRESS_NEAR * (1 + fabsq(x) + fabsq(y));
    struct quad_orbit a, b;

    quad_orbit_find(q, x - near, y + near, STRESS_ORBIT_TOL, &a);
    quad_orbit_find(q, x + near, y - near, STRESS_ORBIT_TOL, &b);
    row->oracle_evaluations += (int64_t) (a.steps + b.steps);
    return a.fate == b.fate && a.fate != FATE_UNDECIDED;
}

/* The cell `at` of the block of rows that begins at `first`. */
static void judge_cell(const struct grid *g, size_t first, size_t at)
{
    const struct study *s = &g->work->study;
    const struct basin_map *m = &s->basins;
    struct stress_row *row = g->work->row;
    const double psi = m->psi[first + at / m->columns];
    const quad x = logq((quad) m->v[at % m->columns]);
    const quad y =
        law_psi_is_log(&s->scene->law) ? (quad) psi : logq((quad) psi);
    const struct stress_cell c = { g->label[at], g->cell[at], s->fields.which };
    struct quad_orbit o;

    row->steps++;
    if (c.label == FATE_UNDECIDED) {
        if (is_certain(&g->slope, x, y, row))
            stress_row_say(row, STRESS_DEGRADED,
                           "a cell is undecided far from the separatrix", NULL);
        return;
    }
    quad_orbit_find(&g->slope, x, y, STRESS_ORBIT_TOL, &o);
    row->oracle_evaluations += (int64_t) o.steps;
    stress_field_judge(&c, &o, row);
}

/* Some rows at a time, of which every stride-th cell is looked at. */
static enum status judge_rows(struct grid *g)
{
    const struct study *s = &g->work->study;
    const struct basin_map *m = &s->basins;
    struct stress_row *row = g->work->row;
    const size_t all = m->rows * m->columns;
    const size_t stride = all > STRESS_LOOKS ? all / STRESS_LOOKS : 1;
    enum status status = STATUS_OK;

    for (size_t j = 0; j < m->rows && status == STATUS_OK;
         j += PATCHWORK_TILE) {
        const size_t some =
            m->rows - j < PATCHWORK_TILE ? m->rows - j : PATCHWORK_TILE;
        double start = clock_seconds();
        status = basin_map_rows(m, j, some, g->label);
        if (status == STATUS_OK)
            status = fields_find(&s->fields, j, some, NULL, g->cell);
        row->seconds += clock_seconds() - start;
        start = clock_seconds();
        for (size_t i = 0; i < some * m->columns && status == STATUS_OK; i++)
            if ((j * m->columns + i) % stride == 0)
                judge_cell(g, j, i);
        row->oracle_seconds += clock_seconds() - start;
    }
    return status;
}

enum status stress_grid_judge(struct stress_work *w)
{
    const size_t n = w->study.basins.columns * PATCHWORK_TILE;
    struct grid g = { .work = w,
                      .label = malloc(n * sizeof *g.label),
                      .cell = malloc(n * sizeof *g.cell) };
    enum status s = STATUS_NO_MEMORY;

    quad_slope_init(&g.slope, &w->study);
    w->row->bar = 0.0;
    if (g.label && g.cell)
        s = judge_rows(&g);
    free(g.label);
    free(g.cell);
    return s;
}
