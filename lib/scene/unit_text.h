/* unit_text.h -- numbers with a unit behind them, "8e-3 m/s" or "8000 V_star":
 * the SI's or the scene's own (unit.h). */
#pragma once

#include <stdbool.h>

#include "unit.h"

enum unit_text { UNIT_TEXT_BARE, UNIT_TEXT_SI, UNIT_TEXT_OWN };

/* " m/s" or " V_star", "" for bare numbers. */
struct unit_text_name {
    char text[16];
};
struct unit_text_name unit_text_name(const struct unit *unit,
                                     enum unit_text in);

/* That of a key or column that may stand behind a number; NULL: none may. */
const struct unit *unit_text_of(const char *own);

/* A number as number_read takes it, and perhaps a unit, with blanks between or
 * without; unit NULL: without.  False, nothing touched, for anything else. */
bool unit_text_read(const struct unit *unit, const char *text, double *value,
                    enum unit_text *in);
