#include "workprec_track.h"

#include <math.h>
#include <string.h>

#include "grow.h"
#include "tolerance.h"
#include "workprec_system.h"
#include "workprec_tolerance.h"

enum { TRIES = 20 }; /* at a row */

/* A method on its way. */
struct track {
    const struct workprec_task *c;
    const struct method *m;
    double tol;
    struct workprec_system equations;
    struct method_system system; /* of the former: must not move */
    void *state;                 /* owned */
    double s, u[METHOD_DIM], s_last, last[METHOD_DIM];
    struct workprec_answer *out;
};

/* Points of both branches on the saddle's series where that is good to a
 * hundredth of the tolerance, with the excess slip from the saddle to there. */
struct start {
    struct vec2 z[WORKPREC_SIDES];
    struct vec2 near[WORKPREC_SIDES]; /* before the first row */
    double excess;
};

static bool find_start(const struct workprec_task *c, enum workprec_quantity q,
                       double tol, struct start *out)
{
    const struct carry carry = { { BLOCK_EXCESS }, q == WORKPREC_X_EXCESS };
    struct local_series u;

    if (local_at(&c->study->slider.plane.system, c->saddle, MANIFOLD_STABLE,
                 &carry, grow_order(tol), WORKPREC_MISSED * tol,
                 &u) != STATUS_OK)
        return false;
    const int up = u.ind == 0 || u.c[1] > 0.0 ? 1 : -1;
    const double near = fmin(u.radius, 0.5 * WORKPREC_ROW_NEAREST / u.unit);
    for (int i = 0; i < WORKPREC_SIDES; i++) {
        const int way = i == SIDE_UPPER ? up : -up;
        out->z[i] = local_series_at(&u, way * u.radius);
        out->near[i] = local_series_at(&u, way * near);
    }
    out->excess =
        carry.count ? jet_at(u.order, u.integral[0], up * u.radius) : 0.0;
    return true;
}

/* ---- steps ----------------------------------------------------------- */

static bool begin(struct track *t, double h)
{
    t->s = 0.0;
    t->state = t->m->open(t->m, &t->system, t->tol, t->u, h);
    return t->state != NULL;
}

static bool advance(struct track *t, double s_end)
{
    t->s_last = t->s;
    memcpy(t->last, t->u, sizeof t->u);
    t->out->steps++;
    return t->m->step(t->state, s_end, &t->s, t->u);
}

static void end(struct track *t)
{
    if (t->state)
        t->m->close(t->state);
    t->state = NULL;
    t->out->calls += t->system.calls;
    t->system.calls = 0;
}

/* The cubic through the ends of the last step. */
static bool cubic(struct track *t, double s, double u[])
{
    const double h = t->s - t->s_last, x = (s - t->s_last) / h, y = 1.0 - x;
    double d0[METHOD_DIM], d1[METHOD_DIM];

    if (!method_rates(&t->system, t->last, d0) ||
        !method_rates(&t->system, t->u, d1))
        return false;
    for (size_t i = 0; i < t->system.dim; i++)
        u[i] = y * y * (1.0 + 2.0 * x) * t->last[i] +
               x * x * (1.0 + 2.0 * y) * t->u[i] +
               h * x * y * (y * d0[i] - x * d1[i]);
    return true;
}

/* Something that changes sign on the last step. */
typedef double goal_fn(const struct track *t, const void *what,
                       const double u[]);

/* u where it is zero: Illinois' regula falsi. */
static bool locate(struct track *t, goal_fn *goal, const void *what, double u[])
{
    double a = t->s_last, b = t->s;
    double f_a = goal(t, what, t->last), f_b = goal(t, what, t->u);

    memcpy(u, t->u, sizeof t->u);
    for (int i = 0; i < TRIES && fabs(f_b) > WORKPREC_MISSED * t->tol; i++) {
        const double s = (a * f_b - b * f_a) / (f_b - f_a);
        if (!(t->m->between ? t->m->between(t->state, s, u) : cubic(t, s, u)))
            return false;
        const double f = goal(t, what, u);
        if ((f > 0.0) != (f_b > 0.0)) {
            a = b;
            f_a = f_b;
        } else {
            f_a *= 0.5;
        }
        b = s;
        f_b = f;
    }
    return true;
}

/* ---- branches -------------------------------------------------------- */

/* Whether nothing that is asked for changes any more as psi runs on. */
static bool has_settled(struct track *t)
{
    double du[METHOD_DIM];

    if (fabs(t->u[1]) < 1.0 || !method_rates(&t->system, t->u, du))
        return false;
    const double slope = fabs(du[0] / du[1]);
    const double growth = t->system.dim > 2 ? fabs(du[2] / du[1]) : 0.0;
    return slope <= WORKPREC_REST * t->tol &&
           growth <= WORKPREC_REST * t->tol * fabs(t->u[2]);
}

static bool begin_branch(struct track *t, struct vec2 z, double excess)
{
    t->u[0] = z.x;
    t->u[1] = z.y;
    t->u[2] = excess;
    return begin(t, WORKPREC_FIRST * fmin(1.0, hypot(z.x, z.y)));
}

static void find_limit(struct track *t, enum workprec_quantity q,
                       const struct start *start)
{
    const int side = q == WORKPREC_V_MINUS ? SIDE_LOWER : SIDE_UPPER;
    bool good = begin_branch(t, start->z[side], start->excess);
    bool settled = false;

    while (good && !settled) {
        good = advance(t, WORKPREC_LONGEST) && t->s < WORKPREC_LONGEST;
        settled = good && has_settled(t);
    }
    t->out->success = good;
    t->out->value[0] = q == WORKPREC_X_EXCESS
                           ? -t->u[2]
                           : t->c->study->slider.block.at.v0 * exp(t->u[0]);
    end(t);
}

