/*
 * tape_plane.h -- formulas as a planar system (planar.h): a graph's rates,
 * lowered to differences from an anchor, over doubles, duals and Taylor series.
 *
 *     tape_plane_lower(&l, f, p, equilibrium, why);   once for a system
 *     tape_plane_at(&l, values, anchor, &t, why);     for parameters, a point
 *     struct planar s = tape_planar(&t);
 *     s.name = .., s.axis[0] = .., s.domain = .., s.observables = ..;
 *
 * The chart of a state is its logarithm if it is positive, itself if not;
 * offsets are measured from the anchor in it.
 */
#ifndef FORMULA_TAPE_PLANE_H
#define FORMULA_TAPE_PLANE_H

#include "constants.h"
#include "planar.h"
#include "real_tape.h"

enum { TAPE_PLANE_VALUES = 128 }; /* of parameters */

/* A system's formulas and their tape; no numbers yet.  Large; copied as a
 * whole. */
struct tape_lowered {
    struct formula f;
    struct plane_formulas p;
    struct tape t;
};

/* A plane at an anchor.  Copied as a whole. */
struct tape_plane {
    struct real_tape t;
    double origin[2]; /* of the chart */
    /* places in a workspace of series, see tape_jet.c: by step and by rate
     * the first slot and what is kept of order 0; by part its rows */
    short slot[TAPE_STEPS], kept[TAPE_STEPS];
    short rate_slot[TAPE_RATES], rate_kept[TAPE_RATES];
    int width[2], rows[2], registers, keep;
    bool odd[2];
};

/* Copies f; of p, states, rates and observables count.  `equilibrium`: both
 * rates vanish at every anchor that will be given, whatever rounding makes of
 * their terms.  STATUS_BAD_ARGUMENT with the reason where a formula cannot be
 * used. */
MUST_CHECK enum status tape_plane_lower(struct tape_lowered *out,
                                        const struct formula *f,
                                        const struct plane_formulas *p,
                                        bool equilibrium, struct fault *why);

/* value[]: of all parameters, ended by one without a name; anchor: in the
 * chart, to all digits that are known.  STATUS_BAD_ARGUMENT where a formula
 * has no finite value at the anchor. */
MUST_CHECK enum status tape_plane_at(const struct tape_lowered *l,
                                     const struct formula_value value[],
                                     const formula_real anchor[2],
                                     struct tape_plane *out, struct fault *why);

/* field, jacobian, jet, rate_gradient, rate_jet, origin, observable_count and
 * ctx; borrows t, which must not move.  The caller adds names and a domain. */
struct planar tape_planar(const struct tape_plane *t);

/* The functions of that planar system; ctx is a struct tape_plane. */
void tape_field(const void *ctx, struct vec2 z, struct planar_field *f);
void tape_jacobian(const void *ctx, struct vec2 z, struct planar_jacobian *J);
void tape_rate(const void *ctx, size_t which, struct vec2 z, double *rate,
               struct vec2 *gradient);
void tape_jet(const void *ctx, struct jet_work *w, size_t k, const jet_pair x[],
              const jet_pair y[], jet_pair fx[], jet_pair fy[]);
void tape_jet_rate(const void *ctx, size_t which, struct jet_work *w, size_t k,
                   const jet_pair x[], const jet_pair y[], jet_pair rate[]);

/* Hands out places; false where they are too many. */
MUST_CHECK bool tape_jet_slots(struct tape_plane *t);

/* d register/d(x, y) for all registers, after real_tape_run. */
void tape_gradients(const struct real_tape *t, bool everything,
                    const double reg[], struct vec2 gradient[]);
/* Of rate i times exp(-scale), at registers with gradients. */
struct vec2 tape_rate_gradient(const struct real_tape *t, int i, double scale,
                               const double reg[],
                               const struct vec2 gradient[]);

#endif
