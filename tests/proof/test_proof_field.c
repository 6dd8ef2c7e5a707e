/* Rates over boxes, of every composition of the laws: their quotient holds that
 * of 113 bits at every point, their series over a box that at every point of
 * it, and what few bits tell what more bits do. */
#include "interval_tape.h"

#include "check.h"
#include "interval_math.h"
#include "law_graph.h"
#include "law_tape.h"
#include "proof_law.h"
#include "proof_tolerance.h"
#include "quad.h"
#include "slider.h"

enum { SLOPES = 40, POINTS = 40, ORDER = 6 };

struct around {
    struct slider slider;
    struct proof_law law;
    struct law_quad truth;
};

/* A slope with a saddle. */
static bool make(struct around *a, uint64_t *rng)
{
    struct material m = material_bristol_board();
    const size_t presets = 7;
    struct law law = *law_preset_at(check_bits(rng) % presets);
    const double alpha = check_uniform(rng, 0.2, 0.4);
    const struct proof_inputs in = { .slope_in = ANGLE_TAN,
                                     .slope = tan(alpha) };
    struct fault why;

    law.form = check_bits(rng) % 2 ? FRICTION_LOG : FRICTION_ASINH;
    slider_init(&a->slider, &law, &m, (long double) in.slope);
    if (a->slider.plane.saddles == 0)
        return false;
    assert_int_equal(proof_law_at(&a->law, &a->slider.block, &in, &why),
                     STATUS_OK);
    law_quad_init(&a->truth, &a->slider.block.law, &a->slider.block.material,
                  in.slope);
    return true;
}

/* ln of the ratio of both rates of the chart; false where one is 0. */
static bool truth_at(struct around *a, double X, double Y, formula_real *ratio)
{
    const formula_real x = a->slider.block.x + (formula_real) X;
    const formula_real y = a->slider.block.y + (formula_real) Y;
    const formula_real dx = law_quad_at(&a->truth, x, y, LAW_AT_DX);
    const formula_real dy = law_quad_at(&a->truth, x, y, LAW_AT_DY);

    *ratio = dy / dx;
    return isfinite((double) *ratio) && fabsq(*ratio) > 0x1p-1000L;
}

static void the_quotient_of_the_rates_is_that_of_113_bits(void **state)
{
    static struct around a;
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < SLOPES; i++) {
        if (!make(&a, &rng))
            continue;
        for (int k = 0; k < POINTS; k++) {
            const double size = pow(10, check_uniform(&rng, -3, 0.7));
            const double X = size * check_uniform(&rng, -1, 1);
            const double Y = size * check_uniform(&rng, -1, 1);
            const struct interval x[] = { interval_point(X) },
                                  y[] = { interval_point(Y) };
            struct interval_series out[3];
            formula_real truth;
            double log_scale;
            interval_tape_jet(&a.law.tape, 0, x, y, out, &log_scale);
            const struct interval q = interval_divide(out[1].c[0], out[0].c[0]);
            if (!truth_at(&a, X, Y, &truth))
                continue;
            /* the truth's saddle is that of a long double */
            const formula_real room = fabsq(truth) * 0x1p-40L;
            CHECK(q.lo <= truth + room && truth - room <= q.hi,
                  "%s at (%g, %g): [%.20Lg, %.20Lg] has no %.17g",
                  a.slider.block.law.preset, X, Y, q.lo, q.hi, (double) truth);
            CHECK(!(fabs(X) < 5 && fabs(Y) < 2) || !interval_is_finite(q) ||
                      q.hi - q.lo <= 1e-10 * interval_most(q) + 1e-300 ||
                      out[0].c[0].lo <= 0,
                  "%s at (%g, %g): [%.20Lg, %.20Lg]", a.slider.block.law.preset,
                  X, Y, q.lo, q.hi);
        }
        proof_law_free(&a.law);
    }
}

/* A line, dep = Y + slope t, over a box of t and at a point of it. */
static void check_line(struct around *a, uint64_t *rng)
{
    const double X = check_uniform(rng, -2, 2), Y = check_uniform(rng, -1, 1);
    const double rise = check_uniform(rng, -2, 2);
    const double half = pow(10, check_uniform(rng, -6, -1));
    const double t = half * check_uniform(rng, -1, 1);
    struct interval x[2][ORDER + 1] = { { { 0, 0 } } };
    struct interval y[2][ORDER + 1] = { { { 0, 0 } } };
    struct interval_series out[2][3];
    double log_scale[2];

    for (int i = 0; i < 2; i++) {
        const struct interval at =
            i == 0 ? interval_within(half) : interval_point(t);
        x[i][0] = interval_add(interval_point(X), at);
        y[i][0] = interval_add(interval_point(Y),
                               interval_times(interval_point(rise), at));
        x[i][1] = interval_point(1);
        y[i][1] = interval_point(rise);
        interval_tape_jet(&a->law.tape, ORDER, x[i], y[i], out[i],
                          &log_scale[i]);
    }
    const struct interval scale =
        interval_exp(interval_point(log_scale[1] - log_scale[0]));
    for (int i = 0; i < 3; i++)
        for (int k = 0; k <= ORDER; k++) {
            const struct interval wide = out[0][i].c[k];
            const struct interval thin = interval_times(out[1][i].c[k], scale);
            CHECK(wide.lo <= thin.hi && thin.lo <= wide.hi,
                  "%s, rate %d, order %d, at (%g, %g) +- %g: [%Lg, %Lg] has "
                  "no [%Lg, %Lg]",
                  a->slider.block.law.preset, i, k, X, Y, half, wide.lo,
                  wide.hi, thin.lo, thin.hi);
        }
}

