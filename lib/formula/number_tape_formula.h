/* The functions of number_tape.h, for SCALAR, KIND and FN. */

#include "change.h"

/* ---- constants ----------------------------------------------------------- */

struct KIND(making) {
    const struct tape *from;
    const formula_real *constant; /* by node */
    struct KIND(tape) * to;
    int place[TAPE_STEPS + 2]; /* of a register; -1: not needed */
};

static void KIND(linear_at)(struct KIND(making) * m, const struct linear *u,
                            struct KIND(tape_form) * out)
{
    struct KIND(tape) *t = m->to;

    out->constant = (SCALAR) m->constant[u->constant];
    out->first = t->terms;
    out->terms = u->terms;
    for (int i = 0; i < u->terms && t->terms < NUMBER_TERMS; i++) {
        t->term[t->terms].reg = m->place[u->term[i].reg];
        t->term[t->terms++].c = (SCALAR) m->constant[u->term[i].c];
    }
}

/* ---- what is needed ------------------------------------------------------ */

static void KIND(need_linear)(const struct linear *u, bool needed[])
{
    for (int i = 0; i < u->terms; i++)
        needed[u->term[i].reg] = true;
}

static void KIND(need_rate)(const struct tape_rate *r, bool needed[])
{
    KIND(need_linear)(&r->mantissa, needed);
    for (int k = 0; k < 2; k++)
        KIND(need_linear)(&r->exponent[k], needed);
    if (r->sinh >= 0)
        needed[r->sinh] = true;
    if (r->scaled >= 0)
        needed[r->scaled] = true;
}

/* Users come after what they use. */
static void KIND(need_parts)(const struct tape *t, bool needed[])
{
    for (int i = t->steps; i-- > 0;) {
        const struct step *s = &t->step[i];
        if (!needed[i + 2])
            continue;
        if (s->a >= 0)
            needed[s->a] = true;
        if (s->b >= 0)
            needed[s->b] = true;
        if (s->kind == STEP_LINEAR || s->kind == STEP_SCALED)
            KIND(need_linear)(&s->form, needed);
    }
}

/* ---- making -------------------------------------------------------------- */

static void KIND(step_at)(struct KIND(making) * m, const struct step *s)
{
    struct KIND(tape_entry) *out = &m->to->step[m->to->steps++];
    const quad k = m->constant[s->k];

    *out = (struct KIND(tape_entry)){ .kind = s->kind, .a = -1, .b = -1 };
    out->a = s->a >= 0 ? m->place[s->a] : -1;
    out->b = s->b >= 0 ? m->place[s->b] : -1;
    out->k = (SCALAR) (s->kind == STEP_TAN ? cosq(k) : k);
    out->q = (SCALAR) (s->kind == STEP_FRICTION ? 4 * expq(-2 * k)
                       : s->kind == STEP_TAN    ? sinq(k)
                                                : m->constant[s->q]);
    KIND(linear_at)(m, &s->form, &out->form);
}

/* Those that are needed and not there yet. */
static void KIND(steps_at)(struct KIND(making) * m, const bool needed[])
{
    for (int i = 0; i < m->from->steps; i++) {
        if (!needed[i + 2] || m->place[i + 2] >= 0)
            continue;
        m->place[i + 2] = m->to->steps + 2;
        KIND(step_at)(m, &m->from->step[i]);
    }
}

/* Its two exponents' mean; terms of both are in it twice, halved. */
static void KIND(mean_at)(struct KIND(making) * m, const struct tape_rate *r,
                          struct KIND(tape_rate) * out)
{
    struct KIND(tape) *t = m->to;
    const quad c = (m->constant[r->exponent[0].constant] +
                    m->constant[r->exponent[1].constant]) /
                   2;
    quad sum[TAPE_STEPS + 2] = { 0 };

    for (int k = 0; k < 2; k++)
        for (int i = 0; i < r->exponent[k].terms; i++)
            sum[m->place[r->exponent[k].term[i].reg]] +=
                m->constant[r->exponent[k].term[i].c] / 2;
    out->mean = (struct KIND(tape_form)){ (SCALAR) c, t->terms, 0 };
    for (int i = 0; i < t->steps + 2 && t->terms < NUMBER_TERMS; i++)
        if (sum[i] > 0 || sum[i] < 0) {
            t->term[t->terms].reg = i;
            t->term[t->terms++].c = (SCALAR) sum[i];
            out->mean.terms++;
        }
    out->mean_kept = (SCALAR) expq(c - (quad) (SCALAR) c);
}

static void KIND(rate_at)(struct KIND(making) * m, const struct tape_rate *r,
                          struct KIND(tape_rate) * out)
{
    KIND(linear_at)(m, &r->mantissa, &out->mantissa);
    for (int k = 0; k < 2; k++) {
        const quad c = m->constant[r->exponent[k].constant];
        KIND(linear_at)(m, &r->exponent[k], &out->exponent[k]);
        out->kept[k] = (SCALAR) expq(c - (quad) out->exponent[k].constant);
    }
    KIND(mean_at)(m, r, out);
    out->sinh = r->sinh >= 0 ? m->place[r->sinh] : -1;
    out->scaled = r->scaled >= 0 ? m->place[r->scaled] : -1;
    out->joined = r->joined;
}

bool KIND(tape_at)(const struct tape *t, const formula_real constant[],
                   struct KIND(tape) * out)
{
    struct KIND(making) m = { .from = t, .constant = constant, .to = out };
    bool needed[TAPE_STEPS + 2] = { false };

