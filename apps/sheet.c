#include "sheet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static bool is_si(const struct sheet *p)
{
    return p->s->scene->units == UNITS_SI;
}

enum status line_init(struct line *l, size_t room)
{
    *l = (struct line){ calloc(room + 1, sizeof *l->x),
                        calloc(room + 1, sizeof *l->y), 0 };
    return l->x && l->y ? STATUS_OK : STATUS_NO_MEMORY;
}

void line_add(struct line *l, double x, double y)
{
    l->x[l->count] = x;
    l->y[l->count++] = y;
}

void line_free(struct line *l)
{
    free(l->x);
    free(l->y);
    *l = (struct line){ .x = NULL };
}

void sheet_span(double range[2], const double *value, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (isfinite(value[i])) {
            range[0] = fmin(range[0], value[i]);
            range[1] = fmax(range[1], value[i]);
        }
}

struct figure_axis sheet_linear(const char *label, const double range[2])
{
    const bool any = range[0] < range[1];
    const double lo = any ? range[0] : 0.0, hi = any ? range[1] : 1.0;
    const double rim = 0.04 * (hi - lo);

    return (struct figure_axis){ label, lo - rim, hi + rim, false };
}

struct figure_axis sheet_rates(const struct sheet *p, const char *what,
                               const double v[2], char label[64])
{
    snprintf(label, 64, "%s %s", what, is_si(p) ? "V (m/s)" : "v = V/V*");
    return (struct figure_axis){ label, v[0] * p->unit, v[1] * p->unit, true };
}

enum status sheet_start(const struct sheet *p, const struct figure_axis *x,
                        const struct figure_axis *y)
{
    const struct study *s = p->s;
    char title[512];

    snprintf(title, sizeof title, "%s%s%s", s->scene->title,
             s->scene->title[0] ? " — " : "", s->slider.block.law.preset);
    return figure_init(p->figure, title, x, y);
}

enum status sheet_line(const struct sheet *p, const struct line *l,
                       struct figure_style style, const char *entry)
{
    const struct figure_curve c = {
        .style = style, .entry = entry, .x = l->x, .y = l->y, .count = l->count
    };

    return l->count > 1 ? figure_add_curve(p->figure, &c) : STATUS_OK;
}

enum status sheet_mark(const struct sheet *p, double x, double y,
                       enum figure_mark mark, const char *entry)
{
    const struct figure_points at = { .style = { .role = FIGURE_EQUILIBRIUM },
                                      .entry = entry,
                                      .x = &x,
                                      .y = &y,
                                      .count = 1,
                                      .mark = mark };

    return figure_add_points(p->figure, &at);
}

enum figure_mark sheet_mark_of(const struct extremum *e)
{
    return e->kind == EXTREMUM_MAXIMUM ? FIGURE_DISC : FIGURE_CIRCLE;
}

void sheet_name(const struct sheet *p, const struct extremum *e, char text[64])
{
    const char which = e->kind == EXTREMUM_MAXIMUM ? 'M' : 'm';
    const double v = e->v.value * p->unit;

    if (is_si(p))
        snprintf(text, 64, "V_%c = %.3e m/s", which, v);
    else
        snprintf(text, 64, "v_%c = %.4g", which, v);
}
