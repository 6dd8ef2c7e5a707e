/* Numbers of the tape at offsets of any size: its exponents add before anything
 * overflows.  An integral of e^h dY ends where h falls faster than -ln Y; h is
 * looked at where Y doubles, up to 1e8 or as far as numbers go. */
#include "quasistatic.h"

#include <math.h>

#include "friction_tolerance.h"
#include "newton.h"
#include "tolerance.h"

/* ---- friction and rates -------------------------------------------------- */

/* A point at which the tape was run. */
struct run {
    const struct real_tape *t;
    double reg[TAPE_STEPS + 2];
};

static void run_at(const struct block *b, double X, double Y, struct run *r)
{
    r->t = &b->plane.t;
    real_tape_run(r->t, X, Y, 1, r->reg);
}

/* mu - tan(alpha) */
static double excess_of(const struct block *b, const struct run *r)
{
    const struct real_tape_form *mu = &r->t->value[0];
    double sum = -b->at.force0;

    for (int i = mu->first; i < mu->first + mu->terms; i++)
        sum += r->t->term[i].c * r->reg[r->t->term[i].reg];
    return sum;
}

static struct vec2 gradient_of(const struct block *b, const struct run *r)
{
    return tape_value_gradient(&b->plane,
                               (struct vec2){ r->reg[0], r->reg[1] });
}

struct search {
    const struct block *b;
    double Y, excess;
};

static double lacking(const void *ctx, double X)
{
    const struct search *s = ctx;
    struct run r;

    run_at(s->b, X, s->Y, &r);
    return excess_of(s->b, &r) - s->excess;
}

/* By Newton's steps from X; where these do not settle, between two X of which
 * one has too little friction and one too much: friction grows with v. */
static double solve(const struct search *s, double X)
{
    struct newton_root root;
    struct run r;
    double last = HUGE_VAL;

    for (int i = 0; i < 12; i++) {
        run_at(s->b, X, s->Y, &r);
        const double step =
            (excess_of(s->b, &r) - s->excess) / gradient_of(s->b, &r).x;
        if (!(fabs(step) < last))
            break;
        X -= step;
        last = fabs(step);
        if (last <= 0x1p-51 * fabs(X))
            return X;
    }
    const double middle = isfinite(X) ? X : 0.0;
    for (double h = TOL_TOUCH * (1.0 + fabs(middle)); isfinite(h); h *= 8.0)
        if (lacking(s, middle - h) < 0.0 && lacking(s, middle + h) > 0.0)
            return newton_find(lacking, s, middle - h, middle + h, 0.0,
                               &root) == STATUS_OK
                       ? root.x
                       : (double) NAN;
    return (double) NAN;
}

double quasistatic_typed_x(const struct block *b, double Y, double *slope)
{
    const struct search s = { b, Y, 0.0 };
    struct run r;

    run_at(b, 0.0, 0.0, &r);
    const struct vec2 first = gradient_of(b, &r);
    const double X = solve(&s, -Y * first.y / first.x);
    run_at(b, X, Y, &r);
    const struct vec2 g = gradient_of(b, &r);
    *slope = -g.y / g.x;
    return X;
}

/* Small ones along the tangent: mu itself has 1e-16 only. */
double quasistatic_typed_above(const struct block *b, double X, double Y,
                               double excess)
{
    const struct search s = { b, Y, excess };
    struct run r;

    run_at(b, X, Y, &r);
    const double d = excess / gradient_of(b, &r).x;
    return d < TOL_ROOT || !isfinite(d) ? d : solve(&s, X + d) - X;
}

double quasistatic_log_rate(const struct block *b, double X, double Y)
{
    struct run r;

    run_at(b, X, Y, &r);
    return real_tape_exponent(r.t, 1, r.reg) +
           log(real_tape_mantissa(r.t, 1, r.reg));
}

/* The largest of a grid of some e-folds around the anchor, and not less than
 * what the material says. */
