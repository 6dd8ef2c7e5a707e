#include "stress_run.h"

#include <math.h>
#include <stdlib.h>

#include "clock.h"
#include "stress_plane.h"
#include "stress_tolerance.h"
#include "stress_work.h"

/* What finding the critical numbers took, without their conditioning. */
static double seconds_of(const struct study *s)
{
    return s->cost[STAGE_STEADY].seconds + s->cost[STAGE_STABLE].seconds +
           s->cost[STAGE_CRITICAL].seconds + s->cost[STAGE_KNEES].seconds;
}

/* The critical numbers beside the oracle's. */
static enum status stress_slope_judge(struct stress_work *w)
{
    const struct study *s = &w->study;
    const struct stress_answer answer = stress_answer_of(s);
    struct stress_row *row = w->row;

    if (answer.has_saddle && !slider_has_manifolds(&s->slider)) {
        stress_row_say(row, STRESS_FAILED, answer.critical.v_plus.reason, NULL);
        return STATUS_OK;
    }
    row->steps =
        (int64_t) (s->stable[SIDE_UPPER].steps + s->stable[SIDE_LOWER].steps);
    row->seconds = seconds_of(s);
    stress_judge(stress_oracle_ask(w->oracle, &w->scene, row), &answer, row);
    return STATUS_OK;
}

#define ASKS(product) (1u << PRODUCT_##product)
static const struct {
    unsigned products; /* of the study, beside those of a case of fields */
    enum status (*judge)(struct stress_work *w);
} kinds[STRESS_KINDS] = {
    [STRESS_SLOPE] = { ASKS(EQUILIBRIA) | ASKS(KNEES) | ASKS(SENSITIVITIES),
                       stress_slope_judge },
    [STRESS_START] = { ASKS(EQUILIBRIA) | ASKS(KNEES), stress_start_judge },
    [STRESS_WINDOW] = { ASKS(EQUILIBRIA) | ASKS(MANIFOLDS) | ASKS(NULLCLINES) |
                            ASKS(BASINS),
                        stress_window_judge },
    [STRESS_FIELD] = { ASKS(BASINS), stress_grid_judge },
};

static enum status judge_law(const struct stress_case *c, struct stress_work *w)
{
    const double start = clock_seconds();

    w->scene = c->scene;
    w->scene.products = kinds[c->kind].products;
    if (c->kind == STRESS_FIELD)
        w->scene.products |= c->scene.products;
    enum status s = study_run(&w->study, &w->scene, NULL, &w->row->fault);
    w->row->seconds = clock_seconds() - start;
    if (s == STATUS_OK)
        s = kinds[c->kind].judge(w);
    study_free(&w->study);
    return s;
}

/* Only STATUS_NO_MEMORY is an error. */
static enum status judge_case(const struct stress_case *c,
                              struct stress_work *w)
{
    const enum status s = c->kind == STRESS_SYSTEM
                              ? stress_plane_judge(&c->scene, w->row)
                              : judge_law(c, w);

    if (s == STATUS_OK || s == STATUS_NO_MEMORY)
        return s;
    stress_row_say(w->row, STRESS_FAILED, w->row->fault.text, NULL);
    return STATUS_OK;
}

static enum status run_case(const struct stress_case *c,
                            struct stress_oracle *oracle,
                            struct stress_row *row)
{
    const double none = (double) NAN;

    *row = (struct stress_row){ .name = c->name,
                                .law = c->scene.system ? "system"
                                                       : c->scene.law.preset,
                                .settings = c->settings,
                                .kind = (int8_t) c->kind,
                                .form = (int8_t) c->scene.law.form,
                                .agree = -1,
                                .digits = none,
                                .allowed = none,
                                .missing = none,
                                .bar = none };
    struct stress_work *w = malloc(sizeof *w);
    if (w == NULL)
        return STATUS_NO_MEMORY;
    *w = (struct stress_work){ .oracle = oracle, .row = row };
    const enum status s = judge_case(c, w);
    free(w);
    return s;
}

static void sum_up(struct stress *s)
{
    for (size_t i = 0; i < s->count; i++) {
        const struct stress_row *row = &s->row[i];
        s->outcome[row->outcome]++;
        if (isnan(row->missing))
            continue;
        s->counted++;
        if (row->missing <= STRESS_MISSING)
            s->full++;
    }
}

/* What the threads share. */
struct shared {
    const struct stress_list *list;
    struct stress_row *row;
    const struct monitor *monitor;
    enum status failed;
    size_t done;
};

/* One thread's share of the cases, from the last: the longest are there. */
static void run_share(struct shared *all, struct stress_oracle *oracle)
{
    const size_t count = all->list->count;

#pragma omp for schedule(dynamic, 1)
    for (size_t i = 0; i < count; i++) {
        const size_t at = count - 1 - i;
        enum status status;
#pragma omp atomic read
        status = all->failed;
        if (status != STATUS_OK)
            continue;
        status = oracle ? run_case(&all->list->at[at], oracle, &all->row[at])
                        : STATUS_NO_MEMORY;
#pragma omp critical
        if (status == STATUS_OK &&
            monitor_tell(all->monitor, "cases", ++all->done, count))
            status = STATUS_STOPPED;
        if (status != STATUS_OK) {
#pragma omp atomic write
            all->failed = status;
        }
    }
}

static enum status run_all(struct stress *s, const struct stress_list *list,
                           const struct monitor *monitor)
{
    struct shared all = { list, s->row, monitor, STATUS_OK, 0 };

#pragma omp parallel
    {
        struct stress_oracle *oracle = calloc(1, sizeof *oracle);
        run_share(&all, oracle);
        free(oracle);
    }
    return all.failed;
}

enum status stress_run(struct stress *s, const struct stress_list *list,
                       const struct monitor *monitor)
{
    enum status status = STATUS_NO_MEMORY;

    *s = (struct stress){ .count = list->count };
    s->row = calloc(list->count + 1, sizeof *s->row);
    if (s->row)
        status = run_all(s, list, monitor);
    if (status == STATUS_OK)
        sum_up(s);
    else
        stress_free(s);
    return status;
}

void stress_free(struct stress *s)
{
    free(s->row);
    *s = (struct stress){ .row = NULL };
}

/* ---- what it says -------------------------------------------------------- */

_Static_assert(sizeof(size_t) == sizeof(int64_t), "counts of record.h");

#define OUTCOME(word, code)                                                    \
    FIELD_AS(stress, COUNT, word, outcome[code], "1", "cases that came to this")

static const struct record_type record_outcomes = RECORD(
    stress, "outcomes", "how many came to what", OUTCOME("exact", STRESS_EXACT),
    OUTCOME("degraded", STRESS_DEGRADED), OUTCOME("none", STRESS_NONE),
    OUTCOME("failed", STRESS_FAILED), OUTCOME("lie", STRESS_LIE),
    FIELD(stress, COUNT, counted, "1", "cases with a number to judge"),
    FIELD(stress, COUNT, full, "1",
          "those with all digits that conditioning allows"));

RESULT_VIEW(view_cases, stress, s->row, s->count)
RESULT_VIEW(view_outcomes, stress, s, 1)

/* clang-format off */
static const struct result stress_results[] = {
    { "/stress", "cases", "stress: its cases", RESULT_COLUMNS,
      .type = &record_stress, .view = view_cases },
    { "/stress", "outcomes", NULL, RESULT_ATTRIBUTES,
      .type = &record_outcomes, .view = view_outcomes },
    { .path = NULL },
};
/* clang-format on */

const struct result *const stress_tables[] = { stress_results, NULL };
