/* report_transient.h -- runs as text for people and as JSON for programs. */
#ifndef APPS_REPORT_TRANSIENT_H
#define APPS_REPORT_TRANSIENT_H

#include <stdio.h>

#include "json.h"
#include "simulation.h"

/* Of each run its end, the balance of energy, phases and events. */
void report_simulation_print(FILE *out, const struct simulation *s);

/* {"trajectories": [{v psi fate end time slip mu_mean energy_defect steps
 * field_evaluations reason phases[3] events[]}]}; owned by the caller. */
json_t *report_simulation_json(const struct simulation *s);

#endif
