#include "curve.h"

#include <float.h>
#include <math.h>

#include "check.h"

static int fail_at = -1;

void *__real_realloc(void *p, size_t n);
void *__wrap_realloc(void *p, size_t n);

void *__wrap_realloc(void *p, size_t n)
{
    if (fail_at-- == 0)
        return NULL;
    return __real_realloc(p, n);
}

/* Pieces of random degree and random coefficients, kept in `copy` as well. */
enum { PIECES = 50, DIM = 3, DEGREE_MAX = 9 };

struct copy {
    size_t degree[PIECES];
    double coef[PIECES][DIM][DEGREE_MAX + 1];
};

static void fill(struct curve *c, struct copy *k, uint64_t *rng)
{
    for (size_t p = 0; p < PIECES; p++) {
        double *coef;
        k->degree[p] = check_bits(rng) % (DEGREE_MAX + 1);
        assert_int_equal(curve_push(c, k->degree[p], &coef), STATUS_OK);
        for (size_t i = 0; i < DIM; i++)
            for (size_t j = 0; j <= k->degree[p]; j++)
                *coef++ = k->coef[p][i][j] = check_uniform(rng, -1.0, 1.0);
    }
}

static void pieces_evaluate_to_their_polynomials(void **state)
{
    struct curve c = CURVE_EMPTY(DIM);
    struct copy k;
    uint64_t rng = check_seed();

    (void) state;
    fill(&c, &k, &rng);
    assert_int_equal(c.count, PIECES);
    for (size_t p = 0; p < PIECES; p++) {
        const double theta = check_uniform(&rng, 0.0, 1.0);
        double u[DIM], slope[DIM];
        curve_at(&c, p, theta, u);
        curve_slope_at(&c, p, theta, slope);
        for (size_t i = 0; i < DIM; i++) {
            double value = 0.0, rate = 0.0;
            for (size_t j = 0; j <= k.degree[p]; j++) {
                const double n = (double) j;
                value += k.coef[p][i][j] * pow(theta, n);
                rate += j ? n * k.coef[p][i][j] * pow(theta, n - 1.0) : 0.0;
            }
            CHECK(fabs(u[i] - value) < 20 * DBL_EPSILON, "%g, true %g", u[i],
                  value);
            CHECK(fabs(slope[i] - rate) < 400 * DBL_EPSILON, "%g, true %g",
                  slope[i], rate);
            assert_memory_equal(curve_component(&c, p, i), k.coef[p][i],
                                (k.degree[p] + 1) * sizeof(double));
        }
    }
    curve_free(&c);
    assert_int_equal(c.dim, DIM);
    assert_int_equal(c.count, 0);
    curve_free(&c);
}

static enum status grow(struct curve *c, size_t n)
{
    for (size_t p = 0; p < n; p++) {
        double *coef;
        const enum status s = curve_push(c, 4, &coef);
        if (s != STATUS_OK)
            return s;
        for (size_t j = 0; j < DIM * 5; j++)
            coef[j] = (double) p;
    }
    return STATUS_OK;
}

static void every_allocation_may_fail_and_leaves_the_curve_whole(void **state)
{
    enum status s = STATUS_NO_MEMORY;
    int k = 0;

    (void) state;
    for (; s != STATUS_OK; k++) {
        struct curve c = CURVE_EMPTY(DIM);
        fail_at = k;
        s = grow(&c, 1000);
        fail_at = -1;
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%s", status_text(s));
        CHECK(c.coefs == c.count * DIM * 5, "%zu pieces, %zu coefficients",
              c.count, c.coefs);
        for (size_t p = 0; p < c.count; p++) {
            double u[DIM];
            curve_at(&c, p, 0.0, u);
            CHECK(u[0] == (double) p && u[2] == (double) p, "piece %zu", p);
        }
        curve_free(&c);
    }
    CHECK(k > 5, "only %d allocations failed", k - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_evaluate_to_their_polynomials),
        cmocka_unit_test(every_allocation_may_fail_and_leaves_the_curve_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
