#include "quad_way.h"

#include <math.h>

#include "stress_tolerance.h"

enum { STEPS = 10000 };

/* From `from` by time h; the error in accuracies. */
static double go(const struct quad_way *w, quad h, quad out[2],
                 struct quad_step *made)
{
    const quad enough[] = { w->accuracy * w->side[0],
                            w->accuracy * w->side[1] };
    quad error[2];

    *made = quad_step(w->rates, w->ctx, 0, h, w->z, enough, out, error);
    return fmax((double) (error[0] / enough[0]),
                (double) (error[1] / enough[1]));
}

/* Columns by central differences, of a relative error of 1e-22 or so. */
static void jacobian(const struct quad_way *w, quad j[2][2])
{
    for (int k = 0; k < 2; k++) {
        const quad h = 0x1p-38 * w->side[k];
        quad up[] = { w->z[0], w->z[1] }, down[] = { w->z[0], w->z[1] }, a[2],
             b[2];
        up[k] += h;
        down[k] -= h;
        w->rates(w->ctx, 0, up, a);
        w->rates(w->ctx, 0, down, b);
        for (int i = 0; i < 2; i++)
            j[i][k] = (a[i] - b[i]) / (2 * h);
    }
}

void quad_way_settle(struct quad_way *w)
{
    for (int n = 0; n < 8; n++) {
        quad j[2][2], r[2];
        jacobian(w, j);
        w->rates(w->ctx, 0, w->z, r);
        const quad d = j[0][0] * j[1][1] - j[0][1] * j[1][0];
        w->z[0] -= (r[0] * j[1][1] - r[1] * j[0][1]) / d;
        w->z[1] -= (r[1] * j[0][0] - r[0] * j[1][0]) / d;
    }
}

static void eigenvalues(quad j[2][2], quad re[2], quad *im)
{
    const quad half = (j[0][0] + j[1][1]) / 2, off = (j[0][0] - j[1][1]) / 2;
    const quad d = off * off + j[0][1] * j[1][0], root = sqrtq(fabsq(d));

    re[0] = d > 0 ? half - root : half;
    re[1] = d > 0 ? half + root : half;
    *im = d > 0 ? 0 : root;
}

void quad_way_eigenvalues(const struct quad_way *w, quad re[2], quad *im)
{
    quad j[2][2];

    jacobian(w, j);
    eigenvalues(j, re, im);
}

void quad_way_leave(struct quad_way *w, const double to[2])
{
    quad j[2][2], re[2], im, d[2];

    jacobian(w, j);
    eigenvalues(j, re, &im);
    const quad rate = re[w->step < 0 ? 0 : 1];
    const bool first =
        hypotq(j[0][1], rate - j[0][0]) > hypotq(rate - j[1][1], j[1][0]);
    d[0] = first ? j[0][1] : rate - j[1][1];
    d[1] = first ? rate - j[0][0] : j[1][0];
    const quad along = (to[0] - w->z[0]) * d[0] / w->side[0] / w->side[0] +
                       (to[1] - w->z[1]) * d[1] / w->side[1] / w->side[1];
    const quad size = hypotq(d[0] / w->side[0], d[1] / w->side[1]);
    w->longest = 0.5 / (re[1] > -re[0] ? re[1] : -re[0]);
    w->step = copysignq(w->longest, rate);
    for (int k = 0; k < 2; k++)
        w->z[k] += copysignq((quad) STRESS_WAY_LEFT, along) * d[k] / size;
}

bool quad_way_step(struct quad_way *w, quad out[2])
{
    struct quad_step made;
    double error;

    while (!((error = go(w, w->step, out, &made)) <= 1.0)) {
        if (!(fabsq(w->step) > (quad) 1e-18))
            return false;
        w->step *= isfinite(error) ? quad_step_factor(&made, error) : 0.25;
    }
    return true;
}

void quad_way_take(struct quad_way *w, const quad out[2])
{
    const quad size = hypotq((out[0] - w->z[0]) / w->side[0],
                             (out[1] - w->z[1]) / w->side[1]);

    w->z[0] = out[0];
    w->z[1] = out[1];
    if (size > 2 * w->most)
        w->step /= 2;
    else if (size < w->most && fabsq(w->step) < w->longest)
        w->step *= (quad) 1.25;
}

/* z - p, the shorter way round. */
static void between(const struct quad_way *w, const double p[2],
                    const quad z[2], quad d[2])
{
    for (int k = 0; k < 2; k++) {
        d[k] = z[k] - p[k];
        if (w->period[k] > 0.0)
            d[k] -= w->period[k] * rint((double) d[k] / w->period[k]);
    }
}

/* How far p is behind z, along the way. */
static quad behind(const struct quad_way *w, const double p[2], const quad z[2],
                   quad *speed)
{
    quad r[2], d[2];

    w->rates(w->ctx, 0, z, r);
    between(w, p, z, d);
    *speed = copysignq(hypotq(r[0], r[1]), w->step);
    return (d[0] * r[0] + d[1] * r[1]) / *speed;
}

/* How far p is off the way where z has just come by it; else infinite. */
static quad off_at(const struct quad_way *w, const double p[2],
                   const quad end[2])
{
    struct quad_step made;
    quad z[] = { w->z[0], w->z[1] }, time = 0, speed, d[2];
    const quad past = behind(w, p, end, &speed);

    between(w, p, end, d);
    if (!(past >= 0 && hypotq(d[0], d[1]) < 2 * fabsq(speed * w->step)))
        return (quad) HUGE_VAL;
    for (int n = 0; n < 8; n++) {
        const quad off = behind(w, p, z, &speed);
        time -= off / speed;
        (void) go(w, time, z, &made);
    }
    between(w, p, z, d);
    return hypotq(d[0], d[1]);
}

size_t quad_way_follow(struct quad_way *w, const struct plane_point p[],
                       size_t count, double slack, quad off[], bool *lost)
{
    size_t held = 0;
    quad z[2], arc = 0;

    *lost = false;
    off[0] = (quad) HUGE_VAL;
    for (int n = 0; n < STEPS && held < count && !*lost; n++) {
        if (!quad_way_step(w, z))
            break;
        arc += hypotq(z[0] - w->z[0], z[1] - w->z[1]);
        for (quad by; held < count &&
                      (by = off_at(w, p[held].at, z)) < (quad) HUGE_VAL;) {
            off[held] = by < off[held] ? by : off[held];
            if (!(by <= p[held].error + slack))
                break;
            if (++held < count)
                off[held] = (quad) HUGE_VAL;
        }
        if (held < count && arc > 1.1 * p[held].arc + 0.05 * w->side[0])
            return held;
        quad_way_take(w, z);
    }
    *lost = held < count;
    return held;
}
