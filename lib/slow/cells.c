/* Each state's whole orbit (fate.h), run at two tolerances: what the finer one
 * changes bounds what it leaves, for an orbit's own error sums are no bounds.
 * Where that is more than asked for, or the fates are not that of the trap
 * (trap.h) that the state ends in, finer ones follow: beside the boundary two
 * orbits may well agree and be wrong. */
#include "cells.h"

#include <math.h>

#include "fate.h"
#include "peak.h"
#include "slider.h"
#include "slow_tolerance.h"
#include "trap.h"

const struct record_field cell_fields[] = {
    FIELD_CODE(cell, exit_reason, fate_names,
               "where the orbit of the state ends"),
    FIELD(cell, REAL, slip, "1", "slip to arrest in units of L"),
    FIELD(cell, REAL, slip_error, "1", "bound on the error of slip"),
    FIELD(cell, REAL, time, "1", "time to arrest in units of L/V_star"),
    FIELD(cell, REAL, time_error, "1", "bound on the error of time"),
    FIELD(cell, REAL, mu_mean, "1", "mean friction over that slip"),
    FIELD(cell, REAL, mu_mean_error, "1", "bound on the error of mu_mean"),
    FIELD(cell, REAL, v_peak, "1",
          "largest slip rate before arrest in units of V_star"),
    FIELD(cell, REAL, v_peak_error, "1", "bound on the error of v_peak"),
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

/* The roundings of exp, and of the coordinates that friction follows. */
static void take_peaks(const struct peaks *p, struct run *r)
{
    const double rounding = TOL_CELLS_ROUNDING * (1.0 + fabs(p->x));
    const double v = exp(p->x);
    const char *why = r->fate == FATE_RUNAWAY     ? "the block runs away"
                      : r->fate == FATE_UNDECIDED ? "the fate is undecided"
                                                  : NULL;

    r->of[CELL_V_PEAK] =
        why ? quantity_none(why) : quantity_of(v, v * rounding);
    if (why == NULL && r->fate == FATE_REST_FINITE)
        why = "friction grows without bound";
    if (why == NULL && r->fate == FATE_REST_ASYMPTOTIC && !p->whole)
        why = "the orbit could not be followed to an end";
    r->of[CELL_MU_PEAK] =
        why ? quantity_none(why) : quantity_of(p->mu, rounding);
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

/* What displacements do, by rounding and by what steps leave across the stable
 * manifold: where an orbit passes the saddle at the distance `near`, they
 * change how long it stays there by the ratio of both over lambda_plus, at the
 * saddle's slip rate and friction; if it has the time. */
static void shake(const struct slider *s, struct vec2 z, double near,
                  double tol, struct run *r)
{
    const double size = 1.0 + fabs(z.x) + fabs(z.y);
    const double part =
        (TOL_CELLS_ROUNDING * size + TOL_CELLS_ACROSS * tol) / near;
    struct quantity *slip = &r->of[CELL_SLIP], *mean = &r->of[CELL_MU_MEAN];

    if (slider_saddle(s) < 0)
        return;
    const double stay = 1.0 / fabs(phase_plane_saddle(&s->plane)->lambda[1]);
    const double way = part * fmin(stay * s->block.at.v0, slip->value);
    r->of[CELL_TIME].error += part * fmin(stay, r->of[CELL_TIME].value);
    slip->error += way;
    mean->error +=
        fabs(mean->value - (double) s->block.tan_alpha) * way / slip->value;
}

/* The finer value; the bar holds its change, its own one, and what may be left
 * of an orbit followed to this tolerance where its change is small by luck.
 * Where it changes by more than that, two may be near each other by chance. */
static struct quantity compare(const struct quantity *coarse,
                               const struct quantity *fine, double tol)
{
    if (!quantity_exists(coarse) || !quantity_exists(fine))
        return quantity_none("only at one tolerance");
    const double change = fabs(fine->value - coarse->value);
    const double least = TOL_CELLS_LEAST * tol * fabs(fine->value);
    return quantity_of(fine->value,
                       change + fine->error + least +
                           TOL_CELLS_CHANCE * fmax(change - least, 0.0));
}

/* Fills the cell from two runs to the same fate, the finer one to `tol`; the
 * largest error, relative. */
static double fill(const struct run *coarse, const struct run *fine, double tol,
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
            which >> k & 1u ? compare(&coarse->of[k], &fine->of[k], tol)
                            : quantity_none("nobody asked");
        *to[k][0] = q.value;
        *to[k][1] = q.error;
        if (q.error > worst * fabs(q.value))
            worst = q.value == 0.0 ? HUGE_VAL : q.error / fabs(q.value);
    }
    return worst;
}

/* Whether it was followed to its end: what arrests takes some time. */
static bool is_whole(const struct run *r)
{
    return r->fate != FATE_UNDECIDED &&
           (r->fate == FATE_RUNAWAY || r->fate == FATE_REST_ASYMPTOTIC ||
            quantity_exists(&r->of[CELL_TIME]));
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
    const double loosest = fmin(TOL_CELLS_START * rtol, TOL_CELLS_COARSEST);
    double tol = fmax(loosest, TOL_CELLS_FINEST / TOL_CELLS_FINER);
    double worst = HUGE_VAL, before = HUGE_VAL;
    struct run coarse, fine;
    int8_t label = FATE_UNDECIDED;
    double near = HUGE_VAL;
    enum status status = follow(s, z, tol, which, &coarse);

    *out = cell_unknown;
    if (status == STATUS_OK && t->set)
        status = trap_pass(t, vec2_sub(z, s->plane.system.origin), &label,
                           &near, NULL);
    while (status == STATUS_OK && worst > rtol &&
           !(worst > TOL_CELLS_GAIN * before) &&
           tol * TOL_CELLS_FINER >= TOL_CELLS_FINEST) {
        tol *= TOL_CELLS_FINER;
        before = worst;
        status = follow(s, z, tol, which, &fine);
        if (status != STATUS_OK)
            break;
        if (!is_whole(&fine) &&
            (isfinite(worst) ||
             (fine.fate == FATE_UNDECIDED && coarse.fate == FATE_UNDECIDED)))
            break;
        shake(s, z, near, tol, &fine);
        *out = cell_unknown;
        worst = agree(&coarse, &fine, label)
                    ? fill(&coarse, &fine, tol, which, out)
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
