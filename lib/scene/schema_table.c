#include "schema_table.h"

#include <float.h>
#include <math.h>

#include "scene_ensemble.h"
#include "scene_push.h"
#include "tolerance.h"
#include "value.h"

const char *const product_names[] = { "equilibria",    "folds",
                                      "nullclines",    "field_arrows",
                                      "manifolds",     "knees",
                                      "estimates",     "taylor_series",
                                      "sensitivities", "trajectories",
                                      "basins",        "margin",
                                      "slip",          "time",
                                      "friction",      "peak",
                                      "friction_law",  "spring_block",
                                      "bifurcation",   "fold_curves",
                                      "chi",           NULL };
_Static_assert(sizeof product_names / sizeof *product_names == PRODUCTS + 1,
               "each product has a name");
const char *const sweep_show_names[] = { "velocities",
                                         "velocity_estimates",
                                         "persistence",
                                         "static_friction",
                                         "fracture_energy",
                                         "basins",
                                         NULL };
_Static_assert(sizeof sweep_show_names / sizeof *sweep_show_names == SHOWS + 1,
               "each table of a sweep's figure has a word");
static const char *const y_scale_names[] = { "auto", "linear", "log", NULL };
static const char *const axes_names[] = { "log", "linear", "eigen", NULL };
static const char *const units_names[] = { "dimensionless", "si", NULL };
static const char *const flag_names[] = { "false", "true", NULL };
static const char *const scale_names[] = { "linear", "log", NULL };
static const char *const state_names[] = { "positive", "real", NULL };
static const char *const legend_names[] = { "auto",  "outside", "inside",
                                            "below", "none",    NULL };
static const char *const colours_names[] = { "viridis", "cividis", "greys",
                                             NULL };
static const char *const board_names[] = { "bristol_board", NULL };

/* ---- the table ----------------------------------------------------------- */

#define AT(member)   .offset = offsetof(struct scene, member)
#define FROM(low)    .lo = low
#define ABOVE(low)   .lo = low, .open_lo = true
#define TO(high)     .hi = high
#define BELOW(high)  .hi = high, .open_hi = true
#define IS(value)    .standard = value
#define UNIT(name)   .unit = name
#define TEXT(phrase) .text = phrase
#define POSITIVE                                                               \
    .read = value_real, ABOVE(0.0), TO(DBL_MAX), .expected = "a number > 0"

