/* Sides of the stable manifold, proved. */
#include "proof_side.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "law_typed.h"
#include "proof_fold.h"
#include "slope.h"

/* The side - 1: fast, -1: slow - on which a state is proved to be; 0: none. */
static int side_of(const struct proof *p, double v, double psi)
{
    struct proof_row row;

    assert_int_equal(proof_rows(p, &v, 1, &psi, 1, &row), STATUS_OK);
    return row.slow == 1 ? -1 : row.fast == 0 ? 1 : 0;
}

/* ---- the table ----------------------------------------------------------- */

static size_t proved;

static void check_row(struct slope *s, const struct csv *c)
{
    const int side = s->study.proof.exact
                         ? side_of(s->study.proof.exact, csv_number(c, "v0", 0),
                                   csv_number(c, "psi0", 0))
                         : 0;

    proved += side != 0;
    CHECK(side == 0 || (side > 0) == (row_fate(c) == FATE_SLIDING),
          "alpha %s id %s is on side %d, the table says %s",
          csv_text(c, "alpha"), csv_text(c, "id"), side, csv_text(c, "label"));
}

static void each_state_of_the_basin_table_is_on_its_side(void **state)
{
    static const char *const more[] = { "products=[equilibria, basins]",
                                        "basins.cells=[2, 2]", "basins.audit=0",
                                        "accuracy.proved=true", NULL };

    (void) state;
    const int rows = each_basin_row(0, more, check_row);
    print_message("# %zu of %d states\n", proved, rows);
    CHECK(proved == (size_t) rows - 106, "%zu of %d", proved, rows);
}

/* ---- beside the curve ---------------------------------------------------- */

static void run(struct slope *s, const char *law, const char *form,
                const char *alpha)
{
    static const char *const more[] = { "products=[equilibria, basins]",
                                        "basins.cells=[2, 2]",
                                        "basins.audit=0",
                                        "accuracy.proved=true",
                                        "window.v=[1e-200, 1e9]",
                                        NULL };

    slope_make(s, law, form, alpha, more);
}

/* So far from the curve along the row, of either sign. */
static double draw_gap(uint64_t *rng)
{
    const double far = pow(10, check_uniform(rng, -14, 1));

    return check_bits(rng) % 2 ? far : -far;
}

/* A state at the offset dy, and gap from where the computed curve crosses that
 * row, or from dx, in doubles: whether both agree; *told: whether both tell. */
static bool agrees(const struct slope *s, const struct proof *p, double dx,
                   double dy, double gap, bool *told)
{
    const struct slider *of = &s->study.slider;
    const struct labels *labels = &s->study.basins.labels;
    const struct separatrix *along = &labels->along[SEPARATRIX_Y];
    const struct vec2 o = of->plane.system.origin;
    struct crossing c[64];
    struct fate_told t;

    *told = false;
    assert_true(along->count < 64);
    const double at = separatrix_row(along, dy, c) > 0 ? c[0].at : dx;
    const double v = exp(o.x + at + gap);
    const double psi =
        of->plane.system.axis[1].is_log ? exp(o.y + dy) : o.y + dy;
    const int side = side_of(p, v, psi);
    assert_int_equal(
        labels_find(labels, block_offset(&of->block, v, psi), NULL, &t),
        STATUS_OK);
    *told = side != 0 && t.fate != FATE_UNDECIDED;
    return !*told || t.fate == (int8_t) fate_of_side(of, side < 0);
}

static void check_law(const char *law, const char *form, const char *alpha,
                      uint64_t *rng)
{
    enum { STATES = 300 };
    static struct slope s;
    size_t tell = 0;

    run(&s, law, form, alpha);
    const struct scene_window *w = &s.scene.window;
    const struct box b = {
        block_offset(&s.study.slider.block, w->v[0], w->psi[0]),
        block_offset(&s.study.slider.block, w->v[1], w->psi[1])
    };
    for (size_t i = 0; i < STATES; i++) {
        const double dx = check_uniform(rng, b.lo.x, b.hi.x);
        const double dy = check_uniform(rng, b.lo.y, b.hi.y);
        const double gap = draw_gap(rng);
        bool told;
        CHECK(agrees(&s, s.study.proof.exact, dx, dy, gap, &told),
              "%s %s: dy %.17g, gap %g", law, form, dy, gap);
        tell += told;
    }
    print_message("# %s %s at %s: %zu of %d states\n", law, form, alpha, tell,
                  STATES);
    CHECK(tell > STATES * 3 / 5, "%s %s: %zu of %d", law, form, tell, STATES);
    slope_free(&s);
}

