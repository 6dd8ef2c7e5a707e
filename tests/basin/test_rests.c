/* Time and slip of random states that come to rest, or fade with a finite
 * slip, by push, simulate and whole orbits, against 113 bits; RESTS=300 tries
 * more than a test can afford, CHECK_SEED others, ANSWER_TELL=1 prints each lie
 * as it is found. */
#include "answers.h"
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(time_and_slip_to_rest_are_those_of_113_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
