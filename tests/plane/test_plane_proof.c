/* What is proved of the branches of systems of formulas holds their closed
 * forms, and nothing wrong is proved along curves that are wrong on purpose. */
#include "plane_proof.h"

#include <math.h>

#include "formulas.h"
#include "proof_plane.h"
#include "proof_short.h"
#include "spoiled.h"

#define TEST(test)                                                             \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)
#define MORE "products=[manifolds]\naccuracy.proved=true\n"

/* ---- closed forms -------------------------------------------------------- */

/* A branch is where g(x, y) = 0. */
typedef long double closed_form(const void *ctx, long double x, long double y);

struct known {
    const char *ode, *more;
    closed_form *g;
    unsigned kinds; /* bits: stable, unstable */
    int crosses, trapped;
    double width;
};

static long double pendulum(const void *ctx, long double x, long double y)
{
    const long double c = 2 * cosl(x / 2);

    (void) ctx;
    return y * y - c * c;
}

static long double nagumo(const void *ctx, long double u, long double v)
{
    (void) ctx;
    return v * sqrtl(2) - u * (1 - u);
}

static long double diagonal(const void *ctx, long double x, long double y)
{
    (void) ctx;
    return x - y;
}

static long double twice(const void *ctx, long double x, long double y)
{
    (void) ctx;
    return y - 2 * x;
}

static long double axis(const void *ctx, long double x, long double y)
{
    (void) ctx;
    return x * y;
}

/* y = x - 0.1, where x is 1e-7 beside 0.1 as decimals. */
static long double beside(const void *ctx, long double x, long double y)
{
    return ctx ? x : fabsl(y) - 1e-7L;
}

/* v^2 = u^2 - u^3 2/3 + C: a saddle-node's homoclinic loop, outside of it. */
static long double fish(const void *ctx, long double x, long double y)
{
    (void) ctx;
    return y * y - x * x * (1 + 2 * x / 3);
}

static const struct proved *of(const struct quantity *q)
{
    assert_non_null(q->proved);
    return q->proved;
}

/* What is proved of a crossing holds a zero of g: it changes its sign. */
static void holds(const struct plane_branch *b, closed_form *g, const void *ctx,
                  double width, const char *what)
{
    const int edge = b->edge / 2;
    const struct proved *at = of(&b->leaves[edge]);
    const struct proved *p = of(&b->leaves[1 - edge]);
    const long double line = ((long double) at->lo + at->hi) / 2;
    const long double lo =
        edge == 0 ? g(ctx, line, p->lo) : g(ctx, p->lo, line);
    const long double hi =
        edge == 0 ? g(ctx, line, p->hi) : g(ctx, p->hi, line);

    CHECK((lo <= 0) != (hi < 0), "%s: [%.17g, %.17g] at %.17g: %Lg %Lg", what,
          p->lo, p->hi, at->lo, lo, hi);
    CHECK(p->hi - p->lo <= width * fmax(1, fabs(p->hi)), "%s: %g wide", what,
          p->hi - p->lo);
}

static void check_known(const struct known *k)
{
    struct plane_study s;
    struct scene c;
    int crosses = 0, trapped = 0;

    plane_run(&s, &c, k->ode, k->more);
    CHECK(s.proof.lie.text[0] == '\0', "%s: %s", k->ode, s.proof.lie.text);
    for (size_t i = 0; i < s.branches; i++) {
        const struct plane_branch *b = &s.branch[i];
        crosses += b->end_proved == PLANE_CROSSES;
        trapped += b->end_proved == PLANE_TRAPPED;
        if (b->end_proved == PLANE_CROSSES && k->kinds & 1u << b->kind)
            holds(b, k->g, NULL, k->width, k->ode);
    }
    CHECK(crosses == k->crosses && trapped == k->trapped,
          "%s: %d cross, %d are trapped", k->ode, crosses, trapped);
    plane_end(&s, &c);
}

enum {
    OF_STABLE = 1u << MANIFOLD_STABLE,
    OF_UNSTABLE = 1u << MANIFOLD_UNSTABLE
};

