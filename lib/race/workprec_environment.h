/* workprec_environment.h -- where times were measured. */
#pragma once

#include <stdbool.h>

#include "record.h"

enum { WORKPREC_TEXT = 160 };

struct workprec_environment {
    const char *cpu, *system; /* into the texts below: must not move */
    const char *compiler, *flags;
    const char *gsl, *sundials;
    double clock_overhead; /* s */
    char cpu_text[WORKPREC_TEXT], system_text[WORKPREC_TEXT];
};
extern const struct record_type record_workprec_environment;

/* Fills *e, which must not move; what cannot be found out is "unknown". */
void workprec_environment_find(struct workprec_environment *e);
