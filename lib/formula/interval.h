/*
 * interval.h -- formulas over boxes: what a node and its two slopes can be
 * wherever two leaves are in given intervals.
 *
 * Nothing is left out: every operation rounds outward by a unit of its last
 * digit, every function by eight (those of lib/core and of 113 bits are right
 * to four), a decimal of up to 30 digits counts with all it may have been
 * before it was kept in 113 bits, and what has no state is enclosed in 113
 * bits first.
 *
 * Searches take intervals of doubles; proofs those of 64 bits (`interval`),
 * whose rounding is 2,000 times finer at about the same cost.
 */
#pragma once

#include "formula.h"
#include "status.h"

enum { INTERVAL_RESULTS = 4 };

struct interval_double {
    double lo, hi;
};
struct interval {
    long double lo, hi;
};
struct interval_quad {
    formula_real lo, hi;
};

/* Of a node, and of its derivatives by the two variables. */
struct interval_slope_double {
    struct interval_double value, by[2];
};
struct interval_slope_quad {
    struct interval_quad value, by[2];
};

/* Where the formulas are defined in the box: where they are not, enclosures
 * hold for the rest of it. */
enum interval_domain { INTERVAL_WHOLE, INTERVAL_PARTLY, INTERVAL_NOWHERE };

/* Formulas that are ready: large; by node. */
struct interval_plan {
    const struct formula *f; /* borrowed */
    int variable[2], result[INTERVAL_RESULTS], results;
    int node[FORMULA_NODES], nodes; /* in order: what the results need and is
                                       not the same everywhere */
    struct interval_slope_double of_double[FORMULA_NODES];
    struct interval_slope_quad of_quad[FORMULA_NODES];
    int effort; /* additions that one box costs, about */
};

/* Results are nodes; no leaf but the two variables moves; value[] holds the
 * other leaves' by node.  STATUS_BAD_ARGUMENT: a function has no rule. */
MUST_CHECK enum status interval_plan(struct interval_plan *p,
                                     const struct formula *f,
                                     const int variable[2], const int result[],
                                     int results, const formula_real value[],
                                     struct fault *why);

/* Results over a box. */
enum interval_domain interval_over_double(struct interval_plan *p,
                                          const struct interval_double box[2],
                                          struct interval_slope_double out[]);
enum interval_domain interval_over_quad(struct interval_plan *p,
                                        const struct interval_quad box[2],
                                        struct interval_slope_quad out[]);

/* What a decimal may have been. */
struct interval_quad interval_decimal(formula_real x);

/* Sums, differences, products and quotients (over what is not 0); those of 64
 * bits are in interval_long.h. */
struct interval_double interval_add_double(struct interval_double u,
                                           struct interval_double w);
struct interval_double interval_less_double(struct interval_double u,
                                            struct interval_double w);
struct interval_double interval_times_double(struct interval_double u,
                                             struct interval_double w);
struct interval_quad interval_add_quad(struct interval_quad u,
                                       struct interval_quad w);
struct interval_quad interval_less_quad(struct interval_quad u,
                                        struct interval_quad w);
struct interval_quad interval_times_quad(struct interval_quad u,
                                         struct interval_quad w);
struct interval_quad interval_divide_quad(struct interval_quad u,
                                          struct interval_quad w);
/* Of what of u is not below 0; its lower end is 0 if there is none. */
struct interval_quad interval_sqrt_quad(struct interval_quad u);
