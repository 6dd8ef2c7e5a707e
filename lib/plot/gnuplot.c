#include "gnuplot.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "litter.h"

enum { SAID_MAX = 4096 };

/* Reads to the end, keeps the beginning. */
static void listen_to(int fd, char said[SAID_MAX])
{
    size_t kept = 0;
    for (;;) {
        char buffer[1024];
        const ssize_t n = read(fd, buffer, sizeof buffer);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            break;
        size_t take = (size_t) n;
        if (take > SAID_MAX - 1 - kept)
            take = SAID_MAX - 1 - kept;
        memcpy(said + kept, buffer, take);
        kept += take;
    }
    said[kept] = '\0';
}

/* gnuplot echoes the line it stumbled on and only then says why: the first
 * line that names a place in the script, else the first that is not blank.
 * Warnings do not stop it. */
static const char *gnuplot_complaint(char *said)
{
    const char *first = NULL;
    char *rest = said;
    for (char *line; (line = strsep(&rest, "\r\n"));) {
        if (strstr(line, "warning:"))
            continue;
        if (strstr(line, "\" line "))
            return line;
        if (!first && line[strspn(line, " \t^")] != '\0')
            first = line;
    }
    return first ? first : "it gave no reason";
}

static enum status gnuplot_refuse(struct fault *fault, const char *what,
                                  const char *why)
{
    snprintf(fault->text, sizeof fault->text, "gnuplot %s: %.400s", what, why);
    return STATUS_NO_GNUPLOT;
}

/* Ours without GNUTERM, GNUPLOT_LIB and all that gnuplot would obey; the list
 * is the caller's (free), its texts are not.  NULL without memory. */
static char **gnuplot_surroundings(void)
{
    size_t n = 0, kept = 0;
    while (environ[n])
        n++;
    char **list = malloc((n + 1) * sizeof *list);
    if (!list)
        return NULL;
    for (size_t k = 0; k < n; k++)
        if (strncmp(environ[k], "GNU", 3) != 0)
            list[kept++] = environ[k];
    list[kept] = NULL;
    return list;
}

/* Returns an errno; stderr of the child goes to `out`. */
static int gnuplot_start(const char *folder, const char *script, int out,
                         char *const variables[], pid_t *child)
{
    char program[] = "gnuplot", defaults[] = "-d", name[512];
    char *const argv[] = { program, defaults, name, NULL };
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    sigset_t normal;
    snprintf(name, sizeof name, "./%s", script);
    if (posix_spawn_file_actions_init(&files) != 0)
        return ENOMEM;
    if (posix_spawnattr_init(&attributes) != 0) {
        posix_spawn_file_actions_destroy(&files);
        return ENOMEM;
    }
    sigemptyset(&normal);
    sigaddset(&normal, SIGPIPE);
    int e = posix_spawnattr_setsigdefault(&attributes, &normal);
    e = e ? e : posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    e = e ? e
          : posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY,
                                             0);
    e = e ? e
          : posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY,
                                             0);
    e = e ? e : posix_spawn_file_actions_adddup2(&files, out, 2);
    e = e ? e : posix_spawn_file_actions_addchdir_np(&files, folder);
    e = e ? e
          : posix_spawnp(child, "gnuplot", &files, &attributes, argv,
                         variables);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return e;
}

enum status gnuplot_run(const char *folder, const char *script,
                        struct fault *fault)
{
    int ends[2], how = 0;
    char said[SAID_MAX];
    pid_t child;
    char **variables = gnuplot_surroundings();
    if (!variables)
        return STATUS_NO_MEMORY;
    if (pipe2(ends, O_CLOEXEC) != 0) {
        free((void *) variables);
        return gnuplot_refuse(fault, "cannot be started", strerror(errno));
    }
    const int e = gnuplot_start(folder, script, ends[1], variables, &child);
    free((void *) variables);
    close(ends[1]);
    if (e == 0) {
        litter_child(child);
        listen_to(ends[0], said);
    }
    close(ends[0]);
    if (e != 0 && e != ENOENT)
        return gnuplot_refuse(fault, "cannot be started", strerror(e));
    while (e == 0 && waitpid(child, &how, 0) < 0 && errno == EINTR)
        continue;
    litter_child(0);
    /* POSIX lets posix_spawn say that nothing was found by exit status 127 */
    if (e == ENOENT || (WIFEXITED(how) && WEXITSTATUS(how) == 127))
        return gnuplot_refuse(fault, "was not found",
                              "install gnuplot, or put it in PATH");
    if (WIFEXITED(how) && WEXITSTATUS(how) == 0)
        return STATUS_OK;
    return gnuplot_refuse(fault, "failed", gnuplot_complaint(said));
}
