/* Whole powers of what may be of any sign, against products of 113 bits, at
 * random points of random boxes. */
#include <math.h>

#include "check.h"
#include "interval_growth.h"
#include "interval_math.h"
#include "quad.h"

enum { DRAWS = 4000, MOST = 9 };

static formula_real power(formula_real x, long n)
{
    formula_real out = 1;

    for (long i = 0; i < labs(n); i++)
        out *= x;
    return n < 0 ? 1 / out : out;
}

/* A box about 0, beside it or thin, of doubles, and a point in it. */
static double draw(uint64_t *rng, double box[2])
{
    const double size = pow(10, check_uniform(rng, -3, 3));

    box[0] = size * check_uniform(rng, -1, 1);
    box[1] =
        box[0] + (check_bits(rng) % 3 ? size * check_uniform(rng, 0, 1) : 0);
    return fmin(box[0] + (box[1] - box[0]) * check_uniform(rng, 0, 1), box[1]);
}

static void holds(const char *what, struct interval u, formula_real truth,
                  const double box[2], long n)
{
    const formula_real room = fabsq(truth) * 0x1p-100L;

    CHECK(u.lo <= truth + room && truth - room <= u.hi,
          "%s, %ld, over [%.17g, %.17g]: [%.20Lg, %.20Lg] has no %.17g", what,
          n, box[0], box[1], u.lo, u.hi, (double) truth);
}

/* From the least to the largest there is. */
static void is_all(const char *what, struct interval u, const double box[2],
                   long n)
{
    const long double a = (long double) power(box[0], n);
    const long double b = (long double) power(box[1], n);
    const bool turns = n > 0 && n % 2 == 0 && box[0] < 0 && box[1] > 0;
    const long double lo = turns ? 0 : fminl(a, b), hi = fmaxl(a, b);

    CHECK(u.lo >= lo - 1e-17L * fabsl(lo) && u.hi <= hi + 1e-17L * fabsl(hi),
          "%s, %ld, over [%.17g, %.17g]: [%.20Lg, %.20Lg]", what, n, box[0],
          box[1], u.lo, u.hi);
}

static void a_power_of_a_box_is_that_of_its_points(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < DRAWS; i++) {
        const long n = (long) (check_bits(&rng) % (MOST + 1));
        double box[2];
        const double x = draw(&rng, box);
        const struct interval u =
            interval_power((struct interval){ box[0], box[1] }, n);
        holds("power", u, power(x, n), box, n);
        is_all("power", u, box, n);
    }
    const struct interval less = { -HUGE_VAL, 3 };
    assert_true(interval_power(less, 2).lo >= 0);
    assert_true(interval_power(less, 3).hi < 28);
    assert_true(interval_power(less, 3).lo < -1e300L);
}

/* ---- what does not change ------------------------------------------------ */

/* u^w of two parameters. */
static enum status constant(const double u[2], const double w[2],
                            struct interval *out)
{
    static struct formula f;
    struct interval_graph g;
    struct fault why;
    bool needed[FORMULA_NODES] = { false };
    int of[2];
    mpfi_t box;

    formula_init(&f);
    of[0] = formula_leaf(&f, "u", FORMULA_PARAMETER);
    of[1] = formula_leaf(&f, "w", FORMULA_PARAMETER);
    const int node = formula_call(&f, FUNCTION_POWER, of);
    needed[node] = true;
    assert_int_equal(interval_graph_init(&g, &f, needed, 60), STATUS_OK);
    mpfi_init2(box, 60);
    mpfi_interv_d(box, u[0], u[1]);
    interval_graph_set(&g, "u", box);
    mpfi_interv_d(box, w[0], w[1]);
    interval_graph_set(&g, "w", box);
    mpfi_clear(box);
    const enum status status = interval_graph_run(&g, &why);
    *out = interval_graph_get(&g, node);
    interval_graph_free(&g);
    return status;
}

