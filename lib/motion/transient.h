/*
 * transient.h -- the motion of a block from a start until it rests, arrives at
 * a steady state or runs away: its orbit with dense output (orbit.h), what
 * happens along it and when, and the phases of sliding.
 *
 * v in units of V_star, psi as the law's (law.h), slip in L, time in L/V_star.
 */
#pragma once

#include "fate.h"
#include "labels.h"
#include "moment.h"
#include "phase.h"
#include "scene.h"
#include "slider.h"

/* Why a run ended. */
enum transient_end {
    TRANSIENT_REST,       /* v = 0 */
    TRANSIENT_ARREST,     /* within TOL_ARREST of a stable node */
    TRANSIENT_UNTIL_TIME, /* as the scene asks */
    TRANSIENT_UNTIL_SLIP,
    TRANSIENT_RUNAWAY, /* v beyond TOL_TRANSIENT_FAST times start and saddle */
    TRANSIENT_FADED,   /* v below TOL_TRANSIENT_SLOW of both, or falling below
                             it from above, of the saddle; and no rest; or
                             further, to where the limit of its slip is known */
    TRANSIENT_LOST,    /* could not be followed further */
    TRANSIENT_NEAR     /* too near the separatrix: up to the saddle */
};
extern const char *const transient_end_names[];

/* What happened on the way; level: NaN where it has none. */
struct transient_event {
    int8_t what; /* enum moment */
    double level;
    struct quantity time, slip, v, psi, mu;
};

/* A run as a whole. */
struct transient_summary {
    double v, psi;                       /* the start */
    int8_t fate;                         /* enum fate */
    int8_t end;                          /* enum transient_end */
    struct quantity time, slip, mu_mean; /* of the run, to its end; of one that
                                            fades the limits, if any; of one
                                            that runs away none */
    /* Of the balance of energy (27) over the run, relative to its largest
     * term; zero along an exact orbit. */
    double energy_defect;
    int64_t steps, field_evaluations;
};
extern const struct record_type record_transient, record_transient_event;

/* Fields of where an event is, in each record of one. */
#define TRANSIENT_EVENT_NUMBERS                                                \
    FIELD(transient_event, QUANTITY, time, "L/V_star",                         \
          "time since the start in units of L/V_star"),                        \
        FIELD(transient_event, QUANTITY, slip, "L",                            \
              "slip since the start in units of L"),                           \
        FIELD(transient_event, QUANTITY, v, "V_star",                          \
              "slip rate in units of V_star"),                                 \
        FIELD(transient_event, QUANTITY, psi, "psi", "interfacial state"),     \
        FIELD(transient_event, QUANTITY, mu, "1", "friction coefficient")

struct transient {
    struct transient_summary sum;
    const char *reason;            /* static; why undecided or lost, or NULL */
    struct transient_event *event; /* owned; in the order of time */
    size_t events;
    struct phase phase[PHASES];
    struct curve curve; /* owned; as orbit.h: x, y, time, slip, work */
};

struct transient_options {
    double until_time, until_slip; /* 0: no limit.  With one, a run goes on
                                      beyond arrest and runaway, and has the
                                      numbers of its length */
    double rtol;                   /* of events, slip and time; see tolerance.h
                                      for what is done to reach it */
    const struct moment_level *level; /* borrowed */
    size_t levels;                    /* <= MOMENT_LEVELS_MAX */
    const struct labels *labels; /* borrowed; of this slope; NULL: its own */
};

/* The scene's limits and accuracy; nearness in seven decades below 1. */
struct transient_options transient_defaults(const struct scene *c);

/* One run from (v, psi) in s, whose critical numbers are known.  Its fate is
 * that of its side of the separatrix (labels.h); within the bar of that, or
 * where its orbits go to the other side, it has no numbers from here and a
 * curve as far as both sides share it (TRANSIENT_NEAR, near_cut.h; with a limit
 * the scene sets, they go as far).  The bars of
 * the whole run hold what its orbit carries of its errors (drift.h) and part of
 * what a second one at ten times the tolerance changes; those of events what
 * the second one changes, what the steps of this one estimate, and rounding;
 * events that only one of the two sees are left out, and turns of v, psi or mu
 * no larger than the tolerance. STATUS_BAD_ARGUMENT: start outside the domain;
 * STATUS_NO_MEMORY; STATUS_STOPPED.  On error *out is empty.  A run that cannot
 * be followed to its end is no error: see `end`. */
MUST_CHECK enum status transient_find(const struct slider *s,
                                      struct scene_start start,
                                      const struct transient_options *options,
                                      const struct monitor *monitor,
                                      struct transient *out);

/* A second call is harmless. */
void transient_free(struct transient *t);
