/* Many states the fast way, against whole orbits.
 *
 * CELL_STATES=2000 tries more states than a test can afford. */
#include "fast_cells.h"

#include <omp.h>

#include "fault_alloc.h"
#include "slope.h"
#include "stops.h"
#include "tolerance.h"

enum { ALL = (1 << CELL_FIELDS) - 1, MOST = 4000 };
static const char *const steady_only[] = { "products=[equilibria]", NULL };

struct place {
    struct slope s;
    struct fast_cells f;
};

static void make(struct place *p, const char *law, const char *alpha)
{
    slope_make(&p->s, law, NULL, alpha, steady_only);
    assert_int_equal(fast_cells_init(&p->f, &p->s.study.slider, NULL),
                     STATUS_OK);
}

static void drop(struct place *p)
{
    fast_cells_free(&p->f);
    fast_cells_free(&p->f);
    slope_free(&p->s);
}

static size_t find(const struct place *p, const struct vec2 z[], size_t n,
                   double rtol, unsigned which, struct cell out[])
{
    size_t whole;
    const enum status status =
        fast_cells_find(&p->f, z, n, rtol, which, NULL, out, &whole);

    CHECK(status == STATUS_OK, "%s", status_text(status));
    return whole;
}

static double value_of(const struct cell *c, size_t field)
{
    const struct record_array a = { &record_cell, c, 1 };
    return *(const double *) record_member(&a, 0, &record_cell.fields[field]);
}

/* Each value within both errors of that of the whole orbit. */
static void check_cell(struct vec2 z, const struct cell *fast,
                       const struct cell *slow)
{
    CHECK(fast->exit_reason == slow->exit_reason, "(%.17g, %.17g): %s, not %s",
          z.x, z.y, fate_names[fast->exit_reason],
          fate_names[slow->exit_reason]);
    for (size_t k = 1; k < record_cell.count; k += 2) {
        const double a = value_of(fast, k), b = value_of(slow, k);
        const double bar = value_of(fast, k + 1) + value_of(slow, k + 1);
        if (isnan(a) && isnan(b))
            continue;
        CHECK(fabs(a - b) <= bar, "(%.17g, %.17g) %s: %.15g, not %.15g +- %g",
              z.x, z.y, record_cell.fields[k].name, a, b, bar);
    }
}

static size_t states(void)
{
    const char *s = getenv("CELL_STATES");
    const size_t n = s ? (size_t) strtoul(s, NULL, 10) / 10 : 5;
    return n < MOST ? n : MOST;
}

static void check_law(const char *law, const char *alpha, unsigned which,
                      uint64_t *seed)
{
    static struct cell fast[MOST], slow[MOST];
    static struct vec2 z[MOST];
    const size_t n = states();
    struct place p;

    make(&p, law, alpha);
    for (size_t i = 0; i < n; i++)
        z[i] = (struct vec2){ check_uniform(seed, -6, 9),
                              check_uniform(seed, -6, 6) };
    find(&p, z, n, 1e-6, which, fast);
    assert_int_equal(
        cells_find(&p.s.study.slider, z, n, 1e-7, which, NULL, slow),
        STATUS_OK);
    for (size_t i = 0; i < n; i++)
        check_cell(z[i], &fast[i], &slow[i]);
    drop(&p);
}

static void every_value_is_that_of_the_whole_orbit(void **state)
{
    const unsigned integrals = ALL & ~(3u << CELL_V_PEAK);
    uint64_t seed = check_seed();

    (void) state;
    check_law("spinodal_gen", "0.34", ALL, &seed);
    check_law("spinodal_gen", "0.30", integrals, &seed);
    check_law("spinodal", "0.34", ALL, &seed);
    check_law("spinodal", "0.2", integrals, &seed);
    check_law("spinodal_phi_gen", "0.38", ALL, &seed);
    check_law("spinodal_phi_gen", "0.34", integrals, &seed);
    check_law("spinodal", "0.38", ALL, &seed);
    check_law("spinodal_phi_gen", "0.30", integrals, &seed);
    check_law("dieterich_gen", "0.34", ALL, &seed);
    check_law("dieterich_gen", "0.30", integrals, &seed);
    check_law("dieterich", "0.26", ALL, &seed);
    check_law("perrin", "0.34", ALL, &seed);
    check_law("ruina", "0.26", ALL, &seed);
}

