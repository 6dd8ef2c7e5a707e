/* The curve is fitted as y = p0 + p1 z + p2 z^2, z = -1..1 over the slopes
 * measured, whose parameters exist and have a regular covariance also where
 * the roots meet, are complex, or far away; the roots and their covariance
 * follow, dr = -dy(r)/y'(r). */
#include "parabola.h"

#include <math.h>

#include "tolerance.h"

const struct record_type record_parabola = RECORD(
    parabola, "parabola", "fit of (33) to critical release distances",
    FIELD(parabola, QUANTITY, mu_s, "1",
          "static friction, the larger root of (33) (95 %)"),
    FIELD(parabola, REAL, mu_s_low, "1",
          "lower end of the 95 % interval of mu_s"),
    FIELD(parabola, REAL, mu_s_high, "1",
          "upper end of the 95 % interval of mu_s"),
    FIELD(parabola, QUANTITY, mu_half, "1",
          "mu_ss(V_star/2), the smaller root of (33) (95 %)"),
    FIELD(parabola, REAL, mu_half_low, "1",
          "lower end of the 95 % interval of mu_half"),
    FIELD(parabola, REAL, mu_half_high, "1",
          "upper end of the 95 % interval of mu_half"),
    FIELD(parabola, QUANTITY, factor, "m",
          "eta L/(K (b - a)), the factor of (33) (95 %)"),
    FIELD(parabola, REAL, factor_low, "m",
          "lower end of the 95 % interval of factor"),
    FIELD(parabola, REAL, factor_high, "m",
          "upper end of the 95 % interval of factor"),
    FIELD(parabola, QUANTITY, mu_middle, "1",
          "half the sum of the roots (95 %)"),
    FIELD(parabola, REAL, mu_s_deviation, "1", "standard deviation of mu_s"),
    FIELD(parabola, REAL, mu_half_deviation, "1",
          "standard deviation of mu_half"),
    FIELD(parabola, REAL, factor_deviation, "m",
          "standard deviation of factor"),
    FIELD(parabola, REAL, mu_s_mu_half, "1", "covariance of mu_s and mu_half"),
    FIELD(parabola, REAL, mu_s_factor, "m", "covariance of mu_s and factor"),
    FIELD(parabola, REAL, mu_half_factor, "m",
          "covariance of mu_half and factor"),
    FIELD(parabola, COUNT, points, "1", "points fitted"),
    FIELD(parabola, COUNT, freedom, "1", "degrees of freedom"),
    FIELD(parabola, REAL, chi2, "1", "sum of squares in units of the errors"),
    FIELD(parabola, REAL, scatter, "1",
          "relative standard deviation of one l_k"),
    FIELD(parabola, REAL, chance, "1", "chance of a chi2 as large or larger"),
    FIELD(parabola, TEXT, warning, "1", "what the data cannot tell"));

/* ---- the curve ----------------------------------------------------------- */

enum { PARAMETERS = 3 };

/* The fit, and its units: t = middle + width z, l t = height y. */
struct bow {
    double middle, width, height;
    struct least least;
};

/* The terms that the parameters multiply. */
static void terms_at(double z, double term[PARAMETERS])
{
    term[0] = 1.0;
    term[1] = z;
    term[2] = z * z;
}

static double sum_of(const double p[], const double term[])
{
    return p[0] * term[0] + p[1] * term[1] + p[2] * term[2];
}

static void curve(const void *ctx, double t, const double p[], double *value,
                  double gradient[])
{
    const struct bow *b = ctx;
    const double scale = b->height / t;

    terms_at((t - b->middle) / b->width, gradient);
    *value = scale * sum_of(p, gradient);
    for (int i = 0; i < PARAMETERS; i++)
        gradient[i] *= scale;
}

static struct bow bow_for(const struct measured *m)
{
    double lo = m->x[0], hi = m->x[0], height = 0.0;

    for (size_t i = 0; i < m->count; i++) {
        lo = fmin(lo, m->x[i]);
        hi = fmax(hi, m->x[i]);
        height = fmax(height, m->x[i] * m->value[i]);
    }
    return (struct bow){
        .middle = 0.5 * (lo + hi),
        .width = 0.5 * (hi - lo),
        .height = height,
        .least = { .parameters = PARAMETERS, .p = { 0.5, -0.5, 0.1 } },
    };
}

/* Covariance of two numbers with these gradients by the parameters. */
static double covariance_of(const struct least *f, const double a[],
                            const double b[])
{
    double sum = 0.0;

    for (size_t i = 0; i < PARAMETERS; i++)
        for (size_t k = 0; k < PARAMETERS; k++)
            sum += a[i] * f->covariance[i][k] * b[k];
    return sum;
}

/* ---- intervals of the roots ---------------------------------------------- */

static bool band_holds_zero(const struct least *f, double z)
{
    double term[PARAMETERS];

    terms_at(z, term);
    const double y = sum_of(f->p, term);
    return y * y <= f->quantile * f->quantile * covariance_of(f, term, term);
}

/* From a root outward to where the band leaves zero: steps that grow from a
 * small part of `width`, then bisection.  Infinite if never. */
static double band_end(const struct least *f, double root, double width)
{
    double in = root, step = FIT_BAND_STEP * width;

    if (width == 0.0)
        return root;
    while (band_holds_zero(f, in + step)) {
        in += step;
        step *= FIT_BAND_GROWTH;
        if (fabs(in) > FIT_BAND_FAR)
            return copysign((double) INFINITY, width);
    }
    double out = in + step;
    for (int i = 0; i < FIT_BAND_HALVINGS; i++) {
        const double middle = 0.5 * (in + out);
        *(band_holds_zero(f, middle) ? &in : &out) = middle;
    }
    return in;
}

