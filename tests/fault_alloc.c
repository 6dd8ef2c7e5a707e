/* The linker's --wrap=malloc makes malloc mean __wrap_malloc, and
 * __real_malloc the true one. */
#include "fault_alloc.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

static atomic_long fail_at = FAULT_ALLOC_NEVER, count;

void *__real_malloc(size_t size);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *p, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *p, size_t size);

void fault_alloc_at(long k)
{
    atomic_store(&fail_at, k);
    atomic_store(&count, 0);
}

long fault_alloc_count(void)
{
    return atomic_load(&count);
}

static bool granted(void)
{
    return atomic_fetch_add(&count, 1) != atomic_load(&fail_at);
}

void *__wrap_malloc(size_t size)
{
    return granted() ? __real_malloc(size) : NULL;
}

void *__wrap_calloc(size_t n, size_t size)
{
    return granted() ? __real_calloc(n, size) : NULL;
}

void *__wrap_realloc(void *p, size_t size)
{
    return granted() ? __real_realloc(p, size) : NULL;
}
