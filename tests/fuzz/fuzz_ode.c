/* Models of XPPAUT: read as a system or refused in one line; what a system is
 * inside a box is enclosed by what it is over the box; now and then all its
 * equilibria. */
#include <string.h>

#include "equations.h"
#include "equilibria.h"
#include "fuzz.h"
#include "interval.h"
#include "xpp_model.h"

static struct xpp_model m;
static struct equations e;
static struct interval_plan p;
static struct system_equilibria found;
static formula_real value[FORMULA_NODES];

static bool holds(struct interval_double u, struct interval_quad w)
{
    return u.lo <= w.hi && w.lo <= u.hi;
}

/* The middle of a box is one of its points. */
static void look_at_box(double x, double y, double size)
{
    const struct interval_double box[2] = { { x - size, x + size },
                                            { y - size, y + size } };
    const struct interval_quad at[2] = { { x, x }, { y, y } };
    struct interval_slope_double over[2];
    struct interval_slope_quad here[2];

    if (interval_over_double(&p, box, over) != INTERVAL_WHOLE)
        return;
    MUST(interval_over_quad(&p, at, here) != INTERVAL_NOWHERE);
    for (int i = 0; i < 2; i++) {
        MUST(holds(over[i].value, here[i].value));
        for (int k = 0; k < 2; k++)
            MUST(holds(over[i].by[k], here[i].by[k]));
    }
}

static void look_at_system(struct formula_system *s, bool all)
{
    const int state[2] = { s->state[0].node, s->state[1].node };
    const struct system_window w = { { -1, -0.5 }, { 2, 1.5 } };
    struct fault why = { "" };

    for (int i = 0; i < s->parameters; i++)
        value[s->parameter[i].node] = s->parameter[i].value;
    if (!equations_make(&e, &s->graph, state, s->rate, value))
        return;
    for (int k = 0; k < 2; k++) {
        if (interval_plan(&p, &e.graph, e.variable, k ? e.rate : e.equation, 2,
                          e.value, &why) != STATUS_OK) {
            must_be_a_line(&why);
            return;
        }
        look_at_box(0.3, 0.8, 1e-3);
        look_at_box(-1.2, 0.1, 0.5);
        look_at_box(0, 0, 1e-9);
        look_at_box(20, -30, 3);
    }
    if (!all)
        return;
    MUST(system_equilibria_find(s, &w, &found, &why) != STATUS_NO_MEMORY);
    for (int i = 0; i < found.count; i++)
        MUST(found.equilibrium[i].chart[0].error >= 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = calloc(size + 1, 1);
    struct fault why = { "" };
    unsigned hash = 0;

    MUST(text != NULL);
    if (size)
        memcpy(text, data, size);
    for (size_t i = 0; i < size; i++)
        hash = hash * 31 + data[i];
    const enum status s = xpp_model_read(text, "a.ode", &m, &why);
    MUST(s == STATUS_OK || s == STATUS_BAD_SCENE);
    if (s == STATUS_OK) {
        char *scene = xpp_model_scene(&m, "any");
        MUST(scene != NULL);
        free(scene);
        look_at_system(&m.system, hash % 200 == 0);
        if (m.system.parameters &&
            formula_system_set(&m.system, m.system.parameter[0].name,
                               -m.system.parameter[0].value,
                               (struct formula_place){ .line = 0 },
                               &why) == STATUS_OK)
            look_at_system(&m.system, false);
    } else {
        must_be_a_line(&why);
    }
    free(text);
    return 0;
}
