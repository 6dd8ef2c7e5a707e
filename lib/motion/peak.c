/* The dense output is sampled; the step with the largest sample and those
 * beside it are followed once more, finer, for between its ends a step is less
 * accurate than there; and on that curve golden section between the neighbours
 * of the largest sample (Kiefer, Proc. AMS 4, 1953, 502-506) finds the peak.
 * Friction has no derivative along a curve that is cheaper than itself. */
#include "peak.h"

#include <math.h>

#include "crest.h"
#include "fate.h"
#include "motion_tolerance.h"
#include "orbit.h"
#include "rest_form.h"
#include "slider.h"

typedef double peak_value(const struct slider *s, struct vec2 z);

/* A function along a curve. */
struct along {
    const struct slider *slider;
    const struct curve *curve;
    peak_value *value;
};

static double slip_rate(const struct slider *s, struct vec2 z)
{
    return s->plane.system.origin.x + z.x;
}

static double friction(const struct slider *s, struct vec2 z)
{
    return block_mu(&s->block, z);
}

/* `at`: number of the piece, and theta. */
static double value_at(const void *ctx, double at)
{
    const struct along *a = ctx;
    const size_t piece = (size_t) fmin(at, (double) a->curve->count - 1.0);
    const double theta = at - (double) piece;
    const size_t degree = a->curve->piece[piece].degree;
    const double *x = curve_component(a->curve, piece, 0);
    const double *y = curve_component(a->curve, piece, 1);
    struct vec2 z = { x[degree], y[degree] };

    for (size_t k = degree; k-- > 0;)
        z = (struct vec2){ z.x * theta + x[k], z.y * theta + y[k] };
    return a->value(a->slider, z);
}

/* Where the largest sample is; the curve is not empty. */
static double top_sample(const struct along *a)
{
    const size_t samples = a->curve->count * TOL_PEAK_SAMPLES;
    double best = value_at(a, 0.0), at = 0.0;

    for (size_t i = 1; i <= samples; i++) {
        const double here = (double) i / TOL_PEAK_SAMPLES;
        const double value = value_at(a, here);
        at = value > best ? here : at;
        best = fmax(best, value);
    }
    return at;
}

static double top_of(const struct along *a)
{
    const double at = top_sample(a), step = 1.0 / TOL_PEAK_SAMPLES;
    const double lo = fmax(at - step, 0.0);
    const double hi = fmin(at + step, (double) a->curve->count);

    return fmax(value_at(a, at),
                crest_between(value_at, a, lo, hi, TOL_PEAK_WIDTH * (hi - lo)));
}

/* Follows the pieces first .. last of an orbit again, finer; the largest value
 * on them.  Where that cannot be done *top stays what it was. */
static enum status sharpen(const struct along *a, double rtol, size_t first,
                           size_t last, double *top)
{
    const struct slider *s = a->slider;
    struct orbit_options options =
        orbit_defaults(&s->plane.system, s->plane.fastest_rate);
    double from[CURVE_DIM_MAX], to[CURVE_DIM_MAX];
    struct orbit o;

    curve_at(a->curve, first, 0.0, from);
    curve_at(a->curve, last, 1.0, to);
    if (!(to[2] > from[2]))
        return STATUS_OK;
    options.rtol = fmax(rtol * TOL_PEAK_FINER, TOL_PEAK_FINEST);
    options.observables = 0;
    options.reach[0] = to[2] - from[2];
    enum status status = orbit_init(
        &o, &s->plane.system, (struct vec2){ from[0], from[1] }, &options);
    if (status != STATUS_OK)
        return STATUS_OK;
    status = orbit_run(&o, NULL);
    const struct along fine = { s, &o.curve, a->value };
    if (status == STATUS_OK && o.curve.count > 0)
        *top = top_of(&fine);
    orbit_free(&o);
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

/* The largest value along an orbit that starts at the offset z. */
static enum status peak_of(const struct slider *s, const struct orbit *o,
                           struct vec2 z, peak_value *value, double *top)
{
    const struct along a = { s, &o->curve, value };
    const size_t count = o->curve.count;

    *top = value(s, z);
    if (count == 0)
        return STATUS_OK;
    const double at = top_sample(&a);
    const size_t piece = (size_t) fmin(at, (double) count - 1.0);
    *top = top_of(&a);
    return sharpen(&a, o->options.rtol, piece > 0 ? piece - 1 : 0,
                   piece + 1 < count ? piece + 1 : piece, top);
}

/* Whether a block that only fades may yet meet more friction than so far: what
 * friction has over gravity, eps^2 |dv/dt|, rises beside a saddle, whatever is
 * known of the rest by then. */
static bool is_to_peak(const struct slider *s, const struct orbit *o,
                       double most)
{
    const double t = (double) s->block.tan_alpha;
    const double now = friction(s, (struct vec2){ o->u[0], o->u[1] });

    return rest_form_of(&s->block.law, &s->block.material).fate ==
               FATE_REST_ASYMPTOTIC &&
           o->du[0] < 0.0 && !(now - t < TOL_PEAK_FADED * (most - t));
}

/* Follows the orbit for so many steps, and on to where friction has faded. */
static enum status follow(const struct slider *s, size_t steps, struct orbit *o)
{
    double most = friction(s, (struct vec2){ o->u[0], o->u[1] });
    enum status status = STATUS_OK;

    while (status == STATUS_OK && o->end == ORBIT_RUNNING &&
           (o->steps < steps || is_to_peak(s, o, most))) {
        status = orbit_step(o);
        most = fmax(most, friction(s, (struct vec2){ o->u[0], o->u[1] }));
    }
    return status;
}

enum status peaks_find(const struct slider *s, struct vec2 z, double rtol,
                       size_t steps, struct peaks *out)
{
    const struct vec2 start = vec2_sub(z, s->plane.system.origin);
    struct orbit_options options =
        orbit_defaults(&s->plane.system, s->plane.fastest_rate);
    struct vec2 goal[EQUILIBRIA_MAX];
    struct peaks p;
    struct orbit o;

    options.rtol = rtol;
    options.observables = BLOCK_EXCESS;
    options.target = goal;
    options.targets = phase_plane_goals(&s->plane, goal);
    options.arrival = TOL_ARREST;
    options.max_steps = TOL_FATE_STEPS;
    fate_least(s, start, options.least);
    enum status status = orbit_init(&o, &s->plane.system, start, &options);
    if (status != STATUS_OK)
        return status;
    status = follow(s, steps, &o);
    p.whole = status == STATUS_OK &&
              (slider_saddle(s) != 0 || (o.u[0] < 0.0 && o.u[1] > 0.0));
    if (status == STATUS_NO_CONVERGENCE || status == STATUS_TOO_MANY_STEPS)
        status = STATUS_OK; /* as far as fate_find got, too */
    if (status == STATUS_OK)
        status = peak_of(s, &o, start, slip_rate, &p.x);
    if (status == STATUS_OK)
        status = peak_of(s, &o, start, friction, &p.mu);
    if (status == STATUS_OK)
        *out = p;
    orbit_free(&o);
    return status;
}
