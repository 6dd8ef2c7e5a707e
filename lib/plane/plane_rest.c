/* What the formulas prove (equilibria.h), with the planar systems about each.
 */
#include "plane_rest.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "equilibria.h"
#include "plane_beyond.h"
#include "plane_tolerance.h"
#include "plane_turn.h"
#include "tolerance.h"

const char *const plane_type_names[] = { "saddle",
                                         "stable_node",
                                         "stable_focus",
                                         "unstable_node",
                                         "unstable_focus",
                                         "nonhyperbolic",
                                         NULL };
_Static_assert((int) PLANE_TYPES == (int) SYSTEM_EQUILIBRIUM_TYPES,
               "types are those of equilibria.h");

/* The value as a double, whose rounding is in the bar; 0 where that may be. */
static struct quantity number(const struct system_number *n)
{
    const double value =
        fabs((double) n->value) <= n->error ? 0.0 : (double) n->value;
    const double left = (double) (n->value - (formula_real) value);

    return quantity_of(value, n->error + fabs(left));
}

/* STATUS_NO_MEMORY, STATUS_BAD_SCENE. */
static enum status fill(const struct plane_study *s,
                        const struct system_equilibrium *e,
                        struct plane_rest *r, struct fault *why)
{
    const formula_real at[] = { e->chart[0].value, e->chart[1].value };
    const struct quantity x = number(&e->chart[0]), y = number(&e->chart[1]);

    r->type = (int8_t) e->type;
    r->exact = *e;
    r->z = (struct vec2){ x.value, y.value };
    r->error = (struct vec2){ x.error, y.error };
    r->alone = (struct box){ { e->box[0][0], e->box[1][0] },
                             { e->box[0][1], e->box[1][1] } };
    for (int i = 0; i < 2; i++) {
        r->state[i] = number(&e->state[i]);
        r->lambda[i].re = number(&e->eigenvalue[i].re);
        r->lambda[i].im = number(&e->eigenvalue[i].im);
    }
    r->plane = calloc(2, sizeof *r->plane);
    if (r->plane == NULL)
        return STATUS_NO_MEMORY;
    const enum status status =
        plane_study_about(s, true, at, r->plane, r->system, why);
    for (int i = 0; i < 2 && status == STATUS_OK; i++)
        r->trap[i] = r->type == PLANE_NONHYPERBOLIC
                         ? (struct trap_form){ .z = r->z }
                         : trap_form_at(&r->system[i], &s->scale);
    return status;
}

bool plane_rest_attracts(const struct plane_rest *r, bool backward)
{
    return r->trap[backward].size > 0.0 || r->turn[backward].corners > 0;
}

bool plane_rest_traps(const struct plane_study *s, const struct plane_rest *r,
                      bool backward, struct vec2 z)
{
    const struct trap_form *t = &r->trap[backward];

    return (t->size > 0.0 && trap_form_distance(t, &s->scale, z) < t->size) ||
           plane_turn_holds(s, r, backward, z);
}

/* Of a box, what is nearest to a place. */
static struct vec2 nearest_in(const struct plane_study *s,
                              const struct plane_box *b, struct vec2 z)
{
    return (struct vec2){ fmin(fmax(z.x, plane_chart(s, 0, b->range[0][0])),
                               plane_chart(s, 0, b->range[0][1])),
                          fmin(fmax(z.y, plane_chart(s, 1, b->range[1][0])),
                               plane_chart(s, 1, b->range[1][1])) };
}

/* No trap reaches to another equilibrium, or to a box that may hold one:
 * V >= u'u. */
static void keep_apart(struct plane_study *s)
{
    for (size_t i = 0; i < 2 * s->rests; i++) {
        struct trap_form *t = &s->rest[i / 2].trap[i % 2];
        for (size_t k = 0; k < s->rests; k++)
            if (k != i / 2 && t->size > 0.0)
                t->size = fmin(t->size, 0.5 * trap_form_distance(t, &s->scale,
                                                                 s->rest[k].z));
        for (size_t k = 0; k < s->undecided_count; k++)
            t->size =
                fmin(t->size,
                     0.5 * vec2_length(arrival_from(
                               &s->scale, nearest_in(s, &s->undecided[k], t->z),
                               t->z)));
    }
}

static enum status keep(struct plane_study *s,
                        const struct system_equilibria *found,
                        struct fault *why)
{
    size_t count[PLANE_TYPES] = { 0 };
    enum status status = STATUS_OK;

    s->complete = found->complete;
    s->rests = (size_t) found->count;
    s->undecided_count = (size_t) found->undecided_count;
    s->rest = calloc(s->rests + 1, sizeof *s->rest);
    s->undecided = calloc(s->undecided_count + 1, sizeof *s->undecided);
    if (s->rest == NULL || s->undecided == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < s->rests && status == STATUS_OK; i++) {
        struct plane_rest *r = &s->rest[i];
        status = fill(s, &found->equilibrium[i], r, why);
        r->name = r->word;
        snprintf(r->word, sizeof r->word, "%s_%zu", plane_type_names[r->type],
                 count[r->type]++);
    }
    if (status != STATUS_OK)
        return status;
    s->listed = s->rests;
    s->saddles = count[PLANE_SADDLE];
    for (size_t i = 0; i < s->undecided_count; i++)
        for (int k = 0; k < 2; k++) {
            const struct system_window *w = &found->undecided[i];
            s->undecided[i].range[k][0] = plane_state(s, k, w->lo[k]);
            s->undecided[i].range[k][1] = plane_state(s, k, w->hi[k]);
        }
    keep_apart(s);
    return STATUS_OK;
}

