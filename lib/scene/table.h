/*
 * table.h -- a table of texts from a CSV file (RFC 4180), each cell with its
 * place, because a message must name file, line and column.
 *
 * Lines end in LF or CRLF; a byte order mark is skipped; so are blank lines
 * and lines that begin with '#'.  The first of the others is the header, and
 * every row has as many cells.  A cell in double quotes may hold commas, line
 * ends and doubled quotes; around any other cell blanks do not count.
 */
#pragma once

#include <stdint.h>

#include "node.h"

struct table_cell {
    const char *text;      /* borrowed from the table; "" where it is empty */
    uint32_t line, column; /* from 1; columns are counted in bytes */
};

struct table {
    const char *name;        /* borrowed: of the file, for messages */
    char *bytes;             /* owned */
    struct table_cell *cell; /* owned: the header's, then row by row */
    size_t columns, rows;    /* at least one of each; the header is no row */
};

/* STATUS_BAD_SCENE with one line FILE:LINE:COL: in *why where the text is no
 * table: empty, without rows, a quote left open, rows of another length than
 * the header, a column without a name or named twice, control characters,
 * cells beyond TABLE_CELL or columns beyond TABLE_COLUMNS.  STATUS_IO where
 * the file cannot be read or is beyond TABLE_BYTES; STATUS_NO_MEMORY.
 * `path` must outlive the table.  On failure *t is empty. */
MUST_CHECK enum status table_read(struct table *t, const char *path,
                                  struct fault *why);

/* The same of `size` bytes in memory, at most TABLE_BYTES, which are copied. */
MUST_CHECK enum status table_parse(struct table *t, const char *bytes,
                                   size_t size, const char *name,
                                   struct fault *why);

/* A second call is harmless. */
void table_free(struct table *t);

/* The header's cell of a column, and a row's. */
const struct table_cell *table_header(const struct table *t, size_t column);
const struct table_cell *table_at(const struct table *t, size_t row,
                                  size_t column);

/* The row's cell in the column of this name; NULL if there is no such column
 * or the cell is empty. */
const struct table_cell *table_find(const struct table *t, size_t row,
                                    const char *name);

/* Where a cell stands, for place_blame. */
struct place table_place(const struct table *t, const struct table_cell *cell);
