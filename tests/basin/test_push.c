/* One state: its fate, its slip, and the kicks that would change the fate.
 *
 * PUSH_STATES=500 tries more states than a test can afford. */
#include "push.h"

#include "fault_alloc.h"
#include "found.h"
#include "pushed.h"
#include "stops.h"

#define NOTHING ((const char *const[]){ NULL })

static double enters_slow(const void *ctx, double s, const double u[])
{
    (void) ctx, (void) s;
    return fmin(-u[0], u[1]);
}

static double enters_fast(const void *ctx, double s, const double u[])
{
    (void) ctx, (void) s;
    return fmin(u[0], -u[1]);
}

/* The fate of a chart point by its L-stable orbit, until it enters one of the
 * saddle's quadrants that cannot be left, and by one from within that. */
static int followed(const struct pushed *p, struct vec2 z)
{
    static const struct event entry[] = {
        { .value = enters_slow, .direction = 1, .stop = true },
        { .value = enters_fast, .direction = 1, .stop = true },
    };
    const struct slider *s = &p->push.slider;
    struct orbit_options o =
        orbit_defaults(&s->plane.system, s->plane.fastest_rate);
    const struct vec2 offset = vec2_sub(z, s->plane.system.origin);
    const double u[2] = { offset.x, offset.y };
    bool slow = enters_slow(NULL, 0.0, u) > 0.0;
    struct fate_result r;
    struct orbit orbit;

    o.rtol = 1e-11;
    o.observables = 0;
    o.event = entry;
    o.events = 2;
    if (!slow && !(enters_fast(NULL, 0.0, u) > 0.0)) {
        assert_int_equal(orbit_init(&orbit, &s->plane.system, offset, &o),
                         STATUS_OK);
        assert_int_equal(orbit_run(&orbit, NULL), STATUS_OK);
        assert_int_equal(orbit.end, ORBIT_EVENT);
        slow = orbit.end_index == 0;
        orbit_free(&orbit);
    }
    const double way = slow ? -0.5 : 0.5;
    const struct vec2 within = { s->plane.system.origin.x + way,
                                 s->plane.system.origin.y - way };
    assert_int_equal(fate_find(s, within, 1e-5, false, NULL, &r), STATUS_OK);
    return (int) r.fate;
}

/* ---- random states ------------------------------------------------------- */

/* A push by `more` than the kick changes the fate, by `less` it does not. */
static bool check_kick(const struct pushed *p, struct vec2 z, struct vec2 axis,
                       double shift, double error, int fate)
{
    const double way = copysign(1e-9, shift);

    if (error > 1e-10)
        return false;
    const int over = followed(p, vec2_add(z, vec2_scale(shift + way, axis)));
    const int short_of =
        followed(p, vec2_add(z, vec2_scale(shift - way, axis)));
    CHECK(over != fate && short_of == fate,
          "(%.17g, %.17g) by (%.17g, %.17g): %s, then %s, then %s", z.x, z.y,
          shift * axis.x, shift * axis.y, fate_names[fate],
          fate_names[short_of], fate_names[over]);
    return true;
}

struct tally {
    int states, kicks;
};

static void check_state(const struct pushed *p, struct push_state at,
                        struct tally *t)
{
    const bool is_log = p->push.slider.plane.system.axis[1].is_log;
    const struct vec2 z = { log(at.v), is_log ? log(at.psi) : at.psi };
    const struct vec2 x = { 1.0, 0.0 }, y = { 0.0, 1.0 };
    const struct push_answer a = answer(p, at.v, at.psi);
    const int fate = followed(p, z);

    CHECK(a.fate == fate, "(%g, %g): %s, not %s", at.v, at.psi,
          fate_names[a.fate], fate_names[fate]);
    t->states++;
    if (quantity_exists(&a.v_kick))
        t->kicks += check_kick(p, z, x, log(a.v_kick.value),
                               a.v_kick.error / a.v_kick.value, fate);
    if (quantity_exists(&a.psi_kick))
        t->kicks +=
            is_log
                ? check_kick(p, z, y, log(a.psi_kick.value),
                             a.psi_kick.error / a.psi_kick.value, fate)
                : check_kick(p, z, y, a.psi_kick.value, a.psi_kick.error, fate);
}

