#include "proof_end.h"

#include "proof_flow.h"
#include "proof_short.h"
#include "proof_tolerance.h"

static const char no_rule[] =
    "a function of the law has no rule for boxes without end";
static const char too_large[] =
    "the bound on what is beyond the last piece is not finite";

/* A box of offsets and, over it, the slopes of mu, g = dy/dt and of their
 * logarithms. */
struct strip {
    struct interval at[2];
    struct interval mu[2], mu_rate[2], rate[2];
    struct growth g, g_by;
};

/* m = |mu - tan(alpha)| at the place, on its side: a bound from below. */
static struct interval force_at(struct proof_law *p,
                                const struct proof_place *at)
{
    const struct interval change = interval_tape_change(&p->tape, at->X, at->Y);

    return at->side > 0 ? change : interval_minus(change);
}

/* mu does not fall with v, nor with psi, on the strip: m does not fall on the
 * way outward.  What is not so, or NULL. */
static const char *look_along(struct proof_law *p, int endless, struct strip *s)
{
    struct interval_growth *w = p->growth;
    const int variable[] = { p->graph->x, p->graph->y };

    for (int i = 0; i < 2; i++) {
        const int by = i == 0 ? 1 - endless : endless; /* this one is kept */
        if (!interval_growth_run(w, &p->state, variable, s->at, by))
            return no_rule;
        s->mu[by] = w->by[p->graph->node[LAW_AT_MU]].all;
        s->mu_rate[by] = w->rate[p->graph->node[LAW_AT_MU]].all;
        s->rate[by] = w->rate[p->graph->node[LAW_AT_DY]].all;
    }
    s->g = w->value[p->graph->node[LAW_AT_DY]];
    s->g_by = w->by[p->graph->node[LAW_AT_DY]];
    return !(s->mu[0].lo >= 0)
               ? "beyond the last piece mu is not proved to rise with v"
           : !(s->mu[1].lo >= 0)
               ? "beyond the last piece mu is not proved to rise with psi"
               : NULL;
}

/* |g| on an edge of the strip, where y does not move inward. */
static const char *look_at_edge(struct proof_law *p,
                                const struct interval at[2], int side,
                                struct interval *g)
{
    const int variable[] = { p->graph->x, p->graph->y };

    if (!interval_growth_run(p->growth, &p->state, variable, at, 0))
        return no_rule;
    *g = p->growth->value[p->graph->node[LAW_AT_DY]].all;
    if (side > 0)
        *g = interval_minus(*g);
    return g->lo >= 0 ? NULL : "psi is not proved to move outward";
}

/* [z, z + w] outward of the coordinate that settles, and all beyond of the
 * other. */
static struct interval outward(struct interval z, int side, double w)
{
    return side > 0 ? (struct interval){ z.lo, add(z, point(w)).hi }
                    : (struct interval){ interval_less(z, point(w)).lo, z.hi };
}

static struct interval beyond(struct interval z, int side)
{
    return side > 0 ? (struct interval){ z.lo, HUGE_VAL }
                    : (struct interval){ -HUGE_VAL, z.hi };
}

/* A bound w on the way holds if on a strip that is so wide the way is less. */
typedef const char *tail_way(struct proof_law *p, const struct proof_place *at,
                             double w, struct proof_tail *out);

static const char *settle(struct proof_law *p, const struct proof_place *at,
                          double most, tail_way *way, struct proof_tail *out)
{
    double w = 0;

    if (!(force_at(p, at).lo > 0))
        return "mu - tan(alpha) has no sign where the last piece ends";
    for (int i = 0; i < PROOF_END_TRIES && w < most; i++) {
        const char *why = way(p, at, w, out);
        if (why)
            return why;
        if (out->way < w)
            return NULL;
        w = 2 * out->way + PROOF_END_LEAST;
    }
    return "no bound on what is beyond the last piece was found";
}

/* ---- psi runs to its end ------------------------------------------------- */

/* With d ln|g|/dy >= q outward and |g| >= g1 where it begins, |g| >= g1 e^(q t)
 * t on; m <= m1 + A w + B t: |dx| <= F/v (m1 + A w + B/q)/(q g1). */
static const char *psi_way(struct proof_law *p, const struct proof_place *at,
                           double w, struct proof_tail *out)
{
    const struct interval x = at->X, y = at->Y;
    struct strip s = { .at = { outward(x, at->side, w), beyond(y, at->side) } };
    const struct interval edge[] = { s.at[0], y };
    struct interval g;
    const char *why = look_along(p, 1, &s);

    if (why == NULL)
        why = look_at_edge(p, edge, at->side, &g);
    if (why)
        return why;
    const long double q = at->side > 0 ? s.rate[1].lo : -s.rate[1].hi;
    if (!(q > 0))
        return "the rate of psi is not proved to grow beyond the last piece";
    const struct interval under = times(point(q), interval_low(g));
    const struct interval per =
        times(p->force,
              interval_exp(interval_minus(interval_low(add(p->x, s.at[0])))));
    const struct interval m =
        add(interval_high(force_at(p, at)),
            add(times(interval_high(s.mu[0]), point(w)),
                interval_divide(interval_high(s.mu[1]), point(q))));
    const struct interval change = interval_expm1(s.at[0]);

    out->way = interval_up(interval_divide(times(per, m), under).hi);
    out->excess =
        interval_up(interval_most(interval_divide(times(p->v, change), under)));
    out->slope = interval_divide(times(per, m), interval_low(g)).hi < 1 ? 1 : 0;
    return isfinite(out->way) && isfinite(out->excess) ? NULL : too_large;
}

