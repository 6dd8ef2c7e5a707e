/* A study drawn: every curve goes from the chart through one function to the
 * numbers on the axes. */
#include "picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw.h"
#include "eigen_frame.h"
#include "panel.h"
#include "physical.h"
#include "picture_diagram.h"
#include "picture_field.h"
#include "picture_taylor.h"
#include "tolerance.h"

struct picture {
    const struct study *s;
    struct figure figure;
    struct mat2 basis; /* eigenvectors, for eigen axes */
    enum axes axes;
    const struct monitor *monitor; /* borrowed */
    struct picture_raster raster;  /* owned; empty: no image below */
    enum cell_field field;         /* shown now */
};

/* Eigenvectors as columns, both with x-component 1: (x, y) = P (X, Y), (36). */
static struct mat2 paper_basis(const struct equilibrium *e)
{
    const struct mat2 P = eigen_basis(e);
    return (struct mat2){ 1.0, 1.0, P.yx / P.xx, P.yy / P.xy };
}

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
        return eigen_coordinates(p->basis, z);
    const double y = b->at.y0 + z.y;
    return shown_value(
        p,
        (struct vec2){ b->at.v0 * exp(z.x),
                       law_psi_is_log(&b->law) ? y : b->at.psi0 * exp(z.y) });
}

/* ---- axes ---------------------------------------------------------------- */

static void labels(const struct picture *p, char *x, char *y, size_t size)
{
    const struct block *b = &p->s->slider.block;
    const bool si = p->s->scene->units == UNITS_SI;

    if (p->axes == AXES_EIGEN) {
        snprintf(x, size, "X: along the stable direction, B X of (36)");
        snprintf(y, size, "Y: along the unstable direction, B Y of (36)");
        return;
    }
    snprintf(x, size, si ? "slip rate V (m/s)" : "slip rate v = V/V*");
    if (si)
        snprintf(y, size, "interfacial state φ%s",
                 strcmp(physical_unit(&b->law), "s") == 0 ? " (s)" : "");
    else
        snprintf(y, size,
                 law_psi_is_log(&b->law) ? "interfacial state φ = exp ψ"
                                         : "interfacial state ψ");
}

/* The window's corners on the axes; for eigen axes a square around the saddle
 * that holds both critical velocities. */
static struct box frame(const struct picture *p)
{
    const struct study *s = p->s;
    const struct scene_window *w = &s->scene->window;

    if (p->axes != AXES_EIGEN)
        return (
            struct box){ shown_value(p, (struct vec2){ w->v[0], w->psi[0] }),
                         shown_value(p, (struct vec2){ w->v[1], w->psi[1] }) };
    double reach = 1.0;
    for (int i = 0; i < SIDES; i++)
        if (s->stable[i].curve.count > 0)
            reach = fmax(reach, fabs(s->stable[i].limit.x));
    reach *= 1.5;
    return (struct box){ { -reach, -reach }, { reach, reach } };
}

static enum status start_figure(struct picture *p)
{
    const struct study *s = p->s;
    const struct box f = frame(p);
    char title[512], x[96], y[96];

    snprintf(title, sizeof title, "%s%s%s, α = %.6g rad", s->scene->title,
             s->scene->title[0] ? " — " : "", s->slider.block.law.preset,
             s->scene->alpha);
    labels(p, x, y, sizeof x);
    return figure_init(
        &p->figure, title,
        &(struct figure_axis){ x, f.lo.x, f.hi.x, p->axes == AXES_LOG },
        &(struct figure_axis){ y, f.lo.y, f.hi.y, p->axes == AXES_LOG });
}

/* ---- layers -------------------------------------------------------------- */

/* Points on their way to a layer; owned. */
struct points {
    double *x, *y;
    size_t count, room;
};

static enum status add_point(struct points *q, struct vec2 at)
{
    if (q->count == q->room) {
        const size_t room = q->room ? 2 * q->room : 512;
        double *x = realloc(q->x, room * sizeof *x);
        if (x)
            q->x = x;
        double *y = x ? realloc(q->y, room * sizeof *y) : NULL;
        if (y == NULL)
            return STATUS_NO_MEMORY;
        q->y = y;
        q->room = room;
    }
    q->x[q->count] = at.x;
    q->y[q->count++] = at.y;
    return STATUS_OK;
}

