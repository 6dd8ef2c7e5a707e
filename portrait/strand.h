/* strand.h -- the polynomials that strands (separatrix.h) are made of. */
#pragma once

#include "separatrix.h"

/* The coordinate in which strands grow, and the other one. */
static inline double strand_along(const struct separatrix *s, struct vec2 z)
{
    return s->along == SEPARATRIX_X ? z.x : z.y;
}

static inline double strand_across(const struct separatrix *s, struct vec2 z)
{
    return s->along == SEPARATRIX_X ? z.y : z.x;
}

struct series {
    const double *c;
    size_t degree;
};

/* Component i of a piece. */
struct series strand_series(const struct curve *c, size_t piece, int i);

double series_at(struct series p, double theta, double *slope);

/* The theta where p = w between q->from and q->to, from the first of which to
 * the second it rises from q->lo to q->hi. */
double strand_theta(struct series p, double w, const struct strand_piece *q);

/* The bound of the curve's own at theta. */
double strand_bar(const struct strand_piece *p, double theta);

/* What is off besides at the offset w, at: offsets and series are rounded, the
 * saddle may be. */
double strand_rounding(const struct separatrix *s, double w, double at);
