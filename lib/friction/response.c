/* With f = d mu/d mu_log (1 in the log form (2)):
 *     direct = f a,   slope = f (a + b theta'(psi_ss) d psi_ss/d ln v).
 * Both kinetics have K'(0) = 1, so rate = 1/T(v); that of Kato & Tullis (2001)
 * is v (1 + ln(v psi)) where v psi ln(v psi) = exp(-v/V_c). */
#include "response.h"

#include <float.h>
#include <math.h>

#include "law_typed.h"
#include "steady.h"

#define SCALAR long double
#define FN(f)  f##l
#include "scalar.h"

/* ln(v psi_ss) of Kato & Tullis: W(exp(-v/V_c)), which is exp(-v/V_c) where
 * that is small. */
static long double composite(const struct law *law, const struct material *m,
                             long double x)
{
    const long double k = expl(x) / (long double) m->V_c;
    return k > 50 ? expl(-k) : steady_y(law, m, x) + x;
}

/* d psi_ss/d ln v */
static long double state_slope(const struct law *law, const struct material *m,
                               long double x)
{
    const long double psi = steady_psi(law, m, x), v = expl(x);

    switch (law->psi_ss) {
        case PSI_SS_INVERSE:
            return -psi;
        case PSI_SS_MINUS_LOG:
            return -1;
        case PSI_SS_LAMBERT: {
            const long double u = composite(law, m, x);
            return -psi * (1 + v / (long double) m->V_c * u / (1 + u));
        }
        default:
            return -psi * v / (1 / (long double) m->R + v);
    }
}

/* theta'(psi_ss) */
static long double theta_slope(const struct law *law, const struct material *m,
                               long double x)
{
    const long double psi = steady_psi(law, m, x), c = (long double) m->c;

    switch (law->theta) {
        case THETA_LN_PSI:
            return 1 / psi;
        case THETA_PSI:
            return 1;
        case THETA_LN_C_PSI:
            return 1 / (c + psi);
        default:
            return 1 / (c / (1 + (long double) m->R) + psi);
    }
}

/* ln of the rate. */
static long double log_rate(const struct law *law, const struct material *m,
                            long double x)
{
    if (law->kinetics == KINETICS_COMPOSITE)
        return x + log1pl(composite(law, m, x));
    return steady_log_rate(law, m, x) -
           (law_freezes(law) ? steady_psi(law, m, x) : 0);
}

struct response response_at(const struct law *law, const struct material *m,
                            long double x)
{
    if (law->typed)
        return law_typed_response(law, m, x);
    const long double a = (long double) m->a;
    const long double f =
        law->form == FRICTION_LOG
            ? 1
            : scalar_friction_slope(steady_mu_log(law, m, x) / a);
    const long double rate = log_rate(law, m, x);
    const long double evolution =
        (long double) m->b * theta_slope(law, m, x) * state_slope(law, m, x);

    return (struct response){
        .slope = f * (a + evolution),
        .direct = f * a,
        .rate = expl(rate),
        .slope_error = 16 * LDBL_EPSILON * f * (a + fabsl(evolution)),
        .rate_error = 8 * LDBL_EPSILON * (1 + fabsl(x) + fabsl(rate)),
    };
}
