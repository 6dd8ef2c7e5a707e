#include "proof_knee.h"

#include "proof_cone.h"
#include "proof_flow.h"
#include "proof_short.h"
#include "proof_tolerance.h"

/* What a part of a piece lies in: offsets. */
struct patch {
    struct interval ind, dep;
};

struct seeker {
    struct interval_tape *tape;
    struct proof_branch *b;
    const struct proof_piece *piece;
    const struct proof_cell *cell; /* NULL: in the cone */
    int sign; /* of dy/dx - 1, the last that is proved; 0: none is */
    bool found;
    struct patch at; /* x and y where it is 0 since, if it is: found */
};

static int sign_of(struct interval u)
{
    return u.lo > 0 ? 1 : u.hi < 0 ? -1 : 0;
}

/* Of dy/dx - 1, from d dep/d ind - 1. */
static int sign_on(const struct seeker *s, struct interval over)
{
    return s->piece->ind == 0 ? sign_of(over) : -sign_of(over);
}

/* The part [a, b] of the piece. */
static struct patch box_on(const struct seeker *s, double a, double b)
{
    const struct proof_piece *p = s->piece;
    const struct interval theta = { a, b };
    const double error =
        s->cell ? s->cell->radius : proof_up_times(s->b->cone.slope, b);

    return (struct patch){
        add(point(p->start), times(point(p->step), theta)),
        add(proof_poly_over(p->degree, p->coef, theta), interval_within(error)),
    };
}

/* d dep/d ind - 1 */
static struct interval over_one(const struct seeker *s, const struct patch *w)
{
    struct proof_flow f;

    proof_flow_aside(s->tape, s->piece->ind, w->ind, w->dep, &f);
    return interval_less(interval_divide(f.dep.c[0], f.ind.c[0]), point(1));
}

/* The derivative of G = d dep/d ind by theta along the manifold: step (G_ind +
 * G_dep G), each of them (N' - G M')/M of G = N/M. */
static struct interval bend(const struct seeker *s, const struct patch *w)
{
    struct proof_flow j[2];
    struct interval G[2], slope[2];

    proof_flow_slopes(s->tape, s->piece->ind, w->ind, w->dep, j);
    for (int i = 0; i < 2; i++) {
        const struct interval *ind = j[i].ind.c, *dep = j[i].dep.c;
        G[i] = interval_divide(dep[0], ind[0]);
        slope[i] =
            interval_divide(interval_less(dep[1], times(G[i], ind[1])), ind[0]);
    }
    return times(point(s->piece->step), add(slope[0], times(slope[1], G[0])));
}

/* ---- what follows from a part -------------------------------------------- */

/* A part with a sign: where that is another one, it was 0 once since the last,
 * as its derivative has had no other sign since. */
static void pass(struct seeker *s, int sign)
{
    struct proof_branch *b = s->b;

    if (s->sign < 0 && sign > 0 && b->knees < PROOF_KNEES_MAX)
        b->knee[b->knees++] = (struct proof_crossing){ s->at.ind, s->at.dep };
    s->sign = sign;
    s->found = false;
}

/* It may be 0 in this box. */
static void add_place(struct seeker *s, const struct patch *w)
{
    const bool x = s->piece->ind == 0;
    const struct patch at = { x ? w->ind : w->dep, x ? w->dep : w->ind };

    s->at = s->found ? (struct patch){ interval_hull(s->at.ind, at.ind),
                                       interval_hull(s->at.dep, at.dep) }
                     : at;
    s->found = true;
}

/* Newton's method over intervals, on [a, b]: where it is 0, if it is. */
static void narrow(struct seeker *s, double a, double b)
{
    for (int i = 0; i < PROOF_NEWTONS; i++) {
        const double middle = a / 2 + b / 2, size = b - a;
        const struct patch all = box_on(s, a, b),
                           at = box_on(s, middle, middle);
        const struct interval to = interval_less(
            point(middle), interval_divide(over_one(s, &at), bend(s, &all)));
        a = fmax(a, interval_down(to.lo));
        b = fmin(b, interval_up(to.hi));
        if (!(a <= b)) /* nowhere */
            return;
        if (!(b - a < size / 2))
            break;
    }
    const struct patch at = box_on(s, a, b);
    add_place(s, &at);
}

