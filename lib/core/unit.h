/* unit.h -- the units in which numbers are told.
 *
 * Inside, slip rates are in units of V_star, lengths of L, times of L/V_star,
 * and a state is psi.  A number says so by the name of its unit, "L/V_star";
 * in the SI it is times V_star^rate L^length (its logarithm: plus the logarithm
 * of that), and a state is phi = phi_1 psi, or phi_1 e^psi of laws whose psi
 * is a logarithm.  An angle may be told in degrees or by its tangent.  Names
 * that are not in this table are in the SI as they are, or have no unit.  One
 * more unit is one more line of the table. */
#pragma once

#include <stdbool.h>

#include "record.h"

enum unit_kind {
    UNIT_FACTOR,
    UNIT_LN,
    UNIT_LOG10,
    UNIT_STATE,    /* psi */
    UNIT_LN_STATE, /* ln psi, where psi > 0 */
    UNIT_KICK,     /* a factor on psi; a shift where it is a logarithm */
    UNIT_ANGLE     /* rad, whatever V_star and L are */
};

enum unit_angle { ANGLE_RAD, ANGLE_DEGREE, ANGLE_TAN };

struct unit {
    const char *own; /* as in record_field.unit */
    const char *si;
    enum unit_kind kind;
    int rate, length; /* -1, 0, 1 */
};

/* In which units to tell. */
struct unit_system {
    bool si; /* else as they are */
    enum unit_angle angle;
    double V_star, L, phi_1;
    bool psi_is_log;
    const char *phi; /* unit of phi: "s", "1" */
};

/* NULL: none of V_star, L, psi and rad. */
const struct unit *unit_find(const char *own);

/* UDUNITS of the number as it is. */
const char *unit_plain(const char *own);

/* What the number times which is in the SI: "V_star"; NULL: there is none. */
const char *unit_factor(const char *own);

/* The unit's name as people see it: "V_star" or "m/s", "1" of states that have
 * none. */
const char *unit_name(const struct unit_system *u, const char *own);

/* One of it in the SI, with one rounding. */
double unit_scale(const struct unit_system *u, const struct unit *unit);

/* Whether all numbers are told as they are. */
bool unit_system_is_own(const struct unit_system *u);

/* A number as told; a value that overflows is infinite.  u NULL: as it is. */
double unit_value(const struct unit_system *u, const struct unit *unit,
                  double x);

/* The same with its bar: error' bounds |x' - exact'| if error does |x - exact|,
 * for V_star and L as they are read.  What is beyond all doubles is none. */
struct quantity unit_quantity(const struct unit_system *u,
                              const struct unit *unit, struct quantity q);
