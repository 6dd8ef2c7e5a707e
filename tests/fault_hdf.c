/* The linker's --wrap=H5Fopen makes H5Fopen mean __wrap_H5Fopen, and
 * __real_H5Fopen the true one; meson.build asks for it by the same names. */
#include "fault_hdf.h"

#include <hdf5.h>
#include <string.h>

static long fail_at = FAULT_HDF_NEVER, count;
static const char *failed;

void fault_hdf_at(long k)
{
    fail_at = k;
    count = 0;
    failed = NULL;
}

long fault_hdf_count(void)
{
    return count;
}

const char *fault_hdf_failed(void)
{
    return failed;
}

static bool refused(const char *name)
{
    if (count++ != fail_at)
        return false;
    failed = name;
    return true;
}

/* answer, what it is on failure, name, parameters, arguments */
/* clang-format off */
#define CALLS(CALL)                                                            \
    CALL(hid_t, -1, H5Acreate2,                                                \
         (hid_t a, const char *b, hid_t c, hid_t d, hid_t e, hid_t f),         \
         (a, b, c, d, e, f))                                                   \
    CALL(htri_t, -1, H5Aexists, (hid_t a, const char *b), (a, b))              \
    CALL(hid_t, -1, H5Aget_space, (hid_t a), (a))                              \
    CALL(hid_t, -1, H5Aget_type, (hid_t a), (a))                               \
    CALL(herr_t, -1, H5Aiterate2,                                              \
         (hid_t a, H5_index_t b, H5_iter_order_t c, hsize_t *d,                \
          H5A_operator2_t e, void *f), (a, b, c, d, e, f))                     \
    CALL(hid_t, -1, H5Aopen, (hid_t a, const char *b, hid_t c), (a, b, c))     \
    CALL(herr_t, -1, H5Aread, (hid_t a, hid_t b, void *c), (a, b, c))          \
    CALL(herr_t, -1, H5Awrite, (hid_t a, hid_t b, const void *c), (a, b, c))   \
    CALL(hid_t, -1, H5Dcreate2,                                                \
         (hid_t a, const char *b, hid_t c, hid_t d, hid_t e, hid_t f, hid_t g),\
         (a, b, c, d, e, f, g))                                                \
    CALL(hid_t, -1, H5Dget_space, (hid_t a), (a))                              \
    CALL(hid_t, -1, H5Dget_type, (hid_t a), (a))                               \
    CALL(hid_t, -1, H5Dopen2, (hid_t a, const char *b, hid_t c), (a, b, c))    \
    CALL(herr_t, -1, H5Dread,                                                  \
         (hid_t a, hid_t b, hid_t c, hid_t d, hid_t e, void *f),               \
         (a, b, c, d, e, f))                                                   \
    CALL(herr_t, -1, H5Dwrite,                                                 \
         (hid_t a, hid_t b, hid_t c, hid_t d, hid_t e, const void *f),         \
         (a, b, c, d, e, f))                                                   \
    CALL(hid_t, -1, H5Fcreate, (const char *a, unsigned b, hid_t c, hid_t d),  \
         (a, b, c, d))                                                         \
    CALL(herr_t, -1, H5Fflush, (hid_t a, H5F_scope_t b), (a, b))               \
    CALL(ssize_t, -1, H5Fget_file_image, (hid_t a, void *b, size_t c),         \
         (a, b, c))                                                            \
    CALL(herr_t, -1, H5Fget_vfd_handle, (hid_t a, hid_t b, void **c),          \
         (a, b, c))                                                            \
    CALL(hid_t, -1, H5Fopen, (const char *a, unsigned b, hid_t c), (a, b, c))  \
    CALL(hid_t, -1, H5Gcreate2,                                                \
         (hid_t a, const char *b, hid_t c, hid_t d, hid_t e), (a, b, c, d, e)) \
    CALL(hid_t, -1, H5Gopen2, (hid_t a, const char *b, hid_t c), (a, b, c))    \
    CALL(H5I_type_t, H5I_BADID, H5Iget_type, (hid_t a), (a))                   \
    CALL(htri_t, -1, H5Lexists, (hid_t a, const char *b, hid_t c), (a, b, c))  \
    CALL(hid_t, -1, H5Oopen, (hid_t a, const char *b, hid_t c), (a, b, c))     \
    CALL(herr_t, -1, H5Ovisit2,                                                \
         (hid_t a, H5_index_t b, H5_iter_order_t c, H5O_iterate_t d, void *e,  \
          unsigned f), (a, b, c, d, e, f))                                     \
    CALL(hid_t, -1, H5Pcopy, (hid_t a), (a))                                   \
    CALL(hid_t, -1, H5Pcreate, (hid_t a), (a))                                 \
    CALL(herr_t, -1, H5Pset_attr_creation_order, (hid_t a, unsigned b),        \
         (a, b))                                                               \
    CALL(herr_t, -1, H5Pset_attr_phase_change,                                 \
         (hid_t a, unsigned b, unsigned c), (a, b, c))                         \
    CALL(herr_t, -1, H5Pset_chunk, (hid_t a, int b, const hsize_t *c),         \
         (a, b, c))                                                            \
    CALL(herr_t, -1, H5Pset_deflate, (hid_t a, unsigned b), (a, b))            \
    CALL(hid_t, -1, H5FDregister, (const H5FD_class_t *a), (a))                \
    CALL(const void *, NULL, H5Pget_driver_info, (hid_t a), (a))               \
    CALL(herr_t, -1, H5Pset_driver, (hid_t a, hid_t b, const void *c),         \
         (a, b, c))                                                            \
    CALL(herr_t, -1, H5Pset_fapl_core, (hid_t a, size_t b, hbool_t c),         \
         (a, b, c))                                                            \
    CALL(herr_t, -1, H5Pset_fclose_degree, (hid_t a, H5F_close_degree_t b),    \
         (a, b))                                                               \
    CALL(herr_t, -1, H5Pset_file_locking, (hid_t a, hbool_t b, hbool_t c),     \
         (a, b, c))                                                            \
    CALL(herr_t, -1, H5Pset_fill_value, (hid_t a, hid_t b, const void *c),     \
         (a, b, c))                                                            \
    CALL(herr_t, -1, H5Pset_libver_bounds,                                     \
         (hid_t a, H5F_libver_t b, H5F_libver_t c), (a, b, c))                 \
    CALL(herr_t, -1, H5Pset_link_creation_order, (hid_t a, unsigned b),        \
         (a, b))                                                               \
    CALL(herr_t, -1, H5Pset_link_phase_change,                                 \
         (hid_t a, unsigned b, unsigned c), (a, b, c))                         \
    CALL(herr_t, -1, H5Pset_obj_track_times, (hid_t a, hbool_t b), (a, b))     \
    CALL(herr_t, -1, H5Pset_shuffle, (hid_t a), (a))                           \
    CALL(herr_t, -1, H5Rcreate,                                                \
         (void *a, hid_t b, const char *c, H5R_type_t d, hid_t e),             \
         (a, b, c, d, e))                                                      \
    CALL(hid_t, -1, H5Scopy, (hid_t a), (a))                                   \
    CALL(hid_t, -1, H5Screate, (H5S_class_t a), (a))                           \
    CALL(hid_t, -1, H5Screate_simple,                                          \
         (int a, const hsize_t *b, const hsize_t *c), (a, b, c))               \
    CALL(htri_t, -1, H5Sextent_equal, (hid_t a, hid_t b), (a, b))              \
    CALL(int, -1, H5Sget_simple_extent_dims,                                   \
         (hid_t a, hsize_t *b, hsize_t *c), (a, b, c))                         \
    CALL(hssize_t, -1, H5Sget_simple_extent_npoints, (hid_t a), (a))           \
    CALL(herr_t, -1, H5Sselect_hyperslab,                                      \
         (hid_t a, H5S_seloper_t b, const hsize_t *c, const hsize_t *d,        \
          const hsize_t *e, const hsize_t *f), (a, b, c, d, e, f))             \
    CALL(herr_t, -1, H5Sset_extent_simple,                                     \
         (hid_t a, int b, const hsize_t *c, const hsize_t *d), (a, b, c, d))   \
    CALL(hid_t, -1, H5Tcopy, (hid_t a), (a))                                   \
    CALL(hid_t, -1, H5Tcreate, (H5T_class_t a, size_t b), (a, b))              \
    CALL(htri_t, -1, H5Tequal, (hid_t a, hid_t b), (a, b))                     \
    CALL(H5T_class_t, H5T_NO_CLASS, H5Tget_class, (hid_t a), (a))              \
    CALL(size_t, 0, H5Tget_size, (hid_t a), (a))                               \
    CALL(herr_t, -1, H5Tinsert, (hid_t a, const char *b, size_t c, hid_t d),   \
         (a, b, c, d))                                                         \
    CALL(htri_t, -1, H5Tis_variable_str, (hid_t a), (a))                       \
    CALL(herr_t, -1, H5Tset_cset, (hid_t a, H5T_cset_t b), (a, b))             \
    CALL(herr_t, -1, H5Tset_size, (hid_t a, size_t b), (a, b))                 \
    CALL(herr_t, -1, H5Tset_strpad, (hid_t a, H5T_str_t b), (a, b))            \
    CALL(hid_t, -1, H5Tvlen_create, (hid_t a), (a))

