/* YAML made into trees that remember where things stand. */
#include "document.h"

#include <string.h>

#include "check.h"
#include "fault_alloc.h"
#include "tolerance.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

static struct node *read_bytes(const char *text, size_t size)
{
    struct node *root = NULL;
    struct fault why;
    const enum status s = document_read(text, size, "s.yaml", &root, &why);

    CHECK(s == STATUS_OK, "%s", why.text);
    return root;
}

static struct node *read(const char *text)
{
    return read_bytes(text, strlen(text));
}

/* ---- trees --------------------------------------------------------------- */

/* "line:column text" of a scalar at a path. */
static void stands_at(const struct node *root, const char *path, size_t line,
                      size_t column, const char *text)
{
    const struct node *n = node_at(root, path);

    CHECK(n && n->kind == NODE_SCALAR, "%s", path);
    CHECK(strcmp(n->text, text) == 0, "%s: %s", path, n->text);
    CHECK(n->at.line == line && n->at.column == column, "%s: %zu:%zu", path,
          n->at.line, n->at.column);
}

static void values_and_keys_know_their_places(void **state)
{
    struct node *root = read("# comment\n"
                             "title: A slope\n"
                             "law: {preset: ruina,\n"
                             "      friction: \"log\"}\n"
                             "window:\n"
                             "  v:\n"
                             "    - 1\n"
                             "    - 1e3\n");

    (void) state;
    assert_int_equal(root->kind, NODE_MAP);
    assert_int_equal(root->count, 3);
    stands_at(root, "title", 2, 8, "A slope");
    stands_at(root, "law.preset", 3, 15, "ruina");
    stands_at(root, "law.friction", 4, 17, "log");
    const struct node *v = node_at(root, "window.v");
    assert_int_equal(v->kind, NODE_LIST);
    assert_int_equal(v->count, 2);
    assert_string_equal(v->child[1]->text, "1e3");
    assert_int_equal(v->child[1]->at.line, 8);
    assert_int_equal(v->child[1]->at.column, 7);
    assert_null(v->child[1]->key);
    assert_int_equal(v->key_at.line, 6);
    assert_int_equal(v->key_at.column, 3);
    assert_string_equal(v->key_at.name, "s.yaml");
    node_free(root);
}

static void columns_count_characters_and_not_bytes(void **state)
{
    struct node *root = read("title: {\xc3\xa9\xe2\x82\xac: x, b: y}\n");

    (void) state;
    stands_at(root, "title.b", 1, 19, "y");
    node_free(root);
}

static void line_ends_and_a_byte_order_mark_do_not_matter(void **state)
{
    static const char *const text[] = { "a: 1\nb: 2\n", "a: 1\r\nb: 2\r\n",
                                        "a: 1\rb: 2\r", "a: 1\nb: 2",
                                        "\357\273\277a: 1\nb: 2\n" };

    (void) state;
    for (size_t i = 0; i < COUNT(text); i++) {
        struct node *root = read(text[i]);
        stands_at(root, "a", 1, 4, "1");
        stands_at(root, "b", 2, 4, "2");
        assert_int_equal(root->count, 2);
        node_free(root);
    }
}

static void marks_around_the_one_document_are_allowed(void **state)
{
    struct node *root = read("%YAML 1.1\n---\na: 1\n...\n");

    (void) state;
    stands_at(root, "a", 3, 4, "1");
    node_free(root);
}

static void an_empty_document_is_an_empty_map(void **state)
{
    static const char *const text[] = {
        "",           "\n", "# only this\n", "---\n",
        "---\n...\n", "{}", "\xef\xbb\xbf",  "\"\""
    };

    (void) state;
    for (size_t i = 0; i < COUNT(text); i++) {
        struct node *root = read(text[i]);
        assert_int_equal(root->kind, NODE_MAP);
        assert_int_equal(root->count, 0);
        node_free(root);
    }
}

static void nothing_behind_a_key_is_an_empty_text(void **state)
{
    struct node *root = read("a:\nb: ''\nc: {d: }\n");

    (void) state;
    assert_true(node_is_nothing(node_at(root, "a")));
    assert_true(node_is_nothing(node_at(root, "b")));
    assert_true(node_is_nothing(node_at(root, "c.d")));
    assert_false(node_is_nothing(node_at(root, "c")));
    node_free(root);
}

