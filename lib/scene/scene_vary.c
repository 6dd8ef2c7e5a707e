#include "scene_vary.h"

#include <math.h>
#include <string.h>

#include "law_typed.h"
#include "scene_law.h"
#include "scene_units.h"
#include "schema.h"
#include "value.h"

struct scene_vary scene_vary_at(const struct scene *s, const char *path)
{
    const struct schema_key *key = schema_find(path);

    return (struct scene_vary){
        .path = path,
        .key = key,
        .own = scene_law_find(s, path),
        .unit = key && s->units == UNITS_SI ? unit_text_of(key->unit) : NULL,
    };
}

bool scene_vary_is(const struct scene_vary *v)
{
    return v->own >= 0 || (v->key && value_is_real(v->key));
}

/* Law and material, or neither. */
static bool set_own(struct scene *s, int own, double x)
{
    struct material m = s->material;

    m.own[own] = x;
    const struct law_typed *typed = law_typed_at(s->typed, m.own);
    if (typed == NULL)
        return false;
    s->material = m;
    s->law = law_of_typed(typed);
    return true;
}

bool scene_vary_set(const struct scene_vary *v, double x, struct scene *s)
{
    if (v->own >= 0) {
        if (!isfinite(x) || (x > 0.0) != (s->typed->own[v->own].value > 0.0))
            return false;
        return set_own(s, v->own, x);
    }
    if (v->key == NULL)
        return isfinite(x);
    if (v->unit == NULL)
        return value_set(v->key, x, s);
    const struct unit_system units = scene_units(s);
    return value_set(v->key, x / unit_scale(&units, v->unit), s);
}

/* Is there such a key, or another one in its place? */
static bool is_given(const struct node *root, const char *path)
{
    const struct node *slope = node_find(root, "slope");

    if (strncmp(path, "slope.", 6) == 0)
        return slope && slope->count > 0;
    return node_at(root, path) != NULL;
}

void scene_vary_begin(const struct scene_vary *v, const struct node *root,
                      double x, struct scene *s)
{
    const bool needed = strncmp(v->path, "slope.", 6) == 0 ||
                        strcmp(v->path, "material.V_c") == 0;

    if (needed && scene_vary_is(v) && !is_given(root, v->path))
        (void) scene_vary_set(v, x, s);
}

enum status scene_vary_check_used(const char *path, const struct scene *s,
                                  struct place at, const char *before,
                                  struct fault *why)
{
    const int own = scene_law_find(s, path);

    if (own >= 0 && !law_uses_name(&s->law, s->typed->own[own].name))
        return place_blame(at, why,
                           "%s%s: no formula of the law has it, expected "
                           "another key",
                           before, path);
    for (int k = 0; k < MATERIAL_G; k++) {
        const char *name = material_key_name((enum material_key) k);
        if (strncmp(path, "material.", 9) == 0 && strcmp(path + 9, name) == 0 &&
            !law_uses(&s->law, (enum material_key) k))
            return place_blame(at, why,
                               "%s%s: not used by this law (%s), expected "
                               "another key",
                               before, path, s->law.preset);
    }
    return STATUS_OK;
}

const char *scene_vary_expected(const struct scene_vary *v,
                                const struct scene *s)
{
    if (v->own >= 0)
        return "numbers of the sign that it has in the scene";
    return s->system || v->key == NULL ? "a finite number" : v->key->expected;
}
