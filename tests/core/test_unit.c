/* Numbers told in the SI against 113 bits. */
#include "unit.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "quad.h"

static const char *const known[] = {
    "rad",        "V_star",          "L",   "L/V_star", "V_star/L",
    "ln(V_star)", "log10(V_star/L)", "psi", "ln(psi)",  "kick of psi",
};
enum { KNOWN = sizeof known / sizeof *known };

static __float128 told(const struct unit_system *u, const char *own,
                       __float128 x)
{
    const __float128 V = u->V_star, L = u->L, one = u->phi_1;

    if (strcmp(own, "V_star") == 0)
        return x * V;
    if (strcmp(own, "L") == 0)
        return x * L;
    if (strcmp(own, "L/V_star") == 0)
        return x * L / V;
    if (strcmp(own, "V_star/L") == 0)
        return x * V / L;
    if (strcmp(own, "rad") == 0)
        return u->angle == ANGLE_TAN      ? tanq(x)
               : u->angle == ANGLE_DEGREE ? x * 180 / acosq(-1)
                                          : x;
    if (strcmp(own, "ln(V_star)") == 0)
        return x + logq(V);
    if (strcmp(own, "log10(V_star/L)") == 0)
        return x + log10q(V / L);
    if (strcmp(own, "ln(psi)") == 0)
        return x + logq(one);
    if (strcmp(own, "kick of psi") == 0)
        return u->psi_is_log ? expq(x) : x;
    return u->psi_is_log ? one * expq(x) : one * x;
}

static struct unit_system random_units(uint64_t *rng)
{
    return (struct unit_system){ .si = true,
                                 .angle =
                                     (enum unit_angle)(check_bits(rng) % 3),
                                 .V_star = pow(10, check_uniform(rng, -9, 2)),
                                 .L = pow(10, check_uniform(rng, -8, 1)),
                                 .phi_1 = pow(10, check_uniform(rng, -3, 6)),
                                 .psi_is_log = check_bits(rng) % 2 == 0,
                                 .phi = "s" };
}

static double random_number(uint64_t *rng, const struct unit *unit)
{
    if (unit->kind == UNIT_ANGLE)
        return check_uniform(rng, 1e-3, 1.57);
    const double size = unit->kind == UNIT_FACTOR
                            ? pow(10, check_uniform(rng, -300, 300))
                            : pow(10, check_uniform(rng, -3, 2));

    return check_bits(rng) % 2 ? size : -size;
}

/* An exact number beside x, at the edge of its bar. */
static void a_bar_holds_what_it_held(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 20000; i++) {
        const struct unit_system u = random_units(&rng);
        const struct unit *unit = unit_find(known[i % KNOWN]);
        const double x = random_number(&rng, unit);
        const double part = i % 3 ? pow(10, check_uniform(&rng, -17, 0)) : 0.0;
        const double error = part * fabs(x);
        const __float128 exact =
            (__float128) x + (check_bits(&rng) % 2 ? error : -error);
        const struct quantity q = unit_quantity(
            &u, unit, (struct quantity){ .value = x, .error = error });
        if (!quantity_exists(&q))
            continue;
        const __float128 off = fabsq(told(&u, unit->own, exact) - q.value);
        CHECK(off <= (__float128) q.error, "%s %.17g +- %g: off %g, bar %g",
              unit->own, x, error, (double) off, q.error);
        if (part > 1e-15 && part < 1e-6 && fabs(q.value) > 1e-300)
            CHECK((double) off > 0.01 * q.error || unit->kind != UNIT_FACTOR,
                  "%s %.17g +- %g: off %g, bar %g", unit->own, x, error,
                  (double) off, q.error);
    }
}

static void what_is_beyond_all_doubles_is_none(void **state)
{
    const struct unit_system u = { .si = true,
                                   .V_star = 1e3,
                                   .L = 1e-3,
                                   .phi_1 = 1.0,
                                   .psi_is_log = true,
                                   .phi = "s" };

    (void) state;
    for (int i = 0; i < 2; i++) {
        const struct quantity q = unit_quantity(
            &u, unit_find(i ? "V_star" : "psi"),
            (struct quantity){ .value = i ? 1e306 : 800.0, .error = 1e-9 });
        assert_false(quantity_exists(&q));
        assert_non_null(strstr(q.reason, "largest double"));
    }
    const struct quantity none =
        unit_quantity(&u, unit_find("L"), quantity_none("a reason"));
    assert_string_equal(none.reason, "a reason");
}

static void numbers_as_they_are_keep_their_bits(void **state)
{
    const struct unit_system own = { .V_star = 3e-6, .L = 4e-6, .phi_1 = 7.0 };
    const struct quantity q = { 0.1, 1e-9, 1e-12, NULL, NULL, 2e-9, 3e-9 };

    (void) state;
    for (int i = 0; i < KNOWN; i++) {
        const struct quantity same =
            unit_quantity(&own, unit_find(known[i]), q);
        assert_true(same.value == q.value && same.error == q.error &&
                    same.conditioning == q.conditioning &&
                    same.spread == q.spread);
        assert_true(unit_value(NULL, unit_find(known[i]), 0.1) == 0.1);
        assert_string_equal(unit_plain(known[i]),
                            strcmp(known[i], "rad") ? "1" : "rad");
    }
    assert_null(unit_find("m"));
    assert_string_equal(unit_plain("Pa/m"), "Pa/m");
}

static void units_have_the_names_that_people_type(void **state)
{
    struct unit_system u = { .si = true, .phi = "s" };

    (void) state;
    assert_string_equal(unit_name(NULL, "V_star"), "V_star");
    assert_string_equal(unit_name(NULL, "psi"), "1");
    assert_string_equal(unit_name(&u, "V_star"), "m/s");
    assert_string_equal(unit_name(&u, "L/V_star"), "s");
    assert_string_equal(unit_name(&u, "psi"), "s");
    assert_string_equal(unit_name(&u, "kick of psi"), "1");
    assert_string_equal(unit_name(&u, "rad"), "rad");
    u.angle = ANGLE_DEGREE;
    assert_string_equal(unit_name(&u, "rad"), "degree");
    u.phi = "1";
    assert_string_equal(unit_name(&u, "psi"), "1");
    assert_string_equal(unit_name(&u, "ln(psi)"), "1");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bar_holds_what_it_held),
        cmocka_unit_test(what_is_beyond_all_doubles_is_none),
        cmocka_unit_test(numbers_as_they_are_keep_their_bits),
        cmocka_unit_test(units_have_the_names_that_people_type),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
