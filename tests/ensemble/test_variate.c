/* Probabilities of fates over scrambled draws, by margins in closed form:
 * whole summaries of spools that no study has filled. */
#include <math.h>
#include <string.h>

#include "ensemble_summary.h"
#include "own_folder.h"
#include "sweeps.h"

enum { RUNS = 100, DRAWS = 1024, KEYS = 3 };

/* Fates by the scores z. */
struct model {
    const char *what;
    const char *parameters;
    double (*margin)(const double z[KEYS]);
    double (*zero)(double x, double w); /* m < 0 where z[1] is below it; NULL:
                                           nowhere alone */
};

static double meets(double x, double w)
{
    return 0.5 - 0.3 * x - 0.4 * w - 0.1 * x * x - 0.15 * sin(2.0 * w + x);
}

/* Curved in all of its scores. */
static double curved(const double z[KEYS])
{
    return expm1(0.4 * (z[1] - meets(z[0], z[2])));
}

/* No function of any score: P(z0^2 + z1^2 < 2) = 1 - 1/e. */
static double ring(const double z[KEYS])
{
    return z[0] * z[0] + z[1] * z[1] - 2.0;
}

/* On a tenth there is no margin, and the fate is one. */
static double partly_meets(double x, double w)
{
    return w > 0.8 ? -HUGE_VAL : 0.3 * x * x;
}

static double partly(const double z[KEYS])
{
    return z[2] > 0.8 ? HUGE_VAL : z[1] - 0.3 * z[0] * z[0];
}

/* E P(z1 < zero): the trapezoid over a normal score, the midpoint over an even
 * one. */
static double truth_of(double (*zero)(double x, double w))
{
    double sum = 0.0, all = 0.0;

    for (int i = -400; i <= 400; i++)
        for (int k = 0; k < 2000; k++) {
            const double x = i / 50.0, w = -1.0 + (k + 0.5) / 1000.0;
            sum += exp(-0.5 * x * x) * 0.5 * erfc(-zero(x, w) / sqrt(2.0));
            all += exp(-0.5 * x * x);
        }
    return sum / all;
}

struct drawn {
    struct scene scene;
    struct ensemble e;
};

/* An ensemble whose draws nobody has looked at. */
static void draw(struct drawn *x, const char *parameters, const char *method,
                 uint64_t seed)
{
    static const struct scene_push push = { .v = 1.0 };
    char ensemble[400];
    const char *const sets[] = { "law.preset=spinodal_gen", "slope.alpha=0.34",
                                 ensemble, NULL };
    struct ensemble *e = &x->e;
    struct fault why;
    bool replaced;

    snprintf(ensemble, sizeof ensemble,
             "ensemble={parameters: {%s}, draws: %d, method: %s, seed: %llu, "
             "pushes: [{v: 1, psi: 1}]}",
             parameters, DRAWS, method, (unsigned long long) seed);
    scene_set(&x->scene, sets);
    *e = ENSEMBLE_EMPTY;
    e->scene = &x->scene;
    assert_int_equal(batch_push(&e->batch, &push, 1), STATUS_OK);
    assert_int_equal(draws_init(&e->draws, e->scene, &why), STATUS_OK);
    const struct spool_shape shape = { e->draws.count, KEYS, 0, 1 };
    assert_int_equal(sweep_reasons_init(&e->reasons), STATUS_OK);
    assert_int_equal(spool_open(&e->spool, &(struct sweep_options){ 0 }, 1,
                                &shape, &e->reasons, &replaced, &why),
                     STATUS_OK);
}

static void drawn_free(struct drawn *x)
{
    ensemble_free(&x->e);
    scene_free(&x->scene);
}

/* What a study would have found; how many stop. */
static void fill(struct ensemble *e, double (*margin)(const double z[KEYS]),
                 size_t *stops)
{
    double *m = spool_column(&e->spool, SPOOL_MARGIN, 0), z[KEYS];
    int8_t *fate = spool_column(&e->spool, SPOOL_FATE, 0);
    int8_t *code = spool_column(&e->spool, SPOOL_FATE_REASON, 0);
    struct fault why;

    for (size_t b = 0; b < spool_blocks(&e->spool); b++) {
        for (size_t i = 0; i < spool_count(&e->spool, b); i++) {
            draws_scores(&e->draws, b * SPOOL_DRAWS + i, z);
            m[i] = margin(z);
            fate[i] = m[i] < 0.0 ? FATE_CREEP : FATE_SLIDING;
            code[i] = REASON_PRESENT;
            *stops += m[i] < 0.0;
        }
        assert_int_equal(spool_push(&e->spool, b, &why), STATUS_OK);
    }
}

