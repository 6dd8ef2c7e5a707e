#include "progress.h"

#include <signal.h>
#include <stdio.h>
#include <unistd.h>

static volatile sig_atomic_t interrupted;
static enum progress how;
static bool line_shown;

static void on_signal(int number)
{
    (void) number;
    interrupted = 1;
}

static void show(const char *stage, uint64_t done, uint64_t total)
{
    if (how == PROGRESS_JSON) {
        fprintf(stderr,
                "{\"stage\": \"%s\", \"done\": %llu, \"total\": %llu}\n", stage,
                (unsigned long long) done, (unsigned long long) total);
        return;
    }
    if (total > 0)
        fprintf(stderr, "\r\033[K%s: %llu of %llu", stage,
                (unsigned long long) done, (unsigned long long) total);
    else
        fprintf(stderr, "\r\033[K%s", stage);
    line_shown = true;
}

static int tell(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    (void) ctx;
    if (how != PROGRESS_NONE)
        show(stage, done, total);
    return interrupted;
}

const struct monitor *progress_monitor(const struct options *o)
{
    static const struct monitor monitor = { tell, NULL };
    const struct sigaction action = { .sa_handler = on_signal };

    how = o->progress;
    if (how == PROGRESS_AUTO && (o->quiet || !isatty(STDERR_FILENO)))
        how = PROGRESS_NONE;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    return &monitor;
}

void progress_end(void)
{
    if (line_shown)
        fputs("\r\033[K", stderr);
    line_shown = false;
}
