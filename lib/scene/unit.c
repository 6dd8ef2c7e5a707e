#include "unit.h"

#include <stdio.h>
#include <string.h>

#include "number.h"

static const char *const names[][3] = {
    [DIMENSION_NONE] = { "", "", "" },
    [DIMENSION_RATE] = { "", "m/s", "V_star" },
    [DIMENSION_TIME] = { "", "s", "L/V_star" },
    [DIMENSION_LENGTH] = { "", "m", "L" },
};

/* Room for every number that number_read takes. */
enum { LETTERS = 1024 };

const char *unit_name(enum dimension d, enum unit u)
{
    return names[d][u];
}

double unit_scale(enum dimension d, const struct material *m)
{
    switch (d) {
        case DIMENSION_RATE:
            return m->V_star;
        case DIMENSION_TIME:
            return m->L / m->V_star;
        case DIMENSION_LENGTH:
            return m->L;
        default:
            return 1.0;
    }
}

/* The number before a unit; false: it does not end in one. */
static bool read_before(const char *text, const char *name, double *value)
{
    const size_t size = strlen(text), tail = strlen(name);
    char number[LETTERS];

    if (size <= tail || size >= LETTERS ||
        strcmp(text + size - tail, name) != 0)
        return false;
    snprintf(number, sizeof number, "%.*s", (int) (size - tail), text);
    for (size_t end = size - tail;
         tail > 0 && end > 0 && number[end - 1] == ' ';)
        number[--end] = '\0';
    return number_read(number, value);
}

bool unit_read(enum dimension d, const char *text, double *value,
               enum unit *unit)
{
    for (int u = UNIT_BARE; u <= UNIT_OWN; u++)
        if ((u == UNIT_BARE || names[d][u][0]) &&
            read_before(text, names[d][u], value)) {
            *unit = (enum unit) u;
            return true;
        }
    return false;
}
