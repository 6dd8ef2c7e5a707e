/*
 * field_formula.h -- the block on a slope, (17), in the chart (ln v, ln psi)
 * [(ln v, psi) where psi is a logarithm], in closed form, for series of 113-bit
 * numbers: by hand, and so independent of the formulas that it judges
 * (law_tape.h).  With offsets X, Y from the anchor,
 *
 *     dX/dt = exp(log_inertia - X) (tan(alpha) - mu),
 *     dY/dt = -K(psi - psi_ss(v)) / (T(v) psi)       [without 1/psi].
 *
 * tan(alpha) - mu = force0 - (mu - mu0) and psi - psi_ss are built from
 * differences to the anchor, so that no digit is lost near an equilibrium;
 * psi - psi_ss of two positive numbers is the larger times 1 - their ratio,
 * so that none is lost far away either; exponents are added before anything
 * is exponentiated, so that nothing overflows.
 *
 * A number is an array of KIND(num) whose element 0 is its value.  The
 * including file defines
 *     KIND(f)          the name of f for this kind;
 *     KIND(real)       the type of an element;
 *     REAL(f)          the name of f for elements: size(u) = |u|, power(u) =
 *                      e^u, ln(u), larger(u, w), and with plain scalars p, q, r
 *                      at_least(p, u), choose(u, p, q, r) = u < p ? q : r;
 *     VAR(w)           declares a number w;
 *     KIND(ctx)        with members scale, frozen[]: fixed at order 0;
 *     KIND(order)(c)   the order being computed, 0 but for jets;
 * and operations, result last:
 *     linear(c, p, q, u, r, w)      p + q u + r w
 *     product(c, u, w)              u w
 *     exp(c, l, s, u)               e^(l + s (u - u[0]))
 *     expm1(c, p, ln p, s, u)       p (e^(s u) - 1), also where it overflows
 *     difference(c, p, u, w)        p (e^u - e^w)
 *     log1p_expm1(c, r, 1 - r, u)   ln(1 + r (e^u - 1))
 *     sinh(c, u)                    e^(-|u[0]|) sinh u
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
            KIND(log1p_expm1)(c, at->theta_r, at->theta_s, Y, out);
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
        law_timescale(law)->ln_r_plus_v)
        KIND(log1p_expm1)(c, at->steady_r, at->steady_s, X, out);
    else
        KIND(linear)(c, 0, 0, X, 0, X, out);
}

/* ln(psi_ss/psi0), with l = saturation; psi_ss - psi0 where it is -ln v */
static void KIND(steady)(const struct law *law, struct KIND(ctx) * c,
                         const KIND(num) * X, const KIND(num) * l,
                         KIND(num) * out)
{
    if (law->psi_ss == PSI_SS_INVERSE || law->psi_ss == PSI_SS_MINUS_LOG)
        KIND(linear)(c, 0, -1, X, 0, X, out);
    else
        KIND(linear)(c, 0, -1, l, 0, l, out);
}

/* psi - psi_ss, with s = steady */
static void KIND(lag)(const struct law *law, const struct KIND(anchor) * at,
                      struct KIND(ctx) * c, const KIND(num) * Y,
                      const KIND(num) * s, KIND(num) * out)
{
    VAR(change);

    if (law_psi_is_log(law) && law->psi_ss == PSI_SS_MINUS_LOG) {
        KIND(linear)(c, 0, 1, Y, -1, s, out);
    } else if (law_psi_is_log(law)) {
        KIND(expm1)(c, at->psi0, at->log_psi0, 1, s, change);
        KIND(linear)(c, 0, 1, Y, -1, change, out);
    } else if (law->psi_ss == PSI_SS_MINUS_LOG) {
        KIND(expm1)(c, at->psi0, at->log_psi0, 1, Y, change);
        KIND(linear)(c, 0, 1, change, -1, s, out);
    } else {
        KIND(difference)(c, at->psi0, Y, s, out);
    }
}

