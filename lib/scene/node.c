/* libyaml's events made into a tree.  Anchors, aliases and tags are refused:
 * a scene is plain data. */
#include "node.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <yaml.h>

enum { DEPTH_MAX = 16 };

void node_printable(const char *text, char *out, size_t size)
{
    char *end = out + size - 1;

    for (; *text && end - out > 4; text++) {
        const unsigned char c = (unsigned char) *text;
        if (c < 0x20 || c == 0x7f)
            out += sprintf(out, "\\x%02x", c);
        else
            *out++ = *text;
    }
    *out = '\0';
}

enum status node_blame(const struct node *n, struct fault *why,
                       const char *format, ...)
{
    char text[1024], where[256];
    va_list list;

    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    node_printable(n->where, where, sizeof where);
    const size_t used =
        (size_t) snprintf(why->text, sizeof why->text, "%s: ", where);
    node_printable(text, why->text + used, sizeof why->text - used);
    return STATUS_BAD_SCENE;
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
    free(n->where);
    free(n);
}

struct node *node_find(const struct node *map, const char *key)
{
    for (size_t i = 0; i < map->count; i++)
        if (map->child[i]->key && strcmp(map->child[i]->key, key) == 0)
            return map->child[i];
    return NULL;
}

void node_remove(struct node *map, const char *key)
{
    for (size_t i = 0; i < map->count; i++)
        if (map->child[i]->key && strcmp(map->child[i]->key, key) == 0) {
            node_free(map->child[i]);
            map->count--;
            memmove(map->child + i, map->child + i + 1,
                    (map->count - i) * sizeof *map->child);
            return;
        }
}

static enum status adopt(struct node *parent, struct node *child)
{
    struct node **list = realloc(parent->child,
                                 (parent->count + 1) * sizeof *parent->child);

    if (list == NULL) {
        node_free(child);
        return STATUS_NO_MEMORY;
    }
    parent->child = list;
    parent->child[parent->count++] = child;
    child->parent = parent;
    return STATUS_OK;
}

/* ---- reading ----------------------------------------------------------- */

struct reader {
    yaml_parser_t parser;
    const char *name; /* file, or the whole override */
    bool is_override; /* messages name it without a line */
    struct fault *why;
};

static char *where_of(const struct reader *r, yaml_mark_t mark)
{
    const size_t size = strlen(r->name) + 48;
    char *text = malloc(size);

    if (text && r->is_override)
        snprintf(text, size, "--set %s", r->name);
    else if (text)
        snprintf(text, size, "%s:%zu:%zu", r->name, mark.line + 1,
                 mark.column + 1);
    return text;
}

static struct node *node_new(const struct reader *r, enum node_kind kind,
                             yaml_mark_t mark)
{
    struct node *n = calloc(1, sizeof *n);

    if (n == NULL)
        return NULL;
    n->kind = kind;
    n->where = where_of(r, mark);
    if (n->where == NULL) {
        free(n);
        return NULL;
    }
    return n;
}

static enum status refuse(struct reader *r, yaml_mark_t mark, const char *text)
{
    const struct node at = { .where = where_of(r, mark) };

    if (at.where == NULL)
        return STATUS_NO_MEMORY;
    node_blame(&at, r->why, "%s", text);
    free(at.where);
    return STATUS_BAD_SCENE;
}

/* What libyaml did not like. */
static enum status syntax_error(struct reader *r)
{
    const yaml_parser_t *p = &r->parser;
    char text[300];

    if (p->error == YAML_MEMORY_ERROR)
        return STATUS_NO_MEMORY;
    if (p->error == YAML_READER_ERROR) {
        snprintf(text, sizeof text, "byte %zu (0x%02x): %s", p->problem_offset,
                 p->problem_value >= 0 ? (unsigned) p->problem_value : 0u,
                 p->problem);
        return refuse(r, p->mark, text);
    }
    snprintf(text, sizeof text, "not YAML: %s%s%s", p->problem,
             p->context ? " " : "", p->context ? p->context : "");
    return refuse(r, p->problem_mark, text);
}

static enum status next(struct reader *r, yaml_event_t *e)
{
    return yaml_parser_parse(&r->parser, e) ? STATUS_OK : syntax_error(r);
}

