/* Eight threads, each with studies, pushes and a sweep of its own: the same
 * numbers as one after the other.  Prints TAP. */
#include <pthread.h>
#include <slipway/slipway.h>
#include <stdio.h>
#include <string.h>

enum { THREADS = 8, NUMBERS = 5 };

struct job {
    int number;
    double found[NUMBERS];
};

static const char *const law[] = { "spinodal_gen", "dieterich_gen", "ruina",
                                   "spinodal" };

static slipway_scene *scene_of(int number)
{
    slipway_scene *s = NULL;

    if (slipway_scene_new(&s) ||
        slipway_scene_set(s, "law.preset", law[number % 4]) ||
        slipway_scene_set_number(s, "slope.alpha", 0.33 + 0.002 * number) ||
        slipway_scene_set(s, "products", "[equilibria, knees, basins]") ||
        slipway_scene_set(s, "basins.cells", "[16, 16]") ||
        slipway_scene_set(s, "basins.audit", "8") ||
        slipway_scene_set(s, "sweep.key", "slope.alpha") ||
        slipway_scene_set(s, "sweep.values", "[0.33, 0.34]"))
        return NULL;
    return s;
}

static void *work(void *ctx)
{
    struct job *job = ctx;
    const slipway_state state = { 100.0, 1.0 };
    slipway_scene *scene = scene_of(job->number);
    slipway_study *study = NULL;
    slipway_push *push = NULL;
    slipway_sweep *sweep = NULL;
    slipway_number n = { 0, 0, NULL, 0 }, two[2];
    slipway_answer a = { .fate = SLIPWAY_UNDECIDED };

    memset(job->found, 0, sizeof job->found);
    if (scene && !slipway_study_run(scene, NULL, &study, NULL) &&
        !slipway_study_number(study, "saddle_v", &n))
        job->found[0] = n.value;
    if (study && !slipway_study_number(study, "x_deficit", &n) && !n.reason)
        job->found[1] = n.value;
    if (scene && !slipway_push_open(scene, NULL, &push, NULL) &&
        !slipway_push_find(push, &state, 1, NULL, &a, NULL))
        job->found[2] = 1.0 + (double) a.fate;
    if (push && !a.slip.reason)
        job->found[3] = a.slip.value;
    if (scene && !slipway_sweep_run(scene, NULL, &sweep, NULL) &&
        !slipway_sweep_numbers(sweep, "saddle_psi", two, 2))
        job->found[4] = two[1].value;
    slipway_sweep_free(sweep);
    slipway_push_free(push);
    slipway_study_free(study);
    slipway_scene_free(scene);
    return NULL;
}

int main(void)
{
    struct job together[THREADS], alone[THREADS];
    pthread_t thread[THREADS];
    int failed = 0;

    for (int i = 0; i < THREADS; i++) {
        together[i].number = alone[i].number = i;
        if (pthread_create(&thread[i], NULL, work, &together[i]))
            return puts("Bail out! no thread"), 1;
    }
    for (int i = 0; i < THREADS; i++) {
        pthread_join(thread[i], NULL);
        work(&alone[i]);
        const int good =
            together[i].found[0] > 0.0 && together[i].found[2] > 0.0 &&
            together[i].found[4] != 0.0 &&
            memcmp(together[i].found, alone[i].found, sizeof alone[i].found) ==
                0;
        printf("%sok %d - thread %d, %s\n", good ? "" : "not ", i + 1, i,
               law[i % 4]);
        failed += !good;
    }
    printf("1..%d\n", THREADS);
    return failed > 0;
}
