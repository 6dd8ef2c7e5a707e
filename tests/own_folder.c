#include "own_folder.h"

#include <ftw.h>
#include <string.h>
#include <sys/stat.h>

#include "check.h"

static char folder[64];

int own_folder_make(void **state)
{
    (void) state;
    strcpy(folder, "/tmp/slipway-test-XXXXXX");
    return mkdtemp(folder) != NULL ? 0 : -1;
}

static int drop(const char *name, const struct stat *s, int kind,
                struct FTW *where)
{
    (void) s, (void) kind, (void) where;
    return remove(name);
}

int own_folder_remove(void **state)
{
    (void) state;
    return nftw(folder, drop, 8, FTW_DEPTH | FTW_PHYS);
}

const char *own_path(const char *name)
{
    static char path[8][256];
    static unsigned turn;
    char *p = path[turn++ % 8];

    snprintf(p, sizeof path[0], name[0] ? "%s/%s" : "%s%s", folder, name);
    return p;
}

static int entries;

static int count(const char *name, const struct stat *s, int kind,
                 struct FTW *where)
{
    (void) name, (void) s, (void) kind, (void) where;
    entries++;
    return 0;
}

int own_folder_entries(void)
{
    entries = -1; /* not the folder itself */
    assert_int_equal(nftw(folder, count, 8, FTW_PHYS), 0);
    return entries;
}

void file_write(const char *path, const void *bytes, size_t size)
{
    FILE *f = fopen(path, "wb");

    assert_non_null(f);
    assert_int_equal(fwrite(bytes, 1, size, f), size);
    assert_int_equal(fclose(f), 0);
}

char *file_read(const char *path, size_t *size)
{
    FILE *f = fopen(path, "rb");
    char *bytes;

    assert_non_null(f);
    assert_int_equal(fseek(f, 0, SEEK_END), 0);
    *size = (size_t) ftell(f);
    rewind(f);
    bytes = malloc(*size + 1);
    assert_non_null(bytes);
    assert_int_equal(fread(bytes, 1, *size, f), *size);
    fclose(f);
    return bytes;
}

void file_holds(const char *path, const char *text)
{
    size_t size;
    char *bytes = file_read(path, &size);

    assert_int_equal(size, strlen(text));
    assert_memory_equal(bytes, text, size);
    free(bytes);
}
