#include "panel.h"

#include <stdio.h>
#include <string.h>

bool panel_path(const char *path, const char *panel, char out[PANEL_PATH])
{
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    const char *end =
        dot && (!slash || dot > slash) ? dot : path + strlen(path);

    return snprintf(out, PANEL_PATH, "%.*s%s%s", (int) (end - path), path,
                    panel, end) < PANEL_PATH;
}
