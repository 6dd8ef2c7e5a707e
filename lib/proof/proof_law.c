#include "proof_law.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "interval_math.h"
#include "law_tape.h"
#include "number.h"
#include "proof_tolerance.h"

/* ---- inputs -------------------------------------------------------------- */

/* The number as it is meant. */
static void number(mpfi_ptr out, double x, bool decimal)
{
    if (decimal)
        mpfi_set_str(out, number_shortest(x).text, 10);
    else
        mpfi_set_d(out, x);
}

static void slope(mpfi_ptr tan_alpha, const struct proof_inputs *in)
{
    mpfi_t pi;

    if (in->decimal && in->slope_text)
        mpfi_set_str(tan_alpha, in->slope_text, 10);
    else
        number(tan_alpha, in->slope, in->decimal);
    if (in->slope_in == ANGLE_TAN)
        return;
    if (in->slope_in == ANGLE_DEGREE) {
        mpfi_init2(pi, PROOF_BITS);
        mpfi_const_pi(pi);
        mpfi_mul(tan_alpha, tan_alpha, pi);
        mpfi_div_ui(tan_alpha, tan_alpha, 180);
        mpfi_clear(pi);
    }
    mpfi_tan(tan_alpha, tan_alpha);
}

struct given {
    mpfi_t tan_alpha, eps2, x, y, other;
};

static void set_both(struct proof_law *p, const char *leaf, mpfi_srcptr value)
{
    interval_graph_set(&p->at, leaf, value);
    interval_graph_set(&p->steady, leaf, value);
}

/* eps^2 = V_star^2/(g L) */
static void set_eps2(struct given *g, const struct material *m, bool decimal)
{
    number(g->eps2, m->V_star, decimal);
    mpfi_sqr(g->eps2, g->eps2);
    number(g->other, m->g, decimal);
    mpfi_div(g->eps2, g->eps2, g->other);
    number(g->other, m->L, decimal);
    mpfi_div(g->eps2, g->eps2, g->other);
}

static void set_leaves(struct proof_law *p, const struct block *b,
                       const struct proof_inputs *in, struct given *g)
{
    const struct material *m = &b->material;
    const struct {
        const char *leaf;
        double value;
        struct interval *out;
    } plain[] = {
        { "mu_star", m->mu_star, NULL },
        { "a", m->a, &p->a },
        { "b", m->b, &p->b },
        { "c", m->c, NULL },
        { "R", m->R, &p->R },
        { "V_c", m->V_c, NULL },
    };

    slope(g->tan_alpha, in);
    set_eps2(g, m, in->decimal);
    set_both(p, "tan_alpha", g->tan_alpha);
    set_both(p, "eps2", g->eps2);
    p->tan_alpha = interval_of_mpfi(g->tan_alpha);
    p->eps2 = interval_of_mpfi(g->eps2);
    for (size_t i = 0; i < sizeof plain / sizeof *plain; i++) {
        if (!isfinite(plain[i].value))
            continue; /* not used, or refused before */
        number(g->other, plain[i].value, in->decimal);
        set_both(p, plain[i].leaf, g->other);
        if (plain[i].out)
            *plain[i].out = interval_of_mpfi(g->other);
    }
}

/* ---- the saddle ---------------------------------------------------------- */

static void set_x(struct proof_law *p, mpfi_srcptr x)
{
    interval_graph_set(&p->at, "lnv0", x);
}

/* h = mu_ss - tan(alpha) at a point; false where it has no value. */
static bool balance(struct proof_law *p, struct given *g, mpfr_srcptr x,
                    mpfi_ptr h)
{
    struct fault why;

    mpfi_set_fr(g->x, x);
    set_x(p, g->x);
    if (interval_graph_run(&p->at, &why) != STATUS_OK)
        return false;
    mpfi_sub(h, interval_graph_value(&p->at, p->lowered->t.value[0].constant),
             g->tan_alpha);
    return true;
}

/* Points of a secant, and h there. */
struct secant {
    mpfr_t x[2], h[2], step;
    mpfi_t value;
};

static void secant_init(struct secant *s)
{
    mpfr_inits2(PROOF_BITS, s->x[0], s->x[1], s->h[0], s->h[1], s->step, NULL);
    mpfi_init2(s->value, PROOF_BITS);
}

