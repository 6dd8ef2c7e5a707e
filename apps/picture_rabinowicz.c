#include "picture_rabinowicz.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdio.h>

#include "draw.h"
#include "panel.h"
#include "picture_transient.h"

const char *const picture_rabinowicz_panel[PICTURE_RABINOWICZ_PANELS] = {
    "", "_friction"
};

/* Points of a curve; mm and um in a metre; the roots' rim on the axis. */
enum { POINTS = 400 };
static const double mm = 1e3, um = 1e6, rim = 0.04;

/* ---- the fit of (33) ----------------------------------------------------- */

/* l_k tan(alpha) in mm at t = tan(alpha). */
static double parabola_at(const struct parabola *p, double t)
{
    return mm * p->factor.value * (p->mu_s.value - t) * (p->mu_half.value - t);
}

/* Half the width of the curve's 95 % band there, to first order. */
static double band_at(const struct parabola *p, double t)
{
    const double a = p->mu_s.value - t, b = p->mu_half.value - t;
    const double f = p->factor.value;
    const double by_s = f * b, by_half = f * a, by_factor = a * b;
    const double variance = pow(by_s * p->mu_s_deviation, 2) +
                            pow(by_half * p->mu_half_deviation, 2) +
                            pow(by_factor * p->factor_deviation, 2) +
                            2.0 * (by_s * by_half * p->mu_s_mu_half +
                                   by_s * by_factor * p->mu_s_factor +
                                   by_half * by_factor * p->mu_half_factor);
    const double quantile =
        isnan(p->scatter) ? gsl_cdf_ugaussian_Pinv(0.975)
                          : gsl_cdf_tdist_Pinv(0.975, (double) p->freedom);

    return mm * quantile * sqrt(fmax(variance, 0.0));
}

static bool has_roots(const struct parabola *p)
{
    return quantity_exists(&p->mu_s) && quantity_exists(&p->mu_half) &&
           quantity_exists(&p->factor);
}

/* ---- (a) tan(alpha) over l_k tan(alpha) ---------------------------------- */

static enum status add_bar(struct figure *f, struct figure_style style,
                           double x0, double x1, double y0, double y1,
                           const char *entry)
{
    return figure_add_curve(f, &(struct figure_curve){
                                   .style = style,
                                   .entry = entry,
                                   .x = (double[]){ x0, x1 },
                                   .y = (double[]){ y0, y1 },
                                   .count = 2,
                               });
}

static enum status add_points(struct figure *f, const double x[],
                              const double y[], size_t count,
                              enum figure_role role, enum figure_mark mark,
                              const char *entry)
{
    return figure_add_points(f,
                             &(struct figure_points){ .style = { .role = role },
                                                      .entry = entry,
                                                      .x = x,
                                                      .y = y,
                                                      .count = count,
                                                      .mark = mark,
                                                      .size = 8 });
}

static enum status add_data(struct figure *f, const struct series *s)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < s->count && !status; i++) {
        const double t = s->tan_alpha[i], x = mm * s->value[i] * t;
        const double reach = s->error ? 1.96 * mm * s->error[i] * t : 0.0;
        if (s->error)
            status =
                add_bar(f, (struct figure_style){ FIGURE_TRAJECTORY, 0, 0 },
                        x - reach, x + reach, t, t, NULL);
        if (!status)
            status = add_points(f, &x, &t, 1, FIGURE_EQUILIBRIUM, FIGURE_DISC,
                                s->error ? "data, 95 % bars" : "data");
    }
    return status;
}

/* Release distances of the scene's law, from its stable manifold. */
static enum status add_exact(struct figure *f, const struct release *r)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < r->rows && !status; i++) {
        const double t = r->row[i].tan_alpha, x = mm * r->row[i].l_k.value * t;
        if (quantity_exists(&r->row[i].l_k))
            status = add_points(f, &x, &t, 1, FIGURE_STABLE, FIGURE_CROSS,
                                "the scene's law, exact");
    }
    return status;
}

