/*
 * draws.h -- the values of an ensemble's keys, draw by draw: any block of them,
 * by any thread, the same bytes.
 *
 * sobol: ENSEMBLE_REPEATS scramblings (sobol.h) one after another, each over
 * its own part of the draws, so that their means tell the error.  random: a
 * hash of seed, draw and key.  grid: of the largest m with m^keys <= draws, the
 * quantiles (i + 1/2)/m.  A normal law is met through its quantile function
 * (normal.h), so that even points stay even; a covariance through its Cholesky
 * factor.  samples: the rows of the file.
 */
#pragma once

#include "scene.h"
#include "sobol.h"
#include "table.h"
#include "tolerance.h"

struct draws {
    size_t count; /* of draws */
    size_t keys;
    const char *key[SCENE_SPREADS]; /* borrowed, of scene or table */

    enum ensemble_method method;
    bool is_sample;
    uint64_t seed;
    size_t each; /* draws of a repeat (sobol), values of a key (grid) */
    const struct scene_spread *spread; /* borrowed; NULL: otherwise */
    struct sobol sobol;

    struct table table;  /* owned; of samples or of a covariance */
    double *mean, *root; /* owned; with a covariance: [keys], [keys * keys],
                            the lower triangle */
    double *sample;      /* owned; column by column */
    int id;              /* column of the table; -1: none */
};

/* Those of the scene's ensemble; reads its files.  STATUS_BAD_SCENE with one
 * line FILE:LINE:COL, STATUS_IO, STATUS_NO_MEMORY; *d is then empty.  The scene
 * must stay. */
MUST_CHECK enum status draws_init(struct draws *d, const struct scene *scene,
                                  struct fault *why);

/* Draws first .. first + count - 1 into column[keys][count]. */
void draws_fill(const struct draws *d, size_t first, size_t count,
                double *const column[]);

/* Whether repeats are scramblings. */
bool draws_is_scrambled(const struct draws *d);

/* The independent scores z[keys] that draw i is made of, drawn: normal ones,
 * and of a uniform law one that is even in (-1, 1). */
void draws_scores(const struct draws *d, size_t i, double z[]);

/* The probability that score k is below z. */
double draws_below(const struct draws *d, size_t k, double z);

/* Which of ENSEMBLE_REPEATS parts a draw belongs to: scramblings, or else equal
 * parts without an order. */
size_t draws_repeat(const struct draws *d, size_t i);

/* "sobol", "random", "grid", or "samples" of a file. */
const char *draws_method(const struct draws *d);

/* What the sample is called; NULL: samples have no names. */
const char *draws_id(const struct draws *d, size_t i);

/* A second call is harmless. */
void draws_free(struct draws *d);
