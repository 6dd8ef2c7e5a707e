/* Traps: of random systems and forms, V rises along every orbit in those that
 * are proved, and a box is in one only if it is. */
#include "proof_trap.h"

#include "made_tube.h"

enum { DRAWS = 3000, POINTS = 60 };

struct drawn {
    double m[4], cube[2]; /* x' = m0 x + m1 y + cube0 x^3, y' likewise */
    struct proof_trap trap;
};

static double form(const struct proof_trap *t, double x, double y)
{
    return t->xx * x * x + 2 * t->xy * x * y + t->yy * y * y;
}

/* dV/dt over 2 V. */
static double rise(const struct drawn *d, double x, double y)
{
    const struct proof_trap *t = &d->trap;
    const double fx = d->m[0] * x + d->m[1] * y + d->cube[0] * x * x * x;
    const double fy = d->m[2] * x + d->m[3] * y + d->cube[1] * y * y * y;

    return ((t->xx * x + t->xy * y) * fx + (t->xy * x + t->yy * y) * fy) /
           form(t, x, y);
}

/* Forms near those of which the conditions are equalities. */
static void draw_one(struct drawn *d, uint64_t *rng)
{
    for (int i = 0; i < 4; i++)
        d->m[i] = check_uniform(rng, -1, 1) + (i % 3 == 0 ? 0.6 : 0);
    for (int i = 0; i < 2; i++)
        d->cube[i] = perhaps(rng, -1, 1);
    d->trap =
        (struct proof_trap){ .xx = check_uniform(rng, -0.2, 1),
                             .yy = check_uniform(rng, -0.2, 1),
                             .level = pow(10, check_uniform(rng, -3, 1)) };
    d->trap.xy =
        check_uniform(rng, -1.1, 1.1) * sqrt(fabs(d->trap.xx * d->trap.yy));
}

static bool verify(const struct drawn *d, struct proof_trap *trap)
{
    static struct interval_graph g;
    static struct interval_tape tape;
    char rate[2][120];

    for (int i = 0; i < 2; i++)
        snprintf(rate[i], sizeof rate[i], "(%.17g)*x + (%.17g)*y + (%.17g)*%s",
                 d->m[2 * i], d->m[2 * i + 1], d->cube[i],
                 i ? "y*y*y" : "x*x*x");
    tape_about_0((const char *[]){ rate[0], rate[1] }, "x", true, &g, &tape);
    const bool found = proof_trap_verify(&tape, trap);
    interval_tape_free(&tape);
    interval_graph_free(&g);
    return found;
}

static void v_rises_all_over_a_trap(void **state)
{
    uint64_t rng = check_seed();
    double least = HUGE_VAL;
    int proved = 0;

    (void) state;
    for (int n = 0; n < DRAWS; n++) {
        struct drawn d;
        draw_one(&d, &rng);
        if (!verify(&d, &d.trap))
            continue;
        const struct proof_trap *t = &d.trap;
        CHECK(t->xx > 0 && t->xx * t->yy > t->xy * t->xy, "draw %d: %g %g %g",
              n, t->xx, t->xy, t->yy);
        for (int k = 0; k < 2 * POINTS; k++) {
            const double at = k * acos(-1) / POINTS;
            const double scale = sqrt(t->level / form(t, cos(at), sin(at)));
            const double far = k % 2 ? scale : 1e-6 * scale;
            const double up = rise(&d, far * cos(at), far * sin(at));
            CHECK(up > 0, "draw %d: %g at %g of %g", n, up, at, far);
            least = fmin(least, up);
        }
        proved++;
    }
    print_message("# %d of %d are proved, V rises by %g at least\n", proved,
                  DRAWS, least);
    CHECK(proved > DRAWS / 20, "%d", proved);
}

static void a_box_is_in_a_trap_only_if_all_of_it_is(void **state)
{
    uint64_t rng = check_seed();
    int held = 0;

    (void) state;
    for (int n = 0; n < DRAWS; n++) {
        struct drawn d;
        double z[2], half[2];
        draw_one(&d, &rng);
        struct proof_trap *t = &d.trap;
        t->at[0] = t->at[1] = interval_point(1);
        for (int i = 0; i < 2; i++) {
            z[i] = check_uniform(&rng, -1, 3);
            half[i] = check_uniform(&rng, 0, 1);
        }
        const struct interval box[] = { { z[0] - half[0], z[0] + half[0] },
                                        { z[1] - half[1], z[1] + half[1] } };
        const bool in = proof_trap_holds(t, box);
        for (int k = 0; k < 4 && in; k++)
            CHECK(form(t, z[0] + (k % 2 ? half[0] : -half[0]) - 1,
                       z[1] + (k / 2 ? half[1] : -half[1]) - 1) <=
                      t->level * (1 + 1e-12),
                  "draw %d", n);
        held += in;
    }
    CHECK(held > DRAWS / 20, "%d", held);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(v_rises_all_over_a_trap),
        cmocka_unit_test(a_box_is_in_a_trap_only_if_all_of_it_is),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
