/* Fold curves and their cusp against the table, and against the sign of the
 * slope of the printed friction in 113 bits. */
#include "fold_curve.h"

#include <float.h>
#include <math.h>

#include "check.h"
#include "cusp.h"
#include "fault_alloc.h"
#include "laws.h"
#include "plain.h"
#include "reference_rows.h"

static struct fold_curve curve_of(const struct law *law,
                                  const struct material *m, double lo,
                                  double hi)
{
    struct fold_curve f;
    const double c[2] = { lo, hi };

    assert_int_equal(fold_curve_find(law, m, c, &f), STATUS_OK);
    return f;
}

/* ---- against the table --------------------------------------------------- */

/* Rounding the row's inputs to doubles costs b/(b - a) half ulps, and more
 * towards the cusp. */
static void check_near(const struct csv *c, const char *name,
                       const struct quantity *q, double part)
{
    const double want = csv_number(c, name, NAN);
    const double off = fabs(q->value - want);
    const double rise = csv_number(c, "b", 0) / csv_number(c, "a", 0) - 1.0;
    const double input = 0x1p-52 * fabs(want) * 4.0 / rise * (part / 1e-12);

    CHECK(quantity_exists(q) == (bool) isfinite(want), "row %zu: %s", c->row,
          name);
    if (!quantity_exists(q))
        return;
    CHECK(off <= part * fabs(want), "row %zu: %s = %.17g, not %.17g", c->row,
          name, q->value, want);
    CHECK(off <= q->error + input, "row %zu: %s = %.17g +- %.2g is off by %.2g",
          c->row, name, q->value, q->error, off);
}

static void check_row(const struct csv *c, const char *preset)
{
    const struct material m = row_material(c);
    const double at = csv_number(c, "c", 0), top = csv_number(c, "c_star", 1);
    const double part = 1e-12 / fmax(1.0 - at / top, 0.1);
    struct law law = *law_preset_find(preset);

    law.form =
        strcmp(csv_text(c, "form"), "log") == 0 ? FRICTION_LOG : FRICTION_ASINH;
    struct fold_curve f = curve_of(&law, &m, at, 2 * fmax(at, top));
    check_near(c, "c_star", &f.cusp.c, 1e-12);
    check_near(c, "v_cusp", &f.cusp.v, 1e-12);
    check_near(c, "psi_cusp", &f.cusp.psi, 1e-12);
    check_near(c, "mu_cusp", &f.cusp.mu, 1e-12);
    check_near(c, "alpha_cusp", &f.cusp.alpha, 1e-12);
    if (at < top) {
        const struct fold_point *p = &f.at[0];
        assert_true(f.count > 100 && p->c == at && f.reason == NULL);
        check_near(c, "v_M", &p->v_M, part);
        check_near(c, "v_m", &p->v_m, part);
        check_near(c, "mu_M", &p->mu_M, part);
        check_near(c, "mu_m", &p->mu_m, part);
        check_near(c, "alpha_cM", &p->alpha_cM, part);
        check_near(c, "alpha_cm", &p->alpha_cm, part);
    } else {
        assert_int_equal(f.count, 0);
        assert_non_null(strstr(f.reason, "beyond the cusp"));
    }
    fold_curve_free(&f);
}

static void every_row_of_the_table_is_on_the_curves(void **state)
{
    struct csv c;
    size_t rows = 0;

    (void) state;
    for (csv_open(&c, "folds.csv"); csv_next(&c);) {
        if (!(csv_number(&c, "c", 0) > 0))
            continue; /* no c = 0 on a log scale */
        check_row(&c, "spinodal");
        check_row(&c, "spinodal_gen");
        rows++;
    }
    CHECK(rows > 15, "%zu rows", rows);
}

/* ---- against 113 bits ---------------------------------------------------- */

/* d mu_ss/d ln v at v (1 + by), of the sign of this. */
static quad slope_at(const struct law *law, const struct material *m, double v,
                     double by)
{
    const quad x = logq((quad) v) + log1pq((quad) by), h = (quad) 1e-9;
    return plain_mu_ss(law, m, x + h) - plain_mu_ss(law, m, x - h);
}

/* The slope changes its sign within the bar, downward at a maximum. */
static void check_fold(size_t i, const struct law *law,
                       const struct material *m, const struct quantity *v,
                       int sign)
{
    if (!quantity_exists(v) || laws_emulated())
        return;
    const double bar = v->error / v->value;
    const quad before = slope_at(law, m, v->value, -bar);
    const quad after = slope_at(law, m, v->value, bar);

    CHECK(before * sign > 0 && after * sign < 0,
          "law %zu c = %g: v = %.17g +- %.1g: slopes %g, %g", i, m->c, v->value,
          v->error, (double) before, (double) after);
}

/* A law and a material with fold curves from c = 1e-5 on. */
static bool draw(size_t i, uint64_t *seed, struct law *law, struct material *m)
{
    if (!laws_draw(i, seed, law, m) || !law_uses(law, MATERIAL_C))
        return false;
    m->mu_star = check_uniform(seed, 0.3, 0.9); /* asinh keeps its digits */
    m->R = laws_power(seed, -1, 5);
    m->b = m->a * (1 + laws_power(seed, -1, 0.5));
    return true;
}

static void folds_are_where_friction_turns_whatever_the_law(void **state)
{
    uint64_t seed = check_seed();
    struct law law;
    struct material m;
    size_t points = 0;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        if (!draw(i, &seed, &law, &m))
            continue;
        struct fold_curve f = curve_of(&law, &m, 1e-5, 1e3);
        for (size_t k = 0; k < f.count; k += 20) {
            m.c = f.at[k].c;
            check_fold(i, &law, &m, &f.at[k].v_M, 1);
            check_fold(i, &law, &m, &f.at[k].v_m, -1);
            points += quantity_exists(&f.at[k].v_M) ? 1 : 0;
            points += quantity_exists(&f.at[k].v_m) ? 1 : 0;
        }
        fold_curve_free(&f);
    }
    CHECK(points > 1000, "%zu", points);
}

