#include "diagram.h"

#include "study_results.h"

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

/* ---- what a study says of its diagrams ----------------------------------- */

RESULT_VIEW(view_friction, study, s->diagrams.friction_law[0].at,
            s->diagrams.friction_law[0].count)
RESULT_VIEW(view_friction_extrema, study, s->diagrams.friction_law[0].extremum,
            s->diagrams.friction_law[0].extrema)
RESULT_VIEW(view_spring, study, s->diagrams.spring_block[0].at,
            s->diagrams.spring_block[0].count)
RESULT_VIEW(view_spring_extrema, study, s->diagrams.spring_block[0].extremum,
            s->diagrams.spring_block[0].extrema)
RESULT_VIEW(view_block, study, &s->diagrams.spring_block[0].block, 1)
RESULT_VIEW(view_bifurcation, study, s->diagrams.bifurcation.at,
            s->diagrams.bifurcation.count)
RESULT_VIEW(view_folds, study, s->diagrams.bifurcation.extremum,
            s->diagrams.bifurcation.extrema)
RESULT_VIEW(view_fold_curves, study, s->diagrams.fold_curves.at,
            s->diagrams.fold_curves.count)
RESULT_VIEW(view_cusp, study, &s->diagrams.fold_curves.cusp, 1)
RESULT_VIEW(view_no_fold_curve, study, &s->diagrams.fold_curves, 1)
RESULT_VIEW(view_slopes, study, s->diagrams.chi.slope, s->diagrams.chi.slopes)
RESULT_VIEW(view_rates, study, s->diagrams.chi.v, s->diagrams.chi.points)

/* Dieterich's curves, where there are any. */
#define BESIDE(diagram) s->diagrams.diagram[DIAGRAM_DIETERICH]
RESULT_VIEW_IF(view_friction_beside, study, BESIDE(friction_law).count > 0,
               result_lend(out, BESIDE(friction_law).at,
                           BESIDE(friction_law).count))
RESULT_VIEW_IF(view_spring_beside, study, BESIDE(spring_block).count > 0,
               result_lend(out, BESIDE(spring_block).at,
                           BESIDE(spring_block).count))

/* Where the stiffest spring still sticks and slips, if any does. */
static enum status view_stiffest(const void *run, size_t k,
                                 struct result_view *out)
{
    const struct spring_curve *c =
        &((const struct study *) run)->diagrams.spring_block[DIAGRAM_SCENE];
    const struct spring_point *top = NULL;

    (void) k;
    for (size_t i = 0; i < c->count; i++)
        if (quantity_exists(&c->at[i].k) &&
            (top == NULL || c->at[i].k.value > top->k.value))
            top = &c->at[i];
    return top ? result_lend(out, top, 1) : STATUS_OK;
}

static const struct record_type record_block =
    RECORD(spring_block, "spring_block", "the block",
           FIELD(spring_block, REAL, sigma, "Pa", "normal stress"),
           FIELD(spring_block, REAL, mass, "kg/m^2", "of the block"));

static const struct record_type record_comment =
    RECORD(fold_curve, "comment", "why there is no curve",
           FIELD_AS(fold_curve, TEXT, "comment", reason, "1",
                    "why there is no curve, if there is none"));

/* Of the axis v, and of a layer. */
struct rate {
    double v;
};
struct chi_cell {
    double ln_chi, ln_chi_error;
};

static const struct record_type record_rate = RECORD(
    rate, "rate", "slip rates", FIELD(rate, REAL, v, "V_star", "slip rate"));

static const struct record_type record_chi =
    RECORD(chi_cell, "chi", "chi(v)",
           FIELD(chi_cell, REAL, ln_chi, "1", "ln chi(v), (34)"),
           FIELD(chi_cell, REAL, ln_chi_error, "1", "error bound of ln_chi"));

static enum status chi_rows(const void *run, size_t first, size_t count,
                            const struct monitor *monitor, void *records)
{
    const struct chi_curves *c = &((const struct study *) run)->diagrams.chi;
    struct chi_cell *cell = records;

    (void) monitor;
    for (size_t i = 0; i < count * c->points; i++)
        cell[i] = (struct chi_cell){ c->ln_chi[first * c->points + i],
                                     c->error[first * c->points + i] };
    return STATUS_OK;
}

