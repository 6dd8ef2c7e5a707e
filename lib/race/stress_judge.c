#include "stress_judge.h"

#include <float.h>
#include <math.h>

#include "stress_tolerance.h"

const char *const stress_outcome_names[] = { "exact",  "degraded", "none",
                                             "failed", "lie",      NULL };

/* ---- the program's numbers ----------------------------------------------- */

#define AT_SADDLE(member)                                                      \
    {                                                                          \
        "saddle_" #member, offsetof(struct stress_answer, saddle.member)       \
    }
#define CRITICAL(member)                                                       \
    {                                                                          \
#member, offsetof(struct stress_answer, critical.member)               \
    }
#define KNEE(which, member)                                                    \
    {                                                                          \
        "knee_" #which "_" #member,                                            \
            offsetof(struct stress_answer, critical.knee_##which.member)       \
    }

static const struct {
    const char *name;
    size_t at;
} numbers[STRESS_NUMBERS] = {
    [STRESS_V_SP] = AT_SADDLE(v),
    [STRESS_PSI_SP] = AT_SADDLE(psi),
    [STRESS_LAMBDA_MINUS] = AT_SADDLE(lambda_minus),
    [STRESS_LAMBDA_PLUS] = AT_SADDLE(lambda_plus),
    [STRESS_V_PLUS] = CRITICAL(v_plus),
    [STRESS_LN_V_PLUS] = CRITICAL(ln_v_plus),
    [STRESS_V_MINUS] = CRITICAL(v_minus),
    [STRESS_LN_V_MINUS] = CRITICAL(ln_v_minus),
    [STRESS_PSI_AT_V0] = CRITICAL(psi_at_v0),
    [STRESS_X_EXCESS] = CRITICAL(x_excess),
    [STRESS_X_DEFICIT] = CRITICAL(x_deficit),
    [STRESS_MU_S_NUM] = CRITICAL(mu_s_num),
    [STRESS_MU_S_MEAN] = CRITICAL(mu_s_mean),
    [STRESS_FRACTURE_ENERGY] = CRITICAL(fracture_energy),
    [STRESS_KNEE_UPPER_V] = KNEE(upper, v),
    [STRESS_KNEE_UPPER_PSI] = KNEE(upper, psi),
    [STRESS_KNEE_LOWER_V] = KNEE(lower, v),
    [STRESS_KNEE_LOWER_PSI] = KNEE(lower, psi),
};

const char *stress_number_name(enum stress_number which)
{
    return numbers[which].name;
}

const struct quantity *stress_answer_number(const struct stress_answer *a,
                                            enum stress_number which)
{
    return (const void *) ((const char *) a + numbers[which].at);
}

struct stress_answer stress_answer_of(const struct study *s)
{
    return (struct stress_answer){ slider_saddle(&s->slider) >= 0,
                                   s->saddle_numbers, s->slider.critical };
}

/* ---- digits -------------------------------------------------------------- */

static double digits_of(double part)
{
    return part > 0.0 ? fmin(fmax(-log10(part), 0.0), STRESS_DIGITS)
                      : STRESS_DIGITS;
}

/* Digits of an estimate of `truth`, of conditioning k: 0...STRESS_DIGITS. */
static double stress_digits(double value, quad truth)
{
    const quad off = fabsq((quad) value - truth);

    return digits_of(off == 0 ? 0.0 : (double) (off / fabsq(truth)));
}

static double stress_digits_allowed(double conditioning)
{
    return digits_of(fmax(conditioning, 0x1p-53));
}

/* ---- one number ---------------------------------------------------------- */

struct judge {
    const struct stress_truth *t;
    const struct stress_answer *a;
    struct stress_row *row;
};

/* Of no number in particular. */
static void lower(struct stress_row *row, enum stress_outcome outcome,
                  const char *reason)
{
    stress_row_say(row, (int) outcome, reason, row->worst);
}

static void hold(struct judge *j, const char *name, const struct quantity *q,
                 const struct stress_true *t)
{
    static const char lie[] = "a number is further off than its bar";
    static const char unsettled[] = "the oracle is not sure of a number";
    const quad off = fabsq((quad) q->value - t->value);
    struct stress_row *row = j->row;

    row->bar = fmax(row->bar, (double) (off / (quad) q->error));
    if (!(off <= (quad) q->error + t->error + (quad) DBL_TRUE_MIN))
        stress_row_say(row, STRESS_LIE, lie, name);
    if (!(t->error <= STRESS_SETTLED * (quad) q->error))
        lower(row, STRESS_DEGRADED, unsettled);
}

static void count_digits(struct judge *j, enum stress_number which)
{
    const struct quantity *q = stress_answer_number(j->a, which);
    struct stress_row *row = j->row;
    const double got = stress_digits(q->value, j->t->number[which].value);
    const double allowed = stress_digits_allowed(q->conditioning);
    const double missing = fmax(allowed - got, 0.0);

    row->digits = fmin(row->digits, got);
    if (isnan(q->conditioning))
        return;
    row->allowed = fmin(row->allowed, allowed);
    if (row->missing >= missing) /* false where there is none yet */
        return;
    row->missing = missing;
    if (row->outcome != STRESS_LIE)
        row->worst = stress_number_name(which);
}

static void judge_number(struct judge *j, enum stress_number which)
{
    const struct quantity *q = stress_answer_number(j->a, which);
    const struct stress_true *t = &j->t->number[which];

    if (quantity_exists(q) && t->exists) {
        hold(j, stress_number_name(which), q, t);
        count_digits(j, which);
    } else if (quantity_exists(q)) {
        lower(j->row, STRESS_DEGRADED, "the oracle found no end of a branch");
    } else if (t->exists) {
        lower(j->row, STRESS_DEGRADED, q->reason);
    }
}

/* ---- knees --------------------------------------------------------------- */

static bool is_decided(const struct knee_number knee[], size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!quantity_exists(&knee[i].v))
            return false;
    return true;
}

