/*
 * Knees of a branch: signs of dy - dx outward, the field's along the stored
 * polynomials, at the ends of their monotone parts (turning.c) and each held
 * to what the curve's error (defect.c) and rounding make of it.  Between two
 * points of certain and different signs there is a crossing, found by the
 * field; between two of the same sign, one where the difference comes too near
 * to zero leaves it undecided.  At the saddle, where the field is 0/0, the
 * series tells the slope.
 */
#include "knee.h"

#include <float.h>
#include <math.h>

#include "defect.h"
#include "newton.h"
#include "tolerance.h"
#include "turning.h"

/* A point on the way: the sign as of dy - dx, outward, in units of the
 * independent coordinate's change. */
struct post {
    double theta;
    struct vec2 z;
    double value, unsure; /* |value| > unsure: its sign is certain */
};

struct seeker {
    const struct planar *sys;
    const struct branch *b;
    struct vec2 floor;
    size_t piece;
    int ind;                /* its independent coordinate; */
    double direction;       /* +1 where that grows outward */
    struct defect off;      /* at the piece's start */
    struct post last, sure; /* the last one, and the last certain one; */
    bool has_sure, near;    /* if any; since then, some were not */
    bool changed;           /* since then, the sign was another, */
    struct knee found;      /* first here */
    struct knee *knee;
    size_t count, room;
};

static struct vec2 point_of(const struct seeker *s, double theta)
{
    return curve_point(&s->b->curve, s->piece, theta);
}

/* dy - dx over |d ind|, of the slope d dep/d ind. */
static double value_of(const struct seeker *s, double slope)
{
    return s->direction * (s->ind == 0 ? slope - 1.0 : 1.0 - slope);
}

static struct defect carry_to(const struct seeker *s, double theta)
{
    return defect_carry(s->sys, s->b, s->piece, theta, s->off);
}

static struct post post_at(const struct seeker *s, double theta,
                           struct defect off)
{
    const struct defect_slope d = defect_look(s->sys, s->b, s->piece, theta);

    return (struct post){
        .theta = theta,
        .z = point_of(s, theta),
        .value = value_of(s, d.slope),
        .unsure = d.rounding + fabs(d.by_dep) * (off.curve + off.saddle),
    };
}

/* At the saddle the slope is the eigenvector's. */
static struct post post_at_saddle(const struct seeker *s)
{
    double way[CURVE_DIM_MAX];

    curve_slope_at(&s->b->curve, 0, 0.0, way);
    const double slope = way[1 - s->ind] / way[s->ind];
    const double lost = DBL_EPSILON * TOL_ROUNDINGS + s->floor.x + s->floor.y;
    return (struct post){ .value = value_of(s, slope),
                          .unsure = lost * fabs(slope) };
}

/* ---- the place ----------------------------------------------------------- */

/* As of a post; the field is 0/0 at the saddle. */
static double by_field(const void *ctx, double theta)
{
    const struct seeker *s = ctx;

    return theta == s->last.theta
               ? s->last.value
               : value_of(s, local_slope(s->sys, s->ind, point_of(s, theta)));
}

/* First and second derivative by ind of the slope along the curve: the field's,
 * and the polynomials'. */
static void bends_at(const struct seeker *s, double theta,
                     const struct defect_slope *d, double bend[2])
{
    const size_t n = s->b->curve.piece[s->piece].degree;
    const double *c =
        curve_component(&s->b->curve, s->piece, (size_t) (1 - s->ind));
    const double unit =
        curve_component(&s->b->curve, s->piece, (size_t) s->ind)[1];

    bend[0] = d->by_ind + d->by_dep * d->slope;
    bend[1] = 0.0;
    for (size_t k = n; k >= 3; k--)
        bend[1] = bend[1] * theta + (double) (k * (k - 1) * (k - 2)) * c[k];
    bend[1] /= unit * unit * unit;
}

/* What of ind changes the slope by `off`, over `off`; infinite where the slope
 * turns before. */
static double stretch(const double bend[2], double off)
{
    const double even = fabs(bend[0]);
    const double left = even * even - 2.0 * fabs(bend[1]) * off;

    return left > 0.0 ? 2.0 / (even + sqrt(left)) : HUGE_VAL;
}

/* The knee before `to`.  With S' = S_ind + S_dep along the curve, its
 * coordinates move with the curve's error by S_dep/S' and by S_ind/S' = 1 -
 * S_dep/S' of it, and both with the slope's. */
