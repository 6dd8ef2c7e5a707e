#include "basin_map.h"

#include <math.h>
#include <stdlib.h>

#include "study.h"
#include "study_tolerance.h"

/* ---- the grid ------------------------------------------------------------ */

/* Centres of n cells between lo and hi, even in the coordinate or, `linear`,
 * in its exponential; `stored` is the exponential where is_log. */
static void make_axis(size_t n, double lo, double hi, bool is_log, bool linear,
                      double chart[], double stored[])
{
    const double a = linear && is_log ? exp(lo) : lo;
    const double b = linear && is_log ? exp(hi) : hi;

    for (size_t i = 0; i < n; i++) {
        const double u = ((double) i + 0.5) / (double) n;
        const double at = (1.0 - u) * a + u * b;
        chart[i] = linear && is_log ? log(at) : at;
        stored[i] = is_log && !linear ? exp(at) : at;
    }
}

void basin_map_axis(const struct study *s, enum basin_axis axis, size_t n,
                    double chart[], double stored[])
{
    const struct box w = study_window(s);
    const bool linear = s->scene->window.axes == AXES_LINEAR;

    if (axis == BASIN_V)
        make_axis(n, w.lo.x, w.hi.x, true, linear, chart, stored);
    else
        make_axis(n, w.lo.y, w.hi.y, s->system.axis[1].is_log, linear, chart,
                  stored);
}

static enum status make_grid(struct basin_map *m, size_t columns, size_t rows)
{
    m->columns = columns;
    m->rows = rows;
    m->x = malloc(m->columns * sizeof *m->x);
    m->v = malloc(m->columns * sizeof *m->v);
    m->y = malloc(m->rows * sizeof *m->y);
    m->psi = malloc(m->rows * sizeof *m->psi);
    if (!m->x || !m->v || !m->y || !m->psi)
        return STATUS_NO_MEMORY;
    basin_map_axis(m->study, BASIN_V, m->columns, m->x, m->v);
    basin_map_axis(m->study, BASIN_PSI, m->rows, m->y, m->psi);
    return STATUS_OK;
}

/* ---- regions ------------------------------------------------------------- */

static enum status cut_plane(struct basin_map *m)
{
    const struct study *s = m->study;
    const struct basin_grid grid = { m->x, m->y, m->columns, m->rows };
    enum status status = STATUS_OK;

    if (s->saddle >= 0 && !study_has_manifolds(s))
        return STATUS_NOT_HYPERBOLIC;
    for (int i = 0; i < 2; i++)
        m->along[i] = separatrix_empty(i, s->system.origin);
    for (int i = 0; i < 2 && status == STATUS_OK && s->saddle >= 0; i++)
        status = separatrix_add(&m->along[i], &s->stable[SIDE_LOWER],
                                &s->stable[SIDE_UPPER]);
    if (status == STATUS_OK)
        status = regions_init(&m->regions, &m->along[SEPARATRIX_Y]);
    if (status == STATUS_OK)
        status = basin_init(&m->basin, &m->regions, &grid);
    if (status == STATUS_OK)
        status = fate_label_first(s, &m->regions);
    if (status == STATUS_OK)
        status = basin_seed(&m->basin, &m->regions);
    if (status == STATUS_OK)
        status = fate_label_regions(s, &m->regions);
    return status;
}

/* The window's in this measure. */
static double whole_area(struct box w, struct measure m)
{
    return measure_between(&m, 0, w.lo.x, w.hi.x) *
           measure_between(&m, 1, w.lo.y, w.hi.y);
}

/* The share of the regions with this label. */
static struct quantity share(const struct regions *r, const struct area area[],
                             int8_t label, double whole)
{
    struct area sum = { 0.0, 0.0 };

    for (size_t i = 0; i < r->count; i++) {
        if (r->region[i].label != label)
            continue;
        sum.value += area[i].value;
        sum.error += area[i].error;
    }
    return quantity_of(sum.value / whole,
                       sum.error / whole + TOL_SHARE_ROUNDING);
}

