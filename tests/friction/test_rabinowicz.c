/* Rabinowicz's experiment: the ball's mechanics, release distances of a law,
 * and measurements from files. */
#include "release.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "estimates.h"
#include "fault_alloc.h"
#include "numbers.h"
#include "own_folder.h"
#include "rabinowicz.h"
#include "stops.h"
#include "study.h"

#define MASSES                                                                 \
    "rabinowicz.block_mass=0.1\nrabinowicz.ball_mass=0.01\n"                   \
    "rabinowicz.restitution=0.5\n"

static struct scene scene_of_lines(const char *lines)
{
    char text[600], *rest = text, *set[32];
    size_t count = 0;
    struct scene s;
    struct fault why;

    snprintf(text, sizeof text, "%s", lines);
    for (char *line; (line = strsep(&rest, "\n")) != NULL && count < 32;)
        if (*line)
            set[count++] = line;
    const enum status status = scene_read(&s, NULL, set, count, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
    return s;
}

static struct release run(const char *lines)
{
    struct scene s = scene_of_lines(lines);
    struct release r;
    struct fault why;
    const enum status status = release_run(&r, &s, NULL, &why);

    CHECK(status == STATUS_OK, "%s", why.text);
    scene_free(&s);
    return r;
}

/* ---- mechanics ----------------------------------------------------------- */

/* The ball rolls, hits, the block slides against mu: (19), (20), (21). */
static void a_ball_released_at_l_stops_the_block_after_s(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 1000; i++) {
        const double g = 9.81, L = 1e-6, V = 1e-6;
        const double eps2 = V * V / (g * L);
        const double alpha = check_uniform(&rng, 0.01, 1.4);
        const double mu = tan(alpha) + check_uniform(&rng, 0.01, 1.0);
        const double m = check_uniform(&rng, 0.1, 10.0);
        const double ball = m * check_uniform(&rng, 0.01, 0.3);
        const double e = check_uniform(&rng, 0.0, 1.0);
        const double l = exp(check_uniform(&rng, -10.0, 0.0));
        const double v_ball = sqrt(10.0 / 7.0 * g * l * sin(alpha));
        const double v0 = (1.0 + e) * ball * v_ball / m;
        const double s = 0.5 * v0 * v0 / (g * (mu * cos(alpha) - sin(alpha)));
        const double K = rabinowicz_K(m, ball, e);
        const double back = L * rabinowicz_release(eps2, v0 / V, K, tan(alpha));
        CHECK(fabs((mu - tan(alpha)) * s / (K * l * tan(alpha)) - 1.0) < 1e-11,
              "(22): %g", (mu - tan(alpha)) * s / (K * l * tan(alpha)));
        CHECK(fabs(back / l - 1.0) < 1e-12, "%.17g %.17g", back, l);
    }
}

static void the_parabola_33_is_31_times_22(void **state)
{
    const struct material m = material_bristol_board();
    const struct law *law = law_preset_find("spinodal_gen");
    const double K = 0.016, mu_s = 0.62, t = 0.3;
    struct estimates e;

    (void) state;
    assert_true(estimates_at(law, &m, t, &e));
    const double l = rabinowicz_release_33(rabinowicz_factor(law, &m, K), mu_s,
                                           rabinowicz_mu_half(&m), t);
    const double G = (mu_s - t) * e.x_k_small_psi;
    CHECK(fabs(l / (m.L * rabinowicz_release_of_energy(G, K, t)) - 1.0) < 1e-13,
          "%.17g", l);
    CHECK(fabs(rabinowicz_mu_half(&m) - (0.369 + 0.014 * log(2.0))) < 1e-15,
          "%.17g", rabinowicz_mu_half(&m));
}

/* ---- forward ------------------------------------------------------------- */

