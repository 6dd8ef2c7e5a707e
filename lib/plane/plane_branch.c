/* After every piece the nearest point to each equilibrium is looked for: an
 * invariant straight line is one long step, which may run through several. */
#include "plane_branch.h"

#include <math.h>
#include <stdlib.h>

#include "grow.h"
#include "plane_cycle.h"
#include "plane_defined.h"
#include "plane_length.h"
#include "plane_rest.h"
#include "plane_slow.h"
#include "plane_tolerance.h"
#include "plane_weak.h"
#include "tolerance.h"

const char *const plane_end_names[] = { "equilibrium", "cycle", "saddle",
                                        "infinity",    "edge",  "singularity",
                                        "steps",       NULL };

/* ---- a branch in the making ---------------------------------------------- */

/* Both halves of a manifold, by the side that they grow to. */
struct half {
    struct windings windings;
    const struct winding *round; /* of those, once it closes */
    bool left;                   /* it has been away from its saddle */
    bool lost;                   /* where the last piece ends is not known */
    bool broken;   /* formulas may have no values after theta, or an
                      equilibrium that is not known may be there */
    int8_t end;    /* enum plane_end, -1 */
    size_t to;     /* rest */
    double theta;  /* on the last piece */
    double beyond; /* of its length, at most */
};

static struct half half_begin(void)
{
    return (struct half){ .windings = windings_begin(0.0), .end = -1 };
}

struct following {
    const struct plane_study *s;
    const struct plane_rest *from;
    const struct planar *system; /* about it, of which the branch is stable */
    int backward;                /* 1: branches are followed backward in time,
                                    as stable ones are */
    struct vec2 *rests;          /* borrowed: of all */
    struct half half[2];
};

/* At equilibrium i, which is d beside theta of the last piece. */
static void end_at(const struct plane_study *s, struct half *h, size_t i,
                   double theta, double d)
{
    const struct plane_rest *r = &s->rest[i];
    const double side = fmax(s->scale.side.x, s->scale.side.y);

    h->end = r->type == PLANE_SADDLE ? PLANE_END_SADDLE : PLANE_END_EQUILIBRIUM;
    h->to = i;
    h->theta = theta;
    h->beyond = 2.0 * d * side * plane_rest_turns(r);
}

/* Whether the piece ends at this equilibrium, before where it ended so far. */
static void look_at(const struct following *f, struct half *h,
                    const struct branch *b, size_t i, double bar)
{
    const struct plane_rest *r = &f->s->rest[i];
    const struct trap_form *trap = &r->trap[f->backward];
    const struct vec2 side = f->s->scale.side;
    const double touch =
        4.0 * bar + 4.0 * vec2_length(r->error) / fmin(side.x, side.y);
    double theta;

    if (r == f->from && !h->left)
        return;
    const double near = fmax(fmax(touch, TOL_TOUCH), TOL_SAME * trap->size);
    const double d =
        arrival_nearest(&f->s->scale, &b->curve, b->curve.count - 1, f->from->z,
                        r->z, near, &theta);
    if (h->theta >= theta && d <= near)
        end_at(f->s, h, i, theta, d);
}

/* Up to where the piece is a branch: from there on formulas may have no
 * values, or there may be an equilibrium that is not known. */
static void break_off(const struct following *f, struct half *h,
                      const struct branch *b, double bar)
{
    const size_t last = b->curve.count - 1;
    const double touch = fmax(4.0 * bar, TOL_TOUCH);
    double theta;
    const enum plane_defined d = plane_defined_along(
        f->s->plan, f->s, &b->curve, last, f->from->z, &theta);

    h->theta = d == PLANE_DEFINED ? 1.0 : theta;
    h->broken = d != PLANE_DEFINED;
    if (d == PLANE_DEFINED_BREAKS)
        h->end = PLANE_END_SINGULARITY;
    if (!plane_weak_along(f->s, &b->curve, last, f->from->z, touch, &theta) ||
        theta > h->theta)
        return;
    h->theta = theta;
    h->broken = true;
    h->end = -1;
}

static bool branch_ends(void *ctx, const struct branch *b, struct vec2 z,
                        double error)
{
    struct following *f = ctx;
    struct half *h = &f->half[b->side < 0];
    const struct vec2 side = f->s->scale.side;
    const double bar = error / fmin(side.x, side.y);
    const struct vec2 away =
        arrival_from(&f->s->scale, vec2_add(f->from->z, z), f->from->z);

    h->lost = !(bar <= TOL_SEEN);
    if (h->lost)
        return true;
    break_off(f, h, b, bar);
    for (size_t i = 0; i < f->s->rests; i++)
        look_at(f, h, b, i, bar);
    if (h->end >= 0 || h->broken)
        return true;
    h->left = h->left || vec2_length(away) > TOL_LITTLE;
    h->round = windings_add(&h->windings, f->system, &f->s->scale, &b->curve,
                            b->curve.count - 1, f->rests, f->s->rests);
    if (h->round != NULL)
        h->end = PLANE_END_CYCLE;
    return h->round != NULL;
}

