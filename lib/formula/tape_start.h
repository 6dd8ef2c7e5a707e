/*
 * tape_start.h -- inside tape_jet.c: order 0 of the series, lane by lane or, of
 * many lanes, side by side.
 */
#pragma once

#include <string.h>

#include "tape_course.h"
#if JET_LANES > 2
#include "tape_each.h"
#endif

/* Steps of a part and then its rates; the chart's own fix the scale. */
static void start_lane(const struct course *c, int part, int l,
                       struct tape_kept *v, double *scale, double rate[])
{
    const struct tape_plane *p = c->ctx[l];
    const int from = part ? p->t.rate_steps : 0;
    double e[2];

    v->p = p;
    for (int i = 0; i < from + 2; i++)
        v->reg[i] = c->reg[i][l];
    tape_keep(v, part);
    for (int i = 0; i < (part ? 1 : 2); i++)
        e[i] = real_tape_exponent(&p->t, part ? part + 1 : i, v->reg);
    if (part == 0)
        *scale = e[0] > e[1] ? e[0] : e[1];
    for (int i = 0; i < (part ? 1 : 2); i++)
        rate[i] = tape_start_rate(v, part ? part + 1 : i, e[i] - *scale);
}

static void keep_pairs(const struct course *c,
                       const struct tape_kept *const v[], int from, int to)
{
#define KEEP(l) v[l]->keep[i]
    for (int i = from; i < to; i++)
        c->keep[i] = JET_EACH(KEEP);
#undef KEEP
}

/* The coefficients of a part's entries. */
static void start_entries(const struct course *c, const struct tape_part *part)
{
#define COEFFICIENT(l)                                                         \
    ((const struct tape_plane *) c->ctx[l])->op[i / 2].c[i % 2]
    for (int i = 2 * part->op; i < 2 * part->ops; i++)
        c->constant[i] = JET_EACH(COEFFICIENT);
#undef COEFFICIENT
}

#if JET_LANES > 2
/* A lane that is odd, by itself. */
static void start_odd(const struct course *c, struct jet_work *w, int part,
                      int l)
{
    const struct tape_plane *p = c->p;
    struct tape_kept v;
    double rate[2], scale = w->log_scale[l];

    start_lane(c, part, l, &v, &scale, rate);
    w->log_scale[l] = scale;
    for (int i = part ? p->t.rate_steps : 0;
         i < (part ? p->t.steps : p->t.rate_steps); i++)
        if (part ? p->t.used[part - 1][i] : !p->t.step[i].idle) {
            c->reg[i + 2][l] = v.reg[i + 2];
            for (int j = p->kept[i]; j < p->kept[i + 1]; j++)
                c->keep[j][l] = v.keep[j];
        }
    for (int i = 0; i < (part ? 1 : 2); i++) {
        const int r = part ? part + 1 : i;
        for (int j = p->rate_kept[r]; j < p->rate_kept[r] + TAPE_KEPT; j++)
            c->keep[j][l] = v.keep[j];
        c->reg[p->result[r]][l] = rate[i];
    }
}

/* tape_start_rate of all lanes. */
static void start_rate(const struct course *c, struct each *e, int rate,
                       const struct each_rate *r, jet_pair scale)
{
    const struct tape_plane *p = c->p;
    const struct real_tape_rate *of = &p->t.rate[rate];
    const jet_pair factor = each_number(e, &p->factor[rate]);
    const jet_pair u = r->exponent - scale, one = JET_PAIR(1.0);
    jet_pair *keep = c->keep + p->rate_kept[rate];

    each_watch(e, u);
    const jet_pair power = each_exp(u);
    keep[0] = r->linear / factor;
    keep[1] = factor * r->kept * power;
    keep[2] = of->sinh >= 0
                  ? jet_choose(c->reg[of->sinh] < 0.0, one, JET_PAIR(0.0))
                  : JET_PAIR(0.0);
    c->reg[p->result[rate]] = r->mantissa * power;
}

/* start, of steps that have lanes. */
static void start_each(const struct course *c, struct jet_work *w, int part)
{
    const struct real_tape *t = &c->p->t;
    const int first = part ? part + 1 : 0, rates = part ? 1 : 2;
    struct each_rate r[2];
    struct each e;

    each_begin(&e, c->ctx);
    e.reg = c->reg;
    e.keep = c->keep;
    each_run(&e, EACH_SERIES, part ? t->used[part - 1] : NULL,
             part ? t->rate_steps : 0, part ? t->steps : t->rate_steps);
    for (int i = 0; i < rates; i++)
        r[i] = each_rate(&e, EACH_SERIES, first + i);
    if (part == 0)
        w->log_scale = jet_choose(r[0].exponent > r[1].exponent, r[0].exponent,
                                  r[1].exponent);
    for (int i = 0; i < rates; i++)
        start_rate(c, &e, first + i, &r[i], w->log_scale);
    start_entries(c, &c->p->part[part]);
    for (int l = 0; l < JET_LANES; l++)
        if (e.odd[l])
            start_odd(c, w, part, l);
}
#endif

/* In pairs: a lane that is written by itself stalls whoever reads the pair. */
static void start(const struct course *c, struct jet_work *w, int part)
{
    const struct tape_plane *p = c->p;
    const bool *used = part ? p->t.used[part - 1] : NULL;
    const int lanes = JET_LANES == 2 ? 2 : w->lanes;
    const struct tape_kept *v[JET_LANES];
    struct tape_kept own[JET_LANES];
    double rate[JET_LANES][2], scale[JET_LANES];

#if JET_LANES > 2
    if (each_can(&p->t)) {
        start_each(c, w, part);
        return;
    }
#endif
    for (int l = 0; l < lanes; l++) {
        v[l] = &own[l];
        scale[l] = part ? w->log_scale[l] : 0.0;
        start_lane(c, part, l, &own[l], &scale[l], rate[l]);
    }
    for (int l = lanes; l < JET_LANES; l++) {
        v[l] = v[0];
        scale[l] = scale[0];
        memcpy(rate[l], rate[0], sizeof rate[0]);
    }
#define SCALE(l)    scale[l]
#define REGISTER(l) v[l]->reg[i + 2]
#define RATE(l)     rate[l][i]
    w->log_scale = JET_EACH(SCALE);
    start_entries(c, &p->part[part]);
    for (int i = part ? p->t.rate_steps : 0;
         i < (part ? p->t.steps : p->t.rate_steps); i++)
        if (used ? used[i] : !p->t.step[i].idle) {
            c->reg[i + 2] = JET_EACH(REGISTER);
            keep_pairs(c, v, p->kept[i], p->kept[i + 1]);
        }
    for (int i = 0; i < (part ? 1 : 2); i++) {
        const int r = part ? part + 1 : i;
        keep_pairs(c, v, p->rate_kept[r], p->rate_kept[r] + TAPE_KEPT);
        c->reg[p->result[r]] = JET_EACH(RATE);
    }
#undef SCALE
#undef REGISTER
#undef RATE
}
