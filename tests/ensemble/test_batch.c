/* Draws of a batch against studies of their own. */
#include "batch.h"

#include <math.h>
#include <string.h>

#include "fate.h"
#include "fault_alloc.h"
#include "push.h"
#include "study.h"
#include "sweeps.h"

enum { DRAWS = 200, KEYS = 4, BRANCHED = 3, NUMBERS = 5, PUSHES = 3 };

static const char *const keys[KEYS] = { "material.a", "material.b",
                                        "slope.alpha", "material.L" };
static const char *const names[NUMBERS] = { "v_plus", "v_minus", "x_excess",
                                            "saddle_v", "folds_alpha_cM" };
static const struct scene_push pushes[PUSHES] = { { .v = 2500.0, .psi = 10.0 },
                                                  { .v = 1e-3, .psi = 1.0 },
                                                  { .from_creep = true,
                                                    .v = 3000.0 } };

/* Values of the keys and what comes of them. */
struct draws {
    double value[KEYS][DRAWS];
    const double *column[KEYS];
    double number[NUMBERS][DRAWS], error[NUMBERS][DRAWS];
    const char *reason[NUMBERS][DRAWS];
    int8_t fate[PUSHES][DRAWS];
    struct batch_column out[NUMBERS];
    struct batch_fates fates[PUSHES];
};

static void draw(struct draws *d, uint64_t *rng)
{
    static const double range[KEYS][2] = {
        { 0.03, 0.04 }, { 0.045, 0.053 }, { 0.3, 0.38 }, { 0.5e-6, 5e-6 }
    };

    for (int k = 0; k < KEYS; k++) {
        for (int i = 0; i < DRAWS; i++)
            d->value[k][i] = check_uniform(rng, range[k][0], range[k][1]);
        d->column[k] = d->value[k];
    }
    for (int n = 0; n < NUMBERS; n++)
        d->out[n] =
            (struct batch_column){ d->number[n], d->error[n], d->reason[n] };
    for (int p = 0; p < PUSHES; p++)
        d->fates[p] = (struct batch_fates){ .fate = d->fate[p] };
}

static void open_batch(struct batch *b, struct scene *scene, const char *law)
{
    char preset[40];
    const char *const sets[] = { preset, "slope.alpha=0.34", NULL };
    struct fault why;

    snprintf(preset, sizeof preset, "law.preset=%s", law);
    scene_set(scene, sets);
    CHECK(batch_init(b, scene, keys, KEYS, names, NUMBERS, &why) == STATUS_OK,
          "%s", why.text);
}

static void run(const struct batch *b, struct draws *d, int threads)
{
    assert_int_equal(batch_run(b, DRAWS, d->column, threads, NULL, d->out,
                               b->pushes ? d->fates : NULL),
                     STATUS_OK);
}

/* The scene of draw i, as a user types it. */
static void scene_of_draw(struct scene *scene, const char *law,
                          const struct draws *d, int i)
{
    char text[KEYS + 2][64];
    const char *sets[KEYS + 3] = { text[0], text[1], text[2],
                                   text[3], text[4], text[5] };

    snprintf(text[0], sizeof text[0], "law.preset=%s", law);
    snprintf(text[1], sizeof text[1], "products=[folds, knees]");
    for (int k = 0; k < KEYS; k++)
        snprintf(text[k + 2], sizeof text[0], "%s=%.17g", keys[k],
                 d->value[k][i]);
    scene_set(scene, sets);
}

/* As the study that keeps its branches, which do not lean, has it: where these
 * tell the number, within both bars. */
static void compare(const struct draws *d, int i, int n,
                    const struct quantity *q)
{
    const double off = fabs(d->number[n][i] - q->value);

    if (!quantity_exists(q)) {
        assert_string_equal(d->reason[n][i], q->reason);
        assert_true(isnan(d->number[n][i]) && isnan(d->error[n][i]));
        return;
    }
    CHECK(d->reason[n][i] == NULL &&
              (n < BRANCHED ? off <= d->error[n][i] + q->error
                            : off == 0.0 && d->error[n][i] == q->error),
          "%s at draw %d: %.17g +- %g (%s), alone %.17g +- %g", names[n], i,
          d->number[n][i], d->error[n][i],
          d->reason[n][i] ? d->reason[n][i] : "", q->value, q->error);
}

