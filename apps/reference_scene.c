#include "reference.h"

#include <string.h>

#include "law.h"
#include "plan.h"
#include "schema.h"
#include "texts.h"
#include "value.h"

/* ---- keys ---------------------------------------------------------------- */

/* What stands before the range of one number. */
static const char *shape(const struct schema_key *k)
{
    return k->read == value_pair ? "[lo, hi], lo < hi, each " : "";
}

static void put_value(FILE *out, const struct schema_key *k)
{
    if (k->read == value_products) {
        fputs("a list of products, see below", out);
    } else if (k->read == value_preset) {
        fputs("a law, see below", out);
    } else if (k->words) {
        fputs("one of ", out);
        markdown_words(out, k->words);
    } else {
        fputs(shape(k), out);
        markdown_text(out, k->expected);
    }
}

/* The keys that cannot stand beside this one. */
static void put_excluded(FILE *out, const struct schema_key *k)
{
    const char *gap = "; not beside ";

    for (const struct schema_key *o = schema_table; o->path; o++) {
        const char *dot = strchr(k->path, '.');
        const size_t section = dot ? (size_t) (dot - k->path) : 0;
        if (strncmp(k->path, o->path, section + 1) != 0 ||
            !schema_excludes(k->path, o->path))
            continue;
        fprintf(out, "%s`%s`", gap, o->path);
        gap = ", ";
    }
}

static void put_key(FILE *out, const struct schema_key *k)
{
    fprintf(out, "| `%s` | ", k->path);
    put_value(out, k);
    fprintf(out, " | %s | %s%s%s | ", k->unit ? k->unit : "",
            k->standard ? "`" : "", k->standard ? k->standard : "",
            k->standard ? "`" : "");
    markdown_text(out, k->text);
    put_excluded(out, k);
    fputs(" |\n", out);
}

static void put_keys(FILE *out)
{
    fputs("\n## Keys\n"
          "\n"
          "| key | value | unit | default | meaning |\n"
          "|---|---|---|---|---|\n",
          out);
    for (const struct schema_key *k = schema_table; k->path; k++)
        put_key(out, k);
    fputs("\n`sweep` may be a list of two such maps, `sweep: [{key: ...}, "
          "{key: ...}]`: a grid.\n",
          out);
}

/* ---- laws ---------------------------------------------------------------- */

static void put_law(FILE *out, const struct law *law)
{
    char formula[256];
    const char *gap = "";

    law_formula(law, formula, sizeof formula);
    fprintf(out, "| `%s` | %s | ", law->preset, law->equation);
    markdown_text(out, formula);
    fputs(" | ", out);
    for (int key = 0; key < MATERIAL_KEYS; key++)
        if (law_uses(law, (enum material_key) key) && key < MATERIAL_G) {
            fprintf(out, "%s`%s`", gap,
                    material_key_name((enum material_key) key));
            gap = " ";
        }
    fputs(" |\n", out);
}

static void put_laws(FILE *out)
{
    const struct law *law;

    fputs("\n## Laws\n"
          "\n"
          "| `law.preset` | equation | formula | uses |\n"
          "|---|---|---|---|\n",
          out);
    for (size_t i = 0; (law = law_preset_at(i)) != NULL; i++)
        put_law(out, law);
    fputs("\nAny other combination of `law.theta`, `law.psi_ss`, "
          "`law.timescale` and `law.kinetics`,\nall four given, is a law "
          "too. A key of the material that the law does not use is an error.\n",
          out);
}

/* ---- products ------------------------------------------------------------ */

static void put_product(FILE *out, int product)
{
    const unsigned asked = 1u << product, stages = plan_stages(asked);
    const char *gap = "";

    fprintf(out, "| `%s` | ", product_names[product]);
    for (int s = 0; s < STAGES; s++)
        if (stage_table[s].products & asked) {
            fprintf(out, "%s", gap);
            markdown_text(out, stage_table[s].text);
            gap = "; ";
        }
    fputs(" |", out);
    for (int s = 0; s < STAGES; s++)
        if (plan_has(stages, (enum stage) s))
            fprintf(out, " `%s`", stage_table[s].name);
    fputs(" |\n", out);
}

static void put_products(FILE *out)
{
    fputs("\n## Products\n"
          "\n"
          "Each runs the stages it needs and no others; `slipway plan SCENE` "
          "says which.\n"
          "\n"
          "| product | computes | stages |\n"
          "|---|---|---|\n",
          out);
    for (int p = 0; p < PRODUCTS; p++)
        put_product(out, p);
}

static void put_stages(FILE *out)
{
    fputs("\n## Stages\n"
          "\n"
          "| stage | does | work |\n"
          "|---|---|---|\n",
          out);
    for (int s = 0; s < STAGES; s++) {
        fprintf(out, "| `%s` | ", stage_table[s].name);
        markdown_text(out, stage_table[s].text);
        fputs(" | ", out);
        markdown_text(out, stage_table[s].cost);
        fputs(" |\n", out);
    }
}

void reference_scene(FILE *out)
{
    fputs(text_scene, out);
    put_keys(out);
    put_laws(out);
    put_products(out);
    put_stages(out);
}
