/* A run in numbers of one shape, against the run itself. */
#include "start_numbers.h"

#include <string.h>

#include "asked.h"

/* A block on spinodal_gen's slope; free with asked_free. */
static void slope(struct asked *a, const char *law, const char *alpha)
{
    a->sets = 0;
    ask(a, "law.preset", law);
    ask(a, "slope.alpha", alpha);
    ask(a, "products", "[equilibria, knees]");
    asked_run(a);
}

static bool same(const struct quantity *a, const struct quantity *b)
{
    return quantity_exists(a) == quantity_exists(b) &&
           (!quantity_exists(a) ||
            (a->value == b->value && a->error == b->error));
}

static bool same_event(const struct transient_event *a,
                       const struct transient_event *b)
{
    return a->what == b->what && same(&a->time, &b->time) &&
           same(&a->slip, &b->slip) && same(&a->v, &b->v) &&
           same(&a->psi, &b->psi) && same(&a->mu, &b->mu);
}

/* The first event of a kind, and of a level if it is not NULL. */
static const struct transient_event *first_of(const struct transient *t,
                                              enum moment what,
                                              const double *level)
{
    for (size_t i = 0; i < t->events; i++)
        if (t->event[i].what == (int8_t) what &&
            (level == NULL || t->event[i].level == *level))
            return &t->event[i];
    return NULL;
}

static void check_event(const struct transient *t,
                        const struct transient_event *found, enum moment what,
                        const double *level, size_t *there)
{
    const struct transient_event *e = first_of(t, what, level);

    if (e) {
        CHECK(same_event(found, e), "%s at %g", moment_names[what],
              e->time.value);
        ++*there;
        return;
    }
    CHECK(!quantity_exists(&found->time) && !quantity_exists(&found->mu) &&
              strcmp(found->slip.reason, "it does not happen in this run") == 0,
          "%s at %g", moment_names[what], found->time.value);
}

static void every_number_is_that_of_the_run(void **state)
{
    static const struct {
        const char *law, *alpha;
        struct scene_start start;
    } run[] = {
        { "spinodal_gen", "0.34", { 1e3, 1.0 } },
        { "spinodal_gen", "0.34", { 1e4, 1.0 } },
        { "dieterich_gen", "0.34", { 0.01, 10.0 } },
        { "spinodal_gen", "0.4", { 0.1, 100.0 } },
    };
    size_t there = 0, all = 0;

    (void) state;
    for (size_t i = 0; i < sizeof run / sizeof *run; i++) {
        static struct asked a;
        struct start_numbers n;
        struct transient t;
        slope(&a, run[i].law, run[i].alpha);
        const struct transient_options o = transient_defaults(&a.scene);
        assert_int_equal(start_numbers_find(&a.study, run[i].start, NULL, &n),
                         STATUS_OK);
        assert_int_equal(
            transient_find(&a.study.slider, run[i].start, &o, NULL, &t),
            STATUS_OK);
        assert_int_equal(n.sum.fate, t.sum.fate);
        assert_int_equal(n.sum.end, t.sum.end);
        assert_true(same(&n.sum.time, &t.sum.time) &&
                    same(&n.sum.slip, &t.sum.slip) &&
                    same(&n.sum.mu_mean, &t.sum.mu_mean));
        for (int k = 0; k < PHASES; k++)
            assert_true(same(&n.phase[k].start_time, &t.phase[k].start_time) &&
                        same(&n.phase[k].end_slip, &t.phase[k].end_slip));
        for (int k = 0; k < MOMENTS; k++)
            check_event(&t, &n.first[k], (enum moment) k, NULL, &there);
        for (size_t k = 0; k < o.levels; k++) {
            const double *level = &o.level[k].value;
            check_event(&t, &n.nears[k], MOMENT_MU_NEARS, level, &there);
            check_event(&t, &n.leaves[k], MOMENT_MU_LEAVES, level, &there);
        }
        all += MOMENTS + 2 * o.levels;
        transient_free(&t);
        asked_free(&a);
    }
    CHECK(there > all / 4 && there < all, "%zu of %zu", there, all);
}

static void a_start_outside_the_domain_is_an_error(void **state)
{
    static struct asked a;
    struct start_numbers n;

    (void) state;
    slope(&a, "spinodal_gen", "0.34");
    assert_int_equal(start_numbers_find(&a.study,
                                        (struct scene_start){ 1e305, 1.0 },
                                        NULL, &n),
                     STATUS_BAD_ARGUMENT);
    asked_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_is_that_of_the_run),
        cmocka_unit_test(a_start_outside_the_domain_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
