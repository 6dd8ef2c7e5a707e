#include "records.h"

const char *const end_names[] = { "psi_inf", "open",      "psi_0",
                                  "v_0",     "truncated", NULL };

#define FIELD(type, kind, member, unit, text)                                  \
    {                                                                          \
#member, unit, text, offsetof(struct type, member), kind, NULL         \
    }
#define QUANTITY(type, member, unit, text)                                     \
    FIELD(type, RECORD_QUANTITY, member, unit, text)
#define REAL(type, member, unit, text)                                         \
    FIELD(type, RECORD_REAL, member, unit, text)
#define CODE(type, member, text, words)                                        \
    {                                                                          \
#member, "1", text, offsetof(struct type, member), RECORD_CODE, words  \
    }
#define TYPE(name, fields, type, text)                                         \
    {                                                                          \
        name, text, fields, sizeof fields / sizeof *fields,                    \
            sizeof(struct type)                                                \
    }

static const struct record_field steady_fields[] = {
    CODE(steady_number, type, "linear type", equilibrium_type_names),
    QUANTITY(steady_number, v, "1", "slip rate in units of V_star"),
    QUANTITY(steady_number, psi, "1", "interfacial state"),
    QUANTITY(steady_number, mu, "1", "friction coefficient"),
    QUANTITY(steady_number, lambda_minus, "1",
             "smaller eigenvalue, per L/V_star"),
    QUANTITY(steady_number, lambda_plus, "1",
             "larger eigenvalue, per L/V_star"),
};
const struct record_type record_steady =
    TYPE("equilibria", steady_fields, steady_number, "steady states");

static const struct record_field fold_fields[] = {
    QUANTITY(fold_numbers, alpha_cm, "rad",
             "slope angle of the fold at the minimum of mu_ss, (16)"),
    QUANTITY(fold_numbers, alpha_cM, "rad",
             "slope angle of the fold at the maximum of mu_ss, (16)"),
    QUANTITY(fold_numbers, v_m, "1", "slip rate at the minimum of mu_ss"),
    QUANTITY(fold_numbers, v_M, "1", "slip rate at the maximum of mu_ss"),
    QUANTITY(fold_numbers, mu_s, "1", "static friction mu_ss(v_M), (15)"),
    QUANTITY(fold_numbers, v_M_eq11, "1", "estimate of v_M, (11)"),
    QUANTITY(fold_numbers, v_m_eq12, "1", "estimate of v_m, (12)"),
    QUANTITY(fold_numbers, c_cusp, "1", "c at which both folds meet, Fig 4"),
    QUANTITY(fold_numbers, alpha_cusp, "rad", "slope angle of that cusp"),
};
const struct record_type record_folds = TYPE(
    "folds", fold_fields, fold_numbers, "extrema of steady-state friction");

static const struct record_field saddle_fields[] = {
    QUANTITY(saddle_numbers, v, "1", "slip rate at the saddle"),
    QUANTITY(saddle_numbers, psi, "1", "interfacial state at the saddle"),
    QUANTITY(saddle_numbers, lambda_minus, "1",
             "stable eigenvalue, per L/V_star"),
    QUANTITY(saddle_numbers, lambda_plus, "1",
             "unstable eigenvalue, per L/V_star"),
};
const struct record_type record_saddle =
    TYPE("saddle", saddle_fields, saddle_numbers, "the saddle");

static const struct record_field critical_fields[] = {
    CODE(critical_numbers, upper_end, "how the upper branch ends", end_names),
    CODE(critical_numbers, lower_end, "how the lower branch ends", end_names),
    QUANTITY(critical_numbers, v_plus, "1",
             "critical slip rate: limit of v as psi -> infinity"),
    QUANTITY(critical_numbers, ln_v_plus, "1", "its natural logarithm"),
    QUANTITY(critical_numbers, v_minus, "1",
             "critical slip rate: limit of v as psi -> 0"),
    QUANTITY(critical_numbers, ln_v_minus, "1", "its natural logarithm"),
    QUANTITY(critical_numbers, psi_at_v0, "1",
             "interfacial state where the lower branch meets v = 0"),
    QUANTITY(critical_numbers, x_excess, "1",
             "integral of (v - v_sp) dt along the upper branch, units of L"),
    QUANTITY(critical_numbers, x_deficit, "1",
             "integral of |v - v_sp| dt along the lower branch, units of L"),
    QUANTITY(critical_numbers, mu_s_num, "1",
             "static friction (41) with exact v_plus and x_excess"),
    QUANTITY(critical_numbers, mu_s_mean, "1",
             "mean friction along the upper branch, weight v - v_sp"),
    QUANTITY(critical_numbers, fracture_energy, "1",
             "(mu_s_num - tan(alpha)) x_excess"),
};
const struct record_type record_critical =
    TYPE("critical", critical_fields, critical_numbers,
         "what the saddle's stable manifold implies");

static const struct record_field knee_fields[] = {
    QUANTITY(knee_number, v, "1", "slip rate at the knee"),
    QUANTITY(knee_number, psi, "1", "interfacial state at the knee"),
};
const struct record_type record_knee =
    TYPE("knee", knee_fields, knee_number, "where the slope passes through 1");

