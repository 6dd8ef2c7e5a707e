/* States side by side against one after the other. */
#include "layer_lanes.h"

#include "slope.h"

enum { N = 150 };
static const char *const steady_only[] = { "products=[equilibria]", NULL };

struct place {
    struct slope s;
    struct slow_curve c;
    struct layer_job job[N];
};

static void make(struct place *p, const char *law, uint64_t *seed)
{
    slope_make(&p->s, law, NULL, "0.34", steady_only);
    assert_int_equal(slow_curve_init(&p->c, &p->s.study.slider, NULL),
                     STATUS_OK);
    for (int i = 0; i < N; i++) {
        const struct vec2 z = { check_uniform(seed, -6, 9),
                                check_uniform(seed, -6, 6) };
        p->job[i].z = vec2_sub(z, p->s.study.slider.plane.system.origin);
        p->job[i].options = layer_defaults(i % 2 ? 1e-6 : 1e-4);
        p->job[i].options.peaks = false;
    }
}

static void drop(struct place *p)
{
    slow_curve_free(&p->c);
    slope_free(&p->s);
}

static void check_same(const struct layer_job *job, const struct layer *a,
                       const struct layer *b)
{
    CHECK(a->end == b->end, "(%.17g, %.17g): end %d, not %d", job->z.x,
          job->z.y, a->end, b->end);
    if (a->end != LAYER_LANDED && a->end != LAYER_RESTED)
        return;
    CHECK(fabs(a->time - b->time) <= 0.01 * (a->time_error + b->time_error),
          "(%.17g, %.17g): %.15g, not %.15g", job->z.x, job->z.y, a->time,
          b->time);
    CHECK(fabs(a->slip - b->slip) <= 0.01 * (a->slip_error + b->slip_error),
          "(%.17g, %.17g): %.15g, not %.15g", job->z.x, job->z.y, a->slip,
          b->slip);
}

static void every_width_gives_what_one_by_one_gives(void **state)
{
    static const char *const law[] = { "spinodal_gen", "spinodal",
                                       "dieterich_gen", "spinodal_phi_gen" };
    static struct layer wide[N];
    uint64_t seed = check_seed();
    struct place p;

    (void) state;
    for (int k = 0; k < 4; k++) {
        make(&p, law[k], &seed);
        for (int most = 1; most <= 8; most *= 2) {
            layer_lanes_follow(&p.c, layer_lanes_width(most), p.job, N, wide);
            for (int i = 0; i < N; i++) {
                struct layer one;
                layer_follow(&p.c, p.job[i].z, &p.job[i].options, &one);
                check_same(&p.job[i], &wide[i], &one);
            }
        }
        drop(&p);
    }
}

static void the_bits_of_a_state_do_not_depend_on_the_others(void **state)
{
    const int width = layer_lanes_width(8);
    static struct layer all[N], some[N];
    uint64_t seed = check_seed();
    struct place p;

    (void) state;
    make(&p, "spinodal_gen", &seed);
    layer_lanes_follow(&p.c, width, p.job, N, all);
    layer_lanes_follow(&p.c, width, p.job + 40, 37, some);
    for (int i = 0; i < 37; i++) {
        assert_int_equal(all[40 + i].steps, some[i].steps);
        assert_memory_equal(&all[40 + i].time, &some[i].time,
                            4 * sizeof(double));
    }
    layer_lanes_follow(&p.c, width, p.job, 0, some);
    layer_lanes_follow(&p.c, width, p.job + 3, 1, some);
    assert_memory_equal(&all[3].time, &some[0].time, 4 * sizeof(double));
    drop(&p);
}

static void the_bits_of_a_state_do_not_depend_on_the_width(void **state)
{
    static const char *const law[] = { "spinodal_gen", "dieterich_gen" };
    static struct layer two[N], wide[N];
    uint64_t seed = check_seed();
    struct place p;

    (void) state;
    for (int k = 0; k < 2; k++) {
        make(&p, law[k], &seed);
        layer_lanes_follow(&p.c, 2, p.job, N, two);
        for (int most = 1; most <= 8; most *= 2) {
            layer_lanes_follow(&p.c, layer_lanes_width(most), p.job, N, wide);
            for (int i = 0; i < N; i++) {
                assert_int_equal(two[i].steps, wide[i].steps);
                assert_memory_equal(&two[i].time, &wide[i].time,
                                    4 * sizeof(double));
            }
        }
        drop(&p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_width_gives_what_one_by_one_gives),
        cmocka_unit_test(the_bits_of_a_state_do_not_depend_on_the_others),
        cmocka_unit_test(the_bits_of_a_state_do_not_depend_on_the_width),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
