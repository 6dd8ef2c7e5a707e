/* Slip, time, friction and peaks of many states.
 *
 * CELL_STATES=2000 tries more states than a test can afford. */
#include "cells.h"

#include "cells_of.h"
#include "peak.h"
#include "tolerance.h"

/* ---- against the table --------------------------------------------------- */

/* The block passes a row before it stops exactly if its slip is still less. */
static void check_transient(const struct cell *c, const struct csv *row)
{
    const double t = csv_number(row, "t", 0), x = csv_number(row, "x", 0);
    const double mu = csv_number(row, "mu", 0);

    if (strcmp(csv_text(row, "kind"), "initial") == 0) {
        is_near(c, CELL_V_PEAK, pow(10.0, 3.1));
        if (c->exit_reason == FATE_CREEP)
            is_near(c, CELL_MU_PEAK, mu);
    }
    if (strcmp(csv_text(row, "kind"), "v_equals_final") == 0 &&
        csv_number(row, "key", 1.0) < 1e-9) {
        is_near(c, CELL_TIME, t);
        is_near(c, CELL_SLIP, x);
    }
    if (fabs(t - c->time) > c->time_error && fabs(x - c->slip) > c->slip_error)
        CHECK((t < c->time) == (x < c->slip), "row %zu: %g %g, %g %g", row->row,
              t, c->time, x, c->slip);
}

static void transients_are_those_of_the_table(void **state)
{
    static const char *const form[] = { "asinh", "log" };
    static const char *const law[] = { "dieterich_gen", "spinodal_gen" };

    (void) state;
    for (int k = 0; k < 4; k++) {
        struct slope s;
        struct csv row;
        slope_make(&s, law[k / 2], form[k % 2], "0.34", steady_only);
        const struct cell c = find_one(&s, pow(10.0, 3.1), 100.0, 1e-6);
        assert_int_equal(c.exit_reason, k / 2 ? FATE_CREEP : FATE_REST_FINITE);
        CHECK(c.time_error <= 1e-6 * c.time && c.slip_error <= 1e-6 * c.slip,
              "%g of %g, %g of %g", c.time_error, c.time, c.slip_error, c.slip);
        csv_open(&row, "transient.csv");
        while (csv_next(&row))
            if (strcmp(csv_text(&row, "law"), law[k / 2]) == 0 &&
                strcmp(csv_text(&row, "form"), form[k % 2]) == 0)
                check_transient(&c, &row);
        slope_free(&s);
    }
}

/* ---- against tight runs -------------------------------------------------- */

static struct quantity tight_value(const struct fate_result *r,
                                   const struct peaks *p, enum cell_field k)
{
    const struct quantity q[CELL_FIELDS] = {
        [CELL_SLIP] = r->slip,
        [CELL_TIME] = r->time,
        [CELL_MU_MEAN] = r->mu_mean,
        [CELL_V_PEAK] = quantity_of(exp(p->x), 0.0),
        [CELL_MU_PEAK] = quantity_of(p->mu, 0.0),
    };
    return q[k];
}

/* 1 if the state could be compared. */
static int check_tight(const struct slope *s, struct vec2 z,
                       const struct cell *c)
{
    struct fate_result r;
    struct peaks p;

    assert_int_equal(fate_find(&s->study.slider, z, 1e-12, true, NULL, &r), 0);
    assert_int_equal(peaks_find(&s->study.slider, z, 1e-12, r.steps, &p), 0);
    if (r.fate == FATE_UNDECIDED)
        return 0;
    CHECK((int) r.fate == c->exit_reason, "(%g, %g): %s, not %s", z.x, z.y,
          fate_names[c->exit_reason], fate_names[r.fate]);
    for (int k = 0; k < CELL_FIELDS; k++) {
        const struct quantity q = tight_value(&r, &p, (enum cell_field) k);
        const double found = value(c, (enum cell_field) k);
        const double bar = error(c, (enum cell_field) k);
        CHECK(isnan(found) == isnan(bar) &&
                  !(fabs(found - q.value) > bar + q.error),
              "(%.17g, %.17g) %s: %.16g +- %g, not %.16g", z.x, z.y,
              record_cell.fields[1 + 2 * k].name, found, bar, q.value);
    }
    return 1;
}