static void closed_forms_are_in_what_is_proved(void **state)
{
    static const struct known known[] = {
        { "x' = y; y' = -sin(x)", "window={x: [-4, 1], y: [-3, 3]}\n" MORE,
          pendulum, OF_STABLE | OF_UNSTABLE, 4, 0, 1e-13 },
        { "u' = v; v' = (1 - 2*a)/sqrt(2)*v - u*(1 - u)*(u - a); a = 0.25",
          "window={u: [-0.2, 0.2], v: [-0.5, 0.5]}\n" MORE, nagumo, OF_UNSTABLE,
          4, 0, 1e-13 },
        { "x' = x; y' = -y", "window={x: [-1, 1], y: [-2, 2]}\n" MORE, axis,
          OF_STABLE | OF_UNSTABLE, 4, 0, 1e-300 },
        { "x' = x - 0.1; y' = 3*(x - 0.1) - 2*y",
          "window={x: [0.0999999, 0.1000001], y: [-1, 1]}\n" MORE, beside,
          OF_UNSTABLE, 4, 0, 1e-19 },
        { "x' = y; y' = x + x^2", "window={x: [-0.5, 1], y: [-1, 1]}\n" MORE,
          fish, OF_STABLE | OF_UNSTABLE, 2, 0, 1e-13 },
        { "x' = y; y' = x - x^3 - 0.1*y",
          "window={x: [-2, 2], y: [-2, 2]}\n" MORE, axis, 0, 2, 2, 1 },
        { "x' = 4/(1 + y^2) - x; y' = 4/(1 + x^2) - y",
          "system.state={x: positive, y: positive}\n"
          "window={x: [0.05, 10], y: [0.05, 10]}\n" MORE,
          diagonal, OF_STABLE, 2, 2, 1e-11 },
        { "x' = x*(1 - x - 1.5*y); y' = y*(1 - y - 2*x)",
          "system.state={x: positive, y: positive}\n"
          "window={x: [0.01, 3], y: [0.01, 3]}\n" MORE,
          twice, OF_STABLE, 4, 0, 1e-12 },
        { "x' = x*(1 - x - 1.5*y); y' = y*(1 - y - 2*x)",
          "window={x: [-0.1, 3], y: [-0.1, 3]}\n" MORE, twice, OF_STABLE, 1, 3,
          1e-12 },
        { "x' = y; y' = -sin(x) - 0.3*y",
          "system.state={x: angle, y: real}\n"
          "window={x: [-4, 2.25], y: [-3, 3]}\n" MORE,
          axis, 0, 2, 2, 1 },
        { "v' = v - v^3/3 - w; w' = 0.5*(v + 0.1 - 2*w)",
          "window={v: [-3, 3], w: [-2, 2]}\n" MORE, axis, 0, 2, 2, 1 },
    };

    (void) state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        check_known(&known[i]);
}

/* ---- random shears ------------------------------------------------------- */

/* y = Y + p X + r X^2, then x = X + q y + t y^2, of X' = X - X^3 and Y' = Y -
 * Y^3 (or -b Y): manifolds are where X or Y is -1, 0 or 1.  In hundredths. */
struct moved {
    int p, r, q, t;
};

static long double moved(const void *ctx, long double x, long double y)
{
    const struct moved *m = ctx;
    const long double X = x - m->q * y / 100.0L - m->t * y * y / 100.0L;
    const long double Y = y - m->p * X / 100.0L - m->r * X * X / 100.0L;

    return X * (X * X - 1) * Y * (Y * Y - 1);
}

static int hundredths(uint64_t *rng, int most)
{
    return (int) (check_bits(rng) % (2 * (uint64_t) most + 1)) - most;
}

