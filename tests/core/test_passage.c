#include "passage.h"

#include <math.h>

#include "check.h"

/* One random piece of degree 4 in 3 components, of size about 1. */
static void random_piece(struct curve *c, uint64_t *rng)
{
    double *coef;

    assert_int_equal(curve_push(c, 4, &coef), STATUS_OK);
    for (size_t i = 0; i < 3 * 5; i++)
        coef[i] = check_uniform(rng, -1.0, 1.0);
}

enum { FINE = 4000, RUN = 2 + FINE / 1024 };

/* The first of FINE samples that begins a stay inside (or outside) b longer
 * than what may be missed; > 1: none. */
static double sampled(const struct curve *c, struct box b, bool inside)
{
    int stay = 0;

    for (int i = 0; i <= FINE; i++) {
        double u[3];
        curve_at(c, c->count - 1, (double) i / FINE, u);
        stay =
            box_holds(b, (struct vec2){ u[0], u[1] }) == inside ? stay + 1 : 0;
        if (stay == RUN)
            return (double) (i - RUN + 1) / FINE;
    }
    return PASSAGE_NEVER;
}

static void passages_through_boxes_agree_with_fine_sampling(void **state)
{
    uint64_t rng = check_seed();
    struct curve c = CURVE_EMPTY(3);
    int found = 0;

    (void) state;
    for (int i = 0; i < 2000; i++) {
        const double w = exp(check_uniform(&rng, -4.0, 0.0));
        const struct vec2 z = { check_uniform(&rng, -1, 1),
                                check_uniform(&rng, -1, 1) };
        const struct box b = { { z.x - w, z.y - w }, { z.x + w, z.y + w } };
        random_piece(&c, &rng);
        for (int inside = 0; inside < 2; inside++) {
            const double ref = sampled(&c, b, inside);
            const double theta =
                inside ? passage_into(&c, b) : passage_out_of(&c, b);
            CHECK(theta <= ref + 1e-12, "%g, sampled %g", theta, ref);
            if (theta > 1.0)
                continue;
            double u[3];
            curve_at(&c, c.count - 1, theta, u);
            const double d = passage_distance(b, (struct vec2){ u[0], u[1] });
            CHECK(theta == 0.0 || fabs(d) < 1e-14, "edge missed by %g", d);
            found += theta > 0.0;
        }
    }
    CHECK(found > 100, "only %d passages", found);
    curve_free(&c);
}

/* At first as fast as 1e12 boxes a piece, then beside the box without moving:
 * strides of the box at that speed would take hours. */
static void a_curve_that_comes_to_lie_beside_a_box_costs_little(void **state)
{
    const struct box b = { { -0.01, -0.01 }, { 0.01, 0.01 } };
    const int binomial[] = { 1, -7, 21, -35, 35, -21, 7, -1 };
    struct curve c = CURVE_EMPTY(2);
    double *coef;

    (void) state;
    assert_int_equal(curve_push(&c, 7, &coef), STATUS_OK);
    for (int k = 0; k < 8; k++) {
        coef[k] = 1e10 * binomial[k] + (k == 0 ? 0.02 : 0.0);
        coef[8 + k] = 0.0;
    }
    assert_true(passage_into(&c, b) == PASSAGE_NEVER);
    coef[0] -= 0.02;
    assert_true(passage_into(&c, b) < 1.0);
    curve_free(&c);
}

/* Parabolas that cross y = 1, the upper face, by a chord of 10^-2 to 10^-6 that
 * its end, a corner, cuts off at random, and those that miss it by as little.
 */
static void no_chord_across_a_corner_is_too_short(void **state)
{
    const struct box b = { { -1, -1 }, { 1, 1 } };
    uint64_t rng = check_seed();
    struct curve c = CURVE_EMPTY(2);

    (void) state;
    for (int i = 0; i < 2000; i++) {
        const double chord = pow(10.0, check_uniform(&rng, -6, -2));
        const double bend = pow(10.0, check_uniform(&rng, -2, 1));
        const double in = 1.0 - chord * check_uniform(&rng, 0.1, 0.9);
        const double out = in + chord, sign = i % 2 ? -1.0 : 1.0;
        double *coef;
        assert_int_equal(curve_push(&c, 2, &coef), STATUS_OK);
        coef[0] = -2.0; /* x = 4 theta - 2 */
        coef[1] = 4.0;
        coef[2] = 0.0;
        /* y = 1 + bend ((x - in) (x - out) + (sign < 0) chord^2), theta */
        coef[3] = 1.0 + bend * ((-2.0 - in) * (-2.0 - out) +
                                (sign < 0.0 ? chord * chord : 0.0));
        coef[4] = -4.0 * bend * (4.0 + in + out);
        coef[5] = 16.0 * bend;
        const double theta = passage_into(&c, b);
        if (sign < 0.0) {
            CHECK(theta == PASSAGE_NEVER, "beside it, %g", chord);
            continue;
        }
        CHECK(theta < 1.0, "a chord of %g at a bend of %g", chord, bend);
        CHECK(fabs(4.0 * theta - 2.0 - in) <
                  0.1 * chord + 1e-13 / (bend * chord),
              "%g from %g", 4.0 * theta - 2.0 - in, chord);
    }
    curve_free(&c);
}

static void values_are_passed_on_the_side_of_their_sign(void **state)
{
    struct curve c = CURVE_EMPTY(3);
    double *coef;

    (void) state;
    assert_int_equal(curve_push(&c, 2, &coef), STATUS_OK);
    for (size_t i = 0; i < 9; i++)
        coef[i] = 0.0;
    coef[7] = 4.0; /* 4 theta - 4 theta^2: up to 1 and back */
    coef[8] = -4.0;
    CHECK(fabs(passage_beyond(&c, 2, 0.75) - 0.25) < 1e-15, "0.75");
    CHECK(passage_beyond(&c, 2, 1.0 + 1e-6) == PASSAGE_NEVER, "above");
    CHECK(passage_beyond(&c, 2, -1e-6) == PASSAGE_NEVER, "below");
    CHECK(passage_beyond(&c, 0, 1.0) == PASSAGE_NEVER, "constant");
    coef[7] = -4.0;
    coef[8] = 4.0;
    CHECK(fabs(passage_beyond(&c, 2, -0.75) - 0.25) < 1e-15, "-0.75");
    curve_free(&c);
}

static void distance_is_signed_and_in_the_maximum_norm(void **state)
{
    const struct box b = { { 0, 0 }, { 2, 4 } };

    (void) state;
    CHECK(passage_distance(b, (struct vec2){ 1, 1.5 }) == -1.0, "inside");
    CHECK(passage_distance(b, (struct vec2){ 3, 6.5 }) == 2.5, "corner");
    CHECK(passage_distance(b, (struct vec2){ 2, 1 }) == 0.0, "edge");
    CHECK(passage_distance(
              (struct box){ { -INFINITY, -INFINITY }, { INFINITY, INFINITY } },
              (struct vec2){ 2, 1 }) == -INFINITY,
          "plane");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(passages_through_boxes_agree_with_fine_sampling),
        cmocka_unit_test(a_curve_that_comes_to_lie_beside_a_box_costs_little),
        cmocka_unit_test(no_chord_across_a_corner_is_too_short),
        cmocka_unit_test(values_are_passed_on_the_side_of_their_sign),
        cmocka_unit_test(distance_is_signed_and_in_the_maximum_norm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
