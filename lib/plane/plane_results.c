/* Names of states and numbers of saddles are known at run time only: fields,
 * types and paths are made from patterns, the tables then go as any others. */
#include "plane_results.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plane_numbers.h"
#include "plane_proof.h"
#include "plane_rows.h"
#include "plane_table.h"

#define ASKED(product) ((uint64_t) 1 << PRODUCT_##product)

/* ---- equilibria ---------------------------------------------------------- */

RESULT_VIEW(view_none, plane_study, s->rest, 0)
RESULT_VIEW(view_rests, plane_study, s->rest, s->listed)
RESULT_VIEW(view_rest, plane_study, &s->rest[k], 1)
RESULT_VIEW(view_lambda, plane_study, s->rest[k].lambda, 2)
RESULT_VIEW(view_no_box, plane_study, s->undecided, 0)
RESULT_VIEW(view_box_x, plane_study, s->undecided[k].range[0], 2)
RESULT_VIEW(view_box_y, plane_study, s->undecided[k].range[1], 2)

RESULT_COUNT(count_rests, plane_study, s->listed)
RESULT_COUNT(count_boxes, plane_study, s->undecided_count)
RESULT_COUNT(count_of_complete, plane_study, !s->complete)

static const char fewer[] = "there are fewer equilibria";

#define REST(member) offsetof(struct plane_rest, member)

static void add_type(struct plane_table *t)
{
    plane_table_field(t, "name", RECORD_TEXT, REST(name), "its name");
    plane_table_field(t, "type", RECORD_CODE, REST(type), "its type")->codes =
        plane_type_names;
}

/* Scalars of each. */
static void add_rest(struct plane_table *t, const struct record_type *type,
                     const char *name)
{
    struct result *r = plane_table_result(t, type, 0);

    r->name = name;
    r->shape = RESULT_SCALARS;
    r->fewer = fewer;
    r->count = count_rests;
    r->view = view_rest;
}

static void add_rests(const struct plane_study *s, struct plane_table *t)
{
    size_t first = t->fields;
    struct result *r;

    add_type(t);
    const struct record_type *brief = plane_table_type(
        t, first, "equilibrium", "an equilibrium", sizeof *s->rest);
    r = plane_table_result(t, brief, 0);
    r->name = "equilibria";
    r->view = view_none;
    add_rest(t, brief, "equilibria[K]");
    first = t->fields;
    plane_table_states(s, t, "*", RECORD_QUANTITY, REST(state));
    add_rest(t, plane_table_type(t, first, "state", "where", sizeof *s->rest),
             "equilibria[K].state");
    first = t->fields;
    plane_table_field(t, "re", RECORD_QUANTITY,
                      offsetof(struct plane_lambda, re), "real part");
    plane_table_field(t, "im", RECORD_QUANTITY,
                      offsetof(struct plane_lambda, im), "imaginary part");
    r = plane_table_result(t,
                           plane_table_type(t, first, "eigenvalue",
                                            "of the Jacobian",
                                            sizeof(struct plane_lambda)),
                           0);
    r->name = "equilibria[K].eigenvalues";
    r->alone = 2;
    r->fewer = fewer;
    r->count = count_rests;
    r->view = view_lambda;
}

/* The parts of both eigenvalues, from the offset `at` on. */
static void add_parts(struct plane_table *t, size_t at)
{
    static const char *const part[] = { "re_0", "im_0", "re_1", "im_1" };

    for (size_t i = 0; i < 4; i++)
        plane_table_field(t, part[i], RECORD_QUANTITY,
                          at + i * sizeof(struct quantity),
                          "part of an eigenvalue");
}

/* The same as columns. */
static void add_rest_columns(const struct plane_study *s, struct plane_table *t)
{
    const size_t first = t->fields;

    add_type(t);
    plane_table_states(s, t, "*", RECORD_QUANTITY, REST(state));
    add_parts(t, REST(lambda));
    struct result *r =
        plane_table_result(t,
                           plane_table_type(t, first, "equilibrium",
                                            "an equilibrium", sizeof *s->rest),
                           0);
    r->path = "/equilibria";
    r->title = "equilibria";
    r->view = view_rests;
}

