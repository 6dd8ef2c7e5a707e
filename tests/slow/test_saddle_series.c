/* Series of time and slip around a saddle, held to what defines them. */
#include "saddle_series.h"

#include <float.h>

#include "cells_of.h"
#include "laws.h"
#include "steady.h"

/* ---- random saddles ------------------------------------------------------ */

static bool draw_scene(uint64_t *rng, struct scene *s)
{
    if (!laws_draw(check_bits(rng) % LAWS, rng, &s->law, &s->material))
        return false;
    const long double x = (long double) check_uniform(rng, -12, 12);
    if (x >= steady_x_max(&s->law))
        return false;
    s->tan_alpha = steady_mu(&s->law, &s->material, x);
    s->alpha = (double) atanl(s->tan_alpha);
    return s->tan_alpha > 0.02L && s->tan_alpha < 5.0L;
}

static void draw(uint64_t *rng, struct slope *s, struct saddle_series *u)
{
    struct fault why;

    for (int attempt = 0; attempt < 2000; attempt++) {
        slope_scene(&s->scene, "spinodal", NULL, "0.34", steady_only);
        if (draw_scene(rng, &s->scene) &&
            study_run(&s->study, &s->scene, NULL, &why) == STATUS_OK) {
            if (slider_saddle(&s->study.slider) >= 0 &&
                saddle_series_find(&s->study.slider, u) == STATUS_OK)
                return;
            study_free(&s->study);
        }
        scene_free(&s->scene);
    }
    fail_msg("no saddle");
}

/* ---- what they are ------------------------------------------------------- */

/* The rates of the offset z. */
static struct vec2 drift(const struct study *s, struct vec2 z)
{
    struct planar_field f;

    s->slider.plane.system.field(s->slider.plane.system.ctx, z, &f);
    return vec2_scale(exp(f.log_scale), f.direction);
}

/* grad p . f = lambda p, and grad q . f = v_sp - v, to what the errors of p and
 * q, and roundings, may do. */
static void check_point(const struct study *s, const struct saddle_series *u,
                        struct vec2 z, const struct saddle_point *at)
{
    const struct vec2 f = drift(s, z);
    const double rates = u->lambda + u->fast;
    const double size = fabs(f.x) + fabs(f.y) + rates * (fabs(z.x) + fabs(z.y));
    const double p = at->p_x * f.x + at->p_y * f.y - u->lambda * at->p;
    const double q = at->q_x * f.x + at->q_y * f.y + u->v * expm1(z.x);
    const double steps = (double) (u->order * u->order);
    const double lost = 1e3 * DBL_EPSILON * size;

    CHECK(fabs(p) <= steps * rates * at->p_error +
                         lost * (fabs(at->p_x) + fabs(at->p_y)),
          "z (%g, %g): %g of %g, error %g, rates %g, mixed %zu", z.x, z.y, p,
          u->lambda * at->p, at->p_error, rates, u->mixed);
    CHECK(fabs(q) <= steps * rates * at->q_error +
                         lost * (fabs(at->q_x) + fabs(at->q_y)) +
                         1e3 * DBL_EPSILON * u->v * fabs(z.x),
          "z (%g, %g): %g of %g, error %g, rates %g, mixed %zu", z.x, z.y, q,
          u->v * z.x, at->q_error, rates, u->mixed);
}

static void they_grow_and_are_left_behind_as_they_should(void **state)
{
    uint64_t rng = check_seed();
    size_t points = 0, saddles = 60, wide = 0;

    (void) state;
    for (size_t i = 0; i < saddles; i++) {
        static struct slope s;
        struct saddle_series u;
        struct saddle_point at;
        draw(&rng, &s, &u);
        wide += u.radius * u.unit > 1e-3;
        for (int k = 0; k < 40; k++) {
            const double d = u.unit * u.reach * laws_power(&rng, -9, 0);
            const double y = d * check_uniform(&rng, -1, 1);
            double slope;
            const double w = d * check_uniform(&rng, -1, 1);
            const struct vec2 z = { saddle_series_x(&u, y, &slope) + w, y };
            if (!saddle_series_at(&u, z, &at))
                continue;
            points++;
            check_point(&s.study, &u, z, &at);
        }
        slope_free(&s);
    }
    print_message("# %zu points, %zu of %zu saddles beyond 1e-3\n", points,
                  wide, saddles);
    CHECK(points > 20 * saddles && wide > saddles / 2, "%zu, %zu", points,
          wide);
}

/* On the curve, p is that of y and back. */
static void a_point_of_the_curve_is_found_by_its_p(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 20; i++) {
        static struct slope s;
        struct saddle_series u;
        draw(&rng, &s, &u);
        for (double part = -1.0; part < 1.0; part += 0.13) {
            const double y = part * part * part * u.unit * u.radius;
            const struct saddle_point on = saddle_series_on(&u, y);
            CHECK(fabs(saddle_series_y(&u, on.p) - y) <= 1e-14 * fabs(y),
                  "y %g: %g", y, saddle_series_y(&u, on.p) - y);
        }
        slope_free(&s);
    }
}

/* No further than half the way to where the series, or a node, change. */
static void beyond_their_reach_they_say_nothing(void **state)
{
    struct saddle_point at;
    struct saddle_series u;
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    assert_int_equal(saddle_series_find(&s.study.slider, &u), STATUS_OK);
    const double far = 1.01 * u.reach * u.unit;
    const struct saddle_point on = saddle_series_on(&u, far);
    CHECK(u.reach * u.unit > 0.01, "%g", u.reach);
    assert_true(saddle_series_at(&u, (struct vec2){ 0.5 * far, 0.0 }, &at));
    assert_false(saddle_series_at(&u, (struct vec2){ on.x, far }, &at));
    assert_false(saddle_series_at(&u, (struct vec2){ far, 0.0 }, &at));
    assert_false(saddle_series_at(&u, (struct vec2){ NAN, 0.0 }, &at));
    assert_false(saddle_series_at(&u, (struct vec2){ 0.0, NAN }, &at));
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(they_grow_and_are_left_behind_as_they_should),
        cmocka_unit_test(a_point_of_the_curve_is_found_by_its_p),
        cmocka_unit_test(beyond_their_reach_they_say_nothing),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
