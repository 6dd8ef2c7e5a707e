/* report_sweep_json.h -- a sweep as JSON for programs. */
#pragma once

#include "json.h"
#include "sweep.h"

/* {"law", "form", "keys": [{"key", "name", "unit", "values"}], "points",
 * "failed", "reasons", "dims": {NAME: {"unit", "values"}}, "starts": [{"v",
 * "psi"}], "numbers": {NAME: {"value": [...], "error": [...], "reason":
 * [...]}}, "maps"}.
 *
 * Numbers have one value a point, null where there is none and "reason" then an
 * index into "reasons", else null; of a code its word.  Those along dimensions
 * have a list a point, of lists for two, and name them in "dims"; exact ones
 * have no "error".  Of maps, which are in files only, {"dims", "shape"}, and of
 * each point how many cells have a value ("present"), "least" and "greatest",
 * or "cells": how many have each word.  A new reference, NULL without memory.
 */
json_t *report_sweep_json(const struct sweep *s);
