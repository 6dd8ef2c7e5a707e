/* What a plane study says of its basins. */
#include <stdlib.h>

#include "plane_map.h"
#include "plane_margin.h"
#include "plane_results.h"
#include "plane_table.h"

#define ASKED(product) ((uint64_t) 1 << PRODUCT_##product)

RESULT_VIEW(view_shares, plane_study, s->basin.share, s->basin.shares)
RESULT_VIEW(view_boundary, plane_study, s->basin.boundary, s->basin.boundaries)
RESULT_VIEW(view_audit, plane_study, &s->basin, 1)

static const struct record_type record_share =
    RECORD(plane_share, "share", "shares of the window",
           FIELD(plane_share, TEXT, attractor, "1", "whereto"),
           FIELD(plane_share, QUANTITY, fraction, "1",
                 "of the window, by area as it is drawn"));

static const struct record_type record_boundary = RECORD(
    plane_boundary, "boundary", "curves between basins",
    FIELD(plane_boundary, COUNT, manifold, "1", "number among the manifolds"),
    FIELD(plane_boundary, TEXT, of, "1", "its saddle, or the cycle itself"));

static const struct record_type record_audit = RECORD(
    plane_basin, "audit", "map against orbits",
    FIELD(plane_basin, COUNT, cells, "1", "states followed forward in time"),
    FIELD(plane_basin, COUNT, disagreements, "1", "those that go elsewhere"));

const struct result plane_basin_results[] = {
    { .path = "/shares",
      .name = "shares",
      .title = "shares of the window",
      .type = &record_share,
      .shape = RESULT_COLUMNS,
      .needs = ASKED(BASINS),
      .view = view_shares },
    { .path = "/boundary",
      .name = "boundary",
      .title = "boundaries of basins",
      .type = &record_boundary,
      .shape = RESULT_COLUMNS,
      .needs = ASKED(BASINS),
      .view = view_boundary },
    { .path = "/basin",
      .name = "audit",
      .title = "audit",
      .member = "audit_*",
      .type = &record_audit,
      .shape = RESULT_ATTRIBUTES,
      .needs = ASKED(BASINS),
      .view = view_audit },
    { .path = NULL },
};

/* ---- the map, along the states' own names -------------------------------- */

static enum status view_cells(const void *run, size_t axis,
                              struct result_view *out)
{
    const struct plane_study *s = run;
    const size_t n = s->scene->cells[axis];
    double *at = malloc(n * sizeof *at);

    if (at == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < n; i++)
        at[i] = plane_map_cell(s, (int) axis, i, n, false);
    out->owned = at;
    return result_lend(out, at, n);
}

static enum status view_columns(const void *run, size_t k,
                                struct result_view *out)
{
    (void) k;
    return view_cells(run, 0, out);
}

static enum status view_rows(const void *run, size_t k, struct result_view *out)
{
    (void) k;
    return view_cells(run, 1, out);
}

static enum status label_rows(const void *run, size_t first, size_t count,
                              const struct monitor *monitor, void *records)
{
    const struct plane_study *s = run;

    (void) monitor;
    return plane_map_fill(s, s->scene->cells[0], s->scene->cells[1], first,
                          count, records);
}

static enum status margin_rows(const void *run, size_t first, size_t count,
                               const struct monitor *monitor, void *records)
{
    const struct plane_study *s = run;

    (void) monitor;
    return plane_margin_fill(s, s->scene->cells[0], s->scene->cells[1], first,
                             count, records);
}

/* "margin_x": along rows; and "margin_y". */
static void add_margins(const struct plane_study *s, struct plane_table *t)
{
    const size_t first = t->fields;

    for (int i = 0; i < 2; i++) {
        const struct planar_axis *a = &s->system[0].axis[i];
        plane_table_field(
            t, plane_table_keep(t, "margin_%s", a->name), RECORD_REAL,
            offsetof(struct plane_margins, by) + (size_t) i * sizeof(double),
            plane_table_keep(t, "smallest change of %s%s with another fate",
                             a->is_log ? "ln " : "", a->name));
    }
    struct result *r = plane_table_result(
        t,
        plane_table_type(t, first, "margin", "how far another fate is",
                         sizeof(struct plane_margins)),
        ASKED(MARGIN));
    r->path = "/basin";
    r->shape = RESULT_LAYERS;
    r->axis = plane_table_keep(t, "%s, %s", s->system[0].axis[1].name,
                               s->system[0].axis[0].name);
    r->rows = margin_rows;
}

void plane_results_map(const struct plane_study *s, struct plane_table *t)
{
    const char *name[] = { s->system[0].axis[0].name,
                           s->system[0].axis[1].name };
    size_t first;
    struct result *r;

    for (size_t i = 2; i-- > 0;) {
        first = t->fields;
        plane_table_field(t, name[i], RECORD_REAL, 0, name[i]);
        r = plane_table_result(
            t, plane_table_type(t, first, name[i], "cells", sizeof(double)),
            ASKED(BASINS));
        r->path = "/basin";
        r->axis = name[i];
        r->view = i == 0 ? view_columns : view_rows;
    }
    first = t->fields;
    plane_table_field(t, "label", RECORD_CODE, 0, "whereto the state goes")
        ->codes = s->basin.name;
    r = plane_table_result(
        t, plane_table_type(t, first, "label", "a map of attractors", 1),
        ASKED(BASINS));
    r->path = "/basin";
    r->shape = RESULT_LAYERS;
    r->axis = plane_table_keep(t, "%s, %s", name[1], name[0]);
    r->rows = label_rows;
    add_margins(s, t);
}
