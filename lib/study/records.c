#include "records.h"

#include "study_results.h"

const char *const end_names[] = { "psi_inf", "open",      "psi_0",
                                  "v_0",     "truncated", NULL };

const struct record_type record_steady = RECORD(
    steady_number, "equilibria", "steady states",
    FIELD_CODE(steady_number, type, equilibrium_type_names, "linear type"),
    FIELD(steady_number, QUANTITY, v, "V_star", "slip rate in units of V_star"),
    FIELD(steady_number, QUANTITY, psi, "psi", "interfacial state"),
    FIELD(steady_number, QUANTITY, mu, "1", "friction coefficient"),
    FIELD(steady_number, QUANTITY, lambda_minus, "V_star/L",
          "smaller eigenvalue, per L/V_star"),
    FIELD(steady_number, QUANTITY, lambda_plus, "V_star/L",
          "larger eigenvalue, per L/V_star"));

const struct record_type record_folds = RECORD(
    fold_numbers, "folds", "extrema of steady-state friction",
    FIELD(fold_numbers, QUANTITY, alpha_cm, "rad",
          "slope angle of the fold at the minimum of mu_ss, (16)"),
    FIELD(fold_numbers, QUANTITY, alpha_cM, "rad",
          "slope angle of the fold at the maximum of mu_ss, (16)"),
    FIELD(fold_numbers, QUANTITY, v_m, "V_star",
          "slip rate at the minimum of mu_ss"),
    FIELD(fold_numbers, QUANTITY, v_M, "V_star",
          "slip rate at the maximum of mu_ss"),
    FIELD(fold_numbers, QUANTITY, mu_s, "1",
          "static friction mu_ss(v_M), (15)"),
    FIELD(fold_numbers, QUANTITY, v_M_eq11, "V_star", "estimate of v_M, (11)"),
    FIELD(fold_numbers, QUANTITY, v_m_eq12, "V_star", "estimate of v_m, (12)"),
    FIELD(fold_numbers, QUANTITY, c_cusp, "1",
          "c at which both folds meet, Fig 4"),
    FIELD(fold_numbers, QUANTITY, alpha_cusp, "rad",
          "slope angle of that cusp"));

const struct record_type record_saddle = RECORD(
    saddle_numbers, "saddle", "the saddle",
    FIELD(saddle_numbers, QUANTITY, v, "V_star", "slip rate at the saddle"),
    FIELD(saddle_numbers, QUANTITY, psi, "psi",
          "interfacial state at the saddle"),
    FIELD(saddle_numbers, QUANTITY, lambda_minus, "V_star/L",
          "stable eigenvalue, per L/V_star"),
    FIELD(saddle_numbers, QUANTITY, lambda_plus, "V_star/L",
          "unstable eigenvalue, per L/V_star"));

const struct record_type record_critical = RECORD(
    critical_numbers, "critical", "what the saddle's stable manifold implies",
    FIELD_CODE(critical_numbers, upper_end, end_names,
               "how the upper branch ends"),
    FIELD_CODE(critical_numbers, lower_end, end_names,
               "how the lower branch ends"),
    FIELD(critical_numbers, QUANTITY, v_plus, "V_star",
          "critical slip rate: limit of v as psi -> infinity"),
    FIELD(critical_numbers, QUANTITY, ln_v_plus, "ln(V_star)",
          "its natural logarithm"),
    FIELD(critical_numbers, QUANTITY, v_minus, "V_star",
          "critical slip rate: limit of v as psi -> 0"),
    FIELD(critical_numbers, QUANTITY, ln_v_minus, "ln(V_star)",
          "its natural logarithm"),
    FIELD(critical_numbers, QUANTITY, psi_at_v0, "psi",
          "interfacial state where the lower branch meets v = 0"),
    FIELD(critical_numbers, QUANTITY, x_excess, "L",
          "integral of (v - v_sp) dt along the upper branch, units of L"),
    FIELD(critical_numbers, QUANTITY, x_deficit, "L",
          "integral of |v - v_sp| dt along the lower branch, units of L"),
    FIELD(critical_numbers, QUANTITY, mu_s_num, "1",
          "static friction (41) with exact v_plus and x_excess"),
    FIELD(critical_numbers, QUANTITY, mu_s_mean, "1",
          "mean friction along the upper branch, weight v - v_sp"),
    FIELD(critical_numbers, QUANTITY, fracture_energy, "L",
          "(mu_s_num - tan(alpha)) x_excess"));