/* A random slope of any law, and as many states of it. */
static int check_slope(const char *law, uint64_t *rng, size_t states)
{
    struct vec2 *z = calloc(states, sizeof *z);
    struct cell *c = calloc(states, sizeof *c);
    char alpha[32], a[40], L[40];
    const char *const more[] = { "products=[equilibria]", a, L, NULL };
    struct slope s;
    int compared = 0;

    snprintf(alpha, sizeof alpha, "%.3f", check_uniform(rng, 0.3, 0.38));
    snprintf(a, sizeof a, "material.a=%g", check_uniform(rng, 0.028, 0.038));
    snprintf(L, sizeof L, "material.L=%g", exp(check_uniform(rng, -17, -11)));
    slope_make(&s, law, check_bits(rng) % 2 ? "log" : "asinh", alpha, more);
    for (size_t i = 0; i < states; i++)
        z[i] = (struct vec2){ check_uniform(rng, -10, 10),
                              check_uniform(rng, -4, 4) };
    find(&s, z, states, 1e-6, ALL, c);
    for (size_t i = 0; i < states; i++)
        compared += check_tight(&s, z[i], &c[i]);
    slope_free(&s);
    free(z);
    free(c);
    return compared;
}

static void errors_of_random_states_lie_within_their_bars(void **state)
{
    static const char *const law[] = { "dieterich",       "dieterich_gen",
                                       "ruina",           "perrin",
                                       "spinodal",        "spinodal_gen",
                                       "spinodal_phi_gen" };
    enum { LAWS_ = sizeof law / sizeof *law, EACH = 12 };
    const char *asked = getenv("CELL_STATES");
    const int states = asked ? atoi(asked) : LAWS_ * EACH;
    uint64_t rng = check_seed();
    int compared = 0;

    (void) state;
    for (int i = 0; i * EACH < states; i++)
        compared += check_slope(law[i % LAWS_], &rng, EACH);
    print_message("# %d of %d states compared\n", compared, states);
    CHECK(compared > states - states / 20, "%d of %d", compared, states);
}

/* At some tolerances the dense output is off by 1e-7 where v turns. */
static void a_peak_inside_a_step_is_found_at_any_tolerance(void **state)
{
    const char *const more[] = { steady_only[0], "material.a=0.037808",
                                 "material.L=7.48577e-08", NULL };
    const struct vec2 z = { 1.48313, -2.43498 };
    struct slope s;
    struct peaks fine, p;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.32244", more);
    assert_int_equal(peaks_find(&s.study.slider, z, 1e-13, 100000, &fine), 0);
    for (double rtol = 1e-5; rtol > 1e-12; rtol *= 0.316) {
        assert_int_equal(peaks_find(&s.study.slider, z, rtol, 100000, &p), 0);
        const double dx = fabs(p.x - fine.x), dmu = fabs(p.mu - fine.mu);
        CHECK(dx < rtol + 1e-13 && dmu < rtol + 1e-13, "%g: %g, %g", rtol, dx,
              dmu);
    }
    slope_free(&s);
}

/* There dv/dt = 0: friction is what the slope pulls. */
static void a_peak_of_v_after_the_start_lies_on_the_nullcline(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    for (double psi = 0.01; psi < 0.3; psi *= 2.0) {
        const struct cell c = find_one(&s, 1.0, psi, 1e-8);
        CHECK(c.v_peak > 1.0 + c.v_peak_error, "psi = %g: %g", psi, c.v_peak);
        if (c.exit_reason != FATE_CREEP)
            continue;
        /* psi has risen meanwhile, or v would still rise */
        const struct vec2 at = vec2_sub(slope_point(&s, c.v_peak, psi),
                                        s.study.slider.plane.system.origin);
        CHECK(block_mu(&s.study.slider.block, at) <= tan(0.34) + 1e-9,
              "psi = %g", psi);
    }
    slope_free(&s);
}

