/* study_results.h -- what a study computed, described (result.h): the tables of
 * all that a scene may ask for, in the order in which files hold them. */
#ifndef STUDY_STUDY_RESULTS_H
#define STUDY_STUDY_RESULTS_H

#include "result.h"
#include "study.h"

/* Bits of result.needs: a stage that ran, a product of the scene. */
#define ASKED_BY(stage)   ((uint64_t) 1 << STAGE_##stage)
#define ASKED_AS(product) ((uint64_t) 1 << (STAGES + PRODUCT_##product))

/* Results whose run is a struct study. */
extern const struct result *const study_tables[];

/* Of cell_rtol and cell_arrest. */
extern const struct record_type record_accuracy;

struct results study_results(const struct study *s);

#endif
