/* What a run is stored and printed as. */
#include "fate.h"
#include "transient.h"

const char *const transient_end_names[] = {
    "rest",  "arrest", "until_time", "until_slip", "runaway",
    "faded", "lost",   "near",       NULL
};

/* ---- records ------------------------------------------------------------- */

static const struct record_field summary_fields[] = {
    FIELD(transient_summary, REAL, v, "1",
          "slip rate at the start in units of V_star"),
    FIELD(transient_summary, REAL, psi, "1", "interfacial state at the start"),
    FIELD_CODE(transient_summary, fate, fate_names,
               "what becomes of the start"),
    FIELD_CODE(transient_summary, end, transient_end_names,
               "why the run ended"),
    FIELD(transient_summary, QUANTITY, time, "1",
          "time of the run in units of L/V_star"),
    FIELD(transient_summary, QUANTITY, slip, "1",
          "slip of the run in units of L"),
    FIELD(transient_summary, QUANTITY, mu_mean, "1",
          "mean friction over that slip"),
    FIELD(transient_summary, REAL, energy_defect, "1",
          "relative defect of the balance of energy (27)"),
    FIELD(transient_summary, COUNT, steps, "1", "steps of the finer orbit"),
    FIELD(transient_summary, COUNT, field_evaluations, "1",
          "field evaluations of both orbits"),
};
const struct record_type record_transient = RECORD_TYPE(
    "transient", "a run from a start", summary_fields, transient_summary);

static const struct record_field event_fields[] = {
    FIELD_CODE(transient_event, what, moment_names, "what happens"),
    FIELD(transient_event, REAL, level, "1",
          "the value that v, psi, |mu - tan(alpha)| takes"),
    FIELD(transient_event, QUANTITY, time, "1",
          "time since the start in units of L/V_star"),
    FIELD(transient_event, QUANTITY, slip, "1",
          "slip since the start in units of L"),
    FIELD(transient_event, QUANTITY, v, "1", "slip rate in units of V_star"),
    FIELD(transient_event, QUANTITY, psi, "1", "interfacial state"),
    FIELD(transient_event, QUANTITY, mu, "1", "friction coefficient"),
};
const struct record_type record_transient_event =
    RECORD_TYPE("transient_event", "what happens along a run", event_fields,
                transient_event);
