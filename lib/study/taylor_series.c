/* The series of the log chart, y = sum a_k x^k (local.h), taken to linear
 * coordinates in long double: x = ln(1 + w) put in, then e^y where psi is not
 * a logarithm (Knuth, TAOCP 2, 4.7).  Radius: the ratio test, its straight
 * line in 1/k (Domb & Sykes, Proc. R. Soc. A 240, 1957, 214-228), and the root
 * test between two envelopes; their spread is the error, because 31
 * coefficients may not have settled yet. */
#include "taylor_series.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "study_results.h"
#include "study_tolerance.h"

enum { LAST = JET_SIZE - 1 };

const struct record_type record_taylor_term = RECORD(
    taylor_term, "taylor_term", "power series of the stable manifold",
    FIELD(taylor_term, COUNT, order, "1", "power of w = (v - v_sp)/v_sp"),
    FIELD(taylor_term, QUANTITY, coefficient, "1",
          "coefficient of w^order in psi"));

const struct record_type record_taylor = RECORD(
    taylor_series, "taylor_series", "power series of the stable manifold in v",
    FIELD(taylor_series, QUANTITY, radius, "V_star",
          "radius of convergence, in v, around v_sp"),
    FIELD(taylor_series, QUANTITY, agrees_from, "V_star",
          "least v where order 14 is within 1 % of the curve"),
    FIELD(taylor_series, QUANTITY, agrees_to, "V_star",
          "largest v where order 14 is within 1 % of the curve"));

/* ---- series ------------------------------------------------------------ */

typedef long double power[JET_SIZE];

/* out = out * x, truncated. */
static void multiply(power out, const power x)
{
    for (int k = LAST; k >= 0; k--) {
        long double sum = 0.0L;
        for (int j = 0; j <= k; j++)
            sum += out[j] * x[k - j];
        out[k] = sum;
    }
}

/* outer(inner(w)), inner[0] = 0, by Horner. */
static void compose(const power outer, const power inner, power out)
{
    for (int k = 0; k <= LAST; k++)
        out[k] = 0.0L;
    for (int k = LAST; k >= 0; k--) {
        multiply(out, inner);
        out[0] += outer[k];
    }
}

/* e^y - 1, y[0] = 0. */
static void exponential(const power y, power out)
{
    out[0] = 1.0L;
    for (int k = 1; k <= LAST; k++) {
        out[k] = 0.0L;
        for (int j = 1; j <= k; j++)
            out[k] += (long double) j * y[j] * out[k - j];
        out[k] /= (long double) k;
    }
    out[0] = 0.0L;
}

/* y(x) from x(y), both without constant term: coefficient k of x(y(x)) = x
 * holds y_k only as x_1 y_k. */
static void revert(const power x, power y)
{
    power all;

    for (int k = 0; k <= LAST; k++)
        y[k] = k == 1 ? 1.0L / x[1] : 0.0L;
    for (int k = 2; k <= LAST; k++) {
        compose(x, y, all);
        y[k] = -all[k] / x[1];
    }
}

/* y over x in the chart; each coefficient of u off by up to `nudge`, up and
 * down in turn. */
static void chart_series(const struct local_series *u, long double nudge,
                         power a)
{
    power c;

    for (int k = 0; k <= LAST; k++)
        c[k] = (long double) u->c[k] / powl((long double) u->unit, k) *
               (1.0L + (k % 2 ? nudge : -nudge));
    c[0] = 0.0L;
    if (u->ind == 1)
        revert(c, a);
    for (int k = 0; u->ind == 0 && k <= LAST; k++)
        a[k] = c[k];
}

/* The coefficients in w. */
static void linear_series(const struct local_series *u, long double nudge,
                          bool psi_is_log, power e)
{
    power a, x, y;

    chart_series(u, nudge, a);
    x[0] = 0.0L;
    for (int k = 1; k <= LAST; k++)
        x[k] = (k % 2 ? 1.0L : -1.0L) / (long double) k;
    compose(a, x, y);
    if (psi_is_log)
        memcpy(e, y, sizeof y);
    else
        exponential(y, e);
}

/* What roundoff in each coefficient of u may do: as if no term cancelled
 * another, and what a change of all of them does. */
