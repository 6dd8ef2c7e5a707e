/* Order 0 of a tape's series: everything that is not a sum of products, by the
 * careful scalar code of other kinds. */
#include "tape_course.h"

#include <math.h>

#include "quad.h"

#define SCALAR double
#define FN(f)  f
#include "change.h"

/* k e^(u - s), and the growth. */
static jet_pair start_growth(const struct course *c,
                             const struct real_tape_entry *n, jet_pair s,
                             jet_pair keep[])
{
    const jet_pair u = c->reg[n->a];
    jet_pair out;

    for (int i = 0; i < JET_LANES; i++) {
        const double l = (n->b >= 0 ? c->reg[n->b][i] : n->q + u[i]) - s[i];
        const double p = s[i] > 0 ? exp(n->q - s[i]) : n->k;
        keep[0][i] = exp(l);
        out[i] = u[i] > 1 ? keep[0][i] - p : p * scalar_em1(u[i]);
    }
    return out;
}

static jet_pair start_apart(const struct course *c,
                            const struct real_tape_entry *n, jet_pair s,
                            jet_pair keep[])
{
    const jet_pair u = c->reg[n->a] - s, w = c->reg[n->b] + n->q - s;
    jet_pair out;

    EACH(out, scalar_difference(n->k, u[i], w[i]));
    EACH(keep[0], scalar_exp(n->k, u[i]));
    EACH(keep[1], scalar_exp(n->k, w[i]));
    return out;
}

/* Largest exponents of both lanes. */
static jet_pair scale_of(const struct course *c, const struct real_tape_form *f)
{
    jet_pair s = { 0 };

    for (int j = f->first; j < f->first + f->terms; j++) {
        const int reg = c->t->term[j].reg;
        if (!real_tape_grows(c->t, reg))
            continue;
        const struct real_tape_entry *n = &c->t->step[reg - 2];
        const jet_pair u = c->reg[n->a],
                       w = n->b >= 0 ? c->reg[n->b] : JET_PAIR(0.0);
        EACH(s, scalar_larger(s[i], n->kind == STEP_APART
                                        ? scalar_larger(u[i], w[i] + n->q)
                                    : n->b >= 0 ? w[i]
                                                : n->q + u[i]));
    }
    return s;
}

/* keep: e^-s, those of the parts, and s as the last */
static jet_pair start_scaled(const struct course *c,
                             const struct real_tape_entry *n, jet_pair keep[],
                             int slots)
{
    const struct real_tape_form *f = &n->form;
    const jet_pair s = scale_of(c, f);
    int at = 1;

    EACH(keep[0], exp(-s[i]));
    jet_pair sum = f->constant * keep[0];
    for (int j = f->first; j < f->first + f->terms; j++) {
        const int reg = c->t->term[j].reg;
        const struct real_tape_entry *part =
            real_tape_grows(c->t, reg) ? &c->t->step[reg - 2] : NULL;
        if (part == NULL) {
            sum += c->t->term[j].c * (c->reg[reg] * keep[0]);
            continue;
        }
        sum += c->t->term[j].c * (part->kind == STEP_GROWTH
                                      ? start_growth(c, part, s, keep + at)
                                      : start_apart(c, part, s, keep + at));
        at += tape_kind_slots(part->kind);
    }
    keep[KEPT * slots] = s;
    return sum;
}

