/*
 * number_tape.h -- a tape (tape.h) whose constants are numbers, for one type:
 * the including file defines TAPE_SCALAR, TAPE_CONSTANT, that constants come
 * in, and TAPE_KIND(f), the name of f for it.  Steps that nothing needs are
 * left out; the first `rate_steps` are all that the rates of the chart need.
 */
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
    bool joined;
};

struct TAPE_KIND(tape) {
    struct TAPE_KIND(tape_entry) step[TAPE_STEPS];
    int steps, rate_steps;
    struct {
        int reg;
        TAPE_SCALAR c;
    } term[NUMBER_TERMS];
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

/* The s of a scaled step. */
TAPE_SCALAR TAPE_KIND(tape_scale)(const struct TAPE_KIND(tape) * t, int step,
                                  const TAPE_SCALAR reg[]);

TAPE_SCALAR TAPE_KIND(tape_linear)(const struct TAPE_KIND(tape) * t,
                                   const struct TAPE_KIND(tape_form) * u,
                                   const TAPE_SCALAR reg[]);

/* Which of its exponents a rate goes by. */
int TAPE_KIND(tape_which)(const struct TAPE_KIND(tape) * t, int rate,
                          const TAPE_SCALAR reg[]);

/* The exponent of a rate, and its mantissa. */
TAPE_SCALAR TAPE_KIND(tape_exponent)(const struct TAPE_KIND(tape) * t, int rate,
                                     const TAPE_SCALAR reg[]);
TAPE_SCALAR TAPE_KIND(tape_mantissa)(const struct TAPE_KIND(tape) * t, int rate,
                                     const TAPE_SCALAR reg[]);

/* What a growth is the logarithm of: ln of k e^u. */
TAPE_SCALAR TAPE_KIND(tape_grown)(const struct TAPE_KIND(tape) * t, int step,
                                  const TAPE_SCALAR reg[]);

/* Whether the register is a growth or an apart. */
bool TAPE_KIND(tape_grows)(const struct TAPE_KIND(tape) * t, int reg);