/* The last piece up to theta. */
static void cut(struct curve *c, double theta)
{
    const struct curve_piece *p = &c->piece[c->count - 1];

    for (size_t i = 0; i < c->dim; i++) {
        double *coef = c->coef + p->first + i * (p->degree + 1), power = 1.0;
        for (size_t j = 1; j <= p->degree; j++) {
            power *= theta;
            coef[j] *= power;
        }
    }
}

/* ---- all manifolds ------------------------------------------------------- */

static struct vec2 last_point(const struct plane_study *s,
                              const struct plane_branch *b)
{
    const size_t n = b->curve.curve.count;

    return n ? plane_length_point(b, s->rest[b->rest].z, n - 1, 1.0)
             : s->rest[b->rest].z;
}

/* Whether it has left all that is looked at. */
static bool is_infinite(const struct plane_branch *b, const struct half *h)
{
    return b->curve.end == BRANCH_DOMAIN && !h->lost;
}

/* A branch that could not be followed to the end may have come into a trap. */
static void look_for_trap(const struct plane_study *s,
                          const struct plane_branch *b, struct half *h)
{
    const bool backward = b->kind == MANIFOLD_STABLE;
    const struct vec2 z = last_point(s, b);

    for (size_t i = 0; i < s->rests && h->end < 0; i++) {
        const struct trap_form *t = &s->rest[i].trap[backward];
        const double d = trap_form_distance(t, &s->scale, z);
        if (plane_rest_traps(s, &s->rest[i], backward, z))
            end_at(s, h, i, 1.0, d < t->size ? d : HUGE_VAL);
    }
}

/* ---- beyond the window --------------------------------------------------- */

/* It ends where it comes to an equilibrium outside the window within its bar:
 * there rounding decides which way it goes on. */
static enum status look_at_slow(struct plane_study *s, struct plane_branch *b,
                                size_t piece, double theta, struct half *h)
{
    const struct vec2 origin = s->rest[b->rest].z, side = s->scale.side;
    size_t i;

    const enum status status =
        plane_rest_add(s, plane_length_point(b, origin, piece, theta), &i);
    if (status != STATUS_OK || i == s->rests)
        return status;
    const struct plane_rest *r = &s->rest[i];
    const double most = fmin(side.x, side.y);
    const double near =
        4.0 *
        fmax((b->curve.curve.piece[piece].error + vec2_length(r->error)) / most,
             TOL_TOUCH);
    const double d = arrival_nearest(&s->scale, &b->curve.curve, piece, origin,
                                     r->z, near, &theta);
    if (!(d <= near))
        return STATUS_OK;
    end_at(s, h, i, theta, d);
    b->curve.curve.count = piece + 1;
    return STATUS_OK;
}

/* One is looked for where the plane is slow, and slower than beside, and where
 * Newton's steps come to from the end, which may be in its trap. */
static enum status look_outside(struct plane_study *s, struct plane_branch *b,
                                struct half *h)
{
    struct plane_slow slow = { .s = s, .b = b };
    enum status status = STATUS_OK;
    double theta;
    size_t at;

    if (h->end >= 0 || box_holds(plane_study_box(s), last_point(s, b)))
        return STATUS_OK;
    while (h->end < 0 && !h->broken && status == STATUS_OK &&
           plane_slow_next(&slow, &at, &theta))
        status = look_at_slow(s, b, at, theta, h);
    return status || h->end >= 0 || is_infinite(b, h)
               ? status
               : look_at_slow(s, b, b->curve.curve.count - 1,
                              h->broken ? h->theta : 1.0, h);
}

static int8_t end_of(const struct plane_study *s, const struct plane_branch *b,
                     struct half *h)
{
    if (h->end < 0 && !is_infinite(b, h))
        look_for_trap(s, b, h);
    if (h->end < 0 && b->curve.end == BRANCH_STEPS &&
        !plane_defined_near(s->plan, s, last_point(s, b), TOL_PLANE_STILL))
        h->end = PLANE_END_SINGULARITY;
    if (h->end >= 0)
        return h->end;
    if (is_infinite(b, h))
        return PLANE_END_INFINITY;
    return !box_holds(plane_study_box(s), last_point(s, b)) ? PLANE_END_EDGE
           : b->curve.end == BRANCH_STEPS                   ? PLANE_END_STEPS
                                                            : -1;
}

