/* lies.h -- laws, found by chance, the bars of which were too small or missing.
 */
#pragma once

#include "drawn.h"

struct lie {
    enum friction_form form;
    enum theta theta;
    enum psi_ss psi_ss;
    enum timescale timescale;
    enum kinetics kinetics;
    long double tan_alpha;
    double mu_star, a, b, c, R, L, V_star;
};

static inline struct draw draw_lie(const struct lie *lie)
{
    struct draw d = { .law = { .preset = "composed",
                               .equation = "",
                               .form = lie->form,
                               .theta = lie->theta,
                               .psi_ss = lie->psi_ss,
                               .timescale = lie->timescale,
                               .kinetics = lie->kinetics },
                      .m = material_bristol_board(),
                      .tan_alpha = lie->tan_alpha };

    d.m.mu_star = lie->mu_star;
    d.m.a = lie->a;
    d.m.b = lie->b;
    d.m.c = lie->c;
    d.m.R = lie->R;
    d.m.L = lie->L;
    d.m.V_star = lie->V_star;
    return d;
}

/* Terms that fall more slowly than the last ones promise. */
static const struct lie lie_slow = {
    FRICTION_LOG,          THETA_LN_PSI,
    PSI_SS_SPINODAL,       TIMESCALE_SLIP45,
    KINETICS_LINEAR,       0.964213307843796437282L,
    0.87282149950100674,   0.0014829935850765421,
    0.020154839655817287,  1e-3,
    176.30256287929842,    0.00044103642234773806,
    4.4159452363176371e-06
};

/* A step past a kink, the series of which is none. */
static const struct lie lie_kink = {
    FRICTION_ASINH,        THETA_PSI,
    PSI_SS_SPINODAL,       TIMESCALE_AGEING44,
    KINETICS_SINH,         0.149915846062127221957L,
    0.10714753708265717,   5.8918871288130952e-05,
    0.0094770623665083407, 0.0,
    228261.25709696827,    3.1091115698576416e-06,
    4.6038575455652215e-07
};

/* An error of psi where a tail begins, which goes on in its integral. */
static const struct lie lie_tail = {
    FRICTION_ASINH,        THETA_LN_C_PSI,
    PSI_SS_SPINODAL,       TIMESCALE_SLIP45,
    KINETICS_LINEAR,       0.701231502536695531418L,
    0.78556884258157234,   2.730975548480436e-05,
    0.020550546327293317,  0.0,
    4297.1058715607842,    1.3983939456076344e-05,
    2.8049869879198623e-05
};

/* A bend of friction beyond which a step's slope fades: at its end it is off by
 * less than by terms that are left out. */
static const struct lie lie_bend = {
    FRICTION_ASINH,        THETA_PSI,
    PSI_SS_SPINODAL,       TIMESCALE_SLIP,
    KINETICS_SINH,         0.757716860785971711299L,
    0.7338495089589987,    0.0077257371272249908,
    0.06237094590677867,   0.024410314884836411,
    1111.7808404991492,    7.9918529793599808e-06,
    1.3215600271972157e-06
};

/* v grows by 1.2e-23 of itself. */
static const struct lie lie_still = {
    FRICTION_ASINH,         THETA_LN_C_1PR_PSI,    PSI_SS_INVERSE,
    TIMESCALE_SPINODAL,     KINETICS_SINH,         0.2553154150204736681L,
    0.31603787763009683,    0.0029552556926671979, 0.012080078352683148,
    2.2507411556556931e-06, 33637941.799149282,    2.430115867308495e-07,
    2.3278187255037038e-05
};

/* A branch that meets v = 0 at psi = -4.66e211, beyond the root of a double. */
static const struct lie lie_far = {
    FRICTION_ASINH,        THETA_PSI,
    PSI_SS_MINUS_LOG,      TIMESCALE_SLIP,
    KINETICS_LINEAR,       0.0899359124374139280928L,
    0.10910940650540076,   0.0013274027724511706,
    0.0029283506392844463, 0.003343742281455263,
    853.83914215558127,    8.4116134970731493e-07,
    1.6845192694703358e-07
};

/* A lower branch whose integral, 6.4e-288, is made of numbers that vanish. */
static const struct lie lie_small = {
    FRICTION_ASINH,         THETA_LN_C_PSI,
    PSI_SS_MINUS_LOG,       TIMESCALE_SLIP45,
    KINETICS_SINH,          0.437953923486861511539L,
    1.0025929650710506,     0.00015317652869261086,
    0.00084997253179943354, 0.0,
    20.389151785401364,     1e-6,
    0.018756463217830078
};