/* ---- the way ------------------------------------------------------------- */

/* d dep/d ind - 1 on [a, b] with the derivative `bend`, by the mean value
 * theorem. */
static struct interval over_by_mean(const struct seeker *s, double a, double b,
                                    struct interval bend)
{
    const double middle = a / 2 + b / 2;
    const struct patch at = box_on(s, middle, middle);

    return add(
        over_one(s, &at),
        times(bend, interval_less((struct interval){ a, b }, point(middle))));
}

static bool part(struct seeker *s, double a, double b, int depth)
{
    const double middle = a / 2 + b / 2;
    const struct patch w = box_on(s, a, b);
    const bool at_saddle = s->cell == NULL && a <= 0;
    const struct interval over =
        at_saddle ? interval_less(proof_cone_slope(s->tape, s->piece, b,
                                                   s->b->cone.slope),
                                  point(1))
                  : over_one(s, &w);
    int sign = sign_on(s, over);

    if (!sign && !at_saddle) {
        const struct interval by = bend(s, &w);
        if (sign_of(by)) {
            narrow(s, a, b);
            return true;
        }
        sign = sign_on(s, over_by_mean(s, a, b, by));
    }
    if (sign)
        pass(s, sign);
    return sign ||
           (depth < PROOF_KNEE_HALVINGS && middle > a && middle < b &&
            part(s, a, middle, depth + 1) && part(s, middle, b, depth + 1));
}

/* Between the last piece and this one, along the other axis. */
static bool corner(struct seeker *s, const struct proof_piece *last)
{
    const struct proof_piece *p = s->piece;
    const struct proof_cell *before =
        &s->b->cell[last->first + last->cells - 1];
    const double after = s->b->cell[p->first].before;
    const struct interval from =
        add(proof_poly_at(last->degree, last->coef, point(1)),
            interval_within(before->after));
    const struct patch w = { interval_hull(from, point(p->start)),
                             add(point(p->coef[0]), interval_within(after)) };
    const struct interval over = over_one(s, &w);
    const int sign = sign_on(s, over);

    if (!(over.lo > -1)) /* the slope is above 0 */
        return false;
    if (sign)
        pass(s, sign);
    else
        add_place(s, &w);
    return sign || sign_of(bend(s, &w));
}

static bool pass_cells(struct seeker *s)
{
    for (size_t k = 0; k < s->piece->cells; k++) {
        s->cell = &s->b->cell[s->piece->first + k];
        if (!part(s, s->cell->from, s->cell->to, 0))
            return false;
    }
    return true;
}

/* As far as there are cells. */
static bool pass_all(struct seeker *s)
{
    const struct proof_piece *p = s->piece = s->b->piece;

    if (!part(s, 0, s->b->cone.reach, 0))
        return false;
    for (size_t i = 0; i < s->b->pieces && p[i].cells > 0; i++) {
        s->piece = &p[i];
        if (i > 0 && p[i].ind != p[i - 1].ind && !corner(s, &p[i - 1]))
            return false;
        if (!pass_cells(s))
            return false;
    }
    return true;
}

void proof_knees(struct interval_tape *tape, struct proof_branch *b)
{
    struct seeker s = { .tape = tape, .b = b };

    b->knees = 0;
    b->no_more = NULL;
    if (!pass_all(&s))
        b->no_more = "the slope is not proved to pass through 1, nor not to";
    else if (b->beyond)
        pass(&s, b->beyond);
    else
        b->no_more = b->not_proved
                         ? b->not_proved
                         : "beyond the tube the slope may rise through 1";
}