/* clang-format off */
const struct result diagram_results[] = {
    { "/friction_law", NULL, "product friction_law, Fig 1(a)", RESULT_COLUMNS,
      .axis = "v", .type = &record_friction, .needs = ASKED_BY(FRICTION_LAW),
      .view = view_friction },
    { "/friction_law/extrema", "friction_law.extrema", "extrema of mu_ss",
      RESULT_COLUMNS, .type = &record_extremum,
      .title = "friction law: extrema of mu_ss",
      .needs = ASKED_BY(FRICTION_LAW), .view = view_friction_extrema },
    { "/friction_law/dieterich", NULL,
      "the same of Dieterich's law, beside another", RESULT_COLUMNS,
      .axis = "v", .type = &record_friction, .needs = ASKED_BY(FRICTION_LAW),
      .view = view_friction_beside },

    { "/spring_block", NULL, "product spring_block, Fig 1(b): steady sliding "
      "is unstable below this stiffness", RESULT_COLUMNS, .axis = "v",
      .type = &record_spring, .needs = ASKED_BY(SPRING_BLOCK),
      .view = view_spring },
    { "/spring_block", "spring_block", NULL, RESULT_ATTRIBUTES,
      .type = &record_block, .title = "spring-block",
      .needs = ASKED_BY(SPRING_BLOCK), .view = view_block },
    { NULL, "spring_block.stiffest", NULL, RESULT_ATTRIBUTES,
      .type = &record_spring, .title = "", .needs = ASKED_BY(SPRING_BLOCK),
      .view = view_stiffest },
    { "/spring_block/extrema", "spring_block.extrema", "extrema of mu_ss",
      RESULT_COLUMNS, .type = &record_extremum, .title = "",
      .needs = ASKED_BY(SPRING_BLOCK), .view = view_spring_extrema },
    { "/spring_block/dieterich", NULL,
      "the same of Dieterich's law, beside another", RESULT_COLUMNS,
      .axis = "v", .type = &record_spring, .needs = ASKED_BY(SPRING_BLOCK),
      .view = view_spring_beside },

    { "/bifurcation", NULL, "product bifurcation, Fig 3", RESULT_COLUMNS,
      .axis = "v", .type = &record_bifurcation,
      .needs = ASKED_BY(BIFURCATION), .view = view_bifurcation },
    { "/bifurcation/folds", "bifurcation.folds", "where two steady states meet",
      RESULT_COLUMNS, .type = &record_extremum,
      .title = "folds of the bifurcation diagram",
      .needs = ASKED_BY(BIFURCATION), .view = view_folds },

    { "/fold_curves", NULL, "product fold_curves, Fig 4", RESULT_COLUMNS,
      .axis = "c", .type = &record_fold_curve, .needs = ASKED_BY(FOLD_CURVES),
      .view = view_fold_curves },
    { "/fold_curves/cusp", "fold_curves.cusp", "where both folds meet",
      .type = &record_cusp, .title = "cusp of the fold curves",
      .needs = ASKED_BY(FOLD_CURVES),
      .view = view_cusp },
    { "/fold_curves", NULL, NULL, RESULT_ATTRIBUTES, .type = &record_comment,
      .needs = ASKED_BY(FOLD_CURVES), .view = view_no_fold_curve },

    { "/chi", "chi", "product chi, Fig 10", RESULT_COLUMNS, .axis = "alpha",
      .type = &record_chi_slope, .title = "chi(v)", .needs = ASKED_BY(CHI), .view = view_slopes },
    { "/chi", NULL, NULL, RESULT_COLUMNS, .axis = "v", .type = &record_rate,
      .needs = ASKED_BY(CHI), .view = view_rates },
    { "/chi", NULL, NULL, RESULT_LAYERS, .axis = "alpha, v",
      .type = &record_chi, .needs = ASKED_BY(CHI), .rows = chi_rows },
    { .path = NULL },
};
/* clang-format on */
