/*
 * Signs of what the outward direction (p, q) tells of its slope, q - p over
 * |p| + |q|, at sixteenths of the arc, first by its rough shape, and at the
 * vertex of a parabola where three of them may hide two crossings; then
 * bracketed secants.  No series and no polynomials: nothing in common with
 * knee.c.
 */
#include "quad_knee.h"

enum { PARTS = 16, ROOT_STEPS = 200, VERTEX_STEPS = 12 };

static const double near_one = 0.3;    /* closer than this, look closely */
static const double curve_off = 1e-18; /* relative, of the curve */

struct sample {
    quad part, z[2], value;
    bool forward; /* ln v grows outward */
};

static struct sample look(const struct quad_arc *arc, bool rough, quad part)
{
    struct sample s = { .part = part };
    quad way[2];

    arc->at(arc->ctx, rough, part, s.z, way);
    s.value = (way[1] - way[0]) / (fabsq(way[0]) + fabsq(way[1]));
    s.forward = way[0] > 0;
    return s;
}

static bool is_apart(const struct sample *u, const struct sample *w)
{
    return (u->value < 0) != (w->value < 0);
}

static quad secant(const struct sample *u, const struct sample *w, quad off)
{
    const quad slope = (w->value - u->value) / (w->part - u->part);

    return slope == 0 ? 0 : off / fabsq(slope);
}

/* The crossing between lo and hi. */
static void add(const struct quad_arc *arc, struct sample lo, struct sample hi,
                struct quad_knees *out)
{
    const bool grows = lo.value < 0;
    const struct sample from = lo, to = hi;
    quad of_lo = lo.value, of_hi = hi.value;
    int side = 0;

    for (int i = 0; i < ROOT_STEPS && hi.part - lo.part > 1e-30; i++) {
        quad t = hi.part - of_hi * (hi.part - lo.part) / (of_hi - of_lo);
        if (!(t > lo.part && t < hi.part) || i % 3 == 2)
            t = (lo.part + hi.part) / 2;
        const struct sample s = look(arc, false, t);
        const bool low = (s.value < 0) == grows;
        *(low ? &lo : &hi) = s;
        *(low ? &of_lo : &of_hi) = s.value;
        if (side == (low ? -1 : 1))
            *(low ? &of_hi : &of_lo) /= 2;
        side = low ? -1 : 1;
        if (s.value == 0)
            break;
    }
    if (out->count < QUAD_KNEES) {
        const struct sample *s = fabsq(lo.value) < fabsq(hi.value) ? &lo : &hi;
        const quad length =
            fabsq(to.z[0] - from.z[0]) + fabsq(to.z[1] - from.z[1]);
        const quad span = to.part - from.part;
        const quad size = 1 + fabsq(s->z[0]) + fabsq(s->z[1]);
        out->at[out->count] = (struct quad_knee){
            .z = { s->z[0], s->z[1] },
            .error = curve_off * size +
                     secant(&from, &to, curve_off * size) / span * length,
            .rising = grows == s->forward,
        };
    }
    out->count++;
}

/* Of three samples of one sign, the middle one nearest to none. */
static void look_between(const struct quad_arc *arc, struct sample s[3],
                         struct quad_knees *out)
{
    for (int i = 0; i < VERTEX_STEPS; i++) {
        const quad p = s[1].part - s[0].part, q = s[2].part - s[1].part;
        const quad u = (s[1].value - s[0].value) / p;
        const quad w = (s[2].value - s[1].value) / q;
        const quad bend = (w - u) / (p + q);
        const quad t = (s[0].part + s[1].part) / 2 - u / (2 * bend);
        if (!(t > s[0].part && t < s[2].part) || t == s[1].part)
            return;
        const struct sample m = look(arc, false, t);
        if (is_apart(&m, &s[1])) {
            add(arc, s[0], m, out);
            add(arc, m, s[2], out);
            return;
        }
        if (!(fabsq(m.value) < fabsq(s[1].value)))
            return;
        s[t < s[1].part ? 2 : 0] = s[1];
        s[1] = m;
    }
}

static bool may_cross(const struct quad_arc *arc)
{
    const bool above = look(arc, true, 0).value > 0;
    bool may = false;

    for (int i = 0; i <= PARTS; i++) {
        const quad value = look(arc, true, (quad) i / PARTS).value;
        may |= !(fabsq(value) > near_one) || (value > 0) != above;
    }
    return may;
}

void quad_knee_add(const struct quad_arc *arc, struct quad_knees *out)
{
    struct sample s[PARTS + 1];

    if (!may_cross(arc))
        return;
    for (int i = 0; i <= PARTS; i++)
        s[i] = look(arc, false, (quad) i / PARTS);
    for (int i = 0; i < PARTS; i++) {
        if (is_apart(&s[i], &s[i + 1]))
            add(arc, s[i], s[i + 1], out);
        else if (i > 0 && !is_apart(&s[i - 1], &s[i]) &&
                 fabsq(s[i].value) < fabsq(s[i - 1].value) &&
                 fabsq(s[i].value) < fabsq(s[i + 1].value))
            look_between(arc, (struct sample[3]){ s[i - 1], s[i], s[i + 1] },
                         out);
    }
}
