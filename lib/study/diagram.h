/* diagram.h -- the diagrams of steady sliding that a scene may ask for:
 * friction laws (Fig 1(a)), stick-slip of a spring-block (Fig 1(b)), steady
 * states over the slope (Fig 3), their folds over c (Fig 4); and chi(v), which
 * takes the slopes of chi.alpha (Fig 10). */
#pragma once

#include "chi_curve.h"
#include "fold_curve.h"
#include "monitor.h"
#include "scene.h"
#include "spring_curve.h"
#include "steady_curve.h"

/* The scene's law, and Dieterich's of the same form and material to compare
 * with; empty where the first is as good as the second. */
enum diagram_law { DIAGRAM_SCENE, DIAGRAM_DIETERICH, DIAGRAM_LAWS };

struct diagrams {
    struct steady_curve friction_law[DIAGRAM_LAWS];
    struct spring_curve spring_block[DIAGRAM_LAWS];
    struct steady_curve bifurcation;
    struct fold_curve fold_curves;
    struct chi_curves chi;
};

struct study;

/* The stages of a study (study.c): each fills its part of s->diagrams from the
 * law, the material and the ranges of the scene; the slope plays no part.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status diagram_friction_law(struct study *s,
                                            const struct monitor *monitor,
                                            struct fault *why);
MUST_CHECK enum status diagram_spring_block(struct study *s,
                                            const struct monitor *monitor,
                                            struct fault *why);
MUST_CHECK enum status diagram_bifurcation(struct study *s,
                                           const struct monitor *monitor,
                                           struct fault *why);
MUST_CHECK enum status diagram_fold_curves(struct study *s,
                                           const struct monitor *monitor,
                                           struct fault *why);

MUST_CHECK enum status diagram_chi(struct study *s,
                                   const struct monitor *monitor,
                                   struct fault *why);

/* A second call is harmless. */
void diagrams_free(struct diagrams *d);
