/* Slip, time and mean friction of many states, by the slow curve's table and
 * by whole orbits. */
#include "push.h"

#include <omp.h>

#include "pushed.h"

static bool is_same(const struct quantity *a, const struct quantity *b)
{
    return quantity_exists(a) ? a->value == b->value && a->error == b->error
                              : a->reason == b->reason;
}

static bool are_same(const struct push_answer *a, const struct push_answer *b)
{
    return a->fate == b->fate && is_same(&a->slip, &b->slip) &&
           is_same(&a->time, &b->time) && is_same(&a->mu_mean, &b->mu_mean) &&
           is_same(&a->v_kick, &b->v_kick) &&
           is_same(&a->psi_kick, &b->psi_kick);
}

/* 1 if it exists, else 0.  Whole orbits lose some that the table follows. */
static int compare(const struct quantity *whole, const struct quantity *table,
                   struct push_state at)
{
    if (!quantity_exists(whole)) {
        if (strstr(whole->reason, "too near the boundary"))
            return (int) quantity_exists(table);
        CHECK(table->reason && strcmp(table->reason, whole->reason) == 0,
              "(%.17g, %.17g): %s, not %s", at.v, at.psi, table->reason,
              whole->reason);
        return 0;
    }
    CHECK(fabs(table->value - whole->value) <= table->error + whole->error,
          "(%.17g, %.17g): %.17g +- %g, not %.17g +- %g", at.v, at.psi,
          table->value, table->error, whole->value, whole->error);
    return 1;
}

/* How many of their numbers exist; n <= 64. */
static int compare_some(struct pushed *p, const struct push_state at[], int n)
{
    struct push_answer whole[64], table[64];
    int numbers = 0;

    assert_int_equal(push_find_all(&p->push, at, (size_t) n, NULL, whole),
                     STATUS_OK);
    assert_int_equal(push_tabulate(&p->push, NULL), STATUS_OK);
    assert_int_equal(push_find_all(&p->push, at, (size_t) n, NULL, table),
                     STATUS_OK);
    for (int i = 0; i < n; i++) {
        assert_int_equal(table[i].fate, whole[i].fate);
        assert_true(is_same(&table[i].v_kick, &whole[i].v_kick));
        assert_true(is_same(&table[i].psi_kick, &whole[i].psi_kick));
        numbers += compare(&whole[i].slip, &table[i].slip, at[i]) +
                   compare(&whole[i].time, &table[i].time, at[i]) +
                   compare(&whole[i].mu_mean, &table[i].mu_mean, at[i]);
    }
    return numbers;
}

static void the_table_says_what_whole_orbits_say(void **state)
{
    static const struct {
        const char *law;
        bool always; /* states come to an end of some slip in some time */
    } all[] = { { "spinodal_gen", true }, { "dieterich_gen", false },
                { "spinodal", true },     { "perrin", false },
                { "ruina", false },       { "dieterich", false } };
    enum { COUNT = 24 };
    struct push_state at[COUNT];
    uint64_t rng = check_seed();

    (void) state;
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        struct pushed p;
        push_make(&p, all[k].law, "0.34");
        const bool is_log = p.push.slider.plane.system.axis[1].is_log;
        for (int i = 0; i < COUNT; i++) {
            const double y = check_uniform(&rng, -3.0, 4.0);
            at[i].v = exp(check_uniform(&rng, -6.0, 10.0));
            at[i].psi = is_log ? exp(y) : y;
        }
        const int numbers = compare_some(&p, at, COUNT);
        CHECK(all[k].always ? numbers == 3 * COUNT : numbers < 3 * COUNT,
              "%s: %d numbers", all[k].law, numbers);
        pushed_free(&p);
    }
}

/* The others are beside the boundary. */
static void nineteen_of_twenty_bars_of_the_table_keep_the_promise(void **state)
{
    enum { COUNT = 400 };
    struct push_state at[COUNT];
    struct push_answer a[COUNT];
    uint64_t rng = check_seed();
    struct pushed p;
    int narrow = 0;

    (void) state;
    push_make(&p, "spinodal_gen", "0.34");
    for (int i = 0; i < COUNT; i++)
        at[i] = (struct push_state){ exp(check_uniform(&rng, -6.0, 10.0)),
                                     exp(check_uniform(&rng, -3.0, 4.0)) };
    assert_int_equal(push_tabulate(&p.push, NULL), STATUS_OK);
    assert_int_equal(push_find_all(&p.push, at, COUNT, NULL, a), STATUS_OK);
    for (int i = 0; i < COUNT; i++)
        narrow += a[i].slip.error <= 1e-9 * a[i].slip.value &&
                  a[i].time.error <= 1e-9 * a[i].time.value &&
                  a[i].mu_mean.error <= 1e-9 * a[i].mu_mean.value;
    CHECK(narrow >= COUNT - COUNT / 20, "%d of %d", narrow, COUNT);
    pushed_free(&p);
}

/* Whether 100 states get the answers that each gets alone, in the order of the
 * states, on one thread and on two. */
static void check_many(const struct pushed *p)
{
    enum { COUNT = 100 };
    struct push_state at[COUNT];
    struct push_answer out[COUNT], two[COUNT];
    uint64_t rng = check_seed();

    for (int i = 0; i < COUNT; i++)
        at[i] = (struct push_state){ exp(check_uniform(&rng, 0.0, 9.0)),
                                     exp(check_uniform(&rng, 0.0, 4.0)) };
    omp_set_num_threads(1);
    assert_int_equal(push_find_all(&p->push, at, COUNT, NULL, out), STATUS_OK);
    omp_set_num_threads(2);
    assert_int_equal(push_find_all(&p->push, at, COUNT, NULL, two), STATUS_OK);
    for (int i = 0; i < COUNT; i++)
        assert_true(are_same(&out[i], &two[i]));
    for (int i = 0; i < COUNT; i += 7) {
        const struct push_answer a = answer(p, at[i].v, at[i].psi);
        assert_true(are_same(&out[i], &a));
    }
}

static void many_states_get_the_answers_of_each(void **state)
{
    struct pushed p;

    (void) state;
    push_make(&p, "spinodal_gen", "0.34");
    check_many(&p);
    assert_int_equal(push_tabulate(&p.push, NULL), STATUS_OK);
    check_many(&p);
    pushed_free(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_says_what_whole_orbits_say),
        cmocka_unit_test(nineteen_of_twenty_bars_of_the_table_keep_the_promise),
        cmocka_unit_test(many_states_get_the_answers_of_each),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
