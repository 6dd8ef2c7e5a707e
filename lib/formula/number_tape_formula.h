/* The functions of number_tape.h, for TAPE_SCALAR, TAPE_CONSTANT, TAPE_KIND and
 * FN; CONSTANT_FN(f) is f for constants. */

#include <float.h>

#include "change.h"

/* ---- constants ----------------------------------------------------------- */

struct TAPE_KIND(making) {
    const struct tape *from;
    const TAPE_CONSTANT *constant; /* by node */
    struct TAPE_KIND(tape) * to;
    int place[TAPE_STEPS + 2]; /* of a register; -1: not needed */
};

static void TAPE_KIND(linear_at)(struct TAPE_KIND(making) * m,
                                 const struct linear *u,
                                 struct TAPE_KIND(tape_form) * out)
{
    struct TAPE_KIND(tape) *t = m->to;

    out->constant = (TAPE_SCALAR) m->constant[u->constant];
    out->first = t->terms;
    out->terms = u->terms;
    for (int i = 0; i < u->terms && t->terms < NUMBER_TERMS; i++) {
        t->term[t->terms].reg = m->place[u->term[i].reg];
        t->term[t->terms++].c = (TAPE_SCALAR) m->constant[u->term[i].c];
    }
}

/* ---- making -------------------------------------------------------------- */

/* k (e^u - e^(w + q)) as -k e^q (e^w - e^(u - q)) where k has no digits. */
static void TAPE_KIND(turn)(struct TAPE_KIND(tape_entry) * e, TAPE_CONSTANT k,
                            TAPE_CONSTANT q)
{
    const struct TAPE_KIND(tape_entry) old = *e;

    if (!(old.k < DBL_MIN && old.k > -DBL_MIN && old.q > 0))
        return;
    e->a = old.b;
    e->b = old.a;
    e->k = (TAPE_SCALAR) (-k * CONSTANT_FN(exp)(q));
    e->q = -old.q;
}

static void TAPE_KIND(step_at)(struct TAPE_KIND(making) * m,
                               const struct step *s)
{
    struct TAPE_KIND(tape_entry) *out = &m->to->step[m->to->steps++];
    const TAPE_CONSTANT k = m->constant[s->k];

    *out = (struct TAPE_KIND(tape_entry)){ .kind = s->kind, .a = -1, .b = -1 };
    out->a = s->a >= 0 ? m->place[s->a] : -1;
    out->b = s->b >= 0 ? m->place[s->b] : -1;
    out->k = (TAPE_SCALAR) (s->kind == STEP_TAN ? CONSTANT_FN(cos)(k) : k);
    out->q =
        (TAPE_SCALAR) (s->kind == STEP_FRICTION ? 4 * CONSTANT_FN(exp)(-2 * k)
                       : s->kind == STEP_TAN    ? CONSTANT_FN(sin)(k)
                                                : m->constant[s->q]);
    if (s->kind == STEP_APART)
        TAPE_KIND(turn)(out, k, m->constant[s->q]);
    TAPE_KIND(linear_at)(m, &s->form, &out->form);
}

/* Those that are needed and not there yet. */
static void TAPE_KIND(steps_at)(struct TAPE_KIND(making) * m,
                                const bool needed[])
{
    for (int i = 0; i < m->from->steps; i++) {
        if (!needed[i + 2] || m->place[i + 2] >= 0)
            continue;
        m->place[i + 2] = m->to->steps + 2;
        TAPE_KIND(step_at)(m, &m->from->step[i]);
    }
}

/* Its two exponents' mean; terms of both are in it twice, halved. */
static void TAPE_KIND(mean_at)(struct TAPE_KIND(making) * m,
                               const struct tape_rate *r,
                               struct TAPE_KIND(tape_rate) * out)
{
    struct TAPE_KIND(tape) *t = m->to;
    const TAPE_CONSTANT c = (m->constant[r->exponent[0].constant] +
                             m->constant[r->exponent[1].constant]) /
                            2;
    TAPE_CONSTANT sum[TAPE_STEPS + 2] = { 0 };

    for (int k = 0; k < 2; k++)
        for (int i = 0; i < r->exponent[k].terms; i++)
            sum[m->place[r->exponent[k].term[i].reg]] +=
                m->constant[r->exponent[k].term[i].c] / 2;
    out->mean = (struct TAPE_KIND(tape_form)){ (TAPE_SCALAR) c, t->terms, 0 };
    for (int i = 0; i < t->steps + 2 && t->terms < NUMBER_TERMS; i++)
        if (sum[i] > 0 || sum[i] < 0) {
            t->term[t->terms].reg = i;
            t->term[t->terms++].c = (TAPE_SCALAR) sum[i];
            out->mean.terms++;
        }
}

