/* Fields as they are, where they are smooth; else the base point and what it
 * leaves of the slip.  A bar holds the last coefficients, the largest miss at
 * the tests a few times over, and the bars of the samples: these errors are
 * smooth, or independent, and no polynomial makes much more of them than they
 * are (Lebesgue's constant, 5, would take signs that alternate). */
#include "patch.h"

#include <math.h>
#include <stdlib.h>

#include "fate.h"
#include "slow_tolerance.h"

/* Where a field lies in struct cell, and whether its logarithm is smooth. */
static const struct member {
    size_t value, error;
    bool is_log;
} member[CELL_FIELDS] = {
    [CELL_SLIP] = { offsetof(struct cell, slip),
                    offsetof(struct cell, slip_error), true },
    [CELL_TIME] = { offsetof(struct cell, time),
                    offsetof(struct cell, time_error), true },
    [CELL_MU_MEAN] = { offsetof(struct cell, mu_mean),
                       offsetof(struct cell, mu_mean_error), false },
    [CELL_V_PEAK] = { offsetof(struct cell, v_peak),
                      offsetof(struct cell, v_peak_error), true },
    [CELL_MU_PEAK] = { offsetof(struct cell, mu_peak),
                       offsetof(struct cell, mu_peak_error), false },
};

static const unsigned by_base =
    1u << CELL_SLIP | 1u << CELL_TIME | 1u << CELL_MU_MEAN;

static double read_at(const struct cell *c, size_t offset)
{
    return *(const double *) ((const char *) c + offset);
}

static void write_at(struct cell *c, size_t offset, double value)
{
    *(double *) ((char *) c + offset) = value;
}

size_t patch_nodes(const struct patch_side *x, const struct patch_side *y,
                   struct vec2 z[PATCH_NODES])
{
    size_t n = 0;

    for (int j = 0; j < y->nodes; j++)
        for (int i = 0; i < x->nodes; i++)
            z[n++] =
                (struct vec2){ patch_side_node(x, i), patch_side_node(y, j) };
    return n;
}

/* ---- polynomials --------------------------------------------------------- */

typedef double coefs[PATCH_SIDE][PATCH_SIDE];

static double value_at(const struct patch *p, coefs c,
                       const double Bx[PATCH_SIDE], const double By[PATCH_SIDE])
{
    double sum = 0.0;

    for (int j = 0; j < p->y.nodes; j++) {
        double row = 0.0;
        for (int i = 0; i < p->x.nodes; i++)
            row += c[j][i] * Bx[i];
        sum += row * By[j];
    }
    return sum;
}

/* What is left out along each side. */
struct tails {
    double x, y;
};

/* By the sizes of the coefficients of each order, made to fall: they go on as
 * they did from the middle on, and the last alone may vanish by symmetry. */
static double tail_of(const struct patch_side *s, double size[PATCH_SIDE])
{
    const int last = PATCH_SIDE - 1, middle = PATCH_SIDE / 2;

    if (s->is_exact)
        return 0.0;
    for (int k = last; k > 0; k--)
        size[k - 1] = fmax(size[k - 1], size[k]);
    const double ratio = cbrt(size[last] / size[middle]);
    const double slow = fmin(ratio > 0.0 ? ratio : 0.0, TOL_PATCH_SLOWEST);
    return size[last] / (1.0 - slow) + TOL_PATCH_BEFORE * size[last - 1];
}

static struct tails tails_of(const struct patch *p, coefs c)
{
    double x[PATCH_SIDE] = { 0.0 }, y[PATCH_SIDE] = { 0.0 };

    for (int j = 0; j < p->y.nodes; j++)
        for (int i = 0; i < p->x.nodes; i++) {
            x[i] += fabs(c[j][i]);
            y[j] += fabs(c[j][i]);
        }
    return (struct tails){ tail_of(&p->x, x), tail_of(&p->y, y) };
}

/* What is fitted: one number of each sample, with its error. */
struct numbers {
    const struct patch_sample *sample;
    size_t count, nodes;
    double value[PATCH_STATES], error[PATCH_STATES];
};

