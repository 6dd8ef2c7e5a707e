/* Pieces are split where their growing coordinate turns (zeros of a
 * polynomial's derivative), joined into strands as long as it grows the same
 * way. */
#include "separatrix.h"

#include <math.h>
#include <stdlib.h>

#include "newton.h"
#include "room.h"
#include "strand.h"

struct separatrix separatrix_empty(int along, struct vec2 origin)
{
    return (struct separatrix){ .along = along, .origin = origin };
}

/* ---- turns --------------------------------------------------------------- */

static double slope_at(const void *ctx, double theta)
{
    double slope;

    series_at(*(const struct series *) ctx, theta, &slope);
    return slope;
}

/* Whether the derivative keeps its sign on [0, 1] because its first term
 * outweighs the others. */
static bool plainly_monotone(struct series p)
{
    double rest = 0.0;

    for (size_t k = 2; k <= p.degree; k++)
        rest += (double) k * fabs(p.c[k]);
    return rest < fabs(p.c[1]);
}

enum { TURNS_MAX = 8, TURN_SAMPLES = 32 };

/* Where p' changes sign within (0, 1). */
static size_t turns(struct series p, double turn[TURNS_MAX])
{
    double before = slope_at(&p, 0.0);
    size_t n = 0;

    if (plainly_monotone(p))
        return 0;
    for (int i = 1; i <= TURN_SAMPLES && n < TURNS_MAX; i++) {
        const double theta = (double) i / TURN_SAMPLES;
        const double here = slope_at(&p, theta);
        struct newton_root root;
        if ((before < 0.0) != (here < 0.0) &&
            newton_find(slope_at, &p, theta - 1.0 / TURN_SAMPLES, theta, 0.0,
                        &root) == STATUS_OK)
            turn[n++] = root.x;
        before = here;
    }
    return n;
}

/* ---- strands ------------------------------------------------------------- */

/* Pieces of a chain in their order, each monotone in `along`. */
struct chain {
    struct separatrix *s;
    struct strand strand; /* being built, falling ones in falling order */
    int way;              /* sign of its growth; 0: empty */
};

static enum status push_piece(struct strand *t, struct strand_piece p)
{
    const enum status s = ROOM_FOR(t->piece, t->room, t->count + 1);

    if (s == STATUS_OK)
        t->piece[t->count++] = p;
    return s;
}

static void turn_round(struct strand *t)
{
    for (size_t i = 0, j = t->count; i + 1 < j--; i++) {
        const struct strand_piece p = t->piece[i];
        t->piece[i] = t->piece[j];
        t->piece[j] = p;
    }
    for (size_t i = 0; i < t->count; i++) {
        const double from = t->piece[i].from;
        t->piece[i].from = t->piece[i].to;
        t->piece[i].to = from;
    }
}

/* Rounding must leave no gap between two pieces. */
static void close_gaps(struct strand *t)
{
    for (size_t i = 1; i < t->count; i++)
        t->piece[i].lo = t->piece[i - 1].hi;
}

static enum status end_strand(struct chain *c)
{
    struct separatrix *s = c->s;
    const double origin = strand_along(s, s->origin);

    if (c->way == 0)
        return STATUS_OK;
    if (ROOM_FOR(s->strand, s->room, s->count + 1) != STATUS_OK)
        return STATUS_NO_MEMORY;
    if (c->way < 0)
        turn_round(&c->strand);
    close_gaps(&c->strand);
    c->strand.way = c->way;
    c->strand.lo = origin + c->strand.piece[0].lo;
    c->strand.hi = origin + c->strand.piece[c->strand.count - 1].hi;
    s->strand[s->count++] = c->strand;
    c->strand = (struct strand){ .piece = NULL };
    c->way = 0;
    return STATUS_OK;
}

