#include "rest_form.h"

#include <math.h>

/* As v -> 0. */
enum course {
    UNKNOWN,  /* formulas do not tell */
    NEVER,    /* it creeps */
    ENDLESS,  /* as t -> inf, and so does the slip */
    SLOWLY,   /* as t -> inf, in a finite slip */
    SOON,     /* like a line */
    BY_POWER, /* v ~ (t0 - t)^(b/(b - a)) */
    AT_ONCE   /* as fast as inertia lets it */
};

/* psi_ss is as large as v is small, or its logarithm: without a bound. */
static bool grows(const struct law *law, const struct material *m)
{
    return law->psi_ss == PSI_SS_INVERSE || law->psi_ss == PSI_SS_LAMBERT ||
           (law->psi_ss == PSI_SS_SPINODAL && isinf(m->R));
}

/* 1/T has a limit that is not 0: of its terms no power of v is left, where
 * psi_ss is 1/v, or e^psi_ss is. */
static bool is_timed(const struct law *law, const struct material *m)
{
    const struct timescale_terms *t = law_timescale(law);
    const bool is_log = law->psi_ss == PSI_SS_MINUS_LOG;

    return t->ln_v + (isinf(m->R) ? t->ln_r_plus_v : 0) ==
           (is_log ? t->psi_ss : t->ln_psi_ss);
}

/* v ~ t^(-b/a), or exponentially where psi grows so. */
static enum course like_power(const struct material *m, bool exponentially)
{
    return exponentially || m->b > m->a ? SLOWLY : ENDLESS;
}

/* psi_ss ~ 1/v. */
static enum course under_inverse(const struct law *law,
                                 const struct material *m)
{
    const bool is_sinh = law->kinetics == KINETICS_SINH;
    const bool plain = law->theta == THETA_PSI;

    if (!plain && m->b < m->a)
        return NEVER;
    if (law_freezes(law))
        return is_sinh && plain ? like_power(m, false) : ENDLESS;
    if (is_sinh)
        return AT_ONCE;
    if (!is_timed(law, m))
        return like_power(m, plain);
    return plain ? SOON : m->b > m->a ? BY_POWER : SLOWLY;
}

/* psi_ss = -ln v. */
static enum course under_logarithm(const struct law *law,
                                   const struct material *m)
{
    const bool is_sinh = law->kinetics == KINETICS_SINH;

    if (law->theta != THETA_PSI || m->b < m->a)
        return NEVER;
    if (is_timed(law, m))
        return is_sinh && m->b > m->a ? BY_POWER : SLOWLY;
    return is_sinh ? like_power(m, false) : ENDLESS;
}

static enum course course_of(const struct law *law, const struct material *m)
{
    if (law->psi_ss == PSI_SS_MINUS_LOG)
        return under_logarithm(law, m);
    return grows(law, m) ? under_inverse(law, m) : NEVER;
}

static struct rest_form form_of(enum course course, double power)
{
    static const enum fate fate[] = {
        [UNKNOWN] = FATE_UNDECIDED,       [NEVER] = FATE_CREEP,
        [ENDLESS] = FATE_REST_ASYMPTOTIC, [SLOWLY] = FATE_REST_ASYMPTOTIC,
        [SOON] = FATE_REST_FINITE,        [BY_POWER] = FATE_REST_FINITE,
        [AT_ONCE] = FATE_REST_FINITE
    };

    return (struct rest_form){
        .fate = fate[course],
        .reason = course == UNKNOWN ? "how the block stops cannot be told from "
                                      "the formulas of its law"
                  : course == NEVER ? "the block creeps at a rate below the "
                                      "plane's"
                                    : NULL,
        .power = power,
        .inertial = course == AT_ONCE,
        .has_slip = course >= SLOWLY,
    };
}

struct rest_form rest_form_of(const struct law *law, const struct material *m)
{
    const enum course course = course_of(law, m);

    return form_of(course, course == BY_POWER ? m->b / (m->b - m->a) : 1.0);
}

struct rest_form rest_form_at(const struct block *b)
{
    static const enum course typed[] = {
        [BLOCK_UNKNOWN] = UNKNOWN, [BLOCK_NEVER] = NEVER,
        [BLOCK_ENDLESS] = ENDLESS, [BLOCK_SLOWLY] = SLOWLY,
        [BLOCK_SOON] = BY_POWER,   [BLOCK_AT_ONCE] = AT_ONCE
    };

    return b->law.typed ? form_of(typed[b->end.course], b->end.power)
                        : rest_form_of(&b->law, &b->material);
}
