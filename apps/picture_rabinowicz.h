/* picture_rabinowicz.h -- measured release distances, the fit of (33) and
 * friction against slip as figures, after Fig 8. */
#pragma once

#include "output.h"
#include "release.h"

/* Two files: NAME.svg shows tan(alpha) over l_k tan(alpha) with error bars, the
 * parabola (33), its 95 % band and roots; NAME_friction.svg the friction
 * coefficient over s_k, (25).  The names after these, as of
 * panel_path: */
extern const char *const picture_rabinowicz_panel[]; /* ended by NULL */

/* Adds both, so titled.  STATUS_BAD_ARGUMENT where nothing was measured, or too
 * little. */
MUST_CHECK enum status picture_rabinowicz(const struct release *r,
                                          const char *title, struct panels *p,
                                          struct fault *why);
