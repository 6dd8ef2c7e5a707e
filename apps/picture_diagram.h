/* picture_diagram.h -- the diagrams of steady sliding as figures. */
#ifndef APPS_PICTURE_DIAGRAM_H
#define APPS_PICTURE_DIAGRAM_H

#include "figure.h"
#include "study.h"

/* Whether the study holds a diagram (diagram.h), which its figure then shows:
 * the first of friction_law, spring_block, bifurcation, fold_curves. */
bool picture_has_diagram(const struct study *s);

/* Makes that figure, to be drawn by figure_write and freed by figure_free.
 * STATUS_NO_MEMORY leaves *f FIGURE_EMPTY. */
MUST_CHECK enum status picture_diagram(const struct study *s, struct figure *f);

#endif
