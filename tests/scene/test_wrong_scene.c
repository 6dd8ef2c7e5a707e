/* Wrong scenes, each with the one line that names what is wrong in it. */
#include "scene.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "check.h"
#include "scenes.h"
#include "text.h"
#include "tolerance.h"
#include "wrong_ensembles.h"
#include "wrong_scenes.h"
#include "wrong_sweeps.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* ---- the lines ----------------------------------------------------------- */

/* A message is one printable line. */
static void is_one_line(const char *line)
{
    char shown[600];

    text_show(line, shown, sizeof shown);
    assert_string_equal(line, shown);
    assert_true(*line != '\0');
}

static void is_empty(const struct scene *s)
{
    assert_null(s->title);
    assert_null(s->xi);
    assert_null(s->text);
    assert_null(s->overrides);
}

static void all_refused(const struct wrong *wrong, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        struct scene s;
        struct fault why;
        char line[600];
        const enum status status = scene_of(&s, wrong[i].text, "", &why);
        assert_int_equal(status, STATUS_BAD_SCENE);
        is_one_line(why.text);
        is_empty(&s);
        snprintf(line, sizeof line, "%s:%s", own_path("s.yaml"), wrong[i].line);
        assert_string_equal(why.text, line);
        scene_free(&s);
    }
}

static void unknown_keys_are_refused_on_every_level(void **state)
{
    (void) state;
    all_refused(wrong_keys, COUNT(wrong_keys));
}

static void keys_given_twice_are_refused(void **state)
{
    (void) state;
    all_refused(wrong_twice, COUNT(wrong_twice));
}

static void values_of_another_kind_are_refused(void **state)
{
    (void) state;
    all_refused(wrong_kinds, COUNT(wrong_kinds));
}

static void what_is_no_number_or_out_of_range_is_refused(void **state)
{
    (void) state;
    all_refused(wrong_numbers, COUNT(wrong_numbers));
}

static void sweeps_over_nothing_sensible_are_refused(void **state)
{
    (void) state;
    all_refused(wrong_sweeps, COUNT(wrong_sweeps));
}

static void ensembles_of_nothing_sensible_are_refused(void **state)
{
    (void) state;
    all_refused(wrong_ensembles, COUNT(wrong_ensembles));
}

static void parts_that_do_not_fit_together_are_refused(void **state)
{
    (void) state;
    all_refused(wrong_together, COUNT(wrong_together));
}

/* The same values, blamed on the override that brought them. */
static void a_wrong_override_is_named_whole(void **state)
{
    static const struct {
        const char *set, *line;
    } wrong[] = {
        { "slope.alpha=x",
          "slope.alpha: 'x'" NOT "an angle in rad, 0 < alpha < pi/2" },
        { "slope.alpha=19.5",
          "slope.alpha: '19.5'" NOT "an angle in rad, 0 < alpha < pi/2 "
          "(did you mean slope.alpha_deg?)" },
        { "window.v=[2, 1]", "window.v: [2, 1] is empty, expected lo < hi" },
        { "products=[kness]",
          "products: 'kness'" NOT "a list of " PRODUCTS_KNOWN
          " (did you mean knees?)" },
        { "material.R=100",
          "material.R: not used by this law (dieterich_gen), expected " USED },
        { "law.preset=kato_tullis",
          "law.preset: kato_tullis needs material.V_c, expected a number > 0" },
        { "law={friction: log}", NO_LAW },
        { "slope=", "no slope, expected 'slope: {alpha: RAD}' or --alpha RAD" },
        { "trajectories.starts=[{v: 1}]",
          "trajectories.starts: psi is missing, expected {v: V, psi: P}" },
    };

    (void) state;
    for (size_t i = 0; i < COUNT(wrong); i++) {
        struct scene s;
        struct fault why;
        char line[600];
        assert_int_equal(scene_of(&s, LAW SLOPE, wrong[i].set, &why),
                         STATUS_BAD_SCENE);
        snprintf(line, sizeof line, "--set %s: %s", wrong[i].set,
                 wrong[i].line);
        assert_string_equal(why.text, line);
        is_empty(&s);
    }
}

