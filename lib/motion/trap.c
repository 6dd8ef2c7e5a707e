#include "trap.h"

#include <math.h>

#include "control.h"
#include "explicit8.h"
#include "motion_tolerance.h"
#include "slider.h"

/* The quadrant that an offset lies in: 0 slow, 1 fast, TRAPS neither. */
static int trap_at(struct vec2 offset)
{
    if (offset.x < 0.0 && offset.y > 0.0)
        return 0;
    return offset.x > 0.0 && offset.y < 0.0 ? 1 : TRAPS;
}

/* The left eigenvector of the growing eigenvalue. */
static struct vec2 across_of(const struct equilibrium *saddle)
{
    const struct mat2 m = saddle->matrix;
    const struct mat2 transposed = { m.xx, m.yx, m.xy, m.yy };

    return mat2_eigenvector(transposed, saddle->scaled[1]);
}

void trap_init(struct trap *t, const struct slider *s)
{
    *t = (struct trap){ .slider = s, .set = slider_traps(s) };
    if (!t->set)
        return;
    t->across = across_of(phase_plane_saddle(&s->plane));
    for (int i = 0; i < TRAPS; i++)
        t->fate[i] = (int8_t) fate_of_side(s, i == 0);
}

/* du/ds = f/|f|: arc length of the chart, along which an orbit outside the
 * traps is not stiff, for there both its coordinates only fall or only rise. */
static void unit_speed(const void *ctx, double s, const double u[], double du[])
{
    const struct slider *slider = ctx;
    struct planar_field f;

    (void) s;
    slider->plane.system.field(slider->plane.system.ctx,
                               (struct vec2){ u[0], u[1] }, &f);
    const double x = f.direction.x, y = f.direction.y;
    const double n = sqrt(x * x + y * y);
    const double size = n > 1e-140 && n < 1e140 ? n : vec2_length(f.direction);
    du[0] = x / size;
    du[1] = y / size;
}

/* Distance of the saddle from the chord of a step. */
static double chord_distance(const double a[], const double b[])
{
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double square = dx * dx + dy * dy;
    const double part = square > 0.0 ? -(a[0] * dx + a[1] * dy) / square : 0.0;
    const double t = fmin(fmax(part, 0.0), 1.0);

    return hypot(a[0] + t * dx, a[1] + t * dy);
}

/* The trap that z ends in; TRAPS where it takes too long to tell.  *certain: it
 * neither came too close to the saddle for this tolerance nor was too close to
 * the stable manifold when it was caught.  *passed: how close it came to
 * either. */
static int follow(const struct trap *t, struct vec2 z, double rtol,
                  bool *certain, double *passed, size_t *evaluations)
{
    const struct ode ode = { 2, unit_speed, t->slider };
    const double atol[2] = { rtol, rtol };
    double u[2] = { z.x, z.y }, u1[2], error[2], h = 1.0, factor;
    struct control control = CONTROL_INIT(8.0);
    struct explicit8 work;
    double near = vec2_length(z);

    *certain = false;
    unit_speed(t->slider, 0.0, u, work.k[0]);
    for (int n = 0; n < TOL_EXPLICIT_STEPS; n++) {
        const double off =
            explicit8_try(&work, &ode, 0.0, u, h, atol, 0.0, u1, error);
        const bool accepted = control_judge(&control, off, &factor);
        *evaluations += EXPLICIT8_CALLS + accepted;
        h *= factor;
        if (!accepted)
            continue;
        near = fmin(near, chord_distance(u, u1));
        u[0] = u1[0];
        u[1] = u1[1];
        const int caught = trap_at((struct vec2){ u[0], u[1] });
        const double side = fabs(t->across.x * u[0] + t->across.y * u[1]);
        *passed = fmin(near, side);
        *certain = near >= TOL_TRAP_FAR * rtol && side >= TOL_TRAP_SIDE * rtol;
        if (caught < TRAPS)
            return caught;
        unit_speed(t->slider, 0.0, u, work.k[0]);
    }
    return TRAPS;
}

static enum status to_the_end(const struct trap *t, struct vec2 z,
                              int8_t *label, size_t *evaluations)
{
    const struct vec2 at = vec2_add(t->slider->plane.system.origin, z);
    struct fate_result r;
    const enum status s =
        fate_find(t->slider, at, TOL_COARSEST, false, NULL, &r);

    *label = (int8_t) r.fate;
    *evaluations += r.field_evaluations;
    return s;
}

enum status trap_pass(const struct trap *t, struct vec2 z, int8_t *label,
                      double *near, size_t *evaluations)
{
    int caught = t->set ? trap_at(z) : TRAPS;
    bool certain = !t->set || caught < TRAPS;
    size_t spent = 0;
    enum status s = STATUS_OK;

    if (slider_no_traps(t->slider)) {
        *label = FATE_UNDECIDED;
        *near = HUGE_VAL;
        return STATUS_OK;
    }
    *near = t->set ? fabs(t->across.x * z.x + t->across.y * z.y) : HUGE_VAL;
    for (double rtol = TOL_COARSEST; !certain && rtol >= TOL_TRANSIENT_FINEST;
         rtol /= TOL_RETRY)
        caught = follow(t, z, rtol, &certain, near, &spent);
    if (caught < TRAPS)
        *label = t->fate[caught];
    else
        s = to_the_end(t, z, label, &spent);
    if (evaluations)
        *evaluations += spent;
    return s;
}

enum status trap_label(const struct trap *t, struct vec2 z, int8_t *label,
                       size_t *evaluations)
{
    double near;

    return trap_pass(t, z, label, &near, evaluations);
}