static void a_constant_has_whole_powers_of_either_sign(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < DRAWS; i++) {
        const long n = (long) (check_bits(&rng) % (2 * MOST + 1)) - MOST;
        const double w[2] = { (double) n, (double) n };
        struct interval u;
        double box[2];
        const double x = draw(&rng, box);
        const bool has_0 = box[0] <= 0 && box[1] >= 0;
        const enum status status = constant(box, w, &u);
        CHECK((status == STATUS_OK) == (n >= 0 || !has_0), "%ld of [%g, %g]", n,
              box[0], box[1]);
        if (status != STATUS_OK)
            continue;
        holds("constant", u, power(x, n), box, n);
        is_all("constant", u, box, n);
    }
}

static void others_are_of_what_is_positive(void **state)
{
    static const double less[] = { -2, -1 }, more[] = { 1, 2 };
    static const double about[][2] = { { 2.5, 2.5 }, { 2, 2.25 }, { 2, 3 } };
    struct interval u;

    (void) state;
    for (int i = 0; i < 3; i++) {
        assert_int_equal(constant(less, about[i], &u), STATUS_BAD_ARGUMENT);
        assert_int_equal(constant(more, about[i], &u), STATUS_OK);
        holds("a power", u, powq(2, about[i][1]), more, 0);
    }
}

/* ---- what does ----------------------------------------------------------- */

/* (x - 1)^n and its derivatives over a box of x. */
static void grow(struct interval box, long n, struct interval out[3])
{
    static struct formula f;
    static struct interval_growth w;
    struct interval_graph g;
    struct fault why;
    bool needed[FORMULA_NODES] = { false };
    int variable[2], of[2];
    mpfi_t zero;

    formula_init(&f);
    for (int i = 0; i < 2; i++)
        variable[i] = formula_leaf(&f, i ? "y" : "x", FORMULA_PARAMETER);
    of[0] = formula_sum(&f, variable[0], formula_number(&f, -1));
    of[1] = formula_leaf(&f, "n", FORMULA_PARAMETER);
    const int node = formula_call(&f, FUNCTION_POWER, of);
    needed[node] = needed[variable[1]] = true;
    assert_int_equal(interval_graph_init(&g, &f, needed, 200), STATUS_OK);
    mpfi_init2(zero, 53);
    mpfi_set_d(zero, 0);
    interval_graph_set(&g, "x", zero);
    interval_graph_set(&g, "y", zero);
    mpfi_set_d(zero, (double) n);
    interval_graph_set(&g, "n", zero);
    mpfi_clear(zero);
    assert_int_equal(interval_graph_run(&g, &why), STATUS_OK);
    assert_true(interval_growth_run(
        &w, &g, variable, (struct interval[]){ box, interval_point(0) }, 0));
    out[0] = w.value[node].all;
    out[1] = w.by[node].all;
    out[2] = w.rate[node].all;
    interval_graph_free(&g);
}

static void powers_grow_as_they_do_at_every_point(void **state)
{
    uint64_t rng = check_seed();
    struct interval u[3];

    (void) state;
    for (int i = 0; i < DRAWS; i++) {
        const long n = (long) (check_bits(&rng) % (2 * MOST + 1)) - MOST;
        double box[2];
        const formula_real x = (formula_real) draw(&rng, box) - 1;
        grow((struct interval){ box[0], box[1] }, n, u);
        holds("value", u[0], power(x, n), box, n);
        holds("derivative", u[1], (formula_real) n * power(x, n - 1), box, n);
        holds("logarithm's", u[2], (formula_real) n / x, box, n);
    }
    grow((struct interval){ -HUGE_VAL, 5 }, 3, u);
    assert_true(u[0].hi < 65 && u[1].lo >= 0);
    grow((struct interval){ -HUGE_VAL, -1 }, 2, u);
    CHECK(u[0].lo > 3.9L && u[1].hi < -3.9L && u[2].lo > -3, "[%Lg, [%Lg, %Lg",
          u[0].lo, u[1].hi, u[2].lo);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_power_of_a_box_is_that_of_its_points),
        cmocka_unit_test(a_constant_has_whole_powers_of_either_sign),
        cmocka_unit_test(others_are_of_what_is_positive),
        cmocka_unit_test(powers_grow_as_they_do_at_every_point),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
