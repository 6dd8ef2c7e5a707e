#include "picture_plane.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crowd.h"
#include "line.h"
#include "margin.h"
#include "mark.h"
#include "plane_map.h"
#include "plane_margin.h"

struct picture {
    const struct plane_study *s;
    struct figure *figure;
    int margin; /* of that state; -1: the map */
};

/* ---- points -------------------------------------------------------------- */

/* What the axes show of a point of the chart. */
static struct vec2 shown(const struct picture *p, struct vec2 z)
{
    return (struct vec2){ plane_state(p->s, 0, z.x),
                          plane_state(p->s, 1, z.y) };
}

/* How many periods a coordinate is away from the window. */
static double turns(double z, double lo, double period)
{
    return period > 0.0 ? floor((z - lo) / period) : 0.0;
}

/* A line in the making: an angle that leaves the window comes back on the other
 * side, as another piece. */
struct stroke {
    struct line line;
    struct vec2 turn, last;
};

static void add(const struct picture *p, struct stroke *t, struct vec2 z)
{
    const struct vec2 period = p->s->scale.period, lo = p->s->window.box.lo;
    const struct vec2 turn = { turns(z.x, lo.x, period.x),
                               turns(z.y, lo.y, period.y) };
    const struct vec2 moved = { z.x - turn.x * period.x,
                                z.y - turn.y * period.y };

    if (t->line.count > 0 && (turn.x != t->turn.x || turn.y != t->turn.y)) {
        const struct vec2 out =
            shown(p, (struct vec2){ z.x - t->turn.x * period.x,
                                    z.y - t->turn.y * period.y });
        const struct vec2 in =
            shown(p, (struct vec2){ t->last.x - turn.x * period.x,
                                    t->last.y - turn.y * period.y });
        line_add(&t->line, out.x, out.y);
        line_add(&t->line, (double) NAN, (double) NAN);
        line_add(&t->line, in.x, in.y);
    }
    const struct vec2 at = shown(p, moved);
    line_add(&t->line, at.x, at.y);
    t->turn = turn;
    t->last = z;
}

static void name_state(const struct picture *p, int i,
                       char text[2 * FORMULA_NAME])
{
    mark_name(text, 2 * FORMULA_NAME, p->s->system[0].axis[i].name);
}

/* ---- layers -------------------------------------------------------------- */

/* From its end to its beginning: way = -1. */
static void add_pieces(const struct picture *p, struct stroke *t,
                       const struct curve *c, size_t pieces, struct vec2 origin,
                       int way)
{
    enum { PER_PIECE = 48 };

    for (size_t i = 0; i < pieces; i++)
        for (int k = i > 0; k <= PER_PIECE; k++) {
            const double part = (double) k / PER_PIECE;
            add(p, t,
                vec2_add(origin, curve_point(c, way > 0 ? i : pieces - 1 - i,
                                             way > 0 ? part : 1.0 - part)));
        }
}

static struct stroke branch_stroke(const struct picture *p,
                                   const struct plane_branch *b)
{
    struct stroke t = { .line = LINE_EMPTY };

    add_pieces(p, &t, &b->curve.curve, b->shown, p->s->rest[b->rest].z, 1);
    return t;
}

/* "to stable focus 0" of stable_focus_0; or undecided. */
static void name_basin(const struct plane_basin *b, size_t i,
                       char entry[PANEL_NAME])
{
    snprintf(entry, PANEL_NAME, "%s%s", i < b->labels ? "to " : "",
             b->share[i].attractor);
    for (char *c = entry; *c; c++)
        *c = *c == '_' ? ' ' : *c;
}

/* The basins as tints. */
static void add_basins(const struct picture *p)
{
    enum { COLUMNS = 720, ROWS = 480, TINTS = FIGURE_SHADE_6 - FIGURE_SHADE_1 };
    const struct plane_basin *b = &p->s->basin;
    struct figure_shade shade[FIGURE_SHADES_MAX];
    char entry[FIGURE_SHADES_MAX][PANEL_NAME];
    size_t count = 0;

    if (b->shares == 0)
        return;
    int8_t *label = malloc((size_t) COLUMNS * ROWS);
    p->figure->status =
        label ? plane_map_fill(p->s, COLUMNS, ROWS, 0, ROWS, label)
              : STATUS_NO_MEMORY;
    for (size_t i = 0; i < b->shares && count < FIGURE_SHADES_MAX; i++)
        if (b->share[i].fraction.value > 0.0) {
            name_basin(b, i, entry[count]);
            shade[count] = (struct figure_shade){
                (int8_t) i,
                i < b->labels
                    ? (enum figure_role)(FIGURE_SHADE_1 + count % TINTS)
                    : FIGURE_SHADE_6,
                entry[count]
            };
            count++;
        }
    if (p->figure->status == STATUS_OK && count > 0)
        figure_add_labels(p->figure,
                          &(struct figure_labels){ label, COLUMNS, ROWS, shade,
                                                   count, NULL });
    free(label);
}