static void TAPE_KIND(rate_at)(struct TAPE_KIND(making) * m,
                               const struct tape_rate *r,
                               struct TAPE_KIND(tape_rate) * out)
{
    TAPE_KIND(linear_at)(m, &r->mantissa, &out->mantissa);
    for (int k = 0; k < TAPE_EXPONENTS; k++) {
        const TAPE_CONSTANT c = m->constant[r->exponent[k].constant];
        TAPE_KIND(linear_at)(m, &r->exponent[k], &out->exponent[k]);
        const TAPE_CONSTANT rest =
            c - (TAPE_CONSTANT) out->exponent[k].constant;
        out->kept[k] = (TAPE_SCALAR) (rest > -1 && rest < 1 ? 1 + rest : 1);
    }
    out->grows = false;
    for (int k = TAPE_NEAR; k < TAPE_EXPONENTS; k++)
        for (int i = 0; i < r->exponent[k].terms; i++)
            out->grows =
                out->grows || tape_takes(m->from, r->exponent[k].term[i].reg);
    if (r->sinh >= 0)
        TAPE_KIND(mean_at)(m, r, out);
    out->sinh = r->sinh >= 0 ? m->place[r->sinh] : -1;
    out->scaled = r->scaled >= 0 ? m->place[r->scaled] : -1;
    out->joined = r->joined;
}

static void TAPE_KIND(read_form)(const struct TAPE_KIND(tape) * t,
                                 const struct TAPE_KIND(tape_form) * u,
                                 bool parts, bool read[])
{
    for (int j = u->first; j < u->first + u->terms; j++)
        if (!parts || !TAPE_KIND(tape_grows)(t, t->term[j].reg))
            read[t->term[j].reg] = true;
}

static void TAPE_KIND(read_rate)(struct TAPE_KIND(tape) * t, int rate,
                                 bool read[])
{
    const struct TAPE_KIND(tape_rate) *r = &t->rate[rate];

    TAPE_KIND(read_form)(t, &r->mantissa, false, read);
    for (int k = 0; k < TAPE_EXPONENTS; k++)
        TAPE_KIND(read_form)(t, &r->exponent[k], false, read);
    read[r->sinh >= 0 ? r->sinh : 0] = true;
    read[r->scaled >= 0 ? r->scaled : 0] = true;
}

/* Which registers nobody reads. */
static void TAPE_KIND(find_idle)(struct TAPE_KIND(tape) * t)
{
    bool read[TAPE_STEPS + 2] = { false };

    for (int i = 0; i < t->steps; i++) {
        const struct TAPE_KIND(tape_entry) *n = &t->step[i];
        TAPE_KIND(read_form)(t, &n->form, n->kind == STEP_SCALED, read);
        read[n->a >= 0 ? n->a : 0] = read[n->b >= 0 ? n->b : 0] = true;
    }
    for (int i = 0; i < t->rates; i++) {
        const struct TAPE_KIND(tape_rate) *r = &t->rate[i];
        TAPE_KIND(read_rate)(t, i, read);
        if (r->joined)
            t->step[r->sinh - 2].joined = true;
    }
    for (int i = 0; i < TAPE_VALUES; i++)
        TAPE_KIND(read_form)(t, &t->value[i], false, read);
    for (int i = 0; i < t->steps; i++)
        t->step[i].idle = !read[i + 2];
}

/* What an observable's rate needs, parts of scaled ones, too. */
static void TAPE_KIND(find_used)(struct TAPE_KIND(tape) * t, int rate,
                                 bool used[])
{
    bool read[TAPE_STEPS + 2] = { false };

    TAPE_KIND(read_rate)(t, rate, read);
    for (int i = t->steps; i-- > 0;) {
        const struct TAPE_KIND(tape_entry) *n = &t->step[i];
        used[i] = read[i + 2] && !n->idle;
        if (!read[i + 2])
            continue;
        TAPE_KIND(read_form)(t, &n->form, false, read);
        read[n->a >= 0 ? n->a : 0] = read[n->b >= 0 ? n->b : 0] = true;
    }
}

bool TAPE_KIND(tape_at)(const struct tape *t, const TAPE_CONSTANT constant[],
                        struct TAPE_KIND(tape) * out)
{
    struct TAPE_KIND(making) m = { .from = t, .constant = constant, .to = out };
    bool needed[TAPE_STEPS + 2] = { false };

