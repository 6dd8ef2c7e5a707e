/* Basins of systems whose boundaries are known exactly. */
#include "basin.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "fault_alloc.h"
#include "fixtures.h"
#include "grow.h"
#include "margin.h"
#include "orbit.h"

enum { COLUMNS = 41, ROWS = 37 };

struct sample {
    struct fixture f;
    struct planar sys;
    struct branch branch[2];
    struct separatrix separatrix;
    struct regions regions;
    struct box window;
    double x[COLUMNS], y[ROWS];
    struct basin_grid grid;
};

static void make_grid(struct sample *s, struct box w)
{
    for (int i = 0; i < COLUMNS; i++)
        s->x[i] = w.lo.x + (i + 0.5) / COLUMNS * (w.hi.x - w.lo.x);
    for (int j = 0; j < ROWS; j++)
        s->y[j] = w.lo.y + (j + 0.5) / ROWS * (w.hi.y - w.lo.y);
    s->grid = (struct basin_grid){ s->x, s->y, COLUMNS, ROWS };
    s->window = w;
}

static enum status grow_both(struct sample *s, const struct box *reach)
{
    struct grow_options o = grow_defaults(1e-12);
    struct local_series u;
    struct equilibrium e;

    o.max_steps = 400;
    o.reach = reach;
    equilibrium_at(&s->sys, false, &e);
    enum status status =
        local_at(&s->sys, &e, MANIFOLD_STABLE, &o.carry, o.order, 1e-14, &u);
    if (status == STATUS_OK)
        status = grow_branches(&s->sys, &u, &o, s->branch);
    return status;
}

static void sample_free(struct sample *s)
{
    regions_free(&s->regions);
    separatrix_free(&s->separatrix);
    branch_free(&s->branch[0]);
    branch_free(&s->branch[1]);
}

/* False where the manifold runs too far for the steps allowed. */
static bool sample_make(struct sample *s, enum fixture_base base, uint64_t *rng)
{
    fixture_random(&s->f, base, rng);
    s->sys = fixture_planar(&s->f);
    s->branch[0].curve = s->branch[1].curve = CURVE_EMPTY(2);
    s->regions = (struct regions){ .separatrix = NULL };
    const struct vec2 c = { s->sys.origin.x + check_uniform(rng, -0.6, 0.6),
                            s->sys.origin.y + check_uniform(rng, -0.6, 0.6) };
    const struct box w = { { c.x - check_uniform(rng, 0.4, 1.2),
                             c.y - check_uniform(rng, 0.4, 1.2) },
                           { c.x + check_uniform(rng, 0.4, 1.2),
                             c.y + check_uniform(rng, 0.4, 1.2) } };
    make_grid(s, w);
    s->separatrix = separatrix_empty(SEPARATRIX_Y, s->sys.origin);
    if (grow_both(s, &w) != STATUS_OK)
        return false;
    assert_int_equal(
        separatrix_add(&s->separatrix, &s->branch[1], &s->branch[0]),
        STATUS_OK);
    assert_int_equal(regions_init(&s->regions, &s->separatrix), STATUS_OK);
    return true;
}

/* The sign of the base coordinate X where the forward orbit ends. */
static enum status fate(const void *ctx, struct vec2 z, int8_t *label)
{
    const struct sample *s = ctx;
    struct orbit_options options = orbit_defaults(&s->sys, exp(s->f.log_rate));
    struct orbit orbit;

    options.observables = 0;
    options.rtol = 1e-8;
    options.reach[0] = 8.0 * exp(-s->f.log_rate);
    enum status status =
        orbit_init(&orbit, &s->sys, vec2_sub(z, s->sys.origin), &options);
    if (status == STATUS_OK)
        status = orbit_run(&orbit, NULL);
    const struct vec2 end = { orbit.u[0], orbit.u[1] };
    *label = fixture_base_point(&s->f, end).x > 0.0 ? 1 : -1;
    orbit_free(&orbit);
    return status == STATUS_NO_CONVERGENCE ? STATUS_OK : status;
}

/* Distance of z from the boundary X = 0, first order. */
static double distance(const struct fixture *f, struct vec2 z)
{
    const double h = 1e-6;
    const double X = fixture_base_point(f, z).x;
    const double gx =
        fixture_base_point(f, (struct vec2){ z.x + h, z.y }).x - X;
    const double gy =
        fixture_base_point(f, (struct vec2){ z.x, z.y + h }).x - X;
    return X * h / hypot(gx, gy);
}

static size_t wrong_cells(const struct sample *s, const int8_t *label)
{
    size_t wrong = 0;

    for (size_t j = 0; j < ROWS; j++)
        for (size_t i = 0; i < COLUMNS; i++) {
            const struct vec2 z = { s->x[i] - s->sys.origin.x,
                                    s->y[j] - s->sys.origin.y };
            const double d = distance(&s->f, z);
            wrong +=
                fabs(d) > 1e-9 && (d > 0.0) != (label[j * COLUMNS + i] > 0);
        }
    return wrong;
}

