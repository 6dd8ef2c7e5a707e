/* One study a row.  What the tables hold beyond a study's numbers - states at
 * the extrema, points of the upper branch - follows from them here. */
#include "row_numbers.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tolerance.h"

/* ---- the columns --------------------------------------------------------- */

#define COLUMN(name, member, unit, kind, text)                                 \
    {                                                                          \
        name, unit, text, offsetof(struct row_numbers, member), kind, NULL     \
    }
#define NUMBER(name, member, text)                                             \
    COLUMN(name, member, "1", RECORD_QUANTITY, text)
#define ANGLE(name, member, text)                                              \
    COLUMN(name, member, "rad", RECORD_QUANTITY, text)
#define COUNT(name, member, text) COLUMN(name, member, "1", RECORD_COUNT, text)
#define CODE(name, member, words, text)                                        \
    {                                                                          \
        name, "1", text, offsetof(struct row_numbers, member), RECORD_CODE,    \
            words                                                              \
    }

/* clang-format off */
static const struct record_field columns[] = {
    NUMBER("eps2", eps2, "V_star^2/(g L)"),
    NUMBER("tan_alpha", tan_alpha, "tangent of the slope angle"),
    CODE("type", type, equilibrium_type_names, "linear type of the state"),
    NUMBER("v", v, "slip rate of the steady state nearest to this"),
    NUMBER("psi", psi, "its interfacial state"),
    NUMBER("mu", mu, "its friction coefficient"),
    NUMBER("lambda_minus", lambda_minus, "smaller eigenvalue, of it or of the "
           "saddle"),
    NUMBER("lambda_plus", lambda_plus, "larger eigenvalue"),
    NUMBER("trace", trace, "their sum"),
    NUMBER("det", det, "their product"),
    COUNT("has_saddle", has_saddle, "1 if there is a saddle, 0 if not"),
    NUMBER("v_sp", v_sp, "slip rate at the saddle"),
    NUMBER("psi_sp", psi_sp, "interfacial state at the saddle"),
    CODE("upper_end", critical.upper_end, end_names,
         "how the upper branch ends"),
    NUMBER("v_plus", critical.v_plus, "limit of v as psi -> infinity"),
    NUMBER("ln_v_plus", critical.ln_v_plus, "its natural logarithm"),
    NUMBER("x_excess", critical.x_excess,
           "integral of (v - v_sp) dt, upper branch"),
    NUMBER("mu_s_num", critical.mu_s_num, "static friction (41), exact slip"),
    NUMBER("mu_s_mean", critical.mu_s_mean, "mean friction, upper branch"),
    NUMBER("G_num", critical.fracture_energy, "fracture energy"),
    NUMBER("knee_up_v", critical.knee_upper.v, "slip rate at the upper knee"),
    NUMBER("knee_up_psi", critical.knee_upper.psi, "state at the upper knee"),
    COUNT("n_knee_up", knees_upper, "crossings of slope 1, upper branch"),
    CODE("lower_end", critical.lower_end, end_names,
         "how the lower branch ends"),
    NUMBER("v_minus", critical.v_minus, "limit of v as psi -> 0"),
    NUMBER("ln_v_minus", critical.ln_v_minus, "its natural logarithm"),
    NUMBER("psi_at_v0", critical.psi_at_v0,
           "state where the lower branch meets v = 0"),
    NUMBER("x_deficit_lower", critical.x_deficit,
           "integral of |v - v_sp| dt, lower branch"),
    NUMBER("knee_lo_v", critical.knee_lower.v, "slip rate at the lower knee"),
    NUMBER("knee_lo_psi", critical.knee_lower.psi, "state at the lower knee"),
    COUNT("n_knee_lo", knees_lower, "crossings of slope 1, lower branch"),
    NUMBER("dlnvplus_dalpha", dlnvplus_dalpha, "d ln v_plus/d alpha"),
    NUMBER("dlnlower_dalpha", dlnlower_dalpha,
           "the same of v_minus or psi_at_v0"),
    NUMBER("v_mark1", v_mark[0], "v of the upper branch at psi_mark1"),
    NUMBER("v_mark2", v_mark[1], "v of the upper branch at psi_mark2"),
    NUMBER("v_mark3", v_mark[2], "v of the upper branch at psi_mark3"),
    NUMBER("v_M", maximum.v, "slip rate at the maximum of mu_ss"),
    NUMBER("psi_M", maximum.psi, "state at the maximum of mu_ss"),
    NUMBER("mu_M", maximum.mu, "maximum of mu_ss: static friction (15)"),
    ANGLE("alpha_cM", maximum.alpha, "slope angle of this fold, (16)"),
    NUMBER("v_m", minimum.v, "slip rate at the minimum of mu_ss"),
    NUMBER("psi_m", minimum.psi, "state at the minimum of mu_ss"),
    NUMBER("mu_m", minimum.mu, "minimum of mu_ss"),
    ANGLE("alpha_cm", minimum.alpha, "slope angle of this fold, (16)"),
    NUMBER("vM_eq11", folds.v_M_eq11, "estimate of v_M, (11)"),
    NUMBER("vm_eq12", folds.v_m_eq12, "estimate of v_m, (12)"),
    NUMBER("c_star", folds.c_cusp, "c at which both folds meet"),
    NUMBER("v_cusp", cusp.v, "slip rate at the cusp"),
    NUMBER("psi_cusp", cusp.psi, "state at the cusp"),
    NUMBER("mu_cusp", cusp.mu, "mu_ss at the cusp"),
    ANGLE("alpha_cusp", cusp.alpha, "slope angle of the cusp"),
};
/* clang-format on */

