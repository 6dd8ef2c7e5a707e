#include "linear.h"

#include <string.h>

struct linear linear_fail(struct forms *s, const char *reason)
{
    s->failed = s->failed ? s->failed : reason;
    return (struct linear){ 0 };
}

struct linear linear_constant(int node)
{
    return (struct linear){ .constant = node };
}

struct linear linear_one(struct forms *s, int reg, int node)
{
    struct linear u = { .constant = node, .terms = 1 };

    u.term[0].reg = reg;
    u.term[0].c = formula_number(s->f, 1);
    return u;
}

/* ---- steps --------------------------------------------------------------- */

static int emit(struct forms *s, const struct step *made)
{
    struct tape *t = s->t;

    for (int i = 0; i < t->steps; i++) {
        struct step old = t->step[i];
        memset(old.name, 0, sizeof old.name);
        if (memcmp(&old, made, sizeof old) == 0)
            return i + 2;
    }
    if (t->steps == TAPE_STEPS) {
        linear_fail(s, "it has too many parts");
        return 0;
    }
    t->step[t->steps] = *made;
    return 2 + t->steps++;
}

int linear_step(struct forms *s, enum step_kind kind, int a, int b, int k,
                int q)
{
    struct step made;

    memset(&made, 0, sizeof made);
    made.kind = kind;
    made.a = a;
    made.b = b;
    made.k = k;
    made.q = q;
    return emit(s, &made);
}

static int emit_form(struct forms *s, enum step_kind kind,
                     const struct linear *u, int constant)
{
    struct step made;

    memset(&made, 0, sizeof made);
    made.kind = kind;
    made.a = made.b = -1;
    made.form.constant = constant;
    made.form.terms = u->terms;
    memcpy(made.form.term, u->term, (size_t) u->terms * sizeof u->term[0]);
    return emit(s, &made);
}

int linear_reg(struct forms *s, const struct linear *u)
{
    if (u->terms == 1 && formula_is(s->f, u->term[0].c, 1.0))
        return u->term[0].reg;
    return emit_form(s, STEP_LINEAR, u, 0);
}

int linear_scaled(struct forms *s, const struct linear *u)
{
    return emit_form(s, STEP_SCALED, u, u->constant);
}

struct linear linear_function(struct forms *s, enum step_kind kind,
                              const struct linear *u, int k, int q, int node)
{
    if (u->terms == 0)
        return linear_constant(node);
    return linear_one(s, linear_step(s, kind, linear_reg(s, u), -1, k, q),
                      node);
}

/* ---- sums ---------------------------------------------------------------- */

static void add_term(struct forms *s, struct linear *u, int reg, int c)
{
    int j = 0;

    while (j < u->terms && u->term[j].reg != reg)
        j++;
    if (j == TAPE_TERMS) {
        *u = linear_one(s, linear_reg(s, u), u->constant);
        j = 1;
    }
    c = j < u->terms ? formula_sum(s->f, u->term[j].c, c) : c;
    u->terms += j == u->terms;
    u->term[j].reg = reg;
    u->term[j].c = c;
    if (!formula_is(s->f, c, 0.0))
        return;
    u->terms--;
    memmove(&u->term[j], &u->term[j + 1],
            (size_t) (u->terms - j) * sizeof u->term[0]);
}

void linear_add(struct forms *s, struct linear *u, int c,
                const struct linear *w)
{
    u->constant =
        formula_sum(s->f, u->constant, formula_times(s->f, c, w->constant));
    for (int i = 0; i < w->terms; i++)
        add_term(s, u, w->term[i].reg, formula_times(s->f, c, w->term[i].c));
}

void linear_add_times(struct forms *s, struct linear *u, double c,
                      const struct linear *w)
{
    linear_add(s, u, formula_number(s->f, c), w);
}

struct linear linear_times(struct forms *s, int c, const struct linear *w)
{
    struct linear u = { 0 };

    linear_add(s, &u, c, w);
    return u;
}

struct linear linear_over(struct forms *s, const struct linear *w, int c)
{
    struct linear u = *w;

