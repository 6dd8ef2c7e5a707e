#include "workprec_course.h"

#include <math.h>
#include <string.h>

#include "quad_branch.h"
#include "workprec_tolerance.h"

const char *const workprec_quantity_names[] = { "v_plus",    "v_minus",
                                                "x_excess",  "curve",
                                                "transient", "basin_rows",
                                                "slip",      NULL };
const char *const workprec_quantity_texts[] = {
    "v_plus, relative",
    "v_minus, relative",
    "x_excess, relative",
    ("both branches within the window: largest distance of a stored point from "
     "the curve, in ln v and ln psi"),
    "an orbit's state at a time: ln v, ln psi",
    "where both branches cut rows of a basin map: ln v",
    "slip of some states to their arrest, relative",
    NULL
};

/* Where states are tried, from the saddle. */
static const struct vec2 places[] = { { 4.0, 2.0 },   { 2.5, -1.0 },
                                      { -3.0, 1.5 },  { 5.0, 3.0 },
                                      { -2.0, -1.5 }, { 3.0, -2.5 } };
enum { PLACES = sizeof places / sizeof *places };

/* ---- limits ---------------------------------------------------------- */

static void set_limits(struct workprec_course *c)
{
    const struct law *law = &c->study->slider.block.law;
    struct workprec_truth *t = &c->truth;
    struct quad_branch up = { .end = QUAD_TRUNCATED }, low = up;

    if (!quad_branch_grow(law, &t->slope.at, 1, WORKPREC_BRANCH_TOL, &up) ||
        up.end != QUAD_PSI_INF)
        c->reason[WORKPREC_V_PLUS] = c->reason[WORKPREC_X_EXCESS] =
            "the upper branch has no limit";
    if (!quad_branch_grow(law, &t->slope.at, -1, WORKPREC_BRANCH_TOL, &low) ||
        low.end != QUAD_PSI_0)
        c->reason[WORKPREC_V_MINUS] = "the lower branch has no such limit";
    t->v[SIDE_UPPER] = t->slope.at.v0 * expq(up.x);
    t->v[SIDE_LOWER] = t->slope.at.v0 * expq(low.x);
    t->x_excess = up.excess;
}

/* ---- branches -------------------------------------------------------- */

/* Rows half way between knots that the branch has not been beyond before,
 * evenly chosen. */
static void choose_cuts(const struct workprec_course *c, int side,
                        struct workprec_cuts *cuts)
{
    const struct workprec_curve *curve = &c->truth.curve[side];
    const quad way = curve->knot[curve->count - 1].z[1] > 0 ? 1 : -1;
    size_t good[256], n = 0;
    quad farthest = 0;

    for (size_t i = 0; i + 1 < curve->count && n < 256; i++) {
        const struct workprec_knot *a = &curve->knot[i], *b = a + 1;
        const bool fresh = way * a->z[1] >= farthest &&
                           fabsq(a->z[0]) > (quad) WORKPREC_ROW_NEAREST;
        if (way * a->z[1] > farthest)
            farthest = way * a->z[1];
        if (fresh && fabsq(a->n[1]) > (quad) WORKPREC_ROW_ACROSS &&
            fabsq(b->n[1]) > (quad) WORKPREC_ROW_ACROSS)
            good[n++] = i;
    }
    cuts->count = n < WORKPREC_ROWS_MOST ? n : WORKPREC_ROWS_MOST;
    for (size_t k = 0; k < cuts->count; k++) {
        const size_t i = good[(2 * k + 1) * n / (2 * cuts->count)];
        const quad y = (curve->knot[i].z[1] + curve->knot[i + 1].z[1]) / 2;
        cuts->row[k] = (double) y;
        const quad row =
            (quad) c->study->slider.plane.system.origin.y + cuts->row[k];
        cuts->x[k] = c->truth.slope.at.x0 +
                     workprec_curve_cross(curve, i, row - c->truth.slope.at.y0);
    }
}

static enum status set_curves(struct workprec_course *c)
{
    enum status s = STATUS_OK;
    size_t cuts = 0;

    for (int i = 0; i < WORKPREC_SIDES && s == STATUS_OK; i++) {
        s = workprec_curve_grow(&c->study->slider.block.law, &c->truth.slope.at,
                                i == SIDE_UPPER ? 1 : -1, c->reach,
                                &c->truth.curve[i]);
        if (s != STATUS_OK)
            break;
        choose_cuts(c, i, &c->truth.cuts[i]);
        cuts += c->truth.cuts[i].count;
    }
    if (s == STATUS_NO_CONVERGENCE)
        c->reason[WORKPREC_CURVE] = c->reason[WORKPREC_ROWS] =
            "the branches were not found in 113 bits";
    else if (cuts == 0)
        c->reason[WORKPREC_ROWS] = "the branches cut no row in the window";
    return s == STATUS_NO_CONVERGENCE ? STATUS_OK : s;
}

/* ---- orbits ---------------------------------------------------------- */

/* The scene's first start and time, else a start near the saddle and the time
 * scale of leaving it; no later than half way to rest. */
static void choose_orbit(struct workprec_course *c)
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

static void set_state(struct workprec_course *c)
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
static void try_cell(struct workprec_course *c, struct vec2 offset)
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

static void set_cells(struct workprec_course *c, size_t cells)
{
    const struct phase_plane *plane = &c->study->slider.plane;

    for (size_t i = 0; i < plane->equilibria; i++)
        if ((int) i != slider_saddle(&c->study->slider))
            c->target[c->targets++] = phase_plane_offset(plane, i);
    for (size_t i = 0; i < PLACES && c->cells < cells && c->targets > 0; i++)
        try_cell(c, places[i]);
    if (c->cells == 0)
        c->reason[WORKPREC_SLIP] = "no state tried arrives at a node";
}

/* ---- all ------------------------------------------------------------- */

enum status workprec_course_init(struct workprec_course *c,
                                 const struct study *s, size_t cells,
                                 size_t sample, const struct monitor *monitor)
{
    static const char stage[] = "truth in 113 bits";
    const struct box w = scene_box(s->scene);
    const struct vec2 o = s->slider.plane.system.origin;

    *c = (struct workprec_course){ .study = s, .sample = sample };
    c->reach = (struct box){ vec2_sub(w.lo, o), vec2_sub(w.hi, o) };
    for (int q = 0; q < WORKPREC_QUANTITIES; q++)
        if (slider_saddle(&s->slider) < 0)
            c->reason[q] = "there is no saddle at this slope";
    if (slider_saddle(&s->slider) < 0)
        return STATUS_OK;
    c->saddle = phase_plane_saddle(&s->slider.plane);
    quad_slope_init(&c->truth.slope, s);
    set_limits(c);
    enum status status =
        monitor_tell(monitor, stage, 1, 4) ? STATUS_STOPPED : set_curves(c);
    if (status == STATUS_OK && monitor_tell(monitor, stage, 2, 4))
        status = STATUS_STOPPED;
    if (status == STATUS_OK)
        set_state(c);
    if (status == STATUS_OK && monitor_tell(monitor, stage, 3, 4))
        status = STATUS_STOPPED;
    if (status == STATUS_OK)
        set_cells(c, cells);
    else
        workprec_course_free(c);
    return status;
}

void workprec_course_free(struct workprec_course *c)
{
    for (int i = 0; i < WORKPREC_SIDES; i++)
        workprec_curve_free(&c->truth.curve[i]);
    *c = (struct workprec_course){ .study = NULL };
}
