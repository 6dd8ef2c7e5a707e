/* plane_beyond.h -- whereto orbits go that leave the window for good: which of
 * these ends are the same. */
#pragma once

#include "plane_study.h"

/* Whether an orbit that is at an absolute point, and has left the domain or
 * not, has come to such an end; and what is known of it.  A coordinate has a
 * limit where it hardly changes, in time and while the other one grows; it
 * grows or falls where it is more than a window beyond the window. */
bool plane_beyond_at(const struct plane_study *s, struct vec2 z, bool backward,
                     bool left, struct plane_beyond *out);

/* Whether they may be one end: nothing known of both differs. */
bool plane_beyond_agree(const struct plane_study *s,
                        const struct plane_beyond *a,
                        const struct plane_beyond *b);

/* Its word. */
void plane_beyond_name(const struct plane_study *s, struct plane_beyond *b);

/* Keeps of *a what is known of both alike. */
void plane_beyond_meet(const struct plane_study *s, struct plane_beyond *a,
                       const struct plane_beyond *b);

/* Adds one to those of the study: all that agree become one, until no two do.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_beyond_add(struct plane_study *s,
                                        const struct plane_beyond *new);

/* Adds the two of which nothing is known where nothing agrees with them, and
 * words.  STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_beyond_finish(struct plane_study *s);