/* ---- what is reported ---------------------------------------------------- */

/* A root in tan alpha, and how it changes with the parameters. */
struct root {
    struct quantity value;
    double low, high, deviation;
    double gradient[PARAMETERS];
};

static struct root root_at(const struct bow *b, double z)
{
    const struct least *f = &b->least;
    const double at = b->middle + b->width * z;
    const double slope = (f->p[1] + 2.0 * f->p[2] * z) / b->width;
    struct root r;

    terms_at(z, r.gradient);
    for (int i = 0; i < PARAMETERS; i++)
        r.gradient[i] /= -slope;
    r.deviation = sqrt(covariance_of(f, r.gradient, r.gradient));
    const double width = f->quantile * r.deviation / b->width;
    r.low = b->middle + b->width * band_end(f, z, -width);
    r.high = b->middle + b->width * band_end(f, z, width);
    r.value = quantity_of(at, fmax(at - r.low, r.high - at));
    return r;
}

/* Of p0 + p1 z + p2 z^2, whose discriminant is d^2 > 0: the further from zero
 * first, the other without cancellation. */
static void find_roots(const struct bow *b, double d, struct parabola *out)
{
    const struct least *f = &b->least;
    const double *p = f->p;
    const double far = -0.5 * (p[1] + copysign(d, p[1])), one = far / p[2],
                 other = p[0] / far;
    const struct root s = root_at(b, fmax(one, other));
    const struct root h = root_at(b, fmin(one, other));
    const double unit = b->height / (b->width * b->width);
    const double factor[] = { 0.0, 0.0, unit };

    out->mu_s = s.value;
    out->mu_s_low = s.low;
    out->mu_s_high = s.high;
    out->mu_s_deviation = s.deviation;
    out->mu_half = h.value;
    out->mu_half_low = h.low;
    out->mu_half_high = h.high;
    out->mu_half_deviation = h.deviation;
    out->mu_s_mu_half = covariance_of(f, s.gradient, h.gradient);
    out->mu_s_factor = covariance_of(f, s.gradient, factor);
    out->mu_half_factor = covariance_of(f, h.gradient, factor);
}

/* Half the sum of the roots, -p1/(2 p2). */
static struct quantity find_middle(const struct bow *b)
{
    const double *p = b->least.p;
    const double z = -0.5 * p[1] / p[2], unit = b->width / p[2];
    const double gradient[] = { 0.0, -0.5 * unit, -z * unit };

    return quantity_of(b->middle + b->width * z,
                       b->least.quantile *
                           sqrt(covariance_of(&b->least, gradient, gradient)));
}

static const char *warning_of(const struct parabola *p)
{
    if (!quantity_exists(&p->mu_s))
        return "the data cannot tell the two roots apart: only their middle "
               "is known";
    if (p->mu_half_high >= p->mu_s.value || p->mu_s_low <= p->mu_half.value)
        return "the data cannot tell the two roots apart: their 95 % intervals "
               "are one";
    if (isinf(p->mu_s_high) || !(p->factor_low > 0.0))
        return "the data do not show the bend of the parabola: mu_s has no "
               "upper bound";
    if (p->chance < FIT_CHANCE)
        return "the data scatter more about (33) than their errors say";
    return NULL;
}

/* Nothing but a reason. */
static struct parabola no_fit(const char *reason)
{
    struct parabola p = { .warning = reason };

    record_absent(&record_parabola, &p, reason);
    return p;
}

static struct parabola report(const struct bow *b)
{
    const struct least *f = &b->least;
    const double unit = b->height / (b->width * b->width);
    const double d2 = f->p[1] * f->p[1] - 4.0 * f->p[0] * f->p[2];
    struct parabola p =
        no_fit("the parabola that fits best has no two real roots");

    p.factor_deviation = unit * sqrt(f->covariance[2][2]);
    p.factor = quantity_of(unit * f->p[2], f->quantile * p.factor_deviation);
    p.factor_low = p.factor.value - p.factor.error;
    p.factor_high = p.factor.value + p.factor.error;
    p.mu_middle = find_middle(b);
    p.freedom = (int64_t) f->freedom;
    p.chi2 = f->chi2;
    p.scatter = f->scatter;
    p.chance = f->chance;
    if (d2 > 0.0)
        find_roots(b, sqrt(d2), &p);
    p.warning = warning_of(&p);
    return p;
}

/* ---- the fit ------------------------------------------------------------- */

enum status parabola_fit(const struct measured *m, struct parabola *out)
{
    static const char few[] =
        "too few slopes: (33) needs three different ones, and a fourth point "
        "where errors are not given";
    static const char bent[] =
        "the data bend the other way than (33), or not at all";

    if (!least_has_places(m, PARAMETERS) ||
        (m->error == NULL && m->count == PARAMETERS)) {
        *out = no_fit(few);
    } else {
        struct bow b = bow_for(m);
        const enum status s = least_fit(curve, &b, m, &b.least);
        if (s != STATUS_OK)
            return s;
        *out = b.least.p[2] > 0.0 ? report(&b) : no_fit(bent);
    }
    out->points = (int64_t) m->count;
    return STATUS_OK;
}
