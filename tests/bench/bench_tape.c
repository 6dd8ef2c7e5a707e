/*
 * bench_tape -- the presets' fields from formulas (tape_plane.h): nanoseconds a
 * field, a gradient, a Taylor coefficient of two curves (order 22) on wide
 * registers and on narrow ones; minima of the repetitions.
 */
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "block.h"

enum { ORDER = 22, REPEATS = 40, POINTS = 400 };

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double) t.tv_sec + 1e-9 * (double) t.tv_nsec;
}

static struct jet_work work;
static jet_pair x[JET_SIZE], y[JET_SIZE], fx[JET_SIZE], fy[JET_SIZE];
static volatile double sink;

static struct vec2 point[POINTS];

static double run_fields(const struct planar *s)
{
    struct planar_field f;
    const double t = now();

    for (int i = 0; i < POINTS; i++) {
        s->field(s->ctx, point[i], &f);
        sink += f.direction.x;
    }
    return (now() - t) / POINTS;
}

static double run_gradients(const struct planar *s)
{
    struct planar_jacobian J;
    const double t = now();

    for (int i = 0; i < POINTS; i++) {
        s->jacobian(s->ctx, point[i], &J);
        sink += J.matrix.xx;
    }
    return (now() - t) / POINTS;
}

static double run_series(const struct planar *s)
{
    const double t = now();

    for (int i = 0; i < POINTS / 10; i++) {
        work.used = 0;
        work.linear = x;
        for (size_t k = 0; k < ORDER; k++)
            s->jet(s->ctx, &work, k, x, y, fx, fy);
        sink += fx[ORDER - 1][0];
    }
    return (now() - t) / (POINTS / 10) / ORDER;
}

static double (*const kinds[])(const struct planar *) = {
    run_fields, run_gradients, run_series, run_series
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static void anchored(struct block *b, const struct law *law, long double slope)
{
    const struct material m = material_bristol_board();

    block_init(b, law, &m, slope);
    block_anchor(b, 0.5L, false);
}

int main(void)
{
    static struct block b;

    for (int k = 0; k < JET_SIZE; k++)
        for (int i = 0; i < JET_LANES; i++) {
            x[k][i] = k == 0 ? 0.3 * i : k == 1;
            y[k][i] = pow(0.5, k) * cos(k + i);
        }
    for (int i = 0; i < POINTS; i++)
        point[i] = (struct vec2){ 2 * sin(1.7 * i), 2 * cos(2.9 * i) };
    printf("ns of a field, a gradient, a coefficient, a narrow one\n");
    for (int i = 0; i < 16; i++) {
        struct law law = *law_preset_at((size_t) i / 2);
        law.form = i % 2 ? FRICTION_LOG : FRICTION_ASINH;
        anchored(&b, &law, 0.35L);
        const struct planar s = block_planar(&b);
        printf("%-17s %-5s", law.preset, friction_form_names[law.form]);
        for (int kind = 0; kind < KINDS; kind++) {
            double best = HUGE_VAL;
            b.plane.wide = kind < KINDS - 1 && tape_jet_wide();
            for (int n = 0; n < REPEATS; n++)
                best = fmin(best, kinds[kind](&s));
            printf("  %6.1f", 1e9 * best);
        }
        printf("\n");
    }
    return 0;
}
