#include "workprec_rank.h"

#include <math.h>
#include <stdlib.h>

#include "workprec_task.h"
#include "workprec_tolerance.h"

const char *const workprec_status_names[] = { "done", "failed",
                                              "silent_failure", NULL };
static const char *const foreign_names[] = { "own", "foreign", NULL };

static const double accuracies[] = { 1e-3, 1e-6, 1e-9, 1e-12 };
enum { ACCURACIES = sizeof accuracies / sizeof *accuracies };

const struct record_type record_workprec_run = RECORD(
    workprec_run, "workprec_run", "a method on a quantity at a tolerance",
    FIELD_CODE(workprec_run, quantity, workprec_quantity_names,
               "what is computed"),
    FIELD(workprec_run, TEXT, method, "1", "by which method"),
    FIELD_CODE(workprec_run, foreign, foreign_names, "whose it is"),
    FIELD(workprec_run, REAL, rtol, "1", "tolerance asked for"),
    FIELD(workprec_run, REAL, true_error, "1", "error against 113 bits"),
    FIELD(workprec_run, REAL, reported_error, "1",
          "error bar, where the method has one"),
    FIELD(workprec_run, REAL, seconds, "s",
          "time of the run, median of repeats"),
    FIELD(workprec_run, COUNT, field_evaluations, "1",
          "evaluations of the field; 0: not counted"),
    FIELD(workprec_run, COUNT, steps, "1", "accepted steps; 0: not counted"),
    FIELD_CODE(workprec_run, status, workprec_status_names,
               "how the run went"));

const struct record_type record_workprec_fastest = RECORD(
    workprec_fastest, "workprec_fastest", "who is fastest at an accuracy",
    FIELD_CODE(workprec_fastest, quantity, workprec_quantity_names,
               "what is computed"),
    FIELD(workprec_fastest, REAL, accuracy, "1", "true error"),
    FIELD(workprec_fastest, TEXT, method, "1", "the fastest of all"),
    FIELD(workprec_fastest, REAL, seconds, "s", "its time"),
    FIELD(workprec_fastest, TEXT, own, "1", "the fastest of ours"),
    FIELD(workprec_fastest, REAL, own_seconds, "s", "its time"),
    FIELD(workprec_fastest, TEXT, foreign, "1", "the fastest of others"),
    FIELD(workprec_fastest, REAL, foreign_seconds, "s", "its time"),
    FIELD(workprec_fastest, REAL, ratio_to_best_foreign, "1",
          "time of the fastest of others over that of the fastest of ours"));

static bool counts(const struct workprec_run *r)
{
    return r->status == WORKPREC_DONE;
}

/* log of the error, no less than what is compared. */
static double depth(const struct workprec_run *r)
{
    return log(fmax(r->true_error, WORKPREC_LEAST));
}

/* Between a run too coarse and one that is good enough. */
static double time_between(const struct workprec_run *coarse,
                           const struct workprec_run *fine, double accuracy)
{
    const double from = depth(coarse), to = depth(fine);
    const double part = (log(accuracy) - from) / (to - from);

    return exp(log(coarse->seconds) +
               part * (log(fine->seconds) - log(coarse->seconds)));
}

double workprec_time_at(const struct workprec_run run[], size_t count,
                        double accuracy)
{
    double best = HUGE_VAL;

    for (size_t i = 0; i < count; i++) {
        if (!counts(&run[i]) || run[i].true_error > accuracy)
            continue;
        best = fmin(best, run[i].seconds);
        if (i > 0 && counts(&run[i - 1]) && run[i - 1].true_error > accuracy)
            best = fmin(best, time_between(&run[i - 1], &run[i], accuracy));
    }
    return best;
}

static size_t same_method(const struct workprec_run run[], size_t runs)
{
    size_t n = 1;

    while (n < runs && run[n].method == run[0].method &&
           run[n].quantity == run[0].quantity)
        n++;
    return n;
}

/* NaN where nobody gets there. */
static double known(const char *method, double seconds)
{
    return method ? seconds : (double) NAN;
}

static struct workprec_fastest rank_one(const struct workprec_run run[],
                                        size_t runs, int8_t quantity,
                                        double accuracy)
{
    const char *name[2] = { NULL, NULL }; /* ours, others' */
    double best[2] = { HUGE_VAL, HUGE_VAL };

    for (size_t i = 0, n; i < runs; i += n) {
        n = same_method(&run[i], runs - i);
        if (run[i].quantity != quantity)
            continue;
        const double seconds = workprec_time_at(&run[i], n, accuracy);
        if (seconds < best[run[i].foreign]) {
            best[run[i].foreign] = seconds;
            name[run[i].foreign] = run[i].method;
        }
    }
    const int first = best[1] < best[0];
    return (struct workprec_fastest){
        .quantity = quantity,
        .accuracy = accuracy,
        .method = name[first],
        .seconds = known(name[first], best[first]),
        .own = name[0],
        .own_seconds = known(name[0], best[0]),
        .foreign = name[1],
        .foreign_seconds = known(name[1], best[1]),
        .ratio_to_best_foreign =
            name[0] && name[1] ? best[1] / best[0] : (double) NAN,
    };
}

enum status workprec_rank(const struct workprec_run run[], size_t runs,
                          struct workprec_fastest **out, size_t *ranks)
{
    struct workprec_fastest *all =
        calloc(WORKPREC_QUANTITIES * ACCURACIES, sizeof *all);
    size_t n = 0;

    if (all == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < runs; i++) {
        if (i > 0 && run[i].quantity == run[i - 1].quantity)
            continue;
        for (int k = 0; k < ACCURACIES; k++)
            all[n++] = rank_one(run, runs, run[i].quantity, accuracies[k]);
    }
    *out = all;
    *ranks = n;
    return STATUS_OK;
}
