/* At each c the extrema are closed forms (steady.h), and so is the cusp: there
 * is nothing to continue. */
#include "fold_curve.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "cusp.h"
#include "numbers_tolerance.h"
#include "steady.h"

const struct record_type record_fold_curve = RECORD(
    fold_point, "fold_curves", "folds of the steady states over c, Fig 4",
    FIELD(fold_point, REAL, c, "1", "residual strength c"),
    FIELD(fold_point, QUANTITY, alpha_cm, "rad",
          "slope angle of the fold at the minimum of mu_ss, (16)"),
    FIELD(fold_point, QUANTITY, alpha_cM, "rad",
          "slope angle of the fold at the maximum of mu_ss, (16)"),
    FIELD(fold_point, QUANTITY, v_m, "V_star",
          "slip rate at the minimum of mu_ss"),
    FIELD(fold_point, QUANTITY, v_M, "V_star",
          "slip rate at the maximum of mu_ss"),
    FIELD(fold_point, QUANTITY, mu_m, "1", "mu_ss at its minimum"),
    FIELD(fold_point, QUANTITY, mu_M, "1",
          "mu_ss at its maximum: static friction, (15)"));

const struct record_type record_cusp =
    RECORD(cusp_numbers, "cusp", "where both folds meet",
           FIELD(cusp_numbers, QUANTITY, c, "1", "c at which both folds meet"),
           FIELD(cusp_numbers, QUANTITY, v, "V_star", "slip rate there"),
           FIELD(cusp_numbers, QUANTITY, psi, "psi", "interfacial state there"),
           FIELD(cusp_numbers, QUANTITY, mu, "1", "friction coefficient there"),
           FIELD(cusp_numbers, QUANTITY, alpha, "rad", "slope angle there"));

/* ---- the cusp ------------------------------------------------------------ */

/* Formulas in long double: what is left is the rounding to double, and that of
 * c, on which mu depends by b/(c + psi) per unit: less than b/c. */
static struct cusp_numbers cusp_of(const struct law *law,
                                   const struct material *m,
                                   const struct cusp *at)
{
    const double eps = 2.0 * DBL_EPSILON;
    struct material here = *m;

    if (at->reason) {
        const struct quantity none = quantity_none(at->reason);
        return (struct cusp_numbers){ none, none, none, none, none };
    }
    here.c = (double) at->c;
    const double v = (double) expl(at->x);
    const double psi = (double) steady_psi(law, &here, at->x);
    const double mu = (double) steady_mu(law, &here, at->x);
    struct cusp_numbers n = {
        .c = quantity_of(here.c, eps * here.c),
        .v = quantity_of(v, eps * v),
        .psi = quantity_of(psi, eps * fabs(psi)),
        .mu = quantity_of(mu, eps * (fabs(mu) + m->b)),
    };
    n.alpha = extremum_angle(&n.mu);
    return n;
}

/* ---- the curves ---------------------------------------------------------- */

static struct fold_point folds_at(const struct law *law,
                                  const struct material *m, double c)
{
    const struct quantity none =
        quantity_none("mu_ss has no such extremum at this c");
    struct fold_point f = { c, none, none, none, none, none, none };
    struct extremum e[EXTREMA_MAX];
    struct material here = *m;

    here.c = c;
    const size_t n = extremum_find(law, &here, e);
    for (size_t i = 0; i < n; i++) {
        const bool top = e[i].kind == EXTREMUM_MAXIMUM;
        *(top ? &f.alpha_cM : &f.alpha_cm) = e[i].alpha;
        *(top ? &f.v_M : &f.v_m) = e[i].v;
        *(top ? &f.mu_M : &f.mu_m) = e[i].mu;
    }
    return f;
}

/* Why no extremum was found on the way; NULL if one was. */
static const char *missing(const struct law *law, const struct fold_curve *f)
{
    if (!law_uses(law, MATERIAL_C))
        return "the law does not use c";
    if (f->count == 0)
        return "the range of c lies beyond the cusp";
    for (size_t i = 0; i < f->count; i++)
        if (quantity_exists(&f->at[i].v_m) || quantity_exists(&f->at[i].v_M))
            return NULL;
    return "mu_ss has no extremum at any of these c";
}

/* Evenly in ln c, or in the square root of its distance from the cusp. */
static void fill(const struct law *law, const struct material *m,
                 const double c[2], const struct cusp *cusp,
                 struct fold_curve *f)
{
    const bool to_cusp = !cusp->reason && cusp->c <= (long double) c[1];
    const int last = STUDY_CURVE_POINTS - 1;
    const long double from = logl((long double) c[0]);
    const long double to = to_cusp ? logl(cusp->c) : logl((long double) c[1]);

    if (to_cusp && (long double) c[0] >= cusp->c)
        return;
    for (int i = 0; i <= last - to_cusp; i++) {
        const long double u = 1.0L - (long double) i / last;
        const double at =
            (double) expl(to + (from - to) * (to_cusp ? u * u : u));
        f->at[f->count++] = folds_at(law, m, i == 0 ? c[0] : at);
    }
}

enum status fold_curve_find(const struct law *law, const struct material *m,
                            const double c[2], struct fold_curve *f)
{
    const struct cusp cusp = cusp_find(law, m);

    *f = (struct fold_curve){ .cusp = cusp_of(law, m, &cusp) };
    f->at = malloc(STUDY_CURVE_POINTS * sizeof *f->at);
    if (f->at == NULL)
        return STATUS_NO_MEMORY;
    if (law_uses(law, MATERIAL_C))
        fill(law, m, c, &cusp, f);
    f->reason = missing(law, f);
    return STATUS_OK;
}

void fold_curve_free(struct fold_curve *f)
{
    free(f->at);
    *f = (struct fold_curve){ .at = NULL };
}
