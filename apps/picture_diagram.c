/* Each diagram gathers the points of its curves, spans the axes around them and
 * adds its layers; slip rates in the scene's units. */
#include "picture_diagram.h"

#include <math.h>
#include <stdio.h>

#include "sheet.h"
#include "symbols.h"

/* A figure in the making; all borrowed. */
struct sheet {
    const struct study *s;
    struct figure *figure;
    double unit; /* of slip rates on axes: V_star in SI units, else 1 */
};

/* Roles of the scene's law and of Dieterich's. */
static const struct figure_style law_style[DIAGRAM_LAWS] = {
    [DIAGRAM_SCENE] = { FIGURE_SERIES_1, FIGURE_SOLID, 3.0 },
    [DIAGRAM_DIETERICH] = { FIGURE_SERIES_2, FIGURE_DASHED, 2.4 },
};

static const char *law_name(const struct sheet *p, int law)
{
    return law == DIAGRAM_SCENE ? p->s->slider.block.law.words
                                : law_preset_find("dieterich")->words;
}

static bool is_si(const struct sheet *p)
{
    return p->s->scene->units == UNITS_SI;
}

/* ---- axes and marks ------------------------------------------------------ */

/* A linear axis with a rim around a range, 0 .. 1 around an empty one. */
static struct figure_axis linear(const char *label, const double range[2])
{
    const bool any = range[0] < range[1];
    const double lo = any ? range[0] : 0.0, hi = any ? range[1] : 1.0;
    const double rim = 0.04 * (hi - lo);

    return (struct figure_axis){ label, lo - rim, hi + rim, false };
}

/* A log axis of slip rates v[0] .. v[1] in the scene's units, `what` they
 * are. */
static struct figure_axis rates(const struct sheet *p, const char *what,
                                const double v[2], char label[64])
{
    snprintf(label, 64, "%s %s", what, is_si(p) ? S_BIG_V " (m/s)" : S_V_RATIO);
    return (struct figure_axis){ label, v[0] * p->unit, v[1] * p->unit, true };
}

static void start(const struct sheet *p, const struct figure_axis *x,
                  const struct figure_axis *y)
{
    figure_init(p->figure, sheet_title(p->s->scene, false).text, x, y);
}

static void mark(const struct sheet *p, double x, double y,
                 enum figure_mark mark, const char *entry)
{
    figure_add_point(p->figure, x, y, FIGURE_EQUILIBRIUM, mark, 0.0, entry);
}

/* A disc for a maximum, a circle for a minimum. */
static enum figure_mark mark_of(const struct extremum *e)
{
    return e->kind == EXTREMUM_MAXIMUM ? FIGURE_DISC : FIGURE_CIRCLE;
}

/* "V_M = 2.493e-08 m/s" of a maximum, "v_m = 405.1" of a minimum in units of
 * V*. */
static void name_extremum(const struct sheet *p, const struct extremum *e,
                          char text[64])
{
    const char which = e->kind == EXTREMUM_MAXIMUM ? 'M' : 'm';
    char v[32];

    mark_number(v, sizeof v, e->v.value * p->unit, 4);
    snprintf(text, 64, ITALIC("%c") SUB(ITALIC("%c")) " = %s%s",
             is_si(p) ? 'V' : 'v', which, v, is_si(p) ? " m/s" : "");
}

/* ---- friction laws, Fig 1(a) --------------------------------------------- */

/* Those between v[0] and v[1]: at their friction, as what kind they are, or
 * where no friction is shown at 0. */
static void mark_extrema(const struct sheet *p, const struct extremum all[],
                         size_t count, const double v[2], bool friction)
{
    for (size_t i = 0; i < count; i++) {
        const struct extremum *e = &all[i];
        char name[64], entry[96];
        if (!(e->v.value >= v[0] && e->v.value <= v[1]))
            continue;
        name_extremum(p, e, name);
        snprintf(entry, sizeof entry, "%s: %s", extremum_names[e->kind], name);
        mark(p, e->v.value * p->unit, friction ? e->mu.value : 0.0, mark_of(e),
             friction ? entry : name);
    }
}

