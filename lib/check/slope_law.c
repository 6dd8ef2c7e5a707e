#include "slope_law.h"

#include <string.h>

#include "number.h"

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
        fprintf(out, "%s = %.17g; ", t->own[i].name, m->own[i]);
    fprintf(out, "state = %s", t->real ? "real" : "positive");
}

/* A name and what is to the right of it, without blanks around. */
struct entry {
    char name[FORMULA_NAME], text[LAW_LETTERS];
};

static bool take(char *out, size_t size, const char *from, const char *to)
{
    while (from < to && *from == ' ')
        from++;
    while (to > from && to[-1] == ' ')
        to--;
    if (from == to || (size_t) (to - from) >= size)
        return false;
    memcpy(out, from, (size_t) (to - from));
    out[to - from] = '\0';
    return true;
}

static bool read_entry(const char *from, const char *to, struct entry *e)
{
    const char *sign = memchr(from, '=', (size_t) (to - from));

    return sign && take(e->name, sizeof e->name, from, sign) &&
           take(e->text, sizeof e->text, sign + 1, to);
}

static bool add_entry(struct law_typed *t, const struct entry *e)
{
    for (int i = 0; i < LAW_PARTS; i++)
        if (strcmp(e->name, law_part_names[i]) == 0) {
            strcpy(t->text[i], e->text);
            return true;
        }
    if (strcmp(e->name, "state") == 0) {
        t->real = strcmp(e->text, "real") == 0;
        return t->real || strcmp(e->text, "positive") == 0;
    }
    if (t->owns == LAW_OWNS)
        return false;
    strcpy(t->own[t->owns].name, e->name);
    return number_read(e->text, &t->own[t->owns++].value);
}

enum status slope_law_read(const char *cell, enum friction_form form,
                           struct law_typed *t, struct fault *why)
{
    enum law_part wrong;
    struct entry e;

    memset(t, 0, sizeof *t);
    t->form = form;
    while (*cell) {
        const size_t size = strcspn(cell, ";");
        if (!read_entry(cell, cell + size, &e) || !add_entry(t, &e)) {
            snprintf(why->text, sizeof why->text,
                     "expected a preset, or NAME = FORMULA with ; between");
            return STATUS_BAD_SCENE;
        }
        cell += size + (cell[size] == ';');
    }
    return law_typed_make(t, &wrong, why);
}
