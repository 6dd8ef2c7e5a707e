/* sweep_results.h -- what a point of a sweep has beside the numbers of its
 * study, described (result.h). */
#pragma once

#include "scene.h"

/* Results whose run is a struct sweep_point.  Their axes are dimensions
 * (sweep_dim.h): the last one of columns runs along a view's records, others
 * through its instances, of which each name has its own:
 *
 *     k = entry of these dimensions * result_count + number of the name. */
extern const struct result *const point_tables[];

/* The bits (study_results.h) of the scene's products, and of these tables. */
uint64_t sweep_asked(const struct scene *scene);