static enum status plain(struct reader *r, const yaml_event_t *e)
{
    const bool anchored =
        e->type == YAML_ALIAS_EVENT ||
        (e->type == YAML_SCALAR_EVENT && e->data.scalar.anchor) ||
        (e->type == YAML_SEQUENCE_START_EVENT &&
         e->data.sequence_start.anchor) ||
        (e->type == YAML_MAPPING_START_EVENT && e->data.mapping_start.anchor);

    if (anchored)
        return refuse(r, e->start_mark,
                      "anchors and aliases are not allowed in a scene");
    return STATUS_OK;
}

static enum status read_value(struct reader *r, const yaml_event_t *e,
                              int depth, struct node **out);

static enum status read_list(struct reader *r, struct node *n, int depth)
{
    for (;;) {
        yaml_event_t e;
        struct node *child = NULL;
        enum status s = next(r, &e);
        if (s != STATUS_OK)
            return s;
        if (e.type == YAML_SEQUENCE_END_EVENT) {
            yaml_event_delete(&e);
            return STATUS_OK;
        }
        s = read_value(r, &e, depth + 1, &child);
        yaml_event_delete(&e);
        if (s == STATUS_OK)
            s = adopt(n, child);
        if (s != STATUS_OK)
            return s;
    }
}

/* A key's text, its value, and both put into n. */
static enum status read_pair(struct reader *r, const yaml_event_t *key,
                             struct node *n, int depth)
{
    yaml_event_t e;
    struct node *child = NULL;
    char text[300], shown[128];

    if (key->type != YAML_SCALAR_EVENT)
        return refuse(r, key->start_mark, "a key must be a plain word");
    const char *name = (const char *) key->data.scalar.value;
    if (strlen(name) != key->data.scalar.length)
        return refuse(r, key->start_mark, "a key holds a zero byte");
    if (node_find(n, name)) {
        node_printable(name, shown, sizeof shown);
        snprintf(text, sizeof text, "key '%s' is given twice", shown);
        return refuse(r, key->start_mark, text);
    }
    enum status s = next(r, &e);
    if (s != STATUS_OK)
        return s;
    s = read_value(r, &e, depth + 1, &child);
    yaml_event_delete(&e);
    if (s != STATUS_OK)
        return s;
    free(child->where);
    child->where = where_of(r, key->start_mark);
    child->key = strdup(name);
    if (child->where == NULL || child->key == NULL) {
        node_free(child);
        return STATUS_NO_MEMORY;
    }
    return adopt(n, child);
}

static enum status read_map(struct reader *r, struct node *n, int depth)
{
    for (;;) {
        yaml_event_t e;
        enum status s = next(r, &e);
        if (s != STATUS_OK)
            return s;
        const bool end = e.type == YAML_MAPPING_END_EVENT;
        if (!end)
            s = plain(r, &e);
        if (!end && s == STATUS_OK)
            s = read_pair(r, &e, n, depth);
        yaml_event_delete(&e);
        if (end || s != STATUS_OK)
            return s;
    }
}

static enum status read_scalar(struct reader *r, const yaml_event_t *e,
                               struct node *n)
{
    const char *text = (const char *) e->data.scalar.value;

    if (strlen(text) != e->data.scalar.length)
        return refuse(r, e->start_mark, "a text holds a zero byte");
    n->text = strdup(text);
    return n->text ? STATUS_OK : STATUS_NO_MEMORY;
}

static enum status read_value(struct reader *r, const yaml_event_t *e,
                              int depth, struct node **out)
{
    const bool scalar = e->type == YAML_SCALAR_EVENT;
    const bool list = e->type == YAML_SEQUENCE_START_EVENT;
    enum status s = plain(r, e);

    if (s != STATUS_OK)
        return s;
    if (depth > DEPTH_MAX)
        return refuse(r, e->start_mark, "nested too deeply for a scene");
    struct node *n = node_new(
        r, scalar ? NODE_SCALAR : list ? NODE_LIST : NODE_MAP, e->start_mark);
    if (n == NULL)
        return STATUS_NO_MEMORY;
    s = scalar ? read_scalar(r, e, n)
        : list ? read_list(r, n, depth)
               : read_map(r, n, depth);
    if (s != STATUS_OK) {
        node_free(n);
        return s;
    }
    *out = n;
    return STATUS_OK;
}

