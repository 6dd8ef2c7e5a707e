/* Gauss' rule on parts of every piece. */
#include "plane_length.h"

#include <math.h>

#include "escape.h"

struct vec2 plane_length_point(const struct plane_branch *b, struct vec2 origin,
                               size_t piece, double theta)
{
    return vec2_add(origin, curve_point(&b->curve.curve, piece, theta));
}

/* Up to where it last leaves the window, for good. */
static void find_shown(const struct plane_study *s, struct plane_branch *b)
{
    enum { SAMPLES = 32 };
    const struct vec2 origin = s->rest[b->rest].z;
    const struct box w = plane_study_box(s);

    for (size_t i = b->curve.curve.count; i-- > 0;) {
        if (!escape_may_touch(&b->curve.curve, i, origin, w))
            continue;
        for (int k = SAMPLES; k >= 0; k--) {
            double in = (double) k / SAMPLES, out = (k + 1.0) / SAMPLES;
            if (!box_holds(w, plane_length_point(b, origin, i, in)))
                continue;
            b->shown = i + 1;
            b->shown_to = 1.0;
            if (k == SAMPLES)
                return;
            for (int n = 0; n < 52; n++) {
                const double middle = 0.5 * (in + out);
                *(box_holds(w, plane_length_point(b, origin, i, middle))
                      ? &in
                      : &out) = middle;
            }
            b->shown_to = in;
            return;
        }
    }
}

/* Five Gauss points on `parts` parts of the piece. */
static double arc(const struct curve *c, size_t piece, double to, int parts)
{
    static const double node[] = { 0.0, 0.5384693101056831, -0.5384693101056831,
                                   0.9061798459386640, -0.9061798459386640 };
    static const double weight[] = { 0.5688888888888889, 0.4786286704993665,
                                     0.4786286704993665, 0.2369268850561891,
                                     0.2369268850561891 };
    double sum = 0.0, slope[CURVE_DIM_MAX];
    const double half = 0.5 * to / parts;

    for (int k = 0; k < parts; k++)
        for (int i = 0; i < 5; i++) {
            curve_slope_at(c, piece, (2 * k + 1 + node[i]) * half, slope);
            sum += half * weight[i] * hypot(slope[0], slope[1]);
        }
    return sum;
}

void plane_length_find(const struct plane_study *s, struct plane_branch *b,
                       double beyond)
{
    double sum = 0.0, error = vec2_length(s->rest[b->rest].error) + beyond;

    find_shown(s, b);
    for (size_t i = 0; i < b->shown; i++) {
        const double to = i + 1 == b->shown ? b->shown_to : 1.0;
        const double fine = arc(&b->curve.curve, i, to, 4);
        const double coarse = arc(&b->curve.curve, i, to, 3);
        sum += fine;
        error += fabs(fine - coarse) + 1e-15 * sum +
                 4.0 * b->curve.curve.piece[i].error;
    }
    b->length = quantity_of(sum, error < sum ? error : HUGE_VAL);
}
