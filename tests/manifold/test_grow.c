/* The stable manifold against systems whose manifolds are known exactly. */
#include "grow.h"

#include <math.h>

#include "check.h"
#include "fixtures.h"
#include "laws.h"
#include "slider.h"
#include "stops.h"
#include "tape_plane.h"

/* Branches of a fixture's saddle at its origin. */
static enum status branches_of(const struct planar *sys, double rtol,
                               struct branch b[2])
{
    struct grow_options o = grow_defaults(rtol);
    struct local_series u;
    struct equilibrium e;

    o.max_steps = 400;
    o.carry =
        (struct carry){ { FIXTURE_X_MOVED, FIXTURE_Y_MOVED, CARRY_TIME }, 3 };
    b[0].curve = b[1].curve = CURVE_EMPTY(5);
    equilibrium_at(sys, false, &e);
    assert_int_equal(e.type, EQUILIBRIUM_SADDLE);
    enum status s =
        local_at(sys, &e, MANIFOLD_STABLE, &o.carry, o.order, 0.01 * rtol, &u);
    if (s == STATUS_OK)
        s = grow_branches(sys, &u, &o, b);
    return s;
}

/* Distance from the exact manifold, first order: implicit over its gradient,
 * relative to the size of the numbers that make z. */
static double distance(const struct fixture *f, struct vec2 z)
{
    const double h = 1e-6 * (1.0 + fabs(z.x) + fabs(z.y));
    const double here = fixture_implicit(f, FIXTURE_STABLE, z);
    const struct vec2 e = { z.x + h, z.y }, w = { z.x - h, z.y };
    const struct vec2 n = { z.x, z.y + h }, s = { z.x, z.y - h };
    const double gx = (fixture_implicit(f, FIXTURE_STABLE, e) -
                       fixture_implicit(f, FIXTURE_STABLE, w)) /
                      (2.0 * h);
    const double gy = (fixture_implicit(f, FIXTURE_STABLE, n) -
                       fixture_implicit(f, FIXTURE_STABLE, s)) /
                      (2.0 * h);
    return here == 0.0 ? 0.0 : fabs(here) / hypot(gx, gy);
}

static bool nearby(struct vec2 u)
{
    return fabs(u.x) < 1.2 && fabs(u.y) < 3.0;
}

static void check_branch(const struct fixture *f, const struct branch *b,
                         double tol)
{
    double at[CURVE_DIM_MAX];

    for (size_t i = 0; i < b->curve.count; i++)
        for (int k = 0; k <= 4; k++) {
            curve_at(&b->curve, i, 0.25 * k, at);
            const struct vec2 z = { at[0], at[1] };
            const struct vec2 u = fixture_base_point(f, z);
            if (!nearby(u))
                return;
            const double size = 1.0 + fabs(z.x) + fabs(z.y);
            CHECK(distance(f, z) <= tol * size,
                  "base %d piece %zu of %zu, u = (%g, %g): distance %.3g",
                  (int) f->base, i, b->curve.count, u.x, u.y, distance(f, z));
            CHECK(fabs(at[2] - u.x) <= 100.0 * tol * size &&
                      fabs(at[3] - u.y) <= 100.0 * tol * size,
                  "integrals (%.15g, %.15g) instead of (%.15g, %.15g)", at[2],
                  at[3], u.x, u.y);
        }
}

static void check_fixture(const struct fixture *f, double rtol)
{
    const struct planar sys = fixture_planar(f);
    struct branch b[2];
    const enum status s = branches_of(&sys, rtol, b);

    CHECK(s == STATUS_OK, "base %d: %s", (int) f->base, status_text(s));
    for (int i = 0; i < 2; i++) {
        CHECK(b[i].curve.count > 1, "only %zu pieces", b[i].curve.count);
        check_branch(f, &b[i], 100.0 * rtol + 1e-13);
        branch_free(&b[i]);
        branch_free(&b[i]);
    }
}

static void systems_have_their_exact_manifolds(void **state)
{
    (void) state;
    fixture_each(400, check_fixture);
}