struct vec2 quasistatic_typed_steep(const struct block *b)
{
    enum { FAR = 32, STEP = 4 };
    struct vec2 most = { b->material.a, b->material.b };
    struct run r;

    for (int i = -FAR; i <= FAR; i += STEP)
        for (int j = -FAR; j <= FAR; j += STEP) {
            run_at(b, i, j, &r);
            const struct vec2 g = gradient_of(b, &r);
            if (isfinite(g.x) && isfinite(g.y)) {
                most.x = fmax(most.x, fabs(g.x));
                most.y = fmax(most.y, fabs(g.y));
            }
        }
    return most;
}

/* dpsi/dt over some e-folds of psi. */
static double growth_at(const struct block *b, double psi)
{
    const bool is_log = law_psi_is_log(&b->law);
    const double Y = is_log ? psi : log(psi);
    struct run r;

    run_at(b, 0.0, Y, &r);
    return (is_log ? 1.0 : psi) * real_tape_mantissa(r.t, 1, r.reg) *
           exp(real_tape_exponent(r.t, 1, r.reg));
}

bool quasistatic_typed_is_linear(const struct block *b)
{
    const double one = growth_at(b, 1.0), two = growth_at(b, 2.0),
                 three = growth_at(b, 3.0);
    const double size = fabs(one) + fabs(two) + fabs(three);

    return fabs(one - 2.0 * two + three) <= TOL_LINEAR * size;
}

/* ---- quadrants ------------------------------------------------------------
 */

bool quasistatic_typed_traps(const struct block *b)
{
    for (double h = 0x1p-6; h < 256.0; h *= 2.0)
        for (int side = -1; side <= 1; side += 2) {
            struct run r;
            run_at(b, 0.0, side * h, &r);
            const double force = real_tape_mantissa(r.t, 0, r.reg);
            run_at(b, side * h, 0.0, &r);
            const double rate = real_tape_mantissa(r.t, 1, r.reg);
            if (force * side > TOL_TOUCH || rate * side > TOL_TOUCH)
                return false;
        }
    return true;
}

/* ---- the end ------------------------------------------------------------- */

enum { DOUBLINGS = 28 };

/* Where Y doubles: ln v_s and ln(dY/dt). */
struct way {
    double x[DOUBLINGS], rate[DOUBLINGS];
    int count;
    bool stops; /* psi grows no further */
};

/* What the mantissa of psi's rate is a sum of. */
static double terms_of(const struct run *r)
{
    const struct real_tape_form *m = &r->t->rate[1].mantissa;
    double sum = fabs(m->constant);

    for (int i = m->first; i < m->first + m->terms; i++)
        sum += fabs(r->t->term[i].c * r->reg[r->t->term[i].reg]);
    return sum;
}

static void go(const struct block *b, struct way *w)
{
    double Y = 1.0, slope;

    *w = (struct way){ .count = 0 };
    for (int i = 0; i < DOUBLINGS; i++, Y *= 2.0) {
        const double X = quasistatic_typed_x(b, Y, &slope);
        struct run r;
        if (!isfinite(X) || !(slope < 0.0))
            break;
        run_at(b, X, Y, &r);
        const double mantissa = real_tape_mantissa(r.t, 1, r.reg);
        if (!(fabs(mantissa) > TOL_ROUNDED * terms_of(&r)))
            break;
        w->stops = mantissa <= 0.0;
        w->count = w->stops ? 0 : w->count;
        if (w->stops)
            continue;
        w->x[w->count] = b->at.x0 + X;
        w->rate[w->count] = real_tape_exponent(r.t, 1, r.reg) + log(mantissa);
        if (isinf(w->rate[w->count++]))
            break;
    }
}

/* Of an integral of e^h. */
enum sum { SUM_OPEN, SUM_ENDS, SUM_UNKNOWN };

/* -dh/d ln Y over the k-th doubling from the last. */
static double power(const double h[], int n, int k)
{
    return (h[n - 2 - k] - h[n - 1 - k]) / M_LN2;
}

