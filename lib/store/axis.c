#include "axis.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "hdf.h"
#include "room.h"

/* A data set and which of its axes this is: an entry of REFERENCE_LIST, of 16
 * bytes as everyone writes it. */
struct axis_user {
    hobj_ref_t set;
    int32_t dimension, zero;
};

static hobj_ref_t axis_reference(struct store *st, hid_t group,
                                 const char *name)
{
    hobj_ref_t at = 0;

    hdf_took(st, H5Rcreate(&at, group, name, H5R_OBJECT, H5I_INVALID_HID));
    return at;
}

/* The specification wants a final zero. */
static void put_label(struct store *st, hid_t set, const char *key,
                      const char *text)
{
    const hid_t type = hdf_took(st, H5Tcopy(H5T_C_S1));

    hdf_took(st, H5Tset_size(type, strlen(text) + 1));
    hdf_put(st, set, key, 0, 1, type, type, text);
    hdf_close(type);
}

struct axis *axis_new(struct store *st, hid_t set, const char *name,
                      hsize_t extent)
{
    struct axis *axis = hdf_memory(st, 1, sizeof *axis);

    if (axis == NULL) {
        hdf_close(set);
        return NULL;
    }
    put_label(st, set, "CLASS", "DIMENSION_SCALE");
    put_label(st, set, "NAME", name);
    axis->set = set;
    axis->at = axis_reference(st, set, ".");
    axis->extent = extent;
    axis->next = st->axes;
    st->axes = axis;
    return axis;
}

struct axis *axis_find(struct store *st, hid_t group, const char *name)
{
    const hobj_ref_t at = axis_reference(st, group, name);
    struct axis *axis = st->axes;

    while (axis != NULL && axis->at != at)
        axis = axis->next;
    if (axis == NULL)
        hdf_fail(st, STATUS_IO, "no such axis");
    return axis;
}

static void note_user(struct store *st, struct axis *axis, hobj_ref_t set,
                      int dimension)
{
    const enum status s = ROOM_FOR(axis->users, axis->room, axis->count + 1);

    if (s != STATUS_OK)
        hdf_fail(st, s, status_text(s));
    else
        axis->users[axis->count++] = (struct axis_user){ set, dimension, 0 };
}

void axis_tie(struct store *st, hid_t set, int rank, struct axis *const axis[])
{
    const hobj_ref_t at = axis_reference(st, set, ".");
    const hid_t type = st->handles.axes;
    hvl_t list[AXES_MAX];

    for (int i = 0; i < rank; i++) {
        list[i] = (hvl_t){ 1, &axis[i]->at };
        note_user(st, axis[i], at, i);
    }
    hdf_put(st, set, "DIMENSION_LIST", 1, (size_t) rank, type, type, list);
}

static hid_t user_type(struct store *st)
{
    const hid_t type =
        hdf_took(st, H5Tcreate(H5T_COMPOUND, sizeof(struct axis_user)));

    hdf_took(st, H5Tinsert(type, "dataset", offsetof(struct axis_user, set),
                           H5T_STD_REF_OBJ));
    hdf_took(st,
             H5Tinsert(type, "dimension", offsetof(struct axis_user, dimension),
                       H5T_NATIVE_INT32));
    return type;
}

void axis_finish(struct store *st)
{
    const hid_t type = user_type(st);

    for (struct axis *axis = st->axes; axis != NULL; axis = axis->next)
        if (axis->count > 0)
            hdf_put(st, axis->set, "REFERENCE_LIST", 1, axis->count, type, type,
                    axis->users);
    hdf_close(type);
}

void axis_free(struct store *st)
{
    while (st->axes != NULL) {
        struct axis *next = st->axes->next;
        hdf_close(st->axes->set);
        free(st->axes->users);
        free(st->axes);
        st->axes = next;
    }
}
