/* A grid of cells from few of them. */
#include "patchwork.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "check.h"
#include "fate.h"
#include "fault_alloc.h"

enum { COLUMNS = 300, ROWS = 200, CELLS = COLUMNS * ROWS };

static const unsigned both = 1u << CELL_SLIP | 1u << CELL_MU_MEAN;

/* Slip and mean friction of states whose base point is smooth: y = 0 is a
 * separatrix, where slip grows like a logarithm, and base points between 1.9
 * and 2.1 pass a box, where it is small.  Beyond the line y = kink there are no
 * base points. */
struct model {
    double bend, kink, noise;
    bool has_no_friction;
    enum status fails;
    /* what was asked of it */
    double *tightest;
    size_t *calls;
};

static double base_of(const struct model *m, struct vec2 z)
{
    return z.x - m->bend + 0.4 * sin(z.y + 0.3 * z.x);
}

static double more_of(struct vec2 z)
{
    return exp(0.5 * sin(z.x) + 0.3 * z.y);
}

static bool passes(const void *ctx, double one, double other)
{
    (void) ctx;
    return fmax(one, other) > 1.9 && fmin(one, other) < 2.1;
}

static struct cell cell_of(double y, double more)
{
    const double slip = 5.0 - log(fabs(y)) + more;

    return (struct cell){ .exit_reason = y > 0.0 ? FATE_SLIDING : FATE_CREEP,
                          .slip = slip,
                          .time = NAN,
                          .time_error = NAN,
                          .mu_mean = 0.4 + 0.1 / slip,
                          .v_peak = NAN,
                          .v_peak_error = NAN,
                          .mu_peak = NAN,
                          .mu_peak_error = NAN };
}

static struct cell truth(const struct model *m, struct vec2 z)
{
    const double y = base_of(m, z);
    struct cell c = cell_of(y, more_of(z) + fmax(0.0, z.y - m->kink));

    if (passes(NULL, y, y) && z.y <= m->kink) {
        c.slip = 0.01 + 0.001 * z.x * z.x;
        c.mu_mean = 0.4;
    }
    if (m->has_no_friction)
        c.mu_mean = (double) NAN;
    return c;
}

/* -1 or 1, the same for a state whenever it is looked at. */
static double sign_of(struct vec2 z)
{
    return sin(1e6 * (z.x + 3.0 * z.y)) > 0.0 ? 1.0 : -1.0;
}

static enum status find(const void *ctx, const struct vec2 z[], size_t n,
                        double rtol, unsigned which, struct cell out[])
{
    const struct model *m = ctx;

    assert_true(which == both);
    *m->tightest = fmin(*m->tightest, rtol);
    ++*m->calls;
    for (size_t i = 0; i < n; i++) {
        out[i] = truth(m, z[i]);
        out[i].slip *= 1.0 + sign_of(z[i]) * m->noise * rtol;
        out[i].slip_error = 1.1 * m->noise * rtol * out[i].slip;
        out[i].mu_mean_error = 1e-15;
    }
    return m->fails;
}

static enum status sample(const void *ctx, struct patch_sample s[], size_t n,
                          double rtol, unsigned which)
{
    const struct model *m = ctx;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < n && status == STATUS_OK; i++) {
        const double y = base_of(m, s[i].z), no = (double) NAN;
        const double shake = 0.5 * sign_of(s[i].z) * m->noise * rtol;
        status = find(ctx, &s[i].z, 1, rtol, which, &s[i].cell);
        s[i].base = (struct base_point){ y + shake, m->noise * rtol,
                                         more_of(s[i].z) - shake,
                                         m->noise * rtol, 1.0 };
        const struct cell t = truth(m, s[i].z);
        s[i].left = 1.0 - 10.0 * (t.mu_mean - 0.4) * t.slip;
        s[i].left_error = 1e-14;
        if (s[i].z.y > m->kink || m->has_no_friction)
            s[i].base = (struct base_point){ no, no, no, no, 1.0 };
        if (passes(NULL, s[i].base.y, s[i].base.y))
            s[i].cell.slip = s[i].cell.mu_mean = no;
    }
    return status;
}