/* A little below it two extrema, as near as a square root makes them; a little
 * above none. */
static void both_folds_meet_at_the_cusp_whatever_the_law(void **state)
{
    uint64_t seed = check_seed();
    struct extremum e[EXTREMA_MAX];
    struct law law;
    struct material m;
    size_t cusps = 0;

    (void) state;
    for (size_t i = 0; i < LAWS * 4; i++) {
        if (!draw(i % LAWS, &seed, &law, &m))
            continue;
        const struct cusp at = cusp_find(&law, &m);
        if (at.reason)
            continue;
        m.c = (double) at.c * (1 + 1e-12);
        CHECK(extremum_find(&law, &m, e) == 0, "law %zu above", i % LAWS);
        m.c = (double) at.c * (1 - 1e-12);
        CHECK(extremum_find(&law, &m, e) == 2, "law %zu below", i % LAWS);
        CHECK(fabsl(e[0].x - at.x) < 1e-5L && fabsl(e[1].x - at.x) < 1e-5L &&
                  e[0].x < at.x && at.x < e[1].x,
              "law %zu: %Lg and %Lg around %Lg", i % LAWS, e[0].x, e[1].x,
              at.x);
        cusps++;
    }
    CHECK(cusps > 100, "%zu", cusps);
}

/* ---- shape --------------------------------------------------------------- */

static void the_curves_close_on_the_cusp(void **state)
{
    const struct law *law = law_preset_find("spinodal_gen");
    const struct material m = material_bristol_board();
    struct fold_curve f = curve_of(law, &m, 1e-14, 10.0);
    const struct fold_point *last = &f.at[f.count - 1];
    double gap = HUGE_VAL, step = 0.0;

    (void) state;
    CHECK(fabs(f.cusp.c.value - 2.8999) < 5e-5, "%g", f.cusp.c.value);
    for (size_t i = 0; i < f.count; i++) {
        const struct fold_point *p = &f.at[i];
        const double now = p->alpha_cM.value - p->alpha_cm.value;
        CHECK(now > 0 && now < gap, "c = %g: %g after %g", p->c, now, gap);
        if (i > 0)
            step = fmax(step, gap - now);
        gap = now;
    }
    CHECK(step < 0.004, "a step of %g rad", step);
    CHECK(gap < 1e-5 && last->v_m.value / last->v_M.value < 1.1,
          "%g rad, from v = %g to %g", gap, last->v_M.value, last->v_m.value);
    fold_curve_free(&f);
}

/* Dieterich's with c: one fold, at v = (b/a - 1)/c, however large c. */
static void one_extremum_makes_one_curve_and_no_cusp(void **state)
{
    struct law law = *law_preset_find("dieterich_gen");
    const struct material m = material_bristol_board();

    (void) state;
    law.theta = THETA_LN_C_PSI;
    struct fold_curve f = curve_of(&law, &m, 1e-3, 1e3);
    assert_true(f.count > 100 && f.reason == NULL);
    assert_non_null(strstr(f.cusp.c.reason, "one extremum"));
    for (size_t i = 0; i < f.count; i++) {
        const struct fold_point *p = &f.at[i];
        const double v = (m.b / m.a - 1) / p->c;
        CHECK(!quantity_exists(&p->v_M) && fabs(p->v_m.value / v - 1) < 1e-14,
              "c = %g: %.17g, not %.17g", p->c, p->v_m.value, v);
    }
    CHECK(f.at[0].c == 1e-3 && fabs(f.at[f.count - 1].c - 1e3) < 1e-9,
          "%g to %g", f.at[0].c, f.at[f.count - 1].c);
    fold_curve_free(&f);
}

static void a_law_without_folds_says_why(void **state)
{
    struct material m = material_bristol_board();
    struct fold_curve f = curve_of(law_preset_find("ruina"), &m, 1e-9, 1.0);

    (void) state;
    assert_true(f.count == 0 && !quantity_exists(&f.cusp.alpha));
    assert_string_equal(f.reason, "the law does not use c");
    fold_curve_free(&f);
    m.b = m.a / 2;
    f = curve_of(law_preset_find("spinodal"), &m, 1e-9, 1.0);
    assert_non_null(strstr(f.reason, "no extremum at any"));
    assert_non_null(strstr(f.cusp.c.reason, "b > a"));
    fold_curve_free(&f);
}

static void an_allocation_that_fails_leaves_nothing(void **state)
{
    const struct law *law = law_preset_find("spinodal_gen");
    const struct material m = material_bristol_board();
    const double c[2] = { 1e-6, 10.0 };
    struct fold_curve f;

    (void) state;
    fault_alloc_at(0);
    assert_int_equal(fold_curve_find(law, &m, c, &f), STATUS_NO_MEMORY);
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_true(f.at == NULL && f.count == 0);
    fold_curve_free(&f);
    fold_curve_free(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_of_the_table_is_on_the_curves),
        cmocka_unit_test(folds_are_where_friction_turns_whatever_the_law),
        cmocka_unit_test(both_folds_meet_at_the_cusp_whatever_the_law),
        cmocka_unit_test(the_curves_close_on_the_cusp),
        cmocka_unit_test(one_extremum_makes_one_curve_and_no_cusp),
        cmocka_unit_test(a_law_without_folds_says_why),
        cmocka_unit_test(an_allocation_that_fails_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