static void secant_free(struct secant *s)
{
    mpfr_clears(s->x[0], s->x[1], s->h[0], s->h[1], s->step, NULL);
    mpfi_clear(s->value);
}

/* Towards the root; nothing here needs to be right. */
static void approach(struct proof_law *p, struct given *g, struct secant *s,
                     long double near)
{
    mpfr_set_ld(s->x[0], near, MPFR_RNDN);
    mpfr_add_d(s->x[1], s->x[0], PROOF_SECANT, MPFR_RNDN);
    for (int i = 0; i < 2; i++)
        if (balance(p, g, s->x[i], s->value))
            mpfi_mid(s->h[i], s->value);
    for (int i = 0; i < PROOF_NEWTONS; i++) {
        mpfr_sub(s->step, s->h[1], s->h[0], MPFR_RNDN);
        if (mpfr_zero_p(s->step))
            break;
        mpfr_sub(s->x[0], s->x[1], s->x[0], MPFR_RNDN);
        mpfr_div(s->step, s->x[0], s->step, MPFR_RNDN);
        mpfr_mul(s->step, s->step, s->h[1], MPFR_RNDN);
        mpfr_set(s->x[0], s->x[1], MPFR_RNDN);
        mpfr_set(s->h[0], s->h[1], MPFR_RNDN);
        mpfr_sub(s->x[1], s->x[1], s->step, MPFR_RNDN);
        if (!mpfr_number_p(s->x[1]) || !balance(p, g, s->x[1], s->value))
            break;
        mpfi_mid(s->h[1], s->value);
    }
}

/* Whether h has the sign at x + r. */
static bool has_sign(struct proof_law *p, struct given *g, struct secant *s,
                     double r, int sign)
{
    mpfr_add_d(s->x[0], s->x[1], r, MPFR_RNDN);
    return balance(p, g, s->x[0], s->value) &&
           (sign > 0 ? mpfi_is_strictly_pos(s->value) > 0
                     : mpfi_is_strictly_neg(s->value) > 0);
}

/* h > 0 at x - r and < 0 at x + r, from a tiny r on: [x - r, x + r]. */
static bool bracket(struct proof_law *p, struct given *g, struct secant *s)
{
    if (!mpfr_number_p(s->x[1]))
        return false;
    for (double r = PROOF_PLACE_LEAST; r < PROOF_PLACE_MOST; r *= 256) {
        if (!has_sign(p, g, s, -r, 1) || !has_sign(p, g, s, r, -1))
            continue;
        mpfi_set_fr(g->x, s->x[1]);
        mpfi_interv_d(g->other, -r, r);
        mpfi_add(g->x, g->x, g->other);
        return true;
    }
    return false;
}

static enum status settle(struct proof_law *p, struct given *g,
                          const struct block *b, struct fault *why)
{
    struct secant s;

    secant_init(&s);
    approach(p, g, &s, b->x);
    const bool found = bracket(p, g, &s);
    secant_free(&s);
    if (!found) {
        snprintf(why->text, sizeof why->text,
                 "no sign change of mu_ss - tan(alpha) was found at the "
                 "saddle");
        return STATUS_BAD_ARGUMENT;
    }
    set_x(p, g->x);
    return interval_graph_run(&p->at, why);
}

/* ---- all ----------------------------------------------------------------- */

/* Room for graphs that are not kept, and what is needed of both. */
static enum status make_graphs(struct proof_law *p, const struct block *b)
{
    bool needed[FORMULA_NODES] = { false };

    p->room = malloc(sizeof *p->room);
    p->graph_room = malloc(sizeof *p->graph_room);
    if (p->room == NULL || p->graph_room == NULL)
        return STATUS_NO_MEMORY;
    p->lowered = law_tape_kept(&b->law, true, p->room);
    p->graph = law_graph_kept(&b->law, p->graph_room);
    memcpy(needed, p->lowered->t.needs, sizeof needed);
    for (int i = 0; i < 2; i++)
        needed[p->lowered->p.chart[i]] = needed[p->lowered->p.at[i]] = true;
    enum status s =
        interval_graph_init(&p->at, &p->lowered->f, needed, PROOF_BITS);
    memset(needed, 0, sizeof needed);
    p->psi_ss = p->graph->psi_ss;
    p->T = formula_find(&p->graph->f, "T", 1);
    if (p->psi_ss >= 0)
        needed[p->psi_ss] = true;
    if (p->T >= 0)
        needed[p->T] = true;
    if (s == STATUS_OK)
        s = interval_graph_init(&p->steady, &p->graph->f, needed, PROOF_BITS);
    return s;
}

