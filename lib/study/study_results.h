/* study_results.h -- what a study computed, described (result.h): the tables of
 * all that a scene may ask for, in the order in which files hold them. */
#pragma once

#include "result_number.h"
#include "study.h"

/* Bits of result.needs: a stage that ran, a product of the scene. */
#define ASKED_BY(stage)   ((uint64_t) 1 << STAGE_##stage)
#define ASKED_AS(product) ((uint64_t) 1 << (STAGES + PRODUCT_##product))

/* Results whose run is a struct study. */
extern const struct result *const study_tables[];

/* Of cell_rtol and cell_arrest; of shares of the window by fate; of its audit.
 */
extern const struct record_type record_accuracy, record_share, record_audit;

/* fate_names as instances of a result. */
#define FATE_WORDS                                                             \
    "{creep,sliding,rest_finite,rest_asymptotic,runaway,undecided}"

struct results study_results(const struct study *s);

/* The stages that numbers of one slope come from: those that cost little, and
 * whose answers to the inputs are looked at (conditioning.h). */
#define STUDY_NUMBERS                                                          \
    (ASKED_BY(STEADY) | ASKED_BY(FOLDS) | ASKED_BY(CRITICAL) |                 \
     ASKED_BY(KNEES) | ASKED_BY(ESTIMATES))

/* The numbers of a study, by name (result_number.h), that any of these bits
 * asks for.  STATUS_NO_MEMORY leaves *n empty. */
MUST_CHECK enum status study_numbers(struct result_numbers *n, uint64_t bits);

/* Makes what the tables say how to make (result.h), as far as it needs nothing
 * but these stages.  STATUS_NO_MEMORY. */
MUST_CHECK enum status study_keep(struct study *s, uint64_t bits);
