/* What a plane study says of its basins. */
#include <stdlib.h>

#include "plane_basin.h"
#include "plane_results.h"
#include "plane_table.h"

#define ASKED(product) ((uint64_t) 1 << PRODUCT_##product)

RESULT_VIEW(view_shares, plane_study, s->basin.share, s->basin.shares)
RESULT_VIEW(view_boundary, plane_study, s->basin.boundary, s->basin.boundaries)
RESULT_VIEW(view_audit, plane_study, &s->basin, 1)

static enum status view_cells(const void *run, size_t axis,
                              struct result_view *out)
{
    const struct plane_study *s = run;
    const size_t n = s->scene->cells[axis];
    double *at = malloc(n * sizeof *at);

    if (at == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < n; i++)
        at[i] = plane_basin_cell(s, (int) axis, i, n, false);
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
    return plane_basin_fill(s, s->scene->cells[0], s->scene->cells[1], first,
                            count, records);
}

static void add_grid(const struct plane_study *s, struct plane_table *t)
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
}

#define BASIN(member) offsetof(struct plane_basin, member)

void plane_results_basins(const struct plane_study *s, struct plane_table *t)
{
    size_t first = t->fields;
    struct result *r;

    plane_table_field(t, "attractor", RECORD_TEXT,
                      offsetof(struct plane_share, attractor), "whereto");
    plane_table_field(t, "fraction", RECORD_QUANTITY,
                      offsetof(struct plane_share, fraction),
                      "of the window, by area as it is drawn");
    r = plane_table_result(t,
                           plane_table_type(t, first, "share",
                                            "shares of the window",
                                            sizeof(struct plane_share)),
                           ASKED(BASINS));
    r->name = "shares";
    r->path = "/shares";
    r->title = "shares of the window";
    r->view = view_shares;
    first = t->fields;
    plane_table_field(t, "manifold", RECORD_COUNT,
                      offsetof(struct plane_boundary, manifold),
                      "number among the manifolds");
    plane_table_field(t, "of", RECORD_TEXT, offsetof(struct plane_boundary, of),
                      "its saddle, or the cycle itself");
    r = plane_table_result(t,
                           plane_table_type(t, first, "boundary",
                                            "curves between basins",
                                            sizeof(struct plane_boundary)),
                           ASKED(BASINS));
    r->name = "boundary";
    r->path = "/boundary";
    r->title = "boundaries of basins";
    r->view = view_boundary;
    first = t->fields;
    plane_table_field(t, "cells", RECORD_COUNT, BASIN(audited),
                      "states followed forward in time");
    plane_table_field(t, "disagreements", RECORD_COUNT, BASIN(disagreements),
                      "those that go elsewhere");
    r = plane_table_result(t,
                           plane_table_type(t, first, "audit",
                                            "map against orbits",
                                            sizeof(struct plane_basin)),
                           ASKED(BASINS));
    r->name = "audit";
    r->title = "audit";
    r->path = "/basin";
    r->member = "audit_*";
    r->shape = RESULT_ATTRIBUTES;
    r->view = view_audit;
    add_grid(s, t);
}