/* The events up to the document's content; *e is the first of it. */
static enum status first_value(struct reader *r, yaml_event_t *e, bool *empty)
{
    enum status s;

    do {
        s = next(r, e);
        if (s != STATUS_OK)
            return s;
        *empty = e->type == YAML_STREAM_END_EVENT;
        if (*empty || (e->type != YAML_STREAM_START_EVENT &&
                       e->type != YAML_DOCUMENT_START_EVENT))
            return STATUS_OK;
        yaml_event_delete(e);
    } while (true);
}

/* Nothing may follow the document. */
static enum status last_event(struct reader *r)
{
    yaml_event_t e;
    enum status s = next(r, &e);

    while (s == STATUS_OK && e.type == YAML_DOCUMENT_END_EVENT) {
        yaml_event_delete(&e);
        s = next(r, &e);
    }
    if (s != STATUS_OK)
        return s;
    if (e.type != YAML_STREAM_END_EVENT)
        s = refuse(r, e.start_mark, "a scene is one YAML document, not two");
    yaml_event_delete(&e);
    return s;
}

static enum status parse(struct reader *r, const char *text, size_t size,
                         struct node **out)
{
    const yaml_mark_t top = { 0 };
    yaml_event_t e;
    bool empty = false;

    *out = NULL;
    if (!yaml_parser_initialize(&r->parser))
        return STATUS_NO_MEMORY;
    yaml_parser_set_encoding(&r->parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&r->parser, (const unsigned char *) text,
                                 size);
    enum status s = first_value(r, &e, &empty);
    if (s == STATUS_OK) {
        if (empty)
            *out = node_new(r, NODE_MAP, top);
        else
            s = read_value(r, &e, 0, out);
        yaml_event_delete(&e);
    }
    if (s == STATUS_OK && *out == NULL)
        s = STATUS_NO_MEMORY;
    if (s == STATUS_OK && !empty)
        s = last_event(r);
    yaml_parser_delete(&r->parser);
    if (s != STATUS_OK) {
        node_free(*out);
        *out = NULL;
    }
    return s;
}

enum status node_parse(const char *text, size_t size, const char *name,
                       struct node **out, struct fault *why)
{
    struct reader r = { .name = name, .why = why };
    const enum status s = parse(&r, text, size, out);

    if (s == STATUS_OK && (*out)->kind != NODE_MAP) {
        node_blame(*out, why, "a scene is a list of 'key: value', this is not");
        node_free(*out);
        *out = NULL;
        return STATUS_BAD_SCENE;
    }
    return s;
}

/* ---- overriding -------------------------------------------------------- */

/* Puts n under the dotted key below map, making maps on the way. */
static enum status graft(struct node *map, const struct reader *r,
                         const char *key, size_t length, struct node *n)
{
    const yaml_mark_t top = { 0 };
    const size_t head = strcspn(key, ".=") < length ? strcspn(key, ".=")
                                                    : length;
    char *name = strndup(key, head);

    if (name == NULL) {
        node_free(n);
        return STATUS_NO_MEMORY;
    }
    if (head == length) {
        node_remove(map, name);
        n->key = name;
        return adopt(map, n);
    }
    struct node *inner = node_find(map, name);
    if (inner && inner->kind != NODE_MAP) {
        node_remove(map, name);
        inner = NULL;
    }
    if (inner == NULL) {
        inner = node_new(r, NODE_MAP, top);
        if (inner)
            inner->key = name;
        else
            free(name);
        if (inner == NULL || adopt(map, inner) != STATUS_OK) {
            node_free(n);
            return STATUS_NO_MEMORY;
        }
    } else {
        free(name);
    }
    return graft(inner, r, key + head + 1, length - head - 1, n);
}

enum status node_override(struct node *root, const char *set,
                          struct fault *why)
{
    struct reader r = { .name = set, .is_override = true, .why = why };
    const size_t length = strcspn(set, "=");
    struct node *n;

    if (set[length] != '=' || length == 0)
        return refuse(&r, (yaml_mark_t){ 0 }, "expected KEY=VALUE");
    const enum status s =
        parse(&r, set + length + 1, strlen(set + length + 1), &n);
    if (s != STATUS_OK)
        return s;
    return graft(root, &r, set, length, n);
}
