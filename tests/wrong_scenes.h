/* wrong_scenes.h -- scenes with one thing wrong each, and the line that says
 * what.  Of libyaml's own messages, and of bytes: test_document.c. */
#pragma once

#define LAW   "law: {preset: dieterich_gen}\n"
#define SLOPE "slope: {alpha: 0.34}\n"

#define NOT " is not allowed, expected "
#define TOP                                                                    \
    "title, system, law, material, slope, gravity, window, units, products, "  \
    "estimates, trajectories, basins, rabinowicz, sweep, ensemble, "           \
    "spring_block, fold_curves, chi, figure, accuracy or output"
#define PRODUCTS_KNOWN                                                         \
    "equilibria, folds, nullclines, field_arrows, manifolds, knees, "          \
    "estimates, taylor_series, sensitivities, trajectories, basins, margin, "  \
    "slip, time, friction, peak, friction_law, spring_block, bifurcation, "    \
    "fold_curves or chi"
#define LAWS                                                                   \
    "dieterich, dieterich_gen, ruina, perrin, spinodal, spinodal_gen, "        \
    "spinodal_phi_gen or kato_tullis"
#define AXIS                                                                   \
    "key, from, to, points, scale, values, refine, show, y_scale or y_range"
#define USED "mu_star, a, b, L or V_star"
#define NO_LAW                                                                 \
    "no law, expected 'law: {preset: NAME}' or --law NAME (see slipway laws)"

struct wrong {
    const char *text, *line; /* what follows "s.yaml:" */
};

/* Unknown on every level; also the keys of sections to come. */
static const struct wrong wrong_keys[] = {
    { LAW SLOPE "titel: x\n",
      "3:1: unknown key 'titel', expected " TOP " (did you mean title?)" },
    { LAW SLOPE "alpha: 0.3\n", "3:1: unknown key 'alpha', expected " TOP
                                " (did you mean slope.alpha?)" },
    { LAW SLOPE "basin: {}\n",
      "3:1: unknown key 'basin', expected " TOP " (did you mean basins?)" },
    { LAW SLOPE "sweep: {keys: slope.alpha}\n",
      "3:9: unknown key 'sweep.keys', expected " AXIS
      " (did you mean sweep.key?)" },
    { LAW SLOPE "sweep: [{key: slope.alpha, values: [0.1, 0.2], step: 1}]\n",
      "3:48: unknown key 'sweep.step', expected " AXIS },
    { LAW SLOPE "spring_block: {k: 1}\n",
      "3:16: unknown key 'spring_block.k', expected sigma, mass or v" },
    { LAW SLOPE "GRAVITY: 9.81\n",
      "3:1: unknown key 'GRAVITY', expected " TOP " (did you mean gravity?)" },
    { LAW SLOPE "law.friction: log\n",
      "3:1: unknown key 'law.friction', expected one word, as in 'slope: "
      "{alpha: RAD}' for slope.alpha" },
    { LAW SLOPE "window: {w: [1, 2]}\n",
      "3:10: unknown key 'window.w', expected v, psi, phi or axes" },
    { LAW SLOPE "window: {axis: log}\n",
      "3:10: unknown key 'window.axis', expected v, psi, phi or axes (did you "
      "mean "
      "window.axes?)" },
    { LAW SLOPE "material: {mu: 0.3}\n",
      "3:12: unknown key 'material.mu', expected preset, mu_star, a, b, L, "
      "V_star, c, R or V_c (did you mean law.mu?)" },
    { LAW SLOPE "material: {g: 9.81}\n",
      "3:12: unknown key 'material.g', expected preset, mu_star, a, b, L, "
      "V_star, c, R or V_c" },
    { LAW SLOPE "trajectories: {until: {times: 3}}\n",
      "3:24: unknown key 'trajectories.until.times', expected time or slip "
      "(did you mean trajectories.until.time?)" },
    { LAW SLOPE "trajectories: {sample: {n: 3}}\n",
      "3:25: unknown key 'trajectories.sample.n', expected linear_slip or "
      "log_time" },
    { LAW SLOPE "trajectories: {starts: [{v: 1, psy: 2}]}\n",
      "3:32: trajectories.starts: unknown key 'psy', expected v and psi (did "
      "you mean psi?)" },
    { LAW SLOPE "trajectories: {starts: [{v: 1, psi: 2, t: 0}]}\n",
      "3:40: trajectories.starts: unknown key 't', expected v and psi" },
    { LAW SLOPE "basins: {refine: 1e-3}\n",
      "3:10: unknown key 'basins.refine', expected cells, audit, exact or "
      "rtol (did you mean sweep.refine?)" },
    { LAW SLOPE "output: {hdf: a.h5}\n",
      "3:10: unknown key 'output.hdf', expected hdf5 or figure (did you mean "
      "output.hdf5?)" },
    { LAW SLOPE "rabinowicz: {mass: 1}\n",
      "3:14: unknown key 'rabinowicz.mass', expected block_mass, ball_mass, "
      "restitution, tan_alpha, data or smoothing (did you mean "
      "spring_block.mass?)" },
    { LAW SLOPE "estimates: {zeta: [0.5]}\n",
      "3:13: unknown key 'estimates.zeta', expected xi" },
    { LAW SLOPE "accuracy: {tol: 1e-9}\n",
      "3:12: unknown key 'accuracy.tol', expected rtol or proved (did you mean "
      "accuracy.rtol?)" },
    { LAW SLOPE "\"\": 1\n", "3:1: unknown key '', expected " TOP },
    { LAW SLOPE "\"ti\\ttle\": x\n",
      "3:1: unknown key 'ti\\x09tle', expected " TOP " (did you mean title?)" },
    { "law: {presett: dieterich_gen}\n" SLOPE,
      "1:7: unknown key 'law.presett', expected preset, theta, psi_ss, "
      "timescale, kinetics, T, K, rate, mu, state or friction (did you mean "
      "law.preset?)" },
    { LAW "slope: {alfa: 0.34}\n",
      "2:9: unknown key 'slope.alfa', expected alpha, alpha_deg or tan_alpha" },
};

