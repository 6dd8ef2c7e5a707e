#include "failing_study.h"

#include "study.h"

double failing_slopes[2];

enum status __real_study_run(struct study *s, const struct scene *scene,
                             const struct monitor *monitor, struct fault *why);
enum status __wrap_study_run(struct study *s, const struct scene *scene,
                             const struct monitor *monitor, struct fault *why);

enum status __wrap_study_run(struct study *s, const struct scene *scene,
                             const struct monitor *monitor, struct fault *why)
{
    if (!(scene->alpha > failing_slopes[0] && scene->alpha < failing_slopes[1]))
        return __real_study_run(s, scene, monitor, why);
    *s = (struct study){ .scene = scene };
    return STATUS_NO_CONVERGENCE;
}
