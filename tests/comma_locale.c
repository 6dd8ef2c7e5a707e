/* The linker's --wrap=strtod makes strtod mean __wrap_strtod, and
 * __real_strtod the true one. */
#include "comma_locale.h"

#include <locale.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static bool used;

struct lconv *__real_localeconv(void);
double __real_strtod(const char *text, char **end);
struct lconv *__wrap_localeconv(void);
double __wrap_strtod(const char *text, char **end);

void comma_locale_use(bool comma)
{
    used = comma;
}

struct lconv *__wrap_localeconv(void)
{
    static char comma[] = ",";
    static struct lconv changed;

    changed = *__real_localeconv();
    changed.decimal_point = comma;
    return used ? &changed : __real_localeconv();
}

/* A point ends the number, and a comma stands for it. */
double __wrap_strtod(const char *text, char **end)
{
    char copy[1024];

    if (!used)
        return __real_strtod(text, end);
    const size_t size = strcspn(text, ".");
    if (size >= sizeof copy)
        abort();
    memcpy(copy, text, size);
    copy[size] = '\0';
    char *comma = strchr(copy, ',');
    if (comma)
        *comma = '.';
    const double x = __real_strtod(copy, end);
    *end = (char *) (uintptr_t) (text + (*end - copy));
    return x;
}
