#include "fixtures.h"

#include <float.h>
#include <math.h>

#include "check.h"

enum { ROUNDS = 40 };

/* Runs a check on every base system: plain, then under random shears. */
static void for_each(void (*check)(struct fixture *f, uint64_t *rng))
{
    uint64_t rng = check_seed();
    struct fixture f;

    for (int base = 0; base < FIXTURE_BASES; base++) {
        fixture_plain(&f, (enum fixture_base) base);
        check(&f, &rng);
        for (int i = 0; i < ROUNDS; i++) {
            fixture_random(&f, (enum fixture_base) base, &rng);
            check(&f, &rng);
        }
    }
}

/* A base point with |X|, |Y| < 1.5, as an offset. */
static struct vec2 random_offset(const struct fixture *f, uint64_t *rng)
{
    const struct vec2 u = { check_uniform(rng, -1.5, 1.5),
                            check_uniform(rng, -1.5, 1.5) };
    return fixture_offset(f, u);
}

static struct vec2 field_at(const struct planar *sys, struct vec2 z)
{
    struct planar_field f;

    sys->field(sys->ctx, z, &f);
    return vec2_scale(exp(f.log_scale), f.direction);
}

static struct mat2 slope_at(const struct planar *sys, struct vec2 z)
{
    struct planar_jacobian J;

    sys->jacobian(sys->ctx, z, &J);
    const double e = exp(J.field.log_scale);
    return (struct mat2){ e * J.matrix.xx, e * J.matrix.xy, e * J.matrix.yx,
                          e * J.matrix.yy };
}

static double mat2_size(struct mat2 A)
{
    return hypot(hypot(A.xx, A.xy), hypot(A.yx, A.yy));
}

static void check_shear_undone(struct fixture *f, uint64_t *rng)
{
    for (size_t i = 0; i < f->shears; i++) {
        const struct vec2 u = { check_uniform(rng, -2, 2),
                                check_uniform(rng, -2, 2) };
        const struct vec2 z = shear_apply(&f->shear[i], u);
        const struct vec2 d = vec2_sub(shear_undo(&f->shear[i], z), u);

        CHECK(vec2_length(d) <= 4 * DBL_EPSILON * (1 + vec2_length(z)),
              "off by %g", vec2_length(d));
        CHECK(vec2_length(vec2_sub(z, u)) > 0, "the shear moves nothing");
    }
}

static void shears_are_undone(void **state)
{
    (void) state;
    for_each(check_shear_undone);
}

static void check_equilibria(struct fixture *f, uint64_t *rng)
{
    (void) rng;
    for (size_t i = 0; i < f->equilibria; i++) {
        const struct fixture_equilibrium *e = &f->equilibrium[i];
        fixture_center(f, e->base);
        const struct planar sys = fixture_planar(f);
        const struct vec2 v = field_at(&sys, (struct vec2){ 0, 0 });
        const struct eigen2 got =
            mat2_eigenvalues(slope_at(&sys, (struct vec2){ 0, 0 }));
        const double size = hypot(e->lambda.re[0], e->lambda.im);
        const double miss = fabs(got.re[0] - e->lambda.re[0]) +
                            fabs(got.re[1] - e->lambda.re[1]) +
                            fabs(got.im - e->lambda.im);

        CHECK(v.x == 0 && v.y == 0, "%s %zu: field %g, %g", sys.name, i, v.x,
              v.y);
        CHECK(sys.origin.x == e->z.x && sys.origin.y == e->z.y, "origin");
        CHECK(miss <= 1e-9 * size, "%s %zu: eigenvalues off by %g", sys.name, i,
              miss / size);
    }
}

static void field_vanishes_at_equilibria_with_the_stated_eigenvalues(void **s)
{
    (void) s;
    for_each(check_equilibria);
}

/* (f(z + h) - f(z - h)) / 2h, extrapolated from h and h/2: O(h^4). */
static struct vec2 difference(const struct planar *sys, struct vec2 z,
                              struct vec2 unit)
{
    struct vec2 d[2];

    for (int i = 0; i < 2; i++) {
        const double h = 1e-3 / (1 + i);
        const struct vec2 step = vec2_scale(h, unit);
        d[i] = vec2_scale(0.5 / h, vec2_sub(field_at(sys, vec2_add(z, step)),
                                            field_at(sys, vec2_sub(z, step))));
    }
    return vec2_add(d[1], vec2_scale(1.0 / 3.0, vec2_sub(d[1], d[0])));
}