static void add_boxes(const struct plane_study *s, struct plane_table *t)
{
    static enum status (*const view[])(const void *, size_t,
                                       struct result_view *) = { view_box_x,
                                                                 view_box_y };
    for (size_t i = 0; i < 2; i++) {
        const size_t first = t->fields;
        const char *name = s->system[0].axis[i].name;
        plane_table_field(t, name, RECORD_REAL, 0, name);
        const struct record_type *type = plane_table_type(
            t, first, "undecided", "where others may be", sizeof(double));
        struct result *r;
        if (i == 0) {
            r = plane_table_result(t, type, 0);
            r->name = "undecided";
            r->count = count_of_complete;
            r->view = view_no_box;
        }
        r = plane_table_result(t, type, 0);
        r->name = plane_table_keep(t, "undecided[K].%s", name);
        r->path = plane_table_keep(t, "/undecided_K/%s", name);
        r->count = count_boxes;
        r->view = view[i];
    }
}

/* ---- sensitivities ------------------------------------------------------- */

static size_t parameters_of(const struct plane_study *s)
{
    return (size_t) s->scene->system->parameters;
}

/* Those of one equilibrium, of all parameters; and of all equilibria. */
RESULT_VIEW(view_slope, plane_study, s->slope + k * parameters_of(s), 1)
RESULT_VIEW(view_slopes, plane_study, s->slope, s->listed)

/* By each parameter one result in JSON, one in files. */
static void add_slopes(const struct plane_study *s, struct plane_table *t)
{
    const size_t each = parameters_of(s);

    for (size_t p = 0; p < each; p++) {
        const char *name = s->scene->system->parameter[p].name;
        const size_t at = p * sizeof *s->slope, first = t->fields;
        plane_table_states(s, t, "*", RECORD_QUANTITY, at);
        add_parts(t, at + 2 * sizeof(struct quantity));
        const struct record_type *type =
            plane_table_type(t, first, "sensitivity",
                             plane_table_keep(t, "derivatives by %s", name),
                             each * sizeof *s->slope);
        struct result *r = plane_table_result(t, type, ASKED(SENSITIVITIES));
        r->name = plane_table_keep(t, "equilibria[K].sensitivities.%s", name);
        r->shape = RESULT_SCALARS;
        r->fewer = fewer;
        r->count = count_rests;
        r->view = view_slope;
        r = plane_table_result(t, type, ASKED(SENSITIVITIES));
        r->path = plane_table_keep(t, "/sensitivities/%s", name);
        r->title = plane_table_keep(t, "derivatives by %s", name);
        r->view = view_slopes;
    }
}

/* ---- manifolds ----------------------------------------------------------- */

static const char *const kind_names[] = { "stable", "unstable", NULL };

RESULT_VIEW(view_branches, plane_study, s->branch, s->listed_branches)
RESULT_VIEW(view_cycles, plane_study, s->cycle, s->cycles)

static const struct record_field manifold_fields[] = {
    FIELD(plane_branch, COUNT, saddle, "1", "number of the saddle"),
    FIELD_CODE(plane_branch, kind, kind_names, "stable or unstable"),
    FIELD(plane_branch, COUNT, branch, "1",
          "0: the one on which the first state grows at the saddle (the second "
          "where that stays), 1"),
    FIELD_CODE(plane_branch, end, plane_end_names, "where it ends"),
    FIELD(plane_branch, COUNT, to, "1", "number of that equilibrium or cycle"),
    FIELD(plane_branch, QUANTITY, length, "1",
          "in the chart, to its end or where it leaves the window"),
};
static const struct record_type record_cycle = RECORD(
    plane_cycle, "cycle", "closed orbits that curves wind on to",
    FIELD(plane_cycle, TEXT, name, "1", "its name"),
    FIELD_CODE(plane_cycle, type, plane_cycle_types, "whether it attracts"));

static const struct result manifold_results[] = {
    { .path = "/cycles",
      .name = "cycles",
      .title = "closed orbits that were met",
      .type = &record_cycle,
      .shape = RESULT_COLUMNS,
      .needs = ASKED(MANIFOLDS) | ASKED(BASINS),
      .view = view_cycles },
    { .path = NULL },
};

