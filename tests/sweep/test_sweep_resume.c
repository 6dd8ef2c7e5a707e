/* Sweeps that are stopped and taken up again. */
#include <unistd.h>

#include "own_folder.h"
#include "sweeps.h"

static const struct sweep_options plainly = { .journal = NULL };

#define LAW "law.preset=spinodal_gen"
#define ALL "products=[equilibria, folds, knees, estimates]"

static const char *const slopes[] = {
    LAW,
    ALL,
    "sweep={key: slope.alpha, from: 0.28, to: 0.4, points: 240}",
    NULL,
};

struct patience {
    uint64_t left;
};

static int lose_patience(void *ctx, const char *stage, uint64_t done,
                         uint64_t total)
{
    struct patience *p = ctx;

    (void) stage, (void) done, (void) total;
    return p->left-- == 0;
}

/* A run that is stopped after some points; the status. */
static enum status run_some(struct swept *w, const char *const sets[],
                            const struct sweep_options *o, uint64_t points,
                            struct fault *why)
{
    struct patience p = { points };
    const struct monitor monitor = { lose_patience, &p };

    scene_set(&w->scene, sets);
    const enum status status = sweep_run(&w->s, &w->scene, o, &monitor, why);
    if (status != STATUS_OK)
        scene_free(&w->scene);
    return status;
}

static void what_was_computed_is_not_computed_again(void **state)
{
    const char *path = own_path("a.part");
    const struct sweep_options o = { .journal = path,
                                     .resume = true,
                                     .version = "1" };
    struct swept whole, part;
    struct fault why;
    size_t taken = 0;

    (void) state;
    sweep_of(&whole, slopes, &plainly);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(run_some(&part, slopes, &o, 9, &why), STATUS_STOPPED);
        assert_string_equal(why.text, "interrupted");
    }
    assert_int_equal(run_some(&part, slopes, &o, 1000, &why), STATUS_OK);
    taken = part.s.taken;
    CHECK(taken >= 40 && taken < 240, "%zu points", taken);
    sweeps_are_the_same(&whole.s, &part.s);
    swept_free(&part);
    assert_int_equal(run_some(&part, slopes, &o, 1000, &why), STATUS_OK);
    assert_int_equal(part.s.taken, 240);
    sweeps_are_the_same(&whole.s, &part.s);
    swept_free(&part);
    assert_int_equal(access(path, F_OK), 0);
    sweep_forget(path);
    assert_int_equal(own_folder_entries(), 0);
    swept_free(&whole);
}

static void a_side_file_cut_anywhere_is_taken_up(void **state)
{
    static const char *const sets[] = {
        LAW, "products=[knees]",
        "sweep={key: slope.alpha, from: 0.28, to: 0.4, points: 5, refine: 0.5}",
        NULL
    };
    const char *path = own_path("a.part");
    const struct sweep_options o = {
        .journal = path,
        .resume = true,
    };
    uint64_t seed = check_seed();
    struct swept whole, part;
    size_t size;

    (void) state;
    sweep_of(&whole, sets, &o);
    char *bytes = file_read(path, &size);
    for (int i = 0; i < 20; i++) {
        const size_t cut = (size_t) (check_bits(&seed) % size);
        file_write(path, bytes, cut);
        sweep_of(&part, sets, &o);
        assert_true(part.s.taken < whole.s.points);
        sweeps_are_the_same(&whole.s, &part.s);
        swept_free(&part);
    }
    free(bytes);
    swept_free(&whole);
}

/* The first row of the side file of one point, its code of `column` changed and
 * its checksum right. */
static void change_code(const char *path, const struct sweep *s,
                        const char *column, int8_t code)
{
    const size_t row = s->rows.width * sizeof(double);
    const int k = sweep_find(s, column);
    size_t size, at = 32; /* behind the head */
    char *bytes = file_read(path, &size);
    uint64_t key, head[2], sum;

    assert_true(k >= 0);
    memcpy(&key, bytes + 8, sizeof key);
    memcpy(head, bytes + at, 16);
    while (head[1] != row) { /* sentences */
        at += 24 + head[1];
        memcpy(head, bytes + at, 16);
    }
    const size_t codes = at + 16 + (3 + s->rows.reals * s->rows.entries) * 8;
    bytes[codes + s->columns.at[k].first] = (char) code;
    sum = sweep_journal_sum(sweep_journal_sum(key, bytes + at, 16),
                            bytes + at + 16, row);
    memcpy(bytes + at + 16 + row, &sum, sizeof sum);
    file_write(path, bytes, size);
    free(bytes);
}

