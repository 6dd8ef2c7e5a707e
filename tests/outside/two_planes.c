/* Friction and systems of formulas through the installed headers alone: as C
 * and, the same file, as C++.  Prints TAP; its numbers have closed forms or are
 * held to the shared table. */
#include <math.h>
#include <slipway/slipway.h>
#include <slipway/slipway_planar.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int cases, failed;

static void told(int good, const char *what)
{
    printf("%sok %d - %s\n", good ? "" : "not ", ++cases, what);
    failed += !good;
}

/* ---- friction ------------------------------------------------------------ */

static slipway_scene *scene_at(double alpha, const char *products)
{
    slipway_scene *s = NULL;

    if (slipway_scene_new(&s) ||
        slipway_scene_set(s, "law.preset", "dieterich_gen") ||
        slipway_scene_set_number(s, "slope.alpha", alpha) ||
        slipway_scene_set(s, "products", products)) {
        puts("Bail out! no scene");
        exit(1);
    }
    return s;
}

static void critical_numbers(void)
{
    slipway_scene *scene = scene_at(0.34, "[equilibria, folds, knees]");
    slipway_study *study = NULL;
    slipway_equilibrium e[5];
    slipway_number v, none;
    size_t names = 0, saddle = 0;

    told(slipway_study_run(scene, NULL, &study, NULL) == SLIPWAY_OK, "a study");
    slipway_scene_free(scene);
    told(slipway_study_number(study, "v_plus", &v) == SLIPWAY_OK &&
             fabs(v.value - 2832.2233588) < 1e-7 && v.error < 1e-8,
         "v_plus of the shared table");
    told(slipway_study_number(study, "psi_at_v0", &none) == SLIPWAY_OK &&
             none.reason && isnan(none.value),
         "a number that does not exist has a reason");
    told(slipway_study_number(study, "v_plsu", &v) == SLIPWAY_BAD_ARGUMENT,
         "an unknown name is refused");
    while (slipway_study_label(study, names).name)
        saddle += !strcmp(slipway_study_label(study, names++).name, "saddle_v");
    told(names > 20 && saddle == 1 &&
             strlen(slipway_study_label(study, 0).unit) > 0 &&
             strlen(slipway_study_label(study, 0).text) > 5,
         "numbers have names, units and meanings");
    told(slipway_study_equilibria(study, e, 5) == 1 &&
             e[0].type == SLIPWAY_SADDLE && e[0].lambda_minus.value < 0.0 &&
             e[0].lambda_plus.value > 0.0,
         "its saddle");
    slipway_study_free(study);
}

static void a_wrong_scene(void)
{
    slipway_scene *scene = scene_at(7.0, "[knees]");
    slipway_study *study = NULL;
    slipway_fault why = { "" };

    told(slipway_study_run(scene, NULL, &study, &why) == SLIPWAY_BAD_SCENE &&
             study == NULL && strstr(why.text, "slope.alpha"),
         "a wrong slope is named");
    slipway_scene_free(scene);
    told(slipway_scene_read("/nowhere.yaml", &scene, &why) == SLIPWAY_IO &&
             strstr(why.text, "/nowhere.yaml"),
         "a missing file is named");
}

static void branches(void)
{
    slipway_scene *scene = scene_at(0.34, "[manifolds]");
    slipway_study *study = NULL;
    const int ran = slipway_study_run(scene, NULL, &study, NULL) == SLIPWAY_OK;
    size_t n = 0;
    const slipway_point *p =
        ran ? slipway_study_branch(study, SLIPWAY_STABLE_UPPER, &n) : NULL;
    int rises = n > 10;

    told(ran && strcmp(slipway_study_axis(study, 1).name, "psi") == 0 &&
             slipway_study_axis(study, 1).is_log &&
             slipway_study_axis(study, 1).range[0] == 1e-3,
         "states have axes");
    for (size_t i = 1; i < n; i++)
        rises = rises && p[i].v >= (1.0 - 1e-14) * p[i - 1].v &&
                p[i].psi > p[i - 1].psi && p[i].arc > p[i - 1].arc &&
                !(p[i].slope <= 0.0) && p[i].error < 1e-9;
    told(rises, "the separatrix rises from the saddle");
    slipway_study_free(study);
    slipway_scene_free(scene);
}