static void a_series_over_a_box_holds_those_at_its_points(void **state)
{
    static struct around a;
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < SLOPES; i++) {
        if (!make(&a, &rng))
            continue;
        for (int k = 0; k < POINTS; k++)
            check_line(&a, &rng);
        proof_law_free(&a.law);
    }
}

/* ---- bits ---------------------------------------------------------------- */

enum { PRECISIONS = 3 };
static const int bits[PRECISIONS] = { 53, 113, 160 };
static const enum law_number asked[] = { LAW_AT_MU, LAW_AT_DX, LAW_AT_DY };

static void copy_leaves(const struct interval_graph *from,
                        struct interval_graph *to)
{
    for (int i = 0; i < from->nodes; i++) {
        const struct formula_node *n = &from->f->node[from->node[i]];
        if (n->kind == FORMULA_LEAF)
            interval_graph_set(to, n->name,
                               interval_graph_value(from, from->node[i]));
    }
}

/* The law's formulas to so many bits, its parameters as they are known. */
static void make_graph(const struct around *a, int precision,
                       struct interval_graph *g)
{
    bool needed[FORMULA_NODES] = { false };

    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++)
        needed[a->law.graph->node[asked[i]]] = true;
    assert_int_equal(
        interval_graph_init(g, &a->law.graph->f, needed, precision), STATUS_OK);
    copy_leaves(&a->law.at, g);
    copy_leaves(&a->law.state, g);
}

/* At an offset from the saddle. */
static void run_graph(const struct around *a, struct interval_graph *g,
                      double X, double Y)
{
    const struct plane_formulas *p = &a->law.lowered->p;
    struct fault why;
    mpfi_t at;

    mpfi_init2(at, PROOF_BITS);
    mpfi_add_d(at, interval_graph_value(&a->law.at, p->chart[0]), X);
    interval_graph_set(g, LAW_LNV0, at);
    mpfi_add_d(at, interval_graph_value(&a->law.at, p->chart[1]), Y);
    interval_graph_set(g, LAW_Y0, at);
    mpfi_clear(at);
    CHECK(interval_graph_run(g, &why) == STATUS_OK, "%s", why.text);
}

static double width_of(mpfi_srcptr u)
{
    mpfr_t width;

    mpfr_init2(width, 53);
    mpfi_diam_abs(width, u);
    const double out = mpfr_get_d(width, MPFR_RNDU);
    mpfr_clear(width);
    return out;
}

static void check_nesting(const struct around *a,
                          const struct interval_graph g[PRECISIONS])
{
    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++)
        for (int k = 0; k + 1 < PRECISIONS; k++) {
            const int node = a->law.graph->node[asked[i]];
            mpfi_srcptr wide = interval_graph_value(&g[k], node);
            mpfi_srcptr thin = interval_graph_value(&g[k + 1], node);
            CHECK(mpfi_is_inside(thin, wide) > 0,
                  "%s: number %zu of %d bits is not in that of %d",
                  a->slider.block.law.preset, i, bits[k + 1], bits[k]);
            CHECK(!isfinite(width_of(wide)) ||
                      width_of(thin) <=
                          ldexp(width_of(wide), bits[k] - bits[k + 1] + 10),
                  "%s: number %zu: %g of %d bits, %g of %d",
                  a->slider.block.law.preset, i, width_of(wide), bits[k],
                  width_of(thin), bits[k + 1]);
        }
}

/* The quotient of the rates in doubles has all of that to the most bits. */
static void check_tape(struct around *a, const struct interval_graph *most,
                       double X, double Y)
{
    const struct interval x[] = { interval_point(X) },
                          y[] = { interval_point(Y) };
    struct interval_series out[3];
    double log_scale;
    mpfi_t exact;

    interval_tape_jet(&a->law.tape, 0, x, y, out, &log_scale);
    const struct interval q = interval_divide(out[1].c[0], out[0].c[0]);
    mpfi_init2(exact, PROOF_BITS);
    mpfi_div(exact, interval_graph_value(most, a->law.graph->node[LAW_AT_DY]),
             interval_graph_value(most, a->law.graph->node[LAW_AT_DX]));
    CHECK(mpfr_cmp_ld(&exact->left, q.lo) >= 0 &&
              mpfr_cmp_ld(&exact->right, q.hi) <= 0,
          "%s at (%g, %g): [%.20Lg, %.20Lg] has not all of %.17g",
          a->slider.block.law.preset, X, Y, q.lo, q.hi, mpfi_get_d(exact));
    mpfi_clear(exact);
}

static void intervals_nest_as_bits_grow(void **state)
{
    static struct around a;
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < SLOPES / 2; i++) {
        struct interval_graph g[PRECISIONS];
        if (!make(&a, &rng))
            continue;
        for (int k = 0; k < PRECISIONS; k++)
            make_graph(&a, bits[k], &g[k]);
        for (int j = 0; j < POINTS; j++) {
            const double X = check_uniform(&rng, -2, 2);
            const double Y = check_uniform(&rng, -1, 1);
            for (int k = 0; k < PRECISIONS; k++)
                run_graph(&a, &g[k], X, Y);
            check_nesting(&a, g);
            check_tape(&a, &g[PRECISIONS - 1], X, Y);
        }
        for (int k = 0; k < PRECISIONS; k++)
            interval_graph_free(&g[k]);
        proof_law_free(&a.law);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_quotient_of_the_rates_is_that_of_113_bits),
        cmocka_unit_test(a_series_over_a_box_holds_those_at_its_points),
        cmocka_unit_test(intervals_nest_as_bits_grow),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
