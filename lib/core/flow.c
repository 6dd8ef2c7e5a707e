/* First step: Hairer, Norsett & Wanner, Solving ODEs I (1993), sec. II.4.
 * Changed: a step counts as accepted only when its dense output is finite
 * too, because the curve is the product and the end point is not. */
#include "flow.h"

#include <math.h>
#include <string.h>

#include "tolerance.h"

enum { COEFS = EXPLICIT8_DEGREE + 1 };

/* Root mean square of d over the error weights at u. */
static double norm(const struct flow *f, const double d[])
{
    const size_t dim = f->ode->dim;
    double sum = 0.0;

    for (size_t i = 0; i < dim; i++) {
        const double weight =
            f->options.atol[i] + f->options.rtol * fabs(f->u[i]);
        sum += (d[i] / weight) * (d[i] / weight);
    }
    return sqrt(sum / (double) dim);
}

/* The step at which either of the first two derivatives would change u by a
 * hundredth of a tolerance if the error went as h^order alone. */
static double first_step(struct flow *f, double way)
{
    const size_t dim = f->ode->dim;
    const double *du = f->work.k[0], probe = TOL_ASIDE * way;
    double at[CURVE_DIM_MAX] = { 0.0 }, change[CURVE_DIM_MAX] = { 0.0 };

    for (size_t i = 0; i < dim; i++)
        at[i] = f->u[i] + probe * du[i];
    f->ode->rhs(f->ode->ctx, f->s + probe, at, change);
    f->calls++;
    for (size_t i = 0; i < dim; i++)
        change[i] = (change[i] - du[i]) / probe;
    const double rate = fmax(norm(f, du), norm(f, change));
    const double h = pow(TOL_LITTLE / rate, 1.0 / f->control.order);
    return h > 0.0 && h < fabs(way) ? h : fabs(way);
}

enum status flow_init(struct flow *f, const struct ode *ode, double s,
                      const double u[], const struct flow_options *options)
{
    const size_t size = ode->dim * sizeof *u;
    bool good = options->rtol > 0.0 && options->first_step >= 0.0 &&
                options->events <= EVENT_COUNT_MAX && ode->dim > 0 &&
                ode->dim <= CURVE_DIM_MAX && ode_all_finite(u, ode->dim);

    for (size_t i = 0; i < ode->dim && good; i++)
        good = options->atol[i] >= 0.0;
    memset(f, 0, sizeof *f);
    if (!good)
        return STATUS_BAD_ARGUMENT;
    f->ode = ode;
    f->options = *options;
    f->curve = CURVE_EMPTY(ode->dim);
    f->s = s;
    memcpy(f->u, u, size);
    f->control = CONTROL_INIT(8.0);
    ode->rhs(ode->ctx, s, u, f->work.k[0]);
    f->calls = 1;
    if (!ode_all_finite(f->work.k[0], ode->dim))
        return STATUS_NO_CONVERGENCE;
    event_begin(&f->log, options->event, options->events, s, u);
    return STATUS_OK;
}

/* Appends the accepted piece, finds events on it, moves to its end. */
static enum status advance(struct flow *f, double h, const double u1[],
                           const double error[], const double coef[])
{
    const size_t dim = f->ode->dim;
    double *target, end = 1.0;
    size_t stop;
    enum status s = curve_push(&f->curve, EXPLICIT8_DEGREE, &target);

    if (s != STATUS_OK)
        return s;
    memcpy(target, coef, dim * COEFS * sizeof *coef);
    s = event_scan(&f->log, f->options.event, f->options.events, &f->curve,
                   f->s, h, &end, &stop);
    f->steps++;
    for (size_t i = 0; i < dim; i++)
        f->error[i] += error[i];
    if (stop == f->options.events) {
        f->s += h;
        memcpy(f->u, u1, dim * sizeof *u1);
        memcpy(f->work.k[0], f->work.k[12], dim * sizeof *u1);
        return s;
    }
    event_trim(&f->log, &f->curve, end);
    f->s += end * h;
    curve_at(&f->curve, f->curve.count - 1, 1.0, f->u);
    f->end = FLOW_EVENT;
    f->end_index = stop;
    return s;
}

/* One attempt at a step of size h; *accepted says how it went. */
static enum status attempt(struct flow *f, double h, bool *accepted)
{
    const struct flow_options *o = &f->options;
    double u1[CURVE_DIM_MAX], error[CURVE_DIM_MAX];
    double coef[CURVE_DIM_MAX * COEFS], factor;
    double ratio = explicit8_try(&f->work, f->ode, f->s, f->u, h, o->atol,
                                 o->rtol, u1, error);

    f->calls += EXPLICIT8_CALLS;
    if (ratio <= 1.0) {
        explicit8_dense(&f->work, f->ode, f->s, f->u, h, u1, coef);
        f->calls += EXPLICIT8_DENSE_CALLS;
        if (!ode_all_finite(coef, f->ode->dim * COEFS))
            ratio = INFINITY;
    }
    *accepted = control_judge(&f->control, ratio, &factor);
    f->h = fabs(h) * factor;
    if (*accepted)
        return advance(f, h, u1, error, coef);
    f->rejected++;
    return STATUS_OK;
}

enum status flow_step(struct flow *f, double s_end)
{
    bool accepted = false;

    if (f->end == FLOW_EVENT)
        return STATUS_OK;
    if (f->s == s_end) {
        f->end = FLOW_REACHED;
        return STATUS_OK;
    }
    f->end = FLOW_RUNNING;
    if (f->h == 0.0)
        f->h = f->options.first_step > 0.0 ? f->options.first_step
                                           : first_step(f, s_end - f->s);
    while (!accepted) {
        const double way = s_end - f->s;
        const bool last = !(1.01 * f->h < fabs(way));
        const double h = last ? way : copysign(f->h, way);

        if (!(fabs(h) > TOL_STEP_MIN) || (!last && f->s + h == f->s))
            return STATUS_NO_CONVERGENCE;
        if (f->steps + f->rejected >= f->options.max_steps)
            return STATUS_TOO_MANY_STEPS;
        const enum status s = attempt(f, h, &accepted);
        if (s != STATUS_OK)
            return s;
        if (accepted && last && f->end == FLOW_RUNNING) {
            f->s = s_end;
            f->end = FLOW_REACHED;
        }
    }
    return STATUS_OK;
}

void flow_free(struct flow *f)
{
    curve_free(&f->curve);
    event_free(&f->log);
}
