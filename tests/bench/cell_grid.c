#include "cell_grid.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "plain.h"
#include "study.h"

enum { TESTS = 500 };

static const unsigned which = 1u << CELL_SLIP | 1u << CELL_TIME;

static void make(struct study *s, struct scene *scene, const char *law,
                 size_t side, double rtol)
{
    char preset[64], grid[64], accuracy[64], alpha[] = "slope.alpha=0.34";
    char audit[] = "basins.audit=0";
    char *const set[] = { preset, alpha, audit, grid, accuracy };
    struct fault why;

    snprintf(preset, sizeof preset, "law.preset=%s", law);
    snprintf(grid, sizeof grid, "basins.cells=[%zu, %zu]", side, side);
    snprintf(accuracy, sizeof accuracy, "basins.rtol=%g", rtol);
    if (scene_read(scene, NULL, set, 5, &why) != STATUS_OK) {
        printf("%s\n", why.text);
        exit(1);
    }
    scene->products =
        1u << PRODUCT_BASINS | 1u << PRODUCT_SLIP | 1u << PRODUCT_TIME;
    if (study_run(s, scene, NULL, &why) != STATUS_OK) {
        printf("%s\n", why.text);
        exit(1);
    }
}

/* The largest errors of slip and time, relative, and over their bars. */
static void test(const struct study *s, size_t side, const struct cell cell[],
                 double *worst, double *over)
{
    uint64_t at = 1;

    *worst = *over = 0.0;
    for (int i = 0; i < TESTS; i++) {
        at = at * 6364136223846793005u + 1442695040888963407u;
        const size_t k = (size_t) (at >> 33) % (side * side);
        const struct vec2 z = { s->basins.x[k % side], s->basins.y[k / side] };
        const struct cell *const c = &cell[k];
        struct cell e;
        if (cells_find(&s->slider, &z, 1, 1e-8, which, NULL, &e) != STATUS_OK ||
            e.exit_reason != c->exit_reason || !isfinite(e.slip + e.time))
            continue;
        const double slip = fabs(c->slip - e.slip);
        const double time = fabs(c->time - e.time);
        *worst = fmax(*worst, fmax(slip / e.slip, time / e.time));
        *over = fmax(*over, fmax(slip / (c->slip_error + e.slip_error),
                                 time / (c->time_error + e.time_error)));
    }
}

/* The plan once more, which the study made already, then every row. */
static double fill(struct study *s, size_t side, struct cell cell[],
                   int8_t label[], size_t *sampled)
{
    struct fault why;
    const double start = plain_worked();

    fields_free(&s->fields);
    if (fields_prepare(&s->fields, &s->basins, NULL, &why) != STATUS_OK ||
        basin_map_rows(&s->basins, 0, side, label) != STATUS_OK ||
        patchwork_rows(&s->fields.patches, 0, side, label, cell, sampled) !=
            STATUS_OK) {
        printf("the grid failed\n");
        exit(1);
    }
    *sampled += s->fields.patches.sampled;
    return plain_worked() - start;
}

void cell_grid_report(const char *law, size_t side, double rtol)
{
    static struct scene scene;
    static struct study s;
    struct cell *cell = malloc(side * side * sizeof *cell);
    int8_t *label = malloc(side * side);
    double worst, over;
    size_t sampled = 0;

    make(&s, &scene, law, side, rtol);
    if (cell == NULL || label == NULL)
        exit(1);
    const double seconds = fill(&s, side, cell, label, &sampled);
    test(&s, side, cell, &worst, &over);
    const double n = (double) (side * side);
    printf("%-14s %4zu x %-4zu %5.0e: %6.3f us a cell, %zu patches, %.2f %% "
           "sampled; worst of %d: %.1e, %.2f of its bar\n",
           law, side, side, rtol, 1e6 * seconds / n, s.fields.patches.count,
           100.0 * (double) sampled / n, TESTS, worst, over);
    study_free(&s);
    scene_free(&scene);
    free(label);
    free(cell);
}
