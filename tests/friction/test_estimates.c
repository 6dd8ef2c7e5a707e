/* Roots of (34) and of (37)-(40) against a fine scan of the equations as they
 * are printed, in long double, on random laws, materials and slopes. */
#include "estimates.h"

#include <float.h>
#include <math.h>

#include "check.h"
#include "tolerance.h"

enum { SETS = 3000 };

struct sample {
    struct material m;
    struct estimates e;
    double tan_alpha, xi;
    long double per_v; /* cos(alpha)/eps^2 */
};

/* ln v_sp0 in [lo, hi], slopes y/x of Y = 0 from 1e-20 to 1e20. */
static void draw(struct sample *s, double lo, double hi, uint64_t *rng)
{
    static const char *const laws[] = { "dieterich_gen", "spinodal_gen",
                                        "spinodal_phi_gen" };
    const struct law *law = law_preset_find(laws[check_bits(rng) % 3]);

    s->m = material_bristol_board();
    s->m.a = pow(10.0, check_uniform(rng, -4.0, -0.5));
    s->m.b = s->m.a * (1.0 + pow(10.0, check_uniform(rng, -2.0, 1.5)));
    s->m.R = pow(10.0, check_uniform(rng, -2.0, 6.0));
    s->m.L = pow(10.0, check_uniform(rng, -24.0, 12.0));
    s->tan_alpha = check_uniform(rng, 0.0, 1.5);
    s->m.mu_star =
        s->tan_alpha + (s->m.b - s->m.a) * check_uniform(rng, lo, hi);
    s->xi = check_uniform(rng, 0.001, 0.999);
    s->per_v =
        1.0L / hypotl(1.0L, s->tan_alpha) / (long double) material_eps2(&s->m);
    assert_true(estimates_at(law, &s->m, s->tan_alpha, &s->e));
}

/* ---- the equations ------------------------------------------------------- */

static long double log_sinh(long double u)
{
    return u > 1.0L ? u + logl(-0.5L * expm1l(-2.0L * u)) : logl(sinhl(u));
}

/* dY/dX = -xi at (x, y) = X (B, -A - lambda_minus), of (17) as c = 0 and the
 * log form have it: the logarithm of
 *     (xi (A + lambda_plus) - (A + lambda_minus)) (-eps^2 v_sp dx/dt) over
 *     (1 - xi) B (-psi_sp dy/dt)
 * and *size, what its terms come to. */
static long double log_xi(const struct sample *s, long double x,
                          long double *size)
{
    const long double v = expl(s->e.ln_v_sp0), psi = 1.0L / v;
    const long double A = s->m.a * s->per_v / v, B = s->m.b * s->per_v / v;
    const long double half = 0.5L * (A + v);
    const long double minus =
        -half - sqrtl(half * half + s->per_v * (s->m.b - s->m.a));
    const long double plus = -s->per_v * (s->m.b - s->m.a) / minus;
    const long double upper = A + plus, lower = -B * v / upper;
    const long double y = -lower / B * x;
    const long double u = psi * fabsl(expm1l(y) - expm1l(-x));
    const long double dx = logl(-minus * fabsl(x)) - x;
    const long double dy = logl(B) + 2.0L * logl(v) + x - y + log_sinh(u);

    *size = fabsl(dx) + fabsl(x) + fabsl(y) + u + fabsl(logl(v)) +
            fabsl(logl(B)) + fabsl(dy);
    return logl(s->xi * upper - lower) + dx - logl(1.0L - s->xi) - dy;
}

/* ln chi, (34), at v = v_sp0 e^x, with mu - tan(alpha) = a x. */
static long double log_chi(const struct sample *s, long double x,
                           long double *size)
{
    const long double psi = expl(-(long double) s->e.ln_v_sp0);
    const long double u = psi * fabsl(expm1l(-x));
    const long double front = logl((long double) s->e.eta * s->m.a * s->per_v);
    const long double v = (long double) s->e.ln_v_sp0;

    *size = fabsl(x) + u + 4.0L * fabsl(v) + fabsl(front);
    return 2.0L * (v + x) + log_sinh(u) + v - front - logl(fabsl(x));
}

typedef long double equation(const struct sample *s, long double x,
                             long double *size);

/* ---- scans --------------------------------------------------------------- */

struct found {
    long double x, uncertain; /* by rounding to doubles */
};

/* f changes its sign in [lo, hi]. */
static struct found bisect(equation *f, const struct sample *s, long double lo,
                           long double hi)
{
    long double size;
    const long double first = f(s, lo, &size);

    for (int i = 0; i < 64; i++) {
        const long double mid = 0.5L * (lo + hi);
        *((f(s, mid, &size) > 0.0L) == (first > 0.0L) ? &lo : &hi) = mid;
    }
    const long double d = 1e-4L * fabsl(lo);
    const long double slope =
        fabsl(f(s, lo + d, &size) - f(s, lo - d, &size)) / (2.0L * d);
    f(s, lo, &size);
    return (struct found){ lo,
                           64.0L * DBL_EPSILON * (size / slope + fabsl(lo)) };
}

