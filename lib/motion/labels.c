/* Along a row the sides alternate from one crossing to the next; the row of a
 * state above the saddle begins on the slow side, for there the slow quadrant
 * reaches to v = 0, and one below it ends on the fast side. */
#include "labels.h"

#include <math.h>

#include "grow.h"
#include "motion_tolerance.h"
#include "rest_form.h"
#include "slider.h"

/* ---- the curve ----------------------------------------------------------- */

static enum status grow_stable(struct labels *l, double rtol,
                               const struct monitor *monitor)
{
    const struct slider *s = l->slider;
    struct grow_options o = grow_defaults(rtol);
    struct local_series u;

    o.reach = &s->plane.system.domain;
    o.monitor = monitor;
    const enum status status = local_at(
        &s->plane.system, phase_plane_saddle(&s->plane), MANIFOLD_STABLE,
        &o.carry, o.order, TOL_TAYLOR_STEP * o.rtol, &u);
    return status == STATUS_OK
               ? grow_branches(&s->plane.system, &u, &o, l->stable)
               : status;
}

/* How far a state may be from the saddle, in the chart, and read as the doubles
 * that its place is told in or those next to them: off by dx and dy it is off a
 * curve of slope s by dy + |s| dx in its column, <= dx + dy where |s| <= 1, and
 * as in its row where not. */
static double slack_of(const struct slider *s)
{
    const struct steady_number *saddle = &s->steady[slider_saddle(s)];
    const struct quantity *v = &saddle->v;
    const struct quantity *psi = &saddle->psi;
    const double scale = s->plane.system.axis[1].is_log ? psi->value : 1.0;
    const double dv = v->error + 2.0 * TOL_ROUNDING * v->value;
    const double dpsi = psi->error + 2.0 * TOL_ROUNDING * fabs(psi->value);

    return dv / v->value + dpsi / scale;
}

/* ---- sides --------------------------------------------------------------- */

/* Whether a branch ended where nothing of it is left to come: at a limit, or
 * where v leaves the domain. */
static bool is_complete(const struct labels *l, const struct branch *b)
{
    const struct box d = l->slider->plane.system.domain;
    const double x = l->slider->plane.system.origin.x + b->limit.x;
    const double edge = fmin(x - d.lo.x, d.hi.x - x);

    return b->end == BRANCH_LIMIT_X || b->end == BRANCH_LIMIT_Y ||
           (b->end == BRANCH_DOMAIN && edge <= TOL_SAME);
}

/* Whether a row is beyond an end from which the curve may go on. */
static bool is_beyond(const struct labels *l, double y)
{
    for (int i = 0; i < 2; i++) {
        const struct branch *b = &l->stable[i];
        const bool above = b->limit.y > 0.0;
        if (b->curve.count > 0 && !is_complete(l, b) &&
            (above ? y >= b->limit.y : y <= b->limit.y))
            return true;
    }
    return false;
}

/* Whether rounding has a curve cross a row of the band in a quadrant that none
 * enters (trap.h). */
static bool strays(const struct labels *l, const struct band *band)
{
    const struct separatrix *s = &l->along[SEPARATRIX_Y];
    const double y = 0.5 * (band->lo + band->hi);

    for (size_t i = 0; i < s->count && isfinite(y); i++)
        if (y >= s->strand[i].lo && y < s->strand[i].hi &&
            separatrix_cross(s, i, y).at * y < 0.0)
            return true;
    return false;
}

static void label_band(struct labels *l, const struct band *band)
{
    const struct slider *s = l->slider;
    struct region *region = &l->regions.region[band->first];
    const size_t n = band->strands;
    const bool below = band->hi <= 0.0, above = band->lo >= 0.0;

    if (is_beyond(l, 0.5 * (band->lo + band->hi)) ||
        (!below && !above && n % 2 == 0) || strays(l, band))
        return;
    for (size_t k = 0; k <= n; k++) {
        const bool slow = below ? (n - k) % 2 == 1 : k % 2 == 0;
        region[k].label = (int8_t) fate_of_side(s, slow);
    }
}

