/* method_flow.h -- our own explicit method of order 8 (flow.h) as one of the
 * methods. */
#ifndef RACE_METHOD_FLOW_H
#define RACE_METHOD_FLOW_H

#include "method.h"

extern const struct method method_flow;

#endif
