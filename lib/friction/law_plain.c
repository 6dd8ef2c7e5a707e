/* Identities are held to TOL_IDENTITY at some places each: formulas that agree
 * there agree. */
#include "law_plain.h"

#include <math.h>
#include <string.h>

#include "friction_tolerance.h"
#include "law_root.h"
#include "slope.h"

/* All nodes at a place. */
struct place {
    const struct law_typed *t;
    long double value[FORMULA_NODES];
};

static void place_at(const struct law *law, const struct material *m,
                     long double tan_alpha, long double x, long double y,
                     struct place *p)
{
    struct formula_value leaf[LAW_VALUES];

    p->t = law->typed;
    law_values(law, m, tan_alpha, x, y, leaf);
    formula_long_constants(&p->t->plain, leaf, NULL, p->value);
}

struct law_plain_slope law_plain_slope(const struct law *law,
                                       const struct material *m,
                                       long double tan_alpha, long double x,
                                       long double y, const char *name)
{
    const struct formula *f = &law->typed->plain;
    const int leaf = formula_find(f, name, strlen(name));
    long double slope[FORMULA_NODES];
    struct law_plain_slope out;
    struct place p;

    place_at(law, m, tan_alpha, x, y, &p);
    formula_long_slopes(f, p.value, leaf, slope);
    for (int i = 0; i < 2; i++) {
        out.rate[i] = p.value[law->typed->chart_rate[i]];
        out.slope[i] = slope[law->typed->chart_rate[i]];
    }
    return out;
}

/* ---- identities ---------------------------------------------------------- */

static bool is_near(long double u, long double w)
{
    return fabsl(u - w) <= (long double) TOL_IDENTITY * (fabsl(u) + fabsl(w));
}

/* The chart's y of psi_ss. */
static long double steady(const struct law *law, const struct material *m,
                          long double x)
{
    return law_typed_steady(law, m, x).y;
}

bool law_plain_is_hyperbolic(const struct law *law, const struct material *m)
{
    const bool is_log = law->typed->real;
    struct place p;

    for (long double x = -1.5L; x < 4; x += 1.3L) {
        const long double y = steady(law, m, x);
        const long double psi = is_log ? y : expl(y);
        long double first = 0;
        for (int i = 0; i < 4; i++) {
            const long double d = (i < 2 ? 1 : -1) * (0.3L + 0.5L * i) *
                                  (is_log ? 1 : fminl(psi, 1) / 4);
            place_at(law, m, 0, x, is_log ? psi + d : logl(psi + d), &p);
            const long double part = p.value[p.t->psi_rate] / sinhl(d);
            first = i ? first : part;
            if (!is_near(part, first) || !(part < 0))
                return false;
        }
    }
    return true;
}

bool law_plain_theta_is_log(const struct law *law, const struct material *m)
{
    struct material bare = *m;
    struct place p, q;

    bare.c = 0;
    if (law->typed->theta == 0 || law->typed->real)
        return false;
    for (long double y = -3; y < 4; y += 1.7L) {
        place_at(law, &bare, 0, 0, y, &p);
        place_at(law, &bare, 0, 0, y + 1, &q);
        if (fabsl(q.value[q.t->theta] - p.value[p.t->theta] - 1) >
            (long double) TOL_IDENTITY)
            return false;
    }
    return true;
}

bool law_plain_is_spinodal(const struct law *law, const struct material *m)
{
    const long double R = (long double) m->R;
    long double first = 0;

    if (law->typed->real || !law_uses(law, MATERIAL_R))
        return false;
    for (int i = 0; i < 4; i++) {
        const long double x = -logl(R) - 2 + 1.7L * i;
        const long double top =
            law_typed_steady(law, m, x).psi * (1 + R * expl(x));
        first = i ? first : top;
        if (!is_near(top, first))
            return false;
    }
    return true;
}
