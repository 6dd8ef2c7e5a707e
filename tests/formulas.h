/* formulas.h -- studies of systems of formulas: what a test says of one in a
 * line.
 */
#pragma once

#include "check.h"
#include "plane_branch.h"
#include "plane_rows.h"
#include "scenes.h"

/* Runs the system's study; `more`: settings, one a line.  *scene must not move
 * while *s is there. */
static inline void plane_run(struct plane_study *s, struct scene *scene,
                             const char *ode, const char *more)
{
    char sets[1000];
    struct fault why;

    snprintf(sets, sizeof sets, "system.ode=\"%s\"\n%s", ode, more);
    CHECK(scene_of(scene, NULL, sets, &why) == STATUS_OK, "%s", why.text);
    CHECK(plane_study_run(s, scene, NULL, &why) == STATUS_OK, "%s", why.text);
}

static inline void plane_end(struct plane_study *s, struct scene *scene)
{
    plane_study_free(s);
    scene_free(scene);
}

/* The branch that a saddle has of this kind. */
static inline const struct plane_branch *plane_branch_of(
    const struct plane_study *s, int64_t saddle, enum manifold_kind kind,
    int64_t branch)
{
    for (size_t i = 0; i < s->branches; i++)
        if (s->branch[i].saddle == saddle &&
            s->branch[i].kind == (int8_t) kind && s->branch[i].branch == branch)
            return &s->branch[i];
    CHECK(false, "saddle %d has no branch %d", (int) saddle, (int) branch);
    return NULL;
}

/* Every stored point of the branch is on g(x, y) = 0 within its bar: g, and
 * how fast it changes; and bars are below `most` as long as the distance from
 * the saddle is below `reach`. */
static inline void plane_on(const struct plane_study *s,
                            const struct plane_branch *b,
                            double (*g)(const void *ctx, double x, double y,
                                        double *steep),
                            const void *ctx, double reach, double most)
{
    const struct record_type type = { .size = sizeof(struct plane_point) };
    struct rows r = rows_of(&type);

    assert_int_equal(plane_rows_branch(s, b, &r), STATUS_OK);
    CHECK(r.count > 5, "only %zu points", r.count);
    for (size_t i = 0; i < r.count; i++) {
        const struct plane_point *p = (const struct plane_point *) r.at + i;
        double steep = 1.0;
        const double off = g(ctx, p->at[0], p->at[1], &steep);
        CHECK(fabs(off) <= steep * (p->error + 1e-15),
              "at %.17g, %.17g (arc %g): off by %g, bar %g x %g", p->at[0],
              p->at[1], p->arc, off, p->error, steep);
        CHECK(p->arc > reach || p->error <= most, "at arc %g: bar %g", p->arc,
              p->error);
        CHECK(p->arc > reach || fabs(off) <= 1e-12 * steep, "at arc %g: %g",
              p->arc, off);
    }
    rows_free(&r);
}