static const struct wrong wrong_twice[] = {
    { LAW SLOPE "title: a\ntitle: b\n",
      "4:1: key 'title' is given twice, expected it once" },
    { LAW SLOPE "slope: {alpha: 0.3}\n",
      "3:1: key 'slope' is given twice, expected it once" },
    { LAW SLOPE "gravity: 9.81\n\"gravity\": 9.81\n",
      "4:1: key 'gravity' is given twice, expected it once" },
    { LAW "slope: {alpha: 0.3, alpha: 0.3}\n",
      "2:21: key 'alpha' is given twice, expected it once" },
    { LAW SLOPE "trajectories: {starts: [{v: 1, v: 2, psi: 1}]}\n",
      "3:32: key 'v' is given twice, expected it once" },
};

static const struct wrong wrong_kinds[] = {
    { LAW SLOPE "title: [a]\n", "3:8: title: a list" NOT "a text" },
    { LAW SLOPE "title: {}\n",
      "3:8: title: an empty map of keys" NOT "a text" },
    { LAW SLOPE "gravity: [9.81]\n",
      "3:10: gravity: a list" NOT "a number > 0" },
    { LAW SLOPE "gravity: {value: 9.81}\n",
      "3:10: gravity: a map of keys" NOT "a number > 0" },
    { LAW SLOPE "gravity:\n", "3:9: gravity: ''" NOT "a number > 0" },
    { LAW SLOPE "gravity: ~\n", "3:10: gravity: '~'" NOT "a number > 0" },
    { LAW SLOPE "gravity: \"9,81\"\n",
      "3:10: gravity: '9,81'" NOT "a number > 0" },
    { LAW SLOPE "material: 3\n",
      "3:11: material: '3'" NOT
      "a map of keys, preset, mu_star, a, b, L, V_star, c, R or V_c, as in "
      "'material: {preset: ...}'" },
    { LAW SLOPE "material: [a, b]\n",
      "3:11: material: a list" NOT
      "a map of keys, preset, mu_star, a, b, L, V_star, c, R or V_c, as in "
      "'material: {preset: ...}'" },
    { LAW SLOPE "trajectories: {until: 3}\n",
      "3:23: trajectories.until: '3'" NOT
      "a map of keys, time or slip, as in 'until: {time: ...}'" },
    { LAW SLOPE "window: {v: 1}\n",
      "3:13: window.v: this is no pair, expected [lo, hi]" },
    { LAW SLOPE "window: {v: [1]}\n",
      "3:13: window.v: this is no pair, expected [lo, hi]" },
    { LAW SLOPE "window: {v: [a, 2]}\n",
      "3:14: window.v: 'a'" NOT "a number from 1e-300 to 1e300" },
    { LAW SLOPE "window: {psi: [[1], 2]}\n",
      "3:16: window.psi: a list" NOT "a number up to 1e300" },
    { LAW SLOPE "products: knees\n",
      "3:11: products: 'knees'" NOT "a list of " PRODUCTS_KNOWN
      " (did you mean knees?)" },
    { LAW SLOPE "products: []\n",
      "3:11: products: an empty list" NOT "a list of " PRODUCTS_KNOWN },
    { LAW SLOPE "products: [knees, [folds]]\n",
      "3:19: products: a list" NOT "a list of " PRODUCTS_KNOWN },
    { LAW SLOPE "products: [manifold]\n",
      "3:12: products: 'manifold'" NOT "a list of " PRODUCTS_KNOWN
      " (did you mean manifolds?)" },
    { LAW SLOPE "products: [Knees]\n",
      "3:12: products: 'Knees'" NOT "a list of " PRODUCTS_KNOWN
      " (did you mean knees?)" },
    { LAW SLOPE "estimates: {xi: []}\n",
      "3:17: estimates.xi: an empty list" NOT
      "1 to 64 numbers xi in brackets, 0 < xi < 1" },
    { LAW SLOPE "rabinowicz: {restitution: 1.1}\n",
      "3:27: rabinowicz.restitution: '1.1'" NOT "a number from 0 to 1" },
    { LAW SLOPE "spring_block: {sigma: 0}\n",
      "3:23: spring_block.sigma: '0'" NOT "a number > 0" },
    { LAW SLOPE "spring_block: {mass: -1}\n",
      "3:22: spring_block.mass: '-1'" NOT "a number >= 0" },
    { LAW SLOPE "spring_block: {v: 3}\n",
      "3:19: spring_block.v: this is no pair, expected [lo, hi]" },
    { LAW SLOPE "fold_curves: {c: [0, 1]}\n",
      "3:19: fold_curves.c: '0'" NOT "a number from 1e-300 to 1e300" },
    { LAW SLOPE "fold_curves: {c: [2, 1]}\n",
      "3:18: fold_curves.c: [2, 1] is empty, expected lo < hi" },
    { LAW SLOPE "chi: {alpha: []}\n",
      "3:14: chi.alpha: an empty list" NOT
      "1 to 64 angles in rad in brackets, 0 < alpha < pi/2" },
    { LAW SLOPE "chi: {alpha: [0.3, 1.6]}\n",
      "3:20: chi.alpha: '1.6'" NOT
      "1 to 64 angles in rad in brackets, 0 < alpha < pi/2" },
    { LAW SLOPE "rabinowicz: {block_mass: 0}\n",
      "3:26: rabinowicz.block_mass: '0'" NOT "a number > 0" },
    { LAW SLOPE "rabinowicz: {smoothing: 0}\n",
      "3:25: rabinowicz.smoothing: '0'" NOT "a number from 1e-12 to 1" },
    { LAW SLOPE "rabinowicz: {tan_alpha: [0.1, -1]}\n",
      "3:31: rabinowicz.tan_alpha: '-1'" NOT
      "1 to 1000 numbers tan_alpha > 0 in brackets" },
    { LAW SLOPE "rabinowicz: {data: [a]}\n",
      "3:20: rabinowicz.data: a list" NOT "a path" },
    { LAW SLOPE "estimates: {xi: 0.9}\n",
      "3:17: estimates.xi: '0.9'" NOT
      "1 to 64 numbers xi in brackets, 0 < xi < 1" },
    { LAW SLOPE "trajectories: {starts: {v: 1, psi: 1}}\n",
      "3:24: trajectories.starts: a map of keys" NOT
      "a list [{v: V, psi: P}, ...]" },
    { LAW SLOPE "trajectories: {starts: [1]}\n",
      "3:25: trajectories.starts: '1'" NOT "a list [{v: V, psi: P}, ...]" },
    { LAW SLOPE "trajectories: {starts: [{v: 1}]}\n",
      "3:25: trajectories.starts: psi is missing, expected {v: V, psi: P}" },
    { LAW SLOPE "trajectories: {starts: [{v: 1, psi: 1}, {}]}\n",
      "3:41: trajectories.starts: v is missing, expected {v: V, psi: P}" },
    { LAW SLOPE "trajectories: {starts: [{v: 1, psi: }]}\n",
      "3:37: trajectories.starts: psi: ''" NOT "a number" },
    { LAW SLOPE "basins: {cells: 512}\n",
      "3:17: basins.cells: '512'" NOT
      "two whole numbers [nv, npsi] from 1 to 32768" },
    { LAW SLOPE "basins: {exact: yes}\n",
      "3:17: basins.exact: 'yes'" NOT "false or true" },
    { LAW SLOPE "basins: {exact: True}\n",
      "3:17: basins.exact: 'True'" NOT "false or true (did you mean true?)" },
    { LAW SLOPE "units: SI\n",
      "3:8: units: 'SI'" NOT "dimensionless or si (did you mean si?)" },
    { LAW SLOPE "window: {axes: logarithmic}\n",
      "3:16: window.axes: 'logarithmic'" NOT "log, linear or eigen" },
    { LAW "slope: 0.34\n",
      "2:8: slope: '0.34'" NOT
      "a map of keys, alpha, alpha_deg or tan_alpha, as in "
      "'slope: {alpha: ...}'" },
    { "law: dieterich_gen\n" SLOPE,
      "1:6: law: 'dieterich_gen'" NOT
      "a map of keys, preset, theta, psi_ss, timescale, kinetics, T, K, rate, "
      "mu, state or friction, as in 'law: {preset: ...}'" },
    { "law: {preset: [ruina]}\n" SLOPE, "1:15: law.preset: a list" NOT LAWS },
    { "law: {preset: dietrich_gen}\n" SLOPE,
      "1:15: law.preset: 'dietrich_gen'" NOT LAWS
      " (did you mean dieterich_gen?)" },
    { "law: {preset: xyz}\n" SLOPE, "1:15: law.preset: 'xyz'" NOT LAWS },
    { "law: {preset: ruina, friction: arcsinh}\n" SLOPE,
      "1:32: law.friction: 'arcsinh'" NOT
      "asinh or log (did you mean asinh?)" },
    { LAW SLOPE "material: {preset: granite}\n",
      "3:20: material.preset: 'granite'" NOT "bristol_board" },
    { LAW SLOPE "output: {hdf5: [a.h5]}\n",
      "3:16: output.hdf5: a list" NOT "a path" },
    { LAW SLOPE "output: {figure: a.jpg}\n",
      "3:18: output.figure: 'a.jpg'" NOT
      "a path ending in .svg, .pdf or .png" },
    { LAW SLOPE "output: {figure: svg}\n",
      "3:18: output.figure: 'svg'" NOT "a path ending in .svg, .pdf or .png" },
    { LAW SLOPE "output: {figure: a.svg.gz}\n",
      "3:18: output.figure: 'a.svg.gz'" NOT
      "a path ending in .svg, .pdf or .png" },
};

