/*
 * sweep_journal.h -- the side file of a running sweep: what is computed stays,
 * whenever the run is killed.
 *
 * A head (a mark, the key, the length of a row and of its block), then records:
 * a row and the block of its layers (sweep_layer.h), or the sentence behind the
 * next free code of sweep_reason.h.  Each record ends in a checksum (FNV-1a, 64
 * bits); what follows the first wrong one was torn off and is dropped.
 */
#pragma once

#include <sys/types.h>

#include "sweep_reason.h"
#include "sweep_rows.h"

struct sweep_journal {
    char *path; /* owned; NULL: there is none */
    int file;   /* owned */
    uint64_t key;
    size_t block; /* bytes behind each row */
    off_t end;    /* where the next record goes */
};

/* Of no bytes yet, and of more bytes after those of `sum`. */
uint64_t sweep_journal_sum(uint64_t sum, const void *bytes, size_t size);
extern const uint64_t sweep_journal_nil;

/* Opens `path` for the rows of the sweep with this key, each with a block of so
 * many bytes.  `resume`: rows and sentences in it are appended to *rows and
 * *reasons; otherwise it is emptied, and *replaced says whether it held rows.
 * Codes are as they stand: -1 and the words of a column are as good as those of
 * reasons, and only the columns' owner can tell and check them (sweep.c).
 *
 * STATUS_BAD_SCENE: resumed, but of another key; or no side file of a sweep at
 * all.  STATUS_IO: it cannot be opened or written, or another run has it.
 * STATUS_NO_MEMORY.  On failure *why is one line and *j has no file. */
MUST_CHECK enum status sweep_journal_open(struct sweep_journal *j,
                                          const char *path, uint64_t key,
                                          size_t block, bool resume,
                                          struct sweep_rows *rows,
                                          struct sweep_reasons *reasons,
                                          bool *replaced, struct fault *why);

/* Reads a side file as it stands, and neither changes it nor is alone with it:
 * rows and sentences are appended as above, with the sentences' codes as *they*
 * are in *reasons.  STATUS_BAD_SCENE: of another key, or no side file of a
 * sweep; STATUS_IO: it cannot be read, or a run is writing it;
 * STATUS_NO_MEMORY.  On failure *why is one line and *j has no file. */
MUST_CHECK enum status sweep_journal_look(struct sweep_journal *j,
                                          const char *path, uint64_t key,
                                          size_t block, struct sweep_rows *rows,
                                          struct sweep_reasons *reasons,
                                          struct fault *why);

/* Append one record; nothing without a file.  A row notes the place of its
 * block.  STATUS_IO. */
MUST_CHECK enum status sweep_journal_reason(struct sweep_journal *j,
                                            const char *text,
                                            struct fault *why);
MUST_CHECK enum status sweep_journal_row(struct sweep_journal *j,
                                         const struct sweep_rows *rows,
                                         size_t i, const void *block,
                                         struct fault *why);

/* `size` bytes from `offset` on of the block of row i.  STATUS_IO. */
MUST_CHECK enum status sweep_journal_read(const struct sweep_journal *j,
                                          const struct sweep_rows *rows,
                                          size_t i, size_t offset, void *bytes,
                                          size_t size, struct fault *why);

/* Closes the file, which stays.  A second call is harmless. */
void sweep_journal_close(struct sweep_journal *j);
