/* basin_proof.h -- which labels of a basin map are proved (proof_side.h). */
#pragma once

#include <stdint.h>

#include "proof_fold.h"
#include "proof_side.h"

struct study;

/* Of a cell's label. */
enum label_proof {
    LABEL_PROVED,
    LABEL_NEAR,   /* the row meets the tube there, or the label is undecided */
    LABEL_BEYOND, /* the tube ends before that row */
    LABEL_PROOFS
};
extern const char *const label_proof_names[];

struct basin_proof {
    struct proof_row *row;  /* owned; of the grid; NULL: nothing is proved */
    unsigned may[2];        /* bits of enum fate: of the slow side, the fast */
    enum proof_alone alone; /* without a saddle */
    double fraction;        /* of the cells */
    int64_t near, beyond;   /* cells */
    const char *reason;     /* borrowed: why nothing is; else NULL */
};

/* Of the grid of s->basins; a cell that is proved to have another label is told
 * in s->proof.lie, unless doubles and decimals are on different sides of it.
 * STATUS_NO_MEMORY. */
MUST_CHECK enum status basin_prove(struct study *s);

/* enum label_proof of rows first .. first + count - 1 into out, which holds
 * their labels. */
void basin_proof_rows(const struct study *s, size_t first, size_t count,
                      int8_t out[]);

/* The same of another grid over the window, of doubles: enum fate into out[],
 * FATE_NONE where it is not proved; some are.  STATUS_NO_MEMORY. */
MUST_CHECK enum status basin_proof_hide(const struct study *s, size_t columns,
                                        size_t rows, int8_t out[]);

/* A second call is harmless. */
void basin_proof_free(struct basin_proof *b);
