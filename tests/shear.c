/* Everything is written for the horizontal map x + p(y); the vertical one is
 * the same with x and y exchanged. */
#include "shear.h"

#include "jet_operations.h"

static struct vec2 flip_vec(bool flip, struct vec2 v)
{
    return flip ? (struct vec2){ v.y, v.x } : v;
}

static struct mat2 flip_mat(bool flip, struct mat2 A)
{
    return flip ? (struct mat2){ A.yy, A.yx, A.xy, A.xx } : A;
}

/* p, p', p'' at t. */
static void polynomial(const struct shear *s, double t, double out[3])
{
    double p = 0.0, slope = 0.0, bend = 0.0;

    for (size_t k = s->degree + 1; k-- > 0;) {
        bend = bend * t + 2.0 * slope;
        slope = slope * t + p;
        p = p * t + s->coef[k];
    }
    out[0] = p;
    out[1] = slope;
    out[2] = bend;
}

static struct vec2 moved(const struct shear *s, double sign, struct vec2 z)
{
    struct vec2 u = flip_vec(s->vertical, z);
    double p[3];

    polynomial(s, u.y, p);
    u.x += sign * p[0];
    return flip_vec(s->vertical, u);
}

struct vec2 shear_apply(const struct shear *s, struct vec2 z)
{
    return moved(s, 1.0, z);
}

struct vec2 shear_undo(const struct shear *s, struct vec2 z)
{
    return moved(s, -1.0, z);
}

struct shear shear_about(const struct shear *s, struct vec2 at)
{
    const double t = flip_vec(s->vertical, at).y;
    struct shear out = *s;

    for (size_t i = 0; i < s->degree; i++)
        for (size_t j = s->degree; j-- > i;)
            out.coef[j] += t * out.coef[j + 1];
    out.coef[0] = 0.0;
    return out;
}

/* With M = (x + p(y), y): the field becomes DM v, its derivative
 * (D^2 M v + DM Dv) (DM)^-1 and a gradient g (DM)^-1. */
void shear_carry(const struct shear *s, struct shear_frame *f)
{
    const struct vec2 z = flip_vec(s->vertical, f->z);
    struct vec2 v = flip_vec(s->vertical, f->value);
    struct vec2 g = flip_vec(s->vertical, f->gradient);
    struct mat2 D = flip_mat(s->vertical, f->slope);
    double p[3];

    polynomial(s, z.y, p);
    D.xx += p[1] * D.yx;
    D.xy += p[1] * D.yy + p[2] * v.y;
    D.xy -= p[1] * D.xx;
    D.yy -= p[1] * D.yx;
    g.y -= p[1] * g.x;
    v.x += p[1] * v.y;
    f->z = shear_apply(s, f->z);
    f->value = flip_vec(s->vertical, v);
    f->slope = flip_mat(s->vertical, D);
    f->gradient = flip_vec(s->vertical, g);
}

const jet_pair *shear_jet_undo(const struct shear *s, struct jet_work *w,
                               size_t k, const jet_pair *z[2])
{
    const size_t m = s->vertical ? 1 : 0;
    const jet_pair *t = z[1 - m];
    jet_pair *before = jet_slot(w), *slope = jet_slot(w);
    const jet_pair *power = t; /* t^j */

    before[k] = z[m][k] - s->coef[1] * t[k] - (k == 0 ? s->coef[0] : 0.0);
    slope[k] = JET_PAIR(k == 0 ? s->coef[1] : 0.0);
    for (size_t j = 2; j <= s->degree; j++) {
        jet_pair *next = jet_slot(w);
        slope[k] += (double) j * s->coef[j] * power[k];
        next[k] = jet_product(k, t, power);
        before[k] -= s->coef[j] * next[k];
        power = next;
    }
    z[m] = before;
    return slope;
}

void shear_jet_carry(const struct shear *s, struct jet_work *w, size_t k,
                     const jet_pair *slope, const jet_pair *v[2])
{
    const size_t m = s->vertical ? 1 : 0;
    jet_pair *after = jet_slot(w);

    after[k] = v[m][k] + jet_product(k, slope, v[1 - m]);
    v[m] = after;
}
