/* Formulas as planar systems: fields, gradients and Taylor series are those of
 * the formulas, and the same bits whoever asks. */
#include "interval_math.h"
#include "interval_tape.h"
#include "made_plane.h"

struct plane_case {
    const char *rate[2], *observable;
    bool positive[2];
    double lo[2], hi[2]; /* states */
};

static const struct plane_case planes[] = {
    { { "y", "-sin(x) - p*y" },
      "y^2/2 - cos(x)",
      { 0, 0 },
      { -3, -2 },
      { 3, 2 } },
    { { "x - x^3/3 - y", "p*(x + 0.7 - 0.8*y)" },
      "x",
      { 0, 0 },
      { -2, -2 },
      { 2, 2 } },
    { { "x*(1 - x - p*y)", "y*(x - 0.3)" },
      "x*y",
      { 1, 1 },
      { .1, .1 },
      { 3, 3 } },
    { { "tanh(x + y)*cosh(s*x)", "atan(x*y) + tan(y/3)" },
      "asin(x/5)",
      { 0, 0 },
      { -2, -2 },
      { 2, 2 } },
    { { "asinh(x*y) + sinh(x - y)", "sinh(x + s*y)*exp(y)" },
      "cosh(y)",
      { 0, 0 },
      { -2, -2 },
      { 2, 2 } },
    { { "y/(1 + x^2)", "x/(3 + sin(y)) - ln(5 + x*y)" },
      "sqrt(9 + x)",
      { 0, 0 },
      { -2, -2 },
      { 2, 2 } },
    { { "x^p - y*x^2", "p - cos(y)*x" },
      "x*exp(y)",
      { 1, 0 },
      { .1, -2 },
      { 3, 2 } },
    { { "y - acos(x/4)", "log10(5 + x) - abs2(y)" },
      "1",
      { 0, 0 },
      { -2, -2 },
      { 2, 2 } },
    { { "1/x - y/(p + x)", "-sinh(y - 1/x)/x" },
      "asinh(x*exp(y))",
      { 1, 1 },
      { .1, .1 },
      { 3, 3 } },
    { { "exp(y) - exp(x)", "(x - y)^5 + s" },
      "exp(x)*(y - 1)",
      { 0, 0 },
      { -2, -2 },
      { 2, 2 } },
};

enum { PLANES = sizeof planes / sizeof *planes };

/* A point of the case's box, in its chart. */
static void draw(const struct plane_case *c, uint64_t *seed, double out[2])
{
    for (int i = 0; i < 2; i++) {
        const double at = check_uniform(seed, c->lo[i], c->hi[i]);
        out[i] = c->positive[i] ? log(at) : at;
    }
}

/* d chart/dt and the observable by the plain formulas. */
static void plainly(const struct plane_case *c, const quad chart[2],
                    quad rate[3])
{
    quad at[2];

    for (int i = 0; i < 2; i++)
        at[i] = c->positive[i] ? expq(chart[i]) : chart[i];
    for (int i = 0; i < 2; i++) {
        rate[i] = plain(c->rate[i], at[0], at[1]);
        if (c->positive[i])
            rate[i] /= at[i];
    }
    rate[2] = plain(c->observable, at[0], at[1]);
}

static void field_and_gradients_are_those_of_the_formulas(void **state)
{
    uint64_t seed = check_seed();
    const quad h = 1e-12;

    (void) state;
    for (int n = 0; n < 40 * PLANES; n++) {
        const struct plane_case *c = &planes[n % PLANES];
        double anchor[2], to[2];
        draw(c, &seed, anchor);
        draw(c, &seed, to);
        const quad at[2] = { anchor[0], anchor[1] };
        make(c->rate, c->positive, c->observable, false, at);
        const struct planar s = tape_planar(&plane);
        const struct vec2 z = { to[0] - anchor[0], to[1] - anchor[1] };
        struct planar_jacobian J;
        double rate;
        struct vec2 slope;
        s.jacobian(s.ctx, z, &J);
        s.rate_gradient(s.ctx, 0, z, &rate, &slope);
        const double e = exp(J.field.log_scale);
        const double found[3][3] = {
            { J.field.direction.x * e, J.matrix.xx * e, J.matrix.xy * e },
            { J.field.direction.y * e, J.matrix.yx * e, J.matrix.yy * e },
            { rate, slope.x, slope.y },
        };
        quad mid[3], side[2][3];
        const quad x = at[0] + z.x, y = at[1] + z.y;
        plainly(c, (const quad[]){ x, y }, mid);
        plainly(c, (const quad[]){ x + h, y }, side[0]);
        plainly(c, (const quad[]){ x, y + h }, side[1]);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                const double exact =
                    (double) (j ? (side[j - 1][i] - mid[i]) / h : mid[i]);
                CHECK(fabs(found[i][j] - exact) <= 1e-11 * (1 + fabs(exact)),
                      "%s | %s, %d %d: %.17g, exactly %.17g", c->rate[0],
                      c->rate[1], i, j, found[i][j], exact);
            }
    }
}