    out->steps = out->terms = 0;
    for (int i = 0; i < TAPE_STEPS + 2; i++)
        m.place[i] = i < 2 ? i : -1;
    for (int i = 0; i < t->rates; i++) {
        tape_need_rate(&t->rate[i], needed);
        tape_need_parts(t, needed);
        if (i >= 1)
            TAPE_KIND(steps_at)(&m, needed);
        if (i == 1)
            out->rate_steps = out->steps;
    }
    for (int i = 0; i < TAPE_VALUES; i++)
        tape_need_linear(&t->value[i], needed);
    tape_need_parts(t, needed);
    TAPE_KIND(steps_at)(&m, needed);
    for (int i = 0; i < t->rates; i++)
        TAPE_KIND(rate_at)(&m, &t->rate[i], &out->rate[i]);
    out->rates = t->rates;
    for (int i = 0; i < TAPE_VALUES; i++)
        TAPE_KIND(linear_at)(&m, &t->value[i], &out->value[i]);
    TAPE_KIND(find_idle)(out);
    for (int i = 2; i < t->rates; i++)
        TAPE_KIND(find_used)(out, i, out->used[i - 2]);
    return out->terms < NUMBER_TERMS;
}

/* ---- steps --------------------------------------------------------------- */

/* p (e^u - 1), l = u + ln p; p = 0: e^l */
static TAPE_SCALAR TAPE_KIND(growth)(TAPE_SCALAR p, TAPE_SCALAR l,
                                     TAPE_SCALAR u)
{
    return u > 1 || !(p > 0) ? FN(exp)(l) - p : p * scalar_em1(u);
}

TAPE_SCALAR TAPE_KIND(tape_step)(const struct TAPE_KIND(tape) * t, int i,
                                 TAPE_SCALAR s, const TAPE_SCALAR r[])
{
    const struct TAPE_KIND(tape_entry) *n = &t->step[i];
    const TAPE_SCALAR k = n->k, q = n->q;
    const TAPE_SCALAR u = n->a >= 0 ? r[n->a] : 0, w = n->b >= 0 ? r[n->b] : 0;

    switch (n->kind) {
        case STEP_GROWTH:
            return TAPE_KIND(growth)(s > 0 && k > 0 ? FN(exp)(q - s) : k,
                                     TAPE_KIND(tape_grown)(t, i, r) - s, u);
        case STEP_APART:
            return scalar_difference(k, u - s, w + q - s);
        case STEP_MIXED:
            return scalar_log1p_expm1(k, q, u);
        case STEP_LN1P:
            return FN(log1p)(u / k);
        case STEP_SINH:
            return scalar_sinh(k + u);
        case STEP_FRICTION:
            return scalar_friction(k, q, u);
        case STEP_SIN:
            return change_sin(k, q, u);
        case STEP_COSH:
            return change_cosh(k, u);
        case STEP_TAN:
            return change_tan(k, q, u);
        case STEP_TANH:
            return change_tanh(k, u);
        case STEP_ASIN:
            return change_asin(k, u);
        case STEP_ATAN:
            return change_atan(k, u);
        case STEP_ASINH:
            return change_asinh(k, u);
        case STEP_PRODUCT:
            return u * w;
        case STEP_QUOTIENT:
            return u / (k + w);
        default:
            return TAPE_KIND(tape_linear)(t, &n->form, r);
    }
}

static TAPE_SCALAR TAPE_KIND(scaled)(const struct TAPE_KIND(tape) * t, int i,
                                     const TAPE_SCALAR r[])
{
    const struct TAPE_KIND(tape_form) *form = &t->step[i].form;
    const TAPE_SCALAR s = TAPE_KIND(tape_scale)(t, i, r), less = FN(exp)(-s);
    TAPE_SCALAR sum = form->constant * less;

    for (int j = form->first; j < form->first + form->terms; j++) {
        const int reg = t->term[j].reg;
        sum += t->term[j].c * (TAPE_KIND(tape_grows)(t, reg)
                                   ? TAPE_KIND(tape_step)(t, reg - 2, s, r)
                                   : r[reg] * less);
    }
    return sum;
}

void TAPE_KIND(tape_run)(const struct TAPE_KIND(tape) * t, TAPE_SCALAR x,
                         TAPE_SCALAR y, int rate, TAPE_SCALAR r[])
{
    const bool *used = rate < 2 ? NULL : t->used[rate - 2];
    const int steps = rate == 0 ? t->rate_steps : t->steps;

    r[0] = x;
    r[1] = y;
    for (int i = 0; i < steps; i++)
        if (used ? used[i] : !t->step[i].idle)
            r[i + 2] = t->step[i].kind == STEP_SCALED
                           ? TAPE_KIND(scaled)(t, i, r)
                           : TAPE_KIND(tape_step)(t, i, 0, r);
}
