/* Halving: about the middle of an interval of half length h a polynomial keeps
 * within sum_j |u_j| h^j, j > 0, of its value there, with u_j its coefficients
 * about that point.  Nearer than that to the passage the halves are searched,
 * the first one first.  A box is looked at side by side: a curve that hugs a
 * face moves along it, but little towards it. */
#include "passage.h"

#include <math.h>
#include <stdbool.h>

#include "jet.h"
#include "newton.h"
#include "tolerance.h"

struct walk {
    const struct curve *curve;
    size_t piece;
    struct box box;
    size_t component; /* < curve->dim; else the box decides */
    double value;
    double sign;   /* of the box distance: +1 into it, -1 out of it */
    bool closed;   /* distance zero is a passage already */
    double stride; /* shorter intervals of theta are not halved, */
    double least;  /* nor those on which the curve moves less than this, */
    int budget;    /* nor any when so many were */
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

/* How far component i may be from its value at the middle m. */
static double spread(const struct walk *w, size_t i, double m, double h)
{
    return jet_spread_at(w->curve->piece[w->piece].degree,
                         curve_component(w->curve, w->piece, i), m, h);
}

/* Whether it keeps off the passage, all along: into a box it must come between
 * both pairs of faces, out of it through one. */
static bool keeps_off(const struct walk *w, double m, const double moves[2])
{
    const size_t n = w->curve->piece[w->piece].degree;
    double off[2];

    if (w->component < w->curve->dim)
        return to_go(w, m) > moves[0];
    for (size_t i = 0; i < 2; i++) {
        const double u = jet_at(n, curve_component(w->curve, w->piece, i), m);
        const double lo = i ? w->box.lo.y : w->box.lo.x;
        const double hi = i ? w->box.hi.y : w->box.hi.x;
        off[i] = w->sign * fmax(lo - u, u - hi) - moves[i];
    }
    return (w->sign > 0.0 ? fmax(off[0], off[1]) : fmin(off[0], off[1])) > 0.0;
}

static bool is_passed(const struct walk *w, double left)
{
    return left < 0.0 || (w->closed && left == 0.0);
}

/* The passage between a, which is before one, and b, if it is beyond. */
static double between(const struct walk *w, double a, double b)
{
    struct newton_root root;

    if (!is_passed(w, to_go(w, b)))
        return PASSAGE_NEVER;
    return newton_find(to_go, w, a, b, 0.0, &root) == STATUS_OK ? root.x : b;
}

/* The first passage after a, which is before one. */
static double search(struct walk *w, double a, double b)
{
    const double m = 0.5 * (a + b), h = 0.5 * (b - a);
    const bool is_box = w->component >= w->curve->dim;
    const double moves[2] = { spread(w, is_box ? 0 : w->component, m, h),
                              is_box ? spread(w, 1, m, h) : 0.0 };
    const double most = fmax(moves[0], moves[1]);

    if (keeps_off(w, m, moves))
        return PASSAGE_NEVER;
    if (!(most > w->least) || isinf(most) || b - a <= w->stride ||
        w->budget-- <= 0)
        return between(w, a, b);
    const double first = search(w, a, m);
    return first <= 1.0 || is_passed(w, to_go(w, m)) ? fmin(first, m)
                                                     : search(w, m, b);
}

static double first(struct walk *w)
{
    w->budget = TOL_ORBIT_STEPS;
    return is_passed(w, to_go(w, 0.0)) ? 0.0 : search(w, 0.0, 1.0);
}

static struct walk through_box(const struct curve *c, struct box b, double sign)
{
    return (struct walk){ .curve = c,
                          .piece = c->count - 1,
                          .box = b,
                          .component = c->dim,
                          .sign = sign,
                          .stride = TOL_PASSAGE_STEP };
}

double passage_into(const struct curve *c, struct box b)
{
    struct walk w = through_box(c, b, 1.0);

    w.closed = true;
    w.stride = TOL_PASSAGE_CHORD;
    w.least = TOL_PASSAGE_CHORD * fmin(b.hi.x - b.lo.x, b.hi.y - b.lo.y);
    return first(&w);
}

double passage_out_of(const struct curve *c, struct box b)
{
    struct walk w = through_box(c, b, -1.0);

    return first(&w);
}

double passage_beyond(const struct curve *c, size_t i, double value)
{
    struct walk w = { .curve = c,
                      .piece = c->count - 1,
                      .component = i,
                      .value = value,
                      .closed = true,
                      .stride = TOL_PASSAGE_STEP };

    return first(&w);
}

double passage_distance(struct box b, struct vec2 z)
{
    return fmax(fmax(b.lo.x - z.x, z.x - b.hi.x),
                fmax(b.lo.y - z.y, z.y - b.hi.y));
}
