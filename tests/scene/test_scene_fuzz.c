/* Scenes with anything done to them: read, or refused in one line. */
#include <ctype.h>
#include <glob.h>
#include <math.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "check.h"
#include "merge.h"
#include "scenes.h"
#include "text.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

enum { TEXT_SIZE = 4096, ROUNDS = 20000 };

/* ---- mutations ----------------------------------------------------------- */

struct draft {
    char text[TEXT_SIZE];
    size_t size;
    uint64_t seed;
};

static size_t below(struct draft *d, size_t n)
{
    return n ? check_bits(&d->seed) % n : 0;
}

/* `size` bytes at `at` become `bytes`; nothing where there is no room. */
static void replace(struct draft *d, size_t at, size_t size, const char *bytes,
                    size_t count)
{
    if (d->size - size + count >= TEXT_SIZE)
        return;
    memmove(d->text + at + count, d->text + at + size, d->size - at - size);
    memcpy(d->text + at, bytes, count);
    d->size += count - size;
}

static void any_byte(struct draft *d)
{
    const char byte = (char) below(d, 256);
    const size_t at = below(d, d->size);

    replace(d, at, d->size > 0 && below(d, 2), &byte, 1);
}

static void one_bit(struct draft *d)
{
    if (d->size > 0)
        d->text[below(d, d->size)] ^= (char) (1 << below(d, 8));
}

static void cut_some(struct draft *d)
{
    const size_t at = below(d, d->size);

    replace(d, at, below(d, d->size - at < 9 ? d->size - at : 9), "", 0);
}

static void cut_the_end(struct draft *d)
{
    d->size = below(d, d->size);
}

/* Where the line at or after byte `at` begins. */
static size_t line_at(const struct draft *d, size_t at)
{
    while (at > 0 && d->text[at - 1] != '\n')
        at--;
    return at;
}

static size_t line_end(const struct draft *d, size_t at)
{
    while (at < d->size && d->text[at] != '\n')
        at++;
    return at + (at < d->size);
}

static void drop_a_line(struct draft *d)
{
    const size_t at = line_at(d, below(d, d->size));

    replace(d, at, line_end(d, at) - at, "", 0);
}

static void repeat_a_line(struct draft *d)
{
    char line[TEXT_SIZE];
    const size_t at = line_at(d, below(d, d->size));
    const size_t size = line_end(d, at) - at;

    memcpy(line, d->text + at, size);
    replace(d, line_at(d, below(d, d->size)), 0, line, size);
}

static const char *const token[] = {
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    ": ",
    "- ",
    "#",
    "&a ",
    "*a",
    "!!str ",
    "? ",
    "|\n",
    ">\n",
    "'",
    "\"",
    "\\",
    "---\n",
    "...\n",
    "%YAML 1.1\n",
    "\t",
    "\n",
    "\r",
    "\xef\xbb\xbf",
    "\xff",
    "\xc3",
    "\xe2\x80\xa8",
    "\x1b",
    "~",
    "<<",
    "nan",
    "inf",
    "-inf",
    "0",
    "-1",
    "1e-400",
    "1e400",
    "1e308",
    "0x10",
    "9,8",
    "99999999999999999999",
    "[]",
    "{}",
    "alpha",
    "alpha_deg",
    "tan_alpha",
    "law",
    "preset",
    "theta: psi",
    "ruina",
    "perrin",
    "kato_tullis",
    "friction: log",
    "units: si\n",
    "material: {R: inf}\n",
    "V_c: 1, ",
    "window: {v: [1, 2]}\n",
    "psi: [-7, 5]",
    "starts: [{v: 1, psi: -1}]",
    "basins: {cells: [4, 4]}\n",
    "products: [knees]\n",
    "xi: [0.5]",
    "until: {time: 1}",
    "sample: {log_time: 9}",
    "title: a\n",
    "output: {hdf5: }\n",
    "figure: x.pdf",
};

static void a_token(struct draft *d)
{
    const char *t = token[below(d, COUNT(token))];

    replace(d, below(d, d->size + 1), 0, t, strlen(t));
}

