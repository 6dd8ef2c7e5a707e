/* States that fall onto the slow curve. */
#include "fast_layer.h"

#include "any_law.h"
#include "place.h"
#include "tolerance.h"

static struct layer_job job_at(const struct place *p, struct vec2 z,
                               double rtol)
{
    return (struct layer_job){
        vec2_sub(z, p->s.study.slider.plane.system.origin), layer_defaults(rtol)
    };
}

static struct layer follow(const struct place *p, struct vec2 z, double rtol)
{
    const struct layer_job job = job_at(p, z, rtol);
    struct layer l;

    layer_follow(&p->c, layer_width(8), &job, 1, &l);
    return l;
}

/* Against the whole orbit. */
static void check_state(const struct place *p, struct vec2 z, double rtol)
{
    const struct layer l = follow(p, z, rtol);
    struct fate_result r;

    if (l.end == LAYER_LOST || l.end == LAYER_UNSURE)
        return;
    assert_int_equal(fate_find(&p->s.study.slider, z, 1e-10, true, NULL, &r),
                     STATUS_OK);
    CHECK((int8_t) r.fate == l.fate, "(%g, %g): %s, not %s", z.x, z.y,
          fate_names[l.fate], fate_names[r.fate]);
    if (l.end == LAYER_RAN)
        return;
    /* an orbit's own error sums are no bounds */
    const double more = 1e-7;
    CHECK(fabs(l.time - r.time.value) <= l.time_error + more * l.time,
          "(%.17g, %.17g): %.12g +- %g, not %.12g", z.x, z.y, l.time,
          l.time_error, r.time.value);
    CHECK(fabs(l.slip - r.slip.value) <= l.slip_error + more * l.slip,
          "(%.17g, %.17g): %.12g +- %g, not %.12g", z.x, z.y, l.slip,
          l.slip_error, r.slip.value);
}

static void slip_and_time_are_those_of_the_whole_orbit(void **state)
{
    static const struct {
        const char *law, *alpha;
    } at[] = { { "spinodal_gen", "0.34" },
               { "spinodal", "0.30" },
               { "spinodal_phi_gen", "0.38" },
               { "dieterich_gen", "0.34" } };
    uint64_t seed = check_seed();

    (void) state;
    for (int i = 0; i < 4; i++) {
        struct place p;
        place_make(&p, at[i].law, at[i].alpha);
        for (int k = 0; k < 12; k++) {
            const struct vec2 z = { check_uniform(&seed, -8, 9),
                                    check_uniform(&seed, -8, 8) };
            check_state(&p, z, k % 2 ? 1e-6 : 1e-9);
        }
        place_drop(&p);
    }
}

static void most_states_land_in_a_few_steps(void **state)
{
    uint64_t seed = check_seed();
    size_t landed = 0, steps = 0;
    struct place p;

    (void) state;
    place_make(&p, "spinodal_gen", "0.34");
    for (int k = 0; k < 200; k++) {
        const struct vec2 z = { check_uniform(&seed, -8, 9),
                                check_uniform(&seed, -8, 8) };
        const struct layer l = follow(&p, z, 1e-6);
        landed += l.end == LAYER_LANDED;
        steps += l.steps;
    }
    CHECK(landed >= 180, "%zu of 200", landed);
    CHECK(steps < 200 * 40, "%zu steps", steps);
    place_drop(&p);
}

/* At 1e-14 a step, over a hundred e-folds. */
static void what_patches_are_sampled_with_lands(void **state)
{
    uint64_t seed = check_seed();
    size_t landed = 0;
    struct place p;

    (void) state;
    place_make(&p, "dieterich", "0.34");
    for (int k = 0; k < 200; k++) {
        const struct vec2 z = { check_uniform(&seed, -13.8, 13.8),
                                check_uniform(&seed, -6.9, 4.6) };
        struct layer_job job = job_at(&p, z, 2e-12);
        struct layer l;
        job.options.peaks = false;
        job.options.through = true;
        layer_follow(&p.c, layer_width(8), &job, 1, &l);
        landed += l.end != LAYER_LOST;
    }
    CHECK(landed >= 198, "%zu of 200", landed);
    place_drop(&p);
}

/* Nearer the separatrix bars grow like 1/distance, and never too little. */
static void bars_grow_towards_the_separatrix(void **state)
{
    struct place p;
    double before = 0.0;

    (void) state;
    place_make(&p, "spinodal_gen", "0.34");
    const double x = log(2850.8257094); /* v_plus */
    for (double q = 1e-2; q > 1e-6; q *= 0.1) {
        const struct vec2 z = { x - q, 5.0 };
        const struct layer l = follow(&p, z, 1e-9);
        assert_int_equal(l.fate, FATE_CREEP);
        CHECK(l.time_error > before, "q %g: %g after %g", q, l.time_error,
              before);
        before = l.time_error;
        check_state(&p, z, 1e-9);
    }
    assert_int_equal(follow(&p, (struct vec2){ x + 1e-4, 5.0 }, 1e-9).fate,
                     FATE_SLIDING);
    place_drop(&p);
}

