/* Scenes read: defaults, files, overrides, units, slopes. */
#include "scene.h"

#include <float.h>
#include <glob.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "comma_locale.h"
#include "fault_alloc.h"
#include "physical.h"
#include "scenes.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* ---- defaults ------------------------------------------------------------ */

static void windows_have_their_defaults(void **state)
{
    struct scene s = scene_made(NULL, "law.preset=dieterich\nslope.alpha=0.3");

    (void) state;
    assert_true(s.window.v[0] == 1e-6 && s.window.v[1] == 1e6);
    assert_true(s.window.psi[0] == 1e-3 && s.window.psi[1] == 1e2);
    assert_int_equal(s.window.axes, AXES_LOG);
    scene_free(&s);
    s = scene_made(NULL, "law.preset=perrin\nslope.alpha=0.3");
    assert_true(s.window.psi[0] == -7.0 && s.window.psi[1] == 5.0);
    scene_free(&s);
    s = scene_made(NULL, "law.preset=perrin\nslope.alpha=0.3\n"
                         "window.psi=[-1, 2]");
    assert_true(s.window.psi[0] == -1.0 && s.window.psi[1] == 2.0);
    scene_free(&s);
}

static void everything_but_law_and_slope_has_a_default(void **state)
{
    static const double xi[] = { 0.85, 0.9, 0.99, 0.999 };
    struct scene s = scene_made(NULL, "law.preset=dieterich\nslope.alpha=0.3");
    const struct material board = material_bristol_board();

    (void) state;
    assert_string_equal(s.title, "");
    assert_int_equal(s.law.form, FRICTION_ASINH);
    assert_memory_equal(&s.material, &board, sizeof board);
    assert_true(s.material.g == 9.81);
    assert_int_equal(s.units, UNITS_DIMENSIONLESS);
    assert_int_equal(s.products, 0);
    assert_int_equal(s.xi_count, COUNT(xi));
    assert_memory_equal(s.xi, xi, sizeof xi);
    assert_int_equal(s.starts, 0);
    assert_int_equal(s.spread, 0);
    assert_int_equal(s.seed, 1);
    assert_true(s.until_time == 0.0 && s.until_slip == 0.0);
    assert_int_equal(s.linear_slip, 0);
    assert_int_equal(s.log_time, 0);
    assert_int_equal(s.cells[0], 512);
    assert_int_equal(s.cells[1], 512);
    assert_int_equal(s.audit, 1000);
    assert_false(s.exact);
    assert_true(s.cell_rtol == 1e-6);
    assert_true(s.spring_block.sigma == 1e3 &&
                s.spring_block.mass == 1e3 / 9.81);
    assert_true(s.spring_block.v[0] == 1e-6 && s.spring_block.v[1] == 1e6);
    assert_true(s.fold_c[0] == 1e-14 && s.fold_c[1] == 10.0);
    assert_int_equal(s.chi_alphas, 4);
    assert_true(s.chi_alpha[0] == 0.2 && s.chi_alpha[3] == 0.38);
    assert_int_equal(s.sweep.show, SHOW_VELOCITIES);
    assert_true(s.sweep.y_range[0] == s.sweep.y_range[1]);
    assert_true(s.rtol == 1e-12);
    assert_null(s.hdf5);
    assert_null(s.figure);
    assert_string_equal(s.text, "");
    scene_free(&s);
}

static void every_preset_is_a_law_of_a_scene(void **state)
{
    (void) state;
    for (size_t i = 0; law_preset_at(i); i++) {
        struct law wanted = *law_preset_at(i);
        char sets[200];
        snprintf(sets, sizeof sets,
                 "law.preset=%s\nlaw.friction=log\nslope.alpha=0.3\n%s",
                 wanted.preset,
                 law_uses(&wanted, MATERIAL_V_C) ? "material.V_c=1" : "");
        struct scene s = scene_made(NULL, sets);
        wanted.form = FRICTION_LOG;
        CHECK(same_law(&s.law, &wanted), "%s", wanted.preset);
        scene_free(&s);
    }
}

