#include "node.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct node *node_new(enum node_kind kind, struct place at)
{
    struct node *n = malloc(sizeof *n);

    if (n)
        *n = (struct node){ .kind = kind, .at = at };
    return n;
}

enum status node_adopt(struct node *parent, struct node *child)
{
    const size_t n = parent->count;

    /* Capacities are powers of two; after node_remove there may be more. */
    if ((n & (n - 1)) == 0) {
        struct node **grown =
            realloc(parent->child, (n ? 2 * n : 1) * sizeof(struct node *));
        if (grown == NULL) {
            node_free(child);
            return STATUS_NO_MEMORY;
        }
        parent->child = grown;
    }
    parent->child[parent->count++] = child;
    return STATUS_OK;
}

enum status node_set_key(struct node *n, const char *key, size_t size,
                         struct place at)
{
    char *copy = text_copy(key, size);

    if (copy == NULL)
        return STATUS_NO_MEMORY;
    free(n->key);
    n->key = copy;
    n->key_at = at;
    return STATUS_OK;
}

struct node *node_find(const struct node *map, const char *key)
{
    for (size_t i = 0; map && i < map->count; i++)
        if (map->child[i]->key && strcmp(map->child[i]->key, key) == 0)
            return map->child[i];
    return NULL;
}

const struct node *node_at(const struct node *root, const char *path)
{
    const struct node *n = root;

    while (n && *path) {
        char key[64];
        const size_t size = strcspn(path, ".");
        snprintf(key, sizeof key, "%.*s", (int) size, path);
        n = node_find(n, key);
        path += size + (path[size] == '.');
    }
    return n;
}

void node_remove(struct node *parent, size_t i)
{
    node_free(parent->child[i]);
    parent->count--;
    memmove(parent->child + i, parent->child + i + 1,
            (parent->count - i) * sizeof *parent->child);
}

bool node_is_nothing(const struct node *n)
{
    return n->kind == NODE_SCALAR && n->text[0] == '\0';
}

struct text_shown node_shown(const struct node *n)
{
    struct text_shown shown;

    if (n->kind != NODE_SCALAR) {
        snprintf(shown.text, sizeof shown.text, "%s %s",
                 n->count ? "a" : "an empty",
                 n->kind == NODE_LIST ? "list" : "map of keys");
        return shown;
    }
    shown.text[0] = '\'';
    text_show(n->text, shown.text + 1, sizeof shown.text - 2);
    strcat(shown.text, "'");
    return shown;
}

void node_free(struct node *n)
{
    if (n == NULL)
        return;
    for (size_t i = 0; i < n->count; i++)
        node_free(n->child[i]);
    free(n->child);
    free(n->key);
    free(n->text);
    free(n);
}

/* "FILE:LINE:COL", "--set KEY=VALUE" or "command line". */
static void place_show(struct place at, char *out, size_t size)
{
    char name[180];

    if (at.name == NULL) {
        snprintf(out, size, "command line");
    } else if (at.is_set) {
        text_show(at.name, name, sizeof name);
        snprintf(out, size, "--set %s", name);
    } else {
        text_show_end(at.name, name, sizeof name);
        snprintf(out, size, at.line ? "%s:%zu:%zu" : "%s", name, at.line,
                 at.column);
    }
}

enum status place_blame(struct place at, struct fault *why, const char *format,
                        ...)
{
    char text[2 * sizeof why->text], where[256];
    va_list list;

    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    place_show(at, where, sizeof where);
    const size_t used =
        (size_t) snprintf(why->text, sizeof why->text, "%s: ", where);
    text_show(text, why->text + used, sizeof why->text - used);
    return STATUS_BAD_SCENE;
}
