/* An orbit down to where v is so small that psi = psi_ss(v) to all digits that
 * matter, and an integral over the rest. */
#include "rest_curve.h"

#include <math.h>
#include <stdlib.h>

#include "slow_branch.h"
#include "study.h"
#include "study_tolerance.h"

/* ---- far down ------------------------------------------------------------ */

/* psi = psi_ss(v), in the chart. */
static double settled_y(const struct study *s, double x)
{
    const struct planar *p = &s->system;

    return (double) (p->steady->y(p->ctx, (long double) (p->origin.x + x)) -
                     (long double) p->origin.y);
}

/* What psi lags behind: there it moves along with psi_ss. */
static double lagging_y(const struct study *s, double x)
{
    const double top = settled_y(s, x), h = TOL_REST_DIFFERENCE;
    const double slope = (settled_y(s, x + h) - settled_y(s, x - h)) / (2 * h);
    double lo = TOL_REST_LAG * exp(s->block.at.x0 + x), hi = 0.0;

    for (int i = 0; i < TOL_REST_HALVINGS; i++) {
        const double mid = 0.5 * (lo + hi);
        struct planar_field f;
        s->system.field(s->system.ctx, (struct vec2){ x, top - mid }, &f);
        if (f.direction.y > slope * f.direction.x)
            lo = mid;
        else
            hi = mid;
    }
    return top - 0.5 * (lo + hi);
}

/* -1/(d ln v/dt). */
static double slowness(const struct study *s, double x, double y)
{
    const struct block *b = &s->block;
    const double t = (double) b->tan_alpha;
    const double mu = block_mu(b, (struct vec2){ x, y });

    return material_eps2(&b->material) * exp(b->at.x0 + x) * hypot(1.0, t) /
           (mu - t);
}

/* Time and slip on the way from x down by h, by Gauss's formula of five points;
 * y: lagging_y or settled_y. */
static void sum_up(const struct study *s, double x, double h,
                   double (*y)(const struct study *, double), double *time,
                   double *slip)
{
    static const double node[] = { -0.9061798459386640, -0.5384693101056831,
                                   0.0, 0.5384693101056831,
                                   0.9061798459386640 };
    static const double weight[] = { 0.2369268850561891, 0.4786286704993665,
                                     0.5688888888888889, 0.4786286704993665,
                                     0.2369268850561891 };

    for (int i = 0; i < 5; i++) {
        const double at = x - 0.5 * h * (1.0 + node[i]);
        const double dt = 0.5 * h * weight[i] * slowness(s, at, y(s, at));
        *time += dt;
        *slip += exp(s->block.at.x0 + at) * dt;
    }
}

/* To rest, from where nothing lags. */
static void sum_all(const struct study *s, double x, double *time, double *slip)
{
    *time = *slip = 0.0;
    for (int piece = 0; piece < TOL_REST_PIECES; piece++)
        sum_up(s, x - piece, 1.0, settled_y, time, slip);
}

/* The rate psi settles at, and so on, hardly matter there. */
static void far_down(const struct rest_curve *c, double x, struct rest_point *p)
{
    const struct study *s = c->study;
    const struct rest_point *last = &c->knot[c->count - 1].at;
    const double part = exp(x - last->x);

    *p = *last;
    p->x = x;
    p->y = settled_y(s, x);
    p->time_slope = slowness(s, x, p->y);
    p->slip_slope = exp(s->block.at.x0 + x) * p->time_slope;
    p->gap *= part;
    p->fibre.x *= part;
    p->fast = 1.0 / (p->gap * p->time_slope);
    sum_all(s, x, &p->time, &p->slip);
    p->time_error = TOL_REST_SUM * p->time;
    p->slip_error = TOL_REST_SUM * p->slip;
}

/* ---- knots --------------------------------------------------------------- */

/* At the end of the orbit, with what its last step took; false where psi does
 * not settle faster than v falls. */
static bool knot_at(const struct study *s, const struct orbit *o,
                    struct rest_knot *k, double *bend)
{
    const struct vec2 z = { o->u[0], o->u[1] };
    struct planar_jacobian J;

    s->system.jacobian(s->system.ctx, z, &J);
    const struct vec2 d = J.field.direction;
    const struct eigen2 e = mat2_eigenvalues(J.matrix);
    const double slow = fmax(fabs(e.re[1]), fabs(d.x));
    const double slope = o->du[1] / o->du[0], v = exp(s->block.at.x0 + z.x);
    const double late = -1.0 / (d.x * exp(J.field.log_scale));

    *bend = (J.matrix.xx + J.matrix.xy * slope) / d.x;
    *k = (struct rest_knot){
        .at = { .x = z.x,
                .y = z.y,
                .y_slope = slope,
                .time_slope = late,
                .slip_slope = v * late,
                .fast = -e.re[0] * exp(J.field.log_scale),
                .gap = slow / -e.re[0],
                .fibre = mat2_eigenvector(J.matrix, e.re[0]) },
        .time_bend = -*bend * late,
        .slip_bend = (1.0 - *bend) * v * late,
    };
    return e.im == 0.0 && e.re[0] < 0.0 && d.x < 0.0 &&
           k->at.gap < TOL_SLOW_GAP &&
           fabs(k->at.fibre.y) > fabs(k->at.fibre.x);
}

