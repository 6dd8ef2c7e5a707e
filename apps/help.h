/* help.h -- what slipway says of itself, out of its two tables. */
#ifndef APPS_HELP_H
#define APPS_HELP_H

#include <stdio.h>

#include "options.h"

/* A command, its options and an example; of NULL: all commands and options. */
void help_print(FILE *out, const struct command *c);

#endif
