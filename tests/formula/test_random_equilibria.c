/* Equilibria of random systems: zeros that are known, and none besides. */
#include "interval.h"
#include "typed_system.h"

/* ---- random polynomials -------------------------------------------------- */

/* Products of linear factors in turned and sheared axes: u (u - a)(u - b), and
 * w (w - c): zeros where each is known. */
static void products_of_linear_factors_have_their_zeros(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int run = 0; run < 60; run++) {
        char text[2][400], u[100], w[100];
        double r[3], t[2], m[4];
        for (int i = 0; i < 3; i++)
            r[i] = check_uniform(&seed, -1, 1) + 2.5 * (i - 1);
        for (int i = 0; i < 2; i++)
            t[i] = check_uniform(&seed, -1, 1) + 2.5 * i;
        const double angle = check_uniform(&seed, 0, 6.28);
        const double shear = check_uniform(&seed, -1, 1);
        m[0] = cos(angle);
        m[1] = sin(angle);
        m[2] = -sin(angle) + shear * m[0];
        m[3] = cos(angle) + shear * m[1];
        sprintf(u, "((%.17g)*x + (%.17g)*y)", m[0], m[1]);
        sprintf(w, "((%.17g)*x + (%.17g)*y)", m[2], m[3]);
        sprintf(text[0], "(%s - (%.17g))*(%s - (%.17g))*(%s - (%.17g))", u,
                r[0], u, r[1], u, r[2]);
        sprintf(text[1], "(%s - (%.17g))*(%s - (%.17g))", w, t[0], w, t[1]);
        const struct typed product = { { CHART_REAL, CHART_REAL },
                                       { { NULL } },
                                       { { NULL } },
                                       { text[0], text[1] } };
        type_system(&product);
        find_in(-30, 31, -29, 30);
        all_found(6, text[0]);
        const double det = m[0] * m[3] - m[1] * m[2];
        for (int i = 0; i < 6; i++)
            at_place((m[3] * r[i / 2] - m[1] * t[i % 2]) / det,
                     (m[0] * t[i % 2] - m[2] * r[i / 2]) / det, 1e-13);
    }
}

/* ---- others find no more ------------------------------------------------- */

static struct interval_plan rates;

static void plan_rates(void)
{
    static formula_real value[FORMULA_NODES];
    const int state[2] = { s.state[0].node, s.state[1].node };

    assert_int_equal(
        interval_plan(&rates, &s.graph, state, s.rate, 2, value, &why),
        STATUS_OK);
}

/* Newton's method in 113 bits from here: where it ends, if it does. */
static bool newton(formula_real at[2])
{
    for (int i = 0; i < 60; i++) {
        const struct interval_quad box[2] = { { at[0], at[0] },
                                              { at[1], at[1] } };
        struct interval_slope_quad f[2];
        if (interval_over_quad(&rates, box, f) != INTERVAL_WHOLE)
            return false;
        const formula_real a = f[0].by[0].lo, b = f[0].by[1].lo;
        const formula_real c = f[1].by[0].lo, d = f[1].by[1].lo;
        const formula_real u = f[0].value.lo, w = f[1].value.lo;
        const formula_real det = a * d - b * c;
        const double step[2] = { (double) ((d * u - b * w) / det),
                                 (double) ((a * w - c * u) / det) };
        if (!(fabs(step[0]) + fabs(step[1]) < 1e3))
            return false;
        at[0] -= step[0];
        at[1] -= step[1];
        if (fabs(step[0]) + fabs(step[1]) < 1e-25)
            return true;
    }
    return false;
}

static bool is_listed(const formula_real at[2])
{
    for (int i = 0; i < found.count; i++) {
        const struct system_equilibrium *q = &found.equilibrium[i];
        bool here = true;
        for (int k = 0; k < 2; k++)
            here = here && fabs((double) (q->state[k].value - at[k])) < 1e-12;
        if (here)
            return true;
    }
    for (int i = 0; i < found.undecided_count; i++) {
        const struct system_window *w = &found.undecided[i];
        if (w->lo[0] <= at[0] && at[0] <= w->hi[0] && w->lo[1] <= at[1] &&
            at[1] <= w->hi[1])
            return true;
    }
    return false;
}

/* A term of a random formula. */
static void add_term(char *text, uint64_t *seed)
{
    static const char *const form[] = {
        "x",
        "y",
        "x*y",
        "x^2",
        "y^3",
        "sin(2*x+y)",
        "exp(-x*y/4)",
        "tanh(3*x-y)",
        "1/(1+x^2)",
        "atan(x*y)",
        "cos(x)*sin(y)",
        "asinh(5*y)",
        "sqrt(4+x-y)",
        "ln(5+x+y)",
        "1",
        "x^2*y",
    };
    const size_t n = sizeof form / sizeof *form;

    sprintf(text + strlen(text), "%s(%.3f)*%s", *text ? "+" : "",
            check_uniform(seed, -2, 2), form[check_bits(seed) % n]);
}

static void newton_finds_none_that_is_not_listed(void **state)
{
    uint64_t seed = check_seed();
    int complete = 0, roots = 0;

    (void) state;
    for (int run = 0; run < 60; run++) {
        char text[2][300] = { "", "" };
        for (int i = 0; i < 2; i++)
            for (int k = 0; k < 4; k++)
                add_term(text[i], &seed);
        const struct typed random = { { CHART_REAL, CHART_REAL },
                                      { { NULL } },
                                      { { NULL } },
                                      { text[0], text[1] } };
        type_system(&random);
        find_in(-2, 2, -2, 2);
        complete += found.complete;
        roots += found.count;
        plan_rates();
        for (int i = 0; i < 60; i++) {
            formula_real at[2] = { check_uniform(&seed, -2, 2),
                                   check_uniform(&seed, -2, 2) };
            if (!newton(at) || fabs((double) at[0]) > 2 ||
                fabs((double) at[1]) > 2)
                continue;
            CHECK(is_listed(at), "%s, %s: (%.17g, %.17g)", text[0], text[1],
                  (double) at[0], (double) at[1]);
        }
    }
    CHECK(complete > 55 && roots > 25, "%d complete, %d zeros", complete,
          roots);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(newton_finds_none_that_is_not_listed),
        cmocka_unit_test(products_of_linear_factors_have_their_zeros),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
