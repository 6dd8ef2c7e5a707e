/* Steps with what series and gradients keep of them: slopes and their kin, of
 * the same exponentials as the values. */
#include "tape_course.h"

#include <math.h>

#include "quad.h"

#define SCALAR double
#define FN(f)  f
#include "change.h"

/* e^u - 1, and e^u */
static double less_one(double u, double *power)
{
    if (u < -1 || u > 1) {
        *power = exp(u);
        return *power - 1;
    }
    const double more = expm1(u);
    *power = 1 + more;
    return more;
}

/* p (e^u - 1) and p e^u; l = u + ln p, if u is large */
static double kept_growth(double p, double l, double u, double *power)
{
    double e;

    if (u > 1) {
        *power = exp(l);
        return *power - p;
    }
    const double more = less_one(u, &e);
    *power = p * e;
    return p * more;
}

/* p (e^u - e^w), p e^u and p e^w */
static double kept_apart(double p, double u, double w, double keep[])
{
    const bool up = u > w;
    const double most = scalar_exp(p, up ? u : w);
    double e;
    const double less = less_one(up ? w - u : u - w, &e);

    keep[!up] = most;
    keep[up] = most * e;
    return up ? -most * less : most * less;
}

/* ln(r e^u + s), its slope and what that leaves of 1 */
static double kept_mixed(double r, double s, double u, double keep[])
{
    double e;

    if (!(s > 0 || s < 0) || u > 700) {
        keep[0] = scalar_logistic(r, s, u);
        keep[1] = scalar_logistic_rest(r, s, u);
        return scalar_log1p_expm1(r, s, u);
    }
    const double change = r * less_one(u, &e), sum = r * e + s;
    keep[0] = r * e / sum;
    keep[1] = s / sum;
    return 2 * change > -1 ? scalar_ln1p(change) : log(s + r * exp(u));
}

/* e^-|w| sinh w, and its slope e^(-2|w|); cosh w if |w| is frozen */
static double kept_sinh(double w, bool joined, double keep[])
{
    double e;
    const double less = less_one(-2 * fabs(w), &e);

    keep[0] = copysign(-less / 2, w);
    keep[1] = joined ? e : (1 + e) / 2;
    return keep[0];
}

/* asinh(e^w/2) - asinh(e^k/2), its slope and 1 - its square */
static double kept_friction(double k, double q, double u, double keep[])
{
    const double w = k + u, e = exp(w > 0 ? -2 * w : 2 * w);
    const double sum = w > 0 ? 1 + 4 * e : 4 + e;

    keep[0] = w > 0 ? 1 / sqrt(sum) : exp(w) / sqrt(sum);
    keep[1] = w > 0 ? 4 * e / sum : 4 / sum;
    return scalar_friction(k, q, u);
}

/* Functions that are not made of exponentials: keep[1] is the slope. */
static double kept_function(const struct real_tape_entry *n, double u,
                            double keep[])
{
    const double k = n->k, w = k + u;

    keep[2] = w;
    switch (n->kind) {
        case STEP_SIN: {
            const double out = change_sin(k, n->q, u);
            keep[0] = k + out;
            keep[1] = change_sin_slope(k, n->q, u);
            return out;
        }
        case STEP_COSH:
            keep[0] = cosh(w);
            keep[1] = sinh(w);
            return change_cosh(k, u);
        case STEP_TAN:
            keep[0] = change_tangent(k, n->q, u);
            keep[1] = 1 + keep[0] * keep[0];
            return change_tan(k, n->q, u);
        case STEP_TANH:
            keep[0] = tanh(w);
            keep[1] = change_tanh_slope(w);
            return change_tanh(k, u);
        case STEP_ATAN:
            keep[1] = 1 / (1 + w * w);
            return change_atan(k, u);
        case STEP_ASIN:
            keep[1] = 1 / change_root(w);
            return change_asin(k, u);
        default: /* STEP_ASINH */
            keep[1] = 1 / change_length(w);
            return change_asinh(k, u);
    }
}

