/* Candidates: the R2 sequence (Roberts 2018: u_k = u_0 + k (1/p, 1/p^2) mod 1,
 * p^3 = p + 1) inside, the golden one around the edge.  Choice: farthest point
 * first, as for evenly spaced streamlines (Mebarki, Alliez & Devillers, IEEE
 * Visualization 2005), by distances to samples of what is drawn. */
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

#define SLANT 0.1 /* sine of the least angle with the frame */

static double fraction(double x)
{
    return x - floor(x);
}

static void add(struct spread *s, enum spread_place place, struct vec2 unit)
{
    s->candidate[place][s->count[place]++] =
        (struct spread_candidate){ window_at(s->window, unit), unit, INFINITY };
}

/* Around the square once: 0 <= p < 4, a side for each unit. */
static struct vec2 around(double p, struct vec2 *inward)
{
    const double t = fraction(p);

    switch ((int) p) {
        case 0:
            *inward = (struct vec2){ 0.0, 1.0 };
            return (struct vec2){ t, 0.0 };
        case 1:
            *inward = (struct vec2){ -1.0, 0.0 };
            return (struct vec2){ 1.0, t };
        case 2:
            *inward = (struct vec2){ 0.0, -1.0 };
            return (struct vec2){ 1.0 - t, 1.0 };
        default:
            *inward = (struct vec2){ 1.0, 0.0 };
            return (struct vec2){ 0.0, 1.0 - t };
    }
}

/* Whether an orbit from the edge enters at an angle that can be seen; one that
 * runs along the frame is no picture. */
static bool flows(const struct planar *system, const struct window *w,
                  struct vec2 z, struct vec2 inward)
{
    struct planar_field f;

    system->field(system->ctx, vec2_sub(z, system->origin), &f);
    const struct vec2 d = window_push(w, z, f.direction);
    return d.x * inward.x + d.y * inward.y > SLANT * vec2_length(d);
}

static void list(struct spread *s, const struct planar *system, size_t count,
                 uint64_t seed)
{
    const double p = 1.3247179572447460, golden = 0.6180339887498949;
    const double x = uniform(&seed), y = uniform(&seed), q = uniform(&seed);

    for (size_t k = 0; k < count; k++) {
        const double n = (double) k;
        const struct vec2 unit = { fraction(x + n / p),
                                   fraction(y + n / (p * p)) };
        struct vec2 inward;
        const struct vec2 edge =
            around(4.0 * fraction(q + n * golden), &inward);
        add(s, SPREAD_INTERIOR, unit);
        if (flows(system, s->window, window_at(s->window, edge), inward))
            add(s, SPREAD_EDGE, edge);
    }
}

enum status spread_init(struct spread *s, const struct planar *system,
                        const struct window *window, size_t count,
                        uint64_t seed)
{
    *s = (struct spread){ .window = window };
    for (int k = 0; k < SPREAD_PLACES; k++) {
        s->candidate[k] = calloc(count + 1, sizeof *s->candidate[k]);
        if (s->candidate[k] == NULL) {
            spread_free(s);
            return STATUS_NO_MEMORY;
        }
    }
    list(s, system, count, seed);
    return STATUS_OK;
}

static void avoid_point(struct spread *s, struct vec2 unit)
{
    for (int k = 0; k < SPREAD_PLACES; k++)
        for (size_t i = 0; i < s->count[k]; i++) {
            struct spread_candidate *c = &s->candidate[k][i];
            const struct vec2 d = vec2_sub(c->unit, unit);
            const double gap = d.x * d.x + d.y * d.y;
            c->gap = gap < c->gap ? gap : c->gap;
        }
}

bool spread_take(struct spread *s, enum spread_place place, struct vec2 *z)
{
    struct spread_candidate *c = s->candidate[place];
    size_t best = 0;

    if (s->count[place] == 0)
        return false;
    for (size_t i = 1; i < s->count[place]; i++)
        if (c[i].gap > c[best].gap)
            best = i;
    const struct spread_candidate chosen = c[best];
    c[best] = c[--s->count[place]];
    avoid_point(s, chosen.unit);
    *z = chosen.z;
    return true;
}

static struct vec2 unit_at(const struct spread *s, const struct curve *c,
                           size_t piece, double theta, struct vec2 origin)
{
    double u[CURVE_DIM_MAX];

    curve_at(c, piece, theta, u);
    return window_unit(s->window,
                       vec2_add(origin, (struct vec2){ u[0], u[1] }));
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

void spread_free(struct spread *s)
{
    for (int k = 0; k < SPREAD_PLACES; k++)
        free(s->candidate[k]);
    *s = (struct spread){ .window = NULL };
}
