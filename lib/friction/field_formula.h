/*
 * field_formula.h -- the block on a slope, (17), in the chart (ln v, ln psi)
 * [(ln v, psi) where psi is a logarithm], written once for every kind of
 * number: real (double), dual (value and gradient), jet (Taylor series) and
 * quad (113 bits).  With offsets X, Y from the anchor,
 *
 *     dX/dt = exp(log_inertia - X) (tan(alpha) - mu),
 *     dY/dt = -K(psi - psi_ss(v)) / (T(v) psi)       [without 1/psi].
 *
 * tan(alpha) - mu = force0 - (mu - mu0) and psi - psi_ss are built from
 * differences to the anchor, so that no digit is lost near an equilibrium;
 * exponents are added before anything is exponentiated, so that nothing
 * overflows (model section 6).
 *
 * A number is an array of KIND(num) whose element 0 is its value.  The
 * including file (one per kind: field_*.c) defines
 *     KIND(f), FN(f)   the names of f for this kind and for its scalars;
 *     KIND(real)       the scalar type;
 *     VAR(w)           declares a number w;
 *     KIND(ctx)        with members scale, frozen[]: fixed at order 0;
 *     KIND(order)(c)   the order being computed, 0 but for jets;
 * and operations, result last:
 *     linear(c, p, q, u, r, w)      p + q u + r w
 *     product(c, u, w)              u w
 *     exp(c, l, s, u)               e^(l + s (u - u[0]))
 *     expm1(c, p, ln p, s, u)       p (e^(s u) - 1), also where it overflows
 *     log1p_expm1(c, r, u)          ln(1 + r (e^u - 1))
 *     friction(c, a, w0, q0, u)     a (asinh(e^(w0+u)/2) - asinh(e^w0/2))
 */

/* theta - theta0 */
static void KIND(theta)(const struct law *law, const struct KIND(anchor) * at,
                        struct KIND(ctx) * c, const KIND(num) * Y,
                        KIND(num) * out)
{
    switch (law->theta) {
        case THETA_LN_PSI:
        case THETA_PSI:
            KIND(linear)(c, 0, 1, Y, 0, Y, out);
            break;
        case THETA_LN_C_PSI: /* ln((c + psi)/(c + psi0)) */
        case THETA_LN_C_1PR_PSI:
        default:
            KIND(log1p_expm1)(c, at->theta_r, Y, out);
            break;
    }
}

/* mu - mu0: a X + b (theta - theta0), bent by the asinh of (4a) */
static void KIND(mu)(const struct law *law, const struct KIND(anchor) * at,
                     struct KIND(ctx) * c, const KIND(num) * X,
                     const KIND(num) * Y, KIND(num) * out)
{
    VAR(theta);
    VAR(mu_log);

    KIND(theta)(law, at, c, Y, theta);
    if (law->form == FRICTION_LOG) {
        KIND(linear)(c, 0, at->a, X, at->b, theta, out);
        return;
    }
    KIND(linear)(c, 0, 1, X, at->b / at->a, theta, mu_log);
    KIND(friction)(c, at->a, at->w0, at->q0, mu_log, out);
}

/* ln((1/R + v)/(1/R + v0)), for the spinodal components */
static void KIND(saturation)(const struct law *law,
                             const struct KIND(anchor) * at,
                             struct KIND(ctx) * c, const KIND(num) * X,
                             KIND(num) * out)
{
    if (law->psi_ss == PSI_SS_SPINODAL || law->psi_ss == PSI_SS_SPINODAL_UNIT ||
        law->timescale == TIMESCALE_SPINODAL)
        KIND(log1p_expm1)(c, at->steady_r, X, out);
    else
        KIND(linear)(c, 0, 0, X, 0, X, out);
}

/* psi_ss(v) - psi0, with l = saturation */
static void KIND(steady)(const struct law *law, const struct KIND(anchor) * at,
                         struct KIND(ctx) * c, const KIND(num) * X,
                         const KIND(num) * l, KIND(num) * out)
{
    switch (law->psi_ss) {
        case PSI_SS_INVERSE:
            KIND(expm1)(c, at->psi0, at->log_psi0, -1, X, out);
            break;
        case PSI_SS_MINUS_LOG:
            KIND(linear)(c, 0, -1, X, 0, X, out);
            break;
        default:
            KIND(expm1)(c, at->psi0, at->log_psi0, -1, l, out);
            break;
    }
}

/* ln(T0/T(v)), with l = saturation and s = psi_ss - psi0 */
static void KIND(quickness)(const struct law *law, struct KIND(ctx) * c,
                            const KIND(num) * X, const KIND(num) * l,
                            const KIND(num) * s, KIND(num) * out)
{
    if (law->timescale == TIMESCALE_SPINODAL ||
        (law->timescale == TIMESCALE_AGEING44 && law->psi_ss != PSI_SS_INVERSE))
        KIND(linear)(c, 0, 1, l, 0, l, out);
    else if (law->timescale == TIMESCALE_SLIP45)
        KIND(linear)(c, 0, -1, s, 0, s, out);
    else
        KIND(linear)(c, 0, 1, X, 0, X, out);
}

/* Kinetics: K(d) exp(w) as mantissa * exp(exponent); returns the exponent's
 * order 0, constants included.  First order: K(d) = d, large d scaled down. */