static void a_node_has_no_such_manifold(void **state)
{
    struct fixture f;
    struct local_series u;
    struct equilibrium e;
    const struct carry none = { .count = 0 };

    (void) state;
    fixture_plain(&f, FIXTURE_PITCHFORK);
    fixture_center(&f, f.equilibrium[1].base);
    const struct planar sys = fixture_planar(&f);
    equilibrium_at(&sys, false, &e);
    assert_int_equal(e.type, EQUILIBRIUM_STABLE_NODE);
    assert_int_equal(
        local_at(&sys, &e, MANIFOLD_UNSTABLE, &none, 20, 1e-14, &u),
        STATUS_NOT_HYPERBOLIC);
}

static void a_system_without_jets_is_refused(void **state)
{
    struct fixture f;
    struct local_series u;
    struct equilibrium e;
    const struct carry none = { .count = 0 };

    (void) state;
    fixture_plain(&f, FIXTURE_DUFFING);
    struct planar sys = fixture_planar(&f);
    equilibrium_at(&sys, false, &e);
    sys.jet = NULL;
    assert_int_equal(local_at(&sys, &e, MANIFOLD_STABLE, &none, 20, 1e-14, &u),
                     STATUS_BAD_ARGUMENT);
}

static void unstable_series_lie_on_the_exact_manifold(void **state)
{
    uint64_t rng = check_seed() + 1;
    const struct carry none = { .count = 0 };

    (void) state;
    for (int i = 0; i < 400; i++) {
        struct fixture f;
        struct local_series u;
        struct equilibrium e;
        fixture_random(&f, (enum fixture_base)(i % FIXTURE_BASES), &rng);
        const struct planar sys = fixture_planar(&f);
        equilibrium_at(&sys, false, &e);
        assert_int_equal(
            local_at(&sys, &e, MANIFOLD_UNSTABLE, &none, 20, 1e-14, &u),
            STATUS_OK);
        for (int k = -4; k <= 4; k++) {
            const double s = 0.25 * k * u.radius;
            const struct vec2 z = local_point(u.ind, s, jet_at(20, u.c, s));
            const double q = fixture_implicit(&f, FIXTURE_UNSTABLE, z);
            CHECK(fabs(q) <= 1e-11 * (1.0 + fabs(z.x) + fabs(z.y)),
                  "base %d at %g of %g: %.3g", (int) f.base, s, u.radius, q);
        }
    }
}

static void the_monitor_can_stop_a_long_branch(void **state)
{
    const struct monitor monitor = { stop_at_once, NULL };
    struct grow_options o = grow_defaults(1e-12);
    struct fixture f;
    struct local_series u;
    struct equilibrium e;
    struct branch b;

    (void) state;
    fixture_plain(&f, FIXTURE_DUFFING); /* a loop that never ends */
    const struct planar sys = fixture_planar(&f);
    o.monitor = &monitor;
    equilibrium_at(&sys, false, &e);
    assert_int_equal(
        local_at(&sys, &e, MANIFOLD_STABLE, &o.carry, o.order, 1e-14, &u),
        STATUS_OK);
    assert_int_equal(grow_branch(&sys, &u, 1, &o, &b), STATUS_STOPPED);
    assert_int_equal(b.curve.count, 0);
}

/* What grows side by side. */
struct company {
    struct slider slider[GROW_JOBS];
    struct local_series series[GROW_JOBS];
    struct grow_options options[GROW_JOBS];
    struct grow_job job[GROW_JOBS];
    struct branch together[GROW_JOBS][2];
};

