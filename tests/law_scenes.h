/* law_scenes.h -- scenes of a preset: by name, and as formulas. */
#pragma once

#include <stdlib.h>

#include "law_typed.h"
#include "scenes.h"

/* The preset as formulas, with a slope. */
static inline struct scene as_formulas(const struct law *law, const char *rest)
{
    struct law_typed *typed = calloc(1, sizeof *typed);
    char text[4000] = "law:\n";
    int used = 5;

    law_typed_of_preset(law, typed);
    for (int i = 0; i < LAW_PARTS; i++)
        if (typed->text[i][0])
            used +=
                snprintf(text + used, sizeof text - (size_t) used,
                         "  %s: \"%s\"\n", law_part_names[i], typed->text[i]);
    snprintf(text + used, sizeof text - (size_t) used,
             "  state: %s\n  friction: %s\n%s",
             typed->real ? "real" : "positive", friction_form_names[law->form],
             rest);
    free(typed);
    return scene_made(text, "");
}

/* The same by dpsi/dt alone. */
static inline struct scene as_rate(const struct law *law, const char *rest)
{
    struct law_typed *typed = calloc(1, sizeof *typed);
    char text[4000];

    law_typed_of_preset(law, typed);
    int used = snprintf(text, sizeof text, "law:\n  theta: \"%s\"\n  rate: \"",
                        typed->text[LAW_THETA]);
    if (typed->text[LAW_RATE][0])
        used += sprintf(text + used, "%s", typed->text[LAW_RATE]);
    else
        used += sprintf(text + used, "-%s(psi - (%s))/(%s)",
                        typed->text[LAW_K][0] == 's' ? "sinh" : "",
                        typed->text[LAW_PSI_SS], typed->text[LAW_T]);
    sprintf(text + used, "\"\n  state: %s\n  friction: %s\n%s",
            typed->real ? "real" : "positive", friction_form_names[law->form],
            rest);
    free(typed);
    return scene_made(text, "");
}

static inline struct scene by_name(const struct law *law, const char *rest)
{
    char text[1000];

    sprintf(text, "law: {preset: %s, friction: %s}\n%s", law->preset,
            friction_form_names[law->form], rest);
    return scene_made(text, "");
}
