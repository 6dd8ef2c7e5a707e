/* Figures as files: what lib/plot leaves behind, and what it refuses. */
#include "check.h"

#include <dirent.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "draw.h"
#include "fault_alloc.h"
#include "gnuplot.h"
#include "line.h"
#include "sample_figure.h"

static const char hostile[] = "a`touch x`b\"; system('touch y') $ @ "
                              "{/Symbol a} \\n \n<b> & 50% \xcf\x88";

/* A folder of its own for each test, and how many files it holds. */
struct place {
    char folder[64];
    char path[512];
};

static int place_setup(void **state)
{
    struct place *p = test_calloc(1, sizeof *p);
    strcpy(p->folder, "/tmp/test_plot.XXXXXX");
    *state = p;
    return mkdtemp(p->folder) ? 0 : -1;
}

static const char *place_path(struct place *p, const char *name)
{
    snprintf(p->path, sizeof p->path, "%s/%s", p->folder, name);
    return p->path;
}

/* Files in the folder, removed on the way where wanted. */
static int place_count(struct place *p, bool empty)
{
    int count = 0;
    DIR *d = opendir(p->folder);
    for (struct dirent *e; d && (e = readdir(d));) {
        if (strcmp(e->d_name, ".") == 0 || strcmp(e->d_name, "..") == 0)
            continue;
        count++;
        if (empty)
            remove(place_path(p, e->d_name));
    }
    closedir(d);
    return count;
}

static int place_teardown(void **state)
{
    struct place *p = *state;
    place_count(p, true);
    rmdir(p->folder);
    test_free(p);
    return 0;
}

struct bytes {
    char *at; /* owned, ends in 0 */
    size_t size;
};

static struct bytes read_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    CHECK(file, "%s is missing", path);
    fseek(file, 0, SEEK_END);
    struct bytes b = { NULL, (size_t) ftell(file) };
    b.at = test_calloc(b.size + 1, 1);
    rewind(file);
    CHECK(fread(b.at, 1, b.size, file) == b.size, "%s", path);
    fclose(file);
    return b;
}

static void check_ok(enum status s, const struct fault *fault)
{
    CHECK(s == STATUS_OK, "%s: %s", status_text(s), fault->text);
}

static const char *const formats[] = { "p.svg", "p.pdf", "p.png" };

static void each_format_is_what_its_name_says(void **state)
{
    static const char *const starts[] = { "<?xml", "%PDF-", "\x89PNG\r\n" };
    struct place *p = *state;
    struct figure f;
    struct fault fault = { "" };
    sample_portrait(&f, "A saddle");
    for (size_t k = 0; k < 3; k++) {
        const char *path = place_path(p, formats[k]);
        check_ok(sample_draw(&f, path, false, &fault), &fault);
        struct bytes b = read_file(path);
        CHECK(memcmp(b.at, starts[k], strlen(starts[k])) == 0, "%s", path);
        CHECK(b.size > 10000, "%zu bytes", b.size);
        test_free(b.at);
    }
    CHECK(place_count(p, false) == 3, "%d files", place_count(p, false));
    figure_free(&f);
}

static void the_same_figure_gives_the_same_bytes(void **state)
{
    struct place *p = *state;
    struct figure f;
    struct fault fault = { "" };
    sample_portrait(&f, "A saddle");
    for (size_t k = 0; k < 3; k++) {
        struct bytes b[2];
        for (int i = 0; i < 2; i++) {
            if (i == 1 && k == 1)
                sleep(1); /* a PDF knows the second it was made in */
            check_ok(sample_draw(&f, place_path(p, formats[k]), false, &fault),
                     &fault);
            b[i] = read_file(p->path);
        }
        CHECK(b[0].size == b[1].size &&
                  memcmp(b[0].at, b[1].at, b[0].size) == 0,
              "%s", formats[k]);
        test_free(b[0].at);
        test_free(b[1].at);
    }
    figure_free(&f);
}

static void a_kept_script_redraws_the_figure(void **state)
{
    struct place *p = *state;
    struct figure f;
    struct fault fault = { "" };
    sample_portrait(&f, "A saddle");
    check_ok(sample_draw(&f, place_path(p, "it's.svg"), true, &fault), &fault);
    CHECK(place_count(p, false) == 3, "%d files", place_count(p, false));
    struct bytes before = read_file(place_path(p, "it's.svg"));
    remove(p->path);
    check_ok(gnuplot_run(p->folder, "it's.gp", &fault), &fault);
    struct bytes after = read_file(place_path(p, "it's.svg"));
    /* but for how large it is on paper */
    const char *a = strstr(before.at, " xmlns="),
               *b = strstr(after.at, " xmlns=");
    CHECK(a && b && strcmp(a, b) == 0, "another figure");
    test_free(before.at);
    test_free(after.at);
    figure_free(&f);
}

