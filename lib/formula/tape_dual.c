/* Gradients along a tape, by the chain rule. */
#include <math.h>

#include "quad.h"
#include "tape_plane.h"

#define SCALAR double
#define FN(f)  f
#include "change.h"

/* d step/d a and d step/d b, growths and aparts times e^-s */
static struct vec2 slopes(const struct real_tape *t, int i, double s,
                          const double r[])
{
    const struct real_tape_entry *n = &t->step[i];
    const double k = n->k, q = n->q;
    const double u = n->a >= 0 ? r[n->a] : 0, w = n->b >= 0 ? r[n->b] : 0;

    switch (n->kind) {
        case STEP_GROWTH:
            return (struct vec2){ exp(real_tape_grown(t, i, r) - s), 0 };
        case STEP_APART:
            return (struct vec2){ scalar_exp(k, u - s),
                                  -scalar_exp(k, w + q - s) };
        case STEP_EXP:
            return (struct vec2){ exp(q + u), 0 };
        case STEP_MIXED:
            return (struct vec2){ scalar_logistic(k, q, u), 0 };
        case STEP_LN1P:
            return (struct vec2){ 1 / (k + u), 0 };
        case STEP_SINH: /* of e^-|w| sinh w */
            return (struct vec2){ exp(-2 * fabs(k + u)), 0 };
        case STEP_FRICTION:
            return (struct vec2){ scalar_friction_slope(k + u), 0 };
        case STEP_SIN:
            return (struct vec2){ change_sin_slope(k, q, u), 0 };
        case STEP_COSH:
            return (struct vec2){ sinh(k + u), 0 };
        case STEP_TAN: {
            const double tangent = change_tangent(k, q, u);
            return (struct vec2){ 1 + tangent * tangent, 0 };
        }
        case STEP_TANH:
            return (struct vec2){ change_tanh_slope(k + u), 0 };
        case STEP_ASIN:
            return (struct vec2){ 1 / change_root(k + u), 0 };
        case STEP_ATAN:
            return (struct vec2){ 1 / (1 + (k + u) * (k + u)), 0 };
        case STEP_ASINH:
            return (struct vec2){ 1 / change_length(k + u), 0 };
        case STEP_PRODUCT:
            return (struct vec2){ w, u };
        default: /* STEP_QUOTIENT */
            return (struct vec2){ 1 / (k + w), -(u / (k + w)) / (k + w) };
    }
}

static void add(struct vec2 *sum, double c, struct vec2 g)
{
    sum->x += c * g.x;
    sum->y += c * g.y;
}

static struct vec2 of_linear(const struct real_tape *t,
                             const struct real_tape_form *u,
                             const struct vec2 g[])
{
    struct vec2 sum = { 0, 0 };

    for (int i = u->first; i < u->first + u->terms; i++)
        add(&sum, t->term[i].c, g[t->term[i].reg]);
    return sum;
}

static struct vec2 of_step(const struct real_tape *t, int i, double s,
                           const double r[], const struct vec2 g[])
{
    const struct real_tape_entry *n = &t->step[i];
    const struct vec2 slope = slopes(t, i, s, r);
    struct vec2 sum = { 0, 0 };

    if (n->a >= 0)
        add(&sum, slope.x, g[n->a]);
    if (n->b >= 0 && n->kind != STEP_GROWTH)
        add(&sum, slope.y, g[n->b]);
    return sum;
}

/* e^-s is as good as a constant: the rate's factor e^s takes it back. */
static struct vec2 of_scaled(const struct real_tape *t, int i, const double r[],
                             const struct vec2 g[])
{
    const struct real_tape_form *u = &t->step[i].form;
    const double s = real_tape_scale(t, i, r), less = exp(-s);
    struct vec2 sum = { 0, 0 };

    for (int j = u->first; j < u->first + u->terms; j++) {
        const int reg = t->term[j].reg;
        if (real_tape_grows(t, reg))
            add(&sum, t->term[j].c, of_step(t, reg - 2, s, r, g));
        else
            add(&sum, t->term[j].c * less, g[reg]);
    }
    return sum;
}

void tape_gradients(const struct real_tape *t, bool everything,
                    const double r[], struct vec2 g[])
{
    const int steps = everything ? t->steps : t->rate_steps;

    g[0] = (struct vec2){ 1, 0 };
    g[1] = (struct vec2){ 0, 1 };
    for (int i = 0; i < steps; i++)
        if (!t->step[i].idle)
            g[i + 2] = t->step[i].kind == STEP_LINEAR
                           ? of_linear(t, &t->step[i].form, g)
                       : t->step[i].kind == STEP_SCALED
                           ? of_scaled(t, i, r, g)
                           : of_step(t, i, 0, r, g);
}

/* M' e^(E - scale) + M E' e^(E - scale) */
struct vec2 tape_rate_gradient(const struct real_tape *t, int i, double scale,
                               const double r[], const struct vec2 g[])
{
    const struct real_tape_rate *p = &t->rate[i];
    const bool less = p->sinh >= 0 && r[p->sinh] < 0;
    const double e = exp(real_tape_exponent(t, i, r) - scale);
    struct vec2 sum = { 0, 0 };

    add(&sum, p->kept[less] * e, of_linear(t, &p->mantissa, g));
    add(&sum, real_tape_mantissa(t, i, r) * e,
        of_linear(t, &p->exponent[less], g));
    return sum;
}
