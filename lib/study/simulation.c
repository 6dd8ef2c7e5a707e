#include "simulation.h"

#include <stdio.h>
#include <stdlib.h>

#include "curve_rows.h"
#include "near_runs.h"
#include "sample.h"

static enum status run_all(struct simulation *s, const struct monitor *monitor)
{
    struct transient_options o = transient_defaults(&s->scene);
    enum status failed = STATUS_OK;

    o.labels = &s->labels;
    if (monitor_tell(monitor, "transients", 0, s->runs))
        return STATUS_STOPPED;
#pragma omp parallel for schedule(dynamic) reduction(max : failed)
    for (size_t i = 0; i < s->runs; i++) {
        const enum status status = transient_find(
            &s->study.slider, s->scene.start[i], &o, NULL, &s->run[i]);
        failed = status > failed ? status : failed;
    }
    return failed;
}

static enum status blame(enum status status, struct fault *why)
{
    const bool outside = status == STATUS_BAD_ARGUMENT;

    snprintf(why->text, sizeof why->text, "%s",
             outside ? "a trajectory starts outside [1e-300, 1e300]"
                     : status_text(status));
    return outside ? STATUS_BAD_SCENE : status;
}

enum status simulation_run(struct simulation *s, const struct scene *scene,
                           const struct monitor *monitor, struct fault *why)
{
    *s = (struct simulation){ .scene = *scene };
    if (scene->starts == 0)
        return fault_set(
            why, STATUS_BAD_SCENE,
            "no start, expected trajectories.starts (or --v and --psi)");
    s->scene.products = 1u << PRODUCT_KNEES | 1u << PRODUCT_EQUILIBRIA;
    enum status status = study_run(&s->study, &s->scene, monitor, why);
    if (status != STATUS_OK)
        return status;
    s->run = calloc(scene->starts, sizeof *s->run);
    s->runs = s->run ? scene->starts : 0;
    status = s->run ? labels_init(&s->labels, &s->study.slider, s->scene.rtol,
                                  monitor)
                    : STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        status = run_all(s, monitor);
    if (status == STATUS_OK)
        status = near_runs_tell(&s->scene, s->runs, monitor, s->run);
    if (status == STATUS_OK)
        return STATUS_OK;
    simulation_free(s);
    return blame(status, why);
}

void simulation_free(struct simulation *s)
{
    for (size_t i = 0; i < s->runs; i++)
        transient_free(&s->run[i]);
    free(s->run);
    s->run = NULL;
    s->runs = 0;
    labels_free(&s->labels);
    study_free(&s->study);
}

/* ---- what a simulation says ---------------------------------------------- */

RESULT_COUNT(count_runs, simulation, s->runs)

static enum status view_curve(const void *run, size_t k,
                              struct result_view *out)
{
    const struct simulation *s = run;
    struct rows r = rows_of(&record_trajectory);

    return s->run[k].curve.count > 0
               ? rows_lend(
                     out, &r,
                     curve_rows_trajectory(&s->study, &s->run[k].curve, &r))
               : STATUS_OK;
}

/* How many samples, if `asked` of them and `others` by the other rule. */
static size_t samples(size_t asked, size_t others)
{
    return asked == 0 && others == 0 ? SIMULATION_SAMPLES : asked;
}

typedef void sampler(const struct slider *s, const struct transient *t,
                     size_t n, struct trajectory_row row[]);

static enum status view_samples(const struct simulation *s, size_t k, size_t n,
                                sampler *sample, struct result_view *out)
{
    const struct transient *t = &s->run[k];

    if (n == 0 || t->curve.count == 0)
        return STATUS_OK;
    struct trajectory_row *row = calloc(n, sizeof *row);
    if (row == NULL)
        return STATUS_NO_MEMORY;
    sample(&s->study.slider, t, n, row);
    out->owned = row;
    return result_lend(out, row, n);
}

static enum status view_linear_slip(const void *run, size_t k,
                                    struct result_view *out)
{
    const struct simulation *s = run;

    return view_samples(s, k, samples(s->scene.linear_slip, s->scene.log_time),
                        sample_linear_slip, out);
}

static enum status view_log_time(const void *run, size_t k,
                                 struct result_view *out)
{
    const struct simulation *s = run;

    return view_samples(s, k, samples(s->scene.log_time, s->scene.linear_slip),
                        sample_log_time, out);
}

static enum status view_end(const void *run, size_t k, struct result_view *out)
{
    const struct transient *t = &((const struct simulation *) run)->run[k];
    const struct transient_summary *sum = &t->sum;

    return curve_rows_lend_end(
        out,
        (struct run_end){ transient_end_names[sum->end], fate_names[sum->fate],
                          t->reason, sum->energy_defect });
}

RESULT_VIEW(view_summary, simulation, &s->run[k].sum, 1)
RESULT_VIEW(view_events, simulation, s->run[k].event, s->run[k].events)
RESULT_VIEW(view_phases, simulation, s->run[k].phase, PHASES)

static const struct record_type record_reason =
    RECORD(transient, "reason", "what went wrong",
           FIELD(transient, TEXT, reason, "1", "why it is undecided or lost"));

RESULT_VIEW(view_reason, simulation, &s->run[k], 1)

/* clang-format off */
static const struct result simulation_results[] = {
    { "/trajectory_K", NULL, "simulate: a run", RESULT_COLUMNS,
      .axis = "time", .type = &record_trajectory, .count = count_runs,
      .view = view_curve },
    { "/trajectory_K", NULL, NULL, RESULT_ATTRIBUTES,
      .type = &record_run_end, .count = count_runs, .view = view_end },
    { "/trajectory_K/linear_slip", NULL,
      "simulate: samples evenly over slip", RESULT_COLUMNS, .axis = "slip",
      .type = &record_trajectory, .count = count_runs,
      .view = view_linear_slip },
    { "/trajectory_K/log_time", NULL,
      "simulate: samples evenly over the logarithm of time", RESULT_COLUMNS,
      .axis = "time", .type = &record_trajectory, .count = count_runs,
      .view = view_log_time },
    { "/trajectory_K/summary", "trajectories[K]", "simulate: the run as a "
      "whole", .type = &record_transient, .title = "trajectories[K]", .count = count_runs,
      .view = view_summary },
    { NULL, "trajectories[K]", NULL, .type = &record_reason, .title = "",
      .count = count_runs, .view = view_reason },
    { "/trajectory_K/phases", "trajectories[K].phases",
      "simulate: the three phases of sliding of the paper's section 4.4",
      RESULT_COLUMNS, .type = &record_phase, .title = "", .count = count_runs,
      .view = view_phases },
    { "/trajectory_K/events", "trajectories[K].events",
      "simulate: what happens along it", RESULT_COLUMNS,
      .type = &record_transient_event, .title = "",
      .count = count_runs,
      .view = view_events },
    { .path = NULL },
};
/* clang-format on */

const struct result *const simulation_tables[] = { simulation_results, NULL };
