/* One rectangle of cells as polynomials. */
#include "patch.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "fate.h"

enum { COLUMNS = 40, ROWS = 30 };

static const unsigned slip = 1u << CELL_SLIP;

/* exp(x + 2 y + amount f(x)) and so on, over the unit square. */
struct field {
    double bump;  /* exp(-((x - 0.3)/0.05)^2) */
    double line;  /* 0: no base points; else y = x - line */
    double noise; /* relative */
};

static double slip_of(const struct field *f, struct vec2 z)
{
    const double far = (z.x - 0.3) / 0.05;

    return exp(z.x + 2.0 * z.y + f->bump * exp(-far * far));
}

static struct patch_sample sample_of(const struct field *f, struct vec2 z)
{
    const double no = (double) NAN, value = slip_of(f, z), y = z.x - f->line;
    struct patch_sample s = {
        .z = z,
        .cell = { .exit_reason = FATE_CREEP,
                  .slip = value,
                  .slip_error = f->noise * value },
        .base = { no, no, no, no, 1.0 },
    };

    if (f->line == 0.0)
        return s;
    s.base = (struct base_point){ y, 1e-12, z.y, 1e-12, 1.0 };
    s.cell.slip = 3.0 - log(fabs(y)) + z.y;
    s.cell.exit_reason = y > 0.0 ? FATE_SLIDING : FATE_CREEP;
    return s;
}

static bool tell(const void *ctx, struct vec2 z, const struct base_point *b,
                 unsigned which, struct cell *out)
{
    (void) ctx, (void) z, (void) which;
    *out =
        (struct cell){ .exit_reason = b->y > 0.0 ? FATE_SLIDING : FATE_CREEP,
                       .slip = 3.0 - log(fabs(b->y)) + b->more,
                       .slip_error = b->y_error / fabs(b->y) + b->more_error };
    return 10.0 * b->y_error < fabs(b->y);
}

static bool passes(const void *ctx, double one, double other)
{
    (void) ctx, (void) one, (void) other;
    return false;
}

static const struct patch_teller teller = { tell, NULL, passes, NULL };

struct room {
    double x[COLUMNS], y[ROWS];
    struct patch_side across, up;
    struct patch_sample sample[PATCH_STATES];
    size_t count;
};

static void make(struct room *r, const struct field *f, size_t columns)
{
    struct vec2 z[PATCH_NODES];

    for (size_t i = 0; i < COLUMNS; i++)
        r->x[i] = ((double) i + 0.5) / COLUMNS;
    for (size_t j = 0; j < ROWS; j++)
        r->y[j] = ((double) j + 0.5) / ROWS;
    r->across = patch_side_of(r->x, columns);
    r->up = patch_side_of(r->y, ROWS);
    r->count = patch_nodes(&r->across, &r->up, z);
    for (size_t i = 0; i < r->count; i++)
        r->sample[i] = sample_of(f, z[i]);
    for (size_t i = 0; i < 12; i++)
        r->sample[r->count++] = sample_of(
            f, (struct vec2){ r->x[i * 7 % columns], r->y[i * 11 % ROWS] });
}

static struct patch_verdict fit(struct room *r, double rtol, struct patch *p)
{
    return patch_fit(p, &r->across, &r->up, slip, rtol, &teller, r->sample,
                     r->count);
}

static void a_smooth_field_is_one_polynomial(void **state)
{
    const struct field f = { 0.0, 0.0, 1e-9 };
    int8_t label[COLUMNS] = { FATE_CREEP };
    struct cell out[COLUMNS];
    static struct room r;
    struct patch p;

    (void) state;
    make(&r, &f, COLUMNS);
    assert_true(fit(&r, 1e-6, &p).holds);
    assert_int_equal(p.plain, slip);
    assert_true(p.bar[CELL_SLIP] > 1e-9);
    label[3] = FATE_RUNAWAY;
    for (size_t j = 0; j < ROWS; j++) {
        patch_rows(&p, j, 1, COLUMNS, label, 1e-6, &teller, out);
        for (size_t i = 0; i < COLUMNS; i++) {
            const double t = slip_of(&f, (struct vec2){ r.x[i], r.y[j] });
            CHECK(fabs(out[i].slip - t) <= out[i].slip_error &&
                      out[i].slip_error <= 1e-6 * t && isnan(out[i].time),
                  "(%zu, %zu): %g", i, j, out[i].slip - t);
            assert_int_equal(out[i].exit_reason, i == 3 ? FATE_NONE : 0);
        }
    }
    assert_false(fit(&r, 1e-9, &p).holds); /* the samples' own bars */
}

static void the_side_to_blame_is_told(void **state)
{
    const struct field f = { 0.5, 0.0, 0.0 };
    static struct room r;
    struct patch p;

    (void) state;
    make(&r, &f, COLUMNS);
    const struct patch_verdict v = fit(&r, 1e-5, &p);
    assert_true(!v.holds && v.is_smooth);
    CHECK(v.excess_x > 1.0 && v.excess_y < 1e-3 * v.excess_x, "%g, %g",
          v.excess_x, v.excess_y);
    make(&r, &f, 5); /* each column by itself */
    assert_true(r.across.is_exact && fit(&r, 1e-5, &p).holds);
}

/* sum 10^-k T_k(x) over the unit square's columns, without T_8. */
static double series(const struct room *r, double x)
{
    const double lo = r->x[0], hi = r->x[COLUMNS - 1];
    const double t = acos((2.0 * x - lo - hi) / (hi - lo));
    double sum = 0.0;

    for (int k = 0; k < 14; k++)
        sum += k == 8 ? 0.0 : pow(10.0, -k) * cos(k * t);
    return sum;
}

