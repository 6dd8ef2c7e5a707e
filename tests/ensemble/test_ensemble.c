/* Whole ensembles: what they say against all draws in memory, against forward
 * integration, and at any number of threads or after a stop. */
#include "ensemble.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "ensemble_tolerance.h"
#include "fate.h"
#include "own_folder.h"
#include "sweeps.h"

struct ran {
    struct scene scene;
    struct ensemble e;
};

static const char two[] =
    "parameters: {material.a: {normal: [0.0349, 0.001]}, slope.alpha: "
    "{uniform: [0.28, 0.36]}}, numbers: [v_plus, x_excess], pushes: [{v: "
    "2500, psi: 10}, {from: creep, kick: 2000}, {v: 1e-3, psi: 1}]";

static void set_scene(struct scene *scene, const char *more)
{
    char text[600];
    const char *const sets[] = { "law.preset=spinodal_gen", "slope.alpha=0.34",
                                 "accuracy.rtol=1e-9", text, NULL };

    const int n = snprintf(text, sizeof text, "ensemble={%s, %s}", two, more);
    assert_in_range(n, 1, (int) sizeof text - 1);
    scene_set(scene, sets);
}

static void run(struct ran *x, const char *more, const struct sweep_options *o)
{
    struct fault why;

    set_scene(&x->scene, more);
    CHECK(ensemble_run(&x->e, &x->scene, o, NULL, &why) == STATUS_OK, "%s",
          why.text);
}

static void ran_free(struct ran *x)
{
    ensemble_free(&x->e);
    scene_free(&x->scene);
}

static const struct sweep_options plain = { .journal = NULL };

/* A column of all draws; owned by the caller. */
static void *read_all(const struct ensemble *e, enum spool_kind kind, size_t k,
                      size_t size)
{
    char *all = malloc(e->draws.count * size);
    struct fault why;

    assert_non_null(all);
    for (size_t b = 0; b < spool_blocks(&e->spool); b++)
        assert_int_equal(spool_read(&e->spool, b, kind, k,
                                    all + b * SPOOL_DRAWS * size, &why),
                         STATUS_OK);
    return all;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *) a, y = *(const double *) b;

    return (x > y) - (x < y);
}

static void check_number(const struct ensemble *e, size_t k)
{
    const struct ensemble_number *n = &e->number[k];
    double *value = read_all(e, SPOOL_VALUE, k, sizeof *value);
    int8_t *code = read_all(e, SPOOL_CODE, k, 1);
    size_t count = 0;
    double sum = 0.0;

    for (size_t i = 0; i < e->draws.count; i++)
        if (code[i] == REASON_PRESENT) {
            value[count++] = value[i];
            sum += value[i];
        }
    assert_true(count > 0 && count < e->draws.count);
    qsort(value, count, sizeof *value, compare);
    for (int q = 0; q < ENSEMBLE_QUANTILES; q++) {
        const double rank = ceil(ensemble_quantile[q] * (double) count);
        CHECK(n->quantile[q] == value[(size_t) rank - 1], "%s %g: %.17g",
              n->name, ensemble_quantile[q], n->quantile[q]);
    }
    CHECK(fabs(n->mean.value / (sum / (double) count) - 1.0) < 1e-12, "%.17g",
          n->mean.value);
    CHECK(fabs(n->exists.value - (double) count / (double) e->draws.count) <
              1e-12,
          "%g", n->exists.value);
    assert_int_equal(n->reason[REASON_PRESENT], count);
    free(value);
    free(code);
}

static void test_quantiles_and_means_are_those_of_all_draws(void **state)
{
    struct ran x;

    (void) state;
    run(&x, "draws: 2300", &plain); /* three blocks, one of them short */
    check_number(&x.e, 0);
    check_number(&x.e, 1);
    size_t reasons = 0;
    for (size_t r = 0; r < REASONS_MAX; r++)
        reasons += x.e.number[0].reason[r];
    assert_int_equal(reasons, 2300);
    ran_free(&x);
}

static void same(const struct ensemble *a, const struct ensemble *b)
{
    static const struct {
        enum spool_kind kind;
        size_t size, count;
    } all[] = { { SPOOL_KEY, 8, 2 },   { SPOOL_VALUE, 8, 2 },
                { SPOOL_ERROR, 8, 2 }, { SPOOL_CODE, 1, 2 },
                { SPOOL_FATE, 1, 3 },  { SPOOL_FATE_REASON, 1, 3 } };

    assert_int_equal(a->draws.count, b->draws.count);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        for (size_t k = 0; k < all[i].count; k++) {
            void *x = read_all(a, all[i].kind, k, all[i].size);
            void *y = read_all(b, all[i].kind, k, all[i].size);
            assert_memory_equal(x, y, a->draws.count * all[i].size);
            free(x);
            free(y);
        }
    for (int q = 0; q < ENSEMBLE_QUANTILES; q++)
        assert_memory_equal(&a->number[0].quantile[q],
                            &b->number[0].quantile[q], sizeof(double));
    for (int f = 0; f <= (int) FATES; f++)
        assert_memory_equal(&a->push[0].fate[f], &b->push[0].fate[f],
                            sizeof(struct estimate));
}

static void test_threads_change_no_bit(void **state)
{
    struct ran one, three;

    (void) state;
    omp_set_num_threads(1);
    run(&one, "draws: 1500", &plain);
    omp_set_num_threads(3);
    run(&three, "draws: 1500", &plain);
    same(&one.e, &three.e);
    ran_free(&one);
    ran_free(&three);
}

