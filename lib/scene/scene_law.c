#include "scene_law.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "law_graph.h"
#include "law_typed.h"
#include "number.h"
#include "schema.h"
#include "text.h"

/* No word as components have them, or misspelt. */
static bool is_formula(const char *text)
{
    return strpbrk(text, "+-*/^()") != NULL;
}

static bool is_word(const char *text)
{
    for (; *text; text++)
        if (!isalnum((unsigned char) *text) && *text != '_')
            return false;
    return true;
}

static const struct node *given(const struct node *root, const char *key)
{
    const struct node *law = node_find(root, "law");
    const struct node *n = law ? node_find(law, key) : NULL;

    return n && n->kind == NODE_SCALAR ? n : NULL;
}

bool scene_law_is_typed(const struct node *root)
{
    static const char *const formulas[] = { "T", "K", "mu", "rate", "state" };
    bool typed = false;

    for (size_t i = 0; i < sizeof formulas / sizeof *formulas; i++)
        typed = typed || given(root, formulas[i]);
    for (int i = 0; i < 2; i++) {
        const struct node *n = given(root, i ? "psi_ss" : "theta");
        typed = typed || (n && is_formula(n->text));
    }
    return typed && !given(root, "preset");
}

enum status scene_law_begin(const struct node *root, struct scene *s)
{
    if (!scene_law_is_typed(root))
        return STATUS_OK;
    s->typed = calloc(1, sizeof *s->typed);
    return s->typed ? STATUS_OK : STATUS_NO_MEMORY;
}

/* ---- names of its own ---------------------------------------------------- */

bool scene_law_may_own(const char *path)
{
    return strncmp(path, "material.", 9) == 0 && strchr(path + 9, '.') == NULL;
}

static bool is_name(const char *text)
{
    static const char *const taken[] = {
        "v", "psi", "theta",     "psi_ss", "d",  "T",
        "K", "mu",  "tan_alpha", "eps2",   "pi", NULL,
    };

    return text_index(text, taken) < 0 &&
           (isalpha((unsigned char) text[0]) || text[0] == '_') &&
           is_word(text) && strlen(text) < FORMULA_NAME;
}

enum status scene_law_own(const struct node *n, struct scene *s,
                          struct fault *why)
{
    struct law_typed *t = s->typed;
    double value;

    if (!is_name(n->key))
        return place_blame(n->key_at, why,
                           "material.%s: expected a name of the law's own that "
                           "the model does not have",
                           text_shown(n->key).text);
    if (t->owns == LAW_OWNS)
        return place_blame(n->key_at, why,
                           "material.%s: more than %d names of its own",
                           text_shown(n->key).text, LAW_OWNS);
    if (n->kind != NODE_SCALAR || !number_read(n->text, &value))
        return place_blame(n->at, why,
                           "material.%s: %s is not allowed, expected a number",
                           text_shown(n->key).text, node_shown(n).text);
    strcpy(t->own[t->owns].name, n->key);
    t->own[t->owns++].value = value;
    return STATUS_OK;
}

const char *scene_law_key(struct scene *s, const char *path)
{
    struct law_typed *t = s->typed;

    if (t == NULL || t->sweeps == 2 || !scene_law_may_own(path) ||
        schema_find(path) || strlen(path) >= sizeof t->swept[0])
        return NULL;
    return strcpy(t->swept[t->sweeps++], path);
}

int scene_law_find(const struct scene *s, const char *path)
{
    const struct law_typed *t = s->typed;

    for (int i = 0; t && scene_law_may_own(path) && i < t->owns; i++)
        if (strcmp(t->own[i].name, path + 9) == 0)
            return i;
    return -1;
}

/* ---- formulas ------------------------------------------------------------ */

/* Words stand for their components' formulas. */
static void words_of(const struct node *root, const struct scene *s,
                     struct law_typed *out)
{
    static const char *const key[LAW_PARTS] = {
        [LAW_THETA] = "theta",
        [LAW_PSI_SS] = "psi_ss",
        [LAW_T] = "timescale",
        [LAW_K] = "kinetics",
    };

    law_typed_of_preset(&s->law, out);
    for (int i = 0; i < LAW_PARTS; i++)
        if (key[i] == NULL || given(root, key[i]) == NULL)
            out->text[i][0] = '\0';
}

static enum status read_part(const struct node *n, char text[LAW_LETTERS],
                             struct fault *why)
{
    if (strlen(n->text) >= LAW_LETTERS)
        return place_blame(n->at, why,
                           "law.%s: more than %d letters, expected a formula",
                           n->key, LAW_LETTERS - 1);
    strcpy(text, n->text);
    return STATUS_OK;
}

static enum status blame(const struct node *root, enum law_part wrong,
                         const char *reason, struct fault *why)
{
    const struct node *n =
        wrong < LAW_PARTS ? given(root, law_part_names[wrong]) : NULL;

    if (n)
        return place_blame(n->at, why, "law.%s: %s", n->key, reason);
    return place_blame(node_find(root, "law")->at, why, "law: %s", reason);
}

enum status scene_law_finish(const struct node *root, struct scene *s,
                             struct fault *why)
{
    struct law_typed *t = s->typed;
    struct fault reason = { "" };
    enum law_part wrong;
    enum status status = STATUS_OK;

    if (t == NULL)
        return STATUS_OK;
    const struct node *state = given(root, "state");
    struct law_own own[LAW_OWNS];
    const int owns = t->owns, sweeps = t->sweeps;
    char swept[2][sizeof t->swept[0]];
    memcpy(own, t->own, sizeof own);
    memcpy(swept, t->swept, sizeof swept);
    words_of(root, s, t);
    memcpy(t->own, own, sizeof own);
    memcpy(t->swept, swept, sizeof swept);
    t->owns = owns;
    t->sweeps = sweeps;
    t->real = state ? strcmp(state->text, "real") == 0
                    : given(root, "theta") && law_psi_is_log(&s->law);
    for (int i = 0; i < LAW_PARTS && status == STATUS_OK; i++) {
        const struct node *n = given(root, law_part_names[i]);
        if (n && (t->text[i][0] == '\0' || is_formula(n->text)))
            status = read_part(n, t->text[i], why);
    }
    if (status != STATUS_OK)
        return status;
    for (int i = 0; i < t->owns; i++)
        s->material.own[i] = t->own[i].value;
    if (law_typed_make(t, &wrong, &reason) != STATUS_OK)
        return blame(root, wrong, reason.text, why);
    s->law = law_of_typed(t);
    return law_root_check(&s->law, &s->material, &reason) == STATUS_OK
               ? STATUS_OK
               : blame(root, LAW_RATE, reason.text, why);
}
