/* A tape in doubles: its registers alone, with their gradients (by the chain
 * rule), or with what series keep of order 0; one source for all three, so that
 * the bits of the values are the same.  Slopes and their kin are made of the
 * exponentials of the values. */
#include "tape_course.h"

#include <math.h>

#define INLINE static inline __attribute__((always_inline))

#define SCALAR double
#define FN(f)  f
#include "change.h"

/* e^u - 1, and e^u */
INLINE double less_one(double u, double *power)
{
    if (u < -1 || u > 1) {
        *power = exp(u);
        return *power - 1;
    }
    const double more = expm1(u);
    *power = 1 + more;
    return more;
}

/* p (e^u - 1) and p e^u; l = u + ln p, if u is large; p = 0: e^l twice */
INLINE double kept_growth(double p, double l, double u, double *power)
{
    double e;

    if (u > 1 || !(p > 0)) {
        *power = exp(l);
        return *power - p;
    }
    const double more = less_one(u, &e);
    *power = p * e;
    return p * more;
}

/* p (e^u - e^w), p e^u and p e^w */
INLINE double kept_apart(double p, double u, double w, double keep[])
{
    const bool up = u > w;
    const double most = scalar_exp(p, up ? u : w);
    double e;
    const double less = less_one(up ? w - u : u - w, &e);

    keep[!up] = most;
    keep[up] = most * e;
    return up ? -most * less : most * less;
}

/* ln(r e^u + s), r + s = 1, its slope and what that leaves of 1 */
INLINE double kept_mixed(double r, double s, double u, double keep[])
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
    return 2 * change > -1 ? scalar_ln1p(change) : log(sum);
}

/* e^-|w| sinh w, and its slope e^(-2|w|); cosh w if |w| is frozen */
INLINE double kept_sinh(double w, bool joined, double keep[])
{
    double e;
    const double less = less_one(-2 * fabs(w), &e);

    keep[0] = copysign(-less / 2, w);
    keep[1] = joined ? e : (1 + e) / 2;
    return keep[0];
}

/* ln(1 + x); four terms of its series where the fifth is below 2^-69 */
INLINE double ln1p(double x)
{
    return fabs(x) < 1e-5 ? x - x * x * (1.0 / 2 - x * (1.0 / 3 - x / 4))
                          : scalar_ln1p(x);
}

/* asinh(e^w/2) - asinh(e^k/2), its slope and 1 - its square; as
 * scalar_friction, whose e^(-2 w) is e^(-2 k) e^(-2 u) where w is not so small
 * that the second overflows */
INLINE double kept_friction(double k, double q, double u, double keep[])
{
    const double w = k + u, fair = 0.7, far = -300;
    double e;

    if (k > fair && w > fair && u > far) {
        const double change = q * less_one(-2 * u, &e), sum = 1 + q * e;
        const double s = sqrt(sum), s0 = sqrt(1 + q);
        keep[0] = 1 / s;
        keep[1] = q * e / sum;
        return u + ln1p(change / ((s + s0) * (1 + s0)));
    }
    e = exp(w > 0 ? -2 * w : 2 * w);
    const double sum = w > 0 ? 1 + 4 * e : 4 + e;
    keep[0] = w > 0 ? 1 / sqrt(sum) : exp(w) / sqrt(sum);
    keep[1] = w > 0 ? 4 * e / sum : 4 / sum;
    return scalar_friction(k, q, u);
}

