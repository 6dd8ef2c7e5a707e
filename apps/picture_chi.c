#include "picture_chi.h"

#include <math.h>
#include <stdio.h>

/* Highest chi shown: well above 1, where all that matters happens. */
static const double top = 1e4;

/* The look of the curve of a slope; dashed after six, dotted after twelve. */
static struct figure_style look_of(size_t slope)
{
    static const enum figure_dash dash[] = { FIGURE_SOLID, FIGURE_DASHED,
                                             FIGURE_DOTTED };
    const size_t roles = FIGURE_SERIES_6 - FIGURE_SERIES_1 + 1;

    return (struct figure_style){
        .role = (enum figure_role)(FIGURE_SERIES_1 + slope % roles),
        .dash = dash[slope / roles % 3],
        .width = 2.6,
    };
}

static void add_curve(const struct sheet *p, const struct chi_curves *c,
                      size_t slope)
{
    const double *ln_chi = c->ln_chi + slope * c->points;
    struct line l = LINE_EMPTY;
    char entry[64];

    snprintf(entry, sizeof entry, "α = %.6g rad", c->slope[slope].alpha);
    for (size_t i = 0; i < c->points; i++)
        line_add(&l, c->v[i] * p->unit, exp(ln_chi[i]));
    sheet_line(p, &l, look_of(slope), entry);
}

static void mark_roots(const struct sheet *p, const struct chi_slope *s)
{
    const struct quantity *root[] = { &s->v_low, &s->v_high };

    for (int i = 0; i < 2; i++)
        if (quantity_exists(root[i]))
            sheet_mark(p, root[i]->value * p->unit, 1.0, FIGURE_CIRCLE,
                       "χ(v) = 1");
}

void picture_chi(const struct sheet *p)
{
    const struct chi_curves *c = &p->s->diagrams.chi;
    const double *v = p->s->scene->window.v;
    double range[2] = { 0.0, 0.0 }; /* of ln chi */
    char label[64];

    range_grow(range, c->ln_chi, c->slopes * c->points);
    const struct figure_axis x = sheet_rates(p, "slip rate", v, label);
    const struct figure_axis y = { "χ(v)", 0.3 * exp(fmax(range[0], -100.0)),
                                   top, true };
    sheet_start(p, &x, &y);
    sheet_segment(p->figure,
                  (struct figure_style){ FIGURE_FIELD, FIGURE_SOLID, 1.2 },
                  NULL, (struct vec2){ x.lo, 1.0 }, (struct vec2){ x.hi, 1.0 });
    for (size_t i = 0; i < c->slopes; i++)
        add_curve(p, c, i);
    for (size_t i = 0; i < c->slopes; i++)
        mark_roots(p, &c->slope[i]);
}