static void draw_friction_law(const struct sheet *p)
{
    const struct steady_curve *c = p->s->diagrams.friction_law;
    char label[64];
    const struct figure_axis x =
        rates(p, "slip rate", p->s->scene->window.v, label);
    struct line line[DIAGRAM_LAWS] = { LINE_EMPTY };
    double range[2] = RANGE_EMPTY;

    for (int i = 0; i < DIAGRAM_LAWS; i++) {
        for (size_t k = 0; k < c[i].count; k++)
            line_add(&line[i], c[i].at[k].v * p->unit, c[i].at[k].mu.value);
        range_grow(range, line[i].y, line[i].count);
    }
    const struct figure_axis y = linear("friction coefficient " S_MU_SS, range);
    start(p, &x, &y);
    for (int i = DIAGRAM_LAWS; i-- > 0;)
        figure_add_curve(p->figure, law_style[i], law_name(p, i), &line[i]);
    mark_extrema(p, c->extremum, c->extrema, p->s->scene->window.v, true);
}

/* ---- spring-block, Fig 1(b) ---------------------------------------------- */

/* k_c with inertia or without; zero at extrema, broken where there is none. */
static struct line spring_line(const struct sheet *p,
                               const struct spring_curve *c, bool inertia)
{
    struct line l = LINE_EMPTY;
    size_t next = 0;

    for (size_t i = 0; i < c->count; i++) {
        const struct spring_point *at = &c->at[i];
        while (next < c->extrema && c->extremum[next].v.value < c->at[0].v)
            next++;
        for (; next < c->extrema && c->extremum[next].v.value < at->v; next++)
            line_add(&l, c->extremum[next].v.value * p->unit, 0.0);
        line_add(&l, at->v * p->unit,
                 inertia ? at->k.value : at->k_quasistatic.value);
    }
    return l;
}

static void shade(const struct sheet *p, const char *entry, struct line *around)
{
    figure_add_line(p->figure,
                    &(struct figure_layer){ .kind = FIGURE_REGION,
                                            .style.role = FIGURE_SHADE_2,
                                            .entry = entry },
                    around);
}

/* The ground under the boundary: where the block sticks and slips. */
static void shade_stick_slip(const struct sheet *p, const struct line *l)
{
    struct line ground = LINE_EMPTY;

    for (size_t i = 0; i < l->count; i++)
        line_add(&ground, l->x[i], isfinite(l->y[i]) ? l->y[i] : 0.0);
    for (size_t i = l->count; i-- > 0;)
        line_add(&ground, l->x[i], 0.0);
    shade(p, "stick-slip", &ground);
}

enum { SPRING_LINES = 2 * DIAGRAM_LAWS }; /* each with inertia, and without */

static void add_springs(const struct sheet *p, struct line line[SPRING_LINES])
{
    static const enum figure_dash no_inertia[DIAGRAM_LAWS] = {
        [DIAGRAM_SCENE] = FIGURE_DOTTED, [DIAGRAM_DIETERICH] = FIGURE_DASH_DOT
    };

    shade_stick_slip(p, &line[0]);
    for (int i = SPRING_LINES; i-- > 0;) {
        struct figure_style style = law_style[i / 2];
        char entry[96];
        snprintf(entry, sizeof entry, "%s, %s", law_name(p, i / 2),
                 i % 2 ? "no inertia" : "with inertia");
        if (i % 2)
            style = (struct figure_style){ style.role, no_inertia[i / 2], 2.2 };
        figure_add_curve(p->figure, style, entry, &line[i]);
    }
}

static void draw_spring_block(const struct sheet *p)
{
    const struct spring_curve *c = p->s->diagrams.spring_block;
    char label[64];
    const struct figure_axis x =
        rates(p, "speed of pulling", p->s->scene->spring_block.v, label);
    struct line line[SPRING_LINES];
    double range[2] = { 0.0, 0.0 };

    for (int i = 0; i < SPRING_LINES; i++) {
        line[i] = spring_line(p, &c[i / 2], i % 2 == 0);
        if (i == 0 || i % 2) /* inertia takes the other far up */
            range_grow(range, line[i].y, line[i].count);
    }
    range[1] *= 1.1;
    const struct figure_axis y =
        linear("spring stiffness " ITALIC("k") " (Pa/m)", range);
    start(p, &x, &y);
    add_springs(p, line);
    mark_extrema(p, c->extremum, c->extrema, p->s->scene->spring_block.v,
                 false);
}

/* ---- bifurcation diagram, Fig 3 ------------------------------------------ */

/* From one extremum to the next, both included. */
static void add_branches(const struct sheet *p, const struct steady_curve *c)
{
    static const struct figure_style look[] = {
        { FIGURE_SERIES_1, FIGURE_SOLID, 3.0 },
        { FIGURE_SERIES_1, FIGURE_DASHED, 3.0 },
    };

    for (size_t from = 0; from + 1 < c->count;) {
        struct line l = LINE_EMPTY;
        size_t to = from + 1;
        const bool saddle = c->at[to].type == EQUILIBRIUM_SADDLE;
        for (size_t i = from; i < c->count; i++) {
            to = i;
            line_add(&l, c->at[i].alpha.value, c->at[i].v * p->unit);
            if (i > from && c->at[i].type == EQUILIBRIUM_SADDLE_NODE)
                break;
        }
        figure_add_curve(p->figure, look[saddle],
                         saddle ? "unstable (saddle)" : "stable (node)", &l);
        from = to;
    }
}

