#include "column.h"

#include <stdlib.h>
#include <string.h>

#include "tolerance.h"
#include "unit.h"

enum { CODES_MAX = 127 };

struct column column_of(const struct record_field *f)
{
    return (struct column){ .name = f->name,
                            .unit = f->unit,
                            .text = f->text,
                            .kind = f->kind,
                            .codes = f->codes };
}

/* In memory, or as stored: little-endian everywhere, so that machines agree on
 * bytes. */
static hid_t type_of(const struct store *st, const struct column *c,
                     bool stored)
{
    switch (c->kind) {
        case RECORD_COUNT:
            return stored ? H5T_STD_I64LE : H5T_NATIVE_INT64;
        case RECORD_CODE:
            return stored ? H5T_STD_I8LE : H5T_NATIVE_INT8;
        case RECORD_TEXT:
            return st->handles.texts;
        case RECORD_REAL:
        case RECORD_QUANTITY:
            break;
    }
    return stored ? H5T_IEEE_F64LE : H5T_NATIVE_DOUBLE;
}

hid_t column_type(const struct store *st, const struct column *c)
{
    return type_of(st, c, false);
}

static void put_fill(struct store *st, hid_t set, const struct column *c)
{
    const double no_value = (double) __builtin_nanf("");
    const int8_t no_code = -1;

    if (c->kind == RECORD_REAL)
        hdf_put(st, set, "_FillValue", 1, 1, type_of(st, c, true),
                column_type(st, c), &no_value);
    if (c->kind == RECORD_CODE)
        hdf_put(st, set, "_FillValue", 1, 1, type_of(st, c, true),
                column_type(st, c), &no_code);
}

static void put_meanings(struct store *st, hid_t set, const char *const *codes)
{
    int8_t value[CODES_MAX];
    size_t count = 0, length = 1;
    char *words;

    for (; count < CODES_MAX && codes[count] != NULL; count++) {
        value[count] = (int8_t) count;
        length += strlen(codes[count]) + 1;
    }
    words = hdf_memory(st, length, 1);
    if (words == NULL)
        return;
    for (size_t i = 0; i < count; i++) {
        strcat(words, i > 0 ? " " : "");
        strcat(words, codes[i]);
    }
    hdf_put(st, set, "flag_values", 1, count, H5T_STD_I8LE, H5T_NATIVE_INT8,
            value);
    hdf_put_text(st, set, "flag_meanings", words);
    free(words);
}

/* Compressed chunks; shuffling puts the slowly changing exponents together.
 * The caller closes it. */
static hid_t column_chunked(struct store *st, const struct column *c, int rank,
                            const hsize_t extent[])
{
    const hid_t list = hdf_took(st, H5Pcopy(st->handles.set[c->kind]));
    hsize_t chunk[AXES_MAX];

    for (int i = 0; i < rank; i++) {
        const hsize_t most = i < rank - 2 ? 1 : STORE_CHUNK;
        chunk[i] = extent[i] < most ? extent[i] : most;
    }
    hdf_took(st, H5Pset_chunk(list, rank, chunk));
    if (c->kind == RECORD_REAL)
        hdf_took(st, H5Pset_shuffle(list));
    hdf_took(st, H5Pset_deflate(list, STORE_DEFLATE));
    return list;
}

/* The bare data set: type, shape, storage. */
static hid_t column_make_set(struct store *st, hid_t group,
                             const struct column *c, int rank,
                             const hsize_t extent[])
{
    hsize_t values = 1;

    for (int i = 0; i < rank; i++)
        values *= extent[i];
    const bool large = rank >= 2 && values >= STORE_LARGE;
    const hid_t list =
        large ? column_chunked(st, c, rank, extent) : st->handles.set[c->kind];
    const hid_t set =
        hdf_took(st, H5Dcreate2(group, c->name, type_of(st, c, true),
                                hdf_space(st, rank, extent), H5P_DEFAULT, list,
                                H5P_DEFAULT));
    if (large)
        hdf_close(list);
    return set;
}

static void column_describe(struct store *st, hid_t set, const struct column *c)
{
    if (c->kind != RECORD_TEXT)
        hdf_put_text(st, set, "units", unit_plain(c->unit));
    if (unit_factor(c->unit))
        hdf_put_text(st, set, "scale", unit_factor(c->unit));
    hdf_put_text(st, set, "long_name", c->text);
    if (c->kind == RECORD_CODE)
        put_meanings(st, set, c->codes);
}

hid_t column_create(struct store *st, hid_t group, const struct column *c,
                    int rank, struct axis *const axis[])
{
    hsize_t extent[AXES_MAX];
    hid_t set;

    for (int i = 0; i < rank; i++)
        extent[i] = axis[i]->extent;
    set = column_make_set(st, group, c, rank, extent);
    column_describe(st, set, c);
    put_fill(st, set, c);
    if (rank > 0)
        axis_tie(st, set, rank, axis);
    return set;
}

/* CF: a coordinate has no missing values, hence no `_FillValue`. */
struct axis *column_axis(struct store *st, hid_t group, const struct column *c,
                         size_t count, const void *values)
{
    const hsize_t extent = count;
    const hid_t set = column_make_set(st, group, c, 1, &extent);
    struct axis *axis = axis_new(st, set, c->name, extent);

    if (axis != NULL) {
        column_describe(st, set, c);
        if (values != NULL)
            column_write(st, set, c, values);
    }
    return axis;
}

void column_write(struct store *st, hid_t set, const struct column *c,
                  const void *values)
{
    hdf_took(st, H5Dwrite(set, column_type(st, c), H5S_ALL, H5S_ALL,
                          H5P_DEFAULT, values));
}
