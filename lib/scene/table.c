/* The text is read once and cut up where it stands: quotes are taken out and
 * separators become zeros in the table's own copy. */
#include "table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "room.h"
#include "text_file.h"
#include "tolerance.h"

struct reader {
    struct table *t;
    char *at; /* next byte; the text ends in a zero at `end` */
    const char *end;
    const char *start; /* of this line */
    uint32_t line;
    size_t cells, room; /* of all the table */
    size_t count;       /* of this record */
    struct fault *why;
};

/* ---- places and messages ------------------------------------------------- */

struct place table_place(const struct table *t, const struct table_cell *cell)
{
    return (struct place){ .name = t->name,
                           .line = cell->line,
                           .column = cell->column };
}

static struct table_cell here(const struct reader *r, const char *at)
{
    return (struct table_cell){ "", r->line, (uint32_t) (at - r->start) + 1 };
}

static enum status blame(const struct reader *r, struct table_cell cell,
                         const char *text)
{
    return place_blame(table_place(r->t, &cell), r->why, "%s", text);
}

/* ---- cells --------------------------------------------------------------- */

static enum status push(struct reader *r, struct table_cell cell)
{
    if (ROOM_FOR(r->t->cell, r->room, r->cells + 1))
        return STATUS_NO_MEMORY;
    r->t->cell[r->cells++] = cell;
    r->count++;
    return STATUS_OK;
}

/* Control characters are no text: a binary file, or one in UTF-16. */
static enum status check_byte(const struct reader *r)
{
    const unsigned char byte = (unsigned char) *r->at;
    char text[64];

    if (byte >= 0x20 ? byte != 0x7f : byte == '\t' || byte == '\n')
        return STATUS_OK;
    snprintf(text, sizeof text, "byte 0x%02x is no text, expected CSV", byte);
    return blame(r, here(r, r->at), text);
}

static bool ends_line(const struct reader *r)
{
    return r->at == r->end || r->at[0] == '\n' ||
           (r->at[0] == '\r' && r->at[1] == '\n');
}

/* Past a line's end, if there is one here. */
static void skip_line_end(struct reader *r)
{
    if (r->at == r->end)
        return;
    r->at += r->at[0] == '\r' ? 2 : 1;
    r->line++;
    r->start = r->at;
}

/* From behind the opening quote to behind the closing one; *to ends the
 * text. */
static enum status read_quoted(struct reader *r, struct table_cell cell,
                               char **to)
{
    while (r->at < r->end && (*r->at != '"' || r->at[1] == '"')) {
        const bool line_end = ends_line(r);
        if (*r->at == '"')
            r->at++;
        if (line_end && *r->at == '\r')
            r->at++;
        const enum status s = check_byte(r);
        if (s != STATUS_OK)
            return s;
        *(*to)++ = *r->at++;
        if (line_end) {
            r->line++;
            r->start = r->at;
        }
    }
    if (r->at == r->end)
        return blame(r, cell, "a quote that is never closed");
    r->at++;
    if (!ends_line(r) && *r->at != ',')
        return blame(r, here(r, r->at), "text behind a closing quote");
    return STATUS_OK;
}

static enum status read_plain(struct reader *r, char **to)
{
    for (; !ends_line(r) && *r->at != ','; r->at++) {
        const enum status s = check_byte(r);
        if (s != STATUS_OK)
            return s;
        if (*r->at == '"')
            return blame(r, here(r, r->at), "a quote inside a cell");
    }
    *to = r->at;
    while (*to > r->start && ((*to)[-1] == ' ' || (*to)[-1] == '\t'))
        --*to;
    return STATUS_OK;
}

static void skip_blanks(struct reader *r)
{
    while (*r->at == ' ' || *r->at == '\t')
        r->at++;
}

/* One cell; *more: a comma follows, which is passed. */
static enum status read_cell(struct reader *r, bool *more)
{
    enum status s;

    if (*r->at != '"')
        skip_blanks(r);
    struct table_cell cell = here(r, r->at);
    const bool quoted = *r->at == '"';
    r->at += quoted;
    char *text = r->at, *to = r->at;
    cell.text = text;
    s = quoted ? read_quoted(r, cell, &to) : read_plain(r, &to);
    if (s != STATUS_OK)
        return s;
    if (to < text)
        to = text;
    if ((size_t) (to - text) > TABLE_CELL)
        return blame(r, cell, "a cell of more than 4096 bytes");
    if (r->count == (r->t->columns ? r->t->columns : TABLE_COLUMNS))
        return blame(r, cell,
                     r->t->columns ? "more cells than the header has"
                                   : "more than 1024 columns");
    *more = *r->at == ',' && r->at < r->end;
    if (*more)
        r->at++;
    else
        skip_line_end(r);
    *to = '\0';
    return push(r, cell);
}

/* ---- records ------------------------------------------------------------- */