const char *proof_tail_psi(struct proof_law *p, const struct proof_place *at,
                           double most, struct proof_tail *out)
{
    return settle(p, at, most, psi_way, out);
}

/* ---- v = 0 --------------------------------------------------------------- */

/* dt = -v dx/(F m): the time is at most v1/(F m1).  With d ln(v g)/dx >= q > 0,
 * v g <= v1 g(x1, y) e^(q (x - x1)), so that |dy| <= v1 g(x1, y)/(q F m1); with
 * 0 <= g <= G, |dy| <= v1 G/(F m1). */
static const char *v_way(struct proof_law *p, const struct proof_place *at,
                         double w, struct proof_tail *out)
{
    const struct interval x = at->X, y = at->Y;
    struct strip s = { .at = { beyond(x, -1), outward(y, -1, w) } };
    const struct interval edge[] = { interval_high(x), s.at[1] };
    struct interval g;
    const char *why = look_along(p, 0, &s);

    if (why == NULL)
        why = look_at_edge(p, edge, -1, &g);
    if (why)
        return why;
    const struct interval q = add(point(1), interval_low(s.rate[0]));
    const struct interval time =
        interval_divide(interval_exp(interval_high(add(p->x, x))),
                        times(p->force, interval_low(force_at(p, at))));
    const struct interval change = interval_expm1(s.at[0]);
    const long double by_value = s.g.all.lo >= 0 ? s.g.all.hi : HUGE_VAL;
    const long double by_rate =
        q.lo > 0 ? interval_divide(interval_high(g), interval_low(q)).hi
                 : HUGE_VAL;

    if (!isfinite(fminl(by_value, by_rate)))
        return "v dpsi/dt is not proved to vanish as v does";
    out->way = interval_up(times(point(fminl(by_value, by_rate)), time).hi);
    out->excess = interval_up(interval_most(times(times(p->v, change), time)));
    out->slope =
        times(point(fminl(by_value, q.lo > 0 ? g.hi : HUGE_VALL)), time).hi < 1
            ? -1
            : 0;
    return isfinite(out->way) && isfinite(out->excess) ? NULL : too_large;
}

const char *proof_tail_v(struct proof_law *p, const struct proof_place *at,
                         double most, struct proof_tail *out)
{
    return at->side > 0 ? "the upper branch does not go to v = 0"
                        : settle(p, at, most, v_way, out);
}

/* ---- open ---------------------------------------------------------------- */

/* No bound of g, or of its slope by y, grows with y, whatever v is. */
static bool is_level(struct growth u)
{
    return interval_is_finite(u.c) && u.power[1] <= 0 &&
           !(u.slope[1] < 0 || u.slope[1] > 0);
}

const char *proof_tail_open(struct proof_law *p, const struct proof_place *at)
{
    struct strip s = { .at = { beyond(at->X, 1), beyond(at->Y, 1) } };

    if (!(force_at(p, at).lo > 0))
        return "mu - tan(alpha) is not proved positive";
    const char *why = look_along(p, 1, &s);
    if (why)
        return why;
    if (!(s.g.all.hi < 0))
        return "psi is not proved to move outward";
    return is_level(s.g) || is_level(s.g_by)
               ? NULL
               : "the rate of psi is not proved to grow no faster than ln psi";
}

/* d ln m/dx or d ln m/dy <= the slope of mu over m1, and that of ln mu times
 * mu/m <= 1 + max(tan(alpha), 0)/m1. */
static struct interval rise_of(const struct proof_law *p, const struct strip *s,
                               int by, struct interval m1)
{
    const struct interval level = point(fmaxl(p->tan_alpha.hi, 0));
    const struct interval slope = interval_divide(s->mu[by], m1);
    const struct interval rate =
        times(s->mu_rate[by], add(point(1), interval_divide(level, m1)));

    return point(fminl(slope.hi, rate.hi));
}

/* dy/dx = v |g|/(F m), the derivative of whose logarithm by x is at least 1 +
 * r_x + r_y - d ln m/dx - d ln m/dy where it is 1: it does not fall through 1.
 */
bool proof_tail_steep(struct proof_law *p, const struct proof_place *at)
{
    struct strip s = { .at = { beyond(at->X, 1), beyond(at->Y, 1) } };
    const struct interval m = interval_low(force_at(p, at));
    struct proof_flow f;

    if (!(m.lo > 0) || look_along(p, 1, &s))
        return false;
    proof_flow_aside(&p->tape, 0, at->X, at->Y, &f);
    const struct interval rise = interval_less(
        add(point(1), add(interval_low(s.rate[0]), interval_low(s.rate[1]))),
        add(rise_of(p, &s, 0, m), rise_of(p, &s, 1, m)));
    return interval_divide(f.dep.c[0], f.ind.c[0]).lo > 1 && rise.lo > 0;
}
