/* slipway rabinowicz: critical release distances of a law, and what measured
 * ones say of it. */
#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdio.h>

#include "output.h"
#include "progress.h"
#include "release.h"
#include "sheet.h"
#include "symbols.h"

/* ---- picture ------------------------------------------------------------- */

/* Two files: NAME.svg shows tan(alpha) over l_k tan(alpha) with error bars, the
 * parabola (33), its 95 % band and roots; NAME_friction.svg the friction
 * coefficient over s_k, (25).  The names after these, as of
 * panel_path: */
static const char *const picture_rabinowicz_panel[] = { "", "_friction", NULL };

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

static void add_data(struct figure *f, const struct series *s)
{
    for (size_t i = 0; i < s->count; i++) {
        const double t = s->tan_alpha[i], x = mm * s->value[i] * t;
        const double reach = s->error ? 1.96 * mm * s->error[i] * t : 0.0;
        if (s->error)
            sheet_segment(f, (struct figure_style){ FIGURE_TRAJECTORY, 0, 0 },
                          NULL, (struct vec2){ x - reach, t },
                          (struct vec2){ x + reach, t });
        figure_add_point(f, x, t, FIGURE_EQUILIBRIUM, FIGURE_DISC, 8.0,
                         s->error ? "data, 95 % bars" : "data");
    }
}

/* Release distances of the scene's law, from its stable manifold. */
static void add_exact(struct figure *f, const struct release *r)
{
    for (size_t i = 0; i < r->rows; i++) {
        const double t = r->row[i].tan_alpha, x = mm * r->row[i].l_k.value * t;
        if (quantity_exists(&r->row[i].l_k))
            figure_add_point(f, x, t, FIGURE_STABLE, FIGURE_CROSS, 8.0,
                             "the scene's law, exact");
    }
}

/* A curve of n points in the middle of its band. */
struct banded {
    double x[2 * POINTS], y[2 * POINTS], middle[POINTS];
    size_t n;
};

static void band_put(struct banded *b, size_t i, double middle, double reach,
                     double y)
{
    const size_t back = 2 * b->n - 1 - i;

    b->middle[i] = middle;
    b->x[i] = middle - reach;
    b->x[back] = middle + reach;
    b->y[i] = b->y[back] = y;
}

static void band_add(const struct banded *b, struct figure *f, const char *band,
                     struct figure_style style, const char *entry)
{
    struct figure_layer l = { .kind = FIGURE_REGION,
                              .style = { .role = FIGURE_SHADE_1 },
                              .entry = band,
                              .x = b->x,
                              .y = b->y,
                              .count = 2 * b->n };

    figure_add(f, &l);
    l.kind = FIGURE_CURVE;
    l.style = style;
    l.entry = entry;
    l.x = b->middle;
    l.count = b->n;
    figure_add(f, &l);
}

static void add_fit(struct figure *f, const struct parabola *p, double from,
                    double to)
{
    struct banded b = { .n = POINTS };

    for (int i = 0; i < POINTS; i++) {
        const double t = from + (to - from) * i / (POINTS - 1);
        band_put(&b, (size_t) i, parabola_at(p, t), band_at(p, t), t);
    }
    band_add(&b, f, "95 % band of the fit",
             (struct figure_style){ FIGURE_SERIES_2, FIGURE_SOLID, 0 },
             "parabola (33), fitted");
}

/* A root on the axis with its interval. */
static void add_root(struct figure *f, const struct quantity *root, double low,
                     double high, enum figure_role role, enum figure_mark mark,
                     const char *name)
{
    char entry[64];

    snprintf(entry, sizeof entry, "%s = %.4g", name, root->value);
    sheet_segment(f, (struct figure_style){ role, FIGURE_SOLID, 4 }, NULL,
                  (struct vec2){ 0.0, fmax(low, f->y.lo) },
                  (struct vec2){ 0.0, fmin(high, f->y.hi) });
    figure_add_point(f, 0.0, root->value, role, mark, 8.0, entry);
}

static void add_roots(struct figure *f, const struct parabola *p)
{
    add_root(f, &p->mu_s, p->mu_s_low, p->mu_s_high, FIGURE_HIGHLIGHT,
             FIGURE_SQUARE, "static friction " S_MU_S);
    add_root(f, &p->mu_half, p->mu_half_low, p->mu_half_high, FIGURE_SERIES_3,
             FIGURE_DIAMOND, "smaller root, " S_MU_SS "(" S_V_STAR "/2)");
}

/* The ranges of the data and, where there are any, of the roots. */
static void measure(const struct release *r, struct figure_axis *x,
                    struct figure_axis *y)
{
    const struct series *s = &r->observed.l_k;

