/* Each run is made once, judged against the truth, and then repeated for its
 * time, which is not part of the answer. */
#include "workprec.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>

#include "clock.h"
#include "method.h"
#include "record.h"
#include "workprec_answer.h"
#include "workprec_own.h"
#include "workprec_tolerance.h"
#include "workprec_track.h"

/* ---- how long a piece of work takes -------------------------------------- */

enum { QUESTIONS = 501 };

static double median(double value[], size_t n)
{
    gsl_sort(value, 1, n);
    return value[n / 2];
}

/* Seconds between two questions to the clock: their median. */
static double workprec_clock_overhead(void)
{
    double gap[QUESTIONS];

    for (int i = 0; i < QUESTIONS; i++) {
        const double before = clock_seconds();
        gap[i] = clock_seconds() - before;
    }
    return median(gap, QUESTIONS);
}

/* Seconds of a call of `work`, which is called for about `budget` seconds, at
 * least once, where `once` is about what it takes.  `overhead`: of
 * workprec_clock_overhead. */
static double workprec_clock_time(void (*work)(void *ctx), void *ctx,
                                  double once, double budget, double overhead)
{
    const double batch = fmax(1.0, ceil(WORKPREC_BATCH / once));
    const double all = fmin(floor(budget / (once * batch)), WORKPREC_REPEATS);
    const size_t repeats = all > 1.0 ? (size_t) all : 1;
    double seconds[WORKPREC_REPEATS];

    for (size_t i = 0; i < repeats; i++) {
        const double start = clock_seconds();
        for (size_t k = 0; k < (size_t) batch; k++)
            work(ctx);
        seconds[i] = (clock_seconds() - start - overhead) / batch;
    }
    return median(seconds, repeats);
}

/* ---- where times are measured -------------------------------------------- */

static const struct record_type record_workprec_environment = RECORD(
    workprec_environment, "workprec_environment", "where times were measured",
    FIELD(workprec_environment, TEXT, cpu, "1", "processor"),
    FIELD(workprec_environment, TEXT, system, "1", "operating system"),
    FIELD(workprec_environment, TEXT, compiler, "1", "compiler"),
    FIELD(workprec_environment, TEXT, flags, "1", "its optimisation flags"),
    FIELD(workprec_environment, TEXT, gsl, "1", "version of GSL"),
    FIELD(workprec_environment, TEXT, sundials, "1", "version of SUNDIALS"),
    FIELD(workprec_environment, REAL, clock_overhead, "s",
          "taken off every time measured"));

/* The value of the first line "KEY : value"; false where there is none. */
static bool read_value(FILE *in, const char *key, char out[WORKPREC_TEXT])
{
    char line[1024];

    while (fgets(line, sizeof line, in)) {
        const char *colon = strchr(line, ':');
        if (strncmp(line, key, strlen(key)) != 0 || colon == NULL)
            continue;
        colon += 1 + strspn(colon + 1, " \t");
        snprintf(out, WORKPREC_TEXT, "%.*s", (int) strcspn(colon, "\n"), colon);
        return true;
    }
    return false;
}

static void find_cpu(struct workprec_environment *e)
{
    FILE *in = fopen("/proc/cpuinfo", "r");

    e->cpu = e->cpu_text;
    if (in == NULL || !read_value(in, "model name", e->cpu_text))
        snprintf(e->cpu_text, WORKPREC_TEXT, "unknown");
    if (in)
        fclose(in);
}

static void find_system(struct workprec_environment *e)
{
    struct utsname u;

    e->system = e->system_text;
    if (uname(&u) == 0)
        snprintf(e->system_text, WORKPREC_TEXT, "%.60s %.60s %.30s", u.sysname,
                 u.release, u.machine);
    else
        snprintf(e->system_text, WORKPREC_TEXT, "unknown");
}

/* Fills *e, which must not move; what cannot be found out is "unknown". */
static void workprec_environment_find(struct workprec_environment *e)
{
    *e = (struct workprec_environment){ .flags = WORKPREC_FLAGS,
                                        .gsl = method_gsl_version(),
                                        .sundials = method_sundials_version() };
#ifdef __clang__
    e->compiler = __VERSION__;
#else
    e->compiler = "gcc " __VERSION__;
#endif
    find_cpu(e);
    find_system(e);
    e->clock_overhead = workprec_clock_overhead();
}

enum { ENTRANTS_MOST = 32, LADDER_MOST = 16 };

/* ---- who takes part ------------------------------------------------------ */

/* Our own ways, then the integrators of method.h. */
struct entrant {
    const char *name;
    bool foreign;
    unsigned can;                 /* bits 1 << enum workprec_quantity */
    enum workprec_own own;        /* where stepper is NULL */
    const struct method *stepper; /* borrowed */
};

