#include "sheet.h"

#include <stdio.h>
#include <string.h>

#include "symbols.h"

static bool is_si(const struct sheet *p)
{
    return p->s->scene->units == UNITS_SI;
}

struct sheet_label sheet_label(const struct unit_system *u, const char *what,
                               const char *unit)
{
    static const struct {
        const char *unit, *own, *si;
    } letters[] = { { "V_star", " " S_V_RATIO, " " S_BIG_V },
                    { "L", " " S_SLIP, " " S_X },
                    { "L/V_star", " " S_TIME, " " S_T },
                    { "psi", " " S_PSI, " " S_PHI } };
    const char *name = unit_name(u, unit), *letter = "";
    const bool told = u->si && strcmp(name, "1") != 0;
    struct sheet_label l;

    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
        if (strcmp(letters[i].unit, unit) == 0)
            letter = u->si ? letters[i].si : letters[i].own;
    snprintf(l.text, sizeof l.text, "%s%s%s%s%s", what, letter,
             told ? " (" : "", told ? name : "", told ? ")" : "");
    return l;
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
    snprintf(label, 64, "%s %s", what, is_si(p) ? S_BIG_V " (m/s)" : S_V_RATIO);
    return (struct figure_axis){ label, v[0] * p->unit, v[1] * p->unit, true };
}

struct sheet_text sheet_title(const struct scene *c, bool slope)
{
    static const char *const form[] = { [ANGLE_RAD] = ", α = %.6g rad",
                                        [ANGLE_DEGREE] = ", α = %.6g°",
                                        [ANGLE_TAN] = ", tan α = %.6g" };
    struct sheet_text t;
    char alpha[64] = "";

    if (slope)
        snprintf(alpha, sizeof alpha, form[c->slope_in], c->slope_given);
    snprintf(t.text, sizeof t.text, "%s%s",
             c->title[0] ? c->title : c->law.words, alpha);
    return t;
}

void sheet_start(const struct sheet *p, const struct figure_axis *x,
                 const struct figure_axis *y)
{
    figure_init(p->figure, sheet_title(p->s->scene, false).text, x, y);
}

void sheet_mark(const struct sheet *p, double x, double y,
                enum figure_mark mark, const char *entry)
{
    figure_add_point(p->figure, x, y, FIGURE_EQUILIBRIUM, mark, 0.0, entry);
}

enum figure_mark sheet_mark_of(const struct extremum *e)
{
    return e->kind == EXTREMUM_MAXIMUM ? FIGURE_DISC : FIGURE_CIRCLE;
}

void sheet_name(const struct sheet *p, const struct extremum *e, char text[64])
{
    const char which = e->kind == EXTREMUM_MAXIMUM ? 'M' : 'm';
    char v[32];

    mark_number(v, sizeof v, e->v.value * p->unit, 4);
    snprintf(text, 64, ITALIC("%c") SUB(ITALIC("%c")) " = %s%s",
             is_si(p) ? 'V' : 'v', which, v, is_si(p) ? " m/s" : "");
}

void sheet_segment(struct figure *f, struct figure_style style,
                   const char *entry, struct vec2 a, struct vec2 b)
{
    figure_add(f, &(struct figure_layer){ .style = style,
                                          .entry = entry,
                                          .x = (double[]){ a.x, b.x },
                                          .y = (double[]){ a.y, b.y },
                                          .count = 2 });
}
