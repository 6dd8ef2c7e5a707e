/* quad_peak.h -- the largest v and mu on the way of a 113-bit orbit. */
#pragma once

#include "quad_course.h"

/* Where it starts. */
void quad_peak_start(struct quad_course *c);

/* Notes what is reached at u. */
void quad_peak_note(struct quad_course *c, const quad u[]);

/* The largest up to the end of the step w, which begins at c->u. */
void quad_peak_step(struct quad_course *c, const struct quad_radau *w);
