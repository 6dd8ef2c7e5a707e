#include "report.h"

#include "json_results.h"
#include "number.h"
#include "report_ensemble.h"
#include "result_units.h"
#include "scene_slope.h"
#include "scene_units.h"
#include "study_results.h"
#include "text_results.h"

/* ---- text ------------------------------------------------------------- */

static const char *const slope_form[] = {
    [ANGLE_RAD] = ", alpha = %s rad",
    [ANGLE_DEGREE] = ", alpha = %s degree",
    [ANGLE_TAN] = ", tan_alpha = %s",
};

enum status report_print(FILE *out, const struct study *s)
{
    struct results all = study_results(s);

    all.units = scene_units(s->scene);
    all.units.angle = s->scene->slope_in;
    fprintf(out, "%s (%s form)", s->slider.block.law.preset,
            friction_form_names[s->slider.block.law.form]);
    if (scene_has_slope(s->scene))
        fprintf(out, slope_form[s->scene->slope_in],
                number_shortest(s->scene->slope_given).text);
    fputc('\n', out);
    return text_results(out, &all);
}

/* ---- JSON ------------------------------------------------------------- */

static const char *const parameter_unit[MATERIAL_KEYS] = {
    [MATERIAL_V_C] = "V_star",
    [MATERIAL_L] = "m",
    [MATERIAL_V_STAR] = "m/s",
    [MATERIAL_G] = "m/s^2",
};

/* Those that the law uses; their units are added to the other list. */
static json_t *parameters_json(const struct study *s, json_t *units)
{
    const struct law *law = &s->slider.block.law;
    const struct unit_system u = scene_units(s->scene);
    struct material m = s->slider.block.material;
    json_t *j = json_object();

    for (int k = 0; k < MATERIAL_KEYS; k++) {
        const enum material_key key = (enum material_key) k;
        const char *name = material_key_name(key), *unit = parameter_unit[k];
        if (!law_uses(law, key))
            continue;
        json_object_set_new(
            j, name,
            json_number(
                result_input(&u, unit_find(unit), *material_member(&m, key))));
        if (unit)
            json_object_set_new(units, name, json_string(unit_name(&u, unit)));
    }
    json_object_set_new(j, "eps2", json_number(material_eps2(&m)));
    json_object_set_new(j, "eta", json_number(law_eta(law, &m)));
    return j;
}

json_t *report_json(const struct study *s, const struct ensemble *drawn)
{
    struct results all = study_results(s);
    const struct stage_cost total = study_cost(s);
    const struct law *law = &s->slider.block.law;
    json_t *units = json_object();
    json_t *j = json_pack(
        "{s:s, s:s, s:o, s:o}", "law", law->preset, "form",
        friction_form_names[law->form], "alpha",
        scene_has_slope(s->scene) ? json_number(s->scene->alpha) : json_null(),
        "parameters", parameters_json(s, units));

    all.units = scene_units(s->scene);
    json_object_set_new(
        j, "units",
        json_pack("{s:s, s:o}", "alpha", "rad", "parameters", units));
    j = json_results(j, &all);
    if (drawn)
        json_object_set_new(j, "ensemble", report_ensemble_json(drawn));
    json_object_set_new(j, "cost",
                        json_pack("{s:I, s:o}", "field_evaluations",
                                  (json_int_t) total.field_evaluations,
                                  "seconds", json_number(total.seconds)));
    return j;
}
