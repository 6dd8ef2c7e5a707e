/* any_law.h -- random laws, materials and slopes. */
#pragma once

#include "laws.h"
#include "scene.h"
#include "steady.h"

enum { DRAWN_NAME = 400 };

static inline void drawn_name(size_t i, const struct scene *s,
                              char name[DRAWN_NAME])
{
    const struct law *l = &s->law;
    const struct material *m = &s->material;

    snprintf(
        name, DRAWN_NAME,
        "draw %zu: %s %s %s %s %s, mu %.17g a %.17g b %.17g c %.17g R %.17g "
        "L %.17g V_c %.17g V %.17g tan alpha %.21Lg, rtol %g",
        i, friction_form_names[l->form], theta_names[l->theta],
        l->kinetics == KINETICS_COMPOSITE ? "kato_tullis"
                                          : psi_ss_names[l->psi_ss],
        timescale_names[l->timescale],
        l->kinetics == KINETICS_SINH ? "sinh" : "linear", m->mu_star, m->a,
        m->b, m->c, m->R, m->L, m->V_c, m->V_star, s->tan_alpha, s->cell_rtol);
}

/* Every other one of a preset, and a material next to Table 2's. */
static inline bool drawn_law(size_t i, uint64_t *rng, struct scene *s)
{
    static const char *const preset[] = {
        "dieterich",    "dieterich_gen",    "ruina",      "perrin", "spinodal",
        "spinodal_gen", "spinodal_phi_gen", "kato_tullis"
    };
    enum { PRESETS = sizeof preset / sizeof *preset };
    struct fault why;

    if (i % 2 == 0)
        return laws_draw(check_bits(rng) % LAWS, rng, &s->law, &s->material);
    s->law = *law_preset_find(preset[i / 2 % PRESETS]);
    s->law.form = (enum friction_form)(check_bits(rng) % FRICTION_FORMS);
    s->material = material_bristol_board();
    s->material.a *= check_uniform(rng, 0.6, 1.1);
    s->material.L *= laws_power(rng, -2, 2);
    s->material.c *= laws_power(rng, -1, 1);
    s->material.R *= laws_power(rng, -1, 1);
    s->material.V_c = laws_power(rng, -1, 4);
    return law_check(&s->law, &s->material, &why) == STATUS_OK;
}

/* A slope on which the block may slide steadily, and a window around that. */
static inline bool drawn_slope(uint64_t *rng, struct scene *s)
{
    const long double x = (long double) check_uniform(rng, -12, 12);
    const double high = check_uniform(rng, 1.0, 10.0), wide = high / 2.0;

    if (x >= steady_x_max(&s->law))
        return false;
    const double psi = (double) steady_psi(&s->law, &s->material, x);
    const bool is_log = law_psi_is_log(&s->law);
    s->tan_alpha = steady_mu(&s->law, &s->material, x);
    s->alpha = (double) atanl(s->tan_alpha);
    for (int i = 0; i < 2; i++) {
        const double side = i ? 1.0 : -1.0;
        s->window.v[i] = exp((double) x + side * high);
        s->window.psi[i] = is_log ? psi + side * wide : psi * exp(side * wide);
    }
    return s->tan_alpha > 0.02L && s->tan_alpha < 5.0L;
}
