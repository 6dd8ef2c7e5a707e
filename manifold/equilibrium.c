/* Equilibria from the system's own steady curve: the balance is monotone
 * between turning points, so a sign change brackets exactly one root. */
#include "equilibrium.h"

#include <float.h>
#include <math.h>

#include "newton.h"

const char *const equilibrium_type_names[] = { "saddle",      "stable_node",
                                               "saddle_node", "unstable_node",
                                               "focus",       NULL };

/* Next to a fold the balance all but vanishes at one end of the bracket, where
 * secants crawl: newton.h bisects in time. */
void equilibrium_close(const struct planar_steady *s, const void *ctx,
                       struct steady_root *root)
{
    struct newton_root_long found;

    if (root->hi > root->x &&
        newton_close_long(s->balance, ctx,
                          (const long double[]){ root->x, root->hi }, root->at,
                          &found) == STATUS_OK)
        root->x = found.x;
    root->hi = root->x;
}

size_t equilibrium_bracket(const struct planar_steady *s, const void *ctx,
                           struct steady_root root[EQUILIBRIA_MAX])
{
    long double lo = s->lo, at_lo = s->balance(ctx, lo);
    size_t n = 0;

    for (size_t i = 0; i <= s->turnings; i++) {
        const bool last = i == s->turnings;
        if (!last && !(s->turning[i] > s->lo && s->turning[i] < s->hi))
            continue;
        const long double hi = last ? s->hi : s->turning[i];
        const long double at_hi = s->balance(ctx, hi);
        if (at_hi == 0 && !last)
            root[n++] = (struct steady_root){ hi, true, false, hi, { 0, 0 } };
        else if (at_lo != 0 && (at_lo < 0) != (at_hi < 0))
            root[n++] = (struct steady_root){
                lo, false, at_lo < 0, hi, { at_lo, at_hi }
            };
        lo = hi;
        at_lo = at_hi;
    }
    return n;
}

size_t equilibrium_find(const struct planar_steady *s, const void *ctx,
                        struct steady_root root[EQUILIBRIA_MAX])
{
    const size_t n = equilibrium_bracket(s, ctx, root);

    for (size_t i = 0; i < n; i++)
        equilibrium_close(s, ctx, &root[i]);
    return n;
}

/* Whether the balance rises along the steady curve, as it does at a saddle. */
static bool balance_rises(const struct planar *sys)
{
    const long double x = (long double) sys->origin.x, hi = sys->steady->hi;
    const long double h = x < hi ? fminl(1e-6L, (hi - x) / 2) : 1e-6L;

    return sys->steady->balance(sys->ctx, x - h) <
           sys->steady->balance(sys->ctx, fminl(x + h, hi));
}

/* An eigenvalue that is no fold's zero is one that left the doubles; both may.
 */
static enum equilibrium_type type_of(const struct planar *sys,
                                     const struct eigen2 *e, bool fold)
{
    if (fold)
        return EQUILIBRIUM_SADDLE_NODE;
    if (e->re[0] <= 0.0 && fabs(e->re[1]) < DBL_MIN && sys->steady)
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
