/* Fields beside the saddle and the separatrix, as stress judges them. */
#include <string.h>

#include "check.h"
#include "laws.h"
#include "stress_field.h"
#include "stress_run.h"

/* ---- one cell ------------------------------------------------------------ */

enum { ALL = (1 << CELL_FIELDS) - 1 };

static struct quad_orbit truth_of(enum fate fate)
{
    struct quad_orbit o = { .fate = fate };

    for (int k = 0; k < CELL_FIELDS; k++) {
        o.value[k] = 1 + k;
        o.error[k] = 1e-14;
    }
    return o;
}

static struct stress_cell cell_of(enum fate fate)
{
    return (struct stress_cell){ (int8_t) fate,
                                 { (int8_t) fate, 1, 1e-9, 2, 1e-9, 3, 1e-9, 4,
                                   1e-9, 5, 1e-9 },
                                 ALL };
}

static struct stress_row judge(const struct stress_cell *c,
                               const struct quad_orbit *o)
{
    struct stress_row row = { .name = "" };

    stress_field_judge(c, o, &row);
    return row;
}

static void a_wrong_number_of_a_cell_is_a_lie(void **state)
{
    const struct quad_orbit o = truth_of(FATE_CREEP);
    const struct stress_cell right = cell_of(FATE_CREEP);

    (void) state;
    assert_int_equal(judge(&right, &o).outcome, STRESS_EXACT);
    for (int k = 0; k < CELL_FIELDS; k++) {
        struct stress_cell c = right;
        double *number = &c.cell.slip + 2 * k;
        number[0] += 3e-9;
        const struct stress_row row = judge(&c, &o);
        assert_int_equal(row.outcome, STRESS_LIE);
        assert_string_equal(row.worst, cell_fields[1 + 2 * k].name);
        CHECK(fabs(row.bar - 3.0) < 1e-6, "%g", row.bar);
        number[1] = (double) NAN;
        assert_int_equal(judge(&c, &o).outcome, STRESS_LIE);
        number[0] = (double) NAN;
        assert_int_equal(judge(&c, &o).outcome, STRESS_DEGRADED);
        c.which &= ~(1u << k); /* nobody asked */
        assert_int_equal(judge(&c, &o).outcome, STRESS_EXACT);
    }
}

static void a_number_that_is_none_and_a_wrong_fate_are_lies(void **state)
{
    struct quad_orbit o = truth_of(FATE_REST_ASYMPTOTIC);
    struct stress_cell c = cell_of(FATE_REST_ASYMPTOTIC);

    (void) state;
    o.error[CELL_TIME] = (double) NAN;
    assert_int_equal(judge(&c, &o).outcome, STRESS_LIE);
    c.cell.time = c.cell.time_error = (double) NAN;
    assert_int_equal(judge(&c, &o).outcome, STRESS_EXACT);
    c.label = FATE_RUNAWAY;
    assert_int_equal(judge(&c, &o).outcome, STRESS_LIE);
    c = (struct stress_cell){ FATE_REST_ASYMPTOTIC, cell_unknown, ALL };
    assert_int_equal(judge(&c, &o).outcome, STRESS_DEGRADED);
    o.fate = FATE_UNDECIDED;
    assert_int_equal(judge(&c, &o).outcome, STRESS_DEGRADED);
}

/* ---- the catalogue ------------------------------------------------------- */

static struct stress run(struct stress_list *list, const char *pattern)
{
    struct stress s;
    struct fault why;

    if (laws_emulated())
        skip();
    assert_int_equal(stress_list_init(list, pattern, false, &why), STATUS_OK);
    CHECK(list->count > 0, "%s", pattern);
    assert_int_equal(stress_run(&s, list, NULL), STATUS_OK);
    return s;
}

/* Next to the saddle; where peaks are on the way, past it or on the way to a
 * rest that takes for ever. */
static void fields_beside_the_separatrix_do_not_lie(void **state)
{
    static const char *const pattern[] = {
        "field/spinodal_gen/asinh/0,1e-0[135]",
        "field/spinodal/*/-1,1e-14",
        "field/spinodal_phi_gen/asinh/-1,1e-14",
        "field/dieterich/asinh/0,1e-06",
        "field/kato_tullis/asinh/0,1e-14",
        "field/ruina/log/-1,1e-06",
        "fields/ln_c_psi.spinodal.ageing44.sinh/*/-1,*",
    };

    (void) state;
    for (size_t i = 0; i < sizeof pattern / sizeof *pattern; i++) {
        struct stress_list list;
        struct stress s = run(&list, pattern[i]);
        for (size_t k = 0; k < s.count; k++)
            CHECK(s.row[k].outcome < STRESS_FAILED && s.row[k].bar <= 1.0 &&
                      s.row[k].steps == 4,
                  "%s: %s, %s of %s, %g bars", s.row[k].name,
                  stress_outcome_names[s.row[k].outcome], s.row[k].reason,
                  s.row[k].worst, s.row[k].bar);
        stress_free(&s);
        stress_list_free(&list);
    }
}

static void all_presets_are_looked_at_from_1e_1_to_1e_14(void **state)
{
    struct stress_list list;
    struct fault why;
    char name[96];

    (void) state;
    assert_int_equal(stress_list_init(&list, "field/", false, &why), STATUS_OK);
    for (size_t i = 0; law_preset_at(i); i++)
        for (int d = 1; d <= 14; d++) {
            bool found = false;
            snprintf(name, sizeof name, "field/%s/asinh/0,%g",
                     law_preset_at(i)->preset, pow(10, -d));
            for (size_t k = 0; k < list.count; k++)
                found = found || strcmp(list.at[k].name, name) == 0;
            CHECK(found, "%s", name);
        }
    for (size_t k = 0; k < list.count; k++) {
        const struct scene_window *w = &list.at[k].scene.window;
        CHECK(w->v[0] < w->v[1] && w->psi[0] < w->psi[1] &&
                  list.at[k].scene.cells[0] * list.at[k].scene.cells[1] == 4,
              "%s", list.at[k].name);
    }
    stress_list_free(&list);
}

/* A grid of anyone's is looked at in so many places. */
static void the_fields_of_a_scene_are_one_more_case(void **state)
{
    char law[] = "law.preset=spinodal_gen", slope[] = "slope.alpha=0.35";
    char slip[] = "products=[slip]", cells[] = "basins.cells=[12, 11]";
    char *set[] = { law, slope, slip, cells };
    struct stress_list list = { .at = NULL };
    struct stress s;
    struct scene scene;
    struct fault why;

    (void) state;
    if (laws_emulated())
        skip();
    assert_int_equal(scene_read(&scene, NULL, set, 4, &why), STATUS_OK);
    assert_int_equal(stress_list_add(&list, "mine", "", &scene), STATUS_OK);
    assert_int_equal(list.at[0].kind, STRESS_FIELD);
    assert_int_equal(stress_run(&s, &list, NULL), STATUS_OK);
    CHECK(s.row[0].outcome < STRESS_FAILED && s.row[0].steps == 66, "%s, %lld",
          s.row[0].reason, (long long) s.row[0].steps);
    stress_free(&s);
    stress_list_free(&list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wrong_number_of_a_cell_is_a_lie),
        cmocka_unit_test(a_number_that_is_none_and_a_wrong_fate_are_lies),
        cmocka_unit_test(fields_beside_the_separatrix_do_not_lie),
        cmocka_unit_test(all_presets_are_looked_at_from_1e_1_to_1e_14),
        cmocka_unit_test(the_fields_of_a_scene_are_one_more_case),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
