#include "state.h"

#include <string.h>

#include "number.h"
#include "physical.h"
#include "result_units.h"
#include "scene_units.h"
#include "text.h"
#include "unit_text.h"

static const char *name_of(const struct options *o, const char *text)
{
    return text == o->v ? "--v" : text == o->psi ? "--psi" : "--phi";
}

enum status state_read(const struct options *o, const struct scene *s,
                       struct scene_start *out, struct fault *why)
{
    const struct scene_state text = { o->v, o->psi, o->phi };
    const char *wrong, *command = o->command->name;
    char expected[128];

    if (o->v == NULL || (o->psi == NULL && o->phi == NULL))
        return fault_set(why, STATUS_BAD_ARGUMENT,
                         "%s: no state, expected %s%s", command,
                         o->v ? "--psi or --phi" : "--v",
                         o->v ? " beside --v" : " and --psi");
    if (scene_state_read(s, &text, out, &wrong, expected))
        return STATUS_OK;
    return fault_set(why, STATUS_BAD_ARGUMENT, "%s: %s %s: %s", command,
                     name_of(o, wrong), text_shown(wrong).text, expected);
}

void state_setting(const struct options *o, const char *key, char *text,
                   size_t size)
{
    const struct unit *rate = unit_find("V_star");
    enum unit_text in = UNIT_TEXT_BARE;
    double v = 0.0, state = 0.0;

    (void) unit_text_read(rate, o->v, &v, &in);
    (void) number_read(o->psi ? o->psi : o->phi, &state);
    snprintf(text, size, "%s=[{v: %s%s, %s: %s}]", key, number_shortest(v).text,
             unit_text_name(rate, in).text, o->psi ? "psi" : "phi",
             number_shortest(state).text);
}

void state_print(FILE *out, const struct scene *s, double v, double psi)
{
    const struct unit_system u = physical_units(&s->law, &s->material, true);
    const struct unit *rate = unit_find("V_star"), *state = unit_find("psi");
    const bool has_unit = strcmp(u.phi, "1") != 0;

    if (s->units == UNITS_SI)
        fprintf(out,
                "v = %.15g m/s = %.15g V_star, phi = %.15g%s%s, psi = %.15g",
                result_input(&u, rate, v), v, result_input(&u, state, psi),
                has_unit ? " " : "", has_unit ? u.phi : "", psi);
    else
        fprintf(out, "v = %.15g V_star = %.15g m/s, psi = %.15g", v,
                result_input(&u, rate, v), psi);
}