    u.constant = formula_over(s->f, u.constant, c);
    for (int i = 0; i < u.terms; i++)
        u.term[i].c = formula_over(s->f, u.term[i].c, c);
    return u;
}

struct linear linear_grown(struct forms *s, const struct linear *u)
{
    struct linear out = linear_constant(u->constant);

    for (int i = 0; i < u->terms; i++) {
        const int reg = u->term[i].reg;
        struct linear part = linear_one(s, reg, 0);
        if (reg >= 2 && s->t->step[reg - 2].kind == STEP_GROWTH) {
            const struct step g = s->t->step[reg - 2];
            part = linear_one(s, linear_step(s, STEP_GROWTH, g.a, g.b, 0, g.q),
                              formula_less(s->f, 0, g.k));
        }
        linear_add(s, &out, u->term[i].c, &part);
    }
    return out;
}

int linear_value(struct forms *s, const struct linear *u)
{
    return emit_form(s, STEP_LINEAR, u, u->constant);
}

/* ---- at the anchor ------------------------------------------------------- */

static bool form_rests(const struct forms *s, const struct linear *u,
                       const bool rests[])
{
    bool all = true;

    for (int i = 0; i < u->terms && all; i++)
        all = rests[u->term[i].reg];
    return all && formula_is(s->f, u->constant, 0.0);
}

static bool step_rests(const struct forms *s, const struct step *t,
                       const bool rests[])
{
    switch (t->kind) {
        case STEP_LINEAR:
        case STEP_SCALED:
            return form_rests(s, &t->form, rests);
        case STEP_SINH:
            return false;
        case STEP_GROWTH:
            return t->k && rests[t->a];
        case STEP_APART:
            return formula_is(s->f, t->q, 0.0) && rests[t->a] && rests[t->b];
        case STEP_PRODUCT:
            return rests[t->a] || rests[t->b];
        default:
            return rests[t->a];
    }
}

bool linear_rests(const struct forms *s, const struct linear *u)
{
    bool rests[TAPE_STEPS + 2] = { true, true };
    struct linear registers = *u;

    registers.constant = 0;
    for (int i = 0; i < s->t->steps; i++)
        rests[i + 2] = step_rests(s, &s->t->step[i], rests);
    return form_rests(s, &registers, rests);
}

/* ---- products ------------------------------------------------------------ */

/* u0 w0 + w0 du + u0 dw + du dw */
struct linear linear_product(struct forms *s, const struct linear *u,
                             const struct linear *w)
{
    struct linear du = *u, dw = *w,
                  out = linear_constant(
                      formula_times(s->f, u->constant, w->constant));

    du.constant = dw.constant = 0;
    linear_add(s, &out, w->constant, &du);
    linear_add(s, &out, u->constant, &dw);
    if (du.terms && dw.terms) {
        const struct linear more =
            linear_one(s,
                       linear_step(s, STEP_PRODUCT, linear_reg(s, &du),
                                   linear_reg(s, &dw), 0, 0),
                       0);
        linear_add_times(s, &out, 1, &more);
    }
    return out;
}

/* q + (u - q w)/w with q = u0/w0 */
struct linear linear_quotient(struct forms *s, const struct linear *u,
                              const struct linear *w)
{
    struct linear du = *u, dw = *w;

    if (w->terms == 0)
        return linear_over(s, u, w->constant);
    const int q = formula_over(s->f, u->constant, w->constant);
    linear_add(s, &du, formula_less(s->f, 0, q), w);
    du.constant = dw.constant = 0;
    return linear_one(s,
                      linear_step(s, STEP_QUOTIENT, linear_reg(s, &du),
                                  linear_reg(s, &dw), w->constant, 0),
                      q);
}

/* By squares. */
struct linear linear_power(struct forms *s, const struct linear *u, int p)
{
    if (p == 1)
        return *u;
    const struct linear half = linear_power(s, u, p / 2),
                        square = linear_product(s, &half, &half);
    return p % 2 ? linear_product(s, &square, u) : square;
}