    out->steps = out->terms = 0;
    for (int i = 0; i < TAPE_STEPS + 2; i++)
        m.place[i] = i < 2 ? i : -1;
    for (int i = 0; i < t->rates; i++) {
        KIND(need_rate)(&t->rate[i], needed);
        KIND(need_parts)(t, needed);
        if (i >= 1)
            KIND(steps_at)(&m, needed);
        if (i == 1)
            out->rate_steps = out->steps;
    }
    for (int i = 0; i < TAPE_VALUES; i++)
        KIND(need_linear)(&t->value[i], needed);
    KIND(need_parts)(t, needed);
    KIND(steps_at)(&m, needed);
    for (int i = 0; i < t->rates; i++)
        KIND(rate_at)(&m, &t->rate[i], &out->rate[i]);
    out->rates = t->rates;
    for (int i = 0; i < TAPE_VALUES; i++)
        KIND(linear_at)(&m, &t->value[i], &out->value[i]);
    return out->terms < NUMBER_TERMS;
}

/* ---- steps --------------------------------------------------------------- */

SCALAR KIND(tape_linear)(const struct KIND(tape) * t,
                         const struct KIND(tape_form) * u, const SCALAR r[])
{
    SCALAR sum = u->constant;

    for (int i = u->first; i < u->first + u->terms; i++)
        sum += t->term[i].c * r[t->term[i].reg];
    return sum;
}

bool KIND(tape_grows)(const struct KIND(tape) * t, int reg)
{
    return reg >= 2 && (t->step[reg - 2].kind == STEP_GROWTH ||
                        t->step[reg - 2].kind == STEP_APART);
}

SCALAR KIND(tape_grown)(const struct KIND(tape) * t, int i, const SCALAR r[])
{
    const struct KIND(tape_entry) *s = &t->step[i];

    return s->b >= 0 ? r[s->b] : s->q + r[s->a];
}

/* p (e^u - 1), l = u + ln p */
static SCALAR KIND(growth)(SCALAR p, SCALAR l, SCALAR u)
{
    return u > 1 ? FN(exp)(l) - p : p * scalar_em1(u);
}

SCALAR KIND(tape_step)(const struct KIND(tape) * t, int i, SCALAR s,
                       const SCALAR r[])
{
    const struct KIND(tape_entry) *n = &t->step[i];
    const SCALAR k = n->k, q = n->q;
    const SCALAR u = n->a >= 0 ? r[n->a] : 0, w = n->b >= 0 ? r[n->b] : 0;

    switch (n->kind) {
        case STEP_GROWTH:
            return KIND(growth)(s > 0 ? FN(exp)(q - s) : k,
                                KIND(tape_grown)(t, i, r) - s, u);
        case STEP_APART:
            return scalar_difference(k, u - s, w + q - s);
        case STEP_EXP:
            return FN(exp)(q + u);
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
            return KIND(tape_linear)(t, &n->form, r);
    }
}

SCALAR KIND(tape_scale)(const struct KIND(tape) * t, int i, const SCALAR r[])
{
    const struct KIND(tape_form) *form = &t->step[i].form;
    SCALAR s = 0;

    for (int j = form->first; j < form->first + form->terms; j++) {
        const int g = t->term[j].reg - 2;
        if (!KIND(tape_grows)(t, g + 2))
            continue;
        const struct KIND(tape_entry) *n = &t->step[g];
        s = scalar_larger(s, n->kind == STEP_GROWTH
                                 ? KIND(tape_grown)(t, g, r)
                                 : scalar_larger(r[n->a], r[n->b] + n->q));
    }
    return s;
}

static SCALAR KIND(scaled)(const struct KIND(tape) * t, int i, const SCALAR r[])
{
    const struct KIND(tape_form) *form = &t->step[i].form;
    const SCALAR s = KIND(tape_scale)(t, i, r), less = FN(exp)(-s);
    SCALAR sum = form->constant * less;

    for (int j = form->first; j < form->first + form->terms; j++) {
        const int reg = t->term[j].reg;
        sum += t->term[j].c * (KIND(tape_grows)(t, reg)
                                   ? KIND(tape_step)(t, reg - 2, s, r)
                                   : r[reg] * less);
    }
    return sum;
}

void KIND(tape_run)(const struct KIND(tape) * t, SCALAR x, SCALAR y,
                    bool everything, SCALAR r[])
{
    const int steps = everything ? t->steps : t->rate_steps;

    r[0] = x;
    r[1] = y;
    for (int i = 0; i < steps; i++)
        r[i + 2] = t->step[i].kind == STEP_SCALED ? KIND(scaled)(t, i, r)
                                                  : KIND(tape_step)(t, i, 0, r);
}

/* ---- rates --------------------------------------------------------------- */

SCALAR KIND(tape_exponent)(const struct KIND(tape) * t, int i, const SCALAR r[])
{
    const struct KIND(tape_rate) *p = &t->rate[i];
    const bool less = p->sinh >= 0 && r[p->sinh] < 0;

    return KIND(tape_linear)(t, &p->exponent[less], r) +
           (p->scaled >= 0 ? KIND(tape_scale)(t, p->scaled - 2, r) : 0);
}

SCALAR KIND(tape_mantissa)(const struct KIND(tape) * t, int i, const SCALAR r[])
{
    const struct KIND(tape_rate) *p = &t->rate[i];
    const bool less = p->sinh >= 0 && r[p->sinh] < 0;

    return p->kept[less] * KIND(tape_linear)(t, &p->mantissa, r);
}
