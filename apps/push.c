/* slipway push: what becomes of a state, or of each of a file, and the
 * smallest kicks that would change it. */
#include "push.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "drawn.h"
#include "json_results.h"
#include "kick.h"
#include "number.h"
#include "output.h"
#include "plane_push.h"
#include "progress.h"
#include "push_file.h"
#include "push_scatter.h"
#include "report_ensemble.h"
#include "result_units.h"
#include "scene_units.h"
#include "state.h"
#include "system.h"
#include "table.h"
#include "text.h"
#include "text_results.h"
#include "tolerance.h"
#include "unit_text.h"

enum { PUSH_SETTING = 224 };

/* What was asked and what was found. */
struct job {
    const struct options *o;
    struct push push;
    struct scene_push kick;     /* beside --from */
    struct ensemble drawn;      /* owned; beside --draws */
    struct push_state *state;   /* owned */
    struct push_answer *answer; /* owned */
    size_t count;
    struct table table; /* where the states come from; else empty */
    char (*number)[24]; /* owned: of rows without an id */
};

/* ---- states -------------------------------------------------------------- */

/* Either --v and --psi or --states. */
static enum status check_options(const struct options *o, struct fault *why)
{
    if (o->states && (o->v || o->psi || o->phi))
        return command_refuse(
            why,
            "push: --states %s: expected no --v, --psi, --phi beside "
            "it",
            o->states);
    if (!o->from != !o->kick)
        return command_refuse(why,
                              "push: --from creep and --kick DV go together, "
                              "expected %s",
                              o->from ? "--kick" : "--from creep");
    if (o->from && (o->v || o->psi || o->phi || o->states || o->state))
        return command_refuse(why,
                              "push: --from %s: expected no other state "
                              "beside it",
                              o->from);
    const enum status s = output_standard_check(o, why);
    return s == STATUS_OK && o->output ? push_file_check(o, why) : s;
}

static enum status check_state(const struct options *o,
                               const struct scene *scene, struct fault *why)
{
    const bool of_law = o->v || o->psi || o->phi || o->from;

    if (scene->system && o->output)
        return command_refuse(why,
                              "push: --output %s: not for a system of "
                              "formulas, expected --json",
                              o->output);
    if (scene->system && of_law)
        return command_refuse(why,
                              "push: --v, --psi, --phi, --from are of a law%s, "
                              "expected --state x=1,y=0.5",
                              "");
    if (!scene->system && o->state)
        return command_refuse(why,
                              "push: --state %s is of a system of "
                              "formulas, expected --v and --psi",
                              o->state);
    return STATUS_OK;
}

static enum status make_room(struct job *j, size_t count)
{
    j->count = count;
    j->state = calloc(count, sizeof *j->state);
    j->answer = calloc(count, sizeof *j->answer);
    j->number = calloc(count, sizeof *j->number);
    return j->state && j->answer && j->number ? STATUS_OK : STATUS_NO_MEMORY;
}

/* That of the table's column id, or the number of the state from 0 on. */
static void name_answers(struct job *j)
{
    for (size_t i = 0; i < j->count; i++) {
        const struct table_cell *id =
            j->table.rows > 0 ? table_find(&j->table, i, "id") : NULL;
        snprintf(j->number[i], sizeof j->number[i], "%zu", i);
        j->answer[i].id = id ? id->text : j->number[i];
    }
}

/* DV and its unit. */
static enum status read_kick(const struct options *o, const struct scene *scene,
                             struct scene_push *out, struct fault *why)
{
    enum unit_text in = UNIT_TEXT_BARE;

    *out = (struct scene_push){ .from_creep = true };
    if (!unit_text_read(unit_find("V_star"), o->kick, &out->v, &in))
        return command_refuse(why,
                              "push: --kick %s: expected a number, perhaps "
                              "with m/s or V_star",
                              o->kick);
    out->is_si =
        in == UNIT_TEXT_BARE ? scene->units == UNITS_SI : in == UNIT_TEXT_SI;
    return STATUS_OK;
}

static enum status read_single(struct job *j, const struct options *o,
                               const struct scene *scene, struct fault *why)
{
    struct scene_start z = { 0.0, 0.0 };
    enum status s = make_room(j, 1);

    if (s == STATUS_OK)
        s = o->from ? read_kick(o, scene, &j->kick, why)
                    : state_read(o, scene, &z, why);
    if (s == STATUS_OK)
        j->state[0] = (struct push_state){ z.v, z.psi };
    return s;
}