/* v_plus of the model's tables; l_k by hand. */
static void release_distances_follow_from_exact_numbers(void **state)
{
    struct release r =
        run("law.preset=dieterich_gen\nslope.alpha=0.34\n" MASSES);
    const struct release_row *row = r.row;
    const double K = 5.0 / 7.0 * 2.25 * 0.01, v = 2832.2233588e-6;
    const double l = v * v / (2.0 * 9.81 * K * sin(0.34));

    (void) state;
    assert_int_equal(r.rows, 1);
    CHECK(fabs(r.K.value / K - 1.0) < 1e-15, "%.17g", r.K.value);
    CHECK(fabs(row->v_k.value / v - 1.0) < 1e-10, "%.17g", row->v_k.value);
    CHECK(fabs(row->l_k.value / l - 1.0) < 1e-9, "%.17g", row->l_k.value);
    CHECK(row->l_k.error < 1e-11 * l && row->l_k.error > 0.0, "%g",
          row->l_k.error);
    CHECK(fabs(row->s_k.value - 1.791454 * 0.9e-6) < 1e-12, "%.17g",
          row->s_k.value);
    CHECK(fabs(row->s_k_30.value - 1.792725 * 0.9e-6) < 1e-12, "%.17g",
          row->s_k_30.value);
    CHECK(fabs(row->l_k_G.value / l - 1.0) < 1e-3 &&
              row->l_k_G.value < row->l_k.value,
          "%.17g", row->l_k_G.value);
    CHECK(fabs(row->l_k_33.value / l - 1.0) < 0.02, "%.17g", row->l_k_33.value);
    assert_true(r.parabola.points == 0 && r.persistence.points == 0);
    release_free(&r);
    release_free(&r);
}

static void a_list_of_slopes_gives_a_row_each(void **state)
{
    struct release all =
        run("law.preset=spinodal_gen\nslope.alpha=0.34\n" MASSES
            "rabinowicz.tan_alpha=[0.36, 0.31, 0.45]\n");
    struct release one =
        run("law.preset=spinodal_gen\nslope.tan_alpha=0.31\n" MASSES);

    (void) state;
    assert_int_equal(all.rows, 3);
    assert_true(all.row[1].l_k.value == one.row[0].l_k.value &&
                all.row[1].tan_alpha == 0.31 &&
                fabs(all.row[1].alpha - atan(0.31)) < 1e-16);
    assert_true(all.row[0].l_k.value < all.row[1].l_k.value);
    assert_true(!quantity_exists(&all.row[2].l_k) && all.row[2].l_k.reason);
    release_free(&all);
    release_free(&one);
}

static void what_is_missing_is_named(void **state)
{
    struct release r = run("law.preset=dieterich_gen\nslope.alpha=0.34\n");

    (void) state;
    assert_true(strstr(r.K.reason, "block_mass") &&
                r.row[0].l_k.reason == r.K.reason &&
                quantity_exists(&r.row[0].v_k));
    release_free(&r);
    r = run("law.preset=dieterich_gen\nslope.alpha=0.34\n"
            "rabinowicz.block_mass=1\nrabinowicz.ball_mass=0.1\n");
    assert_non_null(strstr(r.K.reason, "restitution"));
    release_free(&r);
    r = run("law.preset=ruina\nslope.alpha=0.34\n" MASSES);
    assert_true(!quantity_exists(&r.row[0].l_k) &&
                !quantity_exists(&r.row[0].l_k_33) &&
                !quantity_exists(&r.row[0].s_k_30));
    release_free(&r);
    r = run("law.preset=dieterich_gen\nslope.tan_alpha=0.385\n" MASSES);
    assert_true(quantity_exists(&r.row[0].l_k) &&
                strstr(r.row[0].l_k_33.reason, "mu_ss(V_star/2)"));
    release_free(&r);
}

/* ---- data ---------------------------------------------------------------- */

