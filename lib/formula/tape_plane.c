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
    return fault_set(why, STATUS_BAD_ARGUMENT, "%s", text);
}

/* By way of 113 bits where long doubles lose digits. */
static void constants_at(const struct tape_lowered *l,
                         const struct formula_value leaf[],
                         long double constant[])
{
    quad exact[FORMULA_NODES];

    if (formula_long_constants(&l->f, leaf, l->t.needs, constant))
        return;
    formula_exact_constants(&l->f, leaf, l->t.needs, exact);
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
        return refuse(why, "a formula has no finite value");
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

/* A rate before its exponential is made. */
struct factors {
    double mantissa, exponent;
    int which; /* exponent */
};

static struct factors factors_of(const struct real_tape *t, int rate,
                                 const double reg[])
{
    const struct real_tape_rate *r = &t->rate[rate];
    const int k = real_tape_which(t, rate, reg);
    const double s =
        r->scaled >= 0 ? real_tape_scale(t, r->scaled - 2, reg) : 0;

    return (struct factors){ r->kept[k] *
                                 real_tape_linear(t, &r->mantissa, reg),
                             real_tape_linear(t, &r->exponent[k], reg) + s, k };
}

/* How much less than its exponent the scale of the larger rate may be, so that
 * the smaller one does not vanish beside it: its mantissa all but does so, too,
 * as where psi follows psi_ss at a huge rate. */
static double lent(const struct factors *large, const struct factors *small)
{
    const double wide = 600.0, apart = large->exponent - small->exponent;
    const double size = fabs(large->mantissa);

    if (!(apart > wide) || size >= 1.0 || (size > 0.0 && size < 1e-290))
        return 0.0;
    return fmin(fmin(apart - wide, wide), size > 0.0 ? -log(size) : wide);
}

/* Of both rates, and their exponentials. */
static void field_of(const struct real_tape *t, const double reg[],
                     struct planar_field *f, struct factors r[2],
                     struct power e[2])
{
    for (int i = 0; i < 2; i++)
        r[i] = factors_of(t, i, reg);
    const int large = r[1].exponent >= r[0].exponent;
    f->log_scale = r[large].exponent - lent(&r[large], &r[1 - large]);
    for (int i = 0; i < 2; i++)
        e[i] = power_of(r[i].exponent - f->log_scale);
    f->direction.x = r[0].mantissa * e[0].most * e[0].rest;
    f->direction.y = r[1].mantissa * e[1].most * e[1].rest;
}

/* M' e^E + M E' e^E of a rate, e its exponential */
static struct vec2 gradient_of(const struct real_tape *t, int rate,
                               struct factors f, struct power e,
                               const jet_pair g[])
{
    const struct real_tape_rate *r = &t->rate[rate];
    const jet_pair up = tape_linear_gradient(t, &r->mantissa, g),
                   along = tape_linear_gradient(t, &r->exponent[f.which], g);
    const jet_pair sum =
        (r->kept[f.which] * e.most * up + f.mantissa * e.most * along) * e.rest;

    return (struct vec2){ sum[0], sum[1] };
}

void tape_field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    const struct tape_plane *p = ctx;
    double reg[TAPE_STEPS + 2];
    struct factors r[2];
    struct power e[2];

    tape_values(p, z, 0, reg);
    field_of(&p->t, reg, f, r, e);
}

void tape_jacobian(const void *ctx, struct vec2 z, struct planar_jacobian *J)
{
    const struct tape_plane *p = ctx;
    double reg[TAPE_STEPS + 2];
    jet_pair g[TAPE_STEPS + 2];
    struct factors r[2];
    struct power e[2];

    tape_gradients(p, z, 0, reg, g);
    field_of(&p->t, reg, &J->field, r, e);
    const struct vec2 x = gradient_of(&p->t, 0, r[0], e[0], g),
                      y = gradient_of(&p->t, 1, r[1], e[1], g);
    J->matrix = (struct mat2){ x.x, x.y, y.x, y.y };
}

void tape_rate(const void *ctx, size_t which, struct vec2 z, double *rate,
               struct vec2 *gradient)
{
    const struct tape_plane *p = ctx;
    const int i = 2 + (int) which;
    double reg[TAPE_STEPS + 2];
    jet_pair g[TAPE_STEPS + 2];

    if (gradient == NULL)
        tape_values(p, z, i, reg);
    else
        tape_gradients(p, z, i, reg, g);
    const struct factors r = factors_of(&p->t, i, reg);
    const struct power e = power_of(r.exponent);
    *rate = r.mantissa * e.most * e.rest;
    if (gradient != NULL)
        *gradient = gradient_of(&p->t, i, r, e, g);
}

double tape_value(const struct tape_plane *p, struct vec2 z)
{
    double reg[TAPE_STEPS + 2];

    tape_values(p, z, 1, reg);
    return real_tape_linear(&p->t, &p->t.value[0], reg);
}

struct vec2 tape_value_gradient(const struct tape_plane *p, struct vec2 z)
{
    double reg[TAPE_STEPS + 2];
    jet_pair g[TAPE_STEPS + 2];

    tape_gradients(p, z, 1, reg, g);
    const jet_pair slope = tape_linear_gradient(&p->t, &p->t.value[0], g);
    return (struct vec2){ slope[0], slope[1] };
}

static const struct planar_many *many_of(int width)
{
#ifdef HAVE_WIDE_LANES
    return width == 8 ? &tape_many_8 : width == 4 ? &tape_many_4 : NULL;
#else
    return NULL;
#endif
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
        .many = many_of(jet_width()),
        .ctx = t,
    };
}
