/* A sample of a batch's draws held to 113 bits; EXACT_DRAWS: how many. */
#include "batch.h"

#include <math.h>

#include "laws.h"
#include "quad.h"
#include "stress_truth.h"
#include "sweeps.h"

enum { KEYS = 3, NUMBERS = 3 };

static const char *const keys[KEYS] = { "material.a", "material.b",
                                        "slope.tan_alpha" };
static const char *const names[NUMBERS] = { "v_plus", "v_minus", "x_excess" };
static const enum stress_number which[NUMBERS] = { STRESS_V_PLUS,
                                                   STRESS_V_MINUS,
                                                   STRESS_X_EXCESS };
static const double range[KEYS][2] = { { 0.03, 0.04 },
                                       { 0.045, 0.053 },
                                       { 0.31, 0.4 } };

struct sample {
    size_t draws;
    double *value[KEYS], *number[NUMBERS], *error[NUMBERS];
    const char **reason[NUMBERS];
};

static struct sample sample_of(size_t draws, uint64_t *rng)
{
    struct sample s = { .draws = draws };

    for (int k = 0; k < KEYS; k++) {
        s.value[k] = calloc(draws, sizeof *s.value[k]);
        for (size_t i = 0; i < draws; i++)
            s.value[k][i] = check_uniform(rng, range[k][0], range[k][1]);
    }
    for (int n = 0; n < NUMBERS; n++) {
        s.number[n] = calloc(draws, sizeof *s.number[n]);
        s.error[n] = calloc(draws, sizeof *s.error[n]);
        s.reason[n] = calloc(draws, sizeof *s.reason[n]);
    }
    return s;
}

static void sample_free(struct sample *s)
{
    for (int k = 0; k < KEYS; k++)
        free(s->value[k]);
    for (int n = 0; n < NUMBERS; n++) {
        free(s->number[n]);
        free(s->error[n]);
        free(s->reason[n]);
    }
}

static void run(const struct scene *scene, struct sample *s)
{
    struct batch_column out[NUMBERS];
    const double *column[KEYS];
    struct fault why;
    struct batch b;

    for (int k = 0; k < KEYS; k++)
        column[k] = s->value[k];
    for (int n = 0; n < NUMBERS; n++)
        out[n] =
            (struct batch_column){ s->number[n], s->error[n], s->reason[n] };
    CHECK(batch_init(&b, scene, keys, KEYS, names, NUMBERS, &why) == STATUS_OK,
          "%s", why.text);
    assert_int_equal(batch_run(&b, s->draws, column, 0, NULL, out, NULL),
                     STATUS_OK);
    batch_free(&b);
}

/* Of a draw. */
struct truth {
    struct stress_true number[NUMBERS];
};

static void find_truths(const struct scene *scene, const struct sample *s,
                        struct truth out[])
{
#pragma omp parallel for schedule(dynamic, 1)
    for (size_t i = 0; i < s->draws; i++) {
        struct stress_truth all;
        struct material m = scene->material;
        m.a = s->value[0][i];
        m.b = s->value[1][i];
        stress_truth_find(&scene->law, &m, (long double) s->value[2][i], &all);
        for (int n = 0; n < NUMBERS; n++)
            out[i].number[n] = all.number[which[n]];
    }
}

/* How far it is off, over its bar; what 113 bits have not, it has not. */
static double hold(const struct sample *s, size_t i, int n,
                   const struct stress_true *t)
{
    const double value = s->number[n][i], bar = s->error[n][i];

    CHECK(t->exists == (s->reason[n][i] == NULL), "%s at draw %zu: %s",
          names[n], i, s->reason[n][i] ? s->reason[n][i] : "a number");
    if (!t->exists)
        return 0.0;
    const quad off = fabsq((quad) value - t->value);
    CHECK(off <= (quad) bar + t->error && t->error <= (quad) bar / 16,
          "%s of a = %.17g, b = %.17g, tan(alpha) = %.17g: %.17g +- %.3g is "
          "off by %.3g +- %.3g",
          names[n], s->value[0][i], s->value[1][i], s->value[2][i], value, bar,
          (double) off, (double) t->error);
    return (double) (off / (quad) bar);
}

static void hold_all(const struct scene *scene, const struct sample *s)
{
    struct truth *truth = calloc(s->draws, sizeof *truth);
    size_t missing = 0;
    double worst = 0.0;

    find_truths(scene, s, truth);
    for (size_t i = 0; i < s->draws; i++)
        for (int n = 0; n < NUMBERS; n++) {
            missing += !truth[i].number[n].exists;
            worst = fmax(worst, hold(s, i, n, &truth[i].number[n]));
        }
    print_message("# %s: %zu draws, off by up to %.3g of a bar, %zu of %zu "
                  "numbers do not exist\n",
                  scene->law.preset, s->draws, worst, missing,
                  NUMBERS * s->draws);
    free(truth);
}

static void a_sample_is_within_its_bars_by_113_bits(void **state)
{
    static const char *const laws[] = { "spinodal_gen", "dieterich_gen" };
    const char *asked = getenv("EXACT_DRAWS");
    const size_t draws = asked ? strtoul(asked, NULL, 10) : 8;
    uint64_t rng = check_seed();

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t l = 0; l < sizeof laws / sizeof *laws; l++) {
        char preset[40];
        const char *const sets[] = { preset, "slope.tan_alpha=0.34",
                                     "accuracy.rtol=1e-9", NULL };
        struct scene scene;
        snprintf(preset, sizeof preset, "law.preset=%s", laws[l]);
        scene_set(&scene, sets);
        struct sample s = sample_of(draws / 2, &rng);
        run(&scene, &s);
        hold_all(&scene, &s);
        sample_free(&s);
        scene_free(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sample_is_within_its_bars_by_113_bits),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
