/* Regions of neighbouring bands that share a part of the row between them are
 * one: only whole patches are labelled, by the orbits from inside of their
 * largest regions. */
#include "plane_label.h"

#include <math.h>

#include "plane_basin.h"
#include "plane_border.h"
#include "plane_branch.h"

/* This far from the left to the right of region k of a band, on the row where
 * it is widest of some; false: it is nowhere wide. */
static bool inside_of(const struct patches *p, const struct band *band,
                      size_t k, double part, struct vec2 *z)
{
    enum { ROWS = 16 };
    const struct box w = p->s->window.box;
    const double from = fmax(band->lo, w.lo.y), to = fmin(band->hi, w.hi.y);
    double widest = 0.0;

    for (int i = 0; i < ROWS; i++) {
        const double y = from + (i + 0.4871) / ROWS * (to - from);
        const size_t n = separatrix_row(p->r->separatrix, y, p->below);
        const double lo = plane_patch_end(p->s, p->below, n, k);
        const double hi = plane_patch_end(p->s, p->below, n, k + 1);
        if (n != band->strands || !(hi - lo > widest))
            continue;
        widest = hi - lo;
        *z = (struct vec2){ lo + part * (hi - lo), y };
    }
    return widest > 0.0;
}

/* Whereto a state goes; cycles that are new are added. */
static enum status follow_state(struct plane_study *s, struct vec2 z,
                                int8_t *label)
{
    struct plane_goal goal;
    enum status status = plane_follow(s, z, false, &goal);

    if (status == STATUS_OK && goal.kind == PLANE_GOAL_CYCLE)
        status = plane_cycle_add(s, &goal.round, true, &goal.index);
    *label = plane_basin_label(s, &goal);
    return status;
}

/* Whereto the inside of a region goes, from its middle; where curves that are
 * not known may divide it (plane_border.h), from all over it. */
static enum status follow_region(struct patches *p, size_t region,
                                 struct plane_study *s, int8_t *label)
{
    static const double part[] = {
        PLANE_LABEL_MIDDLE, 0.03, 0.17, 0.33, 0.67, 0.83, 0.97
    };
    const size_t n = plane_border_is_weak(s) ? sizeof part / sizeof *part : 1;
    enum status status = STATUS_OK;
    size_t i = 0;

    while (i + 1 < p->r->bands && p->r->band[i + 1].first <= region)
        i++;
    const struct band *band = &p->r->band[i];
    *label = -1;
    for (size_t k = 0; k < n && status == STATUS_OK; k++) {
        int8_t other = -1;
        struct vec2 z;
        if (inside_of(p, band, region - band->first, part[k], &z))
            status = follow_state(s, z, &other);
        *label = k == 0 || *label == other ? other : (int8_t) -1;
        if (*label < 0)
            break;
    }
    return status;
}

enum { WITNESSES = 3 };

/* The largest regions of a patch, by area. */
static size_t largest(const struct patches *p, size_t patch,
                      size_t out[WITNESSES])
{
    size_t n = 0;

    for (size_t i = patch; i < p->r->count; i++) {
        if (plane_patch_of(p, i) != patch || !(p->area[i].value > 0.0))
            continue;
        size_t k = n < WITNESSES ? n++ : WITNESSES;
        for (; k > 0 && p->area[out[k - 1]].value < p->area[i].value; k--)
            if (k < WITNESSES)
                out[k] = out[k - 1];
        if (k < WITNESSES)
            out[k] = i;
    }
    return n;
}

static enum status label_patch(struct patches *p, size_t patch,
                               struct plane_study *s)
{
    size_t witness[WITNESSES];
    const size_t n = largest(p, patch, witness);
    int8_t label = -1, other;
    enum status status = STATUS_OK;

    for (size_t k = 0; k < n && status == STATUS_OK; k++) {
        status = follow_region(p, witness[k], s, &other);
        label = k == 0 || label == other ? other : (int8_t) -1;
    }
    for (size_t i = patch; i < p->r->count; i++)
        if (plane_patch_of(p, i) == patch)
            p->r->region[i].label = label < 0 ? REGION_UNLABELLED : label;
    return status;
}

enum status plane_label_all(struct plane_study *s, struct patches *p,
                            const struct monitor *monitor)
{
    enum status status = STATUS_OK;

    plane_patch_join(p);
    for (size_t i = 0; i < p->r->count && status == STATUS_OK; i++) {
        if (p->of[i] != i)
            continue;
        if (monitor_tell(monitor, "regions", i, p->r->count))
            return STATUS_STOPPED;
        status = label_patch(p, i, s);
    }
    return status;
}
