#include "trap.h"

#include <math.h>

#include "study.h"
#include "tolerance.h"

/* > 0 inside the slow quadrant (sign +1) or the fast one (-1). */
static double inside(struct vec2 offset, double sign)
{
    return fmin(-sign * offset.x, sign * offset.y);
}

static double enters_slow(const void *ctx, double s, const double u[])
{
    (void) ctx, (void) s;
    return inside((struct vec2){ u[0], u[1] }, 1.0);
}

static double enters_fast(const void *ctx, double s, const double u[])
{
    (void) ctx, (void) s;
    return inside((struct vec2){ u[0], u[1] }, -1.0);
}

static const struct event entries[TRAPS] = {
    { .value = enters_slow, .direction = 1, .stop = true },
    { .value = enters_fast, .direction = 1, .stop = true },
};

enum status trap_init(struct trap *t, const struct study *s,
                      const struct monitor *monitor)
{
    enum status status = STATUS_OK;

    *t = (struct trap){ .study = s, .set = s->saddle >= 0 };
    for (int i = 0; i < TRAPS && t->set && status == STATUS_OK; i++) {
        const double step = i == 0 ? -TOL_TRAP_START : TOL_TRAP_START;
        const struct vec2 z = { s->system.origin.x + step,
                                s->system.origin.y - step };
        struct fate_result r;
        status = fate_find(s, z, TOL_TRAP_RTOL, false, monitor, &r);
        t->fate[i] = (int8_t) r.fate;
    }
    return status;
}

/* Follows z until it is caught; *far: how far from the saddle, in units of
 * the tolerance; NaN where it is caught nowhere. */
static enum status follow(const struct trap *t, struct vec2 z, double rtol,
                          int8_t *label, double *far, size_t *evaluations)
{
    const struct study *s = t->study;
    struct orbit_options options = orbit_defaults(&s->system, s->stable_rate);
    struct orbit o;

    options.rtol = rtol;
    options.observables = 0;
    options.event = entries;
    options.events = TRAPS;
    enum status status = orbit_init(&o, &s->system, z, &options);
    if (status != STATUS_OK)
        return status;
    status = orbit_run(&o, NULL);
    *far = NAN;
    if (status == STATUS_OK && o.end == ORBIT_EVENT) {
        *label = t->fate[o.end_index];
        *far = fmax(fabs(o.u[0]), fabs(o.u[1])) / rtol;
    }
    if (evaluations)
        *evaluations += o.field_calls + o.jacobian_calls;
    orbit_free(&o);
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

static enum status to_the_end(const struct trap *t, struct vec2 z,
                              int8_t *label, size_t *evaluations)
{
    struct fate_result r;
    const enum status s =
        fate_find(t->study, z, TOL_TRAP_RTOL, false, NULL, &r);

    *label = (int8_t) r.fate;
    if (evaluations)
        *evaluations += r.field_evaluations;
    return s;
}

enum status trap_label(const struct trap *t, struct vec2 z, int8_t *label,
                       size_t *evaluations)
{
    const struct vec2 offset = vec2_sub(z, t->study->system.origin);

    if (!t->set)
        return to_the_end(t, z, label, evaluations);
    for (int i = 0; i < TRAPS; i++)
        if (inside(offset, i == 0 ? 1.0 : -1.0) > 0.0) {
            *label = t->fate[i];
            return STATUS_OK;
        }
    for (double rtol = TOL_TRAP_RTOL; rtol >= TOL_TRAP_FINEST;
         rtol *= TOL_TRAP_FINER) {
        double far;
        const enum status s = follow(t, offset, rtol, label, &far, evaluations);
        if (s != STATUS_OK || far >= TOL_TRAP_FAR)
            return s;
    }
    return STATUS_OK;
}