static const struct record_field branch_fields[] = {
    REAL(branch_row, arc, "1", "arc length from the saddle in (ln v, ln psi)"),
    REAL(branch_row, v, "1", "slip rate in units of V_star"),
    REAL(branch_row, psi, "1", "interfacial state"),
    REAL(branch_row, slope, "1", "d ln psi / d ln v along the branch"),
    REAL(branch_row, slip, "1", "slip in units of L from the first point on"),
    REAL(branch_row, time, "1", "time in L/V_star from the first point on"),
    REAL(branch_row, work, "1",
         "frictional work per unit normal force, units of L, likewise"),
    REAL(branch_row, excess, "1",
         "slip in excess of v_sp, units of L, from the saddle"),
    REAL(branch_row, error, "1",
         "bound on the distance to the exact curve in (ln v, ln psi)"),
};
const struct record_type record_branch =
    TYPE("branch", branch_fields, branch_row,
         "one branch of an invariant manifold of the saddle");

static const struct record_field nullcline_fields[] = {
    REAL(nullcline_row, arc, "1", "arc length in (ln v, ln psi)"),
    REAL(nullcline_row, v, "1", "slip rate in units of V_star"),
    REAL(nullcline_row, psi, "1", "interfacial state"),
};
const struct record_type record_nullcline =
    TYPE("nullcline", nullcline_fields, nullcline_row, "a piece of nullcline");

static const struct record_field trajectory_fields[] = {
    REAL(trajectory_row, time, "1", "time in L/V_star"),
    REAL(trajectory_row, v, "1", "slip rate in units of V_star"),
    REAL(trajectory_row, psi, "1", "interfacial state"),
    REAL(trajectory_row, slip, "1", "slip in units of L"),
    REAL(trajectory_row, mu, "1", "friction coefficient"),
    REAL(trajectory_row, work, "1",
         "frictional work per unit normal force, units of L"),
};
const struct record_type record_trajectory =
    TYPE("trajectory", trajectory_fields, trajectory_row, "one forward orbit");

static const struct record_field arrow_fields[] = {
    REAL(arrow_row, v, "1", "slip rate in units of V_star"),
    REAL(arrow_row, psi, "1", "interfacial state"),
    REAL(arrow_row, direction_v, "1", "unit direction as drawn, along v"),
    REAL(arrow_row, direction_psi, "1", "unit direction as drawn, along psi"),
    REAL(arrow_row, log10_speed, "1",
         "log10 of the speed in (ln v, ln psi) per L/V_star"),
};
const struct record_type record_arrow =
    TYPE("field_arrows", arrow_fields, arrow_row, "direction field");

static const struct record_field estimate_fields[] = {
    QUANTITY(estimate_numbers, v_sp0, "1", "slip rate at the saddle, (29)"),
    QUANTITY(estimate_numbers, psi_sp0, "1", "state at the saddle, (29)"),
    QUANTITY(estimate_numbers, x_k, "1",
             "persistence length in units of L, (30)"),
    QUANTITY(estimate_numbers, x_k_small_psi, "1", "its limit (31)"),
    QUANTITY(estimate_numbers, x_k_zero_slope, "1", "(31) at alpha = 0"),
    QUANTITY(estimate_numbers, mu_s_exact_v_plus, "1",
             "static friction (41) with the exact saddle and v_plus"),
    QUANTITY(estimate_numbers, alpha_f, "rad", "friction angle (42)"),
    QUANTITY(estimate_numbers, tan_alpha_f, "1",
             "its tangent; (43) prints the arctangent"),
};
const struct record_type record_estimates =
    TYPE("estimates", estimate_fields, estimate_numbers,
         "the analytic estimates of section 4");

static const struct record_field xi_fields[] = {
    REAL(xi_number, xi, "1", "coefficient xi of (38)"),
    QUANTITY(xi_number, v_minus, "1", "critical slip rate (39)"),
    QUANTITY(xi_number, v_plus, "1", "critical slip rate (39)"),
    QUANTITY(xi_number, mu_s, "1", "static friction (41)"),
    QUANTITY(xi_number, G, "1", "fracture energy (32)"),
};
const struct record_type record_xi =
    TYPE("xi", xi_fields, xi_number, "the eigen-coordinate estimate");

#define BY(parameter, name, unit, text)                                        \
    {                                                                          \
        name, unit, text,                                                      \
            offsetof(struct sensitivity_numbers, by[PARAMETER_##parameter]),   \
            RECORD_QUANTITY, NULL                                              \
    }

static const struct record_field sensitivity_fields[] = {
    BY(ALPHA, "alpha", "rad-1", "derivative of ln v by the slope angle"),
    BY(A, "a", "1", "derivative of ln v by a"),
    BY(B, "b", "1", "derivative of ln v by b"),
    BY(MU_STAR, "mu_star", "1", "derivative of ln v by mu_star"),
    BY(C, "c", "1", "derivative of ln v by c"),
    BY(R, "R", "1", "derivative of ln v by R"),
    BY(EPS2, "eps2", "1", "derivative of ln v by eps^2 = V_star^2/(g L)"),
};
const struct record_type record_sensitivity =
    TYPE("sensitivities", sensitivity_fields, sensitivity_numbers,
         "how a critical slip rate answers to the parameters");