static enum status settle(struct plane_study *s, struct plane_branch *b,
                          struct half *h)
{
    size_t cycle;
    enum status status = look_outside(s, b, h);

    if (status != STATUS_OK)
        return status;
    if (h->broken || h->end == PLANE_END_EQUILIBRIUM ||
        h->end == PLANE_END_SADDLE)
        cut(&b->curve.curve, h->theta);
    b->end = end_of(s, b, h);
    b->to = (b->end == PLANE_END_EQUILIBRIUM || b->end == PLANE_END_SADDLE) &&
                    h->to < s->listed
                ? (int64_t) h->to
                : RECORD_COUNT_NONE;
    if (b->end == PLANE_END_CYCLE) {
        status =
            plane_cycle_add(s, h->round, b->kind == MANIFOLD_UNSTABLE, &cycle);
        b->to = cycle < s->cycles ? (int64_t) cycle : RECORD_COUNT_NONE;
        b->end = cycle < s->cycles ? b->end : -1;
    }
    if (b->end == PLANE_END_SINGULARITY) /* plane_defined_near */
        h->beyond =
            2.0 * TOL_PLANE_STILL * fmax(s->scale.side.x, s->scale.side.y);
    plane_length_find(s, b, h->end >= 0 ? h->beyond : 0.0);
    return status;
}

/* An offset on the last piece. */
static struct vec2 on_last(const struct branch *b, double theta)
{
    return curve_point(&b->curve, b->curve.count - 1, theta);
}

/* How far the last piece goes in x or y. */
static double last_extent(const struct branch *b)
{
    const struct vec2 d = vec2_sub(on_last(b, 1.0), on_last(b, 0.0));

    return fmax(fabs(d.x), fabs(d.y));
}

/* Just outside the window. */
static struct box about_window(const struct following *f)
{
    const struct box w = plane_study_box(f->s), far = f->system->domain;
    const struct vec2 room = vec2_scale(TOL_MARGIN, f->s->scale.side);

    return (struct box){
        { fmax(far.lo.x, w.lo.x - room.x), fmax(far.lo.y, w.lo.y - room.y) },
        { fmin(far.hi.x, w.hi.x + room.x), fmin(far.hi.y, w.hi.y + room.y) }
    };
}

/* A branch that is lost on a piece that begins in the window is too far out on
 * it, or has run through an equilibrium, behind which it is none: it is grown
 * again to just outside the window, then by steps half as long as the one that
 * it is lost on, until it is not.  Else the lost piece is left out. */
static enum status go_nearer(struct following *f, const struct local_series *u,
                             const struct grow_options *options,
                             struct branch *b)
{
    const struct box w = plane_study_box(f->s);
    struct half *h = &f->half[b->side < 0];
    struct planar near = *f->system;
    struct grow_options o = *options;
    enum status status = STATUS_OK;

    near.domain = about_window(f);
    o.longest = HUGE_VAL;
    while (status == STATUS_OK && h->lost && b->curve.count > 1 &&
           box_holds(w, vec2_add(f->from->z, on_last(b, 0.0)))) {
        const int side = b->side;
        branch_free(b);
        *h = half_begin();
        status = grow_branch(&near, u, side, &o, b);
        if (status != STATUS_OK)
            break;
        if (h->lost) {
            o.longest = 0.5 * fmin(o.longest, last_extent(b));
            continue;
        }
        if (h->end >= 0 || b->end != BRANCH_DOMAIN)
            break;
        h->lost = true; /* from there on */
        return STATUS_OK;
    }
    b->curve.count -= h->lost && b->curve.count > 1;
    return status;
}

