/* Names and instances of results (lib/results/result.h). */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "result_number.h"

static bool is_named(const char *pattern, size_t k, const char *field,
                     const char *expected)
{
    char name[RESULT_NAME];

    result_name(pattern, k, field, name);
    return strcmp(name, expected) == 0;
}

static void numbers_and_words_stand_for_the_instance(void **state)
{
    (void) state;
    assert_true(
        is_named("/trajectory_K/events", 12, NULL, "/trajectory_12/events"));
    assert_true(
        is_named("trajectories[K].events", 0, NULL, "trajectories[0].events"));
    assert_true(is_named("/a_{up,down}", 0, NULL, "/a_up"));
    assert_true(is_named("/a_{up,down}", 1, NULL, "/a_down"));
    assert_true(is_named("{x,yy,z}b", 1, NULL, "yyb"));
    assert_true(is_named("fraction_*_{p,q}", 1, "log", "fraction_log_q"));
    assert_true(is_named("", 3, "v", ""));
}

static void a_letter_of_a_word_is_no_number(void **state)
{
    (void) state;
    assert_true(is_named("*", 7, "K", "K"));
    assert_true(is_named("/Kato/KK_1", 7, NULL, "/Kato/KK_1"));
}

static void what_is_too_long_is_cut(void **state)
{
    char pattern[2 * RESULT_NAME], name[RESULT_NAME];

    (void) state;
    memset(pattern, 'x', sizeof pattern);
    pattern[sizeof pattern - 1] = '\0';
    result_name(pattern, 0, NULL, name);
    assert_int_equal(strlen(name), RESULT_NAME - 1);
}

struct number {
    double x;
};
static const struct record_field number_fields[] = {
    FIELD(number, REAL, x, "1", "a number"),
};
static const struct record_type record_number =
    RECORD_TYPE("number", "numbers", number_fields, number);

static size_t five(const void *run)
{
    (void) run;
    return 5;
}

static enum status view_made(const void *run, size_t k, struct result_view *out)
{
    struct number *made = malloc(sizeof *made);

    (void) run;
    if (made == NULL)
        return STATUS_NO_MEMORY;
    made->x = (double) k;
    out->owned = made;
    return result_lend(out, made, 1);
}

RESULT_VIEW(view_there, number, &s[k], 1)

static void instances_are_words_unless_they_are_counted(void **state)
{
    const struct result none = { .path = "/a" };
    const struct result words = { .path = "/a_{b,c,d}" };
    const struct result members = { .path = "/a", .member = "*_{b,c}" };
    const struct result counted = { .path = "/a_K", .count = five };

    (void) state;
    assert_int_equal(result_count(&none, NULL), 1);
    assert_int_equal(result_count(&words, NULL), 3);
    assert_int_equal(result_count(&members, NULL), 2);
    assert_int_equal(result_count(&counted, NULL), 5);
}

static void views_lend_and_what_they_made_goes(void **state)
{
    const struct number run[] = { { 1.0 }, { 2.0 } };
    const struct result there = { .type = &record_number, .view = view_there };
    const struct result made = { .type = &record_number, .view = view_made };
    const struct result nothing = { .type = &record_number };
    const struct results all = { .run = run };
    struct result_view v;

    (void) state;
    assert_int_equal(result_open(&all, &there, 1, &v), STATUS_OK);
    assert_true(v.here && v.records.at == &run[1] && v.records.count == 1 &&
                v.records.type == &record_number && v.owned == NULL);
    result_close(&v);
    assert_int_equal(result_open(&all, &made, 3, &v), STATUS_OK);
    assert_true(v.here && ((const struct number *) v.records.at)->x == 3.0);
    result_close(&v);
    result_close(&v);
    assert_false(v.here);
    assert_int_equal(result_open(&all, &nothing, 0, &v), STATUS_OK);
    assert_false(v.here);
}

static enum status make_number(const void *run, void *record)
{
    ((struct number *) record)->x = 2.0 * *(const double *) run;
    return STATUS_OK;
}

static void what_is_made_is_made_once_and_kept(void **state)
{
    static const struct result table[] = {
        { .type = &record_number, .make = make_number, .needs = 1 },
        { .type = &record_number, .make = make_number, .needs = 2 },
        { .type = &record_number, .make = make_number, .needs = 4 },
        { .path = NULL }
    };
    static const struct result *const tables[] = { table, NULL };
    double run = 1.0;
    struct result_keep kept = { .at = NULL };
    const struct results all = {
        .table = tables, .run = &run, .kept = &kept, .asked = 3
    };
    struct result_view v;

    (void) state;
    assert_int_equal(result_keep(&kept, &all, 1), STATUS_OK);
    run = 5.0;
    assert_int_equal(result_keep(&kept, &all, ~(uint64_t) 0), STATUS_OK);
    assert_int_equal(kept.count, 2);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(result_open(&all, &table[i], 0, &v), STATUS_OK);
        assert_true(v.here == (i < 2));
        if (v.here)
            assert_true(((const struct number *) v.records.at)->x ==
                        (i ? 10.0 : 2.0));
        result_close(&v);
    }
    result_keep_free(&kept);
    result_keep_free(&kept);
}