static bool tell(const void *ctx, struct vec2 z, const struct base_point *b,
                 unsigned which, struct cell *out)
{
    (void) ctx, (void) z, (void) which;
    *out = cell_of(b->y, b->more);
    out->slip_error = 1.1 * b->y_error / fabs(b->y) + b->more_error;
    out->mu_mean_error =
        1.1 * 0.1 * out->slip_error / (out->slip * out->slip) + 1e-15;
    return 10.0 * b->y_error < fabs(b->y) &&
           !passes(NULL, b->y - 10.0 * b->y_error, b->y + 10.0 * b->y_error);
}

/* What arrests at no speed has 0.1 of work to lose. */
static void friction(const void *ctx, struct vec2 z, double left,
                     double left_error, struct cell *c)
{
    (void) ctx, (void) z;
    c->mu_mean = 0.4 + 0.1 * (1.0 - left) / c->slip;
    c->mu_mean_error =
        0.1 * (c->slip_error / c->slip + left_error) / c->slip + 1e-15;
}

struct grid {
    double x[COLUMNS], y[ROWS], tightest;
    int8_t label[CELLS];
    size_t calls;
    struct patchwork_span span[ROWS];
    struct patchwork_grid g;
    struct patchwork_source source;
};

static void make_grid(struct grid *g, struct model *m)
{
    m->tightest = &g->tightest;
    m->calls = &g->calls;
    g->tightest = 1.0;
    g->calls = 0;
    for (int i = 0; i < COLUMNS; i++)
        g->x[i] = -3.0 + 6.0 * (i + 0.5) / COLUMNS;
    for (int j = 0; j < ROWS; j++)
        g->y[j] = -2.0 + 4.0 * (j + 0.5) / ROWS;
    for (int k = 0; k < CELLS; k++)
        g->label[k] =
            truth(m, (struct vec2){ g->x[k % COLUMNS], g->y[k / COLUMNS] })
                .exit_reason;
    for (int j = 0; j < ROWS; j++)
        g->span[j] = (struct patchwork_span){ 0, COLUMNS };
    g->g = (struct patchwork_grid){ g->x, g->y, COLUMNS, ROWS, g->span };
    g->source = (struct patchwork_source){
        find, sample, { tell, friction, passes, m }, ~0u, m
    };
}

/* Plans and fills; how many states that took. */
static size_t fill(struct grid *g, double rtol, struct cell out[])
{
    struct patchwork w;
    size_t sampled = 0;

    assert_int_equal(patchwork_plan(&w, &g->g, &g->source, rtol, both, NULL),
                     STATUS_OK);
    assert_int_equal(patchwork_rows(&w, 0, ROWS, g->label, out, &sampled),
                     STATUS_OK);
    sampled += w.sampled;
    patchwork_free(&w);
    patchwork_free(&w);
    return sampled;
}

static void check_cell(const struct cell *c, const struct cell *t, double rtol,
                       int k)
{
    CHECK(c->exit_reason == t->exit_reason, "cell %d", k);
    CHECK(fabs(c->slip - t->slip) <= c->slip_error &&
              c->slip_error <= rtol * t->slip,
          "rtol %g, cell %d: slip %g off by %g, bar %g", rtol, k, t->slip,
          c->slip - t->slip, c->slip_error);
    CHECK(fabs(c->mu_mean - t->mu_mean) <= c->mu_mean_error &&
              c->mu_mean_error <= rtol * t->mu_mean,
          "rtol %g, cell %d: mu %g off by %g, bar %g", rtol, k, t->mu_mean,
          c->mu_mean - t->mu_mean, c->mu_mean_error);
    CHECK(isnan(c->time) && isnan(c->time_error), "cell %d", k);
}

