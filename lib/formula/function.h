/*
 * function.h -- the functions of formulas: those that people type, and those
 * in which differences are written (lines.h), as text for programs that know
 * exp, ln, sqrt, sinh, cosh, tanh, sin, cos, tan, asin, atan, abs, sign, max,
 * min and if(..)then(..)else(..) and nothing more, to some units of a double's
 * last digit.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* Those that come after need those before only. */
enum formula_function {
    FUNCTION_EXP,
    FUNCTION_LN,
    FUNCTION_SQRT,
    FUNCTION_SINH,
    FUNCTION_TAN,
    FUNCTION_ABS,
    FUNCTION_MAX,
    FUNCTION_SIN,
    FUNCTION_COS,
    FUNCTION_COSH,
    FUNCTION_TANH,
    FUNCTION_ASIN,
    FUNCTION_ATAN,
    FUNCTION_POWER,
    FUNCTION_EM1,
    FUNCTION_LN1P,
    FUNCTION_ASINH,
    FUNCTION_CHOOSE,
    FUNCTION_LAMSTEP,
    FUNCTION_LAMBERT,
    FUNCTION_GROWTH,
    FUNCTION_APART,
    FUNCTION_SINHS,
    FUNCTION_MIXED,
    FUNCTION_ASINHEXP,
    FUNCTION_BENDFAR,
    FUNCTION_BENDNEAR,
    FUNCTION_BEND,
    FUNCTIONS
};

enum { FUNCTION_ARGUMENTS = 4 };

struct function {
    const char *typed;     /* the name that people type; NULL: none */
    const char *name;      /* and the one that is written */
    const char *arguments; /* "p_,u_": their names, unlike any other name */
    const char *body;      /* NULL: every program knows it */
    const char *meaning;
};

extern const struct function functions[FUNCTIONS];

/* How many arguments it has. */
int function_arguments(enum formula_function f);

/* Whether `text` calls a function of this name. */
bool function_is_called(const char *text, const char *name);

/* Adds to needed[] those that the needed ones call. */
void function_complete(bool needed[FUNCTIONS]);
