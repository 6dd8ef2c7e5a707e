#include "page.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char head[] =
    "<!DOCTYPE html>\n"
    "<html lang=\"en\">\n"
    "<head>\n"
    "<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width\">\n"
    "<title>Slipway: the figures</title>\n"
    "<style>\n"
    "body { margin: 0 auto; max-width: 60rem; padding: 1rem 1.5rem;\n"
    "       font: 1rem/1.5 system-ui, sans-serif; color: #222; }\n"
    "nav a { display: inline-block; margin-right: .8rem; }\n"
    "figure { margin: 2.5rem 0; border-top: 1px solid #ccc; }\n"
    "figure h2 { margin: 1rem 0 .5rem; font-size: 1.25rem; }\n"
    "figure img { width: 100%; height: auto; display: block; }\n"
    "figure.many img { width: 49%; display: inline-block; }\n"
    "figcaption p { margin: .4rem 0; }\n"
    "code { background: #f3f3f3; padding: .1rem .3rem; }\n"
    ".failed { color: #b2001d; }\n"
    "a { color: #0072b2; }\n"
    "</style>\n"
    "</head>\n"
    "<body>\n"
    "<h1>Slipway: the figures</h1>\n"
    "<p>Steady and transient sliding under rate-and-state friction, after\n"
    "T. Putelat and J.H.P. Dawes, <cite>J. Mech. Phys. Solids</cite> (2015),\n"
    "<a href=\"https://doi.org/10.1016/j.jmps.2015.01.016\">doi "
    "10.1016/j.jmps.2015.01.016</a>. Every figure is\n"
    "computed from the scene beside it; change a number there and run it "
    "again.</p>\n";

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
    fputs(head, out);
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
