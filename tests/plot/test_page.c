/* Figures on paper: as large as asked for in every format, with plots of one
 * size. */
#include "check.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "draw.h"
#include "own_folder.h"
#include "palette.h"
#include "plane.h"
#include "sample_figure.h"

struct bytes {
    char *at; /* owned, ends in 0 */
    size_t size;
};

/* Also where there are zeros before. */
static const char *find(const struct bytes *b, const char *key)
{
    const char *at = memmem(b->at, b->size, key, strlen(key));
    CHECK(at, "no %s", key);
    return at + strlen(key);
}

static struct bytes drawn(const struct figure *f, const char *name,
                          const char *file)
{
    struct fault fault = { "" };
    struct bytes b;
    const enum status s = sample_draw(f, own_path(name), true, &fault);
    CHECK(s == STATUS_OK, "%s", fault.text);
    b.at = file_read(own_path(file), &b.size);
    return b;
}

static const struct figure_page column = { .width = 89,
                                           .height = 81.3,
                                           .type = 8,
                                           .dpi = 300,
                                           .legend = FIGURE_LEGEND_BELOW };

/* Big-endian, as PNG has them. */
static double number_at(const struct bytes *b, size_t at)
{
    double n = 0;
    for (size_t k = 0; k < 4; k++)
        n = 256 * n + (unsigned char) b->at[at + k];
    return n;
}

static void a_page_is_as_large_as_it_was_asked_for(void **state)
{
    (void) state;
    struct figure f;
    double side[4];

    sample_portrait(&f, "A saddle");
    f.page = column;
    struct bytes b = drawn(&f, "p.svg", "p.svg");
    CHECK(strstr(b.at, " width=\"89mm\" height=\"81.3mm\""), "%.200s", b.at);
    assert_int_equal(
        sscanf(find(&b, "viewBox=\""), "0 0 %lf %lf", &side[2], &side[3]), 2);
    CHECK(fabs(side[2] / side[3] / (89 / 81.3) - 1) < 1e-6, "%g", side[2]);
    free(b.at);
    b = drawn(&f, "p.pdf", "p.pdf");
    assert_int_equal(sscanf(find(&b, "/MediaBox ["), "%lf %lf %lf %lf",
                            &side[0], &side[1], &side[2], &side[3]),
                     4);
    CHECK(fabs((side[2] - side[0]) * 25.4 / 72 - 89) < 1e-4, "%g", side[2]);
    CHECK(fabs((side[3] - side[1]) * 25.4 / 72 - 81.3) < 1e-4, "%g", side[3]);
    free(b.at);
    b = drawn(&f, "p.png", "p.png");
    assert_memory_equal(b.at + 37, "pHYs", 4);
    for (size_t k = 0; k < 2; k++) {
        const double dots = number_at(&b, 16 + 4 * k);
        const double per_metre = number_at(&b, 41 + 4 * k);
        CHECK(fabs(1e3 * dots / per_metre - (k ? 81.3 : 89)) < 12.7 / 300,
              "%g dots, %g per metre", dots, per_metre);
    }
    free(b.at);
    figure_free(&f);
}

/* Offsets of a PDF's objects, as its table has them. */
static void a_pdf_s_objects_are_where_it_says(void **state)
{
    (void) state;
    struct figure f;

    sample_portrait(&f, "A saddle");
    f.page = column;
    struct bytes b = drawn(&f, "p.pdf", "p.pdf");
    const long table = strtol(find(&b, "\nstartxref\n"), NULL, 10);
    CHECK(memcmp(b.at + table, "xref\n", 5) == 0, "%ld", table);
    const char *row = strchr(b.at + table + 5, '\n') + 1;
    int seen = 0;
    for (int k = 0; row[0] >= '0' && row[0] <= '9'; k++, row += 20) {
        char wanted[32];
        snprintf(wanted, sizeof wanted, "%d 0 obj", k);
        if (row[17] != 'n')
            continue;
        CHECK(memcmp(b.at + strtol(row, NULL, 10), wanted, strlen(wanted)) == 0,
              "object %d", k);
        seen++;
    }
    CHECK(seen > 5, "%d objects", seen);
    free(b.at);
    figure_free(&f);
}

/* The plot's size in px of the SVG. */
static struct vec2 plot_size(struct figure *f)
{
    static const char *const name[] = { "l", "r", "b", "t" };
    struct bytes b = drawn(f, "p.svg", "p.gp");
    double side[4], wide, high;

