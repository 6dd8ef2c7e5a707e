/* A tape as the list of what an order of its series has to do: linear forms as
 * sums of two, everything else as one entry, and where all of it stands in the
 * workspace.  Factors of 1 and -1 are left out, which changes no bit. */
#include "tape_course.h"

#include <stddef.h>
#include <string.h>

enum { ALL = JET_SLOTS * JET_SIZE, REGISTERS = TAPE_STEPS + 2 };

struct orders {
    struct tape_plane *p;
    const struct real_tape *t;
    int free;               /* register */
    int slots;              /* of this part so far */
    int alone;              /* as of struct tape_part; -2: none needs a row */
    bool needed[REGISTERS]; /* at orders above 0 */
};

/* c times a register; several are a sum */
struct term {
    int reg;
    double c;
};

/* ---- what is needed ------------------------------------------------------ */

static void need_form(struct orders *o, const struct real_tape_form *u)
{
    for (int j = u->first; j < u->first + u->terms; j++)
        o->needed[o->t->term[j].reg] = true;
}

static void need_rate(struct orders *o, const struct real_tape_rate *r)
{
    need_form(o, &r->mantissa);
    if (is_mean(o->t, r)) {
        need_form(o, &r->mean);
        return;
    }
    need_form(o, &r->exponent[0]);
    if (r->sinh >= 0)
        need_form(o, &r->exponent[1]);
}

/* The b of a growth is for order 0 only. */
static void find_needed(struct orders *o)
{
    const struct real_tape *t = o->t;

    for (int i = 0; i < t->rates; i++)
        need_rate(o, &t->rate[i]);
    for (int i = t->steps; i-- > 0;) {
        const struct real_tape_entry *n = &t->step[i];
        if (!o->needed[i + 2])
            continue;
        need_form(o, &n->form);
        if (n->kind == STEP_SCALED)
            for (int j = n->form.first; j < n->form.first + n->form.terms; j++)
                o->needed[t->term[j].reg] = true;
        if (n->a >= 0)
            o->needed[n->a] = true;
        if (n->b >= 0 && n->kind != STEP_GROWTH)
            o->needed[n->b] = true;
    }
}

/* ---- entries ------------------------------------------------------------- */

static unsigned bytes(int pairs)
{
    return (unsigned) pairs * (unsigned) sizeof(jet_pair);
}

static struct jet_op *add(struct orders *o, enum jet_code code, int out, int a,
                          int b)
{
    struct tape_plane *p = o->p;
    struct jet_op *op = &p->op[p->ops < TAPE_OPS ? p->ops : TAPE_OPS - 1];

    p->ops++;
    *op = (struct jet_op){ .code = code,
                           .out = bytes(out),
                           .a = bytes(a),
                           .b = bytes(b),
                           .c = { 1, 1 } };
    return op;
}

static bool is_unit(double c)
{
    return !(c < 1 || c > 1) || !(c < -1 || c > -1);
}

/* out = a + c b */
static void add_term(struct orders *o, int out, int a, struct term b)
{
    if (is_unit(b.c))
        add(o, b.c > 0 ? JET_SUM : JET_LESS, out, a, b.reg);
    else
        add(o, JET_ADD, out, a, b.reg)->c[0] = b.c;
}

static void add_sum(struct orders *o, int out, const struct term u[], int n)
{
    if (n == 0) {
        add(o, JET_NOTHING, out, 0, 0);
    } else if (n == 1) {
        add(o, JET_TIMES, out, u[0].reg, 0)->c[0] = u[0].c;
    } else if (is_unit(u[0].c) && u[0].c > 0) {
        add_term(o, out, u[0].reg, u[1]);
    } else {
        struct jet_op *op = add(o, JET_TWO, out, u[0].reg, u[1].reg);
        op->c[0] = u[0].c;
        op->c[1] = u[1].c;
    }
    for (int j = 2; j < n; j++)
        add_term(o, out, out, u[j]);
}

static int read_form(const struct orders *o, const struct real_tape_form *f,
                     struct term u[])
{
    for (int j = 0; j < f->terms; j++)
        u[j] = (struct term){ o->t->term[f->first + j].reg,
                              o->t->term[f->first + j].c };
    return f->terms;
}

/* Its register, over a factor *c. */
static int add_form(struct orders *o, const struct real_tape_form *f, double *c)
{
    struct term u[REGISTERS];
    const int n = read_form(o, f, u);

    *c = n == 1 && (u[0].c > 0 || u[0].c < 0) ? u[0].c : 1;
    if (n == 1 && (u[0].c > 0 || u[0].c < 0))
        return u[0].reg;
    add_sum(o, o->free, u, n);
    return o->free++;
}

/* ---- steps --------------------------------------------------------------- */

int tape_kind_slots(enum step_kind kind)
{
    switch (kind) {
        case STEP_LINEAR:
        case STEP_SCALED:
            return 0;
        case STEP_GROWTH:
        case STEP_LN1P:
        case STEP_PRODUCT:
        case STEP_QUOTIENT:
            return 1;
        case STEP_FRICTION:
            return 3;
        default:
            return 2;
    }
}

