#include "result.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- names --------------------------------------------------------------- */

/* A name in the making. */
struct writer {
    char *to;
    size_t size, end;
};

static void put(struct writer *w, const char *text, size_t length)
{
    for (size_t i = 0; i < length && w->end + 1 < w->size; i++)
        w->to[w->end++] = text[i];
    w->to[w->end] = '\0';
}

/* Word k of "{a,b}"; its end. */
static const char *put_word(struct writer *w, const char *list, size_t k)
{
    const char *word = list + 1;

    for (; k > 0 && word[strcspn(word, ",}")] == ','; k--)
        word += strcspn(word, ",}") + 1;
    put(w, word, strcspn(word, ",}"));
    return strchr(list, '}') + 1;
}

static void put_number(struct writer *w, size_t k)
{
    char text[24];

    put(w, text, (size_t) snprintf(text, sizeof text, "%zu", k));
}

/* A K by itself. */
static bool is_number(const char *pattern, const char *p)
{
    return *p == 'K' && (p == pattern || strchr("_[/", p[-1])) &&
           (p[1] == '\0' || strchr("_]/", p[1]));
}

void result_name(const char *pattern, size_t k, const char *field,
                 char name[RESULT_NAME])
{
    struct writer w = { name, RESULT_NAME, 0 };

    name[0] = '\0';
    for (const char *p = pattern; *p;) {
        if (*p == '{') {
            p = put_word(&w, p, k);
            continue;
        }
        if (is_number(pattern, p))
            put_number(&w, k);
        else if (*p == '*' && field)
            put(&w, field, strlen(field));
        else
            put(&w, p, 1);
        p++;
    }
}

void result_member(const struct result *r, size_t k,
                   const struct record_field *f, char name[RESULT_NAME])
{
    result_name(r->member ? r->member : "*", k, f->name, name);
}

/* ---- instances ----------------------------------------------------------- */

static size_t words_of(const char *pattern)
{
    const char *list = pattern ? strchr(pattern, '{') : NULL;
    size_t n = 1;

    for (; list && *list != '}'; list++)
        n += *list == ',';
    return n;
}

size_t result_count(const struct result *r, const void *run)
{
    const size_t words = words_of(r->path);

    if (r->count)
        return r->count(run);
    return words > 1 ? words : words_of(r->member ? r->member : r->name);
}

enum status result_open(const struct result *r, const void *run, size_t k,
                        struct result_view *out)
{
    *out = (struct result_view){ .records = { .type = r->type } };
    return r->view ? r->view(run, k, out) : STATUS_OK;
}

void result_close(struct result_view *v)
{
    free(v->owned);
    *v = (struct result_view){ .here = false };
}