static void check_whole(const char *law, const char *alpha, uint64_t *seed)
{
    enum { N = 300 };
    struct vec2 z[N];
    struct cell c[N];
    struct place p;
    int wide = 0;

    make(&p, law, alpha);
    for (int i = 0; i < N; i++)
        z[i] = (struct vec2){ check_uniform(seed, -6, 9),
                              check_uniform(seed, -6, 6) };
    const unsigned which = 1u << CELL_SLIP | 1u << CELL_TIME;
    const size_t whole = find(&p, z, N, 1e-6, which, c);
    CHECK(whole <= N / 20, "%s at %s: %zu whole orbits", law, alpha, whole);
    for (int i = 0; i < N; i++)
        wide += c[i].slip_error > 1e-6 * c[i].slip ||
                c[i].time_error > 1e-6 * c[i].time;
    CHECK(wide <= N / 10, "%s at %s: %d bars too wide", law, alpha, wide);
    const size_t tops =
        find(&p, z, N, 1e-6, 1u << CELL_V_PEAK | 1u << CELL_MU_PEAK, c);
    CHECK(tops <= N / 30, "%s at %s: %zu whole orbits for peaks", law, alpha,
          tops);
    drop(&p);
}

static void most_states_need_no_whole_orbit(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    check_whole("spinodal_gen", "0.34", &seed);
    check_whole("dieterich", "0.30", &seed);
    check_whole("ruina", "0.25", &seed);
    check_whole("perrin", "0.30", &seed);
}

/* How many of 400 states have a bar of slip or time above 1e-9 of it. */
static int too_wide(const char *law)
{
    enum { N = 400 };
    static struct vec2 z[N];
    static struct cell out[N];
    struct place p;
    int wide = 0;

    make(&p, law, "0.34");
    const struct vec2 o = p.s.study.slider.plane.system.origin;
    for (int i = 0; i < N; i++)
        z[i] = (struct vec2){ o.x - 14.0 + i % 20, o.y - 5.5 + 0.5 * (i / 20) };
    find(&p, z, N, 1e-9, 1u << CELL_SLIP | 1u << CELL_TIME, out);
    for (int i = 0; i < N; i++)
        wide += out[i].slip_error > 1e-9 * out[i].slip ||
                out[i].time_error > 1e-9 * out[i].time;
    drop(&p);
    return wide;
}

/* On the way to a node, and to rest. */
static void bars_are_within_what_is_asked(void **state)
{
    static const char *const law[] = { "dieterich_gen", "spinodal_gen",
                                       "spinodal", "spinodal_phi_gen" };

    (void) state;
    for (size_t i = 0; i < sizeof law / sizeof *law; i++)
        CHECK(too_wide(law[i]) == 0, "%s: %d", law[i], too_wide(law[i]));
}

static void any_number_of_threads_gives_the_same_bits(void **state)
{
    enum { N = 100 };
    uint64_t seed = check_seed();
    struct cell one[N], two[N];
    struct vec2 z[N];
    struct place p;

    (void) state;
    make(&p, "spinodal", "0.34");
    for (int i = 0; i < N; i++)
        z[i] = (struct vec2){ check_uniform(&seed, -6, 9),
                              check_uniform(&seed, -6, 6) };
    memset(one, 0, sizeof one);
    memset(two, 0, sizeof two);
    const int threads = omp_get_max_threads();
    omp_set_num_threads(1);
    find(&p, z, N, 1e-5, 1u << CELL_SLIP, one);
    omp_set_num_threads(2);
    find(&p, z, N, 1e-5, 1u << CELL_SLIP, two);
    omp_set_num_threads(threads);
    for (int i = 0; i < N; i++) {
        assert_int_equal(one[i].exit_reason, two[i].exit_reason);
        assert_memory_equal(&one[i].slip, &two[i].slip, 2 * sizeof(double));
    }
    drop(&p);
}