static void free_points(struct points *q)
{
    free(q->x);
    free(q->y);
}

/* Hands the points to the figure as a curve and frees them. */
static enum status flush(struct picture *p, struct points *q,
                         enum figure_role role, const char *entry,
                         const double *heads, size_t head_count,
                         enum status status)
{
    const struct figure_curve c = { .style = { .role = role },
                                    .entry = entry,
                                    .x = q->x,
                                    .y = q->y,
                                    .count = q->count,
                                    .heads = heads,
                                    .head_count = head_count };

    if (status == STATUS_OK && q->count > 1)
        status = figure_add_curve(&p->figure, &c);
    free_points(q);
    return status;
}

/* Sixteen points a piece draw any of our polynomials smoothly. */
static enum status add_curve(struct picture *p, const struct curve *c,
                             enum figure_role role, const char *entry,
                             bool arrow)
{
    enum { PER_PIECE = 16 };
    static const double head[] = { 0.5 };
    struct points q = { 0 };
    double at[CURVE_DIM_MAX];
    enum status status = STATUS_OK;

    for (size_t i = 0; i < c->count; i++)
        for (int k = i == 0 ? 0 : 1; k <= PER_PIECE && !status; k++) {
            curve_at(c, i, (double) k / PER_PIECE, at);
            status = add_point(&q, shown(p, (struct vec2){ at[0], at[1] }));
        }
    return flush(p, &q, role, entry, head, arrow ? 1 : 0, status);
}

static enum status add_nullclines(struct picture *p)
{
    static const enum figure_role role[] = { FIGURE_NULLCLINE_X,
                                             FIGURE_NULLCLINE_Y };
    static const char *const entry[] = { "dv/dt = 0", "dψ/dt = 0" };
    enum status status = STATUS_OK;

    for (int i = 0; i < NULLCLINES; i++)
        for (size_t k = 0; k < p->s->portrait.nullcline[i].count; k++) {
            const struct polyline *l = &p->s->portrait.nullcline[i].piece[k];
            struct points q = { 0 };
            for (size_t j = 0; j < l->count && !status; j++)
                status = add_point(
                    &q, shown(p, vec2_sub(l->at[j],
                                          p->s->slider.plane.system.origin)));
            status = flush(p, &q, role[i], entry[i], NULL, 0, status);
            if (status != STATUS_OK)
                return status;
        }
    return status;
}

static enum status add_trajectories(struct picture *p)
{
    const struct trajectories *spread = &p->s->portrait.trajectories;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < spread->count && !status; i++)
        status = add_curve(p, &spread->at[i].curve, FIGURE_TRAJECTORY,
                           "trajectories", true);
    return status;
}

/* Over the nullclines and manifolds, which they follow closely. */
static enum status add_chosen(struct picture *p)
{
    const struct trajectories *chosen = &p->s->chosen;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < chosen->count && !status; i++)
        status = add_curve(p, &chosen->at[i].curve, FIGURE_HIGHLIGHT,
                           "trajectory from the given start", true);
    return status;
}

/* The asymptote that closes a branch, drawn to the window's edge. */
static enum status add_asymptote(struct picture *p, const struct branch *b)
{
    const struct box w = scene_box(p->s->scene);
    const struct vec2 origin = p->s->slider.plane.system.origin;
    struct points q = { 0 };
    struct vec2 end = b->limit;

    if (b->end != BRANCH_LIMIT_X && b->end != BRANCH_LIMIT_Y)
        return STATUS_OK;
    if (b->end == BRANCH_LIMIT_X)
        end.y = (b->sign > 0 ? fmax(w.hi.y, b->limit.y + origin.y)
                             : fmin(w.lo.y, b->limit.y + origin.y)) -
                origin.y;
    else
        end.x = (b->sign > 0 ? fmax(w.hi.x, b->limit.x + origin.x)
                             : fmin(w.lo.x, b->limit.x + origin.x)) -
                origin.x;
    enum status status = add_point(&q, shown(p, b->limit));
    if (status == STATUS_OK)
        status = add_point(&q, shown(p, end));
    return flush(p, &q, FIGURE_STABLE, "stable manifold", NULL, 0, status);
}

