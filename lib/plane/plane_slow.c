#include "plane_slow.h"

#include <math.h>

#include "plane_length.h"
#include "tolerance.h"

enum { LOOKS = 16 }; /* a piece */

/* How fast the plane is at a look, of any curve. */
static double speed_at(const struct plane_slow *w, double look)
{
    const struct vec2 origin = w->s->rest[w->b->rest].z;
    const double piece =
        fmin(floor(look / LOOKS), (double) w->b->curve.curve.count - 1.0);

    return plane_study_speed(
        w->s,
        plane_length_point(w->b, origin, (size_t) piece, look / LOOKS - piece));
}

/* The look at which it is slowest, within one of `look`. */
static double slowest(const struct plane_slow *w, double look)
{
    double best = speed_at(w, look), width = 0.5;

    for (int i = 0; i < 120; i++) {
        const double at = look + (i % 2 ? width : -width);
        const double speed = speed_at(w, at);
        if (speed < best) {
            best = speed;
            look = at;
        } else if (i % 2) {
            width *= 0.5;
        }
    }
    return look;
}

bool plane_slow_next(struct plane_slow *w, size_t *piece, double *theta)
{
    double *speed = w->speed;

    while (w->looks < LOOKS * w->b->curve.curve.count) {
        speed[0] = speed[1];
        speed[1] = speed[2];
        speed[2] = speed_at(w, (double) w->looks++);
        w->fastest = fmax(w->fastest, speed[2]);
        if (speed[1] < speed[0] && speed[1] < speed[2] &&
            speed[1] < TOL_SEEN * w->fastest) {
            const double at = slowest(w, (double) w->looks - 2.0);
            *piece = (size_t) (at / LOOKS);
            *theta = at / LOOKS - (double) *piece;
            return true;
        }
    }
    return false;
}
