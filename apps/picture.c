/* A study drawn: every curve goes from the chart through one function to the
 * numbers on the axes. */
#include "picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crowd.h"
#include "eigen_frame.h"
#include "physical.h"
#include "picture_diagram.h"
#include "picture_field.h"
#include "picture_taylor.h"
#include "scene_figure.h"
#include "scene_units.h"
#include "sheet.h"
#include "symbols.h"

/* What lies under the curves. */
enum ground { GROUND_BASINS, GROUND_FIELD, GROUND_MARGIN };

struct picture {
    const struct study *s;
    struct figure *figure;  /* borrowed */
    struct eigen_view view; /* of eigen axes */
    enum axes axes;
    struct picture_raster raster; /* owned; empty: no image below */
    enum ground ground;           /* shown now */
    enum cell_field field;
    enum basin_axis margin;
};

/* From (v, psi) to what the axes show; psi that is a logarithm as e^psi. */
static struct vec2 shown_value(const struct picture *p, struct vec2 u)
{
    const struct block *b = &p->s->slider.block;

    if (p->s->scene->units == UNITS_SI)
        return (struct vec2){ u.x * b->material.V_star,
                              physical_phi(&b->law, &b->material, u.y) };
    return (struct vec2){ u.x, law_psi_is_log(&b->law) ? exp(u.y) : u.y };
}

/* From an offset in the chart to what the axes show. */
static struct vec2 shown(const struct picture *p, struct vec2 z)
{
    const struct block *b = &p->s->slider.block;

    if (p->axes == AXES_EIGEN)
        return eigen_coordinates(p->view.basis, z);
    return shown_value(p, (struct vec2){ block_v(b, z.x), block_psi(b, z.y) });
}

/* ---- axes ---------------------------------------------------------------- */

static void labels(const struct picture *p, char *x, char *y, size_t size)
{
    const struct block *b = &p->s->slider.block;
    const bool si = p->s->scene->units == UNITS_SI;

    if (p->axes == AXES_EIGEN) {
        snprintf(x, size, "stable coordinate " ITALIC("X"));
        snprintf(y, size, "unstable coordinate " ITALIC("Y"));
        return;
    }
    snprintf(x, size,
             si ? "slip rate " S_BIG_V " (m/s)" : "slip rate " S_V_RATIO);
    if (si)
        snprintf(y, size, "interfacial state " S_PHI "%s",
                 strcmp(physical_unit(&b->law), "s") == 0 ? " (s)" : "");
    else
        snprintf(y, size,
                 law_psi_is_log(&b->law) ? "interfacial state " S_PHI
                                           " = exp " S_PSI
                                         : "interfacial state " S_PSI);
}

/* The window's corners on the axes; for eigen axes a square around the saddle.
 */
static struct box frame(const struct picture *p)
{
    const struct scene_window *w = &p->s->scene->window;

    if (p->axes != AXES_EIGEN)
        return (
            struct box){ shown_value(p, (struct vec2){ w->v[0], w->psi[0] }),
                         shown_value(p, (struct vec2){ w->v[1], w->psi[1] }) };
    return (struct box){ { -p->view.reach, -p->view.reach },
                         { p->view.reach, p->view.reach } };
}

static void start_figure(struct picture *p)
{
    const struct box f = frame(p);
    char x[96], y[96];

    labels(p, x, y, sizeof x);
    figure_init(
        p->figure, sheet_title(p->s->scene, true).text,
        &(struct figure_axis){ x, f.lo.x, f.hi.x, p->axes == AXES_LOG },
        &(struct figure_axis){ y, f.lo.y, f.hi.y, p->axes == AXES_LOG });
}

/* ---- layers -------------------------------------------------------------- */

static void add_point(const struct picture *p, struct line *l, struct vec2 z)
{
    const struct vec2 at = shown(p, z);

    line_add(l, at.x, at.y);
}

/* Into so many chords that none is further from piece i than the page allows,
 * also where it turns by a right angle: half its length by the angle at most,
 * over four times their number squared.  On linear axes, which stretch, 48. */