/* A block of a law, a little beside the preset; i tells how. */
static void join(struct company *c, size_t i, uint64_t *rng)
{
    static const char *const law[] = { "spinodal_gen", "dieterich_gen" };
    struct slider *s = &c->slider[i];
    struct material m = { .mu_star = 0.369,
                          .a = 0.0349,
                          .b = 0.0489,
                          .c = 1e-3,
                          .R = 100.0,
                          .L = 0.9e-6,
                          .V_star = 1e-6,
                          .V_c = 1.0,
                          .g = 9.81 };

    m.a *= check_uniform(rng, 0.95, 1.05);
    m.b *= check_uniform(rng, 0.95, 1.05);
    slider_init(s, law_preset_find(law[i % 3 == 2]), &m,
                (long double) check_uniform(rng, 0.32, 0.36));
    assert_true(slider_has_manifolds(s));
    struct grow_options *o = &c->options[i];
    *o = grow_defaults(i % 5 == 4 ? 1e-7 : 1e-9);
    o->carry = (struct carry){ { BLOCK_EXCESS, CARRY_TIME }, 1 + i % 7 / 6 };
    assert_int_equal(local_at(&s->plane.system, phase_plane_saddle(&s->plane),
                              MANIFOLD_STABLE, &o->carry, o->order, 1e-11,
                              &c->series[i]),
                     STATUS_OK);
    c->job[i] = (struct grow_job){ .sys = &s->plane.system,
                                   .start = &c->series[i],
                                   .options = o,
                                   .out = c->together[i] };
}

static void check_same(const struct branch *a, const struct branch *b)
{
    const size_t n = a->curve.count, terms = a->curve.dim;

    assert_int_equal(n, b->curve.count);
    for (size_t i = 0; i < n; i++) {
        double u[CURVE_DIM_MAX], v[CURVE_DIM_MAX];
        curve_at(&a->curve, i, 0.7, u);
        curve_at(&b->curve, i, 0.7, v);
        assert_memory_equal(u, v, terms * sizeof *u);
    }
    assert_memory_equal(&a->limit, &b->limit, sizeof a->limit);
    assert_memory_equal(&a->error, &b->error, sizeof a->error);
    assert_memory_equal(a->total, b->total, sizeof a->total);
    assert_memory_equal(a->total_error, b->total_error, sizeof a->total_error);
    assert_int_equal(a->steps, b->steps);
    assert_int_equal(a->end, b->end);
}

static void company_changes_no_bit_at_any_width(void **state)
{
    static const struct planar_many *const many[] = { NULL,
#ifdef HAVE_WIDE_LANES
                                                      &tape_many_4, &tape_many_8
#endif
    };
    static struct company c;
    uint64_t rng = check_seed();

    (void) state;
    for (size_t w = 0; w < sizeof many / sizeof *many; w++) {
        if (many[w] && many[w]->width > jet_width())
            continue;
        for (size_t i = 0; i < GROW_JOBS; i++) {
            join(&c, i, &rng);
            c.slider[i].plane.system.many = many[w];
        }
        c.options[1].max_steps = 3;
        grow_jobs(c.job, GROW_JOBS);
        for (size_t i = 0; i < GROW_JOBS; i++) {
            struct branch alone[2];
            assert_int_equal(c.job[i].status, STATUS_OK);
            assert_int_equal(grow_branches(c.job[i].sys, c.job[i].start,
                                           c.job[i].options, alone),
                             STATUS_OK);
            for (int k = 0; k < 2; k++) {
                check_same(&alone[k], &c.together[i][k]);
                branch_free(&alone[k]);
                branch_free(&c.together[i][k]);
            }
        }
    }
}

static void a_branch_that_fails_takes_no_other_with_it(void **state)
{
    static struct company c;
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; i < 3; i++)
        join(&c, i, &rng);
    c.series[1].radius = c.series[1].c[1] = NAN;
    grow_jobs(c.job, 3);
    assert_int_equal(c.job[1].status, STATUS_NO_CONVERGENCE);
    for (int k = 0; k < 2; k++) {
        assert_int_equal(c.together[1][k].curve.count, 0);
        for (size_t i = 0; i < 3; i += 2) {
            assert_int_equal(c.job[i].status, STATUS_OK);
            assert_int_equal(c.together[i][k].end == BRANCH_STEPS, false);
            branch_free(&c.together[i][k]);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(systems_have_their_exact_manifolds),
        cmocka_unit_test(a_node_has_no_such_manifold),
        cmocka_unit_test(a_system_without_jets_is_refused),
        cmocka_unit_test(unstable_series_lie_on_the_exact_manifold),
        cmocka_unit_test(the_monitor_can_stop_a_long_branch),
        cmocka_unit_test(company_changes_no_bit_at_any_width),
        cmocka_unit_test(a_branch_that_fails_takes_no_other_with_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
