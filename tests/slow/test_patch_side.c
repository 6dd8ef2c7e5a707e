/* One side of a rectangle of cells. */
#include "patch_side.h"

#include <math.h>

#include "check.h"

enum { CELLS = 40 };

static void make(double at[], size_t cells, uint64_t *rng)
{
    at[0] = check_uniform(rng, -3, 3);
    for (size_t i = 1; i < cells; i++)
        at[i] = at[i - 1] + check_uniform(rng, 0.01, 1.0);
}

static double polynomial(const double c[PATCH_SIDE], double x)
{
    double sum = 0.0;

    for (int k = PATCH_SIDE; k-- > 0;)
        sum = sum * x + c[k];
    return sum;
}

static void nodes_are_chebyshevs(void **state)
{
    double at[CELLS];

    (void) state;
    for (int i = 0; i < CELLS; i++)
        at[i] = -1.0 + 2.0 * i / (CELLS - 1);
    const struct patch_side s = patch_side_of(at, CELLS);
    for (int i = 0; i < PATCH_SIDE; i++)
        assert_true(fabs(patch_side_node(&s, i) -
                         sin(M_PI * (9 - 2 * i) / (2 * PATCH_SIDE))) <=
                    0x1p-53);
}

/* Those of degree 7 everywhere between the ends, whatever the stride. */
static void polynomials_of_degree_7_are_reproduced(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int round = 0; round < 50; round++) {
        double at[CELLS], c[PATCH_SIDE], f[3 * PATCH_SIDE], T[PATCH_SIDE];
        make(at, CELLS, &rng);
        for (int k = 0; k < PATCH_SIDE; k++)
            c[k] = check_uniform(&rng, -1, 1) * pow(0.1, k);
        const struct patch_side s = patch_side_of(at, CELLS);
        assert_int_equal(s.nodes, PATCH_SIDE);
        for (int i = 0; i < PATCH_SIDE; i++) {
            const double x = patch_side_node(&s, i);
            assert_true(x > at[0] && x < at[CELLS - 1]);
            f[3 * i] = polynomial(c, x);
        }
        patch_side_transform(&s, f, 3);
        for (int i = 0; i < CELLS; i++) {
            double sum = 0.0, all = 0.0;
            assert_true(patch_side_basis(&s, at[i], T));
            for (int k = 0; k < PATCH_SIDE; k++) {
                sum += f[3 * k] * T[k];
                all += fabs(f[3 * k]);
            }
            CHECK(fabs(sum - polynomial(c, at[i])) < 1e-13 * all,
                  "x = %g: %.17g, not %.17g", at[i], sum, polynomial(c, at[i]));
        }
    }
}

/* l_i is 1 at its node, 0 at the others; sum |l_i| at the ends. */
static void weights_are_those_of_lagranges_polynomials(void **state)
{
    double at[CELLS];

    (void) state;
    for (int i = 0; i < CELLS; i++)
        at[i] = -1.0 + 2.0 * i / (CELLS - 1);
    const struct patch_side s = patch_side_of(at, CELLS);
    for (double t = -1.0; t <= 1.0; t += 0x1p-6) {
        const struct patch_point p = patch_side_point(&s, t);
        double sum = 0.0;
        for (int i = 0; i < PATCH_SIDE; i++) {
            double l = 1.0;
            for (int k = 0; k < PATCH_SIDE; k++)
                if (k != i)
                    l *= (t - patch_side_node(&s, k)) /
                         (patch_side_node(&s, i) - patch_side_node(&s, k));
            CHECK(fabs(p.weight[i] - fabs(l)) < 1e-13, "t %g, node %d: %g, %g",
                  t, i, p.weight[i], l);
            sum += fabs(l);
        }
        CHECK(sum <= patch_side_weight(&s), "t %g: %g", t, sum);
        assert_true(fabs(t) < 1.0 || sum > 0.999 * patch_side_weight(&s));
    }
    assert_true(patch_side_point(&s, patch_side_node(&s, 3)).weight[3] == 1.0);
}

static void few_cells_have_a_value_each(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (size_t cells = 1; cells <= PATCH_SIDE; cells++) {
        double at[PATCH_SIDE], f[PATCH_SIDE], basis[PATCH_SIDE];
        make(at, cells, &rng);
        const struct patch_side s = patch_side_of(at, cells);
        assert_true(s.is_exact && s.nodes == (int) cells);
        for (size_t i = 0; i < cells; i++) {
            assert_true(patch_side_node(&s, (int) i) == at[i]);
            f[i] = check_uniform(&rng, -9, 9);
        }
        const double last = f[cells - 1];
        patch_side_transform(&s, f, 1);
        assert_true(patch_side_basis(&s, at[cells - 1], basis));
        double sum = 0.0;
        for (size_t i = 0; i < cells; i++)
            sum += f[i] * basis[i];
        assert_true(sum == last);
        assert_false(patch_side_basis(&s, at[0] + 1e-9, basis));
    }
}

static void parts_are_even_and_leave_nothing_out(void **state)
{
    double at[CELLS] = { 0.0 };

    (void) state;
    for (size_t cells = 9; cells <= CELLS; cells++) {
        const struct patch_side s = patch_side_of(at, cells);
        for (size_t parts = 1; parts <= 8; parts++) {
            assert_int_equal(patch_side_cut(&s, parts, 0), 0);
            assert_int_equal(patch_side_cut(&s, parts, parts), cells);
            for (size_t i = 0; i < parts; i++) {
                const size_t size = patch_side_cut(&s, parts, i + 1) -
                                    patch_side_cut(&s, parts, i);
                CHECK(size == cells / parts || size == cells / parts + 1,
                      "part %zu of %zu: %zu of %zu", i, parts, size, cells);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_are_chebyshevs),
        cmocka_unit_test(polynomials_of_degree_7_are_reproduced),
        cmocka_unit_test(weights_are_those_of_lagranges_polynomials),
        cmocka_unit_test(few_cells_have_a_value_each),
        cmocka_unit_test(parts_are_even_and_leave_nothing_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
