#include "real_tape.h"

#include <math.h>

#define TAPE_SCALAR    double
#define TAPE_CONSTANT  long double
#define CONSTANT_FN(f) f##l
#define TAPE_KIND(f)   real_##f
#define SCALAR         double
#define FN(f)          f
#include "number_tape_formula.h"
