#include "tape_plane.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "quad.h"

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
               isfinite(t->rate[i].exponent[1].constant);
    return fine;
}

static enum status refuse(struct fault *why, const char *text)
{
    snprintf(why->text, sizeof why->text, "%s", text);
    return STATUS_BAD_ARGUMENT;
}

enum status tape_plane_at(const struct tape_lowered *l,
                          const struct formula_value value[],
                          const formula_real anchor[2], struct tape_plane *out,
                          struct fault *why)
{
    struct formula_value all[TAPE_PLANE_VALUES] = { { NULL, 0 } };
    formula_real constant[FORMULA_NODES];
    int n = 0;

    for (; value->name && n < TAPE_PLANE_VALUES - 3; n++)
        all[n] = *value++;
    for (int i = 0; i < 2; i++)
        all[n++] = (struct formula_value){ anchor_name[i], anchor[i] };
    formula_constants(&l->f, all, (quad) 0x1p-90, constant);
    if (!real_tape_at(&l->t, constant, &out->t) || !tape_jet_slots(out))
        return refuse(why, "the formulas have too many parts");
    if (!is_finite(&out->t))
        return refuse(why, "a formula has no finite value at this point");
    for (int i = 0; i < 2; i++)
        out->origin[i] = (double) anchor[i];
    return STATUS_OK;
}

/* ---- reals and duals ----------------------------------------------------- */

static double larger(double u, double w)
{
    return u > w ? u : w;
}

/* Registers, and the field's scale. */
static void field_of(const struct real_tape *t, const double reg[],
                     struct planar_field *f)
{
    const double ex = real_tape_exponent(t, 0, reg),
                 ey = real_tape_exponent(t, 1, reg);

    f->log_scale = larger(ex, ey);
    f->direction.x = real_tape_mantissa(t, 0, reg) * exp(ex - f->log_scale);
    f->direction.y = real_tape_mantissa(t, 1, reg) * exp(ey - f->log_scale);
}

void tape_field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    const struct tape_plane *p = ctx;
    double reg[TAPE_STEPS + 2];

    real_tape_run(&p->t, z.x, z.y, false, reg);
    field_of(&p->t, reg, f);
}

void tape_jacobian(const void *ctx, struct vec2 z, struct planar_jacobian *J)
{
    const struct tape_plane *p = ctx;
    double reg[TAPE_STEPS + 2];
    struct vec2 gradient[TAPE_STEPS + 2];

    real_tape_run(&p->t, z.x, z.y, false, reg);
    tape_gradients(&p->t, false, reg, gradient);
    field_of(&p->t, reg, &J->field);
    const double scale = J->field.log_scale;
    const struct vec2 x = tape_rate_gradient(&p->t, 0, scale, reg, gradient),
                      y = tape_rate_gradient(&p->t, 1, scale, reg, gradient);
    J->matrix = (struct mat2){ x.x, x.y, y.x, y.y };
}

void tape_rate(const void *ctx, size_t which, struct vec2 z, double *rate,
               struct vec2 *gradient)
{
    const struct tape_plane *p = ctx;
    const int i = 2 + (int) which;
    double reg[TAPE_STEPS + 2];
    struct vec2 slope[TAPE_STEPS + 2];

    real_tape_run(&p->t, z.x, z.y, true, reg);
    *rate = real_tape_mantissa(&p->t, i, reg) *
            exp(real_tape_exponent(&p->t, i, reg));
    if (gradient == NULL)
        return;
    tape_gradients(&p->t, true, reg, slope);
    *gradient = tape_rate_gradient(&p->t, i, 0.0, reg, slope);
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
