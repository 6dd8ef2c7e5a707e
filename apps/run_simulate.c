/* slipway simulate: the motion of the block from each start of a scene, or
 * from the one of --v and --psi. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output.h"
#include "progress.h"
#include "sample.h"
#include "scene_units.h"
#include "sheet.h"
#include "simulation.h"
#include "state.h"
#include "symbols.h"
#include "tolerance.h"

/* ---- picture ------------------------------------------------------------- */

/* Points of a curve: more than there are px along its axis. */
enum { POINTS = 2000 };

/* Those that are the end of a run, and how far they may stretch a log axis. */
enum { ENDING = POINTS / 50, BEYOND = 30 };

/* Shown of a time axis at most, as the fastest changes of a start may be over
 * in 1e-46 units of time; and of another that reaches zero. */
#define DECADES 1e-12

/* One figure over slip, or over time on a log axis; a second curve is drawn
 * dashed. */
struct view {
    bool over_time, y_log;
    struct {
        const char *what;    /* NULL: none */
        const char *name[2]; /* as it is, in the SI */
        size_t at;           /* in struct trajectory_row */
        const char *unit;
    } curve[2];
};

#define AT(name) offsetof(struct trajectory_row, name)
#define SLIP                                                                   \
    {                                                                          \
        "slip", { S_X, S_X }, AT(slip), "L"                                    \
    }
#define RATE                                                                   \
    {                                                                          \
        "slip rate", { S_V, S_BIG_V }, AT(v), "V_star"                         \
    }
#define STATE                                                                  \
    {                                                                          \
        "state", { S_PSI, S_PHI }, AT(psi), "psi"                              \
    }
#define FRICTION                                                               \
    {                                                                          \
        "friction coefficient " S_MU, { S_MU, S_MU }, AT(mu), "1"              \
    }
static const struct view views[] = {
    { false, false, { FRICTION } },  { false, true, { RATE, STATE } },
    { true, true, { RATE, STATE } }, { true, false, { FRICTION } },
    { true, false, { SLIP } },
};

/* As told; e^psi where psi is a logarithm, for a log axis. */
static double value_of(const struct unit_system *u,
                       const struct trajectory_row *r, size_t at,
                       const char *unit)
{
    const double value =
        unit_value(u, unit_find(unit),
                   *(const double *) (const void *) ((const char *) r + at));

    return at == AT(psi) && u->psi_is_log && !u->si ? exp(value) : value;
}

/* The panels of Figs 14 and 15, one file each: NAME.svg is friction over slip,
 * the others are named NAME_time.svg, ... after these; ended by NULL. */
static const char *const picture_simulation_panel[] = {
    "", "_slip", "_time", "_friction", "_position", NULL
};

/* The points of all runs, one run after another; owned. */
struct points {
    double *x, *y[2]; /* y[1]: NULL where there is one curve only */
    size_t runs;
};

static bool room_for(const struct simulation *s, const struct view *view,
                     struct points *p)
{
    const size_t count = s->runs * POINTS;

    p->x = calloc(count, sizeof *p->x);
    p->y[0] = calloc(count, sizeof *p->y[0]);
    if (view->curve[1].what)
        p->y[1] = calloc(count, sizeof *p->y[1]);
    return p->x && p->y[0] && (p->y[1] || !view->curve[1].what);
}

static enum status fill(const struct simulation *s, const struct view *view,
                        struct points *p)
{
    const struct unit_system units = scene_units(&s->scene);
    struct trajectory_row *row = calloc(POINTS, sizeof *row);