const struct record_type record_row = {
    "row", "what a row of a table states of its slope", columns,
    sizeof columns / sizeof *columns, sizeof(struct row_numbers)
};

/* JSON's name, the tables' name. */
static const char *const other_name[][2] = {
    { "x_deficit", "x_deficit_lower" },
    { "fracture_energy", "G_num" },
    { "mu_s", "mu_M" },
    { "v_M_eq11", "vM_eq11" },
    { "v_m_eq12", "vm_eq12" },
    { "c_cusp", "c_star" },
};

const struct record_field *row_column(const char *name)
{
    for (size_t i = 0; i < sizeof other_name / sizeof *other_name; i++)
        if (strcmp(name, other_name[i][0]) == 0)
            return row_column(other_name[i][1]);
    for (size_t i = 0; i < record_row.count; i++)
        if (strcmp(name, columns[i].name) == 0)
            return &columns[i];
    return NULL;
}

#define BIT(p) (1u << PRODUCT_##p)

unsigned row_column_products(const struct record_field *column)
{
    if (column->offset >= offsetof(struct row_numbers, dlnvplus_dalpha))
        return BIT(KNEES);
    if (column->offset >= offsetof(struct row_numbers, folds))
        return BIT(FOLDS);
    if (column->offset >= offsetof(struct row_numbers, critical))
        return BIT(KNEES);
    return column->offset >= offsetof(struct row_numbers, tan_alpha)
               ? BIT(EQUILIBRIA)
               : 0;
}

bool row_column_is_derivative(const struct record_field *column)
{
    return column->offset >= offsetof(struct row_numbers, dlnvplus_dalpha);
}

/* ---- steady states ------------------------------------------------------- */

/* The steady state nearest to v in ln v; with none given the saddle. */
static int nearest(const struct study *s, double v)
{
    int best = slider_saddle(&s->slider) >= 0   ? slider_saddle(&s->slider)
               : s->slider.plane.equilibria > 0 ? 0
                                                : -1;
    double least = HUGE_VAL;

    for (size_t i = 0; i < s->slider.plane.equilibria && !isnan(v); i++) {
        const double here = s->slider.steady[i].v.value;
        const double far = fabs(v - here) / (fabs(v) + here);
        if (far < least) {
            least = far;
            best = (int) i;
        }
    }
    return best;
}

