#include "stress_judge.h"
#include "stress_work.h"
#include "verify.h"

/* Only STATUS_NO_MEMORY is an error: a second route that fails is no answer. */
static enum status find_agreement(const struct stress_work *w, int8_t *agree)
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

enum status stress_slope_judge(struct stress_work *w)
{
    const struct study *s = &w->study;
    const struct stress_answer answer = stress_answer_of(s);
    struct stress_row *row = w->row;

    if (answer.has_saddle && !slider_has_manifolds(&s->slider)) {
        stress_row_say(row, STRESS_FAILED, answer.critical.v_plus.reason, NULL);
        return STATUS_OK;
    }
    row->steps =
        (int64_t) (s->stable[SIDE_UPPER].steps + s->stable[SIDE_LOWER].steps);
    row->seconds = seconds_of(s);
    const enum status status = find_agreement(w, &row->agree);
    if (status == STATUS_OK)
        stress_judge(stress_oracle_ask(w->oracle, &w->scene, row), &answer,
                     row);
    return status;
}
