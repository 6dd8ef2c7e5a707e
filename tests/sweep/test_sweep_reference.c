/* The exact curves of Figs 9, 11(b) and 12, at the slopes of the reference
 * table. */
#include "sweep.h"

#include <math.h>

#include "csv.h"
#include "sweeps.h"

static const struct sweep_options plainly = { .journal = NULL };

/* Relative uncertainty of a decimal with these digits. */
static double printed(const char *text)
{
    int digits = 0;

    for (; *text && *text != 'e'; text++)
        digits += *text >= '0' && *text <= '9' && (digits > 0 || *text != '0');
    return pow(10.0, 1.0 - digits);
}

/* A point against a row of the table: within its bar, the last digit printed
 * and what rounding of the slope to a double costs. */
static void check_reference(const struct sweep *s, size_t i,
                            const struct csv *c, const char *name,
                            const char *column, const char *lost)
{
    const double want = csv_number(c, column, NAN);
    const struct quantity q = sweep_quantity(s, sweep_find(s, name), i);
    const double input =
        (pow(10.0, fmax(csv_number(c, lost, 0.0), 0.0) - 14.0) +
         printed(csv_text(c, column))) *
        fabs(want);

    if (isnan(want) && strcmp(column, "mu_s_mean") == 0)
        return; /* blank where its digits ran out */
    CHECK(quantity_exists(&q) == !isnan(want), "row %zu: %s", c->row, name);
    if (quantity_exists(&q))
        CHECK(fabs(q.value - want) <= q.error + input,
              "row %zu: %s = %.17g +- %.1g, not %.17g", c->row, name, q.value,
              q.error, want);
}

static size_t point_of(const struct sweep *s, const struct csv *c)
{
    size_t i = 0;

    while (i < s->points && s->axis[0].value[i] != csv_number(c, "alpha", NAN))
        i++;
    return i;
}

static void exact_curves_of_the_figures_hold_to_the_table(void **state)
{
    static const char *const up = "digits_lost_alpha_vplus";
    static const char *const sets[] = {
        "law.preset=dieterich_gen", "products=[knees]",
        "sweep={key: slope.alpha, values: [0.05, 0.1, 0.28, 0.295, 0.3, 0.34, "
        "0.38, 0.3845, 0.4], show: static_friction}",
        NULL
    };
    struct swept w;
    struct csv c;
    size_t rows = 0;

    (void) state;
    sweep_of(&w, sets, &plainly);
    csv_open(&c, "manifold.csv");
    while (csv_next(&c)) {
        const size_t i = point_of(&w.s, &c);
        if (strcmp(csv_text(&c, "law"), "dieterich_gen") != 0 ||
            strcmp(csv_text(&c, "form"), "asinh") != 0 ||
            strcmp(csv_text(&c, "tag"), "default") != 0)
            continue;
        assert_true(i < w.s.points);
        check_reference(&w.s, i, &c, "v_plus", "v_plus", up);
        check_reference(&w.s, i, &c, "v_minus", "v_minus",
                        "digits_lost_alpha_lower");
        check_reference(&w.s, i, &c, "x_excess", "x_excess", up);
        check_reference(&w.s, i, &c, "mu_s_num", "mu_s_num", up);
        check_reference(&w.s, i, &c, "mu_s_mean", "mu_s_mean", up);
        check_reference(&w.s, i, &c, "fracture_energy", "G_num", up);
        rows++;
    }
    assert_int_equal(rows, w.s.points);
    swept_free(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_curves_of_the_figures_hold_to_the_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