static enum status push(struct rest_curve *c, const struct rest_knot *k)
{
    if (c->count == c->room) {
        const size_t room = c->room ? 2 * c->room : 512;
        struct rest_knot *more = realloc(c->knot, room * sizeof *more);
        if (more == NULL)
            return STATUS_NO_MEMORY;
        c->knot = more;
        c->room = room;
    }
    c->knot[c->count++] = *k;
    return STATUS_OK;
}

/* Keeps what the orbit's last step took, until it is known from the end. */
static enum status keep(struct rest_curve *c, const struct orbit *o,
                        struct rest_knot *k)
{
    k->at.time = slow_branch_gained(o, 2);
    k->at.slip = slow_branch_gained(o, 3 + BLOCK_SLIP);
    k->time_bar = o->error[2];
    k->slip_bar = o->error[3 + BLOCK_SLIP];
    return push(c, k);
}

/* Steps that polynomials bear. */
static void hold_back(struct orbit *o, double bend)
{
    const double most = fmin(TOL_SLOW_STEP / fabs(bend), TOL_SLOW_LONGEST);
    const double speed = fabs(o->du[0]);

    if (speed * o->h > most)
        o->h = most / speed;
}

/* Down to the floor; false where it does not get there. */
static enum status descend(struct rest_curve *c, struct orbit *o,
                           const struct monitor *monitor, bool *is_down)
{
    const struct study *s = c->study;
    const double floor = TOL_REST_FLOOR - s->block.at.x0;
    enum status status = STATUS_OK;

    *is_down = false;
    while (status == STATUS_OK && o->end == ORBIT_RUNNING &&
           o->steps < TOL_SLOW_STEPS) {
        struct rest_knot k;
        double bend;
        if (knot_at(s, o, &k, &bend)) {
            status = keep(c, o, &k);
            hold_back(o, bend);
        } else {
            c->count = 0;
        }
        *is_down = o->u[0] < floor;
        if (*is_down || status != STATUS_OK)
            break;
        status = orbit_step(o);
        if (status == STATUS_OK && o->steps % TOL_MONITOR_STEPS == 0 &&
            monitor_tell(monitor, "rest curve", o->steps, 0))
            status = STATUS_STOPPED;
    }
    return status;
}

/* From there on without an orbit, whose steps would see rounding in psi. */
static enum status extend(struct rest_curve *c)
{
    const struct study *s = c->study;
    const double h = TOL_SLOW_LONGEST;
    enum status status = STATUS_OK;

    while (status == STATUS_OK &&
           c->knot[c->count - 1].at.x > TOL_REST_BOTTOM - s->block.at.x0) {
        struct rest_knot k = c->knot[c->count - 1];
        const double from = k.at.x, part = exp(-h);
        const double x = k.at.x = from - h, d = TOL_REST_DIFFERENCE;
        k.at.time = k.at.slip = 0.0;
        sum_up(s, from, h, lagging_y, &k.at.time, &k.at.slip);
        k.at.y = lagging_y(s, x);
        const double late = slowness(s, x, k.at.y), v = exp(s->block.at.x0 + x);
        const double rise = log(slowness(s, x + d, lagging_y(s, x + d)) /
                                slowness(s, x - d, lagging_y(s, x - d))) /
                            (2.0 * d);
        k.at.y_slope = (k.at.y - lagging_y(s, x + d)) / -d;
        k.at.time_slope = late;
        k.at.slip_slope = v * late;
        k.time_bend = rise * late;
        k.slip_bend = (1.0 + rise) * v * late;
        k.at.gap *= part;
        k.at.fibre.x *= part;
        k.at.fast = 1.0 / (k.at.gap * late);
        status = push(c, &k);
    }
    return status;
}

/* ---- a whole one --------------------------------------------------------- */

/* From each step's time and slip to all to come. */
static void look_back(struct rest_curve *c)
{
    const struct rest_knot *end = &c->knot[c->count - 1];
    double time, slip, missed[2] = { end->time_bar, end->slip_bar };
    double time_bar = 0.0, slip_bar = 0.0;

    sum_all(c->study, end->at.x, &time, &slip);
    for (size_t i = c->count; i-- > 0;) {
        struct rest_knot *k = &c->knot[i];
        const double dt = k->at.time, dx = k->at.slip;
        time_bar += missed[0] - k->time_bar;
        slip_bar += missed[1] - k->slip_bar;
        missed[0] = k->time_bar;
        missed[1] = k->slip_bar;
        k->at.time = time;
        k->at.slip = slip;
        k->time_bar = time_bar + TOL_REST_SUM * time;
        k->slip_bar = slip_bar + TOL_REST_SUM * slip;
        time += dt;
        slip += dx;
    }
}

