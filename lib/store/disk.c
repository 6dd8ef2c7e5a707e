#include "disk.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "hdf.h"
#include "replace.h"

struct disk {
    struct replacing *place; /* owned */
    int fd;                  /* borrowed of it */
    int error;               /* errno of the first failure; 0: none */
    hid_t driver; /* owned: on closing a file HDF5 lets go of it too early */
};

/* What HDF5 holds of it. */
struct file {
    H5FD_t own; /* first: HDF5's part */
    struct disk *disk;
    haddr_t eoa, eof;
};

/* ---- the driver ---------------------------------------------------------- */

static H5FD_t *file_open(const char *name, unsigned flags, hid_t access,
                         haddr_t most)
{
    struct disk *const *disk = H5Pget_driver_info(access);
    struct file *f = disk ? calloc(1, sizeof *f) : NULL;

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
    return ((const struct file *) own)->eoa;
}

static herr_t file_set_eoa(H5FD_t *own, H5FD_mem_t type, haddr_t to)
{
    (void) type;
    ((struct file *) own)->eoa = to;
    return 0;
}

static haddr_t file_eof(const H5FD_t *own, H5FD_mem_t type)
{
    (void) type;
    return ((const struct file *) own)->eof;
}

/* Zeros beyond the end, and where it fails. */
static herr_t file_read(H5FD_t *own, H5FD_mem_t type, hid_t transfer,
                        haddr_t from, size_t size, void *bytes)
{
    struct disk *d = ((struct file *) own)->disk;
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
    struct file *f = (struct file *) own;
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
    struct file *f = (struct file *) own;

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

/* ---- the file ------------------------------------------------------------ */

enum status disk_open(const char *path, struct disk **disk, struct fault *fault)
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

void disk_choose(struct store *st, hid_t access)
{
    st->disk->driver = hdf_took(st, H5FDregister(&driver));
    hdf_took(st, H5Pset_driver(access, st->disk->driver, &st->disk));
}

enum status disk_keep(struct disk **disk, const char *path, struct fault *fault)
{
    const enum status s =
        replace_end(&(*disk)->place, (*disk)->error, path, fault);

    hdf_close((*disk)->driver);
    free(*disk);
    *disk = NULL;
    return s;
}

void disk_drop(struct disk **disk)
{
    struct fault unheard;

    if (*disk == NULL)
        return;
    (void) !replace_end(&(*disk)->place, ECANCELED, "", &unheard);
    hdf_close((*disk)->driver);
    free(*disk);
    *disk = NULL;
}
