/* Slip, time and mean friction next to the saddle and to the separatrix, of
 * random laws, materials and slopes, against orbits in 113 bits: maps zoomed on
 * to the saddle, and single states.
 *
 * NEAR_STATES=2000 tries more than a test can afford; CHECK_SEED others. */
#include "cells_of.h"
#include "laws.h"
#include "push.h"
#include "quad_orbit.h"
#include "steady.h"

enum { EACH = 6, SIDE = 40, LOOKS = 6, NAME = 280 };

static const unsigned integrals =
    1u << CELL_SLIP | 1u << CELL_TIME | 1u << CELL_MU_MEAN;

static size_t states_asked(size_t usual)
{
    const char *asked = getenv("NEAR_STATES");
    return asked ? (size_t) strtoul(asked, NULL, 10) : usual;
}

/* ---- random saddles ------------------------------------------------------ */

static void name_slope(size_t i, const struct scene *s, char name[NAME])
{
    const struct law *l = &s->law;
    const struct material *m = &s->material;

    snprintf(name, NAME,
             "draw %zu: %s %s %s %s %s, mu %.9g a %.9g b %.9g c %.9g R %.9g L "
             "%.9g V "
             "%.9g alpha %.9g, rtol %g",
             i, friction_form_names[l->form], theta_names[l->theta],
             l->kinetics == KINETICS_COMPOSITE ? "kato_tullis"
                                               : psi_ss_names[l->psi_ss],
             timescale_names[l->timescale],
             l->kinetics == KINETICS_SINH ? "sinh" : "linear", m->mu_star, m->a,
             m->b, m->c, m->R, m->L, m->V_star, s->alpha, s->cell_rtol);
}

/* Every other one of a preset, and a material next to Table 2's. */
static bool draw_law(size_t i, uint64_t *rng, struct scene *s)
{
    static const char *const preset[] = { "spinodal_gen", "spinodal",
                                          "dieterich_gen", "spinodal_phi_gen" };
    struct fault why;

    if (i % 2 == 0)
        return laws_draw(check_bits(rng) % LAWS, rng, &s->law, &s->material);
    s->law = *law_preset_find(preset[i / 2 % 4]);
    s->law.form = (enum friction_form)(check_bits(rng) % FRICTION_FORMS);
    s->material = material_bristol_board();
    s->material.a *= check_uniform(rng, 0.6, 1.1);
    s->material.L *= laws_power(rng, -2, 2);
    s->material.c *= laws_power(rng, -1, 1);
    s->material.R *= laws_power(rng, -1, 1);
    return law_check(&s->law, &s->material, &why) == STATUS_OK;
}

static bool draw_slope(uint64_t *rng, struct scene *s)
{
    const long double x = (long double) check_uniform(rng, -12, 12);

    if (x >= steady_x_max(&s->law))
        return false;
    s->tan_alpha = steady_mu(&s->law, &s->material, x);
    s->alpha = (double) atanl(s->tan_alpha);
    s->cell_rtol = (const double[]){ 1e-4, 1e-6, 1e-9 }[check_bits(rng) % 3];
    return s->tan_alpha > 0.02L && s->tan_alpha < 5.0L;
}

/* Into `study`, the study of that slope, until there is a saddle beside which
 * blocks are arrested. */
static void draw(size_t i, uint64_t *rng, struct slope *s)
{
    struct fault why;

    for (int attempt = 0; attempt < 5000; attempt++) {
        slope_scene(&s->scene, "spinodal", NULL, "0.34", steady_only);
        if (draw_law(i, rng, &s->scene) && draw_slope(rng, &s->scene) &&
            study_run(&s->study, &s->scene, NULL, &why) == STATUS_OK) {
            if (slider_saddle(&s->study.slider) >= 0 &&
                slider_has_manifolds(&s->study.slider))
                return;
            study_free(&s->study);
        }
        scene_free(&s->scene);
    }
    fail_msg("no saddle");
}

/* ---- checks -------------------------------------------------------------- */

struct tally {
    size_t states, undecided, blurred, compared, lies;
    double worst, near;
};

/* Told of all, so that one run shows every kind. */
static void complain(struct tally *t, const char *name, struct vec2 z,
                     const char *what)
{
    if (t->lies++ < 40)
        print_message("# %s (%.17g, %.17g) at %.2g: %s\n", name, z.x, z.y,
                      t->near, what);
}

static void check_cell(const char *name, const struct quad_slope *q,
                       struct vec2 z, const struct cell *c, struct tally *t)
{
    struct quad_orbit o;
    char what[160];

    t->states++;
    t->undecided += c->exit_reason == FATE_UNDECIDED;
    if (c->exit_reason == FATE_UNDECIDED)
        return;
    quad_orbit_find(q, (quad) z.x, (quad) z.y, 1e-10, &o);
    t->blurred += o.fate == FATE_UNDECIDED;
    if (o.fate == FATE_UNDECIDED)
        return;
    if ((int) o.fate != c->exit_reason) {
        snprintf(what, sizeof what, "%s, not %s", fate_names[c->exit_reason],
                 fate_names[o.fate]);
        complain(t, name, z, what);
        return;
    }
    for (int k = 0; k < CELL_V_PEAK; k++) {
        const double told = value(c, (enum cell_field) k);
        const double bar = error(c, (enum cell_field) k);
        if (isnan(told) || isnan(o.error[k]))
            continue;
        const double off = fabs((double) ((quad) told - o.value[k]));
        t->worst = fmax(t->worst, off / (bar + o.error[k]));
        t->compared++;
        if (off <= bar + o.error[k])
            continue;
        snprintf(what, sizeof what, "%s %.16g +- %.3g, not %.16g +- %.3g, %.3g",
                 record_cell.fields[1 + 2 * k].name, told, bar,
                 (double) o.value[k], o.error[k], off / bar);
        complain(t, name, z, what);
    }
}

