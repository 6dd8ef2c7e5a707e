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

static enum status add_curve(const struct sheet *p, const struct chi_curves *c,
                             size_t slope)
{
    const double *ln_chi = c->ln_chi + slope * c->points;
    char entry[64];
    struct line l;
    enum status status = line_init(&l, c->points);

    snprintf(entry, sizeof entry, "α = %.6g rad", c->slope[slope].alpha);
    for (size_t i = 0; i < c->points && !status; i++)
        line_add(&l, c->v[i] * p->unit, exp(ln_chi[i]));
    if (!status)
        status = sheet_line(p, &l, look_of(slope), entry);
    line_free(&l);
    return status;
}

static enum status add_one(const struct sheet *p, const double v[2])
{
    const double x[] = { v[0] * p->unit, v[1] * p->unit }, y[] = { 1.0, 1.0 };

    return figure_add_curve(
        p->figure,
        &(struct figure_curve){ .style = { FIGURE_FIELD, FIGURE_SOLID, 1.2 },
                                .x = x,
                                .y = y,
                                .count = 2 });
}

static enum status mark_roots(const struct sheet *p, const struct chi_slope *s)
{
    const struct quantity *root[] = { &s->v_low, &s->v_high };
    enum status status = STATUS_OK;

    for (int i = 0; i < 2 && !status; i++)
        if (quantity_exists(root[i]))
            status = sheet_mark(p, root[i]->value * p->unit, 1.0, FIGURE_CIRCLE,
                                "χ(v) = 1");
    return status;
}

enum status picture_chi(const struct sheet *p)
{
    const struct chi_curves *c = &p->s->diagrams.chi;
    const double *v = p->s->scene->window.v;
    double range[2] = { 0.0, 0.0 }; /* of ln chi */
    char label[64];

    sheet_span(range, c->ln_chi, c->slopes * c->points);
    const struct figure_axis x = sheet_rates(p, "slip rate", v, label);
    const struct figure_axis y = { "χ(v)", 0.3 * exp(fmax(range[0], -100.0)),
                                   top, true };
    enum status status = sheet_start(p, &x, &y);
    if (!status)
        status = add_one(p, v);
    for (size_t i = 0; i < c->slopes && !status; i++)
        status = add_curve(p, c, i);
    for (size_t i = 0; i < c->slopes && !status; i++)
        status = mark_roots(p, &c->slope[i]);
    return status;
}
