/*
 * labels.h -- the fate of every state of a slope, told by the side of the
 * saddle's stable manifold on which it lies.
 *
 * The quadrants of the saddle v < v_sp, psi > psi_sp and v > v_sp, psi < psi_sp
 * cannot be left (trap.h), so the stable manifold, which leads into the saddle,
 * never enters them: it divides the plane in two, each side holds one of them,
 * and what attracts all of that one is the fate of the whole side.  No orbit is
 * followed.  A state that is no further from the curve than the bar which the
 * curve carries there (at the saddle: than the bar of the saddle) is undecided.
 *
 * Coordinates are offsets from the saddle, in the chart (block_offset).
 */
#pragma once

#include "branch.h"
#include "fate.h"
#include "region.h"

struct labels {
    const struct slider *slider; /* borrowed */
    struct branch stable[2];     /* owned; to the ends of the domain, but for
                                    those that are lent */
    bool lent;
    struct separatrix along[2]; /* owned; [0] crosses columns, [1] rows;
                                   with lent branches only rows */
    struct regions regions;     /* owned; unlabelled where no side is told */
};

/* Follows the stable branches of s, to rtol, and labels
 * both sides; s must outlive l, which must not move.  STATUS_OK also without a
 * saddle or without manifolds of it (slider_has_manifolds).  On error *l is
 * empty: STATUS_NO_MEMORY, STATUS_STOPPED, or as grow_branches. */
MUST_CHECK enum status labels_init(struct labels *l, const struct slider *s,
                                   double rtol, const struct monitor *monitor);

/* By stable branches that are there, grown as far as anybody liked; they must
 * outlive l.  Beyond its end a branch is told by its limit, off by no more than
 * what was left of the way there, for it approaches it from one side. */
MUST_CHECK enum status labels_lend(struct labels *l, const struct slider *s,
                                   const struct branch stable[2]);

/* Of one state. */
struct fate_told {
    int8_t fate;        /* enum fate */
    const char *reason; /* static; why it is undecided, else NULL */
    bool is_near;       /* because it is within the bar of the separatrix */
};

/* Of the state at the offset z.  Where no side is told - the manifold cannot be
 * followed so far, as on the edge of the plane, or there is no saddle and yet
 * more than one fate - its orbit may tell.  STATUS_NO_MEMORY, STATUS_STOPPED.
 */
MUST_CHECK enum status labels_find(const struct labels *l, struct vec2 z,
                                   const struct monitor *monitor,
                                   struct fate_told *out);

/* What the sides alone tell of it, where its row meets the curve nowhere near
 * it: an enum fate, else FATE_UNDECIDED. */
enum fate labels_side(const struct labels *l, struct vec2 z);

/* How far the state is from the curve along its row, in ln v, signed as v is
 * above it; infinite where the row does not meet it. */
double labels_margin(const struct labels *l, struct vec2 z);

/* labels_find of one state alone; errors as labels_init and labels_find. */
MUST_CHECK enum status labels_find_one(const struct slider *s, struct vec2 z,
                                       double rtol,
                                       const struct monitor *monitor,
                                       struct fate_told *out);

/* A second call is harmless. */
void labels_free(struct labels *l);