/* The maximum with the minimum that follows it: three steady states between
 * their slopes. */
static void shade_bistable(const struct sheet *p, const struct steady_curve *c)
{
    const double *v = p->s->scene->window.v;

    for (size_t i = 0; i + 1 < c->extrema; i++) {
        const struct extremum *top = &c->extremum[i], *low = top + 1;
        struct line around = LINE_EMPTY;
        if (top->kind != EXTREMUM_MAXIMUM || !quantity_exists(&low->alpha))
            continue;
        line_add(&around, low->alpha.value, v[0] * p->unit);
        line_add(&around, top->alpha.value, v[0] * p->unit);
        line_add(&around, top->alpha.value, v[1] * p->unit);
        line_add(&around, low->alpha.value, v[1] * p->unit);
        shade(p, "three steady states", &around);
    }
}

static void mark_folds(const struct sheet *p, const struct steady_curve *c)
{
    for (size_t i = 0; i < c->extrema; i++) {
        const struct extremum *e = &c->extremum[i];
        char entry[64];
        if (!quantity_exists(&e->alpha))
            continue;
        snprintf(entry, sizeof entry, "fold: " S_CM("%c") " = %.6g rad",
                 e->kind == EXTREMUM_MAXIMUM ? 'M' : 'm', e->alpha.value);
        mark(p, e->alpha.value, e->v.value * p->unit, mark_of(e), entry);
    }
}

static void draw_bifurcation(const struct sheet *p)
{
    const struct steady_curve *c = &p->s->diagrams.bifurcation;
    char label[64];
    const struct figure_axis y =
        rates(p, "slip rate", p->s->scene->window.v, label);
    double range[2] = RANGE_EMPTY;

    for (size_t i = 0; i < c->count; i++)
        range_grow(range, &c->at[i].alpha.value, 1);
    const struct figure_axis x = linear("slope angle " S_ALPHA " (rad)", range);
    start(p, &x, &y);
    shade_bistable(p, c);
    add_branches(p, c);
    mark_folds(p, c);
}

/* ---- fold curves, Fig 4 -------------------------------------------------- */

/* One of the two, as far as it exists, and to the cusp. */
static struct line fold_line(const struct fold_curve *f, bool maximum)
{
    const struct cusp_numbers *cusp = &f->cusp;
    struct line l = LINE_EMPTY;

    for (size_t i = 0; i < f->count; i++) {
        const struct fold_point *at = &f->at[i];
        const struct quantity *alpha = maximum ? &at->alpha_cM : &at->alpha_cm;
        if (quantity_exists(alpha))
            line_add(&l, alpha->value, at->c);
    }
    if (l.count > 0 && quantity_exists(&cusp->alpha))
        line_add(&l, cusp->alpha.value, cusp->c.value);
    return l;
}

/* Up along one fold curve and down along the other. */
static void shade_metastable(const struct sheet *p, const struct line line[2])
{
    struct line around = LINE_EMPTY;

    if (line[0].count < 2 || line[1].count < 2)
        return;
    for (size_t i = 0; i < line[0].count; i++)
        line_add(&around, line[0].x[i], line[0].y[i]);
    for (size_t i = line[1].count; i-- > 0;)
        line_add(&around, line[1].x[i], line[1].y[i]);
    shade(p, "metastable domain", &around);
}

static void mark_cusp(const struct sheet *p, const struct cusp_numbers *cusp)
{
    char entry[96];

    if (!quantity_exists(&cusp->alpha))
        return;
    snprintf(entry, sizeof entry,
             "cusp: " S_ALPHA " = %.5g rad, " ITALIC("c") " = %.5g",
             cusp->alpha.value, cusp->c.value);
    mark(p, cusp->alpha.value, cusp->c.value, FIGURE_DISC, entry);
}

