/* The curve all orbits land on. */
#include "slow_curve.h"

#include "fault_alloc.h"
#include "found.h"
#include "rest_left.h"
#include "slider.h"
#include "slope.h"
#include "stops.h"
#include "tolerance.h"

static const char *const steady_only[] = { "products=[equilibria]", NULL };

static void make(struct slow_curve *c, struct slope *s, const char *law,
                 const char *alpha)
{
    slope_make(s, law, NULL, alpha, steady_only);
    const enum status status = slow_curve_init(c, &s->study.slider, NULL);
    CHECK(status == STATUS_OK, "%s", status_text(status));
}

static void drop(struct slow_curve *c, struct slope *s)
{
    slow_curve_free(c);
    slow_curve_free(c);
    slope_free(s);
}

/* The orbit from a point of it takes the time and slip that are tabulated. */
static int check_point(const struct slow_curve *c, const struct slope *s,
                       double y)
{
    struct slow_point p;
    struct fate_result r;

    if (!slow_curve_at(c, y, &p))
        return 0;
    const struct vec2 o = s->study.slider.plane.system.origin;
    const struct vec2 z = { o.x + p.x, o.y + y };
    assert_int_equal(fate_find(&s->study.slider, z, 1e-10, true, NULL, &r),
                     STATUS_OK);
    CHECK((int8_t) r.fate == p.fate, "y %g: %s", y, fate_names[r.fate]);
    CHECK(fabs(r.time.value - p.time) <= 3e-8 * p.time,
          "y %g: %.12g, not %.12g", y, p.time, r.time.value);
    CHECK(fabs(r.slip.value - p.slip) <= 3e-8 * p.slip,
          "y %g: %.12g, not %.12g", y, p.slip, r.slip.value);
    return 1;
}

static void check_curve(const char *law, const char *alpha, int least)
{
    struct slow_curve c;
    struct slope s;
    int points = 0;

    make(&c, &s, law, alpha);
    for (double y = 3.1e-4; y < 8.0; y *= 4.3)
        points += check_point(&c, &s, y) + check_point(&c, &s, -y);
    CHECK(points >= least, "%s at %s: %d points", law, alpha, points);
    drop(&c, &s);
}

static void orbits_on_it_take_the_tabulated_time_and_slip(void **state)
{
    (void) state;
    check_curve("spinodal_gen", "0.34", 9);
    check_curve("spinodal", "0.30", 9);
    check_curve("spinodal_phi_gen", "0.38", 9);
    check_curve("dieterich_gen", "0.34", 5);
    check_curve("spinodal", "0.2", 4);
}

/* Its slopes are those of what it tabulates. */
static void time_and_slip_change_as_their_slopes_say(void **state)
{
    struct slow_point p, q;
    struct slow_curve c;
    struct slope s;
    const double h = 1e-6;

    (void) state;
    make(&c, &s, "spinodal_gen", "0.34");
    for (double y = -7.0; y < 3.0; y += 0.37) {
        if (!slow_curve_at(&c, y, &p) || !slow_curve_at(&c, y + h, &q))
            continue;
        CHECK(fabs((q.time - p.time) / h / p.time_slope - 1.0) < 1e-4,
              "y %g: %g, not %g", y, (q.time - p.time) / h, p.time_slope);
        CHECK(fabs((q.slip - p.slip) / h / p.slip_slope - 1.0) < 1e-4,
              "y %g: %g, not %g", y, (q.slip - p.slip) / h, p.slip_slope);
        CHECK(fabs((q.x - p.x) / h - p.x_slope) < 1e-3, "y %g: %g, not %g", y,
              (q.x - p.x) / h, p.x_slope);
    }
    drop(&c, &s);
}

