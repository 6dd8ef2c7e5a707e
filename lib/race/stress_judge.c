#include "stress_judge.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "stress_tolerance.h"

const char *const stress_outcome_names[] = { "exact",  "degraded", "none",
                                             "failed", "lie",      NULL };

/* ---- the program's numbers ----------------------------------------------- */

struct stress_answer stress_answer_of(const struct study *s)
{
    const struct critical_numbers *c = &s->slider.critical;
    const struct saddle_numbers *p = &s->saddle_numbers;
    struct stress_answer a = {
        .saddle = slider_saddle(&s->slider) >= 0,
        .upper_end = c->upper_end,
        .lower_end = c->lower_end,
        .number = { [STRESS_V_SP] = p->v,
                    [STRESS_PSI_SP] = p->psi,
                    [STRESS_LAMBDA_MINUS] = p->lambda_minus,
                    [STRESS_LAMBDA_PLUS] = p->lambda_plus,
                    [STRESS_V_PLUS] = c->v_plus,
                    [STRESS_LN_V_PLUS] = c->ln_v_plus,
                    [STRESS_V_MINUS] = c->v_minus,
                    [STRESS_LN_V_MINUS] = c->ln_v_minus,
                    [STRESS_PSI_AT_V0] = c->psi_at_v0,
                    [STRESS_X_EXCESS] = c->x_excess,
                    [STRESS_X_DEFICIT] = c->x_deficit,
                    [STRESS_MU_S_NUM] = c->mu_s_num,
                    [STRESS_MU_S_MEAN] = c->mu_s_mean,
                    [STRESS_FRACTURE_ENERGY] = c->fracture_energy,
                    [STRESS_KNEE_UPPER_V] = c->knee_upper.v,
                    [STRESS_KNEE_UPPER_PSI] = c->knee_upper.psi,
                    [STRESS_KNEE_LOWER_V] = c->knee_lower.v,
                    [STRESS_KNEE_LOWER_PSI] = c->knee_lower.psi },
        .knees[SIDE_UPPER] = { .count = c->knees_upper_count,
                               .crossings = c->crossings_upper },
        .knees[SIDE_LOWER] = { .count = c->knees_lower_count,
                               .crossings = c->crossings_lower },
    };

    memcpy(a.knees[SIDE_UPPER].at, c->knees_upper, sizeof c->knees_upper);
    memcpy(a.knees[SIDE_LOWER].at, c->knees_lower, sizeof c->knees_lower);
    return a;
}

/* ---- digits -------------------------------------------------------------- */

static double digits_of(double part)
{
    return part > 0.0 ? fmin(fmax(-log10(part), 0.0), STRESS_DIGITS)
                      : STRESS_DIGITS;
}

double stress_digits(double value, quad truth)
{
    const quad off = fabsq((quad) value - truth);

    return digits_of(off == 0 ? 0.0 : (double) (off / fabsq(truth)));
}

double stress_digits_allowed(double conditioning)
{
    return digits_of(fmax(conditioning, 0x1p-53));
}

/* ---- one number ---------------------------------------------------------- */

struct judge {
    const struct stress_truth *t;
    const struct stress_answer *a;
    struct stress_verdict *v;
};

/* The worst outcome counts, and the first reason for it. */
static void lower(struct stress_verdict *v, enum stress_outcome outcome,
                  const char *reason)
{
    if (v->reason && outcome <= (enum stress_outcome) v->outcome)
        return;
    v->outcome = (int8_t) outcome;
    v->reason = reason;
}

static void hold(struct judge *j, const char *name, const struct quantity *q,
                 const struct stress_true *t)
{
    static const char lie[] = "a number is further off than its bar";
    static const char unsettled[] = "the oracle is not sure of a number";
    const quad off = fabsq((quad) q->value - t->value);
    struct stress_verdict *v = j->v;

    v->bar = fmax(v->bar, (double) (off / (quad) q->error));
    if (!(off <= (quad) q->error + t->error + (quad) DBL_TRUE_MIN)) {
        lower(v, STRESS_LIE, lie);
        v->worst = name;
    }
    if (!(t->error <= STRESS_SETTLED * (quad) q->error))
        lower(v, STRESS_DEGRADED, unsettled);
}

static void count_digits(struct judge *j, enum stress_number which)
{
    const struct quantity *q = &j->a->number[which];
    struct stress_verdict *v = j->v;
    const double got = stress_digits(q->value, j->t->number[which].value);
    const double allowed = stress_digits_allowed(q->conditioning);
    const double missing = fmax(allowed - got, 0.0);

    v->digits = fmin(v->digits, got);
    if (isnan(q->conditioning))
        return;
    v->allowed = fmin(v->allowed, allowed);
    if (v->missing >= missing) /* false where there is none yet */
        return;
    v->missing = missing;
    if (v->outcome != STRESS_LIE)
        v->worst = stress_number_names[which];
}

