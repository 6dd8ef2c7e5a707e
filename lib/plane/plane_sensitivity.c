#include "plane_sensitivity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "equilibria.h"
#include "plane_tolerance.h"

/* The numbers of an equilibrium in the order of struct plane_slope. */
static struct system_number number_at(const struct system_equilibrium *e,
                                      size_t i)
{
    if (i < 2)
        return e->state[i];
    return i % 2 == 0 ? e->eigenvalue[(i - 2) / 2].re
                      : e->eigenvalue[(i - 2) / 2].im;
}

struct differences {
    const struct plane_study *s;
    const struct plane_rest *rest;
    struct formula_system *system;   /* owned; with the parameter moved */
    struct system_equilibria *found; /* owned */
    struct system_equilibrium at[4]; /* p - h, p + h, p - h/2, p + h/2 */
};

/* The one next to the rest; false: there is none, or more than one. */
static bool find_near(struct differences *d, struct system_equilibrium *out)
{
    const double z[] = { d->rest->z.x, d->rest->z.y };
    const double side[] = { d->s->scale.side.x, d->s->scale.side.y };
    const double period[] = { d->s->scale.period.x, d->s->scale.period.y };
    struct system_window w;
    struct fault why;
    int near = 0;

    for (int k = 0; k < 2; k++) {
        w.lo[k] = z[k] - TOL_BESIDE * side[k];
        w.hi[k] = z[k] + TOL_BESIDE * side[k];
    }
    if (system_equilibria_find(d->system, &w, d->found, &why) != STATUS_OK)
        return false;
    for (int i = 0; i < d->found->count; i++) {
        const struct system_equilibrium *e = &d->found->equilibrium[i];
        bool inside = true;
        for (int k = 0; k < 2; k++) {
            const double off = (double) e->chart[k].value - z[k];
            inside = inside &&
                     fabs(period[k] > 0.0 ? remainder(off, period[k]) : off) <=
                         TOL_BESIDE * side[k];
        }
        if (inside)
            *out = *e;
        near += inside;
    }
    return near == 1;
}

/* D of the numbers i of two equilibria 2 h apart, and what their bars leave. */
static formula_real difference(const struct system_equilibrium at[2], size_t i,
                               formula_real h, double *noise)
{
    const struct system_number low = number_at(&at[0], i),
                               high = number_at(&at[1], i);

    *noise = (low.error + high.error) / (double) (2 * h);
    return (high.value - low.value) / (2 * h);
}

static struct quantity slope_of(const struct differences *d, size_t i,
                                formula_real h)
{
    double noise[2];
    const formula_real wide = difference(d->at, i, h, &noise[0]);
    const formula_real fine = difference(d->at + 2, i, h / 2, &noise[1]);
    const double value = (double) fine;
    const double error = fabs((double) (wide - fine)) + noise[0] + noise[1] +
                         fabs((double) (fine - (formula_real) value));

    return isfinite(value) && isfinite(error)
               ? quantity_of(value, error + 0x1p-52 * error)
               : quantity_none("the derivative is not finite");
}

/* Whether eigenvalues are a pair. */
static bool is_pair(const struct system_equilibrium *e)
{
    return e->eigenvalue[1].im.value > 0;
}

/* By parameter k. */
static enum status find_slopes(struct differences *d, int k,
                               struct plane_slope *out)
{
    const struct formula_place here = { "sensitivities", 0, 0 };
    const formula_real p = d->s->scene->system->parameter[k].value;
    const formula_real h = (formula_real) TOL_PLANE_MOVED * (p > 0   ? p
                                                             : p < 0 ? -p
                                                                     : 1);
    const formula_real move[] = { -h, h, -h / 2, h / 2 };
    const char *reason = NULL;
    struct fault why;

