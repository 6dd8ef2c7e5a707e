/*
 * With E = exp(log_inertia - X) = cos(alpha)/(eps^2 v) the first component is
 * E (tan(alpha) - mu), and mu a function of a and of
 * mu_log = mu_star + a x + b theta; the second knows of R alone, through
 * r = 1/R in psi_ss and T.  By hand, because the law's tape holds differences
 * to an anchor that moves with the parameters.
 */
#include "parameter.h"

#include <math.h>
#include <string.h>

#include "law_graph.h"

#define SCALAR double
#define FN(f)  f
#include "scalar.h"

const char *parameter_missing(const struct law *law, const struct material *m,
                              enum parameter p)
{
    if (p == PARAMETER_A && !law_uses(law, MATERIAL_A))
        return "the law does not use a";
    if (p == PARAMETER_B && !law_uses(law, MATERIAL_B))
        return "the law does not use b";
    if (p == PARAMETER_MU_STAR && !law_uses(law, MATERIAL_MU_STAR))
        return "the law does not use mu_star";
    if (p == PARAMETER_C && !law_uses(law, MATERIAL_C))
        return "the law does not use c";
    if (p == PARAMETER_R && !law_uses(law, MATERIAL_R))
        return "the law does not use R";
    if (p == PARAMETER_R && isinf(m->R))
        return "R is infinite";
    return NULL;
}

/* A point in absolute coordinates. */
struct place {
    double x, y, v, psi;
};

static struct place place_at(const struct block *b, struct vec2 z)
{
    const double x = b->at.x0 + z.x, y = b->at.y0 + z.y;
    return (struct place){ x, y, exp(x), law_psi_is_log(&b->law) ? y : exp(y) };
}

/* theta and its derivatives by c and R. */
struct theta_parts {
    double theta, by_c, by_R;
};

static struct theta_parts theta_at(const struct block *b,
                                   const struct place *at)
{
    const double c = b->material.c, R = b->material.R;

    switch (b->law.theta) {
        case THETA_LN_C_PSI:
            return (struct theta_parts){ log(c + at->psi), 1 / (c + at->psi),
                                         0 };
        case THETA_LN_C_1PR_PSI: {
            const double rise = c / at->psi + 1 + R;
            return (struct theta_parts){ at->y + log(rise),
                                         1 / (c + (1 + R) * at->psi),
                                         1 / rise };
        }
        default: /* ln psi, psi */
            return (struct theta_parts){ at->y, 0, 0 };
    }
}

/* d mu/d p, but for alpha and eps2; *mu too. */
static void friction_parts(const struct block *b, const struct place *at,
                           double *mu, double by[PARAMETERS])
{
    const struct theta_parts t = theta_at(b, at);
    const double a = b->material.a, k = b->material.b;
    const double mu_log = b->material.mu_star + a * at->x + k * t.theta;
    const double w = mu_log / a;
    const bool bent = b->law.form == FRICTION_ASINH;
    const double slope = bent ? scalar_friction_slope(w) : 1;

    *mu = bent ? a * scalar_asinh_exp(w) : mu_log;
    by[PARAMETER_A] = *mu / a + slope * (at->x - w);
    by[PARAMETER_B] = slope * t.theta;
    by[PARAMETER_MU_STAR] = slope;
    by[PARAMETER_C] = slope * k * t.by_c;
    by[PARAMETER_R] = slope * k * t.by_R;
}

/* psi_ss(v) = top/(r + v) where it depends on R, else psi = 0; and its
 * derivative by r. */
struct steady_parts {
    double psi, by_r;
    bool spinodal, unit; /* top = 1 + r, top = r */
};

static struct steady_parts steady_parts(const struct law *law, double r,
                                        double v)
{
    const double sum = r + v;

    if (law->psi_ss == PSI_SS_SPINODAL)
        return (struct steady_parts){ (1 + r) / sum, (v - 1) / (sum * sum),
                                      true, false };
    if (law->psi_ss == PSI_SS_SPINODAL_UNIT)
        return (struct steady_parts){ r / sum, v / (sum * sum), false, true };
    return (struct steady_parts){ 0 };
}

