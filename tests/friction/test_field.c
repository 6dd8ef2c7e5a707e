/* The field in double against the same formulas in 113 bits, and those against
 * the model as printed (plain.h).  Errors are compared with what rounding must
 * cost: 2^-53 times the condition number of each component, in which a sum
 * costs its largest term over its value and an exponent its own size. */
#include "block.h"

#include <math.h>

#include "condition.h"

#define LANES 2
#include "tape_lanes.h"

/* One component in double against 113 bits, unless it has underflown beside
 * the other one or no digit of its exponent can be known. */
static void check_component(const struct setting *s, struct vec2 z,
                            const char *name, double p, double log_scale,
                            quad q, quad exact_scale, quad cost)
{
    const quad bound = 8 * ULP * cost;

    CHECK(isfinite(p) && isfinite(log_scale),
          "law %zu at %g %g from %g %g: %s = %g exp(%g)", s->number, z.x, z.y,
          s->b.at.x0, s->b.at.y0, name, p, log_scale);
    if (fabsq(q) * expq(exact_scale - log_scale) < 1e-290 || !(bound < 0.5))
        return;
    const double off = (double) fabsq(log_ratio(p, log_scale, q, exact_scale));
    CHECK(off <= bound,
          "law %zu at %.17g %.17g from %g %g: %s = %g exp(%g), not %g exp(%g):"
          " off by %g, bound %g",
          s->number, z.x, z.y, s->b.at.x0, s->b.at.y0, name, p, log_scale,
          (double) q, (double) exact_scale, off, (double) bound);
}

static void check_real(const struct setting *s, struct vec2 z)
{
    struct planar_field f;
    struct quad_field q;

    tape_field(&s->b.plane, z, &f);
    quad_block_field(&s->at, z.x, z.y, &q);
    const struct condition c = condition_at(s, z.x, z.y, f.log_scale);
    check_component(s, z, "fx", f.direction.x, f.log_scale, q.direction[0],
                    q.log_scale, c.x);
    check_component(s, z, "fy", f.direction.y, f.log_scale, q.direction[1],
                    q.log_scale, c.y);
}

static void check_lanes(const struct setting *s, uint64_t *seed)
{
    lanes x[TAPE_SETS], y[TAPE_SETS], fx[TAPE_SETS], fy[TAPE_SETS],
        scale[TAPE_SETS];

    for (int i = 0; i < TAPE_SETS * LANES; i++) {
        const struct vec2 z =
            i % 2 ? draw_near(-1, 1.3, seed) : draw_near(-15, -1, seed);
        x[i / LANES][i % LANES] = z.x;
        y[i / LANES][i % LANES] = z.y;
    }
    tape_lanes_field(&s->b.plane.t, x, y, fx, fy, scale);
    for (int i = 0; i < TAPE_SETS * LANES; i++) {
        const int p = i / LANES, l = i % LANES;
        const struct vec2 z = { x[p][l], y[p][l] };
        struct quad_field q;
        quad_block_field(&s->at, z.x, z.y, &q);
        const struct condition c = condition_at(s, z.x, z.y, scale[p][l]);
        check_component(s, z, "fx of lanes", fx[p][l], scale[p][l],
                        q.direction[0], q.log_scale, 3 * c.x);
        check_component(s, z, "fy of lanes", fy[p][l], scale[p][l],
                        q.direction[1], q.log_scale, 3 * c.y);
    }
}

/* Of every law; anchors as far as the fast layer goes.  e^x of lanes is good to
 * four units of roundoff, not one, and a difference takes three of them: three
 * times what doubles may cost. */
static void the_field_of_points_side_by_side_is_exact(void **state)
{
    uint64_t seed = check_seed() + 6;
    struct setting s;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < LAWS * 4; i++)
        for (int k = 0; draw_setting(i, 20, &seed, &s) && k < 2; k++)
            check_lanes(&s, &seed);
}

