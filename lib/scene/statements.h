/* statements.h -- formulas in one text: "x' = y; y' = -k*x; k = 1". */
#pragma once

#include "node.h"

enum { STATEMENTS = 64 };

/* NAME' = TEXT or NAME = TEXT, of which both are cut out. */
struct statement {
    char *name, *text;
    bool rate;
};

struct statements {
    struct statement at[STATEMENTS];
    size_t count;
};

/* Cuts a text in place, at semicolons and ends of lines.  NULL, or the part
 * that is no statement, or one too many. */
const char *statements_cut(char *text, struct statements *out);

/* Those of a scene's system.ode, none without a node.  *text, the caller's to
 * free in any case, is what they point into; errors as scene_read. */
MUST_CHECK enum status statements_read(const struct node *n, char **text,
                                       struct statements *out,
                                       struct fault *why);
