#include "schema.h"

#include <stdio.h>
#include <string.h>

#include "scene_law.h"
#include "synonym.h"
#include "text.h"

/* ---- keys ---------------------------------------------------------------- */

enum { PATH_SIZE = 128, LEVEL_WORDS = 32, WORD_SIZE = 24 };

const struct schema_key *schema_find(const char *path)
{
    for (const struct schema_key *k = schema_table; k->path; k++)
        if (strcmp(k->path, path) == 0)
            return k;
    return NULL;
}

static bool holds_keys(const char *path)
{
    const size_t n = strlen(path);

    for (const struct schema_key *k = schema_table; k->path; k++)
        if (strncmp(k->path, path, n) == 0 && k->path[n] == '.')
            return true;
    return false;
}

bool schema_excludes(const char *path, const char *other)
{
    const struct schema_key *a = schema_find(path), *b = schema_find(other);

    return a && b && a->side && b->side && a->side != b->side;
}

/* The words that may stand behind the first `head` letters of path. */
struct level {
    char word[LEVEL_WORDS][WORD_SIZE];
    const char *list[LEVEL_WORDS + 1]; /* NULL-ended */
};

static void level_find(const char *path, size_t head, struct level *l)
{
    size_t count = 0;

    for (const struct schema_key *k = schema_table; k->path; k++) {
        char word[WORD_SIZE];
        if (strncmp(k->path, path, head) != 0 || count == LEVEL_WORDS)
            continue;
        snprintf(word, sizeof word, "%.*s", (int) strcspn(k->path + head, "."),
                 k->path + head);
        if (count > 0 && strcmp(l->word[count - 1], word) == 0)
            continue;
        memcpy(l->word[count], word, sizeof word);
        l->list[count] = l->word[count];
        count++;
    }
    l->list[count] = NULL;
}

/* The key, wherever it is, whose last word is near to this one, such as
 * slope.alpha of alpha; NULL if there is none.  A letter is near to nothing. */
static const char *near_elsewhere(const char *word)
{
    const char *last[SCHEMA_KEYS_MAX + 1] = { NULL };

    for (size_t i = 0; schema_table[i].path; i++) {
        const char *dot = strrchr(schema_table[i].path, '.');
        last[i] = dot ? dot + 1 : schema_table[i].path;
    }
    const char *near = word[1] ? synonym_nearest(word, last) : NULL;
    for (size_t i = 0; near && last[i]; i++)
        if (last[i] == near)
            return schema_table[i].path;
    return NULL;
}

/* Blames the word of path that begins at `head`; all before it is known. */
static enum status unknown(const char *path, size_t head, struct place at,
                           struct fault *why)
{
    struct level level;
    char words[200], word[PATH_SIZE];

    snprintf(word, sizeof word, "%.*s", (int) strcspn(path + head, "."),
             path + head);
    level_find(path, head, &level);
    text_list(level.list, words, sizeof words);
    const char *near = synonym_nearest(word, level.list);
    const size_t parent = near ? head : 0;
    if (near == NULL)
        near = near_elsewhere(word);
    if (near == NULL)
        return place_blame(at, why, "unknown key '%s', expected %s",
                           text_shown(path).text, words);
    return place_blame(at, why,
                       "unknown key '%s', expected %s (did you mean %.*s%s?)",
                       text_shown(path).text, words, (int) parent, path, near);
}

enum status schema_check_path(const char *path, struct place at,
                              struct fault *why)
{
    for (size_t head = 0;;) {
        const size_t end = head + strcspn(path + head, ".");
        char known[PATH_SIZE];
        if (end >= sizeof known)
            return unknown(path, head, at, why);
        snprintf(known, sizeof known, "%.*s", (int) end, path);
        const struct schema_key *key = schema_find(known);
        if (key && key->open)
            return STATUS_OK;
        if (!holds_keys(known) && (path[end] || !key))
            return unknown(path, head, at, why);
        if (path[end] == '\0')
            return STATUS_OK;
        head = end + 1;
    }
}