/* Nobody wrote it so, but nobody may be led astray either. */
static void a_row_whose_codes_mean_nothing_is_computed_again(void **state)
{
    static const char *const one[] = {
        LAW, "products=[knees]", "sweep={key: slope.alpha, values: [0.28]}",
        NULL
    };
    static const struct {
        const char *column;
        int8_t code;
        size_t taken;
    } change[] = {
        { "v_plus", REASON_ABSENT, 1 },
        { "v_plus", 100, 0 },
        { "v_plus", -1, 0 },
        { "equilibria_0_type", 0, 1 },
        { "equilibria_0_type", -1, 1 },
        { "equilibria_0_type", 77, 0 },
        { "upper_end", -2, 0 },
    };
    const char *path = own_path("a.part");
    const struct sweep_options o = { .journal = path,
                                     .resume = true,
                                     .version = "1" };

    (void) state;
    for (size_t i = 0; i < sizeof change / sizeof *change; i++) {
        struct swept w, again;
        sweep_forget(path);
        sweep_of(&w, one, &o);
        change_code(path, &w.s, change[i].column, change[i].code);
        sweep_of(&again, one, &o);
        CHECK(again.s.taken == change[i].taken, "%s = %d: %zu rows taken",
              change[i].column, change[i].code, again.s.taken);
        if (again.s.taken == 0)
            sweeps_are_the_same(&w.s, &again.s);
        swept_free(&again);
        swept_free(&w);
    }
}

static void without_resume_a_side_file_is_replaced(void **state)
{
    const struct sweep_options o = { .journal = own_path("a.part"),
                                     .resume = false,
                                     .version = "1" };
    struct swept w;
    struct fault why;

    (void) state;
    assert_int_equal(run_some(&w, slopes, &o, 9, &why), STATUS_STOPPED);
    assert_int_equal(run_some(&w, slopes, &o, 1000, &why), STATUS_OK);
    assert_true(w.s.replaced);
    assert_int_equal(w.s.taken, 0);
    swept_free(&w);
}

static void a_side_file_of_another_scene_or_version_is_refused(void **state)
{
    static const char *const other[] = {
        LAW, ALL, "sweep={key: slope.alpha, from: 0.28, to: 0.4, points: 61}",
        NULL
    };
    const char *path = own_path("a.part");
    const struct sweep_options one = { .journal = path,
                                       .resume = true,
                                       .version = "1" };
    const struct sweep_options two = { .journal = path,
                                       .resume = true,
                                       .version = "2" };
    struct swept w;
    struct fault why;

    (void) state;
    assert_int_equal(run_some(&w, slopes, &one, 9, &why), STATUS_STOPPED);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(
            run_some(&w, i ? slopes : other, i ? &two : &one, 9, &why),
            STATUS_BAD_SCENE);
        assert_non_null(
            strstr(why.text, "a.part: of another scene or version"));
        assert_null(w.s.columns.at);
    }
    assert_int_equal(run_some(&w, slopes, &one, 1000, &why), STATUS_OK);
    assert_true(w.s.taken >= 10);
    swept_free(&w);
}

static void where_the_side_file_goes_does_not_matter_to_its_key(void **state)
{
    static const char *const here[] = {
        LAW, ALL, "sweep={key: slope.alpha, values: [0.33, 0.34, 0.35]}",
        "output.hdf5=a.h5", NULL
    };
    static const char *const there[] = {
        LAW, ALL, "sweep={key: slope.alpha, values: [0.33, 0.34, 0.35]}",
        "output.figure=b.svg", NULL
    };
    const struct sweep_options o = { .journal = own_path("a.part"),
                                     .resume = true,
                                     .version = "1" };
    struct swept w;

    (void) state;
    sweep_of(&w, here, &o);
    swept_free(&w);
    sweep_of(&w, there, &o);
    assert_int_equal(w.s.taken, 3);
    swept_free(&w);
}

