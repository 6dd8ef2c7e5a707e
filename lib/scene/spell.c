#include "spell.h"

#include <string.h>

enum { LETTERS = 40 };

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

size_t spell_distance(const char *a, const char *b)
{
    size_t d[LETTERS + 1][LETTERS + 1];
    const size_t n = least(strlen(a), LETTERS), m = least(strlen(b), LETTERS);

    for (size_t i = 0; i <= n; i++)
        for (size_t j = 0; j <= m; j++) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            const size_t change = d[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
            d[i][j] = least(least(d[i - 1][j], d[i][j - 1]) + 1, change);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[n][m];
}

int spell_is_near(const char *a, const char *b)
{
    const size_t n = strlen(b);
    return spell_distance(a, b) <= (n < 4 ? 1 : n < 8 ? 2 : 3);
}