static void basins(void)
{
    slipway_scene *scene = scene_at(0.34, "[basins, margin, slip]");
    slipway_study *study = NULL;
    int8_t label[64];
    double v[8], psi[8], by_v[64], by_psi[64], slip[64], error[64];
    size_t columns = 0, rows = 0;
    int good =
        slipway_scene_set(scene, "basins.cells", "[8, 8]") == SLIPWAY_OK &&
        slipway_study_run(scene, NULL, &study, NULL) == SLIPWAY_OK;

    if (good)
        slipway_basin_size(study, &columns, &rows);
    good = good && columns == 8 && rows == 8 &&
           slipway_basin_axes(study, v, psi) == SLIPWAY_OK &&
           slipway_basin_labels(study, 0, 8, label) == SLIPWAY_OK &&
           slipway_basin_margins(study, 0, 8, by_v, by_psi) == SLIPWAY_OK &&
           slipway_basin_field(study, "slip", 0, 8, slip, error) == SLIPWAY_OK;
    told(good, "a map of basins with margins and slip");
    told(good && label[7 * 8] == SLIPWAY_REST_FINITE &&
             label[7] == SLIPWAY_RUNAWAY,
         "slow and healed it rests, fast and worn it runs away");
    told(good && slip[7 * 8] > 0.0 && isnan(slip[7]), "slip where it stops");
    told(good &&
             slipway_basin_labels(study, 4, 5, label) == SLIPWAY_BAD_ARGUMENT,
         "rows beyond the grid are refused");
    told(good && slipway_basin_field(study, "time", 0, 8, slip, error) ==
                     SLIPWAY_BAD_ARGUMENT,
         "a field that nobody asked for is refused");
    slipway_study_free(study);
    slipway_scene_free(scene);
}

static void pushes(void)
{
    static const slipway_state state[] = { { 1.0, 10.0 }, { 1e4, 10.0 } };
    static const slipway_state wrong[] = { { 1.0, -1.0 } };
    slipway_scene *scene = scene_at(0.34, "[equilibria]");
    slipway_push *push = NULL;
    slipway_answer a[2];
    slipway_fault why = { "" };
    const int open = slipway_push_open(scene, NULL, &push, &why) == SLIPWAY_OK;

    told(open &&
             slipway_push_find(push, state, 2, NULL, a, &why) == SLIPWAY_OK &&
             a[0].fate == SLIPWAY_REST_FINITE && a[0].slip.value > 0.0 &&
             a[0].v_kick.value > 1.0 && a[1].fate == SLIPWAY_RUNAWAY &&
             a[1].slip.reason,
         "one push stops, the other does not");
    told(open &&
             slipway_push_find(push, wrong, 1, NULL, a, &why) ==
                 SLIPWAY_BAD_ARGUMENT &&
             strstr(why.text, "state 0"),
         "a state outside the plane is named");
    slipway_push_free(push);
    slipway_scene_free(scene);
}

static void sweeps(void)
{
    slipway_scene *scene = scene_at(0.34, "[knees]");
    slipway_sweep *sweep = NULL;
    slipway_number v[3];
    slipway_label key, label = { NULL, NULL, NULL, NULL };
    size_t n = 0, names = 0;
    const int ran =
        slipway_scene_set(scene, "sweep.key", "slope.alpha") == SLIPWAY_OK &&
        slipway_scene_set(scene, "sweep.values", "[0.33, 0.34]") ==
            SLIPWAY_OK &&
        slipway_sweep_run(scene, NULL, &sweep, NULL) == SLIPWAY_OK;

    told(ran && slipway_sweep_axis(sweep, 0, &n, &key) && n == 2 &&
             strcmp(key.name, "slope.alpha") == 0 &&
             strcmp(key.unit, "rad") == 0 &&
             slipway_sweep_numbers(sweep, "v_plus", v, 2) == SLIPWAY_OK &&
             v[0].value > v[1].value && fabs(v[1].value - 2832.2233588) < 1e-7,
         "a sweep of two slopes");
    told(ran &&
             slipway_sweep_numbers(sweep, "v_plus", v, 3) ==
                 SLIPWAY_BAD_ARGUMENT &&
             slipway_sweep_numbers(sweep, "v_plsu", v, 2) ==
                 SLIPWAY_BAD_ARGUMENT &&
             slipway_sweep_axis(sweep, 1, &n, &key) == NULL && n == 0 &&
             key.name == NULL,
         "a third, another name and a second key are refused");
    while (ran && (label = slipway_sweep_label(sweep, names)).name &&
           strcmp(label.name, "v_plus") != 0)
        names++;
    told(label.name && strcmp(label.scale, "V_star") == 0 &&
             strcmp(label.unit, "1") == 0,
         "its numbers have names and units");
    slipway_sweep_free(sweep);
    slipway_scene_free(scene);
}

