#include "real_tape.h"

#include <math.h>

#include "quad.h"

#define SCALAR  double
#define KIND(f) real_##f
#define FN(f)   f
#include "number_tape_formula.h"
