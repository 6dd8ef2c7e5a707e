#include "store_compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hdf.h"

struct compare {
    struct store *a, *b;
    bool backward; /* a is the second file, told is what b has not */
    void (*tell)(void *ctx, const struct store_difference *d);
    void *ctx;
    const char *path;  /* of the object in hand */
    hid_t before, now; /* that object in a and in b */
};

static void tell(const struct compare *c, const char *key, const char *what)
{
    c->tell(c->ctx, &(struct store_difference){
                        .path = c->path, .key = key, .what = what });
}

static void tell_alone(const struct compare *c, const char *key)
{
    tell(c, key, c->backward ? "only in the second" : "only in the first");
}

/* ---- values ----------------------------------------------------------------
 */

/* A data set or an attribute, as bytes; all owned. */
struct values {
    hid_t type, space;
    size_t count, size; /* elements, bytes of each */
    char *bytes;        /* NULL until read */
};

static struct values values_of(struct store *st, hid_t object, bool is_set)
{
    struct values v = { .bytes = NULL };

    v.type = hdf_took(st, is_set ? H5Dget_type(object) : H5Aget_type(object));
    v.space =
        hdf_took(st, is_set ? H5Dget_space(object) : H5Aget_space(object));
    v.size = H5Tget_size(v.type);
    v.count = (size_t) hdf_took(st, H5Sget_simple_extent_npoints(v.space));
    return v;
}

static void values_read(struct store *st, hid_t object, bool is_set,
                        struct values *v)
{
    if (st->status == STATUS_OK)
        v->bytes = hdf_memory(st, v->count, v->size);
    if (v->bytes == NULL)
        return;
    hdf_took(st, is_set ? H5Dread(object, v->type, H5S_ALL, H5S_ALL,
                                  H5P_DEFAULT, v->bytes)
                        : H5Aread(object, v->type, v->bytes));
}

static bool is_long_text(const struct values *v)
{
    return H5Tis_variable_str(v->type) > 0;
}

static void values_free(struct values *v)
{
    if (v->bytes && is_long_text(v))
        H5Dvlen_reclaim(v->type, v->space, H5P_DEFAULT, v->bytes);
    free(v->bytes);
    v->bytes = NULL;
    hdf_close(v->space);
    hdf_close(v->type);
}

static bool element_equals(const struct values *a, const struct values *b,
                           size_t i)
{
    const char *x = a->bytes + i * a->size, *y = b->bytes + i * b->size;
    const char *text[2];

    if (!is_long_text(a))
        return memcmp(x, y, a->size) == 0;
    memcpy(&text[0], x, sizeof text[0]);
    memcpy(&text[1], y, sizeof text[1]);
    return strcmp(text[0] ? text[0] : "", text[1] ? text[1] : "") == 0;
}

/* Of two doubles that differ; NaN where that says nothing. */
static double relative_difference(const struct values *a,
                                  const struct values *b, size_t i)
{
    double x, y;

    if (H5Tget_class(a->type) != H5T_FLOAT || a->size != sizeof x)
        return NAN;
    memcpy(&x, a->bytes + i * a->size, sizeof x);
    memcpy(&y, b->bytes + i * b->size, sizeof y);
    return fabs(x - y) / fmax(fabs(x), fabs(y));
}

/* How many values differ, and by how much. */
static void tell_values(const struct compare *c, const char *key,
                        const struct values *a, const struct values *b)
{
    char what[256];
    size_t differ = 0;
    double most = NAN;

    for (size_t i = 0; i < a->count; i++)
        if (!element_equals(a, b, i)) {
            differ++;
            most = fmax(most, relative_difference(a, b, i));
        }
    if (differ == 0)
        return;
    const int n = snprintf(what, sizeof what, "%zu of %zu values differ",
                           differ, a->count);
    if (!isnan(most))
        snprintf(what + n, sizeof what - (size_t) n, ", by up to %.1e of them",
                 most);
    tell(c, key, what);
}

/* One that fits in a message. */
static bool is_short_text(const struct values *v)
{
    return H5Tget_class(v->type) == H5T_STRING && !is_long_text(v) &&
           v->count == 1 && v->size < 80 && !memchr(v->bytes, '\n', v->size);
}

/* Their types hold their lengths, so they are not compared. */
static void tell_texts(const struct compare *c, const char *key,
                       const struct values *a, const struct values *b)
{
    char what[256];

    if (a->size == b->size && memcmp(a->bytes, b->bytes, a->size) == 0)
        return;
    snprintf(what, sizeof what, "'%.*s' and '%.*s'", (int) a->size, a->bytes,
             (int) b->size, b->bytes);
    tell(c, key, what);
}

static bool same_shape(const struct values *a, const struct values *b)
{
    return H5Sextent_equal(a->space, b->space) > 0;
}

static void compare_values(const struct compare *c, const char *key, hid_t x,
                           hid_t y, bool is_set)
{
    struct values a = values_of(c->a, x, is_set);
    struct values b = values_of(c->b, y, is_set);

    values_read(c->a, x, is_set, &a);
    values_read(c->b, y, is_set, &b);
    if (a.bytes && b.bytes && is_short_text(&a) && is_short_text(&b))
        tell_texts(c, key, &a, &b);
    else if (a.bytes && b.bytes && H5Tequal(a.type, b.type) <= 0)
        tell(c, key,
             H5Tget_class(a.type) == H5T_STRING ? "another text"
                                                : "another type");
    else if (a.bytes && b.bytes && !same_shape(&a, &b))
        tell(c, key, "another shape");
    else if (a.bytes && b.bytes)
        tell_values(c, key, &a, &b);
    values_free(&a);
    values_free(&b);
}

/* ---- objects ---------------------------------------------------------------
 */

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

/* Both are there. */
static herr_t compare_pair(struct compare *c)
{
    const bool is_set = H5Iget_type(c->before) == H5I_DATASET;

    if (is_set != (H5Iget_type(c->now) == H5I_DATASET)) {
        tell(c, "", "a group in one, a data set in the other");
        return 0;
    }
    if (is_set && !c->backward)
        compare_values(c, "", c->before, c->now, true);
    return H5Aiterate2(c->before, H5_INDEX_CRT_ORDER, H5_ITER_INC, NULL,
                       compare_attribute, c);
}

/* H5Lexists refuses a path through what is not there. */
static bool is_there(hid_t root, const char *name)
{
    return strcmp(name, ".") == 0 || H5Lexists(root, name, H5P_DEFAULT) > 0;
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
    if (!is_there(c->b->file, name)) {
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

static enum status walk(struct compare *c, struct fault *fault)
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
    enum status s = walk(&c, fault);

    if (s != STATUS_OK)
        return s;
    c = (struct compare){
        .a = b, .b = a, .backward = true, .tell = told, .ctx = ctx
    };
    return walk(&c, fault);
}
