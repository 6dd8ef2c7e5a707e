#include "proof_law.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "law_tape.h"
#include "law_typed.h"
#include "proof_root.h"
#include "proof_tolerance.h"

/* ---- inputs -------------------------------------------------------------- */

/* y: where psi stands still over x, sought from `near`; or within `all`, once
 * it is known over a place, by the slope of dpsi/dt there. */
struct given {
    struct proof_law *p;
    mpfi_t tan_alpha, eps2, x, y, all, slope, other;
    long double near;
    bool within;
};

static void set_both(struct proof_law *p, const char *leaf, mpfi_srcptr value)
{
    interval_graph_set(&p->at, leaf, value);
    interval_graph_set(&p->state, leaf, value);
}

/* eps^2 = V_star^2/(g L) */
static void set_eps2(struct given *g, const struct material *m, bool decimal)
{
    proof_input(g->eps2, m->V_star, decimal);
    mpfi_sqr(g->eps2, g->eps2);
    proof_input(g->other, m->g, decimal);
    mpfi_div(g->eps2, g->eps2, g->other);
    proof_input(g->other, m->L, decimal);
    mpfi_div(g->eps2, g->eps2, g->other);
}

static void set_leaves(struct proof_law *p, const struct block *b,
                       const struct proof_inputs *in, struct given *g)
{
    const struct material *m = &b->material;
    const struct {
        const char *leaf;
        double value;
    } plain[] = {
        { "mu_star", m->mu_star },
        { "a", m->a },
        { "b", m->b },
        { "c", m->c },
        { "R", m->R },
        { "V_c", m->V_c },
    };

    proof_slope(g->tan_alpha, in);
    set_eps2(g, m, in->decimal);
    set_both(p, "tan_alpha", g->tan_alpha);
    set_both(p, "eps2", g->eps2);
    p->tan_alpha = interval_of_mpfi(g->tan_alpha);
    for (size_t i = 0; i < sizeof plain / sizeof *plain; i++) {
        if (!isfinite(plain[i].value))
            continue; /* not used, or refused before */
        proof_input(g->other, plain[i].value, in->decimal);
        set_both(p, plain[i].leaf, g->other);
    }
    for (int i = 0; p->law.typed && i < p->law.typed->owns; i++) {
        proof_input(g->other, m->own[i], in->decimal);
        set_both(p, p->law.typed->own[i].name, g->other);
    }
}

/* ---- the saddle ---------------------------------------------------------- */

/* dpsi/dt over g->x. */
static bool growth(void *ctx, mpfr_srcptr y, mpfi_ptr out)
{
    struct given *g = ctx;
    struct proof_law *p = g->p;
    struct fault why;

    mpfi_set_fr(g->y, y);
    interval_graph_set(&p->state, LAW_LNV0, g->x);
    interval_graph_set(&p->state, LAW_Y0, g->y);
    if (interval_graph_run(&p->state, &why) != STATUS_OK)
        return false;
    mpfi_set(out,
             interval_graph_value(&p->state, p->graph->node[LAW_AT_GROWTH]));
    return true;
}

/* y = m - dpsi/dt(m)/slope, m the middle of `all` (mean value theorem). */
static bool stand_within(struct given *g)
{
    mpfr_t m;

    mpfr_init2(m, PROOF_BITS);
    mpfi_mid(m, g->all);
    const bool found = growth(g, m, g->other);
    mpfi_div(g->other, g->other, g->slope);
    mpfi_fr_sub(g->y, m, g->other);
    mpfr_clear(m);
    return found;
}

/* The steady state over g->x: constants at the anchor. */
static bool stand(struct given *g)
{
    struct proof_law *p = g->p;
    struct fault why;

    if (p->graph->psi_ss < 0) {
        if (!(g->within ? stand_within(g)
                        : proof_root(growth, NULL, g, g->near, g->y)))
            return false;
        interval_graph_set(&p->at, LAW_Y0, g->y);
    }
    interval_graph_set(&p->at, LAW_LNV0, g->x);
    return interval_graph_run(&p->at, &why) == STATUS_OK;
}

/* h = mu_ss - tan(alpha) at a point. */
static bool balance(void *ctx, mpfr_srcptr x, mpfi_ptr h)
{
    struct given *g = ctx;
    struct proof_law *p = g->p;

    mpfi_set_fr(g->x, x);
    if (!stand(g))
        return false;
    mpfi_sub(h, interval_graph_value(&p->at, p->lowered->t.value[0].constant),
             g->tan_alpha);
    return true;
}

/* Where psi_ss has no formula: over all of the place dpsi/dt falls through 0 in
 * `all`; y_ss is one function where its slope is not 0. */
static bool know_psi_ss(void *ctx, mpfi_srcptr place)
{
    struct given *g = ctx;
    struct proof_law *p = g->p;
    const int variable[] = { p->graph->x, p->graph->y };
    static const struct interval none[2];
    struct fault why;

    g->within = false;
    mpfi_set(g->x, place);
    if (!stand(g))
        return false;
    mpfi_set(g->all, g->y);
    interval_graph_set(&p->state, LAW_LNV0, place);
    interval_graph_set(&p->state, LAW_Y0, g->all);
    if (interval_graph_run(&p->state, &why) != STATUS_OK ||
        !interval_growth_run(p->growth, &p->state, variable, none, 1))
        return false;
    const struct interval by = p->growth->by[p->graph->node[LAW_AT_GROWTH]].all;
    mpfr_set_ld(&g->slope->left, by.lo, MPFR_RNDD);
    mpfr_set_ld(&g->slope->right, by.hi, MPFR_RNDU);
    g->within = true;
    return true;
}

