/* Friction and a pendulum through the installed headers alone: as C and, the
 * same file, as C++.  Prints TAP; its numbers have closed forms or are held to
 * the shared table. */
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
    size_t names = 0;

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
    while (slipway_study_name(study, names))
        names++;
    told(names > 20, "numbers have names");
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
    const size_t n =
        ran ? slipway_study_branch(study, SLIPWAY_STABLE_UPPER, NULL, 0) : 0;
    slipway_point *p = (slipway_point *) calloc(n + 1, sizeof *p);
    int rises = n > 10;

    if (ran)
        slipway_study_branch(study, SLIPWAY_STABLE_UPPER, p, n);
    for (size_t i = 1; i < n; i++)
        rises = rises && p[i].v >= (1.0 - 1e-14) * p[i - 1].v &&
                p[i].psi > p[i - 1].psi;
    told(rises, "the separatrix rises from the saddle");
    free(p);
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
    slipway_number v;
    size_t n = 0;
    const int ran =
        slipway_scene_set(scene, "sweep.key", "slope.alpha") == SLIPWAY_OK &&
        slipway_scene_set(scene, "sweep.values", "[0.33, 0.34]") ==
            SLIPWAY_OK &&
        slipway_sweep_run(scene, NULL, &sweep, NULL) == SLIPWAY_OK;

    told(ran && slipway_sweep_axis(sweep, 0, &n) && n == 2 &&
             slipway_sweep_number(sweep, "v_plus", 1, 0, &v) == SLIPWAY_OK &&
             fabs(v.value - 2832.2233588) < 1e-7,
         "a sweep of two slopes");
    told(ran && slipway_sweep_number(sweep, "v_plus", 2, 0, &v) ==
                    SLIPWAY_BAD_ARGUMENT,
         "a third is refused");
    slipway_sweep_free(sweep);
    slipway_scene_free(scene);
}

/* ---- a pendulum ---------------------------------------------------------- */

/* x' = y, y' = -sin x: saddles at +-pi, separatrices y = +-2 cos(x/2). */
static void pendulum(void *ctx, slipway_form *f, slipway_term x, slipway_term y,
                     slipway_term rate[2])
{
    (void) ctx;
    rate[0] = y;
    rate[1] = slipway_neg(f, slipway_sin(f, x));
}

static void swings(void)
{
    const double pi = 3.14159265358979323846;
    const slipway_window w = { { -4.0, -3.0 }, { 4.0, 3.0 } };
    slipway_plane *plane = NULL;
    slipway_rest e[4];
    static slipway_place p[4000];
    size_t n = 0, inside = 0;
    int good =
        slipway_plane_open(pendulum, NULL, &w, &plane, NULL) == SLIPWAY_OK;

    told(good && slipway_plane_equilibria(plane, e, 4) == 3 &&
             fabs(e[0].x + pi) <= e[0].error && e[0].error < 1e-14 &&
             e[1].im > 0.99 && e[2].re[0] < 0.0 && e[2].re[1] > 0.0,
         "two saddles and a centre");
    for (int kind = 0; kind < 2 && good; kind++) {
        good = slipway_plane_branch(plane, 0, (slipway_kind) kind, +1, 1e-12, p,
                                    4000, &n) == SLIPWAY_OK &&
               n > 30 && n < 4000;
        for (size_t i = 0; i < n && good; i++) {
            const double y = (kind ? 2.0 : -2.0) * cos(0.5 * p[i].x);
            good = p[i].x > pi - 1e-6 || fabs(p[i].y - y) <= p[i].error;
            inside += p[i].x > 0.0 && p[i].error < 1e-10;
        }
    }
    told(good && inside > 20,
         "separatrices y = +-2 cos(x/2) within their bars");
    told(slipway_plane_branch(plane, 1, SLIPWAY_STABLE, 1, 1e-9, p, 10, &n) ==
             SLIPWAY_NUMERICAL,
         "a centre has none");
    slipway_plane_free(plane);
}

/* A saddle whose stable line y = -2 x leaves more up than aside. */
static void steep(void *ctx, slipway_form *f, slipway_term x, slipway_term y,
                  slipway_term rate[2])
{
    const slipway_term third = slipway_constant(f, 1.0 / 3.0);
    const slipway_term two = slipway_constant(f, 2.0);
    const slipway_term four = slipway_constant(f, 4.0);

    (void) ctx;
    rate[0] = slipway_mul(f, third, slipway_add(f, x, slipway_mul(f, two, y)));
    rate[1] = slipway_mul(f, third, slipway_sub(f, slipway_mul(f, four, x), y));
}

static void sides(void)
{
    const slipway_window w = { { -1.0, -1.0 }, { 1.0, 1.0 } };
    slipway_plane *plane = NULL;
    slipway_place p[200];
    size_t n = 0;
    int good = slipway_plane_open(steep, NULL, &w, &plane, NULL) == SLIPWAY_OK;

    for (int side = -1; side <= 1 && good; side += 2) {
        good = slipway_plane_branch(plane, 0, SLIPWAY_STABLE, side, 1e-9, p,
                                    200, &n) == SLIPWAY_OK &&
               n > 2;
        for (size_t i = 1; i < n && i < 200 && good; i++)
            good = side * p[i].x > 0.0 && fabs(p[i].y + 2.0 * p[i].x) < 1e-8;
    }
    told(good, "side +1 is that of growing x, however steep");
    slipway_plane_free(plane);
}

static void nothing(void *ctx, slipway_form *f, slipway_term x, slipway_term y,
                    slipway_term rate[2])
{
    (void) ctx, (void) f, (void) x, (void) y;
    rate[0] = 99;
    rate[1] = 0;
}

static void wrong_planes(void)
{
    const slipway_window w = { { 0.0, 0.0 }, { 1.0, 1.0 } };
    const slipway_window empty = { { 0.0, 0.0 }, { 0.0, 1.0 } };
    slipway_plane *plane = NULL;
    slipway_fault why;

    told(slipway_plane_open(nothing, NULL, &w, &plane, &why) ==
                 SLIPWAY_BAD_ARGUMENT &&
             plane == NULL,
         "a rate that is no term is refused");
    told(slipway_plane_open(pendulum, NULL, &empty, &plane, &why) ==
             SLIPWAY_BAD_ARGUMENT,
         "an empty window is refused");
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
    swings();
    sides();
    wrong_planes();
    printf("1..%d\n", cases);
    return failed > 0;
}
