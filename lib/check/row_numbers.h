/*
 * row_numbers.h -- all that a row of a table may state of its slope, computed.
 * record_row names every member as the reference tables spell it.
 */
#ifndef CHECK_ROW_NUMBERS_H
#define CHECK_ROW_NUMBERS_H

#include "slope_row.h"
#include "study.h"

/* One extremum of mu_ss, or the cusp where the two meet. */
struct extremum_number {
    struct quantity v, psi, mu, alpha;
};

struct row_numbers {
    struct quantity eps2, tan_alpha;
    /* The steady state nearest to the row's v; without one the saddle. */
    int8_t type;
    struct quantity v, psi, mu, lambda_minus, lambda_plus, trace, det;
    int64_t has_saddle;
    struct quantity v_sp, psi_sp;
    struct critical_numbers critical;
    int64_t knees_upper, knees_lower; /* how many crossings */
    struct quantity v_mark[SLOPE_MARKS];
    struct fold_numbers folds;
    struct extremum_number maximum, minimum, cusp;
    /* d ln v_plus/d alpha, and of v_minus or psi_at_v0 (row_inputs.h). */
    struct quantity dlnvplus_dalpha, dlnlower_dalpha;
};

extern const struct record_type record_row;

/* The column of this name or of its name in JSON; NULL if there is none. */
const struct record_field *row_column(const char *name);

/* The products a column needs; `has_folds` only: it does without an alpha. */
unsigned row_column_products(const struct record_field *column);

/* What rounding of alpha costs is a derivative: the column needs one. */
bool row_column_is_derivative(const struct record_field *column);

static inline const struct quantity *row_quantity(
    const struct row_numbers *n, const struct record_field *column)
{
    return (const void *) ((const char *) n + column->offset);
}

/* Computes what the products give, but for the two derivatives; the rest says
 * that nobody asked.  Errors as study_run, with *n undefined. */
MUST_CHECK enum status row_numbers_find(const struct slope_row *s, size_t law,
                                        double rtol, unsigned products,
                                        struct row_numbers *n,
                                        struct fault *why);

#endif
