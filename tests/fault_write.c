/* The linker's --wrap=write makes write mean __wrap_write, and __real_write the
 * true one; with large files open, ftruncate and lseek end in 64. */
#include "fault_write.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>
#include <unistd.h>

static long fail_at = FAULT_WRITE_NEVER, count;
static int errno_then;
static const char *failed;
static size_t most;

void fault_write_at(long k, int error)
{
    fail_at = k;
    errno_then = error;
    count = 0;
    failed = NULL;
}

const char *fault_write_failed(void)
{
    return failed;
}

void fault_write_most(size_t bytes)
{
    most = bytes;
}

static bool refused(const char *name)
{
    if (count++ != fail_at)
        return false;
    failed = name;
    errno = errno_then;
    return true;
}

ssize_t __real_write(int fd, const void *bytes, size_t size);
ssize_t __wrap_write(int fd, const void *bytes, size_t size);
int __real_fsync(int fd);
int __wrap_fsync(int fd);
int __real_close(int fd);
int __wrap_close(int fd);
int __real_rename(const char *from, const char *to);
int __wrap_rename(const char *from, const char *to);
int __real_linkat(int a, const char *from, int b, const char *to, int flags);
int __wrap_linkat(int a, const char *from, int b, const char *to, int flags);
int __real_open64(const char *path, int flags, ...);
int __wrap_open64(const char *path, int flags, ...);
int __real_ftruncate64(int fd, off_t size);
int __wrap_ftruncate64(int fd, off_t size);
off_t __real_lseek64(int fd, off_t at, int from);
off_t __wrap_lseek64(int fd, off_t at, int from);

ssize_t __wrap_write(int fd, const void *bytes, size_t size)
{
    const size_t part = most > 0 && size > most ? most : size;

    return refused("write") ? -1 : __real_write(fd, bytes, part);
}

int __wrap_fsync(int fd)
{
    return refused("fsync") ? -1 : __real_fsync(fd);
}

int __wrap_close(int fd)
{
    const int answer = __real_close(fd);

    return refused("close") ? -1 : answer;
}

int __wrap_rename(const char *from, const char *to)
{
    return refused("rename") ? -1 : __real_rename(from, to);
}

int __wrap_linkat(int a, const char *from, int b, const char *to, int flags)
{
    return refused("linkat") ? -1 : __real_linkat(a, from, b, to, flags);
}

int __wrap_open64(const char *path, int flags, ...)
{
    va_list list;

    va_start(list, flags);
    const mode_t mode = va_arg(list, mode_t);
    va_end(list);
    return refused("open") ? -1 : __real_open64(path, flags, mode);
}

int __wrap_ftruncate64(int fd, off_t size)
{
    return refused("ftruncate") ? -1 : __real_ftruncate64(fd, size);
}

off_t __wrap_lseek64(int fd, off_t at, int from)
{
    return refused("lseek") ? -1 : __real_lseek64(fd, at, from);
}