static const struct wrong wrong_numbers[] = {
    { LAW SLOPE "gravity: nan\n", "3:10: gravity: 'nan'" NOT "a number > 0" },
    { LAW SLOPE "gravity: 0x1p3\n",
      "3:10: gravity: '0x1p3'" NOT "a number > 0" },
    { LAW SLOPE "gravity: 1_000\n",
      "3:10: gravity: '1_000'" NOT "a number > 0" },
    { LAW SLOPE "gravity: 9.81 m/s^2\n",
      "3:10: gravity: '9.81 m/s^2'" NOT "a number > 0" },
    { LAW SLOPE "gravity: 1e400\n",
      "3:10: gravity: '1e400'" NOT "a number > 0" },
    { LAW SLOPE "gravity: inf\n", "3:10: gravity: 'inf'" NOT "a number > 0" },
    { LAW SLOPE "gravity: 0\n", "3:10: gravity: '0'" NOT "a number > 0" },
    { LAW SLOPE "gravity: -9.81\n",
      "3:10: gravity: '-9.81'" NOT "a number > 0" },
    { LAW SLOPE "gravity: 1:30\n", "3:10: gravity: '1:30'" NOT "a number > 0" },
    { LAW SLOPE "material: {a: 0}\n",
      "3:15: material.a: '0'" NOT "a number > 0" },
    { LAW SLOPE "material: {b: -1e-9}\n",
      "3:15: material.b: '-1e-9'" NOT "a number > 0" },
    { LAW SLOPE "material: {mu_star: 1001}\n",
      "3:21: material.mu_star: '1001'" NOT "a number from -1000 to 1000" },
    { "law: {preset: spinodal}\nmaterial: {c: -1e-300}\n" SLOPE,
      "2:15: material.c: '-1e-300'" NOT "a number >= 0" },
    { "law: {preset: spinodal}\nmaterial: {R: 0}\n" SLOPE,
      "2:15: material.R: '0'" NOT "a number > 0 or inf" },
    { "law: {preset: spinodal}\nmaterial: {R: -inf}\n" SLOPE,
      "2:15: material.R: '-inf'" NOT "a number > 0 or inf" },
    { LAW SLOPE "accuracy: {rtol: 1e-15}\n",
      "3:18: accuracy.rtol: '1e-15'" NOT "a number from 1e-14 to 0.1" },
    { LAW SLOPE "accuracy: {rtol: 0.2}\n",
      "3:18: accuracy.rtol: '0.2'" NOT "a number from 1e-14 to 0.1" },
    { LAW "slope: {alpha: 0}\n",
      "2:16: slope.alpha: '0'" NOT "an angle in rad, 0 < alpha < pi/2" },
    { LAW "slope: {alpha: 0.34 rad}\n",
      "2:16: slope.alpha: '0.34 rad'" NOT "an angle in rad, 0 < alpha < pi/2" },
    { LAW "slope: {alpha_deg: 90}\n",
      "2:20: slope.alpha_deg: '90'" NOT
      "an angle in degrees, 0 < alpha_deg < 90" },
    { LAW "slope: {tan_alpha: 0}\n",
      "2:20: slope.tan_alpha: '0'" NOT "a number > 0" },
    { LAW "slope: {tan_alpha: inf}\n",
      "2:20: slope.tan_alpha: 'inf'" NOT "a number > 0" },
    { LAW SLOPE "window: {v: [1, 1]}\n",
      "3:13: window.v: [1, 1] is empty, expected lo < hi" },
    { LAW SLOPE "window: {v: [1e3, 1e-3]}\n",
      "3:13: window.v: [1e3, 1e-3] is empty, expected lo < hi" },
    { LAW SLOPE "window: {psi: [2, 1]}\n",
      "3:15: window.psi: [2, 1] is empty, expected lo < hi" },
    { LAW SLOPE "window: {v: [0, 1]}\n",
      "3:14: window.v: '0'" NOT "a number from 1e-300 to 1e300" },
    { LAW SLOPE "window: {v: [1, inf]}\n",
      "3:17: window.v: 'inf'" NOT "a number from 1e-300 to 1e300" },
    { LAW SLOPE "window: {psi: [-7, 5]}\n",
      "3:16: window.psi: '-7'" NOT "a number from 1e-300 to 1e300" },
    { "law: {preset: ruina}\nwindow: {psi: [-1.1e300, 5]}\n" SLOPE,
      "2:16: window.psi: '-1.1e300'" NOT "a number up to 1e300" },
    { LAW SLOPE "estimates: {xi: [0.9, 1]}\n",
      "3:23: estimates.xi: '1'" NOT
      "1 to 64 numbers xi in brackets, 0 < xi < 1" },
    { LAW SLOPE "trajectories: {spread: 1.5}\n",
      "3:24: trajectories.spread: '1.5'" NOT "a whole number from 0 to 10000" },
    { LAW SLOPE "trajectories: {spread: -1}\n",
      "3:24: trajectories.spread: '-1'" NOT "a whole number from 0 to 10000" },
    { LAW SLOPE "trajectories: {spread: 10001}\n",
      "3:24: trajectories.spread: '10001'" NOT
      "a whole number from 0 to 10000" },
    { LAW SLOPE "trajectories: {seed: 9007199254740993}\n",
      "3:22: trajectories.seed: '9007199254740993'" NOT
      "a whole number from 0 to 9007199254740992" },
    { LAW SLOPE "trajectories: {seed: 99999999999999999999}\n",
      "3:22: trajectories.seed: '99999999999999999999'" NOT
      "a whole number from 0 to 9007199254740992" },
    { LAW SLOPE "trajectories: {until: {time: 0}}\n",
      "3:30: trajectories.until.time: '0'" NOT "a number > 0" },
    { LAW SLOPE "trajectories: {sample: {log_time: 1}}\n",
      "3:35: trajectories.sample.log_time: '1'" NOT
      "a whole number from 2 to 1000000" },
    { LAW SLOPE "trajectories: {starts: [{v: 0, psi: 1}]}\n",
      "3:29: trajectories.starts: v: '0'" NOT "a number > 0" },
    { LAW SLOPE "trajectories: {starts: [{v: 1, psi: -1}]}\n",
      "3:37: trajectories.starts: psi: '-1'" NOT
      "a number from 1e-300 to 1e300" },
    { LAW SLOPE "trajectories: {starts: [{v: 1e-301, psi: 1}]}\n",
      "3:29: trajectories.starts: v: '1e-301'" NOT
      "v/V_star from 1e-300 to 1e300" },
    { LAW SLOPE "units: si\ntrajectories: {starts: [{v: 1, phi: -1}]}\n",
      "4:37: trajectories.starts: phi: '-1'" NOT "a number > 0" },
    { LAW SLOPE "units: si\ntrajectories: {starts: [{v: 1, psi: 1}]}\n",
      "4:32: trajectories.starts: psi: it could be psi or phi, expected phi "
      "beside units: si" },
    { LAW SLOPE "trajectories: {starts: [{v: 1, psi: 1, phi: 1}]}\n",
      "3:40: trajectories.starts: phi beside psi, expected one" },
    { LAW SLOPE "trajectories: {starts: [{v: 1 m, psi: 1}]}\n",
      "3:29: trajectories.starts: v: '1 m'" NOT "a number > 0" },
    { LAW SLOPE "units: si\nwindow: {v: [1e-4 m, 1 m/s]}\n",
      "4:14: window.v: '1e-4 m'" NOT "a number from 1e-300 to 1e300" },
    { LAW SLOPE "units: si\ntrajectories: {until: {time: 5 m}}\n",
      "4:30: trajectories.until.time: '5 m'" NOT "a number > 0" },
    { LAW SLOPE "units: si\nwindow: {psi: [1, 2]}\n",
      "4:10: window.psi: it could be psi or phi, expected window.phi beside "
      "units: si" },
    { LAW SLOPE "window: {psi: [1, 2], phi: [1, 2]}\n",
      "3:23: window.phi: not beside window.psi, expected one of the two" },
    { LAW SLOPE "window: {phi: [-1, 2]}\n",
      "3:16: window.phi: '-1' is not allowed, expected a number > 0" },
    { LAW SLOPE "window: {v: [1e-9 m/s, 1e-9 V_star]}\n",
      "3:13: window.v: [1e-9 m/s, 1e-9 V_star] is empty, expected lo < hi" },
    { LAW SLOPE "window: {v: [1 m/s, 1e299 m/s]}\n",
      "3:21: window.v: '1e299 m/s' is 1e+305 V_star, expected a number from "
      "1e-300 to 1e300" },
    { LAW SLOPE "basins: {cells: [0, 8]}\n",
      "3:18: basins.cells: '0'" NOT
      "two whole numbers [nv, npsi] from 1 to 32768" },
    { LAW SLOPE "basins: {cells: [8, 32769]}\n",
      "3:21: basins.cells: '32769'" NOT
      "two whole numbers [nv, npsi] from 1 to 32768" },
    { LAW SLOPE "basins: {audit: -1}\n",
      "3:17: basins.audit: '-1'" NOT "a whole number from 0 to 1000000" },
    { LAW SLOPE "basins: {rtol: 0}\n",
      "3:16: basins.rtol: '0'" NOT "a number from 1e-11 to 0.1" },
};

