/*
 * winding.h -- whether a curve of a plane winds on to a closed orbit.
 *
 * Distances are those of arrival.h.
 */
#pragma once

#include "arrival.h"

enum { WINDING_KEPT = 16, WINDING_MOST = 4 };

/* Where a curve is said to return: where it is highest; where an angle has gone
 * round once more, at a multiple of its period.  A closed orbit is told by the
 * first of these that its rounds have. */
enum winding_section {
    WINDING_HIGHEST,
    WINDING_ROUND_X,
    WINDING_ROUND_Y,
    WINDING_SECTIONS
};

/* Returns of a curve, from a start that it does not come back to: where the
 * last `turns` of them repeat the ones before up to `gap`, and these
 * differences have shrunk and go on to, a closed orbit runs within some gaps of
 * them. */
struct winding {
    enum winding_section section;
    struct vec2 at[WINDING_KEPT]; /* absolute, the last one first */
    size_t piece[WINDING_KEPT];   /* how many pieces there were then */
    double theta[WINDING_KEPT];   /* and where on the last one of these */
    size_t count;                 /* of all */
    double noise;         /* what a piece is off, of 1 + |offset|; given */
    size_t pieces;        /* added so far */
    bool up;              /* as the field says at the end */
    double period, mark;  /* the period that the curve is in at the end; where
                             it came into the last one new, in periods */
    struct vec2 start;    /* of the curve; of the first, if others go on */
    double near, away;    /* how near to it this round has come, the last one */
    double extent, round; /* how far the curve has been from the last return,
                             and was between the last two */
    double more, off;     /* what pieces are off since the last return, and
                             between the last two */
    size_t turns;         /* returns in one round, once it is closed */
    double gap;
};

/* Of a curve that begins at the last return of another. */
struct winding winding_from(const struct winding *w,
                            const struct arrival_scale *s);

/* One more piece of a curve of offsets; true once it winds on to a closed orbit
 * that is far from all n equilibria, in terms of the gap. */
bool winding_add(struct winding *w, const struct planar *sys,
                 const struct arrival_scale *s, const struct curve *c,
                 size_t piece, const struct vec2 equilibrium[], size_t n);

/* One curve's returns of every kind. */
struct windings {
    struct winding of[WINDING_SECTIONS];
};

struct windings windings_begin(double noise);

/* The same of each; the one that tells a closed orbit, or NULL. */
const struct winding *windings_add(struct windings *w, const struct planar *sys,
                                   const struct arrival_scale *s,
                                   const struct curve *c, size_t piece,
                                   const struct vec2 equilibrium[], size_t n);

/* Those that come back to their start, and twice to where they were up to what
 * the round is off: the curve is one of many closed orbits, or on one that
 * attracts, as far as numbers tell.  NULL: it does not. */
const struct winding *windings_closed(const struct windings *w,
                                      const struct arrival_scale *s);