static int piece_chords(const struct picture *p, const struct curve *c,
                        size_t i)
{
    const struct box w = scene_box(p->s->scene);
    double a[CURVE_DIM_MAX], b[CURVE_DIM_MAX];

    if (p->axes == AXES_LINEAR)
        return 48;
    curve_at(c, i, 0.0, a);
    curve_at(c, i, 1.0, b);
    const double length = hypot((b[0] - a[0]) / (w.hi.x - w.lo.x),
                                (b[1] - a[1]) / (w.hi.y - w.lo.y));
    return 4 + (int) sqrt(fmin(length, 16.0) / 4.0 /
                          scene_figure_chord(&p->s->scene->paper));
}

static struct line curve_line(const struct picture *p, const struct curve *c)
{
    struct line l = LINE_EMPTY;

    for (size_t i = 0; i < c->count; i++) {
        const int chords = piece_chords(p, c, i);
        for (int k = i == 0 ? 0 : 1; k <= chords; k++) {
            add_point(p, &l, curve_point(c, i, (double) k / chords));
        }
    }
    return l;
}

static void add_nullclines(struct picture *p)
{
    static const enum figure_role role[] = { FIGURE_NULLCLINE_X,
                                             FIGURE_NULLCLINE_Y };
    static const char *const entry[][NULLCLINES] = {
        { S_RATE_OF(S_V) " = 0", S_RATE_OF(S_PSI) " = 0" },
        { S_RATE_OF(S_BIG_V) " = 0", S_RATE_OF(S_PHI) " = 0" },
    };
    const bool si = p->s->scene->units == UNITS_SI;

    for (int i = 0; i < NULLCLINES; i++)
        for (size_t k = 0; k < p->s->portrait.nullcline[i].count; k++) {
            const struct polyline *piece =
                &p->s->portrait.nullcline[i].piece[k];
            struct line l = LINE_EMPTY;
            for (size_t j = 0; j < piece->count; j++)
                add_point(
                    p, &l,
                    vec2_sub(piece->at[j], p->s->slider.plane.system.origin));
            figure_add_curve(p->figure,
                             (struct figure_style){ .role = role[i] },
                             entry[si][i], &l);
        }
}

/* One orbit; with an arrowhead in the middle. */
static void add_chosen(struct picture *p)
{

    for (size_t i = 0; i < p->s->chosen.count; i++) {
        struct line l = curve_line(p, &p->s->chosen.at[i].curve);
        figure_add_way(p->figure,
                       (struct figure_style){ .role = FIGURE_HIGHLIGHT },
                       "trajectory from the given start", &l);
    }
}

/* The asymptote that closes a branch, to the window's edge. */
static void add_asymptote(struct picture *p, const struct branch *b,
                          struct line *l)
{
    const struct box w = scene_box(p->s->scene);
    const struct vec2 origin = p->s->slider.plane.system.origin;
    struct vec2 end = b->limit;

    if (b->end != BRANCH_LIMIT_X && b->end != BRANCH_LIMIT_Y)
        return;
    if (b->end == BRANCH_LIMIT_X)
        end.y = (b->sign > 0 ? fmax(w.hi.y, b->limit.y + origin.y)
                             : fmin(w.lo.y, b->limit.y + origin.y)) -
                origin.y;
    else
        end.x = (b->sign > 0 ? fmax(w.hi.x, b->limit.x + origin.x)
                             : fmin(w.lo.x, b->limit.x + origin.x)) -
                origin.x;
    add_point(p, l, end);
}

/* A branch with its asymptote, along the flow. */
static struct line stable_line(struct picture *p, const struct branch *b)
{
    struct line l = curve_line(p, &b->curve);

    if (b->curve.count > 0)
        add_asymptote(p, b, &l);
    line_reverse(&l);
    return l;
}

static void take_line(struct crowd *crowd, struct line l)
{
    crowd_take(crowd, &l);
    line_free(&l);
}