static void label_all(struct labels *l)
{
    const struct slider *s = l->slider;
    const enum fate all = fate_of_all(s);

    if (slider_no_traps(s))
        for (size_t i = 0; i < l->regions.bands; i++)
            for (size_t k = 0; k <= l->regions.band[i].strands; k++)
                l->regions.region[l->regions.band[i].first + k].label =
                    FATE_UNDECIDED;
    else if (slider_has_manifolds(s))
        for (size_t i = 0; i < l->regions.bands; i++)
            label_band(l, &l->regions.band[i]);
    else if (slider_saddle(s) < 0 && all != FATE_UNDECIDED)
        l->regions.region[0].label = (int8_t) all;
}

/* By l->stable, if there is a manifold; lent ones only cross rows. */
static enum status divide(struct labels *l)
{
    const struct slider *s = l->slider;
    const bool cut = slider_has_manifolds(s);
    enum status status = STATUS_OK;

    for (int i = 0; i < 2; i++)
        l->along[i] = separatrix_empty(i, (struct vec2){ 0.0, 0.0 });
    for (int i = l->lent ? SEPARATRIX_Y : SEPARATRIX_X;
         i < 2 && status == STATUS_OK && cut; i++) {
        l->along[i].slack = slack_of(s);
        status = separatrix_add(&l->along[i], &l->stable[0], &l->stable[1]);
    }
    if (status == STATUS_OK)
        status = regions_init(&l->regions, &l->along[SEPARATRIX_Y]);
    if (status == STATUS_OK)
        label_all(l);
    else
        labels_free(l);
    return status;
}

enum status labels_init(struct labels *l, const struct slider *s, double rtol,
                        const struct monitor *monitor)
{
    *l = (struct labels){ .slider = s };
    const enum status status =
        slider_has_manifolds(s) ? grow_stable(l, rtol, monitor) : STATUS_OK;

    return status == STATUS_OK ? divide(l) : status;
}

/* Beyond the last point; an asymptote along rows is none that they cross. */
static void widen_end(struct branch *b)
{
    double last[CURVE_DIM_MAX];

    if (b->curve.count == 0)
        return;
    curve_at(&b->curve, b->curve.count - 1, 1.0, last);
    b->error.x += fabs(b->limit.x - last[0]);
    b->limit.y = last[1];
    if (b->end == BRANCH_LIMIT_Y)
        b->end = BRANCH_STEPS;
}

enum status labels_lend(struct labels *l, const struct slider *s,
                        const struct branch stable[2])
{
    *l = (struct labels){ .slider = s, .lent = true };
    for (int i = 0; i < 2; i++) {
        l->stable[i] = stable[i];
        widen_end(&l->stable[i]);
    }
    return divide(l);
}

void labels_free(struct labels *l)
{
    regions_free(&l->regions);
    for (int i = 0; i < 2; i++) {
        separatrix_free(&l->along[i]);
        if (!l->lent)
            branch_free(&l->stable[i]);
    }
}

/* ---- states -------------------------------------------------------------- */

static bool meets(const struct separatrix *s, double w, double at)
{
    double lo, hi;

    for (size_t i = 0; i < s->count; i++)
        if (separatrix_near(s, i, w, &lo, &hi) && at >= lo && at <= hi)
            return true;
    return false;
}

/* The slow quadrant is above a column of the saddle's slow side, the fast one
 * below one of its fast side; from there the sides alternate. */
static enum fate fate_in_column(const struct labels *l, struct vec2 z)
{
    const struct separatrix *s = &l->along[SEPARATRIX_X];
    const bool below = z.x > 0.0;
    bool slow = !below;

    for (size_t i = 0; i < s->count; i++)
        if (z.x >= s->strand[i].lo && z.x < s->strand[i].hi &&
            (separatrix_cross(s, i, z.x).at < z.y) == below)
            slow = !slow;
    return fate_of_side(l->slider, slow);
}

static size_t region_at(const struct labels *l, struct vec2 z)
{
    const struct separatrix *s = &l->along[SEPARATRIX_Y];
    const struct band *band = regions_band(&l->regions, z.y);
    size_t left = 0;

    for (size_t i = 0; i < s->count; i++)
        if (z.y >= s->strand[i].lo && z.y < s->strand[i].hi)
            left += z.x >= separatrix_cross(s, i, z.y).at;
    return band->first + left;
}