static void the_value_of_an_override_is_of_any_kind(void **state)
{
    static const struct {
        const char *set;
        enum node_kind kind;
        size_t count;
    } wanted[] = {
        { "a=", NODE_SCALAR, 0 },         { "a=x=y", NODE_SCALAR, 0 },
        { "a=[1, 2]", NODE_LIST, 2 },     { "a={b: 1}", NODE_MAP, 1 },
        { "a=b: 1", NODE_MAP, 1 },        { "a=[]", NODE_LIST, 0 },
        { "a=# comment", NODE_SCALAR, 0 }
    };

    (void) state;
    for (size_t i = 0; i < COUNT(wanted); i++) {
        struct node *n = NULL;
        struct fault why;
        assert_int_equal(document_read_set(wanted[i].set, &n, &why), STATUS_OK);
        assert_int_equal(n->kind, wanted[i].kind);
        assert_int_equal(n->count, wanted[i].count);
        assert_true(n->at.is_set);
        assert_int_equal(n->at.line, 0);
        assert_string_equal(n->at.name, wanted[i].set);
        node_free(n);
    }
}

static void children_are_found_and_removed(void **state)
{
    struct node *root = read("a: 1\nb: {c: {d: 2}}\ne: 3\nf: 4\n");

    (void) state;
    assert_null(node_find(root, "c"));
    assert_null(node_find(NULL, "a"));
    assert_null(node_at(root, "b.c.x"));
    assert_null(node_at(root, "a.b"));
    assert_ptr_equal(node_at(root, ""), root);
    assert_string_equal(node_at(root, "b.c.d")->text, "2");
    node_remove(root, 1);
    assert_null(node_find(root, "b"));
    assert_int_equal(root->count, 3);
    assert_string_equal(root->child[1]->key, "e");
    struct node *g = node_new(NODE_SCALAR, root->at);
    assert_int_equal(node_set_key(g, "gh", 1, root->at), STATUS_OK);
    for (int i = 0; i < 3; i++)
        node_remove(root, 0);
    assert_int_equal(node_adopt(root, g), STATUS_OK);
    assert_ptr_equal(node_find(root, "g"), g);
    node_free(root);
    node_free(NULL);
}

/* ---- what is no scene ---------------------------------------------------- */

static char untouched;

/* Refused with exactly the line "s.yaml:" and this. */
static void refused_bytes(const char *text, size_t size, const char *line)
{
    struct node *root = (struct node *) (void *) &untouched;
    struct fault why;
    char wanted[512];

    snprintf(wanted, sizeof wanted, "s.yaml:%s", line);
    assert_int_equal(document_read(text, size, "s.yaml", &root, &why),
                     STATUS_BAD_SCENE);
    assert_string_equal(why.text, wanted);
    assert_ptr_equal(root, &untouched);
}

static void refused(const char *text, const char *line)
{
    refused_bytes(text, strlen(text), line);
}

static void a_scene_is_a_map(void **state)
{
    (void) state;
    refused("- law\n- slope\n", "1:1: a list, expected lines 'key: value'");
    refused("law\n", "1:1: a lonely text, expected lines 'key: value'");
    refused("\n 'law: x'\n", "2:2: a lonely text, expected lines 'key: value'");
    refused("null\n", "1:1: a lonely text, expected lines 'key: value'");
}

static void keys_are_words_given_once(void **state)
{
    (void) state;
    refused("a: 1\nb: 2\n\"a\": 3\n",
            "3:1: key 'a' is given twice, expected it once");
    refused("a: {b: 1, c: 2, b: 1}\n",
            "1:17: key 'b' is given twice, expected it once");
    refused("? [a, b]\n: x\n",
            "1:3: this key is no word, expected 'key: value'");
    refused("? {a: b}\n: x\n",
            "1:3: this key is no word, expected 'key: value'");
    refused("a: 1\n\"b\\0\": x\n", "2:1: a zero byte is not allowed in a key");
}

static void anchors_aliases_and_tags_are_refused(void **state)
{
    static const char line[] = "2:4: anchors, aliases and tags are not "
                               "allowed, expected a value written out";

    (void) state;
    refused("a: 1\nb: &x 1\n", line);
    refused("a: 1\nb: *x\n", line);
    refused("a: 1\nb: !!str 1\n", line);
    refused("a: 1\nb: !mine 1\n", line);
    refused("a: 1\nb: &x {}\n", line);
    refused("a: 1\nb: !!seq [1]\n", line);
    refused("\n   &x b: 1\n", line);
}

