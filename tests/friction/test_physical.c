/* From the dimensionless psi to the physical phi and back.
 */
#include "physical.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "check.h"

static struct material material(void)
{
    struct material m = material_bristol_board();

    m.L = 2.5e-6;
    m.V_star = 1e-5;
    m.R = 40.0;
    return m;
}

static void phi_is(const char *preset, double psi, double wanted)
{
    const struct law *law = law_preset_find(preset);
    const struct material m = material();
    const double phi = physical_phi(law, &m, psi);

    CHECK(fabs(phi - wanted) <= 4 * DBL_EPSILON * wanted, "%s: %.17g, %.17g",
          preset, phi, wanted);
}

/* L/V_star = 0.25 s, 1 + R = 41. */
static void phi_has_the_formula_of_each_preset(void **state)
{
    (void) state;
    phi_is("dieterich", 3.0, 0.75);
    phi_is("dieterich_gen", 3.0, 0.75);
    phi_is("kato_tullis", 3.0, 0.75);
    phi_is("ruina", 3.0, 0.25 * exp(3.0));
    phi_is("ruina", -4.0, 0.25 * exp(-4.0));
    phi_is("perrin", 3.0, 0.5 * exp(3.0));
    phi_is("perrin", 0.0, 0.5);
    phi_is("spinodal", 82.0, 2.0);
    phi_is("spinodal_gen", 82.0, 2.0);
    phi_is("spinodal_phi_gen", 2.0, 2.0);
}

/* The same friction, whether theta is of psi = (1 + R) phi or of phi. */
static void both_writings_of_the_spinodal_law_have_one_phi(void **state)
{
    const struct material m = material();
    const struct law *psi = law_preset_find("spinodal_gen");
    const struct law *phi = law_preset_find("spinodal_phi_gen");

    (void) state;
    const double x = physical_phi(psi, &m, 7.0);
    assert_true(fabs(physical_psi(phi, &m, x) * 41.0 - 7.0) < 1e-14);
}

static void composed_laws_follow_their_theta(void **state)
{
    struct material m = material();
    struct law law = *law_preset_find("dieterich");

    (void) state;
    law.preset = "composed";
    assert_true(physical_phi(&law, &m, 3.0) == 0.75);
    law.psi_ss = PSI_SS_SPINODAL;
    assert_true(physical_phi(&law, &m, 3.0) == 0.75);
    law.theta = THETA_LN_C_PSI;
    assert_true(fabs(physical_phi(&law, &m, 82.0) - 2.0) < 1e-15);
    law.theta = THETA_LN_C_1PR_PSI;
    assert_true(physical_phi(&law, &m, 82.0) == 82.0);
    law.theta = THETA_PSI;
    assert_true(physical_phi(&law, &m, 0.0) == 0.25);
    law.kinetics = KINETICS_SINH;
    assert_true(physical_phi(&law, &m, 0.0) == 0.5);
}

/* Of psi itself where it is a logarithm, relative elsewhere. */
static double distance(const struct law *law, double psi, double back)
{
    if (law_psi_is_log(law))
        return fabs(back - psi) / fmax(1.0, fabs(psi));
    return fabs(back / psi - 1.0);
}

static void psi_comes_back_from_phi_over_the_whole_range(void **state)
{
    const struct material m = material();
    uint64_t seed = check_seed();

    (void) state;
    for (size_t i = 0; law_preset_at(i); i++)
        for (int k = 0; k < 2000; k++) {
            const struct law *law = law_preset_at(i);
            const double x = check_uniform(&seed, -690.0, 690.0);
            const double psi = law_psi_is_log(law) ? x : exp(x);
            const double back =
                physical_psi(law, &m, physical_phi(law, &m, psi));
            CHECK(distance(law, psi, back) <= 4 * DBL_EPSILON,
                  "%s: %.17g, %.17g", law->preset, psi, back);
        }
}

static void phi_is_a_time_or_a_number(void **state)
{
    (void) state;
    for (size_t i = 0; law_preset_at(i); i++) {
        const struct law *law = law_preset_at(i);
        const bool spinodal = strncmp(law->preset, "spinodal", 8) == 0;
        assert_string_equal(physical_unit(law), spinodal ? "1" : "s");
    }
}

/* phi in s is as long as L/V_star, phi in 1 does not know it. */
static void the_unit_tells_what_phi_scales_with(void **state)
{
    struct material m = material(), slow = m;

    (void) state;
    slow.V_star /= 4.0;
    for (size_t i = 0; law_preset_at(i); i++) {
        const struct law *law = law_preset_at(i);
        const double ratio =
            physical_phi(law, &slow, 1.5) / physical_phi(law, &m, 1.5);
        const double wanted = strcmp(physical_unit(law), "s") == 0 ? 4.0 : 1.0;
        CHECK(fabs(ratio - wanted) < 1e-14, "%s: %g", law->preset, ratio);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(phi_has_the_formula_of_each_preset),
        cmocka_unit_test(both_writings_of_the_spinodal_law_have_one_phi),
        cmocka_unit_test(composed_laws_follow_their_theta),
        cmocka_unit_test(psi_comes_back_from_phi_over_the_whole_range),
        cmocka_unit_test(phi_is_a_time_or_a_number),
        cmocka_unit_test(the_unit_tells_what_phi_scales_with),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