enum status schema_blame_section(const char *path, size_t size,
                                 const struct node *n, struct fault *why)
{
    struct level level;
    char section[PATH_SIZE], words[200];
    size_t last = size;

    snprintf(section, sizeof section, "%.*s.", (int) size, path);
    level_find(section, size + 1, &level);
    text_list(level.list, words, sizeof words);
    while (last > 0 && path[last - 1] != '.')
        last--;
    return place_blame(n->at, why,
                       "%.*s: %s is not allowed, expected a map of keys, %s, "
                       "as in '%.*s: {%s: ...}'",
                       (int) size, path, node_shown(n).text, words,
                       (int) (size - last), path + last, level.list[0]);
}

/* ---- a whole tree -------------------------------------------------------- */

/* "prefix.key", or "key" at the top; cut at size - 1. */
static void join(const char *prefix, const char *key, char *path, size_t size)
{
    snprintf(path, size, "%s%s%s", prefix, prefix[0] ? "." : "", key);
}

static enum status check_sides(const struct node *map, size_t i,
                               const char *prefix, struct fault *why)
{
    char path[PATH_SIZE], other[PATH_SIZE];
    const struct node *n = map->child[i];

    join(prefix, n->key, path, sizeof path);
    for (size_t j = 0; j < i; j++) {
        join(prefix, map->child[j]->key, other, sizeof other);
        if (schema_excludes(path, other))
            return place_blame(n->key_at, why,
                               "%s: not beside %s, expected one of the two",
                               path, other);
    }
    return STATUS_OK;
}

static enum status check_key(const struct node *n, const char *path,
                             struct fault *why)
{
    if (strchr(n->key, '.'))
        return place_blame(n->key_at, why,
                           "unknown key '%s', expected one word, as in "
                           "'slope: {alpha: RAD}' for slope.alpha",
                           text_shown(n->key).text);
    return schema_check_path(path, n->key_at, why);
}

static enum status apply_below(const struct node *map, const char *prefix,
                               struct scene *s, struct fault *why);

/* Only the axes of a sweep may be a list of sections. */
static enum status apply_axes(const struct node *list, struct scene *s,
                              struct fault *why)
{
    enum status status = STATUS_OK;

    if (list->count == 0 || list->count > SCENE_AXES)
        return place_blame(list->at, why,
                           "sweep: a list of %zu, expected one or two of "
                           "{key: KEY, ...}",
                           list->count);
    for (size_t i = 0; i < list->count && status == STATUS_OK; i++) {
        const struct node *axis = list->child[i];
        if (axis->kind != NODE_MAP)
            return schema_blame_section("sweep", strlen("sweep"), axis, why);
        status = apply_below(axis, "sweep", s, why);
        s->sweep.axis[i] = s->sweep.draft;
        s->sweep.draft = (struct scene_axis){ .key = NULL };
    }
    s->sweep.axes = list->count;
    return status;
}

static enum status apply_one(const struct node *n, const char *path,
                             struct scene *s, struct fault *why)
{
    const struct schema_key *key = schema_find(path);

    if (n->kind == NODE_LIST && strcmp(path, "sweep") == 0)
        return apply_axes(n, s, why);
    if (key)
        return key->read(key, n, s, why);
    if (n->kind == NODE_MAP)
        return apply_below(n, path, s, why);
    if (node_is_nothing(n))
        return STATUS_OK;
    return schema_blame_section(path, strlen(path), n, why);
}

static enum status apply_below(const struct node *map, const char *prefix,
                               struct scene *s, struct fault *why)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < map->count && status == STATUS_OK; i++) {
        const struct node *n = map->child[i];
        char path[PATH_SIZE];
        join(prefix, n->key, path, sizeof path);
        if (s->typed && scene_law_may_own(path) && !schema_find(path)) {
            status = scene_law_own(n, s, why);
            continue;
        }
        status = check_key(n, path, why);
        if (status == STATUS_OK)
            status = check_sides(map, i, prefix, why);
        if (status == STATUS_OK)
            status = apply_one(n, path, s, why);
    }
    return status;
}

enum status schema_apply(const struct node *root, struct scene *s,
                         struct fault *why)
{
    return apply_below(root, "", s, why);
}