enum status plane_rest_find(struct plane_study *s, struct fault *why)
{
    const struct box w = s->window.box;
    const struct system_window window = { { w.lo.x, w.lo.y },
                                          { w.hi.x, w.hi.y } };
    struct system_equilibria *found = malloc(sizeof *found);
    enum status status =
        found ? system_equilibria_find(s->scene->system, &window, found, why)
              : STATUS_NO_MEMORY;

    if (status == STATUS_OK)
        status = keep(s, found, why);
    for (size_t i = 0; i < s->rests && status == STATUS_OK; i++)
        status = plane_turn_find(s, &s->rest[i]);
    free(found);
    return status;
}

/* ---- outside the window ---------------------------------------------------
 */

static size_t known_at(const struct plane_study *s, struct vec2 z)
{
    size_t i = 0;

    while (i < s->rests &&
           vec2_length(arrival_from(&s->scale, z, s->rest[i].z)) > TOL_SAME)
        i++;
    return i;
}

/* Newton's steps from *z, within the place where curves are followed. */
static bool settle(const struct plane_study *s, struct vec2 *z)
{
    enum { STEPS = 30 };
    const struct planar *system = &s->system[0];
    struct planar_jacobian J;

    for (int i = 0; i < STEPS; i++) {
        system->jacobian(system->ctx, vec2_sub(*z, system->origin), &J);
        const struct vec2 f = J.field.direction;
        const double det = mat2_det(J.matrix);
        const struct vec2 step = {
            (J.matrix.yy * f.x - J.matrix.xy * f.y) / det,
            (J.matrix.xx * f.y - J.matrix.yx * f.x) / det
        };
        *z = vec2_sub(*z, step);
        if (!box_holds(system->domain, *z))
            return false;
        if (vec2_length(arrival_from(&s->scale, step, (struct vec2){ 0 })) <=
            TOL_ROUNDED)
            return true;
    }
    return false;
}

/* Whether the Jacobian determinant hardly changes from the middle of a box to
 * its corners: no curve of equilibria goes through, simple or double. */
static bool is_simple(const struct plane_study *s, struct vec2 z,
                      struct vec2 near)
{
    static const struct vec2 at[] = {
        { 0, 0 }, { -1, -1 }, { 1, -1 }, { -1, 1 }, { 1, 1 }
    };
    const struct planar *system = &s->system[0];
    double det[5];
    bool simple = true;

    for (int i = 0; i < 5; i++) {
        const struct vec2 d = { at[i].x * near.x, at[i].y * near.y };
        struct planar_jacobian J;
        system->jacobian(system->ctx, vec2_sub(vec2_add(z, d), system->origin),
                         &J);
        det[i] = exp(2.0 * J.field.log_scale) * mat2_det(J.matrix);
        simple = simple && fabs(det[i] - det[0]) < 0.5 * fabs(det[0]);
    }
    return simple;
}

static enum status append(struct plane_study *s,
                          const struct system_equilibrium *e, struct fault *why)
{
    struct plane_rest *more = realloc(s->rest, (s->rests + 1) * sizeof *more);
    struct plane_beyond at = { .rests = true };

    if (more == NULL)
        return STATUS_NO_MEMORY;
    s->rest = more;
    struct plane_rest *r = &s->rest[s->rests];
    *r = (struct plane_rest){ .name = NULL };
    const enum status status = fill(s, e, r, why);
    if (status != STATUS_OK) {
        free(r->plane);
        return status;
    }
    s->rests++;
    at.limit[0] = r->z.x;
    at.limit[1] = r->z.y;
    at.way[0] = at.way[1] = PLANE_WAY_LIMIT;
    plane_beyond_name(s, &at);
    snprintf(r->word, sizeof r->word, "%s", at.word);
    for (size_t i = 0; i < s->rests; i++) /* they may have moved */
        s->rest[i].name = s->rest[i].word;
    keep_apart(s);
    return plane_turn_find(s, &s->rest[s->rests - 1]);
}

enum status plane_rest_add(struct plane_study *s, struct vec2 z, size_t *index)
{
    struct system_equilibria *found;
    struct fault why;
    enum status status = STATUS_OK;

    *index = s->rests;
    if (!settle(s, &z))
        return STATUS_OK;
    *index = known_at(s, z);
    if (*index < s->rests || box_holds(plane_study_box(s), z) ||
        s->rests >= s->listed + PLANE_OUTSIDE)
        return STATUS_OK;
    const struct vec2 near = vec2_scale(TOL_BESIDE, s->scale.side);
    if (!is_simple(s, z, near)) {
        *index = s->rests;
        return STATUS_OK;
    }
    const struct system_window w = { { z.x - near.x, z.y - near.y },
                                     { z.x + near.x, z.y + near.y } };
    found = malloc(sizeof *found);
    if (found == NULL)
        return STATUS_NO_MEMORY;
    status = system_equilibria_find(s->scene->system, &w, found, &why);
    s->basin.steps += status ? 0 : found->boxes / TOL_PLANE_BOXES;
    if (status == STATUS_OK && found->count == 1 && found->complete &&
        found->equilibrium[0].type != SYSTEM_NONHYPERBOLIC)
        status = append(s, &found->equilibrium[0], &why);
    free(found);
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

double plane_rest_turns(const struct plane_rest *r)
{
    const double re = fabs(r->lambda[0].re.value);

    return r->type == PLANE_SADDLE || !(re > 0.0)
               ? 1.0
               : hypot(re, r->lambda[0].im.value) / re;
}
