/* Numbers with a unit behind them (unit.h). */
#include "unit.h"

#include <string.h>

#include "check.h"

static void is_read(enum dimension d, const char *text, double wanted,
                    enum unit unit)
{
    enum unit found = UNIT_BARE;
    double x = 7.0;

    CHECK(unit_read(d, text, &x, &found), "'%s' is refused", text);
    CHECK(x == wanted && found == unit, "'%s': %g, %d", text, x, (int) found);
}

static void a_number_may_have_one_of_two_units(void **state)
{
    (void) state;
    is_read(DIMENSION_RATE, "8e-3", 8e-3, UNIT_BARE);
    is_read(DIMENSION_RATE, "8e-3m/s", 8e-3, UNIT_SI);
    is_read(DIMENSION_RATE, "-8e-3   m/s", -8e-3, UNIT_SI);
    is_read(DIMENSION_RATE, "1e3V_star", 1e3, UNIT_OWN);
    is_read(DIMENSION_RATE, ".5 V_star", 0.5, UNIT_OWN);
    is_read(DIMENSION_TIME, "5s", 5.0, UNIT_SI);
    is_read(DIMENSION_TIME, "5 L/V_star", 5.0, UNIT_OWN);
    is_read(DIMENSION_LENGTH, "1e-6 m", 1e-6, UNIT_SI);
    is_read(DIMENSION_LENGTH, "3L", 3.0, UNIT_OWN);
    is_read(DIMENSION_NONE, "3", 3.0, UNIT_BARE);
}

static void anything_else_is_refused_and_touches_nothing(void **state)
{
    static const struct {
        enum dimension of;
        const char *text;
    } wrong[] = {
        { DIMENSION_RATE, "" },          { DIMENSION_RATE, "m/s" },
        { DIMENSION_RATE, " m/s" },      { DIMENSION_RATE, "8 m" },
        { DIMENSION_RATE, "8 s" },       { DIMENSION_RATE, "8 m/s m/s" },
        { DIMENSION_RATE, "8 m/s " },    { DIMENSION_RATE, "8 V_star/s" },
        { DIMENSION_RATE, "8 v_star" },  { DIMENSION_RATE, "8\tm/s" },
        { DIMENSION_RATE, "0x8 m/s" },   { DIMENSION_RATE, "nan m/s" },
        { DIMENSION_TIME, "5 m/s" },     { DIMENSION_TIME, "5 m" },
        { DIMENSION_LENGTH, "5 s" },     { DIMENSION_LENGTH, "5 V_star" },
        { DIMENSION_NONE, "5 m" },       { DIMENSION_NONE, "5 " },
        { DIMENSION_RATE, "1e400 m/s" },
    };

    (void) state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        enum unit unit = UNIT_OWN;
        double x = 7.0;
        CHECK(!unit_read(wrong[i].of, wrong[i].text, &x, &unit), "'%s' is %g",
              wrong[i].text, x);
        assert_true(x == 7.0 && unit == UNIT_OWN);
    }
    char longest[5000];
    enum unit unit;
    double x;
    memset(longest, '1', sizeof longest);
    memcpy(longest + sizeof longest - 4, "m/s", 4);
    assert_false(unit_read(DIMENSION_RATE, longest, &x, &unit));
}

static void the_own_unit_is_a_scale_of_the_material(void **state)
{
    struct material m = material_bristol_board();

    (void) state;
    m.V_star = 4e-6;
    m.L = 3e-6;
    assert_true(unit_scale(DIMENSION_RATE, &m) == 4e-6);
    assert_true(unit_scale(DIMENSION_TIME, &m) == 3e-6 / 4e-6);
    assert_true(unit_scale(DIMENSION_LENGTH, &m) == 3e-6);
    assert_true(unit_scale(DIMENSION_NONE, &m) == 1.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_number_may_have_one_of_two_units),
        cmocka_unit_test(anything_else_is_refused_and_touches_nothing),
        cmocka_unit_test(the_own_unit_is_a_scale_of_the_material),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
