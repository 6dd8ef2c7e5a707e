/* picture_rabinowicz.h -- measured release distances, the fit of (33) and
 * friction against slip as figures, after Fig 8. */
#ifndef APPS_PICTURE_RABINOWICZ_H
#define APPS_PICTURE_RABINOWICZ_H

#include "panel.h"
#include "release.h"

/* Two files: NAME.svg shows tan(alpha) over l_k tan(alpha) with error bars, the
 * parabola (33), its 95 % band and roots; NAME_friction.svg the friction
 * coefficient over s_k, (25).  The names after these, as of
 * panel_path: */
enum { PICTURE_RABINOWICZ_PANELS = 2 };
extern const char *const picture_rabinowicz_panel[PICTURE_RABINOWICZ_PANELS];

/* Errors as figure_write; STATUS_BAD_ARGUMENT where nothing was measured, or
 * the data give no curve of friction over slip. */
MUST_CHECK enum status picture_rabinowicz(const struct release *r,
                                          const struct scene *scene,
                                          const char *path, bool keep_script,
                                          struct fault *why);

#endif
