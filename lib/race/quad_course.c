/* The clock is that of rescaled.h, d tau = sqrt(kappa^2 + |f|^2) dt, with kappa
 * kept near the field's fastest rate: orbits that creep along a slow curve then
 * solve equations that are all but linear. */
#include "quad_course.h"

#include <math.h>

enum { STEPS_MAX = 2000, FAILURES_MAX = 50 };

/* What equations of a step are solved to, relative to the state's offset. */
static const double solved = 1e-22;
/* |f| over the fastest rate, below which an orbit is a slow one. */
static const double slow_part = 0.1;
/* Next to the saddle offsets grow like e^(lambda t), which wants no bend. */
static const double beside = 0.3;
/* Steps: what they are changed by, and guessed from the last one up to. */
static const double safety = 0.8, longest = 20.0, shortest = 0.1,
                    retreat = 0.25, reach = 3.0, least_excess = 1e-8;

/* ---- the field on its clock ---------------------------------------------- */

void quad_course_field(const struct quad_course *c, const quad z[2], quad du[])
{
    struct quad_field f;

    quad_block_field(&c->slope->at, z[0], z[1], &f);
    const bool fast = f.log_scale > 0;
    const quad unit = fast ? 1 : expq(f.log_scale);
    const quad a = fast ? expq(-f.log_scale) : 1;
    const quad slow = (quad) c->clock.kappa * a;
    const quad x = unit * f.direction[0], y = unit * f.direction[1];
    const quad n = sqrtq(slow * slow + x * x + y * y);

    du[QUAD_X] = x / n;
    du[QUAD_Y] = y / n;
    du[QUAD_TIME] = a / n;
}

static void plane(const void *ctx, const quad z[2], quad du[])
{
    quad_course_field(ctx, z, du);
}

static void integrals(const void *ctx, const quad z[2], quad du[])
{
    const struct quad_course *c = ctx;

    du[QUAD_SLIP] = expq(c->slope->at.x0 + z[0]) * du[QUAD_TIME];
    du[QUAD_WORK] = quad_block_mu(&c->slope->at, z[0], z[1]) * du[QUAD_SLIP];
}

static struct vec2 rounded(const quad z[2])
{
    return (struct vec2){ (double) z[0], (double) z[1] };
}

static void linear(const void *ctx, const quad z[2], double du[2],
                   struct vec2 slope[2])
{
    const struct quad_course *c = ctx;
    struct cascade_linear l;

    rescaled_linear(&c->clock, rounded(z), &l);
    for (int i = 0; i < 2; i++) {
        du[i] = l.du[i];
        slope[i] = l.slope[i];
    }
}

static struct quad_system system_of(const struct quad_course *c)
{
    return (struct quad_system){ &c->slope->method, plane, integrals, linear,
                                 c };
}

static quad hypot_of(const quad du[])
{
    return sqrtq(du[QUAD_X] * du[QUAD_X] + du[QUAD_Y] * du[QUAD_Y]);
}

static quad offset_of(const struct quad_course *c, const quad u[])
{
    const quad x = fabsq(u[QUAD_X]), y = fabsq(u[QUAD_Y]), most = x > y ? x : y;

    return most < 1 && slider_saddle(&c->slope->study->slider) >= 0 ? most : 1;
}

/* d ln |f|/dt at the end of a step, from its last two stages. */
static quad rise_of(const struct quad_course *c, const struct quad_radau *w)
{
    const quad *const node = c->slope->method.node;
    const quad *before = w->du[QUAD_STAGES - 2], *at = w->du[QUAD_STAGES - 1];
    const quad time = w->h * (node[QUAD_STAGES - 1] - node[QUAD_STAGES - 2]) *
                      (before[QUAD_TIME] + at[QUAD_TIME]) / 2;
    const quad from = hypot_of(before) / before[QUAD_TIME];

    return logq(hypot_of(at) / at[QUAD_TIME] / from) / time;
}

/* Sets the clock for the next step, after w: kappa follows the field's fastest
 * rate; where |f| is far below that, away from the saddle, time runs like its
 * inverse, which takes poles and long fadings in their stride. */
static void keep_pace(struct quad_course *c, const struct quad_radau *w)
{
    struct cascade_linear l;
    const quad before = c->du[QUAD_TIME];

    rescaled_linear(&c->clock, rounded(c->u), &l);
    c->clock.kappa = fmin(fmax(rescaled_rate(&l), 1e-150), 1e150);
    plane(c, c->u, c->du);
    integrals(c, c->u, c->du);
    const bool is_slow = hypot_of(c->du) < (quad) slow_part &&
                         offset_of(c, c->u) > (quad) beside;
    const quad bend = w && is_slow ? -rise_of(c, w) * c->du[QUAD_TIME] : 0;
    c->bend = bend - bend == 0 ? bend : 0;
    c->pace = w ? before / c->du[QUAD_TIME] : 0;
}

/* ---- steps --------------------------------------------------------------- */