/* Outward from `near` in steps of 4 %, 0.04 at most, to sign changes. */
static size_t scan(equation *f, const struct sample *s, int side,
                   long double near, long double last, struct found root[8])
{
    long double size, x = near, here = f(s, side * x, &size);
    size_t n = 0;

    while (x < last) {
        const long double next = x + fminl(0.04L * x, 0.04L);
        const long double there = f(s, side * next, &size);
        if ((here > 0.0L) != (there > 0.0L)) {
            assert_true(n < 8);
            root[n++] = bisect(f, s, side * x, side * next);
        }
        x = next;
        here = there;
    }
    return n;
}

/* ---- xi ------------------------------------------------------------------ */

static void check_xi(const struct sample *s, int side, double x, size_t *roots)
{
    const long double near = TOL_SAME;
    long double size;
    const long double first = log_xi(s, side * near, &size);
    struct found root[8];

    if (fabsl(first) < 1e-12L * size)
        return;
    const long double last = isnan(x) ? 5.0L : 1.2L * fabs(x) + 1.0L;
    const size_t n = scan(log_xi, s, side, near, last, root);
    if (first > 0.0L) {
        CHECK(n == 1, "%zu roots", n);
        CHECK(fabsl(x - root[0].x) <= root[0].uncertain,
              "x = %.17g, not %.17Lg: ln v_sp0 = %.17g, xi = %g", x, root[0].x,
              s->e.ln_v_sp0, s->xi);
        ++*roots;
    } else {
        CHECK(n == 0 && isnan(x), "%zu roots, x = %g", n, x);
    }
}

static void no_root_of_the_xi_estimate_is_lost(void **state)
{
    uint64_t rng = check_seed();
    size_t roots = 0;

    (void) state;
    for (int i = 0; i < SETS; i++) {
        struct sample s;
        draw(&s, -12.0, 120.0, &rng);
        const struct estimates_xi x =
            estimates_xi_at(&s.m, &s.e, s.tan_alpha, s.xi);
        check_xi(&s, -1, x.minus, &roots);
        check_xi(&s, 1, x.plus, &roots);
    }
    CHECK(roots > SETS / 4 && roots < 2 * SETS, "%zu roots", roots);
}

/* ---- chi ----------------------------------------------------------------- */

/* The smaller v_sp0, the nearer both roots are to it. */
static size_t scan_chi(const struct sample *s, struct found root[16])
{
    const long double near =
        fminl(1e-7L, 1e-3L * expl((long double) s->e.ln_v_sp0));
    long double size;
    struct found left[8];
    const size_t n = scan(log_chi, s, -1, near, 300.0L, left);
    size_t count = 0;

    for (size_t i = n; i > 0; i--)
        root[count++] = left[i - 1];
    if ((log_chi(s, -near, &size) > 0.0L) != (log_chi(s, near, &size) > 0.0L))
        root[count++] = bisect(log_chi, s, -near, near);
    return count + scan(log_chi, s, 1, near, 300.0L, &root[count]);
}

/* With a bar that holds its rounding and is no wider than that of the scan. */
static void check_chi(const struct sample *s, size_t *pairs)
{
    struct estimates_root root[2];
    struct found want[16];
    const size_t n = estimates_chi(&s->m, &s->e, s->tan_alpha, 0.0, root);
    const size_t scanned = scan_chi(s, want);

    CHECK(n == scanned, "%zu roots, not %zu: ln v_sp0 = %.17g", n, scanned,
          s->e.ln_v_sp0);
    for (size_t k = 0; k < n; k++) {
        const long double off = fabsl(root[k].x - want[k].x);
        CHECK(off <= want[k].uncertain && off <= root[k].error,
              "x = %.17g +- %.2g, not %.17Lg: ln v_sp0 = %.17g", root[k].x,
              root[k].error, want[k].x, s->e.ln_v_sp0);
        CHECK(root[k].error <= 2.0L * want[k].uncertain,
              "x = %.17g +- %.2g, not %.2Lg: ln v_sp0 = %.17g", root[k].x,
              root[k].error, want[k].uncertain, s->e.ln_v_sp0);
    }
    *pairs += n == 2;
}

static void no_root_of_chi_is_lost(void **state)
{
    uint64_t rng = check_seed() + 1;
    size_t pairs = 0;

    (void) state;
    for (int i = 0; i < SETS / 10; i++) {
        struct sample s;
        draw(&s, -12.0, 120.0, &rng);
        check_chi(&s, &pairs);
    }
    CHECK(pairs > 20 && pairs < SETS / 10, "%zu pairs", pairs);
}

/* v_sp0 from 1e-300 to 1e-5, psi_sp0 up to 1e300. */
static void nor_where_v_sp0_is_next_to_nothing(void **state)
{
    uint64_t rng = check_seed() + 2;
    size_t pairs = 0;

    (void) state;
    for (int i = 0; i < SETS / 75; i++) {
        struct sample s;
        draw(&s, -690.0, -12.0, &rng);
        check_chi(&s, &pairs);
    }
    CHECK(pairs > SETS / 150, "%zu pairs", pairs);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_root_of_the_xi_estimate_is_lost),
        cmocka_unit_test(no_root_of_chi_is_lost),
        cmocka_unit_test(nor_where_v_sp0_is_next_to_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
