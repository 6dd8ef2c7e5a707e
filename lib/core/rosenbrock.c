/* Coefficients: Steinebach (2023), in the form that needs no product with the
 * Jacobian (Hairer & Wanner, Solving ODEs II, sec. IV.7, eq. (7.25)):
 *     (I/(gamma h) - J) k_i = f(u + sum_j a_ij k_j) + sum_j c_ij k_j / h.
 * Changed: J has two columns only, so each stage is a 2x2 solve and one
 * substitution for each integral. */
#include "rosenbrock.h"

enum { STAGES = ROSENBROCK_STAGES };

static const double gamma_ = 0.21193756319429014;

static const double a[STAGES][STAGES - 1] = {
    [1] = { 3.0 },
    [2] = { 2.849394379747939, 0.45842242204463923 },
    [3] = { -6.954028509809101, 2.489845061869568, -10.358996098473584 },
    [4] = { 2.8029986275628964, 0.5072464736228206, -0.3988312541770524,
            -0.04721187230404641 },
    [5] = { -7.502846399306121, 2.561846144803919, -11.627539656261098,
            -0.18268767659942256, 0.030198172008377946 },
    [6] = { -7.502846399306121, 2.561846144803919, -11.627539656261098,
            -0.18268767659942256, 0.030198172008377946, 1.0 },
    [7] = { -7.502846399306121, 2.561846144803919, -11.627539656261098,
            -0.18268767659942256, 0.030198172008377946, 1.0, 1.0 },
};

static const double c[STAGES][STAGES - 1] = {
    [1] = { -14.155112264123755 },
    [2] = { -17.97296035885952, -2.859693295451294 },
    [3] = { 147.12150275711716, -1.41221402718213, 71.68940251302358 },
    [4] = { 165.43517024871676, -0.4592823456491126, 42.90938336958603,
            -5.961986721573306 },
    [5] = { 24.854864614690072, -3.0009227002832186, 47.4931110020768,
            5.5814197821558125, -0.6610691825249471 },
    [6] = { 30.91273214028599, -3.1208243349937974, 77.79954646070892,
            34.28646028294783, -19.097331116725623, -28.087943162872662 },
    [7] = { 37.80277123390563, -3.2571969029072276, 112.26918849496327,
            66.9347231244047, -40.06618937091002, -54.66780262877968,
            -9.48861652309627 },
};

static const double dense[3][STAGES] = {
    { 25.948786856663858, -2.5579724845846235, 10.433815404888879,
      -2.3679251022685204, 0.524948541321073, 1.1241088310450404,
      0.4272876194431874, -0.17202221070155493 },
    { -9.91568850695171, -0.9689944594115154, 3.0438037242978453,
      -24.495224566215796, 20.176138334709044, 15.98066361424651,
      -6.789040303419874, -6.710236069923372 },
    { 11.419903575922262, 2.8879645146136994, 72.92137995996029,
      80.12511834622643, -52.072871366152654, -59.78993625266729,
      -0.15582684282751913, 4.883087185713722 },
};

static double combine(const struct rosenbrock *w, size_t i, size_t count,
                      const double weight[])
{
    double sum = 0.0;

    for (size_t j = 0; j < count; j++)
        sum += weight[j] * w->k[j][i];
    return sum;
}

/* The inverse of I/(gamma h) - J for the plane. */
static struct mat2 inverse(const struct cascade_linear *at, double h)
{
    const double shift = 1.0 / (gamma_ * h);
    const struct mat2 A = { shift - at->slope[0].x, -at->slope[0].y,
                            -at->slope[1].x, shift - at->slope[1].y };
    const double det = mat2_det(A);

    return (struct mat2){ A.yy / det, -A.xy / det, -A.yx / det, A.xx / det };
}

/* k <- the stage whose right-hand side k holds on entry. */
static void solve(const struct mat2 *inv, const struct cascade_linear *at,
                  size_t dim, double h, double k[])
{
    const double x = inv->xx * k[0] + inv->xy * k[1];
    const double y = inv->yx * k[0] + inv->yy * k[1];

    k[0] = x;
    k[1] = y;
    for (size_t i = 2; i < dim; i++)
        k[i] = gamma_ * h * (k[i] + at->slope[i].x * x + at->slope[i].y * y);
}

void rosenbrock_try(struct rosenbrock *w, const struct cascade *system,
                    const struct cascade_linear *at, const double u[], double h,
                    double u1[])
{
    const size_t dim = system->dim;
    const struct mat2 inv = inverse(at, h);
    const double per_h = 1.0 / h;

    for (size_t i = 0; i < dim; i++)
        w->k[0][i] = at->du[i];
    solve(&inv, at, dim, h, w->k[0]);
    for (size_t s = 1; s < STAGES; s++) {
        const struct vec2 z = { u[0] + combine(w, 0, s, a[s]),
                                u[1] + combine(w, 1, s, a[s]) };
        system->rhs(system->ctx, z, w->k[s]);
        for (size_t i = 0; i < dim; i++)
            w->k[s][i] += combine(w, i, s, c[s]) * per_h;
        solve(&inv, at, dim, h, w->k[s]);
    }
    for (size_t i = 0; i < dim; i++)
        u1[i] = u[i] + combine(w, i, STAGES - 1, a[STAGES - 1]) +
                w->k[STAGES - 1][i];
}

void rosenbrock_dense(const struct rosenbrock *w, size_t dim, const double u[],
                      const double u1[], double coef[])
{
    for (size_t i = 0; i < dim; i++) {
        double *p = coef + i * (ROSENBROCK_DEGREE + 1);
        const double d0 = combine(w, i, STAGES, dense[0]);
        const double d1 = combine(w, i, STAGES, dense[1]);
        const double d2 = combine(w, i, STAGES, dense[2]);

        p[0] = u[i];
        p[1] = u1[i] - u[i] + d0;
        p[2] = d1 - d0;
        p[3] = d2 - d1;
        p[4] = -d2;
    }
}
