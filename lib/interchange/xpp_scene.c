#include <stdio.h>
#include <stdlib.h>

#include "xpp_model.h"

static void write_states(FILE *out, const struct formula_system *s)
{
    static const char *const word[] = { "real", "positive", "angle" };

    fprintf(out, "  state: {%s: %s, %s: %s}\n", s->state[0].name,
            word[s->state[0].chart], s->state[1].name, word[s->state[1].chart]);
}

/* Formulas have no quotes. */
static void write_entries(FILE *out, const struct formula_system *s,
                          const char *section, enum system_entry_kind kind)
{
    bool any = false;

    for (int i = 0; i < s->entries; i++) {
        const struct system_entry *e = &s->entry[i];
        const char *text = formula_system_text(s, e);
        if (e->kind != kind)
            continue;
        if (!any)
            fprintf(out, "  %s:\n", section);
        any = true;
        while (*text == ' ' || *text == '\t')
            text++;
        fprintf(out, "    %s: \"", e->name);
        for (; *text; text++) /* x**2 was read as x^ 2 */
            if (*text != ' ' || text[-1] != '^')
                fputc(*text, out);
        fprintf(out, "\"\n");
    }
}

char *xpp_model_scene(const struct xpp_model *m, const char *title)
{
    const struct formula_system *s = &m->system;
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);

    if (out == NULL)
        return NULL;
    fprintf(out, "title: \"");
    for (const char *c = title; *c; c++)
        if (*c >= ' ' && *c <= '~' && *c != '"' && *c != '\\')
            fputc(*c, out);
    fprintf(out, "\"\nsystem:\n");
    write_states(out, s);
    bool used = false;
    for (int i = 0; i < s->parameters; i++) {
        if (!formula_system_uses(s, s->parameter[i].name))
            continue;
        fprintf(out, "%s    %s: %s\n", used ? "" : "  parameters:\n",
                s->parameter[i].name, m->decimal[i]);
        used = true;
    }
    write_entries(out, s, "define", ENTRY_DEFINE);
    write_entries(out, s, "rates", ENTRY_RATE);
    fprintf(out, "window: {%s: [%.15g, %.15g], %s: [%.15g, %.15g]}\n",
            s->state[0].name, m->lo[0], m->hi[0], s->state[1].name, m->lo[1],
            m->hi[1]);
    const bool failed = ferror(out);
    if (fclose(out) != 0 || failed) {
        free(text);
        return NULL;
    }
    return text;
}
