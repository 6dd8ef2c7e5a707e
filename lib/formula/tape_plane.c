#include "tape_plane.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "quad.h"
#include "tape_course.h"

/* ---- making -------------------------------------------------------------- */

/* No name that people can type. */
static const char *const anchor_name[2] = { "0 of x", "0 of y" };

enum status tape_plane_lower(struct tape_lowered *out, const struct formula *f,
                             const struct plane_formulas *p, bool equilibrium,
                             struct fault *why)
{
    memcpy(&out->f, f, sizeof *f);
    out->p = *p;
    for (int i = 0; i < 2; i++) {
        const int chart =
            formula_leaf(&out->f, anchor_name[i], FORMULA_PARAMETER);
        out->p.chart[i] = chart;
        out->p.at[i] = f->node[p->state[i]].positive
                           ? formula_of(&out->f, FUNCTION_EXP, chart)
                           : chart;
        out->p.zero[i] = equilibrium;
    }
    return tape_lower(&out->t, &out->f, &out->p, why);
}

static bool is_finite(const struct real_tape *t)
{
    bool fine = true;

    for (int i = 0; i < t->steps; i++)
        fine = fine && isfinite(t->step[i].k) && isfinite(t->step[i].q) &&
               isfinite(t->step[i].form.constant);
    for (int i = 0; i < t->terms; i++)
        fine = fine && isfinite(t->term[i].c);
    for (int i = 0; i < t->rates; i++)
        fine = fine && isfinite(t->rate[i].mantissa.constant) &&
               isfinite(t->rate[i].exponent[0].constant) &&
               isfinite(t->rate[i].exponent[1].constant) &&
               isfinite(t->rate[i].exponent[TAPE_NEAR].constant) &&
               isfinite(t->rate[i].exponent[TAPE_NEAR + 1].constant);
    return fine;
}

static enum status refuse(struct fault *why, const char *text)
{
    snprintf(why->text, sizeof why->text, "%s", text);
    return STATUS_BAD_ARGUMENT;
}

/* By way of 113 bits where long doubles lose digits. */
static void constants_at(const struct tape_lowered *l,
                         const struct formula_value leaf[],
                         long double constant[])
{
    quad exact[FORMULA_NODES];

    if (formula_long_constants(&l->f, leaf, l->t.needs, constant))
        return;
    formula_constants(&l->f, leaf, l->t.needs, (quad) 0x1p-90, exact);
    for (int i = 0; i < l->f.nodes; i++)
        constant[i] = (long double) exact[i];
}

enum status tape_plane_at(const struct tape_lowered *l,
                          const struct formula_value value[],
                          const formula_real anchor[2], struct tape_plane *out,
                          struct fault *why)
{
    struct formula_value all[TAPE_PLANE_VALUES] = { { NULL, 0 } };
    long double constant[FORMULA_NODES];
    int n = 0;

    for (; value->name && n < TAPE_PLANE_VALUES - 3; n++)
        all[n] = *value++;
    for (int i = 0; i < 2; i++)
        all[n++] = (struct formula_value){ anchor_name[i], anchor[i] };
    constants_at(l, all, constant);
    if (!real_tape_at(&l->t, constant, &out->t) || !tape_jet_slots(out))
        return refuse(why, "the formulas have too many parts");
    if (!is_finite(&out->t))
        return refuse(why, "a formula has no finite value at this point");
    for (int i = 0; i < 2; i++)
        out->origin[i] = (double) anchor[i];
    out->wide = tape_jet_wide();
    return STATUS_OK;
}

/* ---- reals and duals ----------------------------------------------------- */

/* e^u in two factors, the second 1 but for e^u that a mantissa, which may be
 * large, brings back; mostly u is 0. */
struct power {
    double most, rest;
};

static struct power power_of(double u)
{
    const double half = u < -700 ? exp(u / 2) : 1;

    return (struct power){ u < -700 ? half : u == 0 ? 1 : exp(u), half };
}

/* And the exponentials of both rates. */
static void field_of(const struct real_tape *t, const double reg[],
                     struct planar_field *f, struct power e[2])
{
    double size[2];