/* ---- formulas ------------------------------------------------------------ */

/* x' = y, y' = -sin x: saddles at +-pi, separatrices y = +-2 cos(x/2). */
static void swings(void)
{
    const double pi = 3.14159265358979323846;
    slipway_plane *plane = NULL;
    slipway_rest e[4];
    slipway_manifold m[9];
    size_t checked = 0, n = 0;
    int complete = 0;
    int good =
        slipway_plane_open("x' = y; y' = -sin(x)", "{x: [-4, 4], y: [-3, 3]}",
                           &plane, NULL) == SLIPWAY_OK;

    told(good && slipway_plane_equilibria(plane, e, 4, &complete) == 3 &&
             complete && e[0].type == SLIPWAY_REST_SADDLE &&
             fabs(e[0].state[0].value + pi) <= e[0].state[0].error &&
             e[0].state[0].error < 1e-14 &&
             e[1].type == SLIPWAY_REST_NONHYPERBOLIC &&
             e[1].im[1].value > 0.99 && strcmp(e[2].name, "saddle_1") == 0 &&
             e[2].share.reason,
         "two saddles and a centre, and no others");
    good = good && slipway_plane_manifolds(plane, m, 9) == 8;
    for (size_t i = 0; i < 8 && good; i++) {
        const slipway_place *p = slipway_plane_points(plane, i, &n);
        good = n > 5;
        for (size_t k = 0; k < n && good; k++) {
            const double y = 2.0 * fabs(cos(0.5 * p[k].state[0]));
            good = fabs(fabs(p[k].state[1]) - y) <= p[k].error + 1e-15;
            checked += p[k].error < 1e-10;
        }
    }
    told(good && checked > 40,
         "separatrices y = +-2 cos(x/2) within their bars");
    told(good && strcmp(m[0].end, "saddle") == 0 && m[0].saddle == 0 &&
             m[0].to == 2 && m[0].length.value > 2.0 * pi,
         "they go from saddle to saddle");
    told(good && slipway_plane_points(plane, 8, &n) == NULL && n == 0,
         "there is no ninth");
    slipway_plane_free(plane);
}

/* A switch of two genes that are alike: u = v divides positive states. */
static void switches(void)
{
    slipway_scene *scene = NULL;
    slipway_plane *plane = NULL;
    slipway_share share[9];
    slipway_number kick[2];
    const char *low = NULL, *high = NULL;
    size_t n = 0;
    int good =
        slipway_scene_new(&scene) == SLIPWAY_OK &&
        slipway_scene_set(scene, "system.ode",
                          "\"u' = a/(1 + v^2) - u; v' = a/(1 + u^2) - v; "
                          "a = 3\"") == SLIPWAY_OK &&
        slipway_scene_set(scene, "system.state",
                          "{u: positive, v: positive}") == SLIPWAY_OK &&
        slipway_scene_set(scene, "window", "{u: [0.05, 5], v: [0.05, 5]}") ==
            SLIPWAY_OK &&
        slipway_scene_set(scene, "basins.audit", "20") == SLIPWAY_OK &&
        slipway_plane_run(scene, NULL, &plane, NULL) == SLIPWAY_OK;

    n = good ? slipway_plane_shares(plane, share, 9) : 0;
    told(good && strcmp(slipway_plane_axis(plane, 1).name, "v") == 0 &&
             slipway_plane_axis(plane, 1).is_log &&
             slipway_plane_axis(plane, 1).range[1] == 5.0,
         "its states have names and a window");
    told(n > 2 && n < 9 &&
             fabs(share[0].fraction.value - 0.5) <= share[0].fraction.error &&
             share[0].fraction.error < 1e-9 &&
             strcmp(share[n - 1].attractor, "undecided") == 0,
         "half of the window each");
    told(good &&
             slipway_plane_goal(plane, 0.5, 2.0, &low, kick) == SLIPWAY_OK &&
             fabs(kick[0].value - 4.0) <= kick[0].error &&
             fabs(kick[1].value - 0.25) <= kick[1].error &&
             slipway_plane_goal(plane, 2.1, 2.0, &high, NULL) == SLIPWAY_OK &&
             strcmp(low, "stable_node_0") == 0 &&
             strcmp(high, "stable_node_1") == 0,
         "u is to grow fourfold to switch it");
    told(good && slipway_plane_goal(plane, -1.0, 2.0, &low, kick) ==
                     SLIPWAY_BAD_ARGUMENT,
         "a negative one is refused");
    slipway_plane_free(plane);
    slipway_scene_free(scene);
}

