/* In arc length of the chart an orbit off the slow curve is not stiff.  Its
 * steps are by the method of order 8 with time and slip as components, shorter
 * only before the slow curve, which no orbit crosses, and before the boxes of
 * arrest, which a longer one might jump.  What a step may have missed is moved
 * across the orbit, where it shifts the landing, and along it, where it shifts
 * the time. */
#include "fast_layer.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "control.h"
#include "crest.h"
#include "explicit8.h"
#include "study.h"
#include "study_tolerance.h"

enum { X, Y, TIME, SLIP, DIM };

struct layer_options layer_defaults(double rtol)
{
    return (struct layer_options){
        .rtol = TOL_LAYER_PART * rtol,
        .landing =
            rtol < TOL_LAYER_PLAIN ? TOL_LAYER_CLOSER : TOL_LAYER_LANDING,
        .peaks = true,
    };
}

/* d(x, y, t, slip)/ds, s the arc length. */
static void along(const void *ctx, double s, const double u[], double du[])
{
    const struct study *study = ctx;
    struct planar_field f;

    (void) s;
    study->system.field(study->system.ctx, (struct vec2){ u[X], u[Y] }, &f);
    const double x = f.direction.x, y = f.direction.y;
    const double n = sqrt(x * x + y * y);
    const double size = n > 1e-140 && n < 1e140 ? n : vec2_length(f.direction);
    du[X] = x / size;
    du[Y] = y / size;
    du[TIME] = exp(-f.log_scale) / size;
    du[SLIP] = exp(study->block.at.x0 + u[X]) * du[TIME];
}

/* An orbit on its way. */
struct walk {
    const struct slow_curve *curve;
    struct layer_options options;
    struct ode ode;
    struct explicit8 work;
    struct control control;
    double u[DIM], h;
    double least[DIM]; /* sizes that tolerances are relative to */
    double across, time_error, slip_error;
    struct layer *out;
};

/* ---- arrival ------------------------------------------------------------- */

/* How far the boxes of arrest are at least. */
static double free_way(const struct study *s, const double u[])
{
    double way = HUGE_VAL;

    for (size_t i = 0; i < s->equilibria; i++) {
        const struct vec2 e = s->equilibrium[i].z, o = s->system.origin;
        const double dx = fabs(e.x - o.x - u[X]), dy = fabs(e.y - o.y - u[Y]);
        if ((int) i != s->saddle)
            way = fmin(way, fmax(dx, dy) - TOL_ARREST);
    }
    return way;
}

/* Whether slow point y lies safely before every box. */
static bool is_clear(const struct study *s, double y)
{
    bool clear = true;

    for (size_t i = 0; i < s->equilibria; i++) {
        const double dy = s->equilibrium[i].z.y - s->system.origin.y - y;
        if ((int) i != s->saddle)
            clear = clear && fabs(dy) > TOL_LAYER_ARREST * TOL_ARREST;
    }
    return clear;
}

/* The point of the curve that shares the fibre of the end of the walk; *off:
 * how far along it, signed. */
static bool project(const struct walk *w, double *y, struct slow_point *p,
                    double *off)
{
    *y = w->u[Y];
    for (int i = 0; i < 4; i++) {
        if (!slow_curve_at(w->curve, *y, p))
            return false;
        const double dx = w->u[X] - p->x, dy = w->u[Y] - *y;
        const struct vec2 e = p->fibre;
        const double det = e.x - e.y * p->x_slope;
        *off = (dx - dy * p->x_slope) / det;
        if (i < 3)
            *y += (e.x * dy - e.y * dx) / det;
    }
    return true;
}

/* The peaks to come.  Where v falls along the curve it is known already; mu is
 * that of the curve at once, or as good as. */
static void add_peaks(struct walk *w, const struct slow_point *p, double y,
                      double off)
{
    const struct block *b = &w->curve->study->block;
    const double mu = block_mu(b, (struct vec2){ p->x, y });
    struct layer *const out = w->out;

    if (p->x_peak > p->x)
        out->x_peak = fmax(out->x_peak, p->x_peak);
    const double wrong =
        TOL_LAYER_MU * (fabs(off) + p->gap) * fabs(mu - (double) b->tan_alpha);
    const double later = fmax(mu, p->mu_peak);
    if (later + wrong > out->mu_peak)
        out->mu_error = wrong;
    out->mu_peak = fmax(out->mu_peak, later);
}

