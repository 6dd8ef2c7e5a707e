#include "statements.h"

#include <string.h>

static char *trimmed(char *text)
{
    text += strspn(text, " \t\r");
    for (size_t n = strlen(text); n > 0 && strchr(" \t\r", text[n - 1]);)
        text[--n] = '\0';
    return text;
}

/* "x" of "x'" and of "dx/dt". */
static char *name_of_rate(char *name, bool *rate)
{
    const size_t n = strlen(name);

    *rate = n > 1 && name[n - 1] == '\'';
    if (*rate) {
        name[n - 1] = '\0';
        return trimmed(name);
    }
    *rate = n > 4 && name[0] == 'd' && strcmp(name + n - 3, "/dt") == 0;
    if (!*rate)
        return name;
    name[n - 3] = '\0';
    return name + 1;
}

const char *statements_cut(char *text, struct statements *out)
{
    char *part;

    out->count = 0;
    while ((part = strsep(&text, ";\n")) != NULL) {
        char *equal = strchr(part, '=');
        if (*trimmed(part) == '\0')
            continue;
        if (equal == NULL || out->count == STATEMENTS)
            return trimmed(part);
        *equal = '\0';
        struct statement *s = &out->at[out->count++];
        s->name = name_of_rate(trimmed(part), &s->rate);
        s->text = trimmed(equal + 1);
    }
    return NULL;
}

enum status statements_read(const struct node *n, char **text,
                            struct statements *out, struct fault *why)
{
    const char *wrong;

    *text = NULL;
    if (n == NULL)
        return STATUS_OK;
    if (n->kind != NODE_SCALAR)
        return place_blame(n->at, why,
                           "system.ode: %s is not allowed, expected \"x' = "
                           "..., y' = ...\"",
                           node_shown(n).text);
    if ((*text = text_copy(n->text, strlen(n->text))) == NULL)
        return STATUS_NO_MEMORY;
    if ((wrong = statements_cut(*text, out)) == NULL)
        return STATUS_OK;
    return place_blame(n->at, why,
                       "system.ode: '%s', expected at most %d of "
                       "NAME' = FORMULA or NAME = FORMULA, with ; "
                       "between them",
                       text_shown(wrong).text, STATEMENTS);
}
