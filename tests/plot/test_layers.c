/* What lies on what, what tells curves apart, what a legend lists. */
#include "check.h"

#include <math.h>
#include <string.h>

#include "crowd.h"
#include "draw.h"
#include "fault_alloc.h"
#include "own_folder.h"
#include "sample_figure.h"

/* Draws the figure and returns one of its files, to be freed. */
static char *drawn(const struct figure *f, const char *file)
{
    struct fault fault = { "" };
    size_t size;
    const enum status s = sample_draw(f, own_path("p.svg"), true, &fault);

    CHECK(s == STATUS_OK, "%s", fault.text);
    return file_read(own_path(file), &size);
}

/* The first and the last block of data of a kind, in drawing order. */
struct span {
    long first, last;
};

static struct span blocks_of(const char *data, const char *kind)
{
    struct span s = { -1, -1 };

    for (const char *at = data; (at = strstr(at, "# block ")); at++) {
        char *end;
        const long block = strtol(at + strlen("# block "), &end, 10);
        if (strncmp(end + 2, kind, strlen(kind)) != 0)
            continue;
        s.first = s.first < 0 ? block : s.first;
        s.last = block;
    }
    CHECK(s.first >= 0, "no %s", kind);
    return s;
}

static void arrowheads_lie_on_all_curves_and_marks_on_them(void **state)
{
    (void) state;
    struct figure f;

    sample_portrait(&f, NULL);
    char *data = drawn(&f, "p.dat");
    const struct span curves = blocks_of(data, "curves"),
                      heads = blocks_of(data, "arrowheads"),
                      points = blocks_of(data, "points");
    CHECK(curves.last < heads.first && heads.last < points.first,
          "curves to %ld, heads from %ld to %ld, points from %ld", curves.last,
          heads.first, heads.last, points.first);
    free(data);
    figure_free(&f);
}

/* What gnuplot is told of a line after its colour. */
static void read_dash(const char *script, long block, char *dash, size_t size)
{
    static const char colour[] = "lc rgb '#000000'";
    char key[48];

    snprintf(key, sizeof key, "data index %ld with lines", block);
    const char *at = strstr(script, key);
    at = at ? strstr(at, "lc rgb '#") : NULL;
    CHECK(at, "no %s", key);
    at += strlen(colour);
    snprintf(dash, size, "%.*s", (int) strcspn(at, ")\n\\"), at);
    dash[strcspn(dash, ",") == 0 ? 0 : strlen(dash)] = '\0';
}

/* Draws curves of these roles and compares their dashes. */
static void check_dashes(const enum figure_role role[], int count)
{
    const double x[] = { 1e-5, 1e5 };
    char dash[6][64];
    struct figure f;

    figure_init(&f, NULL, &sample_v, &sample_psi);
    for (int k = 0; k < count; k++)
        figure_add(&f, &(struct figure_layer){
                           .style = { .role = role[k] },
                           .x = x,
                           .y = (const double[]){ 0.1 + k, 0.1 + k },
                           .count = 2 });
    char *script = drawn(&f, "p.gp");
    for (int k = 0; k < count; k++) {
        read_dash(script, k, dash[k], sizeof dash[k]);
        for (int i = 0; i < k; i++)
            CHECK(strcmp(dash[i], dash[k]) != 0, "%d and %d: %s", i, k,
                  dash[k]);
    }
    free(script);
    figure_free(&f);
}

/* Numbered curves; both manifolds; both nullclines. */
static void curves_of_a_kind_differ_by_their_dash(void **state)
{
    (void) state;
    enum figure_role series[6];

    for (int k = 0; k < 6; k++)
        series[k] = (enum figure_role)(FIGURE_SERIES_1 + k);
    check_dashes(series, 6);
    check_dashes((const enum figure_role[]){ FIGURE_STABLE, FIGURE_UNSTABLE },
                 2);
    check_dashes(
        (const enum figure_role[]){ FIGURE_NULLCLINE_X, FIGURE_NULLCLINE_Y },
        2);
}

/* In the window at `at`, or as far beyond it. */
static void add_each(struct figure *f, const char *const entry[3], double at)
{
    const double x[] = { at, 2 * at, 3 * at }, y[] = { 1, 2, 1 };
    const enum figure_kind kind[] = { FIGURE_CURVE, FIGURE_POINTS,
                                      FIGURE_REGION };

    for (int k = 0; k < 3; k++)
        figure_add(f, &(struct figure_layer){ .kind = kind[k],
                                              .style = { FIGURE_SERIES_1 },
                                              .entry = entry[k],
                                              .x = x,
                                              .y = y,
                                              .count = 3 });
}

static void legends_list_what_is_drawn_and_nothing_else(void **state)
{
    (void) state;
    static const char *const here[] = { "curve here", "mark here",
                                        "region here" };
    static const char *const away[] = { "curve away", "mark away",
                                        "region away" };
    static const struct figure_shade shades[] = {
        { 0, FIGURE_SHADE_1, "shade here" }, { 1, FIGURE_SHADE_2, "shade away" }
    };
    const int8_t label[] = { 0, 0 };
    struct figure f;

    figure_init(&f, NULL, &sample_v, &sample_psi);
    add_each(&f, here, 10);
    add_each(&f, away, 1e9);
    figure_add_labels(&f,
                      &(struct figure_labels){ label, 2, 1, shades, 2, NULL });
    char *svg = drawn(&f, "p.svg");
    for (int k = 0; k < 3; k++)
        CHECK(strstr(svg, here[k]) && !strstr(svg, away[k]), "%s", away[k]);
    CHECK(strstr(svg, "shade here") && !strstr(svg, "shade away"), "shades");
    free(svg);
    figure_free(&f);
}