/* Adds what the table says of the point y, `off` away along its fibre. */
static void land(struct walk *w, double y, const struct slow_point *p,
                 double off)
{
    const struct study *s = w->curve->study;
    struct layer *const out = w->out;
    const struct vec2 e = p->fibre;
    const double det = fabs(e.x - e.y * p->x_slope), part = fabs(off) + p->gap;
    const double bend = TOL_LAYER_BEND * fabs(off * e.x * e.y) * part;
    const double wrong = (bend + w->across) / det;
    const double d = off * e.x, v = exp(s->block.at.x0 + p->x);
    const double more = v / p->fast * d * (1.0 + 0.25 * d);

    if (!is_clear(s, y))
        return;
    out->end = LAYER_LANDED;
    if (s->saddle >= 0 && !(wrong < TOL_LAYER_SIDE * fabs(y)))
        out->end = LAYER_UNSURE;
    out->fate = p->fate;
    out->x_end = p->x_end;
    out->time = w->u[TIME] + p->time;
    out->slip = w->u[SLIP] + p->slip + more;
    out->time_error =
        w->time_error + p->time_error + 2.0 * fabs(p->time_slope) * wrong;
    out->slip_error = w->slip_error + p->slip_error +
                      2.0 * fabs(p->slip_slope) * wrong +
                      TOL_LAYER_BEND * fabs(more) * part;
    add_peaks(w, p, y, off);
}

/* v vanishes and psi grows within no time (as in fate.c). */
static bool rests(struct walk *w)
{
    const double *du = w->work.k[0], *u = w->u;
    const double soon = TOL_REST_SOON * u[TIME];

    if (!(-du[X] * soon > du[TIME] && du[Y] * soon > du[TIME]))
        return false;
    const double left = -du[TIME] / du[X];
    const double v = exp(w->curve->study->block.at.x0 + u[X]);
    w->out->end = LAYER_RESTED;
    w->out->fate = FATE_REST_FINITE;
    w->out->x_end = -HUGE_VAL;
    w->out->time = u[TIME] + left;
    w->out->slip = u[SLIP] + 0.5 * v * left;
    w->out->time_error = w->time_error + left;
    w->out->slip_error = w->slip_error + v * left;
    return true;
}

static bool runs(struct walk *w)
{
    const double far = w->across;

    if (!w->curve->runs_away || !(w->u[X] > far && w->u[Y] < -far))
        return false;
    w->out->end = LAYER_RAN;
    w->out->fate = FATE_RUNAWAY;
    return true;
}

/* Whether v still rises to a curve along which it falls: its peak is between.
 */
static bool is_rising(const struct walk *w, const struct slow_point *p)
{
    return w->options.peaks && w->work.k[0][X] > 0.0 &&
           p->x_slope * p->time_slope > 0.0;
}

/* Whether the walk is over.  If not: how far the next step may go. */
static bool is_over(struct walk *w, double *most)
{
    const double *du = w->work.k[0];
    double aim = w->options.landing, y, off;
    struct slow_point p;

    *most = free_way(w->curve->study, w->u);
    if (!(*most > TOL_LAYER_NEAREST) || rests(w) || runs(w))
        return true;
    if (!slow_curve_at(w->curve, w->u[Y], &p))
        return false;
    const double d = w->u[X] - p.x;
    const double closing = du[X] - p.x_slope * du[Y];
    if (is_rising(w, &p)) {
        aim = fmin(aim, TOL_LAYER_RISE * fabs(d));
    } else if (fabs(d) < aim) {
        if (project(w, &y, &p, &off)) {
            land(w, y, &p, off);
            return true;
        }
        aim = TOL_LAYER_RISE * fabs(d);
    }
    if (d * closing < 0.0)
        *most = fmin(*most, (fabs(d) - TOL_LAYER_AIM * aim) / fabs(closing));
    return false;
}

/* ---- steps --------------------------------------------------------------- */

/* What the step may have missed, in the directions that matter; off its orbit a
 * state also gains another time and slip, by about as much, relative. */
static void account(struct walk *w, const double error[], const double gain[])
{
    const double *du = w->work.k[0];
    const double across = fabs(error[X] * du[Y]) + fabs(error[Y] * du[X]);
    const double on = fabs(error[X] * du[X]) + fabs(error[Y] * du[Y]);

    w->across += TOL_LAYER_TRANSPORT * across;
    w->time_error += TOL_LAYER_TRANSPORT *
                     (error[TIME] + du[TIME] * on + w->across * gain[TIME]);
    w->slip_error += TOL_LAYER_TRANSPORT *
                     (error[SLIP] + du[SLIP] * on + w->across * gain[SLIP]);
    w->out->place_error += error[X] + error[Y];
}

