/* Equilibria from the system's own steady curve: the balance is monotone
 * between turning points, so a sign change brackets exactly one root, found by
 * a bracketed secant (Illinois: Dowell & Jarratt, BIT 11 (1971) 168-174). */
#include "equilibrium.h"

#include <float.h>
#include <math.h>

const char *const equilibrium_type_names[] = { "saddle",      "stable_node",
                                               "saddle_node", "unstable_node",
                                               "focus",       NULL };

struct bracket {
    long double lo, hi, at_lo, at_hi;
};

static void illinois(struct bracket *b, long double x, long double at,
                     int *side)
{
    if ((at < 0) == (b->at_lo < 0)) {
        b->lo = x;
        b->at_lo = at;
        if (*side < 0)
            b->at_hi /= 2;
        *side = -1;
    } else {
        b->hi = x;
        b->at_hi = at;
        if (*side > 0)
            b->at_lo /= 2;
        *side = 1;
    }
}

static long double root_of(const struct planar *sys, struct bracket b)
{
    int side = 0;
    long double before = b.lo;

    for (int i = 0; i < 200; i++) {
        long double x = b.hi - b.at_hi * (b.hi - b.lo) / (b.at_hi - b.at_lo);
        if (!(x > b.lo && x < b.hi) || i % 20 == 19)
            x = b.lo + (b.hi - b.lo) / 2;
        if (!(x > b.lo && x < b.hi) || x == before)
            return x;
        const long double at = sys->steady->balance(sys->ctx, x);
        if (at == 0)
            return x;
        before = x;
        illinois(&b, x, at, &side);
    }
    return b.lo;
}

size_t equilibrium_find(const struct planar *sys,
                        struct steady_root root[EQUILIBRIA_MAX])
{
    const struct planar_steady *s = sys->steady;
    struct bracket b = { .lo = s->lo, .at_lo = s->balance(sys->ctx, s->lo) };
    size_t n = 0;

    for (size_t i = 0; i <= s->turnings; i++) {
        const bool last = i == s->turnings;
        if (!last && !(s->turning[i] > s->lo && s->turning[i] < s->hi))
            continue;
        b.hi = last ? s->hi : s->turning[i];
        b.at_hi = s->balance(sys->ctx, b.hi);
        if (b.at_hi == 0 && !last)
            root[n++] = (struct steady_root){ b.hi, true };
        else if (b.at_lo != 0 && (b.at_lo < 0) != (b.at_hi < 0))
            root[n++] = (struct steady_root){ root_of(sys, b), false };
        b.lo = b.hi;
        b.at_lo = b.at_hi;
    }
    return n;
}

/* Whether the balance rises along the steady curve, as it does at a saddle. */
static bool balance_rises(const struct planar *sys)
{
    const long double x = (long double) sys->origin.x, h = 1e-6L;

    return sys->steady->balance(sys->ctx, x - h) <
           sys->steady->balance(sys->ctx, x + h);
}

/* An eigenvalue that is no fold's zero is one that left the doubles. */
static enum equilibrium_type type_of(const struct planar *sys,
                                     const struct eigen2 *e, bool fold)
{
    if (fold)
        return EQUILIBRIUM_SADDLE_NODE;
    if (e->re[0] < 0.0 && fabs(e->re[1]) < DBL_MIN && sys->steady)
        return balance_rises(sys) ? EQUILIBRIUM_SADDLE
                                  : EQUILIBRIUM_STABLE_NODE;
    if (e->im > 0.0)
        return EQUILIBRIUM_FOCUS;
    if (e->re[0] < 0.0 && e->re[1] > 0.0)
        return EQUILIBRIUM_SADDLE;
    return e->re[0] < 0.0 ? EQUILIBRIUM_STABLE_NODE : EQUILIBRIUM_UNSTABLE_NODE;
}

void equilibrium_at(const struct planar *sys, bool fold,
                    struct equilibrium *out)
{
    struct planar_jacobian J;

    sys->jacobian(sys->ctx, (struct vec2){ 0.0, 0.0 }, &J);
    struct eigen2 e = mat2_eigenvalues(J.matrix);
    if (fold)
        e.re[fabs(e.re[0]) < fabs(e.re[1]) ? 0 : 1] = 0.0;
    *out = (struct equilibrium){
        .type = type_of(sys, &e, fold),
        .z = sys->origin,
        .matrix = J.matrix,
        .scaled = { e.re[0], e.re[1] },
        .log_scale = J.field.log_scale,
    };
    for (int i = 0; i < 2; i++)
        out->lambda[i] =
            copysign(exp(log(fabs(e.re[i])) + J.field.log_scale), e.re[i]);
}

bool equilibrium_is_beyond(const struct equilibrium *e)
{
    return e->type != EQUILIBRIUM_SADDLE_NODE &&
           fmin(fabs(e->scaled[0]), fabs(e->scaled[1])) < DBL_MIN;
}
