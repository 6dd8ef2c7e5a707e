#include "plane_cycle.h"

#include <stdio.h>
#include <stdlib.h>

#include "study_tolerance.h"

const char *const plane_cycle_types[] = { "stable", "unstable", NULL };

size_t plane_cycle_find(const struct plane_study *s, const struct winding *w,
                        bool stable)
{
    for (size_t k = 0; k < s->cycles; k++) {
        const struct plane_cycle *c = &s->cycle[k];
        for (size_t i = 0; i < c->round.turns; i++)
            if ((c->type == PLANE_CYCLE_STABLE) == stable &&
                vec2_length(
                    arrival_from(&s->scale, w->at[0], c->round.at[i])) <=
                    TOL_PLANE_SAME_CYCLE)
                return k;
    }
    return s->cycles;
}

enum status plane_cycle_add(struct plane_study *s, const struct winding *w,
                            bool stable, size_t *index)
{
    *index = plane_cycle_find(s, w, stable);
    if (*index < s->cycles)
        return STATUS_OK;
    struct plane_cycle *more =
        realloc(s->cycle, (s->cycles + 1) * sizeof *more);
    if (more == NULL)
        return STATUS_NO_MEMORY;
    s->cycle = more;
    struct plane_cycle *c = &s->cycle[s->cycles];
    *c = (struct plane_cycle){ .type = stable ? PLANE_CYCLE_STABLE
                                              : PLANE_CYCLE_UNSTABLE,
                               .round = *w };
    snprintf(c->word, sizeof c->word, "cycle_%zu", s->cycles++);
    for (size_t k = 0; k < s->cycles; k++) /* they may have moved */
        s->cycle[k].name = s->cycle[k].word;
    return STATUS_OK;
}