static struct estimate arrest_of(struct ensemble *e)
{
    struct fault why;

    assert_int_equal(ensemble_summary(e, &why), STATUS_OK);
    const struct ensemble_push *p = &e->push[0];
    const double sum = p->fate[FATE_CREEP].value + p->fate[FATE_SLIDING].value;
    CHECK(fabs(sum - 1.0) < 1e-12 && p->arrest.value >= 0.0 &&
              p->arrest.value == p->fate[FATE_CREEP].value,
          "%.17g of %.17g", p->arrest.value, sum);
    return p->arrest;
}

struct held {
    size_t count;
    double gain; /* over the error of as many random draws */
};

static struct held repeat(const struct model *m, double truth)
{
    struct held h = { 0, 0.0 };
    double square = 0.0, bar = 0.0;

    for (uint64_t run = 0; run < RUNS; run++) {
        struct drawn x;
        size_t stops = 0;
        draw(&x, m->parameters, "sobol", sobol_hash(check_seed(), run) >> 33);
        fill(&x.e, m->margin, &stops);
        const struct estimate e = arrest_of(&x.e);
        h.count += fabs(e.value - truth) <= e.error;
        square += (e.value - truth) * (e.value - truth) / RUNS;
        bar += e.error / RUNS;
        drawn_free(&x);
    }
    h.gain = sqrt(truth * (1.0 - truth) / DRAWS / square);
    print_message("# %s: %.6f, %zu of %d hold, errors %.2g, bars %.2g, %.1f "
                  "times less than of random draws\n",
                  m->what, truth, h.count, RUNS, sqrt(square), bar, h.gain);
    return h;
}

static const char three[] =
    "material.a: {normal: [0.0349, 0.0005]}, material.L: {lognormal: [0.9e-6, "
    "1.15]}, slope.alpha: {uniform: [0.335, 0.345]}";

/* Of 100 at 0.95: 95 +- 2.2. */
static void test_errors_hold_whatever_the_margin_is(void **state)
{
    static const struct model models[] = {
        { "ring", three, ring, NULL },
        { "partly", three, partly, partly_meets },
    };

    (void) state;
    for (size_t i = 0; i < sizeof models / sizeof *models; i++) {
        const struct model *m = &models[i];
        const struct held h =
            repeat(m, m->zero ? truth_of(m->zero) : 1.0 - exp(-1.0));
        CHECK(h.count >= 89, "%s: %zu of %d hold", m->what, h.count, RUNS);
        CHECK(h.gain >= 2.0, "%s: only %.3g times", m->what, h.gain);
    }
}

static void test_smooth_margins_make_draws_a_hundred_times_better(void **state)
{
    static const struct model m = { "curved", three, curved, meets };

    (void) state;
    const struct held h = repeat(&m, truth_of(meets));
    CHECK(h.count >= 95, "%zu of %d hold", h.count, RUNS);
    CHECK(h.gain >= 10.0, "only %.3g times less than of random draws", h.gain);
}

static void test_other_draws_are_counted(void **state)
{
    static const char *const others[] = { "random", "grid" };

    (void) state;
    for (int i = 0; i < 2; i++) {
        struct drawn x;
        size_t stops = 0;
        draw(&x, three, others[i], 1);
        fill(&x.e, curved, &stops);
        const struct estimate arrest = arrest_of(&x.e);
        CHECK(arrest.value == (double) stops / (double) x.e.draws.count,
              "%s: %.17g", others[i], arrest.value);
        drawn_free(&x);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_smooth_margins_make_draws_a_hundred_times_better),
        cmocka_unit_test(test_errors_hold_whatever_the_margin_is),
        cmocka_unit_test(test_other_draws_are_counted),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