/* ---- energy -------------------------------------------------------------- */

/* (27): the speed at arrest that slip and work imply is the node's, within what
 * arrest means. */
static void check_energy(const struct slope *s, double v, const struct cell *c,
                         double v_end)
{
    const double alpha = s->scene.alpha;
    const double eps2 = material_eps2(&s->study.slider.block.material);
    const double work = cos(alpha) * c->mu_mean * c->slip;
    const double pull = sin(alpha) * c->slip;
    const double end = 0.5 * eps2 * v * v + pull - work;
    const double slack = c->slip_error * (sin(alpha) + c->mu_mean) +
                         c->slip * c->mu_mean_error + 1e-14 * (pull + work);
    const double far = exp(2.0 * TOL_ARREST * 1.0001);

    CHECK(end >= 0.5 * eps2 * v_end * v_end / far - slack &&
              end <= 0.5 * eps2 * v_end * v_end * far + slack,
          "v = %g: %g, slack %g, end %g", v, end, slack, v_end);
}

static void energy_is_balanced_in_every_cell(void **state)
{
    enum { N = 60 };
    uint64_t rng = check_seed();
    struct vec2 z[N];
    struct cell c[N];
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    for (int i = 0; i < N; i++)
        z[i] = (struct vec2){ check_uniform(&rng, -10, 13),
                              check_uniform(&rng, -6, 6) };
    find(&s, z, N, 1e-6, ALL, c);
    const double end[] = { exp(s.study.slider.plane.equilibrium[0].z.x),
                           exp(s.study.slider.plane.equilibrium[2].z.x) };
    for (int i = 0; i < N; i++) {
        assert_in_range(c[i].exit_reason, FATE_CREEP, FATE_SLIDING);
        check_energy(&s, exp(z[i].x), &c[i], end[c[i].exit_reason]);
    }
    slope_free(&s);
}

/* ---- accuracy ------------------------------------------------------------ */

static void errors_are_no_larger_than_asked_for(void **state)
{
    enum { N = 20 };
    uint64_t rng = check_seed();
    struct vec2 z[N];
    struct cell c[N];
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    for (int i = 0; i < N; i++)
        z[i] = (struct vec2){ check_uniform(&rng, -10, 13),
                              check_uniform(&rng, -6, 6) };
    for (double rtol = 1e-3; rtol > 1e-10; rtol *= 1e-3) {
        find(&s, z, N, rtol, ALL, c);
        for (int i = 0; i < N; i++)
            for (enum cell_field k = 0; k < CELL_FIELDS; k++)
                CHECK(error(&c[i], k) <= rtol * value(&c[i], k),
                      "%g: (%g, %g): %g +- %g", rtol, z[i].x, z[i].y,
                      value(&c[i], k), error(&c[i], k));
    }
    slope_free(&s);
}

static int told, untold;

static void check_near(struct slope *s, const struct csv *row)
{
    const struct vec2 z = row_point(s, row);
    struct fate_result r;
    struct cell c;

    if (row_distance(row) > 1e-6)
        return;
    find(s, &z, 1, 1e-4, 1u << CELL_TIME, &c);
    CHECK(c.exit_reason == row_fate(row) || c.exit_reason == FATE_UNDECIDED,
          "row %zu: %s", row->row, fate_names[c.exit_reason]);
    if (c.exit_reason == FATE_UNDECIDED)
        untold++;
    if (c.exit_reason == FATE_UNDECIDED)
        return;
    told++;
    assert_int_equal(fate_find(&s->study.slider, z, 1e-13, true, NULL, &r), 0);
    CHECK(fabs(c.time - r.time.value) <= c.time_error + 0.01,
          "row %zu: %.9g +- %g, not %.9g", row->row, c.time, c.time_error,
          r.time.value);
    find(s, &z, 1, 1e-2, 0, &c);
    CHECK(c.exit_reason == row_fate(row) || c.exit_reason == FATE_UNDECIDED,
          "row %zu: %s", row->row, fate_names[c.exit_reason]);
}

