/* quad_formulas.h -- the rates of a system of formulas in 113 bits, node by
 * node of its graph, in the chart. */
#pragma once

#include "plane_study.h"
#include "quad_way.h"

struct quad_formulas {
    const struct formula_system *system; /* borrowed */
    struct quad_scratch {
        formula_real value[FORMULA_NODES];
        short node[FORMULA_NODES];
        int count;
        int64_t evaluations;
    } * scratch; /* owned */
};

/* What the rates are made of. */
void quad_formulas_needed(const struct formula_system *s,
                          bool needed[FORMULA_NODES]);

/* STATUS_NO_MEMORY. */
MUST_CHECK enum status quad_formulas_init(struct quad_formulas *f,
                                          const struct formula_system *s);

/* Ways of the study's plane; borrows f. */
struct quad_way quad_formulas_way(const struct plane_study *s,
                                  const struct quad_formulas *f);

/* To the equilibrium, settled. */
void quad_formulas_place(struct quad_way *w, const struct plane_rest *r);

/* A second call is harmless. */
void quad_formulas_free(struct quad_formulas *f);
