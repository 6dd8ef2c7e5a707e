#include "store_compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hdf.h"
#include "store_read.h"
#include "tolerance.h"

struct compare {
    struct store *a, *b;
    bool backward; /* a is the second file, told is what b has not */
    void (*tell)(void *ctx, const struct store_difference *d);
    void *ctx;
    const char *path;  /* of the object in hand */
    hid_t before, now; /* that object in a and in b */
};

/* Nothing more after a failure, which may be why something looks different. */
static void store_compare_tell(const struct compare *c, const char *key,
                               const char *what)
{
    if (c->a->status != STATUS_OK || c->b->status != STATUS_OK)
        return;
    c->tell(c->ctx, &(struct store_difference){
                        .path = c->path, .key = key, .what = what });
}

static void tell_alone(const struct compare *c, const char *key)
{
    store_compare_tell(
        c, key, c->backward ? "only in the second" : "only in the first");
}

/* ---- values -------------------------------------------------------------- */

/* A data set or an attribute; all owned. */
struct values {
    struct store *st;
    hid_t object; /* borrowed */
    bool is_set;
    hid_t type, space;
    int64_t class;
    bool is_long; /* texts of any length: pointers to them are read */
    int rank;
    hsize_t extent[STORE_RANK_MAX];
    size_t count, size; /* elements, bytes of each */
};

static struct values values_of(struct store *st, hid_t object, bool is_set)
{
    struct values v = { .st = st, .object = object, .is_set = is_set };

    v.type = hdf_took(st, is_set ? H5Dget_type(object) : H5Aget_type(object));
    v.space =
        hdf_took(st, is_set ? H5Dget_space(object) : H5Aget_space(object));
    v.class = hdf_took(st, H5Tget_class(v.type));
    v.is_long = hdf_took(st, H5Tis_variable_str(v.type)) > 0;
    v.size = hdf_size(st, v.type);
    v.count = (size_t) hdf_took(st, H5Sget_simple_extent_npoints(v.space));
    v.rank =
        (int) hdf_took(st, H5Sget_simple_extent_dims(v.space, v.extent, NULL));
    return v;
}

static void values_free(struct values *v)
{
    hdf_close(v->space);
    hdf_close(v->type);
}

/* Some of the values, as bytes. */
struct block {
    hid_t space;
    size_t count;
    char *bytes; /* NULL: none, which is noted */
};

static bool is_healthy(const struct values *v)
{
    return v->st->status == STATUS_OK;
}

/* Rows first .. first + rows - 1 of a data set; all that there is of an
 * attribute or a scalar. */
static struct block block_read(struct values *v, size_t first, size_t rows)
{
    struct block b = { H5I_INVALID_HID, v->count, NULL };
    const hsize_t start[STORE_RANK_MAX] = { first };
    hsize_t extent[STORE_RANK_MAX];

    if (v->is_set && v->rank > 0) {
        memcpy(extent, v->extent, sizeof extent);
        b.count = v->count / extent[0] * rows;
        extent[0] = rows;
        hdf_took(v->st, H5Sselect_hyperslab(v->space, H5S_SELECT_SET, start,
                                            NULL, extent, NULL));
        b.space = hdf_took(v->st, H5Screate_simple(v->rank, extent, NULL));
    } else {
        b.space = hdf_took(v->st, H5Scopy(v->space));
    }
    if (is_healthy(v))
        b.bytes = hdf_memory(v->st, b.count, v->size);
    if (b.bytes != NULL)
        hdf_took(v->st, v->is_set ? H5Dread(v->object, v->type, b.space,
                                            v->space, H5P_DEFAULT, b.bytes)
                                  : H5Aread(v->object, v->type, b.bytes));
    return b;
}

static void block_free(struct block *b, const struct values *v)
{
    if (b->bytes != NULL && v->is_long)
        H5Dvlen_reclaim(v->type, b->space, H5P_DEFAULT, b->bytes);
    free(b->bytes);
    hdf_close(b->space);
}

/* Rows of a data set that make a block. */
static size_t rows_of(const struct values *v)
{
    const size_t row =
        v->rank > 0 && v->extent[0] > 0 ? v->count / v->extent[0] * v->size : 0;

    return row > 0 && CHILD_BLOCK > row ? CHILD_BLOCK / row : 1;
}

/* ---- comparing values ---------------------------------------------------- */

