/* What is left of a branch beyond its last cell, of laws whose way from there
 * on is followed by steps of Runge and Kutta: with u = psi - p ln v
 *
 *     mu = mu_star + A ln v + B psi,   dpsi/dt = -f(u) v^r (1 + s ln v),
 *
 * (or c (v^n - 1) more) A, B, p, r and s of any sign, A + B p < 0, and a mass
 * that makes the way as long as what is known of it: each inequality is nearly
 * an equality for some draw.
 */
#include "proof_end.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "law_typed.h"
#include "proof_short.h"

static const char *const shapes[] = {
    "2*sinh(k*u)", "exp(k*u) - 1", "u",
    "u + u*u*u",   "exp(k*u) - 1", /* v^4 in mu */
};
enum { SINH, EXP, PLAIN, CUBE, SHAPES, RISING = SHAPES, LAWS, DRAWS = 1200 };

/* The exponents are differences of two that are positive; X, Y: where the way
 * begins; F = cos(alpha)/eps^2. */
struct made {
    int shape, side;
    double A, B, p, r, s, k, X, Y, F, c, n;
};

static long double shape_at(const struct made *f, long double u)
{
    return f->shape == SINH                        ? 2 * sinhl(f->k * u)
           : f->shape == EXP || f->shape == RISING ? expm1l(f->k * u)
           : f->shape == PLAIN                     ? u
                                                   : u + u * u * u;
}

/* mu - tan(alpha) */
static long double force_at(const struct made *f, long double x, long double y)
{
    return f->A * x + f->B * y + f->c * expm1l(f->n * x);
}

static long double growth_at(const struct made *f, long double x, long double y)
{
    return -shape_at(f, y - f->p * x) * expl(f->r * x) * (1 + f->s * x);
}

/* dy/dx */
static long double slope_at(const struct made *f, long double x, long double y)
{
    return -expl(x) * growth_at(f, x, y) / (f->F * force_at(f, x, y));
}

/* ---- the law ------------------------------------------------------------- */

static struct law_typed typed[LAWS];

static void make_laws(void)
{
    static const char *const names[] = { "a1", "a2", "b1", "b2", "r1",
                                         "r2", "p1", "p2", "s1", "s2",
                                         "k",  "c1", "n1" };

    for (int i = 0; i < LAWS; i++) {
        struct law_typed *t = &typed[i];
        enum law_part wrong;
        struct fault why = { "" };
        *t = (struct law_typed){ .real = true };
        for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
            snprintf(t->own[k].name, FORMULA_NAME, "%s", names[k]);
            t->own[k].value = 1;
            t->owns++;
        }
        snprintf(t->text[LAW_MU], LAW_LETTERS,
                 "(mu_star%s + (a1 - a2)*ln(v) + (b1 - b2)*psi",
                 i == RISING ? " - c1) + c1*v^n1" : ")");
        snprintf(t->text[LAW_PSI_SS], LAW_LETTERS, "(p1 - p2)*ln(v)");
        for (const char *c = shapes[i]; *c; c++)
            snprintf(t->text[LAW_RATE] + strlen(t->text[LAW_RATE]),
                     LAW_LETTERS - strlen(t->text[LAW_RATE]),
                     *c == 'u' ? "(psi - (p1 - p2)*ln(v))" : "%c", *c);
        char rate[LAW_LETTERS];
        snprintf(rate, sizeof rate, "%s", t->text[LAW_RATE]);
        snprintf(t->text[LAW_RATE], LAW_LETTERS,
                 "-(%.200s)*exp((r1 - r2)*ln(v))*(1 + (s1 - s2)*ln(v))", rate);
        CHECK(law_typed_make(t, &wrong, &why) == STATUS_OK, "%s", why.text);
    }
}

/* Both parts of a number of any sign. */
static void set_pair(double pair[2], double number)
{
    pair[0] = 1 + fmax(number, 0);
    pair[1] = 1 - fmin(number, 0);
}