static void put_steady(const struct study *s, double v, struct row_numbers *n)
{
    const int i = nearest(s, v);

    n->has_saddle = slider_saddle(&s->slider) >= 0;
    n->v_sp = s->saddle_numbers.v;
    n->psi_sp = s->saddle_numbers.psi;
    if (i < 0)
        return;
    const struct steady_number *e = &s->slider.steady[i];
    const double low = e->lambda_minus.value, high = e->lambda_plus.value;
    const double low_error = e->lambda_minus.error;
    const double high_error = e->lambda_plus.error;
    n->type = e->type;
    n->v = e->v;
    n->psi = e->psi;
    n->mu = e->mu;
    n->lambda_minus = e->lambda_minus;
    n->lambda_plus = e->lambda_plus;
    n->trace = quantity_of(low + high, low_error + high_error +
                                           DBL_EPSILON * fabs(low + high));
    n->det = quantity_of(low * high, fabs(low) * high_error +
                                         fabs(high) * low_error +
                                         DBL_EPSILON * fabs(low * high));
}

/* ---- extrema ------------------------------------------------------------- */

/* v and alpha are known; psi and mu follow. */
static struct extremum_number extremum(const struct law *law,
                                       const struct material *m,
                                       struct quantity v, struct quantity alpha)
{
    struct extremum_number e = { v, v, alpha, alpha };

    if (quantity_exists(&v)) {
        const double relative = v.error / v.value;
        const double psi = (double) steady_psi(law, m, logl(v.value));
        const double size = law_psi_is_log(law) ? 1.0 : fabs(psi);
        e.psi = quantity_of(psi, relative * size + DBL_EPSILON * fabs(psi));
    }
    if (quantity_exists(&alpha)) {
        const double mu = tan(alpha.value);
        e.mu = quantity_of(mu, alpha.error * (1.0 + mu * mu) +
                                   2.0 * DBL_EPSILON * fabs(mu));
    }
    return e;
}

static void put_folds(const struct law *law, const struct material *m,
                      struct row_numbers *n)
{
    const struct fold_numbers f = numbers_folds(law, m);
    const double sum = m->a + m->b, rise = m->b - m->a;
    const double v = sum / (rise * m->R);
    struct material cusp = *m;
    struct quantity v_cusp = f.c_cusp;

    if (quantity_exists(&f.c_cusp)) {
        cusp.c = f.c_cusp.value;
        v_cusp = quantity_of(v, 4.0 * DBL_EPSILON * v);
    }
    n->folds = f;
    n->maximum = extremum(law, m, f.v_M, f.alpha_cM);
    n->minimum = extremum(law, m, f.v_m, f.alpha_cm);
    n->cusp = extremum(law, &cusp, v_cusp, f.alpha_cusp);
}

/* ---- points of the upper branch ------------------------------------------ */

/* Theta at which the piece's y is `y`, which it passes once. */
static double cross(const struct curve *c, size_t piece, double y)
{
    double lo = 0.0, hi = 1.0, at[CURVE_DIM_MAX];

    curve_at(c, piece, 0.0, at);
    const bool up = at[1] < y;
    while (0.5 * (lo + hi) > lo && 0.5 * (lo + hi) < hi) {
        const double theta = 0.5 * (lo + hi);
        curve_at(c, piece, theta, at);
        *((at[1] < y) == up ? &lo : &hi) = theta;
    }
    return hi;
}

/* The point, all components, at which the curve passes y; false, with its last
 * point, where it does not. */
static bool pass(const struct curve *c, double y, double at[CURVE_DIM_MAX],
                 double *error)
{
    curve_at(c, 0, 0.0, at);
    for (size_t i = 0; i < c->count; i++) {
        const double before = at[1] - y;
        curve_at(c, i, 1.0, at);
        *error = c->piece[i].error;
        if (before * (at[1] - y) <= 0.0) {
            curve_at(c, i, cross(c, i, y), at);
            return true;
        }
    }
    return false;
}

static double chart_psi(const struct planar *sys, double psi)
{
    return sys->axis[1].is_log ? log(psi) : psi;
}

/* The upper branch again, not closed before it has passed every mark. */
static enum status grow_to_marks(const struct study *s,
                                 const struct slope_row *row,
                                 struct branch *upper)
{
    struct planar sys = s->slider.plane.system;
    struct grow_options o = grow_defaults(s->scene->rtol);
    struct box reach = { sys.origin, sys.origin };
    struct local_series u;

