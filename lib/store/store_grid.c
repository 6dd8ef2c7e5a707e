#include "store_grid.h"

#include <assert.h>

#include "column.h"
#include "tolerance.h"

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

enum status store_axis_length(struct store *st, const char *path,
                              const char *name, size_t *count)
{
    const struct axis *axis = NULL;

    if (st->status == STATUS_OK)
        axis = axis_find(st, hdf_group(st, path), name);
    if (axis != NULL)
        *count = axis->extent;
    return st->status;
}

_Static_assert((int) STORE_AXES == (int) AXES_MAX, "columns have as many axes");

enum status store_put_cube(struct store *st, const char *path,
                           const struct record_field *f, size_t rank,
                           const char *const name[])
{
    const struct column c = column_of(f);
    struct axis *axis[AXES_MAX];
    bool all = true;

    assert(f->kind == RECORD_REAL || f->kind == RECORD_CODE);
    assert(rank <= AXES_MAX);
    if (st->status != STATUS_OK)
        return st->status;
    const hid_t group = hdf_group(st, path);
    for (size_t i = 0; i < rank && all; i++)
        all = (axis[i] = axis_find(st, group, name[i])) != NULL;
    if (all)
        hdf_close(column_create(st, group, &c, (int) rank, axis));
    return st->status;
}

/* From start[] on, block[] values along each axis; 0: all there are. */
static void write_block(struct store *st, const char *path,
                        const struct record_field *f,
                        const hsize_t start[AXES_MAX], hsize_t block[AXES_MAX],
                        const void *values)
{
    const struct column c = column_of(f);
    const hid_t group = hdf_group(st, path);
    const hid_t set = hdf_took(st, H5Dopen2(group, f->name, H5P_DEFAULT));
    const hid_t file = hdf_took(st, H5Dget_space(set));
    hsize_t extent[AXES_MAX] = { 0 };
    const int rank = H5Sget_simple_extent_dims(file, extent, NULL);

    for (int i = 0; i < rank; i++)
        block[i] = block[i] ? block[i] : extent[i];
    const hid_t memory = hdf_took(st, H5Screate_simple(rank, block, NULL));
    hdf_took(st, H5Sselect_hyperslab(file, H5S_SELECT_SET, start, NULL, block,
                                     NULL));
    hdf_took(st, H5Dwrite(set, column_type(st, &c), memory, file, H5P_DEFAULT,
                          values));
    hdf_close(memory);
    hdf_close(file);
    hdf_close(set);
}

enum status store_put_index(struct store *st, const char *path,
                            const char *name, const char *text, size_t count)
{
    const struct record_field f = {
        .name = name, .unit = "1", .text = text, .kind = RECORD_COUNT
    };
    const struct column c = column_of(&f);
    int64_t values[STORE_INDEX];

    if (st->status == STATUS_OK)
        column_axis(st, hdf_group(st, path), &c, count, NULL);
    for (size_t first = 0; first < count; first += STORE_INDEX) {
        const hsize_t start[AXES_MAX] = { first };
        const size_t left = count - first;
        hsize_t block[AXES_MAX] = { left < STORE_INDEX ? left : STORE_INDEX };
        for (size_t i = 0; i < block[0]; i++)
            values[i] = (int64_t) (first + i);
        if (st->status == STATUS_OK)
            write_block(st, path, &f, start, block, values);
    }
    return st->status;
}

enum status store_put_rows(struct store *st, const char *path,
                           const struct record_field *f, size_t first,
                           size_t count, const void *values)
{
    const hsize_t start[AXES_MAX] = { first };
    hsize_t block[AXES_MAX] = { count };

    assert(count > 0);
    if (st->status == STATUS_OK)
        write_block(st, path, f, start, block, values);
    return st->status;
}

enum status store_put_slab(struct store *st, const char *path,
                           const struct record_field *f, size_t fixed,
                           const size_t at[], const void *values)
{
    hsize_t start[AXES_MAX] = { 0 }, block[AXES_MAX] = { 0 };

    assert(fixed <= AXES_MAX);
    for (size_t i = 0; i < fixed; i++) {
        start[i] = at[i];
        block[i] = 1;
    }
    if (st->status == STATUS_OK)
        write_block(st, path, f, start, block, values);
    return st->status;
}
