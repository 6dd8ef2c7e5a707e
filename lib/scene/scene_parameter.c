#include "scene_parameter.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "spell.h"
#include "system.h"

enum { KEY = FORMULA_NAME + 20 };

/* One that no formula has is another's name, mistyped. */
static enum status expect_uses(const struct node *n, const struct node *ode,
                               const struct formula_system *f,
                               struct fault *why)
{
    const char *used[SYSTEM_PARAMETERS + 1] = { NULL };
    size_t count = 0;

    for (int i = 0; i < f->parameters; i++)
        if (formula_system_uses(f, f->parameter[i].name))
            used[count++] = f->parameter[i].name;
    for (int i = 0; i < f->parameters; i++) {
        const char *name = f->parameter[i].name;
        const struct node *p = node_find(n, name);
        if (formula_system_uses(f, name))
            continue;
        const char *near = spell_nearest(name, used);
        return place_blame(p ? p->key_at : ode->at, why,
                           "system.parameters.%s: no formula has it%s%s%s",
                           name, near ? " (did you mean " : "",
                           near ? near : "", near ? "?)" : "");
    }
    return STATUS_OK;
}

enum status scene_parameter_keys(struct scene *s, const struct node *of,
                                 const struct node *ode, struct fault *why)
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
    return expect_uses(of, ode, f, why);
}

bool scene_parameter_is(const struct scene *s, const char *key)
{
    return text_index(key, (const char *const *) s->parameter_key) >= 0;
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