static void guess(const struct quad_course *c, struct quad_radau *w)
{
    const struct quad_method *m = &c->slope->method;
    const quad ratio = c->pace > 0 ? w->h / (c->last.h * c->pace) : 1000;

    for (int k = 0; k < 2; k++) {
        const quad end =
            ratio <= (quad) reach ? quad_radau_gain(&c->last, k, 1) : 0;
        for (int i = 0; i < QUAD_STAGES; i++)
            w->z[i][k] =
                ratio <= (quad) reach
                    ? quad_radau_gain(&c->last, k, 1 + ratio * m->node[i]) - end
                    : w->h * m->node[i] * c->du[k];
    }
}

/* The end of a step. */
static void arrive(const struct quad_course *c, const struct quad_radau *w,
                   quad to[QUAD_DIM])
{
    for (int k = 0; k < QUAD_DIM; k++)
        to[k] = c->u[k] + (k < QUAD_TIME ? w->z[QUAD_STAGES - 1][k]
                                         : quad_radau_gain(w, k, 1));
}

/* What it may be too long by: 1 is just right. */
static double excess_of(const struct quad_course *c, const struct quad_radau *w,
                        const quad to[QUAD_DIM])
{
    const quad here = offset_of(c, c->u), there = offset_of(c, to);
    double worst = 0.0;

    for (int k = 0; k < QUAD_DIM; k++) {
        const quad tail = quad_radau_tail(w, k);
        const quad size = k >= QUAD_TIME ? to[k] : here < there ? there : here;
        if (tail > 0)
            worst = fmax(worst, (double) (tail / size) / c->tol);
    }
    return worst;
}

bool quad_course_part(const struct quad_course *c,
                      const struct quad_radau *whole, quad theta,
                      struct quad_radau *w, quad to[QUAD_DIM])
{
    const struct quad_system system = system_of(c);
    const struct quad_method *m = &c->slope->method;

    w->h = whole->h * theta;
    w->bend = whole->bend;
    for (int i = 0; i < QUAD_STAGES; i++)
        for (int k = 0; k < 2; k++)
            w->z[i][k] = quad_radau_gain(whole, k, theta * m->node[i]);
    if (!quad_radau_solve(w, &system, c->u,
                          solved * (double) offset_of(c, c->u)))
        return false;
    arrive(c, w, to);
    return true;
}

/* What to multiply a step by, from its excess. */
static double factor_of(double excess)
{
    return safety * pow(fmax(excess, least_excess), -1.0 / QUAD_STAGES);
}

/* The length of the next step, as if lengths and excesses went on changing as
 * they did. */
static void choose_step(struct quad_course *c, quad h, double excess)
{
    double factor = factor_of(excess);

    if (c->excess > 0.0)
        factor *=
            fmin(c->trend * factor_of(excess) / factor_of(c->excess), longest);
    factor = fmin(fmax(factor, shortest), longest);
    c->excess = excess;
    c->trend = factor;
    c->h = h * c->pace * (quad) factor;
}

bool quad_course_take(struct quad_course *c, struct quad_radau *w,
                      quad to[QUAD_DIM], double *excess)
{
    const struct quad_system system = system_of(c);
    const double tol = solved * (double) offset_of(c, c->u);

    for (;;) {
        if (!(c->h > (quad) 1e-25) || c->steps++ >= STEPS_MAX ||
            c->failures > FAILURES_MAX)
            return false;
        w->h = c->h;
        w->bend = c->bend;
        guess(c, w);
        const bool ok = quad_radau_solve(w, &system, c->u, tol);
        if (ok)
            arrive(c, w, to);
        else
            c->failures++;
        *excess = ok ? excess_of(c, w, to) : HUGE_VAL;
        if (*excess <= 1.0)
            return true;
        const double factor =
            *excess < HUGE_VAL ? fmax(factor_of(*excess), shortest) : retreat;
        c->h *= (quad) factor;
        c->trend *= factor;
    }
}

void quad_course_start(struct quad_course *c, const struct quad_slope *q,
                       quad x, quad y, double tol)
{
    *c = (struct quad_course){ .slope = q, .tol = tol };
    c->clock = (struct rescaled){ &q->study->slider.plane.system,
                                  q->study->slider.plane.fastest_rate, 0 };
    c->fate = FATE_UNDECIDED;
    c->u[QUAD_X] = x - q->at.x0;
    c->u[QUAD_Y] = y - q->at.y0;
    plane(c, c->u, c->du);
    integrals(c, c->u, c->du);
    keep_pace(c, NULL);
    c->h = (quad) 0.1;
}

void quad_course_move(struct quad_course *c, const struct quad_radau *w,
                      const quad to[QUAD_DIM], double excess)
{
    for (int k = 0; k < QUAD_DIM; k++) {
        c->u[k] = to[k];
        c->du[k] = w->du[QUAD_STAGES - 1][k];
    }
    c->last = *w;
    keep_pace(c, w);
    choose_step(c, w->h, excess);
}
