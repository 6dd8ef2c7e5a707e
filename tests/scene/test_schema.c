/* The table of keys: each is read from files and from overrides alike. */
#include "schema.h"

#include <string.h>

#include "check.h"
#include "scenes.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* ---- every key, twice ---------------------------------------------------- */

#define LAW      "law.preset=dieterich_gen\n"
#define SPINODAL "law.preset=spinodal_gen\n"
#define SLOPE    "slope.alpha=0.3\n"
#define KEY      "sweep.key=slope.alpha\n"
#define VALUES   "sweep.values=[0.1, 0.2]\n"
#define THETA    "law.theta=ln_psi\n"
#define PSI_SS   "law.psi_ss=inverse\n"
#define TIME     "law.timescale=slip\n"
#define KINETICS "law.kinetics=sinh\n"

/* A key with two values that differ, and what else makes up a scene. */
static const struct {
    const char *path, *value, *other, *rest;
} keys[] = {
    { "title", "A slope", "a slope", LAW SLOPE },

    { "law.preset", "ruina", "perrin", SLOPE },
    { "law.theta", "psi", "ln_c_psi", PSI_SS TIME KINETICS SLOPE },
    { "law.psi_ss", "inverse", "spinodal", THETA TIME KINETICS SLOPE },
    { "law.timescale", "slip", "slip45", THETA PSI_SS KINETICS SLOPE },
    { "law.kinetics", "linear", "sinh", THETA PSI_SS TIME SLOPE },
    { "law.T", "1/v", "2/v", THETA PSI_SS SLOPE },
    { "law.K", "sinh(d)", "d", THETA PSI_SS TIME SLOPE },
    { "law.rate", "1 - v*psi", "psi_ss - psi", THETA PSI_SS SLOPE },
    { "law.mu", "a*ln(v) + b*psi", "a*ln(v)", PSI_SS TIME KINETICS SLOPE },
    { "law.state", "real", "positive", THETA PSI_SS TIME KINETICS SLOPE },
    { "law.friction", "log", "asinh", LAW SLOPE },

    { "material.preset", "bristol_board", NULL, LAW SLOPE },
    { "material.mu_star", "-0.3", "0.369", LAW SLOPE },
    { "material.a", "0.02", "0.0349", LAW SLOPE },
    { "material.b", "0.02", "0.0489", LAW SLOPE },
    { "material.L", "1e-3", "0.9e-6", LAW SLOPE },
    { "material.V_star", "1e-3", "1e-6", LAW SLOPE },
    { "material.c", "0", "1e-3", SPINODAL SLOPE },
    { "material.R", "inf", "100", SPINODAL SLOPE },
    { "material.V_c", "7", "1", "law.preset=kato_tullis\n" SLOPE },

    { "slope.alpha", "0.34", "0.35", LAW },
    { "slope.alpha_deg", "20", "19", LAW },
    { "slope.tan_alpha", "0.34", "0.35", LAW },

    { "gravity", "1.62", "9.81", LAW SLOPE },

    { "window.v", "[1e-3, 1e3]", "[1e-6, 1e6]", LAW SLOPE },
    { "window.psi", "[0.5, 2]", "[1e-3, 1e2]", LAW SLOPE },
    { "window.phi", "[0.5, 2]", "[1e-3, 1e2]", LAW SLOPE },
    { "window.axes", "eigen", "linear", LAW SLOPE },

    { "units", "si", "dimensionless", LAW SLOPE },
    { "products", "[knees, margin]", "[knees]", LAW SLOPE },
    { "estimates.xi", "[0.5]", "[0.5, 0.6]", LAW SLOPE },

    { "trajectories.starts", "[{v: 1, psi: 2}]", "[{v: 2, psi: 1}]",
      LAW SLOPE },
    { "trajectories.spread", "7", "0", LAW SLOPE },
    { "trajectories.seed", "7", "1", LAW SLOPE },
    { "trajectories.until.time", "7", "8", LAW SLOPE },
    { "trajectories.until.slip", "7", "8", LAW SLOPE },
    { "trajectories.sample.linear_slip", "7", "8", LAW SLOPE },
    { "trajectories.sample.log_time", "7", "8", LAW SLOPE },

    { "basins.cells", "[7, 8]", "[512, 512]", LAW SLOPE },
    { "basins.audit", "7", "1000", LAW SLOPE },
    { "basins.exact", "true", "false", LAW SLOPE },
    { "basins.rtol", "1e-9", "1e-6", LAW SLOPE },

    { "rabinowicz.block_mass", "7", "8", LAW SLOPE },
    { "rabinowicz.ball_mass", "7", "8", LAW SLOPE },
    { "rabinowicz.restitution", "0", "0.5", LAW SLOPE },
    { "rabinowicz.tan_alpha", "[0.1, 0.2]", "[0.1, 0.3]", LAW SLOPE },
    { "rabinowicz.data", "a.csv", "b.csv", LAW SLOPE },
    { "rabinowicz.smoothing", "1e-3", "1e-4", LAW SLOPE },

    { "sweep.key", "slope.alpha", "material.a", LAW SLOPE VALUES },
    { "sweep.from", "0.1", "0.2",
      LAW SLOPE KEY "sweep.to=1\nsweep.points=3\n" },
    { "sweep.to", "0.5", "0.6",
      LAW SLOPE KEY "sweep.from=0.1\nsweep.points=3\n" },
    { "sweep.points", "7", "8", LAW SLOPE KEY "sweep.from=0.1\nsweep.to=1\n" },
    { "sweep.scale", "log", "linear", LAW SLOPE KEY VALUES },
    { "sweep.values", "[0.1, 0.2]", "[0.1, 0.3]", LAW SLOPE KEY },
    { "sweep.refine", "0.1", "0.2", LAW SLOPE KEY VALUES },
    { "sweep.show", "persistence", "velocities", LAW SLOPE KEY VALUES },
    { "sweep.y_scale", "log", "linear", LAW SLOPE KEY VALUES },
    { "sweep.y_range", "[0.1, 2]", "[0.1, 3]", LAW SLOPE KEY VALUES },

    { "ensemble.parameters", "{material.a: {normal: [0.03, 0.001]}}",
      "{material.a: {normal: [0.03, 0.002]}}", LAW SLOPE },
    { "ensemble.covariance", "a.csv", "b.csv", LAW SLOPE },
    { "ensemble.samples", "a.csv", "b.csv", LAW SLOPE },
    { "ensemble.draws", "7", "8", LAW SLOPE },
    { "ensemble.method", "grid", "random", LAW SLOPE },
    { "ensemble.seed", "7", "8", LAW SLOPE },
    { "ensemble.numbers", "[v_plus]", "[v_minus]", LAW SLOPE },
    { "ensemble.pushes", "[{v: 1, psi: 2}]", "[{v: 2, psi: 2}]", LAW SLOPE },

    { "spring_block.sigma", "7", "1e3", LAW SLOPE },
    { "spring_block.mass", "0", "7", LAW SLOPE },
    { "spring_block.v", "[1e-3, 1e3]", "[1e-6, 1e6]", LAW SLOPE },

    { "fold_curves.c", "[1e-3, 1]", "[1e-14, 10]", LAW SLOPE },

    { "chi.alpha", "[0.3]", "[0.3, 0.4]", LAW SLOPE },

    { "figure.width", "one_column", "90", LAW SLOPE },
    { "figure.height", "80", "81.5", LAW SLOPE },
    { "figure.type", "7", "9", LAW SLOPE },
    { "figure.font", "Lato", "", LAW SLOPE },
    { "figure.title", "false", "true", LAW SLOPE },
    { "figure.legend", "inside", "none", LAW SLOPE },
    { "figure.colours", "cividis", "viridis", LAW SLOPE },
    { "figure.dpi", "600", "72", LAW SLOPE },

    { "accuracy.rtol", "1e-9", "1e-12", LAW SLOPE },
    { "accuracy.proved", "true", "false", LAW SLOPE },

    { "output.hdf5", "a.h5", "", LAW SLOPE },
    { "output.figure", "a.svg", "", LAW SLOPE },
};

