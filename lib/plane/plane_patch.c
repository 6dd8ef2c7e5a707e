#include "plane_patch.h"

#include <math.h>
#include <stdlib.h>

#include "plane_defined.h"
#include "plane_tolerance.h"

size_t plane_patch_of(const struct patches *p, size_t i)
{
    while (p->of[i] != i) {
        p->of[i] = p->of[p->of[i]];
        i = p->of[i];
    }
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

/* The same, moved by what the crossing may be off there. */
static double sure_end(const struct patches *p, const struct crossing c[],
                       size_t n, size_t k, double way)
{
    const double off = k == 0 || k > n ? 0.0 : c[k - 1].error;

    return plane_patch_end(p->s, c, n, k) + way * off;
}

/* The crossings of the row at an end of a band, each with how far its curve
 * may go in the gap behind it: one that ends there flat, like |y|^(1/q), goes
 * by 1/(2^(1/q) - 1) of what it went in a gap's length before, which is below
 * TOL_PLANE_FLAT for q <= 11.  Their number. */
static size_t row_at_door(const struct patches *p, double row, double gap,
                          struct crossing out[])
{
    const size_t n = separatrix_row(p->r->separatrix, row, out);
    const size_t m = separatrix_row(p->r->separatrix, row + gap, p->before);

    for (size_t k = 0; k < n; k++)
        out[k].error += m == n
                            ? TOL_PLANE_FLAT * fabs(out[k].at - p->before[k].at)
                            : HUGE_VAL;
    return n;
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

static struct box taller(struct box b, double by)
{
    b.lo.y -= by;
    b.hi.y += by;
    return b;
}

/* Whether formulas have values in a door and about it: a curve ends before an
 * edge of theirs.  One that is shut may be so anywhere up to there. */
static bool is_open(struct patches *p, struct box door)
{
    const struct plane_study *s = p->s;
    double reach = TOL_SAME * s->scale.side.y;

    if (plane_defined_in(s->plan, s, taller(door, reach)))
        return true;
    while (reach > TOL_FAR_BELOW * TOL_ROUNDED * s->scale.side.y &&
           !plane_defined_in(s->plan, s, taller(door, 0.5 * reach)))
        reach *= 0.5;
    door = taller(door, reach);
    const struct vec2 d = vec2_sub(window_unit(&s->window, door.hi),
                                   window_unit(&s->window, door.lo));
    p->s->basin.shut += fabs(d.x * d.y);
    return false;
}

/* Regions of two bands that meet where formulas have values. */
static void join_bands(struct patches *p, const struct band *lower,
                       const struct band *upper)
{
    const struct separatrix *c = p->r->separatrix;
    const double least = TOL_SAME * p->s->scale.side.x;
    const double gap = fmax(upper->lo - lower->hi,
                            TOL_FAR_BELOW * TOL_ROUNDED * p->s->scale.side.y);
    const size_t m =
        row_at_door(p, nextafter(lower->hi, -HUGE_VAL), -gap, p->below);
    const size_t n = row_at_door(p, upper->lo, gap, p->above);

    if (m != lower->strands || n != upper->strands)
        return; /* as thin as rounding */
    for (size_t k = 0, j = 0; k <= m && j <= n;) {
        const double below = plane_patch_end(p->s, p->below, m, k + 1);
        const double above = plane_patch_end(p->s, p->above, n, j + 1);
        const double left = fmax(sure_end(p, p->below, m, k, 1.0),
                                 sure_end(p, p->above, n, j, 1.0));
        const double right = fmin(sure_end(p, p->below, m, k + 1, -1.0),
                                  sure_end(p, p->above, n, j + 1, -1.0));
        const struct box door = { { left, lower->hi }, { right, upper->lo } };
        if (open_part(c, lower->hi, upper->lo, left, right) > least &&
            !p->alone[lower->first + k] && !p->alone[upper->first + j] &&
            is_open(p, door))
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
           TOL_SAME * s->scale.side.y;
}

/* ---- where formulas have no values --------------------------------------- */

/* Where the ends of a band's regions are on some of its rows, and how much that
 * changes from one of these to the next. */
struct end_range {
    double lo, hi, last, more;
};

static void find_ranges(const struct patches *p, const struct band *band,
                        double from, double to, struct end_range out[])
{
    enum { ROWS = 4 };

    for (size_t k = 0; k <= band->strands + 1; k++)
        out[k] = (struct end_range){ HUGE_VAL, -HUGE_VAL, NAN, 0.0 };
    for (int i = 0; i < ROWS; i++) {
        const double y = from + off_middle(i, i + 1) / ROWS * (to - from);
        if (separatrix_row(p->r->separatrix, y, p->below) != band->strands)
            continue;
        for (size_t k = 0; k <= band->strands + 1; k++) {
            const double at = plane_patch_end(p->s, p->below, band->strands, k);
            out[k].lo = fmin(out[k].lo, at);
            out[k].hi = fmax(out[k].hi, at);
            out[k].more = fmax(out[k].more, fabs(at - out[k].last));
            out[k].last = at;
        }
    }
}

/* The small regions of a band, unless formulas have values in the box about
 * them; range: room for most + 2. */
static void find_alone(struct patches *p, const struct band *band, double least,
                       struct end_range range[])
{
    const struct box w = p->s->window.box;
    struct box b = { { w.lo.x, fmax(band->lo, w.lo.y) },
                     { w.hi.x, fmin(band->hi, w.hi.y) } };

    if (!(b.lo.y < b.hi.y) || plane_defined_in(p->s->plan, p->s, b))
        return;
    find_ranges(p, band, b.lo.y, b.hi.y, range);
    for (size_t k = 0; k <= band->strands; k++) {
        const struct end_range *r = &range[k];
        b.lo.x = fmax(r[0].lo - r[0].more, w.lo.x);
        b.hi.x = fmin(r[1].hi + r[1].more, w.hi.x);
        p->alone[band->first + k] = p->area[band->first + k].value < least &&
                                    b.lo.x < b.hi.x &&
                                    !plane_defined_in(p->s->plan, p->s, b);
    }
}

static enum status find_all_alone(struct patches *p)
{
    struct end_range *range = calloc(p->r->most + 2, sizeof *range);
    double all = 0.0;

    for (size_t i = 0; i < p->r->count; i++)
        all += p->area[i].value;
    for (size_t i = 0; i < p->r->bands && range; i++)
        find_alone(p, &p->r->band[i], TOL_PLANE_CELL * all, range);
    const bool room = range != NULL;
    free(range);
    return room ? STATUS_OK : STATUS_NO_MEMORY;
}

/* ---- joined -------------------------------------------------------------- */

enum status plane_patch_join(struct patches *p)
{
    const struct band *last = NULL;

    if (p->s->broken && find_all_alone(p) != STATUS_OK)
        return STATUS_NO_MEMORY;
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
    return STATUS_OK;
}

/* ---- inside ------------------------------------------------------------- */

const struct band *plane_patch_band(const struct regions *r, size_t region)
{
    size_t i = 0;

    while (i + 1 < r->bands && r->band[i + 1].first <= region)
        i++;
    return &r->band[i];
}

enum { ROWS = 16 };

int64_t plane_patch_work(const struct patches *p, int rows)
{
    return rows * (int64_t) p->r->separatrix->count / TOL_PLANE_CROSSINGS;
}

/* How wide it is in the window on row i of some, and where; 0: nowhere. */
static double width_at(const struct patches *p, size_t region, int i, double *y,
                       double *lo)
{
    const struct band *band = plane_patch_band(p->r, region);
    const size_t k = region - band->first;
    const struct box w = p->s->window.box;
    const double from = fmax(band->lo, w.lo.y), to = fmin(band->hi, w.hi.y);

    *y = from + off_middle(i, i + 1) / ROWS * (to - from);
    const size_t n = separatrix_row(p->r->separatrix, *y, p->below);
    if (n != band->strands)
        return 0.0;
    *lo = plane_patch_end(p->s, p->below, n, k);
    return fmax(plane_patch_end(p->s, p->below, n, k + 1) - *lo, 0.0);
}

bool plane_patch_place(const struct patches *p, size_t region, struct vec2 *z)
{
    double widest = 0.0, y, lo = 0.0;

    p->s->basin.steps += plane_patch_work(p, ROWS);
    for (int i = 0; i < ROWS; i++) {
        const double width = width_at(p, region, i, &y, &lo);
        if (!(width > widest))
            continue;
        widest = width;
        *z = (struct vec2){ lo + off_middle(0.0, 1.0) * width, y };
    }
    return widest > 0.0;
}

/* ---- by size ------------------------------------------------------------- */

static int by_area(const void *a, const void *b)
{
    const struct patch_whole *p = a, *q = b;

    if (p->area != q->area)
        return p->area > q->area ? -1 : 1;
    return p->patch < q->patch ? -1 : p->patch > q->patch;
}

double plane_patch_sort(const struct patches *p, struct patch_whole w[])
{
    double all = 0.0;

    for (size_t b = 0, i = 0; i < p->r->count; i++) {
        while (b + 1 < p->r->bands && p->r->band[b + 1].first <= i)
            b++;
        const double area = plane_patch_is_door(p->s, &p->r->band[b]) &&
                                    p->area[i].value > p->area[i].error
                                ? p->area[i].value
                                : 0.0;
        struct patch_whole *to = &w[plane_patch_of(p, i)];
        w[i].patch = i;
        if (to->area == 0.0 || area > p->area[to->largest].value)
            to->largest = i;
        to->area += area;
        all += area;
    }
    qsort(w, p->r->count, sizeof *w, by_area);
    return all;
}
