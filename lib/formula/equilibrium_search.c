/* Boxes of the window by the mean value form and Krawczyk's operator, both of
 * the equations over a box that is a little wider, so that a zero on an edge is
 * inside of one of them: Neumaier, Interval Methods for Systems of Equations
 * (1990), ch. 5; Moore, Kearfott & Cloud, Introduction to Interval Analysis
 * (2009), 8.2.  For F on a box X, c in X, Y any matrix, J what F' can be on X:
 * zeros of F in X are in K = c - Y F(c) + (1 - Y J)(X - c); if K is inside of
 * X there is exactly one. */
#include "equilibrium_search.h"

#include <math.h>

#include "formula_tolerance.h"
#include "plane.h"
#include "room.h"

enum outcome { BOX_EMPTY, BOX_UNIQUE, BOX_OPEN };

static double width(struct interval_double u)
{
    return u.hi - u.lo;
}

static double middle(struct interval_double u)
{
    return 0.5 * u.lo + 0.5 * u.hi;
}

static bool holds_zero(struct interval_double u)
{
    return u.lo <= 0.0 && u.hi >= 0.0;
}

static struct interval_double point(double x)
{
    return (struct interval_double){ x, x };
}

static struct interval_double meet(struct interval_double u,
                                   struct interval_double w)
{
    return (struct interval_double){ fmax(u.lo, w.lo), fmin(u.hi, w.hi) };
}

static struct interval_double wider(struct interval_double u)
{
    const double room = TOL_MARGIN * width(u) +
                        0x1p-50 * fmax(fabs(u.lo), fabs(u.hi)) + 0x1p-1000;

    return (struct interval_double){ u.lo - room, u.hi + room };
}

/* ---- one box ------------------------------------------------------------- */

/* What is known over a box: around its middle, and the slopes. */
struct look {
    struct interval_double side[2];
    double c[2];
    struct interval_double at_c[2], off[2]; /* F(c), X - c */
    struct interval_double slope[2][2];
    double middle_slope[2][2];
};

/* Over the box, and at its middle. */
static enum outcome look_at(struct equilibrium_search *s, struct look *l)
{
    struct interval_slope_double over[2], at[2];
    const enum interval_domain domain =
        interval_over_double(&s->equation, l->side, over);

    if (domain == INTERVAL_NOWHERE || !holds_zero(over[0].value) ||
        !holds_zero(over[1].value))
        return BOX_EMPTY;
    if (domain == INTERVAL_PARTLY)
        return BOX_OPEN;
    for (int k = 0; k < 2; k++) {
        l->c[k] = middle(l->side[k]);
        l->off[k] = interval_less_double(l->side[k], point(l->c[k]));
    }
    interval_over_double(
        &s->equation,
        (struct interval_double[]){ point(l->c[0]), point(l->c[1]) }, at);
    for (int i = 0; i < 2; i++) {
        struct interval_double sum = l->at_c[i] = at[i].value;
        for (int k = 0; k < 2; k++) {
            l->slope[i][k] = over[i].by[k];
            l->middle_slope[i][k] = middle(over[i].by[k]);
            sum = interval_add_double(
                sum, interval_times_double(over[i].by[k], l->off[k]));
        }
        if (!holds_zero(sum))
            return BOX_EMPTY;
    }
    return BOX_UNIQUE; /* can be decided */
}

/* Row i of K. */
static struct interval_double krawczyk_row(const struct look *l, int i,
                                           const double inverse[2])
{
    struct interval_double sum = point(l->c[i]);

    for (int k = 0; k < 2; k++)
        sum = interval_less_double(
            sum, interval_times_double(point(inverse[k]), l->at_c[k]));
    for (int j = 0; j < 2; j++) {
        struct interval_double left = point(i == j);
        for (int k = 0; k < 2; k++)
            left = interval_less_double(
                left, interval_times_double(point(inverse[k]), l->slope[k][j]));
        sum = interval_add_double(sum, interval_times_double(left, l->off[j]));
    }
    return sum;
}

/* K in place[]; BOX_OPEN where there is none. */
static enum outcome krawczyk(const struct look *l,
                             struct interval_double place[2])
{
    const double(*m)[2] = l->middle_slope;
    const double det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    const double inverse[2][2] = { { m[1][1] / det, -m[0][1] / det },
                                   { -m[1][0] / det, m[0][0] / det } };
    bool inside = true;

    if (!isfinite(inverse[0][0] + inverse[0][1] + inverse[1][0] +
                  inverse[1][1]))
        return BOX_OPEN;
    for (int i = 0; i < 2; i++) {
        place[i] = krawczyk_row(l, i, inverse[i]);
        inside = inside && place[i].lo > l->side[i].lo &&
                 place[i].hi < l->side[i].hi;
    }
    return inside ? BOX_UNIQUE : BOX_OPEN;
}

