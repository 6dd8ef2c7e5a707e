/* A tape along two curves.  Every step that is not linear needs sums
 *     S_k = sum_{0 < j < k} A_j B_{k-j}
 * of rows that are known before order k: the sums of all steps are made at
 * once, as one rectangle of rows by slots, and what a step has left to do at an
 * order is a few operations.  The workspace is one array: rows A and B of both
 * parts (the chart's rates, and what observables add), their sums, registers
 * at this order, and what each step keeps of order 0.
 *
 * Of a function w = f(u), k w_k is the convolution of j u_j with f'(u): one
 * slot; f' is made of w (Moore 1966, as in core/jet.h). */
#include "tape_course.h"

#include <math.h>

static void course_at(struct course *c, const struct tape_plane *p,
                      struct jet_work *w, size_t k, int part)
{
    jet_pair *all = &w->slot[0][0], *rows = all + p->rows[part];
    const size_t width = (size_t) p->width[part];

    *c = (struct course){ .p = p,
                          .t = &p->t,
                          .all = all,
                          .reg = all + p->registers,
                          .A = rows + k * width,
                          .B = rows + (JET_SIZE + k) * width,
                          .S = rows + 2 * JET_SIZE * width,
                          .k = jet_number[k],
                          .inverse = jet_inverse[k] };
    if (p->odd[part]) /* nobody's */
        c->A[width - 1] = c->B[width - 1] = JET_PAIR(0.0);
}

/* Coefficient of w where w' = u' v, d = k u_k, v0 of order 0; v is told. */
static inline jet_pair chain(const struct course *c, int slot, jet_pair d,
                             jet_pair v0)
{
    c->A[slot] = d;
    return (c->S[slot] + d * v0) * c->inverse;
}

static inline void tell(const struct course *c, int slot, jet_pair v)
{
    c->B[slot] = v;
}

/* ---- orders above -------------------------------------------------------- */

static inline jet_pair go_growth(const struct course *c,
                                 const struct real_tape_entry *n, int slot,
                                 const jet_pair keep[])
{
    const jet_pair e = chain(c, slot, c->k * c->reg[n->a], keep[0]);

    tell(c, slot, e);
    return e;
}

static inline jet_pair go_apart(const struct course *c,
                                const struct real_tape_entry *n, int slot,
                                const jet_pair keep[])
{
    const jet_pair u = chain(c, slot, c->k * c->reg[n->a], keep[0]),
                   w = chain(c, slot + 1, c->k * c->reg[n->b], keep[1]);

    tell(c, slot, u);
    tell(c, slot + 1, w);
    return u - w;
}

static jet_pair go_scaled(const struct course *c,
                          const struct real_tape_entry *n, int slot,
                          const jet_pair keep[])
{
    const struct real_tape_form *f = &n->form;
    jet_pair sum = { 0 };
    int at = 1;

    for (int j = f->first; j < f->first + f->terms; j++) {
        const int reg = c->t->term[j].reg;
        const struct real_tape_entry *part = &c->t->step[reg - 2];
        if (!real_tape_grows(c->t, reg)) {
            sum += c->t->term[j].c * (c->reg[reg] * keep[0]);
        } else if (part->kind == STEP_GROWTH) {
            sum += c->t->term[j].c * go_growth(c, part, slot, keep + at);
            slot += 1;
            at += 1;
        } else {
            sum += c->t->term[j].c * go_apart(c, part, slot, keep + at);
            slot += 2;
            at += 2;
        }
    }
    return sum;
}

/* w' = p u' with the logistic p, p' = (1 - p) w' */
static inline jet_pair go_mixed(const struct course *c, jet_pair u, int slot,
                                const jet_pair keep[])
{
    const jet_pair w = chain(c, slot, c->k * u, keep[0]),
                   p = chain(c, slot + 1, c->k * w, keep[1]);

    tell(c, slot, p);
    tell(c, slot + 1, -p);
    return w;
}

/* g' = h u', h' = +-g u'; of a joined sinh h' = -2 sign(g) h u' */
static inline jet_pair go_turning(const struct course *c, jet_pair u, int slot,
                                  jet_pair g0, jet_pair h0, bool minus)
{
    const jet_pair d = c->k * u, g = chain(c, slot, d, h0),
                   h = chain(c, slot + 1, d, g0);

    tell(c, slot, minus ? -h : h);
    tell(c, slot + 1, g);
    return g;
}

static inline jet_pair go_sinh(const struct course *c, int i, jet_pair u,
                               int slot, const jet_pair keep[])
{
    if (!is_joined(c->t, i + 2))
        return go_turning(c, u, slot, keep[0], keep[1], false);
    const jet_pair g = chain(c, slot, c->k * u, keep[1]);
    tell(c, slot, 2.0 * jet_choose(keep[0] < JET_PAIR(0.0), g, -g));
    return g;
}