/* Differences of two products that are not 0 at `at`, an equilibrium, beside
 * what makes up for them. */
static const struct {
    struct plane_case of;
    double at[2];
} balanced[] = {
    { { { "x*(2*y/(1 + y) - 0.4*x - 0.3)", "y*(2*x/(1 + x) - 0.4*y - 0.3)" },
        "1",
        { 1, 1 },
        { .01, .01 },
        { 8, 8 } },
      { 0.25, 0.25 } },
    { { { "x*y - 3*y^2/x - x + 3", "2*x*y - y/x - 3*x + 4/(x + y)" },
        "1",
        { 1, 1 },
        { .1, .1 },
        { 3, 3 } },
      { 1, 1 } },
    { { { "(x*y - 4*y/x)^3 + 27", "sinh(x^2 - 2*y/x + 1)/x" },
        "1",
        { 1, 1 },
        { .2, .2 },
        { 2, 2 } },
      { 1, 1 } },
    { { { "3*exp(x - y) - x*exp(y - 1) - 2", "1/(x*y - 2*x) + x^2*y" },
        "1",
        { 1, 1 },
        { .2, .2 },
        { 1.9, 1.9 } },
      { 1, 1 } },
    { { { "x - y", "(x*y - 3*x)*(x/y - y) - 2 + (x - y)/x" },
        "1",
        { 1, 1 },
        { .1, .1 },
        { 3, 3 } },
      { 2, 2 } },
};

static void about_an_equilibrium_fields_are_those_of_the_formulas(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int n = 0; n < 200; n++) {
        const size_t i = (size_t) n % (sizeof balanced / sizeof *balanced);
        const struct plane_case *c = &balanced[i].of;
        const quad at[2] = { logq(balanced[i].at[0]), logq(balanced[i].at[1]) };
        double to[2];
        draw(c, &seed, to);
        make(c->rate, c->positive, c->observable, true, at);
        const struct planar s = tape_planar(&plane);
        const struct vec2 z = { to[0] - (double) at[0],
                                to[1] - (double) at[1] };
        struct planar_field f;
        quad exact[3];
        s.field(s.ctx, z, &f);
        plainly(c, (const quad[]){ at[0] + z.x, at[1] + z.y }, exact);
        const double e = exp(f.log_scale),
                     found[2] = { f.direction.x * e, f.direction.y * e };
        for (int k = 0; k < 2; k++)
            CHECK(fabs(found[k] - (double) exact[k]) <=
                      1e-11 * (1 + fabs((double) exact[k])),
                  "%s: %.17g, exactly %.17g", c->rate[k], found[k],
                  (double) exact[k]);
    }
}