static void test_each_draw_is_the_study_of_its_scene(void **state)
{
    static const char *const laws[] = { "spinodal_gen", "dieterich_gen",
                                        "dieterich" };
    uint64_t rng = check_seed();
    struct draws *d = calloc(1, sizeof *d);

    (void) state;
    for (size_t l = 0; l < sizeof laws / sizeof *laws; l++) {
        struct scene scene, one;
        struct batch b;
        draw(d, &rng);
        open_batch(&b, &scene, laws[l]);
        run(&b, d, 2);
        for (int i = 0; i < DRAWS; i += 7) {
            static struct study s;
            struct fault why;
            scene_of_draw(&one, laws[l], d, i);
            assert_int_equal(study_run(&s, &one, NULL, &why), STATUS_OK);
            const struct critical_numbers *c = &s.slider.critical;
            const struct quantity *q[NUMBERS] = { &c->v_plus, &c->v_minus,
                                                  &c->x_excess,
                                                  &s.saddle_numbers.v,
                                                  &s.folds.alpha_cM };
            for (int n = 0; n < NUMBERS; n++)
                compare(d, i, n, q[n]);
            study_free(&s);
            scene_free(&one);
        }
        batch_free(&b);
        scene_free(&scene);
    }
    free(d);
}

/* The state that a push leads to. */
static struct push_state state_of(const struct push *p,
                                  const struct scene_push *push)
{
    if (!push->from_creep)
        return (struct push_state){ push->v, push->psi };
    return (struct push_state){ p->slider.steady[0].v.value + push->v,
                                p->slider.steady[0].psi.value };
}

static void test_fates_are_those_of_push(void **state)
{
    uint64_t rng = check_seed();
    struct draws *d = calloc(1, sizeof *d);
    size_t found[FATES] = { 0 }, none = 0;
    struct scene scene, one;
    struct batch b;

    (void) state;
    draw(d, &rng);
    open_batch(&b, &scene, "spinodal_gen");
    assert_int_equal(batch_push(&b, pushes, PUSHES), STATUS_OK);
    run(&b, d, 0);
    for (int i = 0; i < DRAWS; i += 8) {
        struct push p;
        struct fault why;
        scene_of_draw(&one, "spinodal_gen", d, i);
        assert_int_equal(push_init(&p, &one, NULL, &why), STATUS_OK);
        for (int k = 0; k < PUSHES; k++) {
            struct push_answer a;
            if (d->fate[k][i] < 0) {
                none++;
                assert_true(pushes[k].from_creep);
                continue;
            }
            found[d->fate[k][i]]++;
            assert_int_equal(push_find(&p, state_of(&p, &pushes[k]), NULL, &a),
                             STATUS_OK);
            assert_int_equal(d->fate[k][i], a.fate);
        }
        push_free(&p);
        scene_free(&one);
    }
    CHECK(found[FATE_CREEP] > 5 && found[FATE_SLIDING] > 5,
          "%zu creep, %zu slide", found[FATE_CREEP], found[FATE_SLIDING]);
    CHECK(none > 0, "no draw is without a creep state");
    batch_free(&b);
    scene_free(&scene);
    free(d);
}

/* Those that a curve of their own tells, too. */
static void test_fates_are_the_same_without_numbers(void **state)
{
    static const char *const without[] = { "saddle_v" };
    uint64_t rng = check_seed();
    struct draws *d = calloc(1, sizeof *d), *by = calloc(1, sizeof *by);
    struct scene scene, same;
    struct batch b, c;
    struct fault why;

    (void) state;
    draw(d, &rng);
    rng = check_seed();
    draw(by, &rng);
    open_batch(&b, &scene, "dieterich_gen");
    assert_int_equal(batch_push(&b, pushes, PUSHES), STATUS_OK);
    run(&b, d, 2);
    scene_set(&same, (const char *const[]){ "law.preset=dieterich_gen",
                                            "slope.alpha=0.34", NULL });
    assert_int_equal(batch_init(&c, &same, keys, KEYS, without, 1, &why),
                     STATUS_OK);
    assert_int_equal(batch_push(&c, pushes, PUSHES), STATUS_OK);
    run(&c, by, 2);
    assert_memory_equal(d->fate, by->fate, sizeof d->fate);
    batch_free(&b);
    batch_free(&c);
    scene_free(&scene);
    scene_free(&same);
    free(d);
    free(by);
}

static void test_threads_and_company_change_no_bit(void **state)
{
    uint64_t rng = check_seed();
    struct draws *one = calloc(1, sizeof *one), *two = calloc(1, sizeof *two);
    struct scene scene;
    struct batch b;

    (void) state;
    draw(one, &rng);
    rng = check_seed();
    draw(two, &rng);
    open_batch(&b, &scene, "spinodal_gen");
    run(&b, one, 1);
    run(&b, two, 3);
    assert_memory_equal(one->number, two->number, sizeof one->number);
    assert_memory_equal(one->error, two->error, sizeof one->error);
    /* draw 7 by itself */
    double alone;
    const double *column[KEYS];
    struct batch_column out[NUMBERS] = { { &alone, NULL, NULL } };
    for (int k = 0; k < KEYS; k++)
        column[k] = &one->value[k][7];
    assert_int_equal(batch_run(&b, 1, column, 0, NULL, out, NULL), STATUS_OK);
    assert_memory_equal(&alone, &one->number[0][7], sizeof alone);
    batch_free(&b);
    scene_free(&scene);
    free(one);
    free(two);
}

