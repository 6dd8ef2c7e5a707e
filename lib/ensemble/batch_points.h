/* batch_points.h -- inside batch.c: draws whose numbers take more than the
 * first stages of a study, as those of basins, or are of a system of formulas.
 * Each is a point of a sweep (sweep_point.h), and has its columns' numbers. */
#pragma once

#include "sweep_column.h"

struct batch_points {
    struct scene scene;     /* borrows; with the products of the columns */
    struct sweep_dims dims; /* owned */
    struct sweep_columns columns; /* owned */
};

/* What a sweep of the scene would have, but no curves.  STATUS_NO_MEMORY leaves
 * *p empty. */
MUST_CHECK enum status batch_points_init(struct batch_points *p,
                                         const struct scene *scene);

/* The numbers of a draw by themselves: whether column k is one, and whether the
 * scene's own study has it (there[k]; of a law always), for those who name
 * none.  STATUS_NO_MEMORY, or that of the study. */
bool batch_points_has(const struct batch_points *p, size_t k);
MUST_CHECK enum status batch_points_there(const struct batch_points *p,
                                          bool there[]);

/* A second call is harmless. */
void batch_points_free(struct batch_points *p);
