/* Contours of maps whose contours are known. */
#include "check.h"

#include <math.h>

#include "contour.h"

enum { NX = 60, NY = 40 };
static const struct vec2 box = { 600, 400 };

/* The map of a function of the place in px. */
static struct figure_raster map_of(double (*f)(struct vec2 p), double value[])
{
    for (size_t k = 0; k < (size_t) NX * NY; k++)
        value[k] = f((struct vec2){ ((double) (k % NX) + 0.5) * 10,
                                    ((double) (k / NX) + 0.5) * 10 });
    return (struct figure_raster){
        .value = value, .nx = NX, .ny = NY, .scale = { .lo = 0, .hi = 400 }
    };
}

static struct stroke traced(const struct figure_raster *r, double level)
{
    struct stroke s = STROKE_EMPTY;

    assert_int_equal(contour_trace(r, level, box, &s), STATUS_OK);
    return s;
}

static double cone(struct vec2 p)
{
    return vec2_length(vec2_sub(p, (struct vec2){ 300, 200 }));
}

static void a_circle_is_closed_and_round(void **state)
{
    (void) state;
    double value[NX * NY];
    const struct figure_raster r = map_of(cone, value);
    struct stroke s = traced(&r, 150);

    CHECK(s.count > 50 && fabs(stroke_length(&s) - 2 * M_PI * 150) < 2,
          "%zu points, %g px", s.count, stroke_length(&s));
    for (size_t k = 0; k < s.count; k++)
        CHECK(fabs(cone(s.at[k]) - 150) < 0.2, "%g", cone(s.at[k]));
    CHECK(vec2_length(vec2_sub(s.at[0], s.at[s.count - 1])) < 1e-9, "open");
    stroke_free(&s);
}

static double saddle(struct vec2 p)
{
    return 200 + (p.x - 300) * (p.y - 200) / 300;
}

/* Two branches on either side, which end at the outermost centres. */
static void a_hyperbola_has_two_pieces(void **state)
{
    (void) state;
    double value[NX * NY];
    const struct figure_raster r = map_of(saddle, value);
    for (int side = -1; side <= 1; side += 2) {
        struct stroke s = traced(&r, 200 + 7.3 * side);
        size_t pieces = 1;
        for (size_t k = 0; k < s.count; k++) {
            pieces += isnan(s.at[k].x) ? 1 : 0;
            CHECK(isnan(s.at[k].x) ||
                      fabs(saddle(s.at[k]) - 200 - 7.3 * side) < 0.2,
                  "(%g, %g)", s.at[k].x, s.at[k].y);
        }
        CHECK(pieces == 2, "%zu", pieces);
        stroke_free(&s);
    }
}

static double cliff(struct vec2 p)
{
    return p.y < 100 ? (double) NAN : p.x < 300 ? p.y / 8 : 200 + p.y / 8;
}

static void no_line_runs_along_a_step_or_where_there_is_no_value(void **state)
{
    (void) state;
    double value[NX * NY];
    const struct figure_raster r = map_of(cliff, value);
    struct stroke s = traced(&r, 150);
    CHECK(s.count == 0, "%zu points on the step", s.count);
    stroke_free(&s);
    s = traced(&r, 230);
    for (size_t k = 0; k < s.count; k++)
        CHECK(s.at[k].x > 300 && fabs(s.at[k].y - 240) < 1e-9, "(%g, %g)",
              s.at[k].x, s.at[k].y);
    CHECK(s.count > 20, "%zu", s.count);
    stroke_free(&s);
    s = traced(&r, 10);
    CHECK(s.count == 0, "%zu points where there is no value", s.count);
    stroke_free(&s);
}

static void labels_stand_on_lines_and_apart(void **state)
{
    (void) state;
    double value[NX * NY];
    const struct figure_raster r = map_of(cone, value);
    const struct vec2 size = { 30, 12 };
    struct keep keep;
    struct vec2 at[3];
    assert_int_equal(keep_init(&keep, box), STATUS_OK);
    for (size_t k = 0; k < 3; k++) {
        struct stroke s = traced(&r, 100 + 15 * (double) k);
        keep_stroke(&keep, &s, (uint8_t) (KEEP_OWN + k));
        assert_true(
            contour_place(&s, size, &keep, (uint8_t) (KEEP_OWN + k), &at[k]));
        keep_box(&keep, at[k], vec2_scale(1.5, size));
        CHECK(fabs(cone(at[k]) - 100 - 15 * (double) k) < 0.2, "%zu", k);
        for (size_t i = 0; i < k; i++)
            CHECK(fabs(at[i].x - at[k].x) > 2 * size.x ||
                      fabs(at[i].y - at[k].y) > 2 * size.y,
                  "%zu on %zu", k, i);
        stroke_free(&s);
    }
    struct stroke small = traced(&r, 12);
    assert_false(contour_place(&small, size, &keep, KEEP_OWN, &at[0]));
    stroke_free(&small);
    keep_free(&keep);
}

/* A label of the line y = 100 between curves at x = 100, 130 and 330, a mark
 * at x = 240, gaps from x = 360 on. */
static double slope(struct vec2 p)
{
    return p.x > 360 ? (double) NAN : p.y;
}

static void labels_keep_clear_of_curves_marks_gaps_and_edges(void **state)
{
    (void) state;
    double value[NX * NY];
    const struct figure_raster r = map_of(slope, value);
    const struct vec2 size = { 40, 12 };
    struct stroke s = traced(&r, 100);
    for (int how = 0; how < 8; how++) {
        const bool curves = how & 1, mark = how & 2, gaps = how & 4;
        const struct vec2 at_mark = { 240, 104 };
        struct keep keep;
        struct vec2 at;
        assert_int_equal(keep_init(&keep, box), STATUS_OK);
        keep_stroke(&keep, &s, KEEP_OWN);
        for (double x = 100; curves && x < 340; x += x < 120 ? 30 : 200)
            keep_stroke(
                &keep,
                &(struct stroke){ .at = (struct vec2[]){ { x, 0 }, { x, 300 } },
                                  .count = 2 },
                KEEP_ALL);
        if (mark)
            keep_box(&keep, at_mark, (struct vec2){ 4, 4 });
        if (gaps)
            keep_gaps(&keep, &r);
        assert_true(contour_place(&s, size, &keep, KEEP_OWN, &at));
        const double half = size.x / 2 + CONTOUR_CLEAR - 2.1;
        for (double x = 100; curves && x < 340; x += x < 120 ? 30 : 200)
            CHECK(fabs(at.x - x) > half, "%d: on a curve, %g", how, at.x);
        CHECK(!mark || fabs(at.x - at_mark.x) > half + 4, "%d: %g", how, at.x);
        CHECK(!gaps || at.x + half < 360, "%d: %g", how, at.x);
        CHECK(at.x > half && at.x + half < box.x, "%d: %g", how, at.x);
        /* No room at all: left out. */
        for (double x = 0; x < box.x; x += 45)
            keep_box(&keep, (struct vec2){ x, 100 }, (struct vec2){ 1, 1 });
        assert_false(contour_place(&s, size, &keep, KEEP_OWN, &at));
        keep_free(&keep);
    }
    stroke_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_circle_is_closed_and_round),
        cmocka_unit_test(a_hyperbola_has_two_pieces),
        cmocka_unit_test(no_line_runs_along_a_step_or_where_there_is_no_value),
        cmocka_unit_test(labels_stand_on_lines_and_apart),
        cmocka_unit_test(labels_keep_clear_of_curves_marks_gaps_and_edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
