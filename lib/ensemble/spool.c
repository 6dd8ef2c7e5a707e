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
    return kind <= SPOOL_MARGIN ? sizeof(double) : sizeof(int8_t);
}

static size_t columns_of(const struct spool_shape *s, enum spool_kind kind)
{
    switch (kind) {
        case SPOOL_KEY:
            return s->keys;
        case SPOOL_VALUE:
        case SPOOL_ERROR:
        case SPOOL_CODE:
            return s->numbers;
        case SPOOL_MARGIN:
        case SPOOL_FATE:
        case SPOOL_FATE_REASON:
            return s->pushes;
    }
    return 0;
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
    size_t draws = 0;

    for (size_t i = 0; i < spool_blocks(s); i++)
        draws += s->there[i] ? spool_count(s, i) : 0;
    return draws;
}

size_t spool_count(const struct spool *s, size_t block)
{
    const size_t left = s->shape.draws - block * SPOOL_DRAWS;

    return left < SPOOL_DRAWS ? left : SPOOL_DRAWS;
}

/* ---- the file ------------------------------------------------------------ */

/* A file of no name, once it is open. */
static enum status open_hidden(struct spool *s, uint64_t key, size_t size,
                               struct sweep_rows *rows,
                               struct sweep_reasons *reasons, struct fault *why)
{
    const char *folder = getenv("TMPDIR");
    char path[512];
    bool replaced;

    snprintf(path, sizeof path, "%.480s/slipway-XXXXXX",
             folder && *folder ? folder : "/tmp");
    const int file = mkstemp(path);
    if (file < 0)
        return fault_set(why, STATUS_IO, "%.480s: %s", path, strerror(errno));
    close(file);
    const enum status status = sweep_journal_open(
        &s->journal, path, key, size, false, rows, reasons, &replaced, why);
    (void) unlink(path);
    return status;
}

/* All blocks, none of them whole. */
static enum status make_rows(struct spool *s)
{
    const size_t blocks = spool_blocks(s);

    s->there = calloc(blocks + 1, sizeof *s->there);
    if (s->block == NULL || s->there == NULL)
        return STATUS_NO_MEMORY;
    const enum status status = sweep_rows_add(&s->rows, blocks);
    for (size_t i = 0; status == STATUS_OK && i < blocks; i++)
        sweep_rows_x(&s->rows, i)[0] = (double) i;
    return status;
}

/* The block of a row of a file; spool_blocks if it is none, or not wanted. */
static size_t wanted(const struct spool *s, const struct sweep_rows *rows,
                     size_t i)
{
    const double x = sweep_rows_x(rows, i)[0];
    const size_t blocks = spool_blocks(s);
    const size_t k = x >= 0.0 && x < (double) blocks ? (size_t) x : blocks;

    return k < blocks && x == (double) k && !s->there[k] ? k : blocks;
}

/* ---- other files --------------------------------------------------------- */

/* Codes of the other's sentences as our own; what is no code is none of it. */
static enum status translate(struct spool *s, const struct sweep_reasons *other,
                             struct sweep_reasons *own, enum spool_kind kind,
                             struct fault *why)
{
    const size_t count = columns_of(&s->shape, kind) * SPOOL_DRAWS;
    int8_t *code = spool_column(s, kind, 0);
    enum status status = STATUS_OK;

    for (size_t i = 0; i < count && status == STATUS_OK; i++) {
        const size_t known = own->count;
        if (code[i] < REASON_FIRST || (size_t) code[i] >= other->count)
            continue;
        const char *text = other->text[code[i]];
        status = sweep_reasons_code(own, text, &code[i]);
        if (status == STATUS_OK && own->count > known)
            status = sweep_journal_reason(&s->journal, text, why);
    }
    return status;
}

static enum status copy_block(struct spool *s, const struct sweep_journal *from,
                              const struct sweep_rows *rows, size_t i, size_t k,
                              const struct sweep_reasons *other,
                              struct sweep_reasons *own, struct fault *why)
{
    enum status status =
        sweep_journal_read(from, rows, i, 0, s->block, from->block, why);

    if (status == STATUS_OK)
        status = translate(s, other, own, SPOOL_CODE, why);
    if (status == STATUS_OK)
        status = translate(s, other, own, SPOOL_FATE_REASON, why);
    return status ? status : spool_push(s, k, why);
}

/* The blocks of another file, into the own one if they are joined. */
static enum status take_file(struct spool *s, const char *path, bool join,
                             struct sweep_reasons *own, struct fault *why)
{
    struct sweep_rows rows = sweep_rows_of(0, false);
    struct sweep_reasons other;
    struct sweep_journal from = { .file = -1 };
    enum status status = sweep_reasons_init(&other);

    if (status == STATUS_OK)
        status = sweep_journal_look(&from, path, s->journal.key,
                                    s->journal.block, &rows, &other, why);
    for (size_t i = 0; i < rows.count && status == STATUS_OK; i++) {
        const size_t k = wanted(s, &rows, i);
        if (k < spool_blocks(s) && join)
            status = copy_block(s, &from, &rows, i, k, &other, own, why);
        if (k < spool_blocks(s))
            s->there[k] = true;
    }
    sweep_journal_close(&from);
    sweep_rows_free(&rows);
    sweep_reasons_free(&other);
    return status;
}