int tape_step_slots(const struct real_tape *t, const struct real_tape_entry *n)
{
    int slots = tape_kind_slots(n->kind);

    for (int j = 0; n->kind == STEP_SCALED && j < n->form.terms; j++) {
        const int reg = t->term[n->form.first + j].reg;
        if (real_tape_grows(t, reg))
            slots += tape_kind_slots(t->step[reg - 2].kind);
    }
    return slots;
}

static enum jet_code code_of(const struct real_tape *t, int i)
{
    static const enum jet_code code[] = {
        [STEP_GROWTH] = JET_GROWTH,     [STEP_APART] = JET_APART,
        [STEP_MIXED] = JET_MIXED,       [STEP_LN1P] = JET_LN1P,
        [STEP_SINH] = JET_SINH,         [STEP_FRICTION] = JET_FRICTION,
        [STEP_SIN] = JET_SIN,           [STEP_COSH] = JET_SINH,
        [STEP_TAN] = JET_TAN,           [STEP_TANH] = JET_TANH,
        [STEP_ASIN] = JET_ASIN,         [STEP_ATAN] = JET_ATAN,
        [STEP_ASINH] = JET_ASINH,       [STEP_PRODUCT] = JET_PRODUCT,
        [STEP_QUOTIENT] = JET_QUOTIENT,
    };
    const enum step_kind kind = t->step[i].kind;

    return kind == STEP_SINH && is_joined(t, i + 2) ? JET_SINH_JOINED
                                                    : code[kind];
}

/* Rows A of multiples of a register; -1: and of others. */
static void row_of(struct orders *o, int reg)
{
    const bool same = o->alone == -2 || o->alone == reg;

    o->alone = same && (reg == 0 || reg == 1) ? reg : -1;
}

/* Takes slots. */
static void add_function(struct orders *o, int i, int out, int keep)
{
    const struct real_tape_entry *n = &o->t->step[i];
    struct jet_op *op = add(o, code_of(o->t, i), out, n->a >= 0 ? n->a : 0,
                            n->b >= 0 ? n->b : 0);

    op->slot = bytes(o->slots);
    op->keep = bytes(keep);
    row_of(o, n->kind == STEP_GROWTH ? n->a : -1);
    o->slots += tape_kind_slots(n->kind);
}

/* Parts that grow have slots of their own; the others, together, are times
 * e^-s. */
static void add_scaled(struct orders *o, int i, int keep)
{
    const struct real_tape_form *f = &o->t->step[i].form;
    struct term all[REGISTERS], rest[REGISTERS];
    int parts = 0, others = 0, next = keep + 1;

    for (int j = f->first; j < f->first + f->terms; j++) {
        const struct term u = { o->t->term[j].reg, o->t->term[j].c };
        if (!real_tape_grows(o->t, u.reg)) {
            rest[others++] = u;
            continue;
        }
        all[parts++] = (struct term){ o->free, u.c };
        add_function(o, u.reg - 2, o->free++, next);
        next += tape_kind_slots(o->t->step[u.reg - 2].kind);
    }
    if (others > 0) {
        add_sum(o, o->free, rest, others);
        add(o, JET_FIXED, o->free + 1, o->free, 0)->keep = bytes(keep);
        all[parts++] = (struct term){ o->free + 1, 1 };
        o->free += 2;
    }
    add_sum(o, i + 2, all, parts);
}

static void add_step(struct orders *o, int i)
{
    const struct real_tape_entry *n = &o->t->step[i];
    const int keep = o->p->kept[i];
    struct term u[REGISTERS];

    if (n->idle || !o->needed[i + 2])
        return;
    if (n->kind == STEP_LINEAR)
        add_sum(o, i + 2, u, read_form(o, &n->form, u));
    else if (n->kind == STEP_SCALED)
        add_scaled(o, i, keep);
    else
        add_function(o, i, i + 2, keep);
}

/* ---- rates --------------------------------------------------------------- */

static int add_exponent(struct orders *o, const struct real_tape_rate *r,
                        int keep, double *c)
{
    struct term u[REGISTERS];
    const int plus = o->free, out = o->free + 2;

    if (r->sinh < 0)
        return add_form(o, &r->exponent[0], c);
    if (is_mean(o->t, r))
        return add_form(o, &r->mean, c);
    o->free += 3;
    for (int k = 0; k < 2; k++)
        add_sum(o, plus + k, u, read_form(o, &r->exponent[k], u));
    add(o, JET_CHOOSE, out, plus + 1, plus)->keep = bytes(keep + 2);
    *c = 1;
    return out;
}

/* m e^w, m and w over factors; slots for the exponential and the product.  A
 * mantissa that is one term has its factor in what is kept of order 0. */
