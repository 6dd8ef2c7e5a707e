#include "provenance.h"

#include <gsl/gsl_version.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene_slope.h"
#include "store_results.h"
#include "system.h"

struct provenance {
    const char *command, *scene, *overrides, *version, *compiler, *libraries;
    const char *law, *friction, *formula;
    struct material material;
    double alpha, eps2; /* NaN: none */
};

#define TEXT(member, text) FIELD(provenance, TEXT, member, "1", text)
#define KEY(member, unit_)                                                     \
    FIELD_AS(provenance, REAL, #member, material.member, unit_,                \
             "material." #member)

static const struct record_type record_provenance = RECORD(
    provenance, "provenance", "how a file came to be",
    TEXT(command, "that makes the file again"),
    TEXT(scene, "the text of the scene; empty without one"),
    TEXT(overrides, "what options set, KEY=VALUE, one a line"),
    TEXT(version, "of Slipway"), TEXT(compiler, "that compiled it"),
    TEXT(libraries, "and their versions"), TEXT(law, "its name, or composed"),
    TEXT(friction, "asinh or log"),
    TEXT(formula, "the law's formulas, or the system's"), KEY(mu_star, "1"),
    KEY(a, "1"), KEY(b, "1"), KEY(c, "1"), KEY(R, "1"), KEY(V_c, "V_star"),
    KEY(L, "m"), KEY(V_star, "m/s"), KEY(g, "m/s^2"),
    FIELD(provenance, REAL, alpha, "rad",
          "slope angle, where the scene has one"),
    FIELD(provenance, REAL, eps2, "1", "eps^2 = V_star^2/(g L)"));

/* What store_create writes. */
static const struct record_type record_root = RECORD_OF(
    char *, "root", NULL, FIELD_OF(TEXT, "Conventions", "1", "CF-1.10"),
    FIELD_OF(TEXT, "title", "1", "the scene's title, or the name of its law"));

RESULT_VIEW(view_provenance, provenance, s, 1)

/* clang-format off */
static const struct result provenance_results[] = {
    { "/", NULL, "of every file", RESULT_ATTRIBUTES, .type = &record_root },
    { "/provenance", NULL,
      "where the file comes from, with what the law uses of the material; "
      "stress has no scene",
      RESULT_ATTRIBUTES, .type = &record_provenance,
      .view = view_provenance },
    { .path = NULL },
};
/* clang-format on */

const struct result *const provenance_tables[] = { provenance_results, NULL };

char *provenance_overrides(const struct scene *scene)
{
    const char *overrides = scene->overrides;
    char *kept = calloc(strlen(overrides) + 1, 1), *end = kept;

    for (const char *line = overrides; kept && *line;) {
        const size_t size = strcspn(line, "\n") + 1;
        if (strncmp(line, "output.", 7) != 0 &&
            strncmp(line, "output=", 7) != 0)
            end = (char *) memcpy(end, line, size) + size;
        line += size;
    }
    return kept;
}

static enum status put(const struct provenance *p, struct store *out)
{
    return store_put_results(
        out, &(struct results){ .table = provenance_tables, .run = p }, NULL);
}

static void tell_law(const struct scene *scene, struct provenance *p,
                     char formula[], size_t size)
{
    law_formula(&scene->law, formula, size);
    p->law = scene->law.preset;
    p->friction = friction_form_names[scene->law.form];
    p->material = scene->material;
    p->eps2 = material_eps2(&p->material);
    for (int k = 0; k < MATERIAL_KEYS; k++)
        if (!law_uses(&scene->law, (enum material_key) k))
            *material_member(&p->material, (enum material_key) k) =
                (double) NAN;
}

static void tell_system(const struct formula_system *f, char formula[],
                        size_t size)
{
    size_t n = 0;

    for (int i = 0; i < f->entries && n < size; i++)
        n += (size_t) snprintf(formula + n, size - n, "%s%s%s = %s",
                               n ? "; " : "", f->entry[i].name,
                               f->entry[i].kind == ENTRY_RATE ? "'" : "",
                               formula_system_text(f, &f->entry[i]));
}

static enum status put_scene(const struct scene *scene, struct provenance *p,
                             struct store *out)
{
    char *overrides = provenance_overrides(scene);
    char formula[1024], libraries[128];

    if (scene->system)
        tell_system(scene->system, formula, sizeof formula);
    else
        tell_law(scene, p, formula, sizeof formula);
    snprintf(libraries, sizeof libraries, "GSL %s, HDF5 %s", GSL_VERSION,
             store_library_version());
    p->scene = scene->text;
    p->overrides = overrides;
    p->libraries = libraries;
    p->formula = formula;
    if (scene_has_slope(scene))
        p->alpha = scene->alpha;
    const enum status status = overrides ? put(p, out) : STATUS_NO_MEMORY;
    free(overrides);
    return status;
}

enum status provenance_put(const char *command, const struct scene *scene,
                           struct store *out)
{
    const double none = (double) NAN;
    struct provenance p = {
        .command = command,
        .version = SLIPWAY_VERSION,
        .compiler = __VERSION__,
        .material = { none, none, none, none, none, none, none, none, none },
        .alpha = none,
        .eps2 = none,
    };

    return scene ? put_scene(scene, &p, out) : put(&p, out);
}
