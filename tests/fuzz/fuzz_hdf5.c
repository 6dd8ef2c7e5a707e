/* Result files, as `info` and `info --rerun` read them: listed, asked for their
 * scene, and compared with one that is whole; in a child, as there, which may
 * die of libhdf5.  Each is read as it is, and with its checksums put right:
 * whoever wants to do harm can do that, too. */
#include <stdbool.h>
#include <string.h>

#include "child.h"
#include "fuzz.h"
#include "hdf5_sums.h"
#include "memory_file.h"
#include "merge.h"
#include "store_compare.h"
#include "store_read.h"
#include "tolerance.h"

/* The file to compare with, opened once: children inherit it. */
static struct store *whole; /* owned */

static int write_item(void *ctx, const struct store_item *item)
{
    FILE *out = ctx;

    fprintf(out, "%s %s %s %s %s", item->path, item->units, item->long_name,
            item->key, item->text);
    for (int i = 0; i < item->rank; i++)
        fprintf(out, " %llu", (unsigned long long) item->extent[i]);
    fputc('\n', out);
    return 0;
}

static enum status read_scene(struct store *file, FILE *out, struct fault *why)
{
    char *text = NULL, *overrides = NULL, *scene = NULL;

    enum status s = store_read_text(file, "/provenance", "scene", &text, why);
    if (s == STATUS_OK)
        s = store_read_text(file, "/provenance", "overrides", &overrides, why);
    if (s == STATUS_OK)
        s = scene_merge(text, overrides, &scene, why);
    if (s == STATUS_OK)
        fputs(scene, out);
    free(text);
    free(overrides);
    free(scene);
    return s;
}

static void write_difference(void *ctx, const struct store_difference *d)
{
    fprintf(ctx, "%s %s %s\n", d->path, d->key, d->what);
}

/* All three, whatever became of the one before. */
static enum status work(void *ctx, FILE *out, struct fault *why)
{
    struct fault of[3] = { { "" } };
    struct store *file = NULL;

    enum status s = store_open(ctx, &file, why);
    if (s != STATUS_OK)
        return s;
    enum status got[3] = { store_visit(file, write_item, out, &of[0]) };
    store_free(&file);
    for (int i = 1; i < 3; i++) {
        if (store_open(ctx, &file, &of[i]) != STATUS_OK)
            return STATUS_IO;
        got[i] =
            i == 1 ? read_scene(file, out, &of[i])
                   : store_compare(file, whole, write_difference, out, &of[i]);
        store_free(&file);
    }
    for (int i = 0; i < 3 && s == STATUS_OK; i++)
        if (got[i] != STATUS_OK) {
            s = got[i];
            *why = of[i];
        }
    return s;
}

static enum status read_apart(const char *path)
{
    struct fault why = { "" };
    char *bytes;
    size_t length;
    const enum status s = child_read(work, (void *) (uintptr_t) path, path, 10,
                                     &bytes, &length, &why);

    MUST(s == STATUS_OK || s == STATUS_IO || s == STATUS_BAD_SCENE ||
         s == STATUS_NO_MEMORY);
    MUST((s == STATUS_OK) == (bytes != NULL));
    MUST(s == STATUS_OK || why.text[0] != '\0');
    free(bytes);
    return s;
}

/* One that is whole is read: else nothing is tried here at all. */
static void begin(void)
{
    const char *path = getenv("FUZZ_WHOLE");
    struct fault why;

    store_silence();
    MUST(path != NULL && store_open(path, &whole, &why) == STATUS_OK);
    MUST(read_apart(path) == STATUS_OK);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint8_t *copy = malloc(size + 1);

    MUST(copy != NULL);
    if (whole == NULL)
        begin();
    (void) read_apart(memory_file(data, size));
    for (size_t i = 0; i < size; i++)
        copy[i] = data[i];
    hdf5_sums_mend(copy, size);
    (void) read_apart(memory_file(copy, size));
    free(copy);
    return 0;
}
