/*
 * steady_formula.h -- steady states and anchors, written once for every
 * scalar type.  The including file defines
 *     T            the scalar type,
 *     NAME(f)      the name of function f for this type,
 *     FN(f)        the mathematical function f for this type (FN(exp), ...),
 *     REAL(f)      those of scalar.h: asinh_exp, lambert.
 * x = ln v throughout.
 */

/* eps^2, below (17) */
static T NAME(eps2)(const struct material *m)
{
    return (T) m->V_star * (T) m->V_star / ((T) m->g * (T) m->L);
}

/* 1/R, and c as it stands beside psi: c, or c/(1 + R). */
static T NAME(inverse_R)(const struct material *m)
{
    return 1 / (T) m->R;
}

static T NAME(offset)(const struct law *law, const struct material *m)
{
    switch (law->theta) {
        case THETA_LN_C_PSI:
            return (T) m->c;
        case THETA_LN_C_1PR_PSI:
            return (T) m->c / (1 + (T) m->R);
        default:
            return 0;
    }
}

/* psi_ss(v) */
static T NAME(psi_ss)(const struct law *law, const struct material *m, T x)
{
    const T r = NAME(inverse_R)(m), v = FN(exp)(x);

    switch (law->psi_ss) {
        case PSI_SS_INVERSE:
            return FN(exp)(0 - x);
        case PSI_SS_MINUS_LOG:
            return 0 - x;
        case PSI_SS_SPINODAL:
            return (1 + r) / (r + v);
        case PSI_SS_SPINODAL_UNIT:
            return r / (r + v);
        default:
            return FN(exp)(REAL(lambert)(v / (T) m->V_c) - x);
    }
}

/* The chart's y on the steady-state curve. */
static T NAME(y_ss)(const struct law *law, const struct material *m, T x)
{
    if (law->psi_ss == PSI_SS_INVERSE && !law_psi_is_log(law))
        return 0 - x;
    if (law->psi_ss == PSI_SS_LAMBERT)
        return REAL(lambert)(FN(exp)(x) / (T) m->V_c) - x;
    const T psi = NAME(psi_ss)(law, m, x);
    return law_psi_is_log(law) ? psi : FN(log)(psi);
}

/* theta(psi_ss(v)) */
static T NAME(theta_ss)(const struct law *law, const struct material *m, T x)
{
    const T psi = NAME(psi_ss)(law, m, x);

    switch (law->theta) {
        case THETA_LN_PSI:
            return NAME(y_ss)(law, m, x);
        case THETA_PSI:
            return psi;
        case THETA_LN_C_PSI:
            return FN(log)((T) m->c + psi);
        default:
            return FN(log)((T) m->c + (1 + (T) m->R) * psi);
    }
}

/* mu_star + a ln v + b theta(psi_ss): the log form (2) in steady state. */
static T NAME(mu_log_ss)(const struct law *law, const struct material *m, T x)
{
    return (T) m->mu_star + (T) m->a * x + (T) m->b * NAME(theta_ss)(law, m, x);
}

/* mu_ss(v): mu_log, or a asinh(exp(mu_log/a)/2), (4a) */
static T NAME(mu_ss)(const struct law *law, const struct material *m, T x)
{
    const T mu = NAME(mu_log_ss)(law, m, x), a = (T) m->a;

    return law->form == FRICTION_LOG ? mu : a * REAL(asinh_exp)(mu / a);
}

/* The value of mu_log at which mu = tan(alpha):
 * tan(alpha) + a ln(1 - exp(-2 tan(alpha)/a)) */
static inline T NAME(tau)(const struct law *law, const struct material *m,
                          T tan_alpha)
{
    const T a = (T) m->a;
    const T less = FN(expm1)(-2 * tan_alpha / a);

    return law->form == FRICTION_LOG ? tan_alpha
                                     : tan_alpha + a * FN(log)(0 - less);
}

/* ln(1/T(v)), where it freezes without the -psi_ss */
static T NAME(log_rate)(const struct law *law, const struct material *m, T x)
{
    const struct timescale_terms *t = law_timescale(law);
    const T r = NAME(inverse_R)(m);
    T sum = t->ln_r ? t->ln_r * FN(log)(r) : 0;

    if (t->ln_v)
        sum += t->ln_v * x;
    if (t->ln_r_plus_v)
        sum += t->ln_r_plus_v * FN(log)(r + FN(exp)(x));
    if (t->ln_psi_ss)
        sum += t->ln_psi_ss * FN(log)(NAME(psi_ss)(law, m, x));
    if (t->psi_ss && !law_freezes(law))
        sum += t->psi_ss * NAME(psi_ss)(law, m, x);
    return sum;
}

/* Everything about the point x of the steady-state curve.  `equilibrium`: the
 * force balance is zero there by construction, not by subtraction. */
static void NAME(anchor)(const struct law *law, const struct material *m,
                         T alpha_tan, T x, bool equilibrium,
                         struct NAME(anchor) * at)
{
    const T r = NAME(inverse_R)(m), c = NAME(offset)(law, m);
    const T tan2 = alpha_tan * alpha_tan;
    const bool has_c = law_uses(law, MATERIAL_C);

    at->x0 = x;
    at->y0 = NAME(y_ss)(law, m, x);
    at->v0 = FN(exp)(x);
    at->psi0 = NAME(psi_ss)(law, m, x);
    at->log_psi0 = law_psi_is_log(law) ? FN(log)(FN(fabs)(at->psi0)) : at->y0;
    at->mu0 = equilibrium ? alpha_tan : NAME(mu_ss)(law, m, x);
    at->force0 = alpha_tan - at->mu0;
    at->a = (T) m->a;
    at->b = (T) m->b;
    at->theta_s = has_c ? c / (c + at->psi0) : 0;
    at->theta_r = has_c ? at->psi0 / (c + at->psi0) : 1;
    at->steady_s = r / (r + at->v0);
    at->steady_r = at->v0 / (r + at->v0);
    at->log_inertia = 0 - FN(log)(NAME(eps2)(m)) - FN(log1p)(tan2) / 2 - x;
    at->log_rate =
        NAME(log_rate)(law, m, x) - (law_psi_is_log(law) ? 0 : at->y0);
    at->kept = 1;
    at->w0 = NAME(mu_log_ss)(law, m, x) / at->a;
    at->q0 = 4 * FN(exp)(-2 * at->w0);
    at->kappa0 = at->v0 / (T) m->V_c;
    at->log_kappa0 = x - FN(log)((T) m->V_c);
    at->log_composite = 0 - at->kappa0 - x - at->y0;
}
