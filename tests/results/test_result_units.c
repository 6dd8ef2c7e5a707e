/* Records told in the SI. */
#include "result_units.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"

/* Of decimals of 12 digits at most, read as scene_units.c and physical.c do. */
static void inputs_are_told_as_they_were_typed(void **state)
{
    uint64_t rng = check_seed();
    int rounded = 0;

    (void) state;
    for (int i = 0; i < 20000; i++) {
        const struct unit_system u = {
            .si = true,
            .V_star = pow(10, check_uniform(&rng, -9, 2)),
            .L = pow(10, check_uniform(&rng, -8, 1)),
            .phi_1 = pow(10, check_uniform(&rng, -3, 6)),
            .psi_is_log = i % 4 == 1,
            .phi = "s",
        };
        const bool is_state = i % 2;
        const struct unit *unit = unit_find(is_state ? "psi" : "V_star");
        char text[32];
        snprintf(text, sizeof text, "%.*g", 1 + i % 12,
                 pow(10, check_uniform(&rng, -9, 9)));
        const double typed = strtod(text, NULL);
        const double x = typed / unit_scale(&u, unit);
        const double own = is_state && u.psi_is_log ? log(x) : x;
        CHECK(result_input(&u, unit, own) == typed, "%s: %.17g", text,
              result_input(&u, unit, own));
        rounded += unit_value(&u, unit, own) != typed;
    }
    assert_true(rounded > 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(inputs_are_told_as_they_were_typed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
