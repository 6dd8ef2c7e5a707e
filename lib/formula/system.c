#include "system.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formula_tolerance.h"
#include "interval.h"
#include "spell.h"

void formula_system_init(struct formula_system *s)
{
    formula_init(&s->graph);
    s->states = s->parameters = s->observables = s->entries = s->letters = 0;
    s->rate[0] = s->rate[1] = -1;
}

/* ---- names --------------------------------------------------------------- */

static bool is_identifier(const char *name)
{
    bool good = isalpha((unsigned char) name[0]) || name[0] == '_';

    for (const char *c = name; *c; c++)
        good = good && (isalnum((unsigned char) *c) || *c == '_');
    return good;
}

int formula_system_find_state(const struct formula_system *s, const char *name)
{
    for (int i = 0; i < s->states; i++)
        if (strcmp(s->state[i].name, name) == 0)
            return i;
    return -1;
}

int formula_system_find_parameter(const struct formula_system *s,
                                  const char *name)
{
    for (int i = 0; i < s->parameters; i++)
        if (strcmp(s->parameter[i].name, name) == 0)
            return i;
    return -1;
}

/* A new name, of `kind`, that formulas can use. */
static enum status check_name(const struct formula_system *s, const char *kind,
                              const char *name, struct formula_place at,
                              struct fault *why)
{
    if (strlen(name) >= FORMULA_NAME)
        return formula_blame(at, why, "%s %.20s...: longer than %d letters",
                             kind, name, FORMULA_NAME - 1);
    if (!is_identifier(name))
        return formula_blame(at, why,
                             "%s '%s', expected a name of letters, digits and "
                             "_ that begins with a letter",
                             kind, name);
    if (formula_is_function(name) || strcmp(name, "pi") == 0)
        return formula_blame(at, why, "%s %s: formulas have %s already", kind,
                             name, name);
    if (formula_find(&s->graph, name, strlen(name)) >= 0)
        return formula_blame(at, why, "%s %s: there is one of this name", kind,
                             name);
    return STATUS_OK;
}

/* ---- states and parameters ----------------------------------------------- */

static int add_state(struct formula *f, const struct system_state *x)
{
    return formula_leaf(f, x->name,
                        x->chart == CHART_POSITIVE ? FORMULA_POSITIVE_STATE
                                                   : FORMULA_STATE);
}

static int add_parameter(struct formula *f, const struct system_parameter *p)
{
    const int leaf = formula_leaf(f, p->name,
                                  p->value > 0 ? FORMULA_POSITIVE_PARAMETER
                                               : FORMULA_PARAMETER);

    formula_know(f, leaf, p->value);
    return leaf;
}

enum status formula_system_state(struct formula_system *s, const char *name,
                                 enum formula_chart chart, const char *period,
                                 struct formula_place at, struct fault *why)
{
    struct system_state new = { .chart = chart };
    enum status status = check_name(s, "state", name, at, why);

    if (status == STATUS_OK && s->states == 2)
        status =
            formula_blame(at, why, "state %s is the third, expected two", name);
    if (status == STATUS_OK && chart == CHART_ANGLE) {
        new.period = 2 * formula_pi();
        if (period)
            status = formula_parse_decimal(period, at, &new.period, why);
        if (status == STATUS_OK && !(new.period > 0))
            status = formula_blame(at, why, "period %s, expected one above 0",
                                   period);
    }
    if (status != STATUS_OK)
        return status;
    strcpy(new.name, name);
    new.node = add_state(&s->graph, &new);
    s->state[s->states++] = new;
    return STATUS_OK;
}

enum status formula_system_parameter(struct formula_system *s, const char *name,
                                     const char *decimal,
                                     struct formula_place at, struct fault *why)
{
    struct system_parameter new = { .node = 0 };
    enum status status = check_name(s, "parameter", name, at, why);

    if (status == STATUS_OK && s->parameters == SYSTEM_PARAMETERS)
        status = formula_blame(at, why, "more than %d parameters",
                               SYSTEM_PARAMETERS);
    if (status == STATUS_OK)
        status = formula_parse_decimal(decimal, at, &new.value, why);
    if (status != STATUS_OK)
        return status;
    strcpy(new.name, name);
    new.node = add_parameter(&s->graph, &new);
    s->parameter[s->parameters++] = new;
    return STATUS_OK;
}

/* ---- formulas ------------------------------------------------------------ */

/* Puts a node where its entry says. */
static void place_node(struct formula_system *s, const struct system_entry *e)
{
    if (e->kind == ENTRY_DEFINE)
        formula_define(&s->graph, e->name, e->node);
    else if (e->kind == ENTRY_RATE)
        s->rate[e->which] = e->node;
    else
        s->observable[e->which].node = e->node;
}

static enum status add_entry(struct formula_system *s, struct system_entry e,
                             const char *text, struct formula_place at,
                             struct fault *why)
{
    const size_t size = strnlen(text, SYSTEM_LETTERS) + 1;
    const int nodes = s->graph.nodes;
    const enum status status =
        formula_parse_at(&s->graph, text, at, &e.node, why);

