/* What lib/plot computes before gnuplot sees it: axes, ticks, clipped and
 * thinned lines, arrowheads. */
#include "check.h"

#include <math.h>
#include <string.h>

#include "stroke.h"
#include "ticks.h"

static const struct figure_axis unit = { NULL, 0, 100, false };
static const struct figure_axis decades = { NULL, 1e-6, 1e6, true };

static struct scale unit_scale(void)
{
    return scale_of(&unit, 100);
}

static void an_axis_maps_there_and_back(void **state)
{
    (void) state;
    uint64_t seed = check_seed();
    const struct scale s = scale_of(&decades, 600);
    for (int k = 0; k < 1000; k++) {
        const double v = pow(10, check_uniform(&seed, -6, 6));
        const double back = scale_value(&s, scale_pixel(&s, v));
        CHECK(fabs(back / v - 1) < 1e-13, "%g -> %g", v, back);
    }
    for (int k = 0; k < 100; k++) {
        const double lo = pow(10, check_uniform(&seed, -300, 0));
        const double hi = pow(10, check_uniform(&seed, 0, 300));
        const struct figure_axis axis = { NULL, lo, hi, true };
        const struct scale t = scale_of(&axis, 600);
        assert_true(scale_value(&t, 0) == lo && scale_value(&t, 600) == hi);
    }
    assert_true(scale_pixel(&s, 1e-6) == 0 && scale_pixel(&s, 1e6) == 600);
    assert_true(isnan(scale_pixel(&s, 0)) && isnan(scale_pixel(&s, -1)));
    CHECK(fabs(scale_rate(&s) * log(10) - 50) < 1e-12, "%g", scale_rate(&s));
}

/* Distance of a point from the segment p -> q. */
static double distance(struct vec2 z, struct vec2 p, struct vec2 q)
{
    const struct vec2 d = vec2_sub(q, p), e = vec2_sub(z, p);
    const double dd = d.x * d.x + d.y * d.y;
    const double t = dd > 0 ? (d.x * e.x + d.y * e.y) / dd : 0;
    return vec2_length(vec2_sub(e, vec2_scale(fmin(fmax(t, 0), 1), d)));
}

static bool on_frame(struct vec2 p)
{
    return p.x == 0 || p.x == 100 || p.y == 0 || p.y == 100;
}

static void a_clipped_segment_is_the_part_in_the_box(void **state)
{
    (void) state;
    uint64_t seed = check_seed();
    const struct scale s = unit_scale();
    const struct box box = { { 0, 0 }, { 100, 100 } };
    struct stroke out = STROKE_EMPTY;
    int visible = 0;
    for (int k = 0; k < 5000; k++) {
        double x[2], y[2];
        for (int i = 0; i < 2; i++) {
            x[i] = check_uniform(&seed, -150, 250);
            y[i] = check_uniform(&seed, -150, 250);
        }
        const struct vec2 p = { x[0], y[0] }, q = { x[1], y[1] };
        assert_int_equal(stroke_clip(&s, &s, x, y, 2, &out), STATUS_OK);
        visible += out.count == 2;
        for (size_t i = 0; i < out.count; i++) {
            const double off = distance(out.at[i], p, q);
            CHECK(box_holds(box, out.at[i]) && off < 1e-11, "off %g", off);
            CHECK(box_holds(box, i ? q : p) || on_frame(out.at[i]), "short");
        }
        for (int j = 0; j <= 20; j++) {
            const struct vec2 z =
                vec2_add(p, vec2_scale(j / 20.0, vec2_sub(q, p)));
            if (box_holds(box, z))
                CHECK(out.count == 2 &&
                          distance(z, out.at[0], out.at[1]) < 1e-11,
                      "lost %g %g", z.x, z.y);
        }
    }
    CHECK(visible > 500, "%d", visible);
    stroke_free(&out);
    stroke_free(&out);
}

static void a_line_that_leaves_and_returns_has_two_pieces(void **state)
{
    (void) state;
    const struct scale s = unit_scale();
    const double x[] = { 50, 150, 150, 50, 40 };
    const double y[] = { 20, 20, 60, 60, 50 };
    struct stroke out = STROKE_EMPTY;
    assert_int_equal(stroke_clip(&s, &s, x, y, 5, &out), STATUS_OK);
    assert_int_equal(out.count, 6);
    assert_true(out.at[1].x == 100 && isnan(out.at[2].x));
    assert_true(out.at[3].x == 100 && out.at[3].y == 60);
    CHECK(fabs(stroke_length(&out) - 100 - hypot(10, 10)) < 1e-12, "%g",
          stroke_length(&out));
    stroke_free(&out);
}

