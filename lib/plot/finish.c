#include "finish.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A file in memory. */
struct text {
    char *at; /* owned, ends in 0 */
    size_t size;
};

static enum status text_read(const char *path, struct text *t)
{
    FILE *file = fopen(path, "rb");
    long size = 0;

    *t = (struct text){ NULL, 0 };
    if (!file)
        return STATUS_IO;
    if (fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0) {
        t->size = (size_t) size;
        t->at = malloc(t->size + 1);
        rewind(file);
    }
    const bool read = t->at && fread(t->at, 1, t->size, file) == t->size;
    fclose(file);
    if (read)
        t->at[t->size] = '\0';
    return read ? STATUS_OK : t->at ? STATUS_IO : STATUS_NO_MEMORY;
}

/* Writes it, if all went well, and frees it. */
static enum status text_write(const char *path, enum status s, struct text *t)
{
    FILE *file = s == STATUS_OK ? fopen(path, "wb") : NULL;

    if (s == STATUS_OK && !file)
        s = STATUS_IO;
    if (file && fwrite(t->at, 1, t->size, file) != t->size)
        s = STATUS_IO;
    if (file && fclose(file) != 0)
        s = STATUS_IO;
    free(t->at);
    return s;
}

/* Puts `size` bytes in the place of `old` bytes. */
static enum status text_replace(struct text *t, size_t at, size_t old,
                                const void *by, size_t size)
{
    char *now = malloc(t->size - old + size + 1);

    if (!now)
        return STATUS_NO_MEMORY;
    memcpy(now, t->at, at);
    memcpy(now + at, by, size);
    memcpy(now + at + size, t->at + at + old, t->size - at - old + 1);
    free(t->at);
    *t = (struct text){ now, t->size - old + size };
    return STATUS_OK;
}

/* ---- SVG ----------------------------------------------------------------- */

enum status finish_svg(const char *path, double width,
                       const struct script_size *size)
{
    struct text t;
    char head[200];
    enum status s = text_read(path, &t);
    const char *from = s == STATUS_OK ? strstr(t.at, " width=\"") : NULL;
    const char *view = from ? strstr(from, "viewBox=\"") : NULL;
    const char *end = view ? strchr(view + strlen("viewBox=\""), '"') : NULL;

    if (!end)
        return text_write(path, s == STATUS_OK ? STATUS_IO : s, &t);
    const int n = snprintf(head, sizeof head,
                           " width=\"%.9gmm\" height=\"%.9gmm\"\n "
                           "viewBox=\"0 0 %.9g %.9g\"\n "
                           "xml:space=\"preserve\"",
                           width, size->height, size->wide, size->high);
    s = text_replace(&t, (size_t) (from - t.at), (size_t) (end + 1 - from),
                     head, (size_t) n);
    return text_write(path, s, &t);
}

/* ---- PDF ----------------------------------------------------------------- */

static void reset_dates(struct text *t)
{
    static const char key[] = "/CreationDate (D:";
    static const char epoch[] = "19700101000000";
    char *end = t->at + t->size, *at = t->at;

    while ((at = memmem(at, (size_t) (end - at), key, sizeof key - 1))) {
        at += sizeof key - 1;
        for (size_t k = 0; epoch[k] && at < end && isdigit((unsigned char) *at);
             k++)
            *at++ = epoch[k];
    }
}

static char *finish_find(const struct text *t, size_t from, const char *key)
{
    return memmem(t->at + from, t->size - from, key, strlen(key));
}

/* What lies beyond `at` has moved: the table of objects (PDF 1.7, 7.5.4), whose
 * offsets have ten digits, and where it is itself. */
static enum status move_objects(struct text *t, size_t at, long by)
{
    char *table = finish_find(t, at, "\nxref\n"),
         *start = finish_find(t, at, "\nstartxref\n");
    char *row = table ? strchr(table + strlen("\nxref\n"), '\n') : NULL;
    char number[48];

    if (!row || !start)
        return STATUS_IO;
    for (row++; isdigit((unsigned char) *row); row += 20) {
        const long offset = strtol(row, NULL, 10);
        snprintf(number, sizeof number, "%010ld",
                 offset > (long) at ? offset + by : offset);
        if (row[17] == 'n')
            memcpy(row, number, 10);
    }
    start += strlen("\nstartxref\n");
    const int n =
        snprintf(number, sizeof number, "%ld", strtol(start, NULL, 10) + by);
    return text_replace(t, (size_t) (start - t->at),
                        strspn(start, "0123456789"), number, (size_t) n);
}

/* The page's box: the upper left part of what is drawn. */
static enum status set_box(struct text *t, const struct script_size *size)
{
    static const char key[] = "/MediaBox [";
    const char *box = finish_find(t, 0, key);
    const char *end = box ? strchr(box, ']') : NULL;
    char now[128];
    double high;

    if (!end || sscanf(box + strlen(key), "%*f %*f %*f %lf", &high) != 1)
        return STATUS_IO;
    const int n = snprintf(now, sizeof now, "%s 0 %.6f %.6f %.6f ", key,
                           high - size->high, size->wide, high);
    const size_t at = (size_t) (box - t->at), old = (size_t) (end - box);
    const enum status s = text_replace(t, at, old, now, (size_t) n);
    return s ? s : move_objects(t, at, (long) n - (long) old);
}

enum status finish_pdf(const char *path, const struct script_size *size)
{
    struct text t;
    enum status s = text_read(path, &t);

    if (s == STATUS_OK) {
        reset_dates(&t);
        s = set_box(&t, size);
    }
    return text_write(path, s, &t);
}

/* ---- PNG ----------------------------------------------------------------- */

/* Of ISO 3309, as PNG has it, bit by bit. */
static uint32_t finish_checksum(const unsigned char *at, size_t size)
{
    uint32_t c = 0xffffffff;

    for (size_t k = 0; k < size; k++) {
        c ^= at[k];
        for (int bit = 0; bit < 8; bit++)
            c = c & 1 ? 0xedb88320 ^ c >> 1 : c >> 1;
    }
    return ~c;
}

static void put_number(unsigned char *at, uint32_t x)
{
    for (int k = 0; k < 4; k++)
        at[k] = (unsigned char) (x >> (24 - 8 * k));
}

enum status finish_png(const char *path, double dpi)
{
    enum { HEADER = 33, CHUNK = 21 }; /* what stands first; ours */
    unsigned char chunk[CHUNK] = "\0\0\0\x09pHYs";
    struct text t;
    enum status s = text_read(path, &t);

    put_number(chunk + 8, (uint32_t) lround(dpi / 0.0254));
    put_number(chunk + 12, (uint32_t) lround(dpi / 0.0254));
    chunk[16] = 1; /* per metre */
    put_number(chunk + 17, finish_checksum(chunk + 4, 13));
    if (s == STATUS_OK)
        s = t.size < HEADER ? STATUS_IO
                            : text_replace(&t, HEADER, 0, chunk, CHUNK);
    return text_write(path, s, &t);
}