static bool is_of_word(char c)
{
    return isalnum((unsigned char) c) || strchr("_.-+", c);
}

/* A word or number becomes a token. */
static void a_word(struct draft *d)
{
    const char *t = token[below(d, COUNT(token))];
    size_t at = below(d, d->size), end;

    while (at < d->size && !(d->text[at] && is_of_word(d->text[at])))
        at++;
    for (end = at; end < d->size && d->text[end] && is_of_word(d->text[end]);)
        end++;
    replace(d, at, end - at, t, strlen(t));
}

static void (*const mutation[])(struct draft *) = {
    any_byte,      one_bit, cut_some, cut_the_end, drop_a_line,
    repeat_a_line, a_token, a_token,  a_word,      a_word,
};

static void mutate(struct draft *d)
{
    for (size_t n = 1 + below(d, 4); n > 0; n--)
        mutation[below(d, COUNT(mutation))](d);
}

/* ---- a file in memory ---------------------------------------------------- */

struct file {
    int fd;
    char path[40];
};

static struct file file_open(void)
{
    struct file f = { .fd = memfd_create("scene", 0) };

    assert_true(f.fd >= 0);
    snprintf(f.path, sizeof f.path, "/proc/self/fd/%d", f.fd);
    return f;
}

static void file_put(const struct file *f, const char *bytes, size_t size)
{
    assert_int_equal(ftruncate(f->fd, 0), 0);
    assert_int_equal(pwrite(f->fd, bytes, size, 0), (ssize_t) size);
}

/* ---- what must hold ------------------------------------------------------ */

/* "LINE:COL: " of a place that is in the text, or just behind it; or "LINE:
 * column COL of the formula: " */
static void is_a_place(const char *place, const struct draft *d)
{
    unsigned long line, column, lines = 2;
    int end = 0;

    for (size_t i = 0; i < d->size; i++)
        lines += d->text[i] == '\n' || d->text[i] == '\r' ||
                 (d->text[i] & 0x80) != 0; /* the line ends of Unicode */
    int read = sscanf(place, "%lu:%lu: %n", &line, &column, &end);
    if (read != 2)
        read = sscanf(place, "%lu: column %lu of the formula: %n", &line,
                      &column, &end);
    CHECK(read == 2 && end > 0 && place[end], "'%s'", place);
    CHECK(line >= 1 && line <= lines, "'%s' of %lu", place, lines);
    CHECK(column >= 1 && column <= d->size + 1, "'%s'", place);
}

static void is_blamed(const char *line, const struct file *f, const char *set,
                      const struct draft *d)
{
    char shown[600];
    const size_t size = strlen(f->path);

    text_show(line, shown, sizeof shown);
    assert_string_equal(line, shown);
    if (set && strncmp(line, "--set ", 6) == 0)
        return;
    CHECK(strncmp(line, f->path, size) == 0 && line[size] == ':', "'%s'", line);
    is_a_place(line + size + 1, d);
}

static void is_sound(const struct scene *s)
{
    assert_true(s->alpha >= 0.0 && s->alpha <= M_PI_2);
    assert_true(s->tan_alpha >= 0.0L && isfinite(s->tan_alpha));
    assert_true((s->alpha > 0.0) == (s->tan_alpha > 0.0L));
    assert_true(s->system ||
                (s->window.v[0] >= 1e-300 && s->window.v[1] <= 1e300));
    assert_true(s->window.v[0] < s->window.v[1]);
    assert_true(s->window.psi[0] < s->window.psi[1]);
    assert_true(s->material.a > 0.0 && s->material.b > 0.0);
    assert_true(s->material.R > 0.0 && s->material.c >= 0.0);
    assert_true(s->rtol >= 1e-14 && s->rtol <= 0.1);
    assert_true(s->products < 1u << PRODUCTS);
    assert_true(s->cells[0] >= 1 && s->cells[1] <= 32768);
    for (size_t i = 0; i < s->starts; i++)
        assert_true(
            (s->system ? isfinite(s->start[i].v) : s->start[i].v > 0.0) &&
            isfinite(s->start[i].psi));
}

