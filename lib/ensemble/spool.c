#include "spool.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "ensemble_tolerance.h"

/* ---- where things stand -------------------------------------------------- */

static size_t size_of(enum spool_kind kind)
{
    return kind <= SPOOL_ERROR ? sizeof(double) : sizeof(int8_t);
}

static size_t columns_of(const struct spool_shape *s, enum spool_kind kind)
{
    return kind == SPOOL_KEY    ? s->keys
           : kind <= SPOOL_CODE ? s->numbers
                                : s->pushes;
}

/* In bytes from the start of a block; of the kind behind the last its size. */
static size_t offset_of(const struct spool_shape *s, int kind, size_t k)
{
    size_t bytes = 0;

    for (int i = 0; i < kind; i++)
        bytes +=
            columns_of(s, (enum spool_kind) i) * size_of((enum spool_kind) i);
    if (k > 0)
        bytes += k * size_of((enum spool_kind) kind);
    return bytes * SPOOL_DRAWS;
}

size_t spool_blocks(const struct spool *s)
{
    return (s->shape.draws + SPOOL_DRAWS - 1) / SPOOL_DRAWS;
}

size_t spool_done(const struct spool *s)
{
    return s->rows.count;
}

size_t spool_count(const struct spool *s, size_t block)
{
    const size_t left = s->shape.draws - block * SPOOL_DRAWS;

    return left < SPOOL_DRAWS ? left : SPOOL_DRAWS;
}

/* ---- the file ------------------------------------------------------------ */

/* A file of no name, once it is open. */
static enum status open_hidden(struct spool *s, uint64_t key, size_t size,
                               struct sweep_reasons *reasons, struct fault *why)
{
    const char *folder = getenv("TMPDIR");
    char path[512];
    bool replaced;

    snprintf(path, sizeof path, "%.480s/slipway-XXXXXX",
             folder && *folder ? folder : "/tmp");
    const int file = mkstemp(path);
    if (file < 0) {
        snprintf(why->text, sizeof why->text, "%.480s: %s", path,
                 strerror(errno));
        return STATUS_IO;
    }
    close(file);
    const enum status status = sweep_journal_open(
        &s->journal, path, key, size, false, &s->rows, reasons, &replaced, why);
    (void) unlink(path);
    return status;
}

/* They follow one another from 0 on; what does not goes. */
static void drop_unsound(struct spool *s)
{
    size_t n = 0;

    while (n < s->rows.count && n < spool_blocks(s) &&
           sweep_rows_x(&s->rows, n)[0] == (double) n)
        n++;
    s->rows.count = n;
}

enum status spool_open(struct spool *s, const char *path, uint64_t key,
                       const struct spool_shape *shape, bool resume,
                       struct sweep_reasons *reasons, bool *replaced,
                       struct fault *why)
{
    const size_t size = offset_of(shape, SPOOL_FATE_REASON + 1, 0);

    *s = (struct spool){ .shape = *shape,
                         .journal = { .file = -1 },
                         .rows = sweep_rows_of(0, false),
                         .block = calloc(size, 1) };
    if (s->block == NULL)
        return STATUS_NO_MEMORY;
    const enum status status =
        path ? sweep_journal_open(&s->journal, path, key, size, resume,
                                  &s->rows, reasons, replaced, why)
             : open_hidden(s, key, size, reasons, why);
    if (status == STATUS_OK)
        drop_unsound(s);
    else
        spool_close(s);
    return status;
}

void spool_close(struct spool *s)
{
    sweep_journal_close(&s->journal);
    sweep_rows_free(&s->rows);
    free(s->block);
    s->block = NULL;
}

/* ---- blocks -------------------------------------------------------------- */

void *spool_column(const struct spool *s, enum spool_kind kind, size_t k)
{
    return s->block + offset_of(&s->shape, (int) kind, k);
}

enum status spool_push(struct spool *s, struct fault *why)
{
    const size_t n = s->rows.count;
    const enum status status = sweep_rows_add(&s->rows, 1);

    if (status != STATUS_OK)
        return status;
    sweep_rows_x(&s->rows, n)[0] = (double) n;
    return sweep_journal_row(&s->journal, &s->rows, n, s->block, why);
}

enum status spool_read(const struct spool *s, size_t block,
                       enum spool_kind kind, size_t k, void *out,
                       struct fault *why)
{
    return sweep_journal_read(&s->journal, &s->rows, block,
                              offset_of(&s->shape, (int) kind, k), out,
                              spool_count(s, block) * size_of(kind), why);
}
