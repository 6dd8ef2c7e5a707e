/* Closed forms (steady.h), verified by what they leave: with S = d mu_ss/d ln v
 * a root at x is good to |S(x)|/|S'|, S known to its rounding. */
#include "extremum.h"

#include <float.h>
#include <math.h>

#include "numbers_tolerance.h"
#include "response.h"
#include "steady.h"
#include "tolerance.h"

const char *const extremum_names[] = { "maximum", "minimum", NULL };

const struct record_type record_extremum = RECORD(
    extremum, "extrema", "extrema of steady-state friction",
    FIELD_CODE(extremum, kind, extremum_names, "which kind of extremum"),
    FIELD(extremum, QUANTITY, v, "V_star", "slip rate in units of V_star"),
    FIELD(extremum, QUANTITY, psi, "psi", "interfacial state"),
    FIELD(extremum, QUANTITY, mu, "1",
          "steady-state friction coefficient mu_ss(v)"),
    FIELD(extremum, QUANTITY, alpha, "rad",
          "slope angle atan mu of the fold, (16)"));

struct quantity extremum_angle(const struct quantity *mu)
{
    const double alpha = atan(mu->value);

    if (!(mu->value > 0.0))
        return quantity_none("mu_ss is not positive there");
    return quantity_of(alpha, mu->error / (1.0 + mu->value * mu->value) +
                                  2.0 * DBL_EPSILON * alpha);
}

/* How far apart differences are taken: safely within what lies between x[i]
 * and its neighbours. */
static long double reach(const long double x[], size_t n, size_t i)
{
    long double h = TOL_EXTREMUM_REACH;

    if (i > 0)
        h = fminl(h, (x[i] - x[i - 1]) / 4);
    if (i + 1 < n)
        h = fminl(h, (x[i + 1] - x[i]) / 4);
    return h;
}

static struct extremum extremum_at(const struct law *law,
                                   const struct material *m, long double x,
                                   long double h)
{
    const struct response at = response_at(law, m, x);
    const long double bend =
        (response_at(law, m, x + h).slope - response_at(law, m, x - h).slope) /
        (2 * h);
    const double off =
        2.0 * (double) ((fabsl(at.slope) + at.slope_error) / fabsl(bend));
    const double v = (double) expl(x), psi = (double) steady_psi(law, m, x);
    const double mu = (double) steady_mu(law, m, x);
    struct extremum e = {
        .kind = bend < 0 ? EXTREMUM_MAXIMUM : EXTREMUM_MINIMUM,
        .v = quantity_of(v, v * (off + 2.0 * DBL_EPSILON)),
        .psi = quantity_of(psi, 2.0 * off * fmax(fabs(psi), 1.0) +
                                    2.0 * DBL_EPSILON * fabs(psi)),
        .mu = quantity_of(mu, 2.0 * DBL_EPSILON * fabs(mu) +
                                  (double) at.slope_error),
        .x = x,
    };

    e.alpha = extremum_angle(&e.mu);
    return e;
}

size_t extremum_find(const struct law *law, const struct material *m,
                     struct extremum out[EXTREMA_MAX])
{
    long double x[EXTREMA_MAX];
    const size_t all = steady_extrema(law, m, x);
    size_t n = 0;

    for (size_t i = 0; i < all; i++)
        if (fabsl(x[i]) <= (long double) LN_RANGE)
            out[n++] = extremum_at(law, m, x[i], reach(x, all, i));
    return n;
}