/* Close to the saddle, time grows like -ln(y)/lambda. */
static void beside_the_saddle_time_grows_like_a_logarithm(void **state)
{
    struct slow_point p, q;
    struct slow_curve c;
    struct slope s;

    (void) state;
    make(&c, &s, "spinodal_gen", "0.34");
    const double lambda = phase_plane_saddle(&s.study.slider.plane)->lambda[1];
    for (int side = -1; side <= 1; side += 2) {
        assert_true(slow_curve_at(&c, side * 1e-9, &p));
        assert_true(slow_curve_at(&c, side * 1e-7, &q));
        CHECK(fabs((p.time - q.time) * lambda / log(100.0) - 1.0) < 1e-6, "%g",
              p.time - q.time);
    }
    assert_false(slow_curve_at(&c, 0.0, &p));
    drop(&c, &s);
}

/* And slip like -v ln(y)/lambda: a decade adds the same to the last digits. */
static void check_decades(const char *law, const char *alpha)
{
    struct slow_curve c;
    struct slope s;

    make(&c, &s, law, alpha);
    const double lambda = phase_plane_saddle(&s.study.slider.plane)->lambda[1];
    const double each = s.study.slider.block.at.v0 * log(10.0) / lambda;
    int decades = 0;
    for (int side = -1; side <= 1; side += 2)
        for (double y = 1e-5; y > 1e-14; y *= 0.1) {
            struct slow_point p, q;
            if (!slow_curve_at(&c, side * y, &p) ||
                !slow_curve_at(&c, 0.1 * side * y, &q))
                continue;
            decades++;
            CHECK(fabs((q.slip - p.slip) / each - 1.0) < 3.0 * y + 1e-12,
                  "%s at %s, y %g: %.15g, not %.15g", law, alpha, side * y,
                  q.slip - p.slip, each);
        }
    CHECK(decades >= 9, "%d", decades);
    drop(&c, &s);
}

static void beside_the_saddle_slip_grows_evenly(void **state)
{
    (void) state;
    check_decades("spinodal_gen", "0.34");
    check_decades("spinodal", "0.30");
    check_decades("spinodal_phi_gen", "0.38");
    check_decades("dieterich_gen", "0.34");
}

/* As far as rounding lets it be seen, though rates are alike on a part of the
 * way at 0.26. */
static void it_leads_on_where_blocks_never_quite_stop(void **state)
{
    const char *const laws[] = { "dieterich", "ruina", "perrin" };
    const char *const slopes[] = { "0.34", "0.26" };
    struct slow_curve c;
    struct slope s;

    (void) state;
    for (int i = 0; i < 6; i++) {
        make(&c, &s, laws[i % 3], slopes[i / 3]);
        const struct slow_branch *b = &c.branch[0];
        assert_int_equal(c.branches, 1);
        assert_int_equal(b->fate, FATE_REST_ASYMPTOTIC);
        const double gap = b->knot[b->count - 1].gap;
        CHECK(gap < 1e-12, "%s at %s: gap %g", laws[i % 3], slopes[i / 3], gap);
        assert_true(c.runs_away);
        drop(&c, &s);
    }
}

static double sum_of(const struct slow_knot *k)
{
    return k->x_slope + k->x_bend + k->aside + k->time[0] + k->time[1] +
           k->time[2] + k->slip[0] + k->slip[1] + k->slip[2] +
           slow_knot_missed(&k->time_miss, 0.5) +
           slow_knot_missed(&k->slip_miss, 0.5) + k->time_bar + k->slip_bar +
           k->mu + k->mu_error + k->mu_y + k->mu_peak_error;
}

/* On the one y is at first and for some steps where it settles, on the other
 * the last steps move it by a rounding or none. */
