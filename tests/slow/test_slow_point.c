/* Points of the slow curve's branches, by place and by time. */
#include "slow_point.h"

#include "slope.h"
#include "slow_curve.h"

static const char *const steady_only[] = { "products=[equilibria]", NULL };

static void make(struct slow_curve *c, struct slope *s, const char *law,
                 const char *alpha)
{
    slope_make(s, law, NULL, alpha, steady_only);
    assert_int_equal(slow_curve_init(c, &s->study.slider, NULL), STATUS_OK);
}

static void drop(struct slow_curve *c, struct slope *s)
{
    slow_curve_free(c);
    slope_free(s);
}

/* As well as time tells y. */
static int check_found_again(const struct slow_branch *b, double y)
{
    struct slow_point p;

    if (!slow_point_at(b, y, &p))
        return 0;
    const double again = slow_point_when(b, p.time);
    const double told = 1e-14 * fabs(p.time / p.time_slope) + 1e-14;
    CHECK(fabs(again - y) <= told, "y = %.17g: %.17g, time %g", y, again,
          p.time);
    return 1;
}

static void a_point_is_found_again_by_its_time(void **state)
{
    static const char *const law[] = { "spinodal_gen", "dieterich_gen",
                                       "spinodal" };

    (void) state;
    for (int i = 0; i < 3; i++) {
        struct slow_curve c;
        struct slope s;
        int points = 0;
        make(&c, &s, law[i], "0.34");
        for (size_t k = 0; k < c.branches; k++)
            for (double y = -9.0; y < 6.0; y += 0.0137) {
                points += check_found_again(&c.branch[k], y);
                if (c.inside[k].count > 2)
                    points += check_found_again(&c.inside[k], y);
            }
        for (double y = 1e-9; y < 0.1; y *= 7.0)
            points += check_found_again(&c.branch[0], y);
        CHECK(points > 200, "%s: %d points", law[i], points);
        drop(&c, &s);
    }
}

/* T = T0 + ln(way)/|lambda| next to a node, the table's last knot or not. */
static void inside_a_box_time_goes_on_below_zero(void **state)
{
    struct slow_curve c;
    struct slope s;
    int boxes = 0;

    (void) state;
    make(&c, &s, "spinodal_gen", "0.34");
    for (size_t k = 0; k < c.branches; k++) {
        const struct slow_branch *in = &c.inside[k];
        const double end = c.branch[k].knot[c.branch[k].count - 1].y;
        struct slow_point face, p, q;
        if (in->count < 3)
            continue;
        boxes++;
        assert_true(slow_point_at(in, end, &face));
        CHECK(fabs(face.time) < 1e-12, "%g", face.time);
        for (double way = 0.3; way > 1e-7; way *= 0.1) {
            const double y = in->centre + way * (end - in->centre);
            const double near = in->centre + 0.1 * way * (end - in->centre);
            assert_true(slow_point_at(in, y, &p));
            assert_true(slow_point_at(in, near, &q));
            CHECK(p.time < 0.0 && p.slip < 0.0, "%g", p.time);
            CHECK(fabs((p.time - q.time) * -in->grows / log(10.0) - 1.0) <
                      0.02 * way + 1e-6,
                  "%g of the way: %g", way, p.time - q.time);
        }
    }
    assert_int_equal(boxes, 4);
    drop(&c, &s);
}

static void elsewhere_there_is_nothing(void **state)
{
    struct slow_curve c;
    struct slow_point p;
    struct slope s;
    double x, slope;

    (void) state;
    make(&c, &s, "spinodal_gen", "0.34");
    const struct slow_branch *b = &c.branch[0];
    assert_false(slow_point_at(b, -b->knot[0].y, &p));
    assert_false(slow_point_at(b, 7.0, &p));
    assert_false(slow_point_beside(b, 7.0, &x, &slope));
    assert_true(isnan(slow_point_when(b, -1.0)));
    assert_true(isnan(slow_point_when(&c.branch[2], 1e6)));
    assert_true(slow_point_when(b, 300.0) > 0.0); /* ever nearer the saddle */
    drop(&c, &s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_point_is_found_again_by_its_time),
        cmocka_unit_test(inside_a_box_time_goes_on_below_zero),
        cmocka_unit_test(elsewhere_there_is_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