static void rounding_of(const struct local_series *u, bool psi_is_log,
                        const power e, power error)
{
    const long double nudge = TOL_ROUNDINGS_MANY * DBL_EPSILON;
    power a, x, y, all;

    chart_series(u, 0.0L, a);
    for (int k = 0; k <= LAST; k++) {
        a[k] = fabsl(a[k]);
        x[k] = k ? 1.0L / (long double) k : 0.0L;
    }
    compose(a, x, y);
    exponential(y, all);
    linear_series(u, nudge, psi_is_log, error);
    for (int k = 0; k <= LAST; k++)
        error[k] = fabsl(error[k] - e[k]) +
                   nudge * (psi_is_log ? fabsl(y[k]) : all[k]);
}

double taylor_series_at(const struct taylor_series *t, size_t order, double v,
                        double v_sp)
{
    const double w = (v - v_sp) / v_sp;
    double sum = 0.0;

    for (size_t k = order + 1; k-- > 0;)
        sum = sum * w + t->term[k].coefficient.value;
    return sum;
}

/* ---- radius ------------------------------------------------------------ */

/* Largest |e_k| of the four up to k. */
static double envelope(const power e, int k)
{
    double most = 0.0;

    for (int j = k - 3; j <= k; j++)
        most = fmax(most, (double) fabsl(e[j] / e[1]));
    return most;
}

/* In units of v_sp. */
static struct quantity radius_of(const power e, double bound)
{
    const double ratio = (double) fabsl(e[LAST - 1] / e[LAST]);
    const double before = (double) fabsl(e[LAST - 2] / e[LAST - 1]);
    const double line = 1.0 / (LAST / ratio - (LAST - 1) / before);
    const int half = LAST / 2;
    const double root =
        pow(envelope(e, half) / envelope(e, LAST), 1.0 / (LAST - half));

    if (!isfinite(root) || root == 0.0)
        return quantity_none("the last coefficients vanish: no test applies");
    const bool settled = line > TOL_CLEARLY * root && TOL_CLEARLY * line < root;
    const double value = fmin(settled ? line : root, bound);
    double error = fabs(root - value);
    if (settled)
        error = fmax(error, fmax(fabs(ratio - value), fabs(line - value)));
    else
        error = fmax(error, (1.0 - TOL_CLEARLY) * value);
    if (isfinite(bound))
        error = fmax(error, bound - value);
    return quantity_of(value, error);
}

/* ---- against the curve -------------------------------------------------- */

/* Where the sum is compared with the curve. */
struct comparison {
    const struct study *s;
    const struct taylor_series *t;
    const struct curve *c;
};

/* A point of the curve: v, how far the sum is from it, and how much of that
 * may be the sum's error and the curve's, which is that of either coordinate at
 * the other: in y no more than max(1, |dy/dx|) times as much. */
struct gap {
    double v, size, share;
};

/* Of the sum, with its rounding. */
static double doubt_of(const struct taylor_series *t, double w)
{
    double sum = 0.0;

    for (int k = TAYLOR_PAPER; k >= 0; k--) {
        const struct quantity *c = &t->term[k].coefficient;
        sum = sum * fabs(w) + c->error +
              TOL_ROUNDINGS * DBL_EPSILON * fabs(c->value);
    }
    return sum;
}

static struct gap gap_at(const struct comparison *q, size_t piece, double theta)
{
    const struct block *b = &q->s->slider.block;
    const bool is_log = law_psi_is_log(&b->law);
    const struct curve_piece *p = &q->c->piece[piece];
    double at[CURVE_DIM_MAX], by[CURVE_DIM_MAX];

    curve_at(q->c, piece, theta, at);
    curve_slope_at(q->c, piece, theta, by);
    const double v = block_v(b, at[0]), off = block_psi(b, at[1]);
    const double psi = is_log ? 1.0 : off;
    const double sum = taylor_series_at(q->t, TAYLOR_PAPER, v, b->at.v0);
    const double across = p->error * fmax(1.0, fabs(by[1] / by[0]));
    const double own = doubt_of(q->t, (v - b->at.v0) / b->at.v0) / psi;
    return (struct gap){ v, fabs(sum - off) / psi,
                         own + across * (is_log ? 1.0 : sum / psi) };
}

static bool is_below(struct gap g, double times)
{
    return g.size + times * g.share < TOL_LITTLE;
}

/* Where the gap, with `times` its share, first reaches TOL_LITTLE, outward from
 * the saddle; whether it does before the curve ends, which *at is then. */
