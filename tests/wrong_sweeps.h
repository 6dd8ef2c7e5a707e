/* wrong_sweeps.h -- what is wrong with a sweep, key by key and as a whole: as
 * wrong_scenes.h. */
#pragma once

#include "wrong_scenes.h"

#define RANGE  "from: 0.2, to: 0.4, points: 3"
#define NUMBER "the key of a number, such as slope.alpha"
#define SWEEP  "sweep: {key: slope.alpha, " RANGE "}\n"
#define ONE_SHAPE                                                              \
    "not in a sweep, whose points all have the same shape; for one point: "    \
    "slipway "
static const struct wrong wrong_sweeps[] = {
    { LAW SLOPE "sweep: 3\n", "3:8: sweep: '3'" NOT "a map of keys, " AXIS
                              ", as in 'sweep: {key: ...}'" },
    { LAW SLOPE "sweep: []\n",
      "3:8: sweep: a list of 0, expected one or two of {key: KEY, ...}" },
    { LAW SLOPE "sweep: [{}, {}, {}]\n",
      "3:8: sweep: a list of 3, expected one or two of {key: KEY, ...}" },
    { LAW SLOPE "sweep: [slope.alpha]\n",
      "3:9: sweep: 'slope.alpha'" NOT "a map of keys, " AXIS
      ", as in 'sweep: {key: ...}'" },
    { LAW SLOPE "sweep: {key: slope.alfa, " RANGE "}\n",
      "3:14: sweep.key: 'slope.alfa'" NOT NUMBER
      " (did you mean slope.alpha?)" },
    { LAW SLOPE "sweep: {key: title, " RANGE "}\n",
      "3:14: sweep.key: 'title'" NOT NUMBER },
    { LAW SLOPE "sweep: {key: sweep.from, " RANGE "}\n",
      "3:14: sweep.key: 'sweep.from'" NOT NUMBER },
    { LAW SLOPE "sweep: {" RANGE "}\n",
      "3:8: sweep: key is missing, expected " NUMBER },
    { LAW SLOPE "sweep: {key: slope.alpha, from: 0.2, points: 3}\n",
      "3:8: sweep: to is missing, expected from, to and points, or values" },
    { LAW SLOPE "sweep: {key: slope.alpha, from: 0.2, values: [1]}\n",
      "3:38: sweep.values: not beside sweep.from, expected one of the two" },
    { LAW SLOPE "sweep: {key: slope.alpha, from: 0.4, to: 0.2, points: 3}\n",
      "3:33: sweep: from 0.4 to 0.2 is empty, expected from < to" },
    { LAW SLOPE "sweep: {key: slope.alpha, from: 0, to: 0.2, points: 3}\n",
      "3:33: sweep.from: slope.alpha: 0" NOT
      "an angle in rad, 0 < alpha < pi/2" },
    { LAW SLOPE "sweep: {key: slope.alpha, from: 0.2, to: 2, points: 3}\n",
      "3:42: sweep.to: slope.alpha: 2" NOT
      "an angle in rad, 0 < alpha < pi/2" },
    { LAW SLOPE "sweep: {key: slope.alpha, from: 0.2, to: 0.3, points: 1}\n",
      "3:55: sweep.points: '1'" NOT "a whole number from 2 to 250000" },
    { LAW SLOPE "sweep: {key: material.mu_star, from: -1, to: 1, points: 3, "
                "scale: log}\n",
      "3:38: sweep: -1 on a log scale, expected numbers > 0" },
    { LAW SLOPE "sweep: {key: slope.alpha, values: [0.2, -1]}\n",
      "3:41: sweep.values: slope.alpha: -1" NOT
      "an angle in rad, 0 < alpha < pi/2" },
    { LAW SLOPE "sweep: {key: slope.alpha, values: [0.2, 0.2]}\n",
      "3:41: sweep.values: 0.20000000000000001 after 0.20000000000000001, "
      "expected numbers that grow" },
    { LAW SLOPE "sweep: {key: material.c, from: 0, to: 1, points: 3}\n",
      "3:14: sweep.key: material.c: not used by this law (dieterich_gen), "
      "expected another key" },
    { LAW SLOPE "sweep: [{key: slope.alpha, " RANGE "},\n"
                "        {key: slope.tan_alpha, " RANGE "}]\n",
      "4:15: sweep.key: slope.tan_alpha beside slope.alpha, expected another" },
    { LAW SLOPE "sweep: [{key: slope.alpha, from: 0.2, to: 0.4, points: 501},\n"
                "        {key: material.a, from: 0.01, to: 0.02, points: 500}]"
                "\n",
      "4:9: sweep: a grid of 501 x 500 points, expected at most 250000 in "
      "all" },
    { LAW SLOPE "sweep: [{key: slope.alpha, " RANGE "},\n"
                "        {key: material.a, " RANGE ", refine: 0.1}]\n",
      "4:9: sweep.refine: not for a grid, expected one key" },
    { LAW SLOPE "sweep: {key: slope.alpha, " RANGE ", refine: 0}\n",
      "3:66: sweep.refine: '0'" NOT
      "a number from 1e-6 to 1, the tolerance in ln v" },
    { LAW SLOPE "products: [knees, manifolds]\n" SWEEP,
      "3:19: products: manifolds: " ONE_SHAPE
      "study --set sweep={} --set slope.alpha=VALUE" },
    { LAW "products: [folds, fold_curves]\n"
          "sweep: {key: material.a, " RANGE "}\n",
      "2:19: products: fold_curves: " ONE_SHAPE
      "study --set sweep={} --set material.a=VALUE" },
    { LAW SLOPE "products: [trajectories]\n" SWEEP,
      "3:11: products: trajectories without trajectories.starts, expected them "
      "in a sweep" },
    { LAW SLOPE "products: [trajectories]\n" SWEEP
                "trajectories: {starts: [{v: 1, psi: 1}], spread: 3}\n",
      "5:50: trajectories.spread: not in a sweep, expected "
      "trajectories.starts alone" },
    { LAW SLOPE
      "products: [trajectories]\n" SWEEP
      "trajectories: {starts: [{v: 1, psi: 1}], sample: {log_time: 9}}\n",
      "5:50: trajectories.sample: " ONE_SHAPE
      "simulate --set sweep={} --set slope.alpha=VALUE" },
    { LAW SLOPE "products: [trajectories]\nunits: si\n"
                "trajectories: {starts: [{v: 1e-6, phi: 1}]}\n"
                "sweep: {key: material.V_star, " RANGE "}\n",
      "5:24: trajectories.starts: in physical units it would be another at "
      "each material.V_star, expected dimensionless" },
    { LAW SLOPE "window: {v: [1e-6 m/s, 1 m/s]}\n"
                "sweep: {key: material.V_star, " RANGE "}\n",
      "3:13: window.v: in physical units it would be another at each "
      "material.V_star, expected dimensionless" },
    { LAW SLOPE "rabinowicz: {data: a.csv}\n" SWEEP,
      "3:20: rabinowicz.data: " ONE_SHAPE
      "rabinowicz --set sweep={} --set slope.alpha=VALUE" },
    { LAW SLOPE "rabinowicz: {tan_alpha: [0.3]}\n" SWEEP,
      "3:25: rabinowicz.tan_alpha: not in a sweep, expected sweep: {key: "
      "slope.tan_alpha, ...}" },
    { LAW "rabinowicz: {restitution: 0.5}\nproducts: [folds]\n"
          "sweep: {key: material.a, " RANGE "}\n",
      "2:13: rabinowicz: takes a slope in a sweep, expected 'slope: {alpha: "
      "RAD}' or --alpha RAD" },
    { LAW SLOPE "products: [basins]\nbasins: {cells: [32768, 16384]}\n" SWEEP,
      "4:17: basins.cells: 32768 x 16384 at each of 3 points, expected at "
      "most 1e+09 in all (shares do not take them)" },
    { LAW SLOPE "products: [folds]\n"
                "sweep: {key: slope.alpha, " RANGE ", refine: 0.1}\n",
      "3:11: products: no knees beside sweep.refine, expected them: it follows "
      "v_plus and v_minus" },
    { LAW SLOPE "sweep: {key: slope.alpha, " RANGE ", show: persistance}\n",
      "3:64: sweep.show: 'persistance'" NOT
      "velocities, velocity_estimates, persistence, static_friction, "
      "fracture_energy or basins (did you mean persistence?)" },
    { LAW SLOPE "sweep: {key: slope.alpha, " RANGE ", show: [velocities]}\n",
      "3:64: sweep.show: a list" NOT
      "velocities, velocity_estimates, persistence, static_friction, "
      "fracture_energy or basins" },
    { LAW SLOPE "sweep: {key: slope.alpha, " RANGE ", y_scale: lin}\n",
      "3:67: sweep.y_scale: 'lin'" NOT "auto, linear or log" },
    { LAW SLOPE "sweep: {key: slope.alpha, " RANGE ", y_range: [2, 1]}\n",
      "3:67: sweep.y_range: [2, 1] is empty, expected lo < hi" },
    { LAW SLOPE "sweep: {key: slope.alpha, " RANGE ", y_range: [0, 1]}\n",
      "3:67: sweep.y_range: from 0 on a log axis, expected numbers > 0" },
    { LAW SLOPE "sweep: {key: slope.alpha, " RANGE ", show: persistence,\n"
                "        y_scale: log, y_range: [-1, 1]}\n",
      "4:32: sweep.y_range: from -1 on a log axis, expected numbers > 0" },
    { LAW SLOPE "sweep: [{key: slope.alpha, " RANGE "},\n"
                "        {key: material.a, " RANGE ", y_range: [1, 2]}]\n",
      "4:67: sweep.y_range: not for a grid, expected one key" },
    { LAW SLOPE "products: [folds]\n"
                "sweep: {key: slope.alpha, " RANGE ", show: persistence}\n",
      "3:11: products: neither knees nor estimates beside sweep.show: "
      "persistence, expected them" },
    { LAW SLOPE "sweep: {key: slope.alpha, " RANGE ", show: basins}\n",
      "1:1: products: no basins beside sweep.show: basins, expected them" },
};
