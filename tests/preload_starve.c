/* For LD_PRELOAD: allocation number STARVE_AT (from 0) of the whole program,
 * its libraries included, fails; at the end how many there were goes into the
 * file STARVE_COUNT. */
#include <errno.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *p, size_t size);

static atomic_long count;

static bool granted(void)
{
    static long fail_at = -2; /* not asked yet */

    if (fail_at == -2) {
        const char *text = getenv("STARVE_AT");
        fail_at = text != NULL ? strtol(text, NULL, 10) : -1;
    }
    if (atomic_fetch_add(&count, 1) != fail_at)
        return true;
    errno = ENOMEM;
    return false;
}

void *malloc(size_t size)
{
    return granted() ? __libc_malloc(size) : NULL;
}

void *calloc(size_t n, size_t size)
{
    return granted() ? __libc_calloc(n, size) : NULL;
}

void *realloc(void *p, size_t size)
{
    return granted() ? __libc_realloc(p, size) : NULL;
}

__attribute__((destructor)) static void tell_count(void)
{
    const char *path = getenv("STARVE_COUNT");
    const long all = atomic_load(&count);
    FILE *file = path != NULL ? fopen(path, "w") : NULL;

    if (file != NULL) {
        fprintf(file, "%ld\n", all);
        fclose(file);
    }
}