const struct record_type record_knee = RECORD(
    knee_number, "knee", "where the slope rises through 1",
    FIELD(knee_number, QUANTITY, v, "V_star", "slip rate at the knee"),
    FIELD(knee_number, QUANTITY, psi, "psi", "interfacial state at the knee"));

const struct record_type record_branch = RECORD(
    branch_row, "branch", "one branch of an invariant manifold of the saddle",
    FIELD(branch_row, REAL, arc, "1",
          "arc length from the saddle in (ln v, ln psi)"),
    FIELD(branch_row, REAL, v, "V_star", "slip rate in units of V_star"),
    FIELD(branch_row, REAL, psi, "psi", "interfacial state"),
    FIELD(branch_row, REAL, slope, "1",
          "d ln psi / d ln v along the branch; missing: vertical"),
    FIELD(branch_row, REAL, slip, "L",
          "slip in units of L from the first point on"),
    FIELD(branch_row, REAL, time, "L/V_star",
          "time in L/V_star from the first point on"),
    FIELD(branch_row, REAL, work, "L",
          "frictional work per unit normal force, units of L, likewise"),
    FIELD(branch_row, REAL, excess, "L",
          "slip in excess of v_sp, units of L, from the saddle"),
    FIELD(branch_row, REAL, error, "1",
          "bound on the distance to the exact curve in (ln v, ln psi)"));

const struct record_type record_nullcline = RECORD(
    nullcline_row, "nullcline", "a piece of nullcline",
    FIELD(nullcline_row, REAL, arc, "1", "arc length in (ln v, ln psi)"),
    FIELD(nullcline_row, REAL, v, "V_star", "slip rate in units of V_star"),
    FIELD(nullcline_row, REAL, psi, "psi", "interfacial state"));

const struct record_type record_trajectory = RECORD(
    trajectory_row, "trajectory", "one forward orbit",
    FIELD(trajectory_row, REAL, time, "L/V_star", "time in L/V_star"),
    FIELD(trajectory_row, REAL, v, "V_star", "slip rate in units of V_star"),
    FIELD(trajectory_row, REAL, psi, "psi", "interfacial state"),
    FIELD(trajectory_row, REAL, slip, "L", "slip in units of L"),
    FIELD(trajectory_row, REAL, mu, "1", "friction coefficient"),
    FIELD(trajectory_row, REAL, work, "L",
          "frictional work per unit normal force, units of L"));

const struct record_type record_arrow =
    RECORD(arrow_row, "field_arrows", "direction field",
           FIELD(arrow_row, REAL, v, "V_star", "slip rate in units of V_star"),
           FIELD(arrow_row, REAL, psi, "psi", "interfacial state"),
           FIELD(arrow_row, REAL, direction_v, "1",
                 "unit direction as drawn, along v"),
           FIELD(arrow_row, REAL, direction_psi, "1",
                 "unit direction as drawn, along psi"),
           FIELD(arrow_row, REAL, log10_speed, "log10(V_star/L)",
                 "log10 of the speed in (ln v, ln psi) per L/V_star"));

