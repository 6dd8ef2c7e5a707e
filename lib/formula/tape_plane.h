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
#pragma once

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

/* What is done at an order of a series after the sums (tape_jet.c): register
 * `out` of registers a and b; d: derivative. */
enum jet_code {
    JET_NOTHING,
    JET_TIMES,  /* c a, c the first */
    JET_SUM,    /* a + b */
    JET_LESS,   /* a - b */
    JET_ADD,    /* a + c b */
    JET_TWO,    /* c[0] a + c[1] b */
    JET_FIXED,  /* a times what is kept */
    JET_CHOOSE, /* a or b by what is kept */
    JET_GROWTH, /* steps of tape.h, from here */
    JET_APART,
    JET_MIXED,
    JET_LN1P,
    JET_SINH, /* cosh, too */
    JET_SINH_JOINED,
    JET_FRICTION,
    JET_SIN,
    JET_TAN,
    JET_TANH,
    JET_ASIN,
    JET_ATAN,
    JET_ASINH,
    JET_PRODUCT,
    JET_QUOTIENT,
    JET_RATE, /* b e^(c a), b the mantissa */
    JET_RATE_ALONE
};

enum { TAPE_OPS = 768, TAPE_KEEPS = 2048 };

/* All but the code in bytes from where registers, slots, what is kept begin. */
struct jet_op {
    unsigned code, out, a, b, slot, keep;
    double c[2];
};

/* What is made together: the chart's rates, an observable's. */
enum { TAPE_PARTS = 1 + TAPE_OBSERVABLES };

struct tape_part {
    int width, rows; /* of its rows, where they begin */
    int op, ops;     /* its entries */
    int alone;       /* the state of which all rows A are multiples, or -1 */
    bool odd;
};

/* A plane at an anchor.  Copied as a whole. */
struct tape_plane {
    struct real_tape t;
    double origin[2]; /* of the chart */
    /* places in a workspace of series, see tape_jet.c: by step (and where they
     * end) and by rate what is kept of order 0, and the factor of a rate's
     * mantissa that is left to it */
    short kept[TAPE_STEPS + 1], rate_kept[TAPE_RATES];
    double factor[TAPE_RATES];
    struct tape_part part[TAPE_PARTS];
    int registers, keep, constants;
    bool wide; /* registers of four numbers: the same bits, sooner */
    struct jet_op op[TAPE_OPS];
    short result[TAPE_RATES]; /* registers */
    int ops;
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

/* value[0] of the tape, and d value[0]/d(x, y). */
double tape_value(const struct tape_plane *t, struct vec2 z);
struct vec2 tape_value_gradient(const struct tape_plane *t, struct vec2 z);

/* Whether this processor has them. */
bool tape_jet_wide(void);

/* Whether series of both planes are made by the same entries, but for their
 * coefficients. */
bool tape_alike(const void *ctx, const void *other);

/* tape_jet and tape_jet_rate of JET_MANY planes, for processors of a level. */
extern const struct planar_many tape_many_4, tape_many_8;

/* look of theirs. */
void tape_look_4(const void *const ctx[], size_t n, const struct vec2 z[],
                 int which, bool slopes, struct planar_look out[]);
void tape_look_8(const void *const ctx[], size_t n, const struct vec2 z[],
                 int which, bool slopes, struct planar_look out[]);

/* Hands out places; false where they are too many. */
MUST_CHECK bool tape_jet_slots(struct tape_plane *t);
