/* The 113-bit orbits of quad_orbit.h: against themselves at a far finer
 * tolerance, the balance of energy, what linear theory says beside the saddle,
 * and orbits in double precision. */
#include "quad_orbit.h"

#include "cells_of.h"
#include "laws.h"

static const char *const law[] = { "spinodal_gen", "spinodal",
                                   "spinodal_phi_gen", "dieterich_gen" };
enum { PRESETS = sizeof law / sizeof *law };

static void make(struct slope *s, struct quad_slope *q, size_t i)
{
    slope_make(s, law[i % PRESETS], i / PRESETS % 2 ? "log" : "asinh", "0.34",
               steady_only);
    quad_slope_init(q, &s->study);
}

static bool arrives(const struct quad_orbit *o)
{
    return o->fate == FATE_CREEP || o->fate == FATE_SLIDING;
}

static void errors_bound_what_a_finer_tolerance_changes(void **state)
{
    static struct slope s;
    static struct quad_slope q;
    uint64_t rng = check_seed();
    struct quad_orbit coarse, fine;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < 2 * PRESETS; i++) {
        make(&s, &q, i);
        const quad x = q.at.x0 + (quad) check_uniform(&rng, -4, 8);
        const quad y = q.at.y0 + (quad) check_uniform(&rng, -4, 4);
        quad_orbit_find(&q, x, y, 1e-8, &coarse);
        quad_orbit_find(&q, x, y, 1e-11, &fine);
        assert_int_equal(coarse.fate, fine.fate);
        for (int k = 0; k < CELL_FIELDS; k++) {
            const double off = (double) fabsq(coarse.value[k] - fine.value[k]);
            const double size = fabs((double) fine.value[k]);
            CHECK(isnan(coarse.error[k]) == isnan(fine.error[k]), "%d", k);
            CHECK(!(off > coarse.error[k]), "%s %d: %g > %g", law[i % PRESETS],
                  k, off, coarse.error[k]);
            CHECK(!(coarse.error[k] > 1e-10 * size), "%d: %g of %g", k,
                  coarse.error[k], size);
        }
        CHECK(coarse.defect < 1e-20, "%g", coarse.defect);
        slope_free(&s);
    }
}

/* From a point of the saddle's own direction, ten times nearer, it takes
 * ln 10/lambda_plus longer, at v_sp. */
static void slip_grows_by_v_sp_ln_10_per_decade_towards_the_saddle(void **state)
{
    static struct slope s;
    static struct quad_slope q;
    struct quad_orbit near, nearer;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < 2 * PRESETS; i++) {
        make(&s, &q, i);
        const struct equilibrium *e = phase_plane_saddle(&s.study.slider.plane);
        const double longer = log(10.0) / fmax(e->lambda[0], e->lambda[1]);
        const quad side = i % 3 == 0 && i % PRESETS != 3 ? -1 : 1;
        const quad far = side * (quad) 1e-9, beside = side * (quad) 1e-10;
        quad_orbit_find(&q, q.at.x0 + far, q.at.y0, 1e-8, &near);
        quad_orbit_find(&q, q.at.x0 + beside, q.at.y0, 1e-8, &nearer);
        if (!arrives(&near))
            continue;
        const double time =
            (double) (nearer.value[CELL_TIME] - near.value[CELL_TIME]);
        const double slip =
            (double) (nearer.value[CELL_SLIP] - near.value[CELL_SLIP]);
        CHECK(fabs(time / longer - 1.0) < 1e-8, "%.12g, not %.12g", time,
              longer);
        CHECK(fabs(slip / (longer * (double) q.at.v0) - 1.0) < 1e-8,
              "%.12g, not %.12g", slip, longer * (double) q.at.v0);
        slope_free(&s);
    }
}

static void orbits_in_double_precision_agree(void **state)
{
    static struct slope s;
    static struct quad_slope q;
    uint64_t rng = check_seed();
    struct fate_result r;
    struct quad_orbit o;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < 2 * PRESETS; i++) {
        make(&s, &q, i);
        const struct vec2 z = { (double) q.at.x0 + check_uniform(&rng, -4, 8),
                                (double) q.at.y0 + check_uniform(&rng, -4, 4) };
        quad_orbit_find(&q, (quad) z.x, (quad) z.y, 1e-8, &o);
        assert_int_equal(fate_find(&s.study.slider, z, 1e-12, true, NULL, &r),
                         0);
        assert_int_equal(o.fate, r.fate);
        const struct quantity told[] = { r.slip, r.time, r.mu_mean };
        for (int k = 0; k < 3; k++)
            CHECK(!arrives(&o) ||
                      fabs((double) o.value[k] / told[k].value - 1.0) < 1e-9,
                  "%s %d: %.15g, not %.15g", law[i % PRESETS], k,
                  (double) o.value[k], told[k].value);
        slope_free(&s);
    }
}

/* Ruina's slip has no limit. */
static void blocks_that_only_fade_are_followed_to_an_end(void **state)
{
    static const char *const fades[] = { "dieterich", "ruina", "perrin" };
    static struct slope s;
    static struct quad_slope q;
    struct fate_result r;
    struct quad_orbit o;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < sizeof fades / sizeof *fades; i++) {
        slope_make(&s, fades[i], "asinh", "0.1", steady_only);
        quad_slope_init(&q, &s.study);
        quad_orbit_find(&q, 0, 1, 1e-8, &o);
        assert_int_equal(o.fate, FATE_REST_ASYMPTOTIC);
        const double slip = (double) o.value[CELL_SLIP],
                     bar = o.error[CELL_SLIP];
        assert_int_equal(fate_find(&s.study.slider, (struct vec2){ 0.0, 1.0 },
                                   1e-12, true, NULL, &r),
                         0);
        assert_int_equal(r.fate, o.fate);
        assert_int_equal(isnan(bar), !quantity_exists(&r.slip));
        CHECK(isnan(bar) || (bar < 1e-9 * slip &&
                             fabs(r.slip.value - slip) <= r.slip.error + bar),
              "%s: %.15g +- %g, not %.15g +- %g", fades[i], r.slip.value,
              r.slip.error, slip, bar);
        slope_free(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_bound_what_a_finer_tolerance_changes),
        cmocka_unit_test(
            slip_grows_by_v_sp_ln_10_per_decade_towards_the_saddle),
        cmocka_unit_test(orbits_in_double_precision_agree),
        cmocka_unit_test(blocks_that_only_fade_are_followed_to_an_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
