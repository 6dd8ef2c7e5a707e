/* Candidates: the R2 sequence (Roberts 2018: u_k = u_0 + k (1/p, 1/p^2) mod 1,
 * p^3 = p + 1).  Choice: farthest point first, as for evenly spaced streamlines
 * (Mebarki, Alliez & Devillers, IEEE Visualization 2005), by distances to
 * samples of what is drawn (Jobard & Lefer, Visualization in Scientific
 * Computing 1997, 43-55).  Changed: the frame counts as what is drawn. */
#include "spread.h"

#include <math.h>
#include <stdlib.h>

#include "tolerance.h"

/* splitmix64: Steele, Lea & Flood, OOPSLA 2014.  Uniform in [0, 1). */
static double uniform(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);

    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double) ((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static double fraction(double x)
{
    return x - floor(x);
}

/* The square of the distance to the mirror image beyond the frame. */
static double mirror_gap(struct vec2 u)
{
    const double d = 2.0 * fmin(fmin(u.x, 1.0 - u.x), fmin(u.y, 1.0 - u.y));

    return d * d;
}

enum status spread_init(struct spread *s, const struct window *window,
                        size_t count, uint64_t seed)
{
    const double p = 1.3247179572447460;
    const double x = uniform(&seed), y = uniform(&seed);

    *s = (struct spread){ .window = window };
    s->candidate = calloc(count + 1, sizeof *s->candidate);
    if (s->candidate == NULL)
        return STATUS_NO_MEMORY;
    for (size_t k = 0; k < count; k++) {
        const double n = (double) k;
        const struct vec2 u = { fraction(x + n / p),
                                fraction(y + n / (p * p)) };
        s->candidate[s->count++] =
            (struct spread_candidate){ u, mirror_gap(u) };
    }
    return STATUS_OK;
}

static void avoid_point(struct spread *s, struct vec2 unit)
{
    for (size_t i = 0; i < s->count; i++) {
        struct spread_candidate *c = &s->candidate[i];
        const struct vec2 d = vec2_sub(c->unit, unit);
        const double gap = d.x * d.x + d.y * d.y;
        c->gap = gap < c->gap ? gap : c->gap;
    }
}

bool spread_take(struct spread *s, struct vec2 *z)
{
    struct spread_candidate *c = s->candidate;
    size_t best = 0;

    if (s->count == 0)
        return false;
    for (size_t i = 1; i < s->count; i++)
        if (c[i].gap > c[best].gap)
            best = i;
    const struct vec2 chosen = c[best].unit;
    c[best] = c[--s->count];
    avoid_point(s, chosen);
    *z = window_at(s->window, chosen);
    return true;
}

static struct vec2 unit_at(const struct spread *s, const struct curve *c,
                           size_t piece, double theta, struct vec2 origin)
{
    return window_unit(s->window,
                       vec2_add(origin, curve_point(c, piece, theta)));
}

void spread_avoid(struct spread *s, const struct curve *c, struct vec2 origin)
{
    struct vec2 last = { INFINITY, INFINITY };

    for (size_t k = 0; k < c->count; k++) {
        const struct vec2 a = unit_at(s, c, k, 0.0, origin);
        const struct vec2 b = unit_at(s, c, k, 1.0, origin);
        const double length = fmin(vec2_length(vec2_sub(b, a)), 2.0);
        const size_t n = 1 + (size_t) (length / TOL_PORTRAIT_SPACING);
        for (size_t i = 0; i <= n; i++) {
            const struct vec2 u =
                unit_at(s, c, k, (double) i / (double) n, origin);
            if (vec2_length(vec2_sub(u, last)) < TOL_PORTRAIT_SPACING / 2.0)
                continue;
            avoid_point(s, u);
            last = u;
        }
    }
}

void spread_avoid_way(struct spread *s, const struct polyline *way)
{
    for (size_t k = 0; k + 1 < way->count; k++) {
        const struct vec2 d = vec2_sub(way->at[k + 1], way->at[k]);
        const size_t n = 1 + (size_t) (vec2_length(d) / TOL_PORTRAIT_SPACING);
        for (size_t i = 0; i < n; i++)
            avoid_point(s, vec2_add(way->at[k],
                                    vec2_scale((double) i / (double) n, d)));
    }
}

void spread_free(struct spread *s)
{
    free(s->candidate);
    *s = (struct spread){ .window = NULL };
}