static void states_beside_the_curve_are_on_the_side_that_is_computed(
    void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; law_preset_at(i); i++) {
        const struct law *law = law_preset_at(i);
        if (law->kinetics != KINETICS_COMPOSITE)
            check_law(law->preset, i % 2 ? "log" : "asinh",
                      i % 3 ? "0.34" : "0.3", &rng);
    }
}

/* ---- inside -------------------------------------------------------------- */

/* The side of a state that is a hundredth of Y above the middle of the cone or
 * of a cell. */
static int above(const struct slope *s, const struct proof_piece *p,
                 double theta)
{
    const double ind = p->start + p->step * theta;
    double dep = p->coef[p->degree];

    for (size_t k = p->degree; k-- > 0;)
        dep = p->coef[k] + theta * dep;
    const struct vec2 o = s->study.slider.plane.system.origin;
    return side_of(s->study.proof.exact, exp(o.x + (p->ind ? dep : ind)),
                   exp(o.y + 1.01 * (p->ind ? ind : dep)));
}

static void a_state_in_the_cone_or_the_tube_has_no_side(void **state)
{
    static struct slope s;

    (void) state;
    run(&s, "spinodal_gen", NULL, "0.34");
    struct proof_branch *b = &s.study.proof.exact->branch[0];
    const struct proof_piece *far = &b->piece[b->pieces / 2];
    assert_int_equal(above(&s, b->piece, b->cone.reach / 2), -1);
    b->cone.slope = 0.1;
    assert_int_equal(above(&s, b->piece, b->cone.reach / 2), 0);
    assert_int_equal(above(&s, far, 0.5), -1);
    for (size_t i = 0; i < b->cells; i++)
        b->cell[i].radius = 0.2;
    assert_int_equal(above(&s, far, 0.5), 0);
    slope_free(&s);
}

/* The lower branch of spinodal ends there. */
static void a_row_in_the_strip_where_v_vanishes_may_meet_the_branch(
    void **state)
{
    static struct slope s;

    (void) state;
    run(&s, "spinodal", NULL, "0.34");
    struct proof_branch *b = &s.study.proof.exact->branch[1];
    const struct proof_piece *p = &b->piece[b->pieces / 2];
    assert_int_equal(b->end, END_V_0);
    for (size_t i = 0; i < b->cells; i++)
        b->cell[i].radius = 3;
    b->strip = (struct interval){ 2 * b->strip.lo, 0 };
    assert_int_equal(above(&s, p, 0.5), 0);
    slope_free(&s);
}

/* ---- nodes --------------------------------------------------------------- */

static struct law composition(size_t i)
{
    struct law law = *law_preset_find("dieterich");

    law.preset = "composed";
    law.kinetics = (enum kinetics)(i % 2);
    law.timescale = (enum timescale)(i / 2 % TIMESCALES);
    law.psi_ss = (enum psi_ss)(i / (2 * TIMESCALES) % PSI_SS_LAMBERT);
    law.theta = (enum theta)(i / (2 * TIMESCALES * PSI_SS_LAMBERT) % THETAS);
    law.form = i / (2 * TIMESCALES * PSI_SS_LAMBERT * THETAS) % 2
                   ? FRICTION_LOG
                   : FRICTION_ASINH;
    return law;
}

static struct material draw_material(uint64_t *rng)
{
    struct material m = material_bristol_board();

    m.a = pow(10, check_uniform(rng, -2.5, -1));
    m.b = m.a * check_uniform(rng, 0.7, 3);
    m.c = check_bits(rng) % 3 ? pow(10, check_uniform(rng, -6, 0)) : 0;
    m.R = pow(10, check_uniform(rng, -1, 6));
    return m;
}

