#include "picture_field.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "eigen_frame.h"
#include "fate.h"
#include "sheet.h"
#include "symbols.h"

#define AT(name) offsetof(struct cell, name)
static const struct {
    const char *panel, *what;
    bool is_log;
    bool to_arrest; /* of those that slide there is none */
    size_t at;      /* in struct cell */
} look[CELL_FIELDS] = {
    [CELL_SLIP] = { "_slip", "slip to arrest", true, true, AT(slip) },
    [CELL_TIME] = { "_time", "time to arrest", true, true, AT(time) },
    [CELL_MU_MEAN] = { "_mu_mean", "mean friction coefficient", false, true,
                       AT(mu_mean) },
    [CELL_V_PEAK] = { "_v_peak", "largest slip rate", true, false, AT(v_peak) },
    [CELL_MU_PEAK] = { "_mu_peak", "largest friction coefficient", false, false,
                       AT(mu_peak) },
};

/* State by state. */
static enum status fill_eigen(struct picture_raster *r, const struct study *s,
                              const struct eigen_view *view,
                              const struct monitor *monitor)
{
    const size_t n = r->columns * r->rows;
    struct vec2 *z = eigen_view_states(view, r->columns, r->rows);
    int8_t *label = malloc(n);
    enum status status =
        z && label ? eigen_view_labels(s, z, n, label) : STATUS_NO_MEMORY;

    for (size_t i = 0; i < n && status == STATUS_OK; i++)
        z[i] = vec2_add(z[i], s->slider.plane.system.origin);
    if (status == STATUS_OK)
        status = fields_states(&s->fields, z, label, n, monitor, r->cell);
    free(z);
    free(label);
    return status;
}

enum status picture_raster_find(struct picture_raster *r, const struct study *s,
                                const struct eigen_view *view,
                                const struct monitor *monitor)
{
    enum { COLUMNS = 144, ROWS = 96 };
    const struct basin_map *m = &s->basins;

    r->columns = m->columns < COLUMNS ? m->columns : COLUMNS;
    r->rows = m->rows < ROWS ? m->rows : ROWS;
    r->cell = malloc(r->columns * r->rows * sizeof *r->cell);
    if (r->cell == NULL)
        return STATUS_NO_MEMORY;
    return view ? fill_eigen(r, s, view, monitor)
                : fields_raster(&s->fields, r->columns, r->rows, monitor,
                                r->cell);
}

void picture_raster_free(struct picture_raster *r)
{
    free(r->cell);
    r->cell = NULL;
}

static bool comes_to_rest(const struct cell *c)
{
    return c->exit_reason == FATE_CREEP || c->exit_reason == FATE_REST_FINITE ||
           c->exit_reason == FATE_REST_ASYMPTOTIC;
}

void picture_add_field(const struct picture_raster *r, enum cell_field field,
                       const struct unit_system *units, struct figure *f)
{
    const char *own = cell_fields[1 + 2 * field].unit;
    const struct sheet_label label = sheet_label(units, look[field].what, own);
    const size_t n = r->columns * r->rows;
    const bool to_arrest = look[field].to_arrest;
    double *value = malloc(n * sizeof *value);

    if (value == NULL) {
        f->status = STATUS_NO_MEMORY;
        return;
    }
    for (size_t i = 0; i < n; i++)
        if (to_arrest && !comes_to_rest(&r->cell[i]))
            value[i] = (double) NAN;
        else
            memcpy(&value[i], (const char *) &r->cell[i] + look[field].at,
                   sizeof *value);
    for (size_t i = 0; i < n; i++)
        value[i] = unit_value(units, unit_find(own), value[i]);
    figure_add_map(
        f, &(struct figure_map){
               .value = value,
               .nx = r->columns,
               .ny = r->rows,
               .scale = { .label = label.text, .is_log = look[field].is_log },
               .contours = true,
               .missing =
                   to_arrest ? "does not come to rest" : "does not exist" });
    free(value);
}

const char *picture_field_panel(enum cell_field field)
{
    return look[field].panel;
}

/* ---- margins ------------------------------------------------------------- */

