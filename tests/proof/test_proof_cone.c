/* Cones and saddles, on fields whose branches are known. */
#include "proof_cone.h"

#include "made_tube.h"

enum { DRAWS = 800 };

/* w and the integral at theta = at, near 0. */
static void begin(const struct made *f, double at, long double u[2])
{
    const double slope = f->A[0] / (f->E[0] - f->L[0]);

    u[0] = slope * at;
    u[1] =
        at * (f->obs[0] + f->obs_across * (f->piece.coef[1] + slope)) / f->E[0];
}

static void check_cone(const struct made *f, const struct proof_cone *c,
                       const struct proof_front *front, struct tally *t, int n)
{
    enum { PARTS = 20, BEGIN = 10 };
    const int steps = 3 + (int) (3 - 3 * f->L[0]);
    double at = ldexp(c->reach, -BEGIN * 2);
    long double u[2];

    begin(f, at, u);
    for (int k = 1; k <= PARTS + BEGIN; k++) {
        const double to = k <= BEGIN
                              ? ldexp(c->reach, 2 * (k - 1 - BEGIN))
                              : c->reach / 4 * (1 + 3. * (k - BEGIN) / PARTS);
        follow(f, at, to, k <= BEGIN ? 8 * steps : steps, u);
        at = to;
        t->nearest =
            fmax(t->nearest, part_of("slope", f, u[0] / at, c->slope, n));
    }
    part_of("error", f, u[0], front->error, n);
    check_integral(f, u[1], c->excess, n);
    check_integral(f, u[1], front->excess, n);
}

static void a_cone_holds_the_branch_and_its_integral(void **state)
{
    uint64_t rng = check_seed();
    struct tally t = { 0 };
    static struct interval_graph g;
    static struct interval_tape tape;

    (void) state;
    for (int n = 0; n < DRAWS; n++) {
        struct made f;
        struct proof_cone cone;
        struct proof_front front;
        draw(&f, true, &rng);
        const bool away = check_bits(&rng) % 8 == 0;
        f.E[0] = away ? -1 : 1;
        tape_of(&f, &g, &tape);
        const bool proved = proof_cone(&tape, &f.piece, 1, &cone, &front);
        CHECK(!proved || !away, "draw %d: it leads away", n);
        if (proved)
            check_cone(&f, &cone, &front, &t, n);
        t.proved += proved;
        interval_tape_free(&tape);
        interval_graph_free(&g);
    }
    print_message("# %d of %d are proved, w up to %g of its bound\n", t.proved,
                  DRAWS, t.nearest);
    CHECK(t.proved > DRAWS / 4 && t.nearest > 0.5, "%d, %g", t.proved,
          t.nearest);
}

static void a_piece_that_begins_beside_the_saddle_has_none(void **state)
{
    static struct interval_graph g;
    static struct interval_tape tape;
    struct made f = { .cone = true, .E = { 1 }, .L = { -1 }, .obs = { 1 } };
    struct proof_cone cone;
    struct proof_front front;

    (void) state;
    f.piece = (struct proof_piece){ .step = 1, .degree = 2, .coef = { 0, 1 } };
    tape_of(&f, &g, &tape);
    for (int i = 0; i < 3; i++) {
        struct proof_piece p = f.piece;
        p.start = i == 1 ? 1e-6 : 0;
        p.coef[0] = i == 2 ? 1e-6 : 0;
        assert_int_equal(proof_cone(&tape, &p, 1, &cone, &front), i == 0);
    }
    interval_tape_free(&tape);
    interval_graph_free(&g);
}

/* ---- saddles ------------------------------------------------------------- */

/* x' = a x + b y, y' = c x + d y */
static void a_saddle_is_told_by_its_eigenvalues(void **state)
{
    static struct interval_graph g;
    static struct interval_tape tape;
    uint64_t rng = check_seed();
    int saddles = 0;

    (void) state;
    for (int n = 0; n < DRAWS; n++) {
        double m[4];
        char rate[2][100];
        struct proof_saddle s;
        for (int i = 0; i < 4; i++)
            m[i] = check_uniform(&rng, -1, 1) * (n % 2 ? 1 : pow(10, -3 * i));
        for (int i = 0; i < 2; i++)
            snprintf(rate[i], sizeof rate[i], "(%.17g)*x + (%.17g)*y", m[2 * i],
                     m[2 * i + 1]);
        tape_about_0((const char *[]){ rate[0], rate[1] }, "x", true, &g,
                     &tape);
        const double half = (m[0] + m[3]) / 2, det = m[0] * m[3] - m[1] * m[2];
        const double root = sqrt(fmax(half * half - det, 0));
        if (proof_is_saddle(&tape, &s)) {
            const double minus = half - root, plus = half + root;
            CHECK(det < 0 && s.lambda_minus.lo < minus + 1e-14 &&
                      minus - 1e-14 < s.lambda_minus.hi &&
                      s.lambda_plus.lo < plus + 1e-14 &&
                      plus - 1e-14 < s.lambda_plus.hi,
                  "draw %d: %g %g %g %g", n, m[0], m[1], m[2], m[3]);
            CHECK(s.lambda_minus.hi - s.lambda_minus.lo <
                          -1e-12L * s.lambda_minus.hi &&
                      s.lambda_plus.hi - s.lambda_plus.lo <
                          1e-12L * s.lambda_plus.lo,
                  "draw %d: [%.20Lg, %.20Lg]", n, s.lambda_minus.lo,
                  s.lambda_minus.hi);
            saddles++;
        } else {
            CHECK(det > -1e-12 || half > 0, "draw %d: det %g", n, det);
        }
        interval_tape_free(&tape);
        interval_graph_free(&g);
    }
    CHECK(saddles > DRAWS / 8, "%d", saddles);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cone_holds_the_branch_and_its_integral),
        cmocka_unit_test(a_piece_that_begins_beside_the_saddle_has_none),
        cmocka_unit_test(a_saddle_is_told_by_its_eigenvalues),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
