#include "scene_vary.h"

#include <math.h>

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

bool scene_vary_set(const struct scene_vary *v, double x, struct scene *s)
{
    if (v->own >= 0) {
        if (!isfinite(x) || (x > 0.0) != (s->typed->own[v->own].value > 0.0))
            return false;
        s->material.own[v->own] = x;
        return true;
    }
    if (v->key == NULL)
        return isfinite(x);
    if (v->unit == NULL)
        return value_set(v->key, x, s);
    const struct unit_system units = scene_units(s);
    return value_set(v->key, x / unit_scale(&units, v->unit), s);
}

const char *scene_vary_expected(const struct scene_vary *v,
                                const struct scene *s)
{
    if (v->own >= 0)
        return "numbers of the sign that it has in the scene";
    return s->system || v->key == NULL ? "a finite number" : v->key->expected;
}
