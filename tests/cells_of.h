/* cells_of.h -- cells of one slope, for tests. */
#pragma once

#include "cells.h"
#include "slope.h"

enum { ALL = (1 << CELL_FIELDS) - 1 };
static const char *const steady_only[] = { "products=[equilibria]", NULL };

static inline double value_of(const struct cell *c, size_t field)
{
    const struct record_array a = { &record_cell, c, 1 };
    return *(const double *) record_member(&a, 0, &record_cell.fields[field]);
}

/* NaN of a number that does not exist. */
static inline double value(const struct cell *c, enum cell_field k)
{
    return value_of(c, 1 + 2 * (size_t) k);
}

static inline double error(const struct cell *c, enum cell_field k)
{
    return value_of(c, 2 + 2 * (size_t) k);
}

static inline void find(const struct slope *s, const struct vec2 z[], size_t n,
                        double rtol, unsigned which, struct cell out[])
{
    const enum status status =
        cells_find(&s->study.slider, z, n, rtol, which, NULL, out);
    CHECK(status == STATUS_OK, "%s", status_text(status));
}

static inline struct cell find_one(const struct slope *s, double v, double psi,
                                   double rtol)
{
    const struct vec2 z = slope_point(s, v, psi);
    struct cell c;

    find(s, &z, 1, rtol, ALL, &c);
    return c;
}

static inline bool same(const struct cell *a, const struct cell *b)
{
    bool is = a->exit_reason == b->exit_reason;

    for (size_t i = 1; i < record_cell.count; i++) {
        const double x = value_of(a, i), y = value_of(b, i);
        is = is && memcmp(&x, &y, sizeof x) == 0;
    }
    return is;
}

static inline void is_near(const struct cell *c, enum cell_field k,
                           double truth)
{
    CHECK(fabs(value(c, k) - truth) <= error(c, k),
          "%s: %.16g +- %g, not %.16g", record_cell.fields[1 + 2 * k].name,
          value(c, k), error(c, k), truth);
}