/* Time and slip between two knots. */
static void between(const struct rest_knot *f, const struct rest_knot *g,
                    double theta, struct rest_point *p)
{
    const double h = g->at.x - f->at.x;
    const double t0[3] = { f->at.time, f->at.time_slope, f->time_bend };
    const double t1[3] = { g->at.time, g->at.time_slope, g->time_bend };
    const double x0[3] = { f->at.slip, f->at.slip_slope, f->slip_bend };
    const double x1[3] = { g->at.slip, g->at.slip_slope, g->slip_bend };

    p->time = slow_quintic(t0, t1, h, theta, &p->time_slope);
    p->slip = slow_quintic(x0, x1, h, theta, &p->slip_slope);
}

/* As of slow_branch.c: by what a polynomial over two steps misses between. */
static void judge(struct rest_curve *c)
{
    struct rest_knot *const k = c->knot;
    struct rest_point p;

    for (size_t i = 1; i + 1 < c->count; i++) {
        const double h = k[i + 1].at.x - k[i - 1].at.x;
        between(&k[i - 1], &k[i + 1], (k[i].at.x - k[i - 1].at.x) / h, &p);
        const double dt = TOL_SLOW_MISSED * fabs(p.time - k[i].at.time);
        const double dx = TOL_SLOW_MISSED * fabs(p.slip - k[i].at.slip);
        for (size_t j = i - 1; j <= i; j++) {
            k[j].at.time_error = fmax(k[j].at.time_error, dt);
            k[j].at.slip_error = fmax(k[j].at.slip_error, dx);
        }
    }
}

enum status rest_curve_run(const struct study *s, struct vec2 z,
                           const struct monitor *monitor, struct rest_curve *c)
{
    struct orbit_options options = orbit_defaults(&s->system, s->stable_rate);
    struct orbit o;
    bool is_down = false;

    *c = (struct rest_curve){ .study = s };
    options.rtol = TOL_SLOW_RTOL;
    options.observables = 1;
    enum status status = orbit_init(&o, &s->system, z, &options);
    if (status == STATUS_OK)
        status = descend(c, &o, monitor, &is_down);
    orbit_free(&o);
    if (!is_down)
        c->count = 0;
    if (status == STATUS_OK && c->count > 2)
        status = extend(c);
    if (c->count > 2) {
        look_back(c);
        judge(c);
    }
    return status == STATUS_NO_MEMORY || status == STATUS_STOPPED ? status
                                                                  : STATUS_OK;
}

void rest_curve_free(struct rest_curve *c)
{
    free(c->knot);
    *c = (struct rest_curve){ .study = c->study };
}

/* ---- points -------------------------------------------------------------- */

/* The knot before x, which is not beyond the last. */
static const struct rest_knot *before(const struct rest_curve *c, double x)
{
    size_t lo = 0, hi = c->count - 1;

    while (hi - lo > 1) {
        const size_t mid = (lo + hi) / 2;
        if (c->knot[mid].at.x >= x)
            lo = mid;
        else
            hi = mid;
    }
    return &c->knot[lo];
}

static double y_inside(const struct rest_point *f, const struct rest_point *g,
                       double t, double *slope)
{
    const double h = g->x - f->x, rise = g->y - f->y;
    const double f1 = h * f->y_slope - rise, g1 = h * g->y_slope - rise;

    *slope = f->y_slope + t * (g->y_slope - f->y_slope);
    return f->y + t * rise + t * (1.0 - t) * ((1.0 - t) * f1 - t * g1);
}

bool rest_curve_beside(const struct rest_curve *c, double x, double *y,
                       double *y_slope)
{
    if (c->count < 3 || x > c->knot[0].at.x)
        return false;
    if (x < c->knot[c->count - 1].at.x) {
        *y = settled_y(c->study, x);
        *y_slope = c->knot[c->count - 1].at.y_slope;
        return true;
    }
    const struct rest_knot *f = before(c, x);
    const double t = (x - f->at.x) / (f[1].at.x - f->at.x);
    *y = y_inside(&f->at, &f[1].at, t, y_slope);
    return true;
}

bool rest_curve_at(const struct rest_curve *c, double x, struct rest_point *p)
{
    if (c->count < 3 || x > c->knot[0].at.x)
        return false;
    if (x < c->knot[c->count - 1].at.x) {
        far_down(c, x, p);
        return true;
    }
    const struct rest_knot *f = before(c, x), *g = f + 1;
    const double t = (x - f->at.x) / (g->at.x - f->at.x);
    *p = f->at;
    p->x = x;
    p->y = y_inside(&f->at, &g->at, t, &p->y_slope);
    p->fast += t * (g->at.fast - f->at.fast);
    p->fibre.x += t * (g->at.fibre.x - f->at.fibre.x);
    p->fibre.y += t * (g->at.fibre.y - f->at.fibre.y);
    p->time_error += f->time_bar;
    p->slip_error += f->slip_bar;
    between(f, g, t, p);
    return true;
}
