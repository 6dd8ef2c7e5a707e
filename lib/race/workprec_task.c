#include "workprec_task.h"

#include <math.h>
#include <string.h>

#include "quad_branch.h"
#include "workprec_tolerance.h"

const char *const workprec_quantity_names[] = { "v_plus",    "v_minus",
                                                "x_excess",  "curve",
                                                "transient", "basin_rows",
                                                "slip",      NULL };
const char *const workprec_quantity_texts[] = {
    "upper critical slip rate, relative",
    "lower critical slip rate, relative",
    "excess slip, relative",
    "stored points' distance from the curve, logarithmic",
    "an orbit's state at a time, logarithmic",
    "where both branches cut rows of a map, logarithmic",
    "slip of some states to their arrest, relative",
    NULL
};

/* Where states are tried, from the saddle. */
static const struct vec2 places[] = { { 4.0, 2.0 },   { 2.5, -1.0 },
                                      { -3.0, 1.5 },  { 5.0, 3.0 },
                                      { -2.0, -1.5 }, { 3.0, -2.5 } };
enum { PLACES = sizeof places / sizeof *places };

/* ---- branches -------------------------------------------------------- */

static void set_limits(struct workprec_task *c)
{
    struct workprec_truth *t = &c->truth;
    const struct quad_branch *up = &t->curve[SIDE_UPPER];
    const struct quad_branch *low = &t->curve[SIDE_LOWER];

    if (up->end != QUAD_PSI_INF)
        c->reason[WORKPREC_V_PLUS] = c->reason[WORKPREC_X_EXCESS] =
            "the upper branch has no limit";
    if (low->end != QUAD_PSI_0)
        c->reason[WORKPREC_V_MINUS] = "the lower branch has no such limit";
    t->v[SIDE_UPPER] = t->slope.at.v0 * expq(up->x);
    t->v[SIDE_LOWER] = t->slope.at.v0 * expq(low->x);
    t->x_excess = up->excess;
}

/* Whether the branch goes on from its point z at an angle with the rows. */
static bool is_across(const struct quad_branch *b, const quad z[2])
{
    quad n[2];

    workprec_curve_tangent(b, z, n);
    return fabsq(n[1]) > (quad) WORKPREC_ROW_ACROSS;
}

static bool is_in_reach(const struct workprec_task *c, const quad z[2])
{
    return box_holds(c->reach, (struct vec2){ (double) z[0], (double) z[1] });
}

/* Rows half way between points that the branch has not been beyond before,
 * evenly chosen. */
static void choose_cuts(struct workprec_task *c, int side)
{
    const struct quad_branch *b = &c->truth.curve[side];
    struct workprec_cuts *cuts = &c->truth.cuts[side];
    size_t good[QUAD_PATH], n = 0;
    quad farthest = 0;

    for (size_t i = 0; i + 1 < b->points && is_in_reach(c, b->path[i + 1]);
         i++) {
        const quad *z = b->path[i], height = fabsq(z[1]);
        if (height >= farthest && fabsq(z[0]) > (quad) WORKPREC_ROW_NEAREST &&
            is_across(b, z) && is_across(b, b->path[i + 1]))
            good[n++] = i;
        farthest = height > farthest ? height : farthest;
    }
    cuts->count = n < WORKPREC_ROWS_MOST ? n : WORKPREC_ROWS_MOST;
    for (size_t k = 0; k < cuts->count; k++) {
        const size_t i = good[(2 * k + 1) * n / (2 * cuts->count)];
        cuts->row[k] = (double) ((b->path[i][1] + b->path[i + 1][1]) / 2);
        const quad row =
            (quad) c->study->slider.plane.system.origin.y + cuts->row[k];
        cuts->x[k] = c->truth.slope.at.x0 +
                     workprec_curve_cross(b, i, row - c->truth.slope.at.y0);
    }
}

static void set_branches(struct workprec_task *c)
{
    const struct law *law = &c->study->slider.block.law;
    struct workprec_truth *t = &c->truth;

    for (int i = 0; i < WORKPREC_SIDES; i++)
        if (!quad_branch_grow(law, &t->slope.at, i == SIDE_UPPER ? 1 : -1,
                              WORKPREC_CURVE_TOL, &t->curve[i])) {
            for (int q = 0; q <= WORKPREC_ROWS; q++)
                if (q != WORKPREC_TRANSIENT)
                    c->reason[q] = "the branches were not found in 113 bits";
            return;
        }
    set_limits(c);
    choose_cuts(c, SIDE_UPPER);
    choose_cuts(c, SIDE_LOWER);
    if (t->cuts[SIDE_UPPER].count + t->cuts[SIDE_LOWER].count == 0)
        c->reason[WORKPREC_ROWS] = "the branches cut no row in the window";
}

