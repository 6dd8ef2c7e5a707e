/*
 * json_results.h -- the results of a run (result.h) as one JSON object: every
 * one that was asked for and has a name, at its place.
 *
 * A record is an object, several are a list; records of one member are a list
 * of values.  "units" mirrors it: at the place of each number that has a unit
 * that unit, lists being one object.  What was asked for and is not there is
 * null at the top, and left out below.
 */
#pragma once

#include "json.h"
#include "result.h"

/* Adds to the object j, after what it holds; NULL: to a new one.  Returns it;
 * NULL, and j is gone, without memory. */
json_t *json_results(json_t *j, const struct results *all);

/* Adds the units that members of such a record have to an object; of those
 * that have none nothing.  Returns it. */
json_t *json_units(json_t *at, const struct record_type *type);