/* Functions that are not made of exponentials: keep[1] is the slope. */
INLINE double kept_function(const struct real_tape_entry *n, double u,
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

/* ---- a step -------------------------------------------------------------- */

/* A register and its slopes in those that it is made of. */
struct made {
    double out, by_a, by_b;
};

/* Growths and aparts times e^-s. */
INLINE struct made grown(const struct real_tape_entry *n, double s,
                         const double reg[], double keep[])
{
    const double k = n->k, q = n->q, u = reg[n->a];
    double out;

    if (n->kind == STEP_GROWTH) {
        out = kept_growth(s > 0 && k > 0 ? exp(q - s) : k,
                          (n->b >= 0 ? reg[n->b] : q + u) - s, u, keep);
        return (struct made){ out, keep[0], 0 };
    }
    out = kept_apart(k, u - s, reg[n->b] + q - s, keep);
    return (struct made){ out, keep[0], -keep[1] };
}

/* The others; frozen: e^-|w| sinh w has the |w| of this point. */
INLINE struct made plain(const struct real_tape_entry *n, bool frozen,
                         const double reg[], double keep[])
{
    const double k = n->k, q = n->q, u = reg[n->a];
    double out;

    switch (n->kind) {
        case STEP_MIXED:
            out = kept_mixed(k, q, u, keep);
            return (struct made){ out, keep[0], 0 };
        case STEP_LN1P:
            keep[0] = k + u > 0 ? 1 / (k + u) : 0;
            return (struct made){ log1p(u / k), keep[0], 0 };
        case STEP_SINH:
            out = kept_sinh(k + u, !frozen || n->joined, keep);
            return (struct made){ out, keep[1], 0 };
        case STEP_FRICTION:
            out = kept_friction(k, q, u, keep);
            return (struct made){ out, keep[0], 0 };
        case STEP_PRODUCT:
            keep[0] = u;
            keep[1] = reg[n->b];
            return (struct made){ u * keep[1], keep[1], u };
        case STEP_QUOTIENT:
            keep[1] = 1 / (k + reg[n->b]);
            keep[0] = u / (k + reg[n->b]);
            return (struct made){ keep[0], keep[1], -keep[0] * keep[1] };
        default:
            out = kept_function(n, u, keep);
            return (struct made){ out, keep[1], 0 };
    }
}

/* ---- all ----------------------------------------------------------------- */

enum making { VALUES, GRADIENTS, SERIES };

struct run {
    const struct tape_plane *p;
    double *reg, *keep; /* keep: of series */
    jet_pair *g;        /* gradients */
    const bool *used;   /* NULL: all that somebody reads */
};

jet_pair tape_linear_gradient(const struct real_tape *t,
                              const struct real_tape_form *u,
                              const jet_pair g[])
{
    const struct real_tape_term *at = &t->term[u->first], *const end =
                                                              at + u->terms;
    jet_pair sum = { 0, 0 };

    for (; at < end; at++)
        sum += at->c * g[at->reg];
    return sum;
}

INLINE jet_pair gradient(const struct real_tape_entry *n,
                         const struct made *made, const jet_pair g[])
{
    const jet_pair by_a = made->by_a * g[n->a];

    return n->b >= 0 && n->kind != STEP_GROWTH ? by_a + made->by_b * g[n->b]
                                               : by_a;
}

/* keep: e^-s, and those of the parts.  e^-s is as good as a constant: the
 * rate's factor e^s takes it back. */
INLINE void run_scaled(const struct run *r, enum making m, int i, double keep[])
{
    const struct real_tape *t = &r->p->t;
    const struct real_tape_form *f = &t->step[i].form;
    const double s = real_tape_scale(t, i, r->reg), less = s > 0 ? exp(-s) : 1;
    double sum = f->constant * less;
    jet_pair slope = { 0, 0 };
    int at = 1;

    keep[0] = less;
    for (int j = f->first; j < f->first + f->terms; j++) {
        const int reg = t->term[j].reg;
        const double c = t->term[j].c;
        if (real_tape_grows(t, reg)) {
            const struct real_tape_entry *part = &t->step[reg - 2];
            const struct made made = grown(part, s, r->reg, keep + at);
            sum += c * made.out;
            if (m == GRADIENTS)
                slope += c * gradient(part, &made, r->g);
            at += m == SERIES ? tape_kind_slots(part->kind) : 0;
        } else {
            sum += c * (r->reg[reg] * less);
            if (m == GRADIENTS)
                slope += c * less * r->g[reg];
        }
    }
    r->reg[i + 2] = sum;
    if (m == GRADIENTS)
        r->g[i + 2] = slope;
}

INLINE void run_linear(const struct run *r, enum making m, int i)
{
    const struct real_tape *t = &r->p->t;
    const struct real_tape_form *u = &t->step[i].form;

    r->reg[i + 2] = real_tape_linear(t, u, r->reg);
    if (m == GRADIENTS)
        r->g[i + 2] = tape_linear_gradient(t, u, r->g);
}

/* Steps from .. to. */
INLINE void run(const struct run *r, enum making m, int from, int to)
{
    const struct real_tape *t = &r->p->t;
    double own[TAPE_KEPT + 1];

    for (int i = from; i < to; i++) {
        const struct real_tape_entry *n = &t->step[i];
        double *keep = m == SERIES ? r->keep + r->p->kept[i] : own;
        if (r->used ? !r->used[i] : n->idle)
            continue;
        if (n->kind == STEP_LINEAR) {
            run_linear(r, m, i);
        } else if (n->kind == STEP_SCALED) {
            run_scaled(r, m, i, keep);
        } else {
            const struct made made =
                n->kind == STEP_GROWTH || n->kind == STEP_APART
                    ? grown(n, 0, r->reg, keep)
                    : plain(n, m == SERIES, r->reg, keep);
            r->reg[i + 2] = made.out;
            if (m == GRADIENTS)
                r->g[i + 2] = gradient(n, &made, r->g);
        }
    }
}

void tape_keep(struct tape_kept *v, int part)
{
    const struct real_tape *t = &v->p->t;
    const struct run r = { .p = v->p,
                           .reg = v->reg,
                           .keep = v->keep,
                           .used = part ? t->used[part - 1] : NULL };

    run(&r, SERIES, part ? t->rate_steps : 0, part ? t->steps : t->rate_steps);
}

void tape_values(const struct tape_plane *p, struct vec2 z, int rate,
                 double reg[])
{
    const struct run r = { .p = p,
                           .reg = reg,
                           .used = rate < 2 ? NULL : p->t.used[rate - 2] };

    reg[0] = z.x;
    reg[1] = z.y;
    run(&r, VALUES, 0, rate == 0 ? p->t.rate_steps : p->t.steps);
}

void tape_gradients(const struct tape_plane *p, struct vec2 z, int rate,
                    double reg[], jet_pair g[])
{
    const struct run r = { .p = p,
                           .reg = reg,
                           .g = g,
                           .used = rate < 2 ? NULL : p->t.used[rate - 2] };

    reg[0] = z.x;
    reg[1] = z.y;
    g[0] = (jet_pair){ 1, 0 };
    g[1] = (jet_pair){ 0, 1 };
    run(&r, GRADIENTS, 0, rate == 0 ? p->t.rate_steps : p->t.steps);
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
