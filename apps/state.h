/* state.h -- the state of --v and --psi or --phi, and states as people read
 * them. */
#pragma once

#include <stdio.h>

#include "options.h"
#include "scene.h"

/* STATUS_BAD_ARGUMENT with one line in *why where it is none, or where the
 * scene leaves open in which unit it is (scene_units.h). */
MUST_CHECK enum status state_read(const struct options *o,
                                  const struct scene *s,
                                  struct scene_start *out, struct fault *why);

/* The same as a setting of the scene, KEY=[{v: V, psi: PSI}]. */
void state_setting(const struct options *o, const char *key, char *text,
                   size_t size);

/* "v = 1000 V_star = 0.001 m/s, psi = 10"; beside units: si "v = 0.001 m/s =
 * 1000 V_star, phi = 1e-05 s, psi = 10". */
void state_print(FILE *out, const struct scene *s, double v, double psi);
