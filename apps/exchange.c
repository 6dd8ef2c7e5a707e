#include "exchange.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "report.h"
#include "tolerance.h"

const unsigned exchange_products =
    1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_FOLDS | 1u << PRODUCT_KNEES;

/* ---- branches ------------------------------------------------------------ */

/* Point `theta` of a piece, as an offset. */
static struct vec2 point(const struct branch *b, size_t piece, double theta)
{
    double at[CURVE_DIM_MAX];

    curve_at(&b->curve, piece, theta, at);
    return (struct vec2){ at[0], at[1] };
}

/* |d other/d running| at z, where coordinate `running` runs to infinity. */
static double slope_at(const struct planar *sys, int running, struct vec2 z)
{
    struct planar_field f;

    sys->field(sys->ctx, z, &f);
    const double x = f.direction.x, y = f.direction.y;
    return fabs(running == 0 ? y / x : x / y);
}

static bool has_limit(const struct branch *b)
{
    return b->end == BRANCH_LIMIT_X || b->end == BRANCH_LIMIT_Y;
}

/* How far from the branch's last point on, along its limit, the slope stays
 * above EXCHANGE_FLAT. */
static double way_to_limit(const struct planar *sys, const struct branch *b)
{
    const int running = b->end == BRANCH_LIMIT_X ? 1 : 0;
    struct vec2 z = b->limit;
    double way = 0.0;

    while (way < LN_RANGE && slope_at(sys, running, z) > EXCHANGE_FLAT) {
        way += EXCHANGE_STRIDE;
        *(running == 1 ? &z.y : &z.x) += b->sign * EXCHANGE_STRIDE;
    }
    return way;
}

static struct interchange_branch branch_of(const struct study *s, int side)
{
    const struct branch *b = &s->stable[side];
    const struct vec2 start = point(b, 0, 1.0); /* piece 0 is the series */
    struct vec2 last = start;
    double length = 0.0;

    for (size_t i = 1; i < b->curve.count; i++) {
        const struct vec2 next = point(b, i, 1.0);
        length += hypot(next.x - last.x, next.y - last.y);
        last = next;
    }
    length = has_limit(b) ? length + way_to_limit(&s->slider.plane.system, b)
                          : fmin(length, EXCHANGE_ARC);
    return (struct interchange_branch){
        .name = side == SIDE_UPPER ? "upper" : "lower",
        .start = { s->slider.plane.system.origin.x + start.x,
                   s->slider.plane.system.origin.y + start.y },
        .length = ceil(length) + 1.0,
    };
}

/* ---- steady states ------------------------------------------------------- */

/* Towards the folds: up in alpha along creep, down along the saddles and along
 * sliding above the last fold. */
static double toward(const struct study *s)
{
    const struct quantity *top = &s->folds.alpha_cM;
    const bool creeps =
        s->slider.plane.equilibrium[0].type == EQUILIBRIUM_STABLE_NODE;

    if (!creeps || (quantity_exists(top) && s->scene->alpha > top->value))
        return -1.0;
    return 1.0;
}

static void set_slopes(const struct study *s, double alpha[2])
{
    const struct quantity *fold[] = { &s->folds.alpha_cm, &s->folds.alpha_cM };
    double lo = s->scene->alpha, hi = lo;

    for (int i = 0; i < 2; i++)
        if (quantity_exists(fold[i])) {
            lo = fmin(lo, fold[i]->value);
            hi = fmax(hi, fold[i]->value);
        }
    alpha[0] = fmax(lo - EXCHANGE_MARGIN, lo / 2.0);
    alpha[1] = fmin(hi + EXCHANGE_MARGIN, (hi + M_PI_2) / 2.0);
}

/* The slowest rate at the anchor, per unit of time. */
static double slow_rate(const struct study *s)
{
    const int i =
        slider_saddle(&s->slider) >= 0 ? slider_saddle(&s->slider) : 0;
    const double rate = s->slider.plane.equilibria
                            ? fabs(s->slider.plane.equilibrium[i].lambda[1])
                            : 0.0;

    return rate > 0.0 && isfinite(rate) ? rate : s->slider.block.at.v0;
}

struct interchange exchange_of(const struct study *s, const char *name,
                               const char *remarks)
{
    const struct vec2 at = s->slider.plane.system.origin;
    struct interchange x = {
        .block = &s->slider.block,
        .name = name,
        .remarks = remarks,
        .branches = slider_has_manifolds(&s->slider) ? SIDES : 0,
        .start = { at.x + EXCHANGE_KICK, at.y },
        .time = EXCHANGE_RATES / slow_rate(s),
        .steady =
            s->slider.plane.equilibria ? s->slider.plane.equilibrium[0].z : at,
        .toward = s->slider.plane.equilibria ? toward(s) : 1.0,
        .has_folds = law_uses(&s->slider.block.law, MATERIAL_C) &&
                     (quantity_exists(&s->folds.alpha_cm) ||
                      quantity_exists(&s->folds.alpha_cM)),
    };

    for (size_t i = 0; i < x.branches; i++)
        x.branch[i] = branch_of(s, (int) i);
    set_slopes(s, x.alpha);
    return x;
}

/* ---- remarks ------------------------------------------------------------- */

/* An eigenvector, from the row of J - lambda where less cancels. */
static void print_direction(FILE *out, const struct equilibrium *e, int i)
{
    const struct mat2 *m = &e->matrix;
    const double up = e->scaled[i] - m->xx, down = e->scaled[i] - m->yy;
    const bool first = fabs(up) > fabs(down);
    const struct vec2 d =
        first ? (struct vec2){ m->xy, up } : (struct vec2){ down, m->yx };
    const double size = copysign(hypot(d.x, d.y), d.x);

    fprintf(out, "  along %-10s (%.15g, %.15g)\n",
            i == 0 ? "lambda_minus" : "lambda_plus", d.x / size, d.y / size);
}

static void print_saddle(FILE *out, const struct study *s)
{
    const struct equilibrium *e = phase_plane_saddle(&s->slider.plane);

    fprintf(out,
            "saddle in the chart (ln v, %s)\n"
            "  at               (%s, %s)\n"
            "  lambda           %.15g, %.15g\n",
            text_state_name(&s->slider.block.law, 1),
            number_shortest(e->z.x).text, number_shortest(e->z.y).text,
            e->lambda[0], e->lambda[1]);
    print_direction(out, e, 0);
    print_direction(out, e, 1);
}

char *exchange_remarks(const struct study *s)
{
    char *text = NULL, formula[256];
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);

    if (out == NULL)
        return NULL;
    law_formula(&s->slider.block.law, formula, sizeof formula);
    fprintf(out, "slipway %s\n%s\n\n", SLIPWAY_VERSION, formula);
    const enum status status = report_print(out, s);
    if (slider_has_manifolds(&s->slider))
        print_saddle(out, s);
    fprintf(out, "\nscene\n%s\noverrides\n%s", s->scene->text,
            s->scene->overrides);
    const bool whole = status == STATUS_OK && !ferror(out);
    if (fclose(out) == 0 && whole)
        return text;
    free(text);
    return NULL;
}
