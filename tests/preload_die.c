/* For LD_PRELOAD: the child that reads a foreign file (lib/store/child.c) dies
 * as DIE says.  It points its standard error nowhere last of all before it
 * reads, by dup2, which nobody else calls. */
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

static bool is_asked(const char *word)
{
    const char *how = getenv("DIE");

    return how != NULL && strcmp(how, word) == 0;
}

/* Instead of a minute, a fifth of a second. */
unsigned alarm(unsigned seconds)
{
    const struct itimerval soon = { .it_value = { 0, 200000 } };
    const struct itimerval then = { .it_value = { (time_t) seconds, 0 } };

    setitimer(ITIMER_REAL, is_asked("hang") ? &soon : &then, NULL);
    return 0;
}

/* Memory without end, if it gets it. */
static void eat(void)
{
    const size_t bytes = (size_t) 1 << 30;

    for (int i = 0; i < 64; i++)
        if (mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                 MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1,
                 0) == MAP_FAILED)
            abort();
}

int dup2(int from, int to)
{
    const long fd = syscall(SYS_dup3, from, to, 0);

    if (is_asked("segv"))
        raise(SIGSEGV);
    if (is_asked("abort"))
        abort();
    if (is_asked("exit"))
        _exit(0);
    if (is_asked("eat"))
        eat();
    while (is_asked("hang"))
        continue;
    return (int) fd;
}
