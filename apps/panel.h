/* panel.h -- the file names of a figure of several panels. */
#ifndef APPS_PANEL_H
#define APPS_PANEL_H

#include <stdbool.h>

enum { PANEL_PATH = 4096 };

/* "a.svg", "_time" -> "a_time.svg"; false if that is too long. */
bool panel_path(const char *path, const char *panel, char out[PANEL_PATH]);

#endif
