/* key.h -- the legend drawn: texts and samples of what they name. */
#pragma once

#include <stdio.h>

#include "layout.h"

/* Commands that stand before the plot command. */
void key_write(FILE *out, const struct layout *p, const struct legend *l);
