/* After every piece the nearest point to each equilibrium is looked for: an
 * invariant straight line is one long step, which may run through several. */
#include "plane_branch.h"

#include <math.h>
#include <stdlib.h>

#include "escape.h"
#include "grow.h"
#include "plane_cycle.h"
#include "plane_defined.h"
#include "plane_rest.h"
#include "plane_tolerance.h"
#include "plane_weak.h"
#include "tolerance.h"

const char *const plane_end_names[] = { "equilibrium", "cycle", "saddle",
                                        "infinity",    "edge",  "singularity",
                                        "steps",       NULL };

/* ---- a branch in the making ---------------------------------------------- */

/* Both halves of a manifold, by the side that they grow to. */
struct half {
    struct winding winding;
    bool left;     /* it has been away from its saddle */
    bool broken;   /* formulas may have no values after theta, or an
                      equilibrium that is not known may be there */
    int8_t end;    /* enum plane_end, -1 */
    size_t to;     /* rest */
    double theta;  /* on the last piece */
    double beyond; /* of its length, at most */
};

struct following {
    const struct plane_study *s;
    const struct plane_rest *from;
    const struct planar *system; /* about it, of which the branch is stable */
    int backward;                /* 1: branches are followed backward in time,
                                    as stable ones are */
    struct vec2 *rests;          /* borrowed: of all */
    struct half half[2];
};

