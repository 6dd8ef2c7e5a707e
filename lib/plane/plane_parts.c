/* A quadtree of boxes tells which cells are of one kind; cells are joined as
 * patches are (plane_patch.c), to the one that comes first. */
#include "plane_parts.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "plane_defined.h"
#include "plane_tolerance.h"

struct survey {
    const struct patches *p;
    struct plane_parts *out;
    uint8_t *kind; /* owned; enum interval_domain by cell */
};

static struct vec2 corner(const struct survey *v, double i, double j)
{
    const double n = (double) v->out->n;

    return window_at(&v->p->s->window, (struct vec2){ i / n, j / n });
}

/* The kinds of size^2 cells. */
static void survey_kinds(struct survey *v, size_t i, size_t j, size_t size)
{
    const struct plane_study *s = v->p->s;
    const enum interval_domain kind = plane_defined_domain(
        s->plan, s,
        (struct box){ corner(v, (double) i, (double) j),
                      corner(v, (double) (i + size), (double) (j + size)) });

    if (kind == INTERVAL_PARTLY && size > 1) {
        for (size_t k = 0; k < 4; k++)
            survey_kinds(v, i + k % 2 * (size / 2), j + k / 2 * (size / 2),
                         size / 2);
        return;
    }
    for (size_t k = 0; k < size * size; k++)
        v->kind[(j + k / size) * v->out->n + i + k % size] = (uint8_t) kind;
}

/* The patches of the cells of a row, by their middles. */
static void survey_row(struct survey *v, size_t j)
{
    const struct regions *r = v->p->r;
    struct crossing *c = v->p->below;
    const double y = corner(v, 0.0, (double) j + 0.5).y;
    const size_t n = separatrix_row(r->separatrix, y, c);
    const struct band *band = regions_band(r, y);

    for (size_t i = 0, k = 0; i < v->out->n; i++) {
        while (k < n && corner(v, (double) i + 0.5, 0.0).x >= c[k].at)
            k++;
        v->out->patch[j * v->out->n + i] =
            n == band->strands ? plane_patch_of(v->p, band->first + k)
                               : r->count;
    }
}

/* ---- joined -------------------------------------------------------------- */

static size_t first_of(const struct plane_parts *p, size_t cell)
{
    while (p->part[cell] != cell) {
        p->part[cell] = p->part[p->part[cell]];
        cell = p->part[cell];
    }
    return cell;
}

static void join(struct survey *v, size_t a, size_t b)
{
    struct plane_parts *out = v->out;
    const size_t i = first_of(out, a), j = first_of(out, b),
                 none = out->n * out->n;

    if (i < none && j < none && v->kind[a] == v->kind[b] &&
        out->patch[a] == out->patch[b])
        out->part[i > j ? i : j] = i > j ? j : i;
}

static void join_all(struct survey *v)
{
    struct plane_parts *out = v->out;
    const size_t n = out->n;

    out->part[n * n] = n * n;
    for (size_t k = 0; k < n * n; k++)
        out->part[k] =
            v->kind[k] == INTERVAL_PARTLY || out->patch[k] == v->p->r->count
                ? n * n
                : k;
    for (size_t k = 0; k < n * n; k++) {
        if (k % n > 0)
            join(v, k, k - 1);
        if (k >= n)
            join(v, k, k - n);
    }
    for (size_t k = 0; k < n * n; k++)
        out->part[k] = first_of(out, k);
}

/* ---- of patches ---------------------------------------------------------- */

/* longest, first: room by cell. */
static void find_middles(struct plane_parts *p, size_t longest[])
{
    const size_t n = p->n;

    for (size_t k = 0, end; k < n * n; k = end) {
        for (end = k + 1; end % n > 0 && p->part[end] == p->part[k];)
            end++;
        if (p->part[k] == n * n || end - k <= longest[p->part[k]])
            continue;
        longest[p->part[k]] = end - k;
        p->middle[p->part[k]] = k + (end - k) / 2;
    }
}

/* first: room by patch. */
static void find_several(struct plane_parts *p, size_t first[])
{
    for (size_t k = 0; k < p->n * p->n; k++) {
        if (p->part[k] != k)
            continue;
        p->several[p->patch[k]] = first[p->patch[k]] > 0;
        first[p->patch[k]]++;
    }
}

enum status plane_parts_find(const struct patches *p, struct plane_parts *out)
{
    const size_t n = p->s->broken ? (size_t) (1.0 / TOL_PLANE_CELL) : 0,
                 cells = n * n, regions = p->r->count + 1;
    struct survey v = { p, out, malloc(cells + 1) };
    size_t *longest = calloc(cells + 1, sizeof *longest),
           *first = calloc(regions, sizeof *first);

    *out = (struct plane_parts){ n, malloc((cells + 1) * sizeof(size_t)),
                                 malloc((cells + 1) * sizeof(size_t)),
                                 malloc((cells + 1) * sizeof(size_t)),
                                 calloc(regions, sizeof(bool)) };
    const bool room = v.kind && longest && first && out->part && out->patch &&
                      out->middle && out->several;
    if (room && n > 0) {
        survey_kinds(&v, 0, 0, n);
        for (size_t j = 0; j < n; j++)
            survey_row(&v, j);
        join_all(&v);
        find_middles(out, longest);
        find_several(out, first);
    }
    free(v.kind);
    free(longest);
    free(first);
    if (!room)
        plane_parts_free(out);
    return room ? STATUS_OK : STATUS_NO_MEMORY;
}

/* ---- answers ------------------------------------------------------------- */

bool plane_parts_place(const struct plane_parts *p, const struct plane_study *s,
                       size_t cell, struct vec2 *z)
{
    const double n = (double) p->n;

    if (p->part[cell] != cell || !p->several[p->patch[cell]])
        return false;
    const size_t at = p->middle[cell];
    *z = window_at(&s->window,
                   (struct vec2){ ((double) (at % p->n) + 0.5) / n,
                                  ((double) (at / p->n) + 0.5) / n });
    return true;
}

/* The cells from one part of the window to another, of n. */
static void cells_between(size_t n, double lo, double hi, size_t cell[2])
{
    const double most = (double) n - 1.0;

    cell[0] = (size_t) fmin(fmax(floor(lo * (double) n), 0.0), most);
    cell[1] = (size_t) fmin(fmax(floor(hi * (double) n), 0.0), most);
}

bool plane_parts_divide(const struct plane_parts *p,
                        const struct plane_study *s, size_t patch, struct box b)
{
    const struct vec2 lo = window_unit(&s->window, b.lo),
                      hi = window_unit(&s->window, b.hi);
    size_t i[2], j[2], known = p->n * p->n;

    if (p->n == 0 || !p->several[patch])
        return false;
    cells_between(p->n, lo.x, hi.x, i);
    cells_between(p->n, lo.y, hi.y, j);
    for (size_t y = j[0]; y <= j[1]; y++)
        for (size_t x = i[0]; x <= i[1]; x++) {
            const size_t cell = y * p->n + x, part = p->part[cell];
            if (part == p->n * p->n || p->patch[cell] != patch)
                continue;
            if (known < p->n * p->n && known != part)
                return true;
            known = part;
        }
    return false;
}

void plane_parts_free(struct plane_parts *p)
{
    free(p->part);
    free(p->patch);
    free(p->middle);
    free(p->several);
    *p = (struct plane_parts){ .n = 0 };
}