/* Whole orbits, as far as none runs beside another or beside a manifold. */
static void add_trajectories(struct picture *p)
{
    const struct trajectories *chosen = &p->s->chosen,
                              *all = &p->s->portrait.trajectories;
    struct crowd *crowd = malloc(sizeof *crowd);

    if (crowd == NULL) {
        p->figure->status = STATUS_NO_MEMORY;
        return;
    }
    crowd_init(crowd, p->figure);
    for (int i = 0; i < SIDES; i++) {
        take_line(crowd, stable_line(p, &p->s->stable[i]));
        take_line(crowd, curve_line(p, &p->s->unstable[i].curve));
    }
    for (size_t i = 0; i < chosen->count; i++)
        take_line(crowd, curve_line(p, &chosen->at[i].curve));
    for (size_t i = 0; i < all->count; i++) {
        struct line l = curve_line(p, &all->at[i].curve);
        crowd_cut(crowd, &l);
        figure_add_way(p->figure,
                       (struct figure_style){ .role = FIGURE_TRAJECTORY },
                       "trajectories", &l);
    }
    free(crowd);
}

/* Under the nullclines, which it follows closely. */
static void add_unstable(struct picture *p)
{

    for (int i = 0; i < SIDES; i++) {
        struct line l = curve_line(p, &p->s->unstable[i].curve);
        figure_add_way(p->figure,
                       (struct figure_style){ .role = FIGURE_UNSTABLE },
                       "unstable manifold", &l);
    }
}

static void add_manifolds(struct picture *p)
{

    for (int i = 0; i < SIDES; i++) {
        struct line l = stable_line(p, &p->s->stable[i]);
        figure_add_way(p->figure,
                       (struct figure_style){ .role = FIGURE_STABLE },
                       "stable manifold", &l);
    }
}

static void add_equilibria(struct picture *p)
{
    const struct phase_plane *plane = &p->s->slider.plane;

    for (size_t i = 0; i < plane->equilibria; i++) {
        const bool saddle = plane->equilibrium[i].type == EQUILIBRIUM_SADDLE;
        const struct vec2 at = shown(p, phase_plane_offset(plane, i));
        figure_add_point(p->figure, at.x, at.y, FIGURE_EQUILIBRIUM,
                         saddle ? FIGURE_CIRCLE : FIGURE_DISC, 0.0,
                         saddle ? "saddle" : "stable node");
    }
}

static void add_arrows(struct picture *p)
{
    const struct arrows *a = &p->s->portrait.arrows;
    struct line at = LINE_EMPTY, along = LINE_EMPTY;

    if (p->axes == AXES_EIGEN)
        return;
    const struct box w =
        p->axes == AXES_LOG ? scene_box(p->s->scene) : frame(p);
    const struct vec2 size = vec2_sub(w.hi, w.lo);
    for (size_t i = 0; i < a->columns * a->rows; i++) {
        add_point(p, &at,
                  vec2_sub(a->at[i].z, p->s->slider.plane.system.origin));
        line_add(&along, a->at[i].direction.x * size.x,
                 a->at[i].direction.y * size.y);
    }
    figure_add_arrows(p->figure, &at, &along);
}

/* The power series in v; not on eigen axes. */
static struct vec2 shown_plain(const void *ctx, struct vec2 u)
{
    return shown_value(ctx, u);
}

static void add_taylor(struct picture *p)
{
    if (p->axes != AXES_EIGEN)
        picture_add_taylor(p->s, shown_plain, p, p->figure);
}

/* Of eigen axes, NULL: the scene's window. */
static const struct eigen_view *view_of(const struct picture *p)
{
    return p->axes == AXES_EIGEN ? &p->view : NULL;
}

static enum status label_eigen(const struct picture *p, size_t columns,
                               size_t rows, int8_t label[])
{
    struct vec2 *z = eigen_view_states(&p->view, columns, rows);
    const enum status status =
        z ? eigen_view_labels(p->s, z, columns * rows, label)
          : STATUS_NO_MEMORY;

    free(z);
    return status;
}

