/* Laws as tapes: short, and psi stands still at the anchor because its formula
 * is 0 there, not because two numbers are the same. */
#include "law_tape.h"

#include "check.h"
#include "laws.h"
#include "quad_tape.h"

static struct tape_lowered tape;

static void make(const struct law *law, bool equilibrium)
{
    law_names(law, &tape.f);
    law_tape(law, equilibrium, &tape);
}

static bool is_zero(int node)
{
    return formula_is(&tape.f, node, 0.0);
}

/* Of the step that the mantissa is: its argument, or its terms, vanish. */
static bool stands_still(const struct tape_rate *r)
{
    const struct step *s = &tape.t.step[r->mantissa.term[0].reg - 2];

    if (r->sinh >= 0)
        return is_zero(s->k);
    if (r->scaled < 0)
        return is_zero(r->mantissa.constant);
    for (int i = 0; i < s->form.terms; i++) {
        const int reg = s->form.term[i].reg;
        if (reg >= 2 && tape.t.step[reg - 2].kind == STEP_APART &&
            !is_zero(tape.t.step[reg - 2].q))
            return false;
    }
    return is_zero(s->form.constant);
}

static void psi_stands_still_at_the_anchor_by_its_formula(void **state)
{
    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        const struct law law = laws_at(i);
        make(&law, false);
        CHECK(stands_still(&tape.t.rate[1]), "law %zu", i);
        CHECK(tape.t.steps <= 40, "law %zu: %d steps", i, tape.t.steps);
        CHECK(!is_zero(tape.t.rate[0].mantissa.constant), "law %zu", i);
        make(&law, true);
        CHECK(is_zero(tape.t.rate[0].mantissa.constant), "law %zu", i);
    }
}

/* d ln v/dt = (..) exp(.. - X): one exponential of the state, whatever the
 * law; psi_ss of (45) is the only other thing that is exponentiated twice. */
static void the_plainest_law_is_short(void **state)
{
    struct law law = *law_preset_find("perrin");

    (void) state;
    law.form = FRICTION_LOG;
    make(&law, false);
    assert_int_equal(tape.t.steps, 2); /* psi + ln v, its sinh */
    assert_int_equal(tape.t.rate[0].exponent[0].terms, 1);
    assert_int_equal(tape.t.rate[0].mantissa.terms, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(psi_stands_still_at_the_anchor_by_its_formula),
        cmocka_unit_test(the_plainest_law_is_short),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