static void add_rate(struct orders *o, int i)
{
    const struct real_tape_rate *r = &o->t->rate[i];
    const int keep = o->p->rate_kept[i];
    double of_m = 1, of_e = 1;

    const int m = is_fixed(r) || r->mantissa.terms > 0
                      ? add_form(o, &r->mantissa, &of_m)
                      : 0;
    o->p->factor[i] = of_m;
    if (is_fixed(r)) {
        add(o, JET_FIXED, o->free, m, 0)->keep = bytes(keep + 1);
    } else {
        const int e = add_exponent(o, r, keep, &of_e), out = o->free;
        struct jet_op *op =
            add(o, r->mantissa.terms ? JET_RATE : JET_RATE_ALONE, out, e, m);
        op->slot = bytes(o->slots);
        op->keep = bytes(keep);
        op->c[0] = of_e;
        row_of(o, r->mantissa.terms ? -1 : e);
        o->slots += 1 + (r->mantissa.terms > 0);
    }
    o->p->result[i] = (short) o->free++;
}

/* ---- all ----------------------------------------------------------------- */

/* What is kept of order 0 has its place in any case. */
static int keep_all(struct tape_plane *p)
{
    int kept = 0;

    for (int i = 0; i < p->t.steps; i++) {
        p->kept[i] = (short) kept;
        kept += TAPE_KEPT * tape_step_slots(&p->t, &p->t.step[i]) + 1;
    }
    p->kept[p->t.steps] = (short) kept;
    for (int i = 0; i < p->t.rates; i++, kept += TAPE_KEPT)
        p->rate_kept[i] = (short) kept;
    return kept;
}

/* Its steps, of those from .. to, and its rates; those that another part has,
 * too, are made by both. */
static void add_part(struct orders *o, int i, int *used)
{
    struct tape_plane *p = o->p;
    struct tape_part *part = &p->part[i];

    part->op = p->ops;
    o->slots = 0;
    o->alone = -2;
    for (int s = i ? p->t.rate_steps : 0;
         s < (i ? p->t.steps : p->t.rate_steps); s++)
        if (i == 0 || p->t.used[i - 1][s])
            add_step(o, s);
    for (int r = i ? i + 1 : 0; r < i + 2; r++)
        add_rate(o, r);
    part->ops = p->ops;
    part->alone = o->alone;
    part->odd = o->slots % 2;
    part->width = o->slots + part->odd;
    part->rows = *used;
    *used += (2 * JET_SIZE + 2) * part->width;
}

bool tape_jet_slots(struct tape_plane *p)
{
    struct orders o = { .p = p, .t = &p->t, .free = p->t.steps + 2 };
    const int kept = keep_all(p);
    int used = 0;

    find_needed(&o);
    p->ops = 0;
    for (int i = 0; i < p->t.rates - 1; i++)
        add_part(&o, i, &used);
    p->registers = used;
    p->keep = used + o.free;
    p->constants = p->keep + kept;
    return p->ops <= TAPE_OPS && kept <= TAPE_KEEPS &&
           p->constants + 2 * p->ops <= ALL;
}

/* ---- alike --------------------------------------------------------------- */

static bool forms_alike(const struct real_tape_form *u,
                        const struct real_tape_form *w)
{
    return u->first == w->first && u->terms == w->terms;
}

static bool steps_alike(const struct real_tape *t, const struct real_tape *u)
{
    bool alike = t->steps == u->steps && t->rate_steps == u->rate_steps &&
                 t->terms == u->terms;

    for (int i = 0; i < t->steps && alike; i++) {
        const struct real_tape_entry *n = &t->step[i], *m = &u->step[i];
        alike = n->kind == m->kind && n->a == m->a && n->b == m->b &&
                n->joined == m->joined && n->idle == m->idle &&
                forms_alike(&n->form, &m->form);
    }
    for (int i = 0; i < t->terms && alike; i++)
        alike = t->term[i].reg == u->term[i].reg;
    return alike;
}

static bool rates_alike(const struct real_tape *t, const struct real_tape *u)
{
    bool alike = t->rates == u->rates;

    for (int i = 0; i < t->rates && alike; i++) {
        const struct real_tape_rate *r = &t->rate[i], *q = &u->rate[i];
        alike = r->sinh == q->sinh && r->scaled == q->scaled &&
                r->grows == q->grows && forms_alike(&r->mantissa, &q->mantissa);
        for (int k = 0; k < TAPE_EXPONENTS && alike; k++)
            alike = forms_alike(&r->exponent[k], &q->exponent[k]);
    }
    return alike && memcmp(t->used, u->used, sizeof t->used) == 0;
}

bool tape_alike(const void *ctx, const void *other)
{
    const struct tape_plane *p = ctx, *q = other;
    bool alike =
        steps_alike(&p->t, &q->t) && rates_alike(&p->t, &q->t) &&
        p->ops == q->ops && p->constants == q->constants &&
        memcmp(p->kept, q->kept, (size_t) p->t.steps * sizeof *p->kept) == 0;

    for (int i = 0; i < p->t.rates && alike; i++)
        alike = p->result[i] == q->result[i];
    for (int i = 0; i < p->t.rates - 1 && alike; i++)
        alike = p->part[i].width == q->part[i].width &&
                p->part[i].op == q->part[i].op &&
                p->part[i].alone == q->part[i].alone;
    for (int i = 0; i < p->ops && alike; i++)
        alike = memcmp(&p->op[i], &q->op[i], offsetof(struct jet_op, c)) == 0;
    return alike;
}
