/* xpp_lines.h -- the statements of an .ode file, for xpp_model.c. */
#pragma once

#include "xpp_model.h"

enum { XPP_ARGUMENTS = 9 };

enum xpp_kind {
    XPP_RATE,      /* name' = text */
    XPP_NAME,      /* name = text */
    XPP_FUNCTION,  /* name(argument, ...) = text */
    XPP_START,     /* name(0) = text */
    XPP_PARAMETER, /* name = text */
    XPP_OPTION     /* @ name = text */
};

struct xpp_statement {
    enum xpp_kind kind;
    char name[FORMULA_NAME];
    char argument[XPP_ARGUMENTS][FORMULA_NAME];
    int arguments;
    const char *text; /* borrowed: of xpp_lines.letters */
    size_t line;
    int state; /* for those who order names */
};

struct xpp_lines {
    struct xpp_statement at[XPP_STATEMENTS];
    int count;
    char letters[XPP_SIZE + 2]; /* small, each formula 0-ended */
};

/* STATUS_BAD_SCENE for what is no statement of a planar flow. */
MUST_CHECK enum status xpp_lines_read(const char *text, const char *name,
                                      struct xpp_lines *out, struct fault *why);

/* The last option of this name, or of its other name; NULL: there is none. */
const char *xpp_option(const struct xpp_lines *lines, const char *name,
                       const char *other);