static enum status settle(struct given *g, const struct block *b,
                          struct fault *why)
{
    mpfi_t place;

    mpfi_init2(place, PROOF_BITS);
    g->near = b->y;
    const bool found = proof_root(
        balance, g->p->graph->psi_ss < 0 ? know_psi_ss : NULL, g, b->x, place);
    mpfi_set(g->x, place);
    mpfi_clear(place);
    g->within = false;
    if (found && stand(g))
        return STATUS_OK;
    return fault_set(
        why, STATUS_BAD_ARGUMENT,
        "no sign change of mu_ss - tan(alpha) was found at the saddle");
}

/* ---- all ----------------------------------------------------------------- */

/* Room for graphs that are not kept, and what is needed of both. */
static enum status make_graphs(struct proof_law *p)
{
    static const enum law_number wanted[] = { LAW_AT_MU, LAW_AT_GROWTH,
                                              LAW_AT_DY };
    bool needed[FORMULA_NODES] = { false };

    p->growth = malloc(sizeof *p->growth);
    p->room = malloc(sizeof *p->room);
    p->graph_room = malloc(sizeof *p->graph_room);
    if (p->growth == NULL || p->room == NULL || p->graph_room == NULL)
        return STATUS_NO_MEMORY;
    p->lowered = law_tape_kept(&p->law, true, p->room);
    p->graph = law_graph_kept(&p->law, p->graph_room);
    memcpy(needed, p->lowered->t.needs, sizeof needed);
    for (int i = 0; i < 2; i++)
        needed[p->lowered->p.chart[i]] = needed[p->lowered->p.at[i]] = true;
    enum status s =
        interval_graph_init(&p->at, &p->lowered->f, needed, PROOF_BITS);
    memset(needed, 0, sizeof needed);
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
        needed[p->graph->node[wanted[i]]] = true;
    if (s == STATUS_OK)
        s = interval_graph_init(&p->state, &p->graph->f, needed, PROOF_BITS);
    return s;
}

static struct interval value_at(const struct proof_law *p, int node)
{
    return interval_graph_get(&p->at, node);
}

static void read_saddle(struct proof_law *p, struct given *g)
{
    const struct plane_formulas *f = &p->lowered->p;

    p->x = value_at(p, f->chart[0]);
    p->y = value_at(p, f->chart[1]);
    p->v = value_at(p, f->at[0]);
    p->psi = value_at(p, f->at[1]);
    mpfi_sqr(g->other, g->tan_alpha);
    mpfi_add_ui(g->other, g->other, 1);
    mpfi_sqrt(g->other, g->other);
    mpfi_mul(g->other, g->other, g->eps2);
    mpfi_inv(g->other, g->other);
    p->force = interval_of_mpfi(g->other);
}

static enum status make(struct proof_law *p, const struct block *b,
                        const struct proof_inputs *in, struct given *g,
                        struct fault *why)
{
    static const int excess[] = { 2 + BLOCK_EXCESS };

    set_leaves(p, b, in, g);
    enum status s = settle(g, b, why);
    if (s != STATUS_OK)
        return s;
    interval_graph_set(&p->state, LAW_LNV0, g->x);
    interval_graph_set(&p->state, LAW_Y0,
                       interval_graph_value(&p->at, p->lowered->p.chart[1]));
    s = interval_graph_run(&p->state, why);
    if (s != STATUS_OK)
        return s;
    read_saddle(p, g);
    return interval_tape_init(&p->tape, &p->lowered->t, &p->at, excess, 1);
}

/* With R = inf, where it may be (law_check), psi_ss = (1 + R)/(1 + R v) is 1/v
 * and T = R/(1 + R v), too. */
static struct law limit_of(const struct block *b)
{
    struct law law = b->law;

    if (isinf(b->material.R) && law.typed == NULL) {
        if (law.psi_ss == PSI_SS_SPINODAL)
            law.psi_ss = PSI_SS_INVERSE;
        if (law.timescale == TIMESCALE_SPINODAL)
            law.timescale = TIMESCALE_SLIP;
    }
    return law;
}

enum status proof_law_at(struct proof_law *p, const struct block *b,
                         const struct proof_inputs *in, struct fault *why)
{
    struct given g = { .p = p };

    *p = (struct proof_law){ .law = limit_of(b),
                             .is_log = law_psi_is_log(&b->law) };
    if (!interval_has_64_bits())
        return fault_set(why, STATUS_BAD_ARGUMENT,
                         "numbers of 64 bits are rounded to fewer here");
    enum status s = make_graphs(p);
    if (s != STATUS_OK)
        return s;
    mpfi_init2(g.tan_alpha, PROOF_BITS);
    mpfi_init2(g.eps2, PROOF_BITS);
    mpfi_init2(g.x, PROOF_BITS);
    mpfi_init2(g.y, PROOF_BITS);
    mpfi_init2(g.all, PROOF_BITS);
    mpfi_init2(g.slope, PROOF_BITS);
    mpfi_init2(g.other, PROOF_BITS);
    s = make(p, b, in, &g, why);
    mpfi_clear(g.tan_alpha);
    mpfi_clear(g.eps2);
    mpfi_clear(g.x);
    mpfi_clear(g.y);
    mpfi_clear(g.all);
    mpfi_clear(g.slope);
    mpfi_clear(g.other);
    return s;
}

void proof_law_free(struct proof_law *p)
{
    interval_tape_free(&p->tape);
    interval_graph_free(&p->at);
    interval_graph_free(&p->state);
    free(p->growth);
    free(p->room);
    free(p->graph_room);
    p->growth = NULL;
    p->room = NULL;
    p->graph_room = NULL;
}
