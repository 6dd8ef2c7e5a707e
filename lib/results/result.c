#include "result.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "result_units.h"

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

static void put_number(struct writer *w, size_t k, int digits)
{
    char text[48];

    put(w, text, (size_t) snprintf(text, sizeof text, "%0*zu", digits, k));
}

/* A K by itself. */
static bool is_number(const char *pattern, const char *p)
{
    return *p == 'K' && (p == pattern || strchr("_[/", p[-1])) &&
           (p[1] == '\0' || strchr("_]/", p[1]));
}

static void name_of(const char *pattern, size_t k, int digits,
                    const char *field, char name[RESULT_NAME])
{
    struct writer w = { name, RESULT_NAME, 0 };

    name[0] = '\0';
    for (const char *p = pattern; *p;) {
        if (*p == '{') {
            p = put_word(&w, p, k);
            continue;
        }
        if (is_number(pattern, p))
            put_number(&w, k, digits);
        else if (*p == '*' && field)
            put(&w, field, strlen(field));
        else
            put(&w, p, 1);
        p++;
    }
}

void result_name(const char *pattern, size_t k, const char *field,
                 char name[RESULT_NAME])
{
    name_of(pattern, k, 1, field, name);
}

void result_path(const struct result *r, size_t k, size_t n,
                 char name[RESULT_NAME])
{
    int digits = 1;

    for (size_t most = n ? n - 1 : 0; most >= 10; most /= 10)
        digits++;
    name_of(r->path, k, digits, NULL, name);
}

void result_prefix(const struct result *r, size_t k, char prefix[RESULT_NAME])
{
    char name[RESULT_NAME], *end = prefix;

    result_name(r->name, k, NULL, name);
    for (const char *c = name; *c; c++)
        if (*c != ']')
            *end++ = *c == '.' || *c == '[' ? '_' : *c;
    *end = '\0';
    if (prefix[0])
        strncat(prefix, "_", RESULT_NAME - strlen(prefix) - 1);
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

static const struct result_kept *find_kept(const struct result_keep *kept,
                                           const struct result *r)
{
    for (size_t i = 0; kept && i < kept->count; i++)
        if (kept->at[i].of == r)
            return &kept->at[i];
    return NULL;
}

static enum status open_own(const struct results *all, const struct result *r,
                            size_t k, struct result_view *out)
{
    const struct result_kept *kept = r->make ? find_kept(all->kept, r) : NULL;

    *out = (struct result_view){ .records = { .type = r->type } };
    if (kept)
        return result_lend(out, kept->record, 1);
    if (r->count && k >= r->count(all->run))
        return STATUS_OK;
    return r->view ? r->view(all->run, k, out) : STATUS_OK;
}

enum status result_open(const struct results *all, const struct result *r,
                        size_t k, struct result_view *out)
{
    const enum status status = open_own(all, r, k, out);

    return status == STATUS_OK && out->here ? result_tell(&all->units, out)
                                            : status;
}

void result_close(struct result_view *v)
{
    free(v->owned);
    *v = (struct result_view){ .here = false };
}

/* ---- what is made once --------------------------------------------------- */

static enum status make(struct result_keep *kept, const struct result *r,
                        const void *run)
{
    void *record = calloc(1, r->type->size);
    struct result_kept *at = realloc(kept->at, (kept->count + 1) * sizeof *at);
    enum status status = STATUS_NO_MEMORY;

    if (at)
        kept->at = at;
    if (at && record)
        status = r->make(run, record);
    if (status == STATUS_OK)
        kept->at[kept->count++] = (struct result_kept){ r, record };
    else
        free(record);
    return status;
}

enum status result_keep(struct result_keep *kept, const struct results *all,
                        uint64_t bits)
{
    enum status status = STATUS_OK;

    for (size_t t = 0; all->table[t]; t++)
        for (const struct result *r = all->table[t]; r->type && !status; r++)
            if (r->make && result_asked(r, all) && !(r->needs & ~bits) &&
                !find_kept(kept, r))
                status = make(kept, r, all->run);
    return status;
}

void result_keep_free(struct result_keep *kept)
{
    for (size_t i = 0; i < kept->count; i++)
        free(kept->at[i].record);
    free(kept->at);
    *kept = (struct result_keep){ .at = NULL };
}
