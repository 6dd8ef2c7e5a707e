/* The row and the column of a state are crossed by the stable branches, which
 * says the nearest other fate; slip and time come from the slow
 * curve's table or from its whole orbit, run twice: the fates must agree, and
 * the bars with what the finer one changes. */
#include "push.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "margin.h"
#include "rest_form.h"
#include "scene_slope.h"
#include "slow_tolerance.h"

#define STATE(name_, unit_, text_)                                             \
    FIELD_AS(push_answer, REAL, #name_, at.name_, unit_, text_)

enum { STATE_FIELDS = 3 };
static const struct record_field push_fields[] = {
    FIELD(push_answer, TEXT, id, "1", "what the state is called"),
    STATE(v, "V_star", "slip rate in units of V_star"),
    STATE(psi, "psi", "interfacial state"),
    FIELD_CODE(push_answer, fate, fate_names, "what becomes of the state"),
    FIELD(push_answer, QUANTITY, slip, "L", "slip to arrest in units of L"),
    FIELD(push_answer, QUANTITY, time, "L/V_star",
          "time to arrest in units of L/V_star"),
    FIELD(push_answer, QUANTITY, mu_mean, "1", "mean friction over that slip"),
    FIELD(push_answer, QUANTITY, v_kick, "1",
          "factor on v to the nearest other fate"),
    FIELD(push_answer, QUANTITY, psi_kick, "kick of psi",
          "factor on psi (or shift of it) to the nearest other fate"),
    FIELD_AS(push_answer, REAL, "arrest_linear", arrest, "1",
             "probability that it creeps or rests, with the inputs normal and "
             "ln v_kick linear in them"),
};
#define PUSH_RECORD(first, last)                                               \
    {                                                                          \
        "push", "what becomes of a state and what would change that",          \
            push_fields + (first),                                             \
            sizeof push_fields / sizeof *push_fields - (first) - (last),       \
            sizeof(struct push_answer)                                         \
    }
const struct record_type record_push[2][2] = {
    { PUSH_RECORD(STATE_FIELDS, 1), PUSH_RECORD(STATE_FIELDS, 0) },
    { PUSH_RECORD(0, 1), PUSH_RECORD(0, 0) },
};

const struct record_type record_push_arrest =
    PUSH_RECORD(sizeof push_fields / sizeof *push_fields - 1, 0);

static const unsigned integrals =
    1u << CELL_SLIP | 1u << CELL_TIME | 1u << CELL_MU_MEAN;

/* ---- the plane ----------------------------------------------------------- */

enum status push_init(struct push *p, const struct scene *scene,
                      const struct monitor *monitor, struct fault *why)
{
    *p = (struct push){ .scene = scene };
    enum status status =
        scene_slope_demand(scene, 1u << PRODUCT_EQUILIBRIA, why);
    if (status != STATUS_OK)
        return status;
    slider_init(&p->slider, &scene->law, &scene->material, scene->tan_alpha);
    status = slider_check(&p->slider, why);
    if (status != STATUS_OK)
        return status;
    const char *none = slider_no_manifolds(&p->slider);
    if (monitor_tell(monitor, "steady states", 0, 0))
        status = STATUS_STOPPED;
    else if (slider_saddle(&p->slider) >= 0 && none)
        status = STATUS_NOT_HYPERBOLIC;
    if (status == STATUS_OK)
        status = labels_init(&p->labels, &p->slider, scene->rtol, monitor);
    if (status == STATUS_OK)
        return STATUS_OK;
    snprintf(why->text, sizeof why->text, "the basins of the slope: %s",
             status == STATUS_NOT_HYPERBOLIC && none ? none
                                                     : status_text(status));
    push_free(p);
    return status;
}

enum status push_tabulate(struct push *p, const struct monitor *monitor)
{
    fast_cells_free(&p->fast);
    const enum status s = fast_cells_init(&p->fast, &p->slider, monitor);

    if (s != STATUS_OK)
        p->fast = (struct fast_cells){ .slider = NULL };
    return s;
}

void push_free(struct push *p)
{
    fast_cells_free(&p->fast);
    labels_free(&p->labels);
}

/* ---- slip and time ------------------------------------------------------- */

static enum status follow(const struct push *p, struct vec2 z,
                          const struct monitor *monitor,
                          struct push_answer *out)
{
    static const char too_near[] =
        "the state is too near the boundary for its orbit to be followed";
    struct fate_result coarse, fine;
    double rtol = TOL_ORBIT_RTOL;
    bool agree = false;
    enum status s = fate_find(&p->slider, z, rtol, true, monitor, &coarse);

    while (s == STATUS_OK && !agree && coarse.reason == NULL &&
           rtol * TOL_FINER >= TOL_FINEST) {
        rtol *= TOL_FINER;
        s = fate_find(&p->slider, z, rtol, true, monitor, &fine);
        agree = (int8_t) coarse.fate == out->fate && fine.fate == coarse.fate;
        if (!agree)
            coarse = fine;
    }
    if (agree) {
        out->slip = fate_compare(&coarse.slip, &fine.slip);
        out->time = fate_compare(&coarse.time, &fine.time);
        out->mu_mean = fate_compare(&coarse.mu_mean, &fine.mu_mean);
    } else {
        const char *why = coarse.reason ? coarse.reason : too_near;
        out->slip = out->time = out->mu_mean = quantity_none(why);
    }
    return s;
}

static struct quantity told(double value, double error, const char *none)
{
    return isfinite(value) ? quantity_of(value, error) : quantity_none(none);
}

/* Of a block that only fades. */
static bool slip_is_finite(const struct push *p)
{
    const struct block *b = &p->slider.block;

    return rest_form_at(b).has_slip;
}

/* What a cell tells of a state of that fate, or why there is nothing to tell
 * (as fate.c says it); false: nothing that helps. */
static bool take_cell(const struct push *p, const struct cell *c,
                      struct push_answer *out)
{
    const bool fades = c->exit_reason == FATE_REST_ASYMPTOTIC;
    const bool runs = c->exit_reason == FATE_RUNAWAY;
    const char *never = runs ? fate_runs_away : "the block never quite stops";
    const char *unbounded = runs ? never : "the slip grows without bound";

    if (c->exit_reason != out->fate)
        return false;
    if (!runs && !fades && !(isfinite(c->mu_mean) && isfinite(c->time)))
        return false;
    if (fades && !isfinite(c->slip) && slip_is_finite(p))
        return false;
    out->slip = told(c->slip, c->slip_error, unbounded);
    out->time = told(c->time, c->time_error, never);
    out->mu_mean = told(c->mu_mean, c->mu_mean_error, unbounded);
    return true;
}

/* ---- what the table knows badly ------------------------------------------ */

/* Whether a number is known worse than whole orbits may know it. */
static bool is_wide(const struct quantity *q)
{
    return quantity_exists(q) &&
           q->error > TOL_FAR_BELOW * TOL_COARSEST * fabs(q->value);
}

static void keep_narrower(struct quantity *q, double value, double error)
{
    if (quantity_exists(q) && error < q->error)
        *q = quantity_of(value, error);
}

/* Its cell from whole orbits (cells.h), whose bars hold what rounding does on
 * the way past the saddle, may know it better. */
static enum status narrow(const struct push *p, struct vec2 z,
                          struct push_answer *out)
{
    struct cell c;

    if (!is_wide(&out->slip) && !is_wide(&out->time) && !is_wide(&out->mu_mean))
        return STATUS_OK;
    const enum status s =
        cells_find(&p->slider, &z, 1, TOL_ORBIT_RTOL, integrals, NULL, &c);
    if (s != STATUS_OK || c.exit_reason != out->fate)
        return s;
    keep_narrower(&out->slip, c.slip, c.slip_error);
    keep_narrower(&out->time, c.time, c.time_error);
    keep_narrower(&out->mu_mean, c.mu_mean, c.mu_mean_error);
    return s;
}

/* ---- kicks --------------------------------------------------------------- */

/* Along a row or a column, from the point `at` of it. */
static struct quantity kick_from(const struct push *p,
                                 const struct margin_line *l, double at,
                                 bool is_log, const char *none)
{
    static const char untold[] = "not every fate along this line is known";
    double error;
    const double shift = margin_at(l, at, &error);
    const double rounding =
        TOL_ROUNDINGS_FEW * DBL_EPSILON * (1.0 + fabs(at) + fabs(shift));
    const double factor = exp(shift);
    const char *traps = slider_no_traps(&p->slider);

    if (slider_saddle(&p->slider) < 0)
        return quantity_none("no saddle at this slope, hence one fate for all");
    if (isinf(shift))
        return quantity_none(traps ? traps : l->untold ? untold : none);
    if (!is_log)
        return quantity_of(shift, error + rounding);
    if (isinf(factor) || factor == 0.0)
        return quantity_none("the factor is beyond the range of a double");
    return quantity_of(factor, factor * (error + rounding));
}

/* z: an offset. */
static enum status find_kicks(const struct push *p, struct vec2 z,
                              struct push_answer *out)
{
    const struct planar_axis *axis = p->slider.plane.system.axis;
    const struct labels *labels = &p->labels;
    struct margin_line l;
    const enum status s = margin_init(&l, &labels->along[0], &labels->along[1]);

    if (s != STATUS_OK)
        return s;
    margin_find(&l, &labels->regions, &labels->along[SEPARATRIX_X], z.x);
    out->psi_kick = kick_from(p, &l, z.y, axis[1].is_log,
                              "no other fate at this v, whatever psi");
    margin_find(&l, &labels->regions, &labels->along[SEPARATRIX_Y], z.y);
    out->v_kick =
        kick_from(p, &l, z.x, true, "no other fate at this psi, whatever v");
    margin_free(&l);
    return STATUS_OK;
}

/* ---- states -------------------------------------------------------------- */

static struct vec2 chart_point(const struct push *p, struct push_state at)
{
    return (struct vec2){ log(at.v), p->slider.plane.system.axis[1].is_log
                                         ? log(at.psi)
                                         : at.psi };
}

bool push_holds(const struct push *p, struct push_state at)
{
    return box_holds(p->slider.plane.system.domain, chart_point(p, at));
}

/* `cell`: what is known of it already. */
static enum status answer(const struct push *p, struct push_state at,
                          const struct cell *cell,
                          const struct monitor *monitor,
                          struct push_answer *out)
{
    const struct vec2 z = block_offset(&p->slider.block, at.v, at.psi);
    struct fate_told label;

    *out = (struct push_answer){ .at = at,
                                 .fate = FATE_NONE,
                                 .arrest = (double) NAN };
    enum status s = find_kicks(p, z, out);
    if (s == STATUS_OK)
        s = labels_find(&p->labels, z, monitor, &label);
    if (s != STATUS_OK)
        return s;
    out->fate = label.fate;
    if (label.fate == FATE_UNDECIDED)
        out->slip = out->time = out->mu_mean = quantity_none(label.reason);
    else if (!take_cell(p, cell, out))
        s = follow(p, chart_point(p, at), monitor, out);
    else
        s = narrow(p, chart_point(p, at), out);
    return s;
}

/* What the slow curve says of n states, if it was tabulated. */
static enum status find_cells(const struct push *p, const struct vec2 z[],
                              size_t n, struct cell out[])
{
    for (size_t i = 0; i < n; i++)
        out[i] = (struct cell){ .exit_reason = FATE_UNDECIDED };
    return p->fast.slider == NULL
               ? STATUS_OK
               : fast_cells_find(&p->fast, z, n, TOL_ORBIT_RTOL, integrals,
                                 NULL, out, NULL);
}

enum status push_find(const struct push *p, struct push_state at,
                      const struct monitor *monitor, struct push_answer *out)
{
    const struct vec2 z = chart_point(p, at);
    struct cell cell;

    if (!push_holds(p, at))
        return STATUS_BAD_ARGUMENT;
    const enum status s = find_cells(p, &z, 1, &cell);
    return s == STATUS_OK ? answer(p, at, &cell, monitor, out) : s;
}

/* States between two words to the monitor. */
enum { BLOCK = 1024, BLOCK_WHOLE = 64 };

/* count <= BLOCK. */
static enum status find_block(const struct push *p,
                              const struct push_state at[], size_t count,
                              struct push_answer out[])
{
    struct vec2 z[BLOCK];
    struct cell cell[BLOCK];

    for (size_t i = 0; i < count; i++) {
        if (!push_holds(p, at[i]))
            return STATUS_BAD_ARGUMENT;
        z[i] = chart_point(p, at[i]);
    }
    enum status failed = find_cells(p, z, count, cell);
#pragma omp parallel for schedule(dynamic) reduction(max : failed)
    for (size_t i = 0; i < count; i++) {
        const enum status s = answer(p, at[i], &cell[i], NULL, &out[i]);
        failed = s > failed ? s : failed;
    }
    return failed;
}

enum status push_find_all(const struct push *p, const struct push_state at[],
                          size_t count, const struct monitor *monitor,
                          struct push_answer out[])
{
    const size_t block = p->fast.slider ? BLOCK : BLOCK_WHOLE;
    enum status failed = STATUS_OK;

    for (size_t first = 0; first < count && failed == STATUS_OK;
         first += block) {
        const size_t end = count - first < block ? count : first + block;
        failed = find_block(p, &at[first], end - first, &out[first]);
        if (failed == STATUS_OK && monitor_tell(monitor, "states", end, count))
            failed = STATUS_STOPPED;
    }
    return failed;
}