static void the_tests_know_every_key(void **state)
{
    (void) state;
    for (const struct schema_key *k = schema_table; k->path; k++) {
        size_t i = 0;
        while (i < COUNT(keys) && strcmp(keys[i].path, k->path) != 0)
            i++;
        if (k->read == NULL) /* test_scene_system.c */
            continue;
        CHECK(i < COUNT(keys), "%s is not in the list above", k->path);
    }
}

/* "a: {b: {c: VALUE}}" of "a.b.c". */
static void nest(const char *path, const char *value, char *out)
{
    size_t depth = 0;

    for (; *path; path++) {
        if (*path == '.') {
            out += sprintf(out, ": {");
            depth++;
        } else {
            *out++ = *path;
        }
    }
    out += sprintf(out, ": %s", value);
    memset(out, '}', depth);
    strcpy(out + depth, "\n");
}

static struct scene from_file(size_t i, const char *value, const char *sets)
{
    char text[200];

    nest(keys[i].path, value, text);
    return scene_made(text, sets);
}

static void file_and_override_give_the_same_scene(void **state)
{
    (void) state;
    for (size_t i = 0; i < COUNT(keys); i++) {
        char sets[400];
        snprintf(sets, sizeof sets, "%s%s=%s\n", keys[i].rest, keys[i].path,
                 keys[i].value);
        struct scene file = from_file(i, keys[i].value, keys[i].rest);
        struct scene set = scene_made(NULL, sets);
        CHECK(scene_same(&file, &set), "%s", keys[i].path);
        scene_free(&file);
        scene_free(&set);
    }
}

