#include "unit_text.h"

#include <stdio.h>
#include <string.h>

#include "number.h"

/* Room for every number that number_read takes. */
enum { LETTERS = 1024 };

const struct unit *unit_text_of(const char *own)
{
    return unit_factor(own) ? unit_find(own) : NULL;
}

static const char *name_of(const struct unit *unit, enum unit_text in)
{
    if (unit == NULL || in == UNIT_TEXT_BARE)
        return "";
    return in == UNIT_TEXT_SI ? unit->si : unit->own;
}

struct unit_text_name unit_text_name(const struct unit *unit, enum unit_text in)
{
    struct unit_text_name name;
    const char *text = name_of(unit, in);

    snprintf(name.text, sizeof name.text, "%s%s", text[0] ? " " : "", text);
    return name;
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

bool unit_text_read(const struct unit *unit, const char *text, double *value,
                    enum unit_text *in)
{
    for (int m = UNIT_TEXT_BARE; m <= (unit ? UNIT_TEXT_OWN : UNIT_TEXT_BARE);
         m++)
        if (read_before(text, name_of(unit, (enum unit_text) m), value)) {
            *in = (enum unit_text) m;
            return true;
        }
    return false;
}
