/* The field's own series in y and w are found from its jets along lines w = m y
 * beside the curve: coefficient k of y on each is a polynomial of degree k in
 * m.
 */
#include "saddle_series.h"

#include <float.h>
#include <math.h>

#include "local.h"
#include "slider.h"
#include "slow_tolerance.h"

/* ---- the field ----------------------------------------------------------- */

enum { LINES = 16 };

/* Nodes of interpolation, each first so many of them spread over -1...1; the
 * first one is the curve itself. */
static const double slant[LINES] = { 0.0,    1.0,   -1.0,   0.58,
                                     -0.58,  0.84,  -0.84,  0.3,
                                     -0.3,   0.945, -0.945, 0.715,
                                     -0.715, 0.145, -0.145, 0.98 };

/* y', x' and the slip rate; all per unit of time e^-log_scale. */
enum { OF_Y, OF_X, OF_SLIP, PARTS };

struct field_series {
    double log_scale;
    double on_line[PARTS][SADDLE_SIZE][LINES]; /* coefficient k of y^k */
    saddle_coefs of[PARTS];
};

/* Along two of the lines. */
static void follow_lines(const struct slider *s, const struct saddle_series *u,
                         size_t line, struct field_series *f)
{
    const struct planar *sys = &s->plane.system;
    jet_pair at[2][JET_SIZE], along[2][JET_SIZE], slip[JET_SIZE];
    struct jet_work work = { .linear = at[1] };

    for (size_t k = 0; k <= u->order; k++) {
        at[0][k] = JET_PAIR(u->curve[k]);
        at[1][k] = JET_PAIR(k == 1 ? u->unit : 0.0);
        if (k == 1)
            at[0][k] += u->unit * (jet_pair){ slant[line], slant[line + 1] };
        sys->jet(sys->ctx, &work, k, at[0], at[1], along[0], along[1]);
        sys->rate_jet(sys->ctx, BLOCK_SLIP, &work, k, at[0], at[1], slip);
        for (size_t lane = 0; lane < JET_LANES; lane++) {
            f->on_line[OF_X][k][line + lane] = along[0][k][lane];
            f->on_line[OF_Y][k][line + lane] = along[1][k][lane];
            f->on_line[OF_SLIP][k][line + lane] = slip[k][lane];
        }
    }
    f->log_scale = work.log_scale[0];
}

/* The polynomial of degree k through value[0..k] at the slants, by Newton's
 * differences; out[b]: of m^b. */
static void interpolate(size_t k, const double value[LINES], double out[])
{
    double d[LINES];

    for (size_t i = 0; i <= k; i++)
        d[i] = value[i];
    for (size_t j = 1; j <= k; j++)
        for (size_t i = k; i >= j; i--)
            d[i] = (d[i] - d[i - 1]) / (slant[i] - slant[i - j]);
    for (size_t i = 0; i <= k; i++)
        out[i] = 0.0;
    for (size_t i = k + 1; i-- > 0;) {
        for (size_t b = k; b > 0; b--)
            out[b] = out[b - 1] - slant[i] * out[b];
        out[0] = d[i] - slant[i] * out[0];
    }
}

static void find_field(const struct slider *s, const struct saddle_series *u,
                       struct field_series *f)
{
    double by_slant[SADDLE_SIZE];

    for (size_t line = 0; line <= u->mixed; line += JET_LANES)
        follow_lines(s, u, line, f);
    for (int i = 0; i < PARTS; i++)
        for (size_t k = 0; k <= u->order; k++) {
            const size_t most = k <= u->mixed ? k : 0;
            interpolate(most, f->on_line[i][k], by_slant);
            for (size_t b = 0; b <= most; b++)
                f->of[i][b][k - b] = by_slant[b];
        }
}

/* ---- the series ---------------------------------------------------------- */

/* y' = g, w' = h, in units of y and of time in which the eigenvalues are plus
 * and minus. */
struct drift {
    double plus, minus;
    saddle_coefs g, h;
};

/* w' = x' - x_u'(y) y', which vanishes with w. */
static void find_drift(const struct saddle_series *u,
                       const struct field_series *f, struct drift *d)
{
    for (size_t b = 0; b <= u->mixed; b++)
        for (size_t a = 0; a + b <= (b == 0 ? u->order : u->mixed); a++) {
            double across = f->of[OF_X][b][a];
            d->g[b][a] = f->of[OF_Y][b][a] / u->unit;
            for (size_t i = 0; i <= a && i < u->order; i++)
                across -= (double) (i + 1) * u->curve[i + 1] * d->g[b][a - i];
            d->h[b][a] = b == 0 ? 0.0 : across / u->unit;
        }
    d->g[0][0] = 0.0;
    d->g[0][1] = d->plus;
    d->h[1][0] = d->minus;
}

