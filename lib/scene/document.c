/* The events of libyaml (YAML 1.1) made into a tree, one function for each
 * thing that may stand at a place. */
#include "document.h"

#include <stdio.h>
#include <string.h>

#include <yaml.h>

#include "text.h"
#include "tolerance.h"

struct reader {
    yaml_parser_t parser;
    const char *text; /* what the parser was given, */
    size_t skipped;   /* after so many bytes: a byte order mark */
    struct place top; /* name and is_set of all places */
    struct fault *why;
};

static struct place place_at(const struct reader *r, yaml_mark_t mark)
{
    struct place at = r->top;

    if (at.name && !at.is_set) {
        at.line = mark.line + 1;
        at.column = mark.column + 1;
    }
    return at;
}

/* ---- what libyaml did not like ------------------------------------------- */

/* Where byte number `offset` stands; columns count characters. */
static yaml_mark_t mark_of_byte(const char *text, size_t offset)
{
    yaml_mark_t mark = { .index = offset };

    for (size_t i = 0; i < offset; i++) {
        const unsigned char c = (unsigned char) text[i];
        if (c == '\n' || (c == '\r' && text[i + 1] != '\n')) {
            mark.line++;
            mark.column = 0;
        } else if (c != '\r' && c >> 6 != 0x02) {
            mark.column++;
        }
    }
    return mark;
}

static enum status wrong_byte(const struct reader *r)
{
    const size_t offset = r->parser.problem_offset;
    const struct place at = place_at(r, mark_of_byte(r->text, offset));

    return place_blame(at, r->why,
                       "byte 0x%02x at offset %zu of the %s: %s, expected "
                       "text in UTF-8",
                       (unsigned char) r->text[offset], r->skipped + offset,
                       at.is_set ? "value" : "file", r->parser.problem);
}

static enum status wrong_syntax(const struct reader *r)
{
    const yaml_parser_t *p = &r->parser;
    const struct place at = place_at(r, p->problem_mark);
    const struct place from = place_at(r, p->context_mark);
    char since[40] = "";

    if (p->context && from.line != at.line)
        snprintf(since, sizeof since, " that begins in line %zu", from.line);
    return place_blame(at, r->why,
                       "%s%s%s%s, expected YAML: 'key: value', indented by "
                       "spaces, brackets and quotes closed",
                       p->problem, p->context ? " " : "",
                       p->context ? p->context : "", since);
}

/* The next event, which yaml_event_delete must free. */
static enum status next_event(struct reader *r, yaml_event_t *e)
{
    if (yaml_parser_parse(&r->parser, e))
        return STATUS_OK;
    switch (r->parser.error) {
        case YAML_MEMORY_ERROR:
            return STATUS_NO_MEMORY;
        case YAML_READER_ERROR:
            return wrong_byte(r);
        default:
            return wrong_syntax(r);
    }
}

/* ---- values -------------------------------------------------------------- */

static enum status check_plain(const struct reader *r, const yaml_event_t *e)
{
    const void *anchor = NULL, *tag = NULL;

    if (e->type == YAML_SCALAR_EVENT) {
        anchor = e->data.scalar.anchor;
        tag = e->data.scalar.tag;
    } else if (e->type == YAML_SEQUENCE_START_EVENT) {
        anchor = e->data.sequence_start.anchor;
        tag = e->data.sequence_start.tag;
    } else if (e->type == YAML_MAPPING_START_EVENT) {
        anchor = e->data.mapping_start.anchor;
        tag = e->data.mapping_start.tag;
    }
    if (!anchor && !tag && e->type != YAML_ALIAS_EVENT)
        return STATUS_OK;
    return place_blame(place_at(r, e->start_mark), r->why,
                       "anchors, aliases and tags are not allowed, expected a "
                       "value written out");
}

static enum status read_value(struct reader *r, const yaml_event_t *e,
                              size_t depth, struct node **out);

static enum status read_scalar(const struct reader *r, const yaml_event_t *e,
                               struct node *n)
{
    const char *text = (const char *) e->data.scalar.value;

    if (strlen(text) != e->data.scalar.length)
        return place_blame(n->at, r->why,
                           "a zero byte is not allowed in a text");
    n->text = text_copy(text, e->data.scalar.length);
    return n->text ? STATUS_OK : STATUS_NO_MEMORY;
}

static enum status check_key(const struct reader *r, const yaml_event_t *key,
                             const struct node *map)
{
    const struct place at = place_at(r, key->start_mark);
    const enum status s = check_plain(r, key);

    if (s != STATUS_OK)
        return s;
    if (key->type != YAML_SCALAR_EVENT)
        return place_blame(at, r->why,
                           "this key is no word, expected 'key: value'");
    const char *word = (const char *) key->data.scalar.value;
    if (strlen(word) != key->data.scalar.length)
        return place_blame(at, r->why, "a zero byte is not allowed in a key");
    if (node_find(map, word))
        return place_blame(at, r->why,
                           "key '%s' is given twice, expected it once",
                           text_shown(word).text);
    if (map->count == SCENE_KEYS)
        return place_blame(at, r->why, "more than %d keys, expected a scene",
                           SCENE_KEYS);
    return STATUS_OK;
}

/* The value that follows `key`, put into the map. */
static enum status read_pair(struct reader *r, const yaml_event_t *key,
                             struct node *map, size_t depth)
{
    yaml_event_t e;
    struct node *child = NULL;
    enum status s = check_key(r, key, map);

