#include "page.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* As text, also inside quotes. */
static void put_text(FILE *out, const char *text)
{
    for (; *text; text++)
        switch (*text) {
            case '&':
                fputs("&amp;", out);
                break;
            case '<':
                fputs("&lt;", out);
                break;
            case '>':
                fputs("&gt;", out);
                break;
            case '"':
                fputs("&quot;", out);
                break;
            default:
                fputc(*text, out);
        }
}

static void put_address(FILE *out, const char *name)
{
    for (; *name; name++)
        if (isalnum((unsigned char) *name) || strchr("._-", *name))
            fputc(*name, out);
        else
            fprintf(out, "%%%02X", (unsigned) (unsigned char) *name);
}

/* %t: a text; %a: a part of a file's address; %i: a size_t. */
static void put(FILE *out, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    for (; *format; format++)
        if (*format != '%')
            fputc(*format, out);
        else if (*++format == 't')
            put_text(out, va_arg(args, const char *));
        else if (*format == 'a')
            put_address(out, va_arg(args, const char *));
        else
            fprintf(out, "%zu", va_arg(args, size_t));
    va_end(args);
}

static void put_links(FILE *out, const struct gallery_entry *e, bool scripts)
{
    put(out,
        "<p><a href=\"./%a.yaml\">scene</a> · <a href=\"./%a.h5\">HDF5</a>",
        e->name, e->name);
    for (size_t i = 0; i < e->panel.count; i++) {
        const char *panel = e->panel.name[i];
        put(out,
            " · <a href=\"./%a%a.png\">PNG</a>, <a href=\"./%a%a.pdf\">PDF</a>",
            e->name, panel, e->name, panel);
        if (scripts)
            put(out,
                ", <a href=\"./%a%a.gp\">script</a>, "
                "<a href=\"./%a%a.dat\">data</a>",
                e->name, panel, e->name, panel);
    }
    put(out, "</p>\n");
}

static void put_figure(FILE *out, const struct gallery_entry *e, size_t number,
                       bool scripts)
{
    const char *title = e->scene.title ? e->scene.title : "";

    put(out, "<figure id=\"figure-%i\"", number);
    put(out, e->panel.count > 1 ? " class=\"many\">\n" : ">\n");
    put(out, "<h2>%t%t%t</h2>\n", e->name, title[0] ? ": " : "", title);
    for (size_t i = 0; i < e->panel.count; i++)
        put(out, "<img src=\"./%a%a.svg\" alt=\"%t%t\">\n", e->name,
            e->panel.name[i], title[0] ? title : e->name, e->panel.name[i]);
    put(out, "<figcaption>\n<p>%t</p>\n<p><code>%t</code></p>\n",
        e->comment ? e->comment : "", e->command ? e->command : "");
    if (e->code == EXIT_DONE)
        put_links(out, e, scripts);
    else
        put(out, "<p class=\"failed\">This scene failed; nothing was "
                 "drawn.</p>\n");
    put(out, "</figcaption>\n</figure>\n");
}

char *page_text(const struct gallery_entry entry[], size_t count, bool scripts)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);

    if (out == NULL)
        return NULL;
    fputs(text_gallery, out);
    put(out, "<nav>\n");
    for (size_t i = 0; i < count; i++)
        put(out, "<a href=\"#figure-%i\">%t</a>\n", i + 1, entry[i].name);
    put(out, "</nav>\n");
    for (size_t i = 0; i < count; i++)
        put_figure(out, &entry[i], i + 1, scripts);
    put(out, "<p>Slipway %t</p>\n</body>\n</html>\n", SLIPWAY_VERSION);
    const int failed = ferror(out) | fclose(out);
    if (failed) {
        free(text);
        return NULL;
    }
    return text;
}
