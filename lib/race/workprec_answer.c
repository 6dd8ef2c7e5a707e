#include "workprec_answer.h"

#include <math.h>

#include "workprec_plane.h"

static double relative(double value, quad truth)
{
    return fabs((double) ((value - truth) / truth));
}

/* The larger one, or whatever is not a number. */
static double worse(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

/* Points beyond the window are nobody's. */
static double curve_error(const struct workprec_task *c, int side,
                          const struct workprec_answer *a)
{
    const struct vec2 o = c->study->slider.plane.system.origin;
    const struct workprec_truth *t = &c->truth;
    const size_t n = a->points[side];
    const size_t sample = n < c->sample ? n : c->sample;
    double worst = n > 0 ? 0.0 : HUGE_VAL;

    if (c->plane)
        return workprec_plane_error(c->plane, a->point[side], n, sample);
    for (size_t k = 0; k < sample; k++) {
        const struct vec2 p = a->point[side][(k + 1) * n / sample - 1];
        const quad z[2] = { (quad) o.x + p.x - t->slope.at.x0,
                            (quad) o.y + p.y - t->slope.at.y0 };
        worst = worse(workprec_curve_distance(&t->curve[side], z), worst);
    }
    return worst;
}

static double rows_error(const struct workprec_task *c,
                         const struct workprec_answer *a)
{
    double worst = 0.0;

    for (int side = 0; side < WORKPREC_SIDES; side++) {
        const struct workprec_cuts *cuts = &c->truth.cuts[side];
        const double *x = &a->value[side * WORKPREC_ROWS_MOST];
        for (size_t k = 0; k < cuts->count; k++) {
            const quad at =
                (quad) c->study->slider.plane.system.origin.x + x[k];
            worst = worse(fabs((double) (at - cuts->x[k])), worst);
        }
    }
    return worst;
}

static double state_error(const struct workprec_task *c,
                          const struct workprec_answer *a)
{
    const struct vec2 o = c->study->slider.plane.system.origin;
    const quad x = (quad) o.x + a->value[0] - c->truth.state[0];
    const quad y = (quad) o.y + a->value[1] - c->truth.state[1];

    return worse(fabs((double) x), fabs((double) y));
}

static double slip_error(const struct workprec_task *c,
                         const struct workprec_answer *a)
{
    double worst = 0.0;

    for (size_t k = 0; k < c->cells; k++)
        worst = worse(relative(a->value[k], c->truth.slip[k]), worst);
    return worst;
}

double workprec_error(const struct workprec_task *c, enum workprec_quantity q,
                      const struct workprec_answer *a)
{
    switch (q) {
        case WORKPREC_V_PLUS:
            return relative(a->value[0], c->truth.v[SIDE_UPPER]);
        case WORKPREC_V_MINUS:
            return relative(a->value[0], c->truth.v[SIDE_LOWER]);
        case WORKPREC_X_EXCESS:
            return relative(a->value[0], c->truth.x_excess);
        case WORKPREC_CURVE:
            return worse(curve_error(c, SIDE_UPPER, a),
                         curve_error(c, SIDE_LOWER, a));
        case WORKPREC_TRANSIENT:
            return state_error(c, a);
        case WORKPREC_ROWS:
            return rows_error(c, a);
        default:
            return slip_error(c, a);
    }
}