    for (size_t k = 0; k < 4; k++) {
        char key[32];
        snprintf(key, sizeof key, "set %smargin at screen", name[k]);
        side[k] = strtod(find(&b, key), NULL);
    }
    assert_int_equal(sscanf(find(&b, " svg size "), "%lf,%lf", &wide, &high),
                     2);
    free(b.at);
    return (struct vec2){ (side[1] - side[0]) * wide,
                          (side[3] - side[2]) * high };
}

/* Whatever the legends hold, in each of their places. */
static void panels_have_plots_of_one_size(void **state)
{
    (void) state;
    for (int k = FIGURE_LEGEND_OUTSIDE; k <= FIGURE_LEGEND_NONE; k++) {
        struct figure f[2];
        struct vec2 size[2];
        figure_init(&f[0], "Empty", &sample_v, &sample_psi);
        sample_portrait(&f[1], "A saddle");
        for (int i = 0; i < 2; i++) {
            f[i].page = figure_screen;
            f[i].page.legend = (enum figure_legend) k;
            f[i].page.height = 0;
            size[i] = plot_size(&f[i]);
            figure_free(&f[i]);
        }
        CHECK(size[0].x > 100 && fabs(size[0].x - size[1].x) < 0.01 &&
                  fabs(size[0].y - size[1].y) < 0.01,
              "legend %d: %g x %g, %g x %g px", k, size[0].x, size[0].y,
              size[1].x, size[1].y);
    }
}

static void a_page_without_room_is_refused(void **state)
{
    (void) state;
    struct figure f;
    struct fault fault = { "" };

    sample_portrait(&f, "A saddle");
    f.page = (struct figure_page){ .width = 30, .type = 30, .dpi = 300 };
    assert_int_equal(sample_draw(&f, own_path("q.svg"), false, &fault),
                     STATUS_BAD_ARGUMENT);
    CHECK(strstr(fault.text, "30 mm") && strstr(fault.text, "30 pt"), "%s",
          fault.text);
    assert_int_not_equal(access(own_path("q.svg"), F_OK), 0);
    figure_free(&f);
}

/* L* of CIE 1976, of sRGB under D65. */
static double lightness(const char *colour)
{
    static const double part[] = { 0.2126, 0.7152, 0.0722 };
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        char two[3] = { colour[1 + 2 * k], colour[2 + 2 * k], 0 };
        const double c = (double) strtol(two, NULL, 16) / 255;
        sum += part[k] *
               (c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4));
    }
    return sum > 216.0 / 24389 ? 116 * cbrt(sum) - 16 : sum * 24389 / 27;
}

/* Equal steps look equal: none is more than a third off their mean. */
static void maps_grow_evenly_lighter(void **state)
{
    (void) state;
    for (int k = 0; k < FIGURE_COLOURS; k++) {
        const char(*map)[8] = palette_map[k];
        const double all =
            lightness(map[PALETTE_TINTS - 1]) - lightness(map[0]);
        const double mean = all / (PALETTE_TINTS - 1);
        CHECK(all > 60, "map %d: %g", k, all);
        for (int i = 0; i + 1 < PALETTE_TINTS; i++) {
            const double step = lightness(map[i + 1]) - lightness(map[i]);
            CHECK(fabs(step / mean - 1) < 1.0 / 3, "map %d, step %d: %g of %g",
                  k, i, step, mean);
        }
    }
}

/* Regions side by side can be told apart in grey. */
static void no_two_tints_are_equally_light(void **state)
{
    (void) state;
    for (int i = FIGURE_SHADE_1; i <= FIGURE_SHADE_6; i++)
        for (int k = FIGURE_SHADE_1; k < i; k++) {
            const char *a =
                paint_of((struct figure_style){ .role = (enum figure_role) i })
                    .colour;
            const char *b =
                paint_of((struct figure_style){ .role = (enum figure_role) k })
                    .colour;
            CHECK(fabs(lightness(a) - lightness(b)) > 2.5, "%s, %s", a, b);
        }
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(a_page_is_as_large_as_it_was_asked_for),
        IN_FOLDER(a_pdf_s_objects_are_where_it_says),
        IN_FOLDER(panels_have_plots_of_one_size),
        cmocka_unit_test(maps_grow_evenly_lighter),
        cmocka_unit_test(no_two_tints_are_equally_light),
        IN_FOLDER(a_page_without_room_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