/* Narrows the box; where it is unique, its zero is in l->side, in place[]. */
static enum outcome narrow(struct equilibrium_search *s, struct search_box *box,
                           struct look *l, struct interval_double place[2])
{
    for (int round = 0; round < 30; round++) {
        bool gained = false;
        for (int k = 0; k < 2; k++)
            l->side[k] = wider(box->side[k]);
        s->out->boxes++;
        const enum outcome seen = look_at(s, l);
        if (seen != BOX_UNIQUE)
            return seen;
        for (int k = 0; k < 2; k++)
            place[k] = l->side[k];
        if (krawczyk(l, place) == BOX_UNIQUE)
            return BOX_UNIQUE;
        for (int k = 0; k < 2; k++) {
            const struct interval_double side = meet(box->side[k], place[k]);
            if (side.lo > side.hi)
                return BOX_EMPTY;
            if (width(box->side[k]) <= s->least[k])
                continue; /* narrower than search_settle can tell */
            gained = gained || width(side) < 0.7 * width(box->side[k]);
            box->side[k] = side;
        }
        if (!gained)
            break;
    }
    return BOX_OPEN;
}

/* ---- all boxes ----------------------------------------------------------- */

static enum status add(struct search_boxes *to, const struct search_box *box)
{
    const enum status status = ROOM_FOR(to->at, to->room, to->count + 1);

    if (status == STATUS_OK)
        to->at[to->count++] = *box;
    return status;
}

static bool is_small(const struct equilibrium_search *s,
                     const struct search_box *box)
{
    for (int k = 0; k < 2; k++) {
        const struct interval_double side = box->side[k];
        if (width(side) >
                s->least[k] +
                    TOL_BOX_LEAST_PART * fmax(fabs(side.lo), fabs(side.hi)) &&
            middle(side) > side.lo && middle(side) < side.hi)
            return false;
    }
    return true;
}

/* The side along which the equations change most, each as a part of all that
 * it changes; the relatively longer one where that is not finite, or does not
 * decide, as of two equations that know nothing of each other. */
static int side_to_part(const struct equilibrium_search *s,
                        const struct search_box *box, const struct look *l)
{
    double change[2] = { 0, 0 };

    for (int i = 0; i < 2; i++) {
        double part[2];
        for (int k = 0; k < 2; k++)
            part[k] = width(box->side[k]) *
                      fmax(fabs(l->slope[i][k].lo), fabs(l->slope[i][k].hi));
        const double sum = part[0] + part[1];
        for (int k = 0; k < 2; k++)
            change[k] += part[k] / sum;
    }
    if (!(fabs(change[0] - change[1]) > TOL_BOX_DECIDES))
        for (int k = 0; k < 2; k++)
            change[k] =
                width(box->side[k]) / (s->window.hi[k] - s->window.lo[k]);
    for (int k = 0; k < 2; k++) /* a side with nothing between its ends */
        if (!(width(box->side[k]) >
              0x1p-50 * fmax(fabs(box->side[k].lo), fabs(box->side[k].hi))))
            return 1 - k;
    return change[1] > change[0];
}

static enum status part(struct equilibrium_search *s,
                        const struct search_box *box, const struct look *l)
{
    const int k = side_to_part(s, box, l);
    const double at = off_middle(box->side[k].lo, box->side[k].hi);
    struct search_box half[2] = { *box, *box };

    half[0].side[k].hi = half[1].side[k].lo = at;
    enum status status = add(&s->boxes, &half[0]);
    if (status == STATUS_OK)
        status = add(&s->boxes, &half[1]);
    return status;
}

static enum status look_into(struct equilibrium_search *s,
                             struct search_box box)
{
    struct look l = { .c = { 0, 0 } };
    struct interval_double place[2];
    const enum outcome found = narrow(s, &box, &l, place);

    if (found == BOX_EMPTY)
        return STATUS_OK;
    if (found == BOX_UNIQUE && search_settle(s, l.side, place))
        return STATUS_OK;
    for (int k = 0; k < 2 && found == BOX_UNIQUE; k++)
        box.side[k] = place[k]; /* if there is one, it is in there */
    if (is_small(s, &box))
        return add(&s->left, &box);
    if (found == BOX_UNIQUE)
        return add(&s->boxes, &box);
    return part(s, &box, &l);
}

enum status search_boxes(struct equilibrium_search *s)
{
    const long most = TOL_SEARCH_EFFORT / (s->equation.effort + 50);
    enum status status = STATUS_OK;
    size_t i = 0;

    for (; i < s->boxes.count && s->out->boxes < most; i++) {
        if ((status = look_into(s, s->boxes.at[i])) != STATUS_OK)
            return status;
    }
    for (; i < s->boxes.count && status == STATUS_OK; i++)
        status = add(&s->left, &s->boxes.at[i]);
    return status;
}