/* The cell of v, of a column that may name its unit, with that unit. */
static const struct table_cell *find_rate(const struct table *t, size_t row,
                                          char *text, size_t size)
{
    static const char *const name[] = { "v", "v [m/s]", "v [V_star]" };
    static const char *const unit[] = { "", " m/s", " V_star" };
    const struct table_cell *c = NULL;

    for (int i = 0; i < 3 && c == NULL; i++)
        if ((c = table_find(t, row, name[i])) != NULL)
            snprintf(text, size, "%s%s", c->text, unit[i]);
    return c;
}

static enum status read_row(const struct job *j, const struct scene *scene,
                            size_t row, struct push_state *out,
                            struct fault *why)
{
    const struct table *t = &j->table;
    char v[TABLE_CELL + 16], expected[128];
    const struct table_cell *first = table_at(t, row, 0);
    const struct table_cell *rate = find_rate(t, row, v, sizeof v);
    const struct table_cell *psi = table_find(t, row, "psi");
    const struct table_cell *seconds = table_find(t, row, "phi [s]");
    const struct table_cell *phi =
        seconds ? seconds : table_find(t, row, "phi");
    const struct scene_state state = { rate ? v : NULL, psi ? psi->text : NULL,
                                       phi ? phi->text : NULL };
    const char *wrong;
    struct scene_start z;

    if (!rate || (!psi && !phi))
        return place_blame(table_place(t, first), why,
                           "no %s in this row, expected a number",
                           rate ? "psi" : "v");
    if (scene_state_read(scene, &state, &z, &wrong, expected)) {
        *out = (struct push_state){ z.v, z.psi };
        return STATUS_OK;
    }
    const struct table_cell *at = wrong == v                  ? rate
                                  : psi && wrong == psi->text ? psi
                                                              : phi;
    return place_blame(table_place(t, at), why, "'%s', %s",
                       text_shown(at->text).text, expected);
}

/* Just one of the columns of a list. */
static enum status has_column(const struct table *t, const char *const *names,
                              struct fault *why)
{
    const struct table_cell *found = NULL;

    for (size_t i = 0; i < t->columns; i++)
        for (const char *const *name = names; *name; name++) {
            const struct table_cell *c = table_header(t, i);
            if (strcmp(c->text, *name) != 0)
                continue;
            if (found)
                return place_blame(table_place(t, c), why,
                                   "column '%s' beside '%s', expected one",
                                   c->text, found->text);
            found = c;
        }
    return found ? STATUS_OK
                 : place_blame(table_place(t, table_header(t, 0)), why,
                               "no column '%s', expected v and psi", names[0]);
}

static enum status read_states(struct job *j, const struct options *o,
                               const struct scene *scene, struct fault *why)
{
    static const char *const rates[] = { "v", "v [m/s]", "v [V_star]", NULL };
    static const char *const states[] = { "psi", "phi", "phi [s]", NULL };
    enum status s = table_read(&j->table, o->states, why);

    if (s == STATUS_OK)
        s = has_column(&j->table, rates, why);
    if (s == STATUS_OK)
        s = has_column(&j->table, states, why);
    if (s == STATUS_OK)
        s = make_room(j, j->table.rows);
    for (size_t i = 0; i < j->table.rows && s == STATUS_OK; i++)
        s = read_row(j, scene, i, &j->state[i], why);
    return s;
}

/* Asked when the law is known, which says what psi may be. */
static enum status check_states(const struct job *j, struct fault *why)
{
    const struct planar *system = &j->push.slider.plane.system;
    char expected[96] = "expected v and psi from 1e-300 to 1e300";

    if (!system->axis[1].is_log)
        snprintf(expected, sizeof expected,
                 "expected v from 1e-300 to 1e300, psi from %g to %.4g",
                 system->domain.lo.y, floor(system->domain.hi.y));
    for (size_t i = 0; i < j->count; i++) {
        const struct push_state at = j->state[i];
        if (push_holds(&j->push, at))
            continue;
        if (j->table.rows > 0)
            return place_blame(
                table_place(&j->table, table_at(&j->table, i, 0)), why,
                "v = %g, psi = %g, %s", at.v, at.psi, expected);
        return fault_set(why, STATUS_BAD_ARGUMENT, "push: v = %g, psi = %g, %s",
                         at.v, at.psi, expected);
    }
    return STATUS_OK;
}