static void judge_number(struct judge *j, enum stress_number which)
{
    const bool told = quantity_exists(&j->a->number[which]);

    if (told && j->t->number[which].exists) {
        hold(j, stress_number_names[which], &j->a->number[which],
             &j->t->number[which]);
        count_digits(j, which);
    } else if (told) {
        lower(j->v, STRESS_DEGRADED, "the oracle found no end of a branch");
    } else if (j->t->number[which].exists) {
        lower(j->v, STRESS_DEGRADED, j->a->number[which].reason);
    }
}

/* ---- knees --------------------------------------------------------------- */

static bool is_decided(const struct judge *j, enum side side)
{
    for (size_t i = 0; i < j->a->knees[side].count; i++)
        if (!quantity_exists(&j->a->knees[side].at[i].v))
            return false;
    return true;
}

/* Of one branch: as many crossings, as many of them rising, each in its place.
 * Where the oracle gave up there may be more of them. */
static void judge_knees(struct judge *j, enum side side)
{
    const struct quad_branch *b =
        side == SIDE_UPPER ? &j->t->upper : &j->t->lower;
    const size_t count = j->a->knees[side].count;
    size_t n = 0;

    if (!is_decided(j, side)) {
        lower(j->v, STRESS_DEGRADED, "whether there is a knee is undecided");
        return;
    }
    if (j->a->knees[side].crossings != b->knees.count) {
        const bool whole = b->end != QUAD_TRUNCATED;
        lower(j->v, whole ? STRESS_LIE : STRESS_DEGRADED,
              j->a->knees[side].crossings < b->knees.count
                  ? "a crossing of slope 1 is missing"
                  : "a crossing of slope 1 is invented");
        return;
    }
    for (size_t i = 0; i < b->knees.count && i < QUAD_KNEES; i++) {
        if (!b->knees.at[i].rising)
            continue;
        const struct stress_knee k = stress_truth_knee(j->t, &b->knees.at[i]);
        if (n < count) {
            hold(j, "v of a knee", &j->a->knees[side].at[n].v, &k.v);
            hold(j, "psi of a knee", &j->a->knees[side].at[n].psi, &k.psi);
        }
        n++;
    }
    if (n != count)
        lower(j->v, STRESS_LIE, "a knee is none, or a falling crossing is one");
}

/* ---- the whole ----------------------------------------------------------- */

/* A lower branch that never settles, but by less than a bar, is as good as one
 * that meets v = 0: the oracle then says nothing. */
static void judge_end(struct judge *j, int8_t truth, int8_t told)
{
    if (truth >= 0 && told != truth)
        lower(j->v, STRESS_LIE, "a branch ends otherwise");
    else if (truth < 0 && told != END_TRUNCATED)
        lower(j->v, STRESS_DEGRADED, "the oracle found no end of a branch");
}

static void judge_saddle(struct judge *j, int8_t agreement)
{
    const struct stress_truth *t = j->t;

    judge_end(j, t->upper_end, j->a->upper_end);
    judge_end(j, t->lower_end, j->a->lower_end);
    for (int i = 0; i < STRESS_NUMBERS; i++)
        judge_number(j, (enum stress_number) i);
    judge_knees(j, SIDE_UPPER);
    judge_knees(j, SIDE_LOWER);
    if (j->v->missing > STRESS_MISSING)
        lower(j->v, STRESS_DEGRADED,
              "a number has fewer digits than conditioning allows");
    if (agreement != STRESS_AGREE)
        lower(j->v, STRESS_DEGRADED,
              agreement == STRESS_DISAGREE ? "the two routes disagree"
                                           : "the second route failed");
}

struct stress_verdict stress_judge(const struct stress_truth *t,
                                   const struct stress_answer *a,
                                   int8_t agreement)
{
    struct stress_verdict v = { .outcome = STRESS_EXACT,
                                .digits = STRESS_DIGITS,
                                .allowed = STRESS_DIGITS,
                                .missing = 0.0 };
    struct judge j = { t, a, &v };

    if (t->saddle && a->saddle) {
        judge_saddle(&j, agreement);
        return v;
    }
    v.digits = v.allowed = v.missing = v.bar = (double) NAN;
    if (t->saddle)
        lower(&v, STRESS_LIE, "there is a saddle, and none was found");
    else if (a->saddle)
        lower(&v, STRESS_LIE, "a saddle was found where there is none");
    else
        lower(&v, STRESS_NONE, "there is no saddle at this slope");
    return v;
}