static void report(const char *what, const struct tally *t)
{
    print_message("# %s: %zu numbers of %zu states compared, the worst at %.2f "
                  "of its bar; %zu undecided, %zu by the orbit\n",
                  what, t->compared, t->states, t->worst, t->undecided,
                  t->blurred);
    CHECK(t->lies == 0, "%zu of %zu", t->lies, t->states);
    CHECK(t->compared > t->states, "%zu of %zu", t->compared, t->states);
}

/* ---- single states ------------------------------------------------------- */

/* At the saddle, or a random point of a stable branch, in the chart. */
static struct vec2 draw_place(const struct push *p, struct vec2 saddle,
                              uint64_t *rng)
{
    const struct branch *b = &p->labels.stable[check_bits(rng) % SIDES];
    double u[CURVE_DIM_MAX];

    if (check_bits(rng) % 2)
        return saddle;
    assert_true(b->curve.count > 0);
    curve_at(&b->curve, check_bits(rng) % b->curve.count,
             check_uniform(rng, 0, 1), u);
    return vec2_add(saddle, (struct vec2){ u[0], u[1] });
}

static void random_states_lie_within_their_bars(void **state)
{
    const size_t draws = states_asked(60) / EACH;
    static struct slope s;
    static struct push p;
    static struct quad_slope q;
    struct tally tally = { 0 };
    uint64_t rng = check_seed();
    struct fault why;
    char name[NAME];

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < draws; i++) {
        draw(i, &rng, &s);
        name_slope(i, &s.scene, name);
        if (push_init(&p, &s.scene, NULL, &why) == STATUS_OK) {
            assert_int_equal(push_tabulate(&p, NULL), STATUS_OK);
            quad_slope_init(&q, &s.study);
            for (int k = 0; k < EACH; k++) {
                struct vec2 z =
                    draw_place(&p, s.study.slider.plane.system.origin, &rng);
                const double d = tally.near = laws_power(&rng, -14, 0);
                struct cell c;
                z.x += d * check_uniform(&rng, -1, 1);
                z.y += d * check_uniform(&rng, -1, 1);
                if (!box_holds(s.study.slider.plane.system.domain, z))
                    continue;
                assert_int_equal(fast_cells_find(&p.fast, &z, 1,
                                                 s.scene.cell_rtol, integrals,
                                                 NULL, &c, NULL),
                                 STATUS_OK);
                check_cell(name, &q, z, &c, &tally);
            }
            push_free(&p);
        }
        slope_free(&s);
    }
    report("states", &tally);
}

/* ---- maps ---------------------------------------------------------------- */

/* A map around the saddle, of this relative half-width. */
static void make_map(struct slope *s, const char *law, const char *form,
                     const char *alpha, double wide, double rtol)
{
    char grid[80], v[80], psi[80];
    const char *const more[] = { "products=[slip, time, friction]", grid, v,
                                 psi, NULL };
    struct slope at;

    slope_make(&at, law, form, alpha, steady_only);
    const struct vec2 o = at.study.slider.plane.system.origin;
    snprintf(grid, sizeof grid, "basins={cells: [%d, %d], audit: 0, rtol: %g}",
             SIDE, SIDE, rtol);
    snprintf(v, sizeof v, "window.v=[%.17g, %.17g]", exp(o.x) * (1.0 - wide),
             exp(o.x) * (1.0 + wide));
    snprintf(psi, sizeof psi, "window.psi=[%.17g, %.17g]",
             exp(o.y) * (1.0 - wide), exp(o.y) * (1.0 + wide));
    slope_free(&at);
    slope_make(s, law, form, alpha, more);
}

static void check_map(struct slope *s, const char *law, double wide,
                      uint64_t *rng, struct tally *t)
{
    static struct cell c[SIDE * SIDE];
    static struct quad_slope q;
    const struct basin_map *m = &s->study.basins;
    char name[NAME];

    quad_slope_init(&q, &s->study);
    snprintf(name, sizeof name, "%s %s at %g, rtol %g", law,
             friction_form_names[s->scene.law.form], s->scene.alpha,
             s->scene.cell_rtol);
    t->near = wide;
    assert_int_equal(fields_find(&s->study.fields, 0, SIDE, NULL, c),
                     STATUS_OK);
    for (int k = 0; k < LOOKS; k++) {
        const size_t at = check_bits(rng) % (SIDE * SIDE);
        const struct vec2 z = { m->x[at % SIDE], m->y[at / SIDE] };
        check_cell(name, &q, z, &c[at], t);
    }
}

static void maps_zoomed_on_to_the_saddle_are_right(void **state)
{
    static const struct {
        const char *law, *form, *alpha;
    } of[] = { { "spinodal_gen", "asinh", "0.34" },
               { "spinodal", "log", "0.30" },
               { "spinodal_phi_gen", "asinh", "0.36" },
               { "dieterich_gen", "log", "0.34" } };
    static const double rtol[] = { 1e-4, 1e-6, 1e-9 };
    const size_t maps = states_asked(48) / LOOKS;
    static struct slope s;
    struct tally tally = { 0 };
    uint64_t rng = check_seed();

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < maps; i++) {
        const double wide = laws_power(&rng, -12, -2);
        make_map(&s, of[i % 4].law, of[i % 4].form, of[i % 4].alpha, wide,
                 rtol[check_bits(&rng) % 3]);
        check_map(&s, of[i % 4].law, wide, &rng, &tally);
        slope_free(&s);
    }
    report("maps", &tally);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_states_lie_within_their_bars),
        cmocka_unit_test(maps_zoomed_on_to_the_saddle_are_right),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
