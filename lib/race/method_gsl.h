/* method_gsl.h -- GSL's ordinary differential equation steppers as its manual
 * has them used: a driver with the error of y controlled, stepped by hand. */
#ifndef RACE_METHOD_GSL_H
#define RACE_METHOD_GSL_H

#include "method.h"

enum { METHOD_GSL_COUNT = 5 };
extern const struct method method_gsl[METHOD_GSL_COUNT];

#endif