/* Of loose steps, whose true errors are far above those of the whole orbit;
 * these states slide most of their way before they land. */
static void bars_hold_what_loose_steps_miss(void **state)
{
    uint64_t seed = check_seed();
    struct place p;

    (void) state;
    place_make(&p, "spinodal", "0.2");
    for (int k = 0; k < 40; k++) {
        const struct vec2 z = { check_uniform(&seed, 7, 9.5),
                                check_uniform(&seed, -8, 9) };
        check_state(&p, z, 1e-2);
    }
    place_drop(&p);
}

/* ---- bars ---------------------------------------------------------------- */

enum { LAWS_TRIED = 48, STATES_OF_LAW = 6, ASKED = 3, MOST = 4096 };

struct ratios {
    size_t count;
    double of[MOST]; /* bars over true errors, but for the table's */
};

static int rising(const void *a, const void *b)
{
    const double x = *(const double *) a, y = *(const double *) b;
    return (x > y) - (x < y);
}

/* Finer ones are known a lot better. */
static void compare(struct ratios *r, const char *name, struct vec2 z,
                    double value, double bar, double fine, double fine_bar)
{
    const double off = fabs(value - fine);

    CHECK(off <= bar + fine_bar, "%s (%.17g, %.17g): %.17g +- %g, not %.17g",
          name, z.x, z.y, value, bar, fine);
    if (fine_bar < 0.01 * bar && r->count < MOST)
        r->of[r->count++] = bar / fmax(off, fine_bar);
}

static void try_state(const struct place *p, const char *name, struct vec2 z,
                      struct ratios *r)
{
    const struct layer fine = follow(p, z, 1e-11);

    for (int i = 0; i < ASKED && fine.end == LAYER_LANDED; i++) {
        const struct layer l = follow(p, z, pow(100.0, -2.0 - i));
        if (l.end != LAYER_LANDED || l.fate == FATE_REST_ASYMPTOTIC)
            continue;
        compare(r, name, z, l.time, l.time_error, fine.time, fine.time_error);
        compare(r, name, z, l.slip, l.slip_error, fine.slip, fine.slip_error);
    }
}

/* Half of them within 100 of the error, where a bound that takes terms to fall
 * as those of place or time alone has 160 to 200. */
static void bars_of_any_law_hold_and_are_not_much_wider_than_the_error(
    void **state)
{
    uint64_t seed = check_seed();
    static struct ratios r;
    static struct place p;
    char name[DRAWN_NAME];
    struct fault why;

    (void) state;
    for (size_t i = 0; i < LAWS_TRIED; i++) {
        slope_scene(&p.s.scene, "spinodal", NULL, "0.34", steady_only);
        if (!drawn_law(i, &seed, &p.s.scene) ||
            !drawn_slope(&seed, &p.s.scene) ||
            study_run(&p.s.study, &p.s.scene, NULL, &why) != STATUS_OK) {
            scene_free(&p.s.scene);
            continue;
        }
        assert_int_equal(slow_curve_init(&p.c, &p.s.study.slider, NULL), 0);
        drawn_name(i, &p.s.scene, name);
        const struct planar *plane = &p.s.study.slider.plane.system;
        for (int k = 0; k < STATES_OF_LAW; k++) {
            const struct vec2 from = { check_uniform(&seed, -10, 10),
                                       check_uniform(&seed, -5, 5) };
            const struct vec2 z = vec2_add(plane->origin, from);
            if (box_holds(plane->domain, z))
                try_state(&p, name, z, &r);
        }
        place_drop(&p);
    }
    qsort(r.of, r.count, sizeof *r.of, rising);
    print_message("# %zu bars, half within %.3g of the error\n", r.count,
                  r.of[r.count / 2]);
    CHECK(r.count > 100 && r.of[r.count / 2] < 100.0, "%zu: %g", r.count,
          r.of[r.count / 2]);
}

static void a_box_of_arrest_may_be_entered_before_landing(void **state)
{
    struct place p;

    (void) state;
    place_make(&p, "spinodal", "0.34");
    const struct vec2 node = p.s.study.slider.plane.equilibrium[0].z;
    const struct vec2 inside = { node.x + 0.005, node.y - 0.005 };
    const struct vec2 level = { node.x + 3.0, node.y + 0.004 };
    assert_int_equal(follow(&p, inside, 1e-6).end, LAYER_LOST);
    assert_int_equal(follow(&p, level, 1e-6).end, LAYER_LANDED);
    check_state(&p, level, 1e-6);
    place_drop(&p);
}