static enum status read_record(struct reader *r)
{
    enum status s = STATUS_OK;
    bool more = true;
    const struct table_cell first = here(r, r->at);

    r->count = 0;
    while (more && s == STATUS_OK)
        s = read_cell(r, &more);
    if (s == STATUS_OK && r->t->columns && r->count < r->t->columns)
        s = place_blame((struct place){ .name = r->t->name,
                                        .line = first.line,
                                        .column = first.column },
                        r->why, "%zu cells, the header has %zu", r->count,
                        r->t->columns);
    return s;
}

static bool skips(struct reader *r)
{
    const char *p = r->at;

    while (*p == ' ' || *p == '\t')
        p++;
    const bool blank =
        p == r->end || *p == '\n' || (p[0] == '\r' && p[1] == '\n');
    if (!blank && *r->at != '#')
        return false;
    while (!ends_line(r))
        r->at++;
    skip_line_end(r);
    return true;
}

static enum status check_names(const struct reader *r)
{
    const struct table *t = r->t;

    for (size_t i = 0; i < t->columns; i++) {
        const struct table_cell *cell = &t->cell[i];
        if (cell->text[0] == '\0')
            return blame(r, *cell, "a column without a name");
        for (size_t j = 0; j < i; j++)
            if (strcmp(t->cell[j].text, cell->text) == 0)
                return place_blame(table_place(t, cell), r->why,
                                   "two columns are named '%s'",
                                   text_shown(cell->text).text);
    }
    return STATUS_OK;
}

static enum status read_all(struct reader *r)
{
    static const char mark[] = "\xef\xbb\xbf";
    enum status s = STATUS_OK;

    if (strncmp(r->at, mark, 3) == 0)
        r->start = r->at += 3;
    while (r->at < r->end && s == STATUS_OK) {
        if (skips(r))
            continue;
        s = read_record(r);
        if (s == STATUS_OK && r->t->columns == 0) {
            r->t->columns = r->count;
            s = check_names(r);
        }
    }
    if (s != STATUS_OK)
        return s;
    if (r->t->columns == 0)
        return blame(r, here(r, r->at), "no header, expected names of columns");
    r->t->rows = r->cells / r->t->columns - 1;
    if (r->t->rows == 0)
        return blame(r, here(r, r->at), "no rows below the header");
    return STATUS_OK;
}

/* ---- the file ------------------------------------------------------------ */

/* Takes over text[0 .. size], the last of them zero. */
static enum status cut_up(struct table *t, char *text, size_t size,
                          const char *name, struct fault *why)
{
    struct reader r = { .t = t,
                        .at = text,
                        .end = text + size,
                        .start = text,
                        .line = 1,
                        .why = why };

    *t = (struct table){ .name = name, .bytes = text };
    const enum status s = read_all(&r);
    if (s != STATUS_OK)
        table_free(t);
    return s;
}

enum status table_parse(struct table *t, const char *bytes, size_t size,
                        const char *name, struct fault *why)
{
    char *text = text_copy(bytes, size);

    *t = (struct table){ .name = name };
    snprintf(why->text, sizeof why->text, "%s", status_text(STATUS_NO_MEMORY));
    return text ? cut_up(t, text, size, name, why) : STATUS_NO_MEMORY;
}

static enum status too_long(const char *path, struct fault *why)
{
    char shown[300];

    text_show_end(path, shown, sizeof shown);
    return fault_set(why, STATUS_IO, "%s: cannot read: more than 64 MiB",
                     shown);
}

enum status table_read(struct table *t, const char *path, struct fault *why)
{
    char *text;
    size_t size;

    *t = (struct table){ .name = path };
    snprintf(why->text, sizeof why->text, "%s", status_text(STATUS_NO_MEMORY));
    enum status s = text_file_read(path, TABLE_BYTES, &text, &size, why);
    if (s == STATUS_OK && size > TABLE_BYTES)
        s = too_long(path, why);
    if (s == STATUS_OK)
        return cut_up(t, text, size, path, why);
    free(text);
    return s;
}

void table_free(struct table *t)
{
    free(t->bytes);
    free(t->cell);
    *t = (struct table){ .name = t->name };
}

/* ---- looking up ---------------------------------------------------------- */

const struct table_cell *table_header(const struct table *t, size_t column)
{
    return &t->cell[column];
}

const struct table_cell *table_at(const struct table *t, size_t row,
                                  size_t column)
{
    return &t->cell[(row + 1) * t->columns + column];
}

const struct table_cell *table_find(const struct table *t, size_t row,
                                    const char *name)
{
    for (size_t i = 0; i < t->columns; i++)
        if (strcmp(t->cell[i].text, name) == 0) {
            const struct table_cell *cell = table_at(t, row, i);
            return cell->text[0] ? cell : NULL;
        }
    return NULL;
}
