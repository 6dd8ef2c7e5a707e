/*
 * bench_cells -- slip and time of states of spinodal_gen at alpha = 0.34, a
 * cell: by the slow curve, by whole orbits with error bars, by one whole orbit,
 * and (the fate alone, to the node) by CVODE's BDF where SUNDIALS was found.
 * One thread; ratios of one run.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <omp.h>

#include "cvode_cell.h"
#include "fast_cells.h"
#include "plain.h"
#include "study.h"

enum { CELLS = 2000, FEW = 40 };

struct sample {
    struct scene scene;
    struct study study;
    struct vec2 z[CELLS];
    struct cell cell[CELLS];
};

static void die(const char *why)
{
    printf("bench_cells: %s\n", why);
    exit(1);
}

static void make(struct sample *s)
{
    char law[] = "law.preset=spinodal_gen", slope[] = "slope.alpha=0.34";
    char *const set[] = { law, slope };
    struct fault why;

    if (scene_read(&s->scene, NULL, set, 2, &why) != STATUS_OK)
        die(why.text);
    s->scene.products = 1u << PRODUCT_EQUILIBRIA;
    if (study_run(&s->study, &s->scene, NULL, &why) != STATUS_OK)
        die(why.text);
    for (int i = 0; i < CELLS; i++) /* a lattice that repeats nothing */
        s->z[i] = (struct vec2){ -6.0 + 15.0 * fmod(i * 0.6180339887, 1.0),
                                 -6.0 + 12.0 * (i + 0.5) / CELLS };
}

static double fast_time(struct sample *s, double rtol, size_t *whole)
{
    const unsigned which = 1u << CELL_SLIP | 1u << CELL_TIME;
    struct fast_cells f;
    const double start = plain_now();

    if (fast_cells_init(&f, &s->study, NULL) != STATUS_OK ||
        fast_cells_find(&f, s->z, CELLS, rtol, which, NULL, s->cell, whole))
        die("the fast way failed");
    fast_cells_free(&f);
    return (plain_now() - start) / CELLS;
}

static double slow_time(struct sample *s, double rtol)
{
    const unsigned which = 1u << CELL_SLIP | 1u << CELL_TIME;
    struct cell c[FEW];
    const double start = plain_now();

    for (int i = 0; i < FEW; i++)
        if (cells_find(&s->study, &s->z[i * (CELLS / FEW)], 1, rtol, which,
                       NULL, &c[i]) != STATUS_OK)
            die("a whole orbit failed");
    return (plain_now() - start) / FEW;
}

static double orbit_time(struct sample *s, double rtol)
{
    struct fate_result r;
    const double start = plain_now();

    for (int i = 0; i < FEW; i++)
        if (fate_find(&s->study, s->z[i * (CELLS / FEW)], rtol, true, NULL,
                      &r) != STATUS_OK)
            die("an orbit failed");
    return (plain_now() - start) / FEW;
}

static double cvode_time(struct sample *s)
{
    struct plain p =
        plain_of(&s->study.block, &s->study.equilibrium[s->study.saddle]);
    const struct vec2 o = s->study.system.origin;
    const double start = plain_now();

    for (int i = 0; i < FEW; i++) {
        const struct vec2 z = vec2_sub(s->z[i * (CELLS / FEW)], o);
        const double at[2] = { z.x, z.y };
        (void) cvode_label(&p, at);
    }
    return (plain_now() - start) / FEW;
}

int main(void)
{
    static struct sample s;
    size_t whole;

    omp_set_num_threads(1);
    make(&s);
    const double rival = cvode_is_there() ? cvode_time(&s) : (double) NAN;
    printf("rtol     fast us  (whole)  bars us   one orbit us  CVODE us  "
           "bars/fast  orbit/fast  CVODE/fast\n");
    for (int k = 0; k < 3; k++) {
        const double rtol = k == 0 ? 1e-4 : k == 1 ? 1e-6 : 1e-9;
        const double fast = fast_time(&s, rtol, &whole);
        const double slow = slow_time(&s, rtol);
        const double orbit = orbit_time(&s, 0.1 * rtol);
        printf("%-7.0e %8.1f %8zu %9.0f %14.0f %9.0f %10.1f %11.1f %11.1f\n",
               rtol, 1e6 * fast, whole, 1e6 * slow, 1e6 * orbit, 1e6 * rival,
               slow / fast, orbit / fast, rival / fast);
    }
    study_free(&s.study);
    scene_free(&s.scene);
    return 0;
}
