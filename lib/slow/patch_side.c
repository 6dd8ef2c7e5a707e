/* Chebyshev's points and polynomials: Mason & Handscomb, Chebyshev Polynomials
 * (2003), ch. 6. */
#include "patch_side.h"

#include <float.h>
#include <math.h>

struct patch_side patch_side_of(const double at[], size_t cells)
{
    const bool is_exact = cells <= PATCH_SIDE;

    return (struct patch_side){ at, cells, is_exact ? (int) cells : PATCH_SIDE,
                                is_exact };
}

/* cos(pi (i + 1/2)/PATCH_SIDE) */
static const double chebyshev_point[PATCH_SIDE] = {
    0x1.f9b24942fe45cp-1,  0x1.c83201d3d2c6dp-1,  0x1.6a09e667f3bcdp-1,
    0x1.d0e2e2b44de01p-2,  0x1.4060b67a85375p-3,  -0x1.4060b67a85375p-3,
    -0x1.d0e2e2b44de01p-2, -0x1.6a09e667f3bcdp-1, -0x1.c83201d3d2c6dp-1,
    -0x1.f9b24942fe45cp-1
};

/* T_0(t), T_1(t), ... */
static void chebyshev(double t, double T[PATCH_SIDE])
{
    T[0] = 1.0;
    T[1] = t;
    for (int k = 2; k < PATCH_SIDE; k++)
        T[k] = 2.0 * t * T[k - 1] - T[k - 2];
}

double patch_side_node(const struct patch_side *s, int i)
{
    const double lo = s->at[0], hi = s->at[s->cells - 1];

    return s->is_exact ? s->at[i]
                       : 0.5 * (lo + hi) + 0.5 * (hi - lo) * chebyshev_point[i];
}

/* c[k] = (2/n) sum f_i T_k(t_i), half of it for k = 0. */
void patch_side_transform(const struct patch_side *s, double f[], size_t stride)
{
    double c[PATCH_SIDE] = { 0 };

    if (s->is_exact)
        return;
    for (int i = 0; i < PATCH_SIDE; i++) {
        double T[PATCH_SIDE];
        chebyshev(chebyshev_point[i], T);
        for (int k = 0; k < PATCH_SIDE; k++)
            c[k] += f[(size_t) i * stride] * T[k];
    }
    for (int k = 0; k < PATCH_SIDE; k++)
        f[(size_t) k * stride] = c[k] * (k == 0 ? 1.0 : 2.0) / PATCH_SIDE;
}

bool patch_side_basis(const struct patch_side *s, double at,
                      double basis[PATCH_SIDE])
{
    const double lo = s->at[0], hi = s->at[s->cells - 1];
    bool is_known = !s->is_exact;

    if (is_known)
        chebyshev((2.0 * at - lo - hi) / (hi - lo), basis);
    for (int i = 0; i < s->nodes && s->is_exact; i++) {
        basis[i] = s->at[i] == at;
        is_known = is_known || s->at[i] == at;
    }
    return is_known;
}

/* l_i(t) = T_n(t) T_n'(t_i)^-1/(t - t_i), with n^2 (1 - t_i^2)^-1 the square of
 * that slope. */
struct patch_point patch_side_point(const struct patch_side *s, double at)
{
    struct patch_point p = { .left_out = 0.0 };

    patch_side_basis(s, at, p.basis);
    if (!s->is_exact)
        p.left_out = fabs(2.0 * p.basis[1] * p.basis[PATCH_SIDE - 1] -
                          p.basis[PATCH_SIDE - 2]);
    for (int i = 0; i < s->nodes; i++) {
        const double t = chebyshev_point[i], d = fabs(p.basis[1] - t);
        p.weight[i] = s->is_exact ? p.basis[i]
                      : d < sqrt(DBL_EPSILON)
                          ? 1.0
                          : p.left_out / PATCH_SIDE * sqrt(1.0 - t * t) / d;
    }
    return p;
}

/* (1/n) sum cot((2 k - 1) pi/(4 n)), at the ends. */
double patch_side_weight(const struct patch_side *s)
{
    static const double of_chebyshev = 2.43;

    return s->is_exact ? 1.0 : of_chebyshev;
}

size_t patch_side_cut(const struct patch_side *s, size_t parts, size_t i)
{
    return s->cells * i / parts;
}
