#include "release.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "rabinowicz.h"
#include "study.h"
#include "tolerance.h"

/* ---- what the results are called ----------------------------------------- */

const struct record_type record_release = RECORD(
    release_row, "release", "critical release distances",
    FIELD(release_row, REAL, tan_alpha, "1", "tangent of the slope angle"),
    FIELD(release_row, REAL, alpha, "rad", "slope angle"),
    FIELD(release_row, QUANTITY, v_k, "m/s",
          "critical slip rate, V_star v_plus"),
    FIELD(release_row, QUANTITY, l_k, "m", "critical release distance, exact"),
    FIELD(release_row, QUANTITY, l_k_G, "m",
          "release distance of the exact fracture energy, (32)"),
    FIELD(release_row, QUANTITY, l_k_33, "m",
          "release distance of (33) with mu_s"),
    FIELD(release_row, QUANTITY, mu_s, "1",
          "static friction of (41) with the exact v_plus"),
    FIELD(release_row, QUANTITY, s_k, "m",
          "persistence length, exact excess slip"),
    FIELD(release_row, QUANTITY, s_k_30, "m", "persistence length of (30)"));

const struct record_type record_release_material = RECORD(
    release_material, "release_material",
    "the material that the fit of (33) means",
    FIELD(release_material, QUANTITY, L, "m",
          "memory length, factor K (b - a)/eta (95 %)"),
    FIELD(release_material, REAL, L_low, "m",
          "lower end of the 95 % interval of L"),
    FIELD(release_material, REAL, L_high, "m",
          "upper end of the 95 % interval of L"),
    FIELD(release_material, QUANTITY, mu_star, "1",
          "friction at V_star, mu_half - (b - a) ln 2 (95 %)"),
    FIELD(release_material, REAL, mu_star_low, "1",
          "lower end of the 95 % interval"),
    FIELD(release_material, REAL, mu_star_high, "1",
          "upper end of the 95 % interval"),
    FIELD(release_material, REAL, L_deviation, "m", "standard deviation of L"),
    FIELD(release_material, REAL, mu_star_deviation, "1",
          "standard deviation of mu_star"));

/* ---- forward ------------------------------------------------------------- */

static struct quantity find_K(const struct scene_rabinowicz *r)
{
    if (!(r->block_mass > 0.0) || !(r->ball_mass > 0.0))
        return quantity_none("no masses: rabinowicz.block_mass and "
                             "rabinowicz.ball_mass are not given");
    if (r->restitution < 0.0)
        return quantity_none("no coefficient of restitution: "
                             "rabinowicz.restitution is not given");
    const double K = rabinowicz_K(r->block_mass, r->ball_mass, r->restitution);
    return quantity_of(K, TOL_ROUNDINGS_FEW * DBL_EPSILON * K);
}

/* Of q by a monotone formula: the value and the part that an error of q, as a
 * part of it, makes of it. */
static struct quantity derived(const struct quantity *q, double value,
                               double part)
{
    if (!quantity_exists(q))
        return *q;
    return quantity_of(
        value, fabs(value) * (fabs(part) + TOL_ROUNDINGS_FEW * DBL_EPSILON));
}

static struct quantity scaled(const struct quantity *q, double factor)
{
    return derived(q, factor * q->value, q->error / q->value);
}

static struct quantity release_33(const struct scene *s, double K, double t,
                                  const struct quantity *mu_s)
{
    const double half = rabinowicz_mu_half(&s->material);
    const double factor = rabinowicz_factor(&s->law, &s->material, K);

    if (!quantity_exists(mu_s))
        return *mu_s;
    if (!(t < half))
        return quantity_none("(31) and (33) hold for slopes below "
                             "mu_ss(V_star/2) only");
    return derived(mu_s, rabinowicz_release_33(factor, mu_s->value, half, t),
                   mu_s->error / (mu_s->value - t));
}

static struct release_row row_of(const struct study *s,
                                 const struct quantity *K)
{
    const struct critical_numbers *c = &s->slider.critical;
    const struct material *m = &s->scene->material;
    const double t = (double) s->scene->tan_alpha, k = K->value;
    const double eps2 = material_eps2(m), v = c->v_plus.value;
    struct release_row row = {
        .tan_alpha = t,
        .alpha = s->scene->alpha,
        .v_k = scaled(&c->v_plus, m->V_star),
        .l_k = *K,
        .l_k_G = *K,
        .l_k_33 = *K,
        .mu_s = s->estimates.mu_s_exact_v_plus,
        .s_k = scaled(&c->x_excess, m->L),
        .s_k_30 = scaled(&s->estimates.x_k, m->L),
    };

    if (!quantity_exists(K))
        return row;
    row.l_k = derived(&c->v_plus, m->L * rabinowicz_release(eps2, v, k, t),
                      2.0 * c->v_plus.error / v);
    row.l_k_G = scaled(&c->fracture_energy,
                       m->L * rabinowicz_release_of_energy(1, k, t));
    row.l_k_33 = release_33(s->scene, k, t, &row.mu_s);
    return row;
}

struct release_row release_at(const struct study *s)
{
    const struct quantity K = find_K(&s->scene->rabinowicz);

