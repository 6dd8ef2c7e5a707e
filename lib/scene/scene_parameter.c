#include "scene_parameter.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "spell.h"
#include "system.h"

enum { KEY = FORMULA_NAME + 20 };

static bool is_part(char c)
{
    return isalnum((unsigned char) c) || c == '_';
}

/* Whether a formula has the name. */
static bool is_used(const struct formula_system *f, const char *name)
{
    const size_t size = strlen(name);

    for (int i = 0; i < f->entries; i++) {
        const char *text = formula_system_text(f, &f->entry[i]);
        for (const char *at = text; (at = strstr(at, name)); at++)
            if ((at == text || !is_part(at[-1])) && !is_part(at[size]))
                return true;
    }
    return false;
}

static enum status check_set(const struct node *n, const struct scene *s,
                             struct fault *why)
{
    const struct formula_system *f = s->system;
    const char *used[SYSTEM_PARAMETERS + 1] = { NULL };
    size_t count = 0;

    for (int i = 0; i < f->parameters; i++)
        if (is_used(f, f->parameter[i].name))
            used[count++] = f->parameter[i].name;
    for (size_t i = 0; n && i < n->count; i++) {
        const struct node *p = n->child[i];
        if (!p->key_at.is_set || is_used(f, p->key))
            continue;
        const char *near = spell_nearest(p->key, used);
        return place_blame(
            p->key_at, why, "system.parameters.%s: no formula has it%s%s%s",
            text_shown(p->key).text, near ? " (did you mean " : "",
            near ? near : "", near ? "?)" : "");
    }
    return STATUS_OK;
}

enum status scene_parameter_keys(struct scene *s, const struct node *of,
                                 struct fault *why)
{
    const struct formula_system *f = s->system;
    const size_t n = (size_t) f->parameters;
    char **key = malloc((n + 1) * sizeof *key + n * KEY);
    char *text = (char *) (key + n + 1);

    if (key == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < n; i++, text += KEY) {
        snprintf(text, KEY, "system.parameters.%s", f->parameter[i].name);
        key[i] = text;
    }
    key[n] = NULL;
    s->parameter_key = key;
    return check_set(of, s, why);
}

bool scene_parameter_is(const struct scene *s, const char *key)
{
    char *const *known = s->parameter_key;

    while (*known && strcmp(*known, key) != 0)
        known++;
    return *known != NULL;
}

enum status scene_parameter_set(struct formula_system *f, const char *key,
                                double x)
{
    static const struct formula_place here = { "a parameter", 0, 0 };
    formula_real value;
    struct fault why;

    const enum status status =
        formula_parse_decimal(number_shortest(x).text, here, &value, &why);
    return status ? status
                  : formula_system_set(f, strrchr(key, '.') + 1, value, here,
                                       &why);
}
