#include "sweep_sheet.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "mark.h"
#include "sweep_told.h"
#include "symbols.h"

double sweep_place(const struct sweep_axis *a, double x)
{
    return a->is_log ? log(x) : x;
}

struct figure_axis sweep_around(const char *label, double lo, double hi,
                                bool is_log, double rim)
{
    if (!(lo < hi))
        rim = is_log || lo == 0.0 ? 1.0 : 0.1 * fabs(lo);
    if (is_log)
        return (struct figure_axis){ label, lo * exp(-rim), hi * exp(rim),
                                     true };
    return (struct figure_axis){ label, lo - rim, hi + rim, false };
}

bool sweep_is_si(const struct sweep *s)
{
    return s->scene->units == UNITS_SI && s->scene->system == NULL;
}

/* Words, letter and unit of the keys that have a letter. */
static const struct {
    const char *path, *label[2]; /* in the SI, where it is another there */
} labels[] = {
    { "slope.alpha", { "slope angle " S_ALPHA " (rad)" } },
    { "slope.alpha_deg", { "slope angle " S_ALPHA " (°)" } },
    { "slope.tan_alpha", { "slope " S_TAN } },
    { "material.mu_star", { "friction coefficient " S_MU SUB("∗") } },
    { "material.a", { "direct effect " ITALIC("a") } },
    { "material.b", { "evolution effect " ITALIC("b") } },
    { "material.L", { "memory length " S_L " (m)" } },
    { "material.V_star", { "reference slip rate " S_V_STAR " (m/s)" } },
    { "material.c", { "residual strength " ITALIC("c") } },
    { "material.R", { "longest relaxation time " ITALIC("R") } },
    { "material.V_c",
      { "cut-off slip rate " S_BIG_V SUB("c") "/" S_V_STAR,
        "cut-off slip rate " S_BIG_V SUB("c") " (m/s)" } },
    { "gravity", { "gravity " ITALIC("g") " (m/s" SUPER("2") ")" } },
};

struct sheet_label sweep_label(const struct sweep *s, size_t k)
{
    const struct sweep_axis *a = &s->axis[k];
    const char *unit = sweep_told_unit(s, a->key.unit);
    const bool plain = unit[0] == '1';
    struct sheet_label l;

    snprintf(l.text, sizeof l.text, "%s%s%s%s", a->key.text, plain ? "" : " (",
             plain ? "" : unit, plain ? "" : ")");
    if (s->scene->system)
        mark_name(l.text, sizeof l.text, a->name);
    for (size_t i = 0; i < sizeof labels / sizeof *labels; i++)
        if (strcmp(a->key.path, labels[i].path) == 0)
            snprintf(l.text, sizeof l.text, "%s",
                     labels[i].label[sweep_is_si(s) && labels[i].label[1]]);
    return l;
}

void sweep_letters(const struct sweep *s, char *text)
{
    while (sweep_is_si(s) && (text = strstr(text, S_V)) != NULL)
        memcpy(text, S_BIG_V, strlen(S_BIG_V));
}

struct sheet_text sweep_title(const struct sweep *s)
{
    struct sheet_text title;
    bool slope = true;

    for (size_t i = 0; i < s->axes; i++)
        slope &= s->axis[i].key.path[0] != 's';
    if (s->scene->system == NULL)
        return sheet_title(s->scene, slope);
    snprintf(title.text, sizeof title.text, "%s", s->scene->title);
    return title;
}
