/* Refinement of curves with known bends and ends, without any study. */
#include "sweep_refine.h"

#include <math.h>

#include "check.h"
#include "fault_alloc.h"
#include "sweep_reason.h"

/* A curve and where it is. */
struct curve {
    double (*value)(double x);
    double lo, hi;
};

static double parabola(double x)
{
    return 3.0 * x * x;
}

static double kink(double x)
{
    return fabs(x - 0.3);
}

static double root(double x)
{
    return sqrt(0.7 - x);
}

static double rising(double x)
{
    return 5.0 * sqrt(x - 0.21) + x;
}

static double line(double x)
{
    return 2.0 - x;
}

static void set_row(struct sweep_rows *rows, size_t i,
                    const struct curve curve[])
{
    const double x = sweep_rows_x(rows, i)[0];

    for (size_t k = 0; k < REFINE_CURVES; k++) {
        const bool is = x >= curve[k].lo && x <= curve[k].hi;
        double *real = sweep_rows_real(rows, i, k);
        real[0] = is ? curve[k].value(x) : (double) NAN;
        real[1] = 0.0;
        *sweep_rows_code(rows, i, k) = is ? REASON_PRESENT : REASON_FIRST;
    }
}

static double constant(double x)
{
    (void) x;
    return 1.0;
}

/* From n points over [0, 1] until nothing needs a middle. */
static struct sweep_rows refined(const struct curve curve[], size_t n,
                                 double tol)
{
    struct sweep_rows rows = sweep_rows_of(REFINE_CURVES, false);
    struct sweep_refine f = { .curve = { 0, 1 }, .tol = tol };

    assert_int_equal(sweep_rows_add(&rows, n), STATUS_OK);
    for (size_t i = 0; i < n; i++) {
        sweep_rows_x(&rows, i)[0] = (double) i / (double) (n - 1);
        set_row(&rows, i, curve);
    }
    assert_int_equal(sweep_refine_init(&f, &rows), STATUS_OK);
    while (f.spans > 0 && f.depth < 60) {
        const size_t first = rows.count;
        assert_int_equal(sweep_rows_add(&rows, f.spans), STATUS_OK);
        for (size_t k = 0; k < f.spans; k++) {
            sweep_rows_x(&rows, first + k)[0] = sweep_refine_middle(&f, k);
            set_row(&rows, first + k, curve);
        }
        sweep_rows_sort(&rows);
        assert_int_equal(sweep_refine_next(&f, &rows), STATUS_OK);
    }
    assert_int_equal(f.spans, 0);
    sweep_refine_free(&f);
    sweep_refine_free(&f);
    return rows;
}

/* The largest distance of a curve from its chords, and from its ends to the
 * last points that have it. */
static double worst(const struct sweep_rows *rows, const struct curve *c)
{
    double most = 0.0, first = NAN, last = NAN;

    for (size_t i = 0; i < rows->count; i++) {
        const double x = sweep_rows_x(rows, i)[0];
        if (!(x >= c->lo && x <= c->hi))
            continue;
        first = isnan(first) ? x : first;
        for (int k = 1; k < 16 && !isnan(last); k++) {
            const double t = k / 16.0, at = last + t * (x - last);
            const double chord = (1.0 - t) * c->value(last) + t * c->value(x);
            most = fmax(most, fabs(chord - c->value(at)));
        }
        last = x;
    }
    most = fmax(most, fabs(c->value(first) - c->value(fmax(c->lo, 0.0))));
    return fmax(most, fabs(c->value(last) - c->value(fmin(c->hi, 1.0))));
}

static void curves_are_known_to_the_tolerance(void **state)
{
    static const struct curve pair[][REFINE_CURVES] = {
        { { parabola, 0, 1 }, { kink, 0, 1 } },
        { { root, -1, 0.7 }, { rising, 0.21, 2 } },
        { { rising, 0.21, 0.7 }, { root, 0.4, 0.7 } },
        { { line, 0.123, 0.456 }, { line, -1, 0 } },
    };

    (void) state;
    for (size_t i = 0; i < sizeof pair / sizeof *pair; i++)
        for (double tol = 0.1; tol > 1e-5; tol *= 0.1) {
            struct sweep_rows rows = refined(pair[i], 6, tol);
            for (size_t k = 0; k < REFINE_CURVES; k++)
                CHECK(worst(&rows, &pair[i][k]) <= tol,
                      "pair %zu, curve %zu, tol %g: %g", i, k, tol,
                      worst(&rows, &pair[i][k]));
            CHECK((double) rows.count < 8.0 / sqrt(tol) + 200, "%zu points",
                  rows.count);
            sweep_rows_free(&rows);
        }
}

static void ends_are_found_to_a_part_of_the_axis(void **state)
{
    static const struct curve flat[] = { { constant, 0.123, 0.456 },
                                         { line, 2, 3 } };
    struct sweep_rows rows = refined(flat, 6, 1e-3);
    size_t near = 0;

    (void) state;
    for (size_t i = 0; i < rows.count; i++) {
        const double x = sweep_rows_x(&rows, i)[0];
        near += fabs(x - 0.123) <= 1e-3 || fabs(x - 0.456) <= 1e-3;
    }
    CHECK(near >= 4, "%zu points at the ends", near);
    sweep_rows_free(&rows);
}

static void where_nothing_is_or_bends_few_points_are_added(void **state)
{
    static const struct curve none[] = { { line, 2, 3 }, { line, 2, 3 } };
    static const struct curve straight[] = { { line, 0, 1 }, { line, 0, 1 } };
    struct sweep_rows rows = refined(none, 6, 1e-4);

    (void) state;
    assert_int_equal(rows.count, 6);
    sweep_rows_free(&rows);
    rows = refined(straight, 6, 1e-4);
    assert_int_equal(rows.count, 11);
    sweep_rows_free(&rows);
}

static void a_log_axis_is_halved_on_its_scale(void **state)
{
    static const struct curve c[] = { { line, 0, 1e9 }, { line, 0, 1e9 } };
    struct sweep_rows rows = sweep_rows_of(REFINE_CURVES, false);
    struct sweep_refine f = { .curve = { 0, -1 }, .tol = 1, .is_log = true };

    (void) state;
    assert_int_equal(sweep_rows_add(&rows, 2), STATUS_OK);
    sweep_rows_x(&rows, 0)[0] = 4.0;
    sweep_rows_x(&rows, 1)[0] = 1e4;
    set_row(&rows, 0, c);
    set_row(&rows, 1, c);
    fault_alloc_at(0);
    assert_int_equal(sweep_refine_init(&f, &rows), STATUS_NO_MEMORY);
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_int_equal(sweep_refine_init(&f, &rows), STATUS_OK);
    assert_int_equal(f.spans, 1);
    assert_true(sweep_refine_middle(&f, 0) == 200.0);
    fault_alloc_at(0);
    assert_int_equal(sweep_refine_next(&f, &rows), STATUS_NO_MEMORY);
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_int_equal(f.spans, 1);
    assert_int_equal(f.depth, 0);
    sweep_refine_free(&f);
    sweep_rows_free(&rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_are_known_to_the_tolerance),
        cmocka_unit_test(ends_are_found_to_a_part_of_the_axis),
        cmocka_unit_test(where_nothing_is_or_bends_few_points_are_added),
        cmocka_unit_test(a_log_axis_is_halved_on_its_scale),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