static void random_states_meet_their_fates_and_kicks_just_change_them(
    void **state)
{
    static const struct {
        const char *law, *alpha;
    } slope[] = { { "spinodal_gen", "0.34" },
                  { "spinodal_gen", "0.30" },
                  { "dieterich_gen", "0.34" },
                  { "spinodal_phi_gen", "0.34" },
                  { "spinodal", "0.34" } };
    enum { SLOPES = sizeof slope / sizeof *slope };
    const char *asked = getenv("PUSH_STATES");
    const int states = (asked ? atoi(asked) : 60) / SLOPES;
    uint64_t rng = check_seed();
    struct tally t = { 0, 0 };

    (void) state;
    for (int k = 0; k < SLOPES; k++) {
        struct pushed p;
        push_make(&p, slope[k].law, slope[k].alpha);
        for (int i = 0; i < states; i++) {
            const double v = exp(check_uniform(&rng, -6.0, 10.0));
            const double psi = exp(check_uniform(&rng, -3.0, 4.0));
            check_state(&p, (struct push_state){ v, psi }, &t);
        }
        pushed_free(&p);
    }
    print_message("# %d states, %d kicks\n", t.states, t.kicks);
    CHECK(t.kicks > t.states, "%d kicks of %d states", t.kicks, t.states);
}

/* ---- far from the window ------------------------------------------------- */

/* psi beyond any window: v_plus itself is the boundary. */
static void far_up_the_boundary_is_v_plus(void **state)
{
    struct pushed p;

    (void) state;
    push_make(&p, "spinodal_gen", "0.34");
    const double v_plus = 2850.825709381503808; /* manifold.csv */
    for (double psi = 1e3; psi < 1e300; psi *= 1e140) {
        const struct push_answer a = answer(&p, 10.0, psi);
        assert_int_equal(a.fate, FATE_CREEP);
        CHECK(fabs(a.v_kick.value - v_plus / 10.0) <= a.v_kick.error,
              "psi = %g: %.17g +- %g", psi, a.v_kick.value, a.v_kick.error);
        CHECK(a.v_kick.error < 1e-8, "%g", a.v_kick.error);
    }
    pushed_free(&p);
}

/* Its lower branch meets v = 0 at a finite psi, the boundary of all rows. */
static void far_left_the_boundary_is_where_the_branch_meets_rest(void **state)
{
    struct pushed p;

    (void) state;
    push_make(&p, "spinodal", "0.34");
    const struct push_answer near = answer(&p, 1e-30, 1.0);
    for (double v = 1e-290; v < 1e-30; v *= 1e130) {
        const struct push_answer a = answer(&p, v, 1.0);
        CHECK(fabs(a.psi_kick.value - near.psi_kick.value) <=
                  a.psi_kick.error + near.psi_kick.error,
              "v = %g: %.17g", v, a.psi_kick.value);
        assert_int_equal(a.fate, near.fate);
    }
    assert_string_equal(answer(&p, 1e-30, 1e-3).v_kick.reason,
                        "no other fate at this psi, whatever v");
    pushed_free(&p);
}

/* First-order kinetics: at any v enough psi stops the block. */
static void an_open_upper_branch_bounds_every_row(void **state)
{
    static const char *const law[] = { "dieterich", "spinodal" };

    (void) state;
    for (int k = 0; k < 2; k++) {
        struct pushed p;
        double last = 0.0;
        push_make(&p, law[k], "0.34");
        for (double psi = 1.0; psi < 1e150; psi *= 1e70) {
            const struct push_answer a = answer(&p, 1.0, psi);
            CHECK(quantity_exists(&a.v_kick) && a.v_kick.value > last,
                  "%s, psi = %g: %g", law[k], psi, a.v_kick.value);
            last = a.v_kick.value;
        }
        pushed_free(&p);
    }
}

