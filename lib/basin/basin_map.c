#include "basin_map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "slider.h"
#include "slow_tolerance.h"

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

void basin_map_axis(const struct scene *c, enum basin_axis axis, size_t n,
                    double chart[], double stored[])
{
    const struct box w = scene_box(c);
    const bool linear = c->window.axes == AXES_LINEAR;

    if (axis == BASIN_V)
        make_axis(n, w.lo.x, w.hi.x, true, linear, chart, stored);
    else
        make_axis(n, w.lo.y, w.hi.y, !law_psi_is_log(&c->law), linear, chart,
                  stored);
}

static enum status make_grid(struct basin_map *m, size_t columns, size_t rows)
{
    const struct block *b = &m->slider->block;

    m->columns = columns;
    m->rows = rows;
    m->x = malloc(m->columns * sizeof *m->x);
    m->v = malloc(m->columns * sizeof *m->v);
    m->dx = malloc(m->columns * sizeof *m->dx);
    m->y = malloc(m->rows * sizeof *m->y);
    m->psi = malloc(m->rows * sizeof *m->psi);
    m->dy = malloc(m->rows * sizeof *m->dy);
    if (!m->x || !m->v || !m->dx || !m->y || !m->psi || !m->dy)
        return STATUS_NO_MEMORY;
    basin_map_axis(m->scene, BASIN_V, m->columns, m->x, m->v);
    basin_map_axis(m->scene, BASIN_PSI, m->rows, m->y, m->psi);
    for (size_t i = 0; i < columns; i++)
        m->dx[i] = block_offset(b, m->v[i], 1.0).x;
    for (size_t j = 0; j < rows; j++)
        m->dy[j] = block_offset(b, 1.0, m->psi[j]).y;
    return STATUS_OK;
}

static struct vec2 cell_offset(const struct basin_map *m, size_t cell)
{
    return (struct vec2){ m->dx[cell % m->columns], m->dy[cell / m->columns] };
}

static enum status cut_grid(struct basin_map *m, const struct regions *r)
{
    const struct basin_grid grid = { m->dx, m->dy, m->columns, m->rows };

    return basin_init(&m->basin, r, &grid);
}

/* ---- shares -------------------------------------------------------------- */

/* The window's in this measure. */
static double whole_area(struct box w, struct measure m)
{
    return measure_between(&m, 0, w.lo.x, w.hi.x) *
           measure_between(&m, 1, w.lo.y, w.hi.y);
}

/* The share of the regions with this label.  Those that have none may be its
 * as well. */
static struct quantity share(const struct regions *r, const struct area area[],
                             int8_t label, double whole)
{
    struct area sum = { 0.0, 0.0 };

    for (size_t i = 0; i < r->count; i++) {
        if (r->region[i].label == label)
            sum.value += area[i].value;
        if (r->region[i].label == REGION_UNLABELLED)
            sum.error += area[i].value;
        if (r->region[i].label == label ||
            r->region[i].label == REGION_UNLABELLED)
            sum.error += area[i].error;
    }
    return quantity_of(sum.value / whole,
                       sum.error / whole + TOL_FAR_BELOW * TOL_ROUNDED);
}

/* The window as offsets. */
static struct box window_of(const struct basin_map *m)
{
    const struct scene_window *w = &m->scene->window;
    const struct block *b = &m->slider->block;

    return (struct box){ block_offset(b, w->v[0], w->psi[0]),
                         block_offset(b, w->v[1], w->psi[1]) };
}

static struct measure linear_measure(const struct basin_map *m, struct box w)
{
    const bool is_log = m->slider->plane.system.axis[1].is_log;

    return (struct measure){ { true, is_log }, { w.hi.x, w.hi.y } };
}

static const struct measure chart = { { false, false }, { 0.0, 0.0 } };

static enum status find_fractions(struct basin_map *m)
{
    const struct box w = window_of(m);
    const struct measure linear = linear_measure(m, w);
    const struct regions *r = &m->labels.regions;
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

/* Where cell i of n begins along an axis from lo to hi. */
static double edge_of(double lo, double hi, bool linear, size_t i, size_t n)
{
    const double u = (double) i / (double) n;

    return linear ? hi + log((1.0 - u) * exp(lo - hi) + u)
                  : (1.0 - u) * lo + u * hi;
}

/* The share of each of n cells along an axis in this measure. */
static void parts_of(const struct basin_map *m, const struct measure *measure,
                     int axis, size_t n, double part[])
{
    const struct box w = window_of(m);
    const double lo = axis == 0 ? w.lo.x : w.lo.y;
    const double hi = axis == 0 ? w.hi.x : w.hi.y;
    const bool linear = m->scene->window.axes == AXES_LINEAR &&
                        m->slider->plane.system.axis[axis].is_log;
    const double whole = measure_between(measure, axis, lo, hi);

    for (size_t i = 0; i < n; i++)
        part[i] = measure_between(measure, axis, edge_of(lo, hi, linear, i, n),
                                  edge_of(lo, hi, linear, i + 1, n)) /
                  whole;
}

/* What the cells that were followed have of the window, in this measure. */
static enum status count_shares(const struct basin_map *m,
                                const struct measure *measure, double out[])
{
    double *width = malloc((m->columns + m->rows) * sizeof *width);
    double *height = width + m->columns;

    if (width == NULL)
        return STATUS_NO_MEMORY;
    parts_of(m, measure, 0, m->columns, width);
    parts_of(m, measure, 1, m->rows, height);
    for (size_t i = 0; i < m->columns * m->rows; i++)
        out[m->followed[i]] += width[i % m->columns] * height[i / m->columns];
    free(width);
    return STATUS_OK;
}

/* The bar of a counted share reaches to that of the separatrix. */
static struct quantity counted(double share, struct quantity by_area)
{
    return quantity_of(share, fabs(share - by_area.value) + by_area.error);
}

static enum status count_fractions(struct basin_map *m)
{
    const struct measure linear = linear_measure(m, window_of(m));
    double part[2][FATES] = { { 0.0 } };
    enum status s = count_shares(m, &chart, part[0]);

