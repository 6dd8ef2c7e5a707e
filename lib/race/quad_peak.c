/* Peaks are between stages of a step, which is taken again to just there. */
#include "quad_peak.h"

#include <math.h>

enum { HALVINGS = 32 };

/* Rates of v and mu at a point, in doubles: to find where they vanish. */
static void find_rise(const struct quad_course *c, const quad z[2],
                      const quad du[], double rise[2])
{
    const struct planar *p = &c->slope->study->slider.plane.system;
    const double v = c->slope->study->slider.block.at.v0 * exp((double) z[0]);
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

/* The rate of v or mu between its values at two neighbouring stages vanishes
 * where it does after steps to there: polynomials are off a slow curve by more
 * than friction changes along it. */
static void polish_peak(struct quad_course *c, const struct quad_radau *w,
                        int which, quad from, quad to)
{
    struct quad_radau part;
    quad u[QUAD_DIM], du[QUAD_DIM];
    double rise[2];

    for (int i = 0; i < HALVINGS; i++) {
        const quad theta = (from + to) / 2;
        if (!quad_course_part(c, w, theta, &part, u))
            return;
        quad_course_field(c, u, du);
        find_rise(c, u, du, rise);
        *(rise[which] > 0.0 ? &from : &to) = theta;
    }
    quad_peak_note(c, u);
}

void quad_peak_start(struct quad_course *c)
{
    find_rise(c, c->u, c->du, c->rise);
    quad_peak_note(c, c->u);
}

void quad_peak_step(struct quad_course *c, const struct quad_radau *w)
{
    const struct quad_method *m = &c->slope->method;
    double before[2] = { c->rise[0], c->rise[1] }, rise[2];

    for (int i = 0; i < QUAD_STAGES; i++) {
        const quad z[2] = { c->u[QUAD_X] + w->z[i][0],
                            c->u[QUAD_Y] + w->z[i][1] };
        const quad from = i == 0 ? 0 : m->node[i - 1];
        find_rise(c, z, w->du[i], rise);
        for (int k = 0; k < 2; k++) {
            const quad v = expq(c->slope->at.x0 + z[0]);
            const quad mu = w->du[i][QUAD_WORK] / w->du[i][QUAD_SLIP];
            const double near =
                (double) (k == 0 ? v / c->v_peak : mu / c->mu_peak);
            if (before[k] > 0.0 && rise[k] <= 0.0 && !(near < 0.9))
                polish_peak(c, w, k, from, m->node[i]);
            before[k] = rise[k];
        }
    }
    c->rise[0] = rise[0];
    c->rise[1] = rise[1];
}