static const struct wrong wrong_together[] = {
    { "", "1:1: " NO_LAW },
    { "# nothing\n", "1:1: " NO_LAW },
    { "{}", "1:1: " NO_LAW },
    { SLOPE, "1:1: " NO_LAW },
    { LAW, "1:1: no slope, expected 'slope: {alpha: RAD}' or --alpha RAD" },
    { "law: {}\n" SLOPE, "1:6: " NO_LAW },
    { "law:\n" SLOPE, "1:5: " NO_LAW },
    { "law: {friction: log}\n" SLOPE, "1:6: " NO_LAW },
    { LAW "slope: {}\n",
      "2:8: no slope, expected 'slope: {alpha: RAD}' or --alpha RAD" },
    { LAW "slope: {alpha: 0.3, tan_alpha: 0.3}\n",
      "2:21: slope.tan_alpha: not beside slope.alpha, expected one of the "
      "two" },
    { LAW "slope: {alpha_deg: 20, alpha: 0.3}\n",
      "2:24: slope.alpha: not beside slope.alpha_deg, expected one of the "
      "two" },
    { "law: {preset: ruina, theta: psi}\n" SLOPE,
      "1:22: law.theta: not beside law.preset, expected one of the two" },
    { "law: {theta: psi, preset: ruina}\n" SLOPE,
      "1:19: law.preset: not beside law.theta, expected one of the two" },
    { "law: {theta: psi, psi_ss: minus_log}\n" SLOPE,
      "1:6: law: kinetics is missing, expected theta, psi_ss, timescale and "
      "kinetics together" },
    { "law: {kinetics: sinh}\n" SLOPE,
      "1:6: law: timescale is missing, expected theta, psi_ss, timescale and "
      "kinetics together" },
    { "law: {theta: psi, psi_ss: minus_log, timescale: ageing44, kinetics: "
      "sinh}\n" SLOPE,
      "1:49: law.timescale: timescale ageing44 is R*psi_ss and needs psi_ss "
      "> 0, but psi_ss is minus_log" },
    { "law: {theta: psi, psi_ss: minus_log, timescale: slip45, kinetics: "
      "sinh}\nmaterial: {R: inf}\n" SLOPE,
      "2:15: material.R: R must be finite for this law: its limit R = inf does "
      "not exist" },
    { "law: {theta: ln_psi, psi_ss: lambert, timescale: slip, kinetics: "
      "sinh}\n" SLOPE,
      "1:30: law.psi_ss: 'lambert'" NOT
      "inverse, minus_log, spinodal or spinodal_unit" },
    { LAW SLOPE "material: {R: 100}\n", "3:12: material.R: not used by this "
                                        "law (dieterich_gen), expected " USED },
    { LAW SLOPE "material: {a: 0.03, V_c: 1}\n",
      "3:21: material.V_c: not used by this law (dieterich_gen), "
      "expected " USED },
    { LAW SLOPE "material: {c: 0}\n", "3:12: material.c: not used by this law "
                                      "(dieterich_gen), expected " USED },
    { "law: {preset: kato_tullis}\n" SLOPE,
      "1:15: law.preset: kato_tullis needs material.V_c, expected a number > "
      "0" },
    { LAW SLOPE "trajectories: {sample: {linear_slip: 8, log_time: 8}}\n",
      "3:41: trajectories.sample.log_time: not beside "
      "trajectories.sample.linear_slip, expected one of the two" },
};
