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
    uint64_t key, row_bytes;
};

struct record_head {
    uint32_t kind, size;
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
    snprintf(why->text, sizeof why->text, "%.300s: %s", j->path,
             strerror(errno));
    return STATUS_IO;
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

/* The next record, whole and with the right sum: its payload, a zero after
 * it, in *bytes, which has the room. */
static bool take_record(const struct sweep_journal *j, size_t most,
                        struct record_head *head, char *bytes)
{
    uint64_t sum = 0;

    if (!take(j->file, head, sizeof *head) || head->size > most ||
        !take(j->file, bytes, head->size) || !take(j->file, &sum, sizeof sum))
        return false;
    bytes[head->size] = '\0';
    return sum ==
           sweep_journal_sum(sweep_journal_sum(j->key, head, sizeof *head),
                             bytes, head->size);
}

static enum status keep(const struct record_head *head, const char *bytes,
                        struct sweep_rows *rows, struct sweep_reasons *reasons)
{
    int8_t code;

    if (head->kind == RECORD_REASON)
        return sweep_reasons_code(reasons, bytes, &code);
    const enum status status = sweep_rows_add(rows, 1);
    if (status == STATUS_OK)
        memcpy(sweep_rows_row(rows, rows->count - 1), bytes, head->size);
    return status;
}

/* Everything up to what was torn off, which goes. */
static enum status take_all(const struct sweep_journal *j,
                            struct sweep_rows *rows,
                            struct sweep_reasons *reasons, struct fault *why)
{
    const size_t row = rows->width * sizeof *rows->at;
    const size_t most = row > REASON_BYTES ? row : REASON_BYTES;
    off_t good = (off_t) sizeof(struct head);
    enum status status = STATUS_OK;
    struct record_head head;
    char *bytes = malloc(most + 1);

    if (bytes == NULL)
        return STATUS_NO_MEMORY;
    while (status == STATUS_OK && take_record(j, most, &head, bytes)) {
        if (head.kind == RECORD_ROW && head.size != row)
            break;
        status = keep(&head, bytes, rows, reasons);
        good += (off_t) (sizeof head + head.size + sizeof(uint64_t));
    }
    free(bytes);
    if (status == STATUS_OK &&
        (ftruncate(j->file, good) != 0 || lseek(j->file, good, SEEK_SET) < 0))
        return trouble(j, why);
    return status;
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

static enum status put_record(const struct sweep_journal *j,
                              enum record_kind_of_journal kind,
                              const void *bytes, size_t size, struct fault *why)
{
    const struct record_head head = { (uint32_t) kind, (uint32_t) size };
    const uint64_t sum = sweep_journal_sum(
        sweep_journal_sum(j->key, &head, sizeof head), bytes, size);
    char *all = malloc(sizeof head + size + sizeof sum), *end = all;

    if (all == NULL)
        return STATUS_NO_MEMORY;
    end = (char *) memcpy(end, &head, sizeof head) + sizeof head;
    end = (char *) memcpy(end, bytes, size) + size;
    end = (char *) memcpy(end, &sum, sizeof sum) + sizeof sum;
    const enum status status = put(j, all, (size_t) (end - all), why);
    free(all);
    return status;
}

enum status sweep_journal_reason(struct sweep_journal *j, const char *text,
                                 struct fault *why)
{
    return j->path ? put_record(j, RECORD_REASON, text, strlen(text), why)
                   : STATUS_OK;
}

enum status sweep_journal_row(struct sweep_journal *j,
                              const struct sweep_rows *rows, size_t i,
                              struct fault *why)
{
    return j->path ? put_record(j, RECORD_ROW, sweep_rows_row(rows, i),
                                rows->width * sizeof *rows->at, why)
                   : STATUS_OK;
}

/* ---- opening ------------------------------------------------------------- */

static enum status open_file(struct sweep_journal *j, struct fault *why)
{
    struct stat is;

    j->file = open(j->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (j->file < 0 || fstat(j->file, &is) != 0)
        return trouble(j, why);
    if (flock(j->file, LOCK_EX | LOCK_NB) == 0 && S_ISREG(is.st_mode))
        return STATUS_OK;
    snprintf(why->text, sizeof why->text, "%.300s: %s", j->path,
             S_ISREG(is.st_mode) ? "another run is writing it"
                                 : "not a regular file");
    return STATUS_IO;
}

static enum status begin(struct sweep_journal *j, size_t row_bytes,
                         struct fault *why)
{
    struct head head = { .key = j->key, .row_bytes = row_bytes };

    memcpy(head.mark, mark, sizeof mark);
    if (ftruncate(j->file, 0) != 0 || lseek(j->file, 0, SEEK_SET) < 0)
        return trouble(j, why);
    return put(j, &head, sizeof head, why);
}

static enum status refuse(const struct sweep_journal *j, const char *what,
                          struct fault *why)
{
    snprintf(why->text, sizeof why->text, "%.300s: %s", j->path, what);
    return STATUS_BAD_SCENE;
}

/* A file that ends within its head was killed before its first row. */
static enum status enter(struct sweep_journal *j, bool resume,
                         struct sweep_rows *rows, struct sweep_reasons *reasons,
                         bool *replaced, struct fault *why)
{
    const size_t row = rows->width * sizeof *rows->at;
    struct head head = { .key = 0 };
    const bool whole = take(j->file, &head, sizeof head);
    const off_t size = lseek(j->file, 0, SEEK_END);
    const size_t marked =
        (size_t) size < sizeof mark ? (size_t) size : sizeof mark;

    *replaced = false;
    if (memcmp(head.mark, mark, marked) != 0)
        return refuse(j, "not the side file of a sweep, expected no such file",
                      why);
    if (whole && resume && (head.key != j->key || head.row_bytes != row))
        return refuse(j,
                      "of another scene or version, expected that of this "
                      "scene (without --resume it is replaced)",
                      why);
    if (!whole || !resume) {
        *replaced = size > (off_t) sizeof head;
        return begin(j, row, why);
    }
    if (lseek(j->file, sizeof head, SEEK_SET) < 0)
        return trouble(j, why);
    return take_all(j, rows, reasons, why);
}

enum status sweep_journal_open(struct sweep_journal *j, const char *path,
                               uint64_t key, bool resume,
                               struct sweep_rows *rows,
                               struct sweep_reasons *reasons, bool *replaced,
                               struct fault *why)
{
    *j = (struct sweep_journal){ path, -1, key };
    enum status status = open_file(j, why);
    if (status == STATUS_OK)
        status = enter(j, resume, rows, reasons, replaced, why);
    if (status != STATUS_OK)
        sweep_journal_close(j);
    return status;
}

void sweep_journal_close(struct sweep_journal *j)
{
    if (j->path && j->file >= 0)
        close(j->file);
    *j = (struct sweep_journal){ .file = -1 };
}