/* ---- orbits ---------------------------------------------------------- */

/* The scene's first start and time, else a start near the saddle and the time
 * scale of leaving it; no later than half way to rest. */
static void choose_orbit(struct workprec_task *c)
{
    const struct scene *scene = c->study->scene;
    const struct planar *sys = &c->study->slider.plane.system;
    struct vec2 z = vec2_add(sys->origin, places[0]);
    struct quad_orbit o;

    if (scene->starts > 0)
        z = (struct vec2){ log(scene->start[0].v),
                           sys->axis[1].is_log ? log(scene->start[0].psi)
                                               : scene->start[0].psi };
    c->start = vec2_sub(z, sys->origin);
    c->until = scene->until_time > 0.0 ? scene->until_time
                                       : 1.0 / c->saddle->lambda[1];
    quad_orbit_find(&c->truth.slope, z.x, z.y, WORKPREC_ORBIT_TOL, &o);
    if (o.fate == FATE_REST_FINITE)
        c->until = fmin(c->until, 0.5 * (double) o.value[CELL_TIME]);
}

static void set_state(struct workprec_task *c)
{
    const struct vec2 o = c->study->slider.plane.system.origin;

    choose_orbit(c);
    if (!quad_orbit_at(&c->truth.slope, (quad) o.x + c->start.x,
                       (quad) o.y + c->start.y, c->until, WORKPREC_ORBIT_TOL,
                       c->truth.state))
        c->reason[WORKPREC_TRANSIENT] =
            "the orbit was not followed in 113 bits";
}

/* Tries one state; counts it where it arrives at a node. */
static void try_cell(struct workprec_task *c, struct vec2 offset)
{
    const struct vec2 z =
        vec2_add(c->study->slider.plane.system.origin, offset);
    struct quad_orbit o;

    quad_orbit_find(&c->truth.slope, z.x, z.y, WORKPREC_ORBIT_TOL, &o);
    if (o.fate != FATE_CREEP && o.fate != FATE_SLIDING)
        return;
    c->truth.slip[c->cells] = o.value[CELL_SLIP];
    c->cell[c->cells++] = z;
}

static void set_cells(struct workprec_task *c)
{
    const struct phase_plane *plane = &c->study->slider.plane;

    for (size_t i = 0; i < plane->equilibria; i++)
        if ((int) i != slider_saddle(&c->study->slider))
            c->target[c->targets++] = phase_plane_offset(plane, i);
    for (size_t i = 0; i < PLACES && c->cells < c->most && c->targets > 0; i++)
        try_cell(c, places[i]);
    if (c->cells == 0)
        c->reason[WORKPREC_SLIP] = "no state tried arrives at a node";
}

/* ---- all ------------------------------------------------------------- */

enum status workprec_task_init(struct workprec_task *c, const struct study *s,
                               size_t cells, size_t sample,
                               const struct monitor *monitor)
{
    static const char stage[] = "truth in 113 bits";
    static void (*const part[])(
        struct workprec_task *) = { set_branches, set_state, set_cells };
    enum { PARTS = sizeof part / sizeof *part };
    const struct box w = scene_box(s->scene);
    const struct vec2 o = s->slider.plane.system.origin;

    *c = (struct workprec_task){ .study = s, .most = cells, .sample = sample };
    c->reach = box_from(w, o);
    for (int q = 0; q < WORKPREC_QUANTITIES; q++)
        if (slider_saddle(&s->slider) < 0)
            c->reason[q] = "there is no saddle at this slope";
    if (slider_saddle(&s->slider) < 0)
        return STATUS_OK;
    c->saddle = phase_plane_saddle(&s->slider.plane);
    quad_slope_init(&c->truth.slope, s);
    for (size_t i = 0; i < PARTS; i++) {
        if (monitor_tell(monitor, stage, i, PARTS))
            return STATUS_STOPPED;
        part[i](c);
    }
    return STATUS_OK;
}