/* However it is asked for: alone, with gradients, as a series begins. */
static void a_field_is_the_same_bits_whoever_asks(void **state)
{
    static struct jet_work w;
    uint64_t seed = check_seed();

    (void) state;
    for (int n = 0; n < 40 * PLANES; n++) {
        const struct plane_case *c = &planes[n % PLANES];
        double anchor[2], to[2], rate[2];
        struct planar_field f;
        struct planar_jacobian J;
        struct vec2 slope;
        jet_pair fx, fy, r;
        draw(c, &seed, anchor);
        draw(c, &seed, to);
        const quad at[2] = { anchor[0], anchor[1] };
        make(c->rate, c->positive, c->observable, n % 2, at);
        const struct vec2 z = { to[0] - anchor[0], to[1] - anchor[1] };
        const jet_pair x = JET_PAIR(z.x), y = JET_PAIR(z.y);
        tape_field(&plane, z, &f);
        tape_jacobian(&plane, z, &J);
        tape_rate(&plane, 0, z, &rate[0], NULL);
        tape_rate(&plane, 0, z, &rate[1], &slope);
        tape_jet(&plane, &w, 0, &x, &y, &fx, &fy);
        tape_jet_rate(&plane, 0, &w, 0, &x, &y, &r);
        assert_memory_equal(&f, &J.field, sizeof f);
        assert_true(rate[0] == rate[1]);
        for (int l = 0; l < JET_LANES; l++)
            CHECK(fx[l] == f.direction.x && fy[l] == f.direction.y &&
                      w.log_scale[l] == f.log_scale,
                  "%s | %s: %.17g %.17g exp(%.17g), not %.17g %.17g exp(%.17g)",
                  c->rate[0], c->rate[1], fx[l], fy[l], w.log_scale[l],
                  f.direction.x, f.direction.y, f.log_scale);
    }
}

/* A rate of which the exponent is no number is none either. */
static void what_is_not_known_is_not_one(void **state)
{
    static struct jet_work w;
    const struct plane_case *c = &planes[0];
    const quad at[2] = { 0, 0 };
    const jet_pair x = JET_PAIR(0.1), y = JET_PAIR(0.2);
    jet_pair fx, fy, r;
    double rate;

    (void) state;
    make(c->rate, c->positive, c->observable, false, at);
    plane.t.rate[2].exponent[0].constant = NAN;
    plane.t.rate[2].exponent[1].constant = NAN;
    tape_rate(&plane, 0, (struct vec2){ 0.1, 0.2 }, &rate, NULL);
    tape_jet(&plane, &w, 0, &x, &y, &fx, &fy);
    tape_jet_rate(&plane, 0, &w, 0, &x, &y, &r);
    assert_true(isnan(rate) && isnan(r[0]) && isnan(r[1]));
}

/* Two curves x + t s, y + t s^2/2 - s of which the series are added up at s. */
static void a_series_adds_up_to_the_field_along_the_curve(void **state)
{
    static struct jet_work w;
    static jet_pair x[JET_SIZE], y[JET_SIZE], f[3][JET_SIZE];
    uint64_t seed = check_seed();
    const double at_s = 0.01;

    (void) state;
    for (int n = 0; n < 20 * PLANES; n++) {
        const struct plane_case *c = &planes[n % PLANES];
        double anchor[2], to[2][2], t[2];
        draw(c, &seed, anchor);
        const quad at[2] = { anchor[0], anchor[1] };
        make(c->rate, c->positive, c->observable, n % 2, at);
        const struct planar s = tape_planar(&plane);
        memset(x, 0, sizeof x);
        memset(y, 0, sizeof y);
        for (int i = 0; i < JET_LANES; i++) {
            draw(c, &seed, to[i]);
            t[i] = check_uniform(&seed, -1, 1);
            x[0][i] = to[i][0] - anchor[0];
            y[0][i] = to[i][1] - anchor[1];
            x[1][i] = t[i];
            y[1][i] = -1;
            y[2][i] = t[i] / 2;
        }
        w.linear = n % 3 ? x : NULL;
        w.used = 0;
        for (size_t k = 0; k < JET_SIZE; k++) {
            s.jet(s.ctx, &w, k, x, y, f[0], f[1]);
            s.rate_jet(s.ctx, 0, &w, k, x, y, f[2]);
        }
        for (int i = 0; i < JET_LANES; i++) {
            const struct vec2 z = { x[0][i] + t[i] * at_s,
                                    y[0][i] - at_s + t[i] / 2 * at_s * at_s };
            struct planar_field field;
            double exact[3], u[JET_SIZE];
            s.field(s.ctx, z, &field);
            s.rate_gradient(s.ctx, 0, z, &exact[2], NULL);
            const double e = exp(field.log_scale);
            exact[0] = field.direction.x * e;
            exact[1] = field.direction.y * e;
            for (int j = 0; j < 3; j++) {
                jet_take(JET_SIZE - 1, f[j], (size_t) i, u);
                const double found =
                    jet_at(JET_SIZE - 1, u, at_s) * exp(w.log_scale[i]);
                CHECK(fabs(found - exact[j]) <= 1e-11 * (1 + fabs(exact[j])),
                      "%s | %s, %d: %.17g, field %.17g", c->rate[0], c->rate[1],
                      j, found, exact[j]);
            }
        }
    }
}

