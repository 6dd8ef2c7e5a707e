#include "run_plane.h"

#include "json_results.h"
#include "margin.h"
#include "plane_numbers.h"
#include "plane_results.h"
#include "report_ensemble.h"
#include "text_results.h"

#define BIT(p) (1u << PRODUCT_##p)

unsigned plane_products(const struct options *o)
{
    const unsigned always = BIT(EQUILIBRIA) | BIT(MANIFOLDS);

    if (o->command == &command_table[COMMAND_BASIN])
        return always | BIT(BASINS);
    return o->command == &command_table[COMMAND_PORTRAIT]
               ? always | BIT(NULLCLINES) | BIT(TRAJECTORIES)
               : always;
}

static json_t *json_reasons(const struct plane_study *s)
{
    json_t *all = json_array();

    for (int i = 0; i < PLANE_UNKNOWNS && plane_numbers_lack(s); i++)
        if (s->basin.unknown[i])
            json_array_append_new(all, json_string(plane_unknown_texts[i]));
    return all;
}

json_t *plane_json(const struct plane_study *s, const struct ensemble *drawn)
{
    const struct results all = plane_results(s);
    json_t *j = json_results(NULL, &all);

    if (j)
        json_object_set_new(j, "equilibria_complete",
                            json_boolean(s->complete));
    if (j && s->products & BIT(BASINS)) {
        json_object_set_new(j, "shares_are_lower_bounds",
                            json_boolean(plane_numbers_lack(s)));
        json_object_set_new(j, "undecided_reasons", json_reasons(s));
        json_object_set_new(j, "neutral_cycles",
                            json_integer((json_int_t) s->basin.neutral));
    }
    if (j && drawn)
        json_object_set_new(j, "ensemble", report_ensemble_json(drawn));
    return j;
}

static void print_incomplete(const struct plane_study *s)
{
    const struct plane_box *b = s->undecided;
    const size_t n = s->undecided_count;

    printf("note: that there are no other equilibria in the window was not "
           "proved");
    if (n > 0)
        printf("; %zu box%s may hold some%s: %s = %.9g .. %.9g, %s = %.9g .. "
               "%.9g",
               n, n > 1 ? "es" : "", n > 1 ? ", as" : "",
               s->system[0].axis[0].name, b->range[0][0], b->range[0][1],
               s->system[0].axis[1].name, b->range[1][0], b->range[1][1]);
    putchar('\n');
}

static void print_notes(const struct plane_study *s)
{
    if (!s->complete)
        print_incomplete(s);
    if (plane_numbers_lack(s))
        printf("note: shares are lower bounds: each may have up to %.3g more, "
               "which is undecided\n",
               s->basin.elsewhere.undecided.value);
    for (int i = 0; i < PLANE_UNKNOWNS && plane_numbers_lack(s); i++)
        if (s->basin.unknown[i])
            printf("note: undecided: %s\n", plane_unknown_texts[i]);
    if (s->scene->products & BIT(MARGIN) && !margin_exists(&s->basin.regions))
        printf("note: no margins to draw: all states have the same fate\n");
}

enum status plane_print(const struct plane_study *s)
{
    const struct results all = plane_results(s);
    const enum status status = text_results(stdout, &all);

    if (status == STATUS_OK)
        print_notes(s);
    return status;
}

/* ---- plan ---------------------------------------------------------------- */

void plan_row(const struct options *o, json_t *list, const char *name,
              const char *text, const char *work)
{
    json_array_append_new(list, json_pack("{s:s, s:s, s:s}", "stage", name,
                                          "text", text, "work", work));
    if (!o->json && !o->quiet)
        printf("%-13s %-48s %s\n", name, text, work);
}

void plane_plan(const struct options *o, json_t *list,
                const struct scene *scene)
{
    static const struct {
        const char *name, *text, *work;
        unsigned products;
    } stage[] = {
        { "equilibria", "all in the window, their eigenvalues",
          "some hundred boxes", BIT(EQUILIBRIA) },
        { "manifolds", "stable and unstable ones of every saddle",
          "some hundred Taylor steps a branch", BIT(MANIFOLDS) },
        { "sensitivities", "of the equilibria, by every parameter",
          "four searches each", BIT(SENSITIVITIES) },
        { "nullclines", "where a state stands still", "some thousand fields",
          BIT(NULLCLINES) },
        { "field_arrows", "the direction field", "400 fields",
          BIT(FIELD_ARROWS) },
        { "basins", "whereto every state goes, their shares",
          "an orbit a region, and those of the audit", BIT(BASINS) },
        { "margin", "how far another fate is",
          "borders, along two lines a cell", BIT(MARGIN) },
        { "trajectories", "orbits, both ways in time",
          "some hundred steps each", BIT(TRAJECTORIES) },
    };

    for (size_t i = 0; i < sizeof stage / sizeof *stage; i++)
        if (scene->products & stage[i].products)
            plan_row(o, list, stage[i].name, stage[i].text, stage[i].work);
}
