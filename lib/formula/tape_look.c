/* Once for each width of the processor's registers, TAPE_LOOK its name. */
#include <math.h>

#include "tape_each.h"

/* The chart's rates and that of an observable. */
struct sight {
    jet_pair f[3], scale, unit;
    struct each_slope slope[3];
};

static void make_plain(const struct tape_plane *p, struct vec2 z, int which,
                       bool slopes, struct planar_look *out)
{
    if (slopes)
        tape_jacobian(p, z, &out->J);
    else
        tape_field(p, z, &out->J.field);
    out->unit = exp(-out->J.field.log_scale);
    if (which >= 0)
        tape_rate(p, (size_t) which, z, &out->rate,
                  slopes ? &out->gradient : NULL);
}

/* The scale is that of the larger rate; see field_of. */
static inline __attribute__((always_inline)) void make_rates(struct each *e,
                                                             enum each_making m,
                                                             int which,
                                                             struct sight *s)
{
    struct each_rate r[3];
    const int n = which < 0 ? 2 : 3;

    for (int i = 0; i < n; i++)
        r[i] = each_rate(e, m, i < 2 ? i : 2 + which);
    s->scale = jet_choose(r[1].exponent >= r[0].exponent, r[1].exponent,
                          r[0].exponent);
    s->unit = each_exp(
        jet_choose(each_size(s->scale) < EACH_FAR, -s->scale, JET_PAIR(0.0)));
    e->odd |= ~(each_size(r[1].exponent - r[0].exponent) < 600.0);
    for (int i = 0; i < n; i++) {
        const jet_pair u = i < 2 ? r[i].exponent - s->scale : r[i].exponent;
        each_watch(e, u);
        const jet_pair power = each_exp(u);
        s->f[i] = r[i].mantissa * power;
        if (m == EACH_GRADIENTS)
            s->slope[i] =
                each_rate_slope(e, i < 2 ? i : 2 + which, &r[i], power);
    }
}

static inline __attribute__((always_inline)) void make(struct each *e,
                                                       enum each_making m,
                                                       const struct vec2 z[],
                                                       int which,
                                                       struct sight *s)
{
    const struct real_tape *t = &e->p[0]->t;
    jet_pair reg[TAPE_STEPS + 2];
    struct each_slope g[TAPE_STEPS + 2];

#define X(l) z[l].x
#define Y(l) z[l].y
    reg[0] = JET_EACH(X);
    reg[1] = JET_EACH(Y);
#undef X
#undef Y
    g[0] = (struct each_slope){ JET_PAIR(1.0), JET_PAIR(0.0) };
    g[1] = (struct each_slope){ JET_PAIR(0.0), JET_PAIR(1.0) };
    e->reg = reg;
    e->g = g;
    each_run(e, m, NULL, 0, t->rate_steps);
    if (which >= 0)
        each_run(e, m, t->used[which], t->rate_steps, t->steps);
    make_rates(e, m, which, s);
}

static void take(const struct sight *s, int l, int which, bool slopes,
                 struct planar_look *out)
{
    out->J.field.direction = (struct vec2){ s->f[0][l], s->f[1][l] };
    out->J.field.log_scale = s->scale[l];
    out->unit = fabs(s->scale[l]) < EACH_FAR ? s->unit[l] : exp(-s->scale[l]);
    if (which >= 0)
        out->rate = s->f[2][l];
    if (!slopes)
        return;
    out->J.matrix = (struct mat2){ s->slope[0].x[l], s->slope[0].y[l],
                                   s->slope[1].x[l], s->slope[1].y[l] };
    if (which >= 0)
        out->gradient = (struct vec2){ s->slope[2].x[l], s->slope[2].y[l] };
}

void TAPE_LOOK(const void *const ctx[], size_t n, const struct vec2 z[],
               int which, bool slopes, struct planar_look out[])
{
    const bool can = each_can(&((const struct tape_plane *) ctx[0])->t);
    const void *plane[JET_LANES];
    struct vec2 at[JET_LANES];
    struct sight s;
    struct each e;

    for (size_t l = 0; l < JET_LANES; l++) {
        plane[l] = ctx[l < n ? l : 0];
        at[l] = z[l < n ? l : 0];
    }
    each_begin(&e, plane);
    if (can && slopes)
        make(&e, EACH_GRADIENTS, at, which, &s);
    else if (can)
        make(&e, EACH_VALUES, at, which, &s);
    for (size_t l = 0; l < n; l++)
        if (can && !e.odd[l])
            take(&s, (int) l, which, slopes, &out[l]);
        else
            make_plain(ctx[l], z[l], which, slopes, &out[l]);
}