static void every_cell_is_within_its_bar(void **state)
{
    static struct grid g;
    static struct cell out[CELLS];
    uint64_t rng = check_seed();

    (void) state;
    for (int round = 0; round < 20; round++) {
        struct model m = { .bend = check_uniform(&rng, -2, 2),
                           .kink = check_uniform(&rng, 0, 4),
                           .noise = 0.5 };
        const double rtol = pow(10.0, check_uniform(&rng, -9, -3));
        make_grid(&g, &m);
        const size_t sampled = fill(&g, rtol, out);
        CHECK(sampled < 2 * CELLS / 3, "rtol %g: %zu states", rtol, sampled);
        for (int k = 0; k < CELLS; k++) {
            const struct cell t =
                truth(&m, (struct vec2){ g.x[k % COLUMNS], g.y[k / COLUMNS] });
            check_cell(&out[k], &t, rtol, k);
        }
    }
}

static void next_to_a_separatrix_few_cells_are_looked_at(void **state)
{
    static struct grid g;
    static struct cell out[CELLS];
    struct model m = { .bend = -1.3, .kink = 5.0 };
    double nearest = 1.0;

    (void) state;
    make_grid(&g, &m);
    const size_t sampled = fill(&g, 1e-6, out);
    CHECK(sampled < CELLS / 8, "%zu states", sampled);
    for (int k = 0; k < CELLS; k++) {
        const struct vec2 z = { g.x[k % COLUMNS], g.y[k / COLUMNS] };
        const double y = fabs(base_of(&m, z));
        if (out[k].slip_error > 1e-15 * out[k].slip) /* not found by itself */
            nearest = fmin(nearest, y);
    }
    CHECK(nearest < 0.01, "none told nearer than %g", nearest);
}

static void what_does_not_exist_is_not_interpolated(void **state)
{
    static struct grid g;
    static struct cell out[CELLS];
    struct model m = { .bend = 9.0, .kink = 5.0, .has_no_friction = true };

    (void) state;
    make_grid(&g, &m);
    const size_t sampled = fill(&g, 1e-4, out);
    for (int k = 0; k < CELLS; k++)
        CHECK(isnan(out[k].mu_mean) && isnan(out[k].mu_mean_error) &&
                  out[k].slip > 0.0,
              "cell %d: %g", k, out[k].mu_mean);
    CHECK(sampled < CELLS / 3, "%zu states", sampled);
}

static void a_label_that_disagrees_is_looked_at_by_itself(void **state)
{
    static struct grid g;
    static struct cell out[CELLS];
    struct model m = { .bend = 9.0, .kink = 5.0 };

    (void) state;
    make_grid(&g, &m);
    const size_t all = fill(&g, 1e-3, out);
    CHECK(all < CELLS / 20, "%zu states of a smooth field", all);
    g.label[5000] = FATE_RUNAWAY;
    const size_t more = fill(&g, 1e-3, out);
    assert_int_equal(out[5000].exit_reason, FATE_CREEP);
    CHECK(more == all + 1, "%zu, %zu", more, all);
    for (int k = 0; k < CELLS; k++)
        g.label[k] = FATE_SLIDING;
    CHECK(fill(&g, 1e-3, out) > CELLS, "not all");
}

static void ask_of(struct grid *g, unsigned fates)
{
    g->source.fates = fates;
    for (int j = 0; j < ROWS; j++)
        g->span[j] = patchwork_span_of(g->label + j * COLUMNS, COLUMNS, fates);
}

