#include "interval_tape.h"

#include <stdlib.h>
#include <string.h>

#include "interval_math.h"
#include "interval_step.h"

static struct interval point(double x)
{
    return interval_point(x);
}

/* ---- constants ----------------------------------------------------------- */

/* The nearest whole number to a constant, and e^(what is left). */
static void split(const struct interval_graph *g, int node, double *whole,
                  struct interval *part)
{
    mpfi_srcptr c = interval_graph_value(g, node);
    mpfi_t rest;

    mpfi_init2(rest, mpfi_get_prec(c));
    *whole = rint(mpfi_get_d(c));
    mpfi_sub_d(rest, c, *whole);
    mpfi_exp(rest, rest);
    *part = interval_of_mpfi(rest);
    mpfi_clear(rest);
}

enum status interval_tape_init(struct interval_tape *out, const struct tape *t,
                               const struct interval_graph *g, const int rate[],
                               int rates)
{
    bool needed[INTERVAL_REGISTERS] = { false };

    *out = (struct interval_tape){ .t = t, .rate = { 0, 1 }, .rates = 2 };
    for (int i = 0; i < rates; i++)
        out->rate[out->rates++] = rate[i];
    for (int i = 0; i < out->rates; i++)
        tape_need_rate(&t->rate[out->rate[i]], needed);
    tape_need_linear(&t->value[0], needed);
    tape_need_parts(t, needed);
    for (int i = 0; i < t->steps; i++)
        out->used[i] = needed[i + 2];
    for (int i = 0; i < g->nodes; i++)
        out->constant[g->node[i]] = interval_graph_get(g, g->node[i]);
    for (int i = 0; i < out->rates; i++)
        for (int k = 0; k < TAPE_EXPONENTS; k++)
            split(g, t->rate[out->rate[i]].exponent[k].constant,
                  &out->whole[i][k], &out->part[i][k]);
    out->series =
        malloc((INTERVAL_REGISTERS + INTERVAL_KEPT) * sizeof *out->series);
    return out->series ? STATUS_OK : STATUS_NO_MEMORY;
}

void interval_tape_free(struct interval_tape *t)
{
    free(t->series);
    t->series = NULL;
}

/* ---- rates --------------------------------------------------------------- */

/* Which exponent goes with the sign taken; of its two forms, which are equal,
 * the one without growths where all of these have shrunk to 1/e. */
static int exponent_of(const struct interval_run *r, const struct tape_rate *p)
{
    const int minus = p->sinh >= 0 && r->sign[p->sinh] < 0;
    const struct linear *near = &p->exponent[minus + TAPE_NEAR];

    for (int i = 0; i < near->terms; i++) {
        const int reg = near->term[i].reg;
        if (tape_takes(r->t->t, reg) &&
            interval_middle(r->reg[r->t->t->step[reg - 2].a].c[0]) > -1)
            return minus + TAPE_NEAR;
    }
    return minus;
}

static void run_steps(struct interval_run *r, const struct interval x[],
                      const struct interval y[])
{
    memcpy(r->reg[0].c, x, (r->n + 1) * sizeof *x);
    memcpy(r->reg[1].c, y, (r->n + 1) * sizeof *y);
    for (int i = 0; i < r->t->t->steps; i++)
        if (r->t->used[i])
            interval_step(r, i);
}

/* A rate's exponent but for what is in `part`. */
struct exponent {
    struct interval c[JET_SIZE];
    int which;
    double whole;
};

static void make_exponent(const struct interval_run *r, int i,
                          struct exponent *e)
{
    const struct tape_rate *p = &r->t->t->rate[r->t->rate[i]];

    e->which = exponent_of(r, p);
    e->whole = r->t->whole[i][e->which];
    interval_terms(r, &p->exponent[e->which], e->c);
    if (p->scaled >= 0)
        e->c[0] = interval_add(e->c[0], point(r->scale[p->scaled]));
}

/* A whole number near the larger exponent of the chart's rates. */
static double scale_of_rates(const struct exponent e[])
{
    double most = -HUGE_VAL;

    for (int i = 0; i < 2; i++)
        most = fmax(most, interval_middle(e[i].c[0]) + e[i].whole);
    return fabs(most) < 0x1p50 ? rint(most) : 0;
}

void interval_tape_jet(struct interval_tape *t, size_t n,
                       const struct interval x[], const struct interval y[],
                       struct interval_series out[], double *log_scale)
{
    struct interval_run r = {
        .t = t, .n = n, .reg = t->series, .keep = t->series + INTERVAL_REGISTERS
    };
    struct exponent e[TAPE_RATES];
    struct interval m[JET_SIZE], power[JET_SIZE];

    run_steps(&r, x, y);
    for (int i = 0; i < t->rates; i++)
        make_exponent(&r, i, &e[i]);
    *log_scale = scale_of_rates(e);
    for (int i = 0; i < t->rates; i++) {
        /* exact: both are whole and below 2^52 */
        const struct interval whole = point(e[i].whole - *log_scale);
        const struct interval e0 =
            interval_times(t->part[i][e[i].which],
                           interval_exp(interval_add(e[i].c[0], whole)));
        interval_linear(&r, &t->t->rate[t->rate[i]].mantissa, m);
        interval_exponential(n, e[i].c, e0, power);
        interval_product(n, m, power, out[i].c);
    }
}

struct interval interval_tape_change(struct interval_tape *t, struct interval x,
                                     struct interval y)
{
    struct interval_run r = { .t = t,
                              .reg = t->series,
                              .keep = t->series + INTERVAL_REGISTERS };
    struct linear change = t->t->value[0];
    struct interval sum[JET_SIZE];

    run_steps(&r, &x, &y);
    change.constant = 0; /* node 0 is the number 0 */
    interval_linear(&r, &change, sum);
    return sum[0];
}
