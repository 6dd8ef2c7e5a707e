#include "trace.h"

#include "block.h"
#include "law.h"
#include "level.h"

/* y^2 - x^3 */
static double cusp(const double p[], struct vec2 z, struct vec2 *g)
{
    (void) p;
    *g = (struct vec2){ -3.0 * z.x * z.x, 2.0 * z.y };
    return z.y * z.y - z.x * z.x * z.x;
}

/* x y - p0: two branches that all but touch */
static double hyperbola(const double p[], struct vec2 z, struct vec2 *g)
{
    *g = (struct vec2){ z.y, z.x };
    return z.x * z.y - p[0];
}

static void branches_that_all_but_touch_stay_apart(void **state)
{
    const struct window w = { .box = { { -1.0, -1.0 }, { 1.01, 1.02 } } };

    (void) state;
    for (int k = 2; k <= 8; k++) {
        const struct plain s = { .x = hyperbola,
                                 .y = one,
                                 .p = { pow(10.0, -k) } };
        const struct planar sys = planar_of(&s);
        struct nullcline n[NULLCLINES];
        find(&sys, &w, n);
        check_ends(&n[0], &w);
        CHECK(n[0].count == 2, "%zu pieces at 1e-%d", n[0].count, k);
        CHECK(worst(&s, s.x, &n[0]) < 1e-12, "off by %g", worst(&s, s.x, n));
        drop(n);
    }
}

static void cusps_are_loose_ends(void **state)
{
    const struct plain s = { .x = cusp, .y = one };
    const struct planar sys = planar_of(&s);
    const struct window w = { .box = { { -1.0, -1.1 }, { 1.0, 1.2 } } };
    struct nullcline n[NULLCLINES];

    (void) state;
    find(&sys, &w, n);
    assert_int_equal(n[0].count, 2);
    assert_int_equal(n[0].loose, 2);
    for (size_t k = 0; k < 2; k++) {
        const struct polyline *p = &n[0].piece[k];
        CHECK(fabs(p->at[0].x - 1.0) == 0.0, "starts at %g", p->at[0].x);
        CHECK(vec2_length(p->at[p->count - 1]) < 1e-3, "ends at (%g, %g)",
              p->at[p->count - 1].x, p->at[p->count - 1].y);
    }
    drop(n);
}

/* x' = x - 0.3 y, y' = exp(2000 y): direction.x underflows for y > 0.37. */
struct steep {
    bool keeps_sign;
};

static void steep_jacobian(const void *ctx, struct vec2 z,
                           struct planar_jacobian *J)
{
    const struct steep *s = ctx;
    const double scale = fmax(0.0, 2000.0 * z.y), e = exp(-scale);
    double x = (z.x - 0.3 * z.y) * e;

    if (x == 0.0 && !s->keeps_sign)
        x = 0.0;
    J->field = (struct planar_field){ { x, exp(2000.0 * z.y - scale) }, scale };
    J->matrix =
        (struct mat2){ e, -0.3 * e, 0.0, 2000.0 * J->field.direction.y };
}

static void steep_field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    struct planar_jacobian J;

    steep_jacobian(ctx, z, &J);
    *f = J.field;
    if (f->direction.x == 0.0 && !((const struct steep *) ctx)->keeps_sign)
        f->direction.x = 0.0;
}

static void check_on_steep_line(const struct nullcline *n)
{
    for (size_t k = 0; k < n->piece[0].count; k++) {
        const struct vec2 z = n->piece[0].at[k];
        CHECK(fabs(z.x - 0.3 * z.y) < 3e-11, "(%g, %g)", z.x, z.y);
    }
}

static void underflow_is_not_taken_for_a_zero(void **state)
{
    const struct window w = { .box = { { -1.0, -1.0 }, { 1.0, 1.0 } } };

    (void) state;
    for (int keeps = 0; keeps < 2; keeps++) {
        const struct steep s = { keeps };
        const struct planar sys = { .domain = { { -9.0, -9.0 }, { 9.0, 9.0 } },
                                    .field = steep_field,
                                    .jacobian = steep_jacobian,
                                    .ctx = &s };
        struct nullcline n[NULLCLINES];
        find(&sys, &w, n);
        assert_int_equal(n[1].count, 0);
        assert_int_equal(n[0].count, 1);
        assert_int_equal(n[0].loose, keeps ? 0 : 1);
        check_on_steep_line(&n[0]);
        const double top = n[0].piece[0].at[n[0].piece[0].count - 1].y;
        CHECK(keeps ? top == 1.0 : top > 0.3 && top < 0.373, "up to y = %g",
              top);
        drop(n);
    }
}

static void friction_nullclines_are_the_closed_forms(void **state)
{
    const struct material m = material_bristol_board();
    const struct law *law;
    size_t laws = 0;

    (void) state;
    for (size_t i = 0; (law = law_preset_at(i)); i++) {
        struct block b;
        struct nullcline n[NULLCLINES];
        const double y = law_psi_is_log(law) ? 1.0 : 0.0;
        const struct window w = { .box = { { -12.0, -11.5 - 10.0 * y },
                                           { 12.0, 11.0 + 10.0 * y } } };
        block_init(&b, law, &m, 0.35L);
        block_anchor(&b, -0.2L, false);
        const struct planar sys = block_planar(&b);
        find(&sys, &w, n);
        CHECK(n[0].count == 1 && n[0].loose == 0, "%s: %zu pieces, %zu loose",
              law->preset, n[0].count, n[0].loose);
        CHECK(n[1].count == 1 && n[1].loose == 0, "%s: %zu pieces, %zu loose",
              law->preset, n[1].count, n[1].loose);
        check_ends(&n[0], &w);
        check_ends(&n[1], &w);
        for (size_t k = 0; k < n[0].piece[0].count; k++) {
            const struct vec2 z = n[0].piece[0].at[k];
            const double mu = block_mu(&b, vec2_sub(z, sys.origin));
            CHECK(fabs(mu - 0.35) < 1e-12, "%s: mu = %.15g at (%g, %g)",
                  law->preset, mu, z.x, z.y);
        }
        for (size_t k = 0; k < n[1].piece[0].count; k++) {
            const struct vec2 z = n[1].piece[0].at[k];
            const double off = z.y - (double) sys.steady->y(&b, z.x);
            CHECK(fabs(off) < 1e-10, "%s: off by %g at (%g, %g)", law->preset,
                  off, z.x, z.y);
        }
        CHECK(n[0].evaluations + n[1].evaluations < 30000, "%zu evaluations",
              n[0].evaluations + n[1].evaluations);
        drop(n);
        laws++;
    }
    CHECK(laws > 5, "%zu laws", laws);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(branches_that_all_but_touch_stay_apart),
        cmocka_unit_test(cusps_are_loose_ends),
        cmocka_unit_test(underflow_is_not_taken_for_a_zero),
        cmocka_unit_test(friction_nullclines_are_the_closed_forms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
