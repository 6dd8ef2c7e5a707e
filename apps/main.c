/* slipway: phase planes of rate-and-state friction.  main() reads the command
 * line and hands over to one command. */
#include <fcntl.h>
#include <gsl/gsl_errno.h>
#include <malloc.h>
#include <omp.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include "command.h"
#include "crew.h"
#include "json.h"

/* Whether it shares its work with other ranks. */
static bool shares(const struct command *c)
{
    static const unsigned sharing = COMMAND_LIST(COMMAND_SHARE_BIT);

    return c && sharing >> command_id(c) & 1u;
}

static enum exit_code run(const struct options *o)
{
    const struct command *general = &command_table[COMMAND_HELP];

    if (crew_ranks() > 1 && !shares(o->command))
        return command_fail(STATUS_BAD_ARGUMENT,
                            "several ranks: expected sweep SCENE -o FILE.h5");
    if (!o->help && !o->version)
        return command_run(o->command ? o->command : general, o);
    if (o->help)
        help_print(stdout, o->command);
    else
        printf("slipway %s\n", SLIPWAY_VERSION);
    return EXIT_DONE;
}

/* A closed stream must not become some file we open: what we print would end
 * up in it.  Opened the wrong way round, writing to it fails as it should. */
static void keep_streams_apart(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0)
            (void) !open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/* What one point or one map frees serves the next: by default the system takes
 * it back and clears it anew (a sixth of the time of a map of basins, and two
 * fifths of a sweep of 10,000 slopes). */
static void keep_memory(void)
{
    (void) mallopt(M_MMAP_THRESHOLD, 32 << 20); /* the largest there is */
    (void) mallopt(M_TRIM_THRESHOLD, 64 << 20);
}

/* What was printed must have arrived. */
static enum exit_code finish(enum exit_code code)
{
    const bool arrived = fflush(stdout) == 0 && !ferror(stdout);

    return arrived || code != EXIT_DONE ? code : command_unwritten();
}

int main(int argc, char *argv[])
{
    struct options o;

    crew_begin(&argc, &argv);
    keep_streams_apart();
    keep_memory();
    signal(SIGXFSZ, SIG_IGN); /* a file too large is an error like another */
    gsl_set_error_handler_off();
    json_watch_memory();
    options_parse(&o, argc, argv);
    if (o.threads > 0)
        omp_set_num_threads(o.threads);
    const enum exit_code code = finish(run(&o));
    options_free(&o);
    return crew_end((int) code);
}
