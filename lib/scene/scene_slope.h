/* scene_slope.h -- which scenes must have a slope: those that ask for more than
 * steady sliding over all slopes. */
#pragma once

#include "node.h"
#include "scene.h"

/* Products (bits 1 << enum product) that take no slope. */
extern const unsigned scene_slopeless;

static inline bool scene_has_slope(const struct scene *s)
{
    return s->alpha > 0.0;
}

/* That the scene has the slope its products take, or, where it names none,
 * those of any command but a `rabinowicz` with slopes of its own.  Errors as
 * scene_read. */
MUST_CHECK enum status scene_slope_check(const struct node *root,
                                         const struct scene *s,
                                         struct fault *why);

/* That it has one if any of these products takes one.  STATUS_BAD_SCENE with
 * one line in *why: the file, the key, the product. */
MUST_CHECK enum status scene_slope_demand(const struct scene *s,
                                          unsigned products, struct fault *why);
