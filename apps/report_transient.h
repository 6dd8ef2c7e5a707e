/* report_transient.h -- runs as text. */
#ifndef APPS_REPORT_TRANSIENT_H
#define APPS_REPORT_TRANSIENT_H

#include <stdio.h>

#include "simulation.h"

/* Of each run its end, the balance of energy, phases and events. */
void report_simulation_print(FILE *out, const struct simulation *s);

#endif
