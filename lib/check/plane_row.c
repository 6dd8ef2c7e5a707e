#include "plane_row.h"

#include <stdlib.h>
#include <string.h>

const char *const plane_row_columns[] = { "scene", "set", NULL };

enum { SETS = 64 };

bool plane_row_is(const struct table *t)
{
    for (size_t i = 0; i < t->columns; i++)
        for (const char *const *c = plane_row_columns; *c; c++)
            if (strcmp(table_header(t, i)->text, *c) == 0)
                return true;
    return false;
}

/* Cuts the lines of *text, which it changes; their number. */
static size_t cut_lines(char *text, char *line[SETS])
{
    size_t n = 0;

    for (char *rest = NULL, *at = strtok_r(text, "\n", &rest); at && n < SETS;
         at = strtok_r(NULL, "\n", &rest))
        line[n++] = at;
    return n;
}

enum status plane_row_read(const struct table *t, size_t row, unsigned products,
                           struct scene *scene, struct fault *why)
{
    const struct table_cell *file = table_find(t, row, "scene");
    const struct table_cell *set = table_find(t, row, "set");
    char *line[SETS], *text = strdup(set ? set->text : "");

    if (text == NULL)
        return STATUS_NO_MEMORY;
    const size_t lines = cut_lines(text, line);
    enum status status =
        scene_read(scene, file ? file->text : NULL, line, lines, why);
    free(text);
    if (status == STATUS_OK && scene->system == NULL) {
        scene_free(scene);
        status = place_blame(table_place(t, table_at(t, row, 0)), why,
                             "a law on a slope, expected a system, or a table "
                             "of laws with columns law, alpha, ...");
    }
    if (status == STATUS_OK)
        scene->products = products;
    return status;
}
