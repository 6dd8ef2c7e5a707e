#include "hdf.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Keeps the innermost reason; HDF5 puts times and new lines into some. */
static herr_t hdf_innermost(unsigned depth, const H5E_error2_t *error,
                            void *ctx)
{
    struct store *st = ctx;

    if (depth == 0 && error->desc != NULL && error->desc[0] != '\0') {
        snprintf(st->reason, sizeof st->reason, "%s", error->desc);
        st->reason[strcspn(st->reason, "\n")] = '\0';
    }
    return 0;
}

int64_t hdf_took(struct store *st, int64_t answer)
{
    if (answer < 0 && st->status == STATUS_OK) {
        hdf_fail(st, STATUS_IO, "HDF5 refused");
        H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, hdf_innermost, st);
    }
    return answer;
}

void hdf_fail(struct store *st, enum status s, const char *reason)
{
    if (st->status != STATUS_OK)
        return;
    st->status = s;
    snprintf(st->reason, sizeof st->reason, "%s", reason);
}

enum status hdf_blame(const struct store *st, struct fault *fault)
{
    if (st->status != STATUS_OK)
        snprintf(fault->text, sizeof fault->text, "%.250s: %s", st->path,
                 st->reason);
    return st->status;
}

void *hdf_memory(struct store *st, size_t count, size_t size)
{
    void *at = calloc(count > 0 ? count : 1, size);

    if (at == NULL)
        hdf_fail(st, STATUS_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    return at;
}

size_t hdf_size(struct store *st, hid_t type)
{
    const size_t size = H5Tget_size(type);

    hdf_took(st, size > 0 ? 0 : -1);
    return size;
}

void hdf_close(hid_t id)
{
    if (id >= 0)
        H5Idec_ref(id);
}

hid_t hdf_space(struct store *st, int rank, const hsize_t extent[])
{
    const int64_t set = hdf_took(
        st, H5Sset_extent_simple(st->handles.space, rank, extent, NULL));

    return set < 0 ? H5I_INVALID_HID : st->handles.space;
}

/* One step down; closes `parent`. */
static hid_t hdf_child(struct store *st, hid_t parent, const char *name)
{
    const int64_t found = hdf_took(st, H5Lexists(parent, name, H5P_DEFAULT));
    const hid_t group = found > 0 ? H5Gopen2(parent, name, H5P_DEFAULT)
                                  : H5Gcreate2(parent, name, H5P_DEFAULT,
                                               st->handles.group, H5P_DEFAULT);

    hdf_took(st, group);
    hdf_close(parent);
    return group;
}

static hid_t hdf_descend(struct store *st, const char *path)
{
    hid_t group = hdf_took(st, H5Gopen2(st->file, "/", H5P_DEFAULT));
    char name[256];

    assert(path[0] == '/');
    for (path++; path[0] != '\0'; path += path[0] == '/') {
        const size_t length = strcspn(path, "/");
        assert(length > 0 && length < sizeof name);
        memcpy(name, path, length);
        name[length] = '\0';
        group = hdf_child(st, group, name);
        path += length;
    }
    return group;
}

hid_t hdf_group(struct store *st, const char *path)
{
    if (st->group_path == NULL || strcmp(st->group_path, path) != 0) {
        hdf_close(st->group);
        free(st->group_path);
        st->group = hdf_descend(st, path);
        st->group_path = hdf_memory(st, strlen(path) + 1, 1);
        if (st->group_path != NULL)
            strcpy(st->group_path, path);
    }
    return st->group;
}

void hdf_put(struct store *st, hid_t object, const char *key, int rank,
             size_t count, hid_t type, hid_t native, const void *values)
{
    const hsize_t extent = count;
    const hid_t attribute =
        hdf_took(st, H5Acreate2(object, key, type, hdf_space(st, rank, &extent),
                                H5P_DEFAULT, H5P_DEFAULT));

    hdf_took(st, H5Awrite(attribute, native, values));
    hdf_close(attribute);
}

void hdf_put_text(struct store *st, hid_t object, const char *key,
                  const char *text)
{
    const size_t length = strlen(text);
    const int64_t set =
        hdf_took(st, H5Tset_size(st->handles.text, length > 0 ? length : 1));
    const hid_t type = set < 0 ? H5I_INVALID_HID : st->handles.text;

    hdf_put(st, object, key, 0, 1, type, type, text);
}