static void a_knot_has_no_number_that_is_none(void **state)
{
    static const struct found slope[] = {
        { FRICTION_LOG, THETA_LN_C_PSI, PSI_SS_SPINODAL_UNIT,
          TIMESCALE_SPINODAL, KINETICS_LINEAR, 0.77250489137791722,
          0.012459248966764744, 0.0075101084564656107, 2.1869897249117582,
          46168107.389127016, 3.553363310529728e-05, 0.00035694015686807981,
          0.62503, 1e-6 },
        { FRICTION_ASINH, THETA_PSI, PSI_SS_INVERSE, TIMESCALE_AGEING44,
          KINETICS_LINEAR, 0.49670396127136351, 0.0020312913416408954,
          0.010106930211383695, 0.00010194818157225821, 0.26984268255216171,
          7.1628063734379712e-05, 1.6547842487386447e-08, 0.548, 1e-6 },
    };
    static const long double tangent[] = { 0.721693387347940588667L,
                                           0.610933354951786344964L };
    struct slow_curve c;
    struct slider s;
    struct scene scene;

    (void) state;
    for (int i = 0; i < 2; i++) {
        found_scene(&slope[i], steady_only, &scene);
        slider_init(&s, &scene.law, &scene.material, tangent[i]);
        assert_int_equal(slow_curve_init(&c, &s, NULL), STATUS_OK);
        assert_true(c.branches > 0);
        for (size_t k = 0; k < c.branches; k++)
            for (size_t j = 0; j < c.branch[k].count; j++)
                CHECK(isfinite(sum_of(&c.branch[k].knot[j])), "knot %zu of %zu",
                      j, c.branch[k].count);
        slow_curve_free(&c);
        scene_free(&scene);
    }
}

/* What is left where only inertia slows the block is one quadrature. */
static void bars_hold_where_steps_take_far_less_than_the_first(void **state)
{
    static const struct found slope = { FRICTION_ASINH,
                                        THETA_LN_PSI,
                                        PSI_SS_INVERSE,
                                        TIMESCALE_SLIP,
                                        KINETICS_SINH,
                                        0.369,
                                        0.037678438442897977,
                                        0.0489,
                                        0.00086422038255759039,
                                        390.01743251464126,
                                        2.5390452563493136e-07,
                                        1e-6,
                                        0.44212,
                                        1e-8 };
    struct slow_curve c;
    struct slider s;
    struct scene scene;
    size_t known = 0;

    (void) state;
    found_scene(&slope, steady_only, &scene);
    slider_init(&s, &scene.law, &scene.material, 0.473371951715025801572L);
    assert_int_equal(slow_curve_init(&c, &s, NULL), STATUS_OK);
    for (size_t i = 0; i < c.branch[0].count; i++) {
        const struct slow_knot *k = &c.branch[0].knot[i];
        struct rest_left left;
        if (!rest_left_find(&s, (struct vec2){ k->x, k->y }, 0.0, &left))
            continue;
        CHECK(fabs(k->time[0] - left.time) <= k->time_bar + left.time_error,
              "knot %zu: time %.17g +- %g, not %.17g +- %g", i, k->time[0],
              k->time_bar, left.time, left.time_error);
        CHECK(fabs(k->slip[0] - left.slip) <= k->slip_bar + left.slip_error,
              "knot %zu: slip %.17g +- %g, not %.17g +- %g", i, k->slip[0],
              k->slip_bar, left.slip, left.slip_error);
        known += left.slip_error < 1e-12 * left.slip;
    }
    CHECK(known > 500, "%zu of %zu", known, c.branch[0].count);
    slow_curve_free(&c);
    scene_free(&scene);
}

/* What is off along f stays off along it: J f - f' is along f, for the fibre f
 * in the middle of an interval and its change over that. */
static int check_fibre(const struct slider *s, const struct slow_branch *b,
                       const struct slow_knot *k)
{
    const double y = 0.5 * (k[0].y + k[1].y);
    const double took = k[0].time[0] - k[1].time[0];
    struct planar_jacobian J;
    struct slow_point p;

    if (!isfinite(k[0].gap) || !isfinite(k[1].gap) || !slow_point_at(b, y, &p))
        return 0;
    s->plane.system.jacobian(s->plane.system.ctx, (struct vec2){ p.x, y }, &J);
    const struct mat2 A = J.matrix;
    const struct eigen2 e = mat2_eigenvalues(A);
    const double scale = exp(J.field.log_scale), x = p.fibre.x, v = p.fibre.y;
    const double x1 = (k[1].fibre.x - k[0].fibre.x) / took,
                 v1 = (k[1].fibre.y - k[0].fibre.y) / took;
    const double apart = x * (scale * (A.yx * x + A.yy * v) - v1) -
                         v * (scale * (A.xx * x + A.xy * v) - x1);
    const double off = fabs(apart) / (scale * (e.re[1] - e.re[0]));

    CHECK(off <= p.swing + 1e-14, "y %g: %g, not within %g", y, off, p.swing);
    return p.swing > 1e-14 && p.swing < 0.1 * p.turns;
}