static void the_field_is_exact_over_the_whole_range(void **state)
{
    uint64_t seed = check_seed();
    struct setting s;
    size_t points = 0;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < LAWS * 12; i++) {
        if (!draw_setting(i, i < LAWS * 8 ? 20 : 690, &seed, &s))
            continue;
        for (int k = 0; k < 24; k++, points++)
            check_real(&s, k % 3 == 0   ? draw_far(&s, &seed)
                           : k % 3 == 1 ? draw_near(-1, 1.3, &seed)
                                        : draw_near(-15, -1, &seed));
    }
    assert_true(points > 50000);
}

static void the_113_bit_field_is_the_model_s(void **state)
{
    uint64_t seed = check_seed() + 1;
    struct setting s;
    size_t points = 0;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < LAWS * 20; i++) {
        if (!draw_setting(i, i % 2 ? 5 : 300, &seed, &s))
            continue;
        for (int k = 0; k < 4; k++) {
            const struct vec2 z =
                k % 2 ? draw_far(&s, &seed) : draw_near(-2, 1, &seed);
            struct quad_field q;
            quad_block_field(&s.at, z.x, z.y, &q);
            const struct condition c = condition_at(&s, z.x, z.y, q.log_scale);
            const quad x = s.at.x0 + z.x, y = s.at.y0 + z.y;
            const struct plain_number fx =
                plain_fx(&s.law, &s.m, s.exact_tan, x, y);
            const struct plain_number fy = plain_fy(&s.law, &s.m, x, y);
            if (c.x + c.y > 1e5 || q.direction[0] == 0 || q.direction[1] == 0)
                continue; /* the plain formulas cancel; or underflow */
            points++;
            const quad off_x =
                logq(fabsq(q.direction[0])) + q.log_scale - fx.log_abs;
            const quad off_y =
                logq(fabsq(q.direction[1])) + q.log_scale - fy.log_abs;
            CHECK(q.direction[0] * fx.sign > 0 && fabsq(off_x) < 1e-24,
                  "law %zu: fx off by %g at %g %g, condition %g", s.number,
                  (double) off_x, (double) x, (double) y, (double) c.x);
            CHECK(q.direction[1] * fy.sign > 0 && fabsq(off_y) < 1e-24,
                  "law %zu: fy off by %g at %g %g, condition %g", s.number,
                  (double) off_y, (double) x, (double) y, (double) c.y);
        }
    }
    CHECK(points > 4000, "only %zu points", points);
}

/* Wherever the nullclines are not within a hundredth of the offset. */
static void near_the_anchor_no_digit_is_lost(void **state)
{
    uint64_t seed = check_seed() + 2;
    struct setting s;
    size_t points = 0;

    (void) state;
    for (size_t i = 0; i < LAWS * 20; i++) {
        if (!draw_setting(i, 7, &seed, &s))
            continue;
        set_anchor(&s, (double) s.x, 0, true);
        for (int k = -15; k <= -1; k++) {
            const struct vec2 z = draw_near(k, k, &seed);
            struct planar_field f;
            struct quad_field q;
            quad_block_field(&s.at, z.x, z.y, &q);
            const struct condition c = condition_at(&s, z.x, z.y, q.log_scale);
            if (c.x + c.y > 200)
                continue;
            points++;
            tape_field(&s.b.plane, z, &f);
            const quad off_x = log_ratio(f.direction.x, f.log_scale,
                                         q.direction[0], q.log_scale);
            const quad off_y = log_ratio(f.direction.y, f.log_scale,
                                         q.direction[1], q.log_scale);
            CHECK(fabsq(off_x) < 1e-13, "law %zu at 1e%d: fx off by %g",
                  s.number, k, (double) off_x);
            CHECK(fabsq(off_y) < 1e-13, "law %zu at 1e%d: fy off by %g",
                  s.number, k, (double) off_y);
        }
    }
    CHECK(points > 4000, "only %zu points", points);
}

