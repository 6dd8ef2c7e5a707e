#include "label.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "mark.h"
#include "utf8.h"

enum { MARKS_DEEP = 4 };

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

static bool is_mark(char c)
{
    return c >= MARK_ITALIC && c <= MARK_END;
}

/* Goes through a text: what stands there, and how large. */
struct reader {
    double size;             /* of letters here */
    bool raised[MARKS_DEEP]; /* the open marks: above or below the line */
    size_t open;
};

/* One glyph, or a mark, which has no width. */
static double reader_step(struct reader *r, const char *text, size_t *bytes)
{
    *bytes = 1;
    if (*text == MARK_END) {
        if (r->open > 0)
            r->open--;
    } else if (is_mark(*text)) {
        if (r->open < MARKS_DEEP)
            r->raised[r->open++] = *text != MARK_ITALIC;
    } else {
        const struct glyph g = glyph_read(text);
        *bytes = g.bytes;
        return glyph_width(g.code) * r->size;
    }
    r->size = 1;
    for (size_t k = 0; k < r->open; k++)
        r->size *= r->raised[k] ? LABEL_SCRIPT : 1;
    return 0;
}

double label_part_width(struct label_part line)
{
    struct reader r = { .size = 1 };
    double width = 0;
    size_t bytes;

    for (size_t at = 0; at < line.size; at += bytes)
        width += reader_step(&r, line.text + at, &bytes);
    return width;
}

static struct label_part label_whole(const char *text)
{
    return (struct label_part){ text, strlen(text) };
}

double label_width(const char *text)
{
    return label_part_width(label_whole(text));
}

/* Whether a line may end at this blank: what belongs to an "=", a number or a
 * dash does not stand alone, nor a unit, of three letters at most. */
static bool breaks_well(const char *text, size_t at)
{
    const char next = text[at + 1];
    const char last = at > 0 ? text[at - 1] : ' ';
    const bool after = last == '=' || (last >= '0' && last <= '9' &&
                                       strcspn(text + at + 1, " ") <= 3);

    return !after && next != '=' && !(next >= '0' && next <= '9') &&
           strncmp(text + at + 1, "\xe2\x80\x94", 3) != 0;
}

/* Bytes up to the last blank before which all fits; 0: all of it, or no blank
 * will do. */
static size_t break_at(const char *text, double room)
{
    struct reader r = { .size = 1 };
    double width = 0;
    size_t at = 0, blank = 0, bytes;

    for (; text[at]; at += bytes) {
        if (text[at] == ' ' && r.open == 0 && breaks_well(text, at))
            blank = at;
        width += reader_step(&r, text + at, &bytes);
        if (width > room && blank > 0)
            return blank;
    }
    return 0;
}

size_t label_break(const char *text, double room, struct label_part line[],
                   size_t most)
{
    size_t n = 0;

    for (;;) {
        const size_t size = n + 1 < most ? break_at(text, room) : 0;
        line[n++] =
            size ? (struct label_part){ text, size } : label_whole(text);
        if (size == 0)
            return n;
        text += size + strspn(text + size, " ");
    }
}

/* A mark as gnuplot has it; true: it opens. */
static bool put_mark(FILE *out, char mark, double script)
{
    switch (mark) {
        case MARK_ITALIC:
            fputs("{/:Italic ", out);
            return true;
        case MARK_SUB:
        case MARK_SUPER:
            fprintf(out, "%c{", mark == MARK_SUB ? '_' : '^');
            if (script > 1)
                fprintf(out, "/*%.3g ", script);
            return true;
        default:
            return false;
    }
}

static void put_glyph(FILE *out, const char *text, struct glyph g, bool marked)
{
    if (g.code == '\'')
        fputs("''", out);
    else if (g.code >= 0x80)
        fwrite(text, 1, g.bytes, out);
    else if (marked && strchr("{}^_@&~\\", (int) g.code))
        fprintf(out, "\\%c", (int) g.code);
    else
        fputc((int) g.code, out);
}

/* What stands between the quotes. */
static void put_text(FILE *out, struct label_part line, double left,
                     double script, bool marked)
{
    const double ellipsis = 1;
    struct reader r = { .size = 1 };
    size_t bytes, open = 0;

    for (size_t at = 0; at < line.size; at += bytes) {
        const char *text = line.text + at;
        left -= reader_step(&r, text, &bytes);
        if (left < ellipsis - 1e-9) {
            fputs("\xe2\x80\xa6", out);
            break;
        }
        if (*text == MARK_END && open > 0) {
            fputc('}', out);
            open--;
        } else if (is_mark(*text)) {
            open += put_mark(out, *text, script);
        } else {
            if (*text == '>' && at > 1 && text[-1] == ']' && text[-2] == ']')
                fputc(' ', out); /* XML forbids what would stand there */
            put_glyph(out, text, glyph_read(text), marked);
        }
    }
    for (; open > 0; open--)
        fputc('}', out);
}

static bool has_marks(struct label_part line)
{
    for (size_t at = 0; at < line.size; at++)
        if (is_mark(line.text[at]))
            return true;
    return false;
}

void label_write(FILE *out, struct label_part line, double room, double script)
{
    const double ellipsis = 1;
    const bool marked = has_marks(line);
    double left = label_part_width(line) <= room ? room + ellipsis : room;

    /* gnuplot takes a doubled quote that comes first for an empty string */
    for (; line.size && *line.text == '\''; line.text++, line.size--) {
        left -= glyph_width('\'');
        fputs("\"'\".", out);
    }
    fputc('\'', out);
    put_text(out, line, left, script, marked);
    fputs(marked ? "' enhanced" : "' noenhanced", out);
}

void label_comment(FILE *out, const char *text)
{
    char plain[256];

    mark_plain(text, plain, sizeof plain);
    put_text(out, label_whole(plain), (double) INFINITY, 1, false);
}

void label_write_path(FILE *out, const char *name)
{
    fputs("'./", out);
    for (; *name; name++)
        fputs(*name == '\'' ? "''" : (char[]){ *name, 0 }, out);
    fputc('\'', out);
}
