/* Each state's whole orbit (fate.h), run at two tolerances, which must agree
 * within their bars.  Where these are more than asked for, or the fates are not
 * that of the trap (trap.h) that the state ends in, finer ones follow: beside
 * the boundary two orbits may well agree and be wrong. */
#include "cells.h"

#include <float.h>
#include <math.h>

#include "fate.h"
#include "peak.h"
#include "slider.h"
#include "slow_tolerance.h"
#include "trap.h"

const struct record_field cell_fields[] = {
    FIELD_CODE(cell, exit_reason, fate_names,
               "where the orbit of the state ends"),
    FIELD(cell, REAL, slip, "L", "slip to arrest in units of L"),
    FIELD(cell, REAL, slip_error, "L", "bound on the error of slip"),
    FIELD(cell, REAL, time, "L/V_star", "time to arrest in units of L/V_star"),
    FIELD(cell, REAL, time_error, "L/V_star", "bound on the error of time"),
    FIELD(cell, REAL, mu_mean, "1", "mean friction over that slip"),
    FIELD(cell, REAL, mu_mean_error, "1", "bound on the error of mu_mean"),
    FIELD(cell, REAL, v_peak, "V_star",
          "largest slip rate before arrest in units of V_star"),
    FIELD(cell, REAL, v_peak_error, "V_star", "bound on the error of v_peak"),
    FIELD(cell, REAL, mu_peak, "1", "largest friction before arrest"),
    FIELD(cell, REAL, mu_peak_error, "1", "bound on the error of mu_peak"),
};
const struct record_type record_cell =
    RECORD_TYPE("cell", "how a state comes to arrest", cell_fields, cell);

static const unsigned peaks = 1u << CELL_V_PEAK | 1u << CELL_MU_PEAK;

const struct cell cell_unknown = { FATE_UNDECIDED, (double) NAN, (double) NAN,
                                   (double) NAN,   (double) NAN, (double) NAN,
                                   (double) NAN,   (double) NAN, (double) NAN,
                                   (double) NAN,   (double) NAN };

/* One orbit at one tolerance. */
struct run {
    enum fate fate;
    struct quantity of[CELL_FIELDS];
};

static void take_peaks(const struct peaks *p, struct run *r)
{
    const double v = exp(p->x);
    const char *why = r->fate == FATE_RUNAWAY     ? fate_runs_away
                      : r->fate == FATE_UNDECIDED ? "the fate is undecided"
                                                  : NULL;

    r->of[CELL_V_PEAK] =
        why ? quantity_none(why)
            : quantity_of(v, v * (expm1(p->x_error) + DBL_EPSILON));
    if (why == NULL && r->fate == FATE_REST_FINITE)
        why = "friction grows without bound";
    if (why == NULL && r->fate == FATE_REST_ASYMPTOTIC && !p->whole)
        why = "the orbit could not be followed to an end";
    r->of[CELL_MU_PEAK] =
        why ? quantity_none(why) : quantity_of(p->mu, p->mu_error);
}

static enum status follow(const struct slider *s, struct vec2 z, double rtol,
                          unsigned which, struct run *r)
{
    struct fate_result found;
    struct peaks p;
    enum status status = fate_find(s, z, rtol, which != 0, NULL, &found);

    if (status != STATUS_OK)
        return status;
    r->fate = found.fate;
    r->of[CELL_SLIP] = found.slip;
    r->of[CELL_TIME] = found.time;
    r->of[CELL_MU_MEAN] = found.mu_mean;
    if (which & peaks)
        status = peaks_find(s, z, rtol, found.steps, &p);
    if ((which & peaks) && status == STATUS_OK)
        take_peaks(&p, r);
    return status;
}

/* Fills the cell from two runs to the same fate; the largest error, relative.
 */