static void at_an_equilibrium_the_field_is_exactly_zero(void **state)
{
    uint64_t seed = check_seed() + 3;
    struct setting s;
    struct planar_field f;
    size_t zeros = 0;

    (void) state;
    for (size_t i = 0; i < LAWS * 4; i++) {
        if (!draw_setting(i, 300, &seed, &s) ||
            !set_anchor(&s, (double) s.x, 0, true))
            continue;
        tape_field(&s.b.plane, (struct vec2){ 0, 0 }, &f);
        CHECK(f.direction.x == 0 && f.direction.y == 0 && isfinite(f.log_scale),
              "law %zu: %g %g", s.number, f.direction.x, f.direction.y);
        zeros++;
    }
    assert_true(zeros > LAWS);
}

/* (f(z + h) - f(z - h))/(2 h) in 113 bits, in units of exp(scale). */
static void quad_jacobian(const struct setting *s, struct vec2 z, quad scale,
                          quad h, quad J[2][2])
{
    for (int j = 0; j < 2; j++) {
        struct quad_field r, l;
        const quad dx = j == 0 ? h : 0, dy = j == 1 ? h : 0;
        quad_block_field(&s->at, z.x + dx, z.y + dy, &r);
        quad_block_field(&s->at, z.x - dx, z.y - dy, &l);
        for (int i = 0; i < 2; i++)
            J[i][j] = (r.direction[i] * expq(r.log_scale - scale) -
                       l.direction[i] * expq(l.log_scale - scale)) /
                      (2 * h);
    }
}

/* Relative to the largest number that meets in a row: its entries, the
 * component times the rate of its exponent, and the terms that cancel. */
static void check_row(const struct setting *s, struct vec2 z, const char *name,
                      double jx, double jy, const quad J[2], quad scale,
                      quad size)
{
    const quad off = fabsq(jx - J[0]) + fabsq(jy - J[1]);
    const quad bound = (1e-12 + 8 * ULP * size) * scale + 1e-290;

    CHECK(off <= bound, "law %zu at %g %g: %s (%g, %g), not (%g, %g)",
          s->number, z.x, z.y, name, jx, jy, (double) J[0], (double) J[1]);
}

static void check_dual(const struct setting *s, struct vec2 z)
{
    struct planar_jacobian D;
    struct planar_field f;
    struct quad_field q;
    quad J[2][2];

    tape_jacobian(&s->b.plane, z, &D);
    tape_field(&s->b.plane, z, &f);
    assert_true(D.field.direction.x == f.direction.x &&
                D.field.direction.y == f.direction.y &&
                D.field.log_scale == f.log_scale);
    assert_true(isfinite(D.matrix.xx) && isfinite(D.matrix.xy) &&
                isfinite(D.matrix.yx) && isfinite(D.matrix.yy));
    quad_block_field(&s->at, z.x, z.y, &q);
    const struct condition c = condition_at(s, z.x, z.y, f.log_scale);
    const quad size = fabsq(f.log_scale) + fabsq(s->hand.log_rate) +
                      fabsq(s->hand.log_inertia) + fabsq(z.x) + fabsq(z.y) +
                      fabsq(s->hand.w0) + fabsq(s->hand.b / s->hand.a * z.y);
    if (c.log_slope > 1e8)
        return;
    quad_jacobian(s, z, f.log_scale, 1e-11 / c.log_slope, J);
    const quad ex = expq(s->hand.log_inertia - z.x - f.log_scale);
    const quad same = expq(q.log_scale - f.log_scale);
    const quad fx = fabsq(q.direction[0]) * same,
               fy = fabsq(q.direction[1]) * same;
    const quad row_x = fabsq(J[0][0]) + fabsq(J[0][1]) + fx +
                       ex * condition_of_mu(s, z.x, z.y);
    const quad row_y = fabsq(J[1][0]) + fabsq(J[1][1]) + fy * c.log_slope;
    check_row(s, z, "fx'", D.matrix.xx, D.matrix.xy, J[0], row_x, size);
    check_row(s, z, "fy'", D.matrix.yx, D.matrix.yy, J[1], row_y,
              size * c.log_slope);
}

static void the_jacobian_is_the_derivative_of_the_field(void **state)
{
    uint64_t seed = check_seed() + 4;
    struct setting s;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < LAWS * 12; i++) {
        if (!draw_setting(i, i < LAWS * 8 ? 10 : 690, &seed, &s))
            continue;
        check_dual(&s, (struct vec2){ 0, 0 });
        for (int k = 0; k < 9; k++)
            check_dual(&s, k % 3 == 0   ? draw_far(&s, &seed)
                           : k % 3 == 1 ? draw_near(-1, 1, &seed)
                                        : draw_near(-15, -1, &seed));
    }
}

