/*
 * A step's error is its first missing term, known from the field at its end
 * (graph_missing), with its sign.  The linearised field carries it on: over a
 * step an error e of dep becomes e exp(integral of S_dep), and makes e times
 * the integral of what S_dep made of it by then and d rate/d dep of an
 * integral.  Both integrals are taken from the ends of the step, and are off by
 * no more than BEND of the difference between the two; that adds to the bounds.
 * So errors that cancel do so in the bars.
 */
#include "grow_error.h"

#include <float.h>
#include <math.h>

#include "many.h"
#include "tolerance.h"

double grow_error_bound(const struct grow_miss *m)
{
    return fabs(m->off) + m->bar + TOL_ROUNDING_BAR * m->noise;
}

void grow_error_look(struct grower *g, struct vec2 z)
{
    const struct planar *sys = g->sys;
    const struct planar_jacobian *J = &g->end.J;
    const bool over_x = g->ind == 0;
    const struct vec2 f = J->field.direction;
    const double ind = grower_along(g, f), lean = g->lean;
    const double dep_i = over_x ? J->matrix.yx : J->matrix.xy;
    const double dep_d = (over_x ? J->matrix.yy : J->matrix.xx) - lean * dep_i;
    const double own_i = over_x ? J->matrix.xx : J->matrix.yy;
    const double own_d = (over_x ? J->matrix.xy : J->matrix.yx) - lean * own_i;
    const double ind_i = own_i + lean * dep_i, ind_d = own_d + lean * dep_d;
    const double unit = g->end.unit;

    g->out.slope = grower_slope(g, f);
    g->out.slope_i = (dep_i - g->out.slope * ind_i) / ind;
    g->out.slope_d = (dep_d - g->out.slope * ind_d) / ind;
    for (size_t i = 0; i < g->carry->count; i++) {
        double rate = g->end.rate;
        struct vec2 gradient = g->end.gradient;
        if (!g->b->from_saddle[i])
            continue;
        if (many_carried(g->carry) < 0)
            sys->rate_gradient(sys->ctx, (size_t) g->carry->which[i], z, &rate,
                               &gradient);
        const double rate_i = over_x ? gradient.x : gradient.y;
        const double rate_d =
            (over_x ? gradient.y : gradient.x) - lean * rate_i;
        g->out.swift[i] = unit * rate / ind;
        g->out.swift_i[i] = unit * (rate_i - rate / ind * ind_i) / ind;
        g->out.swift_d[i] = unit * (rate_d - rate / ind * ind_d) / ind;
    }
}

/* What becomes of errors of dep: `mean` times as much, but up to `most`. */
struct factor {
    double mean, most;
};

static void pass(struct grow_miss *to, const struct grow_miss *m,
                 struct factor by)
{
    to->off += by.mean * m->off;
    to->bar += by.most * m->bar + (by.most - fabs(by.mean)) * fabs(m->off);
    to->noise += by.most * m->noise;
}

/* Of dep's errors so far: what they become, and what they add to integrals. */
static void pass_on(struct grower *g, struct factor grown,
                    const struct factor drift[])
{
    const double off = fabs(g->miss.off);
    struct branch_miss *p = &g->piece;
    struct grow_miss dep = { 0 };

    for (size_t i = 0; i < g->carry->count; i++) {
        pass(&g->total_miss[i], &g->miss, drift[i]);
        p->drift[i] += p->grown * drift[i].mean;
        p->total_bar[i] += (drift[i].most - fabs(drift[i].mean)) * off;
    }
    pass(&dep, &g->miss, grown);
    p->grown *= grown.mean;
    p->bar += (grown.most - fabs(grown.mean)) * off;
    g->miss = dep;
}

void grow_error_turn(struct grower *g, double turned, double ahead)
{
    struct factor drift[LOCAL_CARRY_MAX];

    for (size_t i = 0; i < g->carry->count; i++) {
        const double late = -ahead * g->out.swift[i]; /* at another time */
        drift[i] = (struct factor){ late, fabs(late) };
    }
    pass_on(g, (struct factor){ turned, fabs(turned) }, drift);
}

void grow_error_tail(struct grower *g, double grown, const double drift[])
{
    struct factor late[LOCAL_CARRY_MAX];

    for (size_t i = 0; i < g->carry->count; i++)
        late[i] = (struct factor){ drift[i], fabs(drift[i]) };
    pass_on(g, (struct factor){ grown, fabs(grown) }, late);
}

