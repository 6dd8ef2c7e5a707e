#include "stress_judge.h"
#include "stress_work.h"

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
    stress_judge(stress_oracle_ask(w->oracle, &w->scene, row), &answer, row);
    return STATUS_OK;
}
