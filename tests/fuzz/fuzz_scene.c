/* Scenes: any text is read, or refused in one line; what is read is the same
 * after it was merged with its overrides.  A line "#set KEY=VALUE" of the text
 * is an override, too. */
#include <string.h>

#include "fuzz.h"
#include "merge.h"
#include "scene_sweep.h"
#include "scenes.h"

enum { SETS = 8 };

/* What scene_read opens, whatever its name; the linker sends
 * fopen here, which is fopen64 where files may be large. */
static const char *text;
static size_t length;

FILE *__real_fopen64(const char *path, const char *mode);
FILE *__wrap_fopen64(const char *path, const char *mode);

FILE *__wrap_fopen64(const char *path, const char *mode)
{
    if (text == NULL) /* replay.c opens its files */
        return __real_fopen64(path, mode);
    return length > 0 ? fmemopen((void *) (uintptr_t) text, length, mode)
                      : __real_fopen64("/dev/null", mode);
}

/* Those of the text, cut out of a copy. */
static size_t find_sets(char *copy, char *set[SETS])
{
    size_t count = 0;

    for (char *line; (line = strsep(&copy, "\n")) != NULL && count < SETS;)
        if (strncmp(line, "#set ", 5) == 0)
            set[count++] = line + 5;
    return count;
}

static void merges_into_itself(const struct scene *s)
{
    struct scene again;
    struct fault why;
    char *merged = NULL;

    MUST(scene_merge(s->text, s->overrides, &merged, &why) == STATUS_OK);
    text = merged;
    length = strlen(merged);
    MUST(scene_read(&again, "merged", NULL, 0, &why) == STATUS_OK);
    MUST(scene_same(s, &again));
    scene_free(&again);
    free(merged);
}

/* Points of a sweep can be set. */
static void visits_its_corners(const struct scene *s)
{
    const struct scene_axis *a = s->sweep.axis;
    struct scene point;
    double x[SCENE_AXES] = { 0.0 };

    for (size_t i = 0; i < s->sweep.axes; i++)
        x[i] = a[i].value[a[i].count - 1];
    scene_at(s, x, &point);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *copy = text_copy((const char *) data, size), *set[SETS];
    const size_t sets = find_sets(copy, set);
    struct scene s;
    struct fault why;

    text = (const char *) data;
    length = size;
    const enum status status = scene_read(&s, "s.yaml", set, sets, &why);
    MUST(status == STATUS_OK || status == STATUS_BAD_SCENE);
    if (status == STATUS_BAD_SCENE)
        must_be_a_line(&why);
    if (status == STATUS_OK)
        visits_its_corners(&s);
    /* a text ends in its first zero */
    if (status == STATUS_OK && strlen(s.text) == size)
        merges_into_itself(&s);
    scene_free(&s);
    free(copy);
    text = NULL;
    return 0;
}
