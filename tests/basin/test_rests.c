/* Time and slip of random states that come to rest, or fade with a finite
 * slip, by push, simulate and whole orbits, against 113 bits; RESTS=300 tries
 * more than a test can afford, CHECK_SEED others, ANSWER_TELL=1 prints each lie
 * as it is found. */
#include "answers.h"
#include "found.h"
#include "rest_form.h"

enum { RESTS = 8, EACH = 4 };

/* A slope where blocks come to rest. */
static void draw(uint64_t *rng, struct draw *d)
{
    for (int attempt = 0; attempt < 200; attempt++) {
        const size_t i = check_bits(rng) % 1000;
        slope_scene(&d->scene, "spinodal", NULL, "0.34", grid);
        d->scene.cell_rtol = pow(10.0, -4.0 - (double) (check_bits(rng) % 6));
        if (drawn_law(i, rng, &d->scene) && drawn_slope(rng, &d->scene)) {
            const struct rest_form f =
                rest_form_of(&d->scene.law, &d->scene.material);
            const bool fades = f.fate == FATE_REST_ASYMPTOTIC && f.has_slip;
            const bool ends =
                f.fate == FATE_REST_FINITE || (fades && attempt % 8 == 7);
            if (ends && make(d)) {
                drawn_name(i, &d->scene, d->name);
                return;
            }
        }
        scene_free(&d->scene);
    }
    fail_msg("no slope");
}

static struct push_state draw_state(const struct draw *d, uint64_t *rng)
{
    const struct vec2 origin = d->study.slider.plane.system.origin;
    struct vec2 z;

    do
        z = (struct vec2){ origin.x + check_uniform(rng, -12, 12),
                           origin.y + check_uniform(rng, -7, 7) };
    while (!push_holds(&d->push, state_of(d, z)));
    return state_of(d, z);
}

static bool rests(const struct draw *d, struct push_state at)
{
    const struct told t = by_push(d, at);
    return t.fate == FATE_REST_FINITE || t.fate == FATE_REST_ASYMPTOTIC;
}

static void time_and_slip_to_rest_are_those_of_113_bits(void **state)
{
    const char *asked = getenv("RESTS");
    const size_t states = asked ? strtoul(asked, NULL, 10) : RESTS;
    static struct draw d;
    struct tally t = { 0 };
    uint64_t rng = check_seed();

    (void) state;
    if (laws_emulated())
        skip();
    prepare(&t, states + EACH);
    while (t.states < states) {
        draw(&rng, &d);
        for (int k = 0; k < EACH && t.states < states; k++) {
            const struct push_state at = draw_state(&d, &rng);
            if (rests(&d, at))
                check_state(&d, ANYWHERE, at, true, EXACT_BOTH, &t);
        }
        release(&d);
    }
    print_message("# CHECK_SEED=%llu\n", (unsigned long long) check_seed());
    finish(&t);
    CHECK(t.lies == 0, "%zu lies", t.lies);
    CHECK(t.fields >= states, "%zu fields of %zu states", t.fields, states);
}

/* By Runge's and Kutta's steps over psi - psi_ss, which falls from 85 to 40,
 * then over time, and an integral from there on; no other digits with half the
 * steps. */
static void who_leaps_ahead_of_psi_ss_waits_for_it(void **state)
{
    const struct found f = {
        FRICTION_LOG,  THETA_LN_PSI, PSI_SS_INVERSE,         TIMESCALE_SLIP,
        KINETICS_SINH, 0.369,        0.02493675061400168,    0.0489,
        0.001,         100.0,        7.6617024914627204e-07, 1e-6,
        0.0,           1e-6
    };
    const double time = 1.260904954041968e-12, slip = 6.117830887242574e-19;
    static struct draw d;

    (void) state;
    found_scene(&f, grid, &d.scene);
    d.scene.tan_alpha = 0.613099620486629253162L;
    d.scene.alpha = (double) atanl(d.scene.tan_alpha);
    assert_true(make(&d));
    const struct told t = by_push(
        &d,
        state_of(&d, (struct vec2){ -13.934137966364553, 14.616699379417748 }));
    CHECK(fabs(t.value[CELL_TIME] - time) <= t.bar[CELL_TIME],
          "time %.16g +- %g", t.value[CELL_TIME], t.bar[CELL_TIME]);
    CHECK(fabs(t.value[CELL_SLIP] - slip) <= t.bar[CELL_SLIP],
          "slip %.16g +- %g", t.value[CELL_SLIP], t.bar[CELL_SLIP]);
    CHECK(t.bar[CELL_SLIP] < 1e-9 * slip, "%g", t.bar[CELL_SLIP]);
    release(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(time_and_slip_to_rest_are_those_of_113_bits),
        cmocka_unit_test(who_leaps_ahead_of_psi_ss_waits_for_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