    *x = (struct figure_axis){ "release distance " S_L_K " " S_TAN " (mm)", 0.0,
                               0.0, false };
    *y = (struct figure_axis){ S_TAN, s->tan_alpha[0], s->tan_alpha[0], false };
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

static void build_release(struct figure *f, const struct release *r,
                          const char *title)
{
    const bool fitted = has_roots(&r->parabola);
    struct figure_axis x, y;

    measure(r, &x, &y);
    figure_init(f, title, &x, &y);
    if (fitted)
        add_fit(f, &r->parabola, y.lo, y.hi);
    sheet_segment(f,
                  (struct figure_style){ FIGURE_TRAJECTORY, FIGURE_DOTTED, 0 },
                  NULL, (struct vec2){ 0.0, y.lo }, (struct vec2){ 0.0, y.hi });
    if (fitted)
        add_roots(f, &r->parabola);
    add_exact(f, r);
    add_data(f, &r->observed.l_k);
}

/* ---- (b) friction over slip ---------------------------------------------- */

/* s_k of (25) on the fitted parabola: a straight line, which lies on the
 * spline's where both fit. */
static void add_line_33(struct figure *f, const struct parabola *p, double K,
                        double from, double to)
{
    const double sum = p->mu_s.value + p->mu_half.value;
    const double scale = um * K * p->factor.value;

    sheet_segment(f, (struct figure_style){ FIGURE_NULLCLINE_X, 0, 1.8 },
                  "of the parabola (33)",
                  (struct vec2){ scale * (sum - 2.0 * from), from },
                  (struct vec2){ scale * (sum - 2.0 * to), to });
}

/* s_k of (25) on the smoothing spline; of s_k/K where K is unknown. */
static void add_slip(struct figure *f, const struct slip_curve *c, double K)
{
    struct banded b = { .n = c->count < POINTS ? c->count : POINTS };

    for (size_t i = 0; i < b.n; i++)
        band_put(&b, i, um * K * c->at[i].gradient,
                 um * K * c->at[i].gradient_error, c->at[i].mu);
    band_add(&b, f, "95 % band",
             (struct figure_style){ FIGURE_SERIES_1, FIGURE_SOLID, 4.5 },
             "of the smoothing spline (25)");
}

static void build_friction(struct figure *f, const struct release *r,
                           const char *title)
{
    const struct slip_curve *c = &r->slip;
    const bool has_K = quantity_exists(&r->K);
    const double K = has_K ? r->K.value : 1.0;
    const double from = c->at[0].mu, to = c->at[c->count - 1].mu;
    double far = 0.0;

    for (size_t i = 0; i < c->count; i++)
        far = fmax(far, um * K * (c->at[i].gradient + c->at[i].gradient_error));
    const struct figure_axis x = {
        has_K ? "slip " S_S_K " (μm)"
              : "slip over " ITALIC("K") ", " S_S_K "/" ITALIC("K") " (μm)",
        0.0, (1.0 + rim) * far, false
    };
    const struct figure_axis y = { "friction coefficient " S_MU " = " S_TAN,
                                   from - rim * (to - from),
                                   to + rim * (to - from), false };
    figure_init(f, title, &x, &y);
    add_slip(f, c, K);
    if (has_roots(&r->parabola))
        add_line_33(f, &r->parabola, K, from, to);
}

/* ---- both ---------------------------------------------------------------- */

static enum status picture_rabinowicz(const struct release *r,
                                      const char *title, struct panels *p,
                                      struct fault *why)
{
    const char *reason = r->observed.l_k.count == 0
                             ? "no l_k was measured, nothing to draw"
                             : r->slip.reason;

    if (reason)
        return fault_set(why, STATUS_BAD_ARGUMENT, "rabinowicz: %s", reason);
    if (title[0] == '\0')
        title = "Rabinowicz's experiment";
    build_release(panels_add(p, picture_rabinowicz_panel[0]), r, title);
    build_friction(panels_add(p, picture_rabinowicz_panel[1]), r, title);
    return STATUS_OK;
}

static enum status check(const struct options *o, const struct scene *c,
                         struct fault *why)
{
    if (c->figure && !c->rabinowicz.data)
        return fault_set(
            why, STATUS_BAD_ARGUMENT,
            "rabinowicz: %.300s: a figure shows data, expected --data",
            c->figure);
    return output_check(o, c, c->figure, picture_rabinowicz_panel, why);
}

static enum status draw(const struct options *o, const struct scene *c,
                        const struct release *r, struct fault *why)
{
    struct panels p = PANELS_EMPTY;
    const enum status s =
        c->figure ? picture_rabinowicz(r, c->title, &p, why) : STATUS_OK;

    return s ? s : output_draw(o, &c->paper, &p, c->figure, why);
}

static enum exit_code run(const struct options *o, const struct scene *c)
{
    struct release r = { .row = NULL };
    struct fault why = { "" };
    const struct results all = { .table = release_tables, .run = &r };

    enum status s = check(o, c, &why);
    if (s == STATUS_OK)
        s = release_run(&r, c, progress_monitor(o), &why);
    progress_end();
    if (s == STATUS_OK)
        s = output_write(o, "rabinowicz", &all, c, NULL,
                         "Rabinowicz's experiment", &why);
    if (s == STATUS_OK)
        s = draw(o, c, &r, &why);
    const enum exit_code code = s == STATUS_OK ? output_print(o, &all, NULL)
                                               : command_fail(s, why.text);
    release_free(&r);
    return code;
}

enum exit_code command_rabinowicz(const struct options *o)
{
    return command_with_scene(o, NULL, run);
}