static enum status add_fit(struct figure *f, const struct parabola *p,
                           double from, double to)
{
    double x[2 * POINTS], y[2 * POINTS], middle[POINTS];

    for (int i = 0; i < POINTS; i++) {
        const double t = from + (to - from) * i / (POINTS - 1);
        const double reach = band_at(p, t);
        y[i] = y[2 * POINTS - 1 - i] = t;
        middle[i] = parabola_at(p, t);
        x[i] = middle[i] - reach;
        x[2 * POINTS - 1 - i] = middle[i] + reach;
    }
    const enum status status = figure_add_region(
        f, &(struct figure_region){ FIGURE_SHADE_1, "95 % band of the fit", x,
                                    y, 2 * POINTS });
    return status ? status
                  : figure_add_curve(f, &(struct figure_curve){
                                            .style = { .role = FIGURE_SERIES_2,
                                                       .dash = FIGURE_SOLID },
                                            .entry = "parabola (33), fitted",
                                            .x = middle,
                                            .y = y,
                                            .count = POINTS });
}

/* A root on the axis with its interval. */
static enum status add_root(struct figure *f, const struct quantity *root,
                            double low, double high, enum figure_role role,
                            const char *name)
{
    const double zero = 0.0;
    char entry[64];

    snprintf(entry, sizeof entry, "%s = %.4g", name, root->value);
    const enum status status =
        add_bar(f, (struct figure_style){ role, FIGURE_SOLID, 4 }, 0.0, 0.0,
                fmax(low, f->y.lo), fmin(high, f->y.hi), NULL);
    return status ? status
                  : add_points(f, &zero, &root->value, 1, role, FIGURE_SQUARE,
                               entry);
}

static enum status add_roots(struct figure *f, const struct parabola *p)
{
    const enum status status =
        add_root(f, &p->mu_s, p->mu_s_low, p->mu_s_high, FIGURE_HIGHLIGHT,
                 "static friction μ_s");

    return status ? status
                  : add_root(f, &p->mu_half, p->mu_half_low, p->mu_half_high,
                             FIGURE_SERIES_3, "smaller root, μ_ss(V*/2)");
}

/* The ranges of the data and, where there are any, of the roots. */
static void measure(const struct release *r, struct figure_axis *x,
                    struct figure_axis *y)
{
    const struct series *s = &r->observed.l_k;

    *x = (struct figure_axis){ "l_k tan α (mm)", 0.0, 0.0, false };
    *y = (struct figure_axis){ "tan α", s->tan_alpha[0], s->tan_alpha[0],
                               false };
    for (size_t i = 0; i < s->count; i++) {
        x->hi = fmax(x->hi, mm * s->value[i] * s->tan_alpha[i]);
        y->lo = fmin(y->lo, s->tan_alpha[i]);
        y->hi = fmax(y->hi, s->tan_alpha[i]);
    }
    if (has_roots(&r->parabola)) {
        y->hi = fmax(y->hi, r->parabola.mu_s.value);
        x->lo = parabola_at(&r->parabola, r->parabola.mu_middle.value);
    }
    x->lo -= rim * (x->hi - x->lo);
    x->hi += rim * (x->hi - x->lo);
    const double height = y->hi - y->lo;
    y->lo -= rim * height;
    y->hi += 2.0 * rim * height;
}

static enum status build_release(struct figure *f, const struct release *r,
                                 const char *title)
{
    struct figure_axis x, y;

    measure(r, &x, &y);
    enum status status = figure_init(f, title, &x, &y);
    if (!status && has_roots(&r->parabola))
        status = add_fit(f, &r->parabola, y.lo, y.hi);
    if (!status)
        status = add_bar(
            f, (struct figure_style){ FIGURE_TRAJECTORY, FIGURE_DOTTED, 0 },
            0.0, 0.0, y.lo, y.hi, NULL);
    if (!status && has_roots(&r->parabola))
        status = add_roots(f, &r->parabola);
    if (!status)
        status = add_exact(f, r);
    return status ? status : add_data(f, &r->observed.l_k);
}

