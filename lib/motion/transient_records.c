/* What a run is stored and printed as. */
#include "fate.h"
#include "transient.h"

const char *const transient_end_names[] = {
    "rest",  "arrest", "until_time", "until_slip", "runaway",
    "faded", "lost",   "near",       NULL
};

/* ---- records ------------------------------------------------------------- */

const struct record_type record_transient = RECORD(
    transient_summary, "transient", "a run from a start",
    FIELD(transient_summary, REAL, v, "V_star",
          "slip rate at the start in units of V_star"),
    FIELD(transient_summary, REAL, psi, "psi",
          "interfacial state at the start"),
    FIELD_CODE(transient_summary, fate, fate_names,
               "what becomes of the start"),
    FIELD_CODE(transient_summary, end, transient_end_names,
               "why the run ended"),
    FIELD(transient_summary, QUANTITY, time, "L/V_star",
          "time of the run, unless it runs away, in units of L/V_star"),
    FIELD(
        transient_summary, QUANTITY, slip, "L",
        "slip of the run, unless it runs away; if it fades its limit; in units "
        "of L"),
    FIELD(transient_summary, QUANTITY, mu_mean, "1",
          "mean friction over that slip"),
    FIELD(transient_summary, REAL, energy_defect, "1",
          "relative defect of the balance of energy (27)"),
    FIELD(transient_summary, COUNT, steps, "1", "steps of the finer orbit"),
    FIELD(transient_summary, COUNT, field_evaluations, "1",
          "field evaluations of both orbits"));

const struct record_type record_transient_event =
    RECORD(transient_event, "transient_event", "what happens along a run",
           FIELD_CODE(transient_event, what, moment_names, "what happens"),
           { .name = "level",
             .unit = "1",
             .text = "the value that v, psi, |mu - tan(alpha)| takes",
             .offset = offsetof(struct transient_event, level),
             .kind = RECORD_REAL,
             .units = moment_units },
           TRANSIENT_EVENT_NUMBERS);
