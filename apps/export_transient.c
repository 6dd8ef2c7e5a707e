#include "export_transient.h"

#include <stdio.h>
#include <stdlib.h>

#include "export.h"
#include "library.h"
#include "result_file.h"
#include "rows.h"
#include "sample.h"
#include "store.h"
#include "store_records.h"

enum { NAME = 96 };

/* A run on its way into its group. */
struct job {
    const struct simulation *s;
    const struct transient *t;
    const char *group;
    struct store *out;
};

/* "/trajectory_0/events" */
static void name_of(const struct job *j, const char *part, char name[NAME])
{
    snprintf(name, NAME, "%s/%s", j->group, part);
}

typedef void sampler(const struct study *s, const struct transient *t, size_t n,
                     struct trajectory_row row[]);

static enum status put_samples(const struct job *j, const char *part,
                               const char *axis, size_t n, sampler *sample)
{
    struct trajectory_row *row = calloc(n, sizeof *row);
    const struct record_array a = { &record_trajectory, row, n };
    char name[NAME];

    if (row == NULL)
        return STATUS_NO_MEMORY;
    sample(&j->s->study, j->t, n, row);
    name_of(j, part, name);
    const enum status s = store_put_records(j->out, name, &a, axis);
    free(row);
    return s;
}

static enum status put_curve(const struct job *j)
{
    const struct scene *c = &j->s->scene;
    const bool neither = c->linear_slip == 0 && c->log_time == 0;
    const size_t by_slip = neither ? EXPORT_SAMPLES : c->linear_slip;
    const size_t by_time = neither ? EXPORT_SAMPLES : c->log_time;
    struct rows rows = rows_of(&record_trajectory);
    enum status s = rows_trajectory(&j->s->study, &j->t->curve, &rows);
    const struct record_array all = rows_array(&rows);

    if (s == STATUS_OK)
        s = store_put_records(j->out, j->group, &all, "time");
    rows_free(&rows);
    if (s == STATUS_OK && by_slip > 0)
        s = put_samples(j, "linear_slip", "slip", by_slip, sample_linear_slip);
    if (s == STATUS_OK && by_time > 0)
        s = put_samples(j, "log_time", "time", by_time, sample_log_time);
    return s;
}

static enum status put_attributes(const struct job *j)
{
    const struct transient_summary *sum = &j->t->sum;
    enum status s =
        store_put_text(j->out, j->group, "end", transient_end_names[sum->end]);

    if (s == STATUS_OK)
        s = store_put_text(j->out, j->group, "fate", fate_names[sum->fate]);
    if (s == STATUS_OK && j->t->reason)
        s = store_put_text(j->out, j->group, "comment", j->t->reason);
    if (s == STATUS_OK)
        s = store_put_real(j->out, j->group, "energy_defect",
                           sum->energy_defect);
    return s;
}

static enum status put_run(const struct job *j)
{
    const struct record_array events = { &record_transient_event, j->t->event,
                                         j->t->events };
    const struct record_array phases = { &record_phase, j->t->phase, PHASES };
    enum status s = STATUS_OK;
    char name[NAME];

    if (j->t->curve.count > 0)
        s = put_curve(j);
    if (s == STATUS_OK)
        s = put_attributes(j);
    name_of(j, "summary", name);
    if (s == STATUS_OK)
        s = store_put_scalars(j->out, name, &record_transient, &j->t->sum);
    name_of(j, "events", name);
    if (s == STATUS_OK)
        s = store_put_records(j->out, name, &events, NULL);
    name_of(j, "phases", name);
    if (s == STATUS_OK)
        s = store_put_records(j->out, name, &phases, NULL);
    return s;
}

static enum status put_all(const struct simulation *s, struct store *out)
{
    enum status status = export_provenance(&s->scene, out);

    for (size_t k = 0; k < s->runs && status == STATUS_OK; k++) {
        char group[NAME / 2];
        snprintf(group, sizeof group, "/trajectory_%zu", k);
        status = put_run(&(struct job){ s, &s->run[k], group, out });
    }
    return status;
}

enum status export_simulation(const struct simulation *s, const char *path,
                              struct fault *why)
{
    struct store *out;
    enum status status = result_file_begin(&out, path, &s->scene,
                                           s->study.block.law.preset, why);

    if (status == STATUS_OK)
        status = result_file_end(&out, path, put_all(s, out), why);
    return status;
}
