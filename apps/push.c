/* slipway push: what becomes of a state, or of each of a file, and the
 * smallest kicks that would change it. */
#include "push.h"

#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "json.h"
#include "number.h"
#include "progress.h"
#include "table.h"

/* What was asked and what was found. */
struct job {
    struct push push;
    struct push_state *state;   /* owned */
    struct push_answer *answer; /* owned */
    size_t count;
    struct table table; /* where the states come from; else empty */
};

/* ---- states -------------------------------------------------------------- */

static enum status usage(struct fault *why, const char *format,
                         const char *text)
{
    snprintf(why->text, sizeof why->text, format, text_shown(text).text);
    return STATUS_BAD_ARGUMENT;
}

/* Either --v and --psi or --states. */
static enum status check_options(const struct options *o, struct fault *why)
{
    if (o->states && (o->v || o->psi))
        return usage(why, "push: --states %s: expected no --v, --psi beside it",
                     o->states);
    if (!o->states && !o->v)
        return usage(why, "push: no state, expected %s and --psi", "--v");
    if (!o->states && !o->psi)
        return usage(why, "push: no state, expected %s beside --v", "--psi");
    return STATUS_OK;
}

static enum status make_room(struct job *j, size_t count)
{
    j->count = count;
    j->state = calloc(count, sizeof *j->state);
    j->answer = calloc(count, sizeof *j->answer);
    return j->state && j->answer ? STATUS_OK : STATUS_NO_MEMORY;
}

static enum status read_option(const char *name, const char *text,
                               double *value, struct fault *why)
{
    if (number_read(text, value))
        return STATUS_OK;
    snprintf(why->text, sizeof why->text, "push: %s %s: expected a number",
             name, text_shown(text).text);
    return STATUS_BAD_ARGUMENT;
}

static enum status read_single(struct job *j, const struct options *o,
                               struct fault *why)
{
    enum status s = make_room(j, 1);

    if (s == STATUS_OK)
        s = read_option("--v", o->v, &j->state[0].v, why);
    if (s == STATUS_OK)
        s = read_option("--psi", o->psi, &j->state[0].psi, why);
    return s;
}

static enum status read_cell(const struct job *j, size_t row, const char *name,
                             double *value, struct fault *why)
{
    const struct table_cell *c = table_find(&j->table, row, name);
    const struct table_cell *first = table_at(&j->table, row, 0);

    if (c == NULL)
        return place_blame(table_place(&j->table, first), why,
                           "no %s in this row, expected a number", name);
    if (number_read(c->text, value))
        return STATUS_OK;
    return place_blame(table_place(&j->table, c), why,
                       "'%s', expected a number", text_shown(c->text).text);
}

static enum status has_column(const struct table *t, const char *name,
                              struct fault *why)
{
    for (size_t i = 0; i < t->columns; i++)
        if (strcmp(table_header(t, i)->text, name) == 0)
            return STATUS_OK;
    return place_blame(table_place(t, table_header(t, 0)), why,
                       "no column '%s', expected v and psi", name);
}

static enum status read_states(struct job *j, const struct options *o,
                               struct fault *why)
{
    enum status s = table_read(&j->table, o->states, why);

    if (s == STATUS_OK)
        s = has_column(&j->table, "v", why);
    if (s == STATUS_OK)
        s = has_column(&j->table, "psi", why);
    if (s == STATUS_OK)
        s = make_room(j, j->table.rows);
    for (size_t i = 0; i < j->table.rows && s == STATUS_OK; i++) {
        s = read_cell(j, i, "v", &j->state[i].v, why);
        if (s == STATUS_OK)
            s = read_cell(j, i, "psi", &j->state[i].psi, why);
    }
    return s;
}

/* Asked when the law is known, which says what psi may be. */
static enum status check_states(const struct job *j, struct fault *why)
{
    const bool is_log = j->push.study.system.axis[1].is_log;
    const char *expected = is_log ? "expected v and psi from 1e-300 to 1e300"
                                  : "expected v from 1e-300 to 1e300, psi from "
                                    "-1e300 to 1e300";

    for (size_t i = 0; i < j->count; i++) {
        const struct push_state at = j->state[i];
        if (push_holds(&j->push, at))
            continue;
        if (j->table.rows > 0)
            return place_blame(
                table_place(&j->table, table_at(&j->table, i, 0)), why,
                "v = %g, psi = %g, %s", at.v, at.psi, expected);
        snprintf(why->text, sizeof why->text, "push: v = %g, psi = %g, %s",
                 at.v, at.psi, expected);
        return STATUS_BAD_ARGUMENT;
    }
    return STATUS_OK;
}

/* ---- answers ------------------------------------------------------------- */

static void print_quantity(const char *name, const struct quantity *q)
{
    if (!quantity_exists(q))
        printf("  %-9s -  (%s)\n", name, q->reason);
    else
        printf("  %-9s %-22.15g +- %.1e\n", name, q->value, q->error);
}

static void print_answer(const struct push_state *at,
                         const struct push_answer *a)
{
    printf("v = %.17g, psi = %.17g: %s\n", at->v, at->psi, fate_names[a->fate]);
    print_quantity("slip", &a->slip);
    print_quantity("time", &a->time);
    print_quantity("mu_mean", &a->mu_mean);
    print_quantity("v_kick", &a->v_kick);
    print_quantity("psi_kick", &a->psi_kick);
}

static json_t *answers_json(const struct job *j)
{
    const struct record_array all = { &record_push, j->answer, j->count };
    json_t *object;

    if (j->table.rows == 0)
        return json_record(&record_push, j->answer);
    object = json_object();
    json_object_set_new(object, "states", json_records(&all));
    return object;
}

static enum exit_code print_answers(const struct options *o,
                                    const struct job *j)
{
    if (o->json)
        return json_print(answers_json(j)) ? EXIT_DONE : command_unwritten();
    for (size_t i = 0; i < j->count && !o->quiet; i++)
        print_answer(&j->state[i], &j->answer[i]);
    return EXIT_DONE;
}

/* ---- the command --------------------------------------------------------- */

static enum status find_answers(struct job *j, const struct options *o,
                                const struct scene *scene, struct fault *why)
{
    const struct monitor *monitor = progress_monitor(o);
    enum status s = push_init(&j->push, scene, monitor, why);

    if (s == STATUS_OK)
        s = check_states(j, why);
    if (s == STATUS_OK)
        s = push_tabulate(&j->push, monitor);
    if (s == STATUS_OK)
        s = push_find_all(&j->push, j->state, j->count, monitor, j->answer);
    progress_end();
    return s;
}

static enum exit_code run(const struct options *o, const struct scene *scene)
{
    struct job j = { .count = 0 };
    struct fault why = { "" };

    enum status s =
        o->states ? read_states(&j, o, &why) : read_single(&j, o, &why);
    if (s == STATUS_OK)
        s = find_answers(&j, o, scene, &why);
    const enum exit_code code =
        s == STATUS_OK ? print_answers(o, &j) : command_fail(s, why.text);
    push_free(&j.push);
    table_free(&j.table);
    free(j.state);
    free(j.answer);
    return code;
}

static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    const enum status s = check_options(o, why);

    return s ? s : command_read(o, o->set, o->sets, scene, why);
}

enum exit_code command_push(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