static void a_side_file_that_cannot_be_is_an_error(void **state)
{
    const struct sweep_options o = { .journal = own_path("none/a.part"),
                                     .resume = false };
    struct swept w;
    struct fault why;

    (void) state;
    assert_int_equal(run_some(&w, slopes, &o, 9, &why), STATUS_IO);
    assert_non_null(strstr(why.text, "none/a.part: No such file"));
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

/* Every one of `of` points, from the k-th on. */
struct stride {
    size_t at, of;
};

static size_t next_of(void *ctx, size_t count)
{
    struct stride *s = ctx;
    const size_t at = s->at < count ? s->at : count;

    s->at += s->of;
    return at;
}

enum { SHARES = 3 };

/* The points of share k into its side file; how many are missing. */
static size_t run_share(const char *const sets[], size_t k, const char *path)
{
    struct stride stride = { k, SHARES };
    const struct sweep_share share = { next_of, &stride };
    const struct sweep_options o = {
        .journal = path, .resume = true, .version = "1", .share = &share
    };
    struct swept part;

    sweep_of(&part, sets, &o);
    const size_t missing = part.s.missing;
    swept_free(&part);
    return missing;
}

static void shares_make_the_same_sweep_as_one_run(void **state)
{
    static const char *const sets[] = {
        LAW, "products=[knees, basins, margin]",
        "basins={cells: [3, 2], audit: 0}",
        "sweep={key: slope.alpha, from: 0.2, to: 0.4, points: 10, refine: 0.2}",
        NULL
    };
    const char *const other[SHARES] = { own_path("a"), own_path("b"),
                                        own_path("c") };
    const char *path = own_path("a.part");
    const struct sweep_options o = { .journal = path,
                                     .version = "1",
                                     .other = other,
                                     .others = SHARES,
                                     .join = true };
    struct swept whole, joined;

    (void) state;
    for (size_t k = 0; k < SHARES; k++)
        for (int again = 0; again < 2; again++)
            assert_int_equal(run_share(sets, k, other[k]), k ? 7 : 6);
    sweep_of(&joined, sets, &o);
    assert_int_equal(joined.s.missing, 0);
    assert_int_equal(joined.s.taken, 10);
    sweep_of(&whole, sets,
             &(struct sweep_options){ .journal = own_path("w.part") });
    sweeps_are_the_same(&whole.s, &joined.s);
    swept_free(&whole);
    swept_free(&joined);
}

static void a_side_file_of_another_sweep_is_no_share(void **state)
{
    const char *const other[] = { own_path("a") };
    const struct sweep_options o = {
        .journal = own_path("b"), .version = "2", .other = other, .others = 1
    };
    struct swept part;
    struct fault why;

    (void) state;
    (void) run_share(slopes, 0, other[0]);
    assert_int_equal(run_some(&part, slopes, &o, 1000, &why), STATUS_BAD_SCENE);
    assert_non_null(strstr(why.text, "of another scene or version"));
    (void) unlink(other[0]);
    assert_int_equal(run_some(&part, slopes, &o, 1000, &why), STATUS_IO);
    assert_non_null(strstr(why.text, "No such file"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(what_was_computed_is_not_computed_again),
        IN_FOLDER(a_side_file_cut_anywhere_is_taken_up),
        IN_FOLDER(a_row_whose_codes_mean_nothing_is_computed_again),
        IN_FOLDER(without_resume_a_side_file_is_replaced),
        IN_FOLDER(a_side_file_of_another_scene_or_version_is_refused),
        IN_FOLDER(where_the_side_file_goes_does_not_matter_to_its_key),
        IN_FOLDER(a_side_file_that_cannot_be_is_an_error),
        IN_FOLDER(shares_make_the_same_sweep_as_one_run),
        IN_FOLDER(a_side_file_of_another_sweep_is_no_share),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
