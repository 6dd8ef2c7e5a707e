/* Orbits of equal p arrive together, whatever their q adds to the slip: the
 * base point of one that came here in a time t is where p is e^(-lambda t)
 * times as large, and that holds on the separatrix too. */
#include "landing_near.h"

#include <float.h>
#include <math.h>

#include "landing_weigh.h"
#include "slow_tolerance.h"

/* The branch on that side of the saddle; NULL: there is none. */
static const struct slow_branch *branch_of(const struct slow_curve *c, double p)
{
    for (size_t i = 0; i < c->branches; i++) {
        const struct slow_branch *b = &c->branch[i];
        if (b->near && b->first.p * p > 0.0)
            return b;
    }
    return c->away.count > 2 && c->away.first.p * p > 0.0 ? &c->away : NULL;
}

/* How wrong p is, relative to it: by the series, and by how far the orbit is
 * off. */
static double blur_of(const struct saddle_point *at)
{
    return at->p_error / fmax(fabs(at->p), DBL_MIN);
}

static double doubt_of(const struct landing *l, const struct saddle_point *at)
{
    const double slope = hypot(at->p_x, at->p_y);

    return blur_of(at) + slope * l->across / fmax(fabs(at->p), DBL_MIN);
}

/* What the steps before have made of it all; of slip less v time too, which is
 * q alone. */
static struct landing_bar weigh(const struct landing *l,
                                const struct saddle_series *u,
                                const struct saddle_point *at, double doubt)
{
    const double *du = l->du;
    const double p = du[LAYER_X] * at->p_y - du[LAYER_Y] * at->p_x;
    const double q = du[LAYER_X] * at->q_y - du[LAYER_Y] * at->q_x;
    const double size = copysign(fmax(fabs(at->p), DBL_MIN), at->p);
    const double late = -p / size / u->lambda;
    const struct landing_slope across = { late, u->v * late + q };
    struct landing_bar bar = landing_weigh(l, &across, u->v);
    const double more = 1.0 + doubt; /* ln|p| is no line */

    bar.time *= more;
    bar.slip *= more;
    return bar;
}

/* Where it began, in the coordinates of the series. */
static void tell_base(const struct landing *l, const struct saddle_series *u,
                      const struct saddle_point *at,
                      const struct landing_bar *bar, struct layer *out)
{
    const double time = l->u[LAYER_TIME];
    const double p = exp(-u->lambda * time) * at->p;
    const double wrong =
        blur_of(at) + u->lambda * (bar->time + u->lambda_error * time);

    out->y = saddle_series_y(u, p);
    const struct saddle_point on = saddle_series_on(u, out->y);
    out->y_error = fabs(p) * wrong / (on.p_y + on.p_x * on.x_slope);
    out->more = l->u[LAYER_SLIP] - u->v * time + at->q - on.q;
    out->way_slip_error = bar->more + at->q_error;
}

/* All of it, in *out; the end of it is on branch b. */
static void tell(const struct landing *l, const struct slow_branch *b,
                 const struct saddle_point *at, double doubt, struct layer *out)
{
    const struct saddle_series *u = b->near;
    const struct slow_knot *k = b->knot;
    const double fold = log(b->first.p / at->p) / u->lambda;

    out->end = b == &l->curve->away ? LAYER_RAN : LAYER_LANDED;
    if (!(doubt < TOL_CLEARLY))
        out->end = LAYER_UNSURE;
    out->fate = b->fate;
    out->x_end = b->x_end;
    out->x_end_error = b->x_end_error;
    out->time = l->u[LAYER_TIME] + k->time[0] + fold;
    out->slip =
        l->u[LAYER_SLIP] + k->slip[0] + u->v * fold + at->q - b->first.q;
}

static void tell_bars(const struct slow_branch *b,
                      const struct saddle_point *at,
                      const struct landing_bar *bar, struct layer *out)
{
    const struct saddle_series *u = b->near;
    const struct slow_knot *k = b->knot;
    const double fold = log(b->first.p / at->p) / u->lambda;
    const double wrong =
        (blur_of(at) * (1.0 + blur_of(at)) + TOL_ROUNDED) / u->lambda +
        u->lambda_error * fabs(fold);

    out->time_error = bar->time + k->time_bar + wrong;
    out->slip_error = bar->slip + k->slip_bar + u->v * wrong + at->q_error;
}

/* Whether nearer to the saddle the series would tell what was promised, and
 * here they do not. */
static bool is_early(const struct landing *l, const struct saddle_point *at,
                     const struct layer *out)
{
    const double wrong = at->p_error / fabs(at->p) / l->curve->near->lambda;
    const struct vec2 to = landing_place(l);
    const bool nears = to.x * l->du[LAYER_X] + to.y * l->du[LAYER_Y] < 0.0;

    const double whole = out->fate == FATE_REST_ASYMPTOTIC
                             ? out->slip / l->curve->near->v
                             : out->time;

    return nears && wrong > TOL_SHARE * l->options.promise * whole &&
           hypot(to.x, to.y) > TOL_SAME;
}

bool landing_near(struct landing *l)
{
    const struct saddle_series *u = l->curve->near;
    const struct vec2 z = landing_place(l);
    struct saddle_point at;

    if (l->near.is_near || u == NULL || !saddle_series_at(u, z, &at))
        return false;
    const struct slow_branch *b = branch_of(l->curve, at.p);
    if (b == NULL)
        return false;
    struct layer told = *l->out;
    const double doubt = doubt_of(l, &at);
    tell(l, b, &at, doubt, &told);
    if (is_early(l, &at, &told))
        return false;
    const struct landing_bar bar = weigh(l, u, &at, doubt);
    tell_bars(b, &at, &bar, &told);
    tell_base(l, u, &at, &bar, &told);
    told.is_near = true;
    l->near = told;
    if (!l->options.peaks)
        *l->out = told;
    return !l->options.peaks;
}

void landing_keep_near(struct landing *l)
{
    const struct layer *near = &l->near;
    struct layer *const out = l->out;

    if (!near->is_near || out->end == LAYER_LOST || out->end == LAYER_RAN)
        return;
    out->end = near->end;
    out->fate = near->fate;
    out->x_end = near->x_end;
    out->time = near->time;
    out->slip = near->slip;
    out->time_error = near->time_error;
    out->slip_error = near->slip_error;
    out->x_end_error = near->x_end_error;
}