/* The steady state is at (0, 0). */
static void law_at(struct proof_law *p, struct made *f)
{
    const struct proof_inputs in = { .slope_in = ANGLE_TAN, .slope = 0.5 };
    const struct law law = law_of_typed(&typed[f->shape]);
    struct material m = material_bristol_board();
    static struct block b;
    struct fault why = { "" };

    f->F = fmin(fmax(f->F, 1e-100), 1e100);
    m.mu_star = 0.5;
    m.L = f->F * sqrt(1 + 0.5 * 0.5);
    m.V_star = m.g = 1;
    set_pair(&m.own[0], f->A);
    set_pair(&m.own[2], f->B);
    set_pair(&m.own[4], f->r);
    set_pair(&m.own[6], f->p);
    set_pair(&m.own[8], f->s);
    m.own[10] = f->k;
    m.own[11] = f->c + !(f->c > 0);
    m.own[12] = f->n + !(f->n > 0);
    block_init(&b, &law, &m, 0.5L);
    b.x = b.y = 0;
    CHECK(proof_law_at(p, &b, &in, &why) == STATUS_OK, "%s", why.text);
}

/* ---- draws --------------------------------------------------------------- */

static double some(uint64_t *rng, double from, double to)
{
    return pow(10, check_uniform(rng, from, to));
}

/* Numbers of 20 bits, of which sums with 1 are exact. */
static double plain(double x)
{
    return round(x * 0x1p20) * 0x1p-20;
}

static double signed_or_0(uint64_t *rng, double from, double to)
{
    const double u = some(rng, from, to);

    return check_bits(rng) % 3 == 0 ? 0 : check_bits(rng) % 3 ? u : -u;
}

static double u_of(const struct made *f)
{
    return f->Y - f->p * f->X;
}

/* A + B p < 0: friction falls along the steady states. */
static void draw_law(struct made *f, uint64_t *rng)
{
    f->shape = (int) (check_bits(rng) % SHAPES);
    f->k = plain(some(rng, -0.5, 2));
    f->r = plain(signed_or_0(rng, -1, 0.7)) +
           (check_bits(rng) % 2 && f->shape == SINH ? f->k : 0);
    f->s = check_bits(rng) % 4 ? 0 : plain(signed_or_0(rng, -1, 0));
    do {
        f->p = check_bits(rng) % 2 ? -1 : plain(signed_or_0(rng, -1, 0.5));
        f->A = plain(signed_or_0(rng, -2, 0.5));
        f->B = check_bits(rng) % 2 ? plain(f->A + some(rng, -3, 0.3))
                                   : plain(signed_or_0(rng, -2, 0.5));
    } while (!(f->A + f->B * f->p < -1e-4));
}

/* A way from a place where psi moves to that side and friction lets it, as a
 * rule; the mass is left to choose. */
static void draw(struct made *f, int side, uint64_t *rng)
{
    const bool any = check_bits(rng) % 8 == 0;
    bool good = false;

    *f = (struct made){ .side = side, .F = 1 };
    draw_law(f, rng);
    for (int i = 0; i < 99 && !good; i++) {
        const double u = (check_bits(rng) % 2 ? 1 : -1) * some(rng, -2, 0.7);
        f->X = check_uniform(rng, -4, 4);
        if (f->s > 0 && check_bits(rng) % 2) /* where 1 + s x is small */
            f->X = check_uniform(rng, 0, 0.3) - 1 / f->s;
        f->Y = f->p * f->X + u;
        good = any || (u_of(f) * side > 0 &&
                       (double) force_at(f, f->X, f->Y) * side > 0);
    }
}

/* Where friction is nearly even with gravity but grows with v, on which the
 * rate of psi, fast at once, hardly depends. */
static void draw_even(struct made *f, uint64_t *rng)
{
    const double u = some(rng, -1.5, -0.5);

    draw(f, 1, rng);
    f->shape = check_bits(rng) % 2 ? SINH : EXP;
    f->s = 0;
    f->k = plain(some(rng, 0.5, 0.8) / u);
    f->r = -f->k;
    f->A = plain(some(rng, -0.5, 0.5));
    f->B = plain(f->A * (1 + some(rng, -3, -1)) + 0x1p-20);
    f->p = -1;
    f->X = check_uniform(rng, -1, 0.1 * u);
    f->Y = u - f->X;
}

/* Where friction is nearly even with gravity below the saddle, and psi may turn
 * on the way. */
