/* Close to a node z' = J (z - zero), and the box is around the node: with w
 * from the box's centre to the zero of the field as it is evaluated, and d to
 * that of the law, what falls onto the zero is late at the face as if that were
 * off by w for the one, d for the other, and the way there begins w - d nearer:
 *
 *     |off| <= |w| + |w - d| + what the law's own zero and the origin are off.
 *
 * d is known to the digits of a long double; w is Newton's step from points
 * that are a few roundings from the centre: its largest. */
#include "slow_face.h"

#include <math.h>

#include "fate.h"
#include "place.h"
#include "slider.h"
#include "slow_tolerance.h"

static size_t nearest_node(const struct slider *s, struct vec2 z)
{
    double least = HUGE_VAL;
    size_t node = 0;

    for (size_t i = 0; i < s->plane.equilibria; i++) {
        const struct vec2 d = vec2_sub(z, phase_plane_offset(&s->plane, i));
        const double far = fmax(fabs(d.x), fabs(d.y));
        if ((int) i != slider_saddle(s) && far < least) {
            least = far;
            node = i;
        }
    }
    return node;
}

/* From the offset z to the zero of the field, as evaluated. */
static struct vec2 newton_step(const struct planar *p, struct vec2 z)
{
    struct planar_jacobian J;

    p->jacobian(p->ctx, z, &J);
    const struct mat2 A = J.matrix;
    const struct vec2 f = J.field.direction;
    const double det = mat2_det(A);
    return (struct vec2){ (A.xy * f.y - A.yy * f.x) / det,
                          (A.yx * f.x - A.xx * f.y) / det };
}

/* From the box's centre to the law's zero; *own: how far off that is. */
static struct vec2 to_zero(const struct slider *s, size_t node,
                           struct vec2 *own)
{
    const double x = s->plane.equilibrium[node].z.x;
    const struct vec2 centre = phase_plane_offset(&s->plane, node);
    struct block here = s->block;
    struct steady_root root = { .x = (long double) nextafter(x, -HUGE_VAL),
                                .hi = (long double) nextafter(x, HUGE_VAL) };

    root.at[0] = s->block.steady.balance(&s->block, root.x);
    root.at[1] = s->block.steady.balance(&s->block, root.hi);
    equilibrium_close(&s->block.steady, &s->block, &root);
    block_anchor(&here, root.x, true);
    *own = place_bars(&here);
    return (struct vec2){
        (double) (here.x - s->block.x - (long double) centre.x),
        (double) (here.y - s->block.y - (long double) centre.y),
    };
}

/* |w| + |w - d| normal to the face, for a step from this point. */
static double off_from(const struct slider *s, struct vec2 at,
                       struct vec2 centre, struct vec2 face, struct vec2 d)
{
    const struct vec2 step = newton_step(&s->plane.system, at);
    const struct vec2 w = vec2_add(vec2_sub(at, centre), step);
    const double off = fabs(face.x * w.x + face.y * w.y) +
                       fabs(face.x * (w.x - d.x) + face.y * (w.y - d.y));

    return isnan(off) ? HUGE_VAL : off;
}

double slow_face_error(const struct slider *s, struct vec2 z, double slope)
{
    const size_t node = nearest_node(s, z);
    const struct vec2 centre = phase_plane_offset(&s->plane, node);
    const struct vec2 face = fate_face(z, centre);
    struct vec2 own;
    const struct vec2 d = to_zero(s, node, &own);
    double off = 0.0;

    for (int i = -1; i <= 1; i++)
        for (int j = -1; j <= 1; j++) {
            const struct vec2 at = {
                centre.x + i * TOL_ROUNDED * (1.0 + fabs(centre.x)),
                centre.y + j * TOL_ROUNDED * (1.0 + fabs(centre.y))
            };
            off = fmax(off, off_from(s, at, centre, face, d));
        }
    off += face.x * own.x + face.y * own.y + s->place;
    return face.x > 0.0 ? off / fabs(slope) : off;
}