static double fill(const struct run *coarse, const struct run *fine,
                   unsigned which, struct cell *out)
{
    double *const to[CELL_FIELDS][2] = {
        [CELL_SLIP] = { &out->slip, &out->slip_error },
        [CELL_TIME] = { &out->time, &out->time_error },
        [CELL_MU_MEAN] = { &out->mu_mean, &out->mu_mean_error },
        [CELL_V_PEAK] = { &out->v_peak, &out->v_peak_error },
        [CELL_MU_PEAK] = { &out->mu_peak, &out->mu_peak_error },
    };
    double worst = 0.0;

    out->exit_reason = (int8_t) fine->fate;
    for (int k = 0; k < CELL_FIELDS; k++) {
        const struct quantity q =
            which >> k & 1u ? fate_compare(&coarse->of[k], &fine->of[k])
                            : quantity_none("nobody asked");
        *to[k][0] = q.value;
        *to[k][1] = q.error;
        if (q.error > worst * fabs(q.value))
            worst = q.value == 0.0 ? HUGE_VAL : q.error / fabs(q.value);
    }
    return worst;
}

/* Whether it was followed to its end: what arrests takes some time, and one
 * whose time is known to no more than itself says nothing of another's. */
static bool is_whole(const struct run *r)
{
    const struct quantity *time = &r->of[CELL_TIME];

    return r->fate != FATE_UNDECIDED &&
           (r->fate == FATE_RUNAWAY || r->fate == FATE_REST_ASYMPTOTIC ||
            (quantity_exists(time) && time->error <= time->value));
}

/* `label`: the fate as another method tells it, or FATE_UNDECIDED. */
static bool agree(const struct run *coarse, const struct run *fine,
                  int8_t label)
{
    const bool told = label != FATE_UNDECIDED;

    return fine->fate == coarse->fate &&
           !(told && (int8_t) fine->fate != label);
}

/* Ends where finer runs would change nothing: those before were good enough, no
 * worse, or these cannot be followed, twice or once others agreed. */
static enum status find(const struct trap *t, struct vec2 z, double rtol,
                        unsigned which, struct cell *out)
{
    const struct slider *s = t->slider;
    const double loosest = fmin(TOL_PART * rtol, TOL_COARSEST);
    double tol = fmax(loosest, TOL_RTOL_DEFAULT / TOL_FINER);
    double worst = HUGE_VAL, before = HUGE_VAL;
    struct run coarse, fine;
    int8_t label = FATE_UNDECIDED;
    enum status status = follow(s, z, tol, which, &coarse);

    *out = cell_unknown;
    if (status == STATUS_OK && t->set)
        status =
            trap_label(t, vec2_sub(z, s->plane.system.origin), &label, NULL);
    while (status == STATUS_OK && worst > rtol &&
           !(worst > TOL_CELLS_GAIN * before) &&
           tol * TOL_FINER >= TOL_RTOL_DEFAULT) {
        tol *= TOL_FINER;
        before = worst;
        status = follow(s, z, tol, which, &fine);
        if (status != STATUS_OK)
            break;
        if (!is_whole(&fine) &&
            (isfinite(worst) ||
             (fine.fate == FATE_UNDECIDED && coarse.fate == FATE_UNDECIDED)))
            break;
        *out = cell_unknown;
        worst = agree(&coarse, &fine, label) ? fill(&coarse, &fine, which, out)
                                             : HUGE_VAL;
        if (!is_whole(&coarse) || !is_whole(&fine))
            worst = HUGE_VAL;
        before = isfinite(worst) ? before : HUGE_VAL;
        coarse = fine;
    }
    return status;
}

enum status cells_find(const struct slider *s, const struct vec2 z[], size_t n,
                       double rtol, unsigned which, const struct monitor *m,
                       struct cell out[])
{
    enum { BLOCK = 256 };
    struct trap trap;

    if (!(rtol > 0.0 && rtol < 1.0))
        return STATUS_BAD_ARGUMENT;
    for (size_t i = 0; i < n; i++)
        if (!box_holds(s->plane.system.domain, z[i]))
            return STATUS_BAD_ARGUMENT;
    enum status failed = STATUS_OK;

    trap_init(&trap, s);
    for (size_t first = 0; first < n && failed == STATUS_OK; first += BLOCK) {
        const size_t end = n - first < BLOCK ? n : first + BLOCK;
#pragma omp parallel for schedule(dynamic)
        for (size_t i = first; i < end; i++) {
            const enum status status = find(&trap, z[i], rtol, which, &out[i]);
            if (status != STATUS_OK) {
#pragma omp atomic write
                failed = status;
            }
        }
        if (failed == STATUS_OK && monitor_tell(m, "cells", end, n))
            failed = STATUS_STOPPED;
    }
    return failed;
}