/* m = asinh(e^w/2): m' = t w', t = tanh m, t' = b m', b = 1 - t^2 */
static inline jet_pair go_friction(const struct course *c, jet_pair u, int slot,
                                   const jet_pair keep[])
{
    const jet_pair m = chain(c, slot, c->k * u, keep[0]),
                   t = chain(c, slot + 1, c->k * m, keep[1]);

    tell(c, slot, t);
    tell(c, slot + 1, -(c->S[slot + 2] + 2.0 * keep[0] * t));
    c->A[slot + 2] = t;
    tell(c, slot + 2, t);
    return m;
}

/* t' = b u' with b = 1 + t^2 for tan, 1 - t^2 for tanh */
static jet_pair go_tangent(const struct course *c, jet_pair u, int slot,
                           const jet_pair keep[], bool circular)
{
    const jet_pair t = chain(c, slot, c->k * u, keep[1]),
                   b = c->S[slot + 1] + 2.0 * keep[0] * t;

    tell(c, slot, circular ? b : -b);
    c->A[slot + 1] = t;
    tell(c, slot + 1, t);
    return t;
}

/* d m' = u': m, with 1/d0; d is told */
static inline jet_pair over_slope(const struct course *c, jet_pair u, int slot,
                                  jet_pair over)
{
    const jet_pair dm = (c->k * u - c->S[slot]) * over;

    c->A[slot] = dm;
    return dm * c->inverse;
}

/* d = 1 + w^2 for atan; d' = -w m' for asin, w m' for asinh */
static jet_pair go_inverse(const struct course *c,
                           const struct real_tape_entry *n, jet_pair u,
                           int slot, const jet_pair keep[])
{
    const jet_pair m = over_slope(c, u, slot, keep[1]);
    jet_pair d;

    if (n->kind == STEP_ATAN) {
        d = c->S[slot + 1] + 2.0 * keep[2] * u;
        c->A[slot + 1] = u;
    } else {
        d = chain(c, slot + 1, c->k * m, keep[2]);
    }
    tell(c, slot + 1, u);
    tell(c, slot, n->kind == STEP_ASIN ? -d : d);
    return m;
}

static inline jet_pair go_product(const struct course *c, int slot, jet_pair u,
                                  jet_pair w, jet_pair u0, jet_pair w0)
{
    c->A[slot] = u;
    tell(c, slot, w);
    return c->S[slot] + (u0 * w + u * w0);
}

static inline jet_pair go_quotient(const struct course *c, int slot, jet_pair u,
                                   jet_pair w, const jet_pair keep[])
{
    const jet_pair q = (u - keep[0] * w - c->S[slot]) * keep[1];

    c->A[slot] = q;
    tell(c, slot, w);
    return q;
}

static inline jet_pair go_ln1p(const struct course *c, jet_pair u, int slot,
                               const jet_pair keep[])
{
    tell(c, slot, u);
    return over_slope(c, u, slot, keep[0]);
}

static inline __attribute__((always_inline)) jet_pair go(const struct course *c,
                                                         int i)
{
    const struct real_tape_entry *n = &c->t->step[i];
    const jet_pair *keep = c->all + c->p->keep + c->p->kept[i];
    const int slot = c->p->slot[i];
    const jet_pair u = c->reg[n->a >= 0 ? n->a : 0],
                   w = c->reg[n->b >= 0 ? n->b : 0];

    switch (n->kind) {
        case STEP_LINEAR:
            return linear(c, &n->form);
        case STEP_GROWTH:
        case STEP_EXP:
            return go_growth(c, n, slot, keep);
        case STEP_APART:
            return go_apart(c, n, slot, keep);
        case STEP_SCALED:
            return go_scaled(c, n, slot, keep);
        case STEP_MIXED:
            return go_mixed(c, u, slot, keep);
        case STEP_LN1P:
            return go_ln1p(c, u, slot, keep);
        case STEP_SINH:
            return go_sinh(c, i, u, slot, keep);
        case STEP_FRICTION:
            return go_friction(c, u, slot, keep);
        case STEP_SIN:
        case STEP_COSH:
            return go_turning(c, u, slot, keep[0], keep[1],
                              n->kind == STEP_SIN);
        case STEP_TAN:
        case STEP_TANH:
            return go_tangent(c, u, slot, keep, n->kind == STEP_TAN);
        case STEP_PRODUCT:
            return go_product(c, slot, u, w, keep[0], keep[1]);
        case STEP_QUOTIENT:
            return go_quotient(c, slot, u, w, keep);
        default:
            return go_inverse(c, n, u, slot, keep);
    }
}

/* ---- rates --------------------------------------------------------------- */

/* What the exponent has besides its linear form, at order 0: s, |w0| of the
 * factor sinh w where that is frozen. */
static jet_pair fixed(const struct course *c, const struct real_tape_rate *r)
{
    jet_pair s = { 0 };

    if (r->scaled >= 0) {
        const int i = r->scaled - 2;
        s = c->all[c->p->keep + c->p->kept[i] +
                   KEPT * tape_step_slots(c->t, &c->t->step[i])];
    }
    if (r->sinh >= 0 && !is_joined(c->t, r->sinh)) {
        const struct real_tape_entry *n = &c->t->step[r->sinh - 2];
        const jet_pair w = n->k + c->reg[n->a];
        EACH(s, fabs(w[i]));
    }
    return s;
}

