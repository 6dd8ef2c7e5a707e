/* The file is built by HDF5's memory driver and written by replace.c: HDF5
 * 1.10 crashes on closing a file that could not be flushed, and hides the
 * system's reason among its own.  libver bounds are pinned, because "latest"
 * means other bytes in other versions of HDF5. */
#include "store.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "axis.h"
#include "hdf.h"
#include "replace.h"
#include "status.h"
#include "tolerance.h"

/* ---- disk ---------------------------------------------------------------- */

struct store;
struct disk;

struct disk {
    struct replacing *place; /* owned */
    int fd;                  /* borrowed of it */
    int error;               /* errno of the first failure; 0: none */
    hid_t
        driver; /* owned: on closing a disk_file HDF5 lets go of it too early */
};

/* What HDF5 holds of it. */
struct disk_file {
    H5FD_t own; /* first: HDF5's part */
    struct disk *disk;
    haddr_t eoa, eof;
};

/* ---- the driver ---------------------------------------------------------- */

static H5FD_t *file_open(const char *name, unsigned flags, hid_t access,
                         haddr_t most)
{
    struct disk *const *disk = H5Pget_driver_info(access);
    struct disk_file *f = disk ? calloc(1, sizeof *f) : NULL;

    (void) name, (void) flags, (void) most;
    if (f)
        f->disk = *disk;
    return f ? &f->own : NULL;
}

static herr_t file_close(H5FD_t *own)
{
    free(own);
    return 0;
}

static herr_t file_query(const H5FD_t *own, unsigned long *flags)
{
    (void) own;
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA |
             H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

static haddr_t file_eoa(const H5FD_t *own, H5FD_mem_t type)
{
    (void) type;
    return ((const struct disk_file *) own)->eoa;
}

static herr_t file_set_eoa(H5FD_t *own, H5FD_mem_t type, haddr_t to)
{
    (void) type;
    ((struct disk_file *) own)->eoa = to;
    return 0;
}

static haddr_t file_eof(const H5FD_t *own, H5FD_mem_t type)
{
    (void) type;
    return ((const struct disk_file *) own)->eof;
}

/* Zeros beyond the end, and where it fails. */
static herr_t file_read(H5FD_t *own, H5FD_mem_t type, hid_t transfer,
                        haddr_t from, size_t size, void *bytes)
{
    struct disk *d = ((struct disk_file *) own)->disk;
    char *at = bytes;

    (void) type, (void) transfer;
    while (size > 0) {
        const ssize_t got = pread(d->fd, at, size, (off_t) from);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0 && d->error == 0)
            d->error = errno;
        if (got <= 0)
            break;
        at += got;
        from += (haddr_t) got;
        size -= (size_t) got;
    }
    memset(at, 0, size);
    return 0;
}

static herr_t file_write(H5FD_t *own, H5FD_mem_t type, hid_t transfer,
                         haddr_t to, size_t size, const void *bytes)
{
    struct disk_file *f = (struct disk_file *) own;
    struct disk *d = f->disk;
    const char *at = bytes;

    (void) type, (void) transfer;
    f->eof = to + size > f->eof ? to + size : f->eof;
    while (size > 0 && d->error == 0) {
        const ssize_t put = pwrite(d->fd, at, size, (off_t) to);
        if (put < 0 && errno == EINTR)
            continue;
        if (put <= 0) {
            d->error = put < 0 ? errno : ENOSPC;
            break;
        }
        at += put;
        to += (haddr_t) put;
        size -= (size_t) put;
    }
    return 0;
}

/* As long as HDF5 says that it is. */
static herr_t file_truncate(H5FD_t *own, hid_t transfer, hbool_t closing)
{
    struct disk_file *f = (struct disk_file *) own;

    (void) transfer, (void) closing;
    if (f->disk->error == 0 && ftruncate(f->disk->fd, (off_t) f->eoa) != 0)
        f->disk->error = errno;
    f->eof = f->eoa;
    return 0;
}

static const H5FD_class_t driver = {
    .name = "slipway_disk",
    .maxaddr = (haddr_t) INT64_MAX,
    .fc_degree = H5F_CLOSE_STRONG,
    .fapl_size = sizeof(struct disk *),
    .open = file_open,
    .close = file_close,
    .query = file_query,
    .get_eoa = file_eoa,
    .set_eoa = file_set_eoa,
    .get_eof = file_eof,
    .read = file_read,
    .write = file_write,
    .truncate = file_truncate,
    .fl_map = H5FD_FLMAP_DICHOTOMY,
};