/* clang-format off */
const struct schema_key schema_table[] = {
    { "title", value_text, AT(title), .expected = "a text", IS("''"),
      TEXT("stands over figures and in files") },

    { "system.state", .open = true, .expected = "{NAME: real, ...}",
      TEXT("of a planar system of formulas, in place of law, material and "
           "slope: {NAME: real | positive | angle | {angle: PERIOD}, NAME: "
           "...}; unless given those with rates, real") },
    { "system.parameters", .open = true, .expected = "{NAME: NUMBER, ...}",
      TEXT("numbers that its formulas use: {NAME: NUMBER, ...}; each can be "
           "set, --set system.parameters.NAME=NUMBER") },
    { "system.define", .open = true, .expected = "{NAME: FORMULA, ...}",
      TEXT("names for expressions, each may use those before it") },
    { "system.rates", .open = true, .expected = "{NAME: FORMULA, ...}",
      TEXT("d/dt of each state") },
    { "system.observables", .open = true, .expected = "{NAME: FORMULA, ...}",
      TEXT("integrated along trajectories: {NAME: FORMULA} or {NAME: {rate: "
           "FORMULA, unit: U, long_name: TEXT}}") },
    { "system.ode", .expected = "x' = FORMULA; y' = FORMULA; ...",
      TEXT("or all of it in one text: NAME' = FORMULA, NAME = FORMULA and "
           "NAME = NUMBER with ; between them (--ode)") },

    { "law.preset", value_preset, .side = 1,
      TEXT("a law by name, see 'slipway laws'") },
    { "law.theta", value_part, AT(law.theta), .words = theta_names,
      .side = 2, TEXT("how friction depends on the state: mu has b theta") },
    { "law.psi_ss", value_part, AT(law.psi_ss), .words = psi_ss_names,
      .side = 2, TEXT("the state in steady sliding: 1/v, -ln v, "
                      "(1 + R)/(1 + R v), 1/(1 + R v)") },
    { "law.timescale", value_choice, AT(law.timescale),
      .words = timescale_names, .side = 2,
      TEXT("how fast the state follows, T(v): 1/v, R/(1 + R v), R psi_ss, "
           "R exp(psi_ss)") },
    { "law.kinetics", value_choice, AT(law.kinetics), .words = kinetics_names,
      .side = 2, TEXT("dpsi/dt = -K(psi - psi_ss)/T with K(d) = d or sinh d") },
    { "law.T", value_formula, .expected = "a formula", .side = 2,
      TEXT("T(v) as a formula of v and psi_ss, in place of timescale") },
    { "law.K", value_formula, .expected = "a formula", .side = 2,
      TEXT("K(d) as a formula of d = psi - psi_ss, in place of kinetics") },
    { "law.rate", value_formula, .expected = "a formula", .side = 2,
      TEXT("dpsi/dt as a formula of v, psi and psi_ss, in place of T and K") },
    { "law.mu", value_formula, .expected = "a formula", .side = 2,
      TEXT("mu(v, psi) as a formula, in place of theta and friction") },
    { "law.state", value_state, .words = state_names, .side = 2,
      TEXT("positive, or real where psi is a logarithm; real with theta: psi, "
           "else positive") },
    { "law.friction", value_choice, AT(law.form),
      .words = friction_form_names, IS("asinh"),
      TEXT("the direct effect: regularised (4a), or a logarithm (2)") },

    { "material.preset", value_state, .words = board_names,
      IS("bristol_board"),
      TEXT("Table 2, the defaults of the keys below") },
    { "material.mu_star", value_real, AT(material.mu_star), FROM(-1e3), TO(1e3),
      .expected = "a number from -1000 to 1000", IS("0.369"),
      TEXT("friction coefficient at V_star where theta = 0") },
    { "material.a", AT(material.a), POSITIVE, IS("0.0349"),
      TEXT("direct effect: d mu/d ln v at fixed state") },
    { "material.b", AT(material.b), POSITIVE, IS("0.0489"),
      TEXT("evolution effect: factor of theta") },
    { "material.L", AT(material.L), POSITIVE, UNIT("m"), IS("0.9e-6"),
      TEXT("memory length, unit of slip") },
    { "material.V_star", AT(material.V_star), POSITIVE, UNIT("m/s"),
      IS("1e-6"), TEXT("unit of slip rate; L/V_star is that of time") },
    { "material.c", value_real, AT(material.c), FROM(0.0), TO(DBL_MAX),
      .expected = "a number >= 0", IS("1e-3"),
      TEXT("residual strength beside the state, of spinodal laws") },
    { "material.R", value_real, AT(material.R), ABOVE(0.0),
      TO((double) INFINITY), .expected = "a number > 0 or inf", IS("100"),
      TEXT("longest relaxation time in L/V_star, of spinodal laws") },
    { "material.V_c", AT(material.V_c), POSITIVE, UNIT("V_star"),
      TEXT("cut-off slip rate; kato_tullis needs it, no other law has it") },

    { "slope.alpha", value_slope, ABOVE(0.0), BELOW(M_PI_2), .side = 1,
      .expected = "an angle in rad, 0 < alpha < pi/2", UNIT("rad"),
      TEXT("slope angle") },
    { "slope.alpha_deg", value_slope, ABOVE(0.0), BELOW(90.0), .side = 2,
      .expected = "an angle in degrees, 0 < alpha_deg < 90", UNIT("degree"),
      TEXT("the same in degrees") },
    { "slope.tan_alpha", value_slope, ABOVE(0.0), TO(DBL_MAX), .side = 3,
      .expected = "a number > 0",
      TEXT("its tangent, shear over normal stress") },

    { "gravity", AT(material.g), POSITIVE, UNIT("m/s^2"), IS("9.81"),
      TEXT("eps^2 = V_star^2/(gravity L) weighs inertia") },

    { "window.v", value_pair, AT(window.v), FROM(1 / TOL_RANGE),
      TO(TOL_RANGE), .expected = "a number from 1e-300 to 1e300",
      IS("[1e-6, 1e6]"),
      UNIT("V_star"), TEXT("slip rates that figures and grids show") },
    { "window.psi", value_pair, .side = 1, AT(window.psi), FROM(-TOL_RANGE),
      TO(TOL_RANGE), .expected = "a number up to 1e300", IS("[1e-3, 1e2]"),
      TEXT("states that they show; where psi is a logarithm (theta: psi) "
           "[-7, 5] unless given") },
    { "window.phi", value_pair, .side = 2, AT(window.psi), FROM(-TOL_RANGE),
      TO(TOL_RANGE), .expected = "a number > 0",
      TEXT("the same as phi, in s where the law's state is a time") },
    { "window.axes", value_choice, AT(window.axes), .words = axes_names,
      IS("log"), TEXT("of figures and grids; eigen: the saddle's eigenvectors, "
                      "(36)") },

    { "units", value_choice, AT(units), .words = units_names,
      IS("dimensionless"),
      TEXT("of numbers as they are read and told: beside si slip rates are in "
           "m/s, lengths in m, times in s and states phi, but for those with "
           "a unit behind them; files are always dimensionless") },

    { "products", value_products, .words = product_names,
      .expected = "a list of ",
      TEXT("what to compute, see below; unless given each command has its "
           "own") },

    { "estimates.xi", value_xi, ABOVE(0.0), BELOW(1.0),
      .expected = "1 to 64 numbers xi in brackets, 0 < xi < 1",
      IS("[0.85, 0.9, 0.99, 0.999]"), TEXT("coefficients of (38)") },

    { "trajectories.starts", value_starts,
      .expected = "a list [{v: V, psi: P}, ...]", IS("[]"),
      TEXT("states to follow, {v: V, psi: P} or {v: V, phi: P}; beside units: "
           "si phi") },
    { "trajectories.spread", value_count, AT(spread), FROM(0), TO(10000),
      .expected = "a whole number from 0 to 10000", IS("0"),
      TEXT("how many more orbits, spread evenly over the window") },
    { "trajectories.seed", value_seed, AT(seed), FROM(0), TO(0x1p53),
      .expected = "a whole number from 0 to 9007199254740992", IS("1"),
      TEXT("seed of everything random") },
    { "trajectories.until.time", AT(until_time), POSITIVE, UNIT("L/V_star"),
      TEXT("stop at this time") },
    { "trajectories.until.slip", AT(until_slip), POSITIVE, UNIT("L"),
      TEXT("stop at this slip") },
    { "trajectories.sample.linear_slip", value_count, AT(linear_slip),
      FROM(2), TO(1000000), .side = 1,
      .expected = "a whole number from 2 to 1000000",
      TEXT("simulate: so many samples evenly over slip") },
    { "trajectories.sample.log_time", value_count, AT(log_time),
      FROM(2), TO(1000000), .side = 2,
      .expected = "a whole number from 2 to 1000000",
      TEXT("simulate: so many samples evenly over the logarithm of time") },

    { "basins.cells", value_cells, AT(cells), FROM(1), TO(32768),
      .expected = "two whole numbers [nv, npsi] from 1 to 32768",
      IS("[512, 512]"), TEXT("of the grid, along v and psi") },
    { "basins.audit", value_count, AT(audit), FROM(0), TO(1000000),
      .expected = "a whole number from 0 to 1000000", IS("1000"),
      TEXT("how many random cells are followed forward in time") },
    { "basins.exact", value_flag, AT(exact), .words = flag_names, IS("false"),
      TEXT("follow every cell forward in time; slow") },
    { "basins.rtol", value_real, AT(cell_rtol), FROM(1e-11), TO(0.1),
      .expected = "a number from 1e-11 to 0.1", IS("1e-6"),
      TEXT("relative accuracy of slip, time, friction and peaks of cells") },

    { "rabinowicz.block_mass", AT(rabinowicz.block_mass), POSITIVE,
      UNIT("kg"), TEXT("of the block that is hit") },
    { "rabinowicz.ball_mass", AT(rabinowicz.ball_mass), POSITIVE, UNIT("kg"),
      TEXT("of the ball that hits it") },
    { "rabinowicz.restitution", value_real, AT(rabinowicz.restitution),
      FROM(0.0), TO(1.0), .expected = "a number from 0 to 1",
      TEXT("coefficient of restitution of that impact") },
    { "rabinowicz.tan_alpha", value_slopes, ABOVE(0.0), TO(SCENE_TAN),
      .expected = "1 to 1000 numbers tan_alpha > 0 in brackets",
      TEXT("slopes to compute release distances at; unless given the "
           "scene's") },
    { "rabinowicz.data", value_input, AT(rabinowicz.data),
      .expected = "a path",
      TEXT("measured distances, CSV: tan_alpha, l_k, l_k_error, x_k, "
           "x_k_error; beside the scene, or from the working folder") },
    { "rabinowicz.smoothing", value_real, AT(rabinowicz.smoothing),
      FROM(SCENE_SMOOTHING_LEAST), TO(1.0),
      .expected = "a number from 1e-12 to 1",
      TEXT("of friction against slip; unless given found from the data") },

    { "sweep.key", value_key, AT(sweep.draft.key),
      .expected = "the key of a number, such as slope.alpha",
      TEXT("the key that varies") },
    { "sweep.from", value_real, AT(sweep.draft.from), FROM(-DBL_MAX),
      TO(DBL_MAX), .side = 1, .expected = "a number", TEXT("its first value") },
    { "sweep.to", value_real, AT(sweep.draft.to), FROM(-DBL_MAX), TO(DBL_MAX),
      .side = 1, .expected = "a number", TEXT("its last value") },
    { "sweep.points", value_count, AT(sweep.draft.points), FROM(2),
      TO(SCENE_POINTS), .side = 1,
      .expected = "a whole number from 2 to 250000",
      TEXT("how many values, both ends included") },
    { "sweep.scale", value_choice, AT(sweep.draft.scale),
      .words = scale_names, IS("linear"), TEXT("of the values between") },
    { "sweep.values", value_values, FROM(-DBL_MAX), TO(DBL_MAX), .side = 2,
      .expected = "1 to 250000 numbers in brackets",
      TEXT("or the values themselves") },
    { "sweep.refine", value_real, AT(sweep.refine), FROM(1e-6), TO(1.0),
      .expected = "a number from 1e-6 to 1, the tolerance in ln v",
      TEXT("add values where the critical slip rates bend, to this "
           "tolerance") },
    { "sweep.show", value_choice, AT(sweep.show), .words = sweep_show_names,
      IS("velocities"), TEXT("what the figure shows") },
    { "sweep.y_scale", value_choice, AT(sweep.y_scale),
      .words = y_scale_names, IS("auto"), TEXT("of the figure") },
    { "sweep.y_range", value_pair, AT(sweep.y_range), FROM(-DBL_MAX),
      TO(DBL_MAX), .expected = "a number",
      TEXT("of the figure; unless given as the values need") },

    { "ensemble.parameters", value_spreads, .side = 1,
      .expected = "1 to 32 of {KEY: {normal: [m, s]}, KEY: {uniform: [lo, "
                  "hi]}, KEY: {lognormal: [median, factor]}}",
      TEXT("what is not known: {KEY: {normal: [mean, standard deviation]}, "
           "KEY: {uniform: [lo, hi]}, KEY: {lognormal: [median, factor]}}, "
           "each by itself") },
    { "ensemble.covariance", value_input, AT(ensemble.covariance), .side = 2,
      .expected = "a path",
      TEXT("or normal and not each by itself: a CSV file of columns key, mean "
           "and one for each key, the covariances; beside the scene, or from "
           "the working folder") },
    { "ensemble.samples", value_input, AT(ensemble.samples), .side = 3,
      .expected = "a path",
      TEXT("or materials as they were measured: a CSV file whose columns are "
           "keys, a row each; a column id is kept") },
    { "ensemble.draws", value_count, AT(ensemble.draws), FROM(1),
      TO(SCENE_DRAWS), .expected = "a whole number from 1 to 1000000000",
      IS("10000"), TEXT("how many materials; of samples all that there are") },
    { "ensemble.method", value_choice, AT(ensemble.method),
      .words = ensemble_method_names, IS("sobol"),
      TEXT("how they are drawn: evenly, at random, or on a grid of quantiles") },
    { "ensemble.seed", value_seed, AT(ensemble.seed), FROM(0), TO(0x1p53),
      .expected = "a whole number from 0 to 9007199254740992", IS("1"),
      TEXT("of the draws") },
    { "ensemble.numbers", value_numbers,
      .expected = "a list of at most 256 names such as v_plus",
      TEXT("what is asked for, by name as in tables of sweeps; unless given "
           "what the products give; []: none, where pushes are all") },
    { "ensemble.pushes", value_pushes,
      .expected = "a list [{v: V, psi: P}, {from: creep, kick: DV}, ...]",
      IS("[]"),
      TEXT("states whose fates are asked for: {v: V, psi: P}, or phi, or "
           "{from: creep, kick: DV}, the creep state with DV added to v; of a "
           "system {x: A, y: B}, or {from: stable_node_1, x: DX, y: DY}, what "
           "is added to an equilibrium") },

    { "spring_block.sigma", AT(spring_block.sigma), POSITIVE, UNIT("Pa"),
      IS("1000"), TEXT("normal stress") },
    { "spring_block.mass", value_real, AT(spring_block.mass), FROM(0.0),
      TO(DBL_MAX), .expected = "a number >= 0", UNIT("kg/m^2"),
      TEXT("of the block; unless given its weight is sigma") },
    { "spring_block.v", value_pair, AT(spring_block.v), FROM(1 / TOL_RANGE),
      TO(TOL_RANGE), .expected = "a number from 1e-300 to 1e300",
      UNIT("V_star"),
      TEXT("speeds of pulling; unless given those of the window") },

    { "fold_curves.c", value_pair, AT(fold_c), FROM(1 / TOL_RANGE),
      TO(TOL_RANGE), .expected = "a number from 1e-300 to 1e300",
      IS("[1e-14, 10]"), TEXT("range of material.c") },

    { "chi.alpha", value_chi_slopes, ABOVE(0.0), BELOW(M_PI_2),
      .expected = "1 to 64 angles in rad in brackets, 0 < alpha < pi/2",
      UNIT("rad"), IS("[0.2, 0.28, 0.34, 0.38]"), TEXT("slopes of chi(v)") },

    { "figure.width", value_page, FROM(20), TO(2000),
      .expected = "one_column, two_columns, slide, screen, or mm from 20 to "
                  "2000",
      IS("screen"), UNIT("mm"),
      TEXT("of figures, exactly: 89 and 183 mm of a journal's columns with "
           "letters of 8 pt, 254 x 143 mm with 14 pt, 900 x 600 px of 1/96 "
           "inch with 9.75 pt, or a width, with 8 pt") },
    { "figure.height", value_length, AT(paper.height), FROM(20), TO(2000),
      .expected = "mm from 20 to 2000", UNIT("mm"),
      TEXT("of figures, exactly; unless given the word's, or what the plot "
           "and what is around it need") },
    { "figure.type", value_length, AT(paper.type), FROM(4), TO(72),
      .expected = "pt from 4 to 72", UNIT("pt"),
      TEXT("size of letters; lines and marks grow with it") },
    { "figure.font", value_font, AT(paper.font),
      .expected = "a font's name, of letters, digits, blanks and -",
      TEXT("unless given the system's sans-serif") },
    { "figure.title", value_flag, AT(paper.title), .words = flag_names,
      IS("true"), TEXT("whether figures have one") },
    { "figure.legend", value_choice, AT(paper.legend), .words = legend_names,
      IS("auto"), TEXT("where it stands; auto: outside of a wide figure, else "
                       "below") },
    { "figure.colours", value_choice, AT(paper.colours),
      .words = colours_names, IS("viridis"), TEXT("of maps of numbers") },
    { "figure.dpi", value_length, AT(paper.dpi), FROM(50), TO(1200),
      .expected = "dots per inch from 50 to 1200",
      TEXT("of a .png; unless given 192 on slide and screen, else 300") },

    { "accuracy.rtol", value_real, AT(rtol), FROM(1e-14), TO(0.1),
      .expected = "a number from 1e-14 to 0.1", IS("1e-12"),
      TEXT("relative accuracy; numbers carry the error they have") },
    { "accuracy.proved", value_flag, AT(proved), .words = flag_names,
      IS("false"), TEXT("enclose numbers with proof, inputs as "
                        "decimals; by knees, portrait, study, basin and sweep") },

    { "output.hdf5", value_path, AT(hdf5), .expected = "a path",
      TEXT("write results here; by portrait, study, basin, sweep and "
           "ensemble") },
    { "output.figure", value_figure, AT(figure),
      .expected = "a path ending in .svg, .pdf or .png",
      TEXT("draw here; by the same") },
    { .path = NULL },
};
/* clang-format on */

_Static_assert(sizeof schema_table / sizeof *schema_table <=
                   SCHEMA_KEYS_MAX + 1,
               "lists of keys have room");
