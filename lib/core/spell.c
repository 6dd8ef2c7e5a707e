#include "spell.h"

#include <ctype.h>
#include <string.h>

enum { LETTERS = 40 };

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

static int same(char a, char b)
{
    return tolower((unsigned char) a) == tolower((unsigned char) b);
}

size_t spell_distance(const char *a, const char *b)
{
    size_t d[LETTERS + 1][LETTERS + 1];
    const size_t n = strnlen(a, LETTERS), m = strnlen(b, LETTERS);

    for (size_t i = 0; i <= n; i++)
        for (size_t j = 0; j <= m; j++) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            const size_t change = d[i - 1][j - 1] + !same(a[i - 1], b[j - 1]);
            d[i][j] = least(least(d[i - 1][j], d[i][j - 1]) + 1, change);
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) &&
                same(a[i - 2], b[j - 1]))
                d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[n][m];
}

const char *spell_nearest(const char *word, const char *const *known)
{
    const char *nearest = NULL;
    size_t best = LETTERS;

    for (; *known; known++) {
        const size_t n = strnlen(word, LETTERS), m = strnlen(*known, LETTERS);
        const size_t distance = spell_distance(word, *known);
        if (distance <= (n > m ? n : m) / 3 && distance < best) {
            best = distance;
            nearest = *known;
        }
    }
    return nearest;
}