/* Growths and aparts times e^-s. */
static double kept_step(const struct real_tape_entry *n, bool joined, double s,
                        double u, double w, double keep[])
{
    const double k = n->k, q = n->q;

    switch (n->kind) {
        case STEP_GROWTH:
            return kept_growth(s > 0 ? exp(q - s) : k,
                               (n->b >= 0 ? w : q + u) - s, u, keep);
        case STEP_APART:
            return kept_apart(k, u - s, w + q - s, keep);
        case STEP_EXP:
            return keep[0] = exp(q + u);
        case STEP_MIXED:
            return kept_mixed(k, q, u, keep);
        case STEP_LN1P:
            keep[0] = k + u > 0 ? 1 / (k + u) : 0;
            return log1p(u / k);
        case STEP_SINH:
            return kept_sinh(k + u, joined, keep);
        case STEP_FRICTION:
            return kept_friction(k, q, u, keep);
        case STEP_PRODUCT:
            keep[0] = u;
            keep[1] = w;
            return u * w;
        case STEP_QUOTIENT:
            keep[1] = 1 / (k + w);
            return keep[0] = u / (k + w);
        default:
            return kept_function(n, u, keep);
    }
}

/* ---- all ----------------------------------------------------------------- */

static double kept_at(const struct tape_kept *v, int i, bool joined, double s,
                      double keep[])
{
    const struct real_tape_entry *n = &v->p->t.step[i];

    return kept_step(n, joined, s, n->a >= 0 ? v->reg[n->a] : 0,
                     n->b >= 0 ? v->reg[n->b] : 0, keep);
}

/* keep: e^-s, those of the parts, and s as the last */
static double kept_scaled(const struct tape_kept *v, int i, double keep[])
{
    const struct real_tape *t = &v->p->t;
    const struct real_tape_form *f = &t->step[i].form;
    const double s = real_tape_scale(t, i, v->reg);
    double sum = f->constant * (keep[0] = s > 0 ? exp(-s) : 1), out;
    int at = 1;

    for (int j = f->first; j < f->first + f->terms; j++) {
        const int reg = t->term[j].reg;
        if (real_tape_grows(t, reg)) {
            out = kept_at(v, reg - 2, true, s, keep + at);
            at += tape_kind_slots(t->step[reg - 2].kind);
        } else {
            out = v->reg[reg] * keep[0];
        }
        sum += t->term[j].c * out;
    }
    keep[TAPE_KEPT * tape_step_slots(t, &t->step[i])] = s;
    return sum;
}

void tape_keep(struct tape_kept *v, bool frozen, const bool used[], int from,
               int to)
{
    const struct real_tape *t = &v->p->t;

    for (int i = from; i < to; i++) {
        const struct real_tape_entry *n = &t->step[i];
        double *keep = v->keep + v->p->kept[i];
        if (used ? used[i] : !n->idle)
            v->reg[i + 2] = n->kind == STEP_LINEAR
                                ? real_tape_linear(t, &n->form, v->reg)
                            : n->kind == STEP_SCALED
                                ? kept_scaled(v, i, keep)
                                : kept_at(v, i, !frozen || n->joined, 0, keep);
    }
}

/* ---- rates --------------------------------------------------------------- */

/* Keeps the mantissa over its factor, which goes to kept e^e, and which of two
 * exponents it is. */
double tape_start_rate(struct tape_kept *v, int rate, double e)
{
    const struct real_tape *t = &v->p->t;
    const struct real_tape_rate *r = &t->rate[rate];
    const double factor = v->p->factor[rate], power = e == 0 ? 1 : exp(e);
    double *keep = v->keep + v->p->rate_kept[rate];
    const bool less = r->sinh >= 0 && v->reg[r->sinh] < 0;

    keep[0] = real_tape_linear(t, &r->mantissa, v->reg) / factor;
    keep[1] = factor * r->kept[real_tape_which(t, rate, v->reg)] * power;
    keep[2] = less;
    return real_tape_mantissa(t, rate, v->reg) * power;
}
