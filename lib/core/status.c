#include "status.h"

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
