/* completion.h -- what a shell offers after Tab, out of the tables of commands
 * and options, the laws and the keys of scenes. */
#ifndef APPS_COMPLETION_H
#define APPS_COMPLETION_H

#include <stdio.h>

/* A script for "bash", "zsh" or "fish"; nothing for others. */
void completion_print(FILE *out, const char *shell);

#endif
