/* A tape along two curves, or many tapes along one each.  Every step that is
 * not linear needs sums S_k = sum_{0 < j < k} A_j B_{k-j} of rows that are
 * known before order k: the sums of all steps are made at once, as one
 * rectangle of rows by slots, and what a step has left to do at an order is a
 * few operations (tape_orders.c).  The workspace is one array: rows A and B of
 * all parts (the chart's rates, and what an observable adds), their sums, those
 * of the next order, registers at this order, and what each step keeps of order
 * 0.
 *
 * Of a function w = f(u), k w_k is the convolution of j u_j with f'(u): one
 * slot; f' is made of w (Moore 1966, as in core/jet.h). */
#include <string.h>

#include "tape_course.h"
#include "tape_start.h"
#include "tape_sums.h"

static void course_at(struct course *c, const void *const ctx[],
                      struct jet_work *w, size_t k, int part)
{
    const struct tape_plane *p = ctx[0];
    const struct tape_part *of = &p->part[part];
    jet_pair *all = &w->slot[0][0], *rows = all + of->rows;
    const size_t width = (size_t) of->width;

    *c = (struct course){ .p = p,
                          .ctx = ctx,
                          .constant = all + p->constants,
                          .reg = all + p->registers,
                          .keep = all + p->keep,
                          .A = rows + k * width,
                          .B = rows + (JET_SIZE + k) * width,
                          .S = rows + 2 * JET_SIZE * width,
                          .next = rows + (2 * JET_SIZE + 1) * width,
                          .k = jet_number[k],
                          .inverse = jet_inverse[k] };
    if (of->odd) /* nobody's */
        c->A[width - 1] = c->B[width - 1] = JET_PAIR(0.0);
}

/* Places are in bytes of two lanes. */
enum { NEXT = 2 * sizeof(double) };

static inline jet_pair *at(jet_pair *base, unsigned bytes)
{
    return (jet_pair *) (void *) ((char *) base + bytes * (JET_LANES / 2));
}

/* Coefficient of w where w' = u' v, d = k u_k, v0 of order 0; v is told. */
static inline jet_pair chain(const struct course *c, unsigned slot, jet_pair d,
                             jet_pair v0)
{
    *at(c->A, slot) = d;
    return (*at(c->S, slot) + d * v0) * c->inverse;
}

static inline void tell(const struct course *c, unsigned slot, jet_pair v)
{
    *at(c->B, slot) = v;
}

/* ---- orders above -------------------------------------------------------- */

static inline jet_pair growth(const struct course *c, jet_pair u, unsigned slot,
                              jet_pair keep)
{
    const jet_pair e = chain(c, slot, c->k * u, keep);

    tell(c, slot, e);
    return e;
}

/* w' = p u' with the logistic p, p' = (1 - p) w' */
static inline jet_pair mixed(const struct course *c, jet_pair u, unsigned slot,
                             const jet_pair keep[])
{
    const jet_pair w = chain(c, slot, c->k * u, keep[0]),
                   p = chain(c, slot + NEXT, c->k * w, keep[1]);

    tell(c, slot, p);
    tell(c, slot + NEXT, -p);
    return w;
}

/* g' = h u', h' = +-g u' */
static inline jet_pair turning(const struct course *c, jet_pair u,
                               unsigned slot, const jet_pair keep[], bool minus)
{
    const jet_pair d = c->k * u, g = chain(c, slot, d, keep[1]),
                   h = chain(c, slot + NEXT, d, keep[0]);

    tell(c, slot, minus ? -h : h);
    tell(c, slot + NEXT, g);
    return g;
}

/* g' = h u', h' = -2 sign(g) h u' */
static inline jet_pair sinh_joined(const struct course *c, jet_pair u,
                                   unsigned slot, const jet_pair keep[])
{
    const jet_pair g = chain(c, slot, c->k * u, keep[1]);

    tell(c, slot, 2.0 * jet_choose(keep[0] < JET_PAIR(0.0), g, -g));
    return g;
}

/* m = asinh(e^w/2): m' = t w', t = tanh m, t' = b m', b = 1 - t^2 */
static inline jet_pair friction(const struct course *c, jet_pair u,
                                unsigned slot, const jet_pair keep[])
{
    const jet_pair m = chain(c, slot, c->k * u, keep[0]),
                   t = chain(c, slot + NEXT, c->k * m, keep[1]);

    tell(c, slot, t);
    tell(c, slot + NEXT, -(*at(c->S, slot + 2 * NEXT) + 2.0 * keep[0] * t));
    *at(c->A, slot + 2 * NEXT) = t;
    tell(c, slot + 2 * NEXT, t);
    return m;
}

