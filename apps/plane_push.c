#include "plane_push.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drawn.h"
#include "goal_scatter.h"
#include "json.h"
#include "number.h"
#include "progress.h"
#include "report_ensemble.h"
#include "table.h"

struct job {
    const struct scene *scene;
    struct scene asked; /* borrows from it */
    struct plane_study study;
    double (*state)[2];          /* owned */
    struct plane_answer *answer; /* owned */
    size_t count;
    struct ensemble drawn; /* owned; beside --draws */
    struct table table;    /* where the states come from; else empty */
};

/* ---- states -------------------------------------------------------------- */

static const char *name_of(const struct scene *s, int axis)
{
    return s->system->state[axis].name;
}

static bool is_good(const struct scene *s, int axis, const char *text,
                    double *x)
{
    return number_read(text, x) && fabs(*x) <= 1e300 &&
           (*x >= 1e-300 || !scene_axis_is_log(s, axis));
}

static const char *expected(const struct scene *s, int axis)
{
    return scene_axis_is_log(s, axis) ? "a number > 0" : "a number";
}

static enum status make_room(struct job *j, size_t count)
{
    j->count = count;
    j->state = calloc(count, sizeof *j->state);
    j->answer = calloc(count, sizeof *j->answer);
    return j->state && j->answer ? STATUS_OK : STATUS_NO_MEMORY;
}

/* Which axis has not been named before; 2: none. */
static int axis_named(const struct scene *s, const char *name,
                      const bool known[2])
{
    int i = 0;

    while (i < 2 && (known[i] || strcmp(name, name_of(s, i)) != 0))
        i++;
    return i;
}

enum status plane_push_read(const struct scene *s, const char *text,
                            double state[2], struct fault *why)
{
    char *copy = strdup(text ? text : ""), *rest = copy, *part;
    bool known[3] = { false, false, false };

    while (copy && (part = strsep(&rest, ",")) != NULL) {
        char *value = strchr(part, '=');
        if (value)
            *value++ = '\0';
        const int i = axis_named(s, part, known);
        known[i] = i == 2 || (value && is_good(s, i, value, &state[i]));
    }
    free(copy);
    if (copy == NULL || (known[0] && known[1] && !known[2]))
        return copy ? STATUS_OK : STATUS_NO_MEMORY;
    return fault_set(why, STATUS_BAD_ARGUMENT,
                     "push: %s%.60s, expected --state %s=A,%s=B, each %s",
                     text ? "--state " : "no state", text ? text : "",
                     name_of(s, 0), name_of(s, 1),
                     expected(s, !known[1] && known[0]));
}

static enum status read_many(struct job *j, const char *path, struct fault *why)
{
    enum status s = table_read(&j->table, path, why);

    if (s == STATUS_OK)
        s = make_room(j, j->table.rows);
    for (size_t row = 0; s == STATUS_OK && row < j->count; row++)
        for (int i = 0; i < 2 && s == STATUS_OK; i++) {
            const struct table_cell *c =
                table_find(&j->table, row, name_of(j->scene, i));
            const struct table_cell *at = c ? c : table_at(&j->table, row, 0);
            if (c == NULL || !is_good(j->scene, i, c->text, &j->state[row][i]))
                s = place_blame(table_place(&j->table, at), why,
                                "no '%s' in this row, expected %s",
                                name_of(j->scene, i), expected(j->scene, i));
        }
    return s;
}

/* ---- answers ------------------------------------------------------------- */

static json_t *answer_json(const struct job *j, size_t i)
{
    json_t *all = json_pack("{s:{s:o, s:o}, s:s}", "state",
                            name_of(j->scene, 0), json_number(j->state[i][0]),
                            name_of(j->scene, 1), json_number(j->state[i][1]),
                            "attractor", j->answer[i].attractor);
    char name[80];

    for (int k = 0; k < 2; k++) {
        snprintf(name, sizeof name, "%.70s_kick", name_of(j->scene, k));
        json_object_set_new(all, name, json_quantity(&j->answer[i].kick[k]));
    }
    if (!isnan(j->answer[i].stays))
        json_object_set_new(all, "attractor_linear",
                            json_number(j->answer[i].stays));
    if (j->table.rows == 0 && drawn_of(&j->drawn))
        json_object_set_new(all, "ensemble", report_ensemble_json(&j->drawn));
    return all;
}

