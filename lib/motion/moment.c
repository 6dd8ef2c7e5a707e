#include "moment.h"

#include <math.h>

#include "motion_tolerance.h"
#include "slider.h"

const char *const moment_names[] = { "v_sp",
                                     "v_minus",
                                     "v_plus",
                                     "v_level",
                                     "psi_level",
                                     "psi_minimum",
                                     "psi_maximum",
                                     "mu_minimum",
                                     "mu_maximum",
                                     "v_minimum",
                                     "v_maximum",
                                     "mu_nears_tan_alpha",
                                     "mu_leaves_tan_alpha",
                                     "arrest",
                                     "rest",
                                     NULL };

const char *const moment_units[] = {
    [MOMENT_V_SP] = "V_star",   [MOMENT_V_MINUS] = "V_star",
    [MOMENT_V_PLUS] = "V_star", [MOMENT_V] = "V_star",
    [MOMENT_PSI] = "psi",       [MOMENTS] = NULL,
};

static struct vec2 place(const double u[])
{
    return (struct vec2){ u[0], u[1] };
}

/* ---- functions of the state ---------------------------------------------- */

/* (17): d ln v/dt = cos(alpha)/(eps^2 v) (tan(alpha) - mu), which has all its
 * digits near the anchor. */
double moment_excess_friction(const struct slider *s, struct vec2 z)
{
    struct planar_field f;

    s->plane.system.field(s->plane.system.ctx, z, &f);
    if (fabs(f.direction.x) > TOL_MOMENT_DIRECTION)
        return -f.direction.x *
               exp(f.log_scale + z.x - s->block.at.log_inertia);
    return block_mu(&s->block, z) - (double) s->block.tan_alpha;
}

static double v_level(const void *ctx, double s, const double u[])
{
    const struct moment_watch *w = ctx;

    (void) s;
    return u[0] - w->at;
}

static double psi_level(const void *ctx, double s, const double u[])
{
    const struct moment_watch *w = ctx;

    (void) s;
    return u[1] - w->at;
}

static double psi_rate(const void *ctx, double s, const double u[])
{
    const struct moment_watch *w = ctx;
    const struct planar *sys = &w->slider->plane.system;
    struct planar_field f;

    (void) s;
    sys->field(sys->ctx, place(u), &f);
    return f.direction.y;
}

/* dmu along the field's direction; the gradient of mu from that of mu v. */
static double mu_rate(const void *ctx, double s, const double u[])
{
    const struct moment_watch *w = ctx;
    const struct planar *sys = &w->slider->plane.system;
    const struct vec2 z = place(u);
    struct planar_field f;
    struct vec2 work;
    double v, mu_v;

    (void) s;
    sys->field(sys->ctx, z, &f);
    sys->rate_gradient(sys->ctx, BLOCK_SLIP, z, &v, NULL);
    sys->rate_gradient(sys->ctx, BLOCK_WORK, z, &mu_v, &work);
    return (work.x - mu_v) / v * f.direction.x + work.y / v * f.direction.y;
}

static double v_rate(const void *ctx, double s, const double u[])
{
    const struct moment_watch *w = ctx;

    (void) s;
    return -moment_excess_friction(w->slider, place(u));
}

static double nearness(const void *ctx, double s, const double u[])
{
    const struct moment_watch *w = ctx;

    (void) s;
    return fabs(moment_excess_friction(w->slider, place(u))) - w->at;
}

static double distance(const struct slider *s, size_t i, struct vec2 z)
{
    const struct vec2 at = phase_plane_offset(&s->plane, i);

    return fmax(fabs(z.x - at.x), fabs(z.y - at.y));
}

const struct equilibrium *moment_node_at(const struct slider *s, struct vec2 z,
                                         double reach)
{
    for (size_t i = 0; i < s->plane.equilibria; i++)
        if (s->plane.equilibrium[i].type == EQUILIBRIUM_STABLE_NODE &&
            distance(s, i, z) <= reach)
            return &s->plane.equilibrium[i];
    return NULL;
}

static double node_distance(const void *ctx, double s, const double u[])
{
    const struct moment_watch *w = ctx;
    double least = HUGE_VAL;

    (void) s;
    for (size_t i = 0; i < w->slider->plane.equilibria; i++)
        if (w->slider->plane.equilibrium[i].type == EQUILIBRIUM_STABLE_NODE)
            least = fmin(least, distance(w->slider, i, place(u)));
    return least - TOL_ARREST;
}