static void check_jacobian(struct fixture *f, uint64_t *rng)
{
    const struct planar sys = fixture_planar(f);
    const struct vec2 z = random_offset(f, rng);
    const struct mat2 J = slope_at(&sys, z);
    const struct vec2 dx = difference(&sys, z, (struct vec2){ 1, 0 });
    const struct vec2 dy = difference(&sys, z, (struct vec2){ 0, 1 });
    const struct mat2 miss = { J.xx - dx.x, J.xy - dy.x, J.yx - dx.y,
                               J.yy - dy.y };

    CHECK(mat2_size(miss) <= 1e-7 * mat2_size(J), "%s: off by %g", sys.name,
          mat2_size(miss) / mat2_size(J));
}

static void jacobian_agrees_with_differences(void **state)
{
    (void) state;
    for_each(check_jacobian);
}

enum { ORDER = 24 };

/* The field's series along a random quadratic curve through a random point. */
struct series {
    double x[JET_SIZE], y[JET_SIZE], fx[JET_SIZE], fy[JET_SIZE];
    double rate[FIXTURE_OBSERVABLES][JET_SIZE];
    double log_scale;
};

/* Of the curve in t, which goes into one lane; a straight line from the same
 * point into the other. */
static void series_expand(struct series *t, const struct planar *sys, size_t i)
{
    static jet_pair x[JET_SIZE], y[JET_SIZE], fx[JET_SIZE], fy[JET_SIZE];
    static jet_pair rate[FIXTURE_OBSERVABLES][JET_SIZE];
    static struct jet_work work;

    for (size_t k = 0; k <= ORDER; k++) {
        x[k] = y[k] = JET_PAIR(k == 1 ? 0.5 : 0.0);
        x[k][i] = t->x[k];
        y[k][i] = t->y[k];
        if (k == 0)
            x[0] = JET_PAIR(t->x[0]), y[0] = JET_PAIR(t->y[0]);
        sys->jet(sys->ctx, &work, k, x, y, fx, fy);
        for (size_t j = 0; j < FIXTURE_OBSERVABLES; j++)
            sys->rate_jet(sys->ctx, j, &work, k, x, y, rate[j]);
    }
    jet_take(ORDER, fx, i, t->fx);
    jet_take(ORDER, fy, i, t->fy);
    for (size_t j = 0; j < FIXTURE_OBSERVABLES; j++)
        jet_take(ORDER, rate[j], i, t->rate[j]);
    t->log_scale = work.log_scale[i];
}

static void series_fill(struct series *t, const struct planar *sys,
                        struct vec2 z, uint64_t *rng)
{
    *t = (struct series){ .x = { z.x }, .y = { z.y } };
    for (size_t k = 1; k <= 2; k++) {
        t->x[k] = check_uniform(rng, -1, 1);
        t->y[k] = check_uniform(rng, -1, 1);
    }
    series_expand(t, sys, check_uniform(rng, -1, 1) > 0.0);
}

static void check_first_order(struct fixture *f, uint64_t *rng)
{
    const struct planar sys = fixture_planar(f);
    const struct vec2 z = random_offset(f, rng);
    struct series t;
    struct planar_jacobian J;

    series_fill(&t, &sys, z, rng);
    sys.jacobian(sys.ctx, z, &J);
    const struct mat2 A = J.matrix;
    const double mx = t.fx[1] - A.xx * t.x[1] - A.xy * t.y[1];
    const double my = t.fy[1] - A.yx * t.x[1] - A.yy * t.y[1];

    CHECK(t.log_scale == J.field.log_scale, "%s: scales", sys.name);
    CHECK(hypot(t.fx[0] - J.field.direction.x, t.fy[0] - J.field.direction.y) <=
              1e-13 * mat2_size(A),
          "%s: order 0", sys.name);
    CHECK(hypot(mx, my) <= 1e-13 * mat2_size(A), "%s: off by %g", sys.name,
          hypot(mx, my) / mat2_size(A));
}

static void jacobian_agrees_with_the_jets_first_order(void **state)
{
    (void) state;
    for_each(check_first_order);
}

static void check_series(struct fixture *f, uint64_t *rng)
{
    const struct planar sys = fixture_planar(f);
    const double s = check_uniform(rng, -0.1, 0.1);
    struct series t;

    series_fill(&t, &sys, random_offset(f, rng), rng);
    const double scale = exp(t.log_scale);
    const struct vec2 z = { jet_at(2, t.x, s), jet_at(2, t.y, s) };
    const struct vec2 v = field_at(&sys, z);
    const double size =
        scale * fabs(t.fx[0]) + scale * fabs(t.fy[0]) + fabs(v.x) + fabs(v.y);
    const double miss = hypot(scale * jet_at(ORDER, t.fx, s) - v.x,
                              scale * jet_at(ORDER, t.fy, s) - v.y);

    CHECK(miss <= 1e-12 * size, "%s: field off by %g at %g", sys.name,
          miss / size, s);
    for (size_t i = 0; i < FIXTURE_OBSERVABLES; i++) {
        double rate;
        struct vec2 unused;
        sys.rate_gradient(sys.ctx, i, z, &rate, &unused);
        const double off = scale * jet_at(ORDER, t.rate[i], s) - rate;
        CHECK(fabs(off) <= 1e-12 * (size + fabs(rate)), "%s: %s off by %g",
              sys.name, sys.observables[i].name, off);
    }
}

