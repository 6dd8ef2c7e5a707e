/* With c_k the coefficients along one side, p the polynomial through f at the n
 * zeros of T_n, where T_{n+k} = -T_{n-k},
 *
 *     f - p = T_n (c_n + 2 c_{n+1} T_1 + 2 c_{n+2} T_2 + ...),
 *
 * and coefficients that are not known are taken to fall as those known did: in
 * pairs, for one of two may vanish by symmetry.  How they fall is asked of all
 * along a side, how large the last are of those at the place.  Where tests miss
 * more than such a bound, it grows, and some more; what they cannot tell from
 * their own error is added.  What samples miss, e_ij at
 * most, is multiplied by l_i(x) l_j(y) each:
 *
 *     |sum l_i(x) l_j(y) (what sample ij misses)| <= sum |l_i(x) l_j(y)| e_ij.
 */
#include "patch_poly.h"

#include <float.h>
#include <math.h>

#include "slow_tolerance.h"

enum { PAIRS = PATCH_SIDE / 2, LAST = PATCH_SIDE - PATCH_LAST };

/* ---- what is left out ---------------------------------------------------- */

static double larger(double a, double b)
{
    return fmax(fabs(a), fabs(b));
}

/* Of the last coefficients at some place, or as large as they are at most: the
 * largest of what they say of c_{n-2}. */
static double left_out(const struct patch_tail *t, const double c[PATCH_LAST])
{
    const double r = t->falls;

    return t->left > 0.0 ? t->left * fmax(larger(c[2], c[3] / r),
                                          r * larger(r * c[0], c[1]))
                         : 0.0;
}

/* With r the ratio in which coefficients fall and E what c_{n-2} is at most,
 * the pairs to come are at most r^2 E, r^4 E, ..., and with q = r^2
 *
 *     |f - p| <= |T_n| (3 q E + 4 q^2 E + ...) = |T_n| q E (3 + q)/(1 - q).
 *
 * Of coefficients that are rounding nothing is said. */
static struct patch_tail tail_of(const struct patch_side *s,
                                 const double size[PATCH_SIDE], double rounding)
{
    const struct patch_tail none = { 0.0, 0.0 };
    double pair[PAIRS];

    for (int k = 0; k < PAIRS; k++)
        pair[k] = fmax(larger(size[2 * k], size[2 * k + 1]) - rounding, 0.0);
    const double E = pair[PAIRS - 1];
    if (s->is_exact || E == 0.0)
        return none;
    const double falls = fmax(E / pair[PAIRS - 2], sqrt(E / pair[PAIRS - 3]));
    const double q = fmin(falls, TOL_PATCH_SLOWEST);
    return (struct patch_tail){ q * (3.0 + q) / (1.0 - q), sqrt(q) };
}

/* Of all coefficients along both sides, which sum to *size. */
static void find_tails(struct patch_poly *p, const struct patch_side *x,
                       const struct patch_side *y, double *size)
{
    double of_x[PATCH_SIDE] = { 0.0 }, of_y[PATCH_SIDE] = { 0.0 };

    *size = 0.0;
    for (int j = 0; j < y->nodes; j++)
        for (int i = 0; i < x->nodes; i++) {
            const double c = fabs(p->coef[j][i]);
            of_x[i] += c;
            of_y[j] += c;
            *size += c;
        }
    p->along_x = tail_of(x, of_x, DBL_EPSILON * *size);
    p->along_y = tail_of(y, of_y, DBL_EPSILON * *size);
    p->x = left_out(&p->along_x, of_x + LAST);
    p->y = left_out(&p->along_y, of_y + LAST);
}

/* ---- fitting ------------------------------------------------------------- */

/* The samples' bars; the largest. */
static double find_noise(struct patch_poly *p, const struct patch_side *x,
                         const struct patch_numbers *n)
{
    const size_t columns = (size_t) x->nodes;
    double most = 0.0;

    for (size_t i = 0; i < n->nodes; i++) {
        p->noise[i / columns][i % columns] = n->error[i];
        most = fmax(most, n->error[i]);
    }
    return most;
}

/* What the polynomial misses at a point, and its bar there in two parts. */
struct miss {
    double off, left, noise;
};

