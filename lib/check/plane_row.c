#include "plane_row.h"

#include <stdlib.h>
#include <string.h>

#include "scene_scatter.h"
#include "text.h"

const char *const plane_row_columns[] = { "scene", "set", NULL };

bool plane_row_is(const struct table *t)
{
    for (size_t i = 0; i < t->columns; i++)
        if (text_index(table_header(t, i)->text, plane_row_columns) >= 0)
            return true;
    return false;
}

/* The lines of *text, which is cut; their number.  NULL without memory; owned
 * by the caller. */
static char **cut_lines(char *text, size_t *count)
{
    size_t most = 1;

    for (const char *at = text; (at = strchr(at, '\n')) != NULL; at++)
        most++;
    char **line = calloc(most, sizeof *line);
    *count = 0;
    for (char *part; line && (part = strsep(&text, "\n")) != NULL;)
        if (*part)
            line[(*count)++] = part;
    return line;
}

enum status plane_row_read(const struct table *t, size_t row, unsigned products,
                           struct scene *scene, struct fault *why)
{
    const struct table_cell *file = table_find(t, row, "scene");
    const struct table_cell *set = table_find(t, row, "set");
    char *text = strdup(set ? set->text : "");
    size_t lines = 0;
    char **line = text ? cut_lines(text, &lines) : NULL;

    enum status status =
        line ? scene_read(scene, file ? file->text : NULL, line, lines, why)
             : STATUS_NO_MEMORY;
    free(line);
    free(text);
    if (status == STATUS_OK && scene->system == NULL) {
        scene_free(scene);
        status = place_blame(table_place(t, table_at(t, row, 0)), why,
                             "a law on a slope, expected a system, or a table "
                             "of laws with columns law, alpha, ...");
    }
    if (status == STATUS_OK)
        status = scene_scatter_refuse(scene, "check", why);
    if (status == STATUS_OK)
        scene->products = products;
    return status;
}
