/* random_slope.h -- slopes with a saddle, of any law, L from 1e-6 to 1e-2 m,
 * V_star from 1e-9 to 1e-6 m/s. */
#pragma once

#include "slope.h"

static inline double random_power(uint64_t *rng, double lo, double hi)
{
    return pow(10.0, check_uniform(rng, lo, hi));
}

/* Whether friction falls with the slip rate at x = ln v: a saddle then. */
static inline bool random_falls(const struct scene *s, long double x)
{
    const long double h = 1e-4L;

    return x + h < steady_x_max(&s->law) &&
           steady_mu(&s->law, &s->material, x + h) <
               steady_mu(&s->law, &s->material, x - h);
}

/* Whether a slope of it has a saddle with manifolds. */
static inline bool random_slope_try(struct slope *s, const struct law *law,
                                    uint64_t *rng, const char *const more[])
{
    struct scene *c = &s->scene;
    struct fault why;

    /* for its window */
    slope_scene(c, law_psi_is_log(law) ? "ruina" : "spinodal", NULL, "0.34",
                more);
    c->law = *law;
    c->material.L = random_power(rng, -6.0, -2.0);
    c->material.V_star = random_power(rng, -9.0, -6.0);
    if (law->kinetics == KINETICS_COMPOSITE)
        c->material.V_c = 100.0;
    const long double x = (long double) check_uniform(rng, -12.0, 16.0);
    const bool falls = law_check(&c->law, &c->material, &why) == STATUS_OK &&
                       random_falls(c, x);
    if (falls)
        c->tan_alpha = steady_mu(&c->law, &c->material, x);
    c->alpha = (double) atanl(c->tan_alpha);
    if (falls && c->tan_alpha > 0.02L && c->tan_alpha < 5.0L &&
        study_run(&s->study, c, NULL, &why) == STATUS_OK) {
        if (slider_has_manifolds(&s->study.slider))
            return true;
        study_free(&s->study);
    }
    scene_free(c);
    return false;
}

/* With more settings as in slope_scene; false: none of this law was found. */
static inline bool random_slope_by(struct slope *s, const struct law *law,
                                   uint64_t *rng, const char *const more[])
{
    for (int attempt = 0; attempt < 100; attempt++)
        if (random_slope_try(s, law, rng, more))
            return true;
    return false;
}

/* Of preset number `law` of all. */
static inline void random_slope_of(struct slope *s, size_t law, uint64_t *rng,
                                   const char *const more[])
{
    struct law preset = *law_preset_at(law);

    preset.form = check_bits(rng) & 1 ? FRICTION_LOG : FRICTION_ASINH;
    if (!random_slope_by(s, &preset, rng, more))
        fail_msg("no slope");
}

static inline size_t random_presets(void)
{
    size_t n = 0;

    while (law_preset_at(n))
        n++;
    return n;
}

static inline void random_slope(struct slope *s, uint64_t *rng,
                                const char *more)
{
    const char *const set[] = { more, NULL };

    random_slope_of(s, check_bits(rng) % random_presets(), rng, set);
}