static void draw_fold_curves(const struct sheet *p)
{
    static const struct figure_style look[] = {
        { FIGURE_SERIES_1, FIGURE_SOLID, 3.0 },
        { FIGURE_SERIES_2, FIGURE_DASHED, 3.0 },
    };
    static const char *const entry[] = { S_CM("m") ", minimum of " S_MU_SS,
                                         S_CM("M") ", maximum of " S_MU_SS };
    const struct fold_curve *f = &p->s->diagrams.fold_curves;
    const double *c = p->s->scene->fold_c;
    const struct figure_axis y = { "residual strength " ITALIC("c"), c[0], c[1],
                                   true };
    struct line line[2];
    double range[2] = RANGE_EMPTY;

    for (int i = 0; i < 2; i++) {
        line[i] = fold_line(f, i == 1);
        range_grow(range, line[i].x, line[i].count);
    }
    const struct figure_axis x = linear("slope angle " S_ALPHA " (rad)", range);
    start(p, &x, &y);
    shade_metastable(p, line);
    for (int i = 0; i < 2; i++)
        figure_add_curve(p->figure, look[i], entry[i], &line[i]);
    mark_cusp(p, &f->cusp);
}

/* ---- chi(v), Fig 10 -------------------------------------------------------
 */

/* Highest chi shown: well above 1, where all that matters happens. */
static const double chi_top = 1e4;

/* The look of the curve of a slope: hue and dash, thinner after six. */
static struct figure_style look_of_slope(size_t slope)
{
    const size_t roles = FIGURE_SERIES_6 - FIGURE_SERIES_1 + 1;

    return (struct figure_style){
        .role = (enum figure_role)(FIGURE_SERIES_1 + slope % roles),
        .width = slope < roles ? 2.6 : 1.3,
    };
}

static void add_chi(const struct sheet *p, const struct chi_curves *c,
                    size_t slope)
{
    const double *ln_chi = c->ln_chi + slope * c->points;
    struct line l = LINE_EMPTY;
    char entry[64];

    snprintf(entry, sizeof entry, S_ALPHA " = %.6g rad", c->slope[slope].alpha);
    for (size_t i = 0; i < c->points; i++)
        line_add(&l, c->v[i] * p->unit, exp(ln_chi[i]));
    figure_add_curve(p->figure, look_of_slope(slope), entry, &l);
}

static void mark_chi_roots(const struct sheet *p, const struct chi_slope *s)
{
    const struct quantity *root[] = { &s->v_low, &s->v_high };

    for (int i = 0; i < 2; i++)
        if (quantity_exists(root[i]))
            mark(p, root[i]->value * p->unit, 1.0, FIGURE_CIRCLE,
                 ITALIC("χ") "(" S_V ") = 1");
}

static void draw_chi(const struct sheet *p)
{
    const struct chi_curves *c = &p->s->diagrams.chi;
    const double *v = p->s->scene->window.v;
    double range[2] = { 0.0, 0.0 }; /* of ln chi */
    char label[64];

    range_grow(range, c->ln_chi, c->slopes * c->points);
    const struct figure_axis x = rates(p, "slip rate", v, label);
    const struct figure_axis y = { "slope of the flow " ITALIC("χ") "(" S_V ")",
                                   0.3 * exp(fmax(range[0], -100.0)), chi_top,
                                   true };
    start(p, &x, &y);
    sheet_segment(p->figure,
                  (struct figure_style){ FIGURE_FIELD, FIGURE_SOLID, 1.2 },
                  NULL, (struct vec2){ x.lo, 1.0 }, (struct vec2){ x.hi, 1.0 });
    for (size_t i = 0; i < c->slopes; i++)
        add_chi(p, c, i);
    for (size_t i = 0; i < c->slopes; i++)
        mark_chi_roots(p, &c->slope[i]);
}

/* ---- which one ----------------------------------------------------------- */

static const struct {
    enum stage stage;
    void (*draw)(const struct sheet *p);
} diagram[] = {
    { STAGE_FRICTION_LAW, draw_friction_law },
    { STAGE_SPRING_BLOCK, draw_spring_block },
    { STAGE_BIFURCATION, draw_bifurcation },
    { STAGE_FOLD_CURVES, draw_fold_curves },
    { STAGE_CHI, draw_chi },
};
enum { DIAGRAM_KINDS = sizeof diagram / sizeof *diagram };

static int first_of(const struct study *s)
{
    int i = 0;

    while (i < DIAGRAM_KINDS && !plan_has(s->stages, diagram[i].stage))
        i++;
    return i;
}

bool picture_has_diagram(const struct study *s)
{
    return first_of(s) < DIAGRAM_KINDS;
}

void picture_diagram(const struct study *s, struct figure *f)
{
    const bool si = s->scene->units == UNITS_SI;
    const struct sheet p = { s, f, si ? s->scene->material.V_star : 1.0 };

    diagram[first_of(s)].draw(&p);
}