/* Fills c; *bar: of the polynomial. */
static struct tails fit(const struct patch *p, const struct numbers *n, coefs c,
                        double *bar)
{
    double worst = 0.0, off = 0.0, Bx[PATCH_SIDE], By[PATCH_SIDE];

    for (size_t i = 0; i < n->nodes; i++)
        c[i / (size_t) p->x.nodes][i % (size_t) p->x.nodes] = n->value[i];
    for (int i = 0; i < p->y.nodes; i++)
        patch_side_transform(&p->x, c[i], 1);
    for (int i = 0; i < p->x.nodes; i++)
        patch_side_transform(&p->y, &c[0][i], PATCH_SIDE);
    for (size_t i = 0; i < n->count; i++) {
        worst = fmax(worst, n->error[i]);
        if (i >= n->nodes && patch_side_basis(&p->x, n->sample[i].z.x, Bx) &&
            patch_side_basis(&p->y, n->sample[i].z.y, By))
            off = fmax(off, fabs(value_at(p, c, Bx, By) - n->value[i]));
    }
    const struct tails t = tails_of(p, c);
    *bar = fmax(t.x + t.y, TOL_PATCH_TESTS * off) + TOL_PATCH_SPREAD * worst;
    return t;
}

/* ---- fields -------------------------------------------------------------- */

/* The field of every sample, relative errors; how many there are, and the least
 * value. */
static size_t take_field(const struct member *m, struct numbers *n,
                         double *least)
{
    size_t count = 0;

    *least = HUGE_VAL;
    for (size_t i = 0; i < n->count; i++) {
        const double value = read_at(&n->sample[i].cell, m->value);
        if (!(value > 0.0 && isfinite(value)))
            continue;
        n->value[i] = m->is_log ? log(value) : value;
        n->error[i] =
            read_at(&n->sample[i].cell, m->error) / (m->is_log ? value : 1.0);
        *least = fmin(*least, value);
        count++;
    }
    return count;
}

/* Sets the field's bar: infinite where it is there for some states only, NaN
 * for none. */
static struct tails fit_field(struct patch *p, int field, struct numbers *n)
{
    const struct member *m = &member[field];
    double least;
    const size_t count = take_field(m, n, &least);
    struct tails t = { 0.0, 0.0 };

    p->bar[field] = count == 0 ? (double) NAN : HUGE_VAL;
    if (count < n->count)
        return t;
    t = fit(p, n, p->coef[field], &p->bar[field]);
    if (m->is_log)
        return t;
    p->bar[field] /= least;
    return (struct tails){ t.x / least, t.y / least };
}

/* ---- base points --------------------------------------------------------- */

static bool take_base(int which, struct numbers *n)
{
    for (size_t i = 0; i < n->count; i++) {
        const struct base_point *b = &n->sample[i].base;
        n->value[i] = which == PATCH_BASE_Y ? b->y : b->more;
        n->error[i] = which == PATCH_BASE_Y ? b->y_error : b->more_error;
        if (isnan(n->value[i]))
            return false;
    }
    return true;
}

/* The bars of a told cell over what is asked for. */
static double excess_of(const struct patch *p, const struct patch_teller *t,
                        const struct patch_sample *s, double more_bar,
                        double rtol)
{
    const struct base_point b = { s->base.y, p->base_bar[PATCH_BASE_Y],
                                  s->base.more, more_bar };
    const unsigned which = p->which & by_base & ~p->plain;
    double worst = 0.0;
    struct cell c;

    (void) t->tell(t->ctx, s->z, &b, which, &c);
    for (int k = 0; k < CELL_FIELDS; k++) {
        const double value = read_at(&c, member[k].value);
        if (which >> k & 1u && !isnan(value))
            worst = fmax(worst, read_at(&c, member[k].error) / fabs(value));
    }
    return worst / rtol;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *) a, y = *(const double *) b;
    return (x > y) - (x < y);
}

/* Of the samples that pass no box: those whose bars are too wide, and the
 * excess that most of them stay below. */
static size_t judge_base(const struct patch *p, const struct patch_teller *t,
                         struct numbers *n, double more_bar, double rtol,
                         double *most)
{
    size_t count = 0, wide = 0;

    for (size_t i = 0; i < n->count; i++) {
        const double y = n->sample[i].base.y;
        if (t->passes(t->ctx, y, y))
            continue;
        const double excess = excess_of(p, t, &n->sample[i], more_bar, rtol);
        n->value[count++] = excess;
        wide += excess > 1.0;
    }
    qsort(n->value, count, sizeof *n->value, by_size);
    *most = count > 0
                ? n->value[(size_t) (TOL_PATCH_MOST * (double) (count - 1))]
                : 0.0;
    return wide;
}

/* Along which sides the last coefficients are too large: those of y, or of what
 * it leaves where that is worse. */