/* ---- registers of two widths --------------------------------------------- */

static void series_are_the_same_bits_on_registers_of_any_width(void **state)
{
    static struct jet_work w;
    static jet_pair at[2][JET_SIZE], f[2][3][JET_SIZE];
    uint64_t seed = check_seed();

    (void) state;
    if (!tape_jet_wide())
        skip();
    for (int n = 0; n < PLANES; n++) {
        const struct plane_case *c = &planes[n];
        double at_anchor[2];
        draw(c, &seed, at_anchor);
        const quad anchor[2] = { at_anchor[0], at_anchor[1] };
        make(c->rate, c->positive, c->observable, false, anchor);
        for (int i = 0; i < 2; i++)
            for (size_t k = 0; k < JET_SIZE; k++)
                for (int l = 0; l < JET_LANES; l++)
                    at[i][k][l] = ldexp(check_uniform(&seed, -1, 1), -(int) k);
        for (int wide = 0; wide < 2; wide++)
            for (size_t k = 0; k < JET_SIZE; k++) {
                plane.wide = wide;
                tape_jet(&plane, &w, k, at[0], at[1], f[wide][0], f[wide][1]);
                tape_jet_rate(&plane, 0, &w, k, at[0], at[1], f[wide][2]);
            }
        assert_memory_equal(f[0], f[1], sizeof f[0]);
    }
}

/* ---- over intervals ------------------------------------------------------ */

enum { ORDER = 4 };

static void set(struct interval_graph *g, const char *leaf, double x)
{
    mpfi_t value;

    mpfi_init2(value, 160);
    mpfi_set_d(value, x);
    interval_graph_set(g, leaf, value);
    mpfi_clear(value);
}

static void over_intervals(const struct plane_case *c, const double anchor[2],
                           struct interval_graph *g, struct interval_tape *t)
{
    static const int observable[] = { 2 };
    struct fault why = { "" };

    CHECK(lower(c->rate, c->positive, c->observable, false, &why) == STATUS_OK,
          "%s", why.text);
    assert_int_equal(interval_graph_init(g, &lowered.f, lowered.t.needs, 160),
                     STATUS_OK);
    for (int i = 0; i < 2; i++) {
        set(g, parameters[i].name, (double) parameters[i].value);
        set(g, i ? "0 of y" : "0 of x", anchor[i]);
    }
    CHECK(interval_graph_run(g, &why) == STATUS_OK, "%s", why.text);
    assert_int_equal(interval_tape_init(t, &lowered.t, g, observable, 1),
                     STATUS_OK);
}

/* From z on along (1, rise), with a parameter in `box`. */
static void line(struct interval_tape *t, const double z[2], double rise,
                 struct interval box, struct interval_series out[3],
                 struct interval *factor)
{
    struct interval x[ORDER + 1] = { { 0, 0 } }, y[ORDER + 1] = { { 0, 0 } };
    double log_scale;

    x[0] = interval_add(interval_point(z[0]), box);
    y[0] = interval_add(interval_point(z[1]),
                        interval_times(interval_point(rise), box));
    x[1] = interval_point(1);
    y[1] = interval_point(rise);
    interval_tape_jet(t, ORDER, x, y, out, &log_scale);
    *factor = interval_exp(interval_point(log_scale));
}

/* The same by tape_jet, times e^log_scale. */
static void series_at(const double z[2], double rise, double out[3][ORDER + 1])
{
    static struct jet_work w;
    jet_pair x[ORDER + 1] = { JET_PAIR(z[0]), JET_PAIR(1) };
    jet_pair y[ORDER + 1] = { JET_PAIR(z[1]), JET_PAIR(rise) };
    jet_pair f[3][ORDER + 1];

    for (size_t k = 0; k <= ORDER; k++) {
        tape_jet(&plane, &w, k, x, y, f[0], f[1]);
        tape_jet_rate(&plane, 0, &w, k, x, y, f[2]);
        for (int i = 0; i < 3; i++)
            out[i][k] = f[i][k][0] * exp(w.log_scale[0]);
    }
}