/* A way of our own is one more row, and what it does in workprec_own.c. */
enum {
    ALL = (1u << WORKPREC_QUANTITIES) - 1u,
    SLIP = 1u << WORKPREC_SLIP,
    MOTION = 1u << WORKPREC_TRANSIENT | SLIP
};
static const struct entrant own[] = {
    { "slipway", false, ALL, WORKPREC_SLIPWAY, NULL },
    { "radau", false, MOTION, WORKPREC_RADAU, NULL },
    { "slow_curve", false, SLIP, WORKPREC_SLOW, NULL },
};
enum { OWN = sizeof own / sizeof *own };

/* Number i; false beyond the last. */
static bool entrant_at(size_t i, struct entrant *e)
{
    const struct method *m = i < OWN ? NULL : method_at(i - OWN);

    if (i < OWN)
        *e = own[i];
    else if (m)
        *e = (struct entrant){
            .name = m->name, .foreign = m->foreign, .can = ALL, .stepper = m
        };
    return i < OWN || m;
}

/* ---- runs ---------------------------------------------------------------- */

/* How a race is run. */
struct rules {
    double rtol[LADDER_MOST];
    size_t rungs, cells, sample, calls;
    double budget;
};

static struct rules rules_of(bool quick)
{
    struct rules r = { .rungs = quick ? 4 : 12,
                       .cells = quick ? 1 : WORKPREC_CELLS_MOST,
                       .sample = quick ? 3 : 12,
                       .calls = quick ? WORKPREC_CALLS_QUICK : WORKPREC_CALLS,
                       .budget =
                           quick ? WORKPREC_SECONDS_QUICK : WORKPREC_SECONDS };

    for (size_t i = 0; i < r.rungs; i++)
        r.rtol[i] =
            pow(10.0, quick ? -3.0 - 3.0 * (double) i : -2.0 - (double) i);
    return r;
}

/* One run, to be made again and again. */
struct job {
    const struct workprec_task *task;
    const struct workprec_shared *shared;
    struct entrant who;
    enum workprec_quantity what;
    double rtol;
    size_t calls;
    struct workprec_answer *answer;
};

static void work(void *ctx)
{
    const struct job *j = ctx;

    if (j->who.stepper)
        workprec_track(j->task, j->what, j->who.stepper, j->rtol, j->calls,
                       j->answer);
    else
        workprec_own_run(j->task, j->shared, j->who.own, j->what, j->rtol,
                         j->answer);
}

/* Who has a bar has told how far off it may be. */
static bool is_silent(const struct job *j, double true_error)
{
    const double reported = j->answer->reported;
    const double fair =
        WORKPREC_SILENT * WORKPREC_FAIR * (j->rtol + WORKPREC_FLOOR);

    return !(true_error <=
             (isnan(reported) ? fmin(fair, WORKPREC_WRONG) : reported));
}

static enum workprec_status judge(const struct job *j, double true_error)
{
    if (!j->answer->success)
        return WORKPREC_FAILED;
    return is_silent(j, true_error) ? WORKPREC_SILENT_FAILURE : WORKPREC_DONE;
}

/* What the answer says. */
static struct workprec_run judged(const struct job *j)
{
    const struct workprec_answer *a = j->answer;
    const double error =
        a->success ? workprec_error(j->task, j->what, a) : (double) NAN;

    return (struct workprec_run){
        .quantity = (int8_t) j->what,
        .method = j->who.name,
        .foreign = j->who.foreign,
        .rtol = j->rtol,
        .true_error = error,
        .reported_error = a->reported,
        .field_evaluations = (int64_t) a->calls,
        .steps = (int64_t) a->steps,
        .status = (int8_t) judge(j, error),
    };
}

/* Cells do not count their work. */
static bool must_count(const struct job *j)
{
    return j->what == WORKPREC_SLIP && !j->who.stepper &&
           j->who.own != WORKPREC_RADAU;
}

static enum status race(struct job *j, const struct rules *r, double overhead,
                        struct workprec_run *run)
{
    const enum status s =
        must_count(j)
            ? workprec_own_count(j->task, j->who.own, j->rtol, j->answer)
            : STATUS_OK;
    const size_t counted = j->answer->calls;
    const double before = clock_seconds();

    work(j);
    const double once = fmax(clock_seconds() - before - overhead, 1e-9);
    if (must_count(j))
        j->answer->calls = counted;
    *run = judged(j);
    run->seconds = j->answer->success
                       ? workprec_clock_time(work, j, once, r->budget, overhead)
                       : once;
    return s;
}

/* All methods on one quantity. */
static enum status race_for(struct workprec *w, const struct rules *r,
                            struct job *j, const struct monitor *monitor)
{
    const char *stage = workprec_quantity_names[j->what];
    struct entrant who;
    enum status s = STATUS_OK;