/* As it must stand in an SVG file: only & and < written otherwise. */
static const char hostile_svg[] = "a`touch x`b\"; system('touch y') $ @ "
                                  "{/Symbol a} \\n  &lt;b> &amp; 50% "
                                  "\xcf\x88";

static void a_text_is_never_a_command_nor_markup(void **state)
{
    struct place *p = *state;
    const struct figure_axis x = { hostile, 0, 1, false };
    struct figure f;
    struct fault fault = { "" };
    const double at = 0.5;
    figure_init(&f, hostile, &x, &x);
    sample_mark(&f, FIGURE_DISC, hostile, at, at);
    f.page.width *= 2;
    f.page.height *= 1.5;
    f.page.legend = FIGURE_LEGEND_BELOW;
    check_ok(
        sample_draw(&f, place_path(p, "|touch z;`touch z`.svg"), false, &fault),
        &fault);
    CHECK(place_count(p, false) == 1, "%d files", place_count(p, false));
    CHECK(access("x", F_OK) && access("y", F_OK) && access("z", F_OK), "ran");
    struct bytes b = read_file(p->path);
    int found = 0;
    for (char *t = b.at; (t = strstr(t, hostile_svg)); t++)
        found++;
    CHECK(found == 4, "title, axes, legend: %d", found);
    test_free(b.at);
    figure_free(&f);
}

static void bytes_that_are_no_text_still_give_a_figure(void **state)
{
    struct place *p = *state;
    struct figure f;
    struct fault fault = { "" };
    figure_init(&f, "a\xff\x01\xc3(\xed\xa0\x80z", &sample_v, &sample_psi);
    check_ok(sample_draw(&f, place_path(p, "p.svg"), false, &fault), &fault);
    struct bytes b = read_file(p->path);
    CHECK(strstr(b.at, "a? ?(???z"), "title");
    test_free(b.at);
    figure_free(&f);
}

static void curves_end_at_the_frame_and_break_at_nan(void **state)
{
    struct place *p = *state;
    const double x[] = { -1e200, 0.5, NAN, 0.5, 1e300, INFINITY, 0.2, 0.3 };
    const double y[] = { 0.25, 0.25, 0.3, 0.75, 0.75, 0.1, 0.1, 0.1 };
    const struct figure_axis unit = { NULL, 0, 1, false };
    struct figure f;
    struct fault fault = { "" };
    figure_init(&f, NULL, &unit, &unit);
    figure_add(&f,
               &(struct figure_layer){
                   .style.role = FIGURE_STABLE, .x = x, .y = y, .count = 8 });
    check_ok(sample_draw(&f, place_path(p, "p.svg"), true, &fault), &fault);
    struct bytes b = read_file(place_path(p, "p.dat"));
    CHECK(strstr(b.at, "\n0 0.25\n0.5 0.25\n\n0.5 0.75\n1 0.75\n\n"
                       "0.2 0.1\n0.3 0.1\n"),
          "%.400s", b.at);
    test_free(b.at);
    figure_free(&f);
}

static void a_map_shows_its_scale(void **state)
{
    struct place *p = *state;
    const double value[] = { 1e-3, 1, NAN, 1e5, -1, INFINITY };
    struct figure f;
    struct fault fault = { "" };
    figure_init(&f, NULL, &sample_v, &sample_psi);
    const struct figure_map map = { value, 3,   2, { "slip / L", 0, 0, true },
                                    false, NULL };
    figure_add_map(&f, &map);
    check_ok(sample_draw(&f, place_path(p, "p.svg"), true, &fault), &fault);
    struct bytes b = read_file(p->path);
    CHECK(strstr(b.at, "slip / L") && strstr(b.at, "<image"), "no bar");
    test_free(b.at);
    b = read_file(place_path(p, "p.gp"));
    double lo = 0, hi = 0;
    const char *range = strstr(b.at, "set cbrange ["); /* in decades */
    CHECK(range && sscanf(range, "set cbrange [%lf:%lf]", &lo, &hi) == 2 &&
              fabs(lo + 3) < 1e-12 && fabs(hi - 5) < 1e-12,
          "%.17g:%.17g", lo, hi);
    test_free(b.at);
    figure_free(&f);
}