static struct miss miss_at(const struct patch_poly *p,
                           const struct patch_side *x,
                           const struct patch_side *y, struct vec2 z,
                           double value)
{
    const struct patch_point at = patch_side_point(x, z.x);
    const struct patch_point level = patch_side_point(y, z.y);
    const struct patch_line l = patch_poly_line(p, x, y, &level);
    const double above = patch_poly_above(p, x, &at);
    const double left = l.x * at.left_out + l.y * above;
    double bar;
    const double off = fabs(patch_line_at(&l, x, &at, above, &bar) - value);

    return (struct miss){ off, left, bar - left };
}

/* Of the tests: most of what is missed beyond what they and the samples may be
 * wrong, over what is said to be left out; and most of what may be missed
 * beyond the bar. */
static void look(const struct patch_poly *p, const struct patch_side *x,
                 const struct patch_side *y, const struct patch_numbers *n,
                 double *missed, double *beyond)
{
    double basis[PATCH_SIDE];

    *missed = *beyond = 0.0;
    for (size_t i = n->nodes; i < n->count; i++) {
        if (!patch_side_basis(x, n->z[i].x, basis))
            continue;
        const struct miss m = miss_at(p, x, y, n->z[i], n->value[i]);
        const double e = n->error[i];
        if (m.off > m.noise + e)
            *missed = fmax(*missed, (m.off - m.noise - e) / m.left);
        *beyond = fmax(*beyond, m.off + e - m.noise - m.left);
    }
}

static void grow(struct patch_poly *p, double more)
{
    p->along_x.left *= more;
    p->along_y.left *= more;
    p->x *= more;
    p->y *= more;
}

static void add_noise(struct patch_poly *p, double more)
{
    for (int j = 0; j < PATCH_SIDE; j++)
        for (int i = 0; i < PATCH_SIDE; i++)
            p->noise[j][i] += more;
}

void patch_poly_fit(struct patch_poly *p, const struct patch_side *x,
                    const struct patch_side *y, const struct patch_numbers *n)
{
    const size_t columns = (size_t) x->nodes;
    double size, missed, beyond;

    for (size_t i = 0; i < n->nodes; i++)
        p->coef[i / columns][i % columns] = n->value[i];
    for (int j = 0; j < y->nodes; j++)
        patch_side_transform(x, p->coef[j], 1);
    for (int i = 0; i < x->nodes; i++)
        patch_side_transform(y, &p->coef[0][i], PATCH_SIDE);
    find_tails(p, x, y, &size);
    p->rounding = TOL_ROUNDINGS_FEW * DBL_EPSILON * size;
    const double noise = find_noise(p, x, n);
    look(p, x, y, n, &missed, &beyond);
    grow(p, fmax(1.0, TOL_BAR_CHANCE * missed));
    look(p, x, y, n, &missed, &beyond);
    add_noise(p, beyond);
    const double bar =
        p->x + p->y + p->rounding +
        patch_side_weight(x) * patch_side_weight(y) * (noise + beyond);
    p->bar = isfinite(bar) ? bar : HUGE_VAL;
}

/* ---- rows ---------------------------------------------------------------- */

struct patch_line patch_poly_line(const struct patch_poly *p,
                                  const struct patch_side *x,
                                  const struct patch_side *y,
                                  const struct patch_point *level)
{
    struct patch_line l = { .y = level->left_out, .rounding = p->rounding };

    for (int j = 0; j < y->nodes; j++)
        for (int i = 0; i < x->nodes; i++) {
            l.coef[i] += p->coef[j][i] * level->basis[j];
            l.noise[i] += p->noise[j][i] * level->weight[j];
        }
    l.x = left_out(&p->along_x, l.coef + LAST);
    return l;
}

double patch_poly_above(const struct patch_poly *p, const struct patch_side *x,
                        const struct patch_point *at)
{
    double d[PATCH_LAST] = { 0.0 };

    for (int k = 0; k < PATCH_LAST && p->along_y.left > 0.0; k++)
        for (int i = 0; i < x->nodes; i++)
            d[k] += p->coef[LAST + k][i] * at->basis[i];
    return left_out(&p->along_y, d);
}

double patch_line_at(const struct patch_line *l, const struct patch_side *x,
                     const struct patch_point *at, double above, double *bar)
{
    double sum = 0.0, noise = l->rounding;

    for (int i = 0; i < x->nodes; i++) {
        sum += l->coef[i] * at->basis[i];
        noise += l->noise[i] * at->weight[i];
    }
    *bar = l->x * at->left_out + l->y * above + noise;
    return sum;
}
