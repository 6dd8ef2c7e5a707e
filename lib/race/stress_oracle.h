/* stress_oracle.h -- the truths of slopes, found once for neighbouring cases of
 * one slope. */
#pragma once

#include "scene.h"
#include "stress_row.h"
#include "stress_truth.h"

/* Starts zeroed; some 40 kB. */
struct stress_oracle {
    bool asked;
    struct law law; /* of the slope asked for last */
    struct material m;
    long double tan_alpha;
    struct stress_truth truth;
};

/* The truth of the scene's slope, good until the oracle is asked again: that
 * of the last call where law, values and slope are the same.  Notes in the row
 * what it took: evaluations of the truth, seconds of this call. */
const struct stress_truth *stress_oracle_ask(struct stress_oracle *oracle,
                                             const struct scene *scene,
                                             struct stress_row *row);