    for (int i = 0; i < SLOPE_MARKS; i++)
        if (!isnan(row->psi_mark[i]))
            reach.hi.y = fmax(reach.hi.y, chart_psi(&sys, row->psi_mark[i]));
    reach.hi.x = sys.domain.hi.x;
    sys.domain.hi.y = fmax(sys.domain.hi.y, reach.hi.y + 1.0);
    o.reach = &reach;
    enum status status =
        local_at(&sys, phase_plane_saddle(&s->slider.plane), MANIFOLD_STABLE,
                 &o.carry, o.order, TOL_TAYLOR_STEP * o.rtol, &u);
    if (status == STATUS_OK)
        status = grow_branch(&sys, &u, u.ind == 0 || u.c[1] > 0.0 ? 1 : -1, &o,
                             upper);
    return status;
}

/* v of the upper branch where it passes psi. */
static struct quantity mark(const struct study *s, const struct branch *upper,
                            double psi)
{
    const double y =
        chart_psi(&s->slider.plane.system, psi) - s->slider.block.at.y0;
    double at[CURVE_DIM_MAX], error = 0.0;

    if (!pass(&upper->curve, y, at, &error))
        return quantity_none("the upper branch does not pass this psi");
    const double v = s->slider.block.at.v0 * exp(at[0]);
    const double logs = 16.0 + fabs(s->slider.block.at.x0) + fabs(at[0]);
    return quantity_of(v, v * (error + DBL_EPSILON * logs) +
                              s->saddle_numbers.v.error * exp(at[0]));
}

static enum status put_marks(const struct study *s, const struct slope_row *row,
                             struct row_numbers *n)
{
    struct branch upper = { .curve = CURVE_EMPTY(2) };
    bool any = false;

    for (int i = 0; i < SLOPE_MARKS; i++)
        any = any || !isnan(row->psi_mark[i]);
    if (!any || slider_saddle(&s->slider) < 0)
        return STATUS_OK;
    const enum status status = grow_to_marks(s, row, &upper);
    for (int i = 0; i < SLOPE_MARKS && status == STATUS_OK; i++)
        if (!isnan(row->psi_mark[i]))
            n->v_mark[i] = mark(s, &upper, row->psi_mark[i]);
    branch_free(&upper);
    return status;
}

/* ---- all ----------------------------------------------------------------- */

static void put_critical(const struct study *s, struct row_numbers *n)
{
    n->critical = s->slider.critical;
    n->knees_upper = (int64_t) s->slider.critical.crossings_upper;
    n->knees_lower = (int64_t) s->slider.critical.crossings_lower;
}

/* Every quantity missing for this reason. */
static struct row_numbers nothing(const char *reason)
{
    const struct quantity none = quantity_none(reason);
    struct row_numbers n = { .type = -1, .critical = numbers_no_critical() };

    for (size_t i = 0; i < record_row.count; i++)
        if (columns[i].kind == RECORD_QUANTITY)
            memcpy((char *) &n + columns[i].offset, &none, sizeof none);
    return n;
}

static void put_inputs(const struct slope_row *s, struct row_numbers *n)
{
    const double eps2 = material_eps2(&s->material);

    n->eps2 = quantity_of(eps2, 4.0 * DBL_EPSILON * eps2);
    if (isnan(s->alpha))
        return;
    const double t = (double) tanl((long double) s->alpha);
    n->tan_alpha = quantity_of(t, DBL_EPSILON * t);
}

enum status row_numbers_find(const struct slope_row *s, size_t law, double rtol,
                             unsigned products, struct row_numbers *n,
                             struct fault *why)
{
    const unsigned studied = products & (BIT(EQUILIBRIA) | BIT(KNEES));
    const struct scene scene = slope_row_scene(s, law, rtol, studied);
    struct study study;

    *n = nothing(studied ? "there is no such state at this slope"
                         : "nothing was asked of this slope");
    put_inputs(s, n);
    if (products & BIT(FOLDS))
        put_folds(&s->law[law], &s->material, n);
    if (studied == 0)
        return STATUS_OK;
    enum status status = study_run(&study, &scene, NULL, why);
    if (status != STATUS_OK)
        return status;
    put_steady(&study, s->v, n);
    if (studied & BIT(KNEES)) {
        put_critical(&study, n);
        status = put_marks(&study, s, n);
    }
    study_free(&study);
    if (status != STATUS_OK)
        snprintf(why->text, sizeof why->text, "the upper branch: %s",
                 status_text(status));
    return status;
}
