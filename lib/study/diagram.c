#include "diagram.h"

#include "study.h"

/* Dieterich's law in the form of the scene's. */
static struct law dieterich(const struct scene *c)
{
    struct law law = *law_preset_find("dieterich");

    law.form = c->law.form;
    return law;
}

/* Whether both slide steadily alike; in motion, too, where relaxation counts.
 */
static bool alike(const struct law *law, bool relaxation)
{
    return law->theta == THETA_LN_PSI && law->psi_ss == PSI_SS_INVERSE &&
           (!relaxation || law->timescale == TIMESCALE_SLIP);
}

enum status diagram_friction_law(struct study *s, const struct monitor *monitor,
                                 struct fault *why)
{
    const struct scene *c = s->scene;
    struct steady_curve *curve = s->diagrams.friction_law;
    const struct law other = dieterich(c);
    const enum status status = steady_curve_find(
        &c->law, &c->material, c->window.v, &curve[DIAGRAM_SCENE]);

    (void) monitor, (void) why;
    return status || alike(&c->law, false)
               ? status
               : steady_curve_find(&other, &c->material, c->window.v,
                                   &curve[DIAGRAM_DIETERICH]);
}

enum status diagram_spring_block(struct study *s, const struct monitor *monitor,
                                 struct fault *why)
{
    const struct scene *c = s->scene;
    struct spring_curve *curve = s->diagrams.spring_block;
    const struct spring_block block = { c->spring_block.sigma,
                                        c->spring_block.mass };
    const struct law other = dieterich(c);
    const enum status status =
        spring_curve_find(&block, &c->law, &c->material, c->spring_block.v,
                          &curve[DIAGRAM_SCENE]);

    (void) monitor, (void) why;
    return status || alike(&c->law, true)
               ? status
               : spring_curve_find(&block, &other, &c->material,
                                   c->spring_block.v,
                                   &curve[DIAGRAM_DIETERICH]);
}

enum status diagram_bifurcation(struct study *s, const struct monitor *monitor,
                                struct fault *why)
{
    const struct scene *c = s->scene;

    (void) monitor, (void) why;
    return steady_curve_find(&c->law, &c->material, c->window.v,
                             &s->diagrams.bifurcation);
}

enum status diagram_fold_curves(struct study *s, const struct monitor *monitor,
                                struct fault *why)
{
    const struct scene *c = s->scene;

    (void) monitor, (void) why;
    return fold_curve_find(&c->law, &c->material, c->fold_c,
                           &s->diagrams.fold_curves);
}

enum status diagram_chi(struct study *s, const struct monitor *monitor,
                        struct fault *why)
{
    const struct scene *c = s->scene;

    (void) monitor, (void) why;
    return chi_curves_find(&c->law, &c->material, c->chi_alpha, c->chi_alphas,
                           c->window.v, &s->diagrams.chi);
}

void diagrams_free(struct diagrams *d)
{
    for (int i = 0; i < DIAGRAM_LAWS; i++) {
        steady_curve_free(&d->friction_law[i]);
        spring_curve_free(&d->spring_block[i]);
    }
    steady_curve_free(&d->bifurcation);
    fold_curve_free(&d->fold_curves);
    chi_curves_free(&d->chi);
}
