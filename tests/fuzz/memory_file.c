/* Not one without a name (memfd_create): HDF5 asks for the real path.  A new
 * file each: HDF5 knows one that it has not closed again by its inode. */
#include "memory_file.h"

#include <fcntl.h>
#include <unistd.h>

#include "fuzz.h"

static char path[] = "/dev/shm/slipway-fuzz-XXXXXX";
static pid_t owner;

/* A child that ends has no say. */
static void forget(void)
{
    if (getpid() == owner)
        unlink(path);
}

const char *memory_file(const uint8_t *data, size_t size)
{
    static int fd = -1;

    if (owner == 0) {
        fd = mkstemp(path);
        owner = getpid();
        MUST(fd >= 0 && atexit(forget) == 0);
    } else {
        close(fd);
        unlink(path);
        fd = open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        MUST(fd >= 0);
    }
    MUST(pwrite(fd, data, size, 0) == (ssize_t) size);
    return path;
}