enum { COEFS = EXPLICIT8_DEGREE + 1, LAST = 12 };

/* A step's polynomial. */
struct arc {
    const struct block *block;
    double coef[DIM * COEFS];
};

static double mu_on(const void *ctx, double t)
{
    const struct arc *a = ctx;
    const double *c = a->coef;
    struct vec2 z = { 0.0, 0.0 };

    for (int j = COEFS; j-- > 0;)
        z = (struct vec2){ z.x * t + c[j], z.y * t + c[COEFS + j] };
    return block_mu(a->block, z);
}

static double x_on(const void *ctx, double t)
{
    const struct arc *a = ctx;
    double x = 0.0;

    for (int j = COEFS; j-- > 0;)
        x = x * t + a->coef[j];
    return x;
}

/* On the step to u1, whose ends are seen anyway: v has a peak where it rises at
 * first and falls at last, mu may have one anywhere. */
static void find_peaks(struct walk *w, const double u1[])
{
    struct arc a = { &w->curve->study->block, { 0.0 } };
    const double *from = w->work.k[0], *to = w->work.k[LAST];
    struct layer *const out = w->out;

    explicit8_dense(&w->work, &w->ode, 0.0, w->u, w->h, u1, a.coef);
    out->x_peak = fmax(out->x_peak, u1[X]);
    if (from[X] > 0.0 && to[X] <= 0.0)
        out->x_peak = fmax(out->x_peak, crest_of(x_on, &a));
    out->mu_peak = fmax(out->mu_peak, crest_of(mu_on, &a));
}

/* One accepted step no longer than `most`; false: there is none. */
static bool advance(struct walk *w, double most)
{
    const double tol = w->options.rtol;
    const double atol[DIM] = { tol, tol, tol * w->least[TIME],
                               tol * w->least[SLIP] };
    double u1[DIM], error[DIM], factor;
    struct layer *const out = w->out;

    for (w->h = fmin(w->h, most); w->h > 1e-12; w->h *= factor) {
        const double off = explicit8_try(&w->work, &w->ode, 0.0, w->u, w->h,
                                         atol, tol, u1, error);
        out->calls += EXPLICIT8_CALLS;
        if (!control_judge(&w->control, off, &factor))
            continue;
        if (w->options.peaks)
            find_peaks(w, u1);
        const double gain[DIM] = {
            [TIME] = u1[TIME] - w->u[TIME], [SLIP] = u1[SLIP] - w->u[SLIP]
        };
        memcpy(w->u, u1, sizeof u1);
        along(w->curve->study, 0.0, w->u, w->work.k[0]);
        account(w, error, gain);
        w->h *= factor;
        out->steps++;
        out->calls++;
        return true;
    }
    return false;
}

/* A block that loses v by friction alone needs some eps^2 v for that. */
static void choose_least(struct walk *w)
{
    const struct study *s = w->curve->study;
    const double v = exp(s->block.at.x0 + w->u[X]);
    const double stop = material_eps2(&s->block.material) * v;

    w->least[TIME] = fmax(fmin(w->curve->time_least, stop), DBL_MIN);
    w->least[SLIP] = fmax(fmin(w->curve->slip_least, stop * v), DBL_MIN);
    if (!w->curve->rests) {
        w->least[TIME] = w->curve->time_least;
        w->least[SLIP] = w->curve->slip_least;
    }
}

void layer_follow(const struct slow_curve *c, struct vec2 z,
                  const struct layer_options *options, struct layer *out)
{
    const struct study *s = c->study;
    struct walk w = { .curve = c,
                      .options = *options,
                      .ode = { DIM, along, s },
                      .control = CONTROL_INIT(8.0),
                      .u = { z.x, z.y, 0.0, 0.0 },
                      .h = TOL_LAYER_FIRST,
                      .out = out };
    double most;

    choose_least(&w);
    *out = (struct layer){ .end = LAYER_LOST,
                           .x_peak = z.x,
                           .mu_peak = block_mu(&s->block, z) };
    along(s, 0.0, w.u, w.work.k[0]);
    while (!is_over(&w, &most) && out->steps < TOL_LAYER_STEPS)
        if (!advance(&w, most))
            break;
}
