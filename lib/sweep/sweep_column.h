/*
 * sweep_column.h -- what a sweep keeps of each point as a number, or as a few
 * of them along one or two dimensions (sweep_dim.h): the entries of a column.
 *
 * A column is named like its place in `knees --json`, with underscores for
 * dots and brackets: v_plus, ln_v_plus, mu_s_num, upper_end; saddle_v,
 * folds_alpha_cM, knee_upper_psi, equilibria_0_v, equilibria_0_type,
 * estimates_x_k, estimates_chi_v_plus, estimates_xi_0_v_plus,
 * sensitivities_v_plus_alpha, taylor_series_radius.  By product:
 *
 *   equilibria     creep_ln_v, saddle_ln_psi, sliding_lambda_plus, ...
 *   basins         basin_fraction_log_creep, basin_audit_cells, ...
 *   trajectories   along `start`: trajectory_fate, trajectory_time,
 *                  trajectory_rest_slip, trajectory_psi_minimum_psi, ...;
 *                  along `start` and `phase`: trajectory_phase_end_slip, ...;
 *                  along `start` and `level`: trajectory_mu_nears_time, ...
 *   taylor_series  along `order`: taylor_series_coefficient
 *   chi            along `chi_alpha`: chi_v_low, ...
 *
 * with accuracy.proved v_plus_lo, v_plus_hi, ... of the saddle's and the
 * manifold's numbers, and rabinowicz_l_k, ... of a scene with an experiment.
 * The steady states by number come last.
 */
#pragma once

#include "result_number.h"
#include "sweep_dim.h"
#include "sweep_point.h"

struct sweep_column {
    char name[64];
    char text[160]; /* long_name */
    const char *unit;
    const char *const *codes;    /* words of a code; NULL: a quantity */
    enum record_kind kind;       /* of the member; REAL and COUNT are exact */
    struct result_number number; /* of the first entry */
    size_t names; /* of its result, which is one of sweep_results.h; 0: one of
                     the study's */
    size_t inner; /* entries along its result's records */

    enum sweep_dim dim[SWEEP_RANK];
    size_t dims;
    size_t first, entries; /* among all entries of a point */
};

struct sweep_columns {
    struct sweep_column *at; /* owned */
    size_t count, room;
    struct plane_study *frame; /* owned: whose results' columns these are; NULL:
                                  a law's */
    size_t entries;            /* of all columns */
    bool conditioning; /* of the quantities, where the scene asks for it */
    bool proved;       /* with columns for what is proved, likewise */
};

/* The columns that the scene's products give; d: their dimensions.
 * STATUS_NO_MEMORY leaves *c empty. */
MUST_CHECK enum status sweep_columns_init(struct sweep_columns *c,
                                          const struct scene *scene,
                                          const struct sweep_dims *d);

/* A second call is harmless. */
void sweep_columns_free(struct sweep_columns *c);

/* An entry of a column at a point: where it has no words, and where it has. */
struct quantity sweep_column_quantity(const struct sweep_column *c,
                                      const struct sweep_point *p,
                                      size_t entry);
int8_t sweep_column_code(const struct sweep_column *c,
                         const struct sweep_point *p, size_t entry);
