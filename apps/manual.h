/* manual.h -- man pages out of the tables of commands and options, so that
 * they say what the program does. */
#pragma once

#include <stdio.h>

#include "catalogue.h"

/* slipway(1): all commands and all options, in roff's man macros. */
void manual_print(FILE *out);

/* slipway-COMMAND(1): one command and the options that it takes. */
void manual_print_command(FILE *out, const struct command *c);
