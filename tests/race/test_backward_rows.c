/* The second route against the reference tables: every end right, every number
 * inside a bar that is of use. */
#include <math.h>

#include "backward.h"
#include "check.h"
#include "records.h"
#include "reference_rows.h"

/* Relative uncertainty of a decimal that was printed with few digits. */
static double printed(const char *text)
{
    int digits = 0;

    for (; *text && *text != 'e'; text++)
        digits += *text >= '0' && *text <= '9' && (digits > 0 || *text != '0');
    return pow(10.0, 1.0 - digits);
}

/* The row's inputs are decimals, ours their nearest doubles: their rounding
 * costs some times what that of alpha alone does, `lost` digits. */
static void check_number(const struct csv *c, const char *column,
                         const char *lost, const struct quantity *q)
{
    const double want = csv_number(c, column, NAN);
    const double d = fmax(csv_number(c, lost, 0.0), 0.0);

    CHECK(isnan(want) == !quantity_exists(q), "row %zu: %s = %.17g", c->row,
          column, q->value);
    if (isnan(want))
        return;
    const double size = fabs(want), off = fabs(q->value - want);
    const double input =
        (3.0 * pow(10.0, d - 15.0) + printed(csv_text(c, column))) * size;
    CHECK(off <= q->error + input, "row %zu: %s = %.17g +- %.2g, not %.17g",
          c->row, column, q->value, q->error, want);
    CHECK(q->error <= 1e-8 * size + 100.0 * input,
          "row %zu: %s = %.17g with a bar of %.2g", c->row, column, q->value,
          q->error);
}

static struct critical_numbers numbers_of(const struct solved *s, double rtol)
{
    struct backward_options o = backward_defaults(rtol);
    struct branch b[2];

    o.carry = (struct carry){ { BLOCK_EXCESS }, 1 };
    for (int i = 0; i < 2; i++)
        assert_int_equal(
            backward_branch(&s->system, &s->saddle, i == 0 ? 1 : -1, &o, &b[i]),
            STATUS_OK);
    const struct critical_numbers n =
        numbers_critical(&s->block, &s->saddle, &b[0], &b[1]);
    for (int i = 0; i < 2; i++)
        branch_free(&b[i]);
    return n;
}

/* Where the first route may give up (verify.h). */
static bool is_deep(const struct critical_numbers *n)
{
    return quantity_exists(&n->psi_at_v0) && n->psi_at_v0.value < -1e9;
}

static void check_row(const struct csv *c, const struct critical_numbers *n)
{
    const char *lower = csv_text(c, "lower_end");

    CHECK(strcmp(end_names[n->upper_end], csv_text(c, "upper_end")) == 0,
          "row %zu: upper_end %s", c->row, end_names[n->upper_end]);
    check_number(c, "v_plus", "digits_lost_alpha_vplus", &n->v_plus);
    check_number(c, "x_excess", "digits_lost_alpha_vplus", &n->x_excess);
    if (strcmp(lower, "psi_minus_inf_truncated") == 0)
        return; /* no statement: reference/README.md */
    CHECK(strcmp(end_names[n->lower_end], lower) == 0,
          "row %zu: lower_end %s, not %s", c->row, end_names[n->lower_end],
          lower);
    check_number(c, "v_minus", "digits_lost_alpha_lower", &n->v_minus);
    check_number(c, "psi_at_v0", "digits_lost_alpha_lower", &n->psi_at_v0);
    if (csv_text(c, "x_deficit_lower")[0])
        check_number(c, "x_deficit_lower", "digits_lost_alpha_lower",
                     &n->x_deficit);
}

static size_t check_table(const char *name, double rtol)
{
    struct csv c;
    size_t saddles = 0;

    csv_open(&c, name);
    while (csv_next(&c)) {
        struct solved s;
        assert_int_equal(solve_row(&s, &c, 1e-6), STATUS_OK);
        if (s.has_saddle) {
            const struct critical_numbers n = numbers_of(&s, rtol);
            check_row(&c, &n);
            saddles++;
        }
        solved_free(&s);
    }
    return saddles;
}

static void every_row_is_inside_its_useful_bars(void **state)
{
    (void) state;
    assert_true(check_table("manifold.csv", 1e-12) > 100);
    assert_true(check_table("extreme.csv", 1e-12) > 60);
}

static void coarser_runs_are_still_right_about_the_ends(void **state)
{
    (void) state;
    for (int k = 6; k <= 10; k += 2) {
        struct csv c;
        csv_open(&c, "manifold.csv");
        while (csv_next(&c)) {
            struct solved s;
            assert_int_equal(solve_row(&s, &c, 1e-10), STATUS_OK);
            if (s.has_saddle) {
                const struct critical_numbers n = numbers_of(&s, pow(10, -k));
                const struct quantity *a = &n.v_plus, *b = &s.numbers.v_plus;
                assert_int_equal(n.upper_end, s.numbers.upper_end);
                assert_true(n.lower_end == s.numbers.lower_end ||
                            is_deep(&s.numbers));
                CHECK(!quantity_exists(a) ||
                          fabs(a->value - b->value) <= a->error + b->error,
                      "row %zu, 1e-%d: %.12g +- %.2g, not %.12g", c.row, k,
                      a->value, a->error, b->value);
            }
            solved_free(&s);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_is_inside_its_useful_bars),
        cmocka_unit_test(coarser_runs_are_still_right_about_the_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
