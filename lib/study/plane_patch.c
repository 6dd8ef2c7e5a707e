#include "plane_patch.h"

#include <math.h>

#include "study_tolerance.h"

size_t plane_patch_of(const struct patches *p, size_t i)
{
    while (p->of[i] != i)
        i = p->of[i];
    return i;
}

static void join(struct patches *p, size_t i, size_t j)
{
    const size_t a = plane_patch_of(p, i), b = plane_patch_of(p, j);

    p->of[a > b ? a : b] = a > b ? b : a;
}

/* The left and the right end of region k between n crossings, in the window. */
double plane_patch_end(const struct plane_study *s, const struct crossing c[],
                       size_t n, size_t k)
{
    const struct box w = s->window.box;

    if (k == 0)
        return w.lo.x;
    return k > n ? w.hi.x : fmin(fmax(c[k - 1].at, w.lo.x), w.hi.x);
}

/* How much between two places is open from a row to another just above it. */
static double open_part(const struct separatrix *c, double row, double next,
                        double left, double right)
{
    double part = right - left;

    for (size_t i = 0; i < c->flats; i++)
        if (c->flat[i].w >= row && c->flat[i].w <= next)
            part -= fmax(
                fmin(right, c->flat[i].to) - fmax(left, c->flat[i].from), 0.0);
    return part;
}

/* Regions of two bands that meet. */
static void join_bands(struct patches *p, const struct band *lower,
                       const struct band *upper)
{
    const struct separatrix *c = p->r->separatrix;
    const double least = TOL_PLANE_DOOR * p->s->scale.side.x;
    const size_t m =
        separatrix_row(c, nextafter(lower->hi, -HUGE_VAL), p->below);
    const size_t n = separatrix_row(c, upper->lo, p->above);

    if (m != lower->strands || n != upper->strands)
        return; /* as thin as rounding */
    for (size_t k = 0, j = 0; k <= m && j <= n;) {
        const double below = plane_patch_end(p->s, p->below, m, k + 1);
        const double above = plane_patch_end(p->s, p->above, n, j + 1);
        const double left = fmax(plane_patch_end(p->s, p->below, m, k),
                                 plane_patch_end(p->s, p->above, n, j));
        if (open_part(c, lower->hi, upper->lo, left, fmin(below, above)) >
            least)
            join(p, lower->first + k, upper->first + j);
        k += below <= above;
        j += above <= below;
    }
}

/* Thin bands are none: a curve ends before what it goes to. */
bool plane_patch_is_door(const struct plane_study *s, const struct band *band)
{
    const struct box w = s->window.box;

    return fmin(band->hi, w.hi.y) - fmax(band->lo, w.lo.y) >
           TOL_PLANE_DOOR * s->scale.side.y;
}

void plane_patch_join(struct patches *p)
{
    const struct band *last = NULL;

    for (size_t i = 0; i < p->r->count; i++)
        p->of[i] = i;
    for (size_t i = 0; i < p->r->bands; i++) {
        const struct band *band = &p->r->band[i];
        if (!plane_patch_is_door(p->s, band))
            continue;
        if (last)
            join_bands(p, last, band);
        last = band;
    }
}