/* Adds both branches of one manifold; where it has no series they are empty. */
static enum status grow_at(struct plane_study *s, int64_t saddle, size_t rest,
                           enum manifold_kind kind, double rtol,
                           const struct monitor *monitor)
{
    struct vec2 *rests = calloc(s->rests + 1, sizeof *rests);
    struct plane_branch *more =
        realloc(s->branch, (s->branches + 2) * sizeof *more);
    const struct plane_rest *r = &s->rest[rest];
    const int way = kind == MANIFOLD_STABLE ? 0 : 1;
    struct following f = { .s = s,
                           .from = r,
                           .system = &r->system[way],
                           .backward = 1 - way,
                           .rests = rests };
    const struct grow_follower follower = { branch_ends, &f };
    struct grow_options o = grow_defaults(TOL_PLANE_PART * rtol);
    struct branch half[2] = { { .curve = CURVE_EMPTY(2) },
                              { .curve = CURVE_EMPTY(2) } };
    struct local_series u = { .ind = 0 };
    struct equilibrium e;

    s->branch = more ? more : s->branch;
    if (rests == NULL || more == NULL) {
        free(rests);
        return STATUS_NO_MEMORY;
    }
    for (size_t i = 0; i < s->rests; i++)
        rests[i] = s->rest[i].z;
    f.half[0] = f.half[1] = half_begin();
    o.max_steps *= 2; /* bands times regions grow as their square */
    o.follower = &follower;
    o.monitor = monitor;
    equilibrium_at(f.system, false, &e);
    enum status status = local_at(f.system, &e, MANIFOLD_STABLE, &o.carry,
                                  o.order, TOL_TAYLOR_STEP * o.rtol, &u);
    if (status == STATUS_OK)
        status = grow_branches(f.system, &u, &o, half);
    for (int k = 0; k < 2 && status == STATUS_OK; k++)
        status = go_nearer(&f, &u, &o, &half[k]);
    free(rests);
    if (status == STATUS_NO_MEMORY || status == STATUS_STOPPED) {
        branch_free(&half[0]);
        branch_free(&half[1]);
        return status;
    }
    const bool turned = u.ind == 1 && u.c[1] < 0.0;
    for (int k = 0; k < 2; k++) {
        struct plane_branch *b = &s->branch[s->branches++];
        const int from = turned ? 1 - k : k;
        *b = (struct plane_branch){ .saddle = saddle,
                                    .rest = rest,
                                    .kind = (int8_t) kind,
                                    .branch = k,
                                    .curve = half[from] };
        b->curve.kind = kind;
        status = settle(s, b, &f.half[from]);
        if (status != STATUS_OK)
            return status;
    }
    return STATUS_OK;
}

/* Whether how far it was followed may have decided where it ends. */
static bool is_unsure(const struct plane_branch *b)
{
    return b->end < 0 || b->end == PLANE_END_EDGE ||
           b->end == PLANE_END_STEPS ||
           ((b->end == PLANE_END_EQUILIBRIUM || b->end == PLANE_END_SADDLE) &&
            b->to == RECORD_COUNT_NONE);
}

/* Where branches end is the same whatever accuracy is asked for: one of which
 * that may not be so is the one to TOL_RTOL_DEFAULT. */
static enum status grow(struct plane_study *s, int64_t saddle, size_t rest,
                        enum manifold_kind kind, const struct monitor *monitor)
{
    const size_t n = s->branches;
    enum status status =
        grow_at(s, saddle, rest, kind, s->scene->rtol, monitor);

    if (status != STATUS_OK || s->branches < n + 2 ||
        !(is_unsure(&s->branch[n]) || is_unsure(&s->branch[n + 1])) ||
        fabs(s->scene->rtol - TOL_RTOL_DEFAULT) < 0.5 * TOL_RTOL_DEFAULT)
        return status;
    status = grow_at(s, saddle, rest, kind, TOL_RTOL_DEFAULT, monitor);
    for (size_t i = n; i < n + 2 && i + 2 < s->branches; i++)
        if (is_unsure(&s->branch[i])) {
            const struct plane_branch old = s->branch[i];
            s->branch[i] = s->branch[i + 2];
            s->branch[i + 2] = old;
        }
    while (s->branches > n + 2)
        branch_free(&s->branch[--s->branches].curve);
    return status;
}

enum status plane_branch_grow(struct plane_study *s,
                              const struct monitor *monitor)
{
    enum status status = STATUS_OK;
    int64_t saddle = 0;

    for (size_t i = 0; i < s->listed && status == STATUS_OK; i++) {
        if (s->rest[i].type != PLANE_SADDLE)
            continue;
        if (monitor_tell(monitor, "saddles", (uint64_t) saddle, s->saddles))
            status = STATUS_STOPPED;
        if (status == STATUS_OK)
            status = grow(s, saddle, i, MANIFOLD_STABLE, monitor);
        if (status == STATUS_OK)
            status = grow(s, saddle, i, MANIFOLD_UNSTABLE, monitor);
        saddle++;
    }
    s->listed_branches = s->branches;
    return status;
}

enum status plane_branch_grow_outside(struct plane_study *s)
{
    enum status status = STATUS_OK;
    size_t first = s->listed;

    if (s->branches > s->listed_branches)
        first = s->branch[s->branches - 1].rest + 1;
    for (size_t i = first; i < s->rests && status == STATUS_OK; i++)
        if (s->rest[i].type == PLANE_SADDLE)
            status = grow_at(s, RECORD_COUNT_NONE, i, MANIFOLD_STABLE,
                             s->scene->rtol, NULL);
    return status;
}
