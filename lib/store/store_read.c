#include "store_read.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hdf.h"

struct visit {
    struct store *st;
    int (*visitor)(void *ctx, const struct store_item *item);
    void *ctx;
    const char *path; /* of the object being told of */
};

/* The value of an open attribute, owned by the caller; NULL when it is no
 * text of fixed length, or noted as out of memory. */
static char *read_attribute(struct store *st, hid_t attribute)
{
    const hid_t type = hdf_took(st, H5Aget_type(attribute));
    const hid_t space = hdf_took(st, H5Aget_space(attribute));
    char *text = NULL;
    size_t size = 0;

    if (hdf_took(st, H5Tget_class(type)) == H5T_STRING &&
        hdf_took(st, H5Tis_variable_str(type)) == 0 &&
        hdf_took(st, H5Sget_simple_extent_npoints(space)) == 1)
        size = hdf_size(st, type);
    if (size > 0)
        text = hdf_memory(st, size + 1, 1);
    if (text != NULL)
        hdf_took(st, H5Aread(attribute, type, text));
    hdf_close(space);
    hdf_close(type);
    return text;
}

/* NULL when the object has no such text. */
static char *read_text(struct store *st, hid_t object, const char *key)
{
    char *text = NULL;

    if (hdf_took(st, H5Aexists(object, key)) > 0) {
        const hid_t attribute = hdf_took(st, H5Aopen(object, key, 0));
        text = read_attribute(st, attribute);
        hdf_close(attribute);
    }
    return text;
}

static bool is_plumbing(const char *key)
{
    static const char *const known[] = { "units", "long_name", "CLASS",
                                         "NAME" };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (strcmp(key, known[i]) == 0)
            return true;
    return false;
}

/* Answers of the visitor and of HDF5 share one number here: HDF5 stops at any
 * non-zero, and a negative one is a failure. */
static herr_t store_read_tell(const struct visit *v,
                              const struct store_item *item)
{
    if (v->st->status != STATUS_OK)
        return -1;
    return v->visitor(v->ctx, item) != 0 ? 1 : 0;
}

static herr_t tell_text(hid_t object, const char *key, const H5A_info_t *info,
                        void *ctx)
{
    const struct visit *v = ctx;
    herr_t answer = 0;
    char *text = NULL;

    (void) info;
    if (!is_plumbing(key))
        text = read_text(v->st, object, key);
    if (text != NULL)
        answer = store_read_tell(v, &(struct store_item){ .kind = STORE_TEXT,
                                                          .path = v->path,
                                                          .units = "",
                                                          .long_name = "",
                                                          .key = key,
                                                          .text = text });
    free(text);
    return v->st->status == STATUS_OK ? answer : -1;
}

static herr_t tell_dataset(const struct visit *v, hid_t set)
{
    char *units = read_text(v->st, set, "units");
    char *long_name = read_text(v->st, set, "long_name");
    const hid_t space = hdf_took(v->st, H5Dget_space(set));
    hsize_t extent[STORE_RANK_MAX] = { 0 };
    struct store_item item = { .kind = STORE_DATASET,
                               .path = v->path,
                               .units = units != NULL ? units : "",
                               .long_name = long_name != NULL ? long_name : "",
                               .key = "",
                               .text = "" };
    herr_t answer;

    item.rank =
        (int) hdf_took(v->st, H5Sget_simple_extent_dims(space, extent, NULL));
    for (int i = 0; i < item.rank; i++)
        item.extent[i] = extent[i];
    answer = store_read_tell(v, &item);
    hdf_close(space);
    free(long_name);
    free(units);
    return answer;
}

static herr_t tell_object(hid_t root, const char *name, const H5O_info_t *info,
                          void *ctx)
{
    struct visit *v = ctx;
    const bool is_root = strcmp(name, ".") == 0;
    const size_t room = strlen(name) + 2;
    char *path = hdf_memory(v->st, room, 1);
    const hid_t object = hdf_took(v->st, H5Oopen(root, name, H5P_DEFAULT));
    herr_t answer = -1;

    if (path != NULL) {
        snprintf(path, room, "/%s", is_root ? "" : name);
        v->path = path;
        if (info->type == H5O_TYPE_DATASET)
            answer = tell_dataset(v, object);
        else
            answer =
                store_read_tell(v, &(struct store_item){ .kind = STORE_GROUP,
                                                         .path = path,
                                                         .units = "",
                                                         .long_name = "",
                                                         .key = "",
                                                         .text = "" });
    }
    if (answer == 0)
        answer = H5Aiterate2(object, H5_INDEX_CRT_ORDER, H5_ITER_INC, NULL,
                             tell_text, v);
    if (answer < 0)
        hdf_took(v->st, answer);
    hdf_close(object);
    free(path);
    return answer;
}

enum status store_visit(struct store *st,
                        int (*visitor)(void *ctx,
                                       const struct store_item *item),
                        void *ctx, struct fault *fault)
{
    struct visit v = { .st = st, .visitor = visitor, .ctx = ctx };
    const int64_t answer =
        hdf_took(st, H5Ovisit2(st->file, H5_INDEX_CRT_ORDER, H5_ITER_INC,
                               tell_object, &v, H5O_INFO_BASIC));

    if (answer > 0)
        return STATUS_STOPPED;
    return hdf_blame(st, fault);
}

enum status store_read_text(struct store *st, const char *group,
                            const char *key, char **text, struct fault *fault)
{
    const hid_t object = hdf_took(st, H5Oopen(st->file, group, H5P_DEFAULT));
    enum status s;

    *text = read_text(st, object, key);
    hdf_close(object);
    s = hdf_blame(st, fault);
    if (s != STATUS_OK) {
        free(*text);
        *text = NULL;
    } else if (*text == NULL) {
        snprintf(fault->text, sizeof fault->text, "%.250s: no text '%s' in %s",
                 st->path, key, group);
        s = STATUS_IO;
    }
    return s;
}
