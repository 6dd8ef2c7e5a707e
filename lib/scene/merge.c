/* The tree of the text, changed as scene_read changes it, through libyaml's
 * emitter: a line for each section, nested values in brackets. */
#include "merge.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <yaml.h>

#include "document.h"
#include "override.h"
#include "text.h"

/* ---- a tree as YAML ------------------------------------------------------ */

static bool emit(yaml_emitter_t *y, yaml_event_t *e, int made)
{
    return made && yaml_emitter_emit(y, e);
}

/* libyaml chooses quotes where the text needs them. */
static bool emit_text(yaml_emitter_t *y, char *text)
{
    yaml_event_t e;

    return emit(y, &e,
                yaml_scalar_event_initialize(&e, NULL, NULL,
                                             (yaml_char_t *) text, -1, true,
                                             true, YAML_ANY_SCALAR_STYLE));
}

/* `n` and all below it; the top as lines, the rest in brackets. */
static bool emit_node(yaml_emitter_t *y, const struct node *n, bool top)
{
    const bool list = n->kind == NODE_LIST;
    yaml_event_t e;

    if (n->kind == NODE_SCALAR)
        return emit_text(y, n->text);
    bool ok = list ? emit(y, &e,
                          yaml_sequence_start_event_initialize(
                              &e, NULL, NULL, true, YAML_FLOW_SEQUENCE_STYLE))
                   : emit(y, &e,
                          yaml_mapping_start_event_initialize(
                              &e, NULL, NULL, true,
                              top ? YAML_BLOCK_MAPPING_STYLE
                                  : YAML_FLOW_MAPPING_STYLE));
    for (size_t i = 0; i < n->count && ok; i++)
        ok = (list || emit_text(y, n->child[i]->key)) &&
             emit_node(y, n->child[i], false);
    return ok && emit(y, &e,
                      list ? yaml_sequence_end_event_initialize(&e)
                           : yaml_mapping_end_event_initialize(&e));
}

static bool emit_document(yaml_emitter_t *y, const struct node *root)
{
    yaml_event_t e;

    yaml_emitter_set_unicode(y, true);
    yaml_emitter_set_width(y, -1);
    return emit(y, &e,
                yaml_stream_start_event_initialize(&e, YAML_UTF8_ENCODING)) &&
           emit(y, &e,
                yaml_document_start_event_initialize(&e, NULL, NULL, NULL,
                                                     true)) &&
           emit_node(y, root, true) &&
           emit(y, &e, yaml_document_end_event_initialize(&e, true)) &&
           emit(y, &e, yaml_stream_end_event_initialize(&e));
}

static enum status write_tree(const struct node *root, char **text)
{
    yaml_emitter_t y;
    char *written = NULL;
    size_t size;
    FILE *out = open_memstream(&written, &size);
    bool ok = out != NULL && yaml_emitter_initialize(&y);

    if (ok) {
        yaml_emitter_set_output_file(&y, out);
        ok = emit_document(&y, root);
        yaml_emitter_delete(&y);
    }
    ok = out != NULL && fclose(out) == 0 && ok;
    if (!ok) {
        free(written);
        return STATUS_NO_MEMORY; /* all that can fail in memory */
    }
    *text = written;
    return STATUS_OK;
}

/* ---- overrides ----------------------------------------------------------- */

/* The lines are cut in place and must outlive the tree. */
static enum status apply_lines(struct node *root, char *lines,
                               struct fault *why)
{
    enum status s = STATUS_OK;
    char *line;

    while (s == STATUS_OK && (line = strsep(&lines, "\n")) != NULL)
        if (*line)
            s = override_apply(root, line, why);
    return s;
}

enum status scene_merge(const char *text, const char *overrides, char **merged,
                        struct fault *why)
{
    char *lines = text_copy(overrides, strlen(overrides)), *copy;
    struct node *root = NULL;
    enum status s = lines ? STATUS_OK : STATUS_NO_MEMORY;

    snprintf(why->text, sizeof why->text, "%s", status_text(STATUS_NO_MEMORY));
    if (s == STATUS_OK && *overrides == '\0') {
        copy = text_copy(text, strlen(text));
        s = copy ? STATUS_OK : STATUS_NO_MEMORY;
    } else if (s == STATUS_OK) {
        s = document_read(text, strlen(text), "scene", &root, why);
        if (s == STATUS_OK)
            s = apply_lines(root, lines, why);
        if (s == STATUS_OK)
            s = write_tree(root, &copy);
    }
    node_free(root);
    free(lines);
    if (s == STATUS_OK)
        *merged = copy;
    return s;
}
