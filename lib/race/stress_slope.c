#include "stress_slope.h"

#include <stdlib.h>

#include "stress_judge.h"
#include "verify.h"

/* What does not fit on a stack. */
struct work {
    struct scene scene; /* borrows what the case's owns */
    struct study study;
};

/* Only STATUS_NO_MEMORY is an error: a second route that fails is no answer. */
static enum status find_agreement(const struct work *w, int8_t *agree)
{
    const struct study *s = &w->study;
    struct verification v;
    enum status status = STATUS_NO_CONVERGENCE;

    if (slider_saddle(&s->slider) >= 0)
        status = verify_numbers(&s->slider.block, &s->slider.plane.system,
                                phase_plane_saddle(&s->slider.plane),
                                &s->slider.critical, w->scene.rtol, NULL, &v);
    if (status == STATUS_NO_MEMORY)
        return status;
    *agree = status != STATUS_OK    ? -1
             : v.disagreements == 0 ? STRESS_AGREE
                                    : STRESS_DISAGREE;
    return STATUS_OK;
}

/* What finding the critical numbers took, without their conditioning. */
static double seconds_of(const struct study *s)
{
    return s->cost[STAGE_STEADY].seconds + s->cost[STAGE_STABLE].seconds +
           s->cost[STAGE_CRITICAL].seconds + s->cost[STAGE_KNEES].seconds;
}

static void fill(const struct work *w, const struct stress_truth *truth,
                 struct stress_row *row)
{
    const struct study *s = &w->study;
    const struct stress_answer a = stress_answer_of(s);

    row->steps =
        (int64_t) (s->stable[SIDE_UPPER].steps + s->stable[SIDE_LOWER].steps);
    row->seconds = seconds_of(s);
    const struct stress_verdict v = stress_judge(truth, &a, row->agree);
    row->outcome = v.outcome;
    row->digits = v.digits;
    row->allowed = v.allowed;
    row->missing = v.missing;
    row->bar = v.bar;
    row->worst = v.worst;
    row->reason = v.reason;
}

enum status stress_slope_run(const struct stress_case *c,
                             struct stress_oracle *oracle,
                             struct stress_row *row)
{
    struct work *w = calloc(1, sizeof *w);

    if (w == NULL)
        return STATUS_NO_MEMORY;
    w->scene = c->scene;
    w->scene.products = 1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_KNEES |
                        1u << PRODUCT_SENSITIVITIES;
    enum status s = study_run(&w->study, &w->scene, NULL, &row->fault);
    const bool solved = s == STATUS_OK;
    const bool refused = solved && slider_saddle(&w->study.slider) >= 0 &&
                         !slider_has_manifolds(&w->study.slider);
    if (solved && !refused)
        s = find_agreement(w, &row->agree);
    if (refused || (!solved && s != STATUS_NO_MEMORY)) {
        row->outcome = STRESS_FAILED;
        row->reason =
            refused ? w->study.slider.critical.v_plus.reason : row->fault.text;
        s = STATUS_OK;
    } else if (s == STATUS_OK) {
        fill(w, stress_oracle_ask(oracle, &w->scene, row), row);
    }
    study_free(&w->study);
    free(w);
    return s;
}
