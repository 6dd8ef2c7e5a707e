/*
 * field_text.h -- the block's field as text that other programs can read: the
 * law's formulas, lowered to differences from a steady state (law_tape.h).
 *
 * Parameters keep their names, so that they can be changed in the other
 * program; the anchor follows them, at any point lnv0 of the steady curve.
 */
#pragma once

#include "block.h"
#include "law_typed.h"
#include "lines.h"

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
    TEXT_Y0,
    TEXT_PARAMETERS
};

/* Names of at most 9 letters, no two alike but for capitals. */
struct text_symbol {
    const char *name, *unit, *meaning;
};
extern const struct text_symbol text_parameters[TEXT_PARAMETERS];

/* The parameter of a block; an infinite R becomes 1e200. */
double text_parameter_value(const struct block *b, enum text_parameter p);

/* ln v, and ln psi (psi where it is a logarithm). */
const char *text_state_name(const struct law *law, int coordinate);

struct field_text {
    bool uses[TEXT_PARAMETERS];
    bool owns[LAW_OWNS]; /* names of the law's own */
    /* Among them mu and the field, fx and fy times e^scale, in the chart (ln v,
     * ln psi) per t*; none overflows. */
    struct text_lines lines;
};

void field_text(const struct law *law, struct field_text *out);