/* Rows of basin.csv down to 1e-9 from the boundary, far nearer than what the
 * first tolerances resolve. */
static void states_beside_the_boundary_are_never_given_the_other_fate(
    void **state)
{
    (void) state;
    told = untold = 0;
    each_basin_row(1e-9, steady_only, check_near);
    print_message("# %d told, %d undecided\n", told, untold);
    CHECK(told > 9 * untold, "%d told, %d undecided", told, untold);
}

/* ---- what does not exist ------------------------------------------------- */

static void has(const struct cell *c, unsigned which)
{
    for (enum cell_field k = 0; k < CELL_FIELDS; k++)
        CHECK(isnan(value(c, k)) == !(which >> k & 1u) &&
                  isnan(error(c, k)) == !(which >> k & 1u),
              "%s: field %d: %g +- %g", fate_names[c->exit_reason], (int) k,
              value(c, k), error(c, k));
}

static void what_does_not_exist_is_not_a_number(void **state)
{
    static const struct {
        const char *law;
        double v;
        enum fate fate;
        unsigned has;
    } is[] = {
        { "dieterich_gen", 1e4, FATE_RUNAWAY, 0 },
        { "dieterich_gen", 1e3, FATE_REST_FINITE, ALL & ~(1u << CELL_MU_PEAK) },
        { "perrin", 1.0, FATE_REST_ASYMPTOTIC, ALL & ~(1u << CELL_TIME) },
        { "ruina", 1.0, FATE_REST_ASYMPTOTIC,
          1u << CELL_V_PEAK | 1u << CELL_MU_PEAK },
        { "spinodal_gen", 1e3, FATE_CREEP, ALL },
        { "spinodal_gen", 1e4, FATE_SLIDING, ALL },
    };

    (void) state;
    for (size_t i = 0; i < sizeof is / sizeof *is; i++) {
        struct slope s;
        slope_make(&s, is[i].law, NULL, "0.34", steady_only);
        const struct cell c = find_one(&s, is[i].v, 2.0, 1e-4);
        CHECK(c.exit_reason == (int) is[i].fate, "%s: %s", is[i].law,
              fate_names[c.exit_reason]);
        has(&c, is[i].has);
        slope_free(&s);
    }
}

static void a_state_at_a_node_has_arrived(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    const struct vec2 node = s.study.slider.plane.equilibrium[0].z;
    const double v = exp(node.x + 0.005), psi = exp(node.y - 0.005);
    const struct cell c = find_one(&s, v, psi, 1e-6);
    assert_int_equal(c.exit_reason, FATE_CREEP);
    assert_true(c.slip == 0.0 && c.time == 0.0 && isnan(c.mu_mean));
    is_near(&c, CELL_V_PEAK, v);
    slope_free(&s);
}

static void only_what_is_asked_for_is_computed(void **state)
{
    struct slope s;
    struct cell c, all;

    (void) state;
    slope_make(&s, "spinodal_gen", NULL, "0.34", steady_only);
    const struct vec2 z = slope_point(&s, 1e3, 2.0);
    find(&s, &z, 1, 1e-6, ALL, &all);
    for (unsigned which = 0; which < 1u << CELL_FIELDS; which += 5) {
        find(&s, &z, 1, 1e-6, which, &c);
        assert_int_equal(c.exit_reason, all.exit_reason);
        has(&c, which);
    }
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(transients_are_those_of_the_table),
        cmocka_unit_test(errors_of_random_states_lie_within_their_bars),
        cmocka_unit_test(a_peak_inside_a_step_is_found_at_any_tolerance),
        cmocka_unit_test(a_peak_of_v_after_the_start_lies_on_the_nullcline),
        cmocka_unit_test(energy_is_balanced_in_every_cell),
        cmocka_unit_test(errors_are_no_larger_than_asked_for),
        cmocka_unit_test(
            states_beside_the_boundary_are_never_given_the_other_fate),
        cmocka_unit_test(what_does_not_exist_is_not_a_number),
        cmocka_unit_test(a_state_at_a_node_has_arrived),
        cmocka_unit_test(only_what_is_asked_for_is_computed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
