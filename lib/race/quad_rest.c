/* Where friction balances the slope, mu(v, psi) = tan(alpha) gives v(psi), and
 * X = int_psi^inf v dpsi/(dpsi/dt), or the time without that v, by the
 * double-exponential rule for half lines (Takahasi & Mori, Publ. RIMS 9, 1974,
 * 721-741).  How far the orbit is from that balance is what inertia makes of v:
 * most at the start. */
#include "quad_rest.h"

#include <math.h>

enum { NEWTON_MAX = 60, HALVINGS = 4 };

/* Beyond these arguments the rule's weights vanish, or psi is beyond all. */
static const double first = -4.6, last = 8.5;
/* Of ln v: what the balance is solved to, and may be off at the start. */
static const double balanced = 1e-30, nearly = 1e-3;
/* What v off by a part makes of v dt/dpsi, more than that part. */
static const double more = 4.0;
/* Of the sum: what it must be known to. */
static const double known = 1e-20;

static quad excess(const struct quad_course *c, quad x, quad y)
{
    const struct block *b = &c->slope->study->slider.block;

    return quad_block_mu(&c->slope->at, x, y) - (quad) b->tan_alpha;
}

/* *x: from a guess to where friction balances the slope at y; secants, for
 * friction is all but linear in ln v. */
static bool balance(const struct quad_course *c, quad y, quad *x)
{
    quad at = *x, before = at - (quad) 1e-3, was = excess(c, before, y);

    for (int i = 0; i < NEWTON_MAX; i++) {
        const quad now = excess(c, at, y);
        const quad step = now == was ? 0 : now * (at - before) / (now - was);
        before = at;
        was = now;
        at -= step;
        if (fabsq(step) <= (quad) balanced * (1 + fabsq(at))) {
            *x = at;
            return true;
        }
    }
    return false;
}

/* dt/dY at the offset y, for slip v dt/dY; *x as in balance. */
static bool density(const struct quad_course *c, enum quad_left what, quad y,
                    quad *x, quad *out)
{
    const struct quad_anchor *at = &c->slope->at;
    struct quad_field f;

    if (!balance(c, y, x))
        return false;
    quad_block_field(at, *x, y, &f);
    const quad log_v = what == QUAD_LEFT_SLIP ? at->x0 + *x : 0;
    *out = expq(log_v - f.log_scale) / f.direction[1];
    return *out >= 0 && *out - *out == 0;
}

/* The rule with this step: Y = y + exp(s - e^-s); false where what comes last
 * still counts. */
static bool sum_up(const struct quad_course *c, enum quad_left what,
                   double step, quad *sum)
{
    const int count = (int) ((last - first) / step);
    quad x = c->u[QUAD_X], term = 0;

    *sum = 0;
    for (int i = 0; i <= count; i++) {
        const quad s = (quad) first + (quad) step * i, way = expq(s - expq(-s));
        quad rate;
        if (!density(c, what, c->u[QUAD_Y] + way, &x, &rate))
            return false;
        term = rate * way * (1 + expq(-s)) * (quad) step;
        *sum += term;
        if (term < (quad) 1e-33 * *sum && s > 1)
            return true;
    }
    return term < (quad) known * *sum;
}

bool quad_rest_left(const struct quad_course *c, enum quad_left what,
                    quad *left, quad *error)
{
    quad x = c->u[QUAD_X], before = 0, sum;
    double step = 0.25;

    if (!balance(c, c->u[QUAD_Y], &x))
        return false;
    const quad aside = fabsq(x - c->u[QUAD_X]);
    if (!(aside <= (quad) nearly))
        return false;
    for (int i = 0; i <= HALVINGS; i++, step /= 2) {
        if (!sum_up(c, what, step, &sum))
            return false;
        *left = sum;
        *error =
            ((quad) more * aside + (quad) known) * sum + fabsq(sum - before);
        if (fabsq(sum - before) <= (quad) known * sum)
            return true;
        before = sum;
    }
    return *error < sum;
}

bool quad_rest_fade(struct quad_course *c, bool has_slip)
{
    quad slip;

    if (!has_slip || !quad_rest_left(c, QUAD_LEFT_SLIP, &slip, &c->left[1])) {
        c->left[1] = HUGE_VAL;
        return false;
    }
    c->u[QUAD_SLIP] += slip;
    c->u[QUAD_WORK] += (quad) c->slope->study->slider.block.tan_alpha * slip;
    return true;
}
