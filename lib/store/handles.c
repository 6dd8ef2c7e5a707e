#include "handles.h"

#include "hdf.h"
#include "tolerance.h"

static const unsigned in_order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;

struct handles handles_none(void)
{
    struct handles handles = { H5I_INVALID_HID, H5I_INVALID_HID,
                               H5I_INVALID_HID, H5I_INVALID_HID,
                               H5I_INVALID_HID, { 0 } };

    for (int i = 0; i < HANDLE_KINDS; i++)
        handles.set[i] = H5I_INVALID_HID;
    return handles;
}

void handles_set_order(struct store *st, hid_t list, hid_t class)
{
    hdf_took(st, H5Pset_obj_track_times(list, false));
    hdf_took(st, H5Pset_attr_creation_order(list, in_order));
    hdf_took(st, H5Pset_attr_phase_change(list, STORE_COMPACT, 0));
    if (class == H5P_DATASET_CREATE)
        return;
    hdf_took(st, H5Pset_link_creation_order(list, in_order));
    hdf_took(st, H5Pset_link_phase_change(list, STORE_COMPACT, 0));
}

static hid_t new_list(struct store *st, hid_t class)
{
    const hid_t list = hdf_took(st, H5Pcreate(class));

    handles_set_order(st, list, class);
    return list;
}

static hid_t text_type(struct store *st, size_t size)
{
    const hid_t type = hdf_took(st, H5Tcopy(H5T_C_S1));

    hdf_took(st, H5Tset_size(type, size));
    hdf_took(st, H5Tset_cset(type, H5T_CSET_UTF8));
    hdf_took(st, H5Tset_strpad(type, H5T_STR_NULLPAD));
    return type;
}

void handles_make(struct store *st)
{
    const double no_value = (double) __builtin_nanf("");
    const int8_t no_code = -1;
    struct handles *handles = &st->handles;

    handles->text = text_type(st, 1);
    handles->texts = text_type(st, H5T_VARIABLE);
    handles->axes = hdf_took(st, H5Tvlen_create(H5T_STD_REF_OBJ));
    handles->space = hdf_took(st, H5Screate(H5S_SCALAR));
    handles->group = new_list(st, H5P_GROUP_CREATE);
    for (int i = 0; i < HANDLE_KINDS; i++)
        handles->set[i] = new_list(st, H5P_DATASET_CREATE);
    hdf_took(st, H5Pset_fill_value(handles->set[RECORD_REAL], H5T_NATIVE_DOUBLE,
                                   &no_value));
    hdf_took(st, H5Pset_fill_value(handles->set[RECORD_CODE], H5T_NATIVE_INT8,
                                   &no_code));
}

void handles_free(struct handles *handles)
{
    hdf_close(handles->text);
    hdf_close(handles->texts);
    hdf_close(handles->axes);
    hdf_close(handles->space);
    hdf_close(handles->group);
    for (int i = 0; i < HANDLE_KINDS; i++)
        hdf_close(handles->set[i]);
    *handles = handles_none();
}
