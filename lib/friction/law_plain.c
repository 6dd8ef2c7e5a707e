/* What laws have in common: compositions say it, formulas are held to
 * identities, to TOL_ROUNDED at some places each: those that agree there
 * agree. */
#include "law_graph.h"

#include <math.h>

#include "tolerance.h"

static bool is_near(long double u, long double w)
{
    return fabsl(u - w) <= (long double) TOL_ROUNDED * (fabsl(u) + fabsl(w));
}

/* dpsi/dt is -sinh(psi - psi_ss) times what does not depend on psi. */
static bool is_hyperbolic(const struct law *law, const struct material *m)
{
    const bool is_log = law_psi_is_log(law);
    struct law_long p;

    law_long_init(&p, law, m, 0);
    for (long double x = -1.5L; x < 4; x += 1.3L) {
        const long double psi = law_long_steady(&p, x, LAW_AT_PSI);
        long double first = 0;
        for (int i = 0; i < 4; i++) {
            const long double d = (i < 2 ? 1 : -1) * (0.3L + 0.5L * i) *
                                  (is_log ? 1 : fminl(psi, 1) / 4);
            const long double y = is_log ? psi + d : logl(psi + d);
            const long double part =
                law_long_at(&p, x, y, LAW_AT_GROWTH) / sinhl(d);
            first = i ? first : part;
            if (!is_near(part, first) || !(part < 0))
                return false;
        }
    }
    return true;
}

/* At c = 0 theta is ln psi but for a constant. */
static bool theta_is_log(const struct law *law, const struct material *m)
{
    struct material bare = *m;
    struct law_long p;

    bare.c = 0;
    if (law_text(law, LAW_THETA) == NULL || law_psi_is_log(law))
        return false;
    law_long_init(&p, law, &bare, 0);
    for (long double y = -3; y < 4; y += 1.7L)
        if (fabsl(law_long_at(&p, 0, y + 1, LAW_AT_THETA) -
                  law_long_at(&p, 0, y, LAW_AT_THETA) - 1) >
            (long double) TOL_ROUNDED)
            return false;
    return true;
}

/* psi_ss (1 + R v) does not depend on v. */
static bool is_spinodal(const struct law *law, const struct material *m)
{
    const long double R = (long double) m->R;
    long double first = 0;
    struct law_long p;

    if (law_psi_is_log(law) || !law_uses(law, MATERIAL_R))
        return false;
    law_long_init(&p, law, m, 0);
    for (int i = 0; i < 4; i++) {
        const long double x = -logl(R) - 2 + 1.7L * i;
        const long double top =
            law_long_steady(&p, x, LAW_AT_PSI) * (1 + R * expl(x));
        first = i ? first : top;
        if (!is_near(top, first))
            return false;
    }
    return true;
}

bool law_is_hyperbolic(const struct law *law, const struct material *m)
{
    return law->typed ? is_hyperbolic(law, m) && theta_is_log(law, m)
                      : law->kinetics == KINETICS_SINH && !law_psi_is_log(law);
}

bool law_is_spinodal(const struct law *law, const struct material *m)
{
    return law->typed ? is_spinodal(law, m) && theta_is_log(law, m)
                      : law->psi_ss == PSI_SS_SPINODAL ||
                            law->psi_ss == PSI_SS_SPINODAL_UNIT;
}
