/* What is a root and what is a saddle: neither what only touches 0, nor what
 * goes through it to third order. */
#include "proof_root.h"

#include <string.h>

#include "check.h"
#include "law_typed.h"
#include "proof.h"

/* (1/3 - x)^kind, -(1/3 - x)^-kind where kind < 0. */
static bool power_at(void *ctx, mpfr_srcptr x, mpfi_ptr out)
{
    const int *kind = ctx;
    mpfi_t off;

    mpfi_init2(off, mpfi_get_prec(out));
    mpfi_set_ui(off, 1);
    mpfi_div_ui(off, off, 3);
    mpfi_sub_fr(off, off, x);
    mpfi_set(out, off);
    for (int i = 1; i < abs(*kind); i++)
        mpfi_mul(out, out, off);
    if (*kind < 0)
        mpfi_neg(out, out);
    mpfi_clear(off);
    return true;
}

static void only_where_a_function_falls_through_0_it_has_a_root(void **state)
{
    mpfi_t place;

    (void) state;
    mpfi_init2(place, 256);
    for (int kind = -2; kind <= 2; kind++) {
        int power = kind;
        const bool falls = kind == 1;
        if (kind == 0)
            continue;
        CHECK(proof_root(power_at, NULL, &power, 0.33L, place) == falls, "%d",
              kind);
        if (falls) {
            mpfi_mul_ui(place, place, 3);
            CHECK(mpfi_is_inside_ui(1, place), "%d", kind);
        }
    }
    mpfi_clear(place);
}

/* What is said of the steady state v = psi = 1 of a law, mu_star being the
 * slope. */
static void check_none(const char *psi_ss, const char *rate, const char *why)
{
    static const struct branch none[2];
    static struct law_typed t;
    const struct proof_inputs in = { .slope_in = ANGLE_TAN, .slope = 0.5 };
    struct material m = material_bristol_board();
    static struct block b;
    enum law_part wrong;
    struct fault fault;
    struct proof p;

    law_typed_of_preset(law_preset_find("dieterich"), &t);
    snprintf(t.text[LAW_THETA], LAW_LETTERS, "ln(psi)");
    snprintf(t.text[LAW_PSI_SS], LAW_LETTERS, "%s", psi_ss);
    snprintf(t.text[LAW_RATE], LAW_LETTERS, "%s", rate);
    if (*rate)
        t.text[LAW_T][0] = t.text[LAW_K][0] = '\0';
    t.form = FRICTION_LOG;
    assert_int_equal(law_typed_make(&t, &wrong, &fault), STATUS_OK);
    const struct law law = law_of_typed(&t);
    m.mu_star = 0.5;
    m.a = 1e-8;
    block_init(&b, &law, &m, 0.5L);
    block_anchor(&b, 0, true);
    assert_int_equal(proof_along(&b, &in, none, &p), STATUS_OK);
    CHECK(strstr(p.not_proved.text, why), "%s %s: '%s'", psi_ss, rate,
          p.not_proved.text);
    proof_free(&p);
}

/* mu_ss falls as -(ln v)^3 does; psi_ss is where a third power is 0. */
static void a_steady_state_of_third_order_is_not_proved_a_saddle(void **state)
{
    (void) state;
    check_none("exp(-(a*ln(v) + ln(v)*ln(v)*ln(v))/b)", "", "determinant");
    check_none("", "-(psi*v - 1)*(psi*v - 1)*(psi*v - 1)", "no sign change");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_where_a_function_falls_through_0_it_has_a_root),
        cmocka_unit_test(a_steady_state_of_third_order_is_not_proved_a_saddle),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