static void draw_slow(struct made *f, uint64_t *rng)
{
    const double part = check_uniform(rng, 0, 0.6);

    *f = (struct made){ .side = -1, .F = 1 };
    f->k = plain(some(rng, -0.7, -0.2));
    f->r = plain(signed_or_0(rng, -1, -0.3));
    f->s = check_bits(rng) % 2 ? 0 : plain(some(rng, -0.3, 0.5));
    f->shape = f->s > 0 ? EXP : check_bits(rng) % 2 ? SINH : PLAIN;
    f->p = -plain(some(rng, -0.3, 0));
    f->B = plain(some(rng, -1, 0.3));
    f->A = plain(-f->B * f->p * part);
    f->X = f->s > 0 ? check_uniform(rng, 0, 0.3) - 1 / f->s
                    : check_uniform(rng, -4, -1);
    f->Y = -(f->A * f->X + f->B * some(rng, -2, 0)) / f->B;
}

/* Where v dpsi/dt vanishes much faster than v: psi hardly goes on. */
static void draw_brief(struct made *f, uint64_t *rng)
{
    draw_slow(f, rng);
    f->shape = PLAIN;
    f->r = plain(some(rng, 0.5, 0.7));
    f->p = f->X = -1;
    f->A = plain(0.8 * f->B);
    f->s = f->Y = 0;
}

/* Where psi moves inward above the saddle and friction is below gravity, but
 * not farther on. */
static void draw_inside(struct made *f, uint64_t *rng)
{
    const double part = check_uniform(rng, 0, 0.5);

    draw_slow(f, rng);
    f->side = 1;
    f->s = -plain(some(rng, -0.5, 0.3));
    f->A = plain(-f->B * f->p * part);
    f->X = check_uniform(rng, 0.05, 1) - 1 / f->s;
    f->Y = f->p * f->X * check_uniform(rng, part, 1);
}

/* A place whose strip to larger v and psi has the saddle, if it is below. */
static void draw_on(struct made *f, uint64_t *rng)
{
    draw(f, check_bits(rng) % 4 ? 1 : -1, rng);
    if (check_bits(rng) % 8 == 0)
        draw_inside(f, rng);
    if (f->side < 0) {
        f->X = -fabs(f->X);
        f->Y = -fabs(f->Y);
    }
}

/* A box around where the way is to begin, which is then put at a corner. */
static struct proof_place place_of(struct made *f, uint64_t *rng)
{
    const double wide = check_bits(rng) % 2 ? 0 : some(rng, -3, -0.5);
    const struct proof_place at = { { f->X - wide, f->X + wide },
                                    { f->Y - wide, f->Y + wide },
                                    f->side };

    f->X = (double) (check_bits(rng) % 2 ? at.X.lo : at.X.hi);
    f->Y = (double) (check_bits(rng) % 2 ? at.Y.lo : at.Y.hi);
    return at;
}

/* ---- the way ------------------------------------------------------------- */

/* Along an orbit: how far the settled coordinate goes from where it begins, the
 * integral of |v - 1| over time, and the range of dy/dx. */
struct way {
    long double far, excess, least, most;
};

/* by_y: y is the independent coordinate. */
static void move(const struct made *f, bool by_y, long double s,
                 const long double u[2], long double out[2])
{
    const long double x = by_y ? u[0] : s, y = by_y ? s : u[0];
    const long double slope = slope_at(f, x, y);

    out[0] = by_y ? 1 / slope : slope;
    out[1] = by_y ? expm1l(x) / growth_at(f, x, y)
                  : -expm1l(x) * expl(x) / (f->F * force_at(f, x, y));
}

