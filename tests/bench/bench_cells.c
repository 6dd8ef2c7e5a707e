/*
 * bench_cells -- slip and time to arrest, processor time a cell, in one run: by
 * the slow curve one state after the other and in 2, 4 and 8 lanes; by
 * whole orbits with bars (cells_find); and by CVODE's BDF where SUNDIALS was
 * found, at the tolerance at which nine of ten states are as good as ours (">":
 * it never is, and its finest is taken); then whole grids.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <omp.h>

#include "cell_grid.h"
#include "cvode_cell.h"
#include "fast_cells.h"
#include "fast_layer.h"
#include "plain.h"
#include "study.h"

enum { CELLS = 1000, FEW = 20, REPEATS = 2 };

static const unsigned which = 1u << CELL_SLIP | 1u << CELL_TIME;

struct sample {
    struct scene scene;
    struct study study;
    struct fast_cells fast;
    struct vec2 z[CELLS];
    struct cell cell[CELLS], exact[CELLS];
    double error[CELLS];
    enum fate fate;
};

static void die(const char *why)
{
    printf("bench_cells: %s\n", why);
    exit(1);
}

static void find(struct sample *s, double rtol, struct cell out[],
                 size_t *whole)
{
    if (fast_cells_find(&s->fast, s->z, CELLS, rtol, which, NULL, out, whole) !=
        STATUS_OK)
        die("the fast way failed");
}

/* Points of a lattice that repeats nothing, of one fate. */
static void choose_states(struct sample *s, const double box[4])
{
    struct cell c;
    int n = 0;

    for (int i = 0; n < CELLS && i < 40 * CELLS; i++) {
        const struct vec2 z = {
            box[0] + box[1] * fmod(i * 0.6180339887498949, 1.0),
            box[2] + box[3] * fmod(i * 0.7548776662466927, 1.0)
        };
        if (fast_cells_find(&s->fast, &z, 1, 1e-3, 0, NULL, &c, NULL) ==
                STATUS_OK &&
            c.exit_reason == (int8_t) s->fate)
            s->z[n++] = z;
    }
    if (n < CELLS)
        die("too few states");
}

static void make(struct sample *s, const char *law, enum fate fate,
                 const double box[4])
{
    char preset[64], slope[] = "slope.alpha=0.34";
    char *const set[] = { preset, slope };
    struct fault why;

    snprintf(preset, sizeof preset, "law.preset=%s", law);
    if (scene_read(&s->scene, NULL, set, 2, &why) != STATUS_OK)
        die(why.text);
    s->scene.products = 1u << PRODUCT_EQUILIBRIA;
    if (study_run(&s->study, &s->scene, NULL, &why) != STATUS_OK)
        die(why.text);
    const double start = plain_worked();
    if (fast_cells_init(&s->fast, &s->study.slider, NULL) != STATUS_OK)
        die("no slow curve");
    printf("\n%s, alpha 0.34, %s: the slow curve once in %.1f ms\n", law,
           fate_names[fate], 1e3 * (plain_worked() - start));
    s->fate = fate;
    choose_states(s, box);
    find(s, 1e-10, s->exact, NULL);
}

static void drop(struct sample *s)
{
    fast_cells_free(&s->fast);
    study_free(&s->study);
    scene_free(&s->scene);
}

/* ---- errors -------------------------------------------------------------- */

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *) a, y = *(const double *) b;
    return (x > y) - (x < y);
}

/* Nine of ten are below; *worst. */
static double ninth_tenth(double error[], size_t n, double *worst)
{
    qsort(error, n, sizeof *error, by_size);
    *worst = error[n - 1];
    return error[n * 9 / 10];
}

static double miss(const struct cell *exact, double slip, double time)
{
    return fmax(fabs(slip / exact->slip - 1.0), fabs(time / exact->time - 1.0));
}

/* ---- CVODE --------------------------------------------------------------- */

enum { TOLS = 8 };
struct rival {
    double error[TOLS], seconds[TOLS];
};

static struct cvode_end end_of(const struct sample *s)
{
    const struct slider *t = &s->study.slider;
    struct cvode_end end = { .rests = s->fate == FATE_REST_FINITE };

    for (size_t i = 0; i < t->plane.equilibria; i++) {
        const struct vec2 z =
            vec2_sub(t->plane.equilibrium[i].z, t->plane.system.origin);
        if ((int) i != slider_saddle(t) &&
            fate_of_node(t, &t->plane.equilibrium[i]) == s->fate) {
            end.x = z.x;
            end.y = z.y;
        }
    }
    return end;
}

static void run_rival(struct sample *s, struct rival *r)
{
    struct plain p = plain_of(&s->study.slider.block,
                              phase_plane_saddle(&s->study.slider.plane));
    const struct cvode_end end = end_of(s);
    double worst, slip, time;

    for (int k = 0; k < TOLS; k++) {
        const double tol = 1e-5 * pow(10.0, -k);
        double error[FEW];
        const double start = plain_worked();
        for (int i = 0; i < FEW; i++) {
            const size_t at = (size_t) i * (CELLS / FEW);
            const struct vec2 z =
                vec2_sub(s->z[at], s->study.slider.plane.system.origin);
            const double from[2] = { z.x, z.y };
            error[i] = cvode_cell(&p, from, &end, tol, s->fast.curve.slip_least,
                                  &slip, &time)
                           ? miss(&s->exact[at], slip, time)
                           : HUGE_VAL;
        }
        r->seconds[k] = (plain_worked() - start) / FEW;
        r->error[k] = ninth_tenth(error, FEW, &worst);
    }
}

