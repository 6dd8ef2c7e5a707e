/* stress_work.h -- a case at work: its study, made as its kind asks, is judged
 * by the kind's own function, which fills the row. */
#pragma once

#include "stress_oracle.h"
#include "stress_row.h"
#include "study.h"

struct stress_work {
    struct scene scene; /* borrows what the case's owns */
    struct study study;
    struct stress_oracle *oracle; /* borrowed */
    struct stress_row *row;       /* borrowed */
};

/* Each returns STATUS_NO_MEMORY, or a failure of the program, of which
 * row->fault may say more. */

/* The fate of the first start, by regions and by orbits, beside the side on
 * which the oracle's branches leave it. */
MUST_CHECK enum status stress_start_judge(struct stress_work *w);

/* The labels of the grid, likewise. */
MUST_CHECK enum status stress_window_judge(struct stress_work *w);

/* The fields of the grid, STRESS_LOOKS of its cells or all of fewer, beside
 * orbits in 113 bits. */
MUST_CHECK enum status stress_grid_judge(struct stress_work *w);