/* The form stays, whether it is read before the preset or after. */
static void keys_may_come_in_any_order(void **state)
{
    struct scene a = scene_made("slope: {alpha: 0.3}\nunits: si\n"
                                "law: {preset: ruina, friction: log}\n",
                                "");
    struct scene b = scene_made("law:\n  friction: log\n  preset: ruina\n"
                                "units: si\nslope:\n  alpha: 0.3\n",
                                "");

    (void) state;
    assert_int_equal(a.law.form, FRICTION_LOG);
    assert_true(scene_same(&a, &b));
    scene_free(&a);
    scene_free(&b);
}

/* ---- every key ----------------------------------------------------------- */

static const char full[] =
    "title: All\n"
    "law: {preset: spinodal, friction: log}\n"
    "material: {mu_star: 0.11, a: 0.12, b: 0.13, L: 0.14, V_star: 0.15, "
    "c: 0.16, R: 17}\n"
    "slope: {tan_alpha: 0.18}\n"
    "gravity: 1.9\n"
    "window: {v: [0.21, 22], psi: [0.23, 24], axes: eigen}\n"
    "products: [folds, knees]\n"
    "estimates: {xi: [0.31, 0.32]}\n"
    "trajectories: {starts: [{v: 33, psi: 34}], spread: 35, seed: 36, "
    "until: {time: 37, slip: 38}, sample: {linear_slip: 39}}\n"
    "basins: {cells: [41, 42], audit: 43, exact: true, rtol: 1e-5}\n"
    "accuracy: {rtol: 1e-5}\n"
    "output: {hdf5: a.h5, figure: b.pdf}\n";

static void law_and_material_are_where_their_names_say(void **state)
{
    struct scene s = scene_made(full, "");

    (void) state;
    assert_string_equal(s.title, "All");
    assert_string_equal(s.law.preset, "spinodal");
    assert_int_equal(s.law.form, FRICTION_LOG);
    assert_true(s.material.mu_star == 0.11 && s.material.a == 0.12);
    assert_true(s.material.b == 0.13 && s.material.L == 0.14);
    assert_true(s.material.V_star == 0.15 && s.material.c == 0.16);
    assert_true(s.material.R == 17.0 && s.material.g == 1.9);
    scene_free(&s);
}

static void windows_and_products_are_where_their_names_say(void **state)
{
    struct scene s = scene_made(full, "");

    (void) state;
    assert_true(s.window.v[0] == 0.21 && s.window.v[1] == 22.0);
    assert_true(s.window.psi[0] == 0.23 && s.window.psi[1] == 24.0);
    assert_int_equal(s.window.axes, AXES_EIGEN);
    assert_int_equal(s.products, 1u << PRODUCT_FOLDS | 1u << PRODUCT_KNEES);
    assert_int_equal(s.xi_count, 2);
    assert_true(s.xi[0] == 0.31 && s.xi[1] == 0.32);
    assert_true(s.rtol == 1e-5);
    assert_string_equal(s.hdf5, "a.h5");
    assert_string_equal(s.figure, "b.pdf");
    scene_free(&s);
}

static void trajectories_and_basins_are_where_their_names_say(void **state)
{
    struct scene s = scene_made(full, "");

    (void) state;
    assert_int_equal(s.starts, 1);
    assert_true(s.start[0].v == 33.0 && s.start[0].psi == 34.0);
    assert_int_equal(s.spread, 35);
    assert_int_equal(s.seed, 36);
    assert_true(s.until_time == 37.0 && s.until_slip == 38.0);
    assert_int_equal(s.linear_slip, 39);
    assert_int_equal(s.log_time, 0);
    assert_int_equal(s.cells[0], 41);
    assert_int_equal(s.cells[1], 42);
    assert_int_equal(s.audit, 43);
    assert_true(s.exact);
    assert_true(s.cell_rtol == 1e-5);
    scene_free(&s);
    s = scene_made(full, "trajectories.sample.log_time=40");
    assert_int_equal(s.linear_slip, 0);
    assert_int_equal(s.log_time, 40);
    scene_free(&s);
}

/* ---- files --------------------------------------------------------------- */

static const char good[] = "# a comment\n"
                           "title: Na\xc3\xafve slope\n"
                           "law: {preset: spinodal_gen}\n"
                           "material: {preset: bristol_board, R: 50}\n"
                           "slope: {alpha_deg: 20}\n"
                           "trajectories: {starts: [{v: 0.25, psi: 7.5e-1}]}\n"
                           "output: {hdf5: a.h5}\n";