static enum status add_flat(struct chain *c, const struct strand_piece *p,
                            double w)
{
    struct separatrix *s = c->s;
    const struct series across =
        strand_series(p->curve, p->piece, 1 - s->along);
    const double base = strand_across(s, s->origin);
    double slope;
    const double one = base + series_at(across, p->from, &slope);
    const double other = base + series_at(across, p->to, &slope);
    const enum status status = ROOM_FOR(s->flat, s->flat_room, s->flats + 1);

    if (status == STATUS_OK)
        s->flat[s->flats++] = (struct flat){
            strand_along(s, s->origin) + w,
            fmin(one, other),
            fmax(one, other),
            p->curve->piece[p->piece].error + strand_rounding(s, w, one),
            s->chains,
        };
    return status;
}

/* `from` and `to` in the chain's order; start and end are the growing
 * coordinate there. */
static enum status add_part(struct chain *c, struct strand_piece p,
                            double start, double end)
{
    const int way = end > start ? 1 : end < start ? -1 : c->way;

    if (start == end)
        return add_flat(c, &p, start);
    if (way != c->way) {
        const enum status status = end_strand(c);
        if (status != STATUS_OK)
            return status;
    }
    c->way = way;
    p.lo = fmin(start, end);
    p.hi = fmax(start, end);
    return push_piece(&c->strand, p);
}

/* One piece of the curve, forward or backward, split where it turns. */
static enum status add_piece(struct chain *c, const struct curve *curve,
                             size_t piece, bool backward)
{
    const struct series p = strand_series(curve, piece, c->s->along);
    double turn[TURNS_MAX], cut[TURNS_MAX + 2], slope;
    const size_t n = turns(p, turn);
    enum status status = STATUS_OK;

    cut[0] = 0.0;
    for (size_t i = 0; i < n; i++)
        cut[i + 1] = turn[i];
    cut[n + 1] = 1.0;
    for (size_t i = 0; i <= n && status == STATUS_OK; i++) {
        const double from = backward ? cut[n + 1 - i] : cut[i];
        const double to = backward ? cut[n - i] : cut[i + 1];
        status = add_part(
            c,
            (struct strand_piece){
                .curve = curve, .piece = piece, .from = from, .to = to },
            series_at(p, from, &slope), series_at(p, to, &slope));
    }
    return status;
}

/* The asymptote beyond a branch's end, if it runs along `along`. */
static enum status add_ray(struct chain *c, const struct branch *b,
                           bool backward)
{
    const enum branch_end end =
        c->s->along == SEPARATRIX_Y ? BRANCH_LIMIT_X : BRANCH_LIMIT_Y;
    const double start = strand_along(c->s, b->limit);
    const double far = b->sign > 0 ? HUGE_VAL : -HUGE_VAL;
    const struct strand_piece p = { .at = strand_across(c->s, b->limit),
                                    .error = strand_across(c->s, b->error) };

    if (b->end != end)
        return STATUS_OK;
    return backward ? add_part(c, p, far, start) : add_part(c, p, start, far);
}

static enum status add_inward(struct chain *c, const struct branch *b)
{
    enum status status = add_ray(c, b, true);

    for (size_t i = b->curve.count; i-- > 0 && status == STATUS_OK;)
        status = add_piece(c, &b->curve, i, true);
    return status;
}

static enum status add_outward(struct chain *c, const struct branch *b)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < b->curve.count && status == STATUS_OK; i++)
        status = add_piece(c, &b->curve, i, false);
    return status == STATUS_OK ? add_ray(c, b, false) : status;
}

enum status separatrix_add(struct separatrix *s, const struct branch *one,
                           const struct branch *other)
{
    struct chain c = { .s = s };
    const size_t first = s->count;
    enum status status = one ? add_inward(&c, one) : STATUS_OK;

    if (status == STATUS_OK && other)
        status = add_outward(&c, other);
    if (status == STATUS_OK)
        status = end_strand(&c);
    free(c.strand.piece);
    s->chains++;
    if (s->count > first) {
        struct strand *start = &s->strand[first];
        struct strand *end = &s->strand[s->count - 1];
        start->ends[start->way < 0] = true;
        end->ends[end->way > 0] = true;
    }
    return status;
}

