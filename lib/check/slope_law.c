#include "slope_law.h"

#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "statements.h"

bool slope_law_is(const char *cell)
{
    return strchr(cell, '=') != NULL;
}

/* What YAML has folded into it is one line. */
static void put(FILE *out, const char *name, const char *text)
{
    fprintf(out, "%s = ", name);
    for (; *text; text++)
        fputc(*text == '\n' || *text == '\t' || *text == '"' ? ' ' : *text,
              out);
    fputs("; ", out);
}

void slope_law_write(FILE *out, const struct law_typed *t,
                     const struct material *m)
{
    for (int i = 0; i < LAW_PARTS; i++)
        if (t->text[i][0])
            put(out, law_part_names[i], t->text[i]);
    for (int i = 0; i < t->owns; i++)
        fprintf(out, "%s = %s; ", t->own[i].name,
                number_shortest(m->own[i]).text);
    fprintf(out, "state = %s", t->real ? "real" : "positive");
}

/* Whether a text of less than `size` letters was there and is copied. */
static bool copy(char *out, size_t size, const char *text)
{
    const size_t n = strlen(text);

    if (n == 0 || n >= size)
        return false;
    memcpy(out, text, n + 1);
    return true;
}

static bool add_own(struct law_typed *t, const struct statement *e)
{
    if (t->owns == LAW_OWNS ||
        !copy(t->own[t->owns].name, sizeof t->own->name, e->name))
        return false;
    return number_read(e->text, &t->own[t->owns++].value);
}

static bool add(struct law_typed *t, const struct statement *e)
{
    if (e->rate)
        return false;
    for (int i = 0; i < LAW_PARTS; i++)
        if (strcmp(e->name, law_part_names[i]) == 0)
            return copy(t->text[i], sizeof t->text[i], e->text);
    if (strcmp(e->name, "state") == 0) {
        t->real = strcmp(e->text, "real") == 0;
        return t->real || strcmp(e->text, "positive") == 0;
    }
    return add_own(t, e);
}

enum status slope_law_read(const char *cell, enum friction_form form,
                           struct law_typed *t, struct fault *why)
{
    char *text = strdup(cell);
    struct statements of;
    enum law_part wrong;

    if (text == NULL)
        return STATUS_NO_MEMORY;
    memset(t, 0, sizeof *t);
    t->form = form;
    bool good = statements_cut(text, &of) == NULL;
    for (size_t i = 0; i < of.count && good; i++)
        good = add(t, &of.at[i]);
    free(text);
    if (good)
        return law_typed_make(t, &wrong, why);
    return fault_set(why, STATUS_BAD_SCENE,
                     "expected a preset, or NAME = FORMULA with ; between");
}
