/* Differences between neighbours.  L, V_star and g enter through
 * eps2 = V_star^2/(g L) alone: nudging g speaks for all three, and counts
 * 1 + 1 + 2 times. */
#include "row_inputs.h"

#include <math.h>

#include "tolerance.h"

/* Inputs that a row may have rounded: keys of the material, and alpha. */
enum { INPUT_ALPHA = MATERIAL_KEYS, INPUTS };

struct nearby {
    const struct slope_row *s;
    size_t law;
    double rtol;
    unsigned products;
};

/* How often an input's rounding counts. */
static double weight(const struct nearby *at, int input)
{
    const enum material_key key = (enum material_key) input;

    if (input == INPUT_ALPHA)
        return isnan(at->s->alpha) ? 0.0 : 1.0;
    if (key == MATERIAL_L || key == MATERIAL_V_STAR ||
        !law_uses(&at->s->law[at->law], key))
        return 0.0;
    return key == MATERIAL_G ? 4.0 : 1.0;
}

/* The row's numbers with one input multiplied by 1 - nudge and 1 + nudge. */
struct pair {
    struct row_numbers down, up;
    bool found; /* both could be computed */
};

static enum status neighbours(const struct nearby *at, int input, double nudge,
                              struct pair *p)
{
    struct fault why;

    p->found = true;
    for (int side = -1; side <= 1; side += 2) {
        struct slope_row moved = *at->s;
        double *value =
            input == INPUT_ALPHA
                ? &moved.alpha
                : material_member(&moved.material, (enum material_key) input);
        *value *= 1.0 + side * nudge;
        if (moved.alpha >= M_PI_2) {
            p->found = false;
            return STATUS_OK;
        }
        const enum status status =
            row_numbers_find(&moved, at->law, at->rtol, at->products,
                             side < 0 ? &p->down : &p->up, &why);
        if (status == STATUS_NO_MEMORY)
            return status;
        p->found = p->found && status == STATUS_OK;
    }
    return STATUS_OK;
}

/* ---- what rounding costs ------------------------------------------------- */

/* |dq/dp| |p|, from the neighbours at +-nudge; one will do; infinite without
 * any. */
static double rate(const struct quantity *q, const struct quantity *up,
                   const struct quantity *down, double nudge)
{
    const bool above = quantity_exists(up), below = quantity_exists(down);

    if (!quantity_exists(q))
        return 0.0;
    if (above && below)
        return fabs(up->value - down->value) / (2.0 * nudge);
    if (above || below)
        return fabs((above ? up : down)->value - q->value) / nudge;
    return HUGE_VAL;
}

/* Whether both neighbours have what n has. */
static bool alike(const struct row_numbers *n, const struct pair *p)
{
    for (size_t i = 0; i < record_row.count && p->found; i++) {
        const struct record_field *f = &record_row.fields[i];
        if (f->kind == RECORD_QUANTITY && quantity_exists(row_quantity(n, f)) &&
            !(quantity_exists(row_quantity(&p->up, f)) &&
              quantity_exists(row_quantity(&p->down, f))))
            return false;
    }
    return p->found;
}

static enum status add_input(const struct nearby *at, int input,
                             const struct row_numbers *n,
                             struct row_numbers *cost)
{
    const double unit = CHECK_MARGIN * 0x1p-53 * weight(at, input);
    struct pair p;
    double nudge = CHECK_NUDGE;
    enum status status = neighbours(at, input, nudge, &p);

    while (status == STATUS_OK && !alike(n, &p) && nudge > CHECK_NUDGE_MIN)
        status = neighbours(at, input, nudge *= 0.01, &p);
    for (size_t i = 0; i < record_row.count && status == STATUS_OK; i++) {
        const struct record_field *f = &record_row.fields[i];
        struct quantity *sum = (void *) ((char *) cost + f->offset);
        if (f->kind != RECORD_QUANTITY)
            continue;
        sum->value +=
            p.found ? unit * rate(row_quantity(n, f), row_quantity(&p.up, f),
                                  row_quantity(&p.down, f), nudge)
                    : HUGE_VAL;
    }
    return status;
}

enum status row_inputs_cost(const struct slope_row *s, size_t law, double rtol,
                            unsigned products, const struct row_numbers *n,
                            struct row_numbers *cost)
{
    const struct nearby at = { s, law, rtol, products };
    struct row_numbers plain = *n;
    enum status status = STATUS_OK;

