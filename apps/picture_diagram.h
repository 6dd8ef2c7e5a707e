/* picture_diagram.h -- the diagrams of steady sliding as figures. */
#pragma once

#include "figure.h"
#include "study.h"

/* Whether the study holds a diagram (diagram.h), which its figure then shows:
 * the first of friction_law, spring_block, bifurcation, fold_curves, chi. */
bool picture_has_diagram(const struct study *s);

/* Begins and fills that figure. */
void picture_diagram(const struct study *s, struct figure *f);
