/* Newton steps kept in a bracket. */
#include "strand.h"

#include <float.h>
#include <math.h>

#include "tolerance.h"

struct series strand_series(const struct curve *c, size_t piece, int i)
{
    return (struct series){ curve_component(c, piece, (size_t) i),
                            c->piece[piece].degree };
}

double series_at(struct series p, double theta, double *slope)
{
    double value = p.c[p.degree], rate = 0.0;

    for (size_t k = p.degree; k-- > 0;) {
        rate = rate * theta + value;
        value = value * theta + p.c[k];
    }
    *slope = rate;
    return value;
}

double strand_theta(struct series p, double w, const struct strand_piece *q)
{
    double from = q->from, to = q->to;
    const double part = fmin(fmax((w - q->lo) / (q->hi - q->lo), 0.0), 1.0);
    double theta = from + (to - from) * part;

    for (int i = 0; i < 100; i++) {
        double slope;
        const double off = series_at(p, theta, &slope) - w;
        if (off == 0.0)
            return theta;
        *(off < 0.0 ? &from : &to) = theta;
        double next = theta - off / slope;
        if (!((next > from) == (next < to)) || !isfinite(next))
            next = 0.5 * (from + to);
        if (fabs(next - theta) <= 0x1p-52)
            return next;
        theta = next;
    }
    return theta;
}

/* The bound that a piece states is about its end.  The first one begins at the
 * saddle, where its series is exact. */
double strand_bar(const struct strand_piece *p, double theta)
{
    const struct curve_piece *piece = p->curve->piece;

    if (p->piece == 0)
        return piece[0].error * theta;
    return fmax(piece[p->piece].error, piece[p->piece - 1].error);
}

double strand_rounding(const struct separatrix *s, double w, double at)
{
    return s->slack + TOL_ROUNDINGS_FEW * DBL_EPSILON * (fabs(at) + fabs(w));
}
