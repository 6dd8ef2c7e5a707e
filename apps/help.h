/* help.h -- what slipway says of itself, out of its two tables. */
#pragma once

#include <stdio.h>

#include "options.h"

/* A command, its options and an example; of NULL: all commands and options. */
void help_print(FILE *out, const struct command *c);