    if (status != STATUS_OK) {
        s->graph.nodes = nodes;
        s->graph.full = false;
        return status;
    }
    if (s->entries == SYSTEM_ENTRIES ||
        (size_t) s->letters + size > SYSTEM_LETTERS)
        return formula_blame(at, why,
                             "more than %d formulas or %d letters in all",
                             SYSTEM_ENTRIES, SYSTEM_LETTERS);
    e.text = s->letters;
    memcpy(s->text + s->letters, text, size);
    s->letters += (int) size;
    s->entry[s->entries++] = e;
    place_node(s, &e);
    return STATUS_OK;
}

enum status formula_system_define(struct formula_system *s, const char *name,
                                  const char *text, struct formula_place at,
                                  struct fault *why)
{
    struct system_entry e = { .kind = ENTRY_DEFINE };
    const enum status status = check_name(s, "name", name, at, why);

    if (status != STATUS_OK)
        return status;
    if (s->graph.definitions == FORMULA_DEFINITIONS)
        return formula_blame(at, why, "more than %d names for expressions",
                             FORMULA_DEFINITIONS);
    strcpy(e.name, name);
    return add_entry(s, e, text, at, why);
}

static enum status blame_state(const struct formula_system *s, const char *name,
                               struct formula_place at, struct fault *why)
{
    const char *known[3] = { NULL };

    for (int i = 0; i < s->states; i++)
        known[i] = s->state[i].name;
    const char *near = spell_nearest(name, known);
    return formula_blame(at, why, "rate of %.40s, which is no state%s%s%s",
                         name, near ? " (did you mean " : "", near ? near : "",
                         near ? "?)" : "");
}

enum status formula_system_rate(struct formula_system *s, const char *name,
                                const char *text, struct formula_place at,
                                struct fault *why)
{
    struct system_entry e = { .kind = ENTRY_RATE };

    e.which = formula_system_find_state(s, name);
    if (e.which < 0)
        return blame_state(s, name, at, why);
    if (s->rate[e.which] >= 0)
        return formula_blame(at, why, "rate of %s: there is one already", name);
    strcpy(e.name, name);
    return add_entry(s, e, text, at, why);
}

enum status formula_system_observable(struct formula_system *s,
                                      const char *name, const char *text,
                                      const char *unit, const char *long_name,
                                      struct formula_place at,
                                      struct fault *why)
{
    struct system_entry e = { .kind = ENTRY_OBSERVABLE,
                              .which = s->observables };
    struct system_observable new = { .node = 0 };
    enum status status = STATUS_OK;

    if (formula_system_find_state(s, name) >= 0 || strcmp(name, "time") == 0)
        status = formula_blame(
            at, why, "observable %s: orbits have %s of their own", name, name);
    for (int i = 0; i < s->observables && status == STATUS_OK; i++)
        if (strcmp(s->observable[i].name, name) == 0)
            status = formula_blame(
                at, why, "observable %s: there is one of this name", name);
    if (status == STATUS_OK && s->observables == SYSTEM_OBSERVABLES)
        status = formula_blame(at, why, "more than %d observables",
                               SYSTEM_OBSERVABLES);
    if (status == STATUS_OK &&
        (!is_identifier(name) || strlen(name) >= FORMULA_NAME))
        status = formula_blame(at, why,
                               "observable '%.40s', expected a name of at most "
                               "%d letters, digits and _",
                               name, FORMULA_NAME - 1);
    if (status != STATUS_OK)
        return status;
    strcpy(e.name, name);
    strcpy(new.name, name);
    snprintf(new.unit, sizeof new.unit, "%s", unit ? unit : "");
    snprintf(new.long_name, sizeof new.long_name, "%s",
             long_name ? long_name : "");
    s->observable[s->observables] = new;
    status = add_entry(s, e, text, at, why);
    s->observables += status == STATUS_OK;
    return status;
}

/* ---- whole --------------------------------------------------------------- */

/* Rates of all at a state, in 113 bits; false where there are none. */
static bool rates_at(struct interval_plan *p, const formula_real at[2],
                     struct interval_slope_quad out[2])
{
    const struct interval_quad box[2] = { { at[0], at[0] }, { at[1], at[1] } };

    return interval_over_quad(p, box, out) == INTERVAL_WHOLE;
}

/* Whether rates and observables are the same a period further, at some states:
 * to TOL_PERIODIC of their slopes and values there. */