/* Shoelace formula. */
static double area(const struct stroke *s)
{
    double sum = 0;
    for (size_t k = 0; k < s->count; k++) {
        const struct vec2 p = s->at[k], q = s->at[(k + 1) % s->count];
        sum += p.x * q.y - q.x * p.y;
    }
    return fabs(sum) / 2;
}

/* Area of a triangle in the box: its sections by rows, midpoint rule. */
static double area_by_rows(const double x[3], const double y[3], int rows)
{
    double sum = 0;
    for (int j = 0; j < rows; j++) {
        const double at = 100 * (j + 0.5) / rows;
        double lo = INFINITY, hi = -INFINITY;
        for (int i = 0; i < 3; i++) {
            const int n = (i + 1) % 3;
            if ((y[i] < at) == (y[n] < at))
                continue;
            const double cut =
                x[i] + (at - y[i]) / (y[n] - y[i]) * (x[n] - x[i]);
            lo = fmin(lo, cut);
            hi = fmax(hi, cut);
        }
        if (lo < hi)
            sum += fmax(0, fmin(hi, 100) - fmax(lo, 0));
    }
    return sum * 100 / rows;
}

/* From 3 down through 0: as far as the axis goes, and back. */
static void a_line_to_zero_ends_where_a_log_axis_does(void **state)
{
    (void) state;
    const struct figure_axis down = { .lo = 1, .hi = 100, .is_log = true };
    const struct scale sx = unit_scale(), sy = scale_of(&down, 100);
    const double x[] = { 10, 30, 70, 90 }, y[] = { 10, 3, -1, 11 };
    struct stroke out = STROKE_EMPTY;
    assert_int_equal(stroke_clip(&sx, &sy, x, y, 4, &out), STATUS_OK);
    assert_int_equal(out.count, 6);
    CHECK(fabs(out.at[2].x - 50) < 1e-12 && fabs(out.at[2].y) < 1e-12,
          "(%g, %g)", out.at[2].x, out.at[2].y);
    assert_true(isnan(out.at[3].x));
    CHECK(fabs(out.at[4].x - 70 - 20.0 / 6) < 1e-12, "%g", out.at[4].x);
    const double gone[] = { 10, 3, NAN, 11 }, under[] = { 10, 0.5, -1, -2 };
    assert_int_equal(stroke_clip(&sx, &sy, x, gone, 4, &out), STATUS_OK);
    assert_int_equal(out.count, 2);
    assert_int_equal(stroke_clip(&sx, &sy, x, under, 4, &out), STATUS_OK);
    assert_int_equal(out.count, 2);
    stroke_free(&out);
}

static void a_clipped_region_keeps_the_area_in_the_box(void **state)
{
    (void) state;
    uint64_t seed = check_seed();
    const struct scale s = unit_scale();
    struct stroke out = STROKE_EMPTY;
    for (int k = 0; k < 300; k++) {
        double x[3], y[3];
        for (int i = 0; i < 3; i++) {
            x[i] = check_uniform(&seed, -100, 200);
            y[i] = check_uniform(&seed, -100, 200);
        }
        assert_int_equal(stroke_clip_region(&s, &s, x, y, 3, &out), STATUS_OK);
        const double found = area(&out), wanted = area_by_rows(x, y, 2000);
        CHECK(fabs(found - wanted) < 5, "%g, by rows %g", found, wanted);
    }
    stroke_free(&out);
}

static void thinning_stays_within_its_tolerance(void **state)
{
    (void) state;
    enum { N = 2000 };
    uint64_t seed = check_seed();
    const struct scale s = unit_scale();
    struct stroke out = STROKE_EMPTY, all = STROKE_EMPTY;
    double x[N], y[N];
    for (int k = 0; k < N; k++) {
        x[k] = 50 + 45 * cos(0.008 * k) + check_uniform(&seed, -0.02, 0.02);
        y[k] = 50 + 45 * sin(0.011 * k) + check_uniform(&seed, -0.02, 0.02);
    }
    assert_int_equal(stroke_clip(&s, &s, x, y, N, &all), STATUS_OK);
    assert_int_equal(stroke_clip(&s, &s, x, y, N, &out), STATUS_OK);
    stroke_thin(&out, 0.1);
    CHECK(out.count < N / 4, "%zu left", out.count);
    assert_memory_equal(&out.at[0], &all.at[0], sizeof out.at[0]);
    assert_memory_equal(&out.at[out.count - 1], &all.at[N - 1],
                        sizeof out.at[0]);
    for (size_t k = 0; k < all.count; k++) {
        double least = INFINITY;
        for (size_t i = 0; i + 1 < out.count; i++)
            least = fmin(least, distance(all.at[k], out.at[i], out.at[i + 1]));
        CHECK(least <= 0.1 * (1 + 1e-9), "point %zu is %g away", k, least);
    }
    stroke_free(&out);
    stroke_free(&all);
}