const struct record_type record_estimates = RECORD(
    estimate_numbers, "estimates", "the analytic estimates of section 4",
    FIELD(estimate_numbers, QUANTITY, v_sp0, "V_star",
          "slip rate at the saddle, (29)"),
    FIELD(estimate_numbers, QUANTITY, psi_sp0, "psi",
          "state at the saddle, (29)"),
    FIELD(estimate_numbers, QUANTITY, x_k, "L",
          "persistence length in units of L, (30)"),
    FIELD(estimate_numbers, QUANTITY, x_k_small_psi, "L", "its limit (31)"),
    FIELD(estimate_numbers, QUANTITY, x_k_zero_slope, "L", "(31) at alpha = 0"),
    FIELD(estimate_numbers, QUANTITY, mu_s_exact_v_plus, "1",
          "static friction (41) with the exact saddle and v_plus"),
    FIELD(estimate_numbers, QUANTITY, alpha_f, "rad", "friction angle (42)"),
    FIELD(estimate_numbers, QUANTITY, tan_alpha_f, "1",
          "its tangent; (43) prints the arctangent"));

const struct record_type record_xi = RECORD(
    xi_number, "xi", "the eigen-coordinate estimate",
    FIELD(xi_number, REAL, xi, "1", "coefficient xi of (38)"),
    FIELD(xi_number, QUANTITY, v_minus, "V_star", "critical slip rate (39)"),
    FIELD(xi_number, QUANTITY, v_plus, "V_star", "critical slip rate (39)"),
    FIELD(xi_number, QUANTITY, mu_s, "1", "static friction (41)"),
    FIELD(xi_number, QUANTITY, G, "L", "fracture energy (32)"));

