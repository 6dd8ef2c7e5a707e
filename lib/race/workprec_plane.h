/* workprec_plane.h -- a race around a saddle of a system of formulas: both
 * branches of its stable manifold, up to the window's edge. */
#pragma once

#include "quad_way.h"
#include "workprec_answer.h"

/* A friction slope's place taken by a plane: the planar system about the first
 * saddle whose stable branches leave the window, as a study has it; the only
 * quantity is WORKPREC_CURVE, whose truth is followed in 113 bits. */
struct workprec_plane {
    struct plane_study *plane;      /* owned */
    struct quad_formulas *formulas; /* owned */
    struct quad_way way;            /* at the saddle */
    struct equilibrium saddle;
};

/* Fills the study's system and the task; p must not move while they live.
 * Without such a saddle no quantity exists.  Errors as plane_study_run; on
 * error *p is empty. */
MUST_CHECK enum status workprec_plane_init(struct workprec_plane *p,
                                           const struct scene *scene,
                                           size_t sample, struct study *study,
                                           struct workprec_task *task,
                                           const struct monitor *monitor,
                                           struct fault *why);

/* The largest distance of some stored points from the branch that they are on;
 * infinite where 113 bits do not come by one. */
double workprec_plane_error(const struct workprec_plane *p,
                            const struct vec2 point[], size_t count,
                            size_t sample);

/* A second call is harmless. */
void workprec_plane_free(struct workprec_plane *p);
