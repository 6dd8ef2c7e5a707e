#include "stress_oracle.h"

#include <string.h>

#include "clock.h"

/* A material is doubles only: equal bytes, equal values. */
static bool is_last_asked(const struct stress_oracle *o, const struct scene *s)
{
    return o->asked && law_composition(&o->law) == law_composition(&s->law) &&
           memcmp(&o->m, &s->material, sizeof o->m) == 0 &&
           o->tan_alpha == s->tan_alpha;
}

const struct stress_truth *stress_oracle_ask(struct stress_oracle *oracle,
                                             const struct scene *scene,
                                             struct stress_row *row)
{
    const double start = clock_seconds();

    if (!is_last_asked(oracle, scene)) {
        oracle->asked = true;
        oracle->law = scene->law;
        oracle->m = scene->material;
        oracle->tan_alpha = scene->tan_alpha;
        stress_truth_find(&scene->law, &scene->material, scene->tan_alpha,
                          &oracle->truth);
    }
    row->oracle_seconds = clock_seconds() - start;
    row->oracle_evaluations = (int64_t) oracle->truth.evaluations;
    return &oracle->truth;
}