static void print_kick(const struct job *j, size_t i, int axis)
{
    const struct quantity *q = &j->answer[i].kick[axis];

    if (q->reason) {
        printf("  %s_kick: %s\n", name_of(j->scene, axis), q->reason);
        return;
    }
    const struct number_bar n = number_with_bar(q->value, q->error);
    printf("  %s_kick: %s +- %s", name_of(j->scene, axis), n.value.text,
           n.error.text);
    if (isinf(q->spread))
        printf("  (spread not known)");
    else if (!isnan(q->spread))
        printf("  (spread %.2g)", q->spread);
    putchar('\n');
}

static void print_answer(const struct job *j, size_t i)
{
    printf("%s = %s, %s = %s: %s\n", name_of(j->scene, 0),
           number_shortest(j->state[i][0]).text, name_of(j->scene, 1),
           number_shortest(j->state[i][1]).text, j->answer[i].attractor);
    for (int k = 0; k < 2; k++)
        print_kick(j, i, k);
    if (!isnan(j->answer[i].stays))
        printf("  attractor_linear: %.6g\n", j->answer[i].stays);
}

static enum exit_code print(const struct job *j, const struct options *o)
{
    json_t *list = json_array();

    for (size_t i = 0; i < j->count; i++) {
        json_array_append_new(list, answer_json(j, i));
        if (!o->json && !o->quiet)
            print_answer(j, i);
    }
    if (!o->json && !o->quiet && drawn_of(&j->drawn))
        report_ensemble_print(stdout, &j->drawn);
    if (!o->json) {
        json_decref(list);
        return EXIT_DONE;
    }
    json_t *all = j->table.rows > 0 ? json_pack("{s:o}", "states", list)
                                    : json_incref(json_array_get(list, 0));
    if (j->table.rows == 0)
        json_decref(list);
    return json_print(all) ? EXIT_DONE : command_unwritten();
}

static enum status find_answers(struct job *j, const struct options *o,
                                struct fault *why)
{
    const struct monitor *monitor = progress_monitor(o);
    enum status s = plane_study_run(&j->study, &j->asked, monitor, why);

    for (size_t i = 0; i < j->count && s == STATUS_OK; i++)
        s = plane_answer_at(&j->study, j->state[i], &j->answer[i]);
    if (s == STATUS_OK && j->scene->ensemble.scattered > 0)
        s = goal_scatter_find(&j->study, (const double(*)[2]) j->state,
                              j->count, monitor, j->answer);
    progress_end();
    return s == STATUS_OK ? drawn_run(o, j->scene, &j->drawn, why) : s;
}

enum exit_code plane_push(const struct options *o, const struct scene *scene)
{
    struct job j = { .scene = scene, .asked = *scene, .drawn = ENSEMBLE_EMPTY };
    struct fault why = { "" };

    j.asked.products = 1u << PRODUCT_BASINS;
    j.asked.audit = 0;
    enum status s =
        o->states ? read_many(&j, o->states, &why) : make_room(&j, 1);
    if (s == STATUS_OK && !o->states)
        s = plane_push_read(scene, o->state, j.state[0], &why);
    if (s == STATUS_OK)
        s = find_answers(&j, o, &why);
    const enum exit_code code =
        s == STATUS_OK ? print(&j, o) : command_fail(s, why.text);
    plane_study_free(&j.study);
    ensemble_free(&j.drawn);
    table_free(&j.table);
    free(j.state);
    free(j.answer);
    return code;
}
