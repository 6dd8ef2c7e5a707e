/*
 * newton_formula.h -- newton.c's method for one kind of number: REAL, with
 * NAME(x) naming its functions.  Inverse quadratic interpolation wherever it
 * is sure to be monotone, else bisection: Chandrupatla, Adv. Eng. Software 28
 * (1997) 145-149.  Changed: three calls in a row that do not halve the bracket
 * force a bisection, which bounds the calls for every function; the last
 * steps go to neighbouring numbers, so the bracket can close completely.
 */

/* a: the newest point; b: the other end of the bracket; c: the point that
 * was dropped last.  f_a and f_b differ in sign. */
struct NAME(bracket) {
    REAL a, b, c, f_a, f_b, f_c;
    REAL width; /* |b - a| when the patience was last renewed */
    int patience;
};

/* Fraction of the way from a to b; 1/2 where interpolation cannot be
 * trusted.  Comparisons with a NaN are false, hence choose bisection. */
static REAL NAME(fraction)(const struct NAME(bracket) * k)
{
    const REAL xi = (k->a - k->b) / (k->c - k->b);
    const REAL phi = (k->f_a - k->f_b) / (k->f_c - k->f_b);
    const REAL half = (REAL) 0.5;

    if (!(phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi))
        return half;
    const REAL t = k->f_a / (k->f_b - k->f_a) * (k->f_c / (k->f_b - k->f_c)) +
                   (k->c - k->a) / (k->b - k->a) *
                       (k->f_a / (k->f_c - k->f_a)) *
                       (k->f_b / (k->f_c - k->f_b));
    return t > 0 && t < 1 ? t : half;
}

/* The next point, strictly inside the bracket, at least tol/2 from its ends:
 * ends not adjacent. */
static REAL NAME(next)(struct NAME(bracket) * k, REAL tol)
{
    const REAL middle = k->a / 2 + k->b / 2, reach = k->b - k->a;
    const REAL least = tol / 2 / fabs(reach);
    REAL t = NAME(fraction)(k);

    if (fabs(reach) <= k->width / 2 || k->patience == 0) {
        if (k->patience == 0)
            t = (REAL) 0.5;
        k->width = fabs(reach);
        k->patience = 3;
    }
    k->patience--;
    if (t < least)
        t = least;
    if (t > 1 - least)
        t = 1 - least;
    REAL x = t == (REAL) 0.5 ? middle : k->a + t * reach;
    if (x == k->a)
        x = nextafter(k->a, k->b);
    if (x == k->b || !isfinite(x))
        x = middle == k->a || middle == k->b ? nextafter(k->a, k->b) : middle;
    return x;
}

static void NAME(update)(struct NAME(bracket) * k, REAL x, REAL f_x)
{
    if ((f_x < 0) == (k->f_a < 0)) {
        k->c = k->a;
        k->f_c = k->f_a;
    } else {
        k->c = k->b;
        k->f_c = k->f_b;
        k->b = k->a;
        k->f_b = k->f_a;
    }
    k->a = x;
    k->f_a = f_x;
}

/* Closes the bracket; *calls goes on counting. */
static enum status NAME(close)(REAL (*f)(const void *ctx, REAL x),
                               const void *ctx, REAL tol,
                               struct NAME(bracket) * k, size_t *calls)
{
    while (k->f_a != 0 && !(fabs(k->b - k->a) <= tol) &&
           nextafter(k->a, k->b) != k->b) {
        const REAL x = NAME(next)(k, tol);
        const REAL f_x = f(ctx, x);

        ++*calls;
        if (x == k->a || x == k->b) /* arithmetic of fewer digits than REAL */
            break;
        if (isnan(f_x))
            return STATUS_NO_CONVERGENCE;
        NAME(update)(k, x, f_x);
    }
    return STATUS_OK;
}

static enum status NAME(find_between)(REAL (*f)(const void *ctx, REAL x),
                                      const void *ctx, struct NAME(bracket) k,
                                      REAL tol, struct NAME(newton_root) * out)
{
    size_t calls = 2;
    enum status s;

    if (isnan(k.f_a) || isnan(k.f_b))
        return STATUS_NO_CONVERGENCE;
    if ((k.f_a < 0 && k.f_b < 0) || (k.f_a > 0 && k.f_b > 0))
        return STATUS_BAD_ARGUMENT;
    if (k.f_b != 0) { /* else the root is at lo */
        k.width = fabs(k.a - k.b);
        k.patience = 3;
        s = NAME(close)(f, ctx, tol, &k, &calls);
        if (s != STATUS_OK)
            return s;
    }
    const bool first = fabs(k.f_a) < fabs(k.f_b);
    const bool exact = k.f_a == 0 || k.f_b == 0;
    *out = (struct NAME(newton_root)){ first ? k.a : k.b,
                                       exact ? 0 : fabs(k.b - k.a), calls };
    return STATUS_OK;
}

enum status NAME(newton_find)(REAL (*f)(const void *ctx, REAL x),
                              const void *ctx, REAL lo, REAL hi, REAL tol,
                              struct NAME(newton_root) * out)
{
    struct NAME(bracket) k = { .a = hi, .b = lo, .c = lo };

    if (!(lo <= hi))
        return STATUS_BAD_ARGUMENT;
    k.f_a = f(ctx, hi);
    k.f_b = k.f_c = f(ctx, lo);
    return NAME(find_between)(f, ctx, k, tol, out);
}
