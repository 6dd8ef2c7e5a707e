#include "plane_answer.h"

#include <math.h>

#include "plane_label.h"
#include "plane_map.h"
#include "plane_margin.h"
#include "plane_orbit.h"

enum status plane_answer_at(const struct plane_study *s, const double state[2],
                            struct plane_answer *out)
{
    struct plane_rounds rounds = s->rounds;
    const struct plane_guide guide = { .rounds = &rounds };
    double z[2];
    struct plane_goal goal;
    int8_t label = -1;
    enum status status;

    for (int i = 0; i < 2; i++)
        z[i] = scene_axis_is_log(s->scene, i) ? log(state[i]) : state[i];
    const struct vec2 at = { z[0], z[1] };
    const bool inside = box_holds(s->window.box, at);
    status = inside ? plane_map_at(s, at, false, &label) : STATUS_OK;
    if (status == STATUS_OK && label < 0 &&
        !(inside && plane_map_is_near(s, at))) {
        status = plane_orbit(s, at, false, &guide, &goal);
        label = plane_goal_label(s, &goal);
    }
    if (status == STATUS_OK)
        status = plane_margin_at(s, at, out->kick);
    out->stays = (double) NAN;
    out->attractor =
        s->basin.name[label < 0 ? (int8_t) s->basin.labels : label];
    return status;
}