/* ln(T0/T(v)), with l = saturation and s = steady, which is psi_ss - psi0 where
 * that is -ln v; for the exp(psi_ss) of others see freeze */
static void KIND(quickness)(const struct law *law, struct KIND(ctx) * c,
                            const KIND(num) * X, const KIND(num) * l,
                            const KIND(num) * s, KIND(num) * out)
{
    const struct timescale_terms *t = law_timescale(law);
    const int of_s = t->ln_psi_ss + (law_freezes(law) ? 0 : t->psi_ss);
    VAR(direct);

    KIND(linear)(c, 0, t->ln_v, X, t->ln_r_plus_v, l, of_s ? direct : out);
    if (of_s)
        KIND(linear)(c, 0, 1, direct, of_s, s, out);
}

/* The exponent -psi_ss of 1/T in (45).  sinh(psi - psi_ss) brings the same
 * exponent back when psi < psi_ss, and both may be as large as 1e300: under
 * the sinh it is written -psi + (psi - psi_ss), and `freezing` looks after the
 * second part. */
static void KIND(freeze)(const struct law *law, const struct KIND(anchor) * at,
                         struct KIND(ctx) * c, const KIND(num) * Y,
                         const KIND(num) * s, const KIND(num) * w,
                         KIND(num) * out)
{
    VAR(psi);
    const KIND(num) *u = law->kinetics == KINETICS_SINH ? Y : s;

    if (!law_freezes(law)) {
        KIND(linear)(c, 0, 1, w, 0, w, out);
    } else if (law_psi_is_log(law) && u == Y) {
        KIND(linear)(c, 0 - at->psi0, 1, w, -1, Y, out);
    } else {
        KIND(exp)(c, at->log_psi0 + u[0], 1, u, psi);
        KIND(linear)(c, 0, 1, w, -1, psi, out);
    }
}

/* Kinetics: K(d) exp(w) as mantissa * exp(exponent); returns the exponent's
 * order 0, constants included.  First order: K(d) = d, large d scaled down. */
static KIND(real) KIND(first_order)(struct KIND(ctx) * c, const KIND(num) * d,
                                    const KIND(num) * w, KIND(num) * mantissa,
                                    KIND(num) * exponent)
{
    if (KIND(order)(c) == 0) {
        c->frozen[0] = REAL(at_least)(1, REAL(size)(d[0]));
        c->frozen[1] = REAL(ln)(c->frozen[0]);
    }
    KIND(linear)(c, 0, 1 / c->frozen[0], d, 0, d, mantissa);
    KIND(linear)(c, 0, 1, w, 0, w, exponent);
    return w[0] + c->frozen[1];
}

/* Hyperbolic: sinh d, scaled down. */
static KIND(real) KIND(hyperbolic)(struct KIND(ctx) * c, const KIND(num) * d,
                                   const KIND(num) * w, KIND(num) * mantissa,
                                   KIND(num) * exponent)
{
    KIND(sinh)(c, d, mantissa);
    KIND(linear)(c, 0, 1, w, 0, w, exponent);
    return w[0] + REAL(size)(d[0]);
}

/* With (45): sinh d e^d = (e^(2d) - 1)/2. */
static KIND(real) KIND(freezing)(struct KIND(ctx) * c, const KIND(num) * d,
                                 const KIND(num) * w, KIND(num) * mantissa,
                                 KIND(num) * exponent)
{
    if (KIND(order)(c) == 0) {
        c->frozen[0] = REAL(choose)(d[0], 0, 1, -1);
        c->frozen[1] = REAL(ln)(REAL(size)(c->frozen[0]) / 2);
    }
    const KIND(real) sign = c->frozen[0];
    KIND(expm1)(c, sign / 2, c->frozen[1], 2 * sign, d, mantissa);
    KIND(linear)(c, 0, 1, w, 1 - sign, d, exponent);
    return w[0] + (1 - sign) * d[0];
}