/* t' = b u' with b = 1 + t^2 for tan, 1 - t^2 for tanh */
static inline jet_pair tangent(const struct course *c, jet_pair u,
                               unsigned slot, const jet_pair keep[],
                               bool circular)
{
    const jet_pair t = chain(c, slot, c->k * u, keep[1]),
                   b = *at(c->S, slot + NEXT) + 2.0 * keep[0] * t;

    tell(c, slot, circular ? b : -b);
    *at(c->A, slot + NEXT) = t;
    tell(c, slot + NEXT, t);
    return t;
}

/* d m' = u': m, with 1/d0; d is told */
static inline jet_pair over_slope(const struct course *c, jet_pair u,
                                  unsigned slot, jet_pair over)
{
    const jet_pair dm = (c->k * u - *at(c->S, slot)) * over;

    *at(c->A, slot) = dm;
    return dm * c->inverse;
}

static inline jet_pair apart(const struct course *c, jet_pair u, jet_pair w,
                             unsigned slot, const jet_pair keep[])
{
    const jet_pair less = growth(c, w, slot + NEXT, keep[1]);

    return growth(c, u, slot, keep[0]) - less;
}

static inline jet_pair ln1p(const struct course *c, jet_pair u, unsigned slot,
                            jet_pair over)
{
    tell(c, slot, u);
    return over_slope(c, u, slot, over);
}

/* d = 1 + w^2 for atan; d' = -w m' for asin, w m' for asinh */
static inline jet_pair inverse(const struct course *c, enum jet_code code,
                               jet_pair u, unsigned slot, const jet_pair keep[])
{
    const jet_pair m = over_slope(c, u, slot, keep[1]);
    jet_pair d;

    if (code == JET_ATAN) {
        d = *at(c->S, slot + NEXT) + 2.0 * keep[2] * u;
        *at(c->A, slot + NEXT) = u;
    } else {
        d = chain(c, slot + NEXT, c->k * m, keep[2]);
    }
    tell(c, slot + NEXT, u);
    tell(c, slot, code == JET_ASIN ? -d : d);
    return m;
}

static inline jet_pair product(const struct course *c, unsigned slot,
                               jet_pair u, jet_pair w, const jet_pair keep[])
{
    *at(c->A, slot) = u;
    tell(c, slot, w);
    return *at(c->S, slot) + (keep[0] * w + u * keep[1]);
}

static inline jet_pair quotient(const struct course *c, unsigned slot,
                                jet_pair u, jet_pair w, const jet_pair keep[])
{
    const jet_pair q = (u - keep[0] * w - *at(c->S, slot)) * keep[1];

    *at(c->A, slot) = q;
    tell(c, slot, w);
    return q;
}

/* What entry o makes, from what is at its places. */
#define U    (*at(c->reg, o->a))
#define W    (*at(c->reg, o->b))
#define KEPT at(c->keep, o->keep)
static inline __attribute__((always_inline)) jet_pair entry(
    const struct course *c, const struct jet_op *o)
{
    const jet_pair *C = c->constant + 2 * (o - c->p->op);

    switch ((enum jet_code) o->code) {
        case JET_NOTHING:
            return JET_PAIR(0.0);
        case JET_TIMES:
            return C[0] * U;
        case JET_SUM:
            return U + W;
        case JET_LESS:
            return U - W;
        case JET_ADD:
            return U + C[0] * W;
        case JET_TWO:
            return C[0] * U + C[1] * W;
        case JET_FIXED:
            return U * *KEPT;
        case JET_CHOOSE:
            return jet_choose(*KEPT > JET_PAIR(0.0), U, W);
        case JET_GROWTH:
            return growth(c, U, o->slot, *KEPT);
        case JET_APART:
            return apart(c, U, W, o->slot, KEPT);
        case JET_MIXED:
            return mixed(c, U, o->slot, KEPT);
        case JET_LN1P:
            return ln1p(c, U, o->slot, *KEPT);
        case JET_SINH:
            return turning(c, U, o->slot, KEPT, false);
        case JET_SIN:
            return turning(c, U, o->slot, KEPT, true);
        case JET_SINH_JOINED:
            return sinh_joined(c, U, o->slot, KEPT);
        case JET_FRICTION:
            return friction(c, U, o->slot, KEPT);
        case JET_TAN:
            return tangent(c, U, o->slot, KEPT, true);
        case JET_TANH:
            return tangent(c, U, o->slot, KEPT, false);
        case JET_PRODUCT:
            return product(c, o->slot, U, W, KEPT);
        case JET_QUOTIENT:
            return quotient(c, o->slot, U, W, KEPT);
        case JET_RATE:
            return product(c, o->slot + NEXT, W,
                           growth(c, C[0] * U, o->slot, KEPT[1]), KEPT);
        case JET_RATE_ALONE:
            return KEPT[0] * growth(c, C[0] * U, o->slot, KEPT[1]);
        case JET_ASIN:
        case JET_ATAN:
        case JET_ASINH:
            return inverse(c, (enum jet_code) o->code, U, o->slot, KEPT);
        default:
            __builtin_unreachable();
    }
}

