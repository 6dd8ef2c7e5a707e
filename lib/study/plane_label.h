/* plane_label.h -- whereto the regions of a plane go. */
#ifndef STUDY_PLANE_LABEL_H
#define STUDY_PLANE_LABEL_H

#include "plane_patch.h"

/* States are taken this far from the left to the right end of a region: near
 * its middle, but not where equilibria like to be. */
#define PLANE_LABEL_MIDDLE 0.4871

/* Joins the regions and labels them; cycles that are new are added to *s.  The
 * members of *p are there.  STATUS_NO_MEMORY, STATUS_STOPPED. */
MUST_CHECK enum status plane_label_all(struct plane_study *s, struct patches *p,
                                       const struct monitor *monitor);

#endif
