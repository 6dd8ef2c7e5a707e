/* scene_shape.h -- whether what a sweep asks for has the same shape at each of
 * its points. */
#pragma once

#include "node.h"
#include "scene.h"

/* Products (bits) that are curves, which no sweep takes. */
extern const unsigned scene_shape_curves;

/* For a scene with a sweep: no curves, which are longer here than there; runs
 * from the same starts everywhere; one release distance a point; and no more
 * cells of maps in all than SCENE_SWEEP_CELLS.  Errors as scene_read. */
MUST_CHECK enum status scene_shape_check(const struct node *root,
                                         const struct scene *s,
                                         struct fault *why);
