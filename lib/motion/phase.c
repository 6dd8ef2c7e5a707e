#include "phase.h"

#include <math.h>

#include "motion_tolerance.h"
#include "transient.h"

const struct record_type record_phase = RECORD(
    phase, "phase", "phases of sliding, section 4.4",
    FIELD(phase, QUANTITY, start_time, "L/V_star",
          "time of its start in units of L/V_star"),
    FIELD(phase, QUANTITY, end_time, "L/V_star",
          "time of its end in units of L/V_star"),
    FIELD(phase, QUANTITY, start_slip, "L", "slip at its start in units of L"),
    FIELD(phase, QUANTITY, end_slip, "L", "slip at its end in units of L"));

/* A moment between two phases. */
struct border {
    struct quantity time, slip;
};

static struct border at_event(const struct transient_event *e)
{
    return (struct border){ e->time, e->slip };
}

static struct phase between(struct border from, struct border to)
{
    return (struct phase){ from.time, to.time, from.slip, to.slip };
}

static struct phase none(const char *why)
{
    const struct quantity q = quantity_none(why);

    return (struct phase){ q, q, q, q };
}

static double nearness(const struct slider *s)
{
    return TOL_ARREST * (double) s->block.tan_alpha;
}

/* The first event of this kind, at this level if it is one of nearness, after
 * event number `from`; t->events if there is none. */
static size_t find(const struct slider *s, const struct transient *t,
                   enum moment what, size_t from)
{
    size_t i = from;

    while (i < t->events &&
           !(t->event[i].what == (int8_t) what &&
             (what == MOMENT_V_MINUS || t->event[i].level == nearness(s))))
        i++;
    return i;
}

/* Whether the run starts where phase 2 (phase 3) would take place. */
static bool starts_near(const struct slider *s, const struct transient *t)
{
    return fabs(moment_excess_friction(s, curve_point(&t->curve, 0, 0.0))) <=
           nearness(s);
}

static bool starts_below(const struct slider *s, const struct transient *t)
{
    const struct quantity *ln_v = &s->critical.ln_v_minus;

    return quantity_exists(ln_v) && log(t->sum.v) < ln_v->value;
}

static const char *why_no_third(const struct slider *s)
{
    return quantity_exists(&s->critical.ln_v_minus)
               ? "v does not fall below v_minus"
               : "there is no v_minus";
}

void phase_find(const struct slider *s, const struct transient *t,
                struct phase out[PHASES])
{
    const struct quantity zero = quantity_of(0.0, 0.0);
    const struct border start = { zero, zero };
    const struct border end = { t->sum.time, t->sum.slip };

    out[0] = out[1] = out[2] =
        none(t->reason ? t->reason : "the run has no length");
    if (t->curve.count == 0)
        return;
    const bool near = starts_near(s, t), below = starts_below(s, t);
    const size_t reach = near ? 0 : find(s, t, MOMENT_MU_NEARS, 0);
    const size_t fall = below ? 0 : find(s, t, MOMENT_V_MINUS, 0);
    const size_t leave = find(s, t, MOMENT_MU_LEAVES, reach);
    const struct border on = near                ? start
                             : reach < t->events ? at_event(&t->event[reach])
                                                 : end;
    const struct border third = below              ? start
                                : fall < t->events ? at_event(&t->event[fall])
                                                   : end;
    const bool falls = below || fall < t->events;
    const bool direct = falls && !(third.time.value > on.time.value);

    out[0] = below  ? none("it starts below v_minus")
             : near ? none("it starts on the v-nullcline")
                    : between(start, direct ? third : on);
    if (direct || below)
        out[1] = none(below ? "it starts below v_minus"
                            : "v falls below v_minus first");
    else if (!near && reach == t->events)
        out[1] = none("friction does not come near tan(alpha)");
    else if (!falls && leave < t->events)
        out[1] = between(on, at_event(&t->event[leave]));
    else
        out[1] = between(on, third);
    out[2] = falls ? between(third, end) : none(why_no_third(s));
}
