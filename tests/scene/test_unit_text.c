/* Numbers with a unit behind them (unit_text.h). */
#include "unit_text.h"

#include <string.h>

#include "check.h"

static void is_read(const char *own, const char *text, double wanted,
                    enum unit_text in)
{
    enum unit_text found = UNIT_TEXT_BARE;
    double x = 7.0;

    CHECK(unit_text_read(unit_find(own), text, &x, &found), "'%s' is refused",
          text);
    CHECK(x == wanted && found == in, "'%s': %g, %d", text, x, (int) found);
}

static void a_number_may_have_one_of_two_units(void **state)
{
    (void) state;
    is_read("V_star", "8e-3", 8e-3, UNIT_TEXT_BARE);
    is_read("V_star", "8e-3m/s", 8e-3, UNIT_TEXT_SI);
    is_read("V_star", "-8e-3   m/s", -8e-3, UNIT_TEXT_SI);
    is_read("V_star", "1e3V_star", 1e3, UNIT_TEXT_OWN);
    is_read("V_star", ".5 V_star", 0.5, UNIT_TEXT_OWN);
    is_read("L/V_star", "5s", 5.0, UNIT_TEXT_SI);
    is_read("L/V_star", "5 L/V_star", 5.0, UNIT_TEXT_OWN);
    is_read("L", "1e-6 m", 1e-6, UNIT_TEXT_SI);
    is_read("L", "3L", 3.0, UNIT_TEXT_OWN);
    is_read("1", "3", 3.0, UNIT_TEXT_BARE);
}

static void anything_else_is_refused_and_touches_nothing(void **state)
{
    static const struct {
        const char *of;
        const char *text;
    } wrong[] = {
        { "V_star", "" },
        { "V_star", "m/s" },
        { "V_star", " m/s" },
        { "V_star", "8 m" },
        { "V_star", "8 s" },
        { "V_star", "8 m/s m/s" },
        { "V_star", "8 m/s " },
        { "V_star", "8 V_star/s" },
        { "V_star", "8 v_star" },
        { "V_star", "8\tm/s" },
        { "V_star", "0x8 m/s" },
        { "V_star", "nan m/s" },
        { "L/V_star", "5 m/s" },
        { "L/V_star", "5 m" },
        { "L", "5 s" },
        { "L", "5 V_star" },
        { "1", "5 m" },
        { "1", "5 " },
        { "V_star", "1e400 m/s" },
    };

    (void) state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        enum unit_text unit = UNIT_TEXT_OWN;
        double x = 7.0;
        CHECK(!unit_text_read(unit_find(wrong[i].of), wrong[i].text, &x, &unit),
              "'%s' is %g", wrong[i].text, x);
        assert_true(x == 7.0 && unit == UNIT_TEXT_OWN);
    }
    char longest[5000];
    enum unit_text unit;
    double x;
    memset(longest, '1', sizeof longest);
    memcpy(longest + sizeof longest - 4, "m/s", 4);
    assert_false(unit_text_read(unit_find("V_star"), longest, &x, &unit));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_number_may_have_one_of_two_units),
        cmocka_unit_test(anything_else_is_refused_and_touches_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
