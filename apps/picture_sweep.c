#include "picture_sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "line.h"
#include "mark.h"
#include "picture_plane.h"
#include "plane_numbers.h"
#include "scene_sweep.h"
#include "sweep_sheet.h"
#include "sweep_show.h"
#include "sweep_told.h"
#include "system.h"

/* A bar can be seen when it is this part of its axis long: 2 px of 600.  Marks
 * are at least this part of the axis along the key apart. */
static const double visible = 1.0 / 300.0, apart = 1.0 / 36.0;

/* ---- over one key -------------------------------------------------------- */

/* What is drawn, and where: y.lo < y.hi. */
struct plot {
    const struct sweep *s;
    struct figure *figure;
    struct figure_axis x, y;
    struct sweep_curve curve[SWEEP_CURVES_MAX];
    size_t curves; /* of a system: none */
};

/* A number of a point as it is drawn. */
static struct quantity drawn(const struct sweep *s, int column, size_t point)
{
    const struct unit_system u = sweep_units(s, point);

    return sweep_told(s, &u, column, point, 0);
}

/* The least and largest value of all curves that the axis can show. */
static void span(const struct sweep *s, const struct sweep_curve curve[],
                 size_t curves, bool is_log, double range[2])
{
    for (size_t k = 0; k < curves; k++) {
        const int column = sweep_find(s, curve[k].column);
        for (size_t i = 0; column >= 0 && i < s->points; i++) {
            const double y = drawn(s, column, i).value;
            if (y > 0.0 || !is_log)
                range_grow(range, &y, 1);
        }
    }
    if (!(range[0] <= range[1])) { /* no values */
        range[0] = 0.1;
        range[1] = 10.0;
    }
}

/* As the scene asks, as the table does, or as the values need. */
static struct figure_axis upward(const struct sweep *s,
                                 const struct sweep_curve curve[],
                                 size_t curves)
{
    const struct scene_sweep *w = &s->scene->sweep;
    const struct show_frame *show = &show_frames[w->show];
    const bool is_log = scene_sweep_y_log(w);
    const char *label = show->label[sweep_is_si(s)];
    double range[2] = RANGE_EMPTY;

    for (int i = 0; i < 2; i++) {
        const double *r = i == 0 ? w->y_range : show->range;
        if (r[0] < r[1] && (r[0] > 0.0 || !is_log))
            return (struct figure_axis){ label, r[0], r[1], is_log };
    }
    span(s, curve, curves, is_log, range);
    const double rim = is_log ? 0.03 * log(range[1] / range[0]) + 0.03
                              : 0.04 * (range[1] - range[0]);
    return sweep_around(label, range[0], range[1], is_log, rim);
}

/* The bar from y - error to y + error, where it can be seen. */
static void add_bar(const struct plot *p, const struct sweep_curve *c, double x,
                    double y, double error)
{
    const bool is_log = p->y.is_log;
    const double part = is_log ? error / y / log(p->y.hi / p->y.lo)
                               : error / (p->y.hi - p->y.lo);
    const double least = is_log ? 0.1 * y : -HUGE_VAL;

    if (2.0 * part > visible)
        sheet_segment(p->figure,
                      (struct figure_style){ c->style.role, FIGURE_SOLID, 0 },
                      NULL, (struct vec2){ x, fmax(y - error, least) },
                      (struct vec2){ x, y + error });
}

/* The column of a curve that is drawn; -1: none, nor of shares of fates that no
 * state has. */
static int drawn_column(const struct sweep *s, const struct sweep_curve *c)
{
    const int column = sweep_find(s, c->column);
    size_t i = 0;

    while (column >= 0 && i < s->points &&
           sweep_quantity(s, column, i).value == 0.0)
        i++;
    return i < s->points ? column : -1;
}

/* NaN where there is no value, and at a mark that would lie on top of the one
 * before it. */
