#include "proof_trap.h"

#include "proof_flow.h"
#include "proof_short.h"
#include "proof_tolerance.h"

static struct interval square(struct interval u)
{
    const struct interval most = point(interval_most(u));
    const struct interval least = point(interval_least(u));

    return (struct interval){ times(least, least).lo, times(most, most).hi };
}

/* xx yy - xy^2 */
static struct interval determinant(struct interval xx, struct interval xy,
                                   struct interval yy)
{
    return interval_less(times(xx, yy), square(xy));
}

/* The box of the ellipse: |x - x0|^2 <= level Q_yy/det Q, likewise y; there is
 * none if Q < 0. */
static bool box_of(const struct proof_trap *p, struct interval box[2])
{
    const struct interval xx = point(p->xx), yy = point(p->yy);
    const struct interval det = determinant(xx, point(p->xy), yy);

    if (!(det.lo > 0))
        return false;
    for (int i = 0; i < 2; i++) {
        const struct interval part = interval_divide(i == 0 ? yy : xx, det);
        const long double half = interval_sqrt(times(point(p->level), part)).hi;
        box[i] = add(p->at[i], interval_within(half));
    }
    return interval_is_finite(box[0]) && interval_is_finite(box[1]);
}

/* Q A + A'Q > 0 by its entry xx and its determinant. */
static bool falls(struct interval_tape *t, const struct proof_trap *p)
{
    const struct interval two = point(2), xx = point(p->xx), xy = point(p->xy);
    const struct interval yy = point(p->yy);
    struct interval box[2];
    struct proof_flow j[2];

    if (!box_of(p, box))
        return false;
    proof_flow_slopes(t, 0, box[0], box[1], j);
    const struct interval fx_x = j[0].ind.c[1], fx_y = j[1].ind.c[1];
    const struct interval fy_x = j[0].dep.c[1], fy_y = j[1].dep.c[1];
    const struct interval sxx =
        times(two, add(times(xx, fx_x), times(xy, fy_x)));
    const struct interval syy =
        times(two, add(times(xy, fx_y), times(yy, fy_y)));
    const struct interval sxy =
        add(add(times(xx, fx_y), times(yy, fy_x)), times(xy, add(fx_x, fy_y)));

    return sxx.lo > 0 && determinant(sxx, sxy, syy).lo > 0;
}

bool proof_trap_verify(struct interval_tape *t, struct proof_trap *trap)
{
    for (int i = 0; i < PROOF_TRAP_TRIES; i++) {
        if (falls(t, trap))
            return true;
        trap->level *= PROOF_TRAP_SHRINK;
    }
    return false;
}

bool proof_trap_holds(const struct proof_trap *trap, const struct interval z[2])
{
    const struct interval x = interval_less(z[0], trap->at[0]);
    const struct interval y = interval_less(z[1], trap->at[1]);
    const struct interval v =
        add(add(times(point(trap->xx), square(x)),
                times(point(trap->yy), square(y))),
            times(times(point(2), point(trap->xy)), times(x, y)));

    return v.hi <= trap->level;
}