/* Seconds a cell at that error, between the two tolerances beside it; *beyond:
 * the finest is not that good. */
static double rival_at(const struct rival *r, double error, bool *beyond)
{
    *beyond = false;
    for (int k = 1; k < TOLS; k++)
        if (r->error[k] < error && r->error[k - 1] >= error) {
            const double part = log(error / r->error[k - 1]) /
                                log(r->error[k] / r->error[k - 1]);
            return r->seconds[k - 1] *
                   pow(r->seconds[k] / r->seconds[k - 1], part);
        }
    *beyond = !(error > r->error[0]);
    return r->seconds[*beyond ? TOLS - 1 : 0];
}

/* ---- ours ---------------------------------------------------------------- */

/* The best of a few, a cell: of `now`. */
static double seconds(struct sample *s, double rtol, int lanes, int threads,
                      double (*now)(void), size_t *whole)
{
    double best = HUGE_VAL;

    s->fast.lanes = lanes;
    omp_set_num_threads(threads);
    for (int i = 0; i < REPEATS; i++) {
        const double start = now();
        find(s, rtol, s->cell, whole);
        best = fmin(best, now() - start);
    }
    omp_set_num_threads(1);
    return best / CELLS;
}

static double whole_seconds(struct sample *s, double rtol)
{
    struct cell c;
    const double start = plain_worked();

    for (int i = 0; i < FEW; i++)
        if (cells_find(&s->study.slider, &s->z[i * (CELLS / FEW)], 1, rtol,
                       which, NULL, &c) != STATUS_OK)
            die("a whole orbit failed");
    return (plain_worked() - start) / FEW;
}

static void compare(struct sample *s, double rtol, const struct rival *r)
{
    static const int lanes[] = { 1, 2, 4, 8 };
    const int widest = layer_width(8);
    size_t whole = 0;
    double worst, us = 0.0;

    printf("%-6.0e", rtol);
    for (int k = 0; k < 4; k++) {
        if (lanes[k] > widest)
            continue;
        us = 1e6 * seconds(s, rtol, lanes[k], 1, plain_worked, &whole);
        printf(" %7.2f", us);
    }
    const double one = seconds(s, rtol, widest, 1, plain_now, &whole);
    const double two = seconds(s, rtol, widest, 2, plain_now, &whole);
    for (int i = 0; i < CELLS; i++)
        s->error[i] = miss(&s->exact[i], s->cell[i].slip, s->cell[i].time);
    const double error = ninth_tenth(s->error, CELLS, &worst);
    bool beyond;
    const double rival = 1e6 * rival_at(r, fmax(error, 1e-15), &beyond);
    const double orbit = 1e6 * whole_seconds(s, rtol);
    printf(" %5.2f %6zu %8.1e %8.1e %8.0f %7.0f %s%7.0f %7.0f\n", one / two,
           whole, error, worst, orbit, orbit / us, beyond ? ">" : " ", rival,
           rival / us);
}

int main(void)
{
    static const struct {
        const char *law;
        enum fate fate;
        double box[4];
    } at[] = {
        { "spinodal_gen", FATE_CREEP, { -6.0, 15.0, -6.0, 12.0 } },
        { "spinodal_gen", FATE_SLIDING, { -6.0, 15.0, -6.0, 12.0 } },
        { "dieterich_gen", FATE_REST_FINITE, { -2.0, 4.0, -1.0, 3.0 } },
    };
    static struct sample s;

    setvbuf(stdout, NULL, _IOLBF, 0);
    omp_set_num_threads(1);
    for (int i = 0; i < 3; i++) {
        struct rival r = { { 0.0 }, { 0.0 } };
        make(&s, at[i].law, at[i].fate, at[i].box);
        if (cvode_is_there())
            run_rival(&s, &r);
        for (int k = 0; k < TOLS && cvode_is_there(); k++)
            printf("CVODE at 1e-%d: %.0f us, 90 %% within %.1e\n", k + 5,
                   1e6 * r.seconds[k], r.error[k]);
        printf("us of the processor a cell of %d: one by one, 2 lanes, 4 and 8 "
               "where there are; gain by the clock of 2 threads\n"
               "rtol\t1 by 1 ... lanes ... gain whole  90%%err   worst  orbit "
               "us  ratio  CVODE us  ratio\n",
               CELLS);
        compare(&s, 1e-4, &r);
        compare(&s, 1e-6, &r);
        compare(&s, 1e-9, &r);
        drop(&s);
    }
    printf("\ngrids, labels included, one thread\n");
    for (int i = 0; i < 4; i++)
        cell_grid_report(i % 2 ? "dieterich_gen" : "spinodal_gen",
                         i < 2 ? 300 : 1000, 1e-6);
    return 0;
}