/* Roundings of d dep/d ind and, relative, of rates over that of ind: each
 * component of the field is made of parts that cancel, and of a number whose
 * logarithm is its size. */
struct noise {
    double slope, rate;
};

static struct noise noise_at(const struct grower *g, struct vec2 z)
{
    const struct mat2 m = g->end.J.matrix;
    const struct vec2 f = g->end.J.field.direction;
    const double x = fabs(m.xx * z.x) + fabs(m.xy * z.y);
    const double y = fabs(m.yx * z.x) + fabs(m.yy * z.y);
    const double own =
        (g->ind == 0 ? x : y) + fabs(g->lean) * (g->ind == 0 ? y : x);
    const double ind = fabs(grower_along(g, f));
    const double rate =
        TOL_ROUNDINGS_FEW + 0.5 * fabs(g->end.J.field.log_scale) + own / ind;

    return (struct noise){ DBL_EPSILON * (rate * fabs(g->out.slope) +
                                          (g->ind == 0 ? y : x) / ind),
                           DBL_EPSILON * rate };
}

/* Between two values at the ends of a step. */
static struct factor between(double first, double last)
{
    const double mean = 0.5 * (first + last);

    return (struct factor){ mean,
                            fabs(mean) + TOL_STEP_BEND * fabs(last - first) };
}

/* S_dep on the way. */
static double slope_d_at(const struct grower *g, double part)
{
    const double s = part * g->toward * g->h;
    const double dep = jet_at(g->order, g->u.at[1 - g->ind], s);
    const double ind = g->u.at[g->ind][0] + s * g->unit;
    struct planar_jacobian J;

    g->sys->jacobian(g->sys->ctx, local_point(g->ind, ind, dep), &J);
    const struct vec2 f = J.field.direction;
    return g->ind == 0 ? (J.matrix.yy - f.y / f.x * J.matrix.xy) / f.x
                       : (J.matrix.xx - f.x / f.y * J.matrix.yx) / f.y;
}

/* The integral of S_dep over the step times `turn`, from its values at the
 * ends; and a bound on its error.  A branch that is followed may wind: there it
 * is Boole's rule, which Simpson's tells from. */
static void grow_rate(const struct grower *g, double turn, double first,
                      double last, double *mean, double *off)
{
    *mean = 0.5 * (first + last);
    *off = TOL_STEP_BEND * fabs(last - first);
    if (g->o->follower == NULL)
        return;
    const double a = turn * slope_d_at(g, 0.25), b = turn * slope_d_at(g, 0.5);
    const double c = turn * slope_d_at(g, 0.75);
    const double simpson = (first + 4.0 * b + last) / 6.0;
    const double boole =
        (7.0 * first + 32.0 * a + 12.0 * b + 32.0 * c + 7.0 * last) / 90.0;
    if (fabs(boole - simpson) < *off) {
        *mean = boole;
        *off = fabs(boole - simpson);
    }
}

/* What becomes of errors made before the step, from the field at its ends. */
static void carry_over(struct grower *g, const struct outward *before)
{
    const double turn = g->toward * g->h * g->unit;
    double rate, off;

    grow_rate(g, turn, turn * before->slope_d, turn * g->out.slope_d, &rate,
              &off);
    const double mean = fmin(rate, TOL_STEP_MOST);
    const double more = exp(fmin(off, TOL_STEP_MOST));
    const struct factor grown = { exp(mean), exp(mean) * more };
    struct factor drift[LOCAL_CARRY_MAX];

    for (size_t i = 0; i < g->carry->count; i++) {
        const double e = turn * g->out.swift_d[i] * grown.mean;
        drift[i] = between(turn * before->swift_d[i], e);
        drift[i].most += 0.5 * fabs(e) * (more - 1.0);
    }
    pass_on(g, grown, drift);
}

static void add(struct grow_miss *m, struct graph_miss own, double noise)
{
    m->off += own.value;
    m->bar += own.bar;
    m->noise = hypot(m->noise, noise);
}

/* What a rate should be, per s: by ind, and by ind once more where dep goes
 * with `slope`; `noise` is relative. */
static struct graph_rate rate_of(const struct grower *g, double value,
                                 double by_ind, double by_dep, double slope,
                                 double noise)
{
    const double unit = g->unit; /* its square may be beyond a double */

    return (struct graph_rate){
        .value = unit * value,
        .noise = unit * noise * fabs(value),
        .change = unit * (unit * (by_ind + by_dep * slope)),
        .change_noise =
            unit * (unit * noise * (fabs(by_ind) + fabs(by_dep * slope))),
    };
}