/* `text` with each '\n' replaced. */
static void with_line_ends(const char *text, const char *end, char *out)
{
    for (; *text; text++)
        out += sprintf(out, "%.*s", *text == '\n' ? 2 : 1,
                       *text == '\n' ? end : text);
}

static void line_ends_and_a_byte_order_mark_change_nothing(void **state)
{
    static const char *const end[] = { "\r\n", "\r" };
    struct scene a = scene_made(good, "");

    (void) state;
    for (size_t i = 0; i < COUNT(end); i++) {
        char text[600] = "\xef\xbb\xbf";
        with_line_ends(good, end[i], text + 3);
        struct scene b = scene_made(text, "");
        assert_true(scene_same(&a, &b));
        assert_string_equal(b.text, text);
        scene_free(&b);
    }
    scene_free(&a);
}

static void text_and_overrides_stay_with_the_scene(void **state)
{
    struct scene s =
        scene_made(good, "slope.alpha=0.1\nslope.alpha=0.2\ntitle=");

    (void) state;
    assert_string_equal(s.text, good);
    assert_string_equal(s.overrides,
                        "slope.alpha=0.1\nslope.alpha=0.2\ntitle=\n");
    assert_true(s.alpha == 0.2);
    assert_string_equal(s.title, "");
    scene_free(&s);
    scene_free(&s);
    assert_null(s.text);
}

static void scenes_of_the_repository_are_read(void **state)
{
    char pattern[600];
    glob_t found;

    (void) state;
    snprintf(pattern, sizeof pattern, "%s/scenes/*.yaml",
             getenv("SOURCE_ROOT"));
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    CHECK(found.gl_pathc >= 11, "%zu", found.gl_pathc);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        struct scene s;
        struct fault why;
        CHECK(scene_read(&s, found.gl_pathv[i], NULL, 0, &why) == STATUS_OK,
              "%s", why.text);
        CHECK(s.title[0] && s.hdf5 &&
                  (s.products || s.starts || s.sweep.axes ||
                   s.ensemble.parameters || s.rabinowicz.data),
              "%s", found.gl_pathv[i]);
        scene_free(&s);
    }
    globfree(&found);
}

static void a_decimal_comma_of_the_locale_changes_nothing(void **state)
{
    (void) state;
    comma_locale_use(true);
    struct scene a = scene_made(good, "gravity=1.62");
    comma_locale_use(false);
    struct scene b = scene_made(good, "gravity=1.62");
    assert_true(scene_same(&a, &b));
    scene_free(&a);
    scene_free(&b);
}

/* ---- overrides ----------------------------------------------------------- */

static void overrides_take_back_the_alternatives_of_the_file(void **state)
{
    struct scene s = scene_made(good, "slope.alpha=0.3");

    (void) state;
    assert_true(s.alpha == 0.3);
    scene_free(&s);
    s = scene_made(good, "slope.tan_alpha=1e3");
    assert_true(s.tan_alpha == 1e3L);
    scene_free(&s);
    s = scene_made("law: {theta: psi, psi_ss: minus_log, timescale: slip, "
                   "kinetics: linear, friction: log}\nslope: {alpha: 0.3}\n",
                   "law.preset=dieterich_gen");
    assert_string_equal(s.law.preset, "dieterich_gen");
    assert_int_equal(s.law.theta, THETA_LN_PSI);
    assert_int_equal(s.law.form, FRICTION_LOG);
    scene_free(&s);
}

static void later_overrides_win(void **state)
{
    struct scene s = scene_made(good, "slope.alpha=0.3\nslope.alpha_deg=45\n"
                                      "law.preset=ruina\nlaw.preset=spinodal");

    (void) state;
    assert_true(s.alpha == M_PI_4);
    assert_string_equal(s.law.preset, "spinodal");
    scene_free(&s);
}

