#include "workprec_entrant.h"

bool workprec_entrant_at(size_t i, struct workprec_entrant *e)
{
    if (i < WORKPREC_OWNS) {
        *e = (struct workprec_entrant){ .name = workprec_own_names[i],
                                        .text = workprec_own_texts[i],
                                        .own = (enum workprec_own) i };
        return true;
    }
    const struct method *m = method_at(i - WORKPREC_OWNS);
    if (m == NULL)
        return false;
    *e = (struct workprec_entrant){
        .name = m->name, .text = m->text, .foreign = m->foreign, .stepper = m
    };
    return true;
}

bool workprec_entrant_can(const struct workprec_entrant *e,
                          enum workprec_quantity q)
{
    return e->stepper || workprec_own_can(e->own, q);
}