static void find_values(const struct plot *p, const struct sweep_curve *c,
                        int column, double y[])
{
    const struct sweep_axis *a = &p->s->axis[0];
    const double step =
        apart * (sweep_place(a, p->x.hi) - sweep_place(a, p->x.lo));
    double last = -HUGE_VAL;

    for (size_t i = 0; i < p->s->points; i++) {
        const double x = sweep_place(a, a->value[i]);
        y[i] = drawn(p->s, column, i).value;
        if (c->marks && x - last < step)
            y[i] = (double) NAN;
        else if (isfinite(y[i]))
            last = x;
    }
}

/* ---- a line: jumps at folds, single values as points ----------------------
 */

/* Whether a fold lies between two points: one has a saddle and one has none. */
static bool is_fold(const struct sweep *s, int saddle, size_t i)
{
    return saddle >= 0 && isfinite(sweep_quantity(s, saddle, i).value) !=
                              isfinite(sweep_quantity(s, saddle, i + 1).value);
}

/* Half way from point i to the next on the axis. */
static double half_way(const struct sweep_axis *a, size_t i)
{
    return a->is_log ? sqrt(a->value[i]) * sqrt(a->value[i + 1])
                     : a->value[i] / 2.0 + a->value[i + 1] / 2.0;
}

/* Up to a fold as before it, from there on as behind it; what is only on one
 * side ends there. */
static struct line line_of(const struct plot *p, const double y[])
{
    const struct sweep_axis *a = &p->s->axis[0];
    const int saddle = sweep_find(p->s, "saddle_v");
    struct line l = LINE_EMPTY;

    for (size_t i = 0; i < p->s->points; i++) {
        line_add(&l, a->value[i], y[i]);
        if (i + 1 == p->s->points || !is_fold(p->s, saddle, i) ||
            isfinite(y[i]) != isfinite(y[i + 1]))
            continue;
        line_add(&l, half_way(a, i), y[i]);
        line_add(&l, half_way(a, i), y[i + 1]);
    }
    return l;
}

/* Marks are told apart as lines are. */
static enum figure_mark single_mark(const struct sweep_curve *c)
{
    static const enum figure_mark mark[] = { FIGURE_DISC,     FIGURE_SQUARE,
                                             FIGURE_TRIANGLE, FIGURE_DIAMOND,
                                             FIGURE_BOX,      FIGURE_DELTA };
    const int k = (int) c->style.role - FIGURE_SERIES_1;

    return mark[k < 0 || k > 5 ? 0 : k];
}

/* Values without a neighbour, which are no line. */
static void add_single(const struct plot *p, const struct sweep_curve *c,
                       const double y[])
{
    for (size_t i = 0; i < p->s->points; i++)
        if (isfinite(y[i]) && (i == 0 || !isfinite(y[i - 1])) &&
            (i + 1 == p->s->points || !isfinite(y[i + 1])))
            figure_add(p->figure,
                       &(struct figure_layer){ .kind = FIGURE_POINTS,
                                               .style = c->style,
                                               .entry = c->entry,
                                               .x = &p->s->axis[0].value[i],
                                               .y = &y[i],
                                               .count = 1,
                                               .size = 7,
                                               .mark = single_mark(c) });
}

static void add_marks(const struct plot *p, const struct sweep_curve *c,
                      const double y[])
{
    figure_add(p->figure, &(struct figure_layer){ .kind = FIGURE_POINTS,
                                                  .style = c->style,
                                                  .entry = c->entry,
                                                  .x = p->s->axis[0].value,
                                                  .y = y,
                                                  .count = p->s->points,
                                                  .mark = c->mark });
}

static void add_line(const struct plot *p, const struct sweep_curve *c,
                     const double y[])
{
    struct line l = line_of(p, y);

    figure_add_curve(p->figure, c->style, c->entry, &l);
    add_single(p, c, y);
}

/* A line, or marks, with bars. */
static void add_curve(const struct plot *p, const struct sweep_curve *own)
{
    const int column = drawn_column(p->s, own);
    const double *x = p->s->axis[0].value;
    struct sweep_curve told = *own, *c = &told;

    if (column < 0)
        return;
    sweep_letters(p->s, told.entry);
    double *y = malloc(p->s->points * sizeof *y);
    if (y == NULL) {
        p->figure->status = STATUS_NO_MEMORY;
        return;
    }
    find_values(p, c, column, y);
    (c->marks ? add_marks : add_line)(p, c, y);
    for (size_t i = 0; i < p->s->points; i++)
        if (isfinite(y[i]))
            add_bar(p, c, x[i], y[i], drawn(p->s, column, i).error);
    free(y);
}