/* Over `range`, outward, in so many steps. */
static struct way follow(const struct made *f, bool by_y, double range,
                         int steps)
{
    const long double h = f->side * range / steps;
    const double begin = by_y ? f->Y : f->X;
    long double u[2] = { by_y ? f->X : f->Y, 0 };
    struct way out = { 0, 0, HUGE_VALL, 0 };

    for (int i = 0; i <= steps; i++) {
        const long double s = begin + i * h;
        const long double slope =
            by_y ? slope_at(f, u[0], s) : slope_at(f, s, u[0]);
        long double k[4][2], at[2];
        out.far = fmaxl(out.far, fabsl(u[0] - (by_y ? f->X : f->Y)));
        out.excess = fmaxl(out.excess, fabsl(u[1]));
        out.least = fminl(out.least, slope);
        out.most = fmaxl(out.most, slope);
        if (isnan(u[0]))
            out.far = u[0];
        for (int j = 0; j < 4; j++) {
            const long double part = j == 0 ? 0 : j == 3 ? h : h / 2;
            for (int c = 0; c < 2; c++)
                at[c] = u[c] + (j ? part * k[j - 1][c] : 0);
            move(f, by_y, s + part, at, k[j]);
        }
        for (int c = 0; c < 2; c++)
            u[c] += h / 6 * (k[0][c] + 2 * k[1][c] + 2 * k[2][c] + k[3][c]);
    }
    return out;
}

struct tally {
    int proved, excess_near;
    double nearest, excess;
    double slope[2]; /* the slopes nearest to 1 that are told */
};

static void check_way(const struct made *f, const struct way *w,
                      const struct proof_tail *t, int n, struct tally *all)
{
    const long double room = 1e-6L;

    CHECK(w->far <= t->way * (1 + room),
          "draw %d, A %g B %g p %g r %g k %g, side %d: %Lg, beyond %g", n, f->A,
          f->B, f->p, f->r, f->k, f->side, w->far, t->way);
    CHECK(w->excess <= t->excess * (1 + room),
          "draw %d: the integral is %Lg, beyond %g", n, w->excess, t->excess);
    CHECK(t->slope != 1 || w->least > 1 - room, "draw %d: slope %Lg", n,
          w->least);
    CHECK(t->slope != -1 || w->most < 1 + room, "draw %d: slope %Lg", n,
          w->most);
    all->proved++;
    all->nearest = fmax(all->nearest, (double) w->far / t->way);
    all->excess = fmax(all->excess, (double) w->excess / t->excess);
    if (t->slope == 1)
        all->slope[0] = fmin(all->slope[0], (double) w->least);
    if (t->slope == -1)
        all->slope[1] = fmax(all->slope[1], (double) w->most);
}

/* Where v (by_y) or psi settles. */
static void draw_tail(struct made *f, bool by_y, int n, uint64_t *rng)
{
    if (by_y)
        n % 2 ? draw(f, check_bits(rng) % 2 ? 1 : -1, rng) : draw_even(f, rng);
    else if (n % 2)
        draw(f, check_bits(rng) % 8 ? -1 : 1, rng);
    else
        n % 16 ? draw_slow(f, rng) : draw_brief(f, rng);
    const double g = fabs((double) growth_at(f, f->X, f->Y));
    const double m = by_y ? (fabs(f->A) + fabs(f->B)) / f->k
                          : fabs((double) force_at(f, f->X, f->Y));
    const double part = by_y ? some(rng, -2, 0.1) : some(rng, -0.5, 1);
    f->F = part * exp(f->X) * g / m;
}

static void tails_are_below_their_bounds(bool by_y)
{
    uint64_t rng = check_seed();
    struct tally t = { .slope = { HUGE_VAL, 0 } };

    for (int n = 0; n < DRAWS; n++) {
        struct made f;
        struct proof_law p;
        struct proof_tail tail;
        draw_tail(&f, by_y, n, &rng);
        law_at(&p, &f);
        const struct proof_place at = place_of(&f, &rng);
        /* v g falls as this power of v */
        const double q = 1 + f.r - (f.shape == SINH ? f.k * fabs(f.p) : 0);
        if ((by_y ? proof_tail_psi : proof_tail_v)(&p, &at, 1, &tail) == NULL) {
            CHECK(by_y || q > 0, "draw %d: v g grows as v falls", n);
            const double range = 40 / (by_y ? f.k : fmin(1, q));
            const struct way w = follow(&f, by_y, range, 4000);
            check_way(&f, &w, &tail, n, &t);
        }
        proof_law_free(&p);
    }
    print_message("# %d of %d are proved, the way up to %g of its bound, the "
                  "integral %g, slopes down to %g, up to %g\n",
                  t.proved, DRAWS, t.nearest, t.excess, t.slope[0], t.slope[1]);
    CHECK(t.proved > DRAWS / 60 && t.nearest > 0.9 && t.excess > 0.7, "few");
}

