/* Limits at infinity of the chart: no map of the circle at infinity is made.
 * Of each end so much is known as all orbits to it have in common. */
#include "plane_beyond.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plane_tolerance.h"

/* ---- one orbit ----------------------------------------------------------- */

static enum plane_way way_of(const struct plane_study *s, int axis, double z)
{
    const double lo = vec2_part(s->window.box.lo, axis),
                 hi = vec2_part(s->window.box.hi, axis);

    if (vec2_part(s->scale.period, axis) > 0.0)
        return PLANE_WAY_UNKNOWN;
    return z > 2.0 * hi - lo   ? PLANE_WAY_UP
           : z < 2.0 * lo - hi ? PLANE_WAY_DOWN
                               : PLANE_WAY_UNKNOWN;
}

/* Whether a coordinate moves by little while the other one grows by itself: as
 * a power of that it would come to something else. */
static bool is_done(const struct plane_study *s, struct vec2 z,
                    struct vec2 rate, int axis)
{
    const struct vec2 from = vec2_sub(z, s->system[0].origin);

    return fabs(vec2_part(rate, axis) * vec2_part(from, 1 - axis)) <=
           TOL_SAME * vec2_part(s->scale.side, axis) *
               fabs(vec2_part(rate, 1 - axis));
}

/* Whether the rate decays by itself, J f = tr(J) f: so it does beside a line of
 * equilibria, where J has the eigenvalue 0 along it, and not on a slow curve.
 */
static bool is_beside_line(const struct mat2 *m, struct vec2 f)
{
    const double trace = m->xx + m->yy;
    const struct vec2 off = { m->xy * f.y - m->yy * f.x,
                              m->yx * f.x - m->xx * f.y };

    return vec2_length(off) <= TOL_SEEN * fabs(trace) * vec2_length(f);
}

/* Whether Newton's step from there, by the field and its Jacobian, is as short
 * as what is still at the fastest rate; along a line of equilibria, by the
 * Jacobian's size.  A slow plane is no resting one. */
static bool is_resting(const struct plane_study *s,
                       const struct planar_jacobian *J)
{
    const struct mat2 m = J->matrix;
    const struct vec2 f = J->field.direction;
    const double det = mat2_det(m), size = fmax(fmax(fabs(m.xx), fabs(m.xy)),
                                                fmax(fabs(m.yx), fabs(m.yy)));
    const bool line = !(fabs(det) > TOL_ROUNDED * size * size);
    const struct vec2 side = s->scale.side,
                      step =
                          line ? vec2_scale(1.0 / size, f)
                               : (struct vec2){ (m.yy * f.x - m.xy * f.y) / det,
                                                (m.xx * f.y - m.yx * f.x) /
                                                    det };

    return hypot(step.x / side.x, step.y / side.y) <= TOL_PLANE_STILL &&
           (!line || is_beside_line(&m, f));
}

bool plane_beyond_at(const struct plane_study *s, struct vec2 z, bool backward,
                     bool left, struct plane_beyond *out)
{
    const struct planar *system = &s->system[backward];
    bool still[2];
    struct planar_jacobian J;

    if (!left && box_holds(s->window.box, z))
        return false;
    system->jacobian(system->ctx, vec2_sub(z, system->origin), &J);
    const struct planar_field f = J.field;
    for (int i = 0; i < 2; i++)
        still[i] = fabs(vec2_part(f.direction, i)) * exp(f.log_scale) <=
                   TOL_PLANE_STILL * s->kappa * vec2_part(s->scale.side, i);
    const bool rests = still[0] && still[1] && is_resting(s, &J);
    if (!left && !rests)
        return false;
    *out = (struct plane_beyond){ .rests = !left };
    for (int i = 0; i < 2; i++) {
        out->limit[i] = vec2_part(z, i);
        out->way[i] = still[i] && (rests || is_done(s, z, f.direction, i))
                          ? PLANE_WAY_LIMIT
                          : way_of(s, i, vec2_part(z, i));
    }
    const double far[] = { fabs(z.x - system->origin.x) / s->scale.side.x,
                           fabs(z.y - system->origin.y) / s->scale.side.y };
    const int more = far[1] > far[0];
    if (!rests && out->way[0] == PLANE_WAY_LIMIT &&
        out->way[1] == PLANE_WAY_LIMIT) /* one of them goes there */
        out->way[more] = way_of(s, more, vec2_part(z, more));
    return true;
}