/* Kato-Tullis: dY/dt = v (E - z), z = ln(v psi), E = exp(-v/V_c - z), with
 * E = z at the anchor.  E - E0 near it; where v/V_c has dropped away from its
 * value there, E less what it would be without v/V_c, X and Y.  E overflows
 * long before v psi does. */
static KIND(real)
    KIND(composite)(const struct KIND(anchor) * at, struct KIND(ctx) * c,
                    const KIND(num) * X, const KIND(num) * Y,
                    KIND(num) * mantissa, KIND(num) * exponent)
{
    VAR(z);
    VAR(cut_near);
    VAR(cut_far);
    VAR(cut);
    VAR(q);
    VAR(heal);
    if (KIND(order)(c) == 0)
        c->frozen[3] = REAL(choose)(X[0], -1, 1, 0);
    const KIND(real) far = c->frozen[3], near = 1 - far;
    const KIND(real) log0 = near * at->log_composite - far * (at->x0 + at->y0);

    KIND(linear)(c, 0, 1, X, 1, Y, z);
    KIND(exp)(c, at->log_kappa0 + X[0], 1, X, cut_far);
    KIND(expm1)(c, at->kappa0, at->log_kappa0, 1, X, cut_near);
    KIND(linear)(c, 0, near, cut_near, far, cut_far, cut);
    KIND(linear)(c, 0, -1, z, -1, cut, q);
    if (KIND(order)(c) == 0) {
        c->frozen[0] = REAL(at_least)(0, q[0] + log0);
        c->frozen[1] = REAL(power)(log0 - c->frozen[0]);
        c->frozen[2] = REAL(power)(0 - c->frozen[0]);
    }
    const KIND(real) kept = c->frozen[2] * (at->x0 + at->y0) - c->frozen[1];
    KIND(expm1)(c, c->frozen[1], log0 - c->frozen[0], 1, q, heal);
    KIND(linear)(c, far * kept, -1, heal, c->frozen[2], z, mantissa);
    KIND(linear)(c, 0, 1, X, 0, X, exponent);
    return X[0] + c->frozen[0];
}

static KIND(real)
    KIND(kinetics)(const struct law *law, const struct KIND(anchor) * at,
                   struct KIND(ctx) * c, const KIND(num) * X,
                   const KIND(num) * Y, KIND(num) * mantissa,
                   KIND(num) * exponent)
{
    VAR(l);
    VAR(s);
    VAR(d);
    VAR(t);
    VAR(u);
    VAR(w);

    if (law->kinetics == KINETICS_COMPOSITE)
        return at->x0 + KIND(composite)(at, c, X, Y, mantissa, exponent);
    KIND(saturation)(law, at, c, X, l);
    KIND(steady)(law, c, X, l, s);
    KIND(lag)(law, at, c, Y, s, d);
    KIND(quickness)(law, c, X, l, s, t);
    KIND(linear)(c, 0, 1, t, law_psi_is_log(law) ? 0 : -1, Y, u);
    KIND(freeze)(law, at, c, Y, s, u, w);
    const KIND(real) rate = law->kinetics == KINETICS_LINEAR
                                ? KIND(first_order)(c, d, w, mantissa, exponent)
                            : law_freezes(law)
                                ? KIND(freezing)(c, d, w, mantissa, exponent)
                                : KIND(hyperbolic)(c, d, w, mantissa, exponent);
    return at->log_rate + rate;
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
    KIND(linear)
    (c, at->force0, -1, mu, 0, mu, force);
    const KIND(real) x = at->log_inertia - X[0];
    const KIND(real) y = KIND(kinetics)(law, at, c, X, Y, mantissa, exponent);
    if (KIND(order)(c) == 0)
        c->scale = REAL(larger)(x, y);
    KIND(exp)(c, x - c->scale, -1, X, ex);
    KIND(product)(c, force, ex, fx);
    KIND(exp)(c, y - c->scale, 1, exponent, ey);
    KIND(product)(c, mantissa, ey, up);
    KIND(linear)(c, 0, -1, up, 0, up, fy);
}