static void test_values_that_are_not_allowed_are_a_reason(void **state)
{
    static const double wrong[KEYS] = { -0.03, NAN, 1.6, INFINITY };
    uint64_t rng = check_seed();
    struct draws *d = calloc(1, sizeof *d);
    struct scene scene;
    struct batch b;

    (void) state;
    draw(d, &rng);
    for (int k = 0; k < KEYS; k++)
        d->value[k][10 * k] = wrong[k];
    open_batch(&b, &scene, "spinodal_gen");
    run(&b, d, 0);
    for (int k = 0; k < KEYS; k++)
        for (int n = 0; n < NUMBERS; n++)
            CHECK(d->reason[n][10 * k] && strstr(d->reason[n][10 * k], keys[k]),
                  "%s = %g: %s", keys[k], wrong[k],
                  d->reason[n][10 * k] ? d->reason[n][10 * k] : "a number");
    assert_null(d->reason[3][1]); /* the next draw is not touched */
    batch_free(&b);
    scene_free(&scene);
    free(d);
}

static void test_what_does_not_exist_is_named(void **state)
{
    static const struct {
        const char *key[2], *name;
    } wrong[] = {
        { { "material.q", NULL }, "v_plus" },
        { { "window.v", NULL }, "v_plus" },
        { { "material.a", "material.a" }, "v_plus" },
        { { "slope.alpha", "slope.tan_alpha" }, "v_plus" },
        { { "material.a", NULL }, "v_plsu" },
        { { "material.a", NULL }, "upper_end" },
    };
    const char *const sets[] = { "law.preset=dieterich_gen", "slope.alpha=0.34",
                                 NULL };
    struct scene scene;
    struct batch b;
    struct fault why;

    (void) state;
    scene_set(&scene, sets);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        const size_t n = wrong[i].key[1] ? 2 : 1;
        CHECK(batch_init(&b, &scene, wrong[i].key, n, &wrong[i].name, 1,
                         &why) == STATUS_BAD_ARGUMENT,
              "case %zu", i);
        const char *what = i < 4 ? wrong[i].key[n - 1] : wrong[i].name;
        CHECK(strstr(why.text, what), "%s", why.text);
        batch_free(&b);
    }
    scene_free(&scene);
}

/* Asks for an end at once. */
static int refuse(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    (void) ctx, (void) stage, (void) done, (void) total;
    return 1;
}

static void test_the_monitor_ends_it(void **state)
{
    const struct monitor monitor = { refuse, NULL };
    uint64_t rng = check_seed();
    struct draws *d = calloc(1, sizeof *d);
    struct scene scene;
    struct batch b;

    (void) state;
    draw(d, &rng);
    open_batch(&b, &scene, "spinodal_gen");
    assert_int_equal(batch_run(&b, DRAWS, d->column, 1, &monitor, d->out, NULL),
                     STATUS_STOPPED);
    batch_free(&b);
    scene_free(&scene);
    free(d);
}

static void test_every_allocation_may_fail(void **state)
{
    const char *const sets[] = { "law.preset=dieterich_gen", "slope.alpha=0.34",
                                 NULL };
    uint64_t rng = check_seed();
    struct draws *d = calloc(1, sizeof *d);
    enum status s = STATUS_NO_MEMORY;
    struct scene scene;

    (void) state;
    draw(d, &rng);
    scene_set(&scene, sets);
    for (long k = 0; s != STATUS_OK; k++) {
        struct batch b;
        struct fault why;
        fault_alloc_at(k);
        s = batch_init(&b, &scene, keys, KEYS, names, NUMBERS, &why);
        if (s == STATUS_OK) {
            assert_int_equal(batch_push(&b, pushes, PUSHES), STATUS_OK);
            s = batch_run(&b, 1, d->column, 1, NULL, d->out, d->fates);
        }
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%s", status_text(s));
        batch_free(&b);
    }
    scene_free(&scene);
    free(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_draw_is_the_study_of_its_scene),
        cmocka_unit_test(test_fates_are_those_of_push),
        cmocka_unit_test(test_fates_are_the_same_without_numbers),
        cmocka_unit_test(test_threads_and_company_change_no_bit),
        cmocka_unit_test(test_values_that_are_not_allowed_are_a_reason),
        cmocka_unit_test(test_what_does_not_exist_is_named),
        cmocka_unit_test(test_the_monitor_ends_it),
        cmocka_unit_test(test_every_allocation_may_fail),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