/* ---- what does not exist ------------------------------------------------- */

static void without_a_saddle_no_kick_helps(void **state)
{
    struct pushed p;

    (void) state;
    push_make(&p, "spinodal_gen", "0.28");
    const struct push_answer a = answer(&p, 1e3, 1.0);
    assert_int_equal(a.fate, FATE_CREEP);
    assert_true(quantity_exists(&a.slip) && quantity_exists(&a.time));
    assert_string_equal(a.v_kick.reason,
                        "no saddle at this slope, hence one fate for all");
    assert_string_equal(a.psi_kick.reason, a.v_kick.reason);
    pushed_free(&p);
}

/* Its row lies within rounding of the saddle's: the curve crosses it in a
 * quadrant that none enters. */
static void a_row_that_tells_no_side_tells_no_kick_but_why(void **state)
{
    static const struct found slope = { FRICTION_LOG,
                                        THETA_LN_PSI,
                                        PSI_SS_INVERSE,
                                        TIMESCALE_SLIP45,
                                        KINETICS_SINH,
                                        0.30679409801214763,
                                        0.0015800980408836364,
                                        0.002157697296548495,
                                        0.090047195388733667,
                                        152404.70346255755,
                                        8.7351094293370717e-05,
                                        3.7736697036127201e-08,
                                        0.2971439,
                                        1e-9 };
    struct pushed p;
    struct fault why;

    (void) state;
    found_scene(&slope, NOTHING, &p.scene);
    p.scene.tan_alpha = 0.306187118747734496939L;
    assert_int_equal(push_init(&p.push, &p.scene, NULL, &why), STATUS_OK);
    const struct push_answer a =
        answer(&p, exp(1.0508657316644456), exp(-1.0508657316645056));
    assert_string_equal(a.v_kick.reason,
                        "not every fate along this line is known");
    pushed_free(&p);
}

static void a_shift_of_psi_is_told_where_psi_is_a_logarithm(void **state)
{
    struct pushed p;

    (void) state;
    push_make(&p, "perrin", "0.34");
    const struct push_answer a = answer(&p, 3.0, 0.5);
    const struct push_answer b = answer(&p, 3.0, 0.75);
    CHECK(fabs(a.psi_kick.value - b.psi_kick.value - 0.25) < 1e-12,
          "%.17g, %.17g", a.psi_kick.value, b.psi_kick.value);
    assert_true(a.psi_kick.value < 0.0);
    pushed_free(&p);
}

/* ---- bars ---------------------------------------------------------------- */

/* transient.csv at v = 1e-10 */
static void bars_hold_the_truth(void **state)
{
    const double t = 0.8417232056933423, x = 0.4942932325338876;
    struct pushed p;

    (void) state;
    push_make(&p, "dieterich_gen", "0.34");
    const struct push_answer a = answer(&p, pow(10.0, 3.1), 100.0);
    assert_int_equal(a.fate, FATE_REST_FINITE);
    CHECK(fabs(a.time.value - t) <= a.time.error && a.time.error < 1e-8,
          "%.17g +- %g", a.time.value, a.time.error);
    CHECK(fabs(a.slip.value - x) <= a.slip.error && a.slip.error < 1e-8,
          "%.17g +- %g", a.slip.value, a.slip.error);
    const double eps2 = material_eps2(&p.push.slider.block.material);
    const double mean =
        tan(0.34) + eps2 * pow(10.0, 6.2) / (2.0 * cos(0.34) * x);
    CHECK(fabs(a.mu_mean.value - mean) <= a.mu_mean.error, "%.17g +- %g",
          a.mu_mean.value, a.mu_mean.error);
    pushed_free(&p);
}

