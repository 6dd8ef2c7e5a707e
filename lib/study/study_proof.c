#include "study_proof.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "interval_math.h"
#include "proof_fold.h"
#include "proof_units.h"
#include "study.h"

/* A number of the saddle, of its manifold, or of a knee, by what name, and
 * which of PROOF_NUMBERS. */
struct pair {
    const struct record_field *field;
    const char *of;
    struct quantity *number;
    size_t which;
};

static size_t which_is(const char *name)
{
    size_t i = 0;

    while (i < PROOF_NAMED && strcmp(proof_number_names[i], name) != 0)
        i++;
    return i;
}

static struct quantity *member(void *record, const struct record_field *f)
{
    return (void *) ((char *) record + f->offset);
}

static size_t named_pairs(struct study *s, struct pair out[])
{
    const struct record_type *const type[] = { &record_saddle,
                                               &record_critical };
    void *const at[] = { &s->saddle_numbers, &s->slider.critical };
    size_t n = 0;

    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < type[k]->count; i++) {
            const struct record_field *f = &type[k]->fields[i];
            const size_t which = which_is(f->name);
            if (which < PROOF_NAMED)
                out[n++] = (struct pair){ f, k ? "" : "saddle.",
                                          member(at[k], f), which };
        }
    return n;
}

static size_t knee_pairs(struct knee_number *k, size_t side, size_t which,
                         struct pair out[])
{
    for (size_t i = 0; i < record_knee.count; i++)
        out[i] =
            (struct pair){ &record_knee.fields[i],
                           side ? "knee_lower." : "knee_upper.",
                           member(k, &record_knee.fields[i]),
                           PROOF_NAMED + 2 * (side * KNEES_MAX + which) + i };
    return record_knee.count;
}

/* The first one of a branch by its own name, too. */
static size_t branch_pairs(struct study *s, size_t side, struct pair out[])
{
    struct critical_numbers *c = &s->slider.critical;
    struct knee_number *all = side ? c->knees_lower : c->knees_upper;
    const size_t count = side ? c->knees_lower_count : c->knees_upper_count;
    size_t n = knee_pairs(side ? &c->knee_lower : &c->knee_upper, side, 0, out);

    for (size_t k = 0; k < count; k++)
        n += knee_pairs(&all[k], side, k, out + n);
    return n;
}

/* How many. */
static size_t pairs_of(struct study *s, struct pair out[STUDY_PROOFS])
{
    size_t n = named_pairs(s, out);

    for (size_t side = 0; side < 2; side++)
        n += branch_pairs(s, side, out + n);
    return n;
}

struct proof_inputs study_proof_inputs(const struct scene *scene)
{
    return (struct proof_inputs){ .decimal = true,
                                  .slope_in = scene->slope_in,
                                  .slope = scene->slope_given };
}

/* Of the saddle and of the branches that are not skipped. */
static enum status find(const struct study *s, bool decimal, const bool skip[2],
                        struct proof *out)
{
    struct proof_inputs in = study_proof_inputs(s->scene);

    in.decimal = decimal;
    memcpy(in.skip, skip, sizeof in.skip);
    if (plan_has(s->stages, STAGE_BASINS))
        in.far = &s->scene->window.psi[1];
    return proof_at(&s->slider.block, &in, out);
}

enum status study_prove_doubles(const struct study *s, struct proof *out)
{
    return find(s, false, (const bool[2]){ false }, out);
}

/* Whether the bar is beside what is proved, or there is a number where none is
 * proved to be, or none where one is. */
static bool contradicts(const struct quantity *q, const struct proof_number *p)
{
    if (p->not_proved)
        return p->absent && quantity_exists(q);
    return quantity_exists(q) && !(q->value - q->error <= p->value.hi &&
                                   p->value.lo <= q->value + q->error);
}

static struct proved outcome(const struct proof_number *p,
                             struct interval_double value)
{
    if (p->not_proved)
        return (struct proved){ .absent = p->absent,
                                .not_proved =
                                    p->absent ? NULL : p->not_proved };
    return (struct proved){ .lo = value.lo, .hi = value.hi };
}

static void tell(struct study_proof *k, const struct pair *pair,
                 const struct proof_numbers *n, const struct proof_units *units)
{
    const struct proof_number *p = &n->at[pair->which];
    struct proved *out = k->of[k->count++];

    out[0] = outcome(p, p->value);
    out[1] = outcome(p, proof_in_si(units, pair->field->unit, p->value));
    pair->number->proved = out;
}

