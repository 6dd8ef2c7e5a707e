/*
 * field_text.h -- the block's field as text that other programs can read: the
 * formulas of field_formula.h and steady_formula.h, compiled for a kind of
 * number that writes down what is done to it.
 *
 * Parameters keep their names, so that they can be changed in the other
 * program; the anchor follows them, at any point lnv0 of the steady curve.
 */
#ifndef FRICTION_FIELD_TEXT_H
#define FRICTION_FIELD_TEXT_H

#include "block.h"
#include "scalar_text.h"

enum text_parameter {
    TEXT_ALPHA,
    TEXT_MU_STAR,
    TEXT_A,
    TEXT_B,
    TEXT_C,
    TEXT_R,
    TEXT_V_C,
    TEXT_EPS2,
    TEXT_LNV0,
    TEXT_PARAMETERS
};

/* Names of at most 9 letters, no two alike but for capitals. */
struct text_symbol {
    const char *name, *unit, *meaning;
};
extern const struct text_symbol text_parameters[TEXT_PARAMETERS];

/* The parameter of a block; an infinite R becomes 1e300. */
double text_parameter_value(const struct block *b, enum text_parameter p);

/* ln v, and ln psi (psi where it is a logarithm). */
const char *text_state_name(const struct law *law, int coordinate);

enum { TEXT_LINES = 80, TEXT_LINE = 400, TEXT_NAME = 12 };

/* name = text; `moves`: changes with the state, not only with parameters. */
struct text_line {
    char name[TEXT_NAME];
    char text[TEXT_LINE];
    bool moves;
};

struct field_text {
    bool uses[TEXT_PARAMETERS];
    bool calls[SCALAR_TEXTS];
    /* Each needs only those before it.  Among them mu and the field, fx and fy
     * times e^scale, in the chart (ln v, ln psi) per t*; none overflows. */
    struct text_line line[TEXT_LINES];
    size_t lines;
};

void field_text(const struct law *law, struct field_text *out);

#endif
