/*
 * landing_near.h -- an orbit near the saddle, whose series (saddle_series.h)
 * tell what is still to come.
 */
#pragma once

#include "landing.h"

/* Whether they tell all that is asked for, as landing_is_over.  Where peaks are
 * asked for it goes on: */
bool landing_near(struct landing *l);

/* Puts what they told, if they did, in the place of time and slip as landed. */
void landing_keep_near(struct landing *l);
