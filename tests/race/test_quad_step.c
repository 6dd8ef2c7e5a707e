/* Steps of y' = -y and z' = k z, whose solutions are known. */
#include "quad_step.h"

#include <math.h>

#include "check.h"
#include "laws.h"

struct pair {
    quad decay, growth;
    size_t *calls;
};

static void rates(const void *ctx, quad s, const quad y[QUAD_DIM],
                  quad dy[QUAD_DIM])
{
    const struct pair *p = ctx;

    (void) s;
    dy[0] = -p->decay * y[0];
    dy[1] = p->growth * y[1];
    ++*p->calls;
}

/* One step of length h from (1, 1); off: true errors. */
static struct quad_step take(double decay, double growth, double h,
                             double enough, double off[QUAD_DIM],
                             double error[QUAD_DIM], size_t *calls)
{
    const struct pair p = { (quad) decay, (quad) growth, calls };
    const quad from[QUAD_DIM] = { 1, 1 };
    const quad limit[QUAD_DIM] = { (quad) enough, (quad) enough };
    const quad true_decay = expq(-p.decay * (quad) h);
    const quad true_growth = expq(p.growth * (quad) h);
    quad to[QUAD_DIM], told[QUAD_DIM];

    *calls = 0;
    const struct quad_step step =
        quad_step(rates, &p, 0, (quad) h, from, limit, to, told);
    off[0] = (double) fabsq(to[0] - true_decay);
    off[1] = (double) fabsq(to[1] - true_growth);
    for (int i = 0; i < QUAD_DIM; i++)
        error[i] = (double) told[i];
    return step;
}

/* Rounding of the tableau apart. */
static void errors_bound_what_steps_are_off_by(void **state)
{
    const double enough[] = { 0.0, 1e-24, 1e-18, 1e-12, 1e-6 };
    double off[QUAD_DIM], error[QUAD_DIM];
    uint64_t seed = check_seed();
    size_t calls;

    (void) state;
    if (laws_emulated())
        skip();
    for (int k = 0; k < 1000; k++) {
        const double h = check_uniform(&seed, 0.01, 3.0);
        const double decay = check_uniform(&seed, 0.1, 1.0);
        const double growth = check_uniform(&seed, 0.1, 1.0);
        take(decay, growth, h, enough[k % 5], off, error, &calls);
        for (int i = 0; i < QUAD_DIM; i++)
            CHECK(off[i] <= error[i] + 1e-30,
                  "%d: off by %g, told %g, rates %g %g over %g", i, off[i],
                  error[i], decay, growth, h);
    }
}

static void a_step_ends_when_it_is_good_enough(void **state)
{
    const double enough[] = { 1e-4, 1e-9, 1e-14, 1e-19 };
    double off[QUAD_DIM], error[QUAD_DIM];
    int last = 0;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < 4; i++) {
        size_t calls;
        const struct quad_step step =
            take(1.0, 1.0, 0.5, enough[i], off, error, &calls);
        const size_t columns = (size_t) step.columns;
        CHECK(error[0] <= enough[i] && error[1] <= enough[i], "%g %g", error[0],
              error[1]);
        CHECK(step.columns >= last, "%d after %d", step.columns, last);
        assert_int_equal(calls, columns * columns + 2);
        last = step.columns;
    }
    assert_true(last > 4 && last < QUAD_STEP_COLUMNS);
}

/* However short a step's substeps, e^(-100 s) is over before the first. */
static void a_rate_that_decays_unseen_is_told(void **state)
{
    double off[QUAD_DIM], error[QUAD_DIM];
    size_t calls;

    (void) state;
    if (laws_emulated())
        skip();
    const struct quad_step seen =
        take(2.0, 0.1, 1.0, 1e-18, off, error, &calls);
    assert_true(seen.blind < 1.0);
    const struct quad_step unseen =
        take(6.0, 0.1, 1.0, 1e-4, off, error, &calls);
    CHECK(unseen.blind > 1.0 && error[0] > 0.1, "%g %g", unseen.blind,
          error[0]);
    CHECK(quad_step_factor(&unseen, 1e3) < 1.0, "%g",
          quad_step_factor(&unseen, 1e3));
    assert_true(quad_step_factor(&unseen, 0.5) <= 1.0);
}

static void steps_grow_where_errors_are_small(void **state)
{
    const struct quad_step step = { .columns = 8, .blind = 0.1 };

    (void) state;
    assert_true(quad_step_factor(&step, 0.0) > 1.0);
    assert_true(quad_step_factor(&step, 1e-6) > quad_step_factor(&step, 1e-2));
    assert_true(quad_step_factor(&step, 1.0) < 1.0);
    assert_true(quad_step_factor(&step, (double) NAN) ==
                quad_step_factor(&step, HUGE_VAL));
    assert_true(quad_step_factor(&step, (double) NAN) < 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_bound_what_steps_are_off_by),
        cmocka_unit_test(a_step_ends_when_it_is_good_enough),
        cmocka_unit_test(a_rate_that_decays_unseen_is_told),
        cmocka_unit_test(steps_grow_where_errors_are_small),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