    if (row == NULL || !room_for(s, view, p)) {
        free(row);
        return STATUS_NO_MEMORY;
    }
    for (size_t k = 0; k < s->runs; k++) {
        if (s->run[k].curve.count == 0)
            continue;
        (view->over_time ? sample_log_time : sample_linear_slip)(
            &s->study.slider, &s->run[k], POINTS, row);
        for (size_t i = 0; i < POINTS; i++) {
            const size_t at = p->runs * POINTS + i;
            p->x[at] = view->over_time
                           ? value_of(&units, &row[i], AT(time), "L/V_star")
                           : value_of(&units, &row[i], AT(slip), "L");
            for (int c = 0; c < 2 && p->y[c]; c++)
                p->y[c][at] = value_of(&units, &row[i], view->curve[c].at,
                                       view->curve[c].unit);
        }
        p->runs++;
    }
    free(row);
    return STATUS_OK;
}

static void free_points(struct points *p)
{
    free(p->x);
    free(p->y[0]);
    free(p->y[1]);
}

/* Around one array of values, or two; what is not finite, as e^psi where psi is
 * a logarithm may be, is a gap; of a log axis the ends of runs, where v may
 * fall to zero and psi grow without bound, add a decade or two at most. */
static struct figure_axis axis_of(const char *label, double *const value[2],
                                  size_t count, bool is_log, bool is_time)
{
    double all[2] = RANGE_EMPTY, most[2] = RANGE_EMPTY;

    for (int c = 0; c < 2 && value[c]; c++)
        for (size_t i = 0; i < count; i += POINTS) {
            range_grow(all, value[c] + i, POINTS);
            range_grow(most, value[c] + i, POINTS - ENDING);
        }
    if (!is_log) {
        const double rim = 0.03 * (all[1] - all[0]);
        return (struct figure_axis){ label, all[0] - rim, all[1] + rim, false };
    }
    const double hi = fmin(all[1], most[1] * BEYOND);
    const double seen = fmax(all[0], most[0] / BEYOND);
    const double lo = is_time || seen <= 0.0 ? fmax(seen, DECADES * hi) : seen;
    const double rim = pow(hi / lo, 0.03);
    return (struct figure_axis){ label, lo / rim, hi * rim, true };
}

static void name_run(const struct unit_system *u, const char *curve,
                     const struct transient_summary *sum, char *entry,
                     size_t size)
{
    char v[32], psi[32];

    mark_number(v, sizeof v, unit_value(u, unit_find("V_star"), sum->v), 4);
    mark_number(psi, sizeof psi, unit_value(u, unit_find("psi"), sum->psi), 4);
    snprintf(entry, size,
             u->si ? "%s from " S_BIG_V " = %s m/s, " S_PHI " = %s%s"
                   : "%s from " S_V " = %s, " S_PSI " = %s%s",
             curve, v, psi, strcmp(unit_name(u, "psi"), "s") == 0 ? " s" : "");
}

/* Of each run a mark of its own, and its places along the run: so many runs
 * differ also where colours are the same or there are none. */
static void add_marks(struct figure *f, const char *entry, int colour,
                      const double x[], const double y[], size_t run)
{
    enum { EACH = 8 };
    static const enum figure_mark mark[] = { FIGURE_DISC,     FIGURE_SQUARE,
                                             FIGURE_TRIANGLE, FIGURE_DIAMOND,
                                             FIGURE_PLUS,     FIGURE_CROSS };
    const size_t marks = sizeof mark / sizeof *mark;
    double at[2][EACH];

    for (size_t k = 0; k < EACH; k++) {
        const size_t i = (POINTS * (2 * k + 1) / 2 + 97 * run) / EACH % POINTS;
        at[0][k] = x[i];
        at[1][k] = y[i];
    }
    figure_add(
        f, &(struct figure_layer){ .kind = FIGURE_POINTS,
                                   .style = { .role = (enum figure_role)(
                                                  FIGURE_SERIES_1 + colour) },
                                   .entry = entry,
                                   .x = at[0],
                                   .y = at[1],
                                   .count = EACH,
                                   .size = 7,
                                   .mark = mark[(run + run / marks) % marks] });
}

/* One run in a colour and with a mark of its own; alone, each curve in a colour
 * of its own. */
