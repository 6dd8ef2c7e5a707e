/* sweep_told.h -- a sweep in the units that its scene tells numbers in: those
 * of each point, where a key changes them. */
#pragma once

#include "sweep.h"
#include "unit.h"

/* At a point; of what is the same at all points, at the first. */
struct unit_system sweep_units(const struct sweep *s, size_t point);

/* The same for readers: slopes as that point's is given. */
struct unit_system sweep_answer_units(const struct sweep *s, size_t point);

/* An entry of a column, as sweep_entry, in the units of its point. */
struct quantity sweep_told(const struct sweep *s, const struct unit_system *u,
                           int column, size_t point, size_t entry);

/* "saddle_phi" of saddle_psi, and its unit. */
struct sweep_name {
    char text[64 + RESULT_NAME];
};
struct sweep_name sweep_told_name(const struct sweep *s,
                                  const struct unit_system *u, int column);
const char *sweep_column_unit(const struct sweep *s,
                              const struct unit_system *u, int column);

/* Of keys and maps. */
const char *sweep_told_unit(const struct sweep *s, const char *own);

/* The same of a start, v and psi, or of an axis beside the keys. */
double sweep_told_value(const struct sweep *s, const char *own, double x);
const char *sweep_told_state(const struct sweep *s);
struct sweep_name sweep_told_dim(const struct sweep *s, enum sweep_dim dim);

/* A layer at one point in a few numbers. */
enum { SUMMARY_WORDS = 8 };

struct sweep_summary {
    size_t cells, present;        /* all of them; those that have a value */
    double least, greatest;       /* of numbers; NaN without any */
    size_t counts[SUMMARY_WORDS]; /* of codes, by code */
};

/* Of layer number k.  STATUS_IO with one line in *why, STATUS_NO_MEMORY. */
MUST_CHECK enum status sweep_summary_find(const struct sweep *s, size_t k,
                                          size_t point,
                                          struct sweep_summary *out,
                                          struct fault *why);