/* ---- answers ------------------------------------------------------------- */

static void print_answers(const struct job *j, const struct scene *scene,
                          const struct record_array *told)
{
    for (size_t i = 0; i < j->count; i++) {
        const struct record_array one = {
            told->type, (const char *) told->at + i * told->type->size, 1
        };
        if (j->table.rows > 0)
            printf("%s: ", text_shown(j->answer[i].id).text);
        state_print(stdout, scene, j->state[i].v, j->state[i].psi);
        printf(": %s\n", fate_names[j->answer[i].fate]);
        text_rest(stdout, &one);
    }
}

/* "units" as in json_results.h. */
static json_t *answers_json(const struct job *j,
                            const struct record_array *told)
{
    json_t *units = json_units(json_object(), told->type);

    if (j->table.rows > 0)
        return json_pack("{s:o, s:{s:o}}", "states", json_records(told),
                         "units", "states", units);
    json_t *one = json_record(told->type, told->at);
    json_object_set_new(one, "units", units);
    if (drawn_of(&j->drawn))
        json_object_set_new(one, "ensemble", report_ensemble_json(&j->drawn));
    return one;
}

static enum exit_code tell_answers(const struct options *o,
                                   const struct scene *scene,
                                   const struct job *j)
{
    const struct unit_system units = scene_units(scene);
    const bool scattered = scene->ensemble.scattered > 0;
    struct result_view v = { .records = { &record_push[0][scattered], j->answer,
                                          j->count },
                             .here = true };
    const struct ensemble *drawn = drawn_of(&j->drawn);
    enum exit_code code = EXIT_DONE;

    if (result_tell(&units, &v) != STATUS_OK)
        return command_fail(STATUS_NO_MEMORY, status_text(STATUS_NO_MEMORY));
    if (o->json && !json_print(answers_json(j, &v.records)))
        code = command_unwritten();
    else if (!o->json && !o->quiet && !output_is_standard(o)) {
        print_answers(j, scene, &v.records);
        if (drawn)
            report_ensemble_print(stdout, drawn);
    }
    result_close(&v);
    return code;
}

/* ---- the command --------------------------------------------------------- */

/* The creep state with the kick. */
static enum status kick(struct job *j, struct fault *why)
{
    struct scene_start at;
    const char *reason;

    if (!kick_state(&j->push.slider, &j->kick, &at, &reason))
        return fault_set(why, STATUS_BAD_ARGUMENT, "push: --from creep: %s",
                         reason);
    j->state[0] = (struct push_state){ at.v, at.psi };
    return STATUS_OK;
}

/* The states of another material: what was asked, read in its units. */
static bool states_of(void *ctx, const struct scene *scene,
                      const struct slider *slider, struct push_state out[])
{
    const struct job *j = ctx;
    struct scene_start z;
    struct fault why;
    const char *reason;
    enum status s = STATUS_OK;

    for (size_t i = 0; i < j->table.rows && s == STATUS_OK; i++)
        s = read_row(j, scene, i, &out[i], &why);
    if (j->table.rows > 0)
        return s == STATUS_OK;
    if (j->o->from ? !kick_state(slider, &j->kick, &z, &reason)
                   : state_read(j->o, scene, &z, &why) != STATUS_OK)
        return false;
    out[0] = (struct push_state){ z.v, z.psi };
    return true;
}

static enum status find_answers(struct job *j, const struct options *o,
                                const struct scene *scene, struct fault *why)
{
    const struct monitor *monitor = progress_monitor(o);
    enum status s = push_init(&j->push, scene, monitor, why);

    if (s == STATUS_OK && o->from)
        s = kick(j, why);
    if (s == STATUS_OK)
        s = check_states(j, why);
    if (s == STATUS_OK)
        s = push_tabulate(&j->push, monitor);
    if (s == STATUS_OK)
        s = push_scatter_find(&j->push, &(struct push_source){ states_of, j },
                              j->state, j->count, monitor, j->answer);
    progress_end();
    if (s == STATUS_OK)
        s = drawn_run(o, scene, &j->drawn, why);
    if (s == STATUS_OK)
        name_answers(j);
    return s;
}