    for (size_t i = 0; s == STATUS_OK && entrant_at(i, &who); i++) {
        if (monitor_tell(monitor, stage, i, 0))
            return STATUS_STOPPED;
        if (!(who.can >> j->what & 1u))
            continue;
        j->who = who;
        for (size_t k = 0; k < r->rungs && s == STATUS_OK; k++) {
            j->rtol = r->rtol[k];
            s = race(j, r, w->environment.clock_overhead, &w->run[w->runs]);
            w->runs += s == STATUS_OK;
        }
    }
    return s;
}

static enum status race_all(struct workprec *w, const struct rules *r,
                            const struct workprec_shared *shared,
                            const struct monitor *monitor)
{
    struct workprec_answer *answer = calloc(1, sizeof *answer);
    struct job j = {
        .task = &w->task, .shared = shared, .calls = r->calls, .answer = answer
    };
    enum status s = answer ? STATUS_OK : STATUS_NO_MEMORY;

    for (int q = 0; q < WORKPREC_QUANTITIES && s == STATUS_OK; q++) {
        j.what = (enum workprec_quantity) q;
        if (w->task.reason[q] == NULL)
            s = race_for(w, r, &j, monitor);
    }
    free(answer);
    return s;
}

static enum status run(struct workprec *w, const struct rules *r,
                       const struct monitor *monitor)
{
    struct workprec_shared shared = { NULL };
    enum status s = STATUS_OK;

    if (w->scene.system == NULL)
        s = workprec_task_init(&w->task, &w->study, r->cells, r->sample,
                               monitor);
    if (s != STATUS_OK || w->task.saddle == NULL)
        return s;
    w->run =
        calloc(WORKPREC_QUANTITIES * ENTRANTS_MOST * r->rungs, sizeof *w->run);
    s = w->run ? STATUS_OK : STATUS_NO_MEMORY;
    if (s == STATUS_OK && w->task.plane == NULL)
        s = workprec_shared_init(&shared, &w->task);
    if (s == STATUS_OK)
        s = race_all(w, r, &shared, monitor);
    workprec_shared_free(&shared);
    return s ? s : workprec_rank(w->run, w->runs, &w->fastest, &w->ranks);
}

enum status workprec_run(struct workprec *w, const struct scene *scene,
                         bool quick, const struct monitor *monitor,
                         struct fault *why)
{
    const struct rules r = rules_of(quick);

    *w = (struct workprec){ .scene = *scene };
    w->scene.products = 1u << PRODUCT_EQUILIBRIA;
    workprec_environment_find(&w->environment);
    enum status s = scene->system
                        ? workprec_plane_init(&w->plane, scene, r.sample,
                                              &w->study, &w->task, monitor, why)
                        : study_run(&w->study, &w->scene, monitor, why);
    if (s != STATUS_OK)
        return s;
    s = run(w, &r, monitor);
    if (s == STATUS_OK)
        return s;
    snprintf(why->text, sizeof why->text, "workprec: %s", status_text(s));
    workprec_free(w);
    return s;
}

void workprec_free(struct workprec *w)
{
    free(w->run);
    free(w->fastest);
    w->run = NULL;
    w->fastest = NULL;
    w->runs = w->ranks = 0;
    study_free(&w->study);
    workprec_plane_free(&w->plane);
}

/* ---- what it says -------------------------------------------------------- */

#define MISSING(word, code)                                                    \
    FIELD_AS(workprec, TEXT, word, task.reason[code], "1",                     \
             "why this slope has no such quantity, if it has none")

static const struct record_type record_missing = RECORD(
    workprec, "reasons", "what is missing", MISSING("v_plus", WORKPREC_V_PLUS),
    MISSING("v_minus", WORKPREC_V_MINUS),
    MISSING("x_excess", WORKPREC_X_EXCESS), MISSING("curve", WORKPREC_CURVE),
    MISSING("transient", WORKPREC_TRANSIENT),
    MISSING("basin_rows", WORKPREC_ROWS), MISSING("slip", WORKPREC_SLIP));

RESULT_VIEW(view_runs, workprec, s->run, s->runs)
RESULT_VIEW(view_missing, workprec, s, 1)
RESULT_VIEW(view_fastest, workprec, s->fastest, s->ranks)
RESULT_VIEW(view_environment, workprec, &s->environment, 1)

/* clang-format off */
static const struct result workprec_results[] = {
    { "/workprec", "runs", "workprec: methods at tolerances", RESULT_COLUMNS,
      .type = &record_workprec_run, .view = view_runs },
    { "/workprec/fastest", "fastest", "who is fastest at an accuracy",
      RESULT_COLUMNS, .type = &record_workprec_fastest,
      .title = "time to a true error, ours with error bars, others' without",
      .view = view_fastest },
    { "/workprec", "missing", NULL, RESULT_ATTRIBUTES,
      .type = &record_missing, .title = "", .view = view_missing },
    { "/workprec/environment", "environment", "where times were measured",
      .type = &record_workprec_environment,
      .title = "where times were measured, on one thread",
      .view = view_environment },
    { .path = NULL },
};
/* clang-format on */

const struct result *const workprec_tables[] = { workprec_results, NULL };
