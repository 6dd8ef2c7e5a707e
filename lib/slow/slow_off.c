/* Each step's error is known to a part of it, whichever sign that has: what is
 * not known adds up like deviations, as in drift.h. */
#include "slow_off.h"

#include <math.h>

#include "tolerance.h"

/* Components of the orbit, slip being its first observable. */
enum { TIME = 2, SLIP };

struct slow_off slow_off_gained(struct drift *d, struct slow_off late,
                                struct slow_off *was)
{
    const struct slow_off before = *was;

    if (!isfinite(late.time + late.slip))
        late = before;
    *was = late;
    return (struct slow_off){
        drift_gained(d, TIME) + late.time - before.time,
        drift_gained(d, SLIP) + late.slip - before.slip,
    };
}

void slow_sum_add(struct slow_sum *sum, struct slow_off gained)
{
    struct slow_off *const u = &sum->unsure;

    sum->off.time += gained.time;
    sum->off.slip += gained.slip;
    u->time = hypot(u->time, TOL_DRIFT_UNSURE * gained.time);
    u->slip = hypot(u->slip, TOL_DRIFT_UNSURE * gained.slip);
}

static double bar_of(double off, double unsure)
{
    return TOL_BAR_FIRST_ORDER * fabs(off) + TOL_DRIFT_NOISE * unsure;
}

struct slow_off slow_sum_bar(const struct slow_sum *sum)
{
    return (struct slow_off){ bar_of(sum->off.time, sum->unsure.time),
                              bar_of(sum->off.slip, sum->unsure.slip) };
}