static void one_document_is_enough(void **state)
{
    (void) state;
    refused("a: 1\n---\nb: 1\n", "2:1: a second document, expected one");
    refused("a: 1\n--- x\n", "2:1: a second document, expected one");
    refused("a: 1\n...\n---\n", "3:1: a second document, expected one");
}

#define YAML                                                                   \
    ", expected YAML: 'key: value', indented by spaces, brackets and quotes "  \
    "closed"

static void tabs_do_not_indent(void **state)
{
    (void) state;
    refused("a: 1\n\tb: 1\n",
            "2:1: found a tab character that violates indentation while "
            "scanning a plain scalar that begins in line 1" YAML);
    refused("a:\n\tb: 1\n",
            "2:1: found character that cannot start any token while scanning "
            "for the next token" YAML);
}

static void what_libyaml_cannot_read_is_refused_where_it_stopped(void **state)
{
    (void) state;
    refused("a: 1\nb: \"open\n\n",
            "4:1: found unexpected end of stream while scanning a quoted "
            "scalar that begins in line 2" YAML);
    refused("a: {b: 1\nc: 2\n",
            "2:2: did not find expected ',' or '}' while parsing a flow "
            "mapping that begins in line 1" YAML);
    refused("a: [1, 2\n",
            "2:1: did not find expected ',' or ']' while parsing a flow "
            "sequence that begins in line 1" YAML);
    refused("a: {b: 1}}\n",
            "1:10: did not find expected key while parsing a block "
            "mapping" YAML);
    refused("a: b: c\n",
            "1:5: mapping values are not allowed in this context" YAML);
    refused("a: 1\n b: 1\n",
            "2:3: mapping values are not allowed in this context" YAML);
    refused("a: @x\n", "1:4: found character that cannot start any token "
                       "while scanning for the next token" YAML);
    refused("a: \"\\z\"\n", "1:5: found unknown escape character while "
                            "parsing a quoted scalar" YAML);
    refused("a: 1\nb\n", "3:1: could not find expected ':' while scanning a "
                         "simple key that begins in line 2" YAML);
    refused("%YAML 2.0\n---\na: 1\n",
            "1:1: found incompatible YAML document" YAML);
    refused("a: 1\n...\nb: 1\n",
            "3:1: did not find expected <document start>" YAML);
}

#define UTF8 ", expected text in UTF-8"

static void bytes_that_are_no_text_are_named(void **state)
{
    (void) state;
    refused("a: 1\nb: \xff\n", "2:4: byte 0xff at offset 8 of the file: "
                               "invalid leading UTF-8 octet" UTF8);
    refused("a: \"\xc3\"\n", "1:6: byte 0x22 at offset 5 of the file: invalid "
                             "trailing UTF-8 octet" UTF8);
    refused("a: \xc3", "1:4: byte 0xc3 at offset 3 of the file: incomplete "
                       "UTF-8 octet sequence" UTF8);
    refused("a: \xc3\xa9\xed\xa0\x80\n",
            "1:5: byte 0xed at offset 5 of the file: invalid Unicode "
            "character" UTF8);
    refused("a: \xc0\xaf\n", "1:4: byte 0xc0 at offset 3 of the file: invalid "
                             "length of a UTF-8 sequence" UTF8);
    refused("\xef\xbb\xbf# \x1b[31m\n",
            "1:3: byte 0x1b at offset 5 of the file: control characters are "
            "not allowed" UTF8);
    refused("a\r\nb\rc\n\x7f", "4:1: byte 0x7f at offset 7 of the file: "
                               "control characters are not allowed" UTF8);
    refused_bytes("a: b\0c\n", 7,
                  "1:5: byte 0x00 at offset 4 of the file: control characters "
                  "are not allowed" UTF8);
    refused("a: \"b\\0c\"\n", "1:4: a zero byte is not allowed in a text");
}

/* With and without a byte order mark, of either order. */
static void utf16_is_refused_at_its_first_byte(void **state)
{
    (void) state;
    refused_bytes("\xff\xfe"
                  "a\0:\0 \0b\0",
                  10,
                  "1:1: byte 0xff at offset 0 of the file: invalid leading "
                  "UTF-8 octet" UTF8);
    refused_bytes("\xfe\xff\0a\0:\0 \0b", 10,
                  "1:1: byte 0xfe at offset 0 of the file: invalid leading "
                  "UTF-8 octet" UTF8);
    refused_bytes("\0a\0:\0 \0b", 8,
                  "1:1: byte 0x00 at offset 0 of the file: control characters "
                  "are not allowed" UTF8);
    refused_bytes("a\0:\0 \0b\0", 8,
                  "1:2: byte 0x00 at offset 1 of the file: control characters "
                  "are not allowed" UTF8);
}