static void hard_reference_states_are_told_apart_at_1e_9(void **state)
{
    struct pushed p;
    struct csv c;
    char alpha[64] = "";
    int rows = 0;

    (void) state;
    csv_open(&c, "basin.csv");
    while (csv_next(&c)) {
        if (!isfinite(row_distance(&c)))
            continue;
        if (strcmp(alpha, csv_text(&c, "alpha")) != 0) {
            if (alpha[0])
                pushed_free(&p);
            snprintf(alpha, sizeof alpha, "%s", csv_text(&c, "alpha"));
            push_make(&p, csv_text(&c, "law"), alpha);
        }
        const struct push_answer a =
            answer(&p, csv_number(&c, "v0", 0), csv_number(&c, "psi0", 0));
        CHECK(a.fate == row_fate(&c), "row %zu: %s", c.row, fate_names[a.fate]);
        rows++;
    }
    pushed_free(&p);
    assert_int_equal(rows, 61);
}

/* ---- many and errors ----------------------------------------------------- */

static void states_outside_the_domain_are_refused(void **state)
{
    const struct push_state bad[] = { { 0.0, 1.0 },   { -1.0, 1.0 },
                                      { 1.0, 0.0 },   { 1e301, 1.0 },
                                      { NAN, 1.0 },   { 1.0, NAN },
                                      { INFINITY, 1 } };
    struct push_answer a;
    struct pushed p;

    (void) state;
    push_make(&p, "spinodal_gen", "0.34");
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        CHECK(push_find(&p.push, bad[i], NULL, &a) == STATUS_BAD_ARGUMENT &&
                  !push_holds(&p.push, bad[i]),
              "(%g, %g)", bad[i].v, bad[i].psi);
    pushed_free(&p);
}

static void a_monitor_stops_it(void **state)
{
    const struct monitor monitor = { stop_at_once, NULL };
    const struct push_state at = { 1e3, 1.0 };
    struct push_answer a;
    struct fault why;
    struct pushed p;

    (void) state;
    push_make(&p, "spinodal_gen", "0.34");
    assert_int_equal(push_find_all(&p.push, &at, 1, &monitor, &a),
                     STATUS_STOPPED);
    assert_int_equal(push_tabulate(&p.push, &monitor), STATUS_STOPPED);
    assert_int_equal(push_find(&p.push, at, NULL, &a), STATUS_OK);
    push_free(&p.push);
    assert_int_equal(push_init(&p.push, &p.scene, &monitor, &why),
                     STATUS_STOPPED);
    scene_free(&p.scene);
}

static void every_allocation_may_fail(void **state)
{
    enum status status = STATUS_NO_MEMORY;
    struct push_answer a;
    struct fault why;
    struct pushed p;
    long k = 0;

    (void) state;
    slope_scene(&p.scene, "spinodal_gen", NULL, "0.34", NOTHING);
    for (; status == STATUS_NO_MEMORY; k += 1 + k / 20) {
        fault_alloc_at(k);
        status = push_init(&p.push, &p.scene, NULL, &why);
        if (status == STATUS_OK)
            status = push_tabulate(&p.push, NULL);
        if (status == STATUS_OK)
            status =
                push_find(&p.push, (struct push_state){ 1e3, 10.0 }, NULL, &a);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        push_free(&p.push);
    }
    assert_int_equal(status, STATUS_OK);
    CHECK(k > 20, "%ld allocations", k);
    scene_free(&p.scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            random_states_meet_their_fates_and_kicks_just_change_them),
        cmocka_unit_test(far_up_the_boundary_is_v_plus),
        cmocka_unit_test(far_left_the_boundary_is_where_the_branch_meets_rest),
        cmocka_unit_test(an_open_upper_branch_bounds_every_row),
        cmocka_unit_test(without_a_saddle_no_kick_helps),
        cmocka_unit_test(a_row_that_tells_no_side_tells_no_kick_but_why),
        cmocka_unit_test(a_shift_of_psi_is_told_where_psi_is_a_logarithm),
        cmocka_unit_test(bars_hold_the_truth),
        cmocka_unit_test(hard_reference_states_are_told_apart_at_1e_9),
        cmocka_unit_test(states_outside_the_domain_are_refused),
        cmocka_unit_test(a_monitor_stops_it),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