static void number_of(const struct room *r, double error,
                      struct patch_numbers *n)
{
    *n = (struct patch_numbers){ .count = PATCH_NODES, .nodes = PATCH_NODES };
    patch_nodes(&r->across, &r->up, n->z);
    for (size_t i = 0; i < n->nodes; i++) {
        n->value[i] = series(r, n->z[i].x);
        n->error[i] = error;
    }
}

static void a_coefficient_that_vanishes_leaves_the_bar(void **state)
{
    const struct field f = { 0.0, 0.0, 0.0 };
    static struct patch_numbers n;
    static struct room r;
    struct patch_poly p;
    double bar;

    (void) state;
    make(&r, &f, COLUMNS);
    number_of(&r, 0.0, &n);
    patch_poly_fit(&p, &r.across, &r.up, &n);
    const struct patch_point level = patch_side_point(&r.up, r.y[4]);
    const struct patch_line l = patch_poly_line(&p, &r.across, &r.up, &level);
    for (int i = 0; i < COLUMNS; i++) {
        const struct patch_point at = patch_side_point(&r.across, r.x[i]);
        const double above = patch_poly_above(&p, &r.across, &at);
        const double off = fabs(patch_line_at(&l, &r.across, &at, above, &bar) -
                                series(&r, r.x[i]));
        CHECK(off <= bar && bar <= p.bar, "%d: off %g, bar %g", i, off, bar);
    }
}

static void what_a_test_cannot_tell_is_in_the_bar(void **state)
{
    const struct field f = { 0.0, 0.0, 0.0 };
    static struct patch_numbers n;
    static struct room r;
    struct patch_poly p;

    (void) state;
    make(&r, &f, COLUMNS);
    number_of(&r, 1e-6, &n);
    n.z[n.count] = (struct vec2){ r.x[9], r.y[9] };
    n.value[n.count] = series(&r, r.x[9]) + 5e-6;
    n.error[n.count++] = 1e-5;
    patch_poly_fit(&p, &r.across, &r.up, &n);
    CHECK(p.bar > 1.5e-5, "%g", p.bar);
}

/* What nodes alone would not see. */
static void a_test_that_misses_widens_the_bar(void **state)
{
    const struct field f = { 0.0, 0.0, 0.0 };
    static struct room r;
    struct patch p;

    (void) state;
    make(&r, &f, COLUMNS);
    assert_true(fit(&r, 1e-5, &p).holds);
    const double bar = p.bar[CELL_SLIP];
    r.sample[r.count - 1].cell.slip *= 1.0 + 1e-6;
    assert_true(fit(&r, 1e-4, &p).holds);
    CHECK(p.bar[CELL_SLIP] > 2e-6 && p.bar[CELL_SLIP] > 10.0 * bar, "%g, %g",
          p.bar[CELL_SLIP], bar);
    r.sample[r.count - 1].cell.slip = (double) NAN;
    assert_false(fit(&r, 1e-4, &p).holds);
}

static void base_points_tell_both_sides_of_a_separatrix(void **state)
{
    const struct field f = { 0.0, 0.4321, 0.0 };
    int8_t label[COLUMNS];
    struct cell out[COLUMNS];
    static struct room r;
    struct patch p;
    int told = 0;

    (void) state;
    make(&r, &f, COLUMNS);
    assert_true(fit(&r, 1e-6, &p).holds);
    assert_true(p.has_base && p.plain == 0 && p.exit_reason == FATE_UNDECIDED);
    for (size_t i = 0; i < COLUMNS; i++)
        label[i] = r.x[i] > f.line ? FATE_SLIDING : FATE_CREEP;
    patch_rows(&p, 7, 1, COLUMNS, label, 1e-6, &teller, out);
    for (size_t i = 0; i < COLUMNS; i++) {
        const struct vec2 z = { r.x[i], r.y[7] };
        const struct patch_sample t = sample_of(&f, z);
        if (out[i].exit_reason == FATE_NONE)
            continue;
        assert_int_equal(out[i].exit_reason, label[i]);
        CHECK(fabs(out[i].slip - t.cell.slip) <= out[i].slip_error, "%zu", i);
        told++;
    }
    CHECK(told > COLUMNS - 3, "%d", told);
}

static void kinds_that_differ_say_where_to_cut(void **state)
{
    const struct field f = { 0.0, 0.0, 0.0 };
    static struct room r;
    struct patch p;

    (void) state;
    make(&r, &f, COLUMNS);
    for (size_t i = 0; i < r.count; i++)
        if (r.sample[i].z.y > 0.55)
            r.sample[i].cell.exit_reason = FATE_SLIDING;
    const struct patch_verdict v = fit(&r, 1e-6, &p);
    assert_true(!v.holds && !v.is_smooth);
    assert_true(v.excess_x == 0.0 && v.excess_y == 1.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_smooth_field_is_one_polynomial),
        cmocka_unit_test(the_side_to_blame_is_told),
        cmocka_unit_test(a_coefficient_that_vanishes_leaves_the_bar),
        cmocka_unit_test(what_a_test_cannot_tell_is_in_the_bar),
        cmocka_unit_test(a_test_that_misses_widens_the_bar),
        cmocka_unit_test(base_points_tell_both_sides_of_a_separatrix),
        cmocka_unit_test(kinds_that_differ_say_where_to_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
