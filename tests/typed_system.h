/* typed_system.h -- systems as typed, and what is found of their equilibria. */
#pragma once

#include "equilibria.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "interval.h"

static struct formula_system s;
static struct system_equilibria found;
static struct fault why;

/* "real|positive|angle x, ...; a = 1; x' = ...": the parts in this order. */
struct typed {
    enum formula_chart chart[2];
    const char *parameters[8][2];
    const char *defined[6][2];
    const char *rate[2];
};

static inline void type_system(const struct typed *t)
{
    static const char *const name[] = { "x", "y" };
    const struct formula_place at = { "typed", 1, 1 };
    enum status status = STATUS_OK;

    formula_system_init(&s);
    for (int k = 0; k < 2 && status == STATUS_OK; k++)
        status = formula_system_state(&s, name[k], t->chart[k], NULL, at, &why);
    for (int i = 0; t->parameters[i][0] && status == STATUS_OK; i++)
        status = formula_system_parameter(&s, t->parameters[i][0],
                                          t->parameters[i][1], at, &why);
    for (int i = 0; t->defined[i][0] && status == STATUS_OK; i++)
        status = formula_system_define(&s, t->defined[i][0], t->defined[i][1],
                                       at, &why);
    for (int k = 0; k < 2 && status == STATUS_OK; k++)
        status = formula_system_rate(&s, name[k], t->rate[k], at, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
}

static inline void set_to(const char *name, double value)
{
    const struct formula_place at = { "typed", 1, 1 };

    CHECK(formula_system_set(&s, name, value, at, &why) == STATUS_OK, "%s",
          why.text);
}

static inline void find_in(double x0, double x1, double y0, double y1)
{
    const struct system_window w = { { x0, y0 }, { x1, y1 } };
    const enum status status = system_equilibria_find(&s, &w, &found, &why);

    CHECK(status == STATUS_OK, "%s", why.text);
}

static inline void all_found(int count, const char *what)
{
    CHECK(found.complete && found.count == count,
          "%s: %d found, %d undecided, %ld boxes, expected %d", what,
          found.count, found.undecided_count, found.boxes, count);
}

/* One of them is here, within its bar and `room`. */
static inline const struct system_equilibrium *at_place(double x, double y,
                                                        double room)
{
    for (int i = 0; i < found.count; i++) {
        const struct system_equilibrium *q = &found.equilibrium[i];
        if (fabs((double) (q->state[0].value - x)) <=
                q->state[0].error + room &&
            fabs((double) (q->state[1].value - y)) <= q->state[1].error + room)
            return q;
    }
    CHECK(false, "none at (%.17g, %.17g)", x, y);
    return NULL;
}

static inline void is_type(const struct system_equilibrium *q,
                           enum system_equilibrium_type type)
{
    CHECK(q->type == type, "type %d is not %d", (int) q->type, (int) type);
}

static inline void near(const struct system_number *n, double value,
                        double room)
{
    CHECK(fabs((double) (n->value - value)) <= n->error + room &&
              n->error < 1e-25,
          "%.20g +- %g is not %.20g", (double) n->value, n->error, value);
}
