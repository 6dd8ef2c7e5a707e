/* CSV files, by every reader: the tables of `check`, the measurements of
 * `rabinowicz`, the states of `push`. */
#include "expected.h"
#include "fuzz.h"
#include "number.h"
#include "observations.h"
#include "slope_row.h"

static void must_be_blamed(enum status s, const struct fault *why)
{
    MUST(s == STATUS_OK || s == STATUS_BAD_SCENE);
    if (s == STATUS_BAD_SCENE)
        must_be_a_line(why);
}

/* What `check` asks of a row before it computes. */
static void read_row(const struct expected *expected, size_t row)
{
    struct slope_row slope;
    struct fault why;
    double tolerance;

    must_be_blamed(slope_row_read(expected->table, row, &slope, &why), &why);
    for (size_t i = 0; i < expected->columns; i++) {
        const struct expected_value v = expected_at(expected, row, i);
        (void) expected_tolerance(expected, row, i, v.number, &tolerance);
    }
    (void) expected_lost(expected, row);
    (void) expected_products(expected, row);
}

static void read_baseline(const struct table *t)
{
    struct expected expected;
    struct fault why;
    const enum status s = expected_read(&expected, t, &why);

    must_be_blamed(s, &why);
    for (size_t i = 0; s == STATUS_OK && i < t->rows; i++)
        read_row(&expected, i);
    expected_free(&expected);
}

static void read_observations(const struct table *t)
{
    struct observations o;
    struct fault why;

    must_be_blamed(observations_read(&o, t, &why), &why);
    observations_free(&o);
}

static void read_states(const struct table *t)
{
    double x;

    for (size_t i = 0; i < t->rows; i++) {
        const struct table_cell *v = table_find(t, i, "v");
        const struct table_cell *psi = table_find(t, i, "psi");
        if (v != NULL)
            (void) number_read(v->text, &x);
        if (psi != NULL)
            (void) number_read(psi->text, &x);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct table t;
    struct fault why;
    const enum status s =
        table_parse(&t, (const char *) data, size, "t.csv", &why);

    must_be_blamed(s, &why);
    if (s == STATUS_OK) {
        read_baseline(&t);
        read_observations(&t);
        read_states(&t);
    }
    table_free(&t);
    return 0;
}