    return row_of(s, &K);
}

static enum status find_row(const struct scene *scene, double tan_alpha,
                            const struct quantity *K,
                            const struct monitor *monitor,
                            struct release_row *row, struct fault *why)
{
    struct scene at = *scene;
    struct study study;

    if (tan_alpha > 0.0) {
        at.tan_alpha = (long double) tan_alpha;
        at.alpha = atan(tan_alpha);
    }
    at.products = 1u << PRODUCT_KNEES | 1u << PRODUCT_ESTIMATES;
    const enum status s = study_run(&study, &at, monitor, why);
    if (s != STATUS_OK)
        return s;
    *row = row_of(&study, K);
    study_free(&study);
    return STATUS_OK;
}

/* Without a list, of the scene's own slope. */
static enum status find_rows(struct release *r, const struct scene *scene,
                             const struct monitor *monitor, struct fault *why)
{
    const struct scene_rabinowicz *list = &scene->rabinowicz;
    const size_t count = list->slopes ? list->slopes : 1;
    enum status s = STATUS_OK;

    r->row = calloc(count, sizeof *r->row);
    if (r->row == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < count && s == STATUS_OK; i++) {
        if (monitor_tell(monitor, "slopes", i, count))
            return STATUS_STOPPED;
        s = find_row(scene, list->slopes ? list->tan_alpha[i] : 0.0, &r->K,
                     NULL, &r->row[i], why);
        r->rows = i + 1;
    }
    return s;
}

/* ---- inverse ------------------------------------------------------------- */

static enum status read_data(struct release *r, const char *path,
                             struct fault *why)
{
    struct table t;
    enum status s = table_read(&t, path, why);

    if (s != STATUS_OK)
        return s;
    s = observations_read(&r->observed, &t, why);
    table_free(&t);
    return s;
}

static struct release_material no_material(const char *reason)
{
    struct release_material p;

    record_absent(&record_release_material, &p, reason);
    return p;
}

static struct release_material find_material(const struct release *r,
                                             const struct scene *scene)
{
    const struct parabola *p = &r->parabola;
    const struct material *m = &scene->material;
    const double unit = rabinowicz_factor(&scene->law, m, r->K.value) / m->L;
    const double shift = rabinowicz_mu_half(m) - m->mu_star;

    if (!(m->b > m->a))
        return no_material("(33) needs b > a: friction that weakens with slip "
                           "rate");
    struct release_material out = {
        .L = p->factor,
        .mu_star = p->mu_half,
        .L_low = p->factor_low / unit,
        .L_high = p->factor_high / unit,
        .mu_star_low = p->mu_half_low - shift,
        .mu_star_high = p->mu_half_high - shift,
        .L_deviation = p->factor_deviation / unit,
        .mu_star_deviation = p->mu_half_deviation,
    };
    out.L.value /= unit;
    out.L.error /= unit;
    out.mu_star.value -= shift;
    if (quantity_exists(&out.L) && !quantity_exists(&r->K))
        out.L = r->K;
    return out;
}

static enum status fit_releases(struct release *r, const struct scene *scene)
{
    const struct measured m = series_measured(&r->observed.l_k);
    const double K = quantity_exists(&r->K) ? r->K.value : 0.0;
    enum status s = parabola_fit(&m, &r->parabola);

    if (s == STATUS_OK)
        s = slip_curve_fit(&m, K, scene->rabinowicz.smoothing, &r->slip);
    if (s == STATUS_OK)
        r->material = find_material(r, scene);
    return s;
}

static enum status fit_persistence(struct release *r, const struct scene *scene)
{
    const struct measured m = series_measured(&r->observed.x_k);
    const struct material *p = &scene->material;

    return persistence_fit(&m, law_eta(&scene->law, p), p->b - p->a,
                           &r->persistence);
}

static enum status fit_all(struct release *r, const struct scene *scene)
{
    enum status s = STATUS_OK;

    if (r->observed.l_k.count > 0)
        s = fit_releases(r, scene);
    if (s == STATUS_OK && r->observed.x_k.count > 0)
        s = fit_persistence(r, scene);
    return s;
}

/* ---- both ---------------------------------------------------------------- */

enum status release_run(struct release *r, const struct scene *scene,
                        const struct monitor *monitor, struct fault *why)
{
    enum status s = STATUS_OK;

    *r = (struct release){ .K = find_K(&scene->rabinowicz) };
    if (scene->rabinowicz.data)
        s = read_data(r, scene->rabinowicz.data, why);
    if (s == STATUS_OK) {
        why->text[0] = '\0';
        s = fit_all(r, scene);
    }
    if (s == STATUS_OK)
        s = find_rows(r, scene, monitor, why);
    if (s == STATUS_OK)
        return STATUS_OK;
    if (why->text[0] == '\0')
        snprintf(why->text, sizeof why->text, "rabinowicz: %s", status_text(s));
    release_free(r);
    return s;
}

void release_free(struct release *r)
{
    free(r->row);
    observations_free(&r->observed);
    slip_curve_free(&r->slip);
    *r = (struct release){ .row = NULL };
}