static const struct record_field proved_fields[] = {
    FIELD_CODE(plane_branch, end_proved, plane_proved_names,
               "whether its end is proved"),
    FIELD(plane_branch, TEXT, not_proved, "1", "why it is not"),
};

static void add_fields(struct plane_table *t, const struct record_field f[],
                       size_t n)
{
    memcpy(&t->field[t->fields], f, n * sizeof *f);
    t->fields += n;
}

/* With where they leave the window, by the states' names. */
static void add_manifolds(const struct plane_study *s, struct plane_table *t)
{
    const size_t first = t->fields;

    add_fields(t, manifold_fields,
               sizeof manifold_fields / sizeof *manifold_fields);
    plane_table_states(s, t, "leaves_*", RECORD_QUANTITY,
                       offsetof(struct plane_branch, leaves));
    if (s->scene->proved)
        add_fields(t, proved_fields,
                   sizeof proved_fields / sizeof *proved_fields);
    struct result *r = plane_table_result(
        t,
        plane_table_type(t, first, "manifold", "half of an invariant manifold",
                         sizeof *s->branch),
        ASKED(MANIFOLDS));
    r->path = "/manifolds";
    r->name = "manifolds";
    r->title = "manifolds of the saddles";
    r->alone = 4 * PLANE_SADDLES_ALONE;
    r->fewer = "there are fewer saddles";
    r->view = view_branches;
}

RESULT_COUNT(count_branches, plane_study, s->listed_branches)

ROWS_VIEW(view_branch, plane_study, plane_rows_branch(s, &s->branch[k], &r))

/* "/manifold/{saddle_0/stable_0,saddle_0/stable_1,...}" */
static const char *branch_paths(const struct plane_study *s,
                                struct plane_table *t)
{
    enum { EACH = 48 };
    char *end = t->paths = malloc(EACH * (s->listed_branches + 1));

    if (end == NULL)
        return NULL;
    if (s->listed_branches == 0)
        return strcpy(t->paths, "/manifold/saddle_0/stable_0");
    end += sprintf(end, "/manifold/{");
    for (size_t i = 0; i < s->listed_branches; i++)
        end += sprintf(end, "%ssaddle_%d/%s_%d", i ? "," : "",
                       (int) s->branch[i].saddle, kind_names[s->branch[i].kind],
                       (int) s->branch[i].branch);
    sprintf(end, "}");
    return t->paths;
}

#define POINT(member) offsetof(struct plane_point, member)

static void add_branches(const struct plane_study *s, struct plane_table *t,
                         const char *paths)
{
    const size_t first = t->fields;

    plane_table_field(t, "arc", RECORD_REAL, POINT(arc),
                      "arc length in the chart, from the saddle");
    plane_table_states(s, t, "*", RECORD_REAL, POINT(at));
    plane_table_field(t, "slope", RECORD_REAL, POINT(slope),
                      "d second/d first, in the chart; missing where vertical");
    plane_table_field(t, "error", RECORD_REAL, POINT(error),
                      "bound on the distance to the exact curve, in the chart");
    struct result *r = plane_table_result(
        t,
        plane_table_type(t, first, "branch", "points of a manifold",
                         sizeof(struct plane_point)),
        ASKED(MANIFOLDS));
    r->path = paths;
    r->axis = "arc";
    r->count = count_branches;
    r->view = view_branch;
}

/* ---- portrait ------------------------------------------------------------ */

RESULT_COUNT(count_x, plane_study, s->portrait.nullcline[0].count)
RESULT_COUNT(count_y, plane_study, s->portrait.nullcline[1].count)
RESULT_COUNT(count_tracks, plane_study, s->portrait.trajectories.count)

ROWS_VIEW(view_x, plane_study,
          plane_rows_nullcline(s, &s->portrait.nullcline[0].piece[k], &r))
ROWS_VIEW(view_y, plane_study,
          plane_rows_nullcline(s, &s->portrait.nullcline[1].piece[k], &r))
