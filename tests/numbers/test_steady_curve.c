/* Curves of steady states against tables, the printed law in 113 bits, and the
 * solver of equilibria. */
#include "steady_curve.h"

#include <float.h>
#include <math.h>

#include "check.h"
#include "fault_alloc.h"
#include "laws.h"
#include "plain.h"
#include "reference_rows.h"
#include "steady.h"

static struct steady_curve curve_of(const struct law *law,
                                    const struct material *m, double lo,
                                    double hi)
{
    struct steady_curve c;
    const double v[2] = { lo, hi };

    assert_int_equal(steady_curve_find(law, m, v, &c), STATUS_OK);
    return c;
}

/* ---- against tables ------------------------------------------------------ */

static void check_near(const struct csv *c, const char *name,
                       const struct quantity *q, double part)
{
    const double want = csv_number(c, name, NAN);

    CHECK(quantity_exists(q) == (bool) isfinite(want), "row %zu: %s", c->row,
          name);
    if (quantity_exists(q))
        CHECK(fabs(q->value - want) <= part * fabs(want),
              "row %zu: %s = %.17g, not %.17g", c->row, name, q->value, want);
}

/* Near the cusp rounding of the row's inputs to doubles costs more. */
static void check_folds(const struct csv *c, const struct law *law)
{
    const struct material m = row_material(c);
    const double share = csv_number(c, "c", 0) / csv_number(c, "c_star", 1);
    const double part = 1e-12 / fmax(1.0 - share, 0.1);
    struct steady_curve s = curve_of(law, &m, 1e-12, 1e12);
    const struct quantity none = quantity_none("no such extremum");
    const struct extremum absent = { 0, none, none, none, none, 0 };
    const struct extremum *top = s.extrema > 0 ? &s.extremum[0] : &absent;
    const struct extremum *low = s.extrema > 1 ? &s.extremum[1] : &absent;

    check_near(c, "v_M", &top->v, part);
    check_near(c, "psi_M", &top->psi, part);
    check_near(c, "mu_M", &top->mu, 1e-14);
    check_near(c, "alpha_cM", &top->alpha, 1e-14);
    check_near(c, "v_m", &low->v, part);
    check_near(c, "psi_m", &low->psi, part);
    check_near(c, "mu_m", &low->mu, 1e-14);
    check_near(c, "alpha_cm", &low->alpha, 1e-14);
    for (size_t i = 0; i < s.extrema; i++)
        CHECK(s.extremum[i].kind == (i ? EXTREMUM_MINIMUM : EXTREMUM_MAXIMUM),
              "row %zu: extremum %zu is a %s", c->row, i,
              extremum_names[s.extremum[i].kind]);
    steady_curve_free(&s);
}

static void extrema_are_those_of_the_table(void **state)
{
    struct csv c;
    size_t rows = 0;

    (void) state;
    for (csv_open(&c, "folds.csv"); csv_next(&c); rows++) {
        struct law law = *law_preset_find("spinodal_gen");
        law.form = strcmp(csv_text(&c, "form"), "log") == 0 ? FRICTION_LOG
                                                            : FRICTION_ASINH;
        check_folds(&c, &law);
    }
    assert_int_equal(rows, 26);
}

/* The first point is at the v of the row: its alpha and eigenvalues. */
static void every_equilibrium_of_the_table_is_on_the_curve(void **state)
{
    struct csv c;
    size_t rows = 0;

    (void) state;
    for (csv_open(&c, "equilibria.csv"); csv_next(&c);) {
        const double v = csv_number(&c, "v", NAN);
        const struct law law = row_law(&c);
        const struct material m = row_material(&c);
        if (!isfinite(v))
            continue;
        struct steady_curve s = curve_of(&law, &m, v, 1.01 * v);
        const struct steady_point *p = &s.at[0];
        /* the row's v is rounded: alpha moves by slope times half an ulp, and
         * eigenvalues by that over the distance to a fold */
        const double slope = fabs(p->slope.value);
        const double part = 1e-12 + 1e-15 / fmin(slope, 1.0);
        assert_true(s.count > 0);
        assert_string_equal(equilibrium_type_names[p->type],
                            csv_text(&c, "type"));
        check_near(&c, "alpha", &p->alpha, 1e-13);
        check_near(&c, "mu", &p->mu, 1e-13);
        check_near(&c, "psi", &p->psi, 1e-13 + 1e-15 / fabs(p->psi.value));
        check_near(&c, "lambda_minus", &p->lambda_minus, part);
        check_near(&c, "lambda_plus", &p->lambda_plus, part);
        steady_curve_free(&s);
        rows++;
    }
    CHECK(rows > 100, "%zu rows", rows);
}

/* ---- against 113 bits ---------------------------------------------------- */

static void check_bar(size_t law, const struct steady_point *p,
                      const struct quantity *q, const char *name, quad exact)
{
    const double off = fabs((double) ((quad) q->value - exact));
    const double unit = laws_long_epsilon() / (double) LDBL_EPSILON;

    CHECK(off <= q->error * unit,
          "law %zu v = %g: %s = %.17g +- %.2g off by "
          "%.2g",
          law, p->v, name, q->value, q->error, off);
}

