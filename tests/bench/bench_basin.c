/*
 * bench_basin -- a basin map of spinodal_gen at alpha = 0.34 by the
 * separatrix, cell by cell (`exact`), by GSL's rkf45 that stops in a trapping
 * quadrant, and by CVODE to the node where SUNDIALS was found; then how the
 * map's cost grows with the grid, and the whole process against one that only
 * writes the labels.  argv: the slipway program.
 */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <hdf5.h>
#include <omp.h>

#include "cvode_cell.h"
#include "plain.h"
#include "study.h"
#include "study_tolerance.h"

enum { CELLS = 1000, SAMPLE = 10000, REPEATS = 9 };

struct setting {
    struct scene scene;
    struct study study;
    struct plain plain;
};

static void die(const char *why)
{
    printf("bench_basin: %s\n", why);
    exit(1);
}

static void read_scene(struct scene *scene, size_t cells, bool exact)
{
    char grid[64];
    char law[] = "law.preset=spinodal_gen", slope[] = "slope.alpha=0.34";
    char audit[] = "basins.audit=0", how[32];
    char *const set[] = { law, slope, audit, grid, how };
    struct fault why;

    snprintf(grid, sizeof grid, "basins.cells=[%zu, %zu]", cells, cells);
    snprintf(how, sizeof how, "basins.exact=%s", exact ? "true" : "false");
    if (scene_read(scene, NULL, set, 5, &why) != STATUS_OK)
        die(why.text);
    scene->products = 1u << PRODUCT_BASINS;
}

static void make(struct setting *s, size_t cells, bool exact)
{
    struct fault why;

    read_scene(&s->scene, cells, exact);
    if (study_run(&s->study, &s->scene, NULL, &why) != STATUS_OK)
        die(why.text);
    s->plain = plain_of(&s->study.slider.block,
                        phase_plane_saddle(&s->study.slider.plane));
}

static void drop(struct setting *s)
{
    study_free(&s->study);
    scene_free(&s->scene);
}

/* ---- cell by cell -------------------------------------------------------- */

static int in_quadrant(const double z[])
{
    if (z[0] < 0.0 && z[1] > 0.0)
        return FATE_CREEP;
    return z[0] > 0.0 && z[1] < 0.0 ? FATE_SLIDING : -1;
}

static int forward(double t, const double z[], double d[], void *ctx)
{
    double f[2];
    const double large = exp(plain_field(ctx, z[0], z[1], f));

    (void) t;
    d[0] = f[0] * large;
    d[1] = f[1] * large;
    return GSL_SUCCESS;
}

/* GSL's rkf45 in time, rtol 1e-6, until a quadrant is entered. */
static int rkf45_label(struct plain *p, const double start[2])
{
    gsl_odeiv2_system sys = { forward, NULL, 2, p };
    static gsl_odeiv2_step *step;
    static gsl_odeiv2_control *control;
    static gsl_odeiv2_evolve *evolve;
    double z[2] = { start[0], start[1] }, t = 0.0, d[2];

    if (step == NULL) {
        step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rkf45, 2);
        control = gsl_odeiv2_control_y_new(1e-6, 1e-6);
        evolve = gsl_odeiv2_evolve_alloc(2);
    }
    gsl_odeiv2_step_reset(step);
    gsl_odeiv2_evolve_reset(evolve);
    forward(0.0, z, d, p);
    double h = 1e-3 / (1.0 + fabs(d[0]) + fabs(d[1]));
    for (int n = 0; n < 100000 && in_quadrant(z) < 0; n++)
        if (gsl_odeiv2_evolve_apply(evolve, control, step, &sys, &t, 1e300, &h,
                                    z) != GSL_SUCCESS)
            break;
    return in_quadrant(z);
}

struct tally {
    double seconds; /* a cell */
    size_t wrong, cells;
};

/* Every stride-th cell, by one of the methods. */
static struct tally race(struct setting *s, const int8_t *right, size_t stride,
                         int (*label)(struct plain *, const double[2]))
{
    const struct basin_map *m = &s->study.basins;
    const struct vec2 o = s->study.slider.plane.system.origin;
    struct tally t = { 0 };
    const double start = plain_now();

    for (size_t i = 0; i < m->rows * m->columns; i += stride, t.cells++) {
        const double z[2] = { m->x[i % m->columns] - o.x,
                              m->y[i / m->columns] - o.y };
        t.wrong += label(&s->plain, z) != right[i];
    }
    t.seconds = (plain_now() - start) / (double) t.cells;
    return t;
}

static double exact_time(size_t cells, int threads, size_t *wrong,
                         const int8_t *right)
{
    struct setting s;
    int8_t *label = malloc(cells * cells);

    make(&s, cells, true);
    omp_set_num_threads(threads);
    const double start = plain_now();
    if (label == NULL || basin_map_rows(&s.study.basins, 0, cells, label))
        die("out of memory");
    const double seconds = plain_now() - start;
    *wrong = 0;
    for (size_t i = 0; right && i < cells * cells; i++)
        *wrong += label[i] != right[i];
    free(label);
    drop(&s);
    return seconds / (double) (cells * cells);
}