static struct patch_verdict judge_tails(const struct patch *p,
                                        const struct tails t[PATCH_BASES],
                                        double most, double most_by_y)
{
    const bool y = most_by_y > TOL_PATCH_CAUSE * most || isinf(most);
    const int cause = y ? PATCH_BASE_Y : PATCH_BASE_MORE;
    const double scale = fmin(most, TOL_PATCH_EXCESS) / p->base_bar[cause];

    return (struct patch_verdict){ .excess_x = scale * t[cause].x,
                                   .excess_y = scale * t[cause].y,
                                   .is_smooth = true };
}

static struct patch_verdict fit_base(struct patch *p, struct numbers *n,
                                     double rtol,
                                     const struct patch_teller *teller)
{
    struct patch_verdict v = { .holds = false };
    struct tails t[PATCH_BASES];
    double most, most_by_y;

    for (int k = 0; k < PATCH_BASES; k++) {
        if (!take_base(k, n))
            return v;
        t[k] = fit(p, n, p->base[k], &p->base_bar[k]);
    }
    p->has_base = true;
    const size_t wide =
        judge_base(p, teller, n, p->base_bar[PATCH_BASE_MORE], rtol, &most);
    judge_base(p, teller, n, 0.0, rtol, &most_by_y);
    v = judge_tails(p, t, most, most_by_y);
    const double left =
        (double) wide / (double) n->count * (double) (p->x.cells * p->y.cells);
    v.holds = left <= (double) n->nodes;
    return v;
}

/* ---- all of it ----------------------------------------------------------- */

/* Whether a box may lie between their base points, or a little beyond. */
static bool has_box(const struct patch_teller *t, const struct numbers *n)
{
    double lo = HUGE_VAL, hi = -HUGE_VAL;

    for (size_t i = 0; i < n->count; i++) {
        const double y = n->sample[i].base.y;
        lo = fmin(lo, isnan(y) ? lo : y);
        hi = fmax(hi, isnan(y) ? hi : y);
    }
    const double more = TOL_PATCH_BEYOND * (hi - lo);
    return lo <= hi && t->passes(t->ctx, lo - more, hi + more);
}

static int8_t common_fate(const struct numbers *n)
{
    const int8_t first = n->sample[0].cell.exit_reason;

    for (size_t i = 1; i < n->count; i++)
        if (n->sample[i].cell.exit_reason != first)
            return FATE_UNDECIDED;
    return first;
}

/* Fields that are good enough as they are; the verdict on the worst other. */
static struct patch_verdict fit_fields(struct patch *p, struct numbers *n,
                                       double rtol)
{
    struct patch_verdict v = { .holds = true, .is_smooth = true };

    for (int k = 0; k < CELL_FIELDS; k++) {
        if (!(p->which >> k & 1u))
            continue;
        const struct tails t = fit_field(p, k, n);
        if (!(p->bar[k] > rtol)) {
            p->plain |= 1u << k;
            continue;
        }
        v.holds = false;
        v.is_smooth = v.is_smooth && isfinite(p->bar[k]);
        v.excess_x = fmax(v.excess_x, t.x / rtol);
        v.excess_y = fmax(v.excess_y, t.y / rtol);
    }
    return v;
}

/* Of what kind a sample is; neighbours of different kinds have a boundary
 * between them. */
static int kind_of(const struct patch_sample *s)
{
    return 4 * s->cell.exit_reason + 2 * isnan(s->base.y) + isnan(s->cell.slip);
}

static struct patch_verdict judge_kinds(const struct patch *p,
                                        const struct numbers *n)
{
    const size_t nx = (size_t) p->x.nodes;
    size_t x = 0, y = 0;

    for (size_t i = 0; i < n->nodes; i++) {
        const int kind = kind_of(&n->sample[i]);
        if ((i + 1) % nx != 0)
            x += kind != kind_of(&n->sample[i + 1]);
        if (i + nx < n->nodes)
            y += kind != kind_of(&n->sample[i + nx]);
    }
    return (struct patch_verdict){ .excess_x = 2 * x >= y,
                                   .excess_y = 2 * y >= x };
}