/* ---- the whole ----------------------------------------------------------- */

static enum status open_own(struct spool *s, const struct sweep_options *o,
                            uint64_t key, size_t size,
                            struct sweep_reasons *reasons, bool *replaced,
                            struct fault *why)
{
    struct sweep_rows rows = sweep_rows_of(0, false);
    const enum status status =
        o->journal
            ? sweep_journal_open(&s->journal, o->journal, key, size, o->resume,
                                 &rows, reasons, replaced, why)
            : open_hidden(s, key, size, &rows, reasons, why);

    for (size_t i = 0; i < rows.count && status == STATUS_OK; i++) {
        const size_t k = wanted(s, &rows, i);
        if (k == spool_blocks(s))
            continue;
        *sweep_rows_place(&s->rows, k) = *sweep_rows_place(&rows, i);
        s->there[k] = true;
    }
    sweep_rows_free(&rows);
    return status;
}

enum status spool_open(struct spool *s, const struct sweep_options *o,
                       uint64_t key, const struct spool_shape *shape,
                       struct sweep_reasons *reasons, bool *replaced,
                       struct fault *why)
{
    const size_t size = offset_of(shape, SPOOL_FATE_REASON + 1, 0);

    *s = (struct spool){ .shape = *shape,
                         .journal = { .file = -1 },
                         .rows = sweep_rows_of(0, false),
                         .block = calloc(size, 1) };
    enum status status = make_rows(s);
    if (status == STATUS_OK)
        status = open_own(s, o, key, size, reasons, replaced, why);
    for (size_t k = 0; k < o->others && status == STATUS_OK; k++)
        status = take_file(s, o->other[k], o->join, reasons, why);
    if (status != STATUS_OK)
        spool_close(s);
    return status;
}

void spool_close(struct spool *s)
{
    sweep_journal_close(&s->journal);
    sweep_rows_free(&s->rows);
    free(s->block);
    free(s->there);
    s->block = NULL;
    s->there = NULL;
}

/* ---- blocks -------------------------------------------------------------- */

void *spool_column(const struct spool *s, enum spool_kind kind, size_t k)
{
    return s->block + offset_of(&s->shape, (int) kind, k);
}

enum status spool_push(struct spool *s, size_t block, struct fault *why)
{
    s->there[block] = true;
    return sweep_journal_row(&s->journal, &s->rows, block, s->block, why);
}

static bool is_code(enum spool_kind kind)
{
    return kind == SPOOL_CODE || kind == SPOOL_FATE_REASON;
}

enum status spool_read(const struct spool *s, size_t block,
                       enum spool_kind kind, size_t k, void *out,
                       struct fault *why)
{
    const size_t count = spool_count(s, block);
    int8_t *code = out;
    const enum status status = sweep_journal_read(
        &s->journal, &s->rows, block, offset_of(&s->shape, (int) kind, k), out,
        count * size_of(kind), why);

    for (size_t i = 0; i < count && is_code(kind) && status == STATUS_OK; i++)
        if (s->sorted[code[i]] > 0)
            code[i] = s->sorted[code[i]];
    return status;
}

/* ---- reasons ------------------------------------------------------------- */

/* Those of a column that are new, in its order. */
static enum status sort_column(const struct spool *s, size_t block,
                               enum spool_kind kind, size_t k,
                               const struct sweep_reasons *old,
                               struct sweep_reasons *sorted, int8_t to[],
                               struct fault *why)
{
    int8_t code[SPOOL_DRAWS];
    enum status status = spool_read(s, block, kind, k, code, why);

    for (size_t i = 0; i < spool_count(s, block) && status == STATUS_OK; i++)
        if (code[i] >= REASON_FIRST && to[code[i]] == 0)
            status =
                sweep_reasons_code(sorted, old->text[code[i]], &to[code[i]]);
    return status;
}

static enum status sort_block(const struct spool *s, size_t block,
                              const struct sweep_reasons *old,
                              struct sweep_reasons *sorted, int8_t to[],
                              struct fault *why)
{
    static const enum spool_kind kind[] = { SPOOL_CODE, SPOOL_FATE_REASON };
    enum status status = STATUS_OK;

    for (size_t j = 0; j < 2; j++)
        for (size_t k = 0; k < columns_of(&s->shape, kind[j]) && !status; k++)
            status = sort_column(s, block, kind[j], k, old, sorted, to, why);
    return status;
}

enum status spool_sort(struct spool *s, struct sweep_reasons *reasons,
                       struct fault *why)
{
    struct sweep_reasons sorted;
    int8_t to[REASONS_MAX] = { 0 };
    enum status status = sweep_reasons_init(&sorted);

    for (size_t b = 0; b < spool_blocks(s) && status == STATUS_OK; b++)
        status = sort_block(s, b, reasons, &sorted, to, why);
    if (status != STATUS_OK) {
        sweep_reasons_free(&sorted);
        return status;
    }
    memcpy(s->sorted, to, sizeof to);
    sweep_reasons_free(reasons);
    *reasons = sorted;
    return STATUS_OK;
}
