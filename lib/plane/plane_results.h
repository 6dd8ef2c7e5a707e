/* plane_results.h -- what a plane study computed, described (result.h): tables
 * made for the run, whose members have the names of its states. */
#pragma once

#include "plane_study.h"
#include "result.h"

/* Fills s->table; the rest of *s is known.  STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_results_make(struct plane_study *s);

/* Its tables and itself, which must not move. */
struct results plane_results(const struct plane_study *s);

/* Those of basins whose members have names of their own; and the map, which is
 * added. */
extern const struct result plane_basin_results[];
void plane_results_map(const struct plane_study *s, struct plane_table *t);

void plane_results_free(struct plane_table *t);
