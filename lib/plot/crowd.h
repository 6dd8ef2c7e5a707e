/*
 * crowd.h -- lines that make room for each other: where one would run beside
 * another that was there before, it is not drawn, so that many orbits that
 * come together are seen to join, and never are a stripe.
 */
#pragma once

#include <stdint.h>

#include "line.h"
#include "scale.h"

/* Cells along each side of the axes' box: two lines have at least one between
 * them. */
enum { CROWD_CELLS = 160 };

struct crowd {
    struct scale x, y; /* in cells */
    bool failed;       /* memory ran out for a line that is taken: those that
                          are cut then fail, too (line.h) */
    uint8_t taken[CROWD_CELLS][CROWD_CELLS];
};

/* Nothing is taken yet. */
void crowd_init(struct crowd *c, const struct figure *f);

/* Others keep away from this line from now on. */
void crowd_take(struct crowd *c, const struct line *l);

/* Leaves of the line what is nowhere nearer than a cell to what is taken, with
 * up to three cells more at its ends so that it is seen to join; parts are
 * broken by NaN, those of less than six cells are left out, points are added
 * between others.  Then others keep away from what is left. */
void crowd_cut(struct crowd *c, struct line *l);