static void jets_agree_with_the_field_and_rates_along_curves(void **state)
{
    (void) state;
    for_each(check_series);
}

/* Also the chain rule: a displacement's rate is grad(displacement) . field,
 * with the displacement known. */
static void check_rates(struct fixture *f, uint64_t *rng)
{
    const struct planar sys = fixture_planar(f);
    const struct vec2 z = random_offset(f, rng), v = field_at(&sys, z);
    const double h = 1e-4, speed = vec2_length(v) + exp(f->log_rate);
    const struct vec2 step = vec2_scale(h / speed, v);
    const struct vec2 moved =
        vec2_sub(fixture_base_point(f, vec2_add(z, step)),
                 fixture_base_point(f, vec2_sub(z, step)));
    const double expected[] = { moved.x * speed / (2 * h),
                                moved.y * speed / (2 * h), exp(f->log_rate) };

    for (size_t i = 0; i < sys.observable_count; i++) {
        double rate, ahead, behind;
        struct vec2 g, unused;
        sys.rate_gradient(sys.ctx, i, z, &rate, &g);
        sys.rate_gradient(sys.ctx, i, vec2_add(z, step), &ahead, &unused);
        sys.rate_gradient(sys.ctx, i, vec2_sub(z, step), &behind, &unused);
        const double slope = (g.x * step.x + g.y * step.y) / h;
        const double size = mat2_size(slope_at(&sys, z)) + speed;
        CHECK(fabs(rate - expected[i]) <= 1e-5 * size, "%s: rate %zu, %g",
              sys.name, i, rate - expected[i]);
        CHECK(fabs((ahead - behind) / (2 * h) - slope) <= 1e-5 * size,
              "%s: gradient %zu, %g", sys.name, i, slope);
    }
}

static void rates_are_those_of_the_stated_displacements(void **state)
{
    (void) state;
    for_each(check_rates);
}

/* Sine of the angle between the field and the manifold's tangent, and whether
 * the field points away from the saddle. */
static void check_invariance(const struct fixture *f,
                             enum fixture_manifold kind, double s)
{
    const struct planar sys = fixture_planar(f);
    const double h = 1e-4 * s, toward = kind == FIXTURE_STABLE ? -1.0 : 1.0;
    const struct vec2 z = fixture_manifold_at(f, kind, s);
    const struct vec2 t = vec2_sub(fixture_manifold_at(f, kind, s + h),
                                   fixture_manifold_at(f, kind, s - h));
    const struct vec2 v = field_at(&sys, z);
    const struct vec2 step = vec2_scale(1e-4 / vec2_length(v), v);
    const double size = vec2_length(t) * vec2_length(v);
    const double across = (t.x * v.y - t.y * v.x) / size;
    const double along = (t.x * v.x + t.y * v.y) / size;
    const double drift = fixture_implicit(f, kind, vec2_add(z, step)) -
                         fixture_implicit(f, kind, vec2_sub(z, step));

    CHECK(fabs(fixture_implicit(f, kind, z)) <= 1e-12, "%s: not on it: %g",
          sys.name, fixture_implicit(f, kind, z));
    CHECK(fabs(across) <= 1e-6, "%s: field leaves it: %g", sys.name, across);
    CHECK(toward * along > 0.999, "%s: wrong way: %g", sys.name, along);
    CHECK(fabs(drift) <= 1e-6 * 2e-4, "%s: drifts off: %g", sys.name, drift);
}

static void check_manifolds(struct fixture *f, uint64_t *rng)
{
    const enum fixture_manifold kinds[] = { FIXTURE_STABLE, FIXTURE_UNSTABLE };

    for (int i = 0; i < 2; i++) {
        const double reach = fmin(fixture_reach(f, kinds[i]), 2.0);
        const double s = check_uniform(rng, 0.1, 0.9) * reach;
        check_invariance(f, kinds[i], s);
        check_invariance(f, kinds[i], -s);
    }
}

static void manifolds_are_invariant(void **state)
{
    (void) state;
    for_each(check_manifolds);
}