static void run_moved(struct plane_study *s, struct scene *c,
                      const struct moved *m, bool four)
{
    char ode[600];

    snprintf(ode, sizeof ode,
             "p = %.2f; r = %.2f; q = %.2f; t = %.2f; X = x - q*y - t*y^2; "
             "Y = y - p*X - r*X^2; dX = X - X^3; dY = %s; "
             "dy = dY + (p + 2*r*X)*dX; x' = dX + (q + 2*t*y)*dy; y' = dy",
             m->p / 100.0, m->r / 100.0, m->q / 100.0, m->t / 100.0,
             four ? "Y - Y^3" : "-0.7*Y");
    plane_run(s, c, ode, "window={x: [-3, 3], y: [-2.5, 2.5]}\n" MORE);
}

static struct moved any_moved(uint64_t *rng)
{
    struct moved m;

    m.p = hundredths(rng, 60);
    m.r = hundredths(rng, 30);
    m.q = hundredths(rng, 40);
    m.t = hundredths(rng, 15);
    return m;
}

static void random_shears_of_four_saddles_are_proved(void **state)
{
    uint64_t rng = check_seed();
    size_t asked = 0, proved = 0;

    (void) state;
    for (int i = 0; i < 8; i++) {
        const struct moved m = any_moved(&rng);
        struct plane_study s;
        struct scene c;
        run_moved(&s, &c, &m, i % 2 == 0);
        CHECK(s.proof.lie.text[0] == '\0', "%s", s.proof.lie.text);
        for (size_t k = 0; k < s.branches; k++) {
            const struct plane_branch *b = &s.branch[k];
            asked += b->end != PLANE_END_SADDLE;
            proved += b->end_proved != PLANE_NOT_PROVED;
            if (b->end_proved == PLANE_CROSSES)
                holds(b, moved, &m, 1e-10, "a shear");
        }
        plane_end(&s, &c);
    }
    print_message("# %zu of %zu ends of branches are proved\n", proved, asked);
    CHECK(proved >= 0.9 * (double) asked, "%zu of %zu", proved, asked);
}

/* ---- spoiled curves ------------------------------------------------------ */

/* Once more, along what the curves now are. */
static void prove_again(struct plane_study *s)
{
    plane_proof_free(&s->proof);
    s->proof = (struct plane_proof){ .of = NULL };
    assert_int_equal(plane_proof_find(s), STATUS_OK);
}

/* One of its pieces is lost, best one before a turn. */
static void lose(struct plane_branch *b, uint64_t *rng)
{
    struct curve *c = &b->curve.curve;

    if (b->shown < 3)
        return;
    size_t i = 1 + check_bits(rng) % (b->shown - 2);
    for (size_t k = 1; k + 1 < b->shown; k++)
        if (branch_graph(&b->curve, k) != branch_graph(&b->curve, k + 1))
            i = k;
    struct curve_piece *p = c->piece + i;
    c->count--;
    memmove(p, p + 1, (c->count - i) * sizeof *p);
    b->shown--;
}

/* Curves off by so much; half of them are said to come to another equilibrium
 * than they do. */
static void check_spoiled(struct plane_study *s, const struct moved *m,
                          double noise, uint64_t *rng, size_t tally[2])
{
    int64_t to[64];
    const bool elsewhere = check_bits(rng) % 2, gap = check_bits(rng) % 2;
    const enum spoil kind = (enum spoil)(check_bits(rng) % SPOILS);

    for (size_t k = 0; k < s->branches && k < 64; k++) {
        struct plane_branch *b = &s->branch[k];
        to[k] = b->to;
        spoil(&b->curve, kind, noise, rng);
        if (gap)
            lose(b, rng);
        if (b->end == PLANE_END_EQUILIBRIUM && elsewhere)
            b->to = (int64_t) (check_bits(rng) % s->rests);
    }
    prove_again(s);
    for (size_t k = 0; k < s->branches && k < 64; k++) {
        const struct plane_branch *b = &s->branch[k];
        if (b->end == PLANE_END_SADDLE)
            continue;
        tally[b->end_proved != PLANE_NOT_PROVED]++;
        if (b->end_proved == PLANE_CROSSES)
            holds(b, moved, m, HUGE_VAL, "a spoiled shear");
        if (b->end_proved == PLANE_TRAPPED)
            assert_int_equal(b->to, to[k]);
    }
    CHECK(s->proof.lie.text[0] == '\0', "%s", s->proof.lie.text);
}

