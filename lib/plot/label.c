#include "label.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "utf8.h"

struct glyph {
    uint32_t code;
    size_t bytes; /* of the text */
};

/* The first character of a text that is not empty; '?' for a byte that is not
 * UTF-8 or of a code that is no character, a blank for a control character. */
static struct glyph glyph_read(const char *text)
{
    uint32_t code;
    const size_t bytes = utf8_read(text, &code);
    const bool control = code < ' ' || (code >= 0x7f && code < 0xa0);

    if (bytes == 0 || (code & 0xfffe) == 0xfffe)
        return (struct glyph){ '?', 1 };
    return (struct glyph){ control ? ' ' : code, bytes };
}

static double glyph_width(uint32_t code)
{
    if (code >= 0x1100)
        return code >= 0x2000 && code < 0x2e80 ? 1.0 : 1.1;
    if (code >= 0x80)
        return 0.85;
    const char c = (char) code;
    if (strchr(" !'(),-./:;I[\\]`fijlrt|", c))
        return 0.42;
    if (strchr("%@MWmw", c))
        return 1.0;
    if ((c >= 'A' && c <= 'Z') || strchr("#&+<=>^~", c))
        return 0.84;
    return 0.64;
}

double label_width(const char *text)
{
    double width = 0;
    while (*text) {
        const struct glyph g = glyph_read(text);
        width += glyph_width(g.code);
        text += g.bytes;
    }
    return width;
}

void label_write(FILE *out, const char *text, double room)
{
    const double ellipsis = 1;
    double left = label_width(text) <= room ? room + ellipsis : room;
    /* gnuplot takes a doubled quote that comes first for an empty string */
    for (; *text == '\''; text++, left -= glyph_width('\''))
        fputs("\"'\".", out);
    const char *start = text;
    fputc('\'', out);
    while (*text) {
        const struct glyph g = glyph_read(text);
        left -= glyph_width(g.code);
        if (left < ellipsis - 1e-9) {
            fputs("\xe2\x80\xa6", out);
            break;
        }
        if (g.code == '>' && text - start > 1 && text[-1] == ']' &&
            text[-2] == ']')
            fputc(' ', out); /* XML forbids what gnuplot would leave there */
        if (g.code == '\'')
            fputs("''", out);
        else if (g.code < 0x80)
            fputc((int) g.code, out);
        else
            fwrite(text, 1, g.bytes, out);
        text += g.bytes;
    }
    fputc('\'', out);
}

void label_write_path(FILE *out, const char *name)
{
    fputs("'./", out);
    for (; *name; name++)
        fputs(*name == '\'' ? "''" : (char[]){ *name, 0 }, out);
    fputc('\'', out);
}
