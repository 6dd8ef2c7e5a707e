/*
 * release.h -- Rabinowicz's experiment (Putelat & Dawes 2015, 4.1, 4.2), both
 * ways: critical release distances of a law and material, and what measured
 * ones say of these.
 *
 *     struct release r;
 *     release_run(&r, &scene, NULL, &fault);
 *     ... read r ...
 *     release_free(&r);
 */
#pragma once

#include "observations.h"
#include "parabola.h"
#include "persistence.h"
#include "result.h"
#include "scene.h"
#include "slip_curve.h"

#include "monitor.h"

struct study;

/* One slope, lengths in m.  Exact: from the stable manifold; the others: the
 * paper's estimates beside them. */
struct release_row {
    double tan_alpha, alpha; /* alpha in rad */
    struct quantity v_k;     /* m/s: the block just goes on from there */
    struct quantity l_k;     /* the ball gives it v_k: (20), (21) */
    struct quantity l_k_G;   /* of the exact fracture energy, (32) */
    struct quantity l_k_33;  /* of (33) with the mu_s below */
    struct quantity mu_s;    /* of (41) with the exact v_plus */
    struct quantity s_k;     /* the exact excess slip */
    struct quantity s_k_30;  /* of (30) */
};
extern const struct record_type record_release;

/* What the fit of (33) means for the material; errors and intervals 95 %. */
struct release_material {
    struct quantity L;       /* m, of the factor, with K, eta and b - a given */
    struct quantity mu_star; /* of mu_half with b - a given */
    double L_low, L_high, mu_star_low, mu_star_high;
    double L_deviation, mu_star_deviation; /* standard deviations */
};
extern const struct record_type record_release_material;

/* Of the slope of a study whose critical numbers and estimates are known. */
struct release_row release_at(const struct study *s);

struct release {
    struct quantity K;       /* (22) */
    struct release_row *row; /* owned; the scene's slopes, in its order */
    size_t rows;
    /* The rest is empty without data. */
    struct observations observed; /* owned */
    struct parabola parabola;     /* of l_k, where points > 0 */
    struct release_material material;
    struct slip_curve slip;         /* owned; of l_k */
    struct persistence persistence; /* of x_k, where points > 0 */
};

/* Reads the data, computes the rows, fits.  What does not exist is a reason in
 * its number.  Errors as study_run and observations_read, STATUS_IO where the
 * data cannot be read; *r is then empty and *why says what failed.  Nothing is
 * borrowed from the scene. */
MUST_CHECK enum status release_run(struct release *r, const struct scene *scene,
                                   const struct monitor *monitor,
                                   struct fault *why);

/* What an experiment says, either way.  In results.run a struct release. */
extern const struct result *const release_tables[];

/* A second call is harmless. */
void release_free(struct release *r);
