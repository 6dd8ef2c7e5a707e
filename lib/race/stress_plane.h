/* stress_plane.h -- a system of formulas under stress: its equilibria,
 * eigenvalues, branches and labels beside the same formulas followed in 113
 * bits by a method of another kind (quad_way.h). */
#pragma once

#include <stdbool.h>

#include "scene.h"
#include "stress_row.h"

/* So many times a system's parameters are drawn anew. */
enum { STRESS_PLANE_CASES = 12 };

/* "system.parameters={NAME: VALUE, ...}": each value that
 * the rates use times a random factor of
 * 2/3 to 3/2, which is the k-th; false: there are none, or text[size] is too
 * short. */
bool stress_plane_setting(const struct scene *scene, int k, char text[],
                          size_t size);

/* Fills outcome, reason, digits, bar, steps and times.  STATUS_NO_MEMORY, or a
 * failure of the program, of which row->fault may say more. */
MUST_CHECK enum status stress_plane_judge(const struct scene *scene,
                                          struct stress_row *row);
