/*
 * numbers.h -- the numbers of one slope: what the equilibria and the branches
 * of the saddle's stable manifold say of friction, each with its error.
 * Every struct here has a record table (lib/study/records.h) that names its
 * members.
 * Dimensionless; eigenvalues per t* = L/V_star.
 */
#pragma once

#include "block.h"
#include "grow.h"
#include "record.h"

/* One steady state. */
struct steady_number {
    int8_t type; /* enum equilibrium_type */
    struct quantity v, psi, mu;
    struct quantity lambda_minus, lambda_plus;
};

/* Extrema of mu_ss and what follows, (11), (12), (15), (16), and the cusp of
 * Fig 4. */
struct fold_numbers {
    struct quantity alpha_cm, alpha_cM; /* rad, (16) */
    struct quantity v_m, v_M;           /* local minimum, maximum of mu_ss */
    struct quantity mu_s;               /* mu_ss(v_M), (15) */
    struct quantity v_M_eq11, v_m_eq12;
    struct quantity c_cusp, alpha_cusp;
};

struct saddle_numbers {
    struct quantity v, psi, lambda_minus, lambda_plus;
};

enum end_code {
    END_PSI_INF,  /* psi -> inf, v -> v_plus */
    END_OPEN,     /* no limit */
    END_PSI_0,    /* psi -> 0 (-inf), v -> v_minus */
    END_V_0,      /* v -> 0 at psi_at_v0 */
    END_TRUNCATED /* left [1e-300, 1e300], or steps gave out */
};

struct knee_number {
    struct quantity v, psi;
};

enum { KNEES_MAX = 8 };

/* What the stable manifold implies. */
struct critical_numbers {
    int8_t upper_end, lower_end; /* enum end_code; -1: no saddle */
    struct quantity v_plus, ln_v_plus;
    struct quantity v_minus, ln_v_minus, psi_at_v0;
    struct knee_number knee_upper, knee_lower; /* the first ones */
    struct knee_number knees_upper[KNEES_MAX], knees_lower[KNEES_MAX];
    size_t knees_upper_count, knees_lower_count; /* all of them, capped */
    size_t crossings_upper, crossings_lower;     /* of slope 1, falling too */
    struct quantity x_excess, x_deficit;
    struct quantity mu_s_num, mu_s_mean, fracture_energy;
};

/* The steady state at b's anchor, classified as e. */
struct steady_number numbers_steady(const struct block *b,
                                    const struct equilibrium *e);

/* (|ad| + |bc|)/|ad - bc| of the Jacobian [a b; c d]: 10^(digits lost between
 * a, b and b - a), which grows towards a fold. */
double numbers_cancellation(const struct equilibrium *e);

/* Relative uncertainty of v at the steady state of b's anchor: v0 is the double
 * nearest to e^x, and x a long double root of the balance (place.h). */
double numbers_floor(const struct block *b);

/* NULL: there is none. */
struct saddle_numbers numbers_saddle(const struct steady_number *s);

struct fold_numbers numbers_folds(const struct law *law,
                                  const struct material *m);

/* From the two branches, upper (v > v_sp) and lower, with BLOCK_EXCESS as
 * first carried integral.  Knees are left out (numbers_knees adds them). */
struct critical_numbers numbers_critical(const struct block *b,
                                         const struct equilibrium *e,
                                         const struct branch *upper,
                                         const struct branch *lower);
/* The same where the saddle's place is taken as known. */
struct critical_numbers numbers_placed(const struct block *b,
                                       const struct equilibrium *e,
                                       const struct branch *upper,
                                       const struct branch *lower);
/* None of them: there is no saddle; for another reason (static). */
struct critical_numbers numbers_no_critical(void);
struct critical_numbers numbers_none(const char *reason);

void numbers_knees(const struct block *b, const struct planar *sys,
                   const struct branch *upper, const struct branch *lower,
                   struct critical_numbers *out);