/* Whether p goes on as it has: it grows, or it has settled. */
static enum sum sum_of(const double h[], int n)
{
    if (n < 6)
        return SUM_UNKNOWN;
    const double p = power(h, n, 0), q = power(h, n, 1), r = power(h, n, 2);
    const bool grows = fabs(p) > TOL_POWER_GROWTH * fabs(q) &&
                       fabs(q) > TOL_POWER_GROWTH * fabs(r) &&
                       (p > 0) == (q > 0) && TOL_CLEARLY * fabs(p) > 1.0;
    const bool settled = fabs(p - q) <= TOL_LITTLE * fmax(1.0, fabs(p)) &&
                         fabs(p - q) <= TOL_POWER_FALL * fabs(q - r) + TOL_SAME;

    if (!grows && !settled)
        return SUM_UNKNOWN;
    if (fabs(p - 1.0) > TOL_POWER_ONE)
        return p > 1.0 ? SUM_ENDS : SUM_OPEN;
    /* 1/(Y ln^s Y): p - 1 = s/ln Y, and s > 1 would have an end */
    const double s = (p - 1.0) * (n - 1) * M_LN2;
    return fabs(s - 1.0) < TOL_CLEARLY ? SUM_UNKNOWN
           : s > 1.0                   ? SUM_ENDS
                                       : SUM_OPEN;
}

static struct block_end end_of(const struct way *w)
{
    const int n = w->count;
    double late[DOUBLINGS], far[DOUBLINGS];
    struct block_end end = { .course = BLOCK_ENDLESS, .power = 1.0 };

    for (int i = 0; i < n; i++) {
        late[i] = -w->rate[i];
        far[i] = w->x[i] - w->rate[i];
    }
    const enum sum time = sum_of(late, n), slip = sum_of(far, n);
    if (time == SUM_UNKNOWN || (time == SUM_OPEN && slip == SUM_UNKNOWN))
        return (struct block_end){ .course = BLOCK_UNKNOWN, .power = 1.0 };
    if (time == SUM_ENDS) {
        const double v = w->x[n - 1] - w->x[n - 2],
                     t = late[n - 1] - late[n - 2];
        end.course = BLOCK_SOON;
        end.power = fmax(1.0, v / t);
    } else if (slip == SUM_ENDS) {
        end.course = BLOCK_SLOWLY;
    }
    return end;
}

/* Whether inertia cannot hold v back: eps^2 v d ln v/dt grows along the way. */
static bool is_inertial(const struct block *b, const struct way *w)
{
    const int n = w->count;

    if (n == 0)
        return false;
    const double last = w->x[n - 1] + w->rate[n - 1];
    if (isinf(last))
        return last > 0.0;
    return n > 2 && last > w->x[n - 2] + w->rate[n - 2] &&
           last - b->at.x0 - b->at.log_inertia > TOL_INERTIA_LN;
}

/* mu_ss(v) as v goes to 0, or at the last v at which it is a number, where it
 * is past all bounds; NaN: neither. */
static long double last_friction(const struct block *b)
{
    const bool is_low = b->steady.lo <= -(long double) LN_RANGE;
    const long double x = b->steady.lo + (is_low ? 0 : TOL_EXTREMUM_REACH);
    const long double mu = steady_mu(&b->law, &b->material, x);

    return is_low || mu > (long double) TOL_FRICTION_MOST ? mu
                                                          : (long double) NAN;
}

struct block_end quasistatic_typed_end(const struct block *b)
{
    const long double mu = last_friction(b);
    struct block_end end = { .course = BLOCK_UNKNOWN, .power = 1.0 };
    struct way w;

    if (isnan(mu))
        return end;
    end.course = BLOCK_NEVER;
    if (mu <= b->tan_alpha)
        return end;
    go(b, &w);
    if (is_inertial(b, &w))
        end.course = BLOCK_AT_ONCE;
    return w.stops || end.course == BLOCK_AT_ONCE ? end : end_of(&w);
}