/* ---- the disk_file
 * ------------------------------------------------------------ */

static enum status disk_open(const char *path, struct disk **disk,
                             struct fault *fault)
{
    struct disk *d = calloc(1, sizeof *d);

    *disk = NULL;
    if (d == NULL)
        return STATUS_NO_MEMORY;
    const enum status s = replace_begin(path, &d->place, fault);
    if (s != STATUS_OK) {
        free(d);
        return s;
    }
    d->fd = replace_descriptor(d->place);
    d->driver = H5I_INVALID_HID;
    *disk = d;
    return STATUS_OK;
}

/* Files made with this access list go there. */
static void disk_choose(struct store *st, hid_t access)
{
    st->disk->driver = hdf_took(st, H5FDregister(&driver));
    hdf_took(st, H5Pset_driver(access, st->disk->driver, &st->disk));
}

/* Once HDF5 has closed it: it takes its place, or, where a write had failed, is
 * gone and *fault says why.  STATUS_IO. */
static enum status disk_keep(struct disk **disk, const char *path,
                             struct fault *fault)
{
    const enum status s =
        replace_end(&(*disk)->place, (*disk)->error, path, fault);

    hdf_close((*disk)->driver);
    free(*disk);
    *disk = NULL;
    return s;
}

/* It is gone.  A second call is harmless. */
static void disk_drop(struct disk **disk)
{
    struct fault unheard;

    if (*disk == NULL)
        return;
    (void) !replace_end(&(*disk)->place, ECANCELED, "", &unheard);
    hdf_close((*disk)->driver);
    free(*disk);
    *disk = NULL;
}

void store_silence(void)
{
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
}

const char *store_library_version(void)
{
    return &H5_VERS_INFO[sizeof "HDF5 library version: " - 1];
}

static struct store *store_new(const char *path, struct fault *fault)
{
    struct store *st = calloc(1, sizeof *st);
    char *copy = st != NULL ? malloc(strlen(path) + 1) : NULL;

    if (copy == NULL) {
        snprintf(fault->text, sizeof fault->text, "%.250s: %s", path,
                 status_text(STATUS_NO_MEMORY));
        free(st);
        return NULL;
    }
    strcpy(copy, path);
    st->file = H5I_INVALID_HID;
    st->group = H5I_INVALID_HID;
    st->handles = handles_none();
    st->path = copy;
    return st;
}

/* Hands over a healthy store, or frees it and says what is wrong. */
static enum status hand_over(struct store *st, struct store **store,
                             struct fault *fault)
{
    const enum status s = hdf_blame(st, fault);

    if (s != STATUS_OK)
        store_free(&st);
    *store = st;
    return s;
}

static hid_t access_list(struct store *st)
{
    const hid_t access = hdf_took(st, H5Pcreate(H5P_FILE_ACCESS));

    hdf_took(st, H5Pset_fclose_degree(access, H5F_CLOSE_STRONG));
    return access;
}

/* In memory, or on its disk. */
static void create(struct store *st)
{
    const hid_t access = access_list(st);
    const hid_t create = hdf_took(st, H5Pcreate(H5P_FILE_CREATE));
    char name[32]; /* never seen on disk, but HDF5 wants each its own */

    handles_set_order(st, create, H5P_FILE_CREATE);
    snprintf(name, sizeof name, "%p", (void *) st);
    if (st->disk)
        disk_choose(st, access);
    else
        hdf_took(st, H5Pset_fapl_core(access, STORE_GROWTH, false));
    hdf_took(st, H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18));
    if (st->status == STATUS_OK) /* else perhaps not in memory */
        st->file = hdf_took(st, H5Fcreate(name, H5F_ACC_TRUNC, create, access));
    hdf_close(create);
    hdf_close(access);
}

static enum status begin(const char *path, const char *title, bool on_disk,
                         struct store **store, struct fault *fault)
{
    struct store *st;
    enum status s = replace_check(path, fault);

