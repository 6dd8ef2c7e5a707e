/* Gradients along a tape, by the chain rule. */
#include <math.h>

#include "tape_course.h"

/* d step/d a and d step/d b of what the step keeps */
static struct vec2 slopes(enum step_kind kind, const double keep[])
{
    switch (kind) {
        case STEP_GROWTH:
        case STEP_EXP:
        case STEP_MIXED:
        case STEP_LN1P:
        case STEP_FRICTION:
            return (struct vec2){ keep[0], 0 };
        case STEP_APART:
            return (struct vec2){ keep[0], -keep[1] };
        case STEP_PRODUCT:
            return (struct vec2){ keep[1], keep[0] };
        case STEP_QUOTIENT:
            return (struct vec2){ keep[1], -keep[0] * keep[1] };
        default:
            return (struct vec2){ keep[1], 0 };
    }
}

static void add(struct vec2 *sum, double c, struct vec2 g)
{
    sum->x += c * g.x;
    sum->y += c * g.y;
}

struct vec2 tape_linear_gradient(const struct real_tape *t,
                                 const struct real_tape_form *u,
                                 const struct vec2 g[])
{
    struct vec2 sum = { 0, 0 };

    for (int i = u->first; i < u->first + u->terms; i++)
        add(&sum, t->term[i].c, g[t->term[i].reg]);
    return sum;
}

static struct vec2 of_step(const struct real_tape_entry *n, const double keep[],
                           const struct vec2 g[])
{
    const struct vec2 slope = slopes(n->kind, keep);
    struct vec2 sum = { 0, 0 };

    if (n->a >= 0)
        add(&sum, slope.x, g[n->a]);
    if (n->b >= 0 && n->kind != STEP_GROWTH)
        add(&sum, slope.y, g[n->b]);
    return sum;
}

/* e^-s is as good as a constant: the rate's factor e^s takes it back. */
static struct vec2 of_scaled(const struct real_tape *t, int i,
                             const double keep[], const struct vec2 g[])
{
    const struct real_tape_form *u = &t->step[i].form;
    struct vec2 sum = { 0, 0 };
    int at = 1;

    for (int j = u->first; j < u->first + u->terms; j++) {
        const int reg = t->term[j].reg;
        const struct real_tape_entry *part = &t->step[reg >= 2 ? reg - 2 : 0];
        if (!real_tape_grows(t, reg)) {
            add(&sum, t->term[j].c * keep[0], g[reg]);
            continue;
        }
        add(&sum, t->term[j].c, of_step(part, keep + at, g));
        at += tape_kind_slots(part->kind);
    }
    return sum;
}

void tape_gradients(const struct tape_kept *v, int rate, struct vec2 g[])
{
    const struct real_tape *t = &v->p->t;
    const bool *used = rate < 2 ? NULL : t->used[rate - 2];
    const int steps = rate == 0 ? t->rate_steps : t->steps;

    for (int i = 0; i < steps; i++) {
        const struct real_tape_entry *n = &t->step[i];
        const double *keep = v->keep + v->p->kept[i];
        if (used ? used[i] : !n->idle)
            g[i + 2] = n->kind == STEP_LINEAR
                           ? tape_linear_gradient(t, &n->form, g)
                       : n->kind == STEP_SCALED ? of_scaled(t, i, keep, g)
                                                : of_step(n, keep, g);
    }
}

/* M' e^E + M E' e^E */
struct vec2 tape_rate_gradient(const struct tape_kept *v, int i, double power,
                               const struct vec2 g[])
{
    const struct real_tape *t = &v->p->t;
    const struct real_tape_rate *p = &t->rate[i];
    const int k = real_tape_which(t, i, v->reg);
    struct vec2 sum = { 0, 0 };

    add(&sum, p->kept[k] * power, tape_linear_gradient(t, &p->mantissa, g));
    add(&sum, real_tape_mantissa(t, i, v->reg) * power,
        tape_linear_gradient(t, &p->exponent[k], g));
    return sum;
}
