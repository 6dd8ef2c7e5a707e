/* estimate_numbers.h -- the paper's estimates (friction/estimates.h) as
 * numbers with errors or reasons. */
#pragma once

#include "numbers.h"

enum { ESTIMATES_XI_MAX = 64 };

struct xi_number {
    double xi;
    struct quantity v_minus, v_plus; /* (38), (39) */
    struct quantity mu_s, G;         /* (41), (32) with that v_plus */
};

struct estimate_numbers {
    struct quantity v_sp0, psi_sp0;                     /* (29) */
    struct quantity x_k, x_k_small_psi, x_k_zero_slope; /* (30), (31) */
    struct quantity mu_s_exact_v_plus;    /* (41) with exact v_plus, saddle */
    struct quantity alpha_f, tan_alpha_f; /* (42); (43) without its misprint */
    struct quantity chi_root[2];          /* (34), all */
    size_t chi_roots;
    struct quantity chi_v_minus, chi_v_plus; /* nearest v_sp0 on its sides */
    struct xi_number xi[ESTIMATES_XI_MAX];
    size_t xi_count;
};

/* `critical`: of the exact computation; its v_plus may be missing. */
struct estimate_numbers numbers_estimates(const struct block *b,
                                          const double xi[], size_t xi_count,
                                          const struct critical_numbers *c);