static void enclosures_hold_rates_and_series_at_every_point(void **state)
{
    uint64_t seed = check_seed();

    (void) state;
    for (int n = 0; n < 40 * PLANES; n++) {
        const struct plane_case *c = &planes[n % PLANES];
        const double rise = check_uniform(&seed, -1, 1);
        const double half = pow(10, check_uniform(&seed, -9, -1.5));
        const double at = half * check_uniform(&seed, -1, 1);
        struct interval_series wide[3], thin[3];
        struct interval factor[2];
        struct interval_graph g;
        struct interval_tape t;
        double anchor[2], to[2], exact[3][ORDER + 1];
        draw(c, &seed, anchor);
        draw(c, &seed, to);
        over_intervals(c, anchor, &g, &t);
        make(c->rate, c->positive, c->observable, false,
             (const quad[]){ anchor[0], anchor[1] });
        const double z[] = { to[0] - anchor[0], to[1] - anchor[1] };
        line(&t, z, rise, interval_within(half), wide, &factor[0]);
        line(&t, z, rise, interval_point(at), thin, &factor[1]);
        series_at((const double[]){ z[0] + at, z[1] + rise * at }, rise, exact);
        for (int i = 0; i < 3; i++)
            for (int k = 0; k <= ORDER; k++) {
                const struct interval u =
                    interval_times(factor[0], wide[i].c[k]);
                const struct interval w =
                    interval_times(factor[1], thin[i].c[k]);
                const double truth = exact[i][k];
                const double off = 1e-10 * (1 + fabs(truth));
                CHECK(u.lo <= truth + off && truth - off <= u.hi,
                      "%s | %s, %d, order %d: [%Lg, %Lg] has no %g", c->rate[0],
                      c->rate[1], i, k, u.lo, u.hi, truth);
                CHECK(!interval_is_finite(w) ||
                          (w.lo <= truth + off && truth - off <= w.hi &&
                           w.hi - w.lo <= 1e-8 * (1 + interval_most(w))),
                      "%s | %s, %d, order %d: [%.20Lg, %.20Lg] has no %.17g",
                      c->rate[0], c->rate[1], i, k, w.lo, w.hi, truth);
            }
        interval_tape_free(&t);
        interval_graph_free(&g);
    }
}

/* Of 1e6 e^x six digits are left at x = -12, if 1e6 is not taken from it and
 * added again since e^(e^x - 2 e^y), which has no value at the anchor, is not
 * small. */
static void exponents_forget_the_anchor_beside_growths_that_have_none(
    void **state)
{
    const char *const rate[2] = { "exp(1e6*exp(x) + exp(exp(x) - 2*exp(y)))",
                                  "-y" };
    const struct vec2 z = { -12.0, -3.0 };
    struct planar_field f;

    (void) state;
    make(rate, (bool[2]){ false, false }, NULL, false, (quad[2]){ 0, 0 });
    tape_field(&plane, z, &f);
    const quad found = (quad) f.direction.x * expq(f.log_scale),
               true_rate = plain(rate[0], z.x, z.y);
    CHECK(fabsq(found / true_rate - 1) < 1e-14, "%.17g is off by %.3g",
          (double) true_rate, (double) (found / true_rate - 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(field_and_gradients_are_those_of_the_formulas),
        cmocka_unit_test(about_an_equilibrium_fields_are_those_of_the_formulas),
        cmocka_unit_test(a_field_is_the_same_bits_whoever_asks),
        cmocka_unit_test(what_is_not_known_is_not_one),
        cmocka_unit_test(a_series_adds_up_to_the_field_along_the_curve),
        cmocka_unit_test(series_are_the_same_bits_on_registers_of_any_width),
        cmocka_unit_test(enclosures_hold_rates_and_series_at_every_point),
        cmocka_unit_test(
            exponents_forget_the_anchor_beside_growths_that_have_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