/* ---- two ends ------------------------------------------------------------ */

static bool same_way(const struct plane_study *s, int axis,
                     const struct plane_beyond *a, const struct plane_beyond *b)
{
    const struct vec2 d =
        arrival_from(&s->scale, (struct vec2){ a->limit[0], a->limit[1] },
                     (struct vec2){ b->limit[0], b->limit[1] });

    return a->way[axis] == b->way[axis] &&
           (a->way[axis] != PLANE_WAY_LIMIT ||
            fabs(vec2_part(d, axis)) <= TOL_SAME);
}

bool plane_beyond_agree(const struct plane_study *s,
                        const struct plane_beyond *a,
                        const struct plane_beyond *b)
{
    bool alike = a->rests == b->rests && a->breaks == b->breaks;

    for (int i = 0; i < 2; i++)
        alike =
            alike && (a->way[i] == PLANE_WAY_UNKNOWN ||
                      b->way[i] == PLANE_WAY_UNKNOWN || same_way(s, i, a, b));
    return alike;
}

void plane_beyond_meet(const struct plane_study *s, struct plane_beyond *a,
                       const struct plane_beyond *b)
{
    for (int i = 0; i < 2; i++)
        if (!same_way(s, i, a, b))
            a->way[i] = PLANE_WAY_UNKNOWN;
}

/* ---- all ends ------------------------------------------------------------ */

enum status plane_beyond_add(struct plane_study *s,
                             const struct plane_beyond *new)
{
    struct plane_beyond all = *new;
    struct plane_beyond *more =
        realloc(s->beyond, (s->beyonds + 1) * sizeof *more);
    size_t i = 0;

    if (more == NULL)
        return STATUS_NO_MEMORY;
    s->beyond = more;
    while (i < s->beyonds) {
        if (!plane_beyond_agree(s, &all, &s->beyond[i])) {
            i++;
            continue;
        }
        plane_beyond_meet(s, &all, &s->beyond[i]);
        s->beyonds--;
        memmove(&s->beyond[i], &s->beyond[i + 1],
                (s->beyonds - i) * sizeof *s->beyond);
        i = 0; /* it agrees with more now */
    }
    s->beyond[s->beyonds++] = all;
    return STATUS_OK;
}

/* "x_to_0": no blank, as names of labels are. */
static void add_word(const struct plane_study *s, int axis,
                     struct plane_beyond *b)
{
    const struct planar_axis *a = &s->system[0].axis[axis];
    const size_t n = strlen(b->word);
    const double limit = plane_state(s, axis, b->limit[axis]);
    const bool none =
        fabs(limit) <= TOL_SAME * vec2_part(s->scale.side, axis) && !a->is_log;
    char at[32];

    if (b->way[axis] == PLANE_WAY_UNKNOWN)
        return;
    if (b->way[axis] == PLANE_WAY_LIMIT)
        snprintf(at, sizeof at, "%.5g", none ? 0.0 : limit);
    else
        strcpy(at, b->way[axis] == PLANE_WAY_UP ? "infinity"
                   : a->is_log                  ? "0"
                                                : "-infinity");
    snprintf(b->word + n, sizeof b->word - n, "%s%s_to_%s", n ? "_" : "",
             a->name, at);
}

void plane_beyond_name(const struct plane_study *s, struct plane_beyond *b)
{
    b->word[0] = '\0';
    add_word(s, 0, b);
    add_word(s, 1, b);
    if (b->word[0] == '\0')
        strcpy(b->word, b->breaks  ? "singularity"
                        : b->rests ? "outside"
                                   : "infinity");
}

enum status plane_beyond_finish(struct plane_study *s)
{
    struct plane_beyond *more =
        realloc(s->beyond, (s->beyonds + 2) * sizeof *more);

    if (more == NULL)
        return STATUS_NO_MEMORY;
    s->beyond = more;
    for (int rests = 0; rests < 2; rests++) {
        bool known = false;
        for (size_t i = 0; i < s->beyonds; i++)
            known =
                known || (s->beyond[i].rests == rests && !s->beyond[i].breaks &&
                          !s->beyond[i].way[0] && !s->beyond[i].way[1]);
        if (!known)
            s->beyond[s->beyonds++] = (struct plane_beyond){ .rests = rests };
    }
    for (size_t i = 0; i < s->beyonds; i++)
        plane_beyond_name(s, &s->beyond[i]);
    return STATUS_OK;
}
