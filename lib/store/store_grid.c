#include "store_grid.h"

#include <assert.h>

#include "column.h"

enum status store_put_axis(struct store *st, const char *path, const char *name,
                           const char *unit, const char *text, size_t count,
                           const double *values)
{
    const struct column c = {
        .name = name, .unit = unit, .text = text, .kind = RECORD_REAL
    };
    if (st->status == STATUS_OK)
        column_axis(st, hdf_group(st, path), &c, count, values);
    return st->status;
}

enum status store_put_column(struct store *st, const char *path,
                             const struct record_field *f, const char *name,
                             const void *values)
{
    const struct column c = column_of(f);

    assert(f->kind == RECORD_REAL || f->kind == RECORD_CODE);
    if (st->status == STATUS_OK) {
        const hid_t group = hdf_group(st, path);
        struct axis *const axis = axis_find(st, group, name);
        if (axis != NULL) {
            const hid_t set = column_create(st, group, &c, 1, &axis);
            column_write(st, set, &c, values);
            hdf_close(set);
        }
    }
    return st->status;
}

enum status store_put_layer(struct store *st, const char *path,
                            const struct record_field *f, const char *row,
                            const char *column)
{
    const struct column c = column_of(f);

    assert(f->kind == RECORD_REAL || f->kind == RECORD_CODE);
    if (st->status == STATUS_OK) {
        const hid_t group = hdf_group(st, path);
        struct axis *const axis[2] = { axis_find(st, group, row),
                                       axis_find(st, group, column) };
        if (axis[0] != NULL && axis[1] != NULL)
            hdf_close(column_create(st, group, &c, 2, axis));
    }
    return st->status;
}

static void write_rows(struct store *st, hid_t set, const struct column *c,
                       size_t first, size_t count, const void *values)
{
    const hid_t file = hdf_took(st, H5Dget_space(set));
    const hsize_t start[2] = { first, 0 };
    hsize_t block[2] = { 0 };
    hid_t memory;

    hdf_took(st, H5Sget_simple_extent_dims(file, block, NULL));
    block[0] = count;
    memory = hdf_took(st, H5Screate_simple(2, block, NULL));
    hdf_took(st, H5Sselect_hyperslab(file, H5S_SELECT_SET, start, NULL, block,
                                     NULL));
    hdf_took(st, H5Dwrite(set, column_type(st, c), memory, file, H5P_DEFAULT,
                          values));
    hdf_close(memory);
    hdf_close(file);
}

enum status store_put_rows(struct store *st, const char *path,
                           const struct record_field *f, size_t first,
                           size_t count, const void *values)
{
    const struct column c = column_of(f);

    if (st->status == STATUS_OK) {
        const hid_t group = hdf_group(st, path);
        const hid_t set = hdf_took(st, H5Dopen2(group, f->name, H5P_DEFAULT));
        write_rows(st, set, &c, first, count, values);
        hdf_close(set);
    }
    return st->status;
}
