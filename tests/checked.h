/* checked.h -- tables given as text, checked, and what moved in them. */
#pragma once

#include <string.h>

#include "check.h"
#include "regression.h"
#include "tolerance.h"

/* A table from text, and what became of it. */
struct checked {
    struct table table;
    struct regression r;
};

static inline void check_at(struct checked *c, const char *text, double rtol)
{
    struct fault why;
    enum status s =
        table_parse(&c->table, text, strlen(text), "table.csv", &why);

    CHECK(s == STATUS_OK, "%s", why.text);
    s = regression_run(&c->r, &c->table, rtol, NULL, &why);
    CHECK(s == STATUS_OK, "%s", why.text);
    CHECK(c->r.failed == 0, "%zu rows failed", c->r.failed);
}

static inline void check_text(struct checked *c, const char *text)
{
    check_at(c, text, CHECK_RTOL);
}

static inline void checked_free(struct checked *c)
{
    regression_free(&c->r);
    regression_free(&c->r);
    table_free(&c->table);
}

/* The only finding; of this column. */
static inline const struct finding *only(const struct checked *c,
                                         const char *column)
{
    const struct finding *f = NULL;

    CHECK(c->r.moved == 1, "%s: %zu values moved", column, c->r.moved);
    for (size_t i = 0; i < c->table.rows; i++)
        if (c->r.row[i].findings > 0)
            f = c->r.row[i].finding;
    assert_non_null(f);
    assert_string_equal(f->column, column);
    return f;
}

static inline void holds(const char *text)
{
    struct checked c;

    check_text(&c, text);
    CHECK(c.r.moved == 0, "%s: %s moved by %.3g, tolerance %.3g", text,
          c.r.row[0].finding->column, c.r.row[0].finding->difference,
          c.r.row[0].finding->tolerance);
    checked_free(&c);
}

static inline void moves(const char *text, const char *column)
{
    struct checked c;

    check_text(&c, text);
    only(&c, column);
    checked_free(&c);
}
