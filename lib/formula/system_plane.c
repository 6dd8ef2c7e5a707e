#include "system_plane.h"

#include <stdlib.h>
#include <string.h>

/* The rate of a positive state, whose logarithm's is wanted: between terms that
 * vanish as the state does no digits are lost once it is taken out. */
static int rate_of(struct formula *f, const struct formula_system *s, int i)
{
    const int rate = s->rate[i], x = s->state[i].node;
    int rest;

    return s->state[i].chart == CHART_POSITIVE &&
                   formula_take_out(f, rate, x, &rest)
               ? formula_times(f, x, rest)
               : rate;
}

/* ---- both ways ----------------------------------------------------------- */

static enum status lower(struct system_lowered *out,
                         const struct formula_system *s, struct formula *f,
                         struct fault *why)
{
    struct plane_formulas p = { .observables = 0 };
    enum status status = STATUS_OK;

    for (int i = 0; i < 2; i++)
        p.state[i] = s->state[i].node;
    for (int i = 0; i < s->observables && i < TAPE_OBSERVABLES; i++)
        p.observable[p.observables++] = s->observable[i].node;
    for (int k = 0; k < 4 && status == STATUS_OK; k++) {
        for (int i = 0; i < 2; i++)
            p.rate[i] = formula_times(f, formula_number(f, k % 2 ? -1 : 1),
                                      rate_of(f, s, i));
        status = tape_plane_lower(&out->way[k / 2][k % 2], f, &p, k / 2, why);
    }
    return status == STATUS_BAD_ARGUMENT ? STATUS_BAD_SCENE : status;
}

enum status system_plane_lower(struct system_lowered *out,
                               const struct formula_system *s,
                               struct fault *why)
{
    struct formula *f = malloc(sizeof *f);
    enum status status = f ? STATUS_OK : STATUS_NO_MEMORY;

    for (int i = 0; i < s->parameters; i++) {
        strcpy(out->name[i], s->parameter[i].name);
        out->value[i] =
            (struct formula_value){ out->name[i], s->parameter[i].value };
    }
    out->value[s->parameters] = (struct formula_value){ NULL, 0 };
    if (status == STATUS_OK) {
        *f = s->graph;
        f->definitions = 0; /* constants have no names: nobody reads them */
        status = lower(out, s, f, why);
    }
    free(f);
    return status;
}

enum status system_plane_at(const struct system_lowered *l, bool equilibrium,
                            bool backward, const formula_real anchor[2],
                            struct tape_plane *out, struct fault *why)
{
    const enum status status = tape_plane_at(&l->way[equilibrium][backward],
                                             l->value, anchor, out, why);

    return status == STATUS_BAD_ARGUMENT ? STATUS_BAD_SCENE : status;
}