static void add_run(struct figure *f, const struct unit_system *u,
                    const struct view *view,
                    const struct transient_summary *sum, const struct points *p,
                    size_t at)
{
    for (int c = 0; c < 2 && view->curve[c].what; c++) {
        char entry[160];
        const int colour = (p->runs == 1 ? c : (int) (at % 6));
        if (p->runs == 1)
            snprintf(entry, sizeof entry, "%s", view->curve[c].name[u->si]);
        else
            name_run(u, view->curve[c].name[u->si], sum, entry, sizeof entry);
        figure_add(f,
                   &(struct figure_layer){
                       .style = { (enum figure_role)(FIGURE_SERIES_1 + colour),
                                  c ? FIGURE_DASHED : FIGURE_SOLID, 0 },
                       .entry = entry,
                       .x = p->x + at * POINTS,
                       .y = p->y[c] + at * POINTS,
                       .count = POINTS });
        if (p->runs > 1)
            add_marks(f, entry, colour, p->x + at * POINTS,
                      p->y[c] + at * POINTS, at);
    }
}

static struct figure_style guide(enum figure_dash dash)
{
    return (struct figure_style){ FIGURE_TRAJECTORY, dash, 0 };
}

/* tan(alpha) across, and where the phases of a single run end. */
static void add_guides(struct figure *f, const struct simulation *s,
                       const struct view *view)
{
    const struct unit_system units = scene_units(&s->scene);
    const double drive = (double) s->study.slider.block.tan_alpha;

    if (view->curve[0].at == AT(mu))
        sheet_segment(f, guide(FIGURE_DASHED), S_TAN,
                      (struct vec2){ f->x.lo, drive },
                      (struct vec2){ f->x.hi, drive });
    for (int i = 0; s->runs == 1 && i < PHASES - 1; i++) {
        const struct phase *q = &s->run[0].phase[i];
        const struct quantity *end =
            view->over_time ? &q->end_time : &q->end_slip;
        const double x = unit_value(
            &units, unit_find(view->over_time ? "L/V_star" : "L"), end->value);
        if (quantity_exists(end))
            sheet_segment(f, guide(FIGURE_DOTTED), "ends of phases 1 and 2",
                          (struct vec2){ x, f->y.lo },
                          (struct vec2){ x, f->y.hi });
    }
}

/* Of one curve, or of two with a comma between. */
static struct sheet_label y_label(const struct unit_system *u,
                                  const struct view *view)
{
    struct sheet_label all =
        sheet_label(u, view->curve[0].what, view->curve[0].unit);

    if (view->curve[1].what) {
        const struct sheet_label second =
            sheet_label(u, view->curve[1].what, view->curve[1].unit);
        strncat(all.text, ", ", sizeof all.text - strlen(all.text) - 1);
        strncat(all.text, second.text, sizeof all.text - strlen(all.text) - 1);
    }
    return all;
}

static void build(struct figure *f, const struct simulation *s,
                  const struct view *view, const struct points *p)
{
    const size_t count = p->runs * POINTS;
    const struct unit_system units = scene_units(&s->scene);
    const struct sheet_label over =
        view->over_time ? sheet_label(&units, "time", "L/V_star")
                        : sheet_label(&units, "slip", "L");
    const struct sheet_label label = y_label(&units, view);
    const struct figure_axis x = axis_of(over.text, (double *[]){ p->x, NULL },
                                         count, view->over_time, true);
    const struct figure_axis y =
        axis_of(label.text, p->y, count, view->y_log, false);
    size_t shown = 0;

    figure_init(f, sheet_title(&s->scene, true).text, &x, &y);
    add_guides(f, s, view);
    for (size_t k = 0; k < s->runs; k++)
        if (s->run[k].curve.count > 0)
            add_run(f, &units, view, &s->run[k].sum, p, shown++);
}

/* STATUS_BAD_ARGUMENT where no run has a length: there is nothing to draw. */
static enum status picture_simulation_check(const struct simulation *s,
                                            struct fault *why)
{
    bool any = false;

