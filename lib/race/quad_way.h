/* quad_way.h -- a planar system followed in 113 bits from a place or a saddle,
 * and whether points are on the way. */
#pragma once

#include "plane_rows.h"
#include "quad_step.h"

struct quad_way {
    quad_rates *rates;
    const void *ctx;                         /* borrowed */
    double side[QUAD_DIM], period[QUAD_DIM]; /* of the window; 0: no angle */
    double accuracy, most;  /* of a step, and about how long it is; windows */
    quad longest;           /* a step that is shorter may grow */
    quad z[QUAD_DIM], step; /* step < 0: backward in time */
};

/* To the root of the rates beside w->z, by Newton's steps; the eigenvalues
 * there, re in rising order, im >= 0. */
void quad_way_settle(struct quad_way *w);
void quad_way_eigenvalues(const struct quad_way *w, quad re[2], quad *im);

/* From the saddle at w->z, forward or backward as w->step says, 1e-11 windows
 * along its branch on the side of `to`, off that by the square of it; sets the
 * step, and as the longest half the time scale of the faster direction: what
 * decays there is followed, too. */
void quad_way_leave(struct quad_way *w, const double to[2]);

/* A step, to out; w->z stays.  false: none is small enough. */
bool quad_way_step(struct quad_way *w, quad out[2]);
/* w->z is there. */
void quad_way_take(struct quad_way *w, const quad out[2]);

/* How many points it comes by within their bars (and slack), one after another,
 * at about the arc lengths that they are told to be at; off[]: by how much, of
 * the first that it does not, if any, too.  *lost: its steps end before. */
size_t quad_way_follow(struct quad_way *w, const struct plane_point p[],
                       size_t count, double slack, quad off[], bool *lost);