/* Which of two exponents: where the factor sinh is < 0; bits. */
static jet_mask sign_of(const struct course *c, const struct real_tape_rate *r)
{
    return r->sinh >= 0 ? c->reg[r->sinh] < JET_PAIR(0.0)
                        : JET_PAIR(1.0) < JET_PAIR(0.0);
}

/* The linear form of a rate's exponent without its constant. */
static inline jet_pair exponent(const struct course *c,
                                const struct real_tape_rate *r, jet_mask less)
{
    if (r->sinh < 0)
        return linear(c, &r->exponent[0]);
    if (!is_joined(c->t, r->sinh))
        return linear(c, &r->mean);
    return jet_choose(less, linear(c, &r->exponent[1]),
                      linear(c, &r->exponent[0]));
}

static jet_pair size_of(const struct course *c, int i, jet_pair *kept)
{
    const struct real_tape_rate *r = &c->t->rate[i];
    const jet_mask less = sign_of(c, r);
    const bool mean = r->sinh >= 0 && !is_joined(c->t, r->sinh);
    const jet_pair constant =
        mean ? JET_PAIR(r->mean.constant)
             : jet_choose(less, JET_PAIR(r->exponent[1].constant),
                          JET_PAIR(r->exponent[0].constant));

    *kept = mean ? JET_PAIR(r->mean_kept)
                 : jet_choose(less, JET_PAIR(r->kept[1]), JET_PAIR(r->kept[0]));
    return constant + exponent(c, r, less) + fixed(c, r);
}

/* Order 0 of a rate; keeps mantissa, kept e^(E - scale) and the sign. */
static jet_pair start_rate(const struct course *c, int rate, jet_pair scale)
{
    const struct real_tape_rate *r = &c->t->rate[rate];
    jet_pair *keep = c->all + c->p->keep + c->p->rate_kept[rate];
    jet_pair kept;
    const jet_pair e = size_of(c, rate, &kept) - scale;

    keep[0] = r->mantissa.constant + linear(c, &r->mantissa);
    EACH(keep[1], kept[i] * exp(e[i]));
    keep[2] = (jet_pair) sign_of(c, r);
    return keep[0] * keep[1];
}

static inline jet_pair go_rate(const struct course *c, int i)
{
    const struct real_tape_rate *r = &c->t->rate[i];
    const jet_pair *keep = c->all + c->p->keep + c->p->rate_kept[i];
    const int slot = c->p->rate_slot[i];
    const jet_pair m = linear(c, &r->mantissa);

    if (is_fixed(r))
        return m * keep[1];
    const jet_pair d = c->k * exponent(c, r, (jet_mask) keep[2]),
                   e = chain(c, slot, d, keep[1]);
    tell(c, slot, e);
    return r->mantissa.terms ? go_product(c, slot + 1, m, e, keep[0], keep[1])
                             : keep[0] * e;
}

/* ---- the contract -------------------------------------------------------- */

void tape_jet(const void *ctx, struct jet_work *w, size_t k, const jet_pair x[],
              const jet_pair y[], jet_pair fx[], jet_pair fy[])
{
    const struct tape_plane *p = ctx;
    struct course c;
    jet_pair kept;

    course_at(&c, p, w, k, 0);
    c.reg[0] = x[k];
    c.reg[1] = y[k];
    w->frozen[0] = JET_PAIR(-1.0); /* observables' steps are not done */
    if (k > 0) {
        tape_sums(p, w, k, 0);
        for (int i = 0; i < p->t.rate_steps; i++)
            if (!p->t.step[i].idle)
                c.reg[i + 2] = go(&c, i);
        fx[k] = go_rate(&c, 0);
        fy[k] = go_rate(&c, 1);
        return;
    }
    for (int i = 0; i < p->t.rate_steps; i++)
        if (!p->t.step[i].idle)
            tape_start(&c, i);
    const jet_pair e[2] = { size_of(&c, 0, &kept), size_of(&c, 1, &kept) };
    EACH(w->log_scale, fmax(e[0][i], e[1][i]));
    fx[0] = start_rate(&c, 0, w->log_scale);
    fy[0] = start_rate(&c, 1, w->log_scale);
}

void tape_jet_rate(const void *ctx, size_t which, struct jet_work *w, size_t k,
                   const jet_pair x[], const jet_pair y[], jet_pair rate[])
{
    const struct tape_plane *p = ctx;
    const int i = 2 + (int) which;
    struct course c;

    (void) x, (void) y; /* registers of this order */
    course_at(&c, p, w, k, 1);
    if (w->frozen[0][0] < (double) k) {
        if (k > 0)
            tape_sums(p, w, k, 1);
        for (int j = p->t.rate_steps; j < p->t.steps; j++)
            if (k > 0 && !p->t.step[j].idle)
                c.reg[j + 2] = go(&c, j);
            else if (!p->t.step[j].idle)
                tape_start(&c, j);
        w->frozen[0] = JET_PAIR((double) k);
    }
    rate[k] = k > 0 ? go_rate(&c, i) : start_rate(&c, i, w->log_scale);
}