    if (s == STATUS_OK)
        s = count_shares(m, &linear, part[1]);
    for (int i = 0; i < FATES && s == STATUS_OK; i++) {
        struct basin_fraction *f = &m->fraction[i];
        *f = (struct basin_fraction){ counted(part[0][i], f->log),
                                      counted(part[1][i], f->linear) };
    }
    return s;
}

/* ---- rows ---------------------------------------------------------------- */

/* The cells of some rows that no region tells, asked one by one. */
static enum status settle(const struct basin_map *m, size_t first, size_t count,
                          int8_t out[])
{
    const size_t cells = count * m->columns;
    enum status failed = STATUS_OK;

#pragma omp parallel for schedule(dynamic, 64) reduction(max : failed)
    for (size_t i = 0; i < cells; i++) {
        struct fate_told label;
        if (out[i] != REGION_UNLABELLED)
            continue;
        const enum status s = labels_find(
            &m->labels, cell_offset(m, first * m->columns + i), NULL, &label);
        out[i] = label.fate;
        failed = s > failed ? s : failed;
    }
    return failed;
}

static enum status label_rows(const struct basin_map *m, size_t first,
                              size_t count, int8_t out[])
{
    basin_fill(&m->basin, first, count, out);
    return settle(m, first, count, out);
}

enum status basin_map_rows(const struct basin_map *m, size_t first,
                           size_t count, int8_t out[])
{
    if (!m->exact)
        return label_rows(m, first, count, out);
    memcpy(out, m->followed + first * m->columns, count * m->columns);
    return STATUS_OK;
}

enum status basin_map_raster(const struct basin_map *m, size_t columns,
                             size_t rows, int8_t out[])
{
    struct basin_map raster = { .slider = m->slider,
                                .scene = m->scene,
                                .labels = m->labels };
    enum status s = make_grid(&raster, columns, rows);

    if (s == STATUS_OK)
        s = cut_grid(&raster, &m->labels.regions);
    if (s == STATUS_OK)
        s = label_rows(&raster, 0, rows, out);
    raster.labels = (struct labels){ .slider = NULL };
    basin_map_free(&raster);
    return s;
}

/* ---- margins ------------------------------------------------------------- */

static void row_margins(const struct basin_map *m, struct margin_line *l,
                        size_t first, size_t count, double v[])
{
    double error;

    for (size_t j = 0; j < count; j++) {
        margin_find(l, &m->labels.regions, &m->labels.along[SEPARATRIX_Y],
                    m->dy[first + j]);
        for (size_t i = 0; i < m->columns; i++)
            v[j * m->columns + i] = margin_at(l, m->dx[i], &error);
    }
}

static void column_margins(const struct basin_map *m, struct margin_line *l,
                           size_t first, size_t count, double psi[])
{
    double error;

    for (size_t i = 0; i < m->columns; i++) {
        margin_find(l, &m->labels.regions, &m->labels.along[SEPARATRIX_X],
                    m->dx[i]);
        for (size_t j = 0; j < count; j++)
            psi[j * m->columns + i] = margin_at(l, m->dy[first + j], &error);
    }
}

enum status basin_map_margins(const struct basin_map *m, size_t first,
                              size_t count, double v[], double psi[])
{
    struct margin_line l;
    const enum status s =
        margin_init(&l, &m->labels.along[0], &m->labels.along[1]);

    if (s != STATUS_OK)
        return s;
    row_margins(m, &l, first, count, v);
    column_margins(m, &l, first, count, psi);
    margin_free(&l);
    return STATUS_OK;
}

enum status basin_map_raster_margins(const struct basin_map *m, size_t columns,
                                     size_t rows, double v[], double psi[])
{
    struct basin_map raster = { .slider = m->slider,
                                .scene = m->scene,
                                .labels = m->labels };
    enum status s = make_grid(&raster, columns, rows);

    if (s == STATUS_OK)
        s = basin_map_margins(&raster, 0, rows, v, psi);
    raster.labels = (struct labels){ .slider = NULL };
    basin_map_free(&raster);
    return s;
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
    const size_t most = m->labels.regions.most;
    size_t column = bits % m->columns;

    if (number % 8 == 0 && most > 0) {
        const size_t cut = m->basin.cut[row * most];
        const size_t beside = cut - (bits >> 63);
        column = beside < m->columns ? beside : column;
    }
    return row * m->columns + column;
}

/* The label of a cell by its orbit and by its side; where no side is certain,
 * its orbit tells nothing either. */
static enum status compare(const struct basin_map *m, size_t cell,
                           int8_t *by_orbit, int8_t *by_side)
{
    const struct vec2 z = cell_offset(m, cell);
    struct fate_told label;
    enum status s = labels_find(&m->labels, z, NULL, &label);

    *by_side = *by_orbit = label.fate;
    return s != STATUS_OK || label.fate == FATE_UNDECIDED
               ? s
               : trap_label(&m->trap, z, by_orbit, NULL);
}

/* Of the cells cell[count], or of the first `count` where that is NULL; their
 * labels by orbit into label[], if that is not NULL. */
static enum status check_cells(const struct basin_map *m, const size_t cell[],
                               size_t count, int8_t label[], bool wrong[],
                               const struct monitor *monitor)
{
    enum { BLOCK = 64 };
    enum status failed = STATUS_OK;

    for (size_t first = 0; first < count && failed == STATUS_OK;
         first += BLOCK) {
        const size_t end = first + BLOCK < count ? first + BLOCK : count;
#pragma omp parallel for schedule(dynamic) reduction(max : failed)
        for (size_t i = first; i < end; i++) {
            int8_t by_orbit = FATE_NONE, by_side = FATE_NONE;
            const enum status s =
                compare(m, cell ? cell[i] : i, &by_orbit, &by_side);
            wrong[i] = by_orbit != by_side;
            if (label)
                label[i] = by_orbit;
            failed = s > failed ? s : failed;
        }
        if (failed == STATUS_OK && monitor_tell(monitor, "audit", end, count))
            failed = STATUS_STOPPED;
    }
    return failed;
}

static enum status note_wrong(struct basin_audit *a, const size_t cell[],
                              size_t count, const bool wrong[])
{
    size_t disagreements = 0;

    for (size_t i = 0; i < count; i++)
        disagreements += wrong[i];
    free(a->wrong);
    *a = (struct basin_audit){ .cells = count };
    a->wrong = malloc((disagreements + 1) * sizeof *a->wrong);
    if (a->wrong == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < count; i++)
        if (wrong[i])
            a->wrong[a->disagreements++] = cell ? cell[i] : i;
    return STATUS_OK;
}

enum status basin_map_audit(struct basin_map *m, size_t cells, uint64_t seed,
                            const struct monitor *monitor)
{
    size_t *cell = calloc(cells + 1, sizeof *cell);
    bool *wrong = calloc(cells + 1, sizeof *wrong);
    enum status s = STATUS_NO_MEMORY;

    if (cell && wrong) {
        for (size_t i = 0; i < cells; i++)
            cell[i] = draw_cell(m, i, &seed);
        s = check_cells(m, cell, cells, NULL, wrong, monitor);
    }
    if (s == STATUS_OK)
        s = note_wrong(&m->audit, cell, cells, wrong);
    free(cell);
    free(wrong);
    return s;
}

/* ---- the map ------------------------------------------------------------- */

static enum status follow_all(struct basin_map *m,
                              const struct monitor *monitor)
{
    const size_t cells = m->columns * m->rows;
    bool *wrong = calloc(cells, sizeof *wrong);
    enum status s = STATUS_NO_MEMORY;

    m->followed = malloc(cells);
    if (wrong && m->followed)
        s = check_cells(m, NULL, cells, m->followed, wrong, monitor);
    if (s == STATUS_OK)
        s = note_wrong(&m->audit, NULL, cells, wrong);
    free(wrong);
    return s == STATUS_OK ? count_fractions(m) : s;
}

enum status basin_map_init(struct basin_map *m, const struct slider *s,
                           const struct scene *c, const struct monitor *monitor)
{
    *m = (struct basin_map){ .slider = s, .scene = c, .exact = c->exact };
    enum status status = slider_saddle(s) >= 0 && !slider_has_manifolds(s)
                             ? STATUS_NOT_HYPERBOLIC
                             : STATUS_OK;

    trap_init(&m->trap, s);
    if (status == STATUS_OK)
        status = make_grid(m, c->cells[0], c->cells[1]);
    if (status == STATUS_OK)
        status = labels_init(&m->labels, s, c->rtol, monitor);
    if (status == STATUS_OK)
        status = cut_grid(m, &m->labels.regions);
    if (status == STATUS_OK)
        status = find_fractions(m);
    if (status == STATUS_OK && m->exact)
        status = follow_all(m, monitor);
    if (status != STATUS_OK)
        basin_map_free(m);
    return status;
}

void basin_map_free(struct basin_map *m)
{
    basin_free(&m->basin);
    labels_free(&m->labels);
    free(m->x);
    free(m->y);
    free(m->dx);
    free(m->dy);
    free(m->followed);
    free(m->v);
    free(m->psi);
    free(m->audit.wrong);
    *m = (struct basin_map){ .slider = NULL };
}
