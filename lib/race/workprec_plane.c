#include "workprec_plane.h"

#include <math.h>
#include <stdlib.h>

#include "quad_formulas.h"
#include "workprec_tolerance.h"

static const struct plane_rest *saddle_of(const struct plane_study *s)
{
    for (size_t i = 0; i + 1 < s->listed_branches; i++) {
        const struct plane_branch *b = &s->branch[i];
        if (b[0].kind == MANIFOLD_STABLE && b[0].branch == 0 &&
            quantity_exists(&b[0].leaves[0]) &&
            quantity_exists(&b[1].leaves[0]))
            return &s->rest[b->rest];
    }
    return NULL;
}

/* Offsets from the saddle; the window is where the race ends. */
static void set_task(struct workprec_plane *p, const struct plane_rest *r,
                     size_t sample, struct study *study,
                     struct workprec_task *task)
{
    struct planar *sys = &study->slider.plane.system;

    *sys = r->system[0];
    sys->domain = p->plane->window.box;
    equilibrium_at(sys, false, &p->saddle);
    p->way = quad_formulas_way(p->plane, p->formulas);
    quad_formulas_place(&p->way, r);
    p->way.step = -1;
    task->reason[WORKPREC_CURVE] = NULL;
    task->saddle = &p->saddle;
    task->plane = p;
    task->reach = box_from(sys->domain, sys->origin);
    task->sample = sample;
}

enum status workprec_plane_init(struct workprec_plane *p,
                                const struct scene *scene, size_t sample,
                                struct study *study, struct workprec_task *task,
                                const struct monitor *monitor,
                                struct fault *why)
{
    struct scene all = *scene;

    *p = (struct workprec_plane){ .plane = malloc(sizeof *p->plane),
                                  .formulas = calloc(1, sizeof *p->formulas) };
    *task = (struct workprec_task){ .study = study };
    for (int q = 0; q < WORKPREC_QUANTITIES; q++)
        task->reason[q] = q == WORKPREC_CURVE
                              ? "no saddle's stable branches leave the window"
                              : "the formulas are not those of a slope";
    all.products = 1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_MANIFOLDS;
    enum status s = p->plane && p->formulas
                        ? quad_formulas_init(p->formulas, scene->system)
                        : STATUS_NO_MEMORY;
    if (s == STATUS_OK)
        s = plane_study_run(p->plane, &all, monitor, why);
    if (s != STATUS_OK) {
        free(p->plane);
        p->plane = NULL;
        workprec_plane_free(p);
        return s;
    }
    const struct plane_rest *r = saddle_of(p->plane);
    if (r)
        set_task(p, r, sample, study, task);
    return STATUS_OK;
}

double workprec_plane_error(const struct workprec_plane *p,
                            const struct vec2 point[], size_t count,
                            size_t sample)
{
    struct plane_point *at = calloc(sample, sizeof *at);
    quad *off = calloc(sample, sizeof *off);
    const size_t n = count < sample ? count : sample;
    const struct vec2 o = p->saddle.z;
    struct quad_way way = p->way;
    struct vec2 last = { 0.0, 0.0 };
    double arc = 0.0, worst = n > 0 ? 0.0 : HUGE_VAL;
    bool lost;

    for (size_t i = 0, k = 0; i < count && at && off && k < n; i++) {
        arc += vec2_length(vec2_sub(point[i], last));
        last = point[i];
        if (i + 1 == (k + 1) * count / n)
            at[k++] = (struct plane_point){ .arc = arc,
                                            .at = { o.x + point[i].x,
                                                    o.y + point[i].y },
                                            .error = HUGE_VAL };
    }
    if (at && off && n > 0) {
        quad_way_leave(&way, at[0].at);
        if (quad_way_follow(&way, at, n, 0.0, off, &lost) < n)
            worst = HUGE_VAL;
        for (size_t k = 0; k < n; k++)
            worst = fmax(worst, (double) off[k]);
    }
    free(at);
    free(off);
    return worst;
}

void workprec_plane_free(struct workprec_plane *p)
{
    if (p->plane)
        plane_study_free(p->plane);
    if (p->formulas)
        quad_formulas_free(p->formulas);
    free(p->plane);
    free(p->formulas);
    p->plane = NULL;
    p->formulas = NULL;
}
