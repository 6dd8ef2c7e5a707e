/* Comments must stay comments whatever a scene's title says: XPPAUT reads on
 * after a backslash, for C an asterisk and a slash begin or end one. */
#include "interchange.h"

#include <string.h>

static void put_letter(FILE *out, char letter, char last)
{
    const bool plain = letter >= ' ' && letter <= '~' && letter != '\\';

    if ((letter == '/' && last == '*') || (letter == '*' && last == '/'))
        fputc(' ', out);
    fputc(plain ? letter : ' ', out);
}

/* How much of a line goes into one: up to 118 letters, at a blank. */
static size_t part(const char *line, size_t size)
{
    size_t n = 118;

    if (size <= n)
        return size;
    while (n > 40 && line[n] != ' ')
        n--;
    return n;
}

static void put_line(FILE *out, const char *before, const char *line,
                     size_t size)
{
    fputs(before, out);
    for (size_t i = 0; i < size; i++)
        put_letter(out, line[i], i > 0 ? line[i - 1] : ' ');
    fputc('\n', out);
}

void interchange_remark(FILE *out, const char *before, const char *text)
{
    while (*text) {
        const size_t size = strcspn(text, "\n"), n = part(text, size);
        put_line(out, before, text, n);
        text += n;
        if (*text == '\n')
            text++;
    }
}

void interchange_meaning(FILE *out, enum text_parameter p)
{
    const struct text_symbol *s = &text_parameters[p];

    fprintf(out, "%s (%s)", s->meaning,
            strcmp(s->unit, "1") == 0 ? "dimensionless" : s->unit);
}
