#include "patchwork.h"

#include <math.h>

#include "check.h"
#include "fate.h"
#include "fault_alloc.h"

enum { COLUMNS = 150, ROWS = 100, CELLS = COLUMNS * ROWS };

static const unsigned both = 1u << CELL_SLIP | 1u << CELL_MU_MEAN;

/* Smooth but for two lines: x = bend, where the fate changes and slip grows
 * like a logarithm, and y = kink. */
struct model {
    double bend, kink, noise;
    double tightest; /* accuracy asked for */
    size_t calls;
    enum status fails;
};

static struct cell truth(const struct model *m, struct vec2 z)
{
    const double away = z.x - m->bend;
    const double slip = exp(sin(z.x) + 2.0 * z.y) * (5.0 - log(fabs(away))) +
                        fmax(0.0, z.y - m->kink);

    return (struct cell){ .exit_reason = away > 0 ? FATE_SLIDING : FATE_CREEP,
                          .slip = slip,
                          .time = NAN,
                          .time_error = NAN,
                          .mu_mean = 0.4 + 0.1 * tanh(z.x * z.y) };
}

static enum status find(void *ctx, const struct vec2 z[], size_t n, double rtol,
                        unsigned which, struct cell out[])
{
    struct model *m = ctx;

    assert_true(which == both);
    m->tightest = fmin(m->tightest, rtol);
    m->calls++;
    for (size_t i = 0; i < n; i++) {
        out[i] = truth(m, z[i]);
        out[i].slip *= 1.0 + (i % 2 ? 1.0 : -1.0) * m->noise * rtol;
        out[i].slip_error = 1.1 * m->noise * rtol * out[i].slip;
        out[i].mu_mean_error = 1e-15;
    }
    return m->fails;
}

struct grid {
    double x[COLUMNS], y[ROWS];
    int8_t label[CELLS];
    struct patchwork_grid g;
};

static void make_grid(struct grid *g, const struct model *m)
{
    for (int i = 0; i < COLUMNS; i++)
        g->x[i] = -3.0 + 6.0 * (i + 0.5) / COLUMNS;
    for (int j = 0; j < ROWS; j++)
        g->y[j] = -2.0 + 4.0 * (j + 0.5) / ROWS;
    for (int k = 0; k < CELLS; k++)
        g->label[k] =
            truth(m, (struct vec2){ g->x[k % COLUMNS], g->y[k / COLUMNS] })
                .exit_reason;
    g->g = (struct patchwork_grid){ g->x, g->y, g->label, COLUMNS, ROWS };
}

static void every_cell_is_within_its_bar(void **state)
{
    static struct grid g;
    static struct cell out[CELLS];
    uint64_t rng = check_seed();

    (void) state;
    for (int round = 0; round < 20; round++) {
        struct model m = { check_uniform(&rng, -2, 2),
                           check_uniform(&rng, -1, 1),
                           0.5,
                           1.0,
                           0,
                           0 };
        const double rtol = pow(10.0, check_uniform(&rng, -9, -3));
        make_grid(&g, &m);
        assert_int_equal(patchwork_fill(&g.g,
                                        &(struct patchwork_source){ find, &m },
                                        rtol, both, out, NULL),
                         STATUS_OK);
        for (int k = 0; k < CELLS; k++) {
            const struct cell t =
                truth(&m, (struct vec2){ g.x[k % COLUMNS], g.y[k / COLUMNS] });
            CHECK(out[k].exit_reason == t.exit_reason, "cell %d", k);
            CHECK(fabs(out[k].slip - t.slip) <= out[k].slip_error &&
                      out[k].slip_error <= rtol * t.slip,
                  "rtol %g, cell %d: slip %g off by %g, bar %g", rtol, k,
                  t.slip, out[k].slip - t.slip, out[k].slip_error);
            CHECK(fabs(out[k].mu_mean - t.mu_mean) <= out[k].mu_mean_error &&
                      out[k].mu_mean_error <= rtol * t.mu_mean,
                  "rtol %g, cell %d: mu %g off by %g, bar %g", rtol, k,
                  t.mu_mean, out[k].mu_mean - t.mu_mean, out[k].mu_mean_error);
            CHECK(isnan(out[k].time) && isnan(out[k].time_error), "cell %d", k);
        }
    }
}

static void what_does_not_exist_is_not_interpolated(void **state)
{
    static struct grid g;
    static struct cell out[CELLS];
    struct model m = { NAN, 5.0, 0.0, 1.0, 0, 0 }; /* slip is NaN everywhere */
    size_t sampled;

    (void) state;
    make_grid(&g, &m);
    assert_int_equal(patchwork_fill(&g.g,
                                    &(struct patchwork_source){ find, &m },
                                    1e-4, both, out, &sampled),
                     STATUS_OK);
    for (int k = 0; k < CELLS; k++)
        CHECK(isnan(out[k].slip) && isnan(out[k].slip_error) &&
                  out[k].mu_mean > 0.0,
              "cell %d: %g", k, out[k].slip);
    CHECK(sampled < CELLS / 3, "%zu states", sampled);
}

static void a_label_that_disagrees_is_looked_at_cell_by_cell(void **state)
{
    static struct grid g;
    static struct cell out[CELLS];
    struct model m = { 10.0, 5.0, 0.0, 1.0, 0, 0 };
    size_t sampled, all;
    const struct patchwork_source source = { find, &m };

    (void) state;
    make_grid(&g, &m);
    assert_int_equal(patchwork_fill(&g.g, &source, 1e-3, both, out, &all), 0);
    CHECK(all < CELLS / 3, "%zu states of a smooth field", all);
    g.label[5000] = FATE_RUNAWAY;
    assert_int_equal(patchwork_fill(&g.g, &source, 1e-3, both, out, &sampled),
                     0);
    assert_int_equal(out[5000].exit_reason, FATE_CREEP);
    CHECK(sampled > all + 60, "%zu, %zu", sampled, all);
    for (int k = 0; k < CELLS; k++)
        g.label[k] = FATE_SLIDING;
    assert_int_equal(patchwork_fill(&g.g, &source, 1e-3, both, out, &sampled),
                     0);
    CHECK(sampled > CELLS, "%zu", sampled);
}

static void a_failure_is_passed_on(void **state)
{
    static struct grid g;
    static struct cell out[CELLS];
    struct model m = { 0.0, 5.0, 0.0, 1.0, 0, STATUS_STOPPED };
    const struct patchwork_source source = { find, &m };

    (void) state;
    make_grid(&g, &m);
    assert_int_equal(patchwork_fill(&g.g, &source, 1e-3, both, out, NULL),
                     STATUS_STOPPED);
    m.fails = STATUS_OK;
    enum status s = STATUS_NO_MEMORY;
    long k = 0;
    for (; s != STATUS_OK; k++) {
        fault_alloc_at(k);
        s = patchwork_fill(&g.g, &source, 1e-3, both, out, NULL);
        assert_true(s == STATUS_OK || s == STATUS_NO_MEMORY);
    }
    fault_alloc_at(FAULT_ALLOC_NEVER);
    CHECK(k > 5, "%ld allocations", k);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_cell_is_within_its_bar),
        cmocka_unit_test(what_does_not_exist_is_not_interpolated),
        cmocka_unit_test(a_label_that_disagrees_is_looked_at_cell_by_cell),
        cmocka_unit_test(a_failure_is_passed_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