#define BY(parameter, name_, unit_, text_)                                     \
    FIELD_AS(sensitivity_numbers, QUANTITY, name_, by[PARAMETER_##parameter],  \
             unit_, text_)

const struct record_type record_sensitivity = RECORD(
    sensitivity_numbers, "sensitivities",
    "how a critical slip rate answers to the parameters",
    BY(ALPHA, "alpha", "1/rad", "derivative of ln v by the slope angle"),
    BY(A, "a", "1", "derivative of ln v by a"),
    BY(B, "b", "1", "derivative of ln v by b"),
    BY(MU_STAR, "mu_star", "1", "derivative of ln v by mu_star"),
    BY(C, "c", "1", "derivative of ln v by c"),
    BY(R, "R", "1", "derivative of ln v by R"),
    BY(EPS2, "eps2", "1", "derivative of ln v by eps^2 = V_star^2/(g L)"));

/* ---- what a study says of its numbers ------------------------------------ */

RESULT_VIEW(view_steady, study, s->slider.steady, s->slider.plane.equilibria)
RESULT_VIEW(view_saddle, study, &s->saddle_numbers, 1)
RESULT_VIEW(view_folds, study, &s->folds, 1)

const struct result steady_results[] = {
    { .path = "/equilibria",
      .name = "equilibria",
      .title = "steady states",
      .text = "steady states, by slip rate",
      .shape = RESULT_COLUMNS,
      .type = &record_steady,
      .needs = ASKED_BY(STEADY),
      .alone = EQUILIBRIA_MAX,
      .fewer = "there are fewer steady states",
      .view = view_steady },
    { .path = "/folds",
      .name = "folds",
      .title = "folds",
      .text = "product folds or knees: extrema of steady-state friction",
      .type = &record_folds,
      .needs = ASKED_BY(FOLDS),
      .view = view_folds },
    { .path = "/saddle",
      .name = "saddle",
      .text = "the saddle",
      .type = &record_saddle,
      .needs = ASKED_BY(STEADY),
      .view = view_saddle },
    { .path = NULL },
};

RESULT_VIEW(view_critical, study, &s->slider.critical, 1)
RESULT_VIEW(view_knee, study,
            k ? &s->slider.critical.knee_lower : &s->slider.critical.knee_upper,
            1)
RESULT_VIEW(view_knees, study,
            k ? s->slider.critical.knees_lower : s->slider.critical.knees_upper,
            k ? s->slider.critical.knees_lower_count
              : s->slider.critical.knees_upper_count)

const struct result critical_results[] = {
    { .path = "/critical",
      .name = "",
      .title = "stable manifold of the saddle",
      .text = "product knees: what the stable manifold implies",
      .type = &record_critical,
      .needs = ASKED_BY(CRITICAL),
      .view = view_critical },
    { .path = "/critical/knee_{upper,lower}",
      .name = "knee_{upper,lower}",
      .text = "product knees: the first at which it rises through 1",
      .type = &record_knee,
      .needs = ASKED_BY(KNEES),
      .view = view_knee },
    { .path = "/critical/knees_{upper,lower}",
      .name = "knees_{upper,lower}",
      .title = "",
      .text = "product knees: where the branch's slope rises through 1",
      .shape = RESULT_COLUMNS,
      .type = &record_knee,
      .needs = ASKED_BY(KNEES),
      .view = view_knees },
    { .path = NULL },
};

RESULT_VIEW(view_estimates, study, &s->estimates, 1)
RESULT_VIEW(view_roots, study, s->estimates.chi_root, s->estimates.chi_roots)
RESULT_VIEW(view_xi, study, s->estimates.xi, s->estimates.xi_count)

static const struct record_type record_root = RECORD_OF(
    struct quantity, "roots", "roots of chi",
    FIELD_OF(QUANTITY, "roots", "V_star", "root of chi(v) = 1, (34)"));
#define ROOT(name_, member, text_)                                             \
    FIELD_AS(estimate_numbers, QUANTITY, name_, member, "V_star", text_)
static const struct record_type record_chi =
    RECORD(estimate_numbers, "chi", "roots of chi on both sides",
           ROOT("v_minus", chi_v_minus, "root of chi(v) = 1 below v_sp, (34)"),
           ROOT("v_plus", chi_v_plus, "root of chi(v) = 1 above v_sp, (34)"));

static const char estimate_note[] =
    "  note: x_k neglects psi_ss, so (41) diverges near alpha_f where "
    "mu_s_mean does not;\n"
    "  note: the xi estimate has no limit as xi -> 1; chi = 1 finds "
    "the knees, not v_plus and v_minus;\n"
    "  note: (43) prints 0.378 = atan(alpha_f); a friction coefficient "
    "is tan_alpha_f, and it depends on the arbitrary e = 1e-16.\n";

const struct result estimate_results[] = {
    { .path = "/estimates",
      .name = "estimates",
      .title = "estimates of the paper (log form, c = 0)",
      .text = "product estimates: the analytic estimates of the paper's "
              "section 4",
      .type = &record_estimates,
      .needs = ASKED_BY(ESTIMATES),
      .view = view_estimates },
    { .path = "/estimates/chi/roots",
      .name = "estimates.chi.roots",
      .text = "where chi(v) = 1, all of them",
      .shape = RESULT_COLUMNS,
      .type = &record_root,
      .needs = ASKED_BY(ESTIMATES),
      .view = view_roots },
    { .path = "/estimates/chi",
      .name = "estimates.chi",
      .title = "",
      .text = "those next to v_sp0",
      .type = &record_chi,
      .needs = ASKED_BY(ESTIMATES),
      .view = view_estimates },
    { .path = "/estimates/xi",
      .name = "estimates.xi",
      .title = "",
      .note = estimate_note,
      .text = "those in eigen-coordinates, (38)",
      .shape = RESULT_COLUMNS,
      .axis = "xi",
      .type = &record_xi,
      .needs = ASKED_BY(ESTIMATES),
      .view = view_xi },
    { .path = NULL },
};

RESULT_VIEW(view_sensitivity, study,
            k ? &s->sensitivities.v_minus : &s->sensitivities.v_plus, 1)

const struct result sensitivity_results[] = {
    { .path = "/critical/sensitivities/{v_plus,v_minus}",
      .name = "sensitivities.{v_plus,v_minus}",
      .title = "sensitivities d ln {v_plus,v_minus}/d p",
      .text = "product sensitivities: how a critical slip rate answers to the "
              "parameters",
      .type = &record_sensitivity,
      .needs = ASKED_BY(SENSITIVITIES),
      .view = view_sensitivity },
    { .path = NULL },
};