/* ---- (b) friction over slip ---------------------------------------------- */

/* s_k of (25) on the fitted parabola: a straight line. */
static enum status add_line_33(struct figure *f, const struct parabola *p,
                               double K, double from, double to)
{
    const double sum = p->mu_s.value + p->mu_half.value;
    const double scale = um * K * p->factor.value;

    return add_bar(f, (struct figure_style){ FIGURE_SERIES_2, 0, 0 },
                   scale * (sum - 2.0 * from), scale * (sum - 2.0 * to), from,
                   to, "of the parabola (33)");
}

/* s_k of (25) on the smoothing spline; of s_k/K where K is unknown. */
static enum status add_slip(struct figure *f, const struct slip_curve *c,
                            double K)
{
    double x[2 * POINTS], y[2 * POINTS], middle[POINTS];
    const size_t n = c->count < POINTS ? c->count : POINTS;

    for (size_t i = 0; i < n; i++) {
        const double reach = um * K * c->at[i].gradient_error;
        middle[i] = um * K * c->at[i].gradient;
        y[i] = y[2 * n - 1 - i] = c->at[i].mu;
        x[i] = middle[i] - reach;
        x[2 * n - 1 - i] = middle[i] + reach;
    }
    const enum status status = figure_add_region(
        f, &(struct figure_region){ FIGURE_SHADE_1, "95 % band", x, y, 2 * n });
    return status ? status
                  : figure_add_curve(
                        f, &(struct figure_curve){
                               .style = { .role = FIGURE_SERIES_1 },
                               .entry = "of the smoothing spline (25)",
                               .x = middle,
                               .y = y,
                               .count = n });
}

static enum status build_friction(struct figure *f, const struct release *r,
                                  const char *title)
{
    const struct slip_curve *c = &r->slip;
    const bool has_K = quantity_exists(&r->K);
    const double K = has_K ? r->K.value : 1.0;
    const double from = c->at[0].mu, to = c->at[c->count - 1].mu;
    double far = 0.0;

    for (size_t i = 0; i < c->count; i++)
        far = fmax(far, um * K * (c->at[i].gradient + c->at[i].gradient_error));
    const struct figure_axis x = { has_K ? "slip s_k (μm)"
                                         : "slip over K, s_k/K (μm)",
                                   0.0, (1.0 + rim) * far, false };
    const struct figure_axis y = { "friction coefficient μ = tan α",
                                   from - rim * (to - from),
                                   to + rim * (to - from), false };
    enum status status = figure_init(f, title, &x, &y);
    if (!status)
        status = add_slip(f, c, K);
    return status || !has_roots(&r->parabola)
               ? status
               : add_line_33(f, &r->parabola, K, from, to);
}

/* ---- both ---------------------------------------------------------------- */

static enum status check(const struct release *r, struct fault *why)
{
    const char *reason = r->observed.l_k.count == 0
                             ? "no l_k was measured, nothing to draw"
                             : r->slip.reason;

    if (reason == NULL)
        return STATUS_OK;
    snprintf(why->text, sizeof why->text, "rabinowicz: %s", reason);
    return STATUS_BAD_ARGUMENT;
}

enum status picture_rabinowicz(const struct release *r,
                               const struct scene *scene, const char *path,
                               bool keep_script, struct fault *why)
{
    static enum status (*const build[])(struct figure *, const struct release *,
                                        const char *) = { build_release,
                                                          build_friction };
    const char *title =
        scene->title[0] ? scene->title : "Rabinowicz's experiment";
    char name[PANEL_PATH];
    enum status status = check(r, why);

    for (int i = 0; i < PICTURE_RABINOWICZ_PANELS && !status; i++) {
        struct figure f = FIGURE_EMPTY;
        if (!panel_path(path, picture_rabinowicz_panel[i], name))
            return STATUS_BAD_ARGUMENT;
        status = build[i](&f, r, title);
        if (!status)
            status = figure_write(&f, name, keep_script, why);
        figure_free(&f);
    }
    return status;
}
