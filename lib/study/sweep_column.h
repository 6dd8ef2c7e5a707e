/*
 * sweep_column.h -- what a sweep keeps of a study: every scalar of the scene's
 * products, flat.
 *
 * A column is named like its place in `knees --json`, with underscores for
 * dots and brackets: v_plus, ln_v_plus, mu_s_num, upper_end; saddle_v,
 * folds_alpha_cM, knee_upper_psi, equilibria_0_v, equilibria_0_type,
 * estimates_x_k, estimates_chi_v_plus, estimates_xi_0_v_plus,
 * sensitivities_v_plus_alpha.  The steady states come last.
 */
#ifndef STUDY_SWEEP_COLUMN_H
#define STUDY_SWEEP_COLUMN_H

#include "study.h"

struct sweep_column {
    char name[64];
    char text[160]; /* long_name */
    const char *unit;
    const char *const *codes; /* words of a code; NULL: a quantity */
    size_t offset;            /* of the member in struct study */
};

struct sweep_columns {
    struct sweep_column *at; /* owned */
    size_t count, room;
    bool conditioning; /* of the quantities, where the scene asks for it */
};

/* The columns that the scene's products give.  STATUS_NO_MEMORY leaves *c
 * empty. */
MUST_CHECK enum status sweep_columns_init(struct sweep_columns *c,
                                          const struct scene *scene);

/* A second call is harmless. */
void sweep_columns_free(struct sweep_columns *c);

/* Fills the steady states that a study does not have, which are columns all
 * the same, with the reason. */
void sweep_columns_complete(struct study *s);

/* A column of a study: where it has no words, and where it has. */
struct quantity sweep_column_quantity(const struct sweep_column *c,
                                      const struct study *s);
int8_t sweep_column_code(const struct sweep_column *c, const struct study *s);

#endif