    for (size_t k = 0; k < s->runs; k++)
        any |= s->run[k].curve.count > 0;
    if (!any)
        return fault_set(why, STATUS_BAD_ARGUMENT,
                         "%.300s: no run has a length", s->scene.figure);
    return STATUS_OK;
}

/* Adds all panels. */
static void picture_simulation(const struct simulation *s, struct panels *out)
{
    for (int i = 0; picture_simulation_panel[i]; i++) {
        struct figure *f = panels_add(out, picture_simulation_panel[i]);
        struct points p = { .x = NULL };
        const enum status status = fill(s, &views[i], &p);
        if (status == STATUS_OK)
            build(f, s, &views[i], &p);
        else
            f->status = status;
        free_points(&p);
    }
}

static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    char start[128], *more[] = { start };
    struct scene_start z;
    enum status s = command_read(o, NULL, 0, scene, why);

    if (s != STATUS_OK || !(o->v || o->psi || o->phi))
        return s;
    s = state_read(o, scene, &z, why);
    scene_free(scene);
    if (s != STATUS_OK)
        return s;
    state_setting(o, "trajectories.starts", start, sizeof start);
    return command_read(o, more, 1, scene, why);
}

static enum status write_files(const struct simulation *s,
                               const struct options *o,
                               const struct results *all, struct fault *why)
{
    struct panels p = PANELS_EMPTY;
    enum status status =
        s->scene.figure ? picture_simulation_check(s, why) : STATUS_OK;

    if (status == STATUS_OK)
        status = output_write(o, "simulate", all, &s->scene, NULL,
                              s->study.slider.block.law.preset, why);
    if (status == STATUS_OK && s->scene.figure)
        picture_simulation(s, &p);
    return status ? status
                  : output_draw(o, &s->scene.paper, &p, s->scene.figure, why);
}

/* Numbers are printed and files written: the user may see for himself. */
static enum exit_code judge(const struct simulation *s)
{
    for (size_t i = 0; i < s->runs; i++) {
        char text[128];
        if (s->run[i].sum.end == TRANSIENT_LOST) {
            snprintf(text, sizeof text, "run %zu: lost: %s", i,
                     s->run[i].reason);
            return command_fail(STATUS_NO_CONVERGENCE, text);
        }
        const double defect = s->run[i].sum.energy_defect;
        if (fabs(defect) <= TOL_TRANSIENT_ENERGY * s->scene.rtol)
            continue;
        snprintf(text, sizeof text,
                 "run %zu: the balance of energy (27) is off by %.1e of its "
                 "largest term",
                 i, defect);
        return command_fail(STATUS_NO_CONVERGENCE, text);
    }
    return EXIT_DONE;
}

/* In both units. */
static void print_starts(FILE *out, const void *run)
{
    const struct simulation *s = run;

    for (size_t i = 0; i < s->runs; i++) {
        fprintf(out, "start %zu: ", i);
        state_print(out, &s->scene, s->run[i].sum.v, s->run[i].sum.psi);
        fputc('\n', out);
    }
}

static enum exit_code run(const struct options *o, const struct scene *scene)
{
    struct simulation s;
    struct fault why = { "" };
    const struct results all = { .table = simulation_tables,
                                 .run = &s,
                                 .units = scene_units(scene) };

    enum status status =
        output_check(o, scene, scene->figure, picture_simulation_panel, &why);
    if (status == STATUS_OK)
        status = simulation_run(&s, scene, progress_monitor(o), &why);
    progress_end();
    if (status != STATUS_OK)
        return command_fail(status, why.text);
    status = write_files(&s, o, &all, &why);
    enum exit_code code = status == STATUS_OK
                              ? output_print(o, &all, print_starts)
                              : command_fail(status, why.text);
    if (code == EXIT_DONE)
        code = judge(&s);
    simulation_free(&s);
    return code;
}

enum exit_code command_simulate(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