static void check_rate(const struct setting *s, enum block_observable which,
                       struct vec2 z)
{
    const quad h = 1e-11;
    const quad X = z.x, Y = z.y, x = s->at.x0 + X;
    const quad psi =
        law_psi_is_log(&s->law) ? s->at.y0 + Y : expq(s->at.y0 + Y);
    const quad v = expq(x), v0 = expq(s->at.x0);
    const quad mu = plain_mu(&s->law, &s->m, x, psi);
    const quad plain = which == BLOCK_SLIP   ? v
                       : which == BLOCK_WORK ? mu * v
                                             : v - v0;
    const quad rate = quad_block_rate(&s->at, which, X, Y);
    const quad rx = (quad_block_rate(&s->at, which, X + h, Y) -
                     quad_block_rate(&s->at, which, X - h, Y)) /
                    (2 * h);
    const quad ry = (quad_block_rate(&s->at, which, X, Y + h) -
                     quad_block_rate(&s->at, which, X, Y - h)) /
                    (2 * h);
    const quad terms = which == BLOCK_WORK
                           ? (fabsq(s->at.mu0) + condition_of_mu(s, X, Y)) * v
                           : fabsq(plain);
    const quad size = 1 + fabsq(x) + fabsq(s->at.x0) + fabsq(s->hand.w0) +
                      fabsq(s->hand.b / s->hand.a * Y);
    const quad bound =
        8 * ULP * size * (terms + fabsq(rx) + fabsq(ry)) + 1e-300 * v + 1e-320;
    double found, alone;
    struct vec2 g;

    tape_rate(&s->b.plane, which, z, &found, &g);
    tape_rate(&s->b.plane, which, z, &alone, NULL);
    CHECK(alone == found,
          "law %zu at %g %g from %g: rate %d: %.17g alone, %.17g with its "
          "gradient",
          s->number, z.x, z.y, s->b.at.x0, which, alone, found);
    CHECK(fabsq(found - rate) <= bound,
          "law %zu at %g %g: rate %d: %.17g, not %.17g", s->number, z.x, z.y,
          which, found, (double) rate);
    /* v - v0 from the centre is v - v0 from outside, less cancellation */
    CHECK(fabsq(rate - plain) <= 1e-28 * (fabsq(rate) + fabsq(v) + v0 + terms),
          "law %zu: rate %d: %.17g, the model has %.17g", s->number, which,
          (double) rate, (double) plain);
    CHECK(fabsq(g.x - rx) + fabsq(g.y - ry) <= bound + 1e-12 * fabsq(rate),
          "law %zu: rate %d: gradient (%g, %g), not (%g, %g)", s->number, which,
          g.x, g.y, (double) rx, (double) ry);
}

static void rates_and_their_gradients_are_exact(void **state)
{
    uint64_t seed = check_seed() + 5;
    struct setting s;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < LAWS * 8; i++) {
        if (!draw_setting(i, i < LAWS * 4 ? 10 : 300, &seed, &s))
            continue;
        for (int k = 0; k < 9; k++)
            check_rate(&s, (enum block_observable)(k % BLOCK_OBSERVABLES),
                       k < 3   ? draw_far(&s, &seed)
                       : k < 6 ? draw_near(-1, 1, &seed)
                               : draw_near(-15, -1, &seed));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_field_is_exact_over_the_whole_range),
        cmocka_unit_test(the_field_of_points_side_by_side_is_exact),
        cmocka_unit_test(the_113_bit_field_is_the_model_s),
        cmocka_unit_test(near_the_anchor_no_digit_is_lost),
        cmocka_unit_test(at_an_equilibrium_the_field_is_exactly_zero),
        cmocka_unit_test(the_jacobian_is_the_derivative_of_the_field),
        cmocka_unit_test(rates_and_their_gradients_are_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
