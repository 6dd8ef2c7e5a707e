/* The idea of sphere tracing (Hart, Visual Computer 12 (1996) 527-545) on a
 * polynomial: sum_j j |u_j| bounds the speed of component u on [0, 1]. */
#include "passage.h"

#include <math.h>
#include <stdbool.h>

#include "newton.h"
#include "tolerance.h"

struct walk {
    const struct curve *curve;
    size_t piece;
    struct box box;
    size_t component; /* < curve->dim; else the box decides */
    double value;
    double sign; /* of the box distance: +1 into it, -1 out of it */
};

/* Positive before the passage, negative beyond it. */
static double to_go(const void *ctx, double theta)
{
    const struct walk *w = ctx;
    const size_t dim = w->curve->dim, degree = w->curve->piece[w->piece].degree;
    double u[2];

    for (size_t i = 0; i < 2; i++) {
        const size_t which = w->component < dim ? w->component : i;
        const double *p = curve_component(w->curve, w->piece, which);
        u[i] = p[degree];
        for (size_t j = degree; j-- > 0;)
            u[i] = u[i] * theta + p[j];
    }
    if (w->component < dim)
        return w->value > 0.0 ? w->value - u[0] : u[0] - w->value;
    return w->sign * passage_distance(w->box, (struct vec2){ u[0], u[1] });
}

static double top_speed(const struct walk *w, size_t i)
{
    const double *p = curve_component(w->curve, w->piece, i);
    double sum = 0.0;

    for (size_t j = 1; j <= w->curve->piece[w->piece].degree; j++)
        sum += (double) j * fabs(p[j]);
    return sum;
}

/* `stride`: shortest stride in theta; `closed`: distance zero is a passage
 * already. */
static double first(const struct walk *w, double speed, double stride,
                    bool closed)
{
    double at = 0.0, left = to_go(w, 0.0);

    if (left < 0.0 || (closed && left == 0.0))
        return 0.0;
    while (at < 1.0) {
        struct newton_root root;
        if (left > speed * (1.0 - at))
            return PASSAGE_NEVER;
        const double step = fmax(left / speed, stride);
        const double next = fmin(at + step, 1.0);
        left = to_go(w, next);
        if (left < 0.0 || (closed && left == 0.0))
            return newton_find(to_go, w, at, next, 0.0, &root) == STATUS_OK
                       ? root.x
                       : next;
        at = next;
    }
    return PASSAGE_NEVER;
}

static struct walk through_box(const struct curve *c, struct box b, double sign)
{
    return (struct walk){ .curve = c,
                          .piece = c->count - 1,
                          .box = b,
                          .component = c->dim,
                          .sign = sign };
}

double passage_into(const struct curve *c, struct box b)
{
    const struct walk w = through_box(c, b, 1.0);
    const double speed = fmax(top_speed(&w, 0), top_speed(&w, 1));
    const double width = fmin(b.hi.x - b.lo.x, b.hi.y - b.lo.y);

    return first(&w, speed,
                 fmin(TOL_PASSAGE_STEP, TOL_PASSAGE_CHORD * width / speed),
                 true);
}

double passage_out_of(const struct curve *c, struct box b)
{
    const struct walk w = through_box(c, b, -1.0);
    const double speed = fmax(top_speed(&w, 0), top_speed(&w, 1));

    return first(&w, speed, TOL_PASSAGE_STEP, false);
}

double passage_beyond(const struct curve *c, size_t i, double value)
{
    const struct walk w = {
        .curve = c, .piece = c->count - 1, .component = i, .value = value
    };

    return first(&w, top_speed(&w, i), TOL_PASSAGE_STEP, true);
}

double passage_distance(struct box b, struct vec2 z)
{
    return fmax(fmax(b.lo.x - z.x, z.x - b.hi.x),
                fmax(b.lo.y - z.y, z.y - b.hi.y));
}
