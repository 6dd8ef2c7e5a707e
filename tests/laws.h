/* laws.h -- every legal composition of law components, random materials. */
#pragma once

#include <float.h>
#include <math.h>

#include "check.h"
#include "law.h"

/* theta x psi_ss (but Lambert's) x timescale x kinetics x form, and
 * kato_tullis in both forms. */
enum {
    LAWS_COMPOSED = THETAS * (PSI_SSES - 1) * TIMESCALES * 2,
    LAWS = (LAWS_COMPOSED + 1) * FRICTION_FORMS
};

/* Number i of the LAWS; some of them law_check refuses. */
static inline struct law laws_at(size_t i)
{
    const enum friction_form form = (enum friction_form)(i % FRICTION_FORMS);
    struct law law = { .preset = "composed", .equation = "", .form = form };

    i /= FRICTION_FORMS;
    if (i == LAWS_COMPOSED) {
        law = *law_preset_find("kato_tullis");
        law.form = form;
        return law;
    }
    law.kinetics = (enum kinetics)(i % 2);
    i /= 2;
    law.timescale = (enum timescale)(i % TIMESCALES);
    i /= TIMESCALES;
    law.psi_ss = (enum psi_ss)(i % (PSI_SSES - 1));
    law.theta = (enum theta)(i / (PSI_SSES - 1));
    return law;
}

/* The last bit of a long double, of a double where long double is emulated
 * with fewer digits. */
static inline double laws_long_epsilon(void)
{
    volatile long double one = 1.0L;
    return one + LDBL_EPSILON > one ? (double) LDBL_EPSILON : DBL_EPSILON;
}

/* Those of 113 bits, too, lean on the digits and the range of long double. */
static inline bool laws_emulated(void)
{
    return laws_long_epsilon() > (double) LDBL_EPSILON;
}

static inline double laws_power(uint64_t *state, double lo, double hi)
{
    return pow(10.0, check_uniform(state, lo, hi));
}

/* Wide: a and b within a factor of five of each other, c = 0 and R = inf one
 * time in eight. */
static inline struct material laws_material(uint64_t *state)
{
    struct material m = {
        .mu_star = check_uniform(state, 0.1, 0.9),
        .a = laws_power(state, -3, -0.5),
        .c = laws_power(state, -6, 1),
        .R = laws_power(state, -1, 8),
        .V_c = laws_power(state, -3, 5),
        .L = laws_power(state, -7, -3),
        .V_star = laws_power(state, -8, -3),
        .g = 9.81,
    };
    m.b = m.a * laws_power(state, -0.7, 0.7);
    if (check_bits(state) % 8 == 0)
        m.c = 0.0;
    if (check_bits(state) % 8 == 0)
        m.R = HUGE_VAL;
    return m;
}

/* A law and a material that law_check accepts; false where there is none. */
static inline bool laws_draw(size_t i, uint64_t *state, struct law *law,
                             struct material *m)
{
    struct fault why;

    *law = laws_at(i);
    for (int attempt = 0; attempt < 50; attempt++) {
        *m = laws_material(state);
        if (law_check(law, m, &why) == STATUS_OK)
            return true;
    }
    return false;
}