/* ---- bounds -------------------------------------------------------------- */

static void nesting_ends_at_16(void **state)
{
    char text[2 * SCENE_DEPTH + 8];

    (void) state;
    memset(text, '\0', sizeof text);
    memcpy(text, "a: ", 3);
    memset(text + 3, '[', SCENE_DEPTH);
    memset(text + 3 + SCENE_DEPTH, ']', SCENE_DEPTH);
    node_free(read(text));
    memset(text + 3, '[', SCENE_DEPTH + 1);
    memset(text + 4 + SCENE_DEPTH, ']', SCENE_DEPTH + 1);
    refused(text, "1:20: nested more than 16 deep, expected a scene");
}

static void a_mebibyte_of_brackets_is_refused_at_once(void **state)
{
    char *text = malloc(SCENE_BYTES + 1);

    (void) state;
    memset(text, '[', SCENE_BYTES);
    text[SCENE_BYTES] = '\0';
    refused(text, "1:18: nested more than 16 deep, expected a scene");
    memset(text, '{', SCENE_BYTES);
    refused(text, "1:2: this key is no word, expected 'key: value'");
    free(text);
}

static void a_map_has_at_most_64_keys(void **state)
{
    char text[SCENE_KEYS * 8 + 16];
    size_t n = 0;

    (void) state;
    for (int i = 0; i < SCENE_KEYS; i++)
        n += (size_t) snprintf(text + n, sizeof text - n, "k%d: 1\n", i);
    node_free(read(text));
    snprintf(text + n, sizeof text - n, "k: 1\n");
    refused(text, "65:1: more than 64 keys, expected a scene");
}

/* ---- memory -------------------------------------------------------------- */

/* Of ours it takes two: a node and its text. */
static void libyamls_allocations_are_among_those_that_fail(void **state)
{
    (void) state;
    fault_alloc_at(FAULT_ALLOC_NEVER);
    node_free(read(""));
    CHECK(fault_alloc_count() > 8, "%ld", fault_alloc_count());
}

static const char everything[] =
    "%YAML 1.1\n---\n# all kinds of things\n"
    "title: \"quoted\\n \xe2\x82\xac\"\ntext: |\n  lines\n  of text\n"
    "list: [1, {a: b}, [c]]\nblock:\n  - x\n  - y: z\n? key\n: 'it''s'\n...\n";

static void each_allocation_may_fail(void **state)
{
    enum status s = STATUS_NO_MEMORY;

    (void) state;
    for (long k = 0; s != STATUS_OK; k++) {
        struct node *root = (struct node *) (void *) &untouched;
        struct fault why;
        fault_alloc_at(k);
        s = document_read(everything, strlen(everything), "s.yaml", &root,
                          &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        if (s == STATUS_OK) {
            node_free(root);
            continue;
        }
        assert_int_equal(s, STATUS_NO_MEMORY);
        assert_ptr_equal(root, &untouched);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_and_keys_know_their_places),
        cmocka_unit_test(columns_count_characters_and_not_bytes),
        cmocka_unit_test(line_ends_and_a_byte_order_mark_do_not_matter),
        cmocka_unit_test(marks_around_the_one_document_are_allowed),
        cmocka_unit_test(an_empty_document_is_an_empty_map),
        cmocka_unit_test(nothing_behind_a_key_is_an_empty_text),
        cmocka_unit_test(the_value_of_an_override_is_of_any_kind),
        cmocka_unit_test(children_are_found_and_removed),
        cmocka_unit_test(a_scene_is_a_map),
        cmocka_unit_test(keys_are_words_given_once),
        cmocka_unit_test(anchors_aliases_and_tags_are_refused),
        cmocka_unit_test(one_document_is_enough),
        cmocka_unit_test(tabs_do_not_indent),
        cmocka_unit_test(what_libyaml_cannot_read_is_refused_where_it_stopped),
        cmocka_unit_test(bytes_that_are_no_text_are_named),
        cmocka_unit_test(utf16_is_refused_at_its_first_byte),
        cmocka_unit_test(nesting_ends_at_16),
        cmocka_unit_test(a_mebibyte_of_brackets_is_refused_at_once),
        cmocka_unit_test(a_map_has_at_most_64_keys),
        cmocka_unit_test(libyamls_allocations_are_among_those_that_fail),
        cmocka_unit_test(each_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