static void spoiled_curves_prove_nothing_wrong(void **state)
{
    const int runs = getenv("SPOILED") ? atoi(getenv("SPOILED")) : 12;
    uint64_t rng = check_seed();
    size_t tally[2] = { 0, 0 };

    (void) state;
    for (int i = 0; i < runs; i++) {
        const struct moved m = any_moved(&rng);
        struct plane_study s;
        struct scene c;
        run_moved(&s, &c, &m, i % 2 == 0);
        check_spoiled(&s, &m, pow(10, check_uniform(&rng, -12, -2)), &rng,
                      tally);
        plane_end(&s, &c);
    }
    print_message("# %zu ends proved along %d systems' spoiled curves, %zu "
                  "not\n",
                  tally[1], runs, tally[0]);
    assert_true(tally[1] > 0);
}

/* ---- what is told -------------------------------------------------------- */

static void a_bar_beside_what_is_proved_is_told(void **state)
{
    struct plane_study s;
    struct scene c;

    (void) state;
    plane_run(&s, &c, "x' = x; y' = -2*y",
              "window={x: [-1, 1], y: [-1, 1]}\n" MORE);
    assert_true(s.proof.lie.text[0] == '\0');
    s.rest[0].lambda[0].re.value += 1e-9;
    prove_again(&s);
    assert_string_equal(s.proof.lie.text, "saddle_0 eigenvalue: " PROVED_LIE);
    plane_proof_withdraw(&s.proof);
    assert_non_null(s.rest[0].lambda[0].re.proved->not_proved);
    plane_end(&s, &c);
}

/* What is not followed to an end that has a proof says why. */
static void each_branch_without_a_proof_says_why(void **state)
{
    static const struct {
        const char *ode, *why;
    } at[] = {
        { "x' = y; y' = x - x^3", "it comes to a saddle" },
        { "x' = y; y' = x - x^3 + 0.8*y*(1 - 1.12*x^2)",
          "it winds on to a closed orbit" },
    };
    struct plane_study s;
    struct scene c;

    (void) state;
    for (int i = 0; i < 2; i++) {
        bool found = false;
        plane_run(&s, &c, at[i].ode, "window={x: [-2, 2], y: [-2, 2]}\n" MORE);
        for (size_t k = 0; k < s.branches; k++) {
            const struct plane_branch *b = &s.branch[k];
            assert_true((b->end_proved == PLANE_NOT_PROVED) ==
                        (b->not_proved != NULL));
            found = found ||
                    (b->not_proved && strcmp(b->not_proved, at[i].why) == 0);
        }
        CHECK(found, "%s", at[i].ode);
        plane_end(&s, &c);
    }
}

static void an_equilibrium_without_a_number_has_no_trap(void **state)
{
    struct plane_study s;
    struct scene c;
    int trapped = 0;

    (void) state;
    plane_run(&s, &c, "x' = y; y' = x - x^3 - y/2",
              "window={x: [-2, 2], y: [-2, 2]}\n" MORE);
    for (size_t k = 0; k < s.branches; k++)
        if (s.branch[k].end_proved == PLANE_TRAPPED) {
            s.branch[k].to = RECORD_COUNT_NONE;
            trapped++;
        }
    assert_int_equal(trapped, 2);
    prove_again(&s);
    for (size_t k = 0; k < s.branches; k++)
        if (s.branch[k].end == PLANE_END_EQUILIBRIUM) {
            assert_true(s.branch[k].end_proved == PLANE_NOT_PROVED);
            assert_string_equal(
                s.branch[k].not_proved,
                "it comes to an equilibrium outside the window");
        }
    plane_end(&s, &c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(closed_forms_are_in_what_is_proved),
        TEST(random_shears_of_four_saddles_are_proved),
        TEST(spoiled_curves_prove_nothing_wrong),
        TEST(a_bar_beside_what_is_proved_is_told),
        TEST(each_branch_without_a_proof_says_why),
        TEST(an_equilibrium_without_a_number_has_no_trap),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
