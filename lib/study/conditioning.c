/*
 * One input at a time is multiplied by 1 - h and 1 + h (neighbours.h).  L,
 * V_star and g enter through eps^2 = V_star^2/(g L) alone: moving g speaks for
 * all three.
 */
#include "conditioning.h"

#include <math.h>

#include "law_typed.h"
#include "neighbours.h"
#include "scene_slope.h"
#include "study.h"
#include "study_results.h"
#include "study_tolerance.h"

enum {
    INPUT_ALPHA = MATERIAL_KEYS,
    INPUT_OWN, /* names of the law's own */
    INPUTS = INPUT_OWN + LAW_OWNS
};

/* Multiplies one input by 1 + nudge. */
static bool multiply(const void *ctx, double nudge, struct scene *c)
{
    const int input = *(const int *) ctx;
    const double factor = 1.0 + nudge;

    if (input == INPUT_ALPHA) {
        c->alpha *= factor;
        c->tan_alpha = tanl((long double) c->alpha);
    } else if (input >= INPUT_OWN) {
        c->material.own[input - INPUT_OWN] *= factor;
    } else {
        *material_member(&c->material, (enum material_key) input) *= factor;
    }
    return input != INPUT_ALPHA || c->alpha < M_PI_2;
}

/* A slope given by its tangent has one that is a double, and an angle whose
 * tangent is another. */
static bool given_by_tangent(const struct scene *c)
{
    return c->tan_alpha == (long double) (double) c->tan_alpha &&
           c->tan_alpha != tanl((long double) c->alpha);
}

/* Whole exponents are exact. */
static double own_weight(const struct law *law, const double own[], int i)
{
    return own[i] == 0.0 ||
                   (law->typed->own[i].exponent && floor(own[i]) >= own[i])
               ? 0.0
               : 1.0;
}

/* How often the rounding of an input counts. */
static double weight_of(const struct scene *c, int input)
{
    const enum material_key key = (enum material_key) input;
    const double t = (double) c->tan_alpha;
    struct material m = c->material;

    if (input == INPUT_ALPHA && !scene_has_slope(c))
        return 0.0;
    if (input == INPUT_ALPHA) /* d ln alpha/d ln tan(alpha) */
        return given_by_tangent(c) ? t / ((1.0 + t * t) * c->alpha) : 1.0;
    if (input >= INPUT_OWN)
        return own_weight(&c->law, m.own, input - INPUT_OWN);
    const double value = *material_member(&m, key);
    if (key == MATERIAL_L || key == MATERIAL_V_STAR || value == 0.0 ||
        !isfinite(value) || !law_uses(&c->law, key))
        return 0.0;
    return key == MATERIAL_G ? 4.0 : 1.0;
}

/* ---- the second opinion on sensitivities -------------------------------- */

static const struct {
    enum parameter parameter;
    int input;
} same[] = { { PARAMETER_ALPHA, INPUT_ALPHA },
             { PARAMETER_A, MATERIAL_A },
             { PARAMETER_B, MATERIAL_B },
             { PARAMETER_C, MATERIAL_C },
             { PARAMETER_R, MATERIAL_R },
             { PARAMETER_EPS2, MATERIAL_G },
             { PARAMETER_MU_STAR, MATERIAL_MU_STAR } };

/* Where d ln v/d ln p = rate contradicts *exact, the bar says so. */
static void hold_against(struct quantity *exact, double p, double rate)
{
    const double off = fabs(exact->value - rate / p);
    const double trust = TOL_LITTLE * (1.0 + fabs(rate)) / fabs(p);

    if (quantity_exists(exact) && off > exact->error + trust)
        exact->error = off;
}

static void hold_all(const struct neighbours *f, int input,
                     const struct neighbour_rate rate[],
                     struct sensitivities *exact)
{
    const struct scene *c = f->s->scene;
    struct material m = c->material;

    for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
        const enum parameter which = same[k].parameter;
        if (same[k].input != input)
            continue;
        const double p = which == PARAMETER_ALPHA ? c->alpha
                         : which == PARAMETER_EPS2
                             ? -material_eps2(&m) /* ~ 1/g */
                             : *material_member(&m, (enum material_key) input);
        for (size_t i = 0; i < f->numbers.count; i++) {
            const struct quantity *q = f->numbers.at[i];
            if (rate[i].settled && q == &f->s->slider.critical.ln_v_plus)
                hold_against(&exact->v_plus.by[which], p, rate[i].own);
            if (rate[i].settled && q == &f->s->slider.critical.ln_v_minus)
                hold_against(&exact->v_minus.by[which], p, rate[i].own);
        }
    }
}

/* ---- all inputs --------------------------------------------------------- */

static enum status add_input(struct neighbours *f, int input, double weight,
                             struct sensitivities *exact)
{
    struct neighbour_rate rate[NEIGHBOUR_NUMBERS];
    const enum status status = neighbours_rates(f, multiply, &input, rate);

    if (status != STATUS_OK)
        return status;
    for (size_t i = 0; i < f->numbers.count; i++) {
        struct quantity *q = f->numbers.at[i];
        if (quantity_exists(q) && q->value != 0.0)
            q->conditioning += weight * 0x1p-53 * fabs(rate[i].own / q->value);
    }
    hold_all(f, input, rate, exact);
    return STATUS_OK;
}

static enum status add_inputs(struct neighbours *f,
                              const struct monitor *monitor,
                              struct sensitivities *exact)
{
    enum status status = STATUS_OK;

    if (!f->same)
        return status; /* at a loose rtol knees may come and go */
    for (size_t i = 0; i < f->numbers.count; i++)
        if (quantity_exists(f->numbers.at[i]))
            f->numbers.at[i]->conditioning = 0.0;
    for (int input = 0; input < INPUTS && status == STATUS_OK; input++) {
        const double weight = weight_of(f->s->scene, input);
        if (monitor_tell(monitor, "sensitivities", (uint64_t) input, INPUTS))
            return STATUS_STOPPED;
        if (weight > 0.0)
            status = add_input(f, input, weight, exact);
    }
    return status;
}

enum status conditioning_find(struct study *s, const struct monitor *monitor,
                              struct sensitivities *exact, size_t *evaluations)
{
    struct neighbours f;
    enum status status = neighbours_init(&f, s, STUDY_NUMBERS);

    if (status == STATUS_OK)
        status = add_inputs(&f, monitor, exact);
    *evaluations += f.evaluations;
    neighbours_free(&f);
    return status;
}