static void fates_without_fields_are_not_looked_at(void **state)
{
    static struct grid g;
    static struct cell out[CELLS];
    struct model m = { .bend = 1.2, .kink = 1.0, .noise = 0.5 };

    (void) state;
    make_grid(&g, &m);
    const size_t all = fill(&g, 1e-6, out);
    ask_of(&g, 1u << FATE_SLIDING);
    const size_t some = fill(&g, 1e-6, out);
    CHECK(some < 2 * all / 3, "%zu states of %zu", some, all);
    for (int k = 0; k < CELLS; k++) {
        struct cell t =
            truth(&m, (struct vec2){ g.x[k % COLUMNS], g.y[k / COLUMNS] });
        if (t.exit_reason == FATE_SLIDING)
            check_cell(&out[k], &t, 1e-6, k);
        else
            CHECK(out[k].exit_reason == FATE_CREEP && isnan(out[k].slip) &&
                      isnan(out[k].mu_mean) && isnan(out[k].slip_error),
                  "cell %d: %g", k, out[k].slip);
    }
    ask_of(&g, 1u << FATE_REST_FINITE);
    assert_int_equal(fill(&g, 1e-6, out), 0);
}

/* The same bits in any parts and at any number of threads. */
static void rows_may_be_filled_in_any_parts(void **state)
{
    static struct grid g;
    static struct cell whole[CELLS], part[CELLS];
    struct model m = { .bend = 0.2, .kink = 1.0, .noise = 0.5 };
    struct patchwork w;
    const int threads = omp_get_max_threads();

    (void) state;
    memset(whole, 0, sizeof whole);
    memset(part, 0, sizeof part);
    make_grid(&g, &m);
    omp_set_num_threads(1);
    fill(&g, 1e-5, whole);
    omp_set_num_threads(3);
    assert_int_equal(patchwork_plan(&w, &g.g, &g.source, 1e-5, both, NULL), 0);
    for (size_t j = 0; j < ROWS; j += 37) {
        const size_t rows = j + 37 < ROWS ? 37 : ROWS - j;
        assert_int_equal(patchwork_rows(&w, j, rows, g.label + j * COLUMNS,
                                        part + j * COLUMNS, NULL),
                         STATUS_OK);
    }
    omp_set_num_threads(threads);
    patchwork_free(&w);
    for (size_t k = 0; k < CELLS; k++)
        CHECK(part[k].exit_reason == whole[k].exit_reason &&
                  memcmp(&part[k].slip, &whole[k].slip, 2 * sizeof(double)) ==
                      0,
              "cell %zu: %.17g, not %.17g", k, part[k].slip, whole[k].slip);
}

static int stop(void *ctx, const char *stage, uint64_t done, uint64_t total)
{
    (void) ctx, (void) done, (void) total;
    assert_string_equal(stage, "patches");
    return 1;
}

static void a_failure_is_passed_on(void **state)
{
    static struct grid g;
    static struct cell out[CELLS];
    struct model m = { .kink = 5.0, .fails = STATUS_STOPPED };
    const struct monitor monitor = { stop, NULL };
    enum status s = STATUS_NO_MEMORY;
    struct patchwork w;
    long k = 0;

    (void) state;
    make_grid(&g, &m);
    assert_int_equal(patchwork_plan(&w, &g.g, &g.source, 1e-3, both, NULL),
                     STATUS_STOPPED);
    m.fails = STATUS_OK;
    assert_int_equal(patchwork_plan(&w, &g.g, &g.source, 1e-3, both, &monitor),
                     STATUS_STOPPED);
    assert_int_equal(w.count, 0);
    for (; s != STATUS_OK; k++) {
        fault_alloc_at(k);
        s = patchwork_plan(&w, &g.g, &g.source, 1e-3, both, NULL);
        if (s == STATUS_OK)
            s = patchwork_rows(&w, 0, ROWS, g.label, out, NULL);
        assert_true(s == STATUS_OK || s == STATUS_NO_MEMORY);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        patchwork_free(&w);
    }
    CHECK(k > 5, "%ld allocations", k);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_cell_is_within_its_bar),
        cmocka_unit_test(next_to_a_separatrix_few_cells_are_looked_at),
        cmocka_unit_test(what_does_not_exist_is_not_interpolated),
        cmocka_unit_test(a_label_that_disagrees_is_looked_at_by_itself),
        cmocka_unit_test(fates_without_fields_are_not_looked_at),
        cmocka_unit_test(rows_may_be_filled_in_any_parts),
        cmocka_unit_test(a_failure_is_passed_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