/* direction * exp(log_scale), either of which may leave the doubles. */
static double rate_of(double direction, double log_scale)
{
    return copysign(exp(log(fabs(direction)) + log_scale), direction);
}

struct vec2 moment_rates(const struct slider *s, const double u[])
{
    struct planar_field f;

    s->plane.system.field(s->plane.system.ctx, place(u), &f);
    return (struct vec2){ rate_of(f.direction.x, f.log_scale),
                          rate_of(f.direction.y, f.log_scale) };
}

/* ---- watches ------------------------------------------------------------- */

static double (*const watched[MOMENTS])(const void *, double,
                                        const double[]) = {
    [MOMENT_V_SP] = v_level,      [MOMENT_V_MINUS] = v_level,
    [MOMENT_V_PLUS] = v_level,    [MOMENT_V] = v_level,
    [MOMENT_PSI] = psi_level,     [MOMENT_PSI_MIN] = psi_rate,
    [MOMENT_MU_MIN] = mu_rate,    [MOMENT_V_MIN] = v_rate,
    [MOMENT_MU_NEARS] = nearness, [MOMENT_ARREST] = node_distance,
};

static void add(struct moment_watches *w, const struct slider *s,
                enum moment what, double level, double at)
{
    const size_t i = w->count++;

    w->watch[i] = (struct moment_watch){ s, what, level, at };
    w->event[i] = (struct event){ .value = watched[what], .ctx = &w->watch[i] };
}

static void add_level(struct moment_watches *w, const struct slider *s,
                      const struct moment_level *l)
{
    const bool psi_is_log = !s->plane.system.axis[1].is_log;
    double at = l->value;

    if (l->what == MOMENT_V)
        at = log(l->value) - s->plane.system.origin.x;
    else if (l->what == MOMENT_PSI)
        at = (psi_is_log ? l->value : log(l->value)) - s->plane.system.origin.y;
    add(w, s, l->what, l->value, at);
}

/* A critical velocity by its logarithm. */
static void add_critical(struct moment_watches *w, const struct slider *s,
                         enum moment what, const struct quantity *ln_v)
{
    if (quantity_exists(ln_v))
        add(w, s, what, exp(ln_v->value),
            ln_v->value - s->plane.system.origin.x);
}

void moment_watch_all(struct moment_watches *w, const struct slider *s,
                      const struct moment_level *level, size_t levels,
                      bool stop)
{
    const double none = (double) NAN;

    w->count = 0;
    if (slider_saddle(s) >= 0)
        add(w, s, MOMENT_V_SP, s->block.at.v0, 0.0);
    add_critical(w, s, MOMENT_V_MINUS, &s->critical.ln_v_minus);
    add_critical(w, s, MOMENT_V_PLUS, &s->critical.ln_v_plus);
    add(w, s, MOMENT_PSI_MIN, none, 0.0);
    add(w, s, MOMENT_MU_MIN, none, 0.0);
    add(w, s, MOMENT_V_MIN, none, 0.0);
    add(w, s, MOMENT_ARREST, none, 0.0);
    w->event[w->count - 1].direction = -1;
    w->event[w->count - 1].stop = stop;
    const double near = TOL_ARREST * (double) s->block.tan_alpha;
    add(w, s, MOMENT_MU_NEARS, near, near);
    for (size_t i = 0; i < levels && i < MOMENT_LEVELS_MAX; i++)
        add_level(w, s, &level[i]);
}

/* Whether the watched function rises through its zero at the hit. */
static bool rises(const struct moment_watch *w, const struct event *e,
                  const struct event_hit *hit, const struct curve *c)
{
    double before[CURVE_DIM_MAX], after[CURVE_DIM_MAX];

    curve_at(c, hit->piece, fmax(hit->theta - TOL_MOMENT_ASIDE, 0.0), before);
    curve_at(c, hit->piece, fmin(hit->theta + TOL_MOMENT_ASIDE, 1.0), after);
    return e->value(w, hit->s, after) > e->value(w, hit->s, before);
}

enum moment moment_of(const struct moment_watches *w,
                      const struct event_hit *hit, const struct curve *c)
{
    const struct moment_watch *watch = &w->watch[hit->which];
    const bool leaves = watch->what == MOMENT_MU_NEARS &&
                        rises(watch, &w->event[hit->which], hit, c);

    return leaves ? MOMENT_MU_LEAVES : watch->what;
}