static bool element_equals(const struct values *v, const char *x, const char *y)
{
    const char *text[2];

    if (!v->is_long)
        return memcmp(x, y, v->size) == 0;
    memcpy(&text[0], x, sizeof text[0]);
    memcpy(&text[1], y, sizeof text[1]);
    return strcmp(text[0] ? text[0] : "", text[1] ? text[1] : "") == 0;
}

/* Of two doubles that differ; NaN where that says nothing. */
static double relative_difference(const struct values *v, const char *at,
                                  const char *other)
{
    double x, y;

    if (v->class != H5T_FLOAT || v->size != sizeof x)
        return (double) NAN;
    memcpy(&x, at, sizeof x);
    memcpy(&y, other, sizeof y);
    return fabs(x - y) / fmax(fabs(x), fabs(y));
}

/* How many values differ, and by how much. */
struct tally {
    size_t differ;
    double most;
};

static void count_block(struct tally *t, struct values *a, struct values *b,
                        size_t first, size_t rows)
{
    struct block x = block_read(a, first, rows);
    struct block y = block_read(b, first, rows);

    for (size_t i = 0; i < x.count && is_healthy(a) && is_healthy(b); i++) {
        const char *p = x.bytes + i * a->size, *q = y.bytes + i * b->size;
        if (element_equals(a, p, q))
            continue;
        t->differ++;
        t->most = fmax(t->most, relative_difference(a, p, q));
    }
    block_free(&x, a);
    block_free(&y, b);
}

/* Of the same type and shape.  Block by block: whole maps fill memory. */
static void tell_values(const struct compare *c, const char *key,
                        struct values *a, struct values *b)
{
    const size_t rows = a->is_set && a->rank > 0 ? a->extent[0] : 1;
    const size_t step = rows_of(a);
    struct tally t = { 0, (double) NAN };
    char what[256];

    for (size_t i = 0; i < rows && is_healthy(a) && is_healthy(b); i += step)
        count_block(&t, a, b, i, rows - i < step ? rows - i : step);
    if (t.differ == 0)
        return;
    const int n = snprintf(what, sizeof what, "%zu of %zu values differ",
                           t.differ, a->count);
    if (!isnan(t.most))
        snprintf(what + n, sizeof what - (size_t) n, ", by up to %.1e of them",
                 t.most);
    store_compare_tell(c, key, what);
}

enum { SHORT_TEXT = 80 };

/* One that fits in a message, put there; else empty. */
static void short_text(struct values *v, char text[SHORT_TEXT])
{
    memset(text, '\0', SHORT_TEXT);
    if (v->class != H5T_STRING || v->is_long || v->count != 1 ||
        v->size >= SHORT_TEXT)
        return;
    struct block b = block_read(v, 0, 1);
    if (b.bytes != NULL && !memchr(b.bytes, '\n', v->size) &&
        !memchr(b.bytes, '\0', v->size))
        memcpy(text, b.bytes, v->size);
    block_free(&b, v);
}

/* Lengths of texts are part of their types: those are not compared. */
static bool tell_texts(const struct compare *c, const char *key,
                       struct values *a, struct values *b)
{
    char x[SHORT_TEXT], y[SHORT_TEXT], what[2 * SHORT_TEXT + 16];

    short_text(a, x);
    short_text(b, y);
    if (x[0] == '\0' || y[0] == '\0')
        return false;
    snprintf(what, sizeof what, "'%s' and '%s'", x, y);
    if (strcmp(x, y) != 0)
        store_compare_tell(c, key, what);
    return true;
}

/* Type and shape first: a hostile file may say that it holds any number of
 * values. */
static void tell_pair(const struct compare *c, const char *key,
                      struct values *a, struct values *b)
{
    if (!is_healthy(a) || !is_healthy(b) || tell_texts(c, key, a, b))
        return;
    if (hdf_took(a->st, H5Tequal(a->type, b->type)) <= 0)
        store_compare_tell(
            c, key, a->class == H5T_STRING ? "another text" : "another type");
    else if (hdf_took(a->st, H5Sextent_equal(a->space, b->space)) <= 0)
        store_compare_tell(c, key, "another shape");
    else
        tell_values(c, key, a, b);
}