static bool reaches(const struct comparison *q, double times, struct gap *at)
{
    enum { PER_PIECE = 16, HALVINGS = DBL_MANT_DIG };
    double lo = 0.0;

    for (size_t i = 0; i < q->c->count; i++, lo = 0.0)
        for (int k = 1; k <= PER_PIECE; k++) {
            double hi = (double) k / PER_PIECE;
            *at = gap_at(q, i, hi);
            if (is_below(*at, times)) {
                lo = hi;
                continue;
            }
            for (int n = 0; n < HALVINGS; n++) {
                const double middle = 0.5 * (lo + hi);
                *(is_below(gap_at(q, i, middle), times) ? &lo : &hi) = middle;
            }
            *at = gap_at(q, i, hi);
            return true;
        }
    return false;
}

/* Where the true gap first reaches TOL_LITTLE: |gap - size| <= share, so not
 * before size + share does and not after size - share does; and where psi has
 * no limit, at `end`, the sum has one, so before that. */
static struct quantity leaves(const struct comparison *q,
                              const struct quantity *end)
{
    struct gap at, early, late;
    const bool may = reaches(q, 1.0, &early);

    if (!may && !quantity_exists(end))
        return quantity_none("order 14 agrees with the curve to its end");
    if (!reaches(q, -1.0, &late)) {
        if (!quantity_exists(end))
            return quantity_none("whether order 14 leaves the curve is not "
                                 "told at this accuracy");
        late.v = end->value + copysign(end->error, end->value - early.v);
    }
    if (!reaches(q, 0.0, &at))
        at = late;
    return quantity_of(at.v, fmax(fabs(early.v - at.v), fabs(late.v - at.v)) +
                                 TOL_ROUNDINGS * DBL_EPSILON * at.v);
}

static struct taylor_series no_series(void)
{
    const struct quantity none =
        quantity_none("there is no saddle at this slope");
    return (struct taylor_series){ .radius = none,
                                   .agrees_from = none,
                                   .agrees_to = none };
}

static void fill_terms(const struct study *s, const power e, const power error,
                       struct taylor_series *t)
{
    const struct block *b = &s->slider.block;
    const double unit = law_psi_is_log(&b->law) ? 1.0 : b->at.psi0;

    t->terms = JET_SIZE;
    for (int k = 0; k <= LAST; k++)
        t->term[k] =
            (struct taylor_term){ k, quantity_of((double) e[k] * unit,
                                                 (double) error[k] * unit) };
    t->term[0].coefficient = s->saddle_numbers.psi;
}

enum status taylor_series_find(const struct study *s, struct taylor_series *out)
{
    const struct carry none = { .count = 0 };
    const struct quantity *v_minus = &s->slider.critical.v_minus;
    struct taylor_series t = no_series();
    struct local_series u;
    power e, error;

    if (!slider_has_manifolds(&s->slider)) {
        *out = t;
        return STATUS_OK;
    }
    const enum status status = local_at(
        &s->slider.plane.system, phase_plane_saddle(&s->slider.plane),
        MANIFOLD_STABLE, &none, LAST, TOL_TAYLOR_STEP * s->scene->rtol, &u);
    if (status != STATUS_OK)
        return status;
    linear_series(&u, 0.0L, law_psi_is_log(&s->slider.block.law), e);
    rounding_of(&u, law_psi_is_log(&s->slider.block.law), e, error);
    fill_terms(s, e, error, &t);
    const double v_sp = s->slider.block.at.v0;
    t.radius =
        radius_of(e, quantity_exists(v_minus) ? 1.0 - v_minus->value / v_sp
                                              : (double) INFINITY);
    t.radius.value *= v_sp;
    t.radius.error *= v_sp;
    t.agrees_from = leaves(
        &(struct comparison){ s, &t, &s->stable[SIDE_LOWER].curve }, v_minus);
    t.agrees_to =
        leaves(&(struct comparison){ s, &t, &s->stable[SIDE_UPPER].curve },
               &s->slider.critical.v_plus);
    *out = t;
    return STATUS_OK;
}

RESULT_VIEW(view_terms, study, s->taylor.term, s->taylor.terms)
RESULT_VIEW(view_series, study, &s->taylor, 1)

const struct result taylor_results[] = {
    { .path = "/taylor_series",
      .name = "taylor_series.terms",
      .text = "product taylor_series: the stable manifold as a power series in "
              "v",
      .shape = RESULT_COLUMNS,
      .axis = "order",
      .type = &record_taylor_term,
      .needs = ASKED_BY(TAYLOR),
      .view = view_terms },
    { .path = "/taylor_series",
      .name = "taylor_series",
      .title = "power series of the manifold in v - v_sp",
      .type = &record_taylor,
      .needs = ASKED_BY(TAYLOR),
      .view = view_series },
    { .path = NULL },
};