static void an_override_wins_over_the_file_and_matters(void **state)
{
    (void) state;
    for (size_t i = 0; i < COUNT(keys); i++) {
        char sets[400];
        if (keys[i].other == NULL)
            continue;
        snprintf(sets, sizeof sets, "%s%s=%s\n", keys[i].rest, keys[i].path,
                 keys[i].value);
        struct scene set = scene_made(NULL, sets);
        struct scene both = from_file(i, keys[i].other, sets);
        struct scene other = from_file(i, keys[i].other, keys[i].rest);
        CHECK(scene_same(&both, &set), "%s", keys[i].path);
        CHECK(!scene_same(&other, &set), "%s", keys[i].path);
        scene_free(&set);
        scene_free(&both);
        scene_free(&other);
    }
}

/* ---- ranges -------------------------------------------------------------- */

static void the_ends_of_each_range_belong_to_it(void **state)
{
    static const char *const sets[] = {
        "material.mu_star=-1000",
        "material.mu_star=1e3",
        "material.a=5e-324",
        "material.L=1.7e308",
        "slope.alpha=1e-300",
        "slope.alpha=1.5707963267948963",
        "slope.alpha_deg=89.999999999999",
        "slope.tan_alpha=1e300",
        "window.v=[1e-300, 1e300]",
        "window.psi=[1e-300, 1e300]",
        "law.preset=ruina\nwindow.psi=[-1e300, 1e300]",
        SPINODAL "material.c=0",
        "trajectories.starts=[]",
        "trajectories.starts=[{v: 1e-300, psi: 1e300}]",
        "trajectories.spread=0",
        "trajectories.spread=10000",
        "trajectories.seed=0",
        "trajectories.seed=9007199254740992",
        "trajectories.sample.log_time=2",
        "trajectories.sample.linear_slip=1000000",
        "estimates.xi=[1e-300, 0.99999999999999989]",
        "spring_block.mass=0",
        "spring_block.v=[1e-300, 1e300]",
        "fold_curves.c=[1e-300, 1e300]",
        "chi.alpha=[1e-300, 1.57]",
        "basins.cells=[1, 32768]",
        "basins.audit=0",
        "basins.audit=1000000",
        "basins.rtol=1e-11",
        "basins.rtol=0.1",
        "accuracy.rtol=1e-14",
        "accuracy.rtol=0.1",
    };

    (void) state;
    for (size_t i = 0; i < COUNT(sets); i++) {
        char text[200];
        snprintf(text, sizeof text, LAW SLOPE "%s", sets[i]);
        struct scene s = scene_made(NULL, text);
        scene_free(&s);
    }
}

static void every_word_of_a_choice_has_its_code(void **state)
{
    (void) state;
    for (int i = 0; product_names[i]; i++) {
        char sets[200];
        snprintf(sets, sizeof sets, LAW SLOPE "products=[%s]",
                 product_names[i]);
        struct scene s = scene_made(NULL, sets);
        assert_int_equal(s.products, 1u << i);
        scene_free(&s);
    }
    struct scene s = scene_made(NULL, "law.theta=ln_c_psi\n"
                                      "law.psi_ss=spinodal_unit\n"
                                      "law.timescale=ageing44\n"
                                      "law.kinetics=linear\n" SLOPE);
    assert_string_equal(s.law.preset, "composed");
    assert_int_equal(s.law.theta, THETA_LN_C_PSI);
    assert_int_equal(s.law.psi_ss, PSI_SS_SPINODAL_UNIT);
    assert_int_equal(s.law.timescale, TIMESCALE_AGEING44);
    assert_int_equal(s.law.kinetics, KINETICS_LINEAR);
    scene_free(&s);
}

/* ---- what is said of keys ------------------------------------------------ */