static void compare_values(const struct compare *c, const char *key, hid_t x,
                           hid_t y, bool is_set)
{
    struct values a = values_of(c->a, x, is_set);
    struct values b = values_of(c->b, y, is_set);

    tell_pair(c, key, &a, &b);
    values_free(&a);
    values_free(&b);
}

/* ---- objects ------------------------------------------------------------- */

/* References, alone or in rows, point into their own file. */
static bool is_tie(const char *key)
{
    return strcmp(key, "DIMENSION_LIST") == 0 ||
           strcmp(key, "REFERENCE_LIST") == 0;
}

static herr_t compare_attribute(hid_t object, const char *key,
                                const H5A_info_t *info, void *ctx)
{
    const struct compare *c = ctx;
    const int64_t there = hdf_took(c->b, H5Aexists(c->now, key));

    (void) info;
    if (is_tie(key))
        return 0;
    if (there == 0)
        tell_alone(c, key);
    if (there <= 0 || c->backward)
        return 0; /* walk() sees a failure */
    const hid_t x = hdf_took(c->a, H5Aopen(object, key, H5P_DEFAULT));
    const hid_t y = hdf_took(c->b, H5Aopen(c->now, key, H5P_DEFAULT));
    compare_values(c, key, x, y, false);
    hdf_close(x);
    hdf_close(y);
    return c->a->status || c->b->status ? -1 : 0;
}

static bool is_data(struct store *st, hid_t object)
{
    return hdf_took(st, H5Iget_type(object)) == H5I_DATASET;
}

/* Both are there. */
static herr_t compare_pair(struct compare *c)
{
    const bool is_set = is_data(c->a, c->before);

    if (is_set != is_data(c->b, c->now)) {
        store_compare_tell(c, "", "a group in one, a data set in the other");
        return 0;
    }
    if (is_set && !c->backward)
        compare_values(c, "", c->before, c->now, true);
    return H5Aiterate2(c->before, H5_INDEX_CRT_ORDER, H5_ITER_INC, NULL,
                       compare_attribute, c);
}

/* Asked group by group, because H5Lexists refuses a path through what is not
 * there. */
static bool is_there(struct store *st, const char *path)
{
    char *part = hdf_memory(st, strlen(path) + 1, 1);
    bool there = part != NULL;

    for (size_t end = 1; there && path[end - 1] != '\0'; end++) {
        if (path[end] != '/' && path[end] != '\0')
            continue;
        memcpy(part, path, end);
        there = hdf_took(st, H5Lexists(st->file, part, H5P_DEFAULT)) > 0;
    }
    free(part);
    return there;
}

static herr_t compare_object(hid_t root, const char *name,
                             const H5O_info_t *info, void *ctx)
{
    struct compare *c = ctx;
    const size_t room = strlen(name) + 2;
    char *path = hdf_memory(c->a, room, 1);
    herr_t answer = 0;

    (void) info;
    if (path == NULL)
        return -1;
    snprintf(path, room, "/%s", strcmp(name, ".") == 0 ? "" : name);
    c->path = path;
    if (strcmp(name, ".") != 0 && !is_there(c->b, name)) {
        tell_alone(c, "");
    } else {
        c->before = hdf_took(c->a, H5Oopen(root, name, H5P_DEFAULT));
        c->now = hdf_took(c->b, H5Oopen(c->b->file, name, H5P_DEFAULT));
        if (c->before >= 0 && c->now >= 0)
            answer = compare_pair(c);
        hdf_close(c->before);
        hdf_close(c->now);
    }
    free(path);
    return c->a->status || c->b->status ? -1 : answer;
}

static enum status store_compare_walk(struct compare *c, struct fault *fault)
{
    hdf_took(c->a, H5Ovisit2(c->a->file, H5_INDEX_CRT_ORDER, H5_ITER_INC,
                             compare_object, c, H5O_INFO_BASIC));
    return c->b->status ? hdf_blame(c->b, fault) : hdf_blame(c->a, fault);
}

enum status store_compare(struct store *a, struct store *b,
                          void (*told)(void *ctx,
                                       const struct store_difference *d),
                          void *ctx, struct fault *fault)
{
    struct compare c = { .a = a, .b = b, .tell = told, .ctx = ctx };
    enum status s = store_compare_walk(&c, fault);

    if (s != STATUS_OK)
        return s;
    c = (struct compare){
        .a = b, .b = a, .backward = true, .tell = told, .ctx = ctx
    };
    return store_compare_walk(&c, fault);
}
