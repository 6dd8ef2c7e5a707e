#include "sheet.h"

#include <stdio.h>
#include <string.h>

#include "symbols.h"

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

void sheet_segment(struct figure *f, struct figure_style style,
                   const char *entry, struct vec2 a, struct vec2 b)
{
    figure_add(f, &(struct figure_layer){ .style = style,
                                          .entry = entry,
                                          .x = (double[]){ a.x, b.x },
                                          .y = (double[]){ a.y, b.y },
                                          .count = 2 });
}
