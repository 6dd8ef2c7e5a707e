/*
 * sweep_journal.h -- the side file of a running sweep: what is computed stays,
 * whenever the run is killed.
 *
 * A head (a mark, the key, the length of a row), then records, each appended
 * in one go: a row, or the sentence behind the next free code of
 * sweep_reason.h.  Each record ends in a checksum (FNV-1a, 64 bits); what
 * follows the first wrong one was torn off and is dropped.
 */
#ifndef STUDY_SWEEP_JOURNAL_H
#define STUDY_SWEEP_JOURNAL_H

#include "sweep_reason.h"
#include "sweep_rows.h"

struct sweep_journal {
    const char *path; /* borrowed; NULL: there is none */
    int file;         /* owned */
    uint64_t key;
};

/* Of no bytes yet, and of more bytes after those of `sum`. */
uint64_t sweep_journal_sum(uint64_t sum, const void *bytes, size_t size);
extern const uint64_t sweep_journal_nil;

/* Opens `path` for the rows of the sweep with this key.  `resume`: what is in
 * it is appended to *rows and *reasons; otherwise it is emptied, and
 * *replaced says whether it held rows.
 *
 * STATUS_BAD_SCENE: resumed, but of another key; or no side file of a sweep at
 * all.  STATUS_IO: it cannot be opened or written, or another run has it.
 * STATUS_NO_MEMORY.  On failure *why is one line and *j has no file. */
MUST_CHECK enum status sweep_journal_open(struct sweep_journal *j,
                                          const char *path, uint64_t key,
                                          bool resume, struct sweep_rows *rows,
                                          struct sweep_reasons *reasons,
                                          bool *replaced, struct fault *why);

/* Append one record; nothing without a file.  STATUS_IO, STATUS_NO_MEMORY. */
MUST_CHECK enum status sweep_journal_reason(struct sweep_journal *j,
                                            const char *text,
                                            struct fault *why);
MUST_CHECK enum status sweep_journal_row(struct sweep_journal *j,
                                         const struct sweep_rows *rows,
                                         size_t i, struct fault *why);

/* Closes the file, which stays.  A second call is harmless. */
void sweep_journal_close(struct sweep_journal *j);

#endif