/* mu_ss falls on one interval of v at most (docs/proofs.md, 14): there is a
 * node beyond it where friction at an end of the plane has a limit, as a ln v
 * then goes on. */
static void know_nodes(struct proof_law *p, const struct block *b)
{
    const bool plain = b->law.theta == THETA_PSI;
    const bool ends = b->law.theta == THETA_LN_PSI || b->material.c <= 0;

    p->node[0] = plain || !ends;
    p->node[1] = p->form != PSI_SS_INVERSE;
    if (p->form == PSI_SS_MINUS_LOG)
        p->node[0] = p->node[1] = plain ? 0 : -1;
    if (b->law.typed || p->form == PSI_SS_LAMBERT)
        p->node[0] = p->node[1] = -1;
}

static void know(struct proof_law *p, const struct block *b)
{
    const struct law *law = &b->law;

    p->is_log = law_psi_is_log(law);
    p->first_order = law->kinetics == KINETICS_LINEAR;
    p->form = law->psi_ss;
    know_nodes(p, b);
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
    const enum status s = settle(p, g, b, why);
    if (s != STATUS_OK)
        return s;
    read_saddle(p, g);
    return interval_tape_init(&p->tape, &p->lowered->t, &p->at, excess, 1, why);
}

/* What is not even tried; NULL: everything. */
static const char *refused(const struct block *b)
{
    if (!isfinite(b->material.R) && law_uses(&b->law, MATERIAL_R))
        return "R is infinite";
    if (b->law.typed)
        return "the law is typed as formulas";
    if (b->law.kinetics == KINETICS_COMPOSITE)
        return "the law is not of the form dpsi/dt = -K(psi - psi_ss)/T";
    return NULL;
}

enum status proof_law_at(struct proof_law *p, const struct block *b,
                         const struct proof_inputs *in, struct fault *why)
{
    struct given g;

    *p = (struct proof_law){ .psi_ss = -1, .T = -1 };
    if (refused(b)) {
        snprintf(why->text, sizeof why->text, "%s", refused(b));
        return STATUS_BAD_ARGUMENT;
    }
    enum status s = make_graphs(p, b);
    if (s != STATUS_OK)
        return s;
    know(p, b);
    mpfi_init2(g.tan_alpha, PROOF_BITS);
    mpfi_init2(g.eps2, PROOF_BITS);
    mpfi_init2(g.x, PROOF_BITS);
    mpfi_init2(g.y, PROOF_BITS);
    mpfi_init2(g.other, PROOF_BITS);
    s = make(p, b, in, &g, why);
    mpfi_clear(g.tan_alpha);
    mpfi_clear(g.eps2);
    mpfi_clear(g.x);
    mpfi_clear(g.y);
    mpfi_clear(g.other);
    return s;
}

void proof_law_free(struct proof_law *p)
{
    interval_tape_free(&p->tape);
    interval_graph_free(&p->at);
    interval_graph_free(&p->steady);
    free(p->room);
    free(p->graph_room);
    p->room = NULL;
    p->graph_room = NULL;
}

bool proof_law_steady(struct proof_law *p, struct interval x,
                      struct interval *psi_ss, struct interval *rate)
{
    struct fault why;
    mpfi_t X;

    if (p->psi_ss < 0 || p->T < 0 || !interval_is_finite(x))
        return false;
    mpfi_init2(X, PROOF_BITS);
    mpfi_interv_d(X, x.lo, x.hi);
    interval_graph_set(&p->steady, "lnv0", X);
    mpfi_clear(X);
    if (interval_graph_run(&p->steady, &why) != STATUS_OK)
        return false;
    *psi_ss = interval_graph_get(&p->steady, p->psi_ss);
    *rate = interval_divide(interval_point(1),
                            interval_graph_get(&p->steady, p->T));
    return interval_is_finite(*psi_ss) && interval_is_finite(*rate) &&
           rate->lo > 0;
}