/* The step's own: dep's rate goes on as its series has it. */
static struct graph_miss own_dep(struct grower *g, const struct noise *noise,
                                 const struct outward *before)
{
    const double s = g->toward * g->h, per_s = s * g->unit;
    const double *dep = g->u.at[1 - g->ind];
    struct graph_rate rate =
        rate_of(g, g->out.slope, g->out.slope_i, g->out.slope_d,
                g->dep_end.slope / g->unit, noise->rate);

    rate.noise = g->unit * noise->slope;
    rate.growth = per_s * g->out.slope_d;
    rate.bend = fabs(per_s * before->slope_d - rate.growth) + fabs(rate.growth);
    struct graph_miss own =
        graph_missing(dep, g->order, s, &g->dep_end, &rate, g->kink == 0.0);
    own.bar += g->h * g->unit * g->kink;
    return own;
}

/* How far the slope of integral i's series is off at s. */
static double integral_off(const struct grower *g, size_t i, double s)
{
    const struct planar *sys = g->sys;
    const double dep = jet_at(g->order, g->u.at[1 - g->ind], s);
    const struct vec2 z = grower_point(g, s, dep);
    struct planar_field f;
    double rate;

    sys->field(sys->ctx, z, &f);
    sys->rate_gradient(sys->ctx, (size_t) g->carry->which[i], z, &rate, NULL);
    const double ind = grower_along(g, f.direction);
    return fabs(g->unit * exp(-f.log_scale) * rate / ind -
                jet_slope_at(g->order, g->u.integral[i], s));
}

/* The same over the whole step: between two looks no more than at the larger of
 * all so far and the next, for what a series leaves out grows outwards. */
static double integral_bar(const struct grower *g, size_t i)
{
    static const double part[] = { 0.5, 0.75, 0.9, 1.0 };
    double bar = 0.0, most = 0.0, before = 0.0;

    for (size_t k = 0; k < sizeof part / sizeof *part; k++) {
        most = fmax(most, integral_off(g, i, part[k] * g->toward * g->h));
        bar += (part[k] - before) * g->h * most;
        before = part[k];
    }
    return bar;
}

/* An integral's is that at the true end, which `dep_off` leads to; where its
 * terms do not fall, no more than its slope is off on the way. */
static void add_integral(struct grower *g, size_t i, const struct noise *noise,
                         const struct outward *before, double dep_off)
{
    const double s = g->toward * g->h, *u = g->u.integral[i];
    const double by_dep = g->out.swift_d[i];
    struct graph_rate rate =
        rate_of(g, g->out.swift[i] + by_dep * dep_off, g->out.swift_i[i],
                by_dep, g->out.slope + g->out.slope_d * dep_off, noise->rate);
    const struct graph_end *end = &g->integral_end[i];
    const double rounded =
        noise->rate * fabs(end->value) + 0.5 * DBL_EPSILON * fabs(g->total[i]);

    rate.change_noise +=
        fabs(g->unit / s * (by_dep - before->swift_d[i]) * dep_off);
    struct graph_miss own =
        graph_missing(u, g->order, s, end, &rate, g->kink == 0.0);
    if (own.value == 0.0 && g->kink == 0.0 && g->b->from_saddle[i])
        own.bar = fmin(own.bar, integral_bar(g, i));

    add(&g->total_miss[i], own, rounded);
    g->piece.total_bar[i] += own.bar;
}

void grow_error_step(struct grower *g)
{
    const double way = g->h * g->unit;
    const struct outward before = g->out;
    const double entering = grow_error_bound(&g->miss);
    const double *dep = g->u.at[1 - g->ind];

    grow_error_look(g, g->at_end);
    carry_over(g, &before);
    const struct noise noise = noise_at(g, g->at_end);
    const struct graph_miss own = own_dep(g, &noise, &before);
    const double over = fabs(g->u.at[g->ind][0]) + fabs(g->lean * dep[0]);
    const double place = fabs(dep[0]) + fabs(g->out.slope) * over;
    add(&g->miss, own, noise.slope * way + 0.5 * DBL_EPSILON * place);
    g->piece.bar += own.bar;
    g->worst = fmax(entering, grow_error_bound(&g->miss));
    for (size_t i = 0; i < g->carry->count; i++)
        add_integral(g, i, &noise, &before, own.value);
}
