/*
 * lines.h -- a tape as lines of text for another program, which has only the
 * functions of function.h.  A number of this kind is a node: what a step does
 * is written down with the formulas of its constants, so that parameters keep
 * their names and can be changed in the other program.
 */
#pragma once

#include "tape.h"

enum { TEXT_LINES = 160, TEXT_LINE = 800 };

/* name = text; `moves`: changes with the state, not only with parameters. */
struct text_line {
    char name[FORMULA_NAME];
    char text[TEXT_LINE];
    bool moves;
};

struct text_lines {
    struct text_line line[TEXT_LINES]; /* each needs only those before it */
    size_t lines;
    bool calls[FUNCTIONS];    /* among those with a body */
    bool uses[FORMULA_NODES]; /* leaves */
};

/* What a tape computes, as nodes: rate[i] exp(scale) are the rates of the chart
 * at the offsets (nodes) from the anchor; none of them overflows. */
struct tape_text {
    int rate[2], scale, value[TAPE_VALUES];
};
void text_of_tape(struct formula *f, const struct tape *t, const int offset[2],
                  struct tape_text *out);

/* Lines that compute the nodes; they must be named.  What stands in several
 * places is named k1, k2, ...  False where a line is too long, or there are
 * too many. */
MUST_CHECK bool text_write(struct formula *f, const int result[], int results,
                           struct text_lines *out);