/* The basins as tints. */
static void add_basins(struct picture *p)
{
    enum { COLUMNS = 720, ROWS = 480, COARSER = 2 };
    static const struct figure_shade shade[] = {
        { FATE_CREEP, FIGURE_SHADE_1, "creeps" },
        { FATE_SLIDING, FIGURE_SHADE_2, "slides" },
        { FATE_REST_FINITE, FIGURE_SHADE_3, "comes to rest" },
        { FATE_REST_ASYMPTOTIC, FIGURE_SHADE_4, "rests as " S_T " → ∞" },
        { FATE_RUNAWAY, FIGURE_SHADE_5, "runs away" },
        { FATE_UNDECIDED, FIGURE_SHADE_6, "undecided" },
    };
    const bool eigen = p->axes == AXES_EIGEN;
    const size_t nx = eigen ? COLUMNS / COARSER : COLUMNS,
                 ny = eigen ? ROWS / COARSER : ROWS;
    int8_t *label = malloc(nx * ny);

    p->figure->status = label == NULL ? STATUS_NO_MEMORY
                        : eigen
                            ? label_eigen(p, nx, ny, label)
                            : basin_map_raster(&p->s->basins, nx, ny, label);
    if (p->figure->status == STATUS_OK && !eigen && p->s->label_proof.row)
        p->figure->status = basin_proof_hide(p->s, nx, ny, label);
    if (p->figure->status == STATUS_OK)
        figure_add_labels(p->figure,
                          &(struct figure_labels){ label, nx, ny, shade,
                                                   sizeof shade / sizeof *shade,
                                                   "not proved" });
    free(label);
}

static void add_ground(struct picture *p)
{
    const struct unit_system units = scene_units(p->s->scene);

    if (p->ground == GROUND_FIELD)
        picture_add_field(&p->raster, p->field, &units, p->figure);
    else if (p->ground == GROUND_MARGIN)
        picture_add_margin(p->s, view_of(p), p->margin, p->figure);
    else if (plan_has(p->s->stages, STAGE_BASINS))
        add_basins(p);
}

static void draw_portrait(struct picture *p)
{
    static void (*const layer[])(
        struct picture *) = { add_ground,       add_arrows,   add_taylor,
                              add_trajectories, add_unstable, add_nullclines,
                              add_manifolds,    add_chosen,   add_equilibria };

    start_figure(p);
    for (size_t i = 0; i < sizeof layer / sizeof *layer; i++)
        layer[i](p);
}

/* One picture more, the first where the figure was asked for. */
static void draw_panel(struct picture *p, enum ground ground, const char *name,
                       struct panels *out)
{
    p->figure = panels_add(out, out->names.count ? name : "");
    p->ground = ground;
    draw_portrait(p);
}

static void draw_fields(struct picture *p, const struct monitor *monitor,
                        struct panels *out)
{
    const enum status status =
        picture_raster_find(&p->raster, p->s, view_of(p), monitor);

    for (int k = 0; k < CELL_FIELDS; k++) {
        p->field = (enum cell_field) k;
        if (!(p->s->fields.which >> k & 1u))
            continue;
        if (status == STATUS_OK)
            draw_panel(p, GROUND_FIELD, picture_field_panel(p->field), out);
        else
            panels_add(out, picture_field_panel(p->field))->status = status;
    }
    picture_raster_free(&p->raster);
}

static void draw_margins(struct picture *p, struct panels *out)
{
    for (int k = BASIN_V; k <= BASIN_PSI; k++) {
        p->margin = (enum basin_axis) k;
        draw_panel(p, GROUND_MARGIN, picture_margin_panel(p->margin), out);
    }
}

/* Each field, the map, each margin. */
void picture_study(const struct study *s, const struct monitor *monitor,
                   struct panels *out)
{
    struct picture p = { .s = s, .axes = s->scene->window.axes };
    const bool grid = plan_has(s->stages, STAGE_BASINS);

    if (picture_has_diagram(s)) {
        picture_diagram(s, panels_add(out, ""));
        return;
    }
    if (slider_saddle(&s->slider) >= 0)
        p.view = eigen_view_of(s);
    else if (p.axes == AXES_EIGEN)
        p.axes = AXES_LOG; /* nothing to be eigen about */
    if (grid && s->fields.which != 0)
        draw_fields(&p, monitor, out);
    draw_panel(&p, GROUND_BASINS, "_basins", out);
    if (grid && s->scene->products >> PRODUCT_MARGIN & 1u &&
        margin_exists(&s->basins.labels.regions))
        draw_margins(&p, out);
}
