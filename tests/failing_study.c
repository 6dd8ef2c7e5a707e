#include "failing_study.h"

#include "study.h"

double failing_slopes[2];

void __real_study_run_jobs(struct study_job job[], size_t n, unsigned stages,
                           const struct monitor *monitor);
void __wrap_study_run_jobs(struct study_job job[], size_t n, unsigned stages,
                           const struct monitor *monitor);

void __wrap_study_run_jobs(struct study_job job[], size_t n, unsigned stages,
                           const struct monitor *monitor)
{
    __real_study_run_jobs(job, n, stages, monitor);
    for (size_t i = 0; i < n; i++) {
        const double alpha = job[i].scene->alpha;
        if (job[i].status != STATUS_OK ||
            !(alpha > failing_slopes[0] && alpha < failing_slopes[1]))
            continue;
        study_free(job[i].study);
        job[i].status = STATUS_NO_CONVERGENCE;
    }
}
