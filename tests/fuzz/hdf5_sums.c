/* Jenkins' lookup3 (2006, public domain), a byte at a time. */
#include "hdf5_sums.h"

#include <string.h>

struct words {
    uint32_t a, b, c;
};

static uint32_t turn(uint32_t x, int by)
{
    return x << by | x >> (32 - by);
}

static struct words mix(struct words w)
{
    static const int by[] = { 4, 6, 8, 16, 19, 4 };

    for (int i = 0; i < 6; i++) {
        w.a -= w.c;
        w.a ^= turn(w.c, by[i]);
        w.c += w.b;
        w = (struct words){ w.b, w.c, w.a };
    }
    return w;
}

static struct words finish(struct words w)
{
    static const int by[] = { 14, 11, 25, 16, 4, 14, 24 };

    for (int i = 0; i < 7; i++) {
        w.c ^= w.b;
        w.c -= turn(w.b, by[i]);
        w = (struct words){ w.b, w.c, w.a };
    }
    return w;
}

/* Up to 12 bytes, little-endian. */
static struct words add(struct words w, const uint8_t *bytes, size_t count)
{
    uint8_t part[12] = { 0 };
    uint32_t x[3];

    memcpy(part, bytes, count);
    for (int i = 0; i < 3; i++)
        x[i] = (uint32_t) part[4 * i] | (uint32_t) part[4 * i + 1] << 8 |
               (uint32_t) part[4 * i + 2] << 16 |
               (uint32_t) part[4 * i + 3] << 24;
    return (struct words){ w.a + x[0], w.b + x[1], w.c + x[2] };
}

static uint32_t sum_of(const uint8_t *bytes, size_t size)
{
    const uint32_t start = 0xdeadbeefu + (uint32_t) size;
    struct words w = { start, start, start };

    for (; size > 12; size -= 12, bytes += 12)
        w = mix(add(w, bytes, 12));
    return size > 0 ? finish(add(w, bytes, size)).b : w.c;
}

struct file {
    uint8_t *bytes;
    size_t size;
};

/* Behind `length` bytes from `at` on. */
static void put_sum(const struct file *f, size_t at, size_t length)
{
    if (at > f->size || length > f->size - at || f->size - at - length < 4)
        return;
    const uint32_t sum = sum_of(f->bytes + at, length);
    for (int i = 0; i < 4; i++)
        f->bytes[at + length + (size_t) i] = (uint8_t) (sum >> 8 * i);
}

/* `count` bytes as a number; 0 beyond the file. */
static uint64_t number(const struct file *f, size_t at, size_t count)
{
    uint64_t x = 0;

    for (size_t i = 0; i < count && at < f->size && count <= f->size - at; i++)
        x |= (uint64_t) f->bytes[at + i] << 8 * i;
    return x;
}

/* Messages at .. end-1: continuations are blocks of their own. */
static void mend_messages(const struct file *f, size_t at, size_t end,
                          unsigned flags)
{
    const size_t head = flags & 4u ? 6 : 4;

    for (; at + head <= end && end <= f->size;
         at += head + (size_t) number(f, at + 1, 2)) {
        const uint64_t from = number(f, at + head, 8);
        const uint64_t length = number(f, at + head + 8, 8);
        if (f->bytes[at] == 0x10 && length > 4 && length < f->size &&
            from < f->size)
            put_sum(f, (size_t) from, (size_t) length - 4);
    }
}

static void mend_header(const struct file *f, size_t at)
{
    const unsigned flags = (unsigned) number(f, at + 5, 1);
    const size_t width = (size_t) 1 << (flags & 3u);
    const size_t prefix =
        6u + (flags & 0x20u ? 16u : 0u) + (flags & 0x10u ? 4u : 0u) + width;
    const uint64_t messages = number(f, at + prefix - width, width);

    if (messages >= f->size)
        return;
    mend_messages(f, at + prefix, at + prefix + (size_t) messages, flags);
    put_sum(f, at, prefix + (size_t) messages);
}

void hdf5_sums_mend(uint8_t *bytes, size_t size)
{
    const struct file f = { bytes, size };

    put_sum(&f, 0, 44);
    for (size_t at = 0; at + 8 <= size; at++) {
        if (memcmp(bytes + at, "OHDR", 4) == 0)
            mend_header(&f, at);
        else if (memcmp(bytes + at, "FRHP", 4) == 0)
            put_sum(&f, at, 142);
        else if (memcmp(bytes + at, "BTHD", 4) == 0)
            put_sum(&f, at, 34);
    }
}
