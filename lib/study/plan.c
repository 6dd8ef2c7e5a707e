#include "plan.h"

#include "scene_slope.h"

#define BIT(s)   (1u << STAGE_##s)
#define ASKED(p) (1u << PRODUCT_##p)

const struct stage_info stage_table[STAGES] = {
    [STAGE_STEADY] = { "steady", "steady states, their types, the saddle",
                       "microseconds", 0, ASKED(EQUILIBRIA) },
    [STAGE_FOLDS] = { "folds", "extrema of mu_ss, folds, cusp", "microseconds",
                      0, ASKED(FOLDS) | ASKED(KNEES) },
    [STAGE_STABLE] = { "stable", "both branches of the stable manifold",
                       "about 50 Taylor steps", BIT(STEADY), ASKED(MANIFOLDS) },
    [STAGE_UNSTABLE] = { "unstable", "both branches of the unstable manifold",
                         "two stiff orbits", BIT(STEADY), ASKED(MANIFOLDS) },
    [STAGE_CRITICAL] = { "critical", "critical velocities, slip, mu_s",
                         "microseconds", BIT(STABLE), ASKED(KNEES) },
    [STAGE_KNEES] = { "knees", "where the manifold's slope rises through 1",
                      "microseconds", BIT(STABLE) | BIT(CRITICAL),
                      ASKED(KNEES) },
    [STAGE_TAYLOR] = { "taylor_series", "the manifold's power series in v",
                       "microseconds", BIT(CRITICAL), ASKED(TAYLOR_SERIES) },
    [STAGE_ESTIMATES] = { "estimates", "the paper's formulas (29)-(42)",
                          "microseconds", BIT(CRITICAL), ASKED(ESTIMATES) },
    [STAGE_SENSITIVITIES] = { "sensitivities",
                              "derivatives by the inputs, conditioning",
                              "about 20 times the stable manifold",
                              BIT(CRITICAL), ASKED(SENSITIVITIES) },
    [STAGE_NULLCLINES] = { "nullclines", "zero sets of dv/dt and dpsi/dt",
                           "some thousand field evaluations", BIT(STEADY),
                           ASKED(NULLCLINES) },
    [STAGE_ARROWS] = { "arrows", "direction field",
                       "one field evaluation an arrow", BIT(STEADY),
                       ASKED(FIELD_ARROWS) },
    [STAGE_TRAJECTORIES] = { "trajectories", "forward orbits",
                             "some hundred stiff steps an orbit", BIT(STEADY),
                             ASKED(TRAJECTORIES) },
    [STAGE_BASINS] = { "basins", "the fate of every cell of a grid",
                       "microseconds a row, a stiff orbit an audited cell",
                       BIT(STABLE), ASKED(BASINS) | ASKED(MARGIN) },
    [STAGE_FIELDS] = { "fields", "slip, time, friction of every cell of it",
                       "about a microsecond a cell, more for peaks",
                       BIT(BASINS),
                       ASKED(SLIP) | ASKED(TIME) | ASKED(FRICTION) |
                           ASKED(PEAK) },
    [STAGE_SPREAD] = { "spread", "what the scatter of inputs makes of numbers",
                       "twice the numbers for each input", 0, 0 },
    [STAGE_FRICTION_LAW] = { "friction_law", "steady-state friction over v",
                             "a millisecond", 0, ASKED(FRICTION_LAW) },
    [STAGE_SPRING_BLOCK] = { "spring_block", "stick-slip boundary over v",
                             "a millisecond", 0, ASKED(SPRING_BLOCK) },
    [STAGE_BIFURCATION] = { "bifurcation", "steady states over all slopes",
                            "a millisecond", 0, ASKED(BIFURCATION) },
    [STAGE_FOLD_CURVES] = { "fold_curves", "folds over c, to the cusp",
                            "a millisecond", 0, ASKED(FOLD_CURVES) },
    [STAGE_CHI] = { "chi", "chi(v) of (34) for some slopes", "a millisecond", 0,
                    ASKED(CHI) },
    [STAGE_PROOF] = { "proof", "enclosures of the saddle and its manifold",
                      "some tenths of a second", BIT(STEADY), 0 },
    [STAGE_SIDES] = { "sides", "which cells' labels are proved",
                      "about 40 microseconds a row", BIT(BASINS) | BIT(PROOF),
                      0 },
};

unsigned plan_stages(unsigned products)
{
    unsigned stages = 0;

    for (int s = 0; s < STAGES; s++)
        if (products & stage_table[s].products)
            stages |= 1u << s;
    return plan_close(stages);
}

unsigned plan_close(unsigned stages)
{
    for (int s = STAGES; s-- > 0;) /* needs point backward only */
        if (plan_has(stages, (enum stage) s))
            stages |= stage_table[s].needs;
    return stages;
}

unsigned plan_products(unsigned stages)
{
    unsigned products = 0;

    for (int s = 0; s < STAGES; s++)
        if (plan_has(stages, (enum stage) s))
            products |= stage_table[s].products & -stage_table[s].products;
    return products;
}

unsigned plan_scene(const struct scene *scene)
{
    const unsigned spread = scene->ensemble.scattered > 0 ? BIT(SPREAD) : 0;
    const unsigned stages = plan_stages(scene->products) | spread;
    const unsigned sides = stages & BIT(BASINS) ? BIT(SIDES) : 0;

    if (!scene_has_slope(scene))
        return stages;
    return stages | BIT(STEADY) | (scene->proved ? BIT(PROOF) | sides : 0);
}
