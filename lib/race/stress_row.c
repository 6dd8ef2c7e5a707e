#include "stress_row.h"

#include <time.h>

#include "law.h"
#include "stress_case.h"
#include "stress_judge.h"

double stress_clock(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double) t.tv_sec + 1e-9 * (double) t.tv_nsec;
}

static const char *const agreement_names[] = { "no", "yes", NULL };

#define FIELD(kind_, member, unit_, text_)                                     \
    {                                                                          \
        .name = #member, .unit = unit_, .text = text_,                         \
        .offset = offsetof(struct stress_row, member), .kind = kind_           \
    }
#define REAL(member, unit, text) FIELD(RECORD_REAL, member, unit, text)
#define COUNT(member, text)      FIELD(RECORD_COUNT, member, "1", text)
#define TEXT(member, text)       FIELD(RECORD_TEXT, member, "1", text)
#define CODE(member, text_, words)                                             \
    {                                                                          \
        .name = #member, .unit = "1", .text = text_,                           \
        .offset = offsetof(struct stress_row, member), .kind = RECORD_CODE,    \
        .codes = words                                                         \
    }

static const struct record_field fields[] = {
    TEXT(name, "name of the case"),
    TEXT(law, "friction law"),
    CODE(form, "friction form", friction_form_names),
    TEXT(settings, "the options that make the case"),
    CODE(kind, "what is asked of the case", stress_kind_names),
    CODE(outcome, "what it came to", stress_outcome_names),
    REAL(digits, "1", "least digits got of a number, by the 113-bit oracle"),
    REAL(allowed, "1", "least digits that rounding of the inputs leaves"),
    REAL(missing, "1", "most digits a number lacks of those"),
    REAL(bar, "1", "largest true error over reported error"),
    TEXT(worst, "the number that lacks most digits"),
    COUNT(steps, "steps of branches or orbits, or labels"),
    REAL(seconds, "s", "time taken by the program"),
    REAL(oracle_seconds, "s", "time taken by the oracle"),
    COUNT(oracle_evaluations, "field evaluations of the oracle"),
    CODE(agree, "whether the two routes agree", agreement_names),
    TEXT(reason, "why the case is not exact"),
};

const struct record_type record_stress = { "stress", "stiff and extreme cases",
                                           fields,
                                           sizeof fields / sizeof *fields,
                                           sizeof(struct stress_row) };
