/* wrong_ensembles.h -- what is wrong with an ensemble: as wrong_scenes.h. */
#pragma once

#include "wrong_scenes.h"

#define SPREAD                                                                 \
    "{normal: [m, s]}, {uniform: [lo, hi]} or {lognormal: [median, factor]}"
static const struct wrong wrong_ensembles[] = {
    { LAW SLOPE "ensemble: {parameters: {}}\n",
      "3:24: ensemble.parameters: an empty map of keys" NOT
      "1 to 32 of {KEY: {normal: [m, s]}, KEY: {uniform: [lo, hi]}, KEY: "
      "{lognormal: [median, factor]}}" },
    { LAW SLOPE "ensemble: {parameters: {material.a: 3}}\n",
      "3:37: ensemble.parameters: material.a: '3'" NOT SPREAD },
    { LAW SLOPE "ensemble: {parameters: {material.a: {normol: [1, 2]}}}\n",
      "3:38: ensemble.parameters: material.a: 'normol'" NOT SPREAD },
    { LAW SLOPE "ensemble: {parameters: {material.a: {normal: [1, 0]}}}\n",
      "3:46: ensemble.parameters: material.a: a list" NOT
      "{normal: [mean, standard deviation > 0]}" },
    { LAW SLOPE "ensemble: {parameters: {material.a: {uniform: [2, 1]}}}\n",
      "3:47: ensemble.parameters: material.a: a list" NOT
      "{uniform: [lo, hi]}, lo < hi" },
    { LAW SLOPE "ensemble: {parameters: {material.a: {lognormal: [1, 1]}}}\n",
      "3:49: ensemble.parameters: material.a: a list" NOT
      "{lognormal: [median > 0, factor > 1]}" },
    { LAW SLOPE "ensemble: {parameters: {material.q: {normal: [1, 1]}}}\n",
      "3:25: 'material.q' is no key of a number, expected one such as "
      "material.a (did you mean material.a?)" },
    { LAW SLOPE "ensemble: {parameters: {material.R: {normal: [1, 1]}}}\n",
      "3:25: material.R: not used by this law (dieterich_gen), expected "
      "another key" },
    { LAW SLOPE "ensemble: {parameters: {material.a: {normal: [-1, 1]}}}\n",
      "3:37: ensemble.parameters: material.a: its median -1" NOT
      "a number > 0" },
    { LAW SLOPE "ensemble: {parameters: {slope.alpha: {normal: [0.3, 1]}, "
                "slope.tan_alpha: {normal: [0.3, 1]}}}\n",
      "3:58: slope.tan_alpha beside slope.alpha, expected one of the two" },
    { LAW SLOPE "ensemble: {samples: a.csv, covariance: b.csv}\n",
      "3:28: ensemble.covariance: not beside ensemble.samples, expected one of "
      "the two" },
    { LAW SLOPE "ensemble: {draws: 0}\n",
      "3:19: ensemble.draws: '0'" NOT "a whole number from 1 to 1000000000" },
    { LAW SLOPE "ensemble: {method: soboll}\n",
      "3:20: ensemble.method: 'soboll'" NOT
      "sobol, random or grid (did you mean sobol?)" },
    { LAW SLOPE "ensemble: {numbers: v_plus}\n",
      "3:21: ensemble.numbers: 'v_plus'" NOT
      "a list of at most 256 names such as v_plus" },
    { LAW SLOPE "ensemble: {pushes: [{v: 1}]}\n",
      "3:21: ensemble.pushes: expected v and psi (or phi), or from: creep and "
      "kick" },
    { LAW SLOPE "ensemble: {pushes: [{v: 1, psi: 1, w: 2}]}\n",
      "3:36: ensemble.pushes: unknown key 'w', expected v and psi, or from: "
      "creep and kick" },
    { LAW SLOPE "ensemble: {pushes: [{v: -1, psi: 1}]}\n",
      "3:25: ensemble.pushes: v: '-1'" NOT "a number > 0" },
    { LAW SLOPE "ensemble: {pushes: [{from: slide, kick: 1}]}\n",
      "3:28: ensemble.pushes: expected {from: creep, kick: DV}" },
    { LAW SLOPE "ensemble: {pushes: [{from: creep, kick: x}]}\n",
      "3:41: ensemble.pushes: kick: 'x'" NOT "a number" },
    { LAW SLOPE "units: si\nensemble: {pushes: [{v: 1, psi: 1}]}\n",
      "4:28: ensemble.pushes: psi: it could be psi or phi, expected phi beside "
      "units: si" },
    { LAW SLOPE "material: {a: 0.0349 +-}\n",
      "3:15: material.a: '0.0349 +-'" NOT "X +- S, two numbers, S > 0" },
    { LAW SLOPE "material: {a: 0.0349 +- -0.001}\n",
      "3:15: material.a: '0.0349 +- -0.001'" NOT "X +- S, two numbers, S > 0" },
    { LAW SLOPE "material: {a: 0.0349 +- inf}\n",
      "3:15: material.a: '0.0349 +- inf'" NOT "X +- S, two numbers, S > 0" },
    { LAW SLOPE "material: {a: -1 +- 0.1}\n",
      "3:15: material.a: '-1'" NOT "a number > 0" },
    { LAW SLOPE "material: {R: 100 +- 1}\n",
      "3:12: material.R: not used by this law (dieterich_gen), expected "
      "mu_star, a, b, L or V_star" },
    { LAW SLOPE "accuracy: {rtol: 1e-9 +- 1e-10}\n",
      "3:18: accuracy.rtol: '1e-9 +- 1e-10'" NOT "a number from 1e-14 to 0.1" },
    { LAW SLOPE "material: {a: 0.03 +- 0.001}\n"
                "ensemble: {parameters: {material.a: {normal: [0.03, 1]}}}\n",
      "4:25: ensemble.parameters: material.a has a scatter where it stands, "
      "expected one of the two" },
    { LAW "slope: {alpha: 0.3 +- 0.01}\n"
          "ensemble: {parameters: {slope.tan_alpha: {normal: [0.3, 1]}}}\n",
      "3:25: slope.tan_alpha beside slope.alpha, expected one of the two" },
    { LAW SLOPE "material: {a: 0.03 +- 0.001}\nensemble: {samples: a.csv}\n",
      "3:15: material.a: X +- S beside ensemble.samples, expected one of the "
      "two" },
};