static void what_holds_without_a_key_is_what_the_table_says(void **state)
{
    size_t told = 0;

    (void) state;
    for (size_t i = 0; i < COUNT(keys); i++) {
        const struct schema_key *k = schema_find(keys[i].path);
        char sets[400];
        if (k->standard == NULL)
            continue;
        snprintf(sets, sizeof sets, "%s%s=%s\n", keys[i].rest, k->path,
                 k->standard);
        struct scene without = scene_made(NULL, keys[i].rest);
        struct scene with = scene_made(NULL, sets);
        CHECK(scene_same(&without, &with), "%s", k->path);
        scene_free(&without);
        scene_free(&with);
        told++;
    }
    assert_true(told >= 30);
}

static void every_key_is_explained_in_one_phrase(void **state)
{
    (void) state;
    for (const struct schema_key *k = schema_table; k->path; k++) {
        CHECK(k->text && strlen(k->text) > 3, "%s", k->path);
        CHECK(k->text[strlen(k->text) - 1] != '.', "%s", k->path);
    }
}

/* ---- unknown keys -------------------------------------------------------- */

static const struct place nowhere = { .name = NULL };

/* A letter is doubled; the key is offered, if its word is long enough. */
static void each_misspelt_key_is_offered_as_it_should_be(void **state)
{
    (void) state;
    for (const struct schema_key *k = schema_table; k->path; k++) {
        char path[100], offer[100];
        struct fault why;
        const char *dot = strrchr(k->path, '.');
        if (strlen(dot ? dot + 1 : k->path) < 2)
            continue;
        snprintf(path, sizeof path, "%s%c", k->path,
                 k->path[strlen(k->path) - 1]);
        snprintf(offer, sizeof offer, " (did you mean %s?)", k->path);
        assert_int_equal(schema_check_path(path, nowhere, &why),
                         STATUS_BAD_SCENE);
        CHECK(strstr(why.text, offer), "%s", why.text);
    }
}

static void an_unknown_key_is_told_all_that_are_known(void **state)
{
    (void) state;
    for (const struct schema_key *k = schema_table; k->path; k++) {
        char path[100], word[100];
        struct fault why;
        const char *dot = strrchr(k->path, '.');
        const size_t head = dot ? (size_t) (dot + 1 - k->path) : 0;
        snprintf(path, sizeof path, "%.*sxyzxyz", (int) head, k->path);
        assert_int_equal(schema_check_path(path, nowhere, &why),
                         STATUS_BAD_SCENE);
        snprintf(word, sizeof word, " %s", k->path + head);
        const char *listed = strstr(why.text, "expected");
        CHECK(listed && strstr(listed, word), "%s", why.text);
        assert_null(strstr(why.text, "did you mean"));
    }
}

static void keys_and_their_sections_are_known(void **state)
{
    struct fault why;

    (void) state;
    for (const struct schema_key *k = schema_table; k->path; k++)
        for (const char *end = k->path; end; end = strchr(end + 1, '.')) {
            char path[100];
            const size_t size =
                end == k->path ? strlen(k->path) : (size_t) (end - k->path);
            snprintf(path, sizeof path, "%.*s", (int) size, k->path);
            assert_int_equal(schema_check_path(path, nowhere, &why), STATUS_OK);
        }
}

static void only_alternatives_exclude_each_other(void **state)
{
    (void) state;
    assert_true(schema_excludes("slope.alpha", "slope.alpha_deg"));
    assert_true(schema_excludes("slope.tan_alpha", "slope.alpha"));
    assert_true(schema_excludes("law.theta", "law.preset"));
    assert_false(schema_excludes("law.theta", "law.kinetics"));
    assert_false(schema_excludes("law.preset", "law.friction"));
    assert_false(schema_excludes("slope.alpha", "slope.alpha"));
    assert_false(schema_excludes("slope.alpha", "slope.none"));
    assert_false(schema_excludes("slope", "law"));
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_tests_know_every_key),
        IN_FOLDER(file_and_override_give_the_same_scene),
        IN_FOLDER(an_override_wins_over_the_file_and_matters),
        cmocka_unit_test(the_ends_of_each_range_belong_to_it),
        IN_FOLDER(what_holds_without_a_key_is_what_the_table_says),
        cmocka_unit_test(every_key_is_explained_in_one_phrase),
        cmocka_unit_test(every_word_of_a_choice_has_its_code),
        cmocka_unit_test(each_misspelt_key_is_offered_as_it_should_be),
        cmocka_unit_test(an_unknown_key_is_told_all_that_are_known),
        cmocka_unit_test(keys_and_their_sections_are_known),
        cmocka_unit_test(only_alternatives_exclude_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