/* Merged with its overrides it is the same scene. */
static void merges_into_itself(const struct scene *s, const struct file *f)
{
    char *merged = NULL;
    struct scene again;
    struct fault why;

    CHECK(scene_merge(s->text, s->overrides, &merged, &why) == STATUS_OK, "%s",
          why.text);
    file_put(f, merged, strlen(merged));
    CHECK(scene_read(&again, f->path, NULL, 0, &why) == STATUS_OK, "%s",
          why.text);
    CHECK(scene_same(s, &again), "%s", merged);
    scene_free(&again);
    free(merged);
}

/* Reads the draft; whether it is a scene. */
static bool read_draft(const struct draft *d, const struct file *f, char *set)
{
    struct scene s;
    struct fault why;

    file_put(f, d->text, d->size);
    memset(why.text, 'x', sizeof why.text);
    const enum status status = scene_read(&s, f->path, &set, set != NULL, &why);
    assert_true(status == STATUS_OK || status == STATUS_BAD_SCENE);
    if (status == STATUS_OK) {
        is_sound(&s);
        merges_into_itself(&s, f);
    } else {
        assert_non_null(memchr(why.text, '\0', sizeof why.text));
        is_blamed(why.text, f, set, d);
    }
    scene_free(&s);
    return status == STATUS_OK;
}

/* ---- many ---------------------------------------------------------------- */

/* One of the repository's scenes. */
static void start_from(struct draft *d, const char *path)
{
    char *text = file_read(path, &d->size);

    assert_true(d->size < TEXT_SIZE);
    memcpy(d->text, text, d->size);
    free(text);
}

static void mutated_scenes_are_read_or_refused_in_one_line(void **state)
{
    const struct file f = file_open();
    struct draft d = { .seed = check_seed() };
    size_t good = 0;
    char pattern[600];
    glob_t found;

    (void) state;
    snprintf(pattern, sizeof pattern, "%s/scenes/*.yaml",
             getenv("SOURCE_ROOT"));
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    for (int i = 0; i < ROUNDS; i++) {
        start_from(&d, found.gl_pathv[below(&d, found.gl_pathc)]);
        mutate(&d);
        good += read_draft(&d, &f, NULL);
    }
    /* Else the mutations are too wild, or too tame, to find much. */
    CHECK(good > ROUNDS / 20 && good < ROUNDS / 2, "%zu", good);
    globfree(&found);
    close(f.fd);
}

static const char base[] = "law: {preset: spinodal_gen}\n"
                           "slope: {alpha: 0.34}\n";

/* A draft of one line becomes an override; the scene itself is right. */
static void mutated_overrides_are_read_or_refused_in_one_line(void **state)
{
    static const char *const set[] = {
        "slope.alpha=0.3",       "law.preset=ruina",
        "window.v=[1e-3, 1e3]",  "trajectories.until.time=3",
        "material.R=inf",        "trajectories.starts=[{v: 1, psi: 2}]",
        "products=[knees]",      "slope={alpha_deg: 20}",
        "output.figure=out.svg", "title=Anything",
    };
    const struct file f = file_open();
    struct draft d = { .seed = check_seed() },
                 scene = { .size = sizeof base - 1 };
    size_t good = 0;

    (void) state;
    memcpy(scene.text, base, scene.size);
    for (int i = 0; i < ROUNDS / 4; i++) {
        const char *start = set[below(&d, COUNT(set))];
        d.size = strlen(start);
        memcpy(d.text, start, d.size);
        mutation[below(&d, COUNT(mutation))](&d);
        d.text[d.size] = '\0';
        good += read_draft(&scene, &f, d.text);
    }
    CHECK(good > ROUNDS / 80 && good < ROUNDS / 8, "%zu", good);
    close(f.fd);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mutated_scenes_are_read_or_refused_in_one_line),
        cmocka_unit_test(mutated_overrides_are_read_or_refused_in_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
