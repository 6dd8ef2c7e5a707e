/* Steps of quad_radau.h on z' = lambda z and on a stiff orbit onto a curve. */
#include "quad_radau.h"

#include <math.h>

#include "check.h"
#include "laws.h"

struct line {
    struct quad_method method;
    quad fast, slow; /* rates of z_0 onto the curve z_0 = z_1^2, and of z_1 */
};

static void plane(const void *ctx, const quad z[2], quad du[])
{
    const struct line *l = ctx;

    du[0] = l->fast * (z[1] * z[1] - z[0]) + 2 * l->slow * z[1] * z[1];
    du[1] = l->slow * z[1];
    du[2] = 1;
}

static void integrals(const void *ctx, const quad z[2], quad du[])
{
    (void) ctx;
    du[3] = z[1] * du[2];
    du[4] = z[0] * du[2];
}

static void linear(const void *ctx, const quad z[2], double du[2],
                   struct vec2 slope[2])
{
    const struct line *l = ctx;
    const double fast = (double) l->fast, slow = (double) l->slow;
    const double x = (double) z[0], y = (double) z[1];

    du[0] = fast * (y * y - x) + 2.0 * slow * y * y;
    du[1] = slow * y;
    slope[0] = (struct vec2){ -fast, 2.0 * (fast + 2.0 * slow) * y };
    slope[1] = (struct vec2){ 0.0, slow };
}

/* One step of length h from (from, 1); off: true errors of both, and of the
 * integral of z_1. */
static void take(double fast, double h, double bend, double from, quad off[3])
{
    static struct line l;
    const quad u[2] = { (quad) from, 1 };
    struct quad_radau w = { .h = (quad) h, .bend = (quad) bend };

    quad_method_init(&l.method);
    l.fast = (quad) fast;
    l.slow = -1;
    const struct quad_system system = { &l.method, plane, integrals, linear,
                                        &l };
    assert_true(quad_radau_solve(&w, &system, u, 1e-30));
    const quad t = quad_radau_gain(&w, 2, 1);
    const quad y = expq(-t), rest = ((quad) from - 1) * expq(-l.fast * t);
    off[0] = fabsq(u[0] + w.z[QUAD_STAGES - 1][0] - y * y - rest);
    off[1] = fabsq(1 + w.z[QUAD_STAGES - 1][1] - y);
    off[2] = fabsq(quad_radau_gain(&w, 3, 1) - (1 - y));
}

static void a_smooth_step_is_of_order_21(void **state)
{
    quad coarse[3], fine[3];

    (void) state;
    if (laws_emulated())
        skip();
    take(1.0, 1.0, 0.0, 1.5, coarse);
    take(1.0, 0.5, 0.0, 1.5, fine);
    for (int i = 0; i < 3; i++) {
        const double order = log2((double) (coarse[i] / fine[i])) - 1.0;
        CHECK(fabs(order - 21.0) < 1.5, "%d: %g", i, order);
        CHECK((double) coarse[i] < 1e-22, "%d: %g", i, (double) coarse[i]);
    }
}

static void a_clock_that_bends_leads_to_the_same_orbit(void **state)
{
    quad off[3];

    (void) state;
    if (laws_emulated())
        skip();
    take(1.0, 0.5, -1.0, 1.5, off);
    for (int i = 0; i < 3; i++)
        CHECK((double) off[i] < 1e-19, "%d: %g", i, (double) off[i]);
}

/* What is far faster than the step is damped, and the curve kept. */
static void a_stiff_step_stays_on_the_curve(void **state)
{
    quad off[3];

    (void) state;
    if (laws_emulated())
        skip();
    take(1e12, 0.3, 0.0, 1.0, off);
    CHECK((double) off[0] < 1e-22 && (double) off[1] < 1e-22, "%g %g",
          (double) off[0], (double) off[1]);
    take(1e12, 0.3, 0.0, 1.0 + 1e-6, off);
    CHECK((double) off[0] < 1e-15, "%g", (double) off[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_smooth_step_is_of_order_21),
        cmocka_unit_test(a_clock_that_bends_leads_to_the_same_orbit),
        cmocka_unit_test(a_stiff_step_stays_on_the_curve),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