    if (s == STATUS_OK)
        s = next_event(r, &e);
    if (s != STATUS_OK)
        return s;
    s = read_value(r, &e, depth + 1, &child);
    yaml_event_delete(&e);
    if (s == STATUS_OK)
        s = node_set_key(child, (const char *) key->data.scalar.value,
                         key->data.scalar.length, place_at(r, key->start_mark));
    if (s != STATUS_OK) {
        node_free(child);
        return s;
    }
    return node_adopt(map, child);
}

static enum status read_item(struct reader *r, const yaml_event_t *e,
                             struct node *list, size_t depth)
{
    struct node *child = NULL;
    const enum status s = read_value(r, e, depth + 1, &child);

    return s == STATUS_OK ? node_adopt(list, child) : s;
}

static enum status read_children(struct reader *r, struct node *n, size_t depth)
{
    for (;;) {
        yaml_event_t e;
        enum status s = next_event(r, &e);
        if (s != STATUS_OK)
            return s;
        const bool end = e.type == YAML_MAPPING_END_EVENT ||
                         e.type == YAML_SEQUENCE_END_EVENT;
        if (!end)
            s = n->kind == NODE_MAP ? read_pair(r, &e, n, depth)
                                    : read_item(r, &e, n, depth);
        yaml_event_delete(&e);
        if (end || s != STATUS_OK)
            return s;
    }
}

/* The value that begins with e, which stays the caller's. */
static enum status read_value(struct reader *r, const yaml_event_t *e,
                              size_t depth, struct node **out)
{
    const struct place at = place_at(r, e->start_mark);
    const enum node_kind kind = e->type == YAML_SCALAR_EVENT ? NODE_SCALAR
                                : e->type == YAML_SEQUENCE_START_EVENT
                                    ? NODE_LIST
                                    : NODE_MAP;
    enum status s = check_plain(r, e);

    if (s != STATUS_OK)
        return s;
    if (depth > SCENE_DEPTH)
        return place_blame(at, r->why,
                           "nested more than %d deep, expected a scene",
                           SCENE_DEPTH);
    struct node *n = node_new(kind, at);
    if (n == NULL)
        return STATUS_NO_MEMORY;
    s = kind == NODE_SCALAR ? read_scalar(r, e, n) : read_children(r, n, depth);
    if (s != STATUS_OK)
        node_free(n);
    else
        *out = n;
    return s;
}

/* ---- documents ----------------------------------------------------------- */

/* The first event of the content; YAML_STREAM_END_EVENT where there is none. */
static enum status skip_to_content(struct reader *r, yaml_event_t *e)
{
    enum status s = next_event(r, e);

    while (s == STATUS_OK && (e->type == YAML_STREAM_START_EVENT ||
                              e->type == YAML_DOCUMENT_START_EVENT)) {
        yaml_event_delete(e);
        s = next_event(r, e);
    }
    return s;
}

/* Nothing may follow the document. */
static enum status read_end(struct reader *r)
{
    yaml_event_t e;
    enum status s = next_event(r, &e);

    if (s == STATUS_OK && e.type == YAML_DOCUMENT_END_EVENT) {
        yaml_event_delete(&e);
        s = next_event(r, &e);
    }
    if (s != STATUS_OK)
        return s;
    if (e.type != YAML_STREAM_END_EVENT)
        s = place_blame(place_at(r, e.start_mark), r->why,
                        "a second document, expected one");
    yaml_event_delete(&e);
    return s;
}

/* An empty document is an empty text. */
static enum status read_content(struct reader *r, struct node **out)
{
    yaml_event_t e;
    struct node *n = NULL;
    enum status s = skip_to_content(r, &e);

    if (s != STATUS_OK)
        return s;
    const bool empty = e.type == YAML_STREAM_END_EVENT;
    if (empty) {
        n = node_new(NODE_SCALAR, place_at(r, (yaml_mark_t){ 0 }));
        s = n && (n->text = text_copy("", 0)) ? STATUS_OK : STATUS_NO_MEMORY;
    } else {
        s = read_value(r, &e, 0, &n);
    }
    yaml_event_delete(&e);
    if (s == STATUS_OK && !empty)
        s = read_end(r);
    if (s != STATUS_OK)
        node_free(n);
    else
        *out = n;
    return s;
}

static enum status read_text(const char *text, size_t size, struct place top,
                             struct node **out, struct fault *why)
{
    const size_t skipped = strncmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    struct reader r = {
        .text = text + skipped, .skipped = skipped, .top = top, .why = why
    };

    if (!yaml_parser_initialize(&r.parser))
        return STATUS_NO_MEMORY;
    /* Else bytes that begin like UTF-16 would be read as such. */
    yaml_parser_set_encoding(&r.parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&r.parser, (const unsigned char *) r.text,
                                 size - skipped);
    const enum status s = read_content(&r, out);
    yaml_parser_delete(&r.parser);
    return s;
}

enum status document_read(const char *text, size_t size, const char *name,
                          struct node **out, struct fault *why)
{
    struct node *n = NULL;
    enum status s =
        read_text(text, size, (struct place){ .name = name }, &n, why);

    if (s != STATUS_OK)
        return s;
    if (n->kind != NODE_MAP && !node_is_nothing(n)) {
        s = place_blame(n->at, why, "%s, expected lines 'key: value'",
                        n->kind == NODE_LIST ? "a list" : "a lonely text");
        node_free(n);
        return s;
    }
    n->kind = NODE_MAP;
    *out = n;
    return STATUS_OK;
}

enum status document_read_set(const char *set, struct node **out,
                              struct fault *why)
{
    const char *value = strchr(set, '=') + 1;

    return read_text(value, strlen(value),
                     (struct place){ .name = set, .is_set = true }, out, why);
}
