#include "report_ensemble.h"

#include <math.h>
#include <string.h>

#include "system.h"

/* ---- text ---------------------------------------------------------------- */

static void print_estimate(FILE *out, const struct estimate *x)
{
    if (isnan(x->value))
        fputs("-", out);
    else if (isnan(x->error))
        fprintf(out, "%.6g", x->value);
    else
        fprintf(out, "%.6g +- %.1g", x->value, x->error);
}

static void print_reasons(FILE *out, const struct ensemble *e,
                          const size_t count[], const char *what)
{
    for (size_t r = 0; r < e->reasons.count; r++)
        if (r != REASON_PRESENT && count[r] > 0)
            fprintf(out, "    %s in %zu of %zu draws: %s\n", what, count[r],
                    e->draws.count, e->reasons.text[r]);
}

static void print_number(FILE *out, const struct ensemble *e, size_t k)
{
    const struct ensemble_number *n = &e->number[k];
    const char *unit = n->unit;

    fprintf(out, "  %s%s%s%s\n    mean ", n->name,
            strcmp(unit, "1") ? " (" : "", strcmp(unit, "1") ? unit : "",
            strcmp(unit, "1") ? ")" : "");
    print_estimate(out, &n->mean);
    fputs(", exists ", out);
    print_estimate(out, &n->exists);
    fputs("\n    quantiles", out);
    for (int q = 0; q < ENSEMBLE_QUANTILES; q++) {
        const struct estimate x = { n->quantile[q], (double) NAN };
        fprintf(out, "%s %g: ", q ? "," : "", ensemble_quantile[q]);
        print_estimate(out, &x);
    }
    fputs("\n    variance", out);
    for (size_t p = 0; p < e->draws.keys; p++) {
        fprintf(out, "%s %s ", p ? "," : "", e->draws.key[p]);
        print_estimate(out, &n->share[p]);
    }
    fputc('\n', out);
    print_reasons(out, e, n->reason, "missing");
}

/* Those that are, and of a law arrest before them. */
static void print_push(FILE *out, const struct ensemble *e, size_t k)
{
    const struct ensemble_push *p = &e->push[k];
    const char *between = ":";

    fprintf(out, "  %s", p->said);
    if (e->scene->system == NULL) {
        fputs(": arrest ", out);
        print_estimate(out, &p->arrest);
        between = ",";
    }
    for (int f = 0; f <= GOALS; f++)
        if (p->count[f] > 0) {
            fprintf(out, "%s %s ", between, f == GOALS ? "none" : p->word[f]);
            print_estimate(out, &p->fate[f]);
            between = ",";
        }
    fputc('\n', out);
    print_reasons(out, e, p->reason, "no fate");
}

void report_ensemble_print(FILE *out, const struct ensemble *e)
{
    fprintf(out, "ensemble: %zu draws (%s) of", e->draws.count,
            draws_method(&e->draws));
    for (size_t k = 0; k < e->draws.keys; k++)
        fprintf(out, "%s %s", k ? "," : "", e->draws.key[k]);
    fputs(e->batch.numbers > 0 ? "\nnumbers\n" : "\n", out);
    for (size_t k = 0; k < e->batch.numbers; k++)
        print_number(out, e, k);
    if (e->batch.pushes > 0)
        fputs("probabilities\n", out);
    for (size_t k = 0; k < e->batch.pushes; k++)
        print_push(out, e, k);
}

/* ---- JSON ---------------------------------------------------------------- */

static json_t *estimate_json(const struct estimate *x)
{
    return json_pack("{s:o, s:o}", "value", json_number(x->value), "error",
                     json_number(x->error));
}

static json_t *reasons_json(const struct ensemble *e, const size_t count[])
{
    json_t *reasons = json_object();

    for (size_t r = 0; r < e->reasons.count; r++)
        if (r != REASON_PRESENT && count[r] > 0)
            json_object_set_new(reasons, e->reasons.text[r],
                                json_integer((json_int_t) count[r]));
    return reasons;
}

static json_t *number_json(const struct ensemble *e,
                           const struct ensemble_number *n)
{
    json_t *quantiles = json_object();

    for (int q = 0; q < ENSEMBLE_QUANTILES; q++) {
        char name[16];
        snprintf(name, sizeof name, "%g", ensemble_quantile[q]);
        json_object_set_new(quantiles, name, json_number(n->quantile[q]));
    }
    return json_pack("{s:s, s:o, s:o, s:o, s:o}", "unit", n->unit, "quantiles",
                     quantiles, "mean", estimate_json(&n->mean), "exists",
                     estimate_json(&n->exists), "reasons",
                     reasons_json(e, n->reason));
}

/* What is asked of a law. */
static json_t *push_asked(const struct ensemble_push *p)
{
    const char *unit = p->at.is_si ? "m/s" : "V_star";

    return p->at.from_creep
               ? json_pack("{s:s, s:o, s:s}", "from", "creep", "kick",
                           json_number(p->at.v), "unit", unit)
               : json_pack("{s:o, s:o, s:s}", "v", json_number(p->at.v),
                           p->state, json_number(p->at.psi), "unit", unit);
}

/* And of a system. */
static json_t *state_asked(const struct ensemble *e,
                           const struct ensemble_push *p)
{
    const struct system_state *x = e->scene->system->state;
    json_t *j =
        json_pack("{s:{s:o, s:o}}", "state", x[0].name, json_number(p->at.v),
                  x[1].name, json_number(p->at.psi));

    if (p->at.from[0])
        json_object_set_new(j, "from", json_string(p->at.from));
    return j;
}

static json_t *push_json(const struct ensemble *e,
                         const struct ensemble_push *p)
{
    const bool plane = e->scene->system != NULL;
    json_t *j = plane ? state_asked(e, p) : push_asked(p);
    json_t *goals = plane ? json_object() : j;

    if (plane)
        json_object_set_new(j, "attractors", goals);
    else
        json_object_set_new(j, "arrest", estimate_json(&p->arrest));
    for (int f = 0; f < GOALS; f++)
        if (p->word[f])
            json_object_set_new(goals, p->word[f], estimate_json(&p->fate[f]));
    json_object_set_new(j, "none", estimate_json(&p->fate[GOALS]));
    json_object_set_new(j, "reasons", reasons_json(e, p->reason));
    return j;
}

static json_t *sensitivity_json(const struct ensemble *e)
{
    json_t *all = json_object();

    for (size_t k = 0; k < e->batch.numbers; k++) {
        json_t *by = json_object();
        for (size_t p = 0; p < e->draws.keys; p++)
            json_object_set_new(by, e->draws.key[p],
                                estimate_json(&e->number[k].share[p]));
        json_object_set_new(all, e->number[k].name, by);
    }
    return all;
}

json_t *report_ensemble_json(const struct ensemble *e)
{
    json_t *keys = json_array(), *numbers = json_object();
    json_t *pushes = json_array();

    for (size_t k = 0; k < e->draws.keys; k++)
        json_array_append_new(keys, json_string(e->draws.key[k]));
    for (size_t k = 0; k < e->batch.numbers; k++)
        json_object_set_new(numbers, e->number[k].name,
                            number_json(e, &e->number[k]));
    for (size_t k = 0; k < e->batch.pushes; k++)
        json_array_append_new(pushes, push_json(e, &e->push[k]));
    return json_pack(
        "{s:I, s:s, s:o, s:o, s:o, s:o}", "draws", (json_int_t) e->draws.count,
        "method", draws_method(&e->draws), "parameters", keys, "numbers",
        numbers, "pushes", pushes, "sensitivity", sensitivity_json(e));
}