static bool is_periodic(const struct formula_system *s, struct interval_plan *p,
                        int k)
{
    static const double place[][2] = {
        { 0.1, 0.7 }, { 1.3, -0.4 }, { 2.9, 1.9 }, { -1.7, 0.3 }, { 0.6, -2.2 }
    };

    for (size_t i = 0; i < sizeof place / sizeof *place; i++) {
        formula_real at[2] = { place[i][0], place[i][1] };
        struct interval_slope_quad here[INTERVAL_RESULTS],
            there[INTERVAL_RESULTS];
        for (int j = 0; j < 2; j++)
            if (s->state[j].chart == CHART_POSITIVE)
                at[j] = at[j] > 0 ? at[j] : -at[j];
        if (!rates_at(p, at, here))
            continue;
        at[k] += s->state[k].period;
        if (!rates_at(p, at, there))
            return false;
        for (int j = 0; j < 2; j++) {
            const formula_real off = here[j].value.lo - there[j].value.lo;
            formula_real size = here[j].value.lo * here[j].value.lo;
            for (int i2 = 0; i2 < 2; i2++)
                size += here[j].by[i2].lo * here[j].by[i2].lo;
            if (!(off * off <=
                  (formula_real) TOL_PERIODIC * TOL_PERIODIC * (1 + size)))
                return false;
        }
    }
    return true;
}

/* An angle's rates must be the same after its period. */
static enum status check_angles(const struct formula_system *s,
                                struct formula_place at, struct fault *why)
{
    const int state[2] = { s->state[0].node, s->state[1].node };
    formula_real value[FORMULA_NODES] = { 0 };
    struct interval_plan *p = malloc(sizeof *p);
    enum status status = p ? STATUS_OK : STATUS_NO_MEMORY;

    for (int i = 0; i < s->parameters; i++)
        value[s->parameter[i].node] = s->parameter[i].value;
    if (p &&
        interval_plan(p, &s->graph, state, s->rate, 2, value, why) == STATUS_OK)
        for (int k = 0; k < 2 && status == STATUS_OK; k++)
            if (s->state[k].chart == CHART_ANGLE && !is_periodic(s, p, k))
                status = formula_blame(
                    at, why, "angle %s: the rates are not the same after %.9g",
                    s->state[k].name, (double) s->state[k].period);
    free(p);
    return status;
}

enum status formula_system_finish(const struct formula_system *s,
                                  struct formula_place at, struct fault *why)
{
    if (s->states < 2)
        return formula_blame(at, why, "%d state%s, expected two", s->states,
                             s->states == 1 ? "" : "s");
    for (int i = 0; i < 2; i++)
        if (s->rate[i] < 0)
            return formula_blame(at, why, "state %s has no rate",
                                 s->state[i].name);
    if (s->state[0].chart == CHART_ANGLE || s->state[1].chart == CHART_ANGLE)
        return check_angles(s, at, why);
    return STATUS_OK;
}

static bool is_part(char c)
{
    return isalnum((unsigned char) c) || c == '_';
}

bool formula_system_uses(const struct formula_system *s, const char *name)
{
    const size_t size = strlen(name);

    for (int i = 0; i < s->entries; i++) {
        const char *text = formula_system_text(s, &s->entry[i]);
        for (const char *at = text; (at = strstr(at, name)); at++)
            if ((at == text || !is_part(at[-1])) && !is_part(at[size]))
                return true;
    }
    return false;
}

/* ---- other values -------------------------------------------------------- */

const char *formula_system_text(const struct formula_system *s,
                                const struct system_entry *e)
{
    return s->text + e->text;
}

/* What is > 0 by its form depends on which parameters are, and powers on whole
 * exponents: reads all again. */
static void read_again(struct formula_system *s)
{
    struct fault why;

    formula_init(&s->graph);
    for (int i = 0; i < s->states; i++)
        s->state[i].node = add_state(&s->graph, &s->state[i]);
    for (int i = 0; i < s->parameters; i++)
        s->parameter[i].node = add_parameter(&s->graph, &s->parameter[i]);
    for (int i = 0; i < s->entries; i++) {
        struct system_entry *e = &s->entry[i];
        if (formula_parse(&s->graph, formula_system_text(s, e), &e->node,
                          &why) != STATUS_OK)
            s->graph.full = true;
        place_node(s, e);
    }
}

enum status formula_system_set(struct formula_system *s, const char *name,
                               formula_real value, struct formula_place at,
                               struct fault *why)
{
    const char *known[SYSTEM_PARAMETERS + 1] = { NULL };
    const int i = formula_system_find_parameter(s, name);

    if (i >= 0) {
        struct system_parameter *p = &s->parameter[i];
        const bool was = p->value > 0;
        p->value = value;
        if (was != (value > 0) || s->graph.node[p->node].exponent)
            read_again(s);
        if (!s->graph.full)
            return STATUS_OK;
        return formula_blame(at, why, "the formulas have more than %d parts",
                             FORMULA_NODES);
    }
    for (int k = 0; k < s->parameters; k++)
        known[k] = s->parameter[k].name;
    const char *near = spell_nearest(name, known);
    return formula_blame(at, why, "unknown parameter %.40s%s%s%s", name,
                         near ? " (did you mean " : "", near ? near : "",
                         near ? "?)" : "");
}