/* Coefficient (b, a) of u_y g + u_w h, but for that of u itself. */
static double carried(const struct drift *d, saddle_coefs u, size_t b, size_t a)
{
    double sum = 0.0;

    for (size_t j = 0; j <= b; j++)
        for (size_t i = 0; i <= a + 1 && i + j <= a + b; i++) {
            if (i == a && j == b)
                continue;
            if (i > 0)
                sum += (double) i * u[j][i] * d->g[b - j][a + 1 - i];
            if (i <= a && j > 0)
                sum += (double) j * u[j][i] * d->h[b - j + 1][a - i];
        }
    return sum;
}

static void solve(const struct drift *d, saddle_coefs slip,
                  struct saddle_series *u)
{
    u->p[0][1] = 1.0;
    for (size_t n = 1; n <= u->order; n++)
        for (size_t b = 0; b <= (n <= u->mixed ? n : 0); b++) {
            const size_t a = n - b;
            const double rate = (double) a * d->plus + (double) b * d->minus;
            if (a != 1 || b != 0)
                u->p[b][a] = carried(d, u->p, b, a) / (d->plus - rate);
            u->q[b][a] = -(slip[b][a] + carried(d, u->q, b, a)) / rate;
        }
}

/* ---- how far they hold --------------------------------------------------- */

/* Where a term of order k is TOL_ROUNDED of size r^(k - less). */
static double limit(double radius, double term, double size, size_t k,
                    size_t less)
{
    return term == 0.0 ? radius
                       : fmin(radius, pow(TOL_ROUNDED * size / fabs(term),
                                          1.0 / (double) (k - less)));
}

static double order_sum(saddle_coefs c, size_t n)
{
    double sum = 0.0;

    for (size_t b = 0; b <= n; b++)
        sum += fabs(c[b][n - b]);
    return sum;
}

static void find_reach(struct saddle_series *u, double most)
{
    const double slip = u->v / u->lambda;

    u->radius = most;
    for (size_t k = u->order - 1; k <= u->order; k++) {
        u->radius = limit(u->radius, u->curve[k],
                          fmax(fabs(u->curve[1]), u->unit), k, 1);
        u->radius = limit(u->radius, u->p[0][k], 1.0, k, 1);
        u->radius = limit(u->radius, u->q[0][k], slip, k, 0);
    }
    u->reach = u->mixed > 1 ? u->radius : 0.0;
    for (size_t n = u->mixed; n > 1 && n + 1 >= u->mixed; n--) {
        u->reach = limit(u->reach, order_sum(u->p, n), 1.0, n, 1);
        u->reach = limit(u->reach, order_sum(u->q, n), slip, n, 0);
    }
    u->p_last = order_sum(u->p, u->mixed);
    u->q_last = order_sum(u->q, u->mixed);
}

/* Away from boxes of arrest, in units. */
static double room(const struct slider *s, const struct saddle_series *u)
{
    double most = TOL_NEARBY;

    for (size_t i = 0; i < s->plane.equilibria; i++) {
        const struct vec2 e = phase_plane_offset(&s->plane, i);
        const double way = fmax(fabs(e.x), fabs(e.y)) - TOL_ARREST;
        if ((int) i != slider_saddle(s))
            most = fmin(most, TOL_SHARE * way);
    }
    return most / u->unit;
}

/* ---- all of it ----------------------------------------------------------- */

/* The eigenvalues are what is left of the terms of their product; those of y'
 * too, where y settles first. */
static void find_rounding(const struct equilibrium *e, struct saddle_series *u)
{
    const struct mat2 m = e->matrix;
    const double terms = fabs(m.xx * m.yy) + fabs(m.xy * m.yx);
    const double aside = fabs(u->p[1][0]);
    const double ahead = fabs(1.0 - u->curve[1] / u->unit * u->p[1][0]);
    const double part = aside > ahead ? u->fast / u->lambda : 1.0;

    u->lambda_error = TOL_ROUNDINGS * DBL_EPSILON *
                      (1.0 + terms / fabs(e->scaled[0] * e->scaled[1]));
    u->rounding = TOL_ROUNDINGS * DBL_EPSILON * part;
}

/* How many orders are apart from any resonance. */
static size_t mixed_order(const struct saddle_series *u)
{
    const double orders = 1.0 + TOL_SADDLE_APART * u->fast / u->lambda;

    return orders < (double) u->order ? (size_t) orders : u->order;
}

