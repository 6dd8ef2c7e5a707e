/* completion.h -- what a shell offers after Tab, out of the tables of commands
 * and options, the laws and the keys of scenes. */
#ifndef APPS_COMPLETION_H
#define APPS_COMPLETION_H

#include <stdio.h>

#include "command.h"

/* A script for "bash", "zsh" or "fish"; complains of other names. */
enum exit_code completion_print(FILE *out, const char *shell);

#endif
