#include "text.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "utf8.h"

char *text_copy(const char *bytes, size_t size)
{
    char *copy = malloc(size + 1);

    if (copy == NULL)
        return NULL;
    memcpy(copy, bytes, size);
    copy[size] = '\0';
    return copy;
}

/* Neither controls a terminal, nor ends a line, nor turns it around. */
static bool is_printable(uint32_t code)
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
    const char *byte = *text;
    uint32_t code;

    const size_t valid = utf8_read(byte, &code), size = valid ? valid : 1;
    *text += size;
    if (valid && is_printable(code)) {
        memcpy(out, byte, size);
        return size;
    }
    for (size_t i = 0; i < size; i++)
        sprintf(out + 4 * i, "\\x%02x", (unsigned char) byte[i]);
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

int text_index(const char *text, const char *const *words)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(text, words[i]) == 0)
            return i;
    return -1;
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