static void what_nobody_asked_for_is_not_asked(void **state)
{
    const struct results all = { .asked = 6 };

    (void) state;
    assert_true(result_asked(&(struct result){ .needs = 0 }, &all));
    assert_true(result_asked(&(struct result){ .needs = 2 }, &all));
    assert_true(result_asked(&(struct result){ .needs = 5 }, &all));
    assert_false(result_asked(&(struct result){ .needs = 9 }, &all));
}

/* ---- numbers that stand alone -------------------------------------------- */

struct pair {
    struct quantity q;
    int8_t code;
    double x;
};
static const char *const pair_words[] = { "low", "high", NULL };
static const struct record_field pair_fields[] = {
    FIELD(pair, QUANTITY, q, "1", "a number"),
    FIELD_CODE(pair, code, pair_words, "a word"),
    FIELD(pair, REAL, x, "1", "not by itself"),
};
static const struct record_type record_pair =
    RECORD_TYPE("pair", "pairs", pair_fields, pair);

static enum status view_pairs(const void *run, size_t k,
                              struct result_view *out)
{
    return result_lend(out, run, k == 0 ? 1 : 0);
}

static void numbers_stand_alone_by_name_and_row(void **state)
{
    static const struct result table[] = {
        { .name = "list[K].end",
          .type = &record_pair,
          .shape = RESULT_COLUMNS,
          .member = "{a,b}",
          .alone = 2,
          .fewer = "there are fewer",
          .view = view_pairs },
        { .name = "all", .type = &record_pair, .view = view_pairs },
        { .name = "later",
          .type = &record_pair,
          .needs = 2,
          .view = view_pairs },
        { .path = NULL }
    };
    static const struct result *const tables[] = { table, NULL };
    const struct pair pair = { quantity_of(2.0, 0.5), 1, 3.0 };
    const struct results all = { .table = tables, .run = &pair, .asked = 1 };
    struct result_numbers n;

    (void) state;
    assert_int_equal(result_numbers_init(&n, &all), STATUS_OK);
    assert_int_equal(n.count, 2 + 2 * 2 * 2);
    assert_string_equal(n.at[0].name, "all_q");
    assert_null(result_numbers_find(&n, "later_q"));
    assert_null(result_numbers_find(&n, "all_x"));
    const struct result_number *code = result_numbers_find(&n, "all_code");
    assert_int_equal(result_code(&all, code), 1);
    assert_true(result_quantity(&all, &n.at[0]).value == 2.0);
    for (size_t i = 2; i < n.count; i++) {
        const bool here = n.at[i].instance == 0 && n.at[i].row == 0;
        const struct quantity q = result_quantity(&all, &n.at[i]);
        if (n.at[i].field->kind == RECORD_CODE)
            assert_int_equal(result_code(&all, &n.at[i]), here ? 1 : -1);
        else
            assert_true(here ? q.value == 2.0
                             : strcmp(q.reason, "there are fewer") == 0);
    }
    assert_non_null(result_numbers_find(&n, "list_0_end_1_q"));
    result_numbers_free(&n);
    result_numbers_free(&n);
}

static void paths_sort_as_their_numbers_do(void **state)
{
    static const struct result r = { .path = "/trajectory_K/events" };
    static const struct {
        size_t k, n;
        const char *name;
    } wanted[] = { { 0, 1, "/trajectory_0/events" },
                   { 9, 10, "/trajectory_9/events" },
                   { 1, 11, "/trajectory_01/events" },
                   { 10, 11, "/trajectory_10/events" },
                   { 7, 1000, "/trajectory_007/events" },
                   { 7, 1001, "/trajectory_0007/events" } };
    char name[RESULT_NAME];

    (void) state;
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        result_path(&r, wanted[i].k, wanted[i].n, name);
        assert_string_equal(name, wanted[i].name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(paths_sort_as_their_numbers_do),
        cmocka_unit_test(numbers_and_words_stand_for_the_instance),
        cmocka_unit_test(a_letter_of_a_word_is_no_number),
        cmocka_unit_test(what_is_too_long_is_cut),
        cmocka_unit_test(instances_are_words_unless_they_are_counted),
        cmocka_unit_test(views_lend_and_what_they_made_goes),
        cmocka_unit_test(what_is_made_is_made_once_and_kept),
        cmocka_unit_test(what_nobody_asked_for_is_not_asked),
        cmocka_unit_test(numbers_stand_alone_by_name_and_row),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
