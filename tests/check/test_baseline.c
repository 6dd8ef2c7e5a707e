/* What is recorded holds, until one of its numbers is changed. */
#include "baseline.h"

#include "checked.h"
#include "fault_alloc.h"

static void add_scene(struct baseline *b, char *law, char *alpha, char *extra)
{
    char *set[] = { law, alpha, extra };
    struct scene scene;
    struct fault why;

    enum status s = scene_read(&scene, NULL, set, extra ? 3 : 2, &why);
    CHECK(s == STATUS_OK, "%s", why.text);
    s = baseline_add(b, "a \"name\", #1\n", &scene, &why);
    CHECK(s == STATUS_OK, "%s", why.text);
    scene_free(&scene);
}

static void record_some(struct baseline *b)
{
    static char law[][80] = {
        "law.preset=spinodal_gen", "law.preset=kato_tullis", "law.preset=ruina",
        "law={theta: psi, psi_ss: spinodal, timescale: slip, kinetics: sinh}"
    };
    static char alpha[][32] = { "slope.alpha=0.34", "slope.tan_alpha=0.35",
                                "slope.alpha_deg=17" };
    static char material[] = "material.V_c=100", rtol[] = "accuracy.rtol=1e-6";

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++)
            add_scene(b, law[k], alpha[i],
                      k == 1   ? material
                      : i == 1 ? rtol
                               : NULL);
}

static void what_is_recorded_holds(void **state)
{
    struct baseline b = { .text = NULL };
    struct checked c;

    (void) state;
    record_some(&b);
    assert_int_equal(b.size, strlen(b.text));
    check_text(&c, b.text);
    assert_int_equal(c.table.rows, b.rows);
    CHECK(c.r.compared > 300, "%zu values", c.r.compared);
    for (size_t i = 0; i < c.table.rows; i++)
        CHECK(c.r.row[i].findings == 0, "row %zu: %s moved by %g", i,
              c.r.row[i].finding->column, c.r.row[i].finding->difference);
    assert_string_equal(table_find(&c.table, 0, "name")->text,
                        "a \"name\", #1\\x0a");
    checked_free(&c);
    baseline_free(&b);
    baseline_free(&b);
}

/* The table as CSV, the value of one cell moved by ten times what stands
 * behind it; false if that cell is no number. */
static bool write_planted(const struct table *t, size_t row, size_t column,
                          char *text, size_t size)
{
    const struct table_cell *cell = table_at(t, row, column);
    const size_t name = strlen(table_header(t, column)->text);
    size_t used = 0;
    char planted[64];

    if (column + 1 == t->columns || cell[1].text[0] == '\0' ||
        strncmp(table_header(t, column + 1)->text,
                table_header(t, column)->text, name) != 0 ||
        strcmp(table_header(t, column + 1)->text + name, "_tol") != 0)
        return false;
    snprintf(planted, sizeof planted, "%.21Lg",
             strtold(cell->text, NULL) + 10.0L * strtold(cell[1].text, NULL));
    for (size_t i = 0; i < 2 * t->columns; i++) {
        const struct table_cell *at = i < t->columns
                                          ? table_header(t, i)
                                          : table_at(t, row, i - t->columns);
        const bool label = strchr(at->text, '"') != NULL;
        used += (size_t) snprintf(text + used, size - used, "%s%c",
                                  label        ? ""
                                  : at == cell ? planted
                                               : at->text,
                                  (i + 1) % t->columns ? ',' : '\n');
    }
    return true;
}

static void ten_recorded_tolerances_in_any_quantity_are_found(void **state)
{
    struct baseline b = { .text = NULL };
    struct table t;
    struct fault why;
    size_t planted = 0;

    (void) state;
    record_some(&b);
    assert_int_equal(table_parse(&t, b.text, b.size, "t.csv", &why), STATUS_OK);
    for (size_t row = 0; row < t.rows; row++)
        for (size_t i = 0; i < t.columns; i++) {
            char text[1 << 14];
            if (!write_planted(&t, row, i, text, sizeof text))
                continue;
            moves(text, table_header(&t, i)->text);
            planted++;
        }
    print_message("# %zu planted\n", planted);
    CHECK(planted > 200, "only %zu planted", planted);
    table_free(&t);
    baseline_free(&b);
}

static void every_allocation_of_a_recording_may_fail(void **state)
{
    static char law[] = "law.preset=spinodal_gen", alpha[] = "slope.alpha=0.3";
    char *set[] = { law, alpha };
    struct baseline b = { .text = NULL };
    struct scene scene;
    struct fault why;
    enum status s = STATUS_NO_MEMORY;

    (void) state;
    assert_int_equal(scene_read(&scene, NULL, set, 2, &why), STATUS_OK);
    for (long k = 0; s != STATUS_OK; k++) {
        fault_alloc_at(k);
        s = baseline_add(&b, "x", &scene, &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%ld: %.400s", k,
              why.text);
        CHECK(s == STATUS_OK || (b.size == 0 && b.rows == 0), "%ld: %zu rows",
              k, b.rows);
    }
    holds(b.text);
    baseline_free(&b);
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_recorded_holds),
        cmocka_unit_test(ten_recorded_tolerances_in_any_quantity_are_found),
        cmocka_unit_test(every_allocation_of_a_recording_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