static bool in_reach(const struct track *t)
{
    return box_holds(t->c->reach, (struct vec2){ t->u[0], t->u[1] });
}

static void find_curve(struct track *t, const struct start *start)
{
    struct workprec_answer *a = t->out;

    a->success = true;
    for (int side = 0; side < WORKPREC_SIDES && a->success; side++) {
        bool good = begin_branch(t, start->z[side], 0.0);
        size_t n = 0;
        while (good && in_reach(t)) {
            if (n < WORKPREC_POINTS_MOST)
                a->point[side][n++] = (struct vec2){ t->u[0], t->u[1] };
            good = advance(t, WORKPREC_LONGEST) && t->s < WORKPREC_LONGEST;
        }
        a->points[side] = n;
        a->success = good;
        end(t);
    }
}

static double above_row(const struct track *t, const void *what,
                        const double u[])
{
    const double *row = what;

    (void) t;
    return u[1] - *row;
}

static bool is_crossed(const struct track *t, const double *row)
{
    const double from = above_row(t, row, t->last),
                 to = above_row(t, row, t->u);

    return from * to <= 0.0 && from != to;
}

/* Where one branch cuts its rows, which come one after another. */
static bool cut_branch(struct track *t, const struct start *start, int side)
{
    const struct workprec_cuts *cuts = &t->c->truth.cuts[side];
    double *x = &t->out->value[side * WORKPREC_ROWS_MOST];
    bool good = begin_branch(t, start->near[side], 0.0);
    size_t k = 0;

    while (good && k < cuts->count) {
        good = advance(t, WORKPREC_LONGEST) && t->s < WORKPREC_LONGEST;
        for (; good && k < cuts->count && is_crossed(t, &cuts->row[k]); k++) {
            double u[METHOD_DIM];
            good = locate(t, above_row, &cuts->row[k], u);
            x[k] = u[0];
        }
    }
    end(t);
    return good;
}

static void find_rows(struct track *t, const struct start *start)
{
    t->out->success = true;
    for (int side = 0; side < WORKPREC_SIDES && t->out->success; side++)
        t->out->success = cut_branch(t, start, side);
}

/* ---- orbits ---------------------------------------------------------- */

static bool begin_orbit(struct track *t, struct vec2 z)
{
    double du[METHOD_DIM];

    t->u[0] = z.x;
    t->u[1] = z.y;
    t->u[2] = 0.0;
    return method_rates(&t->system, t->u, du) &&
           begin(t, WORKPREC_CAUTIOUS / (1.0 + fabs(du[0]) + fabs(du[1])));
}

static void find_state(struct track *t)
{
    bool good = begin_orbit(t, t->c->start);

    while (good && t->s < t->c->until)
        good = advance(t, t->c->until);
    t->out->success = good;
    t->out->value[0] = t->u[0];
    t->out->value[1] = t->u[1];
    end(t);
}

/* How far outside the nearest box of arrest. */
static double outside(const struct track *t, const void *what, const double u[])
{
    double least = HUGE_VAL;

    (void) what;
    for (size_t i = 0; i < t->c->targets; i++) {
        const struct vec2 node = t->c->target[i];
        const double off = fmax(fabs(u[0] - node.x), fabs(u[1] - node.y));
        least = fmin(least, off - TOL_ARREST);
    }
    return least;
}

static bool slip_of(struct track *t, struct vec2 z, double *slip)
{
    bool good = begin_orbit(t, z);
    double u[METHOD_DIM];

    while (good && outside(t, NULL, t->u) > 0.0)
        good = advance(t, TOL_RANGE);
    good = good && locate(t, outside, NULL, u);
    if (good)
        *slip = u[2];
    end(t);
    return good;
}

static void find_slips(struct track *t)
{
    const struct vec2 o = t->c->study->slider.plane.system.origin;

    t->out->success = true;
    for (size_t k = 0; k < t->c->cells && t->out->success; k++)
        t->out->success =
            slip_of(t, vec2_sub(t->c->cell[k], o), &t->out->value[k]);
}

static void find_branches(struct track *t, enum workprec_quantity q)
{
    struct start start;

    t->out->success = false;
    if (!find_start(t->c, q, t->tol, &start))
        return;
    if (q == WORKPREC_CURVE)
        find_curve(t, &start);
    else if (q == WORKPREC_ROWS)
        find_rows(t, &start);
    else
        find_limit(t, q, &start);
}

void workprec_track(const struct workprec_task *c, enum workprec_quantity q,
                    const struct method *m, double tol, size_t calls_most,
                    struct workprec_answer *out)
{
    const bool moves = q == WORKPREC_TRANSIENT || q == WORKPREC_SLIP;
    struct track t = { .c = c, .m = m, .tol = tol, .out = out };

    t.equations = (struct workprec_system){
        .planar = &c->study->slider.plane.system,
        .arc = !moves,
        .observable = q == WORKPREC_SLIP       ? BLOCK_SLIP
                      : q == WORKPREC_X_EXCESS ? BLOCK_EXCESS
                                               : WORKPREC_ALONE,
    };
    t.system = workprec_method_system(&t.equations);
    t.system.calls_most = calls_most;
    out->calls = out->steps = 0;
    out->reported = (double) NAN;
    if (q == WORKPREC_TRANSIENT)
        find_state(&t);
    else if (q == WORKPREC_SLIP)
        find_slips(&t);
    else
        find_branches(&t, q);
}