/* Under the nullclines, which it follows closely. */
static enum status add_unstable(struct picture *p)
{
    enum status status = STATUS_OK;

    for (int i = 0; i < SIDES && !status; i++)
        status = add_curve(p, &p->s->unstable[i].curve, FIGURE_UNSTABLE,
                           "unstable manifold", false);
    return status;
}

static enum status add_manifolds(struct picture *p)
{
    enum status status = STATUS_OK;

    for (int i = 0; i < SIDES && !status; i++) {
        if (p->s->stable[i].curve.count == 0)
            continue;
        status = add_curve(p, &p->s->stable[i].curve, FIGURE_STABLE,
                           "stable manifold", false);
        if (!status)
            status = add_asymptote(p, &p->s->stable[i]);
    }
    return status;
}

static enum status add_equilibria(struct picture *p)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < p->s->slider.plane.equilibria && !status; i++) {
        const bool saddle =
            p->s->slider.plane.equilibrium[i].type == EQUILIBRIUM_SADDLE;
        const struct vec2 at =
            shown(p, vec2_sub(p->s->slider.plane.equilibrium[i].z,
                              p->s->slider.plane.system.origin));
        status = figure_add_points(
            &p->figure, &(struct figure_points){
                            .style = { .role = FIGURE_EQUILIBRIUM },
                            .entry = saddle ? "saddle" : "stable node",
                            .x = &at.x,
                            .y = &at.y,
                            .count = 1,
                            .mark = saddle ? FIGURE_CIRCLE : FIGURE_DISC });
    }
    return status;
}

static enum status add_arrows(struct picture *p)
{
    const struct arrows *a = &p->s->portrait.arrows;
    struct points at = { 0 }, along = { 0 };
    enum status status = STATUS_OK;

    if (p->axes == AXES_EIGEN)
        return STATUS_OK;
    const struct box w =
        p->axes == AXES_LOG ? scene_box(p->s->scene) : frame(p);
    const struct vec2 size = vec2_sub(w.hi, w.lo);
    for (size_t i = 0; i < a->columns * a->rows && !status; i++) {
        status = add_point(
            &at,
            shown(p, vec2_sub(a->at[i].z, p->s->slider.plane.system.origin)));
        if (!status)
            status = add_point(&along,
                               (struct vec2){ a->at[i].direction.x * size.x,
                                              a->at[i].direction.y * size.y });
    }
    if (!status && at.count > 0)
        status = figure_add_arrows(
            &p->figure,
            &(struct figure_arrows){ .style = { FIGURE_FIELD, 0, 0 },
                                     .x = at.x,
                                     .y = at.y,
                                     .dx = along.x,
                                     .dy = along.y,
                                     .count = at.count });
    free_points(&at);
    free_points(&along);
    return status;
}

/* The power series in v; not on eigen axes. */
static struct vec2 shown_plain(const void *ctx, struct vec2 u)
{
    return shown_value(ctx, u);
}

static enum status add_taylor(struct picture *p)
{
    return p->axes == AXES_EIGEN
               ? STATUS_OK
               : picture_add_taylor(p->s, shown_plain, p, &p->figure);
}

/* The basins as tints; not on eigen axes, whose window is another. */
static enum status add_basins(struct picture *p)
{
    enum { COLUMNS = 720, ROWS = 480 };
    static const struct figure_shade shade[] = {
        { FATE_CREEP, FIGURE_SHADE_1, "creeps" },
        { FATE_SLIDING, FIGURE_SHADE_2, "slides" },
        { FATE_REST_FINITE, FIGURE_SHADE_3, "comes to rest" },
        { FATE_REST_ASYMPTOTIC, FIGURE_SHADE_4, "rests as t → ∞" },
        { FATE_RUNAWAY, FIGURE_SHADE_5, "runs away" },
        { FATE_UNDECIDED, FIGURE_SHADE_6, "undecided" },
    };

