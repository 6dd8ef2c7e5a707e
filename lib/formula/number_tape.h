/*
 * number_tape.h -- a tape (tape.h) whose constants are numbers, for one type:
 * the including file defines SCALAR and KIND(f), the name of f for it.  Steps
 * that nothing needs are left out; the first `rate_steps` are all that the
 * rates of the chart need.
 */
struct KIND(tape_form) {
    SCALAR constant;
    int first, terms; /* in term[] of the tape */
};

struct KIND(tape_entry) {
    enum step_kind kind;
    int a, b;
    SCALAR k, q;
    struct KIND(tape_form) form;
};

/* A rate times kept[] exp(..): what rounding took from the exponent's constant,
 * which may be hundreds. */
struct KIND(tape_rate) {
    struct KIND(tape_form) mantissa, exponent[2], mean; /* of the two */
    SCALAR kept[2], mean_kept;
    int sinh, scaled;
    bool joined;
};

struct KIND(tape) {
    struct KIND(tape_entry) step[TAPE_STEPS];
    int steps, rate_steps;
    struct {
        int reg;
        SCALAR c;
    } term[NUMBER_TERMS];
    int terms;
    struct KIND(tape_rate) rate[TAPE_RATES];
    int rates;
    struct KIND(tape_form) value[TAPE_VALUES];
};

/* False where it is too long. */
MUST_CHECK bool KIND(tape_at)(const struct tape *t,
                              const formula_real constant[],
                              struct KIND(tape) * out);

/* All registers at offsets from the anchor, or those that the chart's rates
 * need: reg[0 .. steps + 1]. */
void KIND(tape_run)(const struct KIND(tape) * t, SCALAR x, SCALAR y,
                    bool everything, SCALAR reg[]);

/* A step of the tape, a growth or an apart times e^-s, from the registers
 * before it; not of a scaled one. */
SCALAR KIND(tape_step)(const struct KIND(tape) * t, int step, SCALAR s,
                       const SCALAR reg[]);

/* The s of a scaled step. */
SCALAR KIND(tape_scale)(const struct KIND(tape) * t, int step,
                        const SCALAR reg[]);

SCALAR KIND(tape_linear)(const struct KIND(tape) * t,
                         const struct KIND(tape_form) * u, const SCALAR reg[]);

/* The exponent of a rate, and its mantissa. */
SCALAR KIND(tape_exponent)(const struct KIND(tape) * t, int rate,
                           const SCALAR reg[]);
SCALAR KIND(tape_mantissa)(const struct KIND(tape) * t, int rate,
                           const SCALAR reg[]);

/* What a growth is the logarithm of: ln of k e^u. */
SCALAR KIND(tape_grown)(const struct KIND(tape) * t, int step,
                        const SCALAR reg[]);

/* Whether the register is a growth or an apart. */
bool KIND(tape_grows)(const struct KIND(tape) * t, int reg);