static void what_v_goes_on_by_is_below_its_bound(void **state)
{
    (void) state;
    tails_are_below_their_bounds(true);
}

static void what_psi_goes_on_by_is_below_its_bound(void **state)
{
    (void) state;
    tails_are_below_their_bounds(false);
}

/* ---- no end -------------------------------------------------------------- */

/* With f(u) = u alone, and where psi moves outward against friction: dx/dy is
 * above a constant over e^x (1 + y) e^(r x), as long as there is no end. */
static void only_an_open_branch_is_proved_to_be(void **state)
{
    uint64_t rng = check_seed();
    int proved = 0;

    (void) state;
    for (int n = 0; n < DRAWS; n++) {
        struct made f;
        struct proof_law p;
        draw_on(&f, &rng);
        if (check_bits(&rng) % 2)
            f.shape = PLAIN;
        law_at(&p, &f);
        const struct proof_place at = place_of(&f, &rng);
        const bool open = proof_tail_open(&p, &at) == NULL;
        CHECK(!open || (f.shape == PLAIN && f.side > 0 && u_of(&f) > 0 &&
                        f.A >= 0 && force_at(&f, f.X, f.Y) > 0),
              "draw %d, f = %s, side %d, A %g B %g r %g", n, shapes[f.shape],
              f.side, f.A, f.B, f.r);
        proved += open;
        proof_law_free(&p);
    }
    print_message("# %d of %d are proved\n", proved, DRAWS);
    CHECK(proved > DRAWS / 60, "%d", proved);
}

/* Slopes that fall, if they are 1, as m rises with v: as it does where they
 * begin, or is small, or will soon. */
static const struct made falling[] = {
    { EXP, 1, 0.125, 0.03125, -10, -11.5, 0, 1, 0.5, 0.5, 1, 0, 0 },
    { RISING, 1, 0x1p-20, 0x9p-9, -64, -2.9375, 0, 0x1p-4, 0.5, 0.5, 1, 0.5,
      2 },
    { RISING, 1, 0.125, 0.03125, -10, -9.5, 0, 1, 0.5, 0.5, 1, 1e-12, 40 },
};

/* By steps in y where psi moves faster, else in x. */
static void where_the_slope_is_proved_to_stay_above_1_it_does(void **state)
{
    uint64_t rng = check_seed();
    int proved = 0;
    double nearest = HUGE_VAL;

    (void) state;
    for (int n = 0; n < DRAWS; n++) {
        struct made f;
        struct proof_law p;
        draw_on(&f, &rng);
        f = n % 8 < 3 ? falling[n % 8] : f;
        const double slope = (double) slope_at(&f, f.X, f.Y);
        f.F = fabs(slope) / some(&rng, -0.3, 0.3);
        law_at(&p, &f);
        const struct proof_place at = place_of(&f, &rng);
        if (proof_tail_steep(&p, &at)) {
            const double range = f.shape <= EXP ? 40 / f.k : 40;
            const struct way w = follow(&f, true, range, 4000);
            CHECK(f.side > 0 && w.least > 1 - 1e-6L,
                  "draw %d, f = %s, A %g B %g r %g: %Lg", n, shapes[f.shape],
                  f.A, f.B, f.r, w.least);
            nearest = fmin(nearest, (double) w.least);
            proved++;
        }
        proof_law_free(&p);
    }
    print_message("# %d of %d are proved, slopes down to %g\n", proved, DRAWS,
                  nearest);
    CHECK(proved > DRAWS / 60 && nearest < 1.1, "%d, %g", proved, nearest);
}

static int set_up(void **state)
{
    (void) state;
    make_laws();
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_v_goes_on_by_is_below_its_bound),
        cmocka_unit_test(what_psi_goes_on_by_is_below_its_bound),
        cmocka_unit_test(only_an_open_branch_is_proved_to_be),
        cmocka_unit_test(where_the_slope_is_proved_to_stay_above_1_it_does),
    };

    return cmocka_run_group_tests(tests, set_up, NULL);
}