    for (int i = 0; i < 2; i++)
        size[i] = real_tape_exponent(t, i, reg);
    f->log_scale = size[0] > size[1] ? size[0] : size[1];
    for (int i = 0; i < 2; i++)
        e[i] = power_of(size[i] - f->log_scale);
    f->direction.x = real_tape_mantissa(t, 0, reg) * e[0].most * e[0].rest;
    f->direction.y = real_tape_mantissa(t, 1, reg) * e[1].most * e[1].rest;
}

/* A rate's gradient, its exponential e. */
static struct vec2 gradient_of(const struct tape_kept *v, int rate,
                               struct power e, const struct vec2 gradient[])
{
    const struct vec2 g = tape_rate_gradient(v, rate, e.most, gradient);

    return (struct vec2){ g.x * e.rest, g.y * e.rest };
}

void tape_field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    const struct tape_plane *p = ctx;
    double reg[TAPE_STEPS + 2];
    struct power e[2];

    real_tape_run(&p->t, z.x, z.y, 0, reg);
    field_of(&p->t, reg, f, e);
}

/* Registers and gradients that a rate needs; 0: both of the chart, 1: all. */
static void run_both(const struct tape_plane *p, struct vec2 z, int rate,
                     struct tape_kept *v, struct vec2 gradient[])
{
    v->p = p;
    v->reg[0] = z.x;
    v->reg[1] = z.y;
    gradient[0] = (struct vec2){ 1, 0 };
    gradient[1] = (struct vec2){ 0, 1 };
    tape_keep(v, false, rate < 2 ? NULL : p->t.used[rate - 2], 0,
              rate == 0 ? p->t.rate_steps : p->t.steps);
    tape_gradients(v, rate, gradient);
}

void tape_jacobian(const void *ctx, struct vec2 z, struct planar_jacobian *J)
{
    const struct tape_plane *p = ctx;
    struct tape_kept v;
    struct vec2 gradient[TAPE_STEPS + 2];
    struct power e[2];

    run_both(p, z, 0, &v, gradient);
    field_of(&p->t, v.reg, &J->field, e);
    const struct vec2 x = gradient_of(&v, 0, e[0], gradient),
                      y = gradient_of(&v, 1, e[1], gradient);
    J->matrix = (struct mat2){ x.x, x.y, y.x, y.y };
}

void tape_rate(const void *ctx, size_t which, struct vec2 z, double *rate,
               struct vec2 *gradient)
{
    const struct tape_plane *p = ctx;
    const int i = 2 + (int) which;
    struct tape_kept v;
    struct vec2 slope[TAPE_STEPS + 2];

    if (gradient == NULL)
        real_tape_run(&p->t, z.x, z.y, i, v.reg);
    else
        run_both(p, z, i, &v, slope);
    const struct power e = power_of(real_tape_exponent(&p->t, i, v.reg));
    *rate = real_tape_mantissa(&p->t, i, v.reg) * e.most * e.rest;
    if (gradient != NULL)
        *gradient = gradient_of(&v, i, e, slope);
}

double tape_value(const struct tape_plane *p, struct vec2 z)
{
    double reg[TAPE_STEPS + 2];

    real_tape_run(&p->t, z.x, z.y, 1, reg);
    return real_tape_linear(&p->t, &p->t.value[0], reg);
}

struct vec2 tape_value_gradient(const struct tape_plane *p, struct vec2 z)
{
    struct tape_kept v;
    struct vec2 gradient[TAPE_STEPS + 2];

    run_both(p, z, 1, &v, gradient);
    return tape_linear_gradient(&p->t, &p->t.value[0], gradient);
}

struct planar tape_planar(const struct tape_plane *t)
{
    return (struct planar){
        .origin = { t->origin[0], t->origin[1] },
        .field = tape_field,
        .jacobian = tape_jacobian,
        .jet = tape_jet,
        .observable_count = (size_t) (t->t.rates - 2),
        .rate_gradient = t->t.rates > 2 ? tape_rate : NULL,
        .rate_jet = t->t.rates > 2 ? tape_jet_rate : NULL,
        .ctx = t,
    };
}