static void check_point(size_t i, const struct law *law,
                        const struct material *m, const struct steady_point *p)
{
    const quad x = logq((quad) p->v), mu = plain_mu_ss(law, m, x);

    check_bar(i, p, &p->psi, "psi", plain_psi_ss(law, m, x));
    check_bar(i, p, &p->mu, "mu", mu);
    if (quantity_exists(&p->alpha))
        check_bar(i, p, &p->alpha, "alpha", (quad) atanl((long double) mu));
    CHECK(quantity_exists(&p->alpha) == (mu > 0), "law %zu v = %g: mu %g", i,
          p->v, (double) mu);
    /* the type is told by the slope of mu_ss, these by the Jacobian */
    const struct quantity *far = &p->lambda_minus, *near = &p->lambda_plus;
    if (quantity_exists(near) && fabs(near->value) > near->error)
        CHECK((near->value > 0) == (p->type == EQUILIBRIUM_SADDLE) &&
                  far->value < 0,
              "law %zu v = %g: %s with eigenvalues %g, %g", i, p->v,
              equilibrium_type_names[p->type], far->value, near->value);
}

static void points_are_right_within_their_bars(void **state)
{
    uint64_t seed = check_seed();
    struct law law;
    struct material m;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        if (!laws_draw(i, &seed, &law, &m))
            continue;
        struct steady_curve c = curve_of(&law, &m, 1e-5, 1e5);
        for (size_t k = 0; k < c.count; k += 7)
            check_point(i, &law, &m, &c.at[k]);
        steady_curve_free(&c);
    }
}

/* ---- shape --------------------------------------------------------------- */

/* Type and alpha turn at each extremum, which is a point of its own. */
static void stability_changes_at_the_folds_and_nowhere_else(void **state)
{
    const struct law *law = law_preset_find("spinodal_gen");
    const struct material m = material_bristol_board();
    struct steady_curve c = curve_of(law, &m, 1e-6, 1e6);
    size_t folds = 0;

    (void) state;
    assert_int_equal(c.extrema, 2);
    assert_true(c.at[0].v == 1e-6 && c.at[c.count - 1].v == 1e6);
    for (size_t i = 1; i < c.count; i++) {
        const int type = c.at[i].type;
        const bool rises = c.at[i].alpha.value > c.at[i - 1].alpha.value;
        assert_true(c.at[i].v > c.at[i - 1].v);
        if (type == EQUILIBRIUM_SADDLE_NODE) {
            CHECK(c.at[i].v == c.extremum[folds].v.value, "v = %g", c.at[i].v);
            CHECK(c.at[i].lambda_plus.value == 0.0, "%g",
                  c.at[i].lambda_plus.value);
            folds++;
        }
        CHECK(rises == (folds != 1 || type == EQUILIBRIUM_SADDLE_NODE) ||
                  (folds == 2 && type == EQUILIBRIUM_SADDLE_NODE),
              "v = %g: alpha %s after %zu folds", c.at[i].v,
              rises ? "rises" : "falls", folds);
        if (type != EQUILIBRIUM_SADDLE_NODE)
            CHECK((type == EQUILIBRIUM_SADDLE) == (folds == 1),
                  "v = %g: %s after %zu folds", c.at[i].v,
                  equilibrium_type_names[type], folds);
    }
    assert_int_equal(folds, 2);
    steady_curve_free(&c);
}

/* psi = -ln v > 0 only below v = 1; friction < 0 holds no slope. */
static void what_does_not_exist_is_left_out_or_says_why(void **state)
{
    struct law law = { .form = FRICTION_LOG,
                       .theta = THETA_LN_PSI,
                       .psi_ss = PSI_SS_MINUS_LOG,
                       .timescale = TIMESCALE_SLIP,
                       .kinetics = KINETICS_LINEAR };
    const struct material m = material_bristol_board();
    struct steady_curve c = curve_of(&law, &m, 2.0, 9.0);

    (void) state;
    assert_int_equal(c.count, 0);
    steady_curve_free(&c);
    c = curve_of(&law, &m, 0.5, 9.0);
    CHECK(c.count > 300 && c.at[c.count - 1].v < 1.0, "%zu points, to v = %g",
          c.count, c.at[c.count - 1].v);
    steady_curve_free(&c);
    law = *law_preset_find("dieterich");
    law.form = FRICTION_LOG;
    c = curve_of(&law, &m, 1.0, 1e20);
    const struct steady_point *p = &c.at[c.count - 1];
    CHECK(p->mu.value < 0 && !quantity_exists(&p->alpha) &&
              !quantity_exists(&p->lambda_plus) && p->type == -1,
          "mu = %g, type %d", p->mu.value, p->type);
    assert_non_null(strstr(p->alpha.reason, "not positive"));
    assert_int_equal(c.extrema, 0);
    steady_curve_free(&c);
    c = curve_of(&law, &m, 1e-300, 1e300);
    CHECK(c.count > 400 && c.at[0].v == 1e-300 && c.at[c.count - 1].v == 1e300,
          "%zu points", c.count);
    steady_curve_free(&c);
}

static void an_allocation_that_fails_leaves_nothing(void **state)
{
    const struct law *law = law_preset_find("spinodal_gen");
    const struct material m = material_bristol_board();
    const double v[2] = { 1.0, 2.0 };
    struct steady_curve c;

    (void) state;
    fault_alloc_at(0);
    assert_int_equal(steady_curve_find(law, &m, v, &c), STATUS_NO_MEMORY);
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_true(c.at == NULL && c.count == 0);
    steady_curve_free(&c);
    steady_curve_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(extrema_are_those_of_the_table),
        cmocka_unit_test(every_equilibrium_of_the_table_is_on_the_curve),
        cmocka_unit_test(points_are_right_within_their_bars),
        cmocka_unit_test(stability_changes_at_the_folds_and_nowhere_else),
        cmocka_unit_test(what_does_not_exist_is_left_out_or_says_why),
        cmocka_unit_test(an_allocation_that_fails_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