static void without_a_file_the_command_line_is_to_blame(void **state)
{
    struct scene s;
    struct fault why;

    (void) state;
    assert_int_equal(scene_of(&s, NULL, "", &why), STATUS_BAD_SCENE);
    assert_string_equal(why.text, "command line: " NO_LAW);
    assert_int_equal(scene_of(&s, NULL, "law.preset=ruina", &why),
                     STATUS_BAD_SCENE);
    assert_string_equal(why.text, "command line: no slope, expected 'slope: "
                                  "{alpha: RAD}' or --alpha RAD");
}

/* The longest message of all, of the longest name: the offer still fits. */
static void a_long_file_name_leaves_room_for_the_message(void **state)
{
    char name[240];
    struct scene s;
    struct fault why;
    static const char text[] = LAW SLOPE "products: [equilibriaaaa]\n";

    (void) state;
    memset(name, 'n', sizeof name);
    name[sizeof name - 1] = '\0';
    const char *path = own_path("");
    char whole[300];
    snprintf(whole, sizeof whole, "%s/%s", path, name);
    file_write(whole, text, strlen(text));
    assert_int_equal(scene_read(&s, whole, NULL, 0, &why), STATUS_BAD_SCENE);
    is_one_line(why.text);
    assert_memory_equal(why.text, "...nnn", 6);
    assert_non_null(strstr(why.text, "nnn:3:12: products: 'equilibriaaaa'"));
    assert_non_null(strstr(why.text, "(did you mean equilibria?)"));
}

/* ---- files --------------------------------------------------------------- */

static void a_scene_has_at_most_a_mebibyte(void **state)
{
    static const char good[] = LAW SLOPE "# ";
    const char *path = own_path("s.yaml");
    char *text = malloc(SCENE_BYTES + 1), line[300];
    struct scene s;
    struct fault why;

    (void) state;
    memset(text, 'x', SCENE_BYTES + 1);
    memcpy(text, good, strlen(good));
    file_write(path, text, SCENE_BYTES);
    assert_int_equal(scene_read(&s, path, NULL, 0, &why), STATUS_OK);
    scene_free(&s);
    file_write(path, text, SCENE_BYTES + 1);
    assert_int_equal(scene_read(&s, path, NULL, 0, &why), STATUS_BAD_SCENE);
    snprintf(line, sizeof line,
             "%s:1:1: a file of more than 1048576 bytes, expected a scene",
             path);
    assert_string_equal(why.text, line);
    is_empty(&s);
    free(text);
}

static void cannot_be_read(const char *path, const char *reason)
{
    char line[400];
    struct scene s;
    struct fault why;

    assert_int_equal(scene_read(&s, path, NULL, 0, &why), STATUS_IO);
    snprintf(line, sizeof line, "%s: cannot read: %s", path, reason);
    assert_string_equal(why.text, line);
    is_empty(&s);
    scene_free(&s);
}

static void a_file_that_cannot_be_read_is_an_io_error(void **state)
{
    (void) state;
    cannot_be_read(own_path("none.yaml"), "No such file or directory");
    cannot_be_read(own_path(""), "Is a directory");
    file_write(own_path("s.yaml"), "", 0);
    cannot_be_read(own_path("s.yaml/s.yaml"), "Not a directory");
    assert_int_equal(chmod(own_path("s.yaml"), 0), 0);
    if (geteuid() != 0) /* root may read it all the same */
        cannot_be_read(own_path("s.yaml"), "Permission denied");
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(unknown_keys_are_refused_on_every_level),
        IN_FOLDER(keys_given_twice_are_refused),
        IN_FOLDER(values_of_another_kind_are_refused),
        IN_FOLDER(what_is_no_number_or_out_of_range_is_refused),
        IN_FOLDER(sweeps_over_nothing_sensible_are_refused),
        IN_FOLDER(ensembles_of_nothing_sensible_are_refused),
        IN_FOLDER(parts_that_do_not_fit_together_are_refused),
        IN_FOLDER(a_wrong_override_is_named_whole),
        cmocka_unit_test(without_a_file_the_command_line_is_to_blame),
        IN_FOLDER(a_long_file_name_leaves_room_for_the_message),
        IN_FOLDER(a_scene_has_at_most_a_mebibyte),
        IN_FOLDER(a_file_that_cannot_be_read_is_an_io_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
