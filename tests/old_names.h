/* old_names.h -- rows of the reference tables, whose names are older than
 * those of slipway check, as tables of today (tests/reference/names.csv: now is
 * empty for what a check does not state; K is the number of the state). */
#pragma once

#include <math.h>

#include "csv.h"

/* The rest of a file.csv. */
struct old_table {
    struct csv csv;
    char now[CSV_COLUMNS][48]; /* names of its columns */
    char slope[CSV_LINE];      /* of the last row of equilibria.csv */
    size_t state;              /* of that slope, by v */
};

static inline void old_open(struct old_table *t, const char *file)
{
    struct csv names;

    *t = (struct old_table){ .state = 0 };
    csv_open(&t->csv, file);
    for (size_t i = 0; i < t->csv.columns; i++)
        snprintf(t->now[i], sizeof t->now[i], "%s", t->csv.name[i]);
    csv_open(&names, "names.csv");
    while (csv_next(&names)) {
        const char *table = csv_text(&names, "table");
        for (size_t i = 0; i < t->csv.columns; i++)
            if (strncmp(file, table, strlen(table)) == 0 &&
                strcmp(t->csv.name[i], csv_text(&names, "old")) == 0)
                snprintf(t->now[i], sizeof t->now[i], "%s",
                         csv_text(&names, "now"));
    }
}

/* The next row; 0 and closed at the end. */
static inline int old_next(struct old_table *t)
{
    char slope[CSV_LINE] = "";

    if (!csv_next(&t->csv))
        return 0;
    for (size_t i = 0; strcmp(t->csv.name[i], "type") != 0; i++) {
        strcat(strcat(slope, t->csv.cell[i]), ",");
        if (i + 1 == t->csv.columns)
            return 1;
    }
    t->state = strcmp(slope, t->slope) == 0 ? t->state + 1 : 0;
    strcpy(t->slope, slope);
    return 1;
}

/* What a number's column is called today; "" if a check does not state it:
 * ruina's lower branches at small alpha were not followed to their end, and the
 * derivative of psi_at_v0 is no sensitivity. */
static inline void old_name(const struct old_table *t, size_t i, char name[48])
{
    const bool no_limit = strcmp(csv_text(&t->csv, "lower_end"), "psi_0") != 0;
    const bool gave_up = strcmp(t->csv.cell[i], "psi_minus_inf_truncated") == 0;

    strcpy(name, t->now[i]);
    if (gave_up ||
        (no_limit && strcmp(name, "sensitivities_v_minus_alpha") == 0))
        name[0] = '\0';
    if (strchr(name, 'K'))
        *strchr(name, 'K') = (char) ('0' + t->state);
}

/* Derivatives have nine digits, and those that rounding alpha costs. */
static inline double old_tolerance(const struct csv *c, const char *name)
{
    const char *digits = strstr(name, "v_plus") ? "digits_lost_alpha_vplus"
                                                : "digits_lost_alpha_lower";

    return strncmp(name, "sensitivities_", 14) == 0
               ? 1e-9 + pow(10.0, csv_number(c, digits, 0.0) - 12.0)
               : 0.0;
}

/* A table of this row, number `planted` of its cells being `cell`. */
static inline void old_write(const struct old_table *t, size_t planted,
                             const char *cell, char *text, size_t size)
{
    char head[CSV_LINE] = "", row[CSV_LINE] = "";

    for (size_t i = 0; i < t->csv.columns; i++) {
        char name[48];
        const char *what = i == planted ? cell : t->csv.cell[i];
        const size_t h = strlen(head), r = strlen(row);
        old_name(t, i, name);
        const double tolerance = old_tolerance(&t->csv, name);
        const char *comma = h > 0 ? "," : "";
        if (name[0] && tolerance > 0.0) {
            snprintf(head + h, sizeof head - h, "%s%s,%s_tol", comma, name,
                     name);
            snprintf(row + r, sizeof row - r, "%s%s,%.3g", comma, what,
                     tolerance * fabs(strtod(t->csv.cell[i], NULL)));
        } else if (name[0]) {
            snprintf(head + h, sizeof head - h, "%s%s", comma, name);
            snprintf(row + r, sizeof row - r, "%s%s", comma, what);
        }
    }
    snprintf(text, size, "%s\n%s\n", head, row);
}