/* The sums where rows A end after the first. */
static inline void sums_of_first(const struct course *c, size_t k, size_t width)
{
    const jet_pair *a = c->A - (k - 1) * width, *b = c->B - width;

    for (size_t i = 0; i < width; i++)
        c->S[i] = k > 1 ? a[i] * b[i] : JET_PAIR(0.0);
}
#undef U
#undef W
#undef KEPT

/* A part's entries of order k > 0 after their sums, of registers `each`. */
#define ORDER(name, sums, target)                                              \
    target static void name(const struct course *c, size_t k,                  \
                            const struct tape_part *part)                      \
    {                                                                          \
        const size_t width = (size_t) part->width;                             \
        const struct course here = *c;                                         \
        const jet_pair *a = c->A - k * width, *b = c->B - k * width;           \
                                                                               \
        if (c->first)                                                          \
            sums_of_first(c, k, width);                                        \
        else if (k % 2)                                                        \
            sums_ended(k, width, a, b, c->S, c->next);                         \
        else                                                                   \
            sums(k, width, width - (JET_LANES > 2 && part->odd), a, b, c->S,   \
                 c->next);                                                     \
        for (const struct jet_op *o = &c->p->op[part->op];                     \
             o < &c->p->op[part->ops]; o++)                                    \
            *at(here.reg, o->out) = entry(&here, o);                           \
    }

#if JET_LANES == 2 || defined __AVX512F__
ORDER(order_plain, sums_by_pairs, )
#else
ORDER(order_plain, sums_by_fours, )
#endif

#if defined __x86_64__ && JET_LANES == 2
ORDER(order_wide, sums_by_fours, __attribute__((target("avx2"))))
#else
#define order_wide order_plain
#endif

static void run(const struct course *c, size_t k, int part)
{
    if (c->p->wide)
        order_wide(c, k, &c->p->part[part]);
    else
        order_plain(c, k, &c->p->part[part]);
}

/* ---- the contract -------------------------------------------------------- */

static void jet(const void *const ctx[], struct jet_work *w, size_t k,
                const jet_pair x[], const jet_pair y[], jet_pair fx[],
                jet_pair fy[])
{
    const struct tape_plane *p = ctx[0];
    struct course c;

    course_at(&c, ctx, w, k, 0);
    c.reg[0] = x[k];
    c.reg[1] = y[k];
    if (k > 0)
        run(&c, k, 0);
    else
        start(&c, w, 0);
    fx[k] = c.reg[p->result[0]];
    fy[k] = c.reg[p->result[1]];
}

static void jet_rate(const void *const ctx[], size_t which, struct jet_work *w,
                     size_t k, const jet_pair x[], const jet_pair y[],
                     jet_pair rate[])
{
    const struct tape_plane *p = ctx[0];
    const int part = 1 + (int) which;
    struct course c;

    course_at(&c, ctx, w, k, part);
    c.first = w->linear && w->linear == (p->part[part].alone == 0   ? x
                                         : p->part[part].alone == 1 ? y
                                                                    : NULL);
    if (k > 0)
        run(&c, k, part);
    else
        start(&c, w, part);
    rate[k] = c.reg[p->result[2 + which]];
}

#if JET_LANES == 2

bool tape_jet_wide(void)
{
    return jet_width() >= 4;
}

void tape_jet(const void *ctx, struct jet_work *w, size_t k, const jet_pair x[],
              const jet_pair y[], jet_pair fx[], jet_pair fy[])
{
    jet((const void *[]){ ctx, ctx }, w, k, x, y, fx, fy);
}

void tape_jet_rate(const void *ctx, size_t which, struct jet_work *w, size_t k,
                   const jet_pair x[], const jet_pair y[], jet_pair rate[])
{
    jet_rate((const void *[]){ ctx, ctx }, which, w, k, x, y, rate);
}

#else

const struct planar_many TAPE_MANY = {
    .width = JET_WIDTH,
    .alike = tape_alike,
    .jet = jet,
    .rate_jet = jet_rate,
    .look = TAPE_LOOK,
};

#endif