/* How much longer than straight the way into it is, at most: a spiral's. */
static double turns_of(const struct plane_rest *r)
{
    const double re = fabs(r->lambda[0].re.value);

    return r->type == PLANE_SADDLE || !(re > 0.0)
               ? 1.0
               : hypot(re, r->lambda[0].im.value) / re;
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
    if (h->theta < theta || !(d <= near))
        return;
    h->end = r->type == PLANE_SADDLE ? PLANE_END_SADDLE : PLANE_END_EQUILIBRIUM;
    h->to = i;
    h->theta = theta;
    h->beyond = 2.0 * d * fmax(side.x, side.y) * turns_of(r);
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

    if (!(bar <= TOL_SEEN))
        return true;
    break_off(f, h, b, bar);
    for (size_t i = 0; i < f->s->rests; i++)
        look_at(f, h, b, i, bar);
    if (h->end >= 0 || h->broken)
        return true;
    h->left = h->left || vec2_length(away) > TOL_LITTLE;
    if (winding_add(&h->winding, f->system, &f->s->scale, &b->curve,
                    b->curve.count - 1, f->rests, f->s->rests)) {
        h->end = PLANE_END_CYCLE;
        return true;
    }
    return false;
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

/* ---- what is shown of it ------------------------------------------------- */

static struct vec2 point(const struct plane_branch *b, const struct vec2 origin,
                         size_t piece, double theta)
{
    double at[CURVE_DIM_MAX];

    curve_at(&b->curve.curve, piece, theta, at);
    return vec2_add(origin, (struct vec2){ at[0], at[1] });
}

/* Up to where it last leaves the window, for good. */
static void find_shown(const struct plane_study *s, struct plane_branch *b)
{
    enum { SAMPLES = 32 };
    const struct vec2 origin = s->rest[b->rest].z;
    const struct box w = plane_study_box(s);

    for (size_t i = b->curve.curve.count; i-- > 0;) {
        if (!escape_may_touch(&b->curve.curve, i, origin, w))
            continue;
        for (int k = SAMPLES; k >= 0; k--) {
            double in = (double) k / SAMPLES, out = (k + 1.0) / SAMPLES;
            if (!box_holds(w, point(b, origin, i, in)))
                continue;
            b->shown = i + 1;
            b->shown_to = 1.0;
            if (k == SAMPLES)
                return;
            for (int n = 0; n < 52; n++) {
                const double middle = 0.5 * (in + out);
                *(box_holds(w, point(b, origin, i, middle)) ? &in : &out) =
                    middle;
            }
            b->shown_to = in;
            return;
        }
    }
}

/* Five Gauss points on `parts` parts of the piece. */
static double arc(const struct curve *c, size_t piece, double to, int parts)
{
    static const double node[] = { 0.0, 0.5384693101056831, -0.5384693101056831,
                                   0.9061798459386640, -0.9061798459386640 };
    static const double weight[] = { 0.5688888888888889, 0.4786286704993665,
                                     0.4786286704993665, 0.2369268850561891,
                                     0.2369268850561891 };
    double sum = 0.0, slope[CURVE_DIM_MAX];
    const double half = 0.5 * to / parts;

    for (int k = 0; k < parts; k++)
        for (int i = 0; i < 5; i++) {
            curve_slope_at(c, piece, (2 * k + 1 + node[i]) * half, slope);
            sum += half * weight[i] * hypot(slope[0], slope[1]);
        }
    return sum;
}

static void measure(const struct plane_study *s, struct plane_branch *b,
                    double beyond)
{
    double sum = 0.0, error = vec2_length(s->rest[b->rest].error) + beyond;

    find_shown(s, b);
    for (size_t i = 0; i < b->shown; i++) {
        const double to = i + 1 == b->shown ? b->shown_to : 1.0;
        const double fine = arc(&b->curve.curve, i, to, 4);
        const double coarse = arc(&b->curve.curve, i, to, 3);
        sum += fine;
        error += fabs(fine - coarse) + 1e-15 * sum +
                 4.0 * b->curve.curve.piece[i].error;
    }
    b->length = quantity_of(sum, error < sum ? error : HUGE_VAL);
}

/* ---- all manifolds ------------------------------------------------------- */

static struct vec2 last_point(const struct plane_study *s,
                              const struct plane_branch *b)
{
    const size_t n = b->curve.curve.count;

    return n ? point(b, s->rest[b->rest].z, n - 1, 1.0) : s->rest[b->rest].z;
}

/* A branch that could not be followed to the end may have come into a trap. */
static void look_for_trap(const struct plane_study *s,
                          const struct plane_branch *b, struct half *h)
{
    const int backward = b->kind == MANIFOLD_STABLE;
    const struct vec2 z = last_point(s, b);

    for (size_t i = 0; i < s->rests && h->end < 0; i++) {
        const struct trap_form *t = &s->rest[i].trap[backward];
        const double d = trap_form_distance(t, &s->scale, z);
        if (!plane_rest_traps(s, &s->rest[i], backward, z))
            continue;
        h->end = PLANE_END_EQUILIBRIUM;
        h->to = i;
        h->theta = 1.0;
        h->beyond = !(d < t->size)
                        ? HUGE_VAL
                        : 2.0 * d * fmax(s->scale.side.x, s->scale.side.y) *
                              turns_of(&s->rest[i]);
    }
}

/* ---- beyond the window --------------------------------------------------- */

enum { LOOKS = 16 }; /* a piece */

/* How fast the plane is at look n, of any curve: LOOKS a piece. */
static double speed_at(const struct plane_study *s,
                       const struct plane_branch *b, double look)
{
    const double piece =
        fmin(floor(look / LOOKS), (double) b->curve.curve.count - 1.0);

    return plane_study_speed(
        s, point(b, s->rest[b->rest].z, (size_t) piece, look / LOOKS - piece));
}

/* The look at which it is slowest, within one of `look`. */
static double slowest(const struct plane_study *s, const struct plane_branch *b,
                      double look)
{
    double best = speed_at(s, b, look), width = 0.5;

    for (int i = 0; i < 120; i++) {
        const double at = look + (i % 2 ? width : -width);
        const double speed = speed_at(s, b, at);
        if (speed < best) {
            best = speed;
            look = at;
        } else if (i % 2) {
            width *= 0.5;
        }
    }
    return look;
}

/* It ends where it comes to an equilibrium outside the window within its bar:
 * there rounding decides which way it goes on. */
static enum status look_at_slow(struct plane_study *s, struct plane_branch *b,
                                double look, struct half *h)
{
    const struct vec2 origin = s->rest[b->rest].z, side = s->scale.side;
    const double at = slowest(s, b, look);
    const size_t piece = (size_t) (at / LOOKS);
    size_t i;

    const enum status status = plane_rest_add(
        s, point(b, origin, piece, at / LOOKS - (double) piece), &i);
    if (status != STATUS_OK || i == s->rests)
        return status;
    const struct plane_rest *r = &s->rest[i];
    const double most = fmin(side.x, side.y);
    const double near =
        4.0 *
        fmax((b->curve.curve.piece[piece].error + vec2_length(r->error)) / most,
             TOL_TOUCH);
    double theta;
    const double d = arrival_nearest(&s->scale, &b->curve.curve, piece, origin,
                                     r->z, near, &theta);
    if (!(d <= near))
        return STATUS_OK;
    h->end = r->type == PLANE_SADDLE ? PLANE_END_SADDLE : PLANE_END_EQUILIBRIUM;
    h->to = i;
    h->theta = theta;
    h->beyond = 2.0 * d * fmax(side.x, side.y) * turns_of(r);
    b->curve.curve.count = piece + 1;
    return STATUS_OK;
}

/* One is looked for where the plane is slow, and slower than beside. */
static enum status look_outside(struct plane_study *s, struct plane_branch *b,
                                struct half *h)
{
    const size_t looks = LOOKS * b->curve.curve.count;
    double speed[3] = { 0.0, 0.0, 0.0 }, fastest = 0.0;
    enum status status = STATUS_OK;

    if (h->end >= 0 || h->broken ||
        box_holds(plane_study_box(s), last_point(s, b)))
        return STATUS_OK;
    for (size_t n = 0; n < looks && h->end < 0 && status == STATUS_OK; n++) {
        speed[0] = speed[1];
        speed[1] = speed[2];
        speed[2] = speed_at(s, b, (double) n);
        fastest = fmax(fastest, speed[2]);
        if (speed[1] < speed[0] && speed[1] < speed[2] &&
            speed[1] < TOL_SEEN * fastest)
            status = look_at_slow(s, b, (double) n - 1.0, h);
    }
    return status;
}

static int8_t end_of(const struct plane_study *s, const struct plane_branch *b,
                     struct half *h)
{
    if (h->end < 0 && !h->broken && b->curve.end != BRANCH_DOMAIN)
        look_for_trap(s, b, h);
    if (h->end < 0 && b->curve.end == BRANCH_STEPS &&
        !plane_defined_near(s->plan, s, last_point(s, b)))
        h->end = PLANE_END_SINGULARITY;
    if (h->end >= 0)
        return h->end;
    if (b->curve.end == BRANCH_DOMAIN)
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
        status = plane_cycle_add(s, &h->winding, b->kind == MANIFOLD_UNSTABLE,
                                 &cycle);
        b->to = cycle < s->cycles ? (int64_t) cycle : RECORD_COUNT_NONE;
        b->end = cycle < s->cycles ? b->end : -1;
    }
    if (b->end == PLANE_END_SINGULARITY) /* plane_defined_near */
        h->beyond =
            2.0 * TOL_PLANE_STILL * fmax(s->scale.side.x, s->scale.side.y);
    measure(s, b, h->end >= 0 ? h->beyond : 0.0);
    return status;
}

/* Adds both branches of one manifold; where it has no series they are empty. */
static enum status grow(struct plane_study *s, int64_t saddle, size_t rest,
                        enum manifold_kind kind, const struct monitor *monitor)
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
    struct grow_options o = grow_defaults(TOL_PLANE_PART * s->scene->rtol);
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
    f.half[0].end = f.half[1].end = -1;
    o.max_steps *= 2; /* bands times regions grow as their square */
    o.follower = &follower;
    o.monitor = monitor;
    equilibrium_at(f.system, false, &e);
    enum status status = local_at(f.system, &e, MANIFOLD_STABLE, &o.carry,
                                  o.order, TOL_TAYLOR_STEP * o.rtol, &u);
    if (status == STATUS_OK)
        status = grow_branches(f.system, &u, &o, half);
    free(rests);
    if (status == STATUS_NO_MEMORY || status == STATUS_STOPPED)
        return status;
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
            status = grow(s, RECORD_COUNT_NONE, i, MANIFOLD_STABLE, NULL);
    return status;
}