enum { MARGIN_COLUMNS = 288, MARGIN_ROWS = 192 };

static void draw_margin(const struct study *s, enum basin_axis axis,
                        double value[], struct figure *f)
{
    const size_t n = (size_t) MARGIN_COLUMNS * MARGIN_ROWS;
    const bool si = s->scene->units == UNITS_SI;
    const bool shift =
        axis == BASIN_PSI && !si && law_psi_is_log(&s->scene->law);
    const char *const what[2][2] = {
        { "factor on " S_V " to another fate",
          "factor on " S_BIG_V " to another fate" },
        { shift ? "shift of " S_PSI " to another fate"
                : "factor on " S_PSI " to another fate",
          "factor on " S_PHI " to another fate" },
    };

    for (size_t i = 0; i < n; i++)
        if (!isfinite(value[i]))
            value[i] = (double) NAN;
        else
            value[i] = shift ? fabs(value[i]) : exp(fabs(value[i]));
    figure_add_map(f, &(struct figure_map){ .value = value,
                                            .nx = MARGIN_COLUMNS,
                                            .ny = MARGIN_ROWS,
                                            .scale = { .label = what[axis][si],
                                                       .is_log = !shift },
                                            .contours = true,
                                            .missing = "no other fate there" });
}

/* Along v, then along psi. */
static enum status find_margins(const struct study *s,
                                const struct eigen_view *view, double value[])
{
    const size_t n = (size_t) MARGIN_COLUMNS * MARGIN_ROWS;

    if (view == NULL)
        return basin_map_raster_margins(&s->basins, MARGIN_COLUMNS, MARGIN_ROWS,
                                        value, value + n);
    struct vec2 *z = eigen_view_states(view, MARGIN_COLUMNS, MARGIN_ROWS);
    const enum status status =
        z ? margin_states(&s->basins.labels.regions, s->basins.labels.along, z,
                          n, value, value + n)
          : STATUS_NO_MEMORY;
    free(z);
    return status;
}

void picture_add_margin(const struct study *s, const struct eigen_view *view,
                        enum basin_axis axis, struct figure *f)
{
    const size_t n = (size_t) MARGIN_COLUMNS * MARGIN_ROWS;
    double *value = malloc(2 * n * sizeof *value);

    f->status = value ? find_margins(s, view, value) : STATUS_NO_MEMORY;
    if (f->status == STATUS_OK)
        draw_margin(s, axis, axis == BASIN_V ? value : value + n, f);
    free(value);
}

const char *picture_margin_panel(enum basin_axis axis)
{
    return axis == BASIN_V ? "_margin_v" : "_margin_psi";
}

/* ---- the axes of Fig 11(a) ----------------------------------------------- */

struct eigen_view eigen_view_of(const struct study *s)
{
    const struct mat2 P = eigen_basis(phase_plane_saddle(&s->slider.plane));
    struct eigen_view e = { { 1.0, 1.0, P.yx / P.xx, P.yy / P.xy }, 1.0 };

    for (int i = 0; i < SIDES; i++)
        if (s->stable[i].curve.count > 0)
            e.reach = fmax(e.reach, fabs(s->stable[i].limit.x));
    e.reach *= 1.5;
    return e;
}

struct vec2 *eigen_view_states(const struct eigen_view *e, size_t columns,
                               size_t rows)
{
    const struct box w = { { -e->reach, -e->reach }, { e->reach, e->reach } };
    struct vec2 *z = malloc(columns * rows * sizeof *z);

    for (size_t i = 0; z && i < columns * rows; i++) {
        const struct vec2 unit = {
            ((double) (i % columns) + 0.5) / (double) columns,
            ((double) (i / columns) + 0.5) / (double) rows
        };
        z[i] = eigen_point(e->basis, window_mix(w, unit));
    }
    return z;
}

enum status eigen_view_labels(const struct study *s, const struct vec2 z[],
                              size_t n, int8_t label[])
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < n && status == STATUS_OK; i++) {
        struct fate_told told = { .fate = FATE_UNDECIDED };
        status = labels_find(&s->basins.labels, z[i], NULL, &told);
        label[i] = told.fate;
    }
    return status;
}
