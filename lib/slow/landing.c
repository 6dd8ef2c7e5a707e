/* No orbit crosses the slow curve: a step goes no further than just before it
 * and than the boxes of arrest, which a longer one might jump.  A box is
 * entered by Newton's method on its face. */
#include "landing.h"

#include <float.h>
#include <math.h>

#include "landing_near.h"
#include "landing_rest.h"
#include "landing_weigh.h"
#include "layer_peaks.h"
#include "slider.h"
#include "slow_tolerance.h"

/* A block that loses v by friction alone needs some eps^2 v for that. */
static void choose_least(const struct landing *l, double least[2])
{
    const struct slow_curve *c = l->curve;
    const struct block *b = &c->slider->block;
    const double v = exp(b->at.x0 + l->u[LAYER_X]);
    const double stop = material_eps2(&b->material) * v;

    least[0] = c->time_least;
    least[1] = c->slip_least;
    if (c->rests) {
        least[0] = fmax(fmin(least[0], stop), DBL_MIN);
        least[1] = fmax(fmin(least[1], stop * v), DBL_MIN);
    }
    if (l->options.time > 0.0)
        least[0] = fmin(least[0], l->options.time);
    if (l->options.slip > 0.0)
        least[1] = fmin(least[1], l->options.slip);
}

void landing_start(struct landing *l, const struct slow_curve *c, struct vec2 z,
                   const struct layer_options *options, struct layer *out,
                   double least[2])
{
    *l = (struct landing){
        .curve = c,
        .step = l->step,
        .options = *options,
        .from = z,
        .u = { z.x, z.y, 0.0, 0.0 },
        .out = out,
    };
    *out = (struct layer){ LAYER_LOST, .x = { z.x, 0.0, z.x }, .y = NAN };
    l->start = l->across = slider_rounding(c->slider, z);
    if (options->peaks)
        l->mu = l->mu_least = out->mu.value = out->mu.most =
            block_mu(&c->slider->block, z);
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

static struct door door_at(const struct landing *l, const double u[])
{
    const struct slider *s = l->curve->slider;
    struct door door = { .node = -1, .way = HUGE_VAL };

    for (int i = 0; i < (int) s->plane.equilibria && !l->options.through; i++) {
        const struct vec2 e = s->plane.equilibrium[i].z,
                          o = s->plane.system.origin;
        const double dx = u[LAYER_X] - (e.x - o.x);
        const double dy = u[LAYER_Y] - (e.y - o.y);
        const int along = fabs(dy) > fabs(dx);
        const double way = fmax(fabs(dx), fabs(dy)) - TOL_ARREST;
        if (i != slider_saddle(s) && way < door.way)
            door = (struct door){ i, along, way, dx, dy };
    }
    return door;
}

bool landing_is_past(const struct landing *l, const double u[])
{
    return door_at(l, l->u).way > 0.0 && door_at(l, u).way < -TOL_TOUCH;
}

/* `way` of its own from the face, towards which it closes at this rate: what
 * lies to the left of it comes later by what it is further off the face.  With
 * (dx, dy) its way, what lies d beside it meets a face of y at an x that is
 * d/|dy| off, and one of x at the same x. */
static void arrive(struct landing *l, const struct door *door, double closing,
                   double way)
{
    const struct slider *s = l->curve->slider;
    const double *du = l->du;
    const double late =
        door->along ? -du[LAYER_X] / du[LAYER_Y] : du[LAYER_Y] / du[LAYER_X];
    const struct landing_slope across = { late * du[LAYER_TIME],
                                          late * du[LAYER_SLIP] };
    const struct landing_bar bar = landing_weigh(l, &across, 0.0);
    const double level =
        TOL_SLOW_TERMS * slider_rounding(s, landing_place(l)) / closing;
    struct layer *const out = l->out;

    out->end = LAYER_LANDED;
    out->fate = (int8_t) fate_of_node(s, &s->plane.equilibrium[door->node]);
    out->x_end = l->u[LAYER_X] + way * du[LAYER_X];
    out->time = l->u[LAYER_TIME] + way * du[LAYER_TIME];
    out->slip = l->u[LAYER_SLIP] + way * du[LAYER_SLIP];
    out->time_error = bar.time + level * du[LAYER_TIME];
    out->slip_error = bar.slip + level * du[LAYER_SLIP];
    out->x_end_error =
        (door->along ? fmin(l->across / closing, 2.0 * TOL_ARREST) : 0.0) +
        slider_rounding(s, (struct vec2){ out->x_end, 0.0 });
    if (du[LAYER_X] > 0.0)
        layer_peak_raise(&out->x, out->x_end, out->x_end_error);
    if (l->options.peaks)
        layer_peaks_arrive(l, way, l->across / closing + level);
}

/* Beside a box: enters it, takes the next step of Newton's method, or passes it
 * by in steps that cannot meet it.  True also where it grazes a corner. */
static bool enters(struct landing *l, const struct door *door, double *most)
{
    const double side = door->along ? door->y : door->x;
    const double closing = -copysign(1.0, side) * l->du[door->along];
    const double aside = door->along ? door->x : door->y;
    const double wrong = l->across + l->out->place_error;

    if (door->way < -TOL_SEEN)
        return true;
    if (!(closing > TOL_FAR_BELOW) ||
        fabs(aside) > TOL_ARREST - TOL_LAYER_CORNER * wrong) {
        *most = TOL_STEP_SAFETY * door->way;
        return !(door->way > TOL_SAME + TOL_LAYER_CORNER * wrong);
    }
    *most = door->way / closing;
    if (fabs(*most) > TOL_TOUCH) {
        if (l->options.peaks && door->way > 0.0)
            *most *= TOL_LAYER_SHORT; /* or it sees peaks beyond */
        return false;
    }
    arrive(l, door, closing, *most);
    return true;
}

/* ---- the slow curve ------------------------------------------------------ */

static bool overlap(double a, double b, double lo, double hi)
{
    return fmin(a, b) < hi && fmax(a, b) > lo;
}

/* Whether no box lies between here and the slow point y. */
static bool is_clear(const struct landing *l, const struct slow_point *p,
                     double y)
{
    const struct slider *s = l->curve->slider;
    const double size = (1.0 + TOL_SEEN) * TOL_ARREST;

    for (size_t i = 0; i < s->plane.equilibria && !l->options.through; i++) {
        const struct vec2 e = phase_plane_offset(&s->plane, i);
        if ((int) i != slider_saddle(s) &&
            overlap(l->u[LAYER_X], p->x, e.x - size, e.x + size) &&
            overlap(l->u[LAYER_Y], y, e.y - size, e.y + size))
            return false;
    }
    return true;
}

/* How far beside the curve it still is where that enters a box. */
static double left_of(const struct landing *l, const struct slow_point *p,
                      double off)
{
    return l->options.through || p->end_slope == 0.0
               ? 0.0
               : TOL_LAYER_FORGET * fabs(off) * exp(-p->folds);
}

static bool table_at(const struct landing *l, double y, struct slow_point *p)
{
    return l->options.through
               ? slow_curve_anywhere(l->curve, y, p) && isfinite(p->gap)
               : slow_curve_at(l->curve, y, p);
}

/* The point of the curve that shares the fibre of the end of the walk; *off:
 * how far along it, signed. */
static bool project(const struct landing *l, double *y, struct slow_point *p,
                    double *off)
{
    *y = l->u[LAYER_Y];
    for (int i = 0; i < 4; i++) {
        if (!table_at(l, *y, p))
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

/* How many times as long as by a linear fall psi may wait, its own rate of next
 * to nothing, until the curve comes: by a sinh, ahead of it; 0: it may not. */
static double waiting(const struct landing *l, const struct slow_point *p,
                      double off)
{
    const double ahead = -off * p->fibre.y * p->time_slope;

    return l->curve->slider->block.waits && fabs(p->fibre.y) > fabs(p->fibre.x)
               ? p->fast * fmax(ahead, 0.0)
               : 0.0;
}

/* How unlike a linear one its fall is, `off` along the fibre: a sinh is steeper
 * than its tangent, and may take `off` over the curve's speed. */
static double unevenness(const struct landing *l, const struct slow_point *p,
                         double off)
{
    const double det = p->fibre.x - p->fibre.y * p->x_slope;
    const double fall = l->du[LAYER_X] - l->du[LAYER_Y] * p->x_slope;
    const double linear = -p->fast * det * off * l->du[LAYER_TIME];
    const double larger = fmax(fabs(fall), fabs(linear));
    const double longer = fmax(waiting(l, p, off), 1.0);

    return larger > 0.0 ? longer * fabs(fall - linear) / larger : 0.0;
}

/* The sine of the angle between its fibre and the way it falls, less the way of
 * the curve: psi far off psi_ss leaps by a sinh, whatever v settles to. */
static double turning(const struct landing *l, const struct slow_point *p)
{
    const double back = l->du[LAYER_TIME] / p->time_slope;
    const struct vec2 fall = { l->du[LAYER_X] + back * p->x_slope,
                               l->du[LAYER_Y] + back };
    const double size = vec2_length(fall);

    return size > 0.0 ? fabs(fall.x * p->fibre.y - fall.y * p->fibre.x) / size
                      : 0.0;
}

/* Whether its fibre says too little of where it lands: psi may wait until the
 * curve has passed, or it may land anywhere on the way. */
static bool is_vague(const struct landing *l, const struct slow_point *p,
                     double off, double bend)
{
    const double wait = waiting(l, p, off);

    return bend > TOL_CLEARLY * fabs(off) || wait > 1.0 ||
           (wait > 0.0 && fabs(off) > TOL_LAYER_CLOSER);
}

/* Of a point to the left of the end of the walk: its place on the curve is
 * another one, and so is how far along the fibre it is, by which slip has this
 * slope. */
static struct landing_slope across_fibre(const struct landing *l,
                                         const struct slow_point *p,
                                         double off_slope)
{
    const double dx = l->du[LAYER_X], dy = l->du[LAYER_Y];
    const struct vec2 e = p->fibre;
    const double det = e.x - e.y * p->x_slope;
    const double on = (e.x * dx + e.y * dy) / det;
    const double off = -(dy + dx * p->x_slope) / det;

    return (struct landing_slope){ p->time_slope * on,
                                   p->slip_slope * on + off_slope * off };
}

/* How far beside its fibre it may be: `part` of what that leans and turns; how
 * far off the fibre itself is; and, where fibres turn, that of y may not be the
 * one that led to y. */
static double bend_of(const struct landing *l, double y,
                      const struct slow_point *p, double off, double part)
{
    const struct vec2 e = p->fibre;
    const double leans = fabs(e.x * e.y) + p->turns;
    const double beside =
        fabs(e.x * (l->u[LAYER_Y] - y) - e.y * (l->u[LAYER_X] - p->x));

    return fabs(off) * fmax(leans * part + p->swing, turning(l, p)) + beside;
}

/* What the table says of the point y, `off` away along its fibre, added to what
 * was before.  False: nearer to the curve it would be good enough. */
static bool land(struct landing *l, double y, const struct slow_point *p,
                 double off, double *excess)
{
    const struct slider *s = l->curve->slider;
    const struct vec2 e = p->fibre;
    const double det = fabs(e.x - e.y * p->x_slope);
    const double uneven = fabs(off) + unevenness(l, p, off);
    const double bend = bend_of(l, y, p, off, uneven) / det;
    const double wrong = bend + l->across / det;
    const double d = off * e.x, v = exp(s->block.at.x0 + p->x);
    const double more = v / p->fast * d * (1.0 + 0.25 * d);
    const double unsaid =
        fabs(more) * (uneven + TOL_LAYER_BEND * (fabs(off) + p->gap));
    const double time = l->u[LAYER_TIME] + p->time;
    const double slip = l->u[LAYER_SLIP] + p->slip + more;
    const double left = left_of(l, p, off);
    const double wait = left * fabs(p->end_slope); /* it enters later */
    const double waste =
        wait > 0.0 ? wait * exp(s->block.at.x0 + p->x_end) : 0.0;
    const double late = 2.0 * fabs(p->time_slope) * bend;
    const double lateness =
        p->fate == FATE_REST_ASYMPTOTIC
            ? 0.0
            : (late + wait) / fmax(time, l->curve->time_least);
    const double long_ = 2.0 * fabs(p->slip_slope) * bend + unsaid;
    struct layer *const out = l->out;

    *excess =
        fmax(lateness, (long_ + waste) / fmax(slip, l->curve->slip_least));
    if (l->options.through)
        *excess = fmax(*excess, bend);
    *excess /= TOL_SHARE * l->options.promise;
    if (is_vague(l, p, off, bend))
        *excess = fmax(*excess, 1.0 / TOL_SHARE);
    if (*excess > 1.0 && fabs(off) > TOL_ROOT)
        return false;
    if (!is_clear(l, p, y))
        return false;
    if (l->options.peaks && !layer_peaks_land(l, p, y, off, excess))
        return false;
    const struct landing_slope across =
        across_fibre(l, p, v / p->fast * e.x * (1.0 + 0.5 * d));
    const struct landing_bar bar =
        landing_weigh(l, &across, p->slip_slope / p->time_slope);
    out->end = LAYER_LANDED;
    if (slider_saddle(s) >= 0 && !(wrong < TOL_CLEARLY * fabs(y)))
        out->end = LAYER_UNSURE;
    out->fate = p->fate;
    out->x_end = p->x_end;
    out->y = y;
    out->way_time_error = bar.time + late;
    out->way_slip_error = bar.more + unsaid;
    out->time = time;
    out->slip = slip;
    out->time_error = bar.time + late + (p->time_error - p->time_less) + wait;
    out->slip_error = bar.slip + long_ + (p->slip_error - p->slip_less) + waste;
    out->x_end_error = p->x_end_error + left * p->end_aside;
    return true;
}

/* ---- other ends ---------------------------------------------------------- */

/* v vanishes and psi grows within no time (as in fate.c). */
static bool rests(struct landing *l)
{
    const double *du = l->du, *u = l->u;
    const double soon = TOL_REST_GOOD * u[LAYER_TIME];

    if (!(-du[LAYER_X] * soon > du[LAYER_TIME] &&
          du[LAYER_Y] * soon > du[LAYER_TIME]))
        return false;
    const double left = -du[LAYER_TIME] / du[LAYER_X];
    const double v = exp(l->curve->slider->block.at.x0 + u[LAYER_X]);
    const struct landing_slope none = { 0.0, 0.0 };
    const struct landing_bar bar = landing_weigh(l, &none, 0.0);
    l->out->end = LAYER_RESTED;
    l->out->fate = FATE_REST_FINITE;
    l->out->x_end = -HUGE_VAL;
    l->out->time = u[LAYER_TIME] + left;
    l->out->slip = u[LAYER_SLIP] + 0.5 * v * left;
    l->out->time_error = bar.time + left;
    l->out->slip_error = bar.slip + v * left;
    return true;
}

static bool runs(struct landing *l, bool may_land)
{
    const double far = l->across;

    if (!l->curve->runs_away || (l->options.through && may_land) ||
        !(l->u[LAYER_X] > far && l->u[LAYER_Y] < -far))
        return false;
    l->out->end = LAYER_RAN;
    l->out->fate = FATE_RUNAWAY;
    return true;
}

/* ---- all of them --------------------------------------------------------- */

/* Whether v still rises to a curve along which it falls: its peak is between.
 */
static bool is_rising(const struct landing *l)
{
    struct slow_point p;

    return l->options.peaks && l->du[LAYER_X] > 0.0 &&
           table_at(l, l->u[LAYER_Y], &p) && p.x_peak <= p.x;
}

/* Whether it has landed, d from the curve.  If not, *aim: how near to come. */
static bool lands(struct landing *l, double d, double *aim)
{
    struct slow_point p;
    double y, off, excess = 1.0;

    if (is_rising(l)) {
        *aim = fmin(*aim, TOL_SHARE * fabs(d));
        return false;
    }
    if (!(fabs(d) < *aim))
        return false;
    if (project(l, &y, &p, &off) && land(l, y, &p, off, &excess))
        return true;
    *aim = fabs(d) * fmin(TOL_SHARE, fmax(1.0 / TOL_RETRY, TOL_SHARE / excess));
    return false;
}

static bool is_over(struct landing *l, double *most)
{
    const struct door door = door_at(l, l->u);
    double aim = l->options.landing, x, x_slope;

    if (door.way <= 0.0 && l->u[LAYER_TIME] == 0.0)
        return true; /* it starts in a box */
    *most = TOL_STEP_SAFETY * door.way;
    const bool beside = slow_curve_beside(l->curve, l->u[LAYER_Y],
                                          l->options.through, &x, &x_slope);
    if (rests(l) || runs(l, beside))
        return true;
    const double d = l->u[LAYER_X] - x;
    if (beside && door.way > 0.0 && lands(l, d, &aim))
        return true;
    if (door.way < TOL_SEEN)
        return enters(l, &door, most);
    const double closing = l->du[LAYER_X] - x_slope * l->du[LAYER_Y];
    if (beside && d * closing < 0.0)
        *most = fmin(*most, (fabs(d) - TOL_AIM * aim) / fabs(closing));
    return landing_rests(l, most);
}

bool landing_is_over(struct landing *l, double *most)
{
    if (l->out->steps == 0) {
        l->start_time = l->start * l->du[LAYER_TIME];
        l->start_slip = l->start * l->du[LAYER_SLIP];
    }
    if (landing_near(l))
        return true;
    if (!is_over(l, most))
        return false;
    landing_keep_near(l);
    return true;
}
