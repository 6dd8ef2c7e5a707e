/* xppaut.h -- the system as an .ode file of XPPAUT. */
#pragma once

#include "interchange.h"

enum xppaut_form {
    XPPAUT_TIME,     /* d/dt: the motion from x->start */
    XPPAUT_ARCLENGTH /* the orbit through a point as a curve of unit speed,
                        backward in time: the branches of the saddle's stable
                        manifold, a set each */
};

/* Writes it; the caller looks at ferror(out).  XPPAUT_ARCLENGTH needs
 * branches. */
void xppaut_write(FILE *out, const struct interchange *x,
                  enum xppaut_form form);
