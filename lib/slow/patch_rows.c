/* Cells of a patch (patch.h), row by row. */
#include <math.h>

#include "fate.h"
#include "patch.h"
#include "patch_field.h"

/* Polynomials of x on one row: y is done with. */
struct row {
    const struct patch *p;
    const struct patch_teller *teller;
    unsigned told; /* bits: fields by base points */
    double rtol, y;
    struct patch_line field[CELL_FIELDS], base[PATCH_BASES];
};

/* A column, and what its polynomials leave out along it. */
struct place {
    double x, above[CELL_FIELDS], base_above[PATCH_BASES];
    struct patch_point at;
};

static double line_at(const struct row *r, const struct patch_line *l,
                      const struct place *at, double above, double *bar)
{
    return patch_line_at(l, &r->p->x, &at->at, above, bar);
}

/* The fields that base points tell; false: they do not, or too widely. */
static bool tell(const struct row *r, const struct place *at, struct cell *c)
{
    const struct vec2 z = { at->x, r->y };
    struct base_point b = { .late = r->p->late };

    b.y = line_at(r, &r->base[PATCH_BASE_Y], at, at->base_above[PATCH_BASE_Y],
                  &b.y_error);
    b.more = line_at(r, &r->base[PATCH_BASE_MORE], at,
                     at->base_above[PATCH_BASE_MORE], &b.more_error);
    if (!r->teller->tell(r->teller->ctx, z, &b, r->told, c))
        return false;
    for (int k = 0; k < CELL_FIELDS; k++)
        if (r->told >> k & 1u &&
            patch_field_read(c, patch_field[k].error) >
                r->rtol * patch_field_read(c, patch_field[k].value))
            return false;
    return true;
}

/* A field by its polynomial. */
static void add_field(const struct row *r, const struct place *at, int k,
                      struct cell *c)
{
    double error, value = line_at(r, &r->field[k], at, at->above[k], &error);

    value = patch_field[k].is_log ? exp(value) : value;
    patch_field_write(c, patch_field[k].value, value);
    patch_field_write(c, patch_field[k].error,
                      patch_field[k].is_log ? error * value : error);
}

/* By slip, which nobody else may have asked for. */
static void add_friction(const struct row *r, const struct place *at,
                         struct cell *c)
{
    const struct vec2 z = { at->x, r->y };
    struct cell by = *c;
    double error;
    const double left = line_at(r, &r->field[CELL_MU_MEAN], at,
                                at->above[CELL_MU_MEAN], &error);

    if (isnan(by.slip))
        add_field(r, at, CELL_SLIP, &by);
    r->teller->friction(r->teller->ctx, z, left, error, &by);
    c->mu_mean = by.mu_mean;
    c->mu_mean_error = by.mu_mean_error;
}

/* The others asked for, and NaN for those that nobody asked for. */
static void add_plain(const struct row *r, const struct place *at,
                      struct cell *c)
{
    const struct patch *p = r->p;

    for (int k = 0; k < CELL_FIELDS; k++) {
        if (r->told >> k & 1u)
            continue;
        patch_field_write(c, patch_field[k].value, (double) NAN);
        patch_field_write(c, patch_field[k].error, (double) NAN);
        if (!(p->plain >> k & 1u) || isnan(p->bar[k]))
            continue;
        if (k == CELL_MU_MEAN)
            add_friction(r, at, c);
        else
            add_field(r, at, k, c);
    }
}

/* Polynomials that are asked: friction needs that of slip. */
static unsigned lines_of(const struct patch *p)
{
    const unsigned friction = p->plain >> CELL_MU_MEAN & 1u;

    return p->plain | friction << CELL_SLIP;
}

static struct place place_of(const struct patch *p, size_t column)
{
    struct place at = { .x = p->x.at[column] };

    at.at = patch_side_point(&p->x, at.x);
    for (int k = 0; k < CELL_FIELDS; k++)
        if (lines_of(p) >> k & 1u)
            at.above[k] = patch_poly_above(&p->field[k], &p->x, &at.at);
    for (int k = 0; k < PATCH_BASES && p->has_base; k++)
        at.base_above[k] = patch_poly_above(&p->base[k], &p->x, &at.at);
    return at;
}

static void set_row(struct row *r, double y)
{
    const struct patch *p = r->p;
    const struct patch_point level = patch_side_point(&p->y, y);

    r->y = y;
    for (int k = 0; k < CELL_FIELDS; k++)
        if (lines_of(p) >> k & 1u)
            r->field[k] = patch_poly_line(&p->field[k], &p->x, &p->y, &level);
    for (int k = 0; k < PATCH_BASES && r->told; k++)
        r->base[k] = patch_poly_line(&p->base[k], &p->x, &p->y, &level);
}

static void fill_cell(const struct row *r, const struct place *at, int8_t label,
                      struct cell *c)
{
    c->exit_reason = r->p->exit_reason;
    const bool is_told = !r->told || tell(r, at, c);
    add_plain(r, at, c);
    if (!is_told || c->exit_reason != label)
        c->exit_reason = FATE_NONE;
}

void patch_rows(const struct patch *p, size_t first, size_t rows, size_t stride,
                const int8_t label[], double rtol,
                const struct patch_teller *teller, struct cell out[])
{
    enum { TOGETHER = 64 }; /* columns */
    struct place place[TOGETHER];
    struct row r;

    r.p = p;
    r.teller = teller;
    r.told = p->which & ~p->plain;
    r.rtol = rtol;
    for (size_t from = 0; from < p->x.cells; from += TOGETHER) {
        const size_t left = p->x.cells - from;
        const size_t n = left < TOGETHER ? left : TOGETHER;
        for (size_t i = 0; i < n; i++)
            place[i] = place_of(p, from + i);
        for (size_t j = 0; j < rows; j++) {
            const size_t at = j * stride + from;
            set_row(&r, p->y.at[first + j]);
            for (size_t i = 0; i < n; i++)
                fill_cell(&r, &place[i], label[at + i], &out[at + i]);
        }
    }
}
