/*
 * margin.h -- how far a state is from another fate along a row or a column:
 * the push that starts what stops, the brake that stops what slides.
 */
#pragma once

#include "region.h"

/* Whether regions have different labels, so that there is a margin. */
bool margin_exists(const struct regions *r);

/* Where the label changes along a line of the plane, absolute. */
struct margin_line {
    struct crossing *at; /* owned; ascending */
    size_t count, room;
    bool untold; /* a part of it has no label */
};

/* Room for the lines of both separatrices; they may be NULL.
 * STATUS_NO_MEMORY: *l is empty. */
MUST_CHECK enum status margin_init(struct margin_line *l,
                                   const struct separatrix *one,
                                   const struct separatrix *other);

/* The row y = w (cuts along y) or the column x = w (cuts along x): r's
 * separatrix is along y, cuts is the same curves along either. */
void margin_find(struct margin_line *l, const struct regions *r,
                 const struct separatrix *cuts, double w);

/* From a point of the line to the nearest change of label, signed, and the
 * bound on its error; infinite where there is none. */
double margin_at(const struct margin_line *l, double at, double *error);

/* The same of n states anywhere, along their rows and along their columns;
 * `along`: [SEPARATRIX_X], [SEPARATRIX_Y].  STATUS_NO_MEMORY. */
MUST_CHECK enum status margin_states(const struct regions *r,
                                     const struct separatrix along[2],
                                     const struct vec2 z[], size_t n,
                                     double x[], double y[]);

/* A second call is harmless. */
void margin_free(struct margin_line *l);
