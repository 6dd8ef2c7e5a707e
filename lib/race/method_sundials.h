/* method_sundials.h -- SUNDIALS' CVODE and ARKODE where they were found. */
#ifndef RACE_METHOD_SUNDIALS_H
#define RACE_METHOD_SUNDIALS_H

#include "method.h"

enum { METHOD_SUNDIALS_MOST = 3 };
extern const struct method method_sundials[METHOD_SUNDIALS_MOST];
extern const size_t method_sundials_count; /* 0: not found */

#endif