static void fibres_lead_to_fibres(void **state)
{
    static const char *const of[][2] = { { "spinodal_gen", "0.34" },
                                         { "spinodal", "0.30" },
                                         { "spinodal_phi_gen", "0.38" },
                                         { "dieterich_gen", "0.34" } };
    int told = 0;

    (void) state;
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        struct slow_curve c;
        struct slope s;
        make(&c, &s, of[i][0], of[i][1]);
        for (size_t n = 0; n < c.branches; n++)
            for (size_t k = 0; k + 1 < c.branch[n].count; k++)
                told += check_fibre(&s.study.slider, &c.branch[n],
                                    &c.branch[n].knot[k]);
        drop(&c, &s);
    }
    CHECK(told > 100, "%d", told);
}

/* The largest error of time and slip between knots, of what is still to come
 * there; but not where that is rounding, of y' or of where the face is. */
static double missed_between(const struct slow_branch *b, double gap)
{
    double most = 0.0;

    for (size_t i = 1; i < b->count; i++) {
        const struct slow_knot *k = &b->knot[i], *f = k - 1;
        if (!(f->gap > gap && isfinite(f->gap) && k->time[0] > 0.1))
            continue;
        most = fmax(most, slow_knot_missed(&k->time_miss, 0.5) / k->time[0]);
        most = fmax(most, slow_knot_missed(&k->slip_miss, 0.5) / k->slip[0]);
    }
    return most;
}

/* Also where the slopes have a largest or least value. */
static void knots_are_as_near_as_polynomials_bear(void **state)
{
    static const struct {
        const char *name;
        double gap; /* below which y' is mostly rounding */
    } law[] = { { "spinodal_gen", 1e-4 },
                { "spinodal", 1e-4 },
                { "spinodal_phi_gen", 1e-4 },
                { "dieterich_gen", 1e-7 } };
    struct slow_curve c;
    struct slope s;

    (void) state;
    for (size_t i = 0; i < sizeof law / sizeof *law; i++) {
        make(&c, &s, law[i].name, "0.34");
        for (size_t k = 0; k < c.branches; k++) {
            const double missed = missed_between(&c.branch[k], law[i].gap);
            CHECK(missed < 3e-11, "%s, %zu: %g", law[i].name, k, missed);
        }
        drop(&c, &s);
    }
}

static void a_monitor_stops_it(void **state)
{
    const struct monitor monitor = { stop_at_once, NULL };
    struct slow_curve c;
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    assert_int_equal(slow_curve_init(&c, &s.study.slider, &monitor),
                     STATUS_STOPPED);
    assert_int_equal(c.branches, 0);
    drop(&c, &s);
}

static void every_allocation_may_fail(void **state)
{
    enum status status = STATUS_NO_MEMORY;
    struct slow_curve c;
    struct slope s;
    long k = 0;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    for (; status == STATUS_NO_MEMORY; k++) {
        fault_alloc_at(k);
        status = slow_curve_init(&c, &s.study.slider, NULL);
    }
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_int_equal(status, STATUS_OK);
    CHECK(k > 20, "%ld allocations", k);
    drop(&c, &s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orbits_on_it_take_the_tabulated_time_and_slip),
        cmocka_unit_test(time_and_slip_change_as_their_slopes_say),
        cmocka_unit_test(beside_the_saddle_time_grows_like_a_logarithm),
        cmocka_unit_test(beside_the_saddle_slip_grows_evenly),
        cmocka_unit_test(it_leads_on_where_blocks_never_quite_stop),
        cmocka_unit_test(a_knot_has_no_number_that_is_none),
        cmocka_unit_test(bars_hold_where_steps_take_far_less_than_the_first),
        cmocka_unit_test(fibres_lead_to_fibres),
        cmocka_unit_test(knots_are_as_near_as_polynomials_bear),
        cmocka_unit_test(a_monitor_stops_it),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