static void a_straight_line_thins_to_its_ends(void **state)
{
    (void) state;
    const struct scale s = unit_scale();
    double x[] = { 0, 1, 2, 3, 90, NAN, 5, 5, 5, 5 };
    double y[] = { 0, 1, 2, 3, 90, 0, 10, 80, 20, 70 };
    struct stroke out = STROKE_EMPTY;
    assert_int_equal(stroke_clip(&s, &s, x, y, 10, &out), STATUS_OK);
    stroke_thin(&out, 0.05);
    /* two ends, the break, and all four points of the line that turns back */
    assert_int_equal(out.count, 7);
    assert_true(out.at[1].x == 90 && isnan(out.at[2].x));
    assert_true(out.at[4].y == 80 && out.at[5].y == 20);
    stroke_free(&out);
}

static void an_arrowhead_points_along_the_line(void **state)
{
    (void) state;
    const struct scale s = unit_scale();
    const double x[] = { 10, 50, NAN, 80, 80 }, y[] = { 20, 20, 0, 90, 30 };
    struct stroke out = STROKE_EMPTY;
    struct vec2 head[3];
    assert_int_equal(stroke_clip(&s, &s, x, y, 5, &out), STATUS_OK);
    assert_true(stroke_head(&out, 0.2, 8, head)); /* 20 of 100 px: x = 30 */
    assert_true(fabs(head[1].x - 34) < 1e-12 && head[1].y == 20);
    assert_true(fabs(head[0].x - 26) < 1e-12 && head[0].y > 20);
    assert_true(stroke_head(&out, 1, 8, head)); /* tip at the very end */
    assert_true(head[1].x == 80 && fabs(head[1].y - 30) < 1e-12);
    assert_true(stroke_head(&out, 0, 8, head)); /* base at the start */
    assert_true(fabs(head[0].x - 10) < 1e-12);
    assert_false(stroke_head(&out, 0.1, 30, head)); /* too long for it */
    stroke_free(&out);
    assert_false(stroke_head(&out, 0.5, 8, head));
}

/* At a corner it stands beside it, on either leg. */
static void an_arrowhead_stands_where_the_line_is_straight(void **state)
{
    (void) state;
    const struct scale s = unit_scale();
    const double x[] = { 10, 50, 50 }, y[] = { 20, 20, 60 };
    struct stroke out = STROKE_EMPTY;
    struct vec2 head[3];
    assert_int_equal(stroke_clip(&s, &s, x, y, 3, &out), STATUS_OK);
    for (int k = 0; k <= 10; k++) {
        assert_true(stroke_head(&out, k / 10.0, 8, head));
        const struct vec2 base =
            vec2_scale(0.5, vec2_add(head[0], head[2])); /* on the line */
        const bool across = base.y == 20 && head[1].y == 20,
                   up = base.x == 50 && head[1].x == 50;
        CHECK(across != up &&
                  fabs(head[1].x + head[1].y - base.x - base.y - 8) < 1e-12,
              "%d: %g, %g to %g, %g", k, base.x, base.y, head[1].x, head[1].y);
    }
    stroke_free(&out);
}

/* What the function writes, as a text; freed by the caller. */
static char *ticks_text(const struct figure_axis *axis, double pixels,
                        double spacing)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    const struct scale s = scale_of(axis, pixels);
    ticks_write(out, &s, spacing, 1, NULL);
    fclose(out);
    return text;
}

static void labels_are_few_apart_and_on_the_axis(void **state)
{
    (void) state;
    uint64_t seed = check_seed();
    for (int k = 0; k < 3000; k++) {
        struct figure_axis axis = { .is_log = k % 2 };
        const double span = pow(10, check_uniform(&seed, -2, 2.7));
        axis.lo = check_uniform(&seed, -200, 200) / 2;
        axis.hi = axis.lo + span;
        if (axis.is_log) {
            axis.lo = pow(10, axis.lo);
            axis.hi = axis.lo * pow(10, fmin(span, 200));
        }
        const double pixels = check_uniform(&seed, 130, 700);
        const struct scale s = scale_of(&axis, pixels);
        char *text = ticks_text(&axis, pixels, 60);
        int labels = 0;
        double last = -INFINITY;
        for (char *t = strchr(text, '\''); t; t = strchr(t, '\'')) {
            char *end = strchr(t + 1, '\''), *rest;
            const double at = strtod(end + 1, &rest);
            const double px = scale_pixel(&s, at);
            CHECK(px >= -1e-6 && px <= pixels + 1e-6, "%s", text);
            if (end > t + 1) {
                CHECK(px - last > 24, "%g px apart: %s", px - last, text);
                last = px;
                labels++;
            }
            t = rest;
        }
        CHECK(labels >= 3 && labels <= 8, "[%g, %g] %d: %s", axis.lo, axis.hi,
              labels, text);
        free(text);
    }
}