struct patch_verdict patch_fit(struct patch *p, const struct patch_side *x,
                               const struct patch_side *y, unsigned which,
                               double rtol, const struct patch_teller *teller,
                               const struct patch_sample sample[], size_t count)
{
    struct numbers n = { .sample = sample,
                         .count = count,
                         .nodes = (size_t) (x->nodes * y->nodes) };
    struct patch_verdict fields = { .holds = false }, base = fields;

    *p = (struct patch){ .x = *x, .y = *y, .which = which };
    p->exit_reason = common_fate(&n);
    if (p->exit_reason != FATE_UNDECIDED && !has_box(teller, &n))
        fields = fit_fields(p, &n, rtol);
    if (!fields.holds && (which & ~p->plain & ~by_base) == 0)
        base = fit_base(p, &n, rtol, teller);
    return fields.holds || (fields.is_smooth && !base.is_smooth) ? fields
           : base.is_smooth                                      ? base
                            : judge_kinds(p, &n);
}

/* ---- cells --------------------------------------------------------------- */

/* Polynomials of x on one row: y is done with. */
struct row {
    const struct patch *p;
    const struct patch_teller *teller;
    unsigned told; /* bits: fields by base points */
    double rtol, y;
    double field[CELL_FIELDS][PATCH_SIDE], base[PATCH_BASES][PATCH_SIDE];
};

static void contract(const struct patch *p, const double c[][PATCH_SIDE],
                     const double By[PATCH_SIDE], double along[PATCH_SIDE])
{
    for (int i = 0; i < p->x.nodes; i++) {
        along[i] = 0.0;
        for (int j = 0; j < p->y.nodes; j++)
            along[i] += c[j][i] * By[j];
    }
}

static double sum_of(const struct patch *p, const double along[PATCH_SIDE],
                     const double Bx[PATCH_SIDE])
{
    double sum = 0.0;

    for (int i = 0; i < p->x.nodes; i++)
        sum += along[i] * Bx[i];
    return sum;
}

/* The fields that base points tell; false: they do not, or too widely. */
static bool tell(const struct row *r, double x, const double Bx[PATCH_SIDE],
                 struct cell *c)
{
    const struct patch *p = r->p;
    const struct base_point b = { sum_of(p, r->base[PATCH_BASE_Y], Bx),
                                  p->base_bar[PATCH_BASE_Y],
                                  sum_of(p, r->base[PATCH_BASE_MORE], Bx),
                                  p->base_bar[PATCH_BASE_MORE] };
    const struct vec2 z = { x, r->y };

    if (!r->teller->tell(r->teller->ctx, z, &b, r->told, c))
        return false;
    for (int k = 0; k < CELL_FIELDS; k++)
        if (r->told >> k & 1u &&
            read_at(c, member[k].error) > r->rtol * read_at(c, member[k].value))
            return false;
    return true;
}

/* The others asked for, and NaN for those that nobody asked for. */
static void add_plain(const struct row *r, const double Bx[PATCH_SIDE],
                      struct cell *c)
{
    const struct patch *p = r->p;

    for (int k = 0; k < CELL_FIELDS; k++) {
        double value = (double) NAN, error = (double) NAN;
        if (r->told >> k & 1u)
            continue;
        if (p->plain >> k & 1u && !isnan(p->bar[k])) {
            value = sum_of(p, r->field[k], Bx);
            value = member[k].is_log ? exp(value) : value;
            error = p->bar[k] * fabs(value);
        }
        write_at(c, member[k].value, value);
        write_at(c, member[k].error, error);
    }
}

void patch_row(const struct patch *p, size_t first, size_t n, double y,
               const int8_t label[], double rtol,
               const struct patch_teller *teller, struct cell out[])
{
    struct row r = { p,         teller,   p->which & ~p->plain, rtol, y,
                     { { 0 } }, { { 0 } } };
    double Bx[PATCH_SIDE], By[PATCH_SIDE];

    patch_side_basis(&p->y, y, By);
    for (int k = 0; k < CELL_FIELDS; k++)
        if (p->plain >> k & 1u)
            contract(p, p->coef[k], By, r.field[k]);
    for (int k = 0; k < PATCH_BASES && r.told; k++)
        contract(p, p->base[k], By, r.base[k]);
    for (size_t i = 0; i < n; i++) {
        const double x = p->x.at[first + i];
        patch_side_basis(&p->x, x, Bx);
        out[i].exit_reason = p->exit_reason;
        const bool is_told = !r.told || tell(&r, x, Bx, &out[i]);
        add_plain(&r, Bx, &out[i]);
        if (!is_told || out[i].exit_reason != label[i])
            out[i].exit_reason = FATE_NONE;
    }
}
