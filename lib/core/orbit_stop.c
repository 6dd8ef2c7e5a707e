#include "orbit_stop.h"

#include <float.h>
#include <math.h>

#include "passage.h"

static struct box around(struct vec2 z, double r)
{
    return (struct box){ { z.x - r, z.y - r }, { z.x + r, z.y + r } };
}

void orbit_stop_at(struct orbit *o, struct vec2 z)
{
    const struct orbit_options *p = &o->options;
    const struct vec2 origin = o->clock.system->origin;

    if (p->window && !box_holds(box_from(*p->window, origin), z))
        o->end = ORBIT_LEFT_WINDOW;
    for (size_t i = p->targets; i-- > 0;) {
        if (box_holds(around(p->target[i], p->arrival), z)) {
            o->end = ORBIT_ARRIVED;
            o->end_index = i;
        }
    }
}

/* Keeps the earlier of two stops. */
static void keep(struct orbit *o, double *end, double theta, enum orbit_end why,
                 size_t index)
{
    if (theta > 1.0 || (o->end != ORBIT_RUNNING && theta >= *end))
        return;
    *end = fmax(theta, DBL_EPSILON);
    o->end = why;
    o->end_index = index;
}

/* The first of the built-in stops on the last piece. */
static void find_built_in(struct orbit *o, double *end)
{
    const struct orbit_options *p = &o->options;
    const struct planar *sys = o->clock.system;
    const struct curve *c = &o->curve;

    for (size_t i = 0; i < p->targets; i++)
        keep(o, end, passage_into(c, around(p->target[i], p->arrival)),
             ORBIT_ARRIVED, i);
    for (size_t i = 0; i <= p->observables; i++)
        if (isfinite(p->reach[i]))
            keep(o, end, passage_beyond(c, 2 + i, p->reach[i]), ORBIT_REACHED,
                 i);
    if (p->window)
        keep(o, end, passage_out_of(c, box_from(*p->window, sys->origin)),
             ORBIT_LEFT_WINDOW, 0);
    keep(o, end, passage_out_of(c, box_from(sys->domain, sys->origin)),
         ORBIT_LEFT_DOMAIN, 0);
}

enum status orbit_stop_find(struct orbit *o, double h, double *end)
{
    const struct orbit_options *p = &o->options;
    size_t stop;

    find_built_in(o, end);
    const enum status s = event_scan(&o->log, p->event, p->events, &o->curve,
                                     o->tau, h, end, &stop);
    if (stop < p->events) {
        o->end = ORBIT_EVENT;
        o->end_index = stop;
    }
    return s;
}