/* 0.1, 0.2, 0.4 without 0.3 looks like a log axis. */
static void labels_of_linear_axes_are_evenly_apart(void **state)
{
    (void) state;
    uint64_t seed = check_seed();
    for (int k = 0; k < 3000; k++) {
        const double lo = check_uniform(&seed, -3, 3);
        const struct figure_axis axis = {
            .lo = lo, .hi = lo + pow(10, check_uniform(&seed, -3, 3))
        };
        struct tick_label label[TICKS_LABELS];
        const struct scale s = scale_of(&axis, check_uniform(&seed, 120, 700));
        const size_t count = ticks_labels(&s, 60, label);
        for (size_t i = 2; i < count; i++) {
            const double bend =
                label[i].at - 2 * label[i - 1].at + label[i - 2].at;
            CHECK(fabs(bend) < 1e-6 * (axis.hi - axis.lo), "%g, %g, %g",
                  label[i - 2].at, label[i - 1].at, label[i].at);
        }
    }
}

static void ends_that_are_labels_are_labelled(void **state)
{
    (void) state;
    for (int n = -12; n < 12; n++)
        for (int m = 1; m < 7; m++) {
            char end[32];
            snprintf(end, sizeof end, "1e%d", n);
            const double lo = strtod(end, NULL);
            snprintf(end, sizeof end, "1e%d", n + m);
            const double hi = strtod(end, NULL);
            const struct figure_axis axis = { .lo = lo, .hi = hi, .is_log = 1 };
            char *text = ticks_text(&axis, 700, 60), wanted[64];
            for (int k = 0; k < 2; k++) {
                snprintf(wanted, sizeof wanted, "' %.15g 0", k ? hi : lo);
                CHECK(strstr(text, wanted), "%s: %s", wanted, text);
            }
            free(text);
        }
}

static void decades_are_labelled_as_powers_of_ten(void **state)
{
    (void) state;
    char *text = ticks_text(&decades, 600, 60);
    CHECK(strstr(text, "'10^{\xe2\x88\x92"
                       "6}' 1e-06 0"),
          "%s", text);
    CHECK(strstr(text, "'10^{4}' 10000 0") && strstr(text, "'' 1000 1"), "%s",
          text);
    free(text);
}

/* Ranges of sweeps, narrow on log axes, and others that had one label. */
static void every_range_has_three_labels(void **state)
{
    (void) state;
    static const struct figure_axis narrow[] = {
        { NULL, 3.5, 18, true },        { NULL, 0.9, 0.95, true },
        { NULL, 6e-3, 5e-2, true },     { NULL, 2, 130, true },
        { NULL, 0.0299, 0.041, false }, { NULL, -0.3, 0.99, false },
        { NULL, 8e-9, 9e-9, true },
    };
    for (size_t k = 0; k < sizeof narrow / sizeof *narrow; k++)
        for (double pixels = 120; pixels < 700; pixels += 50) {
            char *text = ticks_text(&narrow[k], pixels, 60);
            int labels = 0;
            for (char *t = text; (t = strstr(t, " 0")); t++)
                labels += t[2] == ',' || t[2] == ')';
            CHECK(labels >= 3, "%g px: %s", pixels, text);
            free(text);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_axis_maps_there_and_back),
        cmocka_unit_test(a_clipped_segment_is_the_part_in_the_box),
        cmocka_unit_test(a_line_that_leaves_and_returns_has_two_pieces),
        cmocka_unit_test(a_line_to_zero_ends_where_a_log_axis_does),
        cmocka_unit_test(a_clipped_region_keeps_the_area_in_the_box),
        cmocka_unit_test(thinning_stays_within_its_tolerance),
        cmocka_unit_test(a_straight_line_thins_to_its_ends),
        cmocka_unit_test(an_arrowhead_points_along_the_line),
        cmocka_unit_test(an_arrowhead_stands_where_the_line_is_straight),
        cmocka_unit_test(labels_are_few_apart_and_on_the_axis),
        cmocka_unit_test(labels_of_linear_axes_are_evenly_apart),
        cmocka_unit_test(ends_that_are_labels_are_labelled),
        cmocka_unit_test(decades_are_labelled_as_powers_of_ten),
        cmocka_unit_test(every_range_has_three_labels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
