#include "interval_point.h"

#include <math.h>

#include "interval_math.h"

#define UNIT     0x1p-64L
#define LEAST    0x1p-16445L
#define LN2_HIGH 0x1.62e42fefa39e8p-1L
#define LN2_LOW  0xe6af278ece600fccp-114L
#define MOST_EXP 11000
#define MOST_LN  0x1p15800L

static struct interval all(void)
{
    return (struct interval){ -HUGE_VALL, HUGE_VALL };
}

/* q of |r| < 0.35 */
static long double series(long double r)
{
    static const long double factorial[] = { 1.0L / 1307674368000,
                                             1.0L / 87178291200,
                                             1.0L / 6227020800,
                                             1.0L / 479001600,
                                             1.0L / 39916800,
                                             1.0L / 3628800,
                                             1.0L / 362880,
                                             1.0L / 40320,
                                             1.0L / 5040,
                                             1.0L / 720,
                                             1.0L / 120,
                                             1.0L / 24,
                                             1.0L / 6,
                                             1.0L / 2 };
    long double sum = 1.0L / 20922789888000;

    for (size_t i = 0; i < sizeof factorial / sizeof *factorial; i++)
        sum = sum * r + factorial[i];
    return r + r * r * sum;
}

/* 3 u to both sides. */
static struct interval beside(long double y)
{
    const long double room = 3 * UNIT * fabsl(y) + LEAST;

    return (struct interval){ y - room, y + room };
}

struct interval interval_exp_at(long double x)
{
    if (!(fabsl(x) <= MOST_EXP)) {
        if (x > 0)
            return (struct interval){ interval_exp_at(MOST_EXP).lo, HUGE_VALL };
        return x < 0 ? (struct interval){ 0, interval_exp_at(-MOST_EXP).hi }
                     : all();
    }
    if (x >= 0 && x <= 0)
        return interval_point(1);
    const int k = (int) rintl(x / (LN2_HIGH + LN2_LOW));
    const struct interval e =
        beside(1 + series((x - k * LN2_HIGH) - k * LN2_LOW));

    return (struct interval){ ldexpl(e.lo, k), ldexpl(e.hi, k) };
}

struct interval interval_expm1_at(long double x)
{
    if (x >= 0 && x <= 0)
        return interval_point(0);
    return fabsl(x) < 0.35L
               ? beside(series(x))
               : interval_less(interval_exp_at(x), interval_point(1));
}

/* y + ln(1 + d) */
static struct interval corrected(long double y, struct interval d)
{
    if (!(d.lo >= -0.5L))
        return all();
    const struct interval least = interval_less(d, interval_times(d, d));

    return interval_add(interval_point(y), (struct interval){ least.lo, d.hi });
}

/* ln(1 + x), -1/2 <= x <= 1 */
static struct interval ln1p_near(long double x)
{
    const struct interval z = interval_point(x), one = interval_point(1);
    const long double y = log1p((double) x);

    return corrected(
        y, interval_add(
               interval_times(interval_add(one, z), interval_expm1_at(-y)), z));
}

struct interval interval_ln_at(long double x)
{
    int k;

    if (!(x > 0))
        return all();
    if (x >= 0.5L && x <= 2) /* x - 1 is exact */
        return ln1p_near(x - 1);
    if (x > MOST_LN)
        return (struct interval){ interval_ln_at(MOST_LN).lo, HUGE_VALL };
    if (x < 1 / MOST_LN)
        return (struct interval){ -HUGE_VALL, interval_ln_at(1 / MOST_LN).hi };
    const double part = (double) frexpl(x, &k);
    const long double y = log(part) + k * LN2_HIGH;

    return corrected(
        y, interval_less(interval_times(interval_point(x), interval_exp_at(-y)),
                         interval_point(1)));
}

struct interval interval_ln1p_at(long double x)
{
    if (x >= -0.5L && x <= 1)
        return ln1p_near(x);
    const struct interval z =
        interval_add(interval_point(x), interval_point(1));

    return (struct interval){ interval_ln_at(z.lo).lo,
                              interval_ln_at(z.hi).hi };
}