    for (int i = 0; i < 4 && !reason; i++) {
        *d->system = *d->s->scene->system;
        if (formula_system_set(d->system, d->system->parameter[k].name,
                               p + move[i], here, &why) != STATUS_OK ||
            !find_near(d, &d->at[i]))
            reason = "the equilibrium could not be followed";
    }
    for (size_t i = 0; i < PLANE_SLOPES; i++)
        out->by[i] = reason ? quantity_none(reason) : slope_of(d, i, h);
    for (size_t i = 2; i < PLANE_SLOPES && !reason; i++)
        if (is_pair(&d->at[0]) != is_pair(&d->at[1]))
            out->by[i] = quantity_none("the two eigenvalues meet there");
    return STATUS_OK;
}

/* ---- what rounding of the parameters costs ------------------------------- */

static void set_conditioning(struct quantity *q, const struct plane_slope *by,
                             size_t i, const struct formula_system *f)
{
    double sum = 0.0;

    if (!quantity_exists(q) || q->value == 0.0)
        return;
    for (int k = 0; k < f->parameters; k++) {
        if (!quantity_exists(&by[k].by[i]))
            return;
        sum += fabs(by[k].by[i].value * (double) f->parameter[k].value);
    }
    q->conditioning = 0x1p-53 * sum / fabs(q->value);
}

/* ---- what their scatter makes -------------------------------------------- */

/* S of a parameter that is X +- S; 0: it is known. */
static double scatter_of(const struct scene *s, const char *name)
{
    const struct scene_ensemble *e = &s->ensemble;

    for (size_t i = 0; i < e->scattered; i++)
        if (strcmp(strrchr(e->parameter[i].key, '.') + 1, name) == 0)
            return e->parameter[i].of[1];
    return 0.0;
}

static void set_spread(struct quantity *q, const struct plane_slope *by,
                       size_t i, const struct scene *s)
{
    double all = 0.0;

    for (int k = 0; k < s->system->parameters && quantity_exists(q); k++) {
        const double scatter = scatter_of(s, s->system->parameter[k].name);
        if (scatter > 0.0)
            all = hypot(all, quantity_exists(&by[k].by[i])
                                 ? scatter * by[k].by[i].value
                                 : HUGE_VAL);
        q->spread = q->spread_si = all;
    }
}

static void set_all(struct plane_rest *r, const struct plane_slope *by,
                    const struct plane_study *s)
{
    struct quantity *q[] = { &r->state[0],     &r->state[1],
                             &r->lambda[0].re, &r->lambda[0].im,
                             &r->lambda[1].re, &r->lambda[1].im };

    for (size_t i = 0; i < PLANE_SLOPES; i++) {
        if (s->products & 1u << PRODUCT_SENSITIVITIES)
            set_conditioning(q[i], by, i, s->scene->system);
        if (s->scene->ensemble.scattered > 0)
            set_spread(q[i], by, i, s->scene);
    }
}

/* ---- all ----------------------------------------------------------------- */

enum status plane_sensitivity_find(struct plane_study *s,
                                   const struct monitor *monitor)
{
    const struct formula_system *f = s->scene->system;
    const size_t each = (size_t) f->parameters;
    struct differences d = { .s = s,
                             .system = malloc(sizeof *d.system),
                             .found = malloc(sizeof *d.found) };
    enum status status = STATUS_OK;

    s->slope = calloc(s->listed * each + 1, sizeof *s->slope);
    if (d.system == NULL || d.found == NULL || s->slope == NULL)
        status = STATUS_NO_MEMORY;
    for (size_t i = 0; i < s->listed && status == STATUS_OK; i++) {
        d.rest = &s->rest[i];
        if (monitor_tell(monitor, "sensitivities", i, s->listed))
            status = STATUS_STOPPED;
        for (int k = 0; k < f->parameters && status == STATUS_OK; k++)
            status = find_slopes(&d, k, &s->slope[i * each + (size_t) k]);
        set_all(&s->rest[i], s->slope + i * each, s);
    }
    free(d.system);
    free(d.found);
    return status;
}