static enum status write_answers(const struct options *o,
                                 const struct scene *scene, const struct job *j,
                                 struct fault *why)
{
    const struct push_answers all = { j->answer, j->count,
                                      scene->ensemble.scattered > 0 };
    const enum status s =
        o->output
            ? push_file_write(scene, &all, drawn_of(&j->drawn), o->output, why)
            : STATUS_OK;

    if (s == STATUS_OK && o->output)
        output_tell(o, o->output);
    return s;
}

static enum exit_code run(const struct options *o, const struct scene *scene)
{
    struct job j = { .o = o, .drawn = ENSEMBLE_EMPTY };
    struct fault why = { "" };

    if (scene->system)
        return plane_push(o, scene);
    enum status s = o->states ? read_states(&j, o, scene, &why)
                              : read_single(&j, o, scene, &why);
    if (s == STATUS_OK)
        s = find_answers(&j, o, scene, &why);
    if (s == STATUS_OK)
        s = write_answers(o, scene, &j, &why);
    const enum exit_code code =
        s == STATUS_OK ? tell_answers(o, scene, &j) : command_fail(s, why.text);
    push_free(&j.push);
    ensemble_free(&j.drawn);
    table_free(&j.table);
    free(j.state);
    free(j.answer);
    free(j.number);
    return code;
}

/* --state x=1,y=0.5 as {x: 1, y: 0.5}. */
static enum status system_setting(const struct options *o,
                                  const struct scene *scene,
                                  char text[PUSH_SETTING], struct fault *why)
{
    const struct system_state *name = scene->system->state;
    double z[2];
    const enum status s = plane_push_read(scene, o->state, z, why);

    if (s == STATUS_OK)
        snprintf(text, PUSH_SETTING, "ensemble.pushes=[{%s: %s, %s: %s}]",
                 name[0].name, number_shortest(z[0]).text, name[1].name,
                 number_shortest(z[1]).text);
    return s;
}

/* What was asked as pushes of the scene's ensemble. */
static enum status push_setting(const struct options *o,
                                const struct scene *scene,
                                char text[PUSH_SETTING], struct fault *why)
{
    const struct unit *rate = unit_find("V_star");
    struct scene_start z;
    struct scene_push p;

    if (o->states)
        return command_refuse(why,
                              "push: --states %s: draws are of one state, "
                              "expected --state, --v and --psi, or --from "
                              "creep, or no draws",
                              o->states);
    if (scene->system)
        return system_setting(o, scene, text, why);
    const enum status s =
        o->from ? read_kick(o, scene, &p, why) : state_read(o, scene, &z, why);
    if (s == STATUS_OK && !o->from)
        state_setting(o, "ensemble.pushes", text, PUSH_SETTING);
    if (s != STATUS_OK || !o->from)
        return s;
    snprintf(text, PUSH_SETTING, "ensemble.pushes=[{from: creep, kick: %s%s}]",
             number_shortest(p.v).text,
             unit_text_name(rate, p.is_si ? UNIT_TEXT_SI : UNIT_TEXT_OWN).text);
    return STATUS_OK;
}

/* Read again with them, where draws are asked for. */
static enum status read_draws(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    char push[PUSH_SETTING], none[] = "ensemble.numbers=[]",
                             *more[] = { none, push };
    enum status s = drawn_check(o, scene, why);

    if (s != STATUS_OK || !scene->ensemble.is_drawn ||
        scene->ensemble.scattered == 0)
        return s;
    s = push_setting(o, scene, push, why);
    if (s != STATUS_OK)
        return s;
    scene_free(scene);
    return command_read(o, more, 2, scene, why);
}

static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    enum status s = check_options(o, why);

    if (s == STATUS_OK)
        s = command_read(o, NULL, 0, scene, why);
    if (s != STATUS_OK)
        return s;
    s = check_state(o, scene, why);
    if (s == STATUS_OK && (!scene->system || o->states || o->state))
        s = read_draws(o, scene, why);
    if (s != STATUS_OK)
        scene_free(scene);
    return s;
}

enum exit_code command_push(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