static void an_empty_path_takes_an_output_back(void **state)
{
    struct scene s = scene_made("law: {preset: ruina}\nslope: {alpha: 0.3}\n"
                                "output: {hdf5: a.h5, figure: a.svg}\n",
                                "output.hdf5=\noutput.figure=");

    (void) state;
    assert_null(s.hdf5);
    assert_null(s.figure);
    scene_free(&s);
    s = scene_made("law: {preset: ruina}\nslope: {alpha: 0.3}\n"
                   "output: {hdf5: '', figure: }\n",
                   "");
    assert_null(s.hdf5);
    assert_null(s.figure);
    scene_free(&s);
}

/* ---- units and slopes ---------------------------------------------------- */

static void starts_in_si_units_become_dimensionless(void **state)
{
    static const char *const preset[] = { "dieterich_gen", "perrin", "ruina",
                                          "spinodal", "spinodal_phi_gen" };

    (void) state;
    for (size_t i = 0; i < COUNT(preset); i++) {
        char sets[200];
        snprintf(sets, sizeof sets,
                 "law.preset=%s\nslope.alpha=0.3\nunits=si\n"
                 "material.V_star=4e-6\nmaterial.L=3e-6\n"
                 "trajectories.starts=[{v: 2e-6, phi: 0.6}, {v: 1m/s, phi: 1}]",
                 preset[i]);
        struct scene s = scene_made(NULL, sets);
        assert_int_equal(s.starts, 2);
        assert_true(s.start[0].v == 2e-6 / 4e-6);
        assert_true(s.start[0].psi == physical_psi(&s.law, &s.material, 0.6));
        assert_true(s.start[1].v == 1.0 / 4e-6);
        scene_free(&s);
        for (char *c = sets; (c = strstr(c, "phi: ")) != NULL; c++)
            memcpy(c, "psi", 3);
        memcpy(strstr(sets, "units=si"), "title=si", 8);
        s = scene_made(NULL, sets); /* the other names and units */
        assert_true(s.start[0].v == 2e-6 && s.start[0].psi == 0.6);
        assert_true(s.start[1].v == 1.0 / 4e-6 && s.start[1].psi == 1.0);
        scene_free(&s);
    }
}

/* Every key that may have a unit, in each of its units, beside both `units`. */
static void numbers_with_units_become_dimensionless(void **state)
{
    const struct material m = material_bristol_board();
    const double V = m.V_star, L = m.L;

    (void) state;
    for (int si = 0; si < 2; si++) {
        char sets[400];
        snprintf(sets, sizeof sets,
                 "%s\nslope.alpha=0.3\nwindow.v=[1e-8 m/s, 1e2V_star]\n"
                 "spring_block.v=[2 V_star, 1m/s]\n"
                 "trajectories.until.time=5s\n"
                 "trajectories.until.slip=1e-6 m\n"
                 "window.phi=[0.5, 7]",
                 si ? "units=si" : "units=dimensionless");
        struct scene s = scene_made("law: {preset: spinodal_gen}\n", sets);
        assert_true(s.window.v[0] == 1e-8 / V && s.window.v[1] == 1e2);
        assert_true(s.spring_block.v[0] == 2.0 &&
                    s.spring_block.v[1] == 1.0 / V);
        assert_true(s.until_time == 5.0 / (L / V));
        assert_true(s.until_slip == 1e-6 / L);
        assert_true(s.window.psi[0] == physical_psi(&s.law, &s.material, 0.5) &&
                    s.window.psi[1] == physical_psi(&s.law, &s.material, 7.0));
        assert_int_equal(s.units, si ? UNITS_SI : UNITS_DIMENSIONLESS);
        scene_free(&s);
    }
    struct scene bare = scene_made(
        "law: {preset: spinodal_gen}\nunits: si\n",
        "slope.alpha=0.3\nwindow.v=[1e-8, 1]\nspring_block.v=[2e-9, 1]\n"
        "trajectories.until.time=5\ntrajectories.until.slip=1e-6");
    assert_true(bare.window.v[0] == 1e-8 / V && bare.window.v[1] == 1 / V);
    assert_true(bare.spring_block.v[0] == 2e-9 / V &&
                bare.spring_block.v[1] == 1 / V);
    assert_true(bare.until_time == 5 / (L / V) && bare.until_slip == 1e-6 / L);
    scene_free(&bare);
    struct scene s =
        scene_made("law: {preset: spinodal_gen}\n",
                   "slope.alpha=0.3\ntrajectories.until.time=5 L/V_star\n"
                   "trajectories.until.slip=3L");
    assert_true(s.until_time == 5.0 && s.until_slip == 3.0);
    scene_free(&s);
}

