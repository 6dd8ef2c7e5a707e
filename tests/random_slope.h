/* random_slope.h -- slopes with a saddle, of any preset, either form of
 * friction, L from 1e-6 to 1e-2 m, V_star from 1e-9 to 1e-6 m/s. */
#ifndef TESTS_RANDOM_SLOPE_H
#define TESTS_RANDOM_SLOPE_H

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

/* Of preset number `law` of all, with more settings as in slope_scene; until it
 * is one that has a saddle with manifolds. */
static inline void random_slope_of(struct slope *s, size_t law, uint64_t *rng,
                                   const char *const more[])
{
    const char *cut[8] = { "material.V_c=100" };
    struct fault why;

    for (size_t i = 0; i < 6 && more[i]; i++)
        cut[i + 1] = more[i];
    for (int attempt = 0; attempt < 1000; attempt++) {
        struct scene *c = &s->scene;
        const char *preset = law_preset_at(law)->preset;
        slope_scene(c, preset, check_bits(rng) & 1 ? "log" : "asinh", "0.34",
                    strcmp(preset, "kato_tullis") == 0 ? cut : more);
        c->material.L = random_power(rng, -6.0, -2.0);
        c->material.V_star = random_power(rng, -9.0, -6.0);
        const long double x = (long double) check_uniform(rng, -12.0, 16.0);
        const bool falls = random_falls(c, x);
        if (falls)
            c->tan_alpha = steady_mu(&c->law, &c->material, x);
        c->alpha = (double) atanl(c->tan_alpha);
        if (falls && c->tan_alpha > 0.02L && c->tan_alpha < 5.0L &&
            study_run(&s->study, c, NULL, &why) == STATUS_OK) {
            if (slider_has_manifolds(&s->study.slider))
                return;
            study_free(&s->study);
        }
        scene_free(c);
    }
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

#endif
