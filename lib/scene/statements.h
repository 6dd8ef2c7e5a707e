/* statements.h -- a system in one text: "x' = y; y' = -k*x; k = 1". */
#ifndef SCENE_STATEMENTS_H
#define SCENE_STATEMENTS_H

#include "node.h"

enum { STATEMENTS = 64 };

/* NAME' = TEXT or NAME = TEXT, of which both are cut out. */
struct statement {
    char *name, *text;
    bool rate;
};

struct statements {
    char *text; /* owned: cut in place */
    struct statement at[STATEMENTS];
    size_t count;
    const struct node *node;
};

/* Cuts the text of a node, NULL for none.  out->text is the caller's to free in
 * any case; errors as scene_read. */
MUST_CHECK enum status statements_cut(const struct node *n,
                                      struct statements *out,
                                      struct fault *why);

#endif
