/* made_plane.h -- planar systems of two formulas in x and y, for tests. */
#pragma once

#include <math.h>
#include <string.h>

#include "check.h"
#include "parse.h"
#include "quad.h"
#include "tape_plane.h"

static struct tape_lowered lowered;
static struct tape_plane plane; /* what make() made last */

static const struct formula_value parameters[] = { { "p", 0.7 },
                                                   { "s", -1.3 },
                                                   { NULL, 0 } };

static inline void name_parameters(struct formula *f)
{
    formula_init(f);
    formula_leaf(f, "p", FORMULA_POSITIVE_PARAMETER);
    formula_leaf(f, "s", FORMULA_PARAMETER);
}

static inline int parsed(struct formula *f, const char *text)
{
    struct fault why = { "" };
    int node = 0;
    const enum status s = formula_parse(f, text, &node, &why);

    CHECK(s == STATUS_OK, "%s: %s", text, why.text);
    return node;
}

static inline enum status lower(const char *const rate[2],
                                const bool positive[2], const char *observable,
                                bool equilibrium, struct fault *why)
{
    static struct formula graph;
    struct plane_formulas p = { .observables = 0 };

    name_parameters(&graph);
    for (int i = 0; i < 2; i++)
        p.state[i] =
            formula_leaf(&graph, i ? "y" : "x",
                         positive[i] ? FORMULA_POSITIVE_STATE : FORMULA_STATE);
    for (int i = 0; i < 2; i++)
        p.rate[i] = parsed(&graph, rate[i]);
    if (observable)
        p.observable[p.observables++] = parsed(&graph, observable);
    return tape_plane_lower(&lowered, &graph, &p, equilibrium, why);
}

static inline void make(const char *const rate[2], const bool positive[2],
                        const char *observable, bool equilibrium,
                        const quad at[2])
{
    struct fault why = { "" };
    enum status s = lower(rate, positive, observable, equilibrium, &why);

    if (s == STATUS_OK)
        s = tape_plane_at(&lowered, parameters, at, &plane, &why);
    CHECK(s == STATUS_OK, "%s | %s: %s", rate[0], rate[1], why.text);
}

/* A formula at a state, in 113 bits, plainly. */
static inline quad plain(const char *text, quad x, quad y)
{
    static struct formula f;
    quad value[FORMULA_NODES];

    name_parameters(&f);
    formula_leaf(&f, "x", FORMULA_PARAMETER);
    formula_leaf(&f, "y", FORMULA_PARAMETER);
    const int node = parsed(&f, text);
    const struct formula_value leaf[] = {
        parameters[0], parameters[1], { "x", x }, { "y", y }, { NULL, 0 }
    };
    formula_constants(&f, leaf, NULL, value);
    return value[node];
}
