/* found.h -- slopes that random ones found. */
#pragma once

#include "slope.h"

/* A slope: components of its law as of law.h, its material, and the accuracy
 * asked of its cells. */
struct found {
    enum friction_form form;
    enum theta theta;
    enum psi_ss psi_ss;
    enum timescale timescale;
    enum kinetics kinetics;
    double mu_star, a, b, c, R, L, V_star, alpha, rtol;
};

/* Its scene, with `more` settings as in slope_scene. */
static inline void found_scene(const struct found *f, const char *const more[],
                               struct scene *scene)
{
    slope_scene(scene, "spinodal_gen", NULL, "0.34", more);
    scene->law.form = f->form;
    scene->law.theta = f->theta;
    scene->law.psi_ss = f->psi_ss;
    scene->law.timescale = f->timescale;
    scene->law.kinetics = f->kinetics;
    scene->material.mu_star = f->mu_star;
    scene->material.a = f->a;
    scene->material.b = f->b;
    scene->material.c = f->c;
    scene->material.R = f->R;
    scene->material.L = f->L;
    scene->material.V_star = f->V_star;
    scene->alpha = f->alpha;
    scene->tan_alpha = tanl((long double) f->alpha);
    scene->cell_rtol = f->rtol;
}