    /* neighbours have none, and their bars are wider than any rounding */
    plain.dlnvplus_dalpha = plain.dlnlower_dalpha = quantity_none("");
    *cost = (struct row_numbers){ .type = -1 };
    for (int input = 0; input < INPUTS && status == STATUS_OK; input++)
        if (weight(&at, input) > 0.0)
            status = add_input(&at, input, &plain, cost);
    return status;
}

/* ---- derivatives --------------------------------------------------------- */

/* ln v_plus (which = 0), the chart's v_minus or psi_at_v0 (1): its logarithm,
 * or psi where it is one; with its bar; false if missing. */
static bool chart_limit(const struct nearby *at, const struct row_numbers *n,
                        int which, double *value, double *error)
{
    const struct critical_numbers *c = &n->critical;
    const struct quantity *q = which == 0 ? &c->ln_v_plus
                               : quantity_exists(&c->ln_v_minus)
                                   ? &c->ln_v_minus
                                   : &c->psi_at_v0;
    const bool is_log =
        q != &c->psi_at_v0 || law_psi_is_log(&at->s->law[at->law]);

    if (!quantity_exists(q))
        return false;
    *value = is_log ? q->value : log(q->value);
    *error = is_log ? q->error : q->error / q->value;
    return true;
}

struct ridders {
    double last[CHECK_RIDDERS_STEPS]; /* a row of the tableau */
    int rows;
    double value, error; /* the best so far */
};

/* One more central difference, at a nudge smaller by the ratio, with its own
 * bar, which extrapolation at most doubles. */
static void ridders_add(struct ridders *r, double difference, double bar)
{
    double row[CHECK_RIDDERS_STEPS] = { difference };
    double factor = 1.0;

    for (int j = 1; j <= r->rows; j++) {
        factor *= CHECK_RIDDERS_RATIO * CHECK_RIDDERS_RATIO;
        row[j] = row[j - 1] + (row[j - 1] - r->last[j - 1]) / (factor - 1.0);
        const double change =
            fmax(fabs(row[j] - row[j - 1]), fabs(row[j] - r->last[j - 1]));
        const double error = CHECK_RIDDERS_BAR * change + 2.0 * bar;
        if (error < r->error) {
            r->error = error;
            r->value = row[j];
        }
    }
    r->rows++;
    for (int j = 0; j < r->rows; j++)
        r->last[j] = row[j];
}

/* One more level, if both neighbours have the limit. */
static void add_level(const struct nearby *at, const struct pair *p, int which,
                      double nudge, struct ridders *r)
{
    const double width = 2.0 * nudge * at->s->alpha;
    double up, down, up_error, down_error;

    if (chart_limit(at, &p->up, which, &up, &up_error) &&
        chart_limit(at, &p->down, which, &down, &down_error))
        ridders_add(r, (up - down) / width, (up_error + down_error) / width);
}

/* A smaller error would not be told; nor is there one of what n lacks. */
static bool is_done(const struct nearby *at, const struct row_numbers *n,
                    int which, const struct ridders *r)
{
    double value, error;

    return !chart_limit(at, n, which, &value, &error) ||
           r->error <= CHECK_RIDDERS_FLOOR * fabs(r->value);
}

static struct quantity derivative(const struct ridders *r)
{
    if (!isfinite(r->error))
        return quantity_none("there is no such derivative at this slope");
    return quantity_of(r->value,
                       fmax(r->error, CHECK_RIDDERS_FLOOR * fabs(r->value)));
}

enum status row_inputs_derive(const struct slope_row *s, size_t law,
                              double rtol, struct row_numbers *n)
{
    const struct nearby at = { s, law, rtol, 1u << PRODUCT_KNEES };
    struct ridders r[2] = { { .error = HUGE_VAL }, { .error = HUGE_VAL } };
    double nudge = CHECK_RIDDERS_START;
    bool done = false;

    for (int k = 0; k < CHECK_RIDDERS_STEPS && !done; k++) {
        struct pair p;
        const enum status status = neighbours(&at, INPUT_ALPHA, nudge, &p);
        if (status != STATUS_OK)
            return status;
        for (int i = 0; i < 2 && p.found; i++)
            add_level(&at, &p, i, nudge, &r[i]);
        nudge /= CHECK_RIDDERS_RATIO;
        done = is_done(&at, n, 0, &r[0]) && is_done(&at, n, 1, &r[1]);
    }
    n->dlnvplus_dalpha = derivative(&r[0]);
    n->dlnlower_dalpha = derivative(&r[1]);
    return STATUS_OK;
}
