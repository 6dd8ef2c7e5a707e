#include "stress_run.h"

#include <math.h>
#include <stdlib.h>

#include "stress_slope.h"
#include "stress_state.h"
#include "stress_tolerance.h"

static enum status run_case(const struct stress_case *c, struct stress_row *row)
{
    const double none = (double) NAN;

    *row = (struct stress_row){ .name = c->name,
                                .law = c->scene.law.preset,
                                .settings = c->settings,
                                .kind = (int8_t) c->kind,
                                .form = (int8_t) c->scene.law.form,
                                .agree = -1,
                                .digits = none,
                                .allowed = none,
                                .missing = none,
                                .bar = none };
    switch (c->kind) {
        case STRESS_START:
            return stress_start_run(c, row);
        case STRESS_WINDOW:
            return stress_window_run(c, row);
        default:
            return stress_slope_run(c, row);
    }
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

static enum status run_all(struct stress *s, const struct stress_list *list,
                           const struct monitor *monitor)
{
    enum status failed = STATUS_OK;
    size_t done = 0;

#pragma omp parallel for schedule(dynamic, 1)
    for (size_t i = 0; i < list->count; i++) {
        enum status status;
#pragma omp atomic read
        status = failed;
        if (status != STATUS_OK)
            continue;
        status = run_case(&list->at[i], &s->row[i]);
#pragma omp critical
        if (status == STATUS_OK &&
            monitor_tell(monitor, "cases", ++done, list->count))
            status = STATUS_STOPPED;
        if (status != STATUS_OK) {
#pragma omp atomic write
            failed = status;
        }
    }
    return failed;
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
