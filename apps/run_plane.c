#include "run_plane.h"

#include "certificate_file.h"
#include "drawn.h"
#include "json_results.h"
#include "margin.h"
#include "picture_plane.h"
#include "plane_certificate.h"
#include "plane_numbers.h"
#include "plane_results.h"
#include "progress.h"
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

static enum exit_code print_json(const struct plane_study *s,
                                 const struct ensemble *drawn,
                                 const struct results *all)
{
    json_t *j = json_results(NULL, all);

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
    return json_print(j) ? EXIT_DONE : command_unwritten();
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

static enum exit_code print(const struct plane_study *s,
                            const struct ensemble *drawn,
                            const struct options *o)
{
    const struct results all = plane_results(s);

    if (o->json)
        return print_json(s, drawn, &all);
    if (o->quiet)
        return EXIT_DONE;
    const enum status status = text_results(stdout, &all);
    if (status != STATUS_OK)
        return command_fail(status, status_text(status));
    print_notes(s);
    if (drawn)
        report_ensemble_print(stdout, drawn);
    return EXIT_DONE;
}

static enum status write_files(const struct plane_study *s,
                               const struct ensemble *drawn,
                               const struct options *o, const char *figure,
                               struct fault *why)
{
    const struct results all = plane_results(s);
    struct panels p = PANELS_EMPTY;
    enum status status = output_write(o, o->command->name, &all, s->scene,
                                      drawn, s->system[0].name, why);

    if (status == STATUS_OK && o->certificate)
        status = certificate_write(o, plane_certificate(s), why);
    if (status == STATUS_OK && figure)
        picture_plane(s, &p);
    return status ? status : output_draw(o, &s->scene->paper, &p, figure, why);
}

/* Files are written and numbers printed: the user may see for himself. */
static enum exit_code judge(const struct plane_basin *b)
{
    char text[160];

    snprintf(text, sizeof text,
             "audit: the orbits of %d of %d states go elsewhere than the map "
             "says",
             (int) b->disagreements, (int) b->cells);
    return command_fail(STATUS_NO_CONVERGENCE, text);
}

/* Likewise: a bar and a proof cannot both be right. */
static enum exit_code judge_proof(const struct fault *lie)
{
    fprintf(stderr, "slipway: %s\n", lie->text);
    return EXIT_CHECK;
}

enum exit_code plane_run(const struct options *o, const struct scene *scene,
                         const char *figure)
{
    static const char *const panel[] = { "", NULL };
    const char *draw = scene->figure ? scene->figure
                       : scene->hdf5 ? NULL
                                     : figure;
    struct ensemble drawn = ENSEMBLE_EMPTY;
    struct plane_study s;
    struct fault why = { "" };

    enum status status = drawn_check(o, scene, &why);
    if (status == STATUS_OK)
        status = output_check(o, scene, draw, panel, &why);
    if (status == STATUS_OK)
        status = plane_study_run(&s, scene, progress_monitor(o), &why);
    progress_end();
    if (status != STATUS_OK)
        return command_fail(status, why.text);
    status = drawn_run(o, scene, &drawn, &why);
    if (status == STATUS_OK)
        status = write_files(&s, drawn_of(&drawn), o, draw, &why);
    progress_end();
    enum exit_code code = status == STATUS_OK ? print(&s, drawn_of(&drawn), o)
                                              : command_fail(status, why.text);
    if (code == EXIT_DONE && s.basin.disagreements > 0)
        code = judge(&s.basin);
    if (code == EXIT_DONE && s.proof.lie.text[0])
        code = judge_proof(&s.proof.lie);
    ensemble_free(&drawn);
    plane_study_free(&s);
    return code;
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