    *store = NULL;
    if (s != STATUS_OK)
        return s;
    st = store_new(path, fault);
    if (st == NULL)
        return STATUS_NO_MEMORY;
    if (on_disk)
        s = disk_open(path, &st->disk, fault);
    if (s != STATUS_OK) {
        store_free(&st);
        return s;
    }
    create(st);
    handles_make(st);
    hdf_put_text(st, st->file, "Conventions", "CF-1.10");
    hdf_put_text(st, st->file, "title", title);
    return hand_over(st, store, fault);
}

enum status store_create(const char *path, const char *title,
                         struct store **store, struct fault *fault)
{
    return begin(path, title, false, store, fault);
}

enum status store_create_on_disk(const char *path, const char *title,
                                 struct store **store, struct fault *fault)
{
    return begin(path, title, true, store, fault);
}

/* The system says "no such file" better than HDF5 does. */
static void look_at_file(struct store *st)
{
    struct stat about;
    const int fd = open(st->path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);

    if (fd < 0) {
        hdf_fail(st, STATUS_IO, strerror(errno));
        return;
    }
    if (fstat(fd, &about) != 0)
        hdf_fail(st, STATUS_IO, strerror(errno));
    else if (S_ISDIR(about.st_mode))
        hdf_fail(st, STATUS_IO, strerror(EISDIR));
    else if (!S_ISREG(about.st_mode))
        hdf_fail(st, STATUS_IO, "not a regular file");
    close(fd);
}

enum status store_open(const char *path, struct store **store,
                       struct fault *fault)
{
    struct store *st = store_new(path, fault);

    *store = NULL;
    if (st == NULL)
        return STATUS_NO_MEMORY;
    look_at_file(st);
    if (st->status == STATUS_OK) {
        const hid_t access = access_list(st);
        hdf_took(st, H5Pset_file_locking(access, false, true));
        st->file = hdf_took(st, H5Fopen(path, H5F_ACC_RDONLY, access));
        hdf_close(access);
    }
    return hand_over(st, store, fault);
}

enum status store_put_text(struct store *st, const char *path, const char *key,
                           const char *text)
{
    if (st->status == STATUS_OK)
        hdf_put_text(st, hdf_group(st, path), key, text);
    return st->status;
}

static enum status put_number(struct store *st, const char *path,
                              const char *key, hid_t type, hid_t native,
                              const void *value)
{
    if (st->status == STATUS_OK)
        hdf_put(st, hdf_group(st, path), key, 1, 1, type, native, value);
    return st->status;
}

enum status store_put_real(struct store *st, const char *path, const char *key,
                           double value)
{
    return put_number(st, path, key, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

enum status store_put_count(struct store *st, const char *path, const char *key,
                            int64_t value)
{
    return put_number(st, path, key, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
}

/* The finished image lies in the memory driver's buffer: no second copy. */
static const void *store_finish(struct store *st, size_t *size)
{
    void **image = NULL;

    if (st->status == STATUS_OK) {
        axis_finish(st);
        hdf_took(st, H5Fflush(st->file, H5F_SCOPE_GLOBAL));
        *size = (size_t) hdf_took(st, H5Fget_file_image(st->file, NULL, 0));
        hdf_took(st,
                 H5Fget_vfd_handle(st->file, H5P_DEFAULT, (void **) &image));
    }
    return image != NULL ? *image : NULL;
}

static void close_all(struct store *st)
{
    axis_free(st);
    handles_free(&st->handles);
    hdf_close(st->group);
    hdf_close(st->file);
    st->group = H5I_INVALID_HID;
    st->file = H5I_INVALID_HID;
}

static enum status commit_disk(struct store *st, struct fault *fault)
{
    if (st->status == STATUS_OK)
        axis_finish(st);
    close_all(st);
    const enum status s = hdf_blame(st, fault);
    return s ? s : disk_keep(&st->disk, st->path, fault);
}

enum status store_commit(struct store *st, struct fault *fault)
{
    size_t size = 0;

    if (st->disk)
        return commit_disk(st, fault);
    const void *image = store_finish(st, &size);
    enum status s = hdf_blame(st, fault);
    if (s == STATUS_OK)
        s = replace_file(st->path, image, size, fault);
    close_all(st);
    return s;
}

void store_free(struct store **store)
{
    struct store *st = *store;

    if (st == NULL)
        return;
    close_all(st);
    disk_drop(&st->disk);
    free(st->group_path);
    free(st->path);
    free(st);
    *store = NULL;
}
