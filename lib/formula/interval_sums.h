/*
 * interval_sums.h -- interval.h's arithmetic for one kind of number: REAL, with
 * FN(f) its function f, NAME(x) and OWN(x) naming what others see and do not,
 * LINK before those, UNIT = 2^-52, 2^-63 or 2^-112, LEAST and MOST its least
 * and largest positive number.
 *
 * Rounding outward: r is between the neighbours of c = fl(r), and c -+ (PHI |c|
 * + LEAST), PHI = UNIT/2 (1 + UNIT), rounded, are these or farther (Rump,
 * Zimmermann, Boldo & Melquiond, BIT 49 (2009) 419).  A sum is exact where it
 * is 0, or where Knuth's error of it is.
 */

#define ENDLESS ((REAL) HUGE_VAL)

typedef struct NAME(interval) OWN(range);

#define PHI (UNIT / 2 * (1 + UNIT))

static inline REAL OWN(room)(REAL r)
{
    return FN(fabs)(r) * PHI + LEAST;
}

static inline REAL OWN(below)(REAL r)
{
    return r > MOST ? MOST : r - OWN(room)(r);
}

static inline REAL OWN(above)(REAL r)
{
    return r < -MOST ? -MOST : r + OWN(room)(r);
}

static inline REAL OWN(smaller)(REAL a, REAL b)
{
    return a < b ? a : b;
}

static inline REAL OWN(larger)(REAL a, REAL b)
{
    return a > b ? a : b;
}

static inline OWN(range) OWN(point)(REAL x)
{
    return (OWN(range)){ x, x };
}

static inline OWN(range) OWN(all)(void)
{
    return (OWN(range)){ -ENDLESS, ENDLESS };
}

/* ---- arithmetic ---------------------------------------------------------- */

/* a + b less its rounded value, exactly; a NaN where that is not finite. */
static inline REAL OWN(missed)(REAL a, REAL b, REAL sum)
{
    const REAL other = sum - a;

    return (a - (sum - other)) + (b - other);
}

LINK OWN(range) NAME(interval_add)(OWN(range) u, OWN(range) w)
{
    const REAL lo = u.lo + w.lo, hi = u.hi + w.hi;

    /* factors, for a branch here is guessed wrong as often as right */
    const REAL down = !(OWN(missed)(u.lo, w.lo, lo) >= 0);
    const REAL up = !(OWN(missed)(u.hi, w.hi, hi) <= 0);

    return (OWN(range)){ lo > MOST ? MOST : lo - down * OWN(room)(lo),
                         hi < -MOST ? -MOST : hi + up * OWN(room)(hi) };
}

static inline OWN(range) OWN(minus)(OWN(range) u)
{
    return (OWN(range)){ -u.hi, -u.lo };
}

LINK OWN(range) NAME(interval_less)(OWN(range) u, OWN(range) w)
{
    return NAME(interval_add)(u, OWN(minus)(w));
}

/* An end is 0 times infinity only where the other factor is 0. */
static inline REAL OWN(end)(REAL a, REAL b)
{
    return a < 0 || a > 0 ? (b < 0 || b > 0 ? a * b : 0) : 0;
}

static inline bool OWN(is_point)(OWN(range) u, REAL x)
{
    return u.lo >= x && u.hi <= x;
}

/* Of u >= 0. */
static inline OWN(range) OWN(multiple)(OWN(range) u, OWN(range) w)
{
    const REAL lo = OWN(below)(OWN(end)(w.lo < 0 ? u.hi : u.lo, w.lo));
    const REAL hi = OWN(above)(OWN(end)(w.hi > 0 ? u.hi : u.lo, w.hi));

    return (OWN(range)){ w.lo >= 0 ? OWN(larger)(lo, 0) : lo,
                         w.hi <= 0 ? OWN(smaller)(hi, 0) : hi };
}

LINK OWN(range) NAME(interval_times)(OWN(range) u, OWN(range) w)
{
    if (OWN(is_point)(u, 0) || OWN(is_point)(w, 0))
        return OWN(point)(0);
    if (OWN(is_point)(u, 1))
        return w;
    if (OWN(is_point)(w, 1))
        return u;
    if (OWN(is_point)(u, -1))
        return OWN(minus)(w);
    if (u.lo >= 0)
        return OWN(multiple)(u, w);
    if (w.lo >= 0)
        return OWN(multiple)(w, u);
    if (u.hi <= 0)
        return OWN(minus)(OWN(multiple)(OWN(minus)(u), w));
    if (w.hi <= 0)
        return OWN(minus)(OWN(multiple)(OWN(minus)(w), u));
    const REAL p = u.lo * w.lo, q = u.lo * w.hi;
    const REAL r = u.hi * w.lo, s = u.hi * w.hi;
    return (OWN(range)){ OWN(below)(OWN(smaller)(q, r)),
                         OWN(above)(OWN(larger)(p, s)) };
}

/* Where w is not 0. */
static inline OWN(range) OWN(inverse)(OWN(range) w)
{
    if (w.lo < 0 && w.hi > 0)
        return OWN(all)();
    const REAL lo = w.hi < 0 || w.hi > 0 ? OWN(below)(1 / w.hi) : -ENDLESS;
    const REAL hi = w.lo < 0 || w.lo > 0 ? OWN(above)(1 / w.lo) : ENDLESS;
    if (w.lo >= 0)
        return (OWN(range)){ OWN(larger)(lo, 0), hi };
    return (OWN(range)){ lo, OWN(smaller)(hi, 0) };
}