/* Each rising crossing of a branch is a knee in its place. */
static void judge_places(struct judge *j, const struct quad_knees *truth,
                         const struct knee_number knee[], size_t count)
{
    size_t n = 0;

    for (size_t i = 0; i < truth->count && i < QUAD_KNEES; i++) {
        if (!truth->at[i].rising)
            continue;
        const struct stress_knee k = stress_truth_knee(j->t, &truth->at[i]);
        if (n < count) {
            hold(j, "v of a knee", &knee[n].v, &k.v);
            hold(j, "psi of a knee", &knee[n].psi, &k.psi);
        }
        n++;
    }
    if (n != count)
        lower(j->row, STRESS_LIE,
              "a knee is none, or a falling crossing is one");
}

/* Of one branch: as many crossings, as many of them rising, each in its place.
 * Where the oracle gave up there may be more of them. */
static void judge_knees(struct judge *j, const struct quad_branch *b,
                        const struct knee_number knee[], size_t count,
                        size_t crossings)
{
    if (!is_decided(knee, count))
        lower(j->row, STRESS_DEGRADED, "whether there is a knee is undecided");
    else if (crossings != b->knees.count)
        lower(j->row, b->end != QUAD_TRUNCATED ? STRESS_LIE : STRESS_DEGRADED,
              crossings < b->knees.count ? "a crossing of slope 1 is missing"
                                         : "a crossing of slope 1 is invented");
    else
        judge_places(j, &b->knees, knee, count);
}

/* ---- the whole ----------------------------------------------------------- */

/* A lower branch that never settles, but by less than a bar, is as good as one
 * that meets v = 0: the oracle then says nothing. */
static void judge_end(struct judge *j, int8_t truth, int8_t told)
{
    if (truth >= 0 && told != truth)
        lower(j->row, STRESS_LIE, "a branch ends otherwise");
    else if (truth < 0 && told != END_TRUNCATED)
        lower(j->row, STRESS_DEGRADED, "the oracle found no end of a branch");
}

static void judge_saddle(struct judge *j)
{
    const struct stress_truth *t = j->t;
    const struct critical_numbers *c = &j->a->critical;
    struct stress_row *row = j->row;

    row->digits = row->allowed = STRESS_DIGITS;
    row->missing = row->bar = 0.0;
    judge_end(j, t->upper_end, c->upper_end);
    judge_end(j, t->lower_end, c->lower_end);
    for (int i = 0; i < STRESS_NUMBERS; i++)
        judge_number(j, (enum stress_number) i);
    judge_knees(j, &t->upper, c->knees_upper, c->knees_upper_count,
                c->crossings_upper);
    judge_knees(j, &t->lower, c->knees_lower, c->knees_lower_count,
                c->crossings_lower);
    if (row->missing > STRESS_MISSING)
        lower(row, STRESS_DEGRADED,
              "a number has fewer digits than conditioning allows");
}

void stress_judge(const struct stress_truth *t, const struct stress_answer *a,
                  struct stress_row *row)
{
    struct judge j = { t, a, row };

    if (t->saddle && a->has_saddle)
        judge_saddle(&j);
    else if (t->saddle)
        lower(row, STRESS_LIE, "there is a saddle, and none was found");
    else if (a->has_saddle)
        lower(row, STRESS_LIE, "a saddle was found where there is none");
    else
        lower(row, STRESS_NONE, "there is no saddle at this slope");
}
