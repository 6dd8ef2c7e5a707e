/* The second route's curves against those in 113 bits: on open branches, too,
 * no point is further off than its piece says. */
#include <float.h>
#include <math.h>

#include "backward.h"
#include "slope.h"
#include "workprec_curve.h"

static const char *const no_more[] = { NULL };
static const struct box reach = { { -12.0, -12.0 }, { 12.0, 12.0 } };

/* The saddle in 113 bits. */
static void find_anchor(const struct study *s, struct quad_anchor *at)
{
    const struct block *b = &s->slider.block;
    const quad x = b->at.x0, wide = 1e-6, tangent = b->tan_alpha;

    quad_block_anchor(&b->law, &b->material, tangent,
                      quad_block_equilibrium(&b->law, &b->material, tangent,
                                             x - wide, x + wide),
                      true, at);
}

/* Of a point's absolute coordinates. */
static double rounding(const struct study *s, struct vec2 z)
{
    const struct vec2 o = s->slider.plane.system.origin;

    return 4.0 * DBL_EPSILON *
           (1.0 + fabs(o.x) + fabs(o.y) + fabs(z.x) + fabs(z.y));
}

/* Four points of each piece in the box; returns their largest bar. */
static double check_pieces(const struct study *s,
                           const struct workprec_curve *exact,
                           const struct curve *b, double rtol)
{
    double u[CURVE_DIM_MAX], largest = 0.0;

    for (size_t i = 0; i < 4 * b->count; i++) {
        curve_at(b, i / 4, 0.25 * (double) (i % 4 + 1), u);
        const struct vec2 z = { u[0], u[1] };
        if (!box_holds(reach, z))
            break;
        const quad at[2] = { z.x, z.y };
        const double off = workprec_curve_distance(exact, at);
        const double bar = b->piece[i / 4].error + rounding(s, z);
        CHECK(off <= bar, "%s, rtol %g: piece %zu is %.2g off, bar %.2g",
              s->slider.block.law.preset, rtol, i / 4, off, bar);
        largest = fmax(largest, bar);
    }
    return largest;
}

static void check_branch(const struct study *s, int side)
{
    struct workprec_curve exact;
    struct quad_anchor at;

    find_anchor(s, &at);
    assert_true(workprec_curve_grow(&s->slider.block.law, &at, side, &exact));
    for (int k = 4; k <= 12; k += 4) {
        const double rtol = pow(10.0, -k);
        const struct backward_options o = backward_defaults(rtol);
        struct branch b;
        assert_int_equal(backward_branch(&s->slider.plane.system,
                                         phase_plane_saddle(&s->slider.plane),
                                         side, &o, &b),
                         STATUS_OK);
        const double bar = check_pieces(s, &exact, &b.curve, rtol);
        CHECK(bar <= 1000.0 * rtol, "%s: bar %g at rtol %g",
              s->slider.block.law.preset, bar, rtol);
        branch_free(&b);
    }
}

static void check_law(const char *law, const char *alpha)
{
    struct slope s;

    slope_make(&s, law, NULL, alpha, no_more);
    check_branch(&s.study, 1);
    check_branch(&s.study, -1);
    slope_free(&s);
}

static void no_point_of_an_open_branch_is_off_its_bar(void **state)
{
    (void) state;
    check_law("dieterich", "0.38");
    check_law("ruina", "0.3");
    check_law("spinodal", "0.34");
}

static void no_point_of_a_closed_branch_is_off_its_bar(void **state)
{
    (void) state;
    check_law("dieterich_gen", "0.3");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_point_of_an_open_branch_is_off_its_bar),
        cmocka_unit_test(no_point_of_a_closed_branch_is_off_its_bar),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