static void label_by_point(struct sample *s, struct vec2 z)
{
    struct crossing c[64];
    struct region *g = &s->regions.region[regions_at(&s->regions, z, c)];

    if (g->label == REGION_UNLABELLED)
        assert_int_equal(fate(s, z, &g->label), STATUS_OK);
}

/* Every region that has a cell, or a point of a finer grid, by its fate. */
static void label_all(struct sample *s)
{
    enum { FINE = 60 };
    const struct box w = s->window;

    assert_true(s->regions.most < 64);
    for (size_t k = 0; k < ROWS * COLUMNS; k++)
        label_by_point(s,
                       (struct vec2){ s->x[k % COLUMNS], s->y[k / COLUMNS] });
    for (int k = 0; k < FINE * FINE; k++)
        label_by_point(
            s, (struct vec2){
                   w.lo.x + (k % FINE + 0.5) / FINE * (w.hi.x - w.lo.x),
                   w.lo.y + (k / FINE + 0.5) / FINE * (w.hi.y - w.lo.y) });
}

static void every_cell_has_the_label_of_its_side(void **state)
{
    uint64_t rng = check_seed();
    size_t made = 0, cut = 0;

    (void) state;
    for (int n = 0; n < 1000; n++) {
        static const enum fixture_base base[] = { FIXTURE_PITCHFORK,
                                                  FIXTURE_PARABOLA };
        struct sample s;
        struct basin b;
        int8_t label[ROWS * COLUMNS];
        if (!sample_make(&s, base[n % 2], &rng)) {
            sample_free(&s);
            continue;
        }
        assert_int_equal(basin_init(&b, &s.regions, &s.grid), STATUS_OK);
        label_all(&s);
        basin_fill(&b, 0, ROWS, label);
        const size_t wrong = wrong_cells(&s, label);
        CHECK(wrong == 0, "system %d: %zu of %d cells wrong", n, wrong,
              ROWS * COLUMNS);
        made++;
        cut += s.regions.most > 0;
        basin_free(&b);
        basin_free(&b);
        sample_free(&s);
    }
    print_message("# %zu systems, %zu of them with a boundary in the window\n",
                  made, cut);
    CHECK(made > 990 && cut > 700, "only %zu systems, %zu cut", made, cut);
}

static void crossings_lie_on_the_manifold(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int n = 0; n < 200; n++) {
        struct sample s;
        struct crossing c[64];
        if (!sample_make(&s, n % 2 ? FIXTURE_PITCHFORK : FIXTURE_PARABOLA,
                         &rng)) {
            sample_free(&s);
            continue;
        }
        for (int j = 0; j < ROWS; j++) {
            const size_t found = separatrix_row(&s.separatrix, s.y[j], c);
            for (size_t k = 0; k < found; k++) {
                const struct vec2 z = { c[k].at - s.sys.origin.x,
                                        s.y[j] - s.sys.origin.y };
                if (!(fabs(z.x) < 3.0))
                    continue;
                const double d = fabs(distance(&s.f, z));
                CHECK(d < 1e-10, "system %d: off by %.2g at (%g, %g)", n, d,
                      z.x, z.y);
                CHECK(k == 0 || c[k - 1].at <= c[k].at, "%s", "not in order");
            }
        }
        sample_free(&s);
    }
}

/* A step to just this side of the named margin keeps the side, a step beyond
 * changes it; without a margin there is one label. */
static void check_margin(const struct sample *s, struct margin_line *l,
                         const struct separatrix *cuts, struct vec2 z)
{
    const bool row = cuts->along == SEPARATRIX_Y;
    double error;

    margin_find(l, &s->regions, cuts, row ? z.y : z.x);
    const double far = margin_at(l, row ? z.x : z.y, &error);
    if (!isfinite(far)) {
        assert_int_equal(l->count, 0);
        return;
    }
    for (int beyond = 0; beyond < 2; beyond++) {
        const double step = far + copysign(1e-9, beyond ? far : -far);
        const struct vec2 to = { row ? z.x + step : z.x,
                                 row ? z.y : z.y + step };
        const double d = distance(&s->f, vec2_sub(to, s->sys.origin));
        const double from = distance(&s->f, vec2_sub(z, s->sys.origin));
        if (fabs(to.x - z.x) + fabs(to.y - z.y) < 2.0 && fabs(d) > 1e-12)
            CHECK(((d > 0.0) == (from > 0.0)) == !beyond,
                  "from (%g, %g) by %g %s: %g after %g", z.x, z.y, far,
                  row ? "right" : "up", d, from);
    }
}

