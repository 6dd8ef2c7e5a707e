/* No orbit crosses the slow curve: a step goes no further than just before it
 * and than the boxes of arrest, which a longer one might jump.  A box is
 * entered by Newton's method on its face. */
#include "landing.h"

#include <float.h>
#include <math.h>

#include "landing_rest.h"
#include "study.h"
#include "study_tolerance.h"

/* A block that loses v by friction alone needs some eps^2 v for that. */
static void choose_least(const struct landing *l, double least[2])
{
    const struct slow_curve *c = l->curve;
    const struct block *b = &c->study->block;
    const double v = exp(b->at.x0 + l->u[LAYER_X]);
    const double stop = material_eps2(&b->material) * v;

    least[0] = c->time_least;
    least[1] = c->slip_least;
    if (c->rests) {
        least[0] = fmax(fmin(least[0], stop), DBL_MIN);
        least[1] = fmax(fmin(least[1], stop * v), DBL_MIN);
    }
}

void landing_start(struct landing *l, const struct slow_curve *c, struct vec2 z,
                   const struct layer_options *options, struct layer *out,
                   double least[2])
{
    *l = (struct landing){
        .curve = c, .options = *options, .u = { z.x, z.y, 0.0, 0.0 }, .out = out
    };
    *out = (struct layer){ .end = LAYER_LOST, .x_peak = z.x, .y = NAN };
    if (options->peaks)
        out->mu_peak = block_mu(&c->study->block, z);
    choose_least(l, least);
}

/* ---- boxes of arrest ----------------------------------------------------- */

/* The nearest box: how far to its face, along x (0) or y (1); the offset from
 * its centre. */
struct door {
    int node; /* -1: there is none */
    int along;
    double way, x, y;
};

static struct door door_of(const struct landing *l)
{
    const struct study *s = l->curve->study;
    struct door door = { .node = -1, .way = HUGE_VAL };

    for (int i = 0; i < (int) s->equilibria; i++) {
        const struct vec2 e = s->equilibrium[i].z, o = s->system.origin;
        const double dx = l->u[LAYER_X] - (e.x - o.x);
        const double dy = l->u[LAYER_Y] - (e.y - o.y);
        const int along = fabs(dy) > fabs(dx);
        const double way = fmax(fabs(dx), fabs(dy)) - TOL_ARREST;
        if (i != s->saddle && way < door.way)
            door = (struct door){ i, along, way, dx, dy };
    }
    return door;
}

void landing_add_least(const struct landing *l)
{
    const double least = TOL_LAYER_LEAST * l->options.promise;

    l->out->time_error += least * l->out->time;
    l->out->slip_error += least * l->out->slip;
}

/* On the face, towards which the orbit closes at this rate. */
static void arrive(struct landing *l, const struct door *door, double closing)
{
    const struct study *s = l->curve->study;
    const double aside = fabs(l->du[!door->along]) / closing;
    const double late = 2.0 * l->across * (1.0 + aside);
    struct layer *const out = l->out;

    out->end = LAYER_LANDED;
    out->fate = (int8_t) fate_of_node(s, &s->equilibrium[door->node]);
    out->x_end = l->u[LAYER_X];
    out->time = l->u[LAYER_TIME];
    out->slip = l->u[LAYER_SLIP];
    out->time_error = l->time_error + late * l->du[LAYER_TIME];
    out->slip_error = l->slip_error + late * l->du[LAYER_SLIP];
    landing_add_least(l);
}

/* Beside a box: enters it, or takes the next step of Newton's method. */
static bool enters(struct landing *l, const struct door *door, double *most)
{
    const double side = door->along ? door->y : door->x;
    const double closing = -copysign(1.0, side) * l->du[door->along];

    const double aside = door->along ? door->x : door->y;
    const double wrong = l->across + l->out->place_error;

    if (!(closing > TOL_LAYER_HEAD_ON) || door->way < -TOL_LAYER_BESIDE ||
        fabs(aside) > TOL_ARREST - TOL_LAYER_CORNER * wrong)
        return true;
    *most = door->way / closing;
    if (fabs(*most) > TOL_LAYER_FACE)
        return false;
    arrive(l, door, closing);
    return true;
}

