/* With c_k the coefficients along one side, p the polynomial through f at the n
 * zeros of T_n, where T_{n+k} = -T_{n-k},
 *
 *     f - p = T_n (c_n + 2 c_{n+1} T_1 + 2 c_{n+2} T_2 + ...),
 *
 * and coefficients that are not known are taken to fall as those known did: in
 * pairs, for one of two may vanish by symmetry.  Where tests miss more than
 * such a bound, it grows, and some more.  What samples miss is smooth, which
 * goes on as it is, or independent: with their bars e_ij
 *
 *     sum_ij l_i(x)^2 l_j(y)^2 e_ij^2
 *         <= sum_i l_i(x)^2 sum_j l_j(y)^2 max_i e_ij^2
 *
 * is the square of what is likely of it, which is taken a few times over; only
 * signs that alternate would make 5 e of it, Lebesgue's constant. */
#include "patch_poly.h"

#include <float.h>
#include <math.h>

#include "slow_tolerance.h"

static double value_at(const struct patch_poly *p, const struct patch_side *x,
                       const struct patch_side *y, const double Bx[PATCH_SIDE],
                       const double By[PATCH_SIDE])
{
    double sum = 0.0;

    for (int j = 0; j < y->nodes; j++) {
        double row = 0.0;
        for (int i = 0; i < x->nodes; i++)
            row += p->coef[j][i] * Bx[i];
        sum += row * By[j];
    }
    return sum;
}

/* ---- what is left out ---------------------------------------------------- */

/* With E the larger of the last two and q what that is of those before, pairs
 * to come are at most q E, q^2 E, ..., and
 *
 *     |f - p| <= |T_n| (3 q E + 4 q^2 E + ...) = |T_n| q E (3 + q)/(1 - q). */
static double tail_of(const struct patch_side *s, const double size[PATCH_SIDE])
{
    enum { LAST = PATCH_SIDE / 2 - 1 };
    double pair[LAST + 1];

    if (s->is_exact)
        return 0.0;
    for (int k = 0; k <= LAST; k++)
        pair[k] = fmax(size[2 * k], size[2 * k + 1]);
    const double E = pair[LAST];
    if (E == 0.0)
        return 0.0;
    const double falls = fmax(E / pair[LAST - 1], sqrt(E / pair[LAST - 2]));
    const double q = fmin(falls, TOL_PATCH_SLOWEST);
    return q * E * (3.0 + q) / (1.0 - q);
}

/* Of all coefficients along both sides: *size is the sum of their sizes. */
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
    p->x = tail_of(x, of_x);
    p->y = tail_of(y, of_y);
}

/* ---- noise --------------------------------------------------------------- */

static void find_noise(struct patch_poly *p, const struct patch_side *x,
                       const struct patch_numbers *n, double rounding)
{
    const size_t columns = (size_t) x->nodes;

    for (size_t i = 0; i < n->nodes; i++) {
        double *const row = &p->noise[i / columns];
        if (i % columns == 0)
            *row = 0.0;
        *row = fmax(*row, TOL_PATCH_SPREAD * n->error[i] + rounding);
    }
}

static double noise_at(const struct patch_poly *p, const struct patch_side *y,
                       const double square[PATCH_SIDE])
{
    double sum = 0.0;

    for (int j = 0; j < y->nodes; j++)
        sum += square[j] * p->noise[j] * p->noise[j];
    return sqrt(sum);
}

/* ---- fitting ------------------------------------------------------------- */

/* What the tests miss, less what they and the samples may be wrong, over what
 * is said to be left out. */
static double missed(const struct patch_poly *p, const struct patch_side *x,
                     const struct patch_side *y, const struct patch_numbers *n)
{
    double most = 0.0, Bx[PATCH_SIDE];

    for (size_t i = n->nodes; i < n->count; i++) {
        if (!patch_side_basis(x, n->z[i].x, Bx))
            continue;
        const struct patch_level at = patch_level_at(y, n->z[i].y);
        const double off = fabs(value_at(p, x, y, Bx, at.basis) - n->value[i]) -
                           n->error[i] -
                           noise_at(p, y, at.square) * patch_side_spread(x, Bx);
        if (off > 0.0)
            most = fmax(most, off / (p->x * patch_side_left_out(x, Bx) +
                                     p->y * at.left_out));
    }
    return most;
}

void patch_poly_fit(struct patch_poly *p, const struct patch_side *x,
                    const struct patch_side *y, const struct patch_numbers *n)
{
    const size_t columns = (size_t) x->nodes;
    double size, noise = 0.0;

    for (size_t i = 0; i < n->nodes; i++)
        p->coef[i / columns][i % columns] = n->value[i];
    for (int j = 0; j < y->nodes; j++)
        patch_side_transform(x, p->coef[j], 1);
    for (int i = 0; i < x->nodes; i++)
        patch_side_transform(y, &p->coef[0][i], PATCH_SIDE);
    find_tails(p, x, y, &size);
    find_noise(p, x, n, TOL_ROUNDINGS_FEW * DBL_EPSILON * size);
    const double more = fmax(1.0, TOL_PATCH_TESTS * missed(p, x, y, n));
    p->x *= more;
    p->y *= more;
    for (int j = 0; j < y->nodes; j++)
        noise = fmax(noise, p->noise[j]);
    p->bar = p->x + p->y + 2.0 * noise;
}

/* ---- rows ---------------------------------------------------------------- */

struct patch_level patch_level_at(const struct patch_side *y, double at)
{
    struct patch_level l = { .left_out = 0.0 };

    patch_side_basis(y, at, l.basis);
    patch_side_squares(y, at, l.square);
    l.left_out = patch_side_left_out(y, l.basis);
    return l;
}

struct patch_line patch_poly_line(const struct patch_poly *p,
                                  const struct patch_side *x,
                                  const struct patch_side *y,
                                  const struct patch_level *level)
{
    struct patch_line l = { .bar = p->y * level->left_out,
                            .x = p->x,
                            .noise = noise_at(p, y, level->square) };

    for (int i = 0; i < x->nodes; i++)
        for (int j = 0; j < y->nodes; j++)
            l.coef[i] += p->coef[j][i] * level->basis[j];
    return l;
}

double patch_line_at(const struct patch_line *l, const struct patch_side *x,
                     const double basis[PATCH_SIDE])
{
    double sum = 0.0;

    for (int i = 0; i < x->nodes; i++)
        sum += l->coef[i] * basis[i];
    return sum;
}