/* 1: the law has a saddle here. */
static int check_nodes(const struct law *law, const struct material *m,
                       double tan_alpha)
{
    static const struct branch none[2];
    const struct proof_inputs in = { .slope_in = ANGLE_TAN,
                                     .slope = tan_alpha };
    static struct slider s;
    struct proof p;
    struct fault why;

    if (law_check(law, m, &why) != STATUS_OK)
        return 0;
    slider_init(&s, law, m, (long double) tan_alpha);
    if (slider_saddle(&s) < 0)
        return 0;
    assert_int_equal(proof_along(&s.block, &in, none, &p), STATUS_OK);
    for (int side = -1; side < 2 && p.not_proved.text[0] == '\0'; side += 2) {
        const int node = proof_has_node(&p.law.law, m, side);
        const enum fate fate = fate_of_side(&s, side < 0);
        if (fate == FATE_UNDECIDED) /* the node is beyond 1e-300 */
            CHECK(node != 0, "%s", law->preset);
        else
            CHECK(node < 0 ||
                      node == (fate == FATE_CREEP || fate == FATE_SLIDING),
                  "%s %s %s a %g b %g c %g R %g tan_alpha %.17g: side %d, node "
                  "%d, "
                  "fate %s",
                  friction_form_names[law->form], theta_names[law->theta],
                  psi_ss_names[law->psi_ss], m->a, m->b, m->c, m->R, tan_alpha,
                  side, node, fate_names[fate]);
    }
    proof_free(&p);
    return 1;
}

static void nodes_are_where_theorem_14_says(void **state)
{
    enum { ALL = 2 * TIMESCALES * PSI_SS_LAMBERT * THETAS * FRICTION_FORMS };
    uint64_t rng = check_seed();
    int saddles = 0;

    (void) state;
    for (size_t i = 0; i < 8 * (size_t) ALL; i++) {
        const struct law law = composition(i % ALL);
        const struct material m = draw_material(&rng);
        saddles +=
            check_nodes(&law, &m, m.mu_star * check_uniform(&rng, 0.6, 1.4));
    }
    print_message("# %d saddles\n", saddles);
    CHECK(saddles > ALL, "%d", saddles);
}

static void of_a_law_of_formulas_nothing_is_said_of_nodes(void **state)
{
    const struct material m = material_bristol_board();
    static const struct law_typed formulas;
    struct law typed = *law_preset_find("spinodal_gen");

    (void) state;
    typed.typed = &formulas;
    for (int side = -1; side < 2; side += 2) {
        assert_int_equal(proof_has_node(&typed, &m, side), -1);
        assert_int_equal(
            proof_has_node(law_preset_find("kato_tullis"), &m, side), -1);
    }
}

/* ---- none ---------------------------------------------------------------- */

/* At a slope that is drawn, or just beside a fold. */
static double draw_slope(const struct law *law, const struct material *m,
                         uint64_t *rng)
{
    long double x[4];
    const size_t n = steady_extrema(law, m, x);
    const double away = pow(10, check_uniform(rng, -11, -1));

    if (n == 0 || check_bits(rng) % 3 == 0)
        return m->mu_star * check_uniform(rng, 0.6, 1.4);
    return (double) steady_mu(law, m, x[check_bits(rng) % n]) *
           (check_bits(rng) % 2 ? 1 + away : 1 - away);
}

/* Whether all states go where theorem 20 says; a node beyond 1e300 is not
 * found. */
static bool goes_so(const struct slider *s, const struct law *law,
                    const struct material *m, enum proof_alone said)
{
    const enum fate fate = fate_of_all(s);
    const bool rises = said == PROOF_ALONE_RISING;
    const int side = said == PROOF_ALONE_FAST ? 1 : -1;
    const bool node =
        rises ? proof_rises_through(law, m) : proof_has_node(law, m, side) == 1;

    if (fate == FATE_UNDECIDED || (rises && !node))
        return true;
    if (node)
        return s->plane.equilibria == 0 || (rises && fate == FATE_CREEP) ||
               fate == (side > 0 || rises ? FATE_SLIDING : FATE_CREEP);
    return side > 0 ? fate == FATE_RUNAWAY
                    : fate == FATE_REST_FINITE || fate == FATE_REST_ASYMPTOTIC;
}