/* Functions that are not made of exponentials. */
static jet_pair start_function(const struct real_tape_entry *n, jet_pair u,
                               jet_pair keep[])
{
    const jet_pair w = n->k + u;
    jet_pair out = { 0 };

    switch (n->kind) {
        case STEP_SIN:
            EACH(out, change_sin(n->k, n->q, u[i]));
            keep[0] = n->k + out;
            EACH(keep[1], change_sin_slope(n->k, n->q, u[i]));
            break;
        case STEP_COSH:
            EACH(out, change_cosh(n->k, u[i]));
            EACH(keep[0], cosh(w[i]));
            EACH(keep[1], sinh(w[i]));
            break;
        case STEP_TAN:
            EACH(out, change_tan(n->k, n->q, u[i]));
            EACH(keep[0], change_tangent(n->k, n->q, u[i]));
            keep[1] = 1 + keep[0] * keep[0];
            break;
        case STEP_TANH:
            EACH(out, change_tanh(n->k, u[i]));
            EACH(keep[0], tanh(w[i]));
            EACH(keep[1], change_tanh_slope(w[i]));
            break;
        case STEP_ATAN:
            EACH(out, change_atan(n->k, u[i]));
            keep[1] = 1 / (1 + w * w);
            break;
        case STEP_ASIN:
            EACH(out, change_asin(n->k, u[i]));
            EACH(keep[1], 1 / change_root(w[i]));
            break;
        default: /* STEP_ASINH */
            EACH(out, change_asinh(n->k, u[i]));
            EACH(keep[1], 1 / change_length(w[i]));
            break;
    }
    keep[2] = w;
    return out;
}

static jet_pair start_simple(const struct course *c,
                             const struct real_tape_entry *n, jet_pair keep[])
{
    const jet_pair u = c->reg[n->a],
                   w = n->b >= 0 ? c->reg[n->b] : JET_PAIR(0.0);
    jet_pair out = { 0 };

    switch (n->kind) {
        case STEP_EXP:
            EACH(out, exp(n->q + u[i]));
            keep[0] = out;
            return out;
        case STEP_MIXED:
            EACH(out, scalar_log1p_expm1(n->k, n->q, u[i]));
            EACH(keep[0], scalar_logistic(n->k, n->q, u[i]));
            EACH(keep[1], scalar_logistic_rest(n->k, n->q, u[i]));
            return out;
        case STEP_LN1P:
            EACH(out, log1p(u[i] / n->k));
            keep[0] = 1 / (n->k + u);
            return out;
        case STEP_FRICTION:
            EACH(out, scalar_friction(n->k, n->q, u[i]));
            EACH(keep[0], scalar_friction_slope(n->k + u[i]));
            EACH(keep[1], scalar_friction_bend(n->k + u[i]));
            return out;
        case STEP_PRODUCT:
            keep[0] = u;
            keep[1] = w;
            return u * w;
        case STEP_QUOTIENT:
            keep[0] = u / (n->k + w);
            keep[1] = 1 / (n->k + w);
            return keep[0];
        default:
            return start_function(n, u, keep);
    }
}

/* e^-|w| sinh w, and its slope: cosh w for the |w| of order 0, else e^(-2|w|)
 */
static jet_pair start_sinh(jet_pair w, bool joined, jet_pair keep[])
{
    jet_pair out;

    EACH(out, scalar_sinh(w[i]));
    keep[0] = out;
    EACH(keep[1], joined ? exp(-2 * fabs(w[i])) : scalar_cosh(w[i]));
    return out;
}

void tape_start(const struct course *c, int i)
{
    const struct real_tape_entry *n = &c->t->step[i];
    jet_pair *keep = c->all + c->p->keep + c->p->kept[i];
    const jet_pair none = { 0 };
    jet_pair *out = &c->reg[i + 2];

    if (n->kind == STEP_LINEAR)
        *out = n->form.constant + linear(c, &n->form);
    else if (n->kind == STEP_GROWTH)
        *out = start_growth(c, n, none, keep);
    else if (n->kind == STEP_APART)
        *out = start_apart(c, n, none, keep);
    else if (n->kind == STEP_SCALED)
        *out = start_scaled(c, n, keep, tape_step_slots(c->t, n));
    else if (n->kind == STEP_SINH)
        *out = start_sinh(n->k + c->reg[n->a], is_joined(c->t, i + 2), keep);
    else
        *out = start_simple(c, n, keep);
}
