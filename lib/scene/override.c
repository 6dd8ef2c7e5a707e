#include "override.h"

#include <stdio.h>
#include <string.h>

#include "document.h"
#include "scene_law.h"
#include "schema.h"

/* No key of the schema is longer; what is cut is unknown all the same. */
enum { PATH_SIZE = 128 };

/* Removes what path replaces from the map at its first `head` letters. */
static void take_back(struct node *map, const char *path, size_t head)
{
    for (size_t i = map->count; i-- > 0;) {
        char other[2 * PATH_SIZE];
        snprintf(other, sizeof other, "%.*s%s", (int) head, path,
                 map->child[i]->key);
        if (strcmp(other, path) == 0 || schema_excludes(other, path))
            node_remove(map, i);
    }
}

/* The map at the first `size` letters of path, below `map`; made if there is
 * none or nothing in it. */
static enum status enter(struct node *map, const char *path, size_t size,
                         struct place at, struct node **out, struct fault *why)
{
    const char *key = path;
    char name[PATH_SIZE];

    for (const char *c = path; c < path + size; c++)
        key = *c == '.' ? c + 1 : key;
    snprintf(name, sizeof name, "%.*s", (int) (path + size - key), key);
    struct node *n = node_find(map, name);
    if (n && node_is_nothing(n))
        n->kind = NODE_MAP;
    if (n && n->kind != NODE_MAP)
        return schema_blame_section(path, size, n, why);
    *out = n;
    if (n)
        return STATUS_OK;
    *out = node_new(NODE_MAP, at);
    if (*out == NULL)
        return STATUS_NO_MEMORY;
    if (node_set_key(*out, name, strlen(name), at) != STATUS_OK) {
        node_free(*out);
        return STATUS_NO_MEMORY;
    }
    return node_adopt(map, *out);
}

/* Puts n at path. */
static enum status graft(struct node *root, const char *path, struct node *n,
                         struct fault *why)
{
    struct node *map = root;
    size_t head = 0, end = strcspn(path, ".");

    while (path[end]) {
        const enum status s = enter(map, path, end, n->at, &map, why);
        if (s != STATUS_OK) {
            node_free(n);
            return s;
        }
        head = end + 1;
        end = head + strcspn(path + head, ".");
    }
    take_back(map, path, head);
    if (node_set_key(n, path + head, end - head, n->at) != STATUS_OK) {
        node_free(n);
        return STATUS_NO_MEMORY;
    }
    return node_adopt(map, n);
}

enum status override_apply(struct node *root, const char *set,
                           struct fault *why)
{
    const struct place at = { .name = set, .is_set = true };
    const size_t size = strcspn(set, "=");
    struct node *n = NULL;
    char path[PATH_SIZE];

    if (set[size] != '=')
        return place_blame(at, why, "no '=', expected KEY=VALUE");
    if (strpbrk(set, "\n\r"))
        return place_blame(at, why, "a line end, expected KEY=VALUE in a line");
    snprintf(path, sizeof path, "%.*s", (int) size, set);
    const bool of_system = node_find(root, "system") != NULL;
    enum status s = of_system && strncmp(path, "window.", 7) == 0
                        ? STATUS_OK /* by the names of its states */
                    : scene_law_may_own(path) && scene_law_is_typed(root)
                        ? STATUS_OK /* perhaps a name of the law's own */
                        : schema_check_path(path, at, why);
    if (s == STATUS_OK)
        s = document_read_set(set, &n, why);
    if (s == STATUS_OK)
        s = graft(root, path, n, why);
    return s;
}