/* The example's data, which its header says the truth of. */
static void the_shipped_example_gives_its_numbers_back(void **state)
{
    char lines[600];

    (void) state;
    snprintf(lines, sizeof lines,
             "law.preset=dieterich_gen\nslope.alpha=0.34\n" MASSES
             "rabinowicz.data='%s/scenes/rabinowicz.csv'\n",
             getenv("SOURCE_ROOT"));
    struct release r = run(lines);
    const struct parabola *p = &r.parabola;
    const struct release_material *m = &r.material;
    assert_true(p->points == 12 && r.persistence.points == 12);
    assert_true(!p->warning && !r.persistence.warning);
    CHECK(p->mu_s_low < 0.62 && p->mu_s_high > 0.62, "%g", p->mu_s.value);
    CHECK(m->L_low < 0.9e-6 && m->L_high > 0.9e-6 && m->L_high < 1e-6, "%g",
          m->L.value);
    CHECK(m->mu_star_low < 0.369 && m->mu_star_high > 0.369, "%g",
          m->mu_star.value);
    CHECK(r.persistence.L_low < 0.9e-6 && r.persistence.L_high > 0.9e-6 &&
              r.persistence.L_high < 0.92e-6,
          "%g", r.persistence.L.value);
    assert_true(r.slip.count > 10 && quantity_exists(&r.slip.at[0].s_k));
    release_free(&r);
}

/* Table, and the line of the complaint behind its name. */
static const struct {
    const char *text, *line;
} wrong[] = {
    { "tan_alpha,lk\n0.1,1\n", "1:11: unknown column 'lk', expected tan_alpha, "
                               "l_k, l_k_error, x_k or x_k_error (did you mean "
                               "l_k?)" },
    { "l_k\n1\n", "1:1: no column 'tan_alpha', expected tan_alpha and l_k or "
                  "x_k" },
    { "tan_alpha\n1\n", "1:1: no column 'l_k', expected tan_alpha and l_k or "
                        "x_k" },
    { "tan_alpha,x_k,l_k_error\n1,1,1\n",
      "1:1: no column 'l_k', expected tan_alpha and l_k or x_k" },
    { "tan_alpha,l_k,x_k_error\n1,1,1\n",
      "1:1: no column 'x_k', expected tan_alpha and l_k or x_k" },
    { "# mine\ntan_alpha,l_k\n0.1,2\n0.2,two\n",
      "4:5: l_k: 'two', expected a number > 0" },
    { "tan_alpha,l_k\n0.1,2\n0.2,-1\n",
      "3:5: l_k: '-1', expected a number > 0" },
    { "tan_alpha,l_k\n0,2\n", "2:1: tan_alpha: '0', expected a number > 0" },
    { "tan_alpha,l_k\ninf,2\n",
      "2:1: tan_alpha: 'inf', expected a number > 0" },
    { "l_k,tan_alpha\n1,\n", "2:1: no tan_alpha in this row, expected a number "
                             "> 0" },
    { "tan_alpha,l_k,l_k_error\n0.1,2,0\n",
      "2:7: l_k_error: '0', expected a number > 0" },
    { "tan_alpha,l_k,l_k_error\n0.1,2,0.1\n0.2,1,\n",
      "3:1: no l_k_error in this row, expected a number > 0" },
    { "tan_alpha,l_k,x_k\n0.1,2,3\n0.2,,\n",
      "3:1: neither l_k nor x_k in this row" },
    { "tan_alpha,l_k\n0.1,2,3\n", "2:7: more cells than the header has" },
};

static void wrong_tables_are_blamed_where_they_are_wrong(void **state)
{
    (void) state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct table t;
        struct observations o = { .l_k.count = 7 };
        struct fault why;
        char line[300];
        enum status s = table_parse(&t, wrong[i].text, strlen(wrong[i].text),
                                    "a.csv", &why);
        if (s == STATUS_OK) {
            s = observations_read(&o, &t, &why);
            assert_true(o.l_k.count == 0 && o.x_k.value == NULL);
        }
        snprintf(line, sizeof line, "a.csv:%s", wrong[i].line);
        CHECK(s == STATUS_BAD_SCENE && strcmp(why.text, line) == 0,
              "%.400s instead of %s", why.text, line);
        table_free(&t);
    }
}