static void margins_lead_just_to_the_other_side(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int n = 0; n < 100; n++) {
        struct sample s;
        struct margin_line l;
        if (!sample_make(&s, n % 2 ? FIXTURE_PITCHFORK : FIXTURE_PARABOLA,
                         &rng)) {
            sample_free(&s);
            continue;
        }
        struct separatrix columns =
            separatrix_empty(SEPARATRIX_X, s.sys.origin);
        assert_int_equal(separatrix_add(&columns, &s.branch[1], &s.branch[0]),
                         STATUS_OK);
        label_all(&s);
        assert_int_equal(margin_init(&l, &s.separatrix, &columns), STATUS_OK);
        for (int i = 0; i < 30; i++) {
            const struct vec2 z = {
                check_uniform(&rng, s.window.lo.x, s.window.hi.x),
                check_uniform(&rng, s.window.lo.y, s.window.hi.y)
            };
            check_margin(&s, &l, &s.separatrix, z);
            check_margin(&s, &l, &columns, z);
        }
        margin_free(&l);
        separatrix_free(&columns);
        sample_free(&s);
    }
}

/* The share of a fine grid's points on each side, against the quadrature. */
static double counted(const struct sample *s, struct measure m)
{
    enum { FINE = 400 };
    const struct box w = s->window;
    double inside = 0.0;

    for (int j = 0; j < FINE; j++)
        for (int i = 0; i < FINE; i++) {
            const struct vec2 z = {
                w.lo.x + (i + 0.5) / FINE * (w.hi.x - w.lo.x),
                w.lo.y + (j + 0.5) / FINE * (w.hi.y - w.lo.y)
            };
            const double weight = (m.exponential[0] ? exp(z.x) : 1.0) *
                                  (m.exponential[1] ? exp(z.y) : 1.0);
            const struct vec2 offset = vec2_sub(z, s->sys.origin);
            inside += fixture_base_point(&s->f, offset).x > 0.0 ? weight : 0.0;
        }
    return inside * (w.hi.x - w.lo.x) * (w.hi.y - w.lo.y) / FINE / FINE;
}

static void areas_are_those_of_the_sides(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (int n = 0; n < 60; n++) {
        struct measure m = { .exponential = { n % 3 == 1, n % 3 > 0 } };
        struct sample s;
        struct crossing c[64];
        struct area area[64];
        if (!sample_make(&s, n % 2 ? FIXTURE_PITCHFORK : FIXTURE_PARABOLA,
                         &rng)) {
            sample_free(&s);
            continue;
        }
        label_all(&s);
        const struct box w = s.window;
        const double all =
            (m.exponential[0] ? exp(w.hi.x) - exp(w.lo.x) : w.hi.x - w.lo.x) *
            (m.exponential[1] ? exp(w.hi.y) - exp(w.lo.y) : w.hi.y - w.lo.y);
        assert_true(s.regions.count <= 64);
        regions_areas(&s.regions, w, m, c, area);
        double right = 0.0, left = 0.0, error = 0.0;
        for (size_t i = 0; i < s.regions.count; i++) {
            *(s.regions.region[i].label == 1 ? &right : &left) += area[i].value;
            error += area[i].error;
        }
        CHECK(fabs(right + left - all) <= 1e-12 * all, "%g + %g, not %g", right,
              left, all);
        CHECK(fabs(right - counted(&s, m)) <= 4e-3 * all,
              "system %d: %.9g of %.9g, counted %.9g", n, right, all,
              counted(&s, m));
        CHECK(error <= 2e-9 * all, "error %g", error / all);
        sample_free(&s);
    }
}

static void every_allocation_fails_once(void **state)
{
    uint64_t rng = check_seed();
    struct sample s;
    struct basin b;

    (void) state;
    while (!sample_make(&s, FIXTURE_PITCHFORK, &rng))
        sample_free(&s);
    enum status status = STATUS_NO_MEMORY;
    long k = 0;
    for (; status != STATUS_OK; k++) {
        struct separatrix again = separatrix_empty(SEPARATRIX_Y, s.sys.origin);
        fault_alloc_at(k);
        status = separatrix_add(&again, &s.branch[1], &s.branch[0]);
        struct regions regions = { .separatrix = NULL };
        if (status == STATUS_OK)
            status = regions_init(&regions, &again);
        if (status == STATUS_OK)
            status = basin_init(&b, &regions, &s.grid);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        assert_true(status == STATUS_OK || status == STATUS_NO_MEMORY);
        if (status == STATUS_OK)
            basin_free(&b);
        regions_free(&regions);
        separatrix_free(&again);
    }
    CHECK(k > 5, "only %ld allocations", k);
    sample_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_cell_has_the_label_of_its_side),
        cmocka_unit_test(crossings_lie_on_the_manifold),
        cmocka_unit_test(margins_lead_just_to_the_other_side),
        cmocka_unit_test(areas_are_those_of_the_sides),
        cmocka_unit_test(every_allocation_fails_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
