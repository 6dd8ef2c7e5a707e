#include "stress_row.h"

#include "law.h"
#include "stress_case.h"
#include "stress_judge.h"

void stress_row_say(struct stress_row *row, int outcome, const char *reason,
                    const char *worst)
{
    if (row->reason && outcome <= row->outcome)
        return;
    row->outcome = (int8_t) outcome;
    row->reason = reason;
    row->worst = worst;
}

static const char *const agreement_names[] = { "no", "yes", NULL };

const struct record_type record_stress = RECORD(
    stress_row, "stress", "stiff and extreme cases",
    FIELD(stress_row, TEXT, name, "1", "name of the case"),
    FIELD(stress_row, TEXT, law, "1", "friction law"),
    FIELD_CODE(stress_row, form, friction_form_names, "friction form"),
    FIELD(stress_row, TEXT, settings, "1", "the options that make the case"),
    FIELD_CODE(stress_row, kind, stress_kind_names,
               "what is asked of the case"),
    FIELD_CODE(stress_row, outcome, stress_outcome_names, "what it came to"),
    FIELD(stress_row, REAL, digits, "1",
          "least digits got of a number, by the 113-bit oracle"),
    FIELD(stress_row, REAL, allowed, "1",
          "least digits that rounding of the inputs leaves"),
    FIELD(stress_row, REAL, missing, "1",
          "most digits a number lacks of those"),
    FIELD(stress_row, REAL, bar, "1", "largest true error over reported error"),
    FIELD(stress_row, TEXT, worst, "1", "the number that lacks most digits"),
    FIELD(stress_row, COUNT, steps, "1",
          "steps of branches or orbits, labels, or cells looked at"),
    FIELD(stress_row, REAL, seconds, "s", "time taken by the program"),
    FIELD(stress_row, REAL, oracle_seconds, "s", "time taken by the oracle"),
    FIELD(stress_row, COUNT, oracle_evaluations, "1",
          "field evaluations of the oracle, or steps of its orbits"),
    FIELD_CODE(stress_row, agree, agreement_names,
               "whether the two routes agree"),
    FIELD(stress_row, TEXT, reason, "1", "why the case is not exact"));