ROWS_VIEW(view_track, plane_study, plane_rows_trajectory(s, k, &r))
ROWS_VIEW(view_arrows, plane_study, plane_rows_arrows(s, &r))

static void add_nullclines(const struct plane_study *s, struct plane_table *t)
{
    const size_t first = t->fields;

    plane_table_field(t, "arc", RECORD_REAL, offsetof(struct plane_place, arc),
                      "arc length in the chart");
    plane_table_states(s, t, "*", RECORD_REAL,
                       offsetof(struct plane_place, at));
    const struct record_type *type = plane_table_type(
        t, first, "nullcline", "points where a state stands still",
        sizeof(struct plane_place));
    for (size_t i = 0; i < 2; i++) {
        struct result *r = plane_table_result(t, type, ASKED(NULLCLINES));
        r->path =
            plane_table_keep(t, "/nullcline/%s_K", s->system[0].axis[i].name);
        r->axis = "arc";
        r->count = i == 0 ? count_x : count_y;
        r->view = i == 0 ? view_x : view_y;
    }
}

static void add_arrows(const struct plane_study *s, struct plane_table *t)
{
    const size_t first = t->fields;

    plane_table_states(s, t, "*", RECORD_REAL,
                       offsetof(struct plane_arrow, at));
    plane_table_states(s, t, "direction_*", RECORD_REAL,
                       offsetof(struct plane_arrow, direction));
    plane_table_field(t, "log10_speed", RECORD_REAL,
                      offsetof(struct plane_arrow, log10_speed),
                      "in the chart");
    struct result *r = plane_table_result(
        t,
        plane_table_type(t, first, "arrow", "direction field",
                         sizeof(struct plane_arrow)),
        ASKED(FIELD_ARROWS));
    r->path = "/field_arrows";
    r->view = view_arrows;
}

static void add_tracks(const struct plane_study *s, struct plane_table *t)
{
    const size_t first = t->fields;

    plane_table_field(t, "time", RECORD_REAL,
                      offsetof(struct plane_moment, time), "0 at the start");
    plane_table_states(s, t, "*", RECORD_REAL,
                       offsetof(struct plane_moment, at));
    for (size_t i = 0; i < s->system[0].observable_count; i++) {
        const struct planar_observable *o = &s->system[0].observables[i];
        plane_table_field(t, o->name, RECORD_REAL,
                          offsetof(struct plane_moment, value) +
                              i * sizeof(double),
                          o->long_name)
            ->unit = o->unit;
    }
    struct result *r = plane_table_result(
        t,
        plane_table_type(t, first, "trajectory", "an orbit, both ways in time",
                         sizeof(struct plane_moment)),
        ASKED(TRAJECTORIES));
    r->path = "/trajectory_K";
    r->axis = "time";
    r->count = count_tracks;
    r->view = view_track;
}

/* ---- all ----------------------------------------------------------------- */

enum status plane_results_make(struct plane_study *s)
{
    struct plane_table *t = s->table = calloc(1, sizeof *t);

    if (t == NULL)
        return STATUS_NO_MEMORY;
    add_rest_columns(s, t);
    add_rests(s, t);
    add_boxes(s, t);
    if (s->products & ASKED(SENSITIVITIES))
        add_slopes(s, t);
    add_manifolds(s, t);
    if (s->products & (ASKED(MANIFOLDS) | ASKED(BASINS))) {
        const char *paths = branch_paths(s, t);
        if (paths == NULL)
            return STATUS_NO_MEMORY;
        add_branches(s, t, paths);
    }
    add_nullclines(s, t);
    add_arrows(s, t);
    add_tracks(s, t);
    if (s->products & ASKED(BASINS))
        plane_results_map(s, t);
    t->tables[0] = t->result;
    t->tables[1] = manifold_results;
    t->tables[2] = plane_number_results;
    t->tables[3] = plane_basin_results;
    return STATUS_OK;
}

struct results plane_results(const struct plane_study *s)
{
    return (struct results){
        .table = s->table->tables,
        .run = s,
        .asked = s->products,
    };
}

void plane_results_free(struct plane_table *t)
{
    if (t)
        free(t->paths);
    free(t);
}