static void wrong_planes(void)
{
    slipway_scene *scene = scene_at(0.34, "[knees]");
    slipway_plane *plane = NULL;
    slipway_study *study = NULL;
    slipway_fault why;

    told(slipway_plane_open("x' = y; y' = sine(x)", "{x: [0, 1], y: [0, 1]}",
                            &plane, &why) == SLIPWAY_BAD_SCENE &&
             plane == NULL && strstr(why.text, "sine"),
         "a wrong name is named");
    told(slipway_plane_open("x' = y; y' = x", "{x: [0, 0], y: [0, 1]}", &plane,
                            &why) == SLIPWAY_BAD_SCENE,
         "an empty window is refused");
    told(slipway_plane_run(scene, NULL, &plane, &why) == SLIPWAY_BAD_SCENE &&
             strstr(why.text, "system"),
         "friction is no system of formulas");
    slipway_scene_free(scene);
    scene = NULL;
    told(slipway_scene_new(&scene) == SLIPWAY_OK &&
             slipway_scene_set(scene, "system.ode", "\"x' = y; y' = x\"") ==
                 SLIPWAY_OK &&
             slipway_scene_set(scene, "window", "{x: [-1, 1], y: [-1, 1]}") ==
                 SLIPWAY_OK &&
             slipway_study_run(scene, NULL, &study, &why) ==
                 SLIPWAY_BAD_SCENE &&
             strstr(why.text, "slipway_plane_run"),
         "nor is a system friction");
    slipway_scene_free(scene);
}

static void batches(void)
{
    static const char *const keys[] = { "slope.alpha", "material.a" };
    static const char *const names[] = { "v_plus", "psi_at_v0" };
    static const double alpha[] = { 0.34, 0.34, 0.33 };
    static const double a[] = { 0.0349, -1.0, 0.035 };
    const double *const column[] = { alpha, a };
    double v[3], error[3];
    uint8_t why_v[3], why_psi[3];
    slipway_column out[2] = { { v, error, why_v }, { NULL, NULL, why_psi } };
    slipway_scene *scene = NULL;
    slipway_batch *batch = NULL;
    slipway_fault why = { "" };
    int good =
        slipway_scene_new(&scene) == SLIPWAY_OK &&
        slipway_scene_set(scene, "law.preset", "dieterich_gen") == SLIPWAY_OK &&
        slipway_batch_open(scene, keys, 2, names, 2, &batch, &why) ==
            SLIPWAY_OK &&
        slipway_batch_run(batch, 3, column, 2, NULL, out, &why) == SLIPWAY_OK;

    told(good, "a batch needs no slope of the scene's");
    told(good && why_v[0] == 0 && fabs(v[0] - 2832.2233588) < 1e-7 &&
             error[0] < 1e-8 && why_v[2] == 0 && v[2] != v[0],
         "its numbers are those of studies");
    told(good && why_v[1] > 0 && isnan(v[1]) && isnan(error[1]) &&
             strstr(slipway_batch_reason(batch, why_v[1]), "material.a"),
         "a value that is not allowed is a reason");
    told(good && why_psi[0] > 0 && why_psi[0] != why_v[1] &&
             slipway_batch_reason(batch, why_psi[0]) &&
             slipway_batch_reason(batch, 0) == NULL &&
             slipway_batch_reason(batch, 200) == NULL,
         "reasons are told");
    told(good &&
             slipway_batch_run(batch, 3, column, -1, NULL, out, &why) ==
                 SLIPWAY_BAD_ARGUMENT &&
             strstr(why.text, "threads"),
         "fewer threads than none are refused");
    slipway_batch_free(batch);
    batch = NULL;
    told(slipway_batch_open(scene, keys, 2, keys, 1, &batch, &why) ==
                 SLIPWAY_BAD_ARGUMENT &&
             batch == NULL && strstr(why.text, "slope.alpha"),
         "a batch refuses what is no number");
    static const char *const both[] = { "slope.alpha", "slope.alpha_deg" };
    told(slipway_batch_open(scene, both, 2, names, 1, &batch, &why) ==
                 SLIPWAY_BAD_ARGUMENT &&
             strstr(why.text, "slope.alpha_deg") &&
             strstr(why.text, "sweep") == NULL,
         "and two keys that exclude one another");
    slipway_scene_free(scene);
}

int main(void)
{
    printf("# slipway %s\n", slipway_version());
    critical_numbers();
    a_wrong_scene();
    branches();
    basins();
    pushes();
    sweeps();
    batches();
    swings();
    switches();
    wrong_planes();
    printf("1..%d\n", cases);
    return failed > 0;
}