static void add_arrows(const struct picture *p)
{
    const struct arrows *a = &p->s->portrait.arrows;
    const bool log_axes = p->s->scene->window.axes == AXES_LOG;
    const struct box w = p->s->window.box;
    const struct vec2 lo = log_axes ? w.lo : shown(p, w.lo);
    const struct vec2 side = vec2_sub(log_axes ? w.hi : shown(p, w.hi), lo);
    struct line at = LINE_EMPTY, along = LINE_EMPTY;

    for (size_t i = 0; i < a->columns * a->rows; i++) {
        const struct vec2 z = shown(p, a->at[i].z);
        line_add(&at, z.x, z.y);
        line_add(&along, a->at[i].direction.x * side.x,
                 a->at[i].direction.y * side.y);
    }
    figure_add_arrows(p->figure, &at, &along);
}

/* Orbit k as one line along the flow. */
static struct stroke orbit_stroke(const struct picture *p, size_t k)
{
    const struct plane_study *s = p->s;
    const struct curve *way[] = { &s->backward.at[k].curve,
                                  &s->portrait.trajectories.at[k].curve };
    struct stroke t = { .line = LINE_EMPTY };

    for (int i = 0; i < 2; i++)
        add_pieces(p, &t, way[i], way[i]->count, s->system[0].origin,
                   i ? 1 : -1);
    return t;
}

/* As far as none runs beside another or beside a manifold. */
static void add_trajectories(const struct picture *p)
{
    struct crowd *crowd = malloc(sizeof *crowd);

    if (crowd == NULL) {
        p->figure->status = STATUS_NO_MEMORY;
        return;
    }
    crowd_init(crowd, p->figure);
    for (size_t i = 0; i < p->s->branches; i++) {
        struct stroke t = branch_stroke(p, &p->s->branch[i]);
        crowd_take(crowd, &t.line);
        line_free(&t.line);
    }
    for (size_t i = 0; i < p->s->portrait.trajectories.count; i++) {
        struct stroke t = orbit_stroke(p, i);
        crowd_cut(crowd, &t.line);
        figure_add_way(p->figure,
                       (struct figure_style){ .role = FIGURE_TRAJECTORY },
                       "trajectories", &t.line);
    }
    free(crowd);
}

static void add_nullclines(const struct picture *p)
{
    for (int i = 0; i < NULLCLINES; i++) {
        const struct nullcline *n = &p->s->portrait.nullcline[i];
        const struct figure_style style = { .role = i == 0
                                                        ? FIGURE_NULLCLINE_X
                                                        : FIGURE_NULLCLINE_Y };
        char name[2 * FORMULA_NAME], entry[2 * FORMULA_NAME + 32];
        name_state(p, i, name);
        snprintf(entry, sizeof entry, "d%s/d" ITALIC("t") " = 0", name);
        for (size_t k = 0; k < n->count; k++) {
            struct stroke t = { .line = LINE_EMPTY };
            for (size_t j = 0; j < n->piece[k].count; j++)
                add(p, &t, n->piece[k].at[j]);
            figure_add_curve(p->figure, style, entry, &t.line);
        }
    }
}

/* Along the flow: stable ones are grown against it. */
static void add_manifolds(const struct picture *p)
{

    for (size_t i = 0; i < p->s->branches; i++) {
        const struct plane_branch *b = &p->s->branch[i];
        const bool stable = b->kind == MANIFOLD_STABLE;
        struct stroke t = branch_stroke(p, b);
        if (stable)
            line_reverse(&t.line);
        figure_add_way(p->figure,
                       (struct figure_style){
                           .role = stable ? FIGURE_STABLE : FIGURE_UNSTABLE },
                       stable ? "stable manifold" : "unstable manifold",
                       &t.line);
    }
}

