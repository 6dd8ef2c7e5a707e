/* plan.h -- which stage feeds which: a product runs the stages it needs and
 * nothing else. */
#pragma once

#include <stddef.h>

#include "scene.h"

/* What a study can run, in this order. */
enum stage {
    STAGE_STEADY,        /* equilibria, their types, the saddle */
    STAGE_FOLDS,         /* extrema of mu_ss */
    STAGE_STABLE,        /* both branches of the stable manifold */
    STAGE_UNSTABLE,      /* both branches of the unstable manifold */
    STAGE_CRITICAL,      /* numbers read off the stable branches */
    STAGE_KNEES,         /* crossings of slope 1 */
    STAGE_TAYLOR,        /* the manifold's power series in v */
    STAGE_ESTIMATES,     /* the paper's formulas (29)-(42) */
    STAGE_SENSITIVITIES, /* derivatives by the inputs, conditioning */
    STAGE_NULLCLINES,    /* in the window */
    STAGE_ARROWS,        /* direction field in the window */
    STAGE_TRAJECTORIES,  /* forward orbits */
    STAGE_BASINS,        /* the fate of every cell of a grid */
    STAGE_FIELDS,        /* slip, time, friction of every cell of it */
    STAGE_SPREAD,        /* what the scatter of inputs makes of the numbers */
    STAGE_FRICTION_LAW,  /* diagrams of steady sliding: Fig 1(a), */
    STAGE_SPRING_BLOCK,  /* Fig 1(b), */
    STAGE_BIFURCATION,   /* Fig 3, */
    STAGE_FOLD_CURVES,   /* Fig 4 */
    STAGE_CHI,           /* chi(v), Fig 10 */
    STAGE_PROOF,         /* enclosures of the others' numbers */
    STAGE_SIDES,         /* which labels of the grid are proved */
    STAGES
};

/* Beside bits of stages: of several steady states nobody asks for others than
 * the saddle. */
#define PLAN_SADDLE (1u << STAGES)

/* Beside that one: of its lower branch nobody asks for x_deficit. */
#define PLAN_NO_DEFICIT (2u << STAGES)

/* Stages that read no other one. */
#define PLAN_OF_SADDLE                                                         \
    (1u << STAGE_STEADY | 1u << STAGE_FOLDS | 1u << STAGE_STABLE |             \
     1u << STAGE_CRITICAL | 1u << STAGE_KNEES)

/* What a stage is to its users and to the other stages. */
struct stage_info {
    const char *name;
    const char *text;  /* what it does, one phrase */
    const char *cost;  /* how much work to expect, one phrase */
    unsigned needs;    /* bits 1 << enum stage */
    unsigned products; /* the scene's products (bits) that ask for it */
};

/* By enum stage. */
extern const struct stage_info stage_table[STAGES];

/* The stages a set of products runs, closed under `needs`: bits. */
unsigned plan_stages(unsigned products);

/* Stages with all that they need. */
unsigned plan_close(unsigned stages);

/* As few products as run these stages. */
unsigned plan_products(unsigned stages);

/* Those that a scene's study runs: of its products, with a slope its steady
 * states and, where the scene asks for proofs, those; with inputs that scatter
 * the spread. */
unsigned plan_scene(const struct scene *scene);

/* Whether a stage is among these bits. */
static inline int plan_has(unsigned stages, enum stage s)
{
    return (stages >> s) & 1u;
}