/* d ln(1/T)/d r; ln psi_ss is ln top - ln(r + v). */
static double rate_by_r(const struct timescale_terms *t, double r, double v,
                        const struct steady_parts *s)
{
    const int ln_r = t->ln_r + t->ln_psi_ss * s->unit;
    const int ln_1_plus_r = t->ln_psi_ss * s->spinodal;
    const int ln_r_plus_v =
        t->ln_r_plus_v - t->ln_psi_ss * (s->unit || s->spinodal);

    return ln_r / r + ln_1_plus_r / (1 + r) + ln_r_plus_v / (r + v) +
           t->psi_ss * s->by_r;
}

/* d f_y/d R, f_y = -K(d)/(T psi), d = psi - psi_ss: what psi_ss does is
 * K'(d)/K(d) f_y where d is large, because nothing overflows there. */
static double state_by_R(const struct block *b, const struct place *at,
                         const struct planar_field *f)
{
    const double r = 1 / b->material.R, fy = f->direction.y;
    const bool hyperbolic = b->law.kinetics == KINETICS_SINH;
    double shift = 0;

    if (!(r > 0) || b->law.kinetics == KINETICS_COMPOSITE)
        return 0;
    const struct steady_parts s = steady_parts(&b->law, r, at->v);
    const double d = at->psi - s.psi;
    if (s.psi > 0 && fabs(d) > 1) {
        shift = -fy * (hyperbolic ? 1 / tanh(d) : 1 / d);
    } else if (s.psi > 0) {
        const double log_rate = (double) steady_log_rate(&b->law, &b->material,
                                                         (long double) at->x) -
                                (law_freezes(&b->law) ? s.psi : 0);
        const double y = law_psi_is_log(&b->law) ? 0 : at->y;
        shift = exp(log_rate - y - f->log_scale) * (hyperbolic ? cosh(d) : 1);
    }
    return -r * r *
           (fy * rate_by_r(law_timescale(&b->law), r, at->v, &s) +
            shift * s.by_r);
}

/* Of a law of formulas. */
static void typed_field(const struct block *b, struct vec2 z,
                        const struct planar_field *f,
                        struct vec2 out[PARAMETERS])
{
    static const char *const name[PARAMETERS] = {
        [PARAMETER_ALPHA] = "tan_alpha",
        [PARAMETER_A] = "a",
        [PARAMETER_B] = "b",
        [PARAMETER_MU_STAR] = "mu_star",
        [PARAMETER_C] = "c",
        [PARAMETER_R] = "R",
        [PARAMETER_EPS2] = "eps2",
    };
    const long double less = expl(-(long double) f->log_scale);

    const long double x = b->x + (long double) z.x,
                      y = b->y + (long double) z.y;
    struct law_long at;

    law_long_init(&at, &b->law, &b->material, b->tan_alpha);
    (void) law_long_at(&at, x, y, LAW_AT_DX);
    (void) law_long_at(&at, x, y, LAW_AT_DY);
    for (int p = 0; p < PARAMETERS; p++) {
        const int leaf = formula_find(&at.g->f, name[p], strlen(name[p]));
        const long double unit =
            less * (p == PARAMETER_ALPHA ? 1 + b->tan_alpha * b->tan_alpha : 1);
        out[p] = (struct vec2){
            (double) (law_long_by(&at, LAW_AT_DX, leaf) * unit),
            (double) (law_long_by(&at, LAW_AT_DY, leaf) * unit),
        };
    }
}

void parameter_field(const void *ctx, struct vec2 z,
                     const struct planar_field *f, struct vec2 out[PARAMETERS])
{
    const struct block *b = ctx;
    const struct place at = place_at(b, z);
    const double unit = exp(b->at.log_inertia - z.x - f->log_scale);
    double mu, by[PARAMETERS] = { 0 };

    if (b->law.typed) {
        typed_field(b, z, f, out);
        return;
    }
    friction_parts(b, &at, &mu, by);
    for (int p = 0; p < PARAMETERS; p++)
        out[p] = (struct vec2){ -unit * by[p], 0 };
    out[PARAMETER_ALPHA].x = unit * (1 + (double) b->tan_alpha * mu);
    out[PARAMETER_EPS2].x = -f->direction.x / material_eps2(&b->material);
    out[PARAMETER_R].y = state_by_R(b, &at, f);
}