static enum status find_fractions(struct basin_map *m)
{
    const bool is_log = m->study->system.axis[1].is_log;
    const struct box w = study_window(m->study);
    const struct measure chart = { { false, false }, { 0.0, 0.0 } };
    const struct measure linear = { { true, is_log }, { w.hi.x, w.hi.y } };
    const struct regions *r = &m->regions;
    struct crossing *scratch = malloc((r->most + 1) * sizeof *scratch);
    struct area *area = malloc(2 * r->count * sizeof *area);
    const enum status s = scratch && area ? STATUS_OK : STATUS_NO_MEMORY;

    if (s == STATUS_OK) {
        regions_areas(r, w, chart, scratch, area);
        regions_areas(r, w, linear, scratch, area + r->count);
    }
    for (int8_t i = 0; i < FATES && s == STATUS_OK; i++) {
        m->fraction[i].log = share(r, area, i, whole_area(w, chart));
        m->fraction[i].linear =
            share(r, area + r->count, i, whole_area(w, linear));
    }
    free(scratch);
    free(area);
    return s;
}

enum status basin_map_init(struct basin_map *m, const struct study *s,
                           const struct monitor *monitor)
{
    *m = (struct basin_map){ .study = s, .exact = s->scene->exact };
    enum status status = make_grid(m, s->scene->cells[0], s->scene->cells[1]);

    if (status == STATUS_OK)
        status = cut_plane(m);
    if (status == STATUS_OK)
        status = find_fractions(m);
    if (status == STATUS_OK && (m->exact || s->scene->audit > 0))
        status = trap_init(&m->trap, s, monitor);
    if (status != STATUS_OK)
        basin_map_free(m);
    return status;
}

/* ---- rows ---------------------------------------------------------------- */

static enum status follow_cell(const struct basin_map *m, size_t row,
                               size_t column, int8_t *label)
{
    const struct vec2 z = { m->x[column], m->y[row] };
    return trap_label(&m->trap, z, label, NULL);
}

static enum status follow_rows(const struct basin_map *m, size_t first,
                               size_t count, int8_t out[])
{
    const size_t cells = count * m->columns;
    enum status failed = STATUS_OK;

#pragma omp parallel for schedule(dynamic, 64)
    for (size_t i = 0; i < cells; i++) {
        const enum status s =
            follow_cell(m, first + i / m->columns, i % m->columns, &out[i]);
        if (s != STATUS_OK) {
#pragma omp atomic write
            failed = s;
        }
    }
    return failed;
}

enum status basin_map_rows(const struct basin_map *m, size_t first,
                           size_t count, int8_t out[])
{
    if (m->exact)
        return follow_rows(m, first, count, out);
    basin_fill(&m->basin, first, count, out);
    return STATUS_OK;
}

enum status basin_map_raster(const struct basin_map *m, size_t columns,
                             size_t rows, int8_t out[])
{
    struct basin_map raster = { .study = m->study };
    enum status s = make_grid(&raster, columns, rows);

    if (s == STATUS_OK) {
        const struct basin_grid grid = { raster.x, raster.y, columns, rows };
        s = basin_init(&raster.basin, &m->regions, &grid);
    }
    if (s == STATUS_OK)
        basin_fill(&raster.basin, 0, rows, out);
    basin_map_free(&raster);
    return s;
}

/* ---- margins ------------------------------------------------------------- */

static void row_margins(const struct basin_map *m, struct margin_line *l,
                        size_t first, size_t count, double v[])
{
    double error;

    for (size_t j = 0; j < count; j++) {
        margin_find(l, &m->regions, &m->along[SEPARATRIX_Y], m->y[first + j]);
        for (size_t i = 0; i < m->columns; i++)
            v[j * m->columns + i] = margin_at(l, m->x[i], &error);
    }
}

static void column_margins(const struct basin_map *m, struct margin_line *l,
                           size_t first, size_t count, double psi[])
{
    double error;

    for (size_t i = 0; i < m->columns; i++) {
        margin_find(l, &m->regions, &m->along[SEPARATRIX_X], m->x[i]);
        for (size_t j = 0; j < count; j++)
            psi[j * m->columns + i] = margin_at(l, m->y[first + j], &error);
    }
}

