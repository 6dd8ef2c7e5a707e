/* Routes to a fate: the region between the branches that holds the state,
 * and the state's own orbit forward, L-stable.  The oracle's branches tell the
 * side. */
#include "stress_state.h"

#include <math.h>
#include <stdlib.h>

#include "push.h"
#include "stress_judge.h"
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

struct work {
    struct scene scene; /* borrows what the case's owns */
    struct push push;
    struct study study;
    struct transient transient;
};

/* The fates by the region, by the orbit and by the transient. */
static enum status find_fates(struct work *w, struct stress_row *row,
                              int fate[SOURCES])
{
    const struct scene_start at = w->scene.start[0];
    const struct push_state state = { at.v, at.psi };
    struct transient_options o = transient_defaults(&w->scene);
    const struct planar *sys = &w->push.slider.plane.system;
    const struct vec2 z = { log(at.v),
                            sys->axis[1].is_log ? log(at.psi) : at.psi };
    struct fate_result orbit;
    struct push_answer answer;

    o.labels = &w->push.labels;
    enum status s = push_find(&w->push, state, NULL, &answer);
    if (s == STATUS_OK)
        s = fate_find(&w->push.slider, z, TOL_PUSH_COARSE, false, NULL, &orbit);
    if (s == STATUS_OK && orbit.fate != FATE_UNDECIDED)
        s = transient_find(&w->study.slider, at, &o, NULL, &w->transient);
    if (s != STATUS_OK)
        return s;
    fate[REGION] = answer.fate;
    fate[ORBIT] = (int) orbit.fate;
    fate[TRANSIENT] =
        orbit.fate == FATE_UNDECIDED ? FATE_UNDECIDED : w->transient.sum.fate;
    row->steps = w->transient.sum.steps;
    return STATUS_OK;
}

static void judge_start(const struct work *w, struct stress_oracle *oracle,
                        struct stress_row *row, const int fate[SOURCES])
{
    const struct scene_start at = w->scene.start[0];
    const quad y =
        law_psi_is_log(&w->scene.law) ? (quad) at.psi : logq((quad) at.psi);
    const double defect = fabs(w->transient.sum.energy_defect);

    const struct stress_truth *truth =
        stress_oracle_ask(oracle, &w->scene, row);
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

static enum status run_start(struct work *w, struct stress_oracle *oracle,
                             struct stress_row *row)
{
    int fate[SOURCES];

    const double start = stress_clock();
    w->scene.products = 1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_KNEES;
    enum status s = study_run(&w->study, &w->scene, NULL, &row->fault);
    if (s == STATUS_OK)
        s = push_init(&w->push, &w->scene, NULL, &row->fault);
    if (s == STATUS_OK)
        s = find_fates(w, row, fate);
    row->seconds = stress_clock() - start;
    if (s == STATUS_OK)
        judge_start(w, oracle, row, fate);
    else if (s == STATUS_BAD_ARGUMENT)
        say(row, STRESS_NONE, "the state is outside the plane's domain");
    else if (s != STATUS_NO_MEMORY)
        say(row, STRESS_FAILED, row->fault.text);
    return s == STATUS_NO_MEMORY ? s : STATUS_OK;
}

enum status stress_start_run(const struct stress_case *c,
                             struct stress_oracle *oracle,
                             struct stress_row *row)
{
    struct work *w = calloc(1, sizeof *w);

    if (w == NULL)
        return STATUS_NO_MEMORY;
    w->scene = c->scene;
    const enum status s = run_start(w, oracle, row);
    transient_free(&w->transient);
    push_free(&w->push);
    study_free(&w->study);
    free(w);
    return s;
}

/* ---- a grid -------------------------------------------------------------- */

static enum status judge_labels(const struct scene *c, const struct study *s,
                                struct stress_oracle *oracle,
                                struct stress_row *row)
{
    const struct basin_map *m = &s->basins;
    int8_t *label = calloc(m->columns * m->rows + 1, sizeof *label);
    enum status status = STATUS_NO_MEMORY;

    if (label)
        status = basin_map_rows(m, 0, m->rows, label);
    const struct stress_truth *t = stress_oracle_ask(oracle, c, row);
    for (size_t i = 0; status == STATUS_OK && i < m->rows * m->columns; i++) {
        const double x = m->x[i % m->columns], y = m->y[i / m->columns];
        judge_fate(row, t, c, stress_truth_side(t, (quad) x, (quad) y), REGION,
                   label[i]);
    }
    free(label);
    return status;
}

static void judge_audit(const struct basin_audit *a, struct stress_row *row)
{
    row->agree = a->disagreements == 0 ? STRESS_AGREE : STRESS_DISAGREE;
    if (row->agree == STRESS_DISAGREE)
        say(row, STRESS_DEGRADED, "orbits disagree with labels");
}

enum status stress_window_run(const struct stress_case *c,
                              struct stress_oracle *oracle,
                              struct stress_row *row)
{
    struct study *s = calloc(1, sizeof *s);
    struct scene scene = c->scene;

    if (s == NULL)
        return STATUS_NO_MEMORY;
    const double start = stress_clock();
    scene.products = 1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_MANIFOLDS |
                     1u << PRODUCT_NULLCLINES | 1u << PRODUCT_BASINS;
    enum status status = study_run(s, &scene, NULL, &row->fault);
    row->seconds = stress_clock() - start;
    if (status == STATUS_OK) {
        row->steps = (int64_t) (s->basins.rows * s->basins.columns);
        judge_audit(&s->basins.audit, row);
        status = judge_labels(&scene, s, oracle, row);
        study_free(s);
    } else if (status != STATUS_NO_MEMORY) {
        say(row, STRESS_FAILED, row->fault.text);
        status = STATUS_OK;
    }
    free(s);
    return status;
}