/* Stops after so many draws. */
static int stop_at(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    (void) stage, (void) total;
    return done >= *(const uint64_t *) ctx;
}

static void test_a_stopped_run_goes_on_to_the_same_bytes(void **state)
{
    uint64_t most = 2200;
    const struct monitor monitor = { stop_at, &most };
    const char *journal = own_path("j.part");
    const struct sweep_options fresh = { .journal = journal, .version = "1" };
    const struct sweep_options again = { .journal = journal,
                                         .resume = true,
                                         .version = "1" };
    const struct sweep_options other = { .journal = journal,
                                         .resume = true,
                                         .version = "2" };
    struct ran whole, part, rest;
    struct fault why;

    (void) state;
    run(&whole, "draws: 2600", &plain);
    set_scene(&part.scene, "draws: 2600");
    assert_int_equal(ensemble_run(&part.e, &part.scene, &fresh, &monitor, &why),
                     STATUS_STOPPED);
    assert_int_equal(ensemble_run(&part.e, &part.scene, &other, NULL, &why),
                     STATUS_BAD_SCENE);
    run(&rest, "draws: 2600", &again);
    assert_int_equal(rest.e.taken, 2 * SPOOL_DRAWS);
    same(&whole.e, &rest.e);
    ran_free(&whole);
    scene_free(&part.scene);
    ran_free(&rest);
}

/* Plain Monte Carlo by forward integration of each draw's own orbit. */
static void test_probabilities_are_those_of_forward_integration(void **state)
{
    enum { DRAWS = 600 };
    struct ran sobol, random;
    size_t stops[2] = { 0, 0 }, odd = 0;

    (void) state;
    run(&sobol, "draws: 4096", &plain);
    run(&random, "draws: 600, method: random, seed: 77", &plain);
    double *a = read_all(&random.e, SPOOL_KEY, 0, sizeof *a);
    double *alpha = read_all(&random.e, SPOOL_KEY, 1, sizeof *alpha);
    int8_t *told = read_all(&random.e, SPOOL_FATE, 0, 1);
    for (int i = 0; i < DRAWS; i++) {
        static struct slider s;
        struct scene at = random.scene; /* borrows */
        struct fate_result r;
        at.material.a = a[i];
        slider_init(&s, &at.law, &at.material, tanl((long double) alpha[i]));
        const struct vec2 z = { log(2500.0), log(10.0) };
        assert_int_equal(fate_find(&s, z, 1e-9, false, NULL, &r), STATUS_OK);
        stops[0] += r.fate == FATE_CREEP || r.fate == FATE_REST_FINITE ||
                    r.fate == FATE_REST_ASYMPTOTIC;
        odd += told[i] != (int8_t) r.fate && told[i] != FATE_UNDECIDED;
    }
    CHECK(odd == 0, "%zu fates differ from those of orbits", odd);
    const struct estimate *p = &sobol.e.push[0].arrest;
    const double share = (double) stops[0] / DRAWS;
    const double bar = sqrt(share * (1.0 - share) / DRAWS);
    CHECK(fabs(p->value - share) <= 3.0 * bar + p->error,
          "arrest %g +- %g, by orbits %g +- %g", p->value, p->error, share,
          bar);
    assert_true(share > 0.1 && share < 0.9);
    free(a);
    free(alpha);
    free(told);
    ran_free(&sobol);
    ran_free(&random);
}

static void test_pushes_without_a_state_are_counted(void **state)
{
    struct ran x;

    (void) state;
    run(&x, "draws: 2000", &plain); /* below the fold there is no creep */
    const struct ensemble_push *p = &x.e.push[1];
    double sum = 0.0;
    for (int f = 0; f <= (int) FATES; f++)
        sum += p->fate[f].value;
    assert_true(fabs(sum - 1.0) < 1e-12);
    ran_free(&x);
}

/* A sum of normal numbers: shares are those of its variances. */
static void test_shares_of_variance_have_a_closed_form(void **state)
{
    /* ln saddle_v of Ruina's law is (mu_star - tan alpha)/(b - a) */
    const char *const sets[] = {
        "law.preset=ruina", "law.friction=log", "slope.tan_alpha=0.36",
        "ensemble={parameters: {material.mu_star: {normal: [0.369, 1e-4]}, "
        "slope.tan_alpha: {normal: [0.36, 2e-4]}}, draws: 20000, numbers: "
        "[saddle_v]}",
        NULL
    };
    static const double share[] = { 0.2, 0.8 };
    struct ran x;
    struct fault why;

    (void) state;
    scene_set(&x.scene, sets);
    CHECK(ensemble_run(&x.e, &x.scene, &plain, NULL, &why) == STATUS_OK, "%s",
          why.text);
    for (int k = 0; k < 2; k++) {
        const struct estimate *s = &x.e.number[0].share[k];
        CHECK(fabs(s->value - share[k]) <= s->error + 1e-3 && s->error < 0.03,
              "%d: %g +- %g, truth %g", k, s->value, s->error, share[k]);
    }
    ran_free(&x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_quantiles_and_means_are_those_of_all_draws),
        cmocka_unit_test(test_threads_change_no_bit),
        cmocka_unit_test_setup_teardown(
            test_a_stopped_run_goes_on_to_the_same_bytes, own_folder_make,
            own_folder_remove),
        cmocka_unit_test(test_probabilities_are_those_of_forward_integration),
        cmocka_unit_test(test_pushes_without_a_state_are_counted),
        cmocka_unit_test(test_shares_of_variance_have_a_closed_form),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
