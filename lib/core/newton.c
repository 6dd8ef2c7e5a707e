/* Compiles newton_formula.h once for each kind of number. */
#include "newton.h"

#include <stdbool.h>
#include <tgmath.h>

#define REAL    double
#define NAME(x) x
#include "newton_formula.h"
#undef REAL
#undef NAME

#define REAL    long double
#define NAME(x) x##_long
#include "newton_formula.h"
#undef REAL
#undef NAME