/* As cells_find does. */
static void states_beyond_the_slow_curve_take_their_whole_orbits(void **state)
{
    struct cell fast, slow;
    struct place p;

    (void) state;
    make(&p, "ruina", "0.34");
    const struct vec2 z = slope_point(&p.s, 1.0, 500.0);
    assert_int_equal(find(&p, &z, 1, 1e-4, ALL, &fast), 1);
    assert_int_equal(
        cells_find(&p.s.study.slider, &z, 1, 1e-4, ALL, NULL, &slow),
        STATUS_OK);
    check_cell(z, &fast, &slow);
    drop(&p);
}

/* Orbits that rise all the way are as fast as the slow curve where it ends, in
 * the box of the sliding node, which no table's interpolation knows better. */
static void a_peak_at_the_end_is_known_to_rounding(void **state)
{
    uint64_t seed = check_seed();
    double first = 0.0, bar = 0.0;
    size_t rise = 0;
    struct place p;

    (void) state;
    make(&p, "spinodal_gen", "0.34");
    for (int i = 0; i < 100; i++) {
        const struct vec2 z = { check_uniform(&seed, -1.0, 8.0),
                                check_uniform(&seed, -8.0, 2.0) };
        struct cell c;
        find(&p, &z, 1, 1e-6, 1u << CELL_V_PEAK, &c);
        if (c.exit_reason != FATE_SLIDING || !(c.v_peak > 1.1 * exp(z.x)))
            continue;
        first = rise == 0 ? c.v_peak : first;
        bar = fmax(bar, c.v_peak_error);
        rise++;
        CHECK(fabs(c.v_peak - first) <= bar && bar < 1e-13 * first,
              "(%.17g, %.17g): %.17g +- %g, not %.17g", z.x, z.y, c.v_peak, bar,
              first);
    }
    assert_true(rise > 10);
    drop(&p);
}

static void wrong_arguments_and_monitors_are_answered(void **state)
{
    const struct monitor monitor = { stop_at_once, NULL };
    const struct vec2 good = { 1.0, 1.0 }, bad = { 700.0, 0.0 };
    struct place p;
    struct cell c;

    (void) state;
    make(&p, "spinodal", "0.34");
    assert_int_equal(fast_cells_find(&p.f, &bad, 1, 1e-6, 0, NULL, &c, NULL),
                     STATUS_BAD_ARGUMENT);
    assert_int_equal(fast_cells_find(&p.f, &good, 1, 1.0, 0, NULL, &c, NULL),
                     STATUS_BAD_ARGUMENT);
    assert_int_equal(
        fast_cells_find(&p.f, &good, 1, 1e-6, 0, &monitor, &c, NULL),
        STATUS_STOPPED);
    assert_int_equal(fast_cells_find(&p.f, &good, 1, 1e-6, 0, NULL, &c, NULL),
                     STATUS_OK);
    assert_true(isnan(c.slip) && isnan(c.mu_peak_error));
    drop(&p);
}

static void every_allocation_may_fail(void **state)
{
    enum status status = STATUS_NO_MEMORY;
    struct fast_cells f;
    struct slope s;
    struct cell c;

    (void) state;
    slope_make(&s, "ruina", NULL, "0.34", steady_only);
    const struct vec2 z = slope_point(&s, 1.0, 500.0);
    assert_int_equal(fast_cells_init(&f, &s.study.slider, NULL), STATUS_OK);
    fault_alloc_at(0);
    status = fast_cells_find(&f, &z, 1, 1e-3, 1u, NULL, &c, NULL);
    fault_alloc_at(FAULT_ALLOC_NEVER);
    assert_int_equal(status, STATUS_NO_MEMORY);
    fast_cells_free(&f);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_value_is_that_of_the_whole_orbit),
        cmocka_unit_test(most_states_need_no_whole_orbit),
        cmocka_unit_test(bars_are_within_what_is_asked),
        cmocka_unit_test(any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(states_beyond_the_slow_curve_take_their_whole_orbits),
        cmocka_unit_test(a_peak_at_the_end_is_known_to_rounding),
        cmocka_unit_test(wrong_arguments_and_monitors_are_answered),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