/* Of a map: the entry of cells that have no value is there when they are. */
static void a_map_without_gaps_has_no_entry_for_them(void **state)
{
    (void) state;
    for (int gaps = 0; gaps < 2; gaps++) {
        const double value[] = { 1, gaps ? NAN : 2 };
        struct figure f;
        figure_init(&f, NULL, &sample_v, &sample_psi);
        figure_add_map(&f, &(struct figure_map){ .value = value,
                                                 .nx = 2,
                                                 .ny = 1,
                                                 .missing = "does not exist" });
        char *svg = drawn(&f, "p.svg");
        CHECK((strstr(svg, "does not exist") != NULL) == gaps, "%d", gaps);
        free(svg);
        char *script = drawn(&f, "p.gp");
        CHECK((strstr(script, "nohead back") != NULL) == gaps &&
                  (strstr(script, "nohead front") != NULL) == gaps,
              "hatching %d", gaps);
        free(script);
        figure_free(&f);
    }
}

static void labels_without_a_shade_are_hatched_where_that_is_said(void **state)
{
    static const struct figure_shade shade = { 0, FIGURE_SHADE_1, "here" };

    (void) state;
    for (int said = 0; said < 2; said++) {
        const int8_t label[] = { 0, -1 };
        struct figure f;
        figure_init(&f, NULL, &sample_v, &sample_psi);
        figure_add_labels(&f,
                          &(struct figure_labels){ label, 2, 1, &shade, 1,
                                                   said ? "unknown" : NULL });
        char *script = drawn(&f, "p.gp");
        CHECK((strstr(script, "nohead back") != NULL) == said &&
                  (strstr(script, "unknown") != NULL) == said,
              "%d", said);
        free(script);
        figure_free(&f);
    }
}

/* A line along (0.2, 0.5), (0.8, 0.5), (0.8, top) meets one that stands at 0.8
 * and is not drawn beyond; nor is any beside another. */
static void lines_end_where_they_join_others(void **state)
{
    (void) state;
    const struct figure_axis unit = { NULL, 0, 1, false };
    const double cell = 1.0 / CROWD_CELLS;
    struct crowd *c = test_calloc(1, sizeof *c);
    struct line l = LINE_EMPTY;
    struct figure f;
    double right = 0, top = 0;

    figure_init(&f, NULL, &unit, &unit);
    crowd_init(c, &f);
    for (int k = 0; k < 2; k++)
        line_add(&l, 0.8, k);
    crowd_take(c, &l);
    line_free(&l);
    line_add(&l, 0.2, 0.5);
    line_add(&l, 0.8, 0.5);
    line_add(&l, 0.8, 0.9);
    crowd_cut(c, &l);
    for (size_t i = 0; i < l.count; i++) {
        right = fmax(right, l.x[i]);
        top = fmax(top, l.y[i]);
    }
    CHECK(l.x[0] == 0.2 && fabs(right - 0.8) < 2 * cell && top < 0.5 + 4 * cell,
          "to (%g, %g)", right, top);
    line_free(&l);
    for (int k = -1; k <= 1; k++) {
        line_add(&l, 0.3, 0.5 + k * cell);
        line_add(&l, 0.7, 0.5 + k * cell);
        crowd_cut(c, &l);
        CHECK(l.count == 0, "%zu points", l.count);
        line_free(&l);
    }
    figure_free(&f);
    test_free(c);
}

/* A line that could not be taken, for memory ran out, leaves none uncut. */
static void a_line_that_was_not_taken_fails_those_that_are_cut(void **state)
{
    (void) state;
    const struct figure_axis unit = { NULL, 0, 1, false };
    struct crowd *c = test_calloc(1, sizeof *c);
    struct line across = LINE_EMPTY, l = LINE_EMPTY;
    struct figure f;

    figure_init(&f, NULL, &unit, &unit);
    crowd_init(c, &f);
    for (int k = 0; k < 2; k++)
        line_add(&across, 0.8, k);
    line_add(&l, 0.2, 0.5);
    line_add(&l, 0.9, 0.5);
    fault_alloc_at(0);
    crowd_take(c, &across);
    fault_alloc_at(FAULT_ALLOC_NEVER);
    crowd_cut(c, &l);
    assert_true(l.failed);
    line_free(&across);
    line_free(&l);
    figure_free(&f);
    test_free(c);
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(arrowheads_lie_on_all_curves_and_marks_on_them),
        IN_FOLDER(curves_of_a_kind_differ_by_their_dash),
        IN_FOLDER(legends_list_what_is_drawn_and_nothing_else),
        IN_FOLDER(a_map_without_gaps_has_no_entry_for_them),
        IN_FOLDER(labels_without_a_shade_are_hatched_where_that_is_said),
        cmocka_unit_test(lines_end_where_they_join_others),
        cmocka_unit_test(a_line_that_was_not_taken_fails_those_that_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
