/* The plane is moved so that the equilibrium is the origin; what rounding
 * leaves of the rates there is taken off everywhere, so that they vanish. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "api.h"
#include "api_form.h"
#include "grow.h"
#include "tolerance.h"

struct slipway_plane {
    struct slipway_form form;
    struct box window;
    slipway_rest *rest; /* owned; ascending */
    size_t rests;
};

/* ---- equilibria ---------------------------------------------------------- */

enum { GRID = 32, NEWTON = 50 };

static struct vec2 solve(struct mat2 A, struct vec2 b)
{
    const double det = mat2_det(A);

    return (struct vec2){ (A.yy * b.x - A.xy * b.y) / det,
                          (A.xx * b.y - A.yx * b.x) / det };
}

/* Newton's method from z; *step: the length of its last step. */
static bool settles(const struct slipway_plane *p, struct vec2 *z, double *step)
{
    struct mat2 J;

    for (int i = 0; i < NEWTON; i++) {
        const struct vec2 f = form_rates(&p->form, *z, &J);
        const struct vec2 d = solve(J, f);
        *step = vec2_length(d);
        if (!isfinite(*step))
            return false;
        *z = vec2_sub(*z, d);
        if (*step <= 4.0 * DBL_EPSILON * (1.0 + vec2_length(*z)))
            return box_holds(p->window, *z);
    }
    return false;
}

static slipway_rest rest_at(const struct slipway_plane *p, struct vec2 z)
{
    struct mat2 J;
    const struct vec2 f = form_rates(&p->form, z, &J);
    const struct eigen2 e = mat2_eigenvalues(J);
    const double step = vec2_length(solve(J, f));
    const double unit = DBL_EPSILON * (1.0 + vec2_length(z));

    return (slipway_rest){
        z.x, z.y, 2.0 * step + unit, { e.re[0], e.re[1] }, e.im
    };
}

static bool is_known(const struct slipway_plane *p, struct vec2 z)
{
    const double near = 1e-8 * (1.0 + vec2_length(z));

    for (size_t i = 0; i < p->rests; i++)
        if (hypot(p->rest[i].x - z.x, p->rest[i].y - z.y) < near)
            return true;
    return false;
}

static int by_place(const void *a, const void *b)
{
    const slipway_rest *p = a, *q = b;

    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return (p->y > q->y) - (p->y < q->y);
}

static enum status find_rests(struct slipway_plane *p)
{
    const struct vec2 wide = vec2_sub(p->window.hi, p->window.lo);

    for (int i = 0; i < GRID * GRID; i++) {
        struct vec2 z = { p->window.lo.x + wide.x * (i % GRID + 0.5) / GRID,
                          p->window.lo.y + wide.y * (i / GRID + 0.5) / GRID };
        double step;
        if (!settles(p, &z, &step) || is_known(p, z))
            continue;
        slipway_rest *more = realloc(p->rest, (p->rests + 1) * sizeof *p->rest);
        if (more == NULL)
            return STATUS_NO_MEMORY;
        p->rest = more;
        p->rest[p->rests++] = rest_at(p, z);
    }
    if (p->rests > 1)
        qsort(p->rest, p->rests, sizeof *p->rest, by_place);
    return STATUS_OK;
}

slipway_status slipway_plane_open(slipway_rates *rates, void *ctx,
                                  const slipway_window *window,
                                  slipway_plane **out, slipway_fault *why)
{
    const double *lo = window->lo, *hi = window->hi;
    slipway_plane *p = calloc(1, sizeof *p);

    if (p == NULL)
        return api_fault(why, SLIPWAY_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    p->window = (struct box){ { lo[0], lo[1] }, { hi[0], hi[1] } };
    slipway_status s = SLIPWAY_OK;
    if (!(lo[0] < hi[0] && lo[1] < hi[1]))
        s = api_fault(why, SLIPWAY_BAD_ARGUMENT, "the window is empty");
    else if (form_build(&p->form, rates, ctx) != STATUS_OK)
        s = api_fault(
            why, SLIPWAY_BAD_ARGUMENT,
            "the rates are no terms of the form, or have more than 62");
    else
        s = api_status(find_rests(p));
    if (s == SLIPWAY_OK)
        *out = p;
    else
        slipway_plane_free(p);
    return s;
}

size_t slipway_plane_equilibria(const slipway_plane *plane, slipway_rest out[],
                                size_t room)
{
    for (size_t i = 0; i < plane->rests && i < room; i++)
        out[i] = plane->rest[i];
    return plane->rests;
}

/* ---- as a planar system -------------------------------------------------- */

/* Around an equilibrium; `sign` -1: backward in time. */
struct around {
    const struct slipway_form *form;
    struct vec2 origin, left; /* left: the rates at the origin */
    double sign;
};

static struct vec2 rates_at(const struct around *a, struct vec2 z,
                            struct mat2 *J)
{
    const struct vec2 f = form_rates(a->form, vec2_add(a->origin, z), J);

    return vec2_scale(a->sign, vec2_sub(f, a->left));
}

static void field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    *f = (struct planar_field){ rates_at(ctx, z, NULL), 0.0 };
}

