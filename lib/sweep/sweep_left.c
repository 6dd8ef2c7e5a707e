/* Side files are read as they are: only sweeps know which codes are those of
 * reasons, and reasons have other codes in each file. */
#include "sweep_left.h"

#include <stdlib.h>
#include <string.h>

/* The same for the same scene and version, wherever the results go. */
static uint64_t key_of(const struct sweep *s, const char *version)
{
    uint64_t sum = sweep_key_sum(s->scene, version);

    for (size_t k = 0; k < s->columns.count; k++)
        sum = sweep_journal_sum(sum, s->columns.at[k].name,
                                strlen(s->columns.at[k].name) + 1);
    for (size_t k = 0; k < s->layers.count; k++)
        sum = sweep_journal_sum(sum, s->layers.at[k].name,
                                strlen(s->layers.at[k].name) + 1);
    return sum;
}

static size_t count_words(const char *const *words)
{
    size_t n = 0;

    while (words[n])
        n++;
    return n;
}

/* Every code of a row means something: the checksum of a side file keeps out
 * accidents only. */
static bool is_sound(const struct sweep *s, const struct sweep_reasons *reasons,
                     const struct sweep_rows *rows, size_t i)
{
    bool sound = true;

    for (size_t k = 0; k < s->columns.count && sound; k++) {
        const struct sweep_column *c = &s->columns.at[k];
        const int8_t *code = sweep_rows_code(rows, i, c->first);
        const size_t words = c->codes ? count_words(c->codes) : reasons->count;
        for (size_t n = 0; n < c->entries; n++)
            sound &= (code[n] >= 0 && (size_t) code[n] < words) ||
                     (code[n] == -1 && c->codes);
    }
    return sound;
}

static void drop_unsound(const struct sweep *s,
                         const struct sweep_reasons *reasons,
                         struct sweep_rows *rows)
{
    size_t kept = 0;

    for (size_t i = 0; i < rows->count; i++)
        if (is_sound(s, reasons, rows, i))
            memmove(sweep_rows_row(rows, kept++), sweep_rows_row(rows, i),
                    rows->width * sizeof *rows->at);
    rows->count = kept;
}

static enum status open_own(struct sweep *s, const struct sweep_options *o,
                            struct sweep_rows *left, struct fault *why)
{
    return sweep_journal_open(&s->journal, o->journal, key_of(s, o->version),
                              s->layers.size, o->resume, left, &s->reasons,
                              &s->replaced, why);
}

/* ---- other side files ---------------------------------------------------- */

/* A code of the other's reasons as one of our own. */
static enum status translate(struct sweep *s, const struct sweep_reasons *other,
                             int8_t *code, struct fault *why)
{
    const size_t known = s->reasons.count;
    const char *text = other->text[*code];

    if (*code < REASON_FIRST)
        return STATUS_OK;
    const enum status status = sweep_reasons_code(&s->reasons, text, code);
    return status != STATUS_OK || s->reasons.count == known
               ? status
               : sweep_journal_reason(&s->journal, text, why);
}

static enum status translate_row(struct sweep *s, struct sweep_rows *rows,
                                 size_t i, const struct sweep_reasons *other,
                                 struct fault *why)
{
    enum status status = STATUS_OK;

    for (size_t k = 0; k < s->columns.count; k++) {
        const struct sweep_column *c = &s->columns.at[k];
        int8_t *code = sweep_rows_code(rows, i, c->first);
        for (size_t n = 0; !c->codes && n < c->entries && status == STATUS_OK;
             n++)
            status = translate(s, other, &code[n], why);
    }
    return status;
}

/* Appends the rows of an open side file, in the sweep's own words, to *left. */
static enum status take_rows(struct sweep *s, const struct sweep_journal *from,
                             struct sweep_rows *rows,
                             const struct sweep_reasons *reasons, bool copied,
                             struct sweep_rows *left, struct fault *why)
{
    const size_t size = rows->width * sizeof *rows->at, first = left->count;
    char *block = malloc(s->layers.size + 1);
    enum status status =
        block ? sweep_rows_add(left, rows->count) : STATUS_NO_MEMORY;

    for (size_t i = 0; i < rows->count && status == STATUS_OK; i++) {
        status = translate_row(s, rows, i, reasons, why);
        if (status == STATUS_OK && copied)
            status = sweep_journal_read(from, rows, i, 0, block, s->layers.size,
                                        why);
        memcpy(sweep_rows_row(left, first + i), sweep_rows_row(rows, i), size);
        if (status == STATUS_OK && copied)
            status =
                sweep_journal_row(&s->journal, left, first + i, block, why);
    }
    free(block);
    return status;
}

/* The sound rows of a side file, into the own one if they are copied. */
static enum status take_file(struct sweep *s, const struct sweep_options *o,
                             const char *path, struct sweep_rows *left,
                             struct fault *why)
{
    struct sweep_rows rows =
        sweep_rows_of(s->columns.entries, s->columns.conditioning);
    struct sweep_reasons reasons;
    struct sweep_journal from;
    enum status status = sweep_reasons_init(&reasons);

    if (status == STATUS_OK)
        status = sweep_journal_look(&from, path, key_of(s, o->version),
                                    s->layers.size, &rows, &reasons, why);
    if (status == STATUS_OK) {
        drop_unsound(s, &reasons, &rows);
        status = take_rows(s, &from, &rows, &reasons, o->join, left, why);
        sweep_journal_close(&from);
    }
    sweep_rows_free(&rows);
    sweep_reasons_free(&reasons);
    return status;
}

enum status sweep_left_open(struct sweep *s, const struct sweep_options *o,
                            struct sweep_rows *left, struct fault *why)
{
    enum status status = o->journal ? open_own(s, o, left, why) : STATUS_OK;

    if (status == STATUS_OK)
        drop_unsound(s, &s->reasons, left);
    for (size_t k = 0; k < o->others && status == STATUS_OK; k++)
        status = take_file(s, o, o->other[k], left, why);
    sweep_rows_sort(left);
    return status;
}
