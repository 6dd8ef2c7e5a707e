#include "progress.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "clock.h"
#include "litter.h"
#include "text.h"

enum { BAR_WIDTH = 20 };

/* Seconds between two lines of a stage; its first and last are always shown. */
static const double rest = 0.1;

/* What is shown of the stage at hand. */
struct shown {
    const char *stage;  /* borrowed; NULL: none yet */
    double begun, last; /* seconds */
    uint64_t from;      /* done when it was first told of */
};

static volatile sig_atomic_t interrupted;
static enum { PROGRESS_NONE, PROGRESS_BAR, PROGRESS_JSON } how;
static struct shown shown;
static volatile sig_atomic_t line_shown;

/* nohup says that a terminal's end is to be ignored. */
static bool ignores(int number)
{
    struct sigaction now;

    return sigaction(number, NULL, &now) == 0 && now.sa_handler == SIG_IGN;
}

/* How long work may take to hear of a signal, ns. */
static const long grace = 700000000L;
static timer_t deadline;
static bool listens;

static void set_deadline(long ns)
{
    const struct itimerspec once = { .it_value = { 0, ns } };

    if (listens)
        (void) timer_settime(deadline, 0, &once, NULL);
}

static void on_signal(int number)
{
    (void) number;
    if (!interrupted)
        set_deadline(grace);
    interrupted = 1;
}

/* What is said by whom a deadline ends, while there is something left. */
static char farewell[2048];
static volatile sig_atomic_t leaves;

/* Some work is deaf, or gnuplot is at it. */
static _Noreturn void on_deadline(int number)
{
    static const char clear[] = "\r\033[K", said[] = "slipway: interrupted\n";
    const char *last = leaves ? farewell : said;

    (void) number;
    if (line_shown)
        (void) !write(STDERR_FILENO, clear, sizeof clear - 1);
    (void) !write(STDERR_FILENO, last, strlen(last));
    litter_sweep();
    _exit(EXIT_INTERRUPT);
}

/* Signals are heard from now on; without a timer they end us as they are. */
static void listen(void)
{
    const struct sigaction action = { .sa_handler = on_signal };
    const struct sigaction end = { .sa_handler = on_deadline };
    struct sigevent alarm = { .sigev_notify = SIGEV_SIGNAL };

    alarm.sigev_signo = SIGALRM;
    sigaction(SIGALRM, &end, NULL);
    listens = listens || timer_create(CLOCK_MONOTONIC, &alarm, &deadline) == 0;
    if (!listens)
        return;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    if (!ignores(SIGHUP))
        sigaction(SIGHUP, &action, NULL);
}

/* Notes that it is time for another line of this stage. */
static bool is_due(const char *stage, uint64_t done, uint64_t total)
{
    const double t = clock_seconds();
    const bool same = shown.stage && strcmp(shown.stage, stage) == 0;

    if (same && t - shown.last < rest && !(total > 0 && done >= total))
        return false;
    if (!same || done < shown.from)
        shown = (struct shown){ stage, t, t, done };
    shown.last = t;
    return true;
}

static void show_json(const char *stage, uint64_t done, uint64_t total)
{
    fprintf(stderr, "{\"stage\": \"%s\", \"done\": %llu, \"total\": %llu}\n",
            stage, (unsigned long long) done, (unsigned long long) total);
}

/* stage [#####---------------]  25 %  1.2e+03/s  0:42 left */
static void show_bar(const char *stage, uint64_t done, uint64_t total)
{
    const double part = (double) done / (double) total;
    const double passed = shown.last - shown.begun;
    char bar[BAR_WIDTH + 1] = "";

    for (int i = 0; i < BAR_WIDTH; i++)
        bar[i] = i < (int) (part * BAR_WIDTH) ? '#' : '-';
    fprintf(stderr, "\r\033[K%s [%s] %3.0f %%", stage, bar, 100.0 * part);
    if (done > shown.from && passed > 0.0) {
        const double rate = (double) (done - shown.from) / passed;
        const double left = (double) (total - done) / rate;
        fprintf(stderr, "  %.3g/s  %.0f:%02.0f left", rate, floor(left / 60.0),
                fmod(floor(left), 60.0));
    }
}

static void show(const char *stage, uint64_t done, uint64_t total)
{
    if (how == PROGRESS_JSON) {
        show_json(stage, done, total);
        return;
    }
    if (total > 0)
        show_bar(stage, done < total ? done : total, total);
    else
        fprintf(stderr, "\r\033[K%s", stage);
    line_shown = true;
}

static int tell(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    (void) ctx;
    if (how != PROGRESS_NONE && is_due(stage, done, total))
        show(stage, done, total);
    return interrupted;
}

const struct monitor *progress_monitor(const struct options *o)
{
    static const struct monitor monitor = { tell, NULL };
    const char *word = o->progress ? o->progress : "auto";

    const bool bar =
        strcmp(word, "bar") == 0 || (strcmp(word, "auto") == 0 && !o->quiet);

    how = strcmp(word, "json") == 0           ? PROGRESS_JSON
          : bar && isatty(STDERR_FILENO) != 0 ? PROGRESS_BAR
                                              : PROGRESS_NONE;
    listen();
    return &monitor;
}

void progress_leaves(const char *text)
{
    char line[sizeof farewell - sizeof "slipway: \n"];

    leaves = false;
    text_show(text ? text : "", line, sizeof line);
    snprintf(farewell, sizeof farewell, "slipway: %s\n", line);
    leaves = text != NULL;
}

void progress_heard(void)
{
    set_deadline(0);
}

void progress_end(void)
{
    if (line_shown)
        fputs("\r\033[K", stderr);
    line_shown = false;
}
