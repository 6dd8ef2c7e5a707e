#include "persistence.h"

#include <math.h>

#include "estimates.h"
#include "tolerance.h"

const struct record_type record_persistence = RECORD(
    persistence, "persistence", "fit of (30) to persistence lengths",
    FIELD(persistence, QUANTITY, L, "m", "memory length (95 %)"),
    FIELD(persistence, REAL, L_low, "m", "lower end of the 95 % interval of L"),
    FIELD(persistence, REAL, L_high, "m",
          "upper end of the 95 % interval of L"),
    FIELD(persistence, QUANTITY, mu_star, "1", "friction at V_star (95 %)"),
    FIELD(persistence, REAL, mu_star_low, "1",
          "lower end of the 95 % interval of mu_star"),
    FIELD(persistence, REAL, mu_star_high, "1",
          "upper end of the 95 % interval of mu_star"),
    FIELD(persistence, REAL, L_deviation, "m", "standard deviation of L"),
    FIELD(persistence, REAL, mu_star_deviation, "1",
          "standard deviation of mu_star"),
    FIELD(persistence, REAL, L_mu_star, "m", "covariance of L and mu_star"),
    FIELD(persistence, COUNT, points, "1", "points fitted"),
    FIELD(persistence, COUNT, freedom, "1", "degrees of freedom"),
    FIELD(persistence, REAL, chi2, "1",
          "sum of squares in units of the errors"),
    FIELD(persistence, REAL, scatter, "1",
          "relative standard deviation of one x_k"),
    FIELD(persistence, REAL, chance, "1",
          "chance of a chi2 as large or larger"),
    FIELD(persistence, TEXT, warning, "1", "what the data cannot tell"));

enum { LENGTH, MU_STAR, PARAMETERS };

struct line {
    double scale, eta, b_minus_a; /* L in units of scale */
};

static void curve(const void *ctx, double t, const double p[], double *value,
                  double gradient[])
{
    const struct line *l = ctx;
    const double y = (p[MU_STAR] - t) / l->b_minus_a; /* ln v_sp0 */
    const double psi = exp(-y);
    const bool straight = y > FIT_STRAIGHT, gone = psi > FIT_GONE;
    const double x = l->scale * (straight ? l->eta * (M_LN2 + y)
                                          : estimates_persistence(l->eta, psi));
    const double part = straight ? 1.0 : gone ? 0.0 : psi / sinh(psi);

    *value = p[LENGTH] * x;
    gradient[LENGTH] = x;
    gradient[MU_STAR] = p[LENGTH] * l->scale * l->eta * part / l->b_minus_a;
}

static struct persistence no_fit(const char *reason)
{
    struct persistence p = { .warning = reason };

    record_absent(&record_persistence, &p, reason);
    return p;
}

static struct persistence report(const struct least *f, double scale)
{
    const double L = scale * f->p[LENGTH], mu = f->p[MU_STAR];
    const double of_L = scale * sqrt(f->covariance[LENGTH][LENGTH]);
    const double of_mu = sqrt(f->covariance[MU_STAR][MU_STAR]);

    return (struct persistence){
        .L = quantity_of(L, f->quantile * of_L),
        .mu_star = quantity_of(mu, f->quantile * of_mu),
        .L_low = L - f->quantile * of_L,
        .L_high = L + f->quantile * of_L,
        .mu_star_low = mu - f->quantile * of_mu,
        .mu_star_high = mu + f->quantile * of_mu,
        .L_deviation = of_L,
        .mu_star_deviation = of_mu,
        .L_mu_star = scale * f->covariance[LENGTH][MU_STAR],
        .freedom = (int64_t) f->freedom,
        .chi2 = f->chi2,
        .scatter = f->scatter,
        .chance = f->chance,
        .warning = f->chance < FIT_CHANCE ? "the data scatter more about (30) "
                                            "than their errors say"
                                          : NULL,
    };
}

enum status persistence_fit(const struct measured *m, double eta,
                            double b_minus_a, struct persistence *out)
{
    static const char few[] =
        "too few slopes: (30) needs two different ones, and a third point "
        "where errors are not given";
    static const char rising[] =
        "x_k does not fall as the slope grows, as (31) has it";
    static const char steady[] =
        "(30) needs b > a: friction that weakens with slip rate";
    struct line l = { .eta = eta, .b_minus_a = b_minus_a };
    struct least f = { .parameters = PARAMETERS };
    struct least_line start;
    enum status s = STATUS_OK;

    if (!(b_minus_a > 0.0)) {
        *out = no_fit(steady);
    } else if (!least_has_places(m, PARAMETERS) ||
               (m->error == NULL && m->count == PARAMETERS)) {
        *out = no_fit(few);
    } else if ((s = least_line(m, &start)) == STATUS_OK &&
               !(start.slope < 0.0)) {
        *out = no_fit(rising);
    } else if (s == STATUS_OK) {
        l.scale = -start.slope * b_minus_a / eta;
        f.p[LENGTH] = 1.0;
        f.p[MU_STAR] = -start.at_zero / start.slope - b_minus_a * M_LN2;
        s = least_fit(curve, &l, m, &f);
        if (s == STATUS_OK)
            *out = report(&f, l.scale);
    }
    if (s == STATUS_OK)
        out->points = (int64_t) m->count;
    return s;
}
