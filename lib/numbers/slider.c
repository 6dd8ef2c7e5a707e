/* Each steady state is classified with the anchor on it, where its differences
 * cancel nowhere; the last anchor is the saddle's. */
#include "slider.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "numbers_tolerance.h"
#include "place.h"

static struct planar anchor_at(struct slider *s, long double x,
                               bool equilibrium)
{
    block_anchor(&s->block, x, equilibrium);
    return block_planar(&s->block);
}

/* The index of a saddle, else the first. */
static size_t home_among(const struct equilibrium e[], size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (e[i].type == EQUILIBRIUM_SADDLE)
            return i;
    return 0;
}

/* Where one saddle has all others as nodes beside it. */
static bool has_one_saddle(const struct steady_root root[], size_t n)
{
    size_t saddles = 0;

    for (size_t i = 0; i < n; i++)
        saddles += root[i].fold ? 2 : root[i].rises;
    return saddles == 1;
}

/* Looks at those that rise or do not; returns the last. */
static size_t look_at(struct slider *s, struct steady_root root[], size_t n,
                      bool rises, struct equilibrium e[])
{
    size_t at = n;

    for (size_t i = n; i-- > 0;)
        if (root[i].rises == rises) {
            equilibrium_close(&s->block.steady, &s->block, &root[i]);
            const struct planar system = anchor_at(s, root[i].x, true);
            equilibrium_at(&system, root[i].fold, &e[i]);
            s->steady[i] = numbers_steady(&s->block, &e[i]);
            at = i;
        }
    return at;
}

/* A saddle comes last. */
static void place(struct slider *s, struct steady_root root[], size_t n,
                  struct equilibrium e[])
{
    const size_t node = look_at(s, root, n, false, e);
    const size_t saddle = look_at(s, root, n, true, e);
    const size_t last = saddle < n ? saddle : node;

    if (n == 0)
        (void) anchor_at(s, fminl(0.0L, s->block.steady.hi - 1.0L), false);
    else if (home_among(e, n) != last)
        (void) anchor_at(s, root[home_among(e, n)].x, true);
}

/* The saddle alone, if it is one. */
static bool place_saddle(struct slider *s, struct steady_root root[], size_t n,
                         struct equilibrium e[])
{
    if (!has_one_saddle(root, n))
        return false;
    for (size_t i = 0; i < n; i++)
        e[i] = (struct equilibrium){ .type = EQUILIBRIUM_STABLE_NODE };
    return e[look_at(s, root, n, true, e)].type == EQUILIBRIUM_SADDLE;
}

static void init(struct slider *s, bool nodes)
{
    struct steady_root root[EQUILIBRIA_MAX];
    struct equilibrium e[EQUILIBRIA_MAX];
    const size_t n = equilibrium_bracket(&s->block.steady, &s->block, root);

    if (nodes || !place_saddle(s, root, n, e))
        place(s, root, n, e);
    const struct planar system = block_planar(&s->block);
    if (nodes && n > 0) {
        const struct vec2 off = place_bars(&s->block);
        s->place = off.x + off.y;
    } else {
        s->place = 0.0;
    }
    s->plane = phase_plane_of(&system, e, n);
    block_ask(&s->block);
    const char *none = slider_no_manifolds(s);
    s->critical = numbers_none(none ? none : "nobody asked");
}

void slider_init(struct slider *s, const struct law *law,
                 const struct material *m, long double tan_alpha)
{
    block_init(&s->block, law, m, tan_alpha);
    init(s, true);
}

void slider_init_saddle(struct slider *s, const struct law *law,
                        const struct material *m, long double tan_alpha)
{
    block_init(&s->block, law, m, tan_alpha);
    init(s, false);
}

enum status slider_check(const struct slider *s, struct fault *why)
{
    for (size_t i = 0; i < s->plane.equilibria; i++) {
        const double *scaled = s->plane.equilibrium[i].scaled;
        if (!isnan(scaled[0]) && !isnan(scaled[1]))
            continue;
        return fault_set(
            why, STATUS_NOT_HYPERBOLIC,
            "the law has no slope at its steady state v = %g, psi = %g: a "
            "formula has no real value there",
            s->steady[i].v.value, s->steady[i].psi.value);
    }
    return STATUS_OK;
}

bool slider_has_manifolds(const struct slider *s)
{
    return slider_no_manifolds(s) == NULL;
}

const char *slider_no_manifolds(const struct slider *s)
{
    const struct equilibrium *saddle = phase_plane_saddle(&s->plane);

    if (saddle == NULL)
        return "there is no saddle at this slope";
    if (equilibrium_is_beyond(saddle))
        return "the saddle's eigenvalues are further apart than doubles can "
               "tell";
    if (!box_holds(s->plane.system.domain, saddle->z))
        return "the saddle's psi is beyond the plane's range";
    return NULL;
}

const char *slider_no_traps(const struct slider *s)
{
    if (s->plane.saddles == 0 || slider_traps(s))
        return NULL;
    return s->plane.saddles > 1
               ? "there are several saddles: the sides of one do not tell"
               : "the law lets states leave both quadrants of the saddle: its "
                 "sides do not tell";
}

double slider_energy_defect(const struct slider *s, const struct curve *c)
{
    double first[CURVE_DIM_MAX], last[CURVE_DIM_MAX];
    const size_t slip = 3 + BLOCK_SLIP, work = 3 + BLOCK_WORK;

    curve_at(c, 0, 0.0, first);
    curve_at(c, c->count - 1, 1.0, last);
    return block_energy_defect(
        &s->block, block_v(&s->block, first[0]), block_v(&s->block, last[0]),
        last[slip] - first[slip], last[work] - first[work]);
}

double slider_rounding(const struct slider *s, struct vec2 z)
{
    const struct vec2 o = s->plane.system.origin;

    return s->place + TOL_ROUNDING * (fabs(o.x) + fabs(o.y) + fabs(o.x + z.x) +
                                      fabs(o.y + z.y));
}

struct quantity slider_mean_friction(const struct slider *s, double v0,
                                     double v1, double v1_part,
                                     const struct quantity *slip)
{
    const double t = (double) s->block.tan_alpha, digits = 4.0 * DBL_EPSILON;
    const double per =
        0.5 * material_eps2(&s->block.material) * hypot(1.0, t) / slip->value;
    const double lost = per * (v0 - v1) * (v0 + v1);
    const double known = slip->value - slip->error;

    return quantity_of(
        t + lost,
        fabs(lost) * slip->error / known +
            per * (digits * v0 * v0 + (digits + 2.0 * v1_part) * v1 * v1) +
            digits * (t + fabs(lost)));
}