/* ---- the slow curve ------------------------------------------------------ */

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
static bool project(const struct landing *l, double *y, struct slow_point *p,
                    double *off)
{
    *y = l->u[LAYER_Y];
    for (int i = 0; i < 4; i++) {
        if (!slow_curve_at(l->curve, *y, p))
            return false;
        const double dx = l->u[LAYER_X] - p->x, dy = l->u[LAYER_Y] - *y;
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
static void add_peaks(struct landing *l, const struct slow_point *p, double y,
                      double off)
{
    const struct block *b = &l->curve->study->block;
    const double mu = block_mu(b, (struct vec2){ p->x, y });
    struct layer *const out = l->out;

    if (p->x_peak > p->x)
        out->x_peak = fmax(out->x_peak, p->x_peak);
    const double wrong =
        TOL_LAYER_MU * (fabs(off) + p->gap) * fabs(mu - (double) b->tan_alpha);
    const double later = fmax(mu, p->mu_peak);
    if (later + wrong > out->mu_peak)
        out->mu_error = wrong;
    out->mu_peak = fmax(out->mu_peak, later);
}

/* What the table says of the point y, `off` away along its fibre, added to what
 * was before.  False: nearer to the curve it would be good enough. */
static bool land(struct landing *l, double y, const struct slow_point *p,
                 double off, double *excess)
{
    const struct study *s = l->curve->study;
    const struct vec2 e = p->fibre;
    const double det = fabs(e.x - e.y * p->x_slope), part = fabs(off) + p->gap;
    const double bend = TOL_LAYER_BEND * fabs(off * e.x * e.y) * part / det;
    const double wrong = bend + l->across / det;
    const double d = off * e.x, v = exp(s->block.at.x0 + p->x);
    const double more = v / p->fast * d * (1.0 + 0.25 * d);
    const double unsaid = TOL_LAYER_BEND * fabs(more) * part;
    const double time = l->u[LAYER_TIME] + p->time;
    const double slip = l->u[LAYER_SLIP] + p->slip + more;
    const double late = 2.0 * fabs(p->time_slope) * bend;
    const double long_ = 2.0 * fabs(p->slip_slope) * bend + unsaid;
    struct layer *const out = l->out;

    *excess =
        fmax(late / time, long_ / slip) / (TOL_LAYER_BENT * l->options.promise);
    if (*excess > 1.0 && fabs(off) > TOL_LAYER_TOUCH)
        return false;
    if (!is_clear(s, y))
        return false;
    out->end = LAYER_LANDED;
    if (s->saddle >= 0 && !(wrong < TOL_LAYER_SIDE * fabs(y)))
        out->end = LAYER_UNSURE;
    out->fate = p->fate;
    out->x_end = p->x_end;
    out->y = y;
    out->time = time;
    out->slip = slip;
    out->time_error =
        l->time_error + p->time_error + 2.0 * fabs(p->time_slope) * wrong;
    out->slip_error = l->slip_error + p->slip_error + unsaid +
                      2.0 * fabs(p->slip_slope) * wrong;
    landing_add_least(l);
    if (l->options.peaks)
        add_peaks(l, p, y, off);
    return true;
}

/* ---- other ends ---------------------------------------------------------- */

/* v vanishes and psi grows within no time (as in fate.c). */
static bool rests(struct landing *l)
{
    const double *du = l->du, *u = l->u;
    const double soon = TOL_REST_SOON * u[LAYER_TIME];

    if (!(-du[LAYER_X] * soon > du[LAYER_TIME] &&
          du[LAYER_Y] * soon > du[LAYER_TIME]))
        return false;
    const double left = -du[LAYER_TIME] / du[LAYER_X];
    const double v = exp(l->curve->study->block.at.x0 + u[LAYER_X]);
    l->out->end = LAYER_RESTED;
    l->out->fate = FATE_REST_FINITE;
    l->out->x_end = -HUGE_VAL;
    l->out->time = u[LAYER_TIME] + left;
    l->out->slip = u[LAYER_SLIP] + 0.5 * v * left;
    l->out->time_error = l->time_error + left;
    l->out->slip_error = l->slip_error + v * left;
    return true;
}

static bool runs(struct landing *l)
{
    const double far = l->across;

    if (!l->curve->runs_away || !(l->u[LAYER_X] > far && l->u[LAYER_Y] < -far))
        return false;
    l->out->end = LAYER_RAN;
    l->out->fate = FATE_RUNAWAY;
    return true;
}

/* ---- all of them --------------------------------------------------------- */

/* Whether v still rises to a curve along which it falls: its peak is between.
 */
static bool is_rising(const struct landing *l, double x_slope)
{
    struct slow_point p;

    return l->options.peaks && l->du[LAYER_X] > 0.0 &&
           slow_curve_at(l->curve, l->u[LAYER_Y], &p) &&
           x_slope * p.time_slope > 0.0;
}

/* Whether it has landed, d from the curve.  If not, *aim: how near to come. */
static bool lands(struct landing *l, double d, double x_slope, double *aim)
{
    struct slow_point p;
    double y, off, excess = 1.0;

    if (is_rising(l, x_slope)) {
        *aim = fmin(*aim, TOL_LAYER_RISE * fabs(d));
        return false;
    }
    if (!(fabs(d) < *aim))
        return false;
    if (project(l, &y, &p, &off) && land(l, y, &p, off, &excess))
        return true;
    *aim = fabs(d) *
           fmin(TOL_LAYER_RISE, fmax(TOL_LAYER_DIVE, TOL_LAYER_RISE / excess));
    return false;
}

bool landing_is_over(struct landing *l, double *most)
{
    const struct door door = door_of(l);
    double aim = l->options.landing, x, x_slope;

    *most = TOL_LAYER_NEARER * door.way;
    if (rests(l) || runs(l))
        return true;
    const bool beside =
        slow_curve_beside(l->curve, l->u[LAYER_Y], &x, &x_slope);
    const double d = l->u[LAYER_X] - x;
    if (beside && door.way > 0.0 && lands(l, d, x_slope, &aim))
        return true;
    if (door.way < TOL_LAYER_BESIDE)
        return enters(l, &door, most);
    const double closing = l->du[LAYER_X] - x_slope * l->du[LAYER_Y];
    if (beside && d * closing < 0.0)
        *most = fmin(*most, (fabs(d) - TOL_LAYER_AIM * aim) / fabs(closing));
    return landing_rests(l, most);
}
