/* Peaks are between stages of a step, which is taken again to just there. */
#include "quad_peak.h"

#include <math.h>

#include "newton.h"

/* Of a step: half its square is nothing in 113 bits of a smooth peak. */
static const double placed = 0x1p-32;

/* Rates of v and mu at a point, in doubles: to find where they vanish. */
static void find_rise(const struct quad_course *c, const quad z[2],
                      const quad du[], double rise[2])
{
    const struct planar *p = &c->slope->study->slider.plane.system;
    const double v = block_v(&c->slope->study->slider.block, (double) z[0]);
    const struct vec2 at = { (double) z[0], (double) z[1] };
    struct vec2 g;
    double work;

    p->rate_gradient(p->ctx, BLOCK_WORK, at, &work, &g);
    rise[0] = (double) du[QUAD_X];
    rise[1] =
        ((g.x - work) * (double) du[QUAD_X] + g.y * (double) du[QUAD_Y]) / v;
}

void quad_peak_note(struct quad_course *c, const quad u[])
{
    const quad v = expq(c->slope->at.x0 + u[QUAD_X]);
    const quad mu = quad_block_mu(&c->slope->at, u[QUAD_X], u[QUAD_Y]);

    c->v_peak = c->steps == 0 || v > c->v_peak ? v : c->v_peak;
    c->mu_peak = c->steps == 0 || mu > c->mu_peak ? mu : c->mu_peak;
}

struct between {
    const struct quad_course *course;
    const struct quad_radau *whole;
    int which; /* 0: v, 1: mu */
};

/* Its rate after a step to there: polynomials are off a slow curve by more
 * than friction changes along it. */
static double rise_at(const void *ctx, double theta)
{
    const struct between *b = (const struct between *) ctx;
    struct quad_radau part;
    quad u[QUAD_DIM], du[QUAD_DIM];
    double rise[2];

    if (!quad_course_part(b->course, b->whole, theta, &part, u))
        return NAN;
    quad_course_field(b->course, u, du);
    find_rise(b->course, u, du, rise);
    return rise[b->which];
}

static void note_at(struct quad_course *c, const struct quad_radau *whole,
                    double theta)
{
    struct quad_radau part;
    quad u[QUAD_DIM];

    if (quad_course_part(c, whole, theta, &part, u))
        quad_peak_note(c, u);
}

/* Where rounding turns the sign at an end, the peak is there. */
static void polish_peak(struct quad_course *c, const struct quad_radau *w,
                        int which, double from, double to)
{
    const struct between b = { c, w, which };
    struct newton_root root = { .x = to };

    if (newton_find(rise_at, &b, from, to, placed, &root) != STATUS_OK)
        note_at(c, w, from);
    note_at(c, w, root.x);
}

void quad_peak_start(struct quad_course *c)
{
    find_rise(c, c->u, c->du, c->rise);
    quad_peak_note(c, c->u);
}

/* A peak between stages lies below the tangents at both, where it is one. */
void quad_peak_step(struct quad_course *c, const struct quad_radau *w)
{
    const struct quad_method *m = &c->slope->method;
    double before[2] = { c->rise[0], c->rise[1] }, rise[2];

    for (int i = 0; i < QUAD_STAGES; i++) {
        const quad *z = w->z[i], *du = w->du[i];
        const quad from = i == 0 ? 0 : m->node[i - 1];
        const double past = (double) ((m->node[i] - from) * w->h);
        const quad at[2] = { c->u[QUAD_X] + z[0], c->u[QUAD_Y] + z[1] };
        const quad v = expq(c->slope->at.x0 + at[0]);
        find_rise(c, at, du, rise);
        const bool may[2] = { v * exp(-rise[0] * past) > c->v_peak,
                              du[QUAD_WORK] / du[QUAD_SLIP] - rise[1] * past >
                                  c->mu_peak };
        for (int k = 0; k < 2; k++) {
            if (before[k] > 0.0 && rise[k] <= 0.0 && may[k])
                polish_peak(c, w, k, (double) from, (double) m->node[i]);
            before[k] = rise[k];
        }
    }
    c->rise[0] = rise[0];
    c->rise[1] = rise[1];
}
