/*
 * stress_run.h -- runs the catalogue, cases in parallel, and judges each.
 *
 *     struct stress s;
 *     stress_run(&s, &list, monitor, &fault);
 *     ... s.row[i] of list.at[i] ...
 *     stress_free(&s);
 */
#pragma once

#include "monitor.h"
#include "result.h"
#include "stress_case.h"
#include "stress_judge.h"
#include "stress_row.h"

struct stress {
    struct stress_row *row; /* owned; one a case of the list */
    size_t count;
    size_t outcome[STRESS_OUTCOMES]; /* how many of each */
    size_t counted, full; /* cases with digits; and within STRESS_MISSING of
                             what conditioning allows */
};

/* All cases; the same at any number of threads but for seconds.  A case that
 * cannot be computed is no error: see `outcome`.  STATUS_NO_MEMORY,
 * STATUS_STOPPED; *s is then empty.  The list must outlive s. */
MUST_CHECK enum status stress_run(struct stress *s,
                                  const struct stress_list *list,
                                  const struct monitor *monitor);

/* What a run of the catalogue says.  In results.run a struct stress. */
extern const struct result *const stress_tables[];

/* A second call is harmless. */
void stress_free(struct stress *s);
