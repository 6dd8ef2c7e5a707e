/*
 * number_tape.h -- a tape (tape.h) whose constants are numbers, for one type:
 * the including file defines TAPE_SCALAR, TAPE_CONSTANT, that constants come
 * in, and TAPE_KIND(f), the name of f for it.  Steps that nothing needs are
 * left out; the first `rate_steps` are all that the rates of the chart need.
 */
struct TAPE_KIND(tape_term) {
    int reg;
    TAPE_SCALAR c;
};

struct TAPE_KIND(tape_form) {
    TAPE_SCALAR constant;
    int first, terms; /* in term[] of the tape */
};

struct TAPE_KIND(tape_entry) {
    enum step_kind kind;
    int a, b;
    TAPE_SCALAR k, q;
    struct TAPE_KIND(tape_form) form;
    bool joined; /* of a sinh: tape_rate.joined */
    bool idle;   /* nobody reads its register: it is a part of scaled ones */
};

/* A rate times kept[] exp(..): what rounding took from the exponent's constant,
 * which may be hundreds. */
struct TAPE_KIND(tape_rate) {
    struct TAPE_KIND(tape_form) mantissa, exponent[TAPE_EXPONENTS];
    struct TAPE_KIND(tape_form) mean; /* of the first two */
    TAPE_SCALAR kept[TAPE_EXPONENTS];
    int sinh, scaled;
    bool joined, grows; /* grows: its exponents have growths */
};

struct TAPE_KIND(tape) {
    struct TAPE_KIND(tape_entry) step[TAPE_STEPS];
    int steps, rate_steps;
    struct TAPE_KIND(tape_term) term[NUMBER_TERMS];
    int terms;
    struct TAPE_KIND(tape_rate) rate[TAPE_RATES];
    int rates;
    bool used[TAPE_OBSERVABLES][TAPE_STEPS]; /* steps */
    struct TAPE_KIND(tape_form) value[TAPE_VALUES];
};

/* False where it is too long. */
MUST_CHECK bool TAPE_KIND(tape_at)(const struct tape *t,
                                   const TAPE_CONSTANT constant[],
                                   struct TAPE_KIND(tape) * out);

/* Registers at offsets from the anchor, reg[0 .. steps + 1]: those that the
 * chart's rates need (rate 0), all (1), or those of an observable's rate. */
void TAPE_KIND(tape_run)(const struct TAPE_KIND(tape) * t, TAPE_SCALAR x,
                         TAPE_SCALAR y, int rate, TAPE_SCALAR reg[]);

/* A step of the tape, a growth or an apart times e^-s, from the registers
 * before it; not of a scaled one. */
TAPE_SCALAR TAPE_KIND(tape_step)(const struct TAPE_KIND(tape) * t, int step,
                                 TAPE_SCALAR s, const TAPE_SCALAR reg[]);

static inline TAPE_SCALAR TAPE_KIND(tape_linear)(
    const struct TAPE_KIND(tape) * t, const struct TAPE_KIND(tape_form) * u,
    const TAPE_SCALAR r[])
{
    const struct TAPE_KIND(tape_term) *at = &t->term[u->first], *const end =
                                                                    at +
                                                                    u->terms;
    TAPE_SCALAR sum = u->constant;

    for (; at < end; at++)
        sum += at->c * r[at->reg];
    return sum;
}

/* Whether the register is a growth or an apart. */
static inline bool TAPE_KIND(tape_grows)(const struct TAPE_KIND(tape) * t,
                                         int reg)
{
    return reg >= 2 && (t->step[reg - 2].kind == STEP_GROWTH ||
                        t->step[reg - 2].kind == STEP_APART);
}

/* Whether it is a growth that takes a value at the anchor away. */
static inline bool TAPE_KIND(tape_takes)(const struct TAPE_KIND(tape) * t,
                                         int reg)
{
    return reg >= 2 && t->step[reg - 2].kind == STEP_GROWTH &&
           t->step[reg - 2].k > 0;
}

/* What a growth is the logarithm of: ln of k e^u. */
static inline TAPE_SCALAR TAPE_KIND(tape_grown)(const struct TAPE_KIND(tape) *
                                                    t,
                                                int i, const TAPE_SCALAR r[])
{
    const struct TAPE_KIND(tape_entry) *s = &t->step[i];

    return s->b >= 0 ? r[s->b] : s->q + r[s->a];
}

static inline TAPE_SCALAR TAPE_KIND(larger)(TAPE_SCALAR u, TAPE_SCALAR w)
{
    return u > w ? u : w;
}

/* The s of a scaled step. */
static inline TAPE_SCALAR TAPE_KIND(tape_scale)(const struct TAPE_KIND(tape) *
                                                    t,
                                                int i, const TAPE_SCALAR r[])
{
    const struct TAPE_KIND(tape_form) *form = &t->step[i].form;
    TAPE_SCALAR s = 0;

    for (int j = form->first; j < form->first + form->terms; j++) {
        const int g = t->term[j].reg - 2;
        if (!TAPE_KIND(tape_grows)(t, g + 2))
            continue;
        const struct TAPE_KIND(tape_entry) *n = &t->step[g];
        s = TAPE_KIND(larger)(s,
                              n->kind == STEP_GROWTH
                                  ? TAPE_KIND(tape_grown)(t, g, r)
                                  : TAPE_KIND(larger)(r[n->a], r[n->b] + n->q));
    }
    return s;
}

/* Which of its exponents a rate goes by: a growth has taken away all but 1/e of
 * the anchor's value where u < -1. */
static inline int TAPE_KIND(tape_which)(const struct TAPE_KIND(tape) * t, int i,
                                        const TAPE_SCALAR r[])
{
    const struct TAPE_KIND(tape_rate) *p = &t->rate[i];
    const int less = p->sinh >= 0 && r[p->sinh] < 0;
    const struct TAPE_KIND(tape_form) *u = &p->exponent[less + TAPE_NEAR];

    for (int j = u->first; p->grows && j < u->first + u->terms; j++) {
        const int reg = t->term[j].reg;
        if (TAPE_KIND(tape_takes)(t, reg) && r[t->step[reg - 2].a] > -1)
            return less + TAPE_NEAR;
    }
    return less;
}

/* The exponent of a rate, and its mantissa. */
static inline TAPE_SCALAR TAPE_KIND(tape_exponent)(
    const struct TAPE_KIND(tape) * t, int i, const TAPE_SCALAR r[])
{
    const struct TAPE_KIND(tape_rate) *p = &t->rate[i];
    const int k = TAPE_KIND(tape_which)(t, i, r);

    return TAPE_KIND(tape_linear)(t, &p->exponent[k], r) +
           (p->scaled >= 0 ? TAPE_KIND(tape_scale)(t, p->scaled - 2, r) : 0);
}

static inline TAPE_SCALAR TAPE_KIND(tape_mantissa)(
    const struct TAPE_KIND(tape) * t, int i, const TAPE_SCALAR r[])
{
    const struct TAPE_KIND(tape_rate) *p = &t->rate[i];
    const int k = TAPE_KIND(tape_which)(t, i, r);

    return p->kept[k] * TAPE_KIND(tape_linear)(t, &p->mantissa, r);
}