/* ---- by the separatrix --------------------------------------------------- */

/* Steady states, branches, rows and fill. */
static double map_time(size_t cells, int8_t *label)
{
    struct scene scene;
    struct study s;
    struct fault why;
    double best = HUGE_VAL;

    read_scene(&scene, cells, false);
    for (int r = 0; r < REPEATS; r++) {
        const double start = plain_now();
        if (study_run(&s, &scene, NULL, &why) != STATUS_OK)
            die(why.text);
        for (size_t j = 0; j < cells; j += 64)
            if (basin_map_rows(&s.basins, j, j + 64 < cells ? 64 : cells - j,
                               label + (label ? j * cells : 0)))
                die("out of memory");
        best = fmin(best, plain_now() - start);
        study_free(&s);
    }
    scene_free(&scene);
    return best;
}

static double pair_time(struct setting *s)
{
    double best = HUGE_VAL;

    for (int r = 0; r < 50; r++) {
        const double start = plain_now();
        plain_branches(&s->plain, 1e-12);
        best = fmin(best, plain_now() - start);
    }
    return best;
}

/* ---- whole processes ----------------------------------------------------- */

/* Only the labels, with the axes, through HDF5. */
static void write_only(const char *path, const int8_t *label)
{
    const hsize_t size[2] = { CELLS, CELLS }, chunk[2] = { 64, CELLS };
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(2, size, NULL);
    const hid_t how = H5Pcreate(H5P_DATASET_CREATE);

    H5Pset_chunk(how, 2, chunk);
    H5Pset_deflate(how, 1);
    const hid_t set = H5Dcreate2(file, "label", H5T_STD_I8LE, space,
                                 H5P_DEFAULT, how, H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_INT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, label);
    H5Dclose(set);
    H5Pclose(how);
    H5Sclose(space);
    H5Fclose(file);
}

static double process_time(char *const argv[])
{
    const double start = plain_now();
    const pid_t child = fork();
    int status;

    if (child == 0) {
        execv(argv[0], argv);
        _exit(127);
    }
    if (waitpid(child, &status, 0) < 0 || status != 0)
        die("a program failed");
    return plain_now() - start;
}

static void race_processes(const char *self, const char *slipway)
{
    char cells[64];
    snprintf(cells, sizeof cells, "basins.cells=[%d, %d]", CELLS, CELLS);
    char *const whole[] = { strdup(slipway),
                            strdup("basin"),
                            strdup("--law"),
                            strdup("spinodal_gen"),
                            strdup("--alpha"),
                            strdup("0.34"),
                            strdup("--set"),
                            cells,
                            strdup("--set"),
                            strdup("basins.audit=0"),
                            strdup("-q"),
                            strdup("-o"),
                            strdup("bench_basin.h5"),
                            NULL };
    char *const only[] = { strdup(self), strdup("--write-only"), NULL };
    double a = HUGE_VAL, b = HUGE_VAL;

    for (int r = 0; r < 15; r++) {
        a = fmin(a, process_time(whole));
        b = fmin(b, process_time(only));
    }
    printf("cold process, %d x %d labels in a deflated file: %.2f ms; a "
           "program that only writes them %.2f ms; ratio %.2f\n",
           CELLS, CELLS, 1e3 * a, 1e3 * b, a / b);
    remove("bench_basin.h5");
    remove("bench_only.h5");
}

int main(int argc, char *argv[])
{
    int8_t *right = calloc(CELLS, CELLS);
    struct setting s;
    size_t wrong = 0;

    if (argc == 2 && strcmp(argv[1], "--write-only") == 0) {
        write_only("bench_only.h5", right);
        return 0;
    }
    make(&s, CELLS, false);
    const double pair = pair_time(&s);
    const double map = map_time(CELLS, right);
    printf("%d x %d labels: %.0f us; a plain GSL pair of branches %.0f us; "
           "ratio %.2f\n",
           CELLS, CELLS, 1e6 * map, 1e6 * pair, map / pair);
    const struct tally rkf = race(&s, right, 1, rkf45_label);
    printf("rkf45, quadrant stop: %.2f us a cell, %zu of %zu wrong\n",
           1e6 * rkf.seconds, rkf.wrong, rkf.cells);
    const double one = exact_time(CELLS, 1, &wrong, right);
    const double two = exact_time(CELLS, 2, &wrong, right);
    printf("exact: %.2f us a cell on one thread, %.2f on two (%.2f times "
           "faster), %zu wrong; rkf45 over exact per core %.2f\n",
           1e6 * one, 1e6 * two, one / two, wrong, rkf.seconds / one);
    if (cvode_is_there()) {
        const struct tally cv =
            race(&s, right, CELLS * CELLS / SAMPLE + 1, cvode_label);
        printf("CVODE to the node, %zu cells: %.0f us a cell, %zu wrong; a map "
               "%.3g s, over ours %.3g\n",
               cv.cells, 1e6 * cv.seconds, cv.wrong, cv.seconds * CELLS * CELLS,
               cv.seconds * CELLS * CELLS / map);
    }
    drop(&s);
    if (argc > 1)
        race_processes(argv[0], argv[1]);
    free(right);
    return 0;
}
