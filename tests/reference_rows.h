/* reference_rows.h -- a row of the reference tables as a solved slope. */
#pragma once

#include <math.h>

#include "csv.h"
#include "numbers.h"

/* Everything computed from one row; must not move (system borrows block). */
struct solved {
    struct block block;
    struct planar system;
    struct equilibrium saddle;
    struct steady_number steady;
    bool has_saddle;
    struct branch upper, lower; /* owned */
    struct critical_numbers numbers;
};

static inline int word_of(const char *text, const char *const *names)
{
    for (int i = 0; names[i]; i++)
        if (strcmp(names[i], text) == 0)
            return i;
    return 0;
}

static inline struct law row_law(const struct csv *c)
{
    const struct law *preset = law_preset_find(csv_text(c, "law"));
    struct law law =
        preset ? *preset
               : (struct law){ .preset = "composed", .equation = "composed" };

    law.form =
        strcmp(csv_text(c, "form"), "log") == 0 ? FRICTION_LOG : FRICTION_ASINH;
    if (preset == NULL) {
        law.theta = (enum theta) word_of(csv_text(c, "theta"), theta_names);
        law.psi_ss = (enum psi_ss) word_of(csv_text(c, "psi_ss"), psi_ss_names);
        law.timescale =
            (enum timescale) word_of(csv_text(c, "timescale"), timescale_names);
        law.kinetics =
            (enum kinetics) word_of(csv_text(c, "kinetics"), kinetics_names);
    }
    return law;
}

static inline struct material row_material(const struct csv *c)
{
    struct material m = material_bristol_board();

    for (int key = 0; key < MATERIAL_KEYS; key++) {
        const char *name = material_key_name((enum material_key) key);
        double *value = material_member(&m, (enum material_key) key);
        *value = csv_number(c, name, *value);
    }
    return m;
}

/* Branches are not closed inside this box; NULL: as soon as possible. */
static const struct box *solve_reach;
/* Whether for numbers alone, without knees; every other time without
 * x_deficit. */
static bool solve_bare;

static inline enum status solve_branches(struct solved *s, double rtol)
{
    static unsigned times;
    struct grow_options o = grow_defaults(rtol);
    struct branch branch[2];
    struct local_series u;

    o.carry = (struct carry){ { BLOCK_EXCESS }, 1 };
    o.reach = solve_reach;
    o.bare = solve_bare;
    enum status status = local_at(&s->system, &s->saddle, MANIFOLD_STABLE,
                                  &o.carry, o.order, 0.01 * rtol, &u);
    const bool up = u.ind == 0 || u.c[1] > 0.0;
    struct grow_job job = {
        .sys = &s->system, .start = &u, .options = &o, .out = branch
    };
    job.carries = solve_bare && times++ % 2 ? (up ? 1 : -1) : 0;
    if (status == STATUS_OK) {
        grow_jobs(&job, 1);
        status = job.status;
    }
    if (status != STATUS_OK)
        return status;
    s->upper = branch[up ? 0 : 1];
    s->lower = branch[up ? 1 : 0];
    s->numbers = numbers_critical(&s->block, &s->saddle, &s->upper, &s->lower);
    if (!solve_bare)
        numbers_knees(&s->block, &s->system, &s->upper, &s->lower, &s->numbers);
    return STATUS_OK;
}

/* Law, material and slope solved; free with solved_free. */
static inline enum status solve(struct solved *s, const struct law *law,
                                const struct material *m, long double tan_alpha,
                                double rtol)
{
    struct steady_root root[EQUILIBRIA_MAX];

    *s = (struct solved){ .has_saddle = false };
    s->upper.curve = s->lower.curve = CURVE_EMPTY(3);
    s->numbers = numbers_no_critical();
    block_init(&s->block, law, m, tan_alpha);
    s->system = block_planar(&s->block);
    const size_t n = equilibrium_find(s->system.steady, s->system.ctx, root);
    for (size_t i = 0; i < n && !s->has_saddle; i++) {
        block_anchor(&s->block, root[i].x, true);
        s->system = block_planar(&s->block);
        equilibrium_at(&s->system, root[i].fold, &s->saddle);
        s->steady = numbers_steady(&s->block, &s->saddle);
        s->has_saddle = s->saddle.type == EQUILIBRIUM_SADDLE;
    }
    return s->has_saddle ? solve_branches(s, rtol) : STATUS_OK;
}

static inline enum status solve_row(struct solved *s, const struct csv *c,
                                    double rtol)
{
    const struct law law = row_law(c);
    const struct material m = row_material(c);
    return solve(s, &law, &m, tanl((long double) csv_number(c, "alpha", 0)),
                 rtol);
}

static inline void solved_free(struct solved *s)
{
    branch_free(&s->upper);
    branch_free(&s->lower);
}
