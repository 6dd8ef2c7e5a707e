/* Routes to a fate: the region between the branches that holds the state,
 * and the state's own orbit forward, L-stable.  The oracle's branches tell the
 * side. */
#include <math.h>
#include <stdlib.h>

#include "clock.h"
#include "push.h"
#include "stress_judge.h"
#include "stress_work.h"
#include "study_tolerance.h"
#include "transient.h"

static void say(struct stress_row *row, enum stress_outcome outcome,
                const char *reason)
{
    stress_row_say(row, (int) outcome, reason, NULL);
}

/* Where a fate comes from, and what is said of one that is wrong. */
enum source { REGION, ORBIT, TRANSIENT, SOURCES };
static const char *const wrong[SOURCES] = {
    "the region has the fate of the other side",
    "the orbit has the fate of the other side",
    "the transient has the fate of the other side",
};
static const char *const undecided[SOURCES] = {
    "the region has no fate",
    "the orbit's fate is undecided",
    "the transient's fate is undecided",
};

/* One fate against the oracle's. */
static void judge_fate(struct stress_row *row, const struct stress_truth *t,
                       const struct scene *c, enum stress_side side,
                       enum source source, int fate)
{
    if (fate == FATE_UNDECIDED || fate == FATE_NONE)
        say(row, STRESS_DEGRADED, undecided[source]);
    else if ((stress_truth_fates(t, &c->law, &c->material, side) >> fate &
              1u) == 0)
        say(row, STRESS_LIE, wrong[source]);
    else if (side == STRESS_UNTOLD)
        say(row, STRESS_DEGRADED, "the oracle cannot tell the side");
}

/* ---- one state ----------------------------------------------------------- */

/* What does not fit on a stack. */
struct routes {
    struct push push;
    struct transient transient;
};

/* The fates by the region, by the orbit and by the transient. */
static enum status find_fates(struct stress_work *w, struct routes *r,
                              int fate[SOURCES])
{
    const struct scene_start at = w->scene.start[0];
    const struct push_state state = { at.v, at.psi };
    struct transient_options o = transient_defaults(&w->scene);
    const struct planar *sys = &r->push.slider.plane.system;
    const struct vec2 z = { log(at.v),
                            sys->axis[1].is_log ? log(at.psi) : at.psi };
    struct fate_result orbit;
    struct push_answer answer;

    o.labels = &r->push.labels;
    enum status s = push_find(&r->push, state, NULL, &answer);
    if (s == STATUS_OK)
        s = fate_find(&r->push.slider, z, TOL_ORBIT_RTOL, false, NULL, &orbit);
    if (s == STATUS_OK && orbit.fate != FATE_UNDECIDED)
        s = transient_find(&w->study.slider, at, &o, NULL, &r->transient);
    if (s != STATUS_OK)
        return s;
    fate[REGION] = answer.fate;
    fate[ORBIT] = (int) orbit.fate;
    fate[TRANSIENT] =
        orbit.fate == FATE_UNDECIDED ? FATE_UNDECIDED : r->transient.sum.fate;
    w->row->steps = r->transient.sum.steps;
    return STATUS_OK;
}

static void judge_fates(const struct stress_work *w, const int fate[SOURCES],
                        double defect)
{
    const struct scene_start at = w->scene.start[0];
    const quad y =
        law_psi_is_log(&w->scene.law) ? (quad) at.psi : logq((quad) at.psi);
    struct stress_row *row = w->row;

    const struct stress_truth *truth =
        stress_oracle_ask(w->oracle, &w->scene, row);
    const enum stress_side side =
        stress_truth_side(truth, logq((quad) at.v), y);
    for (int i = 0; i < SOURCES; i++)
        judge_fate(row, truth, &w->scene, side, (enum source) i, fate[i]);
    row->agree = fate[REGION] == fate[ORBIT] && fate[ORBIT] == fate[TRANSIENT]
                     ? STRESS_AGREE
                     : STRESS_DISAGREE;
    if (row->agree == STRESS_DISAGREE)
        say(row, STRESS_DEGRADED, "the two routes disagree");
    if (defect > TOL_TRANSIENT_ENERGY * w->scene.rtol)
        say(row, STRESS_DEGRADED, "the balance of energy is off");
}

enum status stress_start_judge(struct stress_work *w)
{
    struct routes *r = calloc(1, sizeof *r);
    int fate[SOURCES];

    if (r == NULL)
        return STATUS_NO_MEMORY;
    const double start = clock_seconds();
    enum status s = push_init(&r->push, &w->scene, NULL, &w->row->fault);
    if (s == STATUS_OK)
        s = find_fates(w, r, fate);
    w->row->seconds += clock_seconds() - start;
    if (s == STATUS_OK)
        judge_fates(w, fate, fabs(r->transient.sum.energy_defect));
    else if (s == STATUS_BAD_ARGUMENT)
        say(w->row, STRESS_NONE, "the state is outside the plane's domain");
    transient_free(&r->transient);
    push_free(&r->push);
    free(r);
    return s == STATUS_BAD_ARGUMENT ? STATUS_OK : s;
}

/* ---- a grid -------------------------------------------------------------- */

enum status stress_window_judge(struct stress_work *w)
{
    const struct basin_map *m = &w->study.basins;
    const struct stress_truth *t;
    struct stress_row *row = w->row;
    int8_t *label = calloc(m->columns * m->rows + 1, sizeof *label);
    enum status status = STATUS_NO_MEMORY;

    row->steps = (int64_t) (m->rows * m->columns);
    row->agree = m->audit.disagreements == 0 ? STRESS_AGREE : STRESS_DISAGREE;
    if (row->agree == STRESS_DISAGREE)
        say(row, STRESS_DEGRADED, "orbits disagree with labels");
    if (label)
        status = basin_map_rows(m, 0, m->rows, label);
    t = stress_oracle_ask(w->oracle, &w->scene, row);
    for (size_t i = 0; status == STATUS_OK && i < m->rows * m->columns; i++) {
        const double x = m->x[i % m->columns], y = m->y[i / m->columns];
        judge_fate(row, t, &w->scene, stress_truth_side(t, (quad) x, (quad) y),
                   REGION, label[i]);
    }
    free(label);
    return status;
}
