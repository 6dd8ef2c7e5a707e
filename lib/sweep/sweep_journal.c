#include "sweep_journal.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

enum record_kind_of_journal { RECORD_REASON = 1, RECORD_ROW = 2 };

/* No sentence is longer. */
enum { REASON_BYTES = 4096 };

static const char mark[8] = "slipswp";

struct head {
    char mark[8];
    uint64_t key, row_bytes, block_bytes;
};

struct record_head {
    uint64_t kind, size;
};

const uint64_t sweep_journal_nil = 0xcbf29ce484222325u;

uint64_t sweep_journal_sum(uint64_t sum, const void *bytes, size_t size)
{
    const unsigned char *b = bytes;

    for (size_t i = 0; i < size; i++)
        sum = (sum ^ b[i]) * 0x100000001b3u;
    return sum;
}

static enum status trouble(const struct sweep_journal *j, struct fault *why)
{
    return fault_set(why, STATUS_IO, "%.300s: %s", j->path, strerror(errno));
}

/* ---- reading ------------------------------------------------------------- */

/* All of `size` bytes, or not. */
static bool take(int file, void *bytes, size_t size)
{
    char *at = bytes;

    while (size > 0) {
        const ssize_t got = read(file, at, size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        at += got;
        size -= (size_t) got;
    }
    return true;
}

/* Goes on summing over `size` bytes that nobody keeps. */
static bool skim(int file, size_t size, uint64_t *sum)
{
    char bytes[1 << 14];

    for (size_t some; size > 0; size -= some) {
        some = size < sizeof bytes ? size : sizeof bytes;
        if (!take(file, bytes, some))
            return false;
        *sum = sweep_journal_sum(*sum, bytes, some);
    }
    return true;
}

/* The next record, whole and with the right sum: its row (of `row` bytes) or
 * its sentence and a zero after it, in *bytes, which has the room. */
static bool take_record(const struct sweep_journal *j, size_t row,
                        struct record_head *head, char *bytes)
{
    uint64_t sum, stored = 0;

    if (!take(j->file, head, sizeof *head))
        return false;
    const bool is_row = head->kind == RECORD_ROW;
    const size_t kept = is_row ? row : head->size;
    if (is_row ? head->size != row + j->block
               : head->kind != RECORD_REASON || kept > REASON_BYTES)
        return false;
    if (!take(j->file, bytes, kept))
        return false;
    bytes[kept] = '\0';
    sum = sweep_journal_sum(sweep_journal_sum(j->key, head, sizeof *head),
                            bytes, kept);
    return skim(j->file, head->size - kept, &sum) &&
           take(j->file, &stored, sizeof stored) && stored == sum;
}

static enum status keep(const struct sweep_journal *j,
                        const struct record_head *head, const char *bytes,
                        struct sweep_rows *rows, struct sweep_reasons *reasons)
{
    int8_t code;

    if (head->kind == RECORD_REASON)
        return sweep_reasons_code(reasons, bytes, &code);
    const enum status status = sweep_rows_add(rows, 1);
    if (status != STATUS_OK)
        return status;
    const size_t i = rows->count - 1, size = rows->width * sizeof *rows->at;
    memcpy(sweep_rows_row(rows, i), bytes, size);
    *sweep_rows_place(rows, i) =
        (double) (j->end + (off_t) (sizeof *head + size));
    return STATUS_OK;
}

/* Everything up to what was torn off. */
static enum status take_all(struct sweep_journal *j, struct sweep_rows *rows,
                            struct sweep_reasons *reasons)
{
    const size_t row = rows->width * sizeof *rows->at;
    enum status status = STATUS_OK;
    struct record_head head;
    char *bytes = malloc((row > REASON_BYTES ? row : REASON_BYTES) + 1);

    if (bytes == NULL)
        return STATUS_NO_MEMORY;
    while (status == STATUS_OK && take_record(j, row, &head, bytes)) {
        status = keep(j, &head, bytes, rows, reasons);
        j->end += (off_t) (sizeof head + head.size + sizeof(uint64_t));
    }
    free(bytes);
    return status;
}

/* The torn rest goes. */
static enum status cut(const struct sweep_journal *j, struct fault *why)
{
    return ftruncate(j->file, j->end) != 0 ||
                   lseek(j->file, j->end, SEEK_SET) < 0
               ? trouble(j, why)
               : STATUS_OK;
}

enum status sweep_journal_read(const struct sweep_journal *j,
                               const struct sweep_rows *rows, size_t i,
                               size_t offset, void *bytes, size_t size,
                               struct fault *why)
{
    off_t from = (off_t) *sweep_rows_place(rows, i) + (off_t) offset;
    char *at = bytes;

    while (size > 0) {
        const ssize_t got = pread(j->file, at, size, from);
        if (got < 0 && errno == EINTR)
            continue;
        if (got == 0)
            errno = EIO;
        if (got <= 0)
            return trouble(j, why);
        at += got;
        from += got;
        size -= (size_t) got;
    }
    return STATUS_OK;
}

/* ---- writing ------------------------------------------------------------- */

static enum status put(const struct sweep_journal *j, const void *bytes,
                       size_t size, struct fault *why)
{
    const char *at = bytes;

    while (size > 0) {
        const ssize_t put = write(j->file, at, size);
        if (put < 0 && errno == EINTR)
            continue;
        if (put < 0)
            return trouble(j, why);
        at += put;
        size -= (size_t) put;
    }
    return STATUS_OK;
}

/* Two pieces, either may be empty. */
static enum status put_record(struct sweep_journal *j,
                              enum record_kind_of_journal kind,
                              const void *bytes, size_t size, const void *more,
                              size_t more_size, struct fault *why)
{
    const struct record_head head = { kind, size + more_size };
    uint64_t sum = sweep_journal_sum(j->key, &head, sizeof head);

    sum = sweep_journal_sum(sum, bytes, size);
    sum = sweep_journal_sum(sum, more, more_size);
    enum status status = put(j, &head, sizeof head, why);
    if (status == STATUS_OK)
        status = put(j, bytes, size, why);
    if (status == STATUS_OK)
        status = put(j, more, more_size, why);
    if (status == STATUS_OK)
        status = put(j, &sum, sizeof sum, why);
    j->end += (off_t) (sizeof head + head.size + sizeof sum);
    return status;
}

enum status sweep_journal_reason(struct sweep_journal *j, const char *text,
                                 struct fault *why)
{
    return j->path
               ? put_record(j, RECORD_REASON, text, strlen(text), "", 0, why)
               : STATUS_OK;
}

enum status sweep_journal_row(struct sweep_journal *j,
                              const struct sweep_rows *rows, size_t i,
                              const void *block, struct fault *why)
{
    const size_t size = rows->width * sizeof *rows->at;

    if (j->path == NULL)
        return STATUS_OK;
    *sweep_rows_place(rows, i) =
        (double) (j->end + (off_t) (sizeof(struct record_head) + size));
    return put_record(j, RECORD_ROW, sweep_rows_row(rows, i), size, block,
                      j->block, why);
}

/* ---- opening ------------------------------------------------------------- */

static enum status open_file(struct sweep_journal *j, int how, int lock,
                             struct fault *why)
{
    struct stat is;

    j->file = open(j->path, how | O_CLOEXEC, 0666);
    if (j->file < 0 || fstat(j->file, &is) != 0)
        return trouble(j, why);
    if (flock(j->file, lock | LOCK_NB) == 0 && S_ISREG(is.st_mode))
        return STATUS_OK;
    return fault_set(why, STATUS_IO, "%.300s: %s", j->path,
                     S_ISREG(is.st_mode) ? "another run is writing it"
                                         : "not a regular file");
}

static enum status begin(struct sweep_journal *j, const struct head *own,
                         struct fault *why)
{
    if (ftruncate(j->file, 0) != 0 || lseek(j->file, 0, SEEK_SET) < 0)
        return trouble(j, why);
    return put(j, own, sizeof *own, why);
}

static enum status refuse(const struct sweep_journal *j, const char *what,
                          struct fault *why)
{
    return fault_set(why, STATUS_BAD_SCENE, "%.300s: %s", j->path, what);
}

static struct head head_of(const struct sweep_journal *j,
                           const struct sweep_rows *rows)
{
    struct head own = { .key = j->key,
                        .row_bytes = rows->width * sizeof *rows->at,
                        .block_bytes = j->block };

    memcpy(own.mark, mark, sizeof mark);
    return own;
}

/* The head of a side file, of which *size is the size; *whole: it did not end
 * within its head, killed before its first row.  `resume`: of this sweep. */
static enum status take_head(const struct sweep_journal *j,
                             const struct head *own, bool resume, off_t *size,
                             bool *whole, struct fault *why)
{
    struct head head = { .key = 0 };

    *whole = take(j->file, &head, sizeof head);
    *size = lseek(j->file, 0, SEEK_END);
    const size_t marked =
        (size_t) *size < sizeof mark ? (size_t) *size : sizeof mark;
    if (memcmp(head.mark, mark, marked) != 0)
        return refuse(j, "not a side file of slipway, expected no such file",
                      why);
    if (*whole && resume && memcmp(&head, own, sizeof head) != 0)
        return refuse(j,
                      "of another scene or version, expected that of this "
                      "scene (without --resume it is replaced)",
                      why);
    return lseek(j->file, sizeof head, SEEK_SET) < 0 ? trouble(j, why)
                                                     : STATUS_OK;
}

static enum status enter(struct sweep_journal *j, bool resume,
                         struct sweep_rows *rows, struct sweep_reasons *reasons,
                         bool *replaced, struct fault *why)
{
    const struct head own = head_of(j, rows);
    bool whole;
    off_t size;
    enum status status = take_head(j, &own, resume, &size, &whole, why);

    *replaced = false;
    j->end = sizeof own;
    if (status != STATUS_OK)
        return status;
    if (!whole || !resume) {
        *replaced = size > (off_t) sizeof own;
        return begin(j, &own, why);
    }
    status = take_all(j, rows, reasons);
    return status ? status : cut(j, why);
}

enum status sweep_journal_open(struct sweep_journal *j, const char *path,
                               uint64_t key, size_t block, bool resume,
                               struct sweep_rows *rows,
                               struct sweep_reasons *reasons, bool *replaced,
                               struct fault *why)
{
    *j = (struct sweep_journal){
        .path = strdup(path), .file = -1, .key = key, .block = block
    };
    enum status status = j->path ? open_file(j, O_RDWR | O_CREAT, LOCK_EX, why)
                                 : STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        status = enter(j, resume, rows, reasons, replaced, why);
    if (status != STATUS_OK)
        sweep_journal_close(j);
    return status;
}

enum status sweep_journal_look(struct sweep_journal *j, const char *path,
                               uint64_t key, size_t block,
                               struct sweep_rows *rows,
                               struct sweep_reasons *reasons, struct fault *why)
{
    bool whole = false;
    off_t size;

    *j = (struct sweep_journal){ .path = strdup(path),
                                 .file = -1,
                                 .key = key,
                                 .block = block,
                                 .end = sizeof(struct head) };
    enum status status =
        j->path ? open_file(j, O_RDONLY, LOCK_SH, why) : STATUS_NO_MEMORY;
    if (status == STATUS_OK) {
        const struct head own = head_of(j, rows);
        status = take_head(j, &own, true, &size, &whole, why);
    }
    if (status == STATUS_OK && whole)
        status = take_all(j, rows, reasons);
    if (status != STATUS_OK)
        sweep_journal_close(j);
    return status;
}

void sweep_journal_close(struct sweep_journal *j)
{
    if (j->path && j->file >= 0)
        close(j->file);
    free(j->path);
    *j = (struct sweep_journal){ .file = -1 };
}