/* Of numbers that there are none of without a saddle. */
static void tell_none(struct study *s, const struct pair pair[], size_t n)
{
    const struct proof_inputs in = study_proof_inputs(s->scene);
    double window[2];
    const struct proof_number none = {
        .absent =
            proof_no_saddle(&s->scene->law, &s->scene->material, &in, window),
        .not_proved = "that there is no saddle was not proved",
    };

    for (size_t i = 0; i < n; i++) {
        struct proved *out = s->proof.of[s->proof.count++];
        out[0] = out[1] = outcome(&none, none.value);
        pair[i].number->proved = out;
    }
}

/* The numbers, some of which are beside, again with the doubles themselves:
 * rounding the inputs may have moved them. */
static enum status judge(struct study *s, const struct pair pair[], size_t n,
                         const bool skip[2])
{
    struct proof exact;
    enum status status = find(s, false, skip, &exact);

    if (status == STATUS_OK) {
        const struct proof_numbers numbers = proof_numbers_of(&exact);
        for (size_t i = 0; i < n && s->proof.lie.text[0] == '\0'; i++)
            if (contradicts(pair[i].number, &numbers.at[pair[i].which]))
                snprintf(s->proof.lie.text, sizeof s->proof.lie.text,
                         "%s%s: " PROVED_LIE, pair[i].of, pair[i].field->name);
    }
    proof_free(&exact);
    return status;
}

/* To the bar, which is of the doubles, what reading the decimals costs: it
 * holds all that is proved of these, as texts of 17 digits, too. */
static void reach(struct quantity *q, const struct proof_number *p)
{
    const struct interval told = { nextafter(p->value.lo, -HUGE_VAL),
                                   nextafter(p->value.hi, HUGE_VAL) };
    const struct interval off = interval_less(told, interval_point(q->value));

    if (quantity_exists(q) && !p->not_proved)
        q->error = fmax(q->error, interval_up(interval_most(off)));
}

/* A copy of a saddle's number has its proof and its bar, too. */
static void copy_to_steady(struct study *s)
{
    struct steady_number *to = &s->slider.steady[slider_saddle(&s->slider)];

    to->v = s->saddle_numbers.v;
    to->psi = s->saddle_numbers.psi;
    to->lambda_minus = s->saddle_numbers.lambda_minus;
    to->lambda_plus = s->saddle_numbers.lambda_plus;
}

enum status study_prove(struct study *s)
{
    struct pair pair[STUDY_PROOFS];
    const size_t n = pairs_of(s, pair);
    bool beside = false, skip[2] = { false };

    if (slider_saddle(&s->slider) < 0) {
        tell_none(s, pair, n);
        return STATUS_OK;
    }
    struct proof *proof = s->proof.exact = malloc(sizeof *proof);
    if (proof == NULL)
        return STATUS_NO_MEMORY;
    enum status status = find(s, true, skip, proof);
    if (status != STATUS_OK)
        return status;
    const struct proof_numbers numbers = proof_numbers_of(proof);
    const struct proof_units units =
        proof_units_of(&s->scene->law, &s->scene->material);
    skip[0] = skip[1] = true;
    for (size_t i = 0; i < n; i++) {
        const int side = proof_number_side(pair[i].which);
        tell(&s->proof, &pair[i], &numbers, &units);
        if (!contradicts(pair[i].number, &numbers.at[pair[i].which]))
            continue;
        beside = true;
        if (side >= 0)
            skip[side] = false;
    }
    if (beside)
        status = judge(s, pair, n, skip);
    for (size_t i = 0; i < n && s->proof.lie.text[0] == '\0'; i++)
        reach(pair[i].number, &numbers.at[pair[i].which]);
    copy_to_steady(s);
    return status;
}

bool study_proves(const struct record_type *type)
{
    return type == &record_saddle || type == &record_critical ||
           type == &record_knee;
}

void study_proof_withdraw(struct study_proof *p)
{
    for (size_t i = 0; i < p->count && p->lie.text[0]; i++)
        p->of[i][0] = p->of[i][1] =
            (struct proved){ .not_proved = p->lie.text };
}

void study_proof_free(struct study_proof *p)
{
    if (p->exact)
        proof_free(p->exact);
    free(p->exact);
    p->exact = NULL;
}