    if (!plan_has(p->s->stages, STAGE_BASINS) || p->axes == AXES_EIGEN ||
        p->s->fields.which != 0)
        return STATUS_OK;
    int8_t *label = malloc((size_t) COLUMNS * ROWS);
    if (label == NULL)
        return STATUS_NO_MEMORY;
    enum status status = basin_map_raster(&p->s->basins, COLUMNS, ROWS, label);
    struct figure_shade shown[FATES];
    size_t count = 0;
    for (int i = 0; i < FATES; i++)
        if (p->s->basins.fraction[i].log.value > 0.0)
            shown[count++] = shade[i];
    if (status == STATUS_OK)
        status = figure_add_labels(
            &p->figure,
            &(struct figure_labels){ label, COLUMNS, ROWS, shown, count });
    free(label);
    return status;
}

/* A field as an image instead. */
static enum status add_field(struct picture *p)
{
    return p->raster.cell ? picture_add_field(&p->raster, p->field, &p->figure)
                          : STATUS_OK;
}

static enum status draw_portrait(struct picture *p)
{
    static enum status (*const layer[])(struct picture *) = {
        add_basins,       add_field,     add_arrows,     add_taylor,
        add_trajectories, add_unstable,  add_nullclines, add_manifolds,
        add_chosen,       add_equilibria
    };
    enum status status;

    if (slider_saddle(&p->s->slider) >= 0)
        p->basis = paper_basis(phase_plane_saddle(&p->s->slider.plane));
    else if (p->axes == AXES_EIGEN)
        p->axes = AXES_LOG; /* nothing to be eigen about */
    status = start_figure(p);
    for (size_t i = 0; i < sizeof layer / sizeof *layer && !status; i++)
        status = layer[i](p);
    return status;
}

/* Of p->figure, drawn with the given status. */
static enum status write_figure(struct picture *p, enum status status,
                                const char *path, bool keep_script,
                                struct fault *why)
{
    if (status == STATUS_OK)
        status = figure_write(&p->figure, path, keep_script, why);
    else
        snprintf(why->text, sizeof why->text, "%.300s: %s", path,
                 status_text(status));
    figure_free(&p->figure);
    p->figure = FIGURE_EMPTY;
    return status;
}

static bool shows_fields(const struct study *s)
{
    return s->fields.which != 0 && s->scene->window.axes != AXES_EIGEN &&
           !picture_has_diagram(s);
}

const char *picture_panel(const struct study *s, size_t i)
{
    if (i == 0)
        return "";
    for (size_t k = 0, n = 0; k < CELL_FIELDS && shows_fields(s); k++)
        if (s->fields.which >> k & 1u && n++ == i)
            return picture_field_panel((enum cell_field) k);
    return NULL;
}

/* One picture for each field, the first where the figure was asked for. */
static enum status draw_fields(struct picture *p, const char *path,
                               bool keep_script, struct fault *why)
{
    enum status status = picture_raster_find(&p->raster, p->s, p->monitor);
    size_t shown = 0;

    if (status != STATUS_OK)
        return write_figure(p, status, path, keep_script, why);
    for (int k = 0; k < CELL_FIELDS && status == STATUS_OK; k++) {
        char to[PANEL_PATH];
        if (!(p->s->fields.which >> k & 1u))
            continue;
        p->field = (enum cell_field) k;
        status = panel_path(path, picture_panel(p->s, shown++), to)
                     ? draw_portrait(p)
                     : STATUS_BAD_ARGUMENT;
        status = write_figure(p, status, to, keep_script, why);
    }
    return status;
}

enum status picture_draw(const struct study *s, const char *path,
                         bool keep_script, const struct monitor *monitor,
                         struct fault *why)
{
    struct picture p = { .s = s,
                         .figure = FIGURE_EMPTY,
                         .axes = s->scene->window.axes,
                         .monitor = monitor };
    enum status status;

    if (picture_has_diagram(s))
        status = write_figure(&p, picture_diagram(s, &p.figure), path,
                              keep_script, why);
    else if (shows_fields(s))
        status = draw_fields(&p, path, keep_script, why);
    else
        status = write_figure(&p, draw_portrait(&p), path, keep_script, why);
    picture_raster_free(&p.raster);
    return status;
}