static void that_there_is_no_saddle_is_proved_where_there_is_none(void **state)
{
    enum { ALL = 2 * TIMESCALES * PSI_SS_LAMBERT * THETAS * FRICTION_FORMS };
    uint64_t rng = check_seed();
    static struct slider s;
    int none = 0, proved_none = 0;
    struct fault why;

    (void) state;
    for (size_t i = 0; i < 20 * (size_t) ALL; i++) {
        const struct law law = composition(i % ALL);
        const struct material m = draw_material(&rng);
        const double tan_alpha = draw_slope(&law, &m, &rng);
        const struct proof_inputs in = { .decimal = true,
                                         .slope_in = ANGLE_TAN,
                                         .slope = tan_alpha };
        if (law_check(&law, &m, &why) != STATUS_OK || !(tan_alpha > 1e-3) ||
            law.psi_ss == PSI_SS_MINUS_LOG)
            continue;
        slider_init(&s, &law, &m, (long double) tan_alpha);
        double window[2];
        const enum proof_alone said = proof_no_saddle(&law, &m, &in, window);
        CHECK(!said || (slider_saddle(&s) < 0 && goes_so(&s, &law, &m, said)),
              "%s %s %s a %.17g b %.17g c %.17g R %.17g tan_alpha %.17g: %d, "
              "%s",
              friction_form_names[law.form], theta_names[law.theta],
              psi_ss_names[law.psi_ss], m.a, m.b, m.c, m.R, tan_alpha,
              (int) said, fate_names[fate_of_all(&s)]);
        none += slider_saddle(&s) < 0;
        proved_none += said != PROOF_ALONE_NOT;
    }
    print_message("# %d of %d\n", proved_none, none);
    CHECK(proved_none > 0.9 * none && none > ALL, "%d of %d", proved_none,
          none);
}

/* As v -> 0 or infinity tau is (a - b) ln v, but where psi_ss or theta(psi_ss)
 * is bounded. */
static void tau_rises_from_end_to_end_only_where_it_has_no_end(void **state)
{
    static const struct {
        enum theta theta;
        enum psi_ss psi_ss;
        double a, b;
        bool rises;
    } at[] = {
        { THETA_LN_PSI, PSI_SS_INVERSE, 0.25, 0.25, false },
        { THETA_LN_PSI, PSI_SS_INVERSE, 0.5, 0.25, true },
        { THETA_LN_C_PSI, PSI_SS_INVERSE, 0.25, 0.25, false },
        { THETA_LN_PSI, PSI_SS_SPINODAL, 0.25, 0.25, false },
        { THETA_LN_PSI, PSI_SS_SPINODAL, 0.5, 0.25, true },
        { THETA_LN_C_PSI, PSI_SS_SPINODAL, 0.25, 0.5, true },
        { THETA_PSI, PSI_SS_SPINODAL, 0.25, 0.5, true },
    };

    (void) state;
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        const struct law law = { .theta = at[i].theta, .psi_ss = at[i].psi_ss };
        struct material m = material_bristol_board();
        m.a = at[i].a;
        m.b = at[i].b;
        CHECK(proof_rises_through(&law, &m) == at[i].rises, "%zu", i);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tau_rises_from_end_to_end_only_where_it_has_no_end),
        cmocka_unit_test(each_state_of_the_basin_table_is_on_its_side),
        cmocka_unit_test(
            states_beside_the_curve_are_on_the_side_that_is_computed),
        cmocka_unit_test(a_state_in_the_cone_or_the_tube_has_no_side),
        cmocka_unit_test(
            a_row_in_the_strip_where_v_vanishes_may_meet_the_branch),
        cmocka_unit_test(nodes_are_where_theorem_14_says),
        cmocka_unit_test(of_a_law_of_formulas_nothing_is_said_of_nodes),
        cmocka_unit_test(that_there_is_no_saddle_is_proved_where_there_is_none),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
