/* slipway laws: the presets, their formulas and parameters. */
#include "command.h"
#include "json.h"
#include "law_typed.h"

static json_t *law_json(const struct law *law)
{
    char formula[256];
    json_t *uses = json_array();

    law_formula(law, formula, sizeof formula);
    for (int key = 0; key < MATERIAL_KEYS; key++)
        if (law_uses(law, (enum material_key) key))
            json_array_append_new(
                uses, json_string(material_key_name((enum material_key) key)));
    return json_pack("{s:s, s:s, s:s, s:o}", "name", law->preset, "equation",
                     law->equation, "formula", formula, "parameters", uses);
}

static void print_law(const struct law *law)
{
    char formula[256];

    law_formula(law, formula, sizeof formula);
    printf("%-16s %-22s %s\n", law->preset, law->equation, formula);
}

/* The scene that says the same in formulas; a slope is to be added. */
static enum exit_code print_scene(const char *name)
{
    static struct law_typed typed;
    const struct law *law = law_preset_find(name);
    struct fault why;

    if (law == NULL) {
        snprintf(why.text, sizeof why.text,
                 "laws: no law %.60s, expected one that 'slipway laws' lists",
                 name);
        return command_fail(STATUS_BAD_SCENE, why.text);
    }
    law_typed_of_preset(law, &typed);
    printf("title: %s as formulas\nlaw:\n", law->preset);
    for (int i = 0; i < LAW_PARTS; i++)
        if (typed.text[i][0])
            printf("  %s: \"%s\"\n", law_part_names[i], typed.text[i]);
    printf("  state: %s\n", typed.real ? "real" : "positive");
    if (law_uses(law, MATERIAL_V_C))
        printf("material: {V_c: 1}\n");
    return EXIT_DONE;
}

enum exit_code command_laws(const struct options *o)
{
    json_t *list;
    const struct law *law;

    if (o->as && o->files)
        return print_scene(o->file[0]);
    if (o->as || o->files) {
        struct fault why;
        const enum status s = command_refuse(
            &why,
            "laws: %s: a NAME needs --as scene, and that a NAME, see 'slipway "
            "help laws'",
            o->files ? o->file[0] : "--as");
        return command_fail(s, why.text);
    }
    list = o->json ? json_array() : NULL;
    for (size_t i = 0; (law = law_preset_at(i)) != NULL; i++) {
        if (o->json)
            json_array_append_new(list, law_json(law));
        else
            print_law(law);
    }
    if (o->json)
        return json_print(list) ? EXIT_DONE : command_unwritten();
    printf("\nmu = a asinh((v/2) exp((mu_star + b theta)/a))   --friction "
           "asinh (default), (4a)\n"
           "mu = mu_star + a ln v + b theta                  --friction log, "
           "(2)\n");
    return EXIT_DONE;
}