static KIND(real) KIND(first_order)(struct KIND(ctx) * c, const KIND(num) * d,
                                    const KIND(num) * w, KIND(num) * mantissa,
                                    KIND(num) * exponent)
{
    if (KIND(order)(c) == 0)
        c->frozen[0] = FN(fabs)(d[0]) > 1 ? FN(fabs)(d[0]) : 1;
    KIND(linear)(c, 0, 1 / c->frozen[0], d, 0, d, mantissa);
    KIND(linear)(c, 0, 1, w, 0, w, exponent);
    return KIND(order)(c) == 0 ? w[0] + FN(log)(c->frozen[0]) : 0;
}

/* Hyperbolic: sinh d = -sgn expm1(-2 sgn d) e^(sgn d) / 2. */
static KIND(real) KIND(hyperbolic)(struct KIND(ctx) * c, const KIND(num) * d,
                                   const KIND(num) * w, KIND(num) * mantissa,
                                   KIND(num) * exponent)
{
    if (KIND(order)(c) == 0)
        c->frozen[0] = d[0] < 0 ? -1 : 1;
    const KIND(real) sign = c->frozen[0];
    KIND(expm1)
    (c, -sign / 2, FN(log)((KIND(real)) 0.5), -2 * sign, d, mantissa);
    KIND(linear)(c, 0, 1, w, sign, d, exponent);
    return w[0] + FN(fabs)(d[0]);
}

/* Kato-Tullis: dY/dt = v (E - z), z = ln(v psi), E = exp(-v/V_c - z), with
 * E = z at the anchor.  E overflows long before v psi does. */
static KIND(real)
    KIND(composite)(const struct KIND(anchor) * at, struct KIND(ctx) * c,
                    const KIND(num) * X, const KIND(num) * Y,
                    KIND(num) * mantissa, KIND(num) * exponent)
{
    VAR(z);
    VAR(cut);
    VAR(q);
    VAR(heal);
    const KIND(real) log0 = at->log_composite;

    KIND(linear)(c, 0, 1, X, 1, Y, z);
    KIND(expm1)(c, at->kappa0, at->log_kappa0, 1, X, cut);
    KIND(linear)(c, 0, -1, z, -1, cut, q);
    if (KIND(order)(c) == 0) {
        c->frozen[0] = q[0] + log0 > 0 ? q[0] + log0 : 0;
        c->frozen[1] = FN(exp)(log0 - c->frozen[0]);
        c->frozen[2] = FN(exp)(-c->frozen[0]);
    }
    KIND(expm1)(c, c->frozen[1], log0 - c->frozen[0], 1, q, heal);
    KIND(linear)(c, 0, -1, heal, c->frozen[2], z, mantissa);
    KIND(linear)(c, 0, 1, X, 0, X, exponent);
    return X[0] + c->frozen[0];
}

/* psi - psi_ss(v) and w = ln(T0 psi0/(T psi)) [ln(T0/T)]. */
static void KIND(lag)(const struct law *law, const struct KIND(anchor) * at,
                      struct KIND(ctx) * c, const KIND(num) * X,
                      const KIND(num) * Y, KIND(num) * d, KIND(num) * w)
{
    VAR(l);
    VAR(psi);
    VAR(steady);
    VAR(t);

    KIND(saturation)(law, at, c, X, l);
    KIND(steady)(law, at, c, X, l, steady);
    KIND(quickness)(law, c, X, l, steady, t);
    if (law_psi_is_log(law)) {
        KIND(linear)(c, 0, 1, Y, -1, steady, d);
        KIND(linear)(c, 0, 1, t, 0, t, w);
        return;
    }
    KIND(expm1)(c, at->psi0, at->log_psi0, 1, Y, psi);
    KIND(linear)(c, 0, 1, psi, -1, steady, d);
    KIND(linear)(c, 0, 1, t, -1, Y, w);
}

static KIND(real)
    KIND(kinetics)(const struct law *law, const struct KIND(anchor) * at,
                   struct KIND(ctx) * c, const KIND(num) * X,
                   const KIND(num) * Y, KIND(num) * mantissa,
                   KIND(num) * exponent)
{
    VAR(d);
    VAR(w);

    if (law->kinetics == KINETICS_COMPOSITE)
        return at->x0 + KIND(composite)(at, c, X, Y, mantissa, exponent);
    KIND(lag)(law, at, c, X, Y, d, w);
    return at->log_rate +
           (law->kinetics == KINETICS_SINH
                ? KIND(hyperbolic)(c, d, w, mantissa, exponent)
                : KIND(first_order)(c, d, w, mantissa, exponent));
}

/* Both components times exp(-c->scale), which order 0 fixes for the series. */
static void KIND(field)(const struct law *law, const struct KIND(anchor) * at,
                        struct KIND(ctx) * c, const KIND(num) * X,
                        const KIND(num) * Y, KIND(num) * fx, KIND(num) * fy)
{
    VAR(mu);
    VAR(force);
    VAR(mantissa);
    VAR(exponent);
    VAR(ex);
    VAR(ey);
    VAR(up);

    KIND(mu)(law, at, c, X, Y, mu);
    KIND(linear)(c, at->force0, -1, mu, 0, mu, force);
    const KIND(real) x = at->log_inertia - X[0];
    const KIND(real) y = KIND(kinetics)(law, at, c, X, Y, mantissa, exponent);
    if (KIND(order)(c) == 0)
        c->scale = x > y ? x : y;
    KIND(exp)(c, x - c->scale, -1, X, ex);
    KIND(product)(c, force, ex, fx);
    KIND(exp)(c, y - c->scale, 1, exponent, ey);
    KIND(product)(c, mantissa, ey, up);
    KIND(linear)(c, 0, -1, up, 0, up, fy);
}