static void every_line_of_the_legend_appears_once(void **state)
{
    struct place *p = *state;
    struct figure f;
    struct fault fault = { "" };
    sample_portrait(&f, NULL);
    check_ok(sample_draw(&f, place_path(p, "p.svg"), false, &fault), &fault);
    struct bytes b = read_file(p->path);
    char *first = strstr(b.at, ">trajectories</text>");
    CHECK(first && !strstr(first + 1, ">trajectories</text>"), "trajectories");
    CHECK(strstr(b.at, ">basin of rest</text>"), "a shade");
    test_free(b.at);
    figure_free(&f);
}

/* Writes an empty figure and expects a refusal that holds `word`. */
static void expect(struct place *p, const struct figure_axis *x,
                   const char *path, enum status wanted, const char *word)
{
    struct figure f;
    struct fault fault = { "" };
    const int before = place_count(p, false);
    figure_init(&f, "t", x, x);
    const enum status s = sample_draw(&f, path, true, &fault);
    CHECK(s == wanted, "%s: %s", status_text(s), fault.text);
    CHECK(strstr(fault.text, word), "%s", fault.text);
    CHECK(!strchr(fault.text, '\n'), "%s", fault.text);
    CHECK(place_count(p, false) == before, "left something behind");
    figure_free(&f);
}

static void a_bad_request_is_refused_by_name(void **state)
{
    struct place *p = *state;
    const struct figure_axis empty = { "v", 3, 3, false };
    const struct figure_axis negative = { "v", -1, 3, true };
    const struct figure_axis wild = { "v", 0, NAN, false };
    const struct {
        const struct figure_axis *x;
        const char *name, *word;
    } cases[] = {
        { &sample_v, "p.bmp", ".bmp" }, { &sample_v, "p", "expected .svg" },
        { &empty, "p.svg", "from 3" },  { &negative, "p.svg", "log" },
        { &wild, "p.svg", "nan" },      { &sample_v, "a\nb.svg", "control" },
    };
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        char path[512];
        snprintf(path, sizeof path, "%s/%s", p->folder, cases[k].name);
        expect(p, cases[k].x, path, STATUS_BAD_ARGUMENT, cases[k].word);
    }
}

static void a_folder_that_cannot_be_written_is_an_io_fault(void **state)
{
    struct place *p = *state;
    expect(p, &sample_v, "/nowhere/at/all/p.svg", STATUS_IO, "No such file");
    expect(p, &sample_v, "/dev/null/p.svg", STATUS_IO, "/dev/null/p.svg");
    mkdir(place_path(p, "taken.svg"), 0777);
    expect(p, &sample_v, place_path(p, "taken.svg"), STATUS_IO, "taken.svg");
}

/* Puts a shell script in gnuplot's place, nothing if body is NULL. */
static char *replace_gnuplot(struct place *p, const char *body)
{
    char *old = getenv("PATH");
    char *saved = strdup(old ? old : "");
    if (body) {
        FILE *file = fopen(place_path(p, "gnuplot"), "w");
        fprintf(file, "#!/bin/sh\n%s\n", body);
        fclose(file);
        chmod(p->path, 0755);
    }
    setenv("PATH", p->folder, 1);
    return saved;
}

static void without_a_working_gnuplot_there_is_no_figure(void **state)
{
    static const struct {
        const char *body, *word;
    } cases[] = {
        { NULL, "not found" },
        { "exit 0", "drew nothing" },
        { ": > p.svg", "drew nothing" },
        { "echo '<svg>' > p.svg", "did not draw all" },
        { "printf '%09999d' 0 > p.svg", "did not draw all" },
        { "echo >&2; echo 'plot x(' >&2; echo '       ^' >&2;"
          "echo '\"p.gp\" line 3: warning: skipped' >&2;"
          "echo '\"p.gp\" line 7: undefined function' >&2; exit 1",
          "gnuplot failed: \"p.gp\" line 7: undefined function" },
        { "echo something else >&2; exit 1", "something else" },
        { "kill -9 $$", "no reason" },
        { "i=0; while [ $i -lt 9000 ]; do echo 0123456789 >&2;"
          " i=$((i+1)); done; exit 3",
          "0123456789" },
    };
    struct place *p = *state;
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        char path[512];
        char *saved = replace_gnuplot(p, cases[k].body);
        snprintf(path, sizeof path, "%s/p.svg", p->folder);
        expect(p, &sample_v, path, STATUS_NO_GNUPLOT, cases[k].word);
        setenv("PATH", saved, 1);
        free(saved);
    }
}

/* Builds and writes everything with allocation k failing. */
static enum status portrait_failing_at(struct place *p, int k)
{
    struct figure f;
    struct fault fault = { "" };
    fault_alloc_at(k);
    sample_portrait(&f, "A saddle");
    const enum status s =
        sample_draw(&f, place_path(p, "p.pdf"), false, &fault);
    figure_free(&f);
    figure_free(&f);
    fault_alloc_at(FAULT_ALLOC_NEVER);
    return s;
}

