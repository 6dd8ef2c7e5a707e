/* The error is the form of eq. (10.17) of Hairer, Norsett & Wanner (1993),
 * err5^2 / sqrt(err5^2 + 0.01 err3^2). */
#include "explicit8.h"

#include <math.h>
#include <string.h>

#include "explicit8_table.h"

enum { STAGES = EXPLICIT8_STAGES, ALL = EXPLICIT8_ALL };

static const double dense[4][ALL] = {
    { -8.4289382761090128651353491142, 0.0, 0.0, 0.0, 0.0,
      0.56671495351937776962531783590, -3.0689499459498916912797304727,
      2.3846676565120698287728149680, 2.1170345824450282767155149946,
      -0.87139158377797299206789907490, 2.2404374302607882758541771650,
      0.63157877876946881815570249290, -0.088990336451333310820698117400,
      18.148505520854727256656404962, -9.1946323924783554000451984436,
      -4.4360363875948939664310572000 },
    { 10.427508642579134603413151009, 0.0, 0.0, 0.0, 0.0,
      242.28349177525818288430175319, 165.20045171727028198505394887,
      -374.54675472269020279518312152, -22.113666853125306036270938578,
      7.7334326684722638389603898808, -30.674084731089398182061213626,
      -9.3321305264302278729567221706, 15.697238121770843886131091075,
      -31.139403219565177677282850411, -9.3529243588444783865713862664,
      35.816841486394083752465898540 },
    { 19.985053242002433820987653617, 0.0, 0.0, 0.0, 0.0,
      -387.03730874935176555105901742, -189.17813819516756882690830838336,
      527.80815920542364900561016686, -11.573902539959630126141871134,
      6.8812326946963000169666922661, -1.0006050966910838403183860980,
      0.77771377980534432092869265740, -2.7782057523535084065932004339,
      -60.196695231264120758267380846, 84.320405506677161018159903784,
      11.992291136182789328035130030 },
    { -25.693933462703749003312586129, 0.0, 0.0, 0.0, 0.0,
      -154.18974869023643374053993627, -231.52937917604549567536039109,
      357.63911791061412378285349910, 93.405324183624310003907691704,
      -37.458323136451633156875139351, 104.09964950896230045147246184,
      29.840293426660503123344363579, -43.533456590011143754432175058,
      96.324553959188282948394950600, -39.177261675615439165231486172,
      -149.72683625798562581422125276 },
};

/* sum_j weight[j] k[j] */
static void combine(const struct explicit8 *w, size_t dim, size_t count,
                    const double weight[], double sum[])
{
    memset(sum, 0, dim * sizeof *sum);
    for (size_t j = 0; j < count; j++) {
        if (weight[j] == 0.0)
            continue;
        for (size_t i = 0; i < dim; i++)
            sum[i] += weight[j] * w->k[j][i];
    }
}

/* The argument of stage j; k[j] = rhs there. */
static void stage(struct explicit8 *w, const struct ode *ode, size_t j,
                  double s, const double u[], double h, double at[])
{
    combine(w, ode->dim, j, explicit8_a[j], at);
    for (size_t i = 0; i < ode->dim; i++)
        at[i] = u[i] + h * at[i];
    ode->rhs(ode->ctx, s + explicit8_node[j] * h, at, w->k[j]);
}

double explicit8_try(struct explicit8 *w, const struct ode *ode, double s,
                     const double u[], double h, const double atol[],
                     double rtol, double u1[], double error[])
{
    const size_t dim = ode->dim;
    double at[CURVE_DIM_MAX], third[CURVE_DIM_MAX];
    double sum5 = 0.0, sum3 = 0.0;

    for (size_t j = 1; j < STAGES; j++)
        stage(w, ode, j, s, u, h, at);
    combine(w, dim, STAGES, explicit8_a[STAGES], u1);
    combine(w, dim, STAGES, explicit8_weight3, third);
    combine(w, dim, STAGES, explicit8_error5, error);
    for (size_t i = 0; i < dim; i++) {
        const double e3 = u1[i] - third[i], e5 = error[i];
        u1[i] = u[i] + h * u1[i];
        const double scale = atol[i] + rtol * fmax(fabs(u[i]), fabs(u1[i]));
        sum3 += (e3 / scale) * (e3 / scale);
        sum5 += (e5 / scale) * (e5 / scale);
        error[i] = fabs(h * e5);
    }
    if (sum5 == 0.0)
        return 0.0;
    return fabs(h) * sum5 / sqrt((double) dim * (sum5 + 0.01 * sum3));
}

/* p <- c + theta p and p <- c + (1 - theta) p, degree of p before: n. */
static void times_theta(double p[], size_t n, double c)
{
    for (size_t j = n + 1; j >= 1; j--)
        p[j] = p[j - 1];
    p[0] = c;
}

static void times_rest(double p[], size_t n, double c)
{
    p[n + 1] = -p[n];
    for (size_t j = n; j >= 1; j--)
        p[j] -= p[j - 1];
    p[0] += c;
}

void explicit8_dense(struct explicit8 *w, const struct ode *ode, double s,
                     const double u[], double h, const double u1[],
                     double coef[])
{
    const size_t dim = ode->dim;
    double at[CURVE_DIM_MAX], d[4][CURVE_DIM_MAX];

    ode->rhs(ode->ctx, s + h, u1, w->k[STAGES]);
    for (size_t j = STAGES + 1; j < ALL; j++)
        stage(w, ode, j, s, u, h, at);
    for (size_t n = 0; n < 4; n++)
        combine(w, dim, ALL, dense[n], d[n]);
    for (size_t i = 0; i < dim; i++) {
        double *p = coef + i * (EXPLICIT8_DEGREE + 1);
        const double rise = u1[i] - u[i];
        const double bend = h * w->k[0][i] - rise;

        p[0] = h * d[3][i];
        times_theta(p, 0, h * d[2][i]);
        times_rest(p, 1, h * d[1][i]);
        times_theta(p, 2, h * d[0][i]);
        times_rest(p, 3, rise - h * w->k[STAGES][i] - bend);
        times_theta(p, 4, bend);
        times_rest(p, 5, rise);
        times_theta(p, 6, u[i]);
    }
}
