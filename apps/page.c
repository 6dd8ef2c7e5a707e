#include "page.h"

#include <ctype.h>
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

/* A file beside the page, as an address. */
static void put_address(FILE *out, const char *name, const char *ending)
{
    fputs("./", out);
    for (; *name; name++)
        if (isalnum((unsigned char) *name) || strchr("._-", *name))
            fputc(*name, out);
        else
            fprintf(out, "%%%02X", (unsigned) (unsigned char) *name);
    fputs(ending, out);
}

static void put_link(FILE *out, const char *name, const char *ending,
                     const char *what)
{
    fputs("<a href=\"", out);
    put_address(out, name, ending);
    fprintf(out, "\">%s</a>", what);
}

static void put_contents(FILE *out, const struct page *p)
{
    fputs("<nav>\n", out);
    for (size_t i = 0; i < p->count; i++) {
        fprintf(out, "<a href=\"#figure-%zu\">", i + 1);
        put_text(out, p->figure[i].name);
        fputs("</a>\n", out);
    }
    fputs("</nav>\n", out);
}

static void put_panels(FILE *out, const struct page_figure *f)
{
    for (size_t i = 0; i < f->panels; i++) {
        fputs("<img src=\"", out);
        put_address(out, f->panel[i], ".svg");
        fputs("\" alt=\"", out);
        put_text(out, f->title[0] ? f->title : f->name);
        fputs("\">\n", out);
    }
}

static void put_links(FILE *out, const struct page *p,
                      const struct page_figure *f)
{
    fputs("<p>", out);
    put_link(out, f->name, ".yaml", "scene");
    fputs(" · ", out);
    put_link(out, f->name, ".h5", "HDF5");
    for (size_t i = 0; i < f->panels; i++) {
        fputs(" · ", out);
        put_link(out, f->panel[i], ".png", "PNG");
        if (!p->has_scripts)
            continue;
        fputs(", ", out);
        put_link(out, f->panel[i], ".gp", "script");
        fputs(", ", out);
        put_link(out, f->panel[i], ".dat", "data");
    }
    fputs("</p>\n", out);
}

static void put_figure(FILE *out, const struct page *p, size_t i)
{
    const struct page_figure *f = &p->figure[i];

    fprintf(out, "<figure id=\"figure-%zu\"%s>\n<h2>", i + 1,
            f->panels > 1 ? " class=\"many\"" : "");
    put_text(out, f->name);
    if (f->title[0])
        fputs(": ", out);
    put_text(out, f->title);
    fputs("</h2>\n", out);
    put_panels(out, f);
    fputs("<figcaption>\n<p>", out);
    put_text(out, f->comment);
    fputs("</p>\n<p><code>", out);
    put_text(out, f->command);
    fputs("</code></p>\n", out);
    if (f->failure) {
        fputs("<p class=\"failed\">", out);
        put_text(out, f->failure);
        fputs("</p>\n", out);
    } else {
        put_links(out, p, f);
    }
    fputs("</figcaption>\n</figure>\n", out);
}

char *page_text(const struct page *p)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);

    if (out == NULL)
        return NULL;
    fputs(head, out);
    put_contents(out, p);
    for (size_t i = 0; i < p->count; i++)
        put_figure(out, p, i);
    fputs("<p>Slipway ", out);
    put_text(out, p->version);
    fputs("</p>\n</body>\n</html>\n", out);
    const int failed = ferror(out) | fclose(out);
    if (failed) {
        free(text);
        return NULL;
    }
    return text;
}
