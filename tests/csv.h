/* csv.h -- reads the reference tables, by column name. */
#pragma once

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CSV_COLUMNS = 64, CSV_LINE = 4096 };

struct csv {
    FILE *file;
    char head[CSV_LINE], line[CSV_LINE];
    char *name[CSV_COLUMNS], *cell[CSV_COLUMNS];
    size_t columns, row;
};

static inline size_t csv_split(char *line, char *cell[])
{
    size_t n = 0;

    line[strcspn(line, "\r\n")] = '\0';
    for (char *p = line; p && n < CSV_COLUMNS; n++) {
        cell[n] = p;
        p = strchr(p, ',');
        if (p)
            *p++ = '\0';
    }
    return n;
}

/* tests/reference/NAME under SOURCE_ROOT; exits if it is not there. */
static inline void csv_open(struct csv *c, const char *name)
{
    char path[1024];
    const char *root = getenv("SOURCE_ROOT");

    snprintf(path, sizeof path, "%s/tests/reference/%s", root ? root : ".",
             name);
    c->file = fopen(path, "r");
    if (c->file == NULL || fgets(c->head, CSV_LINE, c->file) == NULL) {
        fprintf(stderr, "cannot read %s\n", path);
        exit(EXIT_FAILURE);
    }
    c->columns = csv_split(c->head, c->name);
    c->row = 1;
}

/* The next row; 0 and closed at the end. */
static inline int csv_next(struct csv *c)
{
    if (fgets(c->line, CSV_LINE, c->file) == NULL) {
        fclose(c->file);
        return 0;
    }
    const size_t n = csv_split(c->line, c->cell);
    for (size_t i = n; i < c->columns; i++)
        c->cell[i] = c->line + strlen(c->line);
    c->row++;
    return 1;
}

/* The cell as text; "" if empty or if there is no such column. */
static inline const char *csv_text(const struct csv *c, const char *name)
{
    for (size_t i = 0; i < c->columns; i++)
        if (strcmp(c->name[i], name) == 0)
            return c->cell[i];
    return "";
}

/* The cell as a number, or `none` where it is empty or "none". */
static inline double csv_number(const struct csv *c, const char *name,
                                double none)
{
    char *end;
    const char *text = csv_text(c, name);
    const double value = strtod(text, &end);

    return end == text || strcmp(text, "none") == 0 ? none : value;
}
