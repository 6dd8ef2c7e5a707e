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

static struct planar_field field_at(const struct slider *s, struct vec2 z)
{
    struct planar_field f;

    s->plane.system.field(s->plane.system.ctx, z, &f);
    return f;
}

/* (17): d ln v/dt = cos(alpha)/(eps^2 v) (tan(alpha) - mu), which has all its
 * digits near the anchor. */
static double excess_by(const struct slider *s, struct vec2 z,
                        const struct planar_field *f)
{
    if (fabs(f->direction.x) > TOL_MOMENT_DIRECTION)
        return -f->direction.x *
               exp(f->log_scale + z.x - s->block.at.log_inertia);
    return block_mu(&s->block, z) - (double) s->block.tan_alpha;
}

double moment_excess_friction(const struct slider *s, struct vec2 z)
{
    const struct planar_field f = field_at(s, z);

    return excess_by(s, z, &f);
}

/* ---- functions along an orbit -------------------------------------------- */

/* Its field at u. */
static const struct planar_field *field_of(const struct moment_along *a,
                                           const double u[])
{
    struct moment_look *l = a->last;

    if (!(l->z.x == u[0] && l->z.y == u[1])) {
        l->z = place(u);
        l->f = field_at(a->slider, l->z);
    }
    return &l->f;
}

static double ln_v(const void *ctx, double s, const double u[])
{
    (void) ctx, (void) s;
    return u[0];
}

static double psi(const void *ctx, double s, const double u[])
{
    (void) ctx, (void) s;
    return u[1];
}

static double psi_rate(const void *ctx, double s, const double u[])
{
    (void) s;
    return field_of(ctx, u)->direction.y;
}

/* dmu along the field's direction; the gradient of mu from that of mu v. */
static double mu_rate(const void *ctx, double s, const double u[])
{
    const struct moment_along *a = ctx;
    const struct planar *sys = &a->slider->plane.system;
    const struct vec2 z = place(u), f = field_of(a, u)->direction;
    struct vec2 work;
    double v, mu_v;

    (void) s;
    sys->rate_gradient(sys->ctx, BLOCK_SLIP, z, &v, NULL);
    sys->rate_gradient(sys->ctx, BLOCK_WORK, z, &mu_v, &work);
    return (work.x - mu_v) / v * f.x + work.y / v * f.y;
}

/* Against dv/dt. */
static double excess(const void *ctx, double s, const double u[])
{
    const struct moment_along *a = ctx;

    (void) s;
    return excess_by(a->slider, place(u), field_of(a, u));
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
    const struct slider *of = ((const struct moment_along *) ctx)->slider;
    double least = HUGE_VAL;

    (void) s;
    for (size_t i = 0; i < of->plane.equilibria; i++)
        if (of->plane.equilibrium[i].type == EQUILIBRIUM_STABLE_NODE)
            least = fmin(least, distance(of, i, place(u)));
    return least;
}

/* direction * exp(log_scale), either of which may leave the doubles. */
static double rate_of(double direction, double log_scale)
{
    return copysign(exp(log(fabs(direction)) + log_scale), direction);
}

struct vec2 moment_rates(const struct slider *s, const double u[])
{
    const struct planar_field f = field_at(s, place(u));

    return (struct vec2){ rate_of(f.direction.x, f.log_scale),
                          rate_of(f.direction.y, f.log_scale) };
}

/* ---- watches ------------------------------------------------------------- */

static double (*const watched[MOMENTS])(const void *, double,
                                        const double[]) = {
    [MOMENT_V_SP] = ln_v,       [MOMENT_V_MINUS] = ln_v,
    [MOMENT_V_PLUS] = ln_v,     [MOMENT_V] = ln_v,
    [MOMENT_PSI] = psi,         [MOMENT_PSI_MIN] = psi_rate,
    [MOMENT_MU_MIN] = mu_rate,  [MOMENT_V_MIN] = excess,
    [MOMENT_MU_NEARS] = excess, [MOMENT_ARREST] = node_distance,
};

/* at: what is watched when it happens, an offset in the chart. */
static void add(struct moment_watches *w, enum moment what, double level,
                double at)
{
    const size_t i = w->count++;

    w->watch[i] = (struct moment_watch){ what, level };
    w->event[i] =
        (struct event){ .value = watched[what], .ctx = &w->along, .level = at };
}

/* From above and from below: friction may pass both between two samples. */
static void add_nearness(struct moment_watches *w, double level)
{
    add(w, MOMENT_MU_NEARS, level, level);
    add(w, MOMENT_MU_NEARS, level, -level);
}

static void add_level(struct moment_watches *w, const struct moment_level *l)
{
    const struct slider *s = w->along.slider;
    const bool psi_is_log = !s->plane.system.axis[1].is_log;

    if (l->what == MOMENT_MU_NEARS)
        add_nearness(w, l->value);
    else if (l->what == MOMENT_V)
        add(w, l->what, l->value, log(l->value) - s->plane.system.origin.x);
    else
        add(w, l->what, l->value,
            (psi_is_log ? l->value : log(l->value)) - s->plane.system.origin.y);
}

/* A critical velocity by its logarithm. */
static void add_critical(struct moment_watches *w, enum moment what,
                         const struct quantity *ln_v)
{
    if (quantity_exists(ln_v))
        add(w, what, exp(ln_v->value),
            ln_v->value - w->along.slider->plane.system.origin.x);
}

void moment_watch_all(struct moment_watches *w, const struct slider *s,
                      const struct moment_level *level, size_t levels,
                      bool stop)
{
    const double none = (double) NAN;

    w->count = 0;
    w->look.z.x = none;
    w->along = (struct moment_along){ s, &w->look };
    if (slider_saddle(s) >= 0)
        add(w, MOMENT_V_SP, s->block.at.v0, 0.0);
    add_critical(w, MOMENT_V_MINUS, &s->critical.ln_v_minus);
    add_critical(w, MOMENT_V_PLUS, &s->critical.ln_v_plus);
    add(w, MOMENT_PSI_MIN, none, 0.0);
    add(w, MOMENT_MU_MIN, none, 0.0);
    add(w, MOMENT_ARREST, none, TOL_ARREST);
    w->event[w->count - 1].direction = -1;
    w->event[w->count - 1].stop = stop;
    add(w, MOMENT_V_MIN, none, 0.0);
    add_nearness(w, TOL_ARREST * (double) s->block.tan_alpha);
    for (size_t i = 0; i < levels && i < MOMENT_LEVELS_MAX; i++)
        add_level(w, &level[i]);
}

enum moment moment_of(const struct moment_watches *w,
                      const struct event_hit *hit)
{
    const enum moment what = w->watch[hit->which].what;
    const bool above = w->event[hit->which].level > 0.0;

    return what == MOMENT_MU_NEARS && hit->rising == above ? MOMENT_MU_LEAVES
                                                           : what;
}