/* ---- where there is nothing to draw ---------------------------------------
 */

static bool any_value(const struct plot *p, size_t point)
{
    bool any = false;

    if (p->s->scene->system)
        return sweep_quantity(p->s, sweep_find(p->s, "count_equilibria"), point)
                   .value != 0.0;
    for (size_t k = 0; k < p->curves && !any; k++) {
        const int column = drawn_column(p->s, &p->curve[k]);
        any = column >= 0 && isfinite(drawn(p->s, column, point).value);
    }
    return any;
}

/* From half way to the point before to half way to the one behind. */
static void add_gap(const struct plot *p, size_t first, size_t last)
{
    const struct sweep_axis *a = &p->s->axis[0];
    const double lo = first > 0 ? half_way(a, first - 1) : p->x.lo;
    const double hi = last + 1 < p->s->points ? half_way(a, last) : p->x.hi;

    figure_add_block(p->figure, (double[]){ lo, hi },
                     (double[]){ p->y.lo, p->y.hi }, FIGURE_SHADE_6,
                     "does not exist");
}

static void add_gaps(const struct plot *p)
{
    size_t first = 0;

    for (size_t i = 0; i <= p->s->points; i++) {
        if (i < p->s->points && !any_value(p, i))
            continue;
        if (first < i)
            add_gap(p, first, i - 1);
        first = i + 1;
    }
}

/* ---- of a system --------------------------------------------------------- */

/* The first state of equilibrium k at each point of type `type`; NaN at others.
 */
static bool find_states(const struct sweep *s, size_t k, int type, double y[])
{
    char name[2][64];
    bool any = false;

    snprintf(name[0], sizeof name[0], "equilibria_%zu_type", k);
    snprintf(name[1], sizeof name[1], "equilibria_%zu_state_%.32s", k,
             s->scene->system->state[0].name);
    const int code = sweep_find(s, name[0]), column = sweep_find(s, name[1]);
    for (size_t i = 0; i < s->points && code >= 0 && column >= 0; i++) {
        const bool is_it = sweep_code(s, code, i) == type;
        y[i] = is_it ? sweep_quantity(s, column, i).value : (double) NAN;
        any = any || isfinite(y[i]);
    }
    return any;
}

/* Every equilibrium over the key, marked by what it is. */
static void add_equilibria(const struct plot *p)
{
    double *y = malloc(p->s->points * sizeof *y);

    if (y == NULL)
        p->figure->status = STATUS_NO_MEMORY;
    for (size_t k = 0; k < PLANE_RESTS_ALONE && y; k++)
        for (int type = 0; type < PLANE_TYPES; type++)
            if (find_states(p->s, k, type, y))
                figure_add(p->figure,
                           &(struct figure_layer){
                               .kind = FIGURE_POINTS,
                               .style = { .role = (enum figure_role)(
                                              FIGURE_SERIES_1 + type) },
                               .entry = picture_plane_look[type].entry,
                               .x = p->s->axis[0].value,
                               .y = y,
                               .count = p->s->points,
                               .size = 5,
                               .mark = picture_plane_look[type].mark });
    free(y);
}

static void draw_key(const struct sweep *s, struct figure *f)
{
    const struct scene *c = s->scene;
    const struct sweep_axis *a = &s->axis[0];
    const struct sheet_label x = sweep_label(s, 0);
    struct plot p = { .s = s, .figure = f };
    char y[2 * FORMULA_NAME];

    p.x = sweep_around(x.text, a->value[0], a->value[a->count - 1], a->is_log,
                       0.0);
    if (c->system) {
        mark_name(y, sizeof y, c->system->state[0].name);
        p.y = (struct figure_axis){ y, c->window.v[0], c->window.v[1],
                                    c->window.axes == AXES_LOG &&
                                        scene_axis_is_log(c, 0) };
    } else {
        p.curves = sweep_show_curves(c, p.curve);
        p.y = upward(s, p.curve, p.curves);
    }
    figure_init(f, sweep_title(s).text, &p.x, &p.y);
    add_gaps(&p);
    for (size_t k = 0; k < p.curves; k++)
        add_curve(&p, &p.curve[k]);
    if (c->system)
        add_equilibria(&p);
}

