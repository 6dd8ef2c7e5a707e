#include "status.h"

#include <stdarg.h>
#include <stdio.h>

const char *status_text(enum status s)
{
#define STATUS_AS_CASE(name, text)                                             \
    case name:                                                                 \
        return text;
    switch (s) {
        STATUS_LIST(STATUS_AS_CASE)
        case STATUS_COUNT:
            break;
    }
#undef STATUS_AS_CASE
    return "not a status";
}

enum status fault_set(struct fault *why, enum status s, const char *format, ...)
{
    va_list list;

    va_start(list, format);
    vsnprintf(why->text, sizeof why->text, format, list);
    va_end(list);
    return s;
}