/* Of long double as it is computed here: valgrind has 53 bits. */
static long double epsilon(void)
{
    volatile long double one = 1.0L, step = 1.0L;

    while (one + step / 2 != one)
        step /= 2;
    return step;
}

static void slope_is(const char *set, long double tan_alpha, double alpha)
{
    char sets[200];

    snprintf(sets, sizeof sets, "law.preset=ruina\n%s", set);
    struct scene s = scene_made(NULL, sets);
    CHECK(fabsl(s.tan_alpha / tan_alpha - 1) <= 4 * epsilon(), "%s: %.21Lg",
          set, s.tan_alpha);
    CHECK(fabs(s.alpha / alpha - 1) <= DBL_EPSILON, "%s: %.17g", set, s.alpha);
    scene_free(&s);
}

static void degrees_give_the_tangent_to_the_last_digits(void **state)
{
    const double rad = M_PI / 180;

    (void) state;
    slope_is("slope.alpha_deg=20", 0.363970234266202361351047882777L, 20 * rad);
    slope_is("slope.alpha_deg=30", 0.577350269189625764509148780502L, M_PI / 6);
    slope_is("slope.alpha_deg=45", 1.0L, M_PI_4);
    slope_is("slope.alpha_deg=60", 1.73205080756887729352744634151L, M_PI / 3);
    slope_is("slope.alpha_deg=89.75", 229.181663609439917894268191397L,
             89.75 * rad);
    /* 90 - 2^-40 */
    slope_is("slope.alpha_deg=89.999999999999090505298227071762",
             62997375797123.9353143362867454L, M_PI_2 - 0x1p-40 * rad);
}

static void radians_and_tangents_agree(void **state)
{
    (void) state;
    slope_is("slope.alpha=0.34", tanl((long double) 0.34), 0.34);
    slope_is("slope.tan_alpha=0.34", 0.34, atan(0.34));
    slope_is("slope.tan_alpha=1e300", 1e300, M_PI_2);
    slope_is("slope.alpha=1e-300", 1e-300, 1e-300);
}

/* ---- memory -------------------------------------------------------------- */

static void each_allocation_may_fail(void **state)
{
    enum status s = STATUS_NO_MEMORY;

    (void) state;
    for (long k = 0; s != STATUS_OK; k++) {
        struct scene scene;
        struct fault why;
        fault_alloc_at(k);
        s = scene_of(&scene, good,
                     "window.v=[1, 2]\ntitle=other\noutput.figure=a.svg\n"
                     "estimates.xi=[0.5, 0.6]",
                     &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        if (s == STATUS_OK) {
            scene_free(&scene);
            continue;
        }
        assert_int_equal(s, STATUS_NO_MEMORY);
        assert_string_equal(why.text, "out of memory");
        assert_null(scene.text);
        assert_null(scene.xi);
    }
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(windows_have_their_defaults),
        cmocka_unit_test(everything_but_law_and_slope_has_a_default),
        cmocka_unit_test(every_preset_is_a_law_of_a_scene),
        IN_FOLDER(law_and_material_are_where_their_names_say),
        IN_FOLDER(windows_and_products_are_where_their_names_say),
        IN_FOLDER(trajectories_and_basins_are_where_their_names_say),
        IN_FOLDER(keys_may_come_in_any_order),
        IN_FOLDER(line_ends_and_a_byte_order_mark_change_nothing),
        IN_FOLDER(text_and_overrides_stay_with_the_scene),
        cmocka_unit_test(scenes_of_the_repository_are_read),
        IN_FOLDER(a_decimal_comma_of_the_locale_changes_nothing),
        IN_FOLDER(overrides_take_back_the_alternatives_of_the_file),
        IN_FOLDER(later_overrides_win),
        IN_FOLDER(an_empty_path_takes_an_output_back),
        cmocka_unit_test(starts_in_si_units_become_dimensionless),
        IN_FOLDER(numbers_with_units_become_dimensionless),
        cmocka_unit_test(degrees_give_the_tangent_to_the_last_digits),
        cmocka_unit_test(radians_and_tangents_agree),
        IN_FOLDER(each_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
