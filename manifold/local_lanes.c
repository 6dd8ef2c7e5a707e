/* One source, once for each width of the processor's registers: LOCAL_BUILD is
 * the name, JET_LANES how many series. */
#include "local_lanes.h"

#include <math.h>

/* The field along the graphs; those beyond n are as the first. */
struct building {
    const struct planar *sys;
    const void *ctx[JET_LANES];
    const struct carry *carry;
    struct local_seed seed[JET_LANES];
    jet_pair unit;
    jet_mask over_y; /* the lanes whose independent coordinate is y */
    struct jet_work work;
    jet_pair at[2][JET_SIZE], f[2][JET_SIZE];
    jet_pair c[JET_SIZE], ind[JET_SIZE];
    jet_pair rate[LOCAL_CARRY_MAX][JET_SIZE];
};

static void set_seed(struct building *g, const struct planar *const sys[],
                     const struct local_seed seed[], size_t n)
{
    bool same = true;

    g->sys = sys[0];
    for (size_t i = 0; i < JET_LANES; i++) {
        g->ctx[i] = sys[i < n ? i : 0]->ctx;
        g->seed[i] = seed[i < n ? i : 0];
        same &= g->seed[i].ind == seed[0].ind;
    }
#define UNIT(i)   g->seed[i].unit
#define RISE(i)   (g->seed[i].slope * g->seed[i].unit)
#define OVER_Y(i) (double) g->seed[i].ind
    g->unit = JET_EACH(UNIT);
    g->c[0] = JET_PAIR(0.0);
    g->c[1] = JET_EACH(RISE);
    g->over_y = JET_EACH(OVER_Y) > JET_PAIR(0.0);
#undef UNIT
#undef RISE
#undef OVER_Y
    g->work.linear = same ? g->at[seed[0].ind] : NULL;
    g->work.lanes = (int) n;
}

static void field_order(struct building *g, size_t k)
{
    const jet_pair ahead = k == 1 ? g->unit : JET_PAIR(0.0);

    g->at[0][k] = jet_choose(g->over_y, g->c[k], ahead);
    g->at[1][k] = jet_choose(g->over_y, ahead, g->c[k]);
#if JET_LANES == 2
    g->sys->jet(g->sys->ctx, &g->work, k, g->at[0], g->at[1], g->f[0], g->f[1]);
#else
    g->sys->many->jet(g->ctx, &g->work, k, g->at[0], g->at[1], g->f[0],
                      g->f[1]);
#endif
    g->ind[k] = jet_choose(g->over_y, g->f[1][k], g->f[0][k]);
}

static void carry_order(struct building *g, size_t i, size_t k)
{
    const size_t which = (size_t) g->carry->which[i];

    if (g->carry->which[i] == CARRY_TIME)
        g->rate[i][k] = JET_PAIR(k == 0 ? 1.0 : 0.0);
    else
#if JET_LANES == 2
        g->sys->rate_jet(g->sys->ctx, which, &g->work, k, g->at[0], g->at[1],
                         g->rate[i]);
#else
        g->sys->many->rate_jet(g->ctx, which, &g->work, k, g->at[0], g->at[1],
                               g->rate[i]);
#endif
}

/* What order k leaves on the right when c[k] is still zero. */
static jet_pair defect_of_order(const struct building *g, size_t k)
{
    jet_pair sum = g->c[1] * g->ind[k];

    for (size_t j = 1; j + 1 < k; j++)
        sum += jet_number[j + 1] * g->c[j + 1] * g->ind[k - j];
    return jet_choose(g->over_y, g->f[0][k], g->f[1][k]) - sum / g->unit;
}

static void build(struct building *g, size_t order)
{
    jet_pair along = JET_PAIR(0.0), across = along;

#define SCALE(i)  exp(g->seed[i].log_scale - g->work.log_scale[i])
#define ALONG(i)  g->seed[i].along
#define ACROSS(i) g->seed[i].across
    for (size_t k = 0; k <= order; k++) {
        if (k >= 2) {
            g->c[k] = JET_PAIR(0.0);
            field_order(g, k);
            g->c[k] = defect_of_order(g, k) / (jet_number[k] * along - across);
        } else if (k == 1) {
            const jet_pair scale = JET_EACH(SCALE);
            along = scale * JET_EACH(ALONG);
            across = scale * JET_EACH(ACROSS);
        }
        field_order(g, k);
        for (size_t i = 0; i < g->carry->count; i++)
            carry_order(g, i, k);
    }
#undef SCALE
#undef ALONG
#undef ACROSS
}

/* q' = rate/f_ind with both zero at the saddle: divide the shifted series. */
static void integrate(const struct building *g, size_t i, size_t order,
                      jet_pair integral[])
{
    jet_pair quotient[JET_SIZE];

    integral[0] = JET_PAIR(0.0);
    for (size_t k = 0; k < order; k++) {
        quotient[k] = jet_quotient(k, g->rate[i] + 1, g->ind + 1, quotient);
        integral[k + 1] = g->unit * quotient[k] / jet_number[k + 1];
    }
}

static void take_integral(const struct building *g, size_t i, size_t order,
                          size_t n, struct local_series *const out[])
{
    jet_pair integral[JET_SIZE];

    integrate(g, i, order, integral);
    for (size_t l = 0; l < n; l++) {
        struct local_series *u = out[l];
        u->converges[i] = g->rate[i][0][l] == 0.0;
        for (size_t k = 0; k <= order; k++)
            u->integral[i][k] = u->converges[i] ? integral[k][l] : 0.0;
        if (u->converges[i])
            local_integral_floor(order, g->ind[1][l] / u->unit, u->integral[i]);
    }
}

void LOCAL_BUILD(const struct planar *const sys[], const struct carry *carry,
                 size_t order, size_t n, const struct local_seed seed[],
                 struct local_series *const out[])
{
    struct building g;

    g.carry = carry;
    set_seed(&g, sys, seed, n);
    build(&g, order);
    for (size_t l = 0; l < n; l++) {
        out[l]->ind = seed[l].ind;
        out[l]->order = order;
        out[l]->unit = seed[l].unit;
        jet_take(order, g.c, l, out[l]->c);
    }
    for (size_t i = 0; i < carry->count; i++)
        take_integral(&g, i, order, n, out);
}
