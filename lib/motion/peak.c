/* The dense output is sampled; the step with the largest sample and those
 * beside it are followed once more, finer, for between its ends a step is less
 * accurate than there; and on that curve golden section between the neighbours
 * of the largest sample (Kiefer, Proc. AMS 4, 1953, 502-506) finds the peak.
 * Friction has no derivative along a curve that is cheaper than itself. */
#include "peak.h"

#include <float.h>
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
    const size_t samples = a->curve->count * TOL_EVENT_SAMPLES;
    double best = value_at(a, 0.0), at = 0.0;

    for (size_t i = 1; i <= samples; i++) {
        const double here = (double) i / TOL_EVENT_SAMPLES;
        const double value = value_at(a, here);
        at = value > best ? here : at;
        best = fmax(best, value);
    }
    return at;
}

/* The largest value beside a sample that is not less than its neighbours. */
static double crest_beside(const struct along *a, double at)
{
    const double step = 1.0 / TOL_EVENT_SAMPLES;
    const double lo = fmax(at - step, 0.0);
    const double hi = fmin(at + step, (double) a->curve->count);

    return fmax(value_at(a, at),
                crest_between(value_at, a, lo, hi, TOL_ROOT * (hi - lo)));
}

/* What the largest value may be on all pieces but first .. last, for how far
 * off each is; `part` of that is what it makes of a value.  *top becomes the
 * one there if that is surely more. */
static double most_elsewhere(const struct along *a, double part, size_t first,
                             size_t last, double *top)
{
    const double samples = TOL_EVENT_SAMPLES;
    double most = -HUGE_VAL, where = 0.0, off = 0.0;

    for (size_t k = 0; k < a->curve->count; k++)
        for (int i = 0; i <= TOL_EVENT_SAMPLES && !(k >= first && k <= last);
             i++) {
            const double at = (double) k + i / samples;
            const double aside = part * a->curve->piece[k].across;
            const double here = value_at(a, at) + aside;
            off = here > most ? aside : off;
            where = here > most ? at : where;
            most = fmax(most, here);
        }
    if (!(most > *top))
        return most;
    const double crest = crest_beside(a, where);
    *top = crest - off > *top ? crest : *top;
    return crest + off;
}

/* How far off a curve is at most on its pieces at and beside `at`. */
static double worst_at(const struct curve *c, double at)
{
    const size_t last = (size_t) at + 1;
    double worst = 0.0;

    for (size_t i = last > 1 ? last - 2 : 0; i <= last && i < c->count; i++)
        worst = fmax(worst, c->piece[i].across);
    return worst;
}

/* The start of a piece is the end of the one before. */
static double start_error(const struct curve *c, size_t piece)
{
    return piece > 0 ? fmin(c->piece[piece - 1].across, c->piece[piece].across)
                     : 0.0;
}

/* Follows the pieces first .. last of an orbit again, finer; the largest value
 * on them.  Where that cannot be done *top stays what it was. */
