/*
 * sample_figure.h -- a phase portrait in closed form that has everything
 * lib/plot can draw but a map: the linear saddle p' = p, q' = -q, seen in
 * log10 v = p + 0.6 q and log10 psi = q - 0.4 p.
 */
#pragma once

#include "draw.h"

extern const struct figure_axis sample_v, sample_psi;

void sample_portrait(struct figure *f, const char *title);

void sample_mark(struct figure *f, enum figure_mark mark, const char *entry,
                 double x, double y);

/* figures_write of one. */
MUST_CHECK enum status sample_draw(const struct figure *f, const char *path,
                                   bool keep_script, struct fault *fault);
