/* Side files of sweeps, as `sweep --resume` reads them.  An input is a list of
 * records, each a kind, a size (two bytes) and its payload; they get checksums
 * that are right, or nothing would be read.  One that begins with the mark of a
 * side file is taken as it is. */
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

#include "fuzz.h"
#include "memory_file.h"
#include "sweep_journal.h"

enum { KEY = 7, BLOCK = 4 };

struct read {
    struct sweep_journal journal;
    struct sweep_rows rows;
    struct sweep_reasons reasons;
    struct fault why;
};

static enum status begin(struct read *r, const char *path, bool resume)
{
    bool replaced;

    *r = (struct read){ .rows = sweep_rows_of(1, false) };
    MUST(sweep_reasons_init(&r->reasons) == STATUS_OK);
    return sweep_journal_open(&r->journal, path, KEY, BLOCK, resume, &r->rows,
                              &r->reasons, &replaced, &r->why);
}

static void end(struct read *r)
{
    sweep_journal_close(&r->journal);
    sweep_rows_free(&r->rows);
    sweep_reasons_free(&r->reasons);
}

/* As sweep_journal.c writes one. */
static void put_record(int file, uint64_t kind, const uint8_t *payload,
                       uint64_t size)
{
    const uint64_t head[2] = { kind, size };
    const uint64_t sum = sweep_journal_sum(
        sweep_journal_sum(KEY, head, sizeof head), payload, (size_t) size);

    MUST(write(file, head, sizeof head) == sizeof head);
    MUST(write(file, payload, (size_t) size) == (ssize_t) size);
    MUST(write(file, &sum, sizeof sum) == sizeof sum);
}

static void put_records(const char *path, const uint8_t *data, size_t size)
{
    struct read r;

    MUST(begin(&r, path, false) == STATUS_OK);
    end(&r);
    const int file = open(path, O_WRONLY | O_APPEND | O_CLOEXEC);
    MUST(file >= 0);
    while (size > 3) {
        const size_t said = (size_t) (data[1] | data[2] << 8);
        const size_t payload = said < size - 3 ? said : size - 3;
        put_record(file, data[0], data + 3, payload);
        data += 3 + payload;
        size -= 3 + payload;
    }
    MUST(write(file, data, size) == (ssize_t) size); /* torn off */
    close(file);
}

/* Codes are for sweep.c to check, which knows what they may be. */
static void check_rows(struct read *r)
{
    char block[BLOCK];

    for (size_t i = 0; i < r->rows.count; i++)
        MUST(sweep_journal_read(&r->journal, &r->rows, i, 0, block, BLOCK,
                                &r->why) == STATUS_OK);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const bool whole = size >= 8 && memcmp(data, "slipswp", 8) == 0;
    const char *path = memory_file(data, whole ? size : 0);
    struct read r;

    if (!whole)
        put_records(path, data, size);
    const enum status s = begin(&r, path, true);
    MUST(s == STATUS_OK || s == STATUS_BAD_SCENE);
    if (s != STATUS_OK)
        must_be_a_line(&r.why);
    else
        check_rows(&r);
    end(&r);
    return 0;
}