static void a_runaway_is_known_at_once(void **state)
{
    struct place p;

    (void) state;
    place_make(&p, "dieterich_gen", "0.34");
    const struct vec2 o = p.s.study.slider.plane.system.origin;
    const struct layer l =
        follow(&p, (struct vec2){ o.x + 1.0, o.y - 1.0 }, 1e-6);
    assert_int_equal(l.end, LAYER_RAN);
    assert_int_equal(l.fate, FATE_RUNAWAY);
    assert_int_equal(l.steps, 0);
    place_drop(&p);
}

/* What it has to fall yet decays before it comes there. */
static void friction_s_peak_ahead_on_the_curve_is_known_far_from_it(
    void **state)
{
    struct place p;

    (void) state;
    place_make(&p, "spinodal_gen", "0.34");
    const struct vec2 origin = p.s.study.slider.plane.system.origin;
    const struct vec2 at = vec2_add(origin, (struct vec2){ -5.348, -2.941 });
    const struct layer l = follow(&p, at, 1e-8);
    assert_int_equal(l.end, LAYER_LANDED);
    CHECK(l.steps < 100, "%zu steps", l.steps);
    CHECK(l.mu.most - l.mu.value < 1e-8, "%g", l.mu.most - l.mu.value);
    place_drop(&p);
}

/* ---- side by side -------------------------------------------------------- */

enum { N = 150 };

/* Of a third peaks are asked for as well. */
static void make_jobs(const struct place *p, uint64_t *seed,
                      struct layer_job job[])
{
    for (int i = 0; i < N; i++) {
        const struct vec2 z = { check_uniform(seed, -6, 9),
                                check_uniform(seed, -6, 6) };
        job[i] = job_at(p, z, i % 2 ? 1e-6 : 1e-4);
        job[i].options.peaks = i % 3 == 0;
    }
}

static void check_same(const struct layer *a, const struct layer *b)
{
    assert_int_equal(a->end, b->end);
    assert_int_equal(a->steps, b->steps);
    assert_memory_equal(&a->time, &b->time, 4 * sizeof(double));
    assert_memory_equal(&a->x, &b->x, 2 * sizeof a->x + sizeof(double));
}

static void the_bits_of_a_state_do_not_depend_on_the_others(void **state)
{
    static struct layer all[N], some[N];
    static struct layer_job job[N];
    const int width = layer_width(8);
    uint64_t seed = check_seed();
    struct place p;

    (void) state;
    place_make(&p, "spinodal_gen", "0.34");
    make_jobs(&p, &seed, job);
    layer_follow(&p.c, width, job, N, all);
    layer_follow(&p.c, width, job + 40, 37, some);
    for (int i = 0; i < 37; i++)
        check_same(&all[40 + i], &some[i]);
    layer_follow(&p.c, width, job, 0, some);
    layer_follow(&p.c, width, job + 3, 1, some);
    check_same(&all[3], &some[0]);
    place_drop(&p);
}

static void the_bits_of_a_state_do_not_depend_on_the_width(void **state)
{
    static const char *const law[] = { "spinodal_gen", "spinodal",
                                       "dieterich_gen", "spinodal_phi_gen" };
    static struct layer one[N], wide[N];
    static struct layer_job job[N];
    uint64_t seed = check_seed();
    struct place p;

    (void) state;
    for (int k = 0; k < 4; k++) {
        place_make(&p, law[k], "0.34");
        make_jobs(&p, &seed, job);
        layer_follow(&p.c, 1, job, N, one);
        for (int most = 2; most <= 8; most *= 2) {
            layer_follow(&p.c, layer_width(most), job, N, wide);
            for (int i = 0; i < N; i++)
                check_same(&one[i], &wide[i]);
        }
        place_drop(&p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slip_and_time_are_those_of_the_whole_orbit),
        cmocka_unit_test(most_states_land_in_a_few_steps),
        cmocka_unit_test(what_patches_are_sampled_with_lands),
        cmocka_unit_test(bars_grow_towards_the_separatrix),
        cmocka_unit_test(bars_hold_what_loose_steps_miss),
        cmocka_unit_test(
            bars_of_any_law_hold_and_are_not_much_wider_than_the_error),
        cmocka_unit_test(a_box_of_arrest_may_be_entered_before_landing),
        cmocka_unit_test(a_runaway_is_known_at_once),
        cmocka_unit_test(
            friction_s_peak_ahead_on_the_curve_is_known_far_from_it),
        cmocka_unit_test(the_bits_of_a_state_do_not_depend_on_the_others),
        cmocka_unit_test(the_bits_of_a_state_do_not_depend_on_the_width),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
