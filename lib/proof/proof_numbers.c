#include "proof_numbers.h"

#include <assert.h>

#include "interval_math.h"

const char *const proof_number_names[PROOF_NAMED] = {
    "v",         "psi",      "lambda_minus", "lambda_plus",    "v_plus",
    "ln_v_plus", "v_minus",  "ln_v_minus",   "psi_at_v0",      "x_excess",
    "x_deficit", "mu_s_num", "mu_s_mean",    "fracture_energy"
};
static_assert(sizeof(struct proof_numbers) ==
                  PROOF_NUMBERS * sizeof(struct proof_number),
              "none but numbers");

static_assert((int) PROOF_KNEES_MAX == (int) KNEES_MAX, "as many as are told");

static const char not_so[] = "the branch ends otherwise, which is proved";

static struct proof_number none(const char *why)
{
    return (struct proof_number){ { 0, 0 }, why, why == not_so };
}

static struct proof_number some(struct interval value)
{
    if (!interval_is_finite(value))
        return none("its enclosure is not finite");
    return (struct proof_number){ interval_outward(value), NULL, false };
}

/* Why what belongs to this end of the branch is not there; NULL: it is. */
static const char *missing(const struct proof *p, const struct proof_branch *b,
                           enum end_code end)
{
    return p->not_proved.text[0] ? p->not_proved.text
           : b->not_proved       ? b->not_proved
           : b->end != (int) end ? not_so
                                 : NULL;
}

/* v = v_sp e^X, and psi = psi_sp e^Y or psi_sp + Y. */
static struct interval v_at(const struct proof *p, struct interval X)
{
    return interval_times(p->law.v, interval_exp(X));
}

static struct interval psi_at(const struct proof *p, struct interval Y)
{
    return p->law.is_log ? interval_add(p->law.psi, Y)
                         : interval_times(p->law.psi, interval_exp(Y));
}

static void of_saddle(const struct proof *p, struct proof_numbers *out)
{
    if (p->not_proved.text[0]) {
        out->v = out->psi = out->lambda_minus = out->lambda_plus =
            none(p->not_proved.text);
        return;
    }
    out->v = some(p->law.v);
    out->psi = some(p->law.psi);
    out->lambda_minus = some(p->saddle.lambda_minus);
    out->lambda_plus = some(p->saddle.lambda_plus);
}

/* G = eps^2 (v_plus^2 - v^2)/(2 cos(alpha)), with F = cos(alpha)/eps^2. */
static void of_upper(const struct proof *p, struct proof_numbers *out)
{
    const struct proof_branch *b = &p->branch[0];
    const char *why = missing(p, b, END_PSI_INF);

    out->v_plus = out->ln_v_plus = out->x_excess = none(why);
    out->mu_s_num = out->mu_s_mean = out->fracture_energy = none(why);
    if (why)
        return;
    const struct interval X = b->place, v = p->law.v;
    const struct interval part = interval_divide(
        interval_times(v, v), interval_times(interval_point(2), p->law.force));
    const struct interval rise = interval_expm1(X);
    const struct interval energy = interval_times(
        part, interval_expm1(interval_times(interval_point(2), X)));
    const struct interval mean =
        interval_times(part, interval_times(rise, rise));

    out->v_plus = some(v_at(p, X));
    out->ln_v_plus = some(interval_add(p->law.x, X));
    out->x_excess = some(b->excess);
    out->fracture_energy = some(energy);
    out->mu_s_num = some(
        interval_add(p->law.tan_alpha, interval_divide(energy, b->excess)));
    out->mu_s_mean =
        some(interval_add(p->law.tan_alpha, interval_divide(mean, b->excess)));
}

static void of_lower(const struct proof *p, struct proof_numbers *out)
{
    const struct proof_branch *b = &p->branch[1];
    const char *why = missing(p, b, END_PSI_0);
    const char *none_at_0 = missing(p, b, END_V_0);

    out->v_minus = out->ln_v_minus = none(why);
    out->psi_at_v0 = none(none_at_0);
    out->x_deficit = none(why && none_at_0 ? why : NULL);
    if (why == NULL) {
        out->v_minus = some(v_at(p, b->place));
        out->ln_v_minus = some(interval_add(p->law.x, b->place));
    }
    if (none_at_0 == NULL)
        out->psi_at_v0 = some(psi_at(p, b->place));
    if (why == NULL || none_at_0 == NULL)
        out->x_deficit = some(b->excess);
}

static void of_knees(const struct proof *p, struct proof_numbers *out)
{
    for (size_t i = 0; i < 2 * KNEES_MAX; i++) {
        const size_t side = i / KNEES_MAX, k = i % KNEES_MAX;
        const struct proof_branch *b = &p->branch[side];
        const char *why = p->not_proved.text[0] ? p->not_proved.text
                          : b->no_more          ? b->no_more
                                                : not_so;
        const bool there = k < b->knees && !p->not_proved.text[0];
        out->knee[side][k].v = there ? some(v_at(p, b->knee[k].X)) : none(why);
        out->knee[side][k].psi =
            there ? some(psi_at(p, b->knee[k].Y)) : none(why);
    }
}

int proof_number_side(size_t which)
{
    static const signed char side[PROOF_NAMED] = { -1, -1, -1, -1, 0, 0, 1,
                                                   1,  1,  0,  1,  0, 0, 0 };

    return which < PROOF_NAMED ? side[which]
                               : (int) ((which - PROOF_NAMED) / 2 / KNEES_MAX);
}

struct proof_numbers proof_numbers_of(const struct proof *p)
{
    struct proof_numbers out;

    of_saddle(p, &out);
    of_upper(p, &out);
    of_lower(p, &out);
    of_knees(p, &out);
    return out;
}