static void empty_cells_were_not_measured(void **state)
{
    static const char text[] = "x_k,tan_alpha,l_k,l_k_error\n"
                               "1,0.1,,\n,0.2,2,0.1\n3,0.3,3,0.2\n";
    struct table t;
    struct observations o;
    struct fault why;

    (void) state;
    assert_int_equal(table_parse(&t, text, strlen(text), "a.csv", &why),
                     STATUS_OK);
    assert_int_equal(observations_read(&o, &t, &why), STATUS_OK);
    assert_true(o.x_k.count == 2 && o.l_k.count == 2 && !o.x_k.error);
    assert_true(o.l_k.tan_alpha[0] == 0.2 && o.l_k.value[1] == 3.0 &&
                o.l_k.error[1] == 0.2 && o.x_k.tan_alpha[1] == 0.3);
    observations_free(&o);
    observations_free(&o);
    table_free(&t);
}

static void a_missing_file_is_no_scene_s_fault(void **state)
{
    struct scene s = scene_of_lines("law.preset=dieterich_gen\n"
                                    "slope.alpha=0.34\n"
                                    "rabinowicz.data=/nowhere/a.csv\n");
    struct release r;
    struct fault why;

    (void) state;
    assert_int_equal(release_run(&r, &s, NULL, &why), STATUS_IO);
    CHECK(strstr(why.text, "/nowhere/a.csv: cannot read"), "%s", why.text);
    assert_true(r.row == NULL && r.observed.l_k.value == NULL);
    scene_free(&s);
}

static void a_monitor_stops_it(void **state)
{
    const struct monitor monitor = { stop_at_once, NULL };
    struct scene s =
        scene_of_lines("law.preset=dieterich_gen\nslope.alpha=0.34\n");
    struct release r;
    struct fault why;

    (void) state;
    assert_int_equal(release_run(&r, &s, &monitor, &why), STATUS_STOPPED);
    assert_true(r.row == NULL);
    scene_free(&s);
}

static void every_allocation_may_fail(void **state)
{
    static const char text[] = "tan_alpha,l_k,x_k\n0.1,4,5\n0.15,3,4\n"
                               "0.2,2,3\n0.25,1.2,2\n0.3,0.5,1\n";
    char lines[600];
    enum status status = STATUS_NO_MEMORY;
    struct release r;
    struct fault why;
    long k = 0;

    (void) state;
    file_write(own_path("a.csv"), text, strlen(text));
    snprintf(lines, sizeof lines,
             "law.preset=dieterich_gen\nslope.alpha=0.34\n" MASSES
             "rabinowicz.data='%s'\n",
             own_path("a.csv"));
    struct scene s = scene_of_lines(lines);
    for (; status == STATUS_NO_MEMORY; k++) {
        fault_alloc_at(k);
        status = release_run(&r, &s, NULL, &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        if (status == STATUS_NO_MEMORY)
            assert_true(r.row == NULL && r.slip.at == NULL);
    }
    CHECK(status == STATUS_OK, "%s", why.text);
    CHECK(k > 10, "%ld allocations", k);
    release_free(&r);
    scene_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ball_released_at_l_stops_the_block_after_s),
        cmocka_unit_test(the_parabola_33_is_31_times_22),
        cmocka_unit_test(release_distances_follow_from_exact_numbers),
        cmocka_unit_test(a_list_of_slopes_gives_a_row_each),
        cmocka_unit_test(what_is_missing_is_named),
        cmocka_unit_test(the_shipped_example_gives_its_numbers_back),
        cmocka_unit_test(wrong_tables_are_blamed_where_they_are_wrong),
        cmocka_unit_test(empty_cells_were_not_measured),
        cmocka_unit_test(a_missing_file_is_no_scene_s_fault),
        cmocka_unit_test(a_monitor_stops_it),
        cmocka_unit_test_setup_teardown(every_allocation_may_fail,
                                        own_folder_make, own_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
