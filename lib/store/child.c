/* The answer comes through a pipe: what the work wrote, then a struct ending.
 * Only a whole ending counts, so that no way of dying is taken for an answer;
 * how the child died only chooses the words. */
#include "child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tolerance.h"

static const char mark[8] = "answered";

struct ending {
    char mark[8];
    enum status status;
    struct fault why;
};

static enum status child_blame(const char *path, const char *what,
                               const char *reason, struct fault *why)
{
    return fault_set(why, STATUS_IO, "%.250s: %s%s", path, what, reason);
}

/* ---- the child ----------------------------------------------------------- */

/* Bytes of address space in use, of which sanitizers reserve terabytes. */
static rlim_t in_use(void)
{
    char pages[200] = "";
    FILE *file = fopen("/proc/self/statm", "r");

    if (file == NULL)
        return 0;
    if (fgets(pages, sizeof pages, file) == NULL)
        pages[0] = '\0';
    fclose(file);
    return strtoull(pages, NULL, 10) * (rlim_t) sysconf(_SC_PAGESIZE);
}

static void limit_memory(void)
{
    const rlim_t most = in_use() + CHILD_BYTES;
    struct rlimit r;

    if (getrlimit(RLIMIT_AS, &r) != 0 || r.rlim_cur < most)
        return;
    r.rlim_cur = most;
    (void) setrlimit(RLIMIT_AS, &r);
}

/* It ends with its parent, in time, without eating the machine, without a core
 * file, and in silence: the parent says in one line what happened. */
static void child_confine(unsigned seconds)
{
    const int silence = open("/dev/null", O_WRONLY | O_CLOEXEC);
    sigset_t alarms;

    prctl(PR_SET_PDEATHSIG, SIGKILL);
    signal(SIGALRM, SIG_DFL);
    sigemptyset(&alarms);
    sigaddset(&alarms, SIGALRM);
    sigprocmask(SIG_UNBLOCK, &alarms, NULL);
    alarm(seconds);
    (void) setrlimit(RLIMIT_CORE, &(struct rlimit){ 0, 0 });
    limit_memory();
    if (silence >= 0)
        dup2(silence, STDERR_FILENO);
}

/* A reader that is gone is an error of writing, as everywhere. */
static _Noreturn void child_answer(child_work *work, void *ctx, int pipe)
{
    FILE *out = fdopen(pipe, "w");
    struct ending e = { .status = STATUS_NO_MEMORY };

    memcpy(e.mark, mark, sizeof mark);
    if (out == NULL)
        _exit(1);
    e.status = work(ctx, out, &e.why);
    const bool sent = fwrite(&e, sizeof e, 1, out) == 1 && fflush(out) == 0;
    _exit(sent ? 0 : 1);
}

/* ---- the parent ---------------------------------------------------------- */

struct answer {
    char *bytes; /* owned */
    size_t size, room;
};

/* False at the end, or where there is no room for more: then errno says so. */
static bool take_some(struct answer *a, int pipe)
{
    ssize_t got;

    errno = 0;
    if (a->size + 1 >= a->room) {
        const size_t room = a->room > 0 ? 2 * a->room : 1 << 16;
        char *more = room <= CHILD_ANSWER ? realloc(a->bytes, room) : NULL;
        if (more == NULL) {
            errno = room <= CHILD_ANSWER ? ENOMEM : EFBIG;
            return false;
        }
        a->bytes = more;
        a->room = room;
    }
    do
        got = read(pipe, a->bytes + a->size, a->room - 1 - a->size);
    while (got < 0 && errno == EINTR);
    a->size += got > 0 ? (size_t) got : 0;
    return got > 0;
}

/* How the child ended; 0 where that is not known. */
static int wait_for(pid_t child)
{
    int how = 0;

    while (waitpid(child, &how, 0) < 0)
        if (errno != EINTR)
            return 0;
    return how;
}

static enum status blame_death(const char *path, int how, struct fault *why)
{
    if (WIFSIGNALED(how) && WTERMSIG(how) == SIGALRM)
        return child_blame(path, "cannot be read: it takes too long", "", why);
    if (WIFSIGNALED(how))
        return child_blame(path, "damaged: HDF5 died over it: ",
                           strsignal(WTERMSIG(how)), why);
    return child_blame(path, "damaged: HDF5 gave up over it", "", why);
}

/* Cuts the ending off the answer. */
static enum status child_judge(struct answer *a, const char *path, int how,
                               struct fault *why)
{
    struct ending e;

    if (a->bytes == NULL || a->size < sizeof e)
        return blame_death(path, how, why);
    memcpy(&e, a->bytes + a->size - sizeof e, sizeof e);
    if (memcmp(e.mark, mark, sizeof mark) != 0)
        return blame_death(path, how, why);
    a->size -= sizeof e;
    a->bytes[a->size] = '\0';
    if (e.status != STATUS_OK)
        *why = e.why;
    return e.status;
}

/* Takes all that comes and waits for the child. */
static enum status child_collect(struct answer *a, const char *path, int pipe,
                                 pid_t child, struct fault *why)
{
    while (take_some(a, pipe))
        continue;
    const int error = errno;
    if (error != 0)
        kill(child, SIGKILL);
    const int how = wait_for(child);
    if (error == ENOMEM) {
        child_blame(path, status_text(STATUS_NO_MEMORY), "", why);
        return STATUS_NO_MEMORY;
    }
    return error != 0
               ? child_blame(path, "cannot be read: ", strerror(error), why)
               : child_judge(a, path, how, why);
}

enum status child_read(child_work *work, void *ctx, const char *path,
                       unsigned seconds, char **bytes, size_t *size,
                       struct fault *why)
{
    struct answer a = { .bytes = NULL };
    int ends[2];

    *bytes = NULL;
    *size = 0;
    if (pipe2(ends, O_CLOEXEC) != 0)
        return child_blame(path, "cannot be read: ", strerror(errno), why);
    const pid_t child = fork();
    if (child == 0) {
        child_confine(seconds);
        child_answer(work, ctx, ends[1]);
    }
    close(ends[1]);
    const enum status s =
        child > 0 ? child_collect(&a, path, ends[0], child, why)
                  : child_blame(path, "cannot be read: ", strerror(errno), why);
    close(ends[0]);
    if (s == STATUS_OK) {
        *bytes = a.bytes;
        *size = a.size;
    } else {
        free(a.bytes);
    }
    return s;
}
