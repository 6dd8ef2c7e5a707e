/* Runs that are too near the separatrix to be followed have the numbers of the
 * slow curve, within their bars of 113 bits. */
#include "near_runs.h"

#include "answers.h"
#include "simulation.h"
#include "start_numbers.h"

enum { STARTS = 4 };

/* Beside the saddle, 1e-10 to 2e-9 of v away. */
static void draw_starts(const struct draw *d, uint64_t *rng,
                        struct scene_start start[STARTS])
{
    const struct block *b = &d->study.slider.block;

    for (size_t i = 0; i < STARTS; i++) {
        const double off = laws_power(rng, -10, -8.7);
        start[i] = (struct scene_start){
            .v = b->at.v0 * (i % 2 ? 1.0 + off : 1.0 - off), .psi = b->at.psi0
        };
    }
}

/* Within its bar and what that of 113 bits leaves, where push has it. */
static void hold(const struct draw *d, enum cell_field k,
                 const struct quantity *q, const struct quad_orbit *truth)
{
    const double off = (double) fabsq((quad) q->value - truth->value[k]);

    CHECK(quantity_exists(q), "%s: field %d: %s", d->name, (int) k, q->reason);
    CHECK(off <= q->error + truth->error[k],
          "%s: field %d: %.17g +- %.2g is off by %.2g", d->name, (int) k,
          q->value, q->error, off);
}

/* Whether it is one of those whose numbers are finite. */
static bool hold_run(const struct draw *d, const struct transient_summary *sum)
{
    const bool stays = sum->fate == FATE_CREEP || sum->fate == FATE_SLIDING ||
                       sum->fate == FATE_REST_FINITE;

    if (sum->end != TRANSIENT_NEAR || !stays)
        return false;
    const struct quad_orbit truth =
        truth_at(d, (struct push_state){ sum->v, sum->psi });
    CHECK(sum->fate == (int8_t) truth.fate, "%s: %s, not %s", d->name,
          fate_names[sum->fate], fate_names[truth.fate]);
    hold(d, CELL_TIME, &sum->time, &truth);
    hold(d, CELL_SLIP, &sum->slip, &truth);
    hold(d, CELL_MU_MEAN, &sum->mu_mean, &truth);
    return true;
}

/* The same alone as among others. */
static void hold_alone(const struct draw *d, const struct scene *scene,
                       const struct transient_summary *sum)
{
    const struct scene_start at = { .v = sum->v, .psi = sum->psi };
    struct study s = d->study;
    struct start_numbers n;

    s.scene = scene;
    assert_int_equal(start_numbers_find(&s, at, NULL, &n), STATUS_OK);
    assert_int_equal(n.sum.end, sum->end);
    assert_true(n.sum.time.value == sum->time.value);
    assert_true(n.sum.slip.error == sum->slip.error);
}

static size_t hold_slope(const char *law, const char *alpha, uint64_t *rng)
{
    static struct draw d;
    static struct simulation sim;
    struct scene_start start[STARTS];
    struct fault why;
    size_t held = 0;

    slope_scene(&d.scene, law, NULL, alpha, grid);
    assert_true(make(&d));
    snprintf(d.name, sizeof d.name, "%s at %s", law, alpha);
    draw_starts(&d, rng, start);
    struct scene scene = d.steady;
    scene.start = start;
    scene.starts = STARTS;
    assert_int_equal(simulation_run(&sim, &scene, NULL, &why), STATUS_OK);
    for (size_t i = 0; i < STARTS; i++)
        if (hold_run(&d, &sim.run[i].sum)) {
            if (held++ == 0)
                hold_alone(&d, &scene, &sim.run[i].sum);
            assert_non_null(sim.run[i].reason);
        }
    simulation_free(&sim);
    release(&d);
    return held;
}

static void what_is_not_followed_is_told_by_the_slow_curve(void **state)
{
    static const char *const law[] = { "spinodal_gen", "dieterich_gen",
                                       "spinodal" };
    static const char *const alpha[] = { "0.34", "0.36" };
    uint64_t rng = check_seed();
    size_t held = 0;

    (void) state;
    if (laws_emulated())
        skip();
    for (int i = 0; i < 3; i++)
        held += hold_slope(law[i], alpha[i % 2], &rng);
    print_message("# CHECK_SEED=%llu: %zu runs\n",
                  (unsigned long long) check_seed(), held);
    CHECK(held >= STARTS, "%zu runs", held);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_not_followed_is_told_by_the_slow_curve),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
