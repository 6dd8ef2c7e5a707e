/*
 * Halves of [0, 1] until the Bernstein coefficients of p' change sign no more
 * than once: they have as many roots of p' as changes, or fewer by an even
 * number (Descartes' rule in Bernstein form; Collins & Akritas, SYMSAC 1976).
 * One change: one root, bisected.  Halves of halves that never come to that
 * hold a root of even order, or nothing but rounding: their middle is given.
 */
#include "turning.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "tolerance.h"

struct search {
    size_t degree;
    double slope[JET_SIZE]; /* p' */
    double noise;           /* coefficients below this are zero */
    int last;               /* sign of p' so far; 0: none yet */
    double *at;
    size_t found;
};

/* From powers to Bernstein's basis: c_i over the binomial (n, i), then sums
 * of these times (j, i). */
static void to_bernstein(size_t n, const double c[], double b[])
{
    double binomial = 1.0;

    for (size_t i = 0; i <= n; i++) {
        b[i] = c[i] / binomial;
        binomial *= (double) (n - i) / (double) (i + 1);
    }
    for (size_t i = 1; i <= n; i++)
        for (size_t j = n; j >= i; j--)
            b[j] += b[j - 1];
}

struct turning_range turning_bound(size_t degree, const double c[])
{
    double b[JET_SIZE];

    to_bernstein(degree, c, b);
    struct turning_range r = { b[0], b[0] };
    for (size_t i = 1; i <= degree; i++) {
        r.lo = fmin(r.lo, b[i]);
        r.hi = fmax(r.hi, b[i]);
    }
    return r;
}

/* The coefficients of both halves (de Casteljau). */
static void halve(size_t n, const double b[], double left[], double right[])
{
    memcpy(right, b, (n + 1) * sizeof *b);
    for (size_t i = 0; i <= n; i++) {
        left[i] = right[0];
        for (size_t j = 0; j + i < n; j++)
            right[j] = 0.5 * (right[j] + right[j + 1]);
    }
}

/* Of b, and the first and the last sign; 0 where there is none. */
static size_t sign_changes(const struct search *s, const double b[], int end[2])
{
    size_t changes = 0;

    end[0] = end[1] = 0;
    for (size_t i = 0; i <= s->degree; i++) {
        const int sign = (b[i] > s->noise) - (b[i] < -s->noise);
        changes += sign * end[1] < 0;
        end[0] = end[0] ? end[0] : sign;
        end[1] = sign ? sign : end[1];
    }
    return changes;
}

/* Where the sign is no longer `first`. */
static double bisect(const struct search *s, double lo, double hi, int first)
{
    for (int i = 0; i < DBL_MANT_DIG; i++) {
        const double middle = 0.5 * (lo + hi);
        if (first * jet_at(s->degree, s->slope, middle) > 0.0)
            lo = middle;
        else
            hi = middle;
    }
    return 0.5 * (lo + hi);
}

static void add(struct search *s, double at)
{
    const double before = s->found > 0 ? s->at[s->found - 1] : 0.0;

    if (s->found < TURNING_MAX && at > before && at < 1.0)
        s->at[s->found++] = at;
}

static void look_in(struct search *s, const double b[], double lo, double hi)
{
    const double middle = 0.5 * (lo + hi);
    double left[JET_SIZE], right[JET_SIZE];
    int end[2];
    const size_t changes = sign_changes(s, b, end);

    if (changes > 1 && hi - lo > TOL_PIECE_SHORTEST) {
        halve(s->degree, b, left, right);
        look_in(s, left, lo, middle);
        look_in(s, right, middle, hi);
        return;
    }
    if (s->last * end[0] < 0) /* somewhere before, too small to tell */
        add(s, lo);
    if (changes > 0)
        add(s, changes == 1 ? bisect(s, lo, hi, end[0]) : middle);
    s->last = end[1] ? end[1] : s->last;
}

size_t turning_find(size_t degree, const double c[], double at[TURNING_MAX])
{
    struct search s = { .degree = degree > 0 ? degree - 1 : 0, .at = at };
    double b[JET_SIZE];

    for (size_t k = 1; k <= degree; k++) {
        s.slope[k - 1] = (double) k * c[k];
        s.noise += fabs(s.slope[k - 1]);
    }
    s.noise *= TOL_ROUNDINGS_MANY * DBL_EPSILON;
    to_bernstein(s.degree, s.slope, b);
    look_in(&s, b, 0.0, 1.0);
    return s.found;
}