/* ---- crossings ----------------------------------------------------------- */

/* The piece that holds the offset w: the last one that begins at or below. */
static const struct strand_piece *piece_at(const struct strand *t, double w)
{
    size_t lo = 0, hi = t->count;

    while (hi - lo > 1) {
        const size_t middle = (lo + hi) / 2;
        *(t->piece[middle].lo <= w ? &lo : &hi) = middle;
    }
    return &t->piece[lo];
}

/* Where a strand meets a row, as offsets. */
struct meeting {
    double at, slope; /* slope: of at along the strand */
    double bar;       /* bound on the distance of the true curve */
};

static struct meeting meet(const struct separatrix *s, const struct strand *t,
                           double offset)
{
    const struct strand_piece *p = piece_at(t, offset);
    struct meeting m = { p->at, 0.0, p->error };

    if (p->curve) {
        const struct series up = strand_series(p->curve, p->piece, s->along);
        const struct series out =
            strand_series(p->curve, p->piece, 1 - s->along);
        double rise, run;
        const double theta = strand_theta(up, offset, p);
        series_at(up, theta, &rise);
        m.at = series_at(out, theta, &run);
        m.slope = run / rise;
        m.bar = strand_bar(p, theta);
    }
    m.bar += strand_rounding(s, offset, m.at);
    return m;
}

struct crossing separatrix_cross(const struct separatrix *s, size_t i, double w)
{
    const struct meeting m =
        meet(s, &s->strand[i], w - strand_along(s, s->origin));

    return (struct crossing){ strand_across(s, s->origin) + m.at,
                              m.bar * (1.0 + fabs(m.slope)), i };
}

/* Widens lo .. hi by where the strand is at w, or at its end if that is nearer:
 * flat there, the curve goes on along the row. */
static void widen(const struct separatrix *s, const struct strand *t, double w,
                  double *lo, double *hi)
{
    const double base = strand_along(s, s->origin);
    const bool below = w<t->lo, above = w> t->hi;
    const struct meeting m = meet(s, t, fmin(fmax(w, t->lo), t->hi) - base);
    const bool goes_on =
        (below || above) && t->ends[above] && !(fabs(m.slope) < 1.0);
    const bool right = above == (m.slope > 0.0);

    *lo = goes_on && !right ? -HUGE_VAL : fmin(*lo, m.at);
    *hi = goes_on && right ? HUGE_VAL : fmax(*hi, m.at);
}

bool separatrix_near(const struct separatrix *s, size_t i, double w, double *lo,
                     double *hi)
{
    const struct strand *t = &s->strand[i];
    const double nearest = fmin(fmax(w, t->lo), t->hi);
    const struct meeting m = meet(s, t, nearest - strand_along(s, s->origin));

    if (fabs(w - nearest) > m.bar)
        return false;
    *lo = *hi = m.at;
    widen(s, t, w - m.bar, lo, hi);
    widen(s, t, w + m.bar, lo, hi);
    *lo += strand_across(s, s->origin) - m.bar;
    *hi += strand_across(s, s->origin) + m.bar;
    return true;
}

size_t separatrix_row(const struct separatrix *s, double w,
                      struct crossing out[])
{
    size_t n = 0;

    for (size_t i = 0; i < s->count; i++) {
        if (!(w >= s->strand[i].lo && w < s->strand[i].hi))
            continue;
        const struct crossing c = separatrix_cross(s, i, w);
        size_t k = n++;
        for (; k > 0 && out[k - 1].at > c.at; k--)
            out[k] = out[k - 1];
        out[k] = c;
    }
    return n;
}

void separatrix_free(struct separatrix *s)
{
    for (size_t i = 0; i < s->count; i++)
        free(s->strand[i].piece);
    free(s->strand);
    free(s->flat);
    *s = separatrix_empty(s->along, s->origin);
}
