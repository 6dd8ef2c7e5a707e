/*
 * system.h -- a planar system as people type it: two states, parameters, names
 * for expressions, the states' rates, and what is to be carried along.
 *
 *     static struct formula_system s;
 *     formula_system_init(&s);
 *     formula_system_state(&s, "x", CHART_REAL, 0, at, &why);
 *     formula_system_state(&s, "y", CHART_REAL, 0, at, &why);
 *     formula_system_parameter(&s, "eps", "0.1", at, &why);
 *     formula_system_define(&s, "w", "x - x^3", at, &why);
 *     formula_system_rate(&s, "x", "(w - y)/eps", at, &why);
 *     formula_system_rate(&s, "y", "x - 3*y", at, &why);
 *     formula_system_finish(&s, at, &why);
 *
 * A formula may use what came before it.  Each call takes where its words begin
 * in the user's file, for its one line of blame; after STATUS_BAD_SCENE the
 * system is as it was.  It is a plain value without pointers: large (not for
 * the stack), copied by =.
 */
#pragma once

#include "formula.h"
#include "parse.h"
#include "status.h"

enum {
    SYSTEM_PARAMETERS = 100,
    SYSTEM_OBSERVABLES = 8,
    SYSTEM_ENTRIES = FORMULA_DEFINITIONS + SYSTEM_OBSERVABLES + 2,
    SYSTEM_LETTERS = 40000, /* of all formulas */
    SYSTEM_TITLE = 80
};

/* What the axis of a state shows: the state; ln of the state, which is > 0; or
 * the state, which is the same after a period. */
enum formula_chart { CHART_REAL, CHART_POSITIVE, CHART_ANGLE };

struct system_state {
    char name[FORMULA_NAME];
    enum formula_chart chart;
    formula_real period; /* of an angle, else 0 */
    int node;            /* its leaf */
};

struct system_parameter {
    char name[FORMULA_NAME];
    formula_real value;
    int node; /* its leaf: FORMULA_POSITIVE_PARAMETER where value > 0 */
};

struct system_observable {
    char name[FORMULA_NAME];
    char unit[FORMULA_NAME];      /* may be empty */
    char long_name[SYSTEM_TITLE]; /* may be empty */
    int node;
};

/* A formula as typed; text: where it begins in formula_system.text */
struct system_entry {
    enum system_entry_kind { ENTRY_DEFINE, ENTRY_RATE, ENTRY_OBSERVABLE } kind;
    int which; /* of the rates or observables */
    char name[FORMULA_NAME];
    int text;
    int node;
};

struct formula_system {
    struct formula graph;
    struct system_state state[2];
    int states;
    struct system_parameter parameter[SYSTEM_PARAMETERS];
    int parameters;
    struct system_observable observable[SYSTEM_OBSERVABLES];
    int observables;
    int rate[2]; /* nodes: d state/dt; -1: not yet */
    struct system_entry entry[SYSTEM_ENTRIES]; /* in the order of the calls */
    int entries;
    char text[SYSTEM_LETTERS];
    int letters;
};

void formula_system_init(struct formula_system *s);

/* period: a decimal, NULL for 2 pi; of an angle only. */
MUST_CHECK enum status formula_system_state(
    struct formula_system *s, const char *name, enum formula_chart chart,
    const char *period, struct formula_place at, struct fault *why);

/* A decimal, taken as typed. */
MUST_CHECK enum status formula_system_parameter(struct formula_system *s,
                                                const char *name,
                                                const char *decimal,
                                                struct formula_place at,
                                                struct fault *why);

MUST_CHECK enum status formula_system_define(struct formula_system *s,
                                             const char *name, const char *text,
                                             struct formula_place at,
                                             struct fault *why);

/* d name/dt */
MUST_CHECK enum status formula_system_rate(struct formula_system *s,
                                           const char *name, const char *text,
                                           struct formula_place at,
                                           struct fault *why);

/* An integral along every curve, of this rate; unit, long_name: NULL or as
 * people read them. */
MUST_CHECK enum status formula_system_observable(
    struct formula_system *s, const char *name, const char *text,
    const char *unit, const char *long_name, struct formula_place at,
    struct fault *why);

/* Whether all is there: two states, two rates, which after an angle's period
 * are the same again. */
MUST_CHECK enum status formula_system_finish(const struct formula_system *s,
                                             struct formula_place at,
                                             struct fault *why);

/* Whether a formula has the name. */
bool formula_system_uses(const struct formula_system *s, const char *name);

/* Sets a parameter that is there.  Nodes may change with its sign, or where it
 * is an exponent: what was made of them before is to be made again. */
MUST_CHECK enum status formula_system_set(struct formula_system *s,
                                          const char *name, formula_real value,
                                          struct formula_place at,
                                          struct fault *why);

/* -1: there is none */
int formula_system_find_state(const struct formula_system *s, const char *name);
int formula_system_find_parameter(const struct formula_system *s,
                                  const char *name);

/* The entry's formula as typed. */
const char *formula_system_text(const struct formula_system *s,
                                const struct system_entry *e);
