/*
 * spool.h -- the draws of a running ensemble in a file (sweep_journal.h), block
 * by block and column by column within a block: memory holds one block, however
 * many there are, and what is computed stays whenever the run is killed.
 */
#pragma once

#include "sweep_journal.h"
#include "sweep_options.h"

/* What stands at a draw. */
enum spool_kind {
    SPOOL_KEY,        /* double */
    SPOOL_VALUE,      /* double, of a number */
    SPOOL_ERROR,      /* double */
    SPOOL_MARGIN,     /* double, of a push: labels_margin, or infinite */
    SPOOL_CODE,       /* int8_t, of a number: sweep_reason.h */
    SPOOL_FATE,       /* int8_t, of a push: enum fate; -1: none */
    SPOOL_FATE_REASON /* int8_t: why it is none or undecided, or present */
};

struct spool_shape {
    size_t draws, keys, numbers, pushes;
};

struct spool {
    struct spool_shape shape;
    struct sweep_journal journal; /* owned */
    struct sweep_rows rows; /* owned; a row a block, x[0] being its number */
    char *block;            /* owned; the one being filled */
    bool *there;            /* owned; blocks that are whole, in any file */
    int8_t sorted[REASONS_MAX]; /* the code of a sentence by that in the file;
                                   0 unless sorted */
};

/* Opens the file of a run with this key (o->journal); without a path one in
 * TMPDIR that nobody else sees.  o->resume takes its blocks and sentences, else
 * it is emptied and *replaced says whether it held some; then those of the
 * other files.  Errors as sweep_journal_open; *s is then closed. */
MUST_CHECK enum status spool_open(struct spool *s,
                                  const struct sweep_options *o, uint64_t key,
                                  const struct spool_shape *shape,
                                  struct sweep_reasons *reasons, bool *replaced,
                                  struct fault *why);

/* Blocks in all, draws in those that are whole, and in one. */
size_t spool_blocks(const struct spool *s);
size_t spool_done(const struct spool *s);
size_t spool_count(const struct spool *s, size_t block);

/* A column of the block being filled: SPOOL_DRAWS values. */
void *spool_column(const struct spool *s, enum spool_kind kind, size_t k);

/* Writes that block, which is then whole.  STATUS_IO. */
MUST_CHECK enum status spool_push(struct spool *s, size_t block,
                                  struct fault *why);

/* A column of a block that is whole in the own file: spool_count values.
 * STATUS_IO. */
MUST_CHECK enum status spool_read(const struct spool *s, size_t block,
                                  enum spool_kind kind, size_t k, void *out,
                                  struct fault *why);

/* Of a whole file: from now on sentences have the codes of the order in which
 * the draws meet them, whatever the order of arrival was; *reasons likewise.
 * STATUS_IO, STATUS_NO_MEMORY. */
MUST_CHECK enum status spool_sort(struct spool *s,
                                  struct sweep_reasons *reasons,
                                  struct fault *why);

/* Closes the file, which stays if it has a path.  A second call is harmless. */
void spool_close(struct spool *s);
