#include "layout.h"

#include "cells.h"
#include "export_basin.h"
#include "export_diagram.h"
#include "export_rabinowicz.h"
#include "export_sweep.h"
#include "records.h"
#include "release.h"
#include "stress_judge.h"
#include "stress_row.h"
#include "study.h"
#include "transient.h"
#include "workprec_environment.h"
#include "workprec_rank.h"

/* ---- attributes, and axes without a record ------------------------------- */

#define ONE(name_, kind_, unit_, text_)                                        \
    {                                                                          \
        .name = name_, .unit = unit_, .text = text_, .kind = RECORD_##kind_    \
    }
#define GROUP(name)                                                            \
    static const struct record_type name = { .fields = name##_fields,          \
                                             .count = sizeof name##_fields /   \
                                                      sizeof *name##_fields }

static const struct record_field root_fields[] = {
    ONE("Conventions", TEXT, "1", "CF-1.10"),
    ONE("title", TEXT, "1", "the scene's title, or the name of its law"),
};
GROUP(root);

static const struct record_field made_fields[] = {
    ONE("version", TEXT, "1", "of Slipway"),
    ONE("compiler", TEXT, "1", "that compiled it"),
};
GROUP(made);

static const struct record_field scene_fields[] = {
    ONE("scene", TEXT, "1", "the text of the scene; empty without one"),
    ONE("overrides", TEXT, "1", "what options set, KEY=VALUE, one a line"),
    ONE("libraries", TEXT, "1", "and their versions"),
    ONE("law", TEXT, "1", "its name, or composed"),
    ONE("friction", TEXT, "1", "asinh or log"),
    ONE("formula", TEXT, "1", "the law's formulas"),
    ONE("mu_star", REAL, "1", "material.mu_star"),
    ONE("a", REAL, "1", "material.a"),
    ONE("b", REAL, "1", "material.b"),
    ONE("c", REAL, "1", "material.c"),
    ONE("R", REAL, "1", "material.R"),
    ONE("V_c", REAL, "1", "material.V_c"),
    ONE("L", REAL, "m", "material.L, unit of slip"),
    ONE("V_star", REAL, "m s-1", "material.V_star, unit of slip rate"),
    ONE("g", REAL, "m s-2", "gravity"),
    ONE("alpha", REAL, "rad", "slope angle, where the scene has one"),
    ONE("eps2", REAL, "1", "eps^2 = V_star^2/(g L)"),
};
GROUP(scene);

static const struct record_field orbit_fields[] = {
    ONE("end", TEXT, "1",
        "why it ends: arrived, left_window, left_domain, limit, event, "
        "given_up; of simulate a word of transient_end"),
    ONE("energy_defect", REAL, "1", "relative defect of the balance (27)"),
};
GROUP(orbit);

static const struct record_field run_fields[] = {
    ONE("fate", TEXT, "1", "what becomes of the start, a word of fate"),
    ONE("comment", TEXT, "1", "why it is undecided or lost, if it is"),
};
GROUP(run);

static const struct record_field plane_fields[] = {
    ONE("psi", REAL, "1", "interfacial state"),
    ONE("v", REAL, "1", "slip rate in units of V_star"),
};
GROUP(plane);

static const struct record_field share_fields[] = {
    ONE("fraction_{log,linear}_FATE", REAL, "1",
        "share of the window with this fate, by area in (ln v, ln psi), and "
        "in (v, psi); absent where none"),
    ONE("fraction_{log,linear}_FATE_error", REAL, "1", "bound on its error"),
    ONE("audit_cells", COUNT, "1", "cells followed forward in time"),
    ONE("audit_disagreements", COUNT, "1", "those with another fate"),
};
GROUP(share);

static const struct record_field cell_fields[] = {
    ONE("cell_rtol", REAL, "1", "basins.rtol"),
    ONE("cell_arrest", REAL, "1",
        "a state has arrived this near to a node, in ln v and in ln psi"),
};
GROUP(cell);

static const struct record_field spring_fields[] = {
    ONE("sigma", REAL, "Pa", "normal stress"),
    ONE("mass", REAL, "kg m-2", "of the block"),
};
GROUP(spring);

static const struct record_field comment_fields[] = {
    ONE("comment", TEXT, "1", "why there is no curve, if there is none"),
};
GROUP(comment);

static const struct record_field speed_fields[] = {
    ONE("v", REAL, "1", "slip rate"),
};
GROUP(speed);

static const struct record_field sweep_fields[] = {
    ONE("keys", TEXT, "1", "the keys of the axes, in their order"),
    ONE("refine", REAL, "1", "sweep.refine, where the scene has it"),
};
GROUP(sweep);

static const struct record_field impact_fields[] = {
    ONE("K", REAL, "1", "of (22), where masses and restitution are known"),
};
GROUP(impact);

static const struct record_field spline_fields[] = {
    ONE("smoothing", REAL, "1", "as given, or found from the data"),
    ONE("freedom", REAL, "1", "parameters that the curve spends"),
    ONE("reason", TEXT, "1", "instead of all this: why there is no curve"),
};
GROUP(spline);

static const struct record_field race_fields[] = {
    ONE("QUANTITY", TEXT, "1",
        "why this slope has no such quantity, one attribute for each"),
};
GROUP(race);

static const struct record_field outcome_fields[] = {
    ONE("OUTCOME", COUNT, "1", "cases that came to this, one for each word"),
    ONE("counted", COUNT, "1", "cases with a number to judge"),
    ONE("full", COUNT, "1", "those with all digits that conditioning allows"),
};
GROUP(outcome);

/* ---- the table ----------------------------------------------------------- */

#define SCALARS(group, text, type)                                             \
    {                                                                          \
        group, text, LAYOUT_SCALARS, NULL, &(type)                             \
    }
#define COLUMNS(group, text, along, type)                                      \
    {                                                                          \
        group, text, LAYOUT_COLUMNS, along, &(type)                            \
    }
#define AXES(group, text, type)                                                \
    {                                                                          \
        group, text, LAYOUT_AXES, NULL, &(type)                                \
    }
#define LAYERS(group, text, along, type)                                       \
    {                                                                          \
        group, text, LAYOUT_LAYERS, along, &(type)                             \
    }
#define ATTRIBUTES(group, text, type)                                          \
    {                                                                          \
        group, text, LAYOUT_ATTRIBUTES, NULL, &(type)                          \
    }

/* clang-format off */
const struct layout_part layout_table[] = {
    ATTRIBUTES("/", "of every file", root),
    ATTRIBUTES("/provenance", "where the file comes from", made),
    ATTRIBUTES("/provenance", "of all commands but stress", scene),

    COLUMNS("/equilibria", "steady states, by slip rate", "n", record_steady),
    SCALARS("/saddle", "the saddle among them", record_saddle),
    SCALARS("/folds", "product folds or knees: extrema of steady-state "
            "friction", record_folds),
    COLUMNS("/manifold/{stable,unstable}_{upper,lower}",
            "product manifolds: a branch of an invariant manifold of the "
            "saddle, from there on; stable ones also where others need them",
            "arc", record_branch),
    SCALARS("/critical", "product knees: what the stable manifold implies",
            record_critical),
    COLUMNS("/critical/knees_{upper,lower}",
            "product knees: where the branch's slope passes through 1", "n",
            record_knee),
    SCALARS("/critical/sensitivities/{v_plus,v_minus}",
            "product sensitivities: how a critical slip rate answers to the "
            "parameters", record_sensitivity),
    COLUMNS("/taylor_series", "product taylor_series: the stable manifold as a "
            "power series in v", "order", record_taylor_term),
    SCALARS("/taylor_series", NULL, record_taylor),
    SCALARS("/estimates", "product estimates: the analytic estimates of the "
            "paper's section 4", record_estimates),
    COLUMNS("/estimates/xi", "those in eigen-coordinates, (38)", "xi",
            record_xi),
    COLUMNS("/nullcline/{v,psi}_K", "product nullclines: a piece of the curve "
            "where v (psi) does not change", "arc", record_nullcline),
    COLUMNS("/field_arrows", "product field_arrows: the direction field", "n",
            record_arrow),
    COLUMNS("/trajectory_K", "product trajectories, and simulate: a forward "
            "orbit", "time", record_trajectory),
    ATTRIBUTES("/trajectory_K", NULL, orbit),
    ATTRIBUTES("/trajectory_K", "simulate", run),
    COLUMNS("/trajectory_K/linear_slip", "simulate: samples evenly over slip",
            "slip", record_trajectory),
    COLUMNS("/trajectory_K/log_time", "simulate: samples evenly over the "
            "logarithm of time", "time", record_trajectory),
    SCALARS("/trajectory_K/summary", "simulate: the run as a whole",
            record_transient),
    COLUMNS("/trajectory_K/events", "simulate: what happens along it", "n",
            record_transient_event),
    COLUMNS("/trajectory_K/phases", "simulate: the three phases of sliding of "
            "the paper's section 4.4", "n", record_phase),

    AXES("/basin", "product basins, and those beside it: a grid of states",
         plane),
    LAYERS("/basin", "label with basins, the others with margin", "psi, v",
           record_basin),
    LAYERS("/basin", "products slip, time, friction (mu_mean), peak (v_peak, "
           "mu_peak); with any of them exit_reason. Slip and time run to "
           "arrest; a value is NaN where there is none", "psi, v", record_cell),
    ATTRIBUTES("/basin", NULL, share),
    ATTRIBUTES("/basin", "with fields of cells", cell),
    COLUMNS("/basin/disagreement", "where the audit disagrees, if it does; the "
            "command then exits with 3", "n", record_disagreement),

    COLUMNS("/friction_law", "product friction_law, Fig 1(a)", "v",
            record_friction),
    COLUMNS("/friction_law/dieterich", "the same of Dieterich's law, beside "
            "another", "v", record_friction),
    COLUMNS("/friction_law/extrema", "extrema of mu_ss", "n", record_extremum),
    COLUMNS("/spring_block", "product spring_block, Fig 1(b): steady sliding "
            "is unstable below this stiffness", "v", record_spring),
    ATTRIBUTES("/spring_block", NULL, spring),
    COLUMNS("/spring_block/dieterich", "the same of Dieterich's law, beside "
            "another", "v", record_spring),
    COLUMNS("/spring_block/extrema", "extrema of mu_ss", "n", record_extremum),
    COLUMNS("/bifurcation", "product bifurcation, Fig 3", "v",
            record_bifurcation),
    COLUMNS("/bifurcation/folds", "where two steady states meet", "n",
            record_extremum),
    COLUMNS("/fold_curves", "product fold_curves, Fig 4", "c",
            record_fold_curve),
    ATTRIBUTES("/fold_curves", NULL, comment),
    SCALARS("/fold_curves/cusp", "where both folds meet", record_cusp),
    COLUMNS("/chi", "product chi, Fig 10", "alpha", record_chi_slope),
    AXES("/chi", NULL, speed),
    LAYERS("/chi", NULL, "alpha, v", record_chi),

    ATTRIBUTES("/sweep", "sweep: the numbers of a study over one key or more; "
               "its axes and columns are below", sweep),
    ATTRIBUTES("/sweep", "with fields of cells", cell),
    COLUMNS("/sweep", "with starts, the same at all points", "start",
            record_sweep_start),

    COLUMNS("/rabinowicz/release", "rabinowicz: critical release distances of "
            "the law", "n", record_release),
    ATTRIBUTES("/rabinowicz/release", NULL, impact),
    COLUMNS("/rabinowicz/{l_k,x_k}", "with data: release distances, "
            "persistence lengths as measured", "n", record_measured),
    SCALARS("/rabinowicz/fit", "with l_k: the fit of (33)", record_parabola),
    SCALARS("/rabinowicz/fit", NULL, record_release_material),
    COLUMNS("/rabinowicz/slip", "with l_k: friction against slip, (25)", "mu",
            record_slip_point),
    ATTRIBUTES("/rabinowicz/slip", NULL, spline),
    SCALARS("/rabinowicz/persistence", "with x_k: the fit of (30)",
            record_persistence),

    COLUMNS("/workprec", "workprec: methods at tolerances", "n",
            record_workprec_run),
    ATTRIBUTES("/workprec", NULL, race),
    COLUMNS("/workprec/fastest", "who is fastest at an accuracy", "n",
            record_workprec_fastest),
    SCALARS("/workprec/environment", "where times were measured",
            record_workprec_environment),
    COLUMNS("/stress", "stress: its cases", "n", record_stress),
    ATTRIBUTES("/stress", NULL, outcome),
    { .group = NULL },
};
/* clang-format on */