const struct picture_plane_look picture_plane_look[PLANE_TYPES] = {
    [PLANE_SADDLE] = { "saddle", FIGURE_CIRCLE },
    [PLANE_STABLE_NODE] = { "stable node", FIGURE_DISC },
    [PLANE_STABLE_FOCUS] = { "stable focus", FIGURE_DIAMOND },
    [PLANE_UNSTABLE_NODE] = { "unstable node", FIGURE_SQUARE },
    [PLANE_UNSTABLE_FOCUS] = { "unstable focus", FIGURE_TRIANGLE },
    [PLANE_NONHYPERBOLIC] = { "not hyperbolic", FIGURE_PLUS },
};

static void add_equilibria(const struct picture *p)
{
    for (size_t i = 0; i < p->s->listed; i++) {
        const struct plane_rest *r = &p->s->rest[i];
        const struct vec2 at = shown(p, r->z);
        figure_add_point(p->figure, at.x, at.y, FIGURE_EQUILIBRIUM,
                         picture_plane_look[r->type].mark, 0.0,
                         picture_plane_look[r->type].entry);
    }
}

/* ---- margins ------------------------------------------------------------- */

enum { MARGIN_COLUMNS = 288, MARGIN_ROWS = 192 };

/* What is added to a state, or of a positive one the factor. */
static void draw_margin(const struct picture *p, int axis,
                        const struct plane_margins cell[], double value[])
{
    enum { N = MARGIN_COLUMNS * MARGIN_ROWS };
    const bool factor = p->s->system[0].axis[axis].is_log;
    char name[2 * FORMULA_NAME], label[2 * FORMULA_NAME + 48];

    for (size_t i = 0; i < N; i++) {
        const double shift = fabs(cell[i].by[axis]);
        value[i] = factor ? exp(shift) : shift;
    }
    name_state(p, axis, name);
    snprintf(label, sizeof label, "%s %s to another fate",
             factor ? "factor on" : "change of", name);
    figure_add_map(p->figure, &(struct figure_map){
                                  .value = value,
                                  .nx = MARGIN_COLUMNS,
                                  .ny = MARGIN_ROWS,
                                  .scale = { .label = label, .is_log = factor },
                                  .contours = true,
                                  .missing = "no other fate there" });
}

/* Each under the curves, as the map is. */
static void add_margin(const struct picture *p)
{
    const size_t n = (size_t) MARGIN_COLUMNS * MARGIN_ROWS;
    struct plane_margins *cell = malloc(n * sizeof *cell);
    double *value = malloc(n * sizeof *value);

    p->figure->status =
        cell && value ? plane_margin_fill(p->s, MARGIN_COLUMNS, MARGIN_ROWS, 0,
                                          MARGIN_ROWS, cell)
                      : STATUS_NO_MEMORY;
    if (p->figure->status == STATUS_OK)
        draw_margin(p, p->margin, cell, value);
    free(cell);
    free(value);
}

/* ---- the whole ----------------------------------------------------------- */

static void draw(const struct picture *p)
{
    static void (*const layer[])(const struct picture *) = {
        add_arrows, add_trajectories, add_nullclines, add_manifolds,
        add_equilibria
    };
    const struct scene *c = p->s->scene;
    const double *range[] = { c->window.v, c->window.psi };
    char label[2][2 * FORMULA_NAME];
    struct figure_axis axis[2];

    for (int i = 0; i < 2; i++) {
        name_state(p, i, label[i]);
        axis[i] = (struct figure_axis){ label[i], range[i][0], range[i][1],
                                        c->window.axes == AXES_LOG &&
                                            p->s->system[0].axis[i].is_log };
    }
    figure_init(p->figure, c->title[0] ? c->title : NULL, &axis[0], &axis[1]);
    (p->margin < 0 ? add_basins : add_margin)(p);
    for (size_t i = 0; i < sizeof layer / sizeof *layer; i++)
        layer[i](p);
}

void picture_plane(const struct plane_study *s, struct panels *out)
{
    const bool margins = s->basin.shares > 0 &&
                         margin_exists(&s->basin.regions) &&
                         s->scene->products >> PRODUCT_MARGIN & 1u;

    for (int margin = -1; margin < (margins ? 2 : 0); margin++) {
        char name[PANEL_NAME] = "";
        if (margin >= 0)
            snprintf(name, sizeof name, "_margin_%.40s",
                     s->system[0].axis[margin].name);
        draw(&(struct picture){ s, panels_add(out, name), margin });
    }
}
