/* Result files, as `info` and `info --rerun` read them: listed, asked for their
 * scene, and compared with one that is whole; in a child, as there, which may
 * die of libhdf5.  Each is read as it is, and with its checksums put right:
 * whoever wants to do harm can do that, too.
 *
 * A child reads what waits, one after the other, and tells in shared memory how
 * far it came: where it dies over one, the next child goes on behind that.
 * FUZZ_GROUP may wait (2, which is one input; at most GROUP). */
#include <stdbool.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

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
static enum status read_one(const char *path, FILE *out, struct fault *why)
{
    struct fault of[3] = { { "" } };
    struct store *file = NULL;

    enum status s = store_open(path, &file, why);
    if (s != STATUS_OK)
        return s;
    enum status got[3] = { store_visit(file, write_item, out, &of[0]) };
    store_free(&file);
    for (int i = 1; i < 3; i++) {
        if (store_open(path, &file, &of[i]) != STATUS_OK)
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

enum { GROUP = 64, SECONDS = 10 };

static struct input {
    const char *path; /* or NULL: bytes */
    uint8_t *bytes;   /* owned */
    size_t size;
} input[GROUP];
static size_t waiting, most;

static struct progress {
    size_t done;
    enum status status[GROUP];
    bool told[GROUP];
} * seen; /* shared with children */

static void tell(enum status s, const struct fault *why)
{
    seen->status[seen->done] = s;
    seen->told[seen->done] = why->text[0] != '\0';
    seen->done++;
}

/* All that wait; its answer is that of the last. */
static enum status work(void *ctx, FILE *out, struct fault *why)
{
    enum status s = STATUS_OK;

    (void) ctx;
    while (seen->done < waiting) {
        const struct input *of = &input[seen->done];
        alarm(SECONDS);
        *why = (struct fault){ "" };
        s = read_one(of->path ? of->path : memory_file(of->bytes, of->size),
                     out, why);
        tell(s, why);
    }
    return s;
}

static void read_in_a_child(void)
{
    struct fault why = { "" };
    char *bytes;
    size_t length;
    const enum status s =
        child_read(work, NULL, "a.h5", SECONDS, &bytes, &length, &why);

    MUST((s == STATUS_OK) == (bytes != NULL));
    MUST(s == STATUS_OK || why.text[0] != '\0');
    MUST(s != STATUS_OK || seen->done == waiting);
    if (seen->done < waiting)
        tell(s, &why); /* over this one it died */
    free(bytes);
}

static void read_waiting(void)
{
    seen->done = 0;
    while (seen->done < waiting)
        read_in_a_child();
    for (size_t i = 0; i < waiting; i++) {
        const enum status s = seen->status[i];
        const bool known = s == STATUS_OK || s == STATUS_IO ||
                           s == STATUS_BAD_SCENE || s == STATUS_NO_MEMORY;
        if (!known || (s != STATUS_OK && !seen->told[i]))
            fprintf(stderr, "reading %zu of the last %zu\n", i + 1, waiting);
        MUST(known);
        MUST(s == STATUS_OK || seen->told[i]);
        free(input[i].bytes);
    }
    waiting = 0;
}

static void add(const uint8_t *data, size_t size, bool mended)
{
    uint8_t *copy = malloc(size + 1);

    MUST(copy != NULL);
    for (size_t i = 0; i < size; i++)
        copy[i] = data[i];
    if (mended)
        hdf5_sums_mend(copy, size);
    input[waiting++] = (struct input){ .bytes = copy, .size = size };
}

/* One that is whole is read: else nothing is tried here at all. */
static void begin(void)
{
    const char *path = getenv("FUZZ_WHOLE"), *group = getenv("FUZZ_GROUP");
    struct fault why;

    seen = mmap(NULL, sizeof *seen, PROT_READ | PROT_WRITE,
                MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    MUST(seen != MAP_FAILED);
    most = group ? strtoul(group, NULL, 10) : 2;
    MUST(most >= 2 && most <= GROUP && most % 2 == 0);
    (void) memory_file((const uint8_t *) "", 0); /* this process removes it */
    store_silence();
    MUST(path != NULL && store_open(path, &whole, &why) == STATUS_OK);
    MUST(most == 2 || atexit(read_waiting) == 0); /* before HDF5's own end */
    input[waiting++] = (struct input){ .path = path };
    read_waiting();
    MUST(seen->status[0] == STATUS_OK);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (whole == NULL)
        begin();
    add(data, size, false);
    add(data, size, true);
    if (waiting >= most)
        read_waiting();
    return 0;
}