/* ---- over a grid --------------------------------------------------------- */

/* Cells of the map: no finer than can be seen. */
enum { COLUMNS = 360, ROWS = 240 };

/* The axis that shows all values, with half a step around them. */
static struct figure_axis frame(const struct sweep_axis *a, const char *label)
{
    const double lo = a->value[0], hi = a->value[a->count - 1];
    const double step = a->count > 1
                            ? (sweep_place(a, hi) - sweep_place(a, lo)) /
                                  (double) (a->count - 1)
                            : 0.0;

    return sweep_around(label, lo, hi, a->is_log, 0.5 * step);
}

/* The value nearest the middle of each of n cells, as an index. */
static void nearest(const struct sweep_axis *a, const struct figure_axis *shown,
                    size_t n, size_t index[])
{
    const double lo = sweep_place(a, shown->lo), hi = sweep_place(a, shown->hi);
    size_t k = 0;

    for (size_t i = 0; i < n; i++) {
        const double x = lo + (hi - lo) * ((double) i + 0.5) / (double) n;
        while (k + 1 < a->count && fabs(sweep_place(a, a->value[k + 1]) - x) <=
                                       fabs(sweep_place(a, a->value[k]) - x))
            k++;
        index[i] = k;
    }
}

/* Whether the map's cells are the points: no nearer to one side than can be
 * seen. */
static bool is_even(const struct sweep_axis *a)
{
    const double lo = sweep_place(a, a->value[0]);
    const double step =
        (sweep_place(a, a->value[a->count - 1]) - lo) / (double) (a->count - 1);
    bool even = a->count > 1;

    for (size_t i = 0; i < a->count && even; i++)
        even = fabs(sweep_place(a, a->value[i]) - lo - (double) i * step) <=
               visible * step;
    return even;
}

static void add_map(const struct sweep *s, const struct figure_axis *x,
                    const struct figure_axis *y, struct figure *f)
{
    static double value[ROWS * COLUMNS];
    static const struct show_frame count = {
        .map = "count_equilibria", .map_label = { "equilibria", "equilibria" }
    };
    const struct show_frame *show =
        s->scene->system ? &count : &show_frames[s->scene->sweep.show];
    const int column = sweep_find(s, show->map);
    const bool even = is_even(&s->axis[0]) && is_even(&s->axis[1]) &&
                      s->axis[0].count <= COLUMNS && s->axis[1].count <= ROWS;
    const size_t nx = even ? s->axis[0].count : COLUMNS;
    const size_t ny = even ? s->axis[1].count : ROWS;
    size_t across[COLUMNS], up[ROWS];

    nearest(&s->axis[0], x, nx, across);
    nearest(&s->axis[1], y, ny, up);
    for (size_t j = 0; j < ny; j++)
        for (size_t i = 0; i < nx; i++)
            value[j * nx + i] =
                column < 0
                    ? (double) NAN
                    : drawn(s, column, across[i] * s->axis[1].count + up[j])
                          .value;
    figure_add_map(f, &(struct figure_map){
                          .value = value,
                          .nx = nx,
                          .ny = ny,
                          .contours = even && s->scene->system == NULL,
                          .scale = { .label = show->map_label[sweep_is_si(s)] },
                          .missing = "does not exist" });
}

static void draw_map(const struct sweep *s, struct figure *f)
{
    const struct sheet_label label[] = { sweep_label(s, 0), sweep_label(s, 1) };
    const struct figure_axis x = frame(&s->axis[0], label[0].text);
    const struct figure_axis y = frame(&s->axis[1], label[1].text);

    figure_init(f, sweep_title(s).text, &x, &y);
    add_map(s, &x, &y, f);
}

void picture_sweep(const struct sweep *s, struct figure *f)
{
    (s->axes == 1 ? draw_key : draw_map)(s, f);
}
