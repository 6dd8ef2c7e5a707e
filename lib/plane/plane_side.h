/*
 * plane_side.h -- beside a stable manifold orbits go to its saddle, and from
 * there along the unstable branch of that side: whereto the regions go that
 * touch it, without an orbit of their own.
 */
#pragma once

#include "plane_label.h"

/* By patch: what its regions on all bands say of it. */
enum plane_side {
    PLANE_SIDE_NONE,
    PLANE_SIDE_TOLD,  /* p->goal is an equilibrium or a cycle */
    PLANE_SIDE_DIFFER /* two of them differ: there is a border within */
};

/* Fills told[] and at[], a place of a region that tells, by the first region
 * of patches, and the goals of those that are told; ask is asked for each
 * unstable branch.  STATUS_NO_MEMORY, or what ask returns. */
MUST_CHECK enum status plane_side_find(struct plane_study *s, struct patches *p,
                                       plane_ask *ask, void *ctx,
                                       enum plane_side told[],
                                       struct vec2 at[]);
