/* Arc length in the drawing instead of time, so that fast and slow motion cost
 * the same; Bogacki & Shampine, Appl. Math. Lett. 2 (1989) 321-325, 3(2).
 * Backward in time an orbit leaves what attracts it: nothing is stiff. */
#include "streamline.h"

#include <math.h>

#include "tolerance.h"

struct walk {
    const struct planar *system; /* borrowed */
    const struct window *window; /* borrowed */
    size_t evaluations;
};

/* Against the field, of length 1; 0 where it has no direction. */
static struct vec2 walk_way(struct walk *w, struct vec2 unit)
{
    const struct box d = w->system->domain;
    struct vec2 z = window_at(w->window, unit);
    struct planar_field f;

    z.x = fmin(fmax(z.x, d.lo.x), d.hi.x);
    z.y = fmin(fmax(z.y, d.lo.y), d.hi.y);
    w->evaluations++;
    w->system->field(w->system->ctx, vec2_sub(z, w->system->origin), &f);
    const struct vec2 v = window_push(w->window, z, f.direction);
    const double r = vec2_length(v);
    return r > 0.0 && isfinite(r) ? vec2_scale(-1.0 / r, v)
                                  : (struct vec2){ 0.0, 0.0 };
}

static struct vec2 ahead(struct vec2 at, double h, struct vec2 way)
{
    return vec2_add(at, vec2_scale(h, way));
}

/* One step of length h from `at`, where the way is *way, which becomes that at
 * the end; returns by how much it may be off. */
static double walk_step(struct walk *w, struct vec2 at, double h,
                        struct vec2 *way, struct vec2 *to)
{
    const struct vec2 a = *way, b = walk_way(w, ahead(at, h / 2.0, a));
    const struct vec2 c = walk_way(w, ahead(at, 0.75 * h, b));

    *to =
        ahead(ahead(ahead(at, 2.0 / 9.0 * h, a), h / 3.0, b), 4.0 / 9.0 * h, c);
    const struct vec2 d = walk_way(w, *to);
    const struct vec2 off = {
        -5.0 / 72.0 * a.x + b.x / 12.0 + c.x / 9.0 - d.x / 8.0,
        -5.0 / 72.0 * a.y + b.y / 12.0 + c.y / 9.0 - d.y / 8.0
    };
    *way = d;
    return h * vec2_length(off);
}

static bool inside(struct vec2 u)
{
    return u.x >= 0.0 && u.x <= 1.0 && u.y >= 0.0 && u.y <= 1.0;
}

/* Where a straight line from a, inside, to b, outside, meets the frame. */
static struct vec2 at_frame(struct vec2 a, struct vec2 b)
{
    const double from[] = { a.x, a.y }, to[] = { b.x, b.y };
    double part = 1.0, side = 0.0;
    int axis = 0;

    for (int k = 0; k < 2; k++) {
        const double edge = to[k] < 0.0 ? 0.0 : 1.0;
        const double here = (edge - from[k]) / (to[k] - from[k]);
        if ((to[k] < 0.0 || to[k] > 1.0) && here < part) {
            part = here;
            side = edge;
            axis = k;
        }
    }
    struct vec2 u = ahead(a, part, vec2_sub(b, a));
    *(axis ? &u.y : &u.x) = side;
    return u;
}

/* The next step's length, after one of length h that was off by so much. */
static double next_length(double h, double off)
{
    const double wish = 0.9 * cbrt(TOL_DRAWN / fmax(off, 1e-300));

    return fmin(h * fmin(2.0, wish), TOL_STREAMLINE_STEP);
}

enum status streamline_back(const struct planar *system,
                            const struct window *window, struct vec2 z,
                            struct polyline *way, size_t *evaluations)
{
    struct walk w = { system, window, 0 };
    struct vec2 at = window_unit(window, z), along = walk_way(&w, at);
    double h = TOL_STREAMLINE_STEP, gone = 0.0;
    enum status s = polyline_push(way, at);

    while (s == STATUS_OK && inside(at) && gone < TOL_STREAMLINE_LENGTH &&
           h > TOL_DRAWN) {
        struct vec2 then = along, to;
        const double off = walk_step(&w, at, h, &then, &to);
        if (off <= TOL_DRAWN) {
            s = polyline_push(way, inside(to) ? to : at_frame(at, to));
            gone += h;
            at = to;
            along = then;
        }
        h = next_length(h, off);
    }
    *evaluations += w.evaluations;
    return s;
}
