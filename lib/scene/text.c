#include "text.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *text_copy(const char *bytes, size_t size)
{
    char *copy = malloc(size + 1);

    if (copy == NULL)
        return NULL;
    memcpy(copy, bytes, size);
    copy[size] = '\0';
    return copy;
}

/* Bytes of the character at s, and its code; 0 where it is not UTF-8. */
static size_t decode(const unsigned char *s, unsigned *code)
{
    static const unsigned bits[] = { 0, 0x7f, 0x1f, 0x0f, 0x07 };
    static const unsigned least[] = { 0, 0, 0x80, 0x800, 0x10000 };
    const size_t size = s[0] < 0x80         ? 1
                        : s[0] >> 5 == 0x06 ? 2
                        : s[0] >> 4 == 0x0e ? 3
                        : s[0] >> 3 == 0x1e ? 4
                                            : 0;

    *code = s[0] & bits[size];
    for (size_t i = 1; i < size; i++) {
        if (s[i] >> 6 != 0x02)
            return 0;
        *code = *code << 6 | (s[i] & 0x3fu);
    }
    const bool surrogate = *code >= 0xd800 && *code <= 0xdfff;
    return *code < least[size] || *code > 0x10ffff || surrogate ? 0 : size;
}

/* Neither controls a terminal, nor ends a line, nor turns it around. */
static bool is_printable(unsigned code)
{
    const bool control = code < 0x20 || (code >= 0x7f && code <= 0x9f);
    const bool turns = code == 0x61c || code == 0x200e || code == 0x200f ||
                       (code >= 0x2028 && code <= 0x202e) ||
                       (code >= 0x2066 && code <= 0x2069) || code == 0xfeff;

    return !control && !turns;
}

enum { SHOWN_MAX = 4 * 4 };

/* Shows the character at *text, moves past it, returns the bytes written. */
static size_t show_character(const char **text, char out[SHOWN_MAX + 1])
{
    unsigned char byte[5] = { 0 };
    unsigned code;

    memcpy(byte, *text, strnlen(*text, 4));
    const size_t valid = decode(byte, &code);
    const size_t size = valid ? valid : 1;
    *text += size;
    if (valid && is_printable(code)) {
        memcpy(out, byte, size);
        return size;
    }
    for (size_t i = 0; i < size; i++)
        sprintf(out + 4 * i, "\\x%02x", byte[i]);
    return 4 * size;
}

void text_show(const char *text, char *out, size_t size)
{
    size_t used = 0, cut = 0; /* "..." and a zero fit behind cut */

    while (*text) {
        char one[SHOWN_MAX + 1];
        const size_t n = show_character(&text, one);
        if (used + n >= size) {
            memcpy(out + cut, "...", 4);
            return;
        }
        memcpy(out + used, one, n);
        used += n;
        if (used + 4 <= size)
            cut = used;
    }
    out[used] = '\0';
}

void text_show_end(const char *text, char *out, size_t size)
{
    char one[SHOWN_MAX + 1];
    size_t whole = 0;

    for (const char *p = text; *p;)
        whole += show_character(&p, one);
    if (whole < size) {
        text_show(text, out, size);
        return;
    }
    while (whole + 3 >= size)
        whole -= show_character(&text, one);
    strcpy(out, "...");
    text_show(text, out + 3, size - 3);
}

struct text_shown text_shown(const char *text)
{
    struct text_shown shown;

    text_show(text, shown.text, sizeof shown.text);
    return shown;
}

void text_list(const char *const *words, char *out, size_t size)
{
    size_t used = 0;

    out[0] = '\0';
    for (size_t i = 0; words[i] && used < size; i++) {
        const char *comma = i == 0 ? "" : words[i + 1] ? ", " : " or ";
        used +=
            (size_t) snprintf(out + used, size - used, "%s%s", comma, words[i]);
    }
}