enum status saddle_series_find(const struct slider *s,
                               struct saddle_series *out)
{
    const struct equilibrium *e = phase_plane_saddle(&s->plane);
    const struct carry none = { .count = 0 };
    struct local_series local;
    struct field_series f;
    struct drift d;
    const enum status status =
        local_over(&s->plane.system, e, MANIFOLD_UNSTABLE, 1, &none,
                   SADDLE_ORDER, TOL_ROUNDED, &local);

    if (status != STATUS_OK)
        return status;
    *out = (struct saddle_series){ .unit = local.unit,
                                   .lambda = e->lambda[1],
                                   .fast = -e->lambda[0],
                                   .v = s->block.at.v0,
                                   .order = SADDLE_ORDER };
    for (size_t k = 0; k <= out->order; k++)
        out->curve[k] = local.c[k];
    out->mixed = mixed_order(out);
    find_field(s, out, &f);
    d.plus = e->scaled[1] * exp(e->log_scale - f.log_scale);
    d.minus = e->scaled[0] * exp(e->log_scale - f.log_scale);
    find_drift(out, &f, &d);
    solve(&d, f.of[OF_SLIP], out);
    find_reach(out, fmin(local.radius, room(s, out)));
    find_rounding(e, out);
    return out->radius > 0.0 ? STATUS_OK : STATUS_NO_CONVERGENCE;
}

/* ---- points -------------------------------------------------------------- */

/* Value and derivatives by y and w, in units. */
struct jet3 {
    double value, by_y, by_w;
};

static struct jet3 sum_of(const struct saddle_series *u, const saddle_coefs c,
                          double y, double w)
{
    struct jet3 f = { 0.0, 0.0, 0.0 };

    for (size_t b = u->mixed + 1; b-- > 0;) {
        double row = 0.0, slope = 0.0;
        for (size_t a = (b == 0 ? u->order : u->mixed - b) + 1; a-- > 0;) {
            slope = slope * y + row;
            row = row * y + c[b][a];
        }
        f.by_w = f.by_w * w + f.value;
        f.value = f.value * w + row;
        f.by_y = f.by_y * w + slope;
    }
    return f;
}

double saddle_series_x(const struct saddle_series *u, double y, double *slope)
{
    const double s = y / u->unit;

    *slope = jet_slope_at(u->order, u->curve, s) / u->unit;
    return jet_at(u->order, u->curve, s);
}

/* w in units. */
static struct saddle_point point_at(const struct saddle_series *u, double y,
                                    double w)
{
    struct saddle_point to;
    const double s = y / u->unit;
    const struct jet3 p = sum_of(u, u->p, s, w), q = sum_of(u, u->q, s, w);

    to.x = saddle_series_x(u, y, &to.x_slope);
    to.p = u->unit * p.value;
    to.p_x = p.by_w;
    to.p_y = p.by_y - to.x_slope * p.by_w;
    to.q = q.value;
    to.q_x = q.by_w / u->unit;
    to.q_y = q.by_y / u->unit - to.x_slope * to.q_x;
    to.p_error = u->rounding * (fabs(y) + fabs(p.by_w) * fabs(to.x));
    to.q_error = DBL_EPSILON * fabs(to.q);
    return to;
}

struct saddle_point saddle_series_on(const struct saddle_series *u, double y)
{
    return point_at(u, y, 0.0);
}

bool saddle_series_at(const struct saddle_series *u, struct vec2 z,
                      struct saddle_point *out)
{
    const double s = z.y / u->unit;
    double slope;

    if (!(fabs(s) <= u->reach))
        return false;
    const double w = (z.x - saddle_series_x(u, z.y, &slope)) / u->unit;
    if (!(fabs(w) <= u->reach))
        return false;
    *out = point_at(u, z.y, w);
    const double far = fmax(fabs(s), fabs(w));
    const double last = pow(far, (double) u->mixed);
    out->p_error +=
        u->unit * (last * u->p_last + u->rounding * fabs(out->p_x) * fabs(w));
    out->q_error += last * u->q_last;
    return true;
}

/* Newton's method on a nearly straight line. */
double saddle_series_y(const struct saddle_series *u, double p)
{
    double y = p;

    for (int i = 0; i < TOL_ITERATIONS; i++) {
        const double before = y, s = y / u->unit;
        const double at = u->unit * jet_at(u->order, u->p[0], s);
        y -= (at - p) / jet_slope_at(u->order, u->p[0], s);
        if (fabs(y - before) <= TOL_ROUNDINGS_FEW * DBL_EPSILON * fabs(y))
            break;
    }
    return y;
}
