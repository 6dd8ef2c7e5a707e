/* libyaml's own allocations, made here instead: what a program defines comes
 * before what a shared library does.  With fault_alloc they fail in turn. */
#include <stdlib.h>
#include <string.h>

void *yaml_malloc(size_t size);
void *yaml_realloc(void *p, size_t size);
void yaml_free(void *p);
unsigned char *yaml_strdup(const unsigned char *text);

void *yaml_malloc(size_t size)
{
    return malloc(size ? size : 1);
}

void *yaml_realloc(void *p, size_t size)
{
    return realloc(p, size ? size : 1);
}

void yaml_free(void *p)
{
    free(p);
}

unsigned char *yaml_strdup(const unsigned char *text)
{
    const size_t size = text ? strlen((const char *) text) + 1 : 0;
    unsigned char *copy = text ? malloc(size) : NULL;

    return copy ? memcpy(copy, text, size) : NULL;
}
