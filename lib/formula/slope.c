#include "slope.h"

#include <math.h>

#include "quad.h"

#define SCALAR  long double
#define KIND(f) formula_long_##f
#define FN(f)   f##l
#include "slope_formula.h"
#undef SCALAR
#undef KIND
#undef FN

#define SCALAR  quad
#define KIND(f) formula_##f
#define FN(f)   f##q
#include "slope_formula.h"