static void every_allocation_may_fail(void **state)
{
    struct place *p = *state;
    enum status s = STATUS_NO_MEMORY;
    int k = 0;
    for (; s != STATUS_OK; k++) {
        s = portrait_failing_at(p, k);
        CHECK(s == STATUS_OK || s == STATUS_NO_MEMORY, "%s", status_text(s));
        CHECK(s == STATUS_OK || place_count(p, false) == 0, "file at %d", k);
    }
    CHECK(k > 90, "only %d allocations", k);
}

/* Nothing is added after it, and the second raster replaces the first. */
static void a_figure_remembers_its_first_failure(void **state)
{
    struct place *p = *state;
    const double value[] = { 1, 2 };
    const struct figure_map map = { value, 2,   1, { "slip", 0, 0, false },
                                    false, NULL };
    const double x[] = { 0, 1, 0 }, y[] = { 0, 0, 1 };
    const struct figure_layer region = {
        .kind = FIGURE_REGION, .entry = "r", .x = x, .y = y, .count = 3
    };
    struct fault fault = { "" };
    struct figure f;

    for (int k = 0; k < 6; k++) {
        figure_init(&f, NULL, &sample_v, &sample_psi);
        figure_add_map(&f, &map);
        const struct figure_raster *first = f.raster;
        fault_alloc_at(k % 3);
        if (k < 3)
            figure_add_map(&f, &map);
        else
            figure_add(&f, &region);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        assert_int_equal(f.status, STATUS_NO_MEMORY);
        figure_add(&f, &region);
        figure_add_map(&f, &map);
        assert_int_equal(f.layer_count, 0);
        assert_ptr_equal(f.raster, first);
        assert_int_equal(sample_draw(&f, place_path(p, "p.svg"), false, &fault),
                         STATUS_NO_MEMORY);
        CHECK(strstr(fault.text, "p.svg"), "%s", fault.text);
        figure_free(&f);
    }
    figure_init(&f, NULL, &sample_v, &sample_psi);
    figure_add_map(&f, &map);
    const struct figure_raster *first = f.raster;
    figure_add_map(&f, &map);
    assert_true(f.status == STATUS_OK && f.raster != first);
    figure_free(&f);
}

/* As many points as come; two of a curve at least, one of points. */
static void a_line_becomes_a_layer_and_its_failure_the_figures(void **state)
{
    (void) state;
    const struct figure_layer curve = { .kind = FIGURE_CURVE },
                              points = { .kind = FIGURE_POINTS };
    struct line l = LINE_EMPTY;
    struct figure f;

    figure_init(&f, NULL, &sample_v, &sample_psi);
    for (int n = 0; n < 3; n++)
        for (int k = 0; k < 2; k++) {
            const size_t before = f.layer_count;
            for (int i = 0; i < n; i++)
                line_add(&l, i, -i);
            figure_add_line(&f, k ? &points : &curve, &l);
            assert_int_equal(f.layer_count - before, n > (k == 0));
            assert_int_equal(l.count, 0);
        }
    for (int i = 0; i < 3000; i++)
        line_add(&l, i, -i);
    CHECK(l.count == 3000 && l.x[2999] == 2999 && l.y[2999] == -2999, "%zu",
          l.count);
    fault_alloc_at(0);
    for (int i = 0; i < 3000; i++)
        line_add(&l, i, -i);
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_true(l.failed);
    figure_add_line(&f, &curve, &l);
    assert_int_equal(f.status, STATUS_NO_MEMORY);
    figure_free(&f);
}

#define PLACED(test)                                                           \
    cmocka_unit_test_setup_teardown(test, place_setup, place_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        PLACED(each_format_is_what_its_name_says),
        PLACED(the_same_figure_gives_the_same_bytes),
        PLACED(a_kept_script_redraws_the_figure),
        PLACED(a_text_is_never_a_command_nor_markup),
        PLACED(bytes_that_are_no_text_still_give_a_figure),
        PLACED(curves_end_at_the_frame_and_break_at_nan),
        PLACED(a_map_shows_its_scale),
        PLACED(every_line_of_the_legend_appears_once),
        PLACED(a_bad_request_is_refused_by_name),
        PLACED(a_folder_that_cannot_be_written_is_an_io_fault),
        PLACED(without_a_working_gnuplot_there_is_no_figure),
        PLACED(every_allocation_may_fail),
        PLACED(a_figure_remembers_its_first_failure),
        cmocka_unit_test(a_line_becomes_a_layer_and_its_failure_the_figures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