enum status basin_map_margins(const struct basin_map *m, size_t first,
                              size_t count, double v[], double psi[])
{
    struct margin_line l;
    const enum status s = margin_init(&l, &m->along[0], &m->along[1]);

    if (s != STATUS_OK)
        return s;
    row_margins(m, &l, first, count, v);
    column_margins(m, &l, first, count, psi);
    margin_free(&l);
    return STATUS_OK;
}

/* ---- audit --------------------------------------------------------------- */

/* splitmix64: Steele, Lea, Flood, OOPSLA 2014. */
static uint64_t next_bits(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* Every eighth cell is moved next to a boundary of its row, if there is one. */
static size_t draw_cell(const struct basin_map *m, size_t number,
                        uint64_t *state)
{
    const size_t row = next_bits(state) % m->rows;
    const uint64_t bits = next_bits(state);
    size_t column = bits % m->columns;

    if (number % 8 == 0 && m->regions.most > 0) {
        const size_t cut = m->basin.cut[row * m->regions.most];
        const size_t beside = cut - (bits >> 63);
        column = beside < m->columns ? beside : column;
    }
    return row * m->columns + column;
}

static enum status check_cell(const struct basin_map *m, size_t cell,
                              bool *agrees)
{
    const size_t row = cell / m->columns, column = cell % m->columns;
    int8_t *line = malloc(m->columns), found = FATE_NONE;

    if (line == NULL)
        return STATUS_NO_MEMORY;
    basin_fill(&m->basin, row, 1, line);
    const enum status s = follow_cell(m, row, column, &found);
    *agrees = line[column] == found;
    free(line);
    return s;
}

static enum status check_cells(struct basin_map *m, const size_t cell[],
                               size_t count, bool wrong[],
                               const struct monitor *monitor)
{
    enum { BLOCK = 64 };
    enum status failed = STATUS_OK;

    for (size_t first = 0; first < count && failed == STATUS_OK;
         first += BLOCK) {
        const size_t end = first + BLOCK < count ? first + BLOCK : count;
#pragma omp parallel for schedule(dynamic)
        for (size_t i = first; i < end; i++) {
            bool agrees = true;
            const enum status s = check_cell(m, cell[i], &agrees);
            wrong[i] = !agrees;
            if (s != STATUS_OK) {
#pragma omp atomic write
                failed = s;
            }
        }
        if (failed == STATUS_OK && monitor_tell(monitor, "audit", end, count))
            failed = STATUS_STOPPED;
    }
    return failed;
}

static void note_wrong(struct basin_audit *a, const size_t cell[], size_t count,
                       const bool wrong[])
{
    a->cells = count;
    for (size_t i = 0; i < count; i++)
        if (wrong[i])
            a->wrong[a->disagreements++] = cell[i];
}

enum status basin_map_audit(struct basin_map *m, size_t cells, uint64_t seed,
                            const struct monitor *monitor)
{
    size_t *cell = malloc((cells + 1) * sizeof *cell);
    bool *wrong = calloc(cells + 1, sizeof *wrong);
    enum status s = STATUS_NO_MEMORY;

    free(m->audit.wrong);
    m->audit = (struct basin_audit){ .cells = 0 };
    m->audit.wrong = malloc((cells + 1) * sizeof *m->audit.wrong);
    if (cell && wrong && m->audit.wrong) {
        for (size_t i = 0; i < cells; i++)
            cell[i] = draw_cell(m, i, &seed);
        s = check_cells(m, cell, cells, wrong, monitor);
    }
    if (s == STATUS_OK)
        note_wrong(&m->audit, cell, cells, wrong);
    free(cell);
    free(wrong);
    return s;
}

void basin_map_free(struct basin_map *m)
{
    basin_free(&m->basin);
    regions_free(&m->regions);
    separatrix_free(&m->along[0]);
    separatrix_free(&m->along[1]);
    free(m->x);
    free(m->y);
    free(m->v);
    free(m->psi);
    free(m->audit.wrong);
    *m = (struct basin_map){ .study = NULL };
}
