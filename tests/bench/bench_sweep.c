/*
 * bench_sweep -- 10,000 slopes and all numbers of `knees` (generalised spinodal
 * law, Table 2) as one sweep, against as many single computations in one
 * process, scene and study; then the sweep on two threads against one.  Prints
 * times and ratios of one run, best of REPEATS; a ratio below 1 means that the
 * sweep is faster.
 */
#include <math.h>
#include <omp.h>
#include <stdio.h>

#include "plain.h"
#include "scene_sweep.h"
#include "sweep.h"

enum { POINTS = 10000, REPEATS = 3 };

static const char *const settings[] = {
    "law.preset=spinodal_gen", "products=[equilibria, folds, knees, estimates]",
    "sweep.key=slope.alpha",   "sweep.from=0.325",
    "sweep.to=0.355",          "sweep.points=10000",
};
enum { SETTINGS = sizeof settings / sizeof *settings };

static bool read_scene(struct scene *scene)
{
    char text[SETTINGS][80], *set[SETTINGS];
    struct fault why;

    for (int i = 0; i < SETTINGS; i++) {
        snprintf(text[i], sizeof text[i], "%s", settings[i]);
        set[i] = text[i];
    }
    return scene_read(scene, NULL, set, SETTINGS, &why) == STATUS_OK;
}

/* One number as a user of the library gets it: the scene, its study. */
static double v_plus_at(double alpha)
{
    char text[3][80], *set[3] = { text[0], text[1], text[2] };
    struct scene scene;
    struct study study;
    struct fault why;
    double v_plus = 0.0;

    snprintf(text[0], sizeof text[0], "%s", settings[0]);
    snprintf(text[1], sizeof text[1], "%s", settings[1]);
    snprintf(text[2], sizeof text[2], "slope.alpha=%.17g", alpha);
    if (scene_read(&scene, NULL, set, 3, &why) != STATUS_OK)
        return NAN;
    if (study_run(&study, &scene, NULL, &why) == STATUS_OK) {
        if (quantity_exists(&study.slider.critical.v_plus))
            v_plus = study.slider.critical.v_plus.value;
        study_free(&study);
    }
    scene_free(&scene);
    return v_plus;
}

/* Seconds of the processor, and a sum that no compiler may leave out. */
static double single(const struct scene *scene, double *sum)
{
    const double begun = plain_worked();

    for (int i = 0; i < POINTS; i++)
        *sum += v_plus_at(scene->sweep.axis[0].value[i]);
    return plain_worked() - begun;
}

/* Seconds of `now`. */
static double swept(const struct scene *scene, int threads, double (*now)(void),
                    double *sum)
{
    const double begun = now();
    struct sweep s;
    struct fault why;

    omp_set_num_threads(threads);
    if (sweep_run(&s, scene, &(struct sweep_options){ 0 }, NULL, &why) !=
        STATUS_OK)
        return NAN;
    const double passed = now() - begun;
    const int v_plus = sweep_find(&s, "v_plus");
    for (size_t i = 0; i < s.points; i++) {
        const struct quantity q = sweep_quantity(&s, v_plus, i);
        if (quantity_exists(&q))
            *sum += q.value;
    }
    sweep_free(&s);
    return passed;
}

int main(void)
{
    double one = HUGE_VAL, two = HUGE_VAL, alone = HUGE_VAL;
    double work = HUGE_VAL, sum[4] = { 0 };
    struct scene scene;

    if (!read_scene(&scene))
        return 1;
    for (int i = 0; i < REPEATS; i++) {
        alone = fmin(alone, single(&scene, &sum[0]));
        work = fmin(work, swept(&scene, 1, plain_worked, &sum[1]));
        one = fmin(one, swept(&scene, 1, plain_now, &sum[2]));
        two = fmin(two, swept(&scene, 2, plain_now, &sum[3]));
    }
    printf("%d slopes, all numbers of knees\n", POINTS);
    printf("work: single %.3f s, sweep %.3f s, ratio %.3f\n", alone, work,
           work / alone);
    printf("clock: 1 thread %.3f s, 2 threads %.3f s, speed-up %.2f\n", one,
           two, one / two);
    printf("the same numbers: %s\n",
           sum[0] == sum[1] && sum[1] == sum[2] && sum[2] == sum[3] ? "yes"
                                                                    : "no");
    scene_free(&scene);
    return 0;
}