static void check_implicit(struct fixture *f, uint64_t *rng)
{
    const struct vec2 u = { check_uniform(rng, -1.4, 1.4),
                            check_uniform(rng, -1.4, 1.4) };
    const struct vec2 z = fixture_offset(f, u);

    if (f->base != FIXTURE_PITCHFORK)
        return;
    CHECK((fixture_implicit(f, FIXTURE_STABLE, z) > 0) == (u.x > 0), "%g", u.x);
    CHECK((fixture_implicit(f, FIXTURE_UNSTABLE, z) > 0) == (u.y > 0), "%g",
          u.y);
}

static void implicit_function_tells_the_sides_of_the_pitchfork(void **state)
{
    (void) state;
    for_each(check_implicit);
}

/* The same absolute point seen from two origins. */
static void check_origins(struct fixture *f, uint64_t *rng)
{
    const struct vec2 u = { check_uniform(rng, -1, 1),
                            check_uniform(rng, -1, 1) };
    struct fixture g = *f;

    f->tilt = (struct vec2){ 0.0, 0.0 };
    fixture_center(&g, (struct vec2){ check_uniform(rng, -1, 1),
                                      check_uniform(rng, -1, 1) });
    const struct planar a = fixture_planar(f), b = fixture_planar(&g);
    const struct vec2 za = fixture_offset(f, u), zb = fixture_offset(&g, u);
    const struct vec2 d =
        vec2_sub(vec2_add(a.origin, za), vec2_add(b.origin, zb));
    const struct vec2 va = field_at(&a, za), vb = field_at(&b, zb);
    const double size = vec2_length(va) + mat2_size(slope_at(&a, za));

    CHECK(vec2_length(d) <= 1e-13 * (1 + vec2_length(za)), "%s: %g", a.name,
          vec2_length(d));
    CHECK(vec2_length(vec2_sub(va, vb)) <= 1e-12 * size, "%s: %g", a.name,
          vec2_length(vec2_sub(va, vb)) / size);
}

static void field_does_not_depend_on_origin_or_tilt(void **state)
{
    (void) state;
    for_each(check_origins);
}

/* Only vertical shears keep it a graph over x. */
static void check_steady(struct fixture *f, uint64_t *rng)
{
    (void) rng;
    for (size_t i = 0; i < f->shears; i++)
        f->shear[i].vertical = true;
    fixture_center(f, f->centre);
    const struct planar sys = fixture_planar(f);
    const struct planar_steady *s = sys.steady;

    CHECK(s != NULL, "%s: no steady curve", sys.name);
    for (size_t i = 0; i < f->equilibria; i++) {
        const struct vec2 z = f->equilibrium[i].z;
        const double y = (double) s->y(sys.ctx, (long double) z.x);
        const double b = (double) s->balance(sys.ctx, (long double) z.x);
        CHECK(fabs(b) <= 1e-15, "%s %zu: balance %g", sys.name, i, b);
        CHECK(fabs(y - z.y) <= 1e-14 * (1 + fabs(y)), "%s %zu: y %g", sys.name,
              i, y - z.y);
    }
    for (size_t i = 0; i < s->turnings; i++) {
        const long double x = s->turning[i], h = 1e-3L;
        const double left =
            (double) (s->balance(sys.ctx, x) - s->balance(sys.ctx, x - h));
        const double right =
            (double) (s->balance(sys.ctx, x + h) - s->balance(sys.ctx, x));
        CHECK(left * right < 0, "%s: turning %zu does not turn", sys.name, i);
    }
}

static void steady_curve_carries_the_equilibria(void **state)
{
    (void) state;
    for_each(check_steady);
}

static void horizontal_shears_leave_no_steady_curve(void **state)
{
    uint64_t rng = check_seed();
    struct fixture f;

    (void) state;
    fixture_random(&f, FIXTURE_DUFFING, &rng);
    assert_null(fixture_planar(&f).steady);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shears_are_undone),
        cmocka_unit_test(
            field_vanishes_at_equilibria_with_the_stated_eigenvalues),
        cmocka_unit_test(jacobian_agrees_with_differences),
        cmocka_unit_test(jacobian_agrees_with_the_jets_first_order),
        cmocka_unit_test(jets_agree_with_the_field_and_rates_along_curves),
        cmocka_unit_test(rates_are_those_of_the_stated_displacements),
        cmocka_unit_test(manifolds_are_invariant),
        cmocka_unit_test(implicit_function_tells_the_sides_of_the_pitchfork),
        cmocka_unit_test(field_does_not_depend_on_origin_or_tilt),
        cmocka_unit_test(steady_curve_carries_the_equilibria),
        cmocka_unit_test(horizontal_shears_leave_no_steady_curve),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