static void jacobian(const void *ctx, struct vec2 z, struct planar_jacobian *J)
{
    const struct around *a = ctx;
    struct mat2 m;

    J->field = (struct planar_field){ rates_at(a, z, &m), 0.0 };
    J->matrix = (struct mat2){ a->sign * m.xx, a->sign * m.xy, a->sign * m.yx,
                               a->sign * m.yy };
}

static void jet(const void *ctx, struct jet_work *w, size_t k,
                const jet_pair x[], const jet_pair y[], jet_pair fx[],
                jet_pair fy[])
{
    const struct around *a = ctx;
    const jet_pair *rate[2];

    w->used = 0;
    if (k == 0)
        w->log_scale = JET_PAIR(0.0);
    jet_pair *const at[2] = { jet_slot(w), jet_slot(w) };
    at[0][k] = k == 0 ? x[0] + a->origin.x : x[k];
    at[1][k] = k == 0 ? y[0] + a->origin.y : y[k];
    form_jet(a->form, w, k, at[0], at[1], rate);
    fx[k] = a->sign * (rate[0][k] - (k == 0 ? a->left.x : 0.0));
    fy[k] = a->sign * (rate[1][k] - (k == 0 ? a->left.y : 0.0));
}

static struct planar planar_around(const struct around *a, struct box window)
{
    return (struct planar){
        .name = "plane",
        .axis = { { "x", "1", "first coordinate", false },
                  { "y", "1", "second coordinate", false } },
        .domain = window,
        .origin = a->origin,
        .field = field,
        .jacobian = jacobian,
        .jet = jet,
        .ctx = a,
    };
}

/* ---- branches ------------------------------------------------------------ */

enum { PLACES = 16 }; /* points of a piece */

/* Points of the branch in the window; their number. */
static size_t places_of(const struct branch *b, const slipway_plane *p,
                        const slipway_rest *from, slipway_place out[],
                        size_t room)
{
    double at[CURVE_DIM_MAX];
    size_t n = 0;

    for (size_t i = 0; i < b->curve.count; i++)
        for (int k = i > 0; k <= PLACES; k++) {
            curve_at(&b->curve, i, (double) k / PLACES, at);
            const struct vec2 z = { from->x + at[0], from->y + at[1] };
            if (!box_holds(p->window, z))
                return n;
            if (n < room)
                out[n] =
                    (slipway_place){ z.x, z.y,
                                     b->curve.piece[i].error + from->error };
            n++;
        }
    return n;
}

/* The side of the series on which x grows (side +1) or falls, or y where the
 * manifold leaves vertically. */
static int series_side(const struct local_series *u, int side)
{
    return u->ind == 1 && u->c[1] < 0.0 ? -side : side;
}

static enum status grow(const slipway_plane *p, const slipway_rest *from,
                        slipway_kind kind, int side, double rtol,
                        struct branch *out)
{
    const struct vec2 at = { from->x, from->y };
    const struct around a = { &p->form, at, form_rates(&p->form, at, NULL),
                              kind == SLIPWAY_STABLE ? 1.0 : -1.0 };
    const struct planar sys = planar_around(&a, p->window);
    struct grow_options o = grow_defaults(rtol);
    struct local_series u;
    struct equilibrium e;

    o.reach = &p->window;
    equilibrium_at(&sys, false, &e);
    const enum status s = local_at(&sys, &e, MANIFOLD_STABLE, &o.carry, o.order,
                                   TOL_TAYLOR_STEP * rtol, &u);
    return s == STATUS_OK
               ? grow_branch(&sys, &u, series_side(&u, side), &o, out)
               : s;
}

slipway_status slipway_plane_branch(const slipway_plane *plane, size_t which,
                                    slipway_kind kind, int side, double rtol,
                                    slipway_place out[], size_t room,
                                    size_t *count)
{
    struct branch b;

    if (which >= plane->rests || (side != 1 && side != -1) ||
        !(rtol > 0.0 && rtol < 1.0))
        return SLIPWAY_BAD_ARGUMENT;
    const enum status s =
        grow(plane, &plane->rest[which], kind, side, rtol, &b);
    if (s != STATUS_OK)
        return api_status(s == STATUS_BAD_ARGUMENT ? STATUS_NOT_HYPERBOLIC : s);
    *count = places_of(&b, plane, &plane->rest[which], out, room);
    branch_free(&b);
    return SLIPWAY_OK;
}

void slipway_plane_free(slipway_plane *plane)
{
    if (plane == NULL)
        return;
    free(plane->rest);
    free(plane);
}
