/* A plane is a study of a scene with a system of formulas. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "api.h"
#include "plane_answer.h"
#include "plane_rows.h"
#include "slipway_planar.h"

struct slipway_plane {
    struct scene scene;
    struct plane_study study;
    struct rows *branch; /* owned; of each of study.branch */
};

API_LENT(slipway_place, arc, plane_point, arc);
API_LENT(slipway_place, state, plane_point, at);
API_LENT(slipway_place, slope, plane_point, slope);
API_LENT(slipway_place, error, plane_point, error);

#define BIT(p) (1u << PRODUCT_##p)

/* ---- a run --------------------------------------------------------------- */

static enum status fill_branches(slipway_plane *p)
{
    static const struct record_type type = { .size =
                                                 sizeof(struct plane_point) };
    const struct plane_study *s = &p->study;
    enum status status = STATUS_OK;

    p->branch = calloc(s->listed_branches + 1, sizeof *p->branch);
    if (p->branch == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < s->listed_branches && status == STATUS_OK; i++) {
        p->branch[i] = rows_of(&type);
        status = plane_rows_branch(s, &s->branch[i], &p->branch[i]);
    }
    return status;
}

static slipway_status run(slipway_plane *p, const slipway_monitor *monitor,
                          slipway_fault *why)
{
    struct monitor tell;
    struct fault fault = { "" };

    if (p->scene.system == NULL)
        return api_fault(why, SLIPWAY_BAD_SCENE,
                         "no system of formulas in this scene");
    p->scene.products |= BIT(EQUILIBRIA) | BIT(MANIFOLDS) | BIT(BASINS);
    enum status s = plane_study_run(&p->study, &p->scene,
                                    api_monitor(monitor, &tell), &fault);
    if (s == STATUS_OK)
        s = fill_branches(p);
    return api_answer(why, s, &fault);
}

slipway_status slipway_plane_run(const slipway_scene *scene,
                                 const slipway_monitor *monitor,
                                 slipway_plane **out, slipway_fault *why)
{
    slipway_plane *p = calloc(1, sizeof *p);

    if (p == NULL)
        return api_fault(why, SLIPWAY_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    slipway_status s = api_read(scene, &p->scene, why);
    if (s == SLIPWAY_OK)
        s = run(p, monitor, why);
    if (s == SLIPWAY_OK)
        *out = p;
    else
        slipway_plane_free(p);
    return s;
}

slipway_status slipway_plane_open(const char *equations, const char *window,
                                  slipway_plane **out, slipway_fault *why)
{
    slipway_scene *scene = NULL;
    char *quoted = NULL;
    slipway_status s = SLIPWAY_BAD_SCENE;

    if (strpbrk(equations, "\"\\\n"))
        return api_fault(why, s,
                         "the equations: quotes, backslashes and line "
                         "breaks are no part of a formula");
    s = slipway_scene_new(&scene);
    if (s == SLIPWAY_OK && asprintf(&quoted, "\"%s\"", equations) < 0)
        s = SLIPWAY_NO_MEMORY;
    if (s == SLIPWAY_OK)
        s = slipway_scene_set(scene, "system.ode", quoted);
    if (s == SLIPWAY_OK)
        s = slipway_scene_set(scene, "window", window);
    s = s == SLIPWAY_OK ? slipway_plane_run(scene, NULL, out, why)
                        : api_fault(why, s, slipway_status_text(s));
    free(quoted);
    slipway_scene_free(scene);
    return s;
}

void slipway_plane_free(slipway_plane *plane)
{
    if (plane == NULL)
        return;
    for (size_t i = 0; i < plane->study.listed_branches && plane->branch; i++)
        rows_free(&plane->branch[i]);
    free(plane->branch);
    plane_study_free(&plane->study);
    scene_free(&plane->scene);
    free(plane);
}

slipway_axis slipway_plane_axis(const slipway_plane *plane, int axis)
{
    return api_axis(&plane->scene, axis);
}

/* ---- lists --------------------------------------------------------------- */

size_t slipway_plane_equilibria(const slipway_plane *plane, slipway_rest out[],
                                size_t room, int *complete)
{
    const struct plane_study *s = &plane->study;

    for (size_t i = 0; i < s->listed && i < room; i++) {
        const struct plane_rest *r = &s->rest[i];
        out[i] = (slipway_rest){ .name = r->name,
                                 .type = (slipway_rest_type) r->type,
                                 .share = api_number(&r->share) };
        for (int k = 0; k < 2; k++) {
            out[i].state[k] = api_number(&r->state[k]);
            out[i].re[k] = api_number(&r->lambda[k].re);
            out[i].im[k] = api_number(&r->lambda[k].im);
        }
    }
    if (complete)
        *complete = s->complete;
    return s->listed;
}

size_t slipway_plane_manifolds(const slipway_plane *plane,
                               slipway_manifold out[], size_t room)
{
    const struct plane_study *s = &plane->study;

    for (size_t i = 0; i < s->listed_branches && i < room; i++) {
        const struct plane_branch *b = &s->branch[i];
        out[i] = (slipway_manifold){
            .saddle = b->rest,
            .kind =
                b->kind == MANIFOLD_STABLE ? SLIPWAY_STABLE : SLIPWAY_UNSTABLE,
            .branch = (int) b->branch,
            .end = b->end < 0 ? NULL : plane_end_names[b->end],
            .to = b->to == RECORD_COUNT_NONE ? -1 : (long) b->to,
            .length = api_number(&b->length),
        };
    }
    return s->listed_branches;
}

const slipway_place *slipway_plane_points(const slipway_plane *plane,
                                          size_t which, size_t *count)
{
    const bool is = which < plane->study.listed_branches;

    *count = is ? plane->branch[which].count : 0;
    return is ? plane->branch[which].at : NULL;
}

size_t slipway_plane_shares(const slipway_plane *plane, slipway_share out[],
                            size_t room)
{
    const struct plane_basin *b = &plane->study.basin;

    for (size_t i = 0; i < b->shares && i < room; i++)
        out[i] = (slipway_share){ b->share[i].attractor,
                                  api_number(&b->share[i].fraction) };
    return b->shares;
}

/* ---- states -------------------------------------------------------------- */

slipway_status slipway_plane_goal(const slipway_plane *plane, double x,
                                  double y, const char **attractor,
                                  slipway_number kick[2])
{
    const double state[] = { x, y };
    struct plane_answer a;

    for (int i = 0; i < 2; i++)
        if (!isfinite(state[i]) ||
            (scene_axis_is_log(&plane->scene, i) && !(state[i] > 0.0)))
            return SLIPWAY_BAD_ARGUMENT;
    const enum status s = plane_answer_at(&plane->study, state, &a);
    if (s != STATUS_OK)
        return api_status(s);
    *attractor = a.attractor;
    for (int i = 0; i < 2 && kick; i++)
        kick[i] = api_number(&a.kick[i]);
    return SLIPWAY_OK;
}
