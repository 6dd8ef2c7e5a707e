/*
 * moment.h -- what is looked out for along the orbit of a block: events of
 * event.h, each a function of the state that vanishes there.
 */
#pragma once

#include "equilibrium.h"
#include "event.h"
#include "orbit.h"
#include "record.h"

struct slider;

/* What happens; files hold these codes. */
enum moment {
    MOMENT_V_SP,    /* v = v of the saddle */
    MOMENT_V_MINUS, /* v = v_minus, where it exists */
    MOMENT_V_PLUS,  /* v = v_plus, where it exists */
    MOMENT_V,       /* v = level */
    MOMENT_PSI,     /* psi = level */
    MOMENT_PSI_MIN, /* dpsi/dt = 0 */
    MOMENT_PSI_MAX,
    MOMENT_MU_MIN, /* dmu/dt = 0 */
    MOMENT_MU_MAX,
    MOMENT_V_MIN, /* dv/dt = 0: mu = tan(alpha) */
    MOMENT_V_MAX,
    MOMENT_MU_NEARS,  /* |mu - tan(alpha)| falls below level */
    MOMENT_MU_LEAVES, /* and rises above it */
    MOMENT_ARREST,    /* enters the box TOL_ARREST around a stable node */
    MOMENT_REST,      /* v = 0 */
    MOMENTS
};
extern const char *const moment_units[]; /* of the level, by code */
extern const char *const moment_names[];

/* A value to look out for, of v (MOMENT_V), psi (MOMENT_PSI) or
 * |mu - tan(alpha)| (MOMENT_MU_NEARS, both ways). */
struct moment_level {
    enum moment what;
    double value;
};

/* The field where it was asked for last: at a sample of an orbit several
 * functions ask for it. */
struct moment_look {
    struct vec2 z; /* offset; x = NaN: nowhere */
    struct planar_field f;
};

/* Whose functions are watched. */
struct moment_along {
    const struct slider *slider;
    struct moment_look *last;
};

struct moment_watch {
    enum moment what; /* of a pair that differs in direction, the first */
    double level;     /* as given; NaN: none */
};

/* The functions watched along one orbit; neither it nor the slider may move. */
struct moment_watches {
    struct moment_watch watch[EVENT_COUNT_MAX];
    struct event event[EVENT_COUNT_MAX]; /* their ctx: along */
    size_t count;
    struct moment_along along;
    struct moment_look look;
};

/* Levels that fit beside what is always watched. */
enum { MOMENT_LEVELS_MAX = 7 };

/* Everything that exists in s, whose critical numbers are known, the nearness
 * that phases go by (TOL_ARREST tan(alpha)), and the levels; but rest,
 * which nothing vanishes at (rest_left.h).  Orbits stop at arrest where `stop`
 * is true. */
void moment_watch_all(struct moment_watches *w, const struct slider *s,
                      const struct moment_level *level, size_t levels,
                      bool stop);

/* What a hit means; of a turn, that it is one: *_MIN. */
enum moment moment_of(const struct moment_watches *w,
                      const struct event_hit *hit);

/* mu - tan(alpha) at the offset z, exact to rounding of the difference. */
double moment_excess_friction(const struct slider *s, struct vec2 z);

/* The stable node within `reach` of the offset z in both coordinates, in s;
 * NULL: none. */
const struct equilibrium *moment_node_at(const struct slider *s, struct vec2 z,
                                         double reach);

/* d ln v/dt and d ln psi/dt (dpsi/dt where psi is a logarithm), per t*; may be
 * infinite.  u: of the orbit. */
struct vec2 moment_rates(const struct slider *s, const double u[]);