/* Where the curve runs along a row it may meet it far away, with the bar that
 * it has there, and rounding may have it cross none: the column tells then. */
static bool column_tells(const struct labels *l, struct vec2 z, int8_t row)
{
    const struct separatrix *s = &l->along[SEPARATRIX_X];

    return s->count > 0 && row != FATE_UNDECIDED && !meets(s, z.x, z.y) &&
           !is_beyond(l, z.y) &&
           (row == REGION_UNLABELLED ||
            meets(&l->along[SEPARATRIX_Y], z.y, z.x));
}

/* The quadrants tell as far as the saddle is known. */
static int8_t label_of_quadrant(const struct slider *s, struct vec2 z)
{
    const double slack = slider_traps(s) ? slack_of(s) : HUGE_VAL;

    if (z.x < -slack && z.y > slack)
        return (int8_t) fate_of_side(s, true);
    if (z.x > slack && z.y < -slack)
        return (int8_t) fate_of_side(s, false);
    return REGION_UNLABELLED;
}

static enum status ask_orbit(const struct labels *l, struct vec2 z,
                             const struct monitor *monitor,
                             struct fate_told *out)
{
    const struct box d = l->slider->plane.system.domain;
    struct vec2 at = vec2_add(l->slider->plane.system.origin, z);
    struct fate_result r;

    at.x = fmin(fmax(at.x, d.lo.x), d.hi.x); /* rounding at the edge */
    at.y = fmin(fmax(at.y, d.lo.y), d.hi.y);
    const enum status s =
        fate_find(l->slider, at, TOL_ORBIT_RTOL, false, monitor, &r);

    if (s == STATUS_OK)
        *out = (struct fate_told){ (int8_t) r.fate, r.reason, false };
    return s;
}

enum status labels_find(const struct labels *l, struct vec2 z,
                        const struct monitor *monitor, struct fate_told *out)
{
    static const char near[] =
        "the state is nearer the separatrix than its error bar";
    const char *none = slider_no_traps(l->slider);
    const char *slow = none ? none : rest_form_at(&l->slider->block).reason;
    int8_t fate = l->regions.region[region_at(l, z)].label;

    if (meets(&l->along[SEPARATRIX_Y], z.y, z.x) &&
        meets(&l->along[SEPARATRIX_X], z.x, z.y)) {
        *out = (struct fate_told){ FATE_UNDECIDED, near, true };
        return STATUS_OK;
    }
    if (column_tells(l, z, fate))
        fate = (int8_t) fate_in_column(l, z);
    if (fate == REGION_UNLABELLED)
        fate = label_of_quadrant(l->slider, z);
    if (fate == REGION_UNLABELLED)
        return ask_orbit(l, z, monitor, out);
    *out =
        (struct fate_told){ fate, fate == FATE_UNDECIDED ? slow : NULL, false };
    return STATUS_OK;
}

enum fate labels_side(const struct labels *l, struct vec2 z)
{
    const int8_t side = l->regions.region[region_at(l, z)].label;

    return side == REGION_UNLABELLED || meets(&l->along[SEPARATRIX_Y], z.y, z.x)
               ? FATE_UNDECIDED
               : (enum fate) side;
}

double labels_margin(const struct labels *l, struct vec2 z)
{
    const struct separatrix *s = &l->along[SEPARATRIX_Y];
    double off = HUGE_VAL;

    for (size_t i = 0; i < s->count; i++)
        if (z.y >= s->strand[i].lo && z.y < s->strand[i].hi) {
            const double to = z.x - separatrix_cross(s, i, z.y).at;
            off = fabs(to) < fabs(off) ? to : off;
        }
    return off;
}

enum status labels_find_one(const struct slider *s, struct vec2 z, double rtol,
                            const struct monitor *monitor,
                            struct fate_told *out)
{
    struct labels own;
    enum status status = labels_init(&own, s, rtol, monitor);

    if (status == STATUS_OK)
        status = labels_find(&own, z, monitor, out);
    labels_free(&own);
    return status;
}
