/* Not one without a name (memfd_create): HDF5 asks for the real path. */
#include "memory_file.h"

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

    if (fd < 0) {
        fd = mkstemp(path);
        owner = getpid();
        MUST(fd >= 0 && atexit(forget) == 0);
    }
    MUST(ftruncate(fd, 0) == 0);
    MUST(pwrite(fd, data, size, 0) == (ssize_t) size);
    return path;
}
