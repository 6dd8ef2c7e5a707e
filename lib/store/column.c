#include "column.h"

#include <stdlib.h>
#include <string.h>

#include <hdf5_hl.h>

#include "tolerance.h"

enum { CODES_MAX = 127 };

static const int8_t no_code = -1;

struct column column_of(const struct record_field *f)
{
    return (struct column){ .name = f->name,
                            .unit = f->unit,
                            .text = f->text,
                            .kind = f->kind,
                            .codes = f->codes };
}

hid_t column_type(struct store *st, const struct column *c)
{
    switch (c->kind) {
        case RECORD_COUNT:
            return H5T_NATIVE_INT64;
        case RECORD_CODE:
            return H5T_NATIVE_INT8;
        case RECORD_TEXT:
            return hdf_text_type(st, H5T_VARIABLE);
        case RECORD_REAL:
        case RECORD_QUANTITY:
            break;
    }
    return H5T_NATIVE_DOUBLE;
}

void column_type_close(const struct column *c, hid_t type)
{
    if (c->kind == RECORD_TEXT)
        hdf_close(type);
}

/* As stored: little-endian everywhere, so that machines agree on bytes. */
static hid_t file_type(const struct column *c, hid_t type)
{
    if (c->kind == RECORD_COUNT)
        return H5T_STD_I64LE;
    if (c->kind == RECORD_CODE)
        return H5T_STD_I8LE;
    return c->kind == RECORD_TEXT ? type : H5T_IEEE_F64LE;
}

static void set_fill(struct store *st, hid_t list, const struct column *c)
{
    const double no_value = (double) __builtin_nanf("");

    if (c->kind == RECORD_REAL)
        hdf_took(st, H5Pset_fill_value(list, H5T_NATIVE_DOUBLE, &no_value));
    if (c->kind == RECORD_CODE)
        hdf_took(st, H5Pset_fill_value(list, H5T_NATIVE_INT8, &no_code));
}

static void put_fill(struct store *st, hid_t set, const struct column *c)
{
    const double no_value = (double) __builtin_nanf("");

    if (c->kind == RECORD_REAL)
        hdf_put_numbers(st, set, "_FillValue", H5T_IEEE_F64LE,
                        H5T_NATIVE_DOUBLE, 1, &no_value);
    if (c->kind == RECORD_CODE)
        hdf_put_numbers(st, set, "_FillValue", H5T_STD_I8LE, H5T_NATIVE_INT8, 1,
                        &no_code);
}

static void put_meanings(struct store *st, hid_t set, const char *const *codes)
{
    int8_t value[CODES_MAX];
    size_t count = 0, length = 1;
    char *words;

    for (; codes[count] != NULL && count < CODES_MAX; count++) {
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
    hdf_put_numbers(st, set, "flag_values", H5T_STD_I8LE, H5T_NATIVE_INT8,
                    count, value);
    hdf_put_text(st, set, "flag_meanings", words);
    free(words);
}

/* Large ones only; shuffling puts the slowly changing exponents together. */
static void set_layout(struct store *st, hid_t list, const struct column *c,
                       int rank, const hsize_t extent[])
{
    hsize_t chunk[2];

    if (rank != 2 || extent[0] == 0 || extent[1] == 0)
        return;
    for (int i = 0; i < 2; i++)
        chunk[i] = extent[i] < STORE_CHUNK ? extent[i] : STORE_CHUNK;
    hdf_took(st, H5Pset_chunk(list, 2, chunk));
    if (c->kind == RECORD_REAL)
        hdf_took(st, H5Pset_shuffle(list));
    hdf_took(st, H5Pset_deflate(list, STORE_DEFLATE));
}

/* The bare data set: type, shape, storage. */
static hid_t create(struct store *st, hid_t group, const struct column *c,
                    int rank, const hsize_t extent[])
{
    const hid_t list = hdf_properties(st, H5P_DATASET_CREATE);
    const hid_t space = hdf_took(st, H5Screate_simple(rank, extent, NULL));
    const hid_t type = column_type(st, c);
    hid_t set;

    set_fill(st, list, c);
    set_layout(st, list, c, rank, extent);
    set = hdf_took(st, H5Dcreate2(group, c->name, file_type(c, type), space,
                                  H5P_DEFAULT, list, H5P_DEFAULT));
    column_type_close(c, type);
    hdf_close(space);
    hdf_close(list);
    return set;
}

static void describe(struct store *st, hid_t set, const struct column *c)
{
    if (c->kind != RECORD_TEXT)
        hdf_put_text(st, set, "units", c->unit);
    hdf_put_text(st, set, "long_name", c->text);
    if (c->kind == RECORD_CODE)
        put_meanings(st, set, c->codes);
}

static hsize_t extent_of(struct store *st, hid_t axis)
{
    const hid_t space = hdf_took(st, H5Dget_space(axis));
    const int64_t extent = hdf_took(st, H5Sget_simple_extent_npoints(space));

    hdf_close(space);
    return extent > 0 ? (hsize_t) extent : 0;
}

hid_t column_create(struct store *st, hid_t group, const struct column *c,
                    int rank, const hid_t axis[])
{
    hsize_t extent[2] = { 0 };
    hid_t set;

    for (int i = 0; i < rank; i++)
        extent[i] = extent_of(st, axis[i]);
    set = create(st, group, c, rank, extent);
    describe(st, set, c);
    put_fill(st, set, c);
    for (int i = 0; i < rank; i++)
        hdf_took(st, H5DSattach_scale(set, axis[i], (unsigned) i));
    return set;
}

/* CF: a coordinate has no missing values, hence no `_FillValue`. */
hid_t column_axis(struct store *st, hid_t group, const struct column *c,
                  size_t count, const void *values)
{
    const hsize_t extent = count;
    const hid_t set = create(st, group, c, 1, &extent);

    hdf_took(st, H5DSset_scale(set, c->name));
    describe(st, set, c);
    column_write(st, set, c, values);
    return set;
}

void column_write(struct store *st, hid_t set, const struct column *c,
                  const void *values)
{
    const hid_t type = column_type(st, c);

    hdf_took(st, H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
    column_type_close(c, type);
}