static struct knee knee_before(const struct seeker *s, const struct post *to)
{
    struct newton_root root = { .x = to->theta };
    const enum status found =
        newton_find(by_field, s, s->last.theta, to->theta, 0.0, &root);
    const double theta = root.x;
    const struct defect e = carry_to(s, theta);
    const double error = e.curve + e.saddle;
    const struct defect_slope d = defect_look(s->sys, s->b, s->piece, theta);
    const double off =
        found == STATUS_OK ? d.rounding + fabs(d.by_dep) * error : HUGE_VAL;
    double bend[2];

    bends_at(s, theta, &d, bend);
    const double ind = stretch(bend, off) * off;
    const double dep =
        stretch(bend, off) * (d.rounding + fabs(d.by_ind) * error);
    return (struct knee){
        .kind = (to->value > 0.0) == (s->direction > 0.0) ? KNEE_RISING
                                                          : KNEE_FALLING,
        .z = point_of(s, theta),
        .error = { s->ind == 0 ? ind : dep, s->ind == 0 ? dep : ind },
    };
}

/* ---- the way ------------------------------------------------------------- */

static void add(struct seeker *s, struct knee k)
{
    if (s->count < s->room)
        s->knee[s->count] = k;
    s->count++;
}

static double larger_way(double z, double u, double w)
{
    return fmax(fabs(z - u), fabs(z - w));
}

/* From one certain point to the next: a knee is between them at least, as the
 * saddle is. */
static void add_between(struct seeker *s, const struct post *to)
{
    struct knee k = s->found;

    if (s->has_sure && (to->value < 0.0) != (s->sure.value < 0.0)) {
        const struct vec2 from = s->sure.z;
        const double x = larger_way(k.z.x, from.x, to->z.x);
        const double y = larger_way(k.z.y, from.y, to->z.y);
        k.error.x = fmin(k.error.x, x + s->floor.x);
        k.error.y = fmin(k.error.y, y + s->floor.y);
        add(s, k);
    } else if (s->near) {
        add(s, (struct knee){ .kind = KNEE_UNDECIDED });
    }
}

/* The next point on the way. */
static void pass(struct seeker *s, struct post to)
{
    const bool apart = s->has_sure && (to.value < 0.0) != (s->sure.value < 0.0);

    if (!isfinite(to.value))
        return;
    if (apart && !s->changed) {
        s->found = knee_before(s, &to);
        s->changed = true;
    }
    s->last = to;
    if (!(fabs(to.value) > to.unsure)) {
        s->near = true;
        return;
    }
    add_between(s, &to);
    s->sure = to;
    s->has_sure = true;
    s->near = s->changed = false;
}

/* Where the piece's slope may turn near 1. */
static size_t find_turns(const struct seeker *s, double at[TURNING_MAX])
{
    const size_t n = s->b->curve.piece[s->piece].degree;
    const double *c =
        curve_component(&s->b->curve, s->piece, (size_t) (1 - s->ind));
    const double unit =
        curve_component(&s->b->curve, s->piece, (size_t) s->ind)[1];
    double slope[JET_SIZE];

    for (size_t k = 1; k <= n; k++)
        slope[k - 1] = (double) k * c[k] / unit;
    const struct turning_range r = turning_bound(n - 1, slope);
    if (r.lo > 1.0 + TOL_KNEE_NEAR || r.hi < 1.0 - TOL_KNEE_NEAR)
        return 0;
    return turning_find(n - 1, slope, at);
}

static void enter_piece(struct seeker *s)
{
    const int before = s->ind;

    s->ind = branch_graph(s->b, s->piece);
    s->direction = copysign(
        1.0, curve_component(&s->b->curve, s->piece, (size_t) s->ind)[1]);
    s->last.theta = 0.0;
    if (s->piece > 0 && s->ind != before) { /* along the other axis */
        const double slope =
            fabs(local_slope(s->sys, s->ind, point_of(s, 0.0)));
        s->off.curve *= slope;
        s->off.saddle *= slope;
    }
}

static void pass_piece(struct seeker *s)
{
    double turn[TURNING_MAX];

    enter_piece(s);
    if (s->piece == 0)
        pass(s, post_at_saddle(s));
    for (size_t i = 0, n = find_turns(s, turn); i < n; i++)
        pass(s, post_at(s, turn[i], carry_to(s, turn[i])));
    const struct defect end = carry_to(s, 1.0);
    pass(s, post_at(s, 1.0, end));
    s->off = end;
}

size_t knee_find(const struct planar *sys, const struct branch *b,
                 struct vec2 floor, struct knee knee[], size_t room)
{
    struct seeker s = {
        .sys = sys, .b = b, .floor = floor, .knee = knee, .room = room
    };

    s.off = defect_start(b, floor);
    for (; s.piece < b->curve.count; s.piece++)
        pass_piece(&s);
    if (s.near)
        add(&s, (struct knee){ .kind = KNEE_UNDECIDED });
    return s.count;
}