/* Those whose work is done all the same. */
#define ENDS(CALL)                                                             \
    CALL(herr_t, -1, H5Dvlen_reclaim,                                          \
         (hid_t a, hid_t b, hid_t c, void *d), (a, b, c, d))                   \
    CALL(herr_t, -1, H5Eset_auto2, (hid_t a, H5E_auto2_t b, void *c),          \
         (a, b, c))                                                            \
    CALL(herr_t, -1, H5Ewalk2,                                                 \
         (hid_t a, H5E_direction_t b, H5E_walk2_t c, void *d), (a, b, c, d))   \
    CALL(int, -1, H5Idec_ref, (hid_t a), (a))
/* clang-format on */

#define WRAP(type, value, name, parameters, arguments)                         \
    type __real_##name parameters;                                             \
    type __wrap_##name parameters;                                             \
    type __wrap_##name parameters                                              \
    {                                                                          \
        return refused(#name) ? value : __real_##name arguments;               \
    }

#define WRAP_END(type, value, name, parameters, arguments)                     \
    type __real_##name parameters;                                             \
    type __wrap_##name parameters;                                             \
    type __wrap_##name parameters                                              \
    {                                                                          \
        const type answer = __real_##name arguments;                           \
        return refused(#name) ? value : answer;                                \
    }

CALLS(WRAP)
ENDS(WRAP_END)

#define NAME(type, value, name, parameters, arguments) #name,

bool fault_hdf_knows(const char *name)
{
    static const char *const known[] = { CALLS(NAME) ENDS(NAME) };

    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strcmp(known[i], name) == 0)
            return true;
    return false;
}
