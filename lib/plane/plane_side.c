#include "plane_side.h"

#include <stdlib.h>

/* Left and right of a manifold, from the end of its branch 0 to that of branch
 * 1. */
enum { SIDES = 2 };

/* Whereto the sides of all manifolds lead, by their first branches, and which
 * border a strand is of. */
struct sides {
    struct plane_study *s;
    struct patches *p;
    struct plane_goal (*goal)[SIDES];   /* owned */
    const struct plane_border **border; /* owned; by strand */
    enum plane_side *told;
    struct vec2 *at;
    bool given_up; /* a manifold that winds on */
};

/* ---- of a manifold ------------------------------------------------------- */

/* Which way a branch sets out. */
static struct vec2 start_of(const struct plane_branch *b)
{
    double slope[CURVE_DIM_MAX];

    curve_slope_at(&b->curve.curve, 0, 0.0, slope);
    return (struct vec2){ slope[0], slope[1] };
}

/* An absolute point of a branch, next to the saddle. */
static struct vec2 next_to(const struct plane_study *s,
                           const struct plane_branch *b)
{
    return vec2_add(s->rest[b->rest].z, curve_point(&b->curve.curve, 0, 1.0));
}

/* Stable branches 0 and 1 at b[0] and b[1], then the unstable ones; a branch
 * that comes to a saddle leads along both of that one's. */
static enum status find_sides(const struct plane_study *s,
                              const struct plane_branch b[4], plane_ask *ask,
                              void *ctx, struct plane_goal goal[SIDES])
{
    enum status status = STATUS_OK;

    for (int k = 0; k < 2 && b[1].curve.curve.count; k++)
        if (b[2 + k].curve.curve.count && b[2 + k].end != PLANE_END_SADDLE &&
            status == STATUS_OK) {
            const struct vec2 along = start_of(&b[1]),
                              out = start_of(&b[2 + k]);
            const bool right = vec2_cross(along, out) < 0.0;
            status = ask(ctx, next_to(s, &b[2 + k]), &goal[right]);
            if (goal[right].kind != PLANE_GOAL_REST &&
                goal[right].kind != PLANE_GOAL_CYCLE)
                goal[right].kind = PLANE_GOAL_NONE;
        }
    return status;
}

/* ---- of a region --------------------------------------------------------- */

/* Whereto the region on the right or on the left of a crossing goes, that
 * lies in the window; NULL: it is not known. */
static const struct plane_goal *goal_of(const struct sides *d,
                                        const struct crossing *c, bool right)
{
    const struct box w = d->s->window.box;
    const struct plane_border *b = d->border[c->strand];

    if (b == NULL || !(c->at >= w.lo.x && c->at <= w.hi.x))
        return NULL;
    const bool up = d->s->basin.cuts.strand[c->strand].way * b->way > 0;
    const struct plane_goal *goal = &d->goal[b->of][up == right];
    return goal->kind == PLANE_GOAL_NONE ? NULL : goal;
}

static void tell(struct sides *d, size_t region, const struct plane_goal *goal,
                 struct vec2 at)
{
    const size_t patch = plane_patch_of(d->p, region);
    struct plane_goal *own = &d->p->goal[patch];

    if (goal == NULL || d->p->alone[patch] ||
        d->told[patch] == PLANE_SIDE_DIFFER)
        return;
    if (d->told[patch] == PLANE_SIDE_NONE) {
        d->told[patch] = PLANE_SIDE_TOLD;
        d->at[patch] = at;
        *own = *goal;
    } else if (!plane_goal_is_same(d->s, own, goal)) {
        d->told[patch] = PLANE_SIDE_DIFFER;
        own->kind = PLANE_GOAL_NONE;
        d->s->basin.unknown[PLANE_UNKNOWN_BORDER] |= d->given_up;
    }
}

static void tell_band(struct sides *d, const struct band *band)
{
    const struct box w = d->s->window.box;
    struct crossing *c = d->p->below;
    const double y = off_middle(band->lo > w.lo.y ? band->lo : w.lo.y,
                                band->hi < w.hi.y ? band->hi : w.hi.y);
    const size_t n = separatrix_row(d->p->r->separatrix, y, c);

    for (size_t k = 0; n == band->strands && k <= n; k++) {
        const double lo = plane_patch_end(d->s, c, n, k),
                     hi = plane_patch_end(d->s, c, n, k + 1);
        const struct vec2 at = { off_middle(lo, hi), y };
        if (!(lo < hi))
            continue;
        tell(d, band->first + k, k > 0 ? goal_of(d, &c[k - 1], true) : NULL,
             at);
        tell(d, band->first + k, k < n ? goal_of(d, &c[k], false) : NULL, at);
    }
}

/* ---- all ----------------------------------------------------------------- */

static enum status find(struct sides *d, plane_ask *ask, void *ctx)
{
    const struct plane_basin *b = &d->s->basin;
    enum status status = STATUS_OK;

    for (size_t i = 0; i + 3 < d->s->listed_branches && status == STATUS_OK;
         i += 4)
        status = find_sides(d->s, &d->s->branch[i], ask, ctx, d->goal[i]);
    for (size_t i = 0; i < d->s->listed_branches; i++)
        d->given_up = d->given_up || (d->s->branch[i].kind == MANIFOLD_STABLE &&
                                      d->s->branch[i].end == PLANE_END_STEPS);
    for (size_t j = 0; j < b->borders; j++)
        for (size_t i = b->border[j].first; i < b->border[j].last; i++)
            if (b->border[j].of < d->s->listed_branches &&
                d->s->branch[b->border[j].of].kind == MANIFOLD_STABLE)
                d->border[i] = &b->border[j];
    for (size_t i = 0; i < d->p->r->bands && status == STATUS_OK; i++)
        if (plane_patch_is_door(d->s, &d->p->r->band[i]))
            tell_band(d, &d->p->r->band[i]);
    return status;
}

enum status plane_side_find(struct plane_study *s, struct patches *p,
                            plane_ask *ask, void *ctx, enum plane_side told[],
                            struct vec2 at[])
{
    struct sides d = { .s = s, .p = p, .told = told, .at = at };
    enum status status = STATUS_NO_MEMORY;

    d.goal = calloc(s->listed_branches + 1, sizeof *d.goal);
    d.border = (const struct plane_border **) calloc(s->basin.cuts.count + 1,
                                                     sizeof *d.border);
    if (d.goal && d.border)
        status = find(&d, ask, ctx);
    free(d.goal);
    free((void *) d.border);
    return status;
}
