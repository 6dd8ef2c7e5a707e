/*
 * fate.h -- what becomes of a state: stops, creeps, slides or runs away; how
 * far it slips meanwhile and how long that takes, by one L-stable integration
 * of its forward orbit (orbit.h).
 */
#pragma once

#include <stdint.h>

#include "equilibrium.h"
#include "monitor.h"
#include "record.h"

struct slider;

/* Labels of basins; files hold these codes. */
enum fate {
    FATE_CREEP,           /* to the creep node */
    FATE_SLIDING,         /* to the sliding node */
    FATE_REST_FINITE,     /* v = 0 at a finite time */
    FATE_REST_ASYMPTOTIC, /* v -> 0 as t -> inf */
    FATE_RUNAWAY,         /* v -> inf */
    FATE_UNDECIDED,
    FATES
};

/* Whether a block of that fate ends at rest, or creeps as it did. */
static inline bool fate_stops(int fate)
{
    return fate == FATE_CREEP || fate == FATE_REST_FINITE ||
           fate == FATE_REST_ASYMPTOTIC;
}
enum { FATE_NONE = -1 }; /* no cell, no value */
extern const char *const fate_names[];

/* Why a block has no slip, no time and no mean friction that runs away. */
extern const char fate_runs_away[];

/* Creep and sliding nodes: below and above the turning points of mu_ss; where
 * it has none, v <= 1 is creep. */
enum fate fate_of_node(const struct slider *s, const struct equilibrium *e);

/* Of all states in the quadrant v < v_sp, psi > psi_sp of the saddle (slow), or
 * v > v_sp, psi < psi_sp: neither can be left (trap.h), a node in it attracts
 * all of it, and without one nothing holds v.  FATE_UNDECIDED: a node beyond
 * the plane. */
enum fate fate_of_side(const struct slider *s, bool slow);

/* Where there is at most one steady state in all, and no saddle, every state
 * shares one fate; else FATE_UNDECIDED. */
enum fate fate_of_all(const struct slider *s);

struct fate_result {
    enum fate fate;
    const char *reason;                  /* static; why undecided, else NULL */
    struct quantity slip, time, mu_mean; /* to arrest: within TOL_ARREST of
                                            the node, or v = 0; limits of what
                                            has one */
    double v_peak, mu_peak;              /* largest on the way, dimensionless */
    size_t steps, field_evaluations;
};

/* Time, slip and work, as an orbit holds them, that one from the offset z to
 * its arrest has no use for digits below: far less than what a block needs that
 * friction stops; 0 where nothing makes it stop. */
void fate_least(const struct slider *s, struct vec2 z, double least[]);

/* The fate of the absolute chart point z in s->plane.system, whose steady
 * states are known.  `observe`: with slip, time and means, else the fate alone,
 * which is known, too, where the orbit could be followed only into one of the
 * saddle's quadrants that cannot be left (trap.h), or where all share one.
 * Whether a rest takes a finite time is the law's (rest_form.h), whatever rtol.
 * STATUS_BAD_ARGUMENT: z outside the domain; STATUS_NO_MEMORY; STATUS_STOPPED.
 * An orbit that cannot be followed is undecided, with a reason. */
MUST_CHECK enum status fate_find(const struct slider *s, struct vec2 z,
                                 double rtol, bool observe,
                                 const struct monitor *monitor,
                                 struct fate_result *out);

/* Normal to the face of the box of arrest around a node on which z lies. */
struct vec2 fate_face(struct vec2 z, struct vec2 node);

/* Mean friction over a slip (slider.h), or why there is none. */
struct quantity fate_mean_friction(const struct slider *s, double v0, double v1,
                                   double v1_part, const struct quantity *slip);

/* What two orbits say of one number: the finer one's.  Where they are further
 * apart than their bars, these are too small by as much; and the bar holds a
 * part of what the finer one changes. */
struct quantity fate_compare(const struct quantity *coarse,
                             const struct quantity *fine);
