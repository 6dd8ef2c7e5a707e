/* Fields as they are, where they are smooth; else the base point and what it
 * leaves of the slip. */
#include "patch.h"

#include <math.h>
#include <stdlib.h>

#include "fate.h"
#include "patch_field.h"
#include "slow_tolerance.h"

const struct patch_field patch_field[CELL_FIELDS] = {
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

/* ---- numbers ------------------------------------------------------------- */

/* What is fitted: one number of each sample, with its error. */
struct numbers {
    const struct patch_sample *sample;
    struct patch_numbers of;
};

/* ---- fields -------------------------------------------------------------- */

/* The field of every sample, relative errors; how many there are, and the least
 * value. */
static size_t take_field(const struct patch_field *m, struct numbers *n,
                         double *least)
{
    size_t count = 0;

    *least = HUGE_VAL;
    for (size_t i = 0; i < n->of.count; i++) {
        const double value = patch_field_read(&n->sample[i].cell, m->value);
        if (!(value > 0.0 && isfinite(value)))
            continue;
        n->of.value[i] = m->is_log ? log(value) : value;
        n->of.error[i] = patch_field_read(&n->sample[i].cell, m->error) /
                         (m->is_log ? value : 1.0);
        *least = fmin(*least, value);
        count++;
    }
    return count;
}

/* Sets the field's bar: infinite where it is there for some states only, NaN
 * for none. */
static void fit_field(struct patch *p, int field, struct numbers *n)
{
    const struct patch_field *m = &patch_field[field];
    double least;
    const size_t count = take_field(m, n, &least);

    p->bar[field] = count == 0 ? (double) NAN : HUGE_VAL;
    if (count < n->of.count)
        return;
    patch_poly_fit(&p->field[field], &p->x, &p->y, &n->of);
    p->bar[field] = p->field[field].bar / (m->is_log ? 1.0 : least);
}

/* Relative, of the friction that polynomials of slip and of v^2 at arrest tell
 * at most. */
static double friction_bar(const struct patch *p, const struct numbers *n,
                           const struct patch_teller *t)
{
    double worst = 0.0;

    for (size_t i = 0; i < n->of.count; i++) {
        const struct patch_sample *s = &n->sample[i];
        struct cell c = { .slip = s->cell.slip,
                          .slip_error =
                              s->cell.slip * p->field[CELL_SLIP].bar };
        t->friction(t->ctx, s->z, s->left, p->field[CELL_MU_MEAN].bar, &c);
        worst = fmax(worst, c.mu_mean_error / fabs(c.mu_mean));
    }
    return worst;
}

/* By (27) it needs no polynomial, but slip and v^2 at arrest do, which hardly
 * changes: what errs by a part of itself in slip errs by as much of what
 * friction has over tan(alpha), and nothing of tan(alpha) is interpolated. */
static void fit_friction(struct patch *p, struct numbers *n,
                         const struct patch_teller *teller)
{
    double least;
    const size_t count = take_field(&patch_field[CELL_MU_MEAN], n, &least);

    p->bar[CELL_MU_MEAN] = count == 0 ? (double) NAN : HUGE_VAL;
    if (count < n->of.count)
        return;
    if (!(p->which >> CELL_SLIP & 1u))
        fit_field(p, CELL_SLIP, n);
    if (!isfinite(p->bar[CELL_SLIP]))
        return;
    for (size_t i = 0; i < n->of.count; i++) {
        n->of.value[i] = n->sample[i].left;
        n->of.error[i] = n->sample[i].left_error;
    }
    patch_poly_fit(&p->field[CELL_MU_MEAN], &p->x, &p->y, &n->of);
    p->bar[CELL_MU_MEAN] = friction_bar(p, n, teller);
}

/* ---- base points --------------------------------------------------------- */

static bool take_base(int which, struct numbers *n)
{
    for (size_t i = 0; i < n->of.count; i++) {
        const struct base_point *b = &n->sample[i].base;
        n->of.value[i] = which == PATCH_BASE_Y ? b->y : b->more;
        n->of.error[i] = which == PATCH_BASE_Y ? b->y_error : b->more_error;
        if (isnan(n->of.value[i]))
            return false;
    }
    return true;
}

/* The bars of a told cell over what is asked for. */
static double excess_of(const struct patch *p, const struct patch_teller *t,
                        const struct patch_sample *s, double more_bar,
                        double rtol)
{
    const struct base_point b = { s->base.y, p->base[PATCH_BASE_Y].bar,
                                  s->base.more, more_bar, p->late };
    const unsigned which = p->which & by_base & ~p->plain;
    double worst = 0.0;
    struct cell c;

    (void) t->tell(t->ctx, s->z, &b, which, &c);
    for (int k = 0; k < CELL_FIELDS; k++) {
        const double value = patch_field_read(&c, patch_field[k].value);
        if (which >> k & 1u && !isnan(value))
            worst = fmax(worst, patch_field_read(&c, patch_field[k].error) /
                                    fabs(value));
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

    for (size_t i = 0; i < n->of.count; i++) {
        const double y = n->sample[i].base.y;
        if (t->passes(t->ctx, y, y))
            continue;
        const double excess = excess_of(p, t, &n->sample[i], more_bar, rtol);
        n->of.value[count++] = excess;
        wide += excess > 1.0;
    }
    qsort(n->of.value, count, sizeof *n->of.value, by_size);
    *most = count > 0
                ? n->of.value[(size_t) (TOL_PATCH_MOST * (double) (count - 1))]
                : 0.0;
    return wide;
}

/* Along which sides the last coefficients are too large: those of y, or of what
 * it leaves where that is worse. */
static struct patch_verdict judge_tails(const struct patch *p, double most,
                                        double most_by_y)
{
    const bool y = most_by_y > TOL_CLEARLY * most || isinf(most);
    const struct patch_poly *cause =
        &p->base[y ? PATCH_BASE_Y : PATCH_BASE_MORE];
    const double scale = fmin(most, TOL_PATCH_EXCESS) / cause->bar;

    return (struct patch_verdict){ .excess_x = scale * cause->x,
                                   .excess_y = scale * cause->y,
                                   .is_smooth = true };
}

static struct patch_verdict fit_base(struct patch *p, struct numbers *n,
                                     double rtol,
                                     const struct patch_teller *teller)
{
    struct patch_verdict v = { .holds = false };
    double most, most_by_y;

    for (int k = 0; k < PATCH_BASES; k++) {
        if (!take_base(k, n))
            return v;
        patch_poly_fit(&p->base[k], &p->x, &p->y, &n->of);
    }
    p->has_base = true;
    const size_t wide =
        judge_base(p, teller, n, p->base[PATCH_BASE_MORE].bar, rtol, &most);
    judge_base(p, teller, n, 0.0, rtol, &most_by_y);
    v = judge_tails(p, most, most_by_y);
    const double left = (double) wide / (double) n->of.count *
                        (double) (p->x.cells * p->y.cells);
    v.holds = left <= (double) n->of.nodes;
    return v;
}

/* ---- all of it ----------------------------------------------------------- */

static double most_late(const struct numbers *n)
{
    double late = 1.0;

    for (size_t i = 0; i < n->of.count; i++)
        late = fmax(late, n->sample[i].base.late);
    return late;
}

/* Whether any of them may meet a box while it falls. */
static bool falls_by_box(const struct patch *p, const struct patch_teller *t,
                         const struct numbers *n)
{
    struct cell c;

    for (size_t i = 0; i < n->of.count && p->late > 1.0; i++) {
        struct base_point b = n->sample[i].base;
        b.late = p->late;
        if (!isnan(b.y) && !t->tell(t->ctx, n->sample[i].z, &b, 0, &c))
            return true;
    }
    return false;
}

/* Whether a box may lie between their base points, or a little beyond. */
static bool has_box(const struct patch_teller *t, const struct numbers *n)
{
    double lo = HUGE_VAL, hi = -HUGE_VAL;

    for (size_t i = 0; i < n->of.count; i++) {
        const double y = n->sample[i].base.y;
        lo = fmin(lo, isnan(y) ? lo : y);
        hi = fmax(hi, isnan(y) ? hi : y);
    }
    const double more = TOL_MARGIN * (hi - lo);
    return lo <= hi && t->passes(t->ctx, lo - more, hi + more);
}

static int8_t common_fate(const struct numbers *n)
{
    const int8_t first = n->sample[0].cell.exit_reason;

    for (size_t i = 1; i < n->of.count; i++)
        if (n->sample[i].cell.exit_reason != first)
            return FATE_UNDECIDED;
    return first;
}

/* Of a polynomial that errs by `excess` of what it may. */
static void blame(const struct patch_poly *p, double excess,
                  struct patch_verdict *v)
{
    v->excess_x = fmax(v->excess_x, excess * (p->x / p->bar));
    v->excess_y = fmax(v->excess_y, excess * (p->y / p->bar));
}

/* Fields that are good enough as they are; the verdict on the worst other. */
static struct patch_verdict fit_fields(struct patch *p, struct numbers *n,
                                       double rtol,
                                       const struct patch_teller *teller)
{
    struct patch_verdict v = { .holds = true, .is_smooth = true };

    for (int k = 0; k < CELL_FIELDS; k++) {
        if (!(p->which >> k & 1u))
            continue;
        if (k == CELL_MU_MEAN)
            fit_friction(p, n, teller);
        else
            fit_field(p, k, n);
        if (!(p->bar[k] > rtol)) {
            p->plain |= 1u << k;
            continue;
        }
        v.holds = false;
        v.is_smooth = v.is_smooth && isfinite(p->bar[k]);
        if (!isfinite(p->bar[k]))
            continue;
        blame(&p->field[k], p->bar[k] / rtol, &v);
        if (k == CELL_MU_MEAN)
            blame(&p->field[CELL_SLIP], p->bar[k] / rtol, &v);
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

    for (size_t i = 0; i < n->of.nodes; i++) {
        const int kind = kind_of(&n->sample[i]);
        if ((i + 1) % nx != 0)
            x += kind != kind_of(&n->sample[i + 1]);
        if (i + nx < n->of.nodes)
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
    struct numbers n = { .sample = sample, .of.count = count };
    struct patch_verdict fields = { .holds = false }, base = fields;

    n.of.nodes = (size_t) (x->nodes * y->nodes);
    for (size_t i = 0; i < count; i++)
        n.of.z[i] = sample[i].z;
    *p = (struct patch){ .x = *x, .y = *y, .which = which };
    p->exit_reason = common_fate(&n);
    p->late = most_late(&n);
    if (p->exit_reason != FATE_UNDECIDED && !has_box(teller, &n) &&
        !falls_by_box(p, teller, &n))
        fields = fit_fields(p, &n, rtol, teller);
    if (!fields.holds && (which & ~p->plain & ~by_base) == 0)
        base = fit_base(p, &n, rtol, teller);
    return fields.holds || (fields.is_smooth && !base.is_smooth) ? fields
           : base.is_smooth                                      ? base
                            : judge_kinds(p, &n);
}