static enum status sharpen(const struct along *a, double part, size_t first,
                           size_t last, double *top, double *error)
{
    const struct slider *s = a->slider;
    struct orbit_options options =
        orbit_defaults(&s->plane.system, s->plane.fastest_rate);
    double from[CURVE_DIM_MAX], to[CURVE_DIM_MAX];
    struct drift drift;
    struct orbit o;

    curve_at(a->curve, first, 0.0, from);
    curve_at(a->curve, last, 1.0, to);
    *error = part * fmax(worst_at(a->curve, (double) first),
                         worst_at(a->curve, (double) last));
    if (!(to[2] > from[2]))
        return STATUS_OK;
    drift_start(&drift, start_error(a->curve, first),
                phase_plane_leaving_rate(&s->plane));
    options.drift = &drift;
    options.rtol = TOL_FINEST;
    options.observables = 0;
    options.reach[0] = to[2] - from[2];
    enum status status = orbit_init(
        &o, &s->plane.system, (struct vec2){ from[0], from[1] }, &options);
    if (status != STATUS_OK)
        return STATUS_OK;
    status = orbit_run(&o, NULL);
    const struct along fine = { s, &o.curve, a->value };
    if (status == STATUS_OK && o.curve.count > 0) {
        const double at = top_sample(&fine);
        *top = crest_beside(&fine, at);
        const double most = most_elsewhere(&fine, part, 1, 0, top);
        *error = fmax(part * worst_at(&o.curve, at), most - *top);
    }
    orbit_free(&o);
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

/* How far off the last point of an orbit is that arrived. */
static double end_error(const struct orbit *o)
{
    const struct vec2 face = fate_face((struct vec2){ o->u[0], o->u[1] },
                                       o->options.target[o->end_index]);

    return fmax(drift_bar(o->options.drift, face, 0),
                drift_bar(o->options.drift, face, 1));
}

/* Of ln v and of psi's coordinate, per piece, at the start. */
static double first_slope(const struct curve *c)
{
    return fabs(curve_component(c, 0, 0)[1]) +
           fabs(curve_component(c, 0, 1)[1]);
}

/* Whether the value rises from z on. */
static bool is_rising(const struct slider *s, struct vec2 z, peak_value *value)
{
    struct planar_field f;

    s->plane.system.field(s->plane.system.ctx, z, &f);
    const double part = TOL_ASIDE / vec2_length(f.direction);
    return value(s, vec2_add(z, vec2_scale(part, f.direction))) > value(s, z);
}

/* The largest value along an orbit that starts at the offset z, and its error;
 * `part`: what a place that is off makes of a value.  At the start there is
 * none, if it falls there and nothing else may be larger. */
static enum status peak_of(const struct slider *s, const struct orbit *o,
                           struct vec2 z, peak_value *value, double part,
                           double *top, double *error)
{
    const struct along a = { s, &o->curve, value };
    const size_t count = o->curve.count;
    enum status status = STATUS_OK;

    *top = value(s, z);
    *error = 0.0;
    if (count == 0)
        return STATUS_OK;
    const double at = top_sample(&a), start = *top, peak = crest_beside(&a, at);
    const size_t piece = (size_t) fmin(at, (double) count - 1.0);
    const size_t first = piece > 0 ? piece - 1 : 0;
    const size_t last = piece + 1 < count ? piece + 1 : piece;
    *top = fmax(start, peak);
    if (peak <= start && !is_rising(s, z, value)) {
        *error = fmax(most_elsewhere(&a, part, first, last, top) - start, 0.0);
        return STATUS_OK;
    }
    if (o->end == ORBIT_ARRIVED && peak > start &&
        peak <= value_at(&a, (double) count))
        *error = part * end_error(o);
    else
        status = sharpen(&a, part, first, last, top, error);
    if (!(*top > start)) /* it rises by less than is seen of it */
        *error = fmax(*error, part * TOL_ROOT * first_slope(&o->curve));
    *top = fmax(start, *top);
    const double most = most_elsewhere(&a, part, first, last, top);
    *error = fmax(*error, most - *top);
    return status;
}

/* Whether a block that only fades may yet meet more friction than so far: what
 * friction has over gravity, eps^2 |dv/dt|, rises beside a saddle, whatever is
 * known of the rest by then. */
static bool is_to_peak(const struct slider *s, const struct orbit *o,
                       double most)
{
    const double t = (double) s->block.tan_alpha;
    const double now = friction(s, (struct vec2){ o->u[0], o->u[1] });

    return rest_form_at(&s->block).fate == FATE_REST_ASYMPTOTIC &&
           o->du[0] < 0.0 && !(now - t < TOL_LITTLE * (most - t));
}

/* Whether v still rises where nothing holds it above 0 (fate.c): an orbit's
 * rest is known next to its curve, from below as well. */
static bool is_to_fall(const struct slider *s, const struct orbit *o)
{
    return slider_saddle(s) == 0 && o->u[0] < 0.0 && o->u[1] > 0.0 &&
           o->du[0] > 0.0;
}

/* Follows the orbit for so many steps, and on to where v falls and friction has
 * faded. */
static enum status follow(const struct slider *s, size_t steps, struct orbit *o)
{
    double most = friction(s, (struct vec2){ o->u[0], o->u[1] });
    enum status status = STATUS_OK;

    while (status == STATUS_OK && o->end == ORBIT_RUNNING &&
           (o->steps < steps || is_to_fall(s, o) || is_to_peak(s, o, most))) {
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
    const struct vec2 m = s->block.steep;
    struct vec2 goal[EQUILIBRIA_MAX];
    const double rounding = slider_rounding(s, start);
    struct drift drift;
    struct peaks p;
    struct orbit o;

    options.rtol = rtol;
    options.observables = BLOCK_EXCESS;
    options.target = goal;
    options.targets = phase_plane_goals(&s->plane, goal);
    options.arrival = TOL_ARREST;
    options.drift = &drift;
    drift_start(&drift, rounding, phase_plane_leaving_rate(&s->plane));
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
        status = peak_of(s, &o, start, slip_rate, 1.0, &p.x, &p.x_error);
    if (status == STATUS_OK)
        status = peak_of(s, &o, start, friction, m.x + m.y, &p.mu, &p.mu_error);
    if (status == STATUS_OK) {
        *out = p;
        if (p.x == slip_rate(s, start))
            out->x = z.x;
        else
            out->x_error += rounding;
        out->mu_error += (m.x + m.y) * rounding +
                         TOL_ROUNDINGS_FEW * DBL_EPSILON * fabs(p.mu);
    }
    orbit_free(&o);
    return status;
}
