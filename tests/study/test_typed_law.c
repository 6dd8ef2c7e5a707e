/* Laws that scenes write as formulas: presets give their numbers, others are
 * held to 113 bits, and what cannot be says so where it stands. */
#include <math.h>
#include <string.h>

#include "law_scenes.h"
#include "scene_law.h"
#include "study.h"

/* ---- presets ------------------------------------------------------------- */

static void same(const struct quantity *found, const struct quantity *exact,
                 const char *what, const char *law)
{
    CHECK(quantity_exists(found) == quantity_exists(exact), "%s: %s", law,
          what);
    if (!quantity_exists(found))
        return;
    const double off = fabs(found->value - exact->value);
    CHECK(off <= found->error + exact->error, "%s: %s %.17g, not %.17g", law,
          what, found->value, exact->value);
    CHECK(found->error <= 10 * exact->error + 4e-16 * fabs(exact->value),
          "%s: %s known to %g, not %g", law, what, found->error, exact->error);
}

static void compare(const struct study *found, const struct study *exact,
                    const char *law)
{
    const struct critical_numbers *f = &found->slider.critical,
                                  *e = &exact->slider.critical;

    same(&f->v_plus, &e->v_plus, "v_plus", law);
    same(&f->v_minus, &e->v_minus, "v_minus", law);
    same(&f->psi_at_v0, &e->psi_at_v0, "psi_at_v0", law);
    same(&f->x_excess, &e->x_excess, "x_excess", law);
    same(&f->x_deficit, &e->x_deficit, "x_deficit", law);
    same(&f->mu_s_num, &e->mu_s_num, "mu_s_num", law);
    same(&f->knee_upper.v, &e->knee_upper.v, "knee", law);
    assert_int_equal(found->slider.plane.equilibria,
                     exact->slider.plane.equilibria);
    for (size_t i = 0; i < exact->slider.plane.equilibria; i++) {
        const struct steady_number *s = &found->slider.steady[i],
                                   *t = &exact->slider.steady[i];
        assert_int_equal(s->type, t->type);
        same(&s->v, &t->v, "v_sp", law);
        same(&s->psi, &t->psi, "psi_sp", law);
    }
    same(&found->folds.alpha_cM, &exact->folds.alpha_cM, "alpha_cM", law);
    same(&found->folds.v_m, &exact->folds.v_m, "v_m", law);
}

static void presets_give_their_numbers(
    struct scene (*typed_as)(const struct law *law, const char *rest))
{
    static struct study found, exact;
    uint64_t seed = check_seed();

    for (int i = 0; i < 32; i++) {
        struct law law = *law_preset_at((size_t) i % 8);
        char rest[300];
        struct fault why;
        law.form = i / 8 % 2 ? FRICTION_LOG : FRICTION_ASINH;
        const double a = check_uniform(&seed, 0.02, 0.05),
                     b = a * check_uniform(&seed, 1.2, 1.6);
        const double tangent = check_uniform(&seed, 0.3, 0.4);
        sprintf(rest,
                "material: {a: %.6g, b: %.6g%s}\nslope: {tan_alpha: %.6g}\n"
                "products: [equilibria, folds, manifolds, knees]\n",
                a, b, i % 8 == 7 ? ", V_c: 3" : "", tangent);
        struct scene s = typed_as(&law, rest), t = by_name(&law, rest);
        assert_int_equal(study_run(&found, &s, NULL, &why), STATUS_OK);
        assert_int_equal(study_run(&exact, &t, NULL, &why), STATUS_OK);
        compare(&found, &exact, law.preset);
        study_free(&found);
        study_free(&exact);
        scene_free(&s);
        scene_free(&t);
    }
}

static void a_preset_as_formulas_gives_its_numbers(void **state)
{
    (void) state;
    presets_give_their_numbers(as_formulas);
}

static void a_preset_by_its_rate_alone_gives_its_numbers(void **state)
{
    (void) state;
    presets_give_their_numbers(as_rate);
}

/* ---- what no preset says ------------------------------------------------- */

/* theta = ln psi with a velocity cut-off under the state, v0 its own, and
 * names that the program uses within: the extrema of mu_ss where a/v = b/(v +
 * v0). */
#define LAW_OF_NAMES                                                           \
    "law: {theta: ln(psi), psi_ss: slip/v + work/v0,\n"                        \
    "      rate: v*(work/v0 + slip*lnv0/v - y0*psi)/(dv*dpsi*mu_log)}\n"
#define NAMES                                                                  \
    "material: {a: 0.03, b: 0.04, slip: 1, work: 1, lnv0: 1, y0: 1,"           \
    " dv: 2, dpsi: 0.25, mu_log: 2, "

static void a_law_with_names_of_its_own_has_its_folds(void **state)
{
    static struct study study;
    struct fault why;
    struct scene s = scene_made(
        LAW_OF_NAMES NAMES "v0: 50}\nslope: {alpha: 0.34}\nproducts: [folds]\n",
        "");

    (void) state;
    struct scene set = scene_made(
        LAW_OF_NAMES NAMES "v0: 7}\nslope: {alpha: 0.34}\nproducts: [folds]\n",
        "material.v0=50\n");
    assert_true(scene_same(&s, &set));
    scene_free(&set);
    assert_int_equal(s.typed->owns, 8);
    assert_int_equal(study_run(&study, &s, NULL, &why), STATUS_OK);
    /* b v0/(v + v0) = a at v = v0 (b - a)/a */
    const double v = 50 * (0.04 - 0.03) / 0.03;
    const struct quantity *found = &study.folds.v_m;
    CHECK(fabs(found->value - v) <= found->error + 1e-15 * v &&
              found->error < 1e-13 * v,
          "%.17g, not %.17g", found->value, v);
    study_free(&study);
    scene_free(&s);
}

/* ---- refusals ------------------------------------------------------------ */

static void what_is_wrong_is_said_where_it_stands(void **state)
{
    static const char *const cases[][2] = {
        { "law: {theta: ln(psi), psi_ss: 1/w, T: 1/v}\n",
          "s.yaml:1:31: law.psi_ss: line 1, column 3: unknown name w" },
        { "law: {theta: ln(psi), psi_ss: 1/v}\n",
          "s.yaml:1:6: law: T is missing" },
        { "law: {theta: ln(psi), rate: (psi - 1/v)*(psi - 9/v)*(99/v - psi)}\n",
          "s.yaml:1:29: law.rate: it is 0 at several psi at v" },
        { "law: {theta: ln(psi), rate: psi*v - 1}\n",
          "s.yaml:1:29: law.rate: psi leaves where it is 0 at v" },
        { "law: {theta: ln(psi), rate: v}\n",
          "s.yaml:1:29: law.rate: it is 0 at no psi" },
        { "law: {theta: ln(psi), rate: 1 - d}\n",
          "s.yaml:1:29: law.rate: line 1, column 5: unknown name d" },
        { "law: {theta: ln(psi), psi_ss: 1/v, T: abs(v)}\n",
          "s.yaml:1:39: law.T: line 1, column 1: abs is not analytic" },
        { "law: {theta: ln_psy, psi_ss: inverse, T: 1/v}\n",
          "law.theta: 'ln_psy' is not allowed" },
        { "law: {preset: ruina, T: 1/v}\n", "not beside law.preset" },
        { "law: {preset: ruina}\nmaterial: {v_0: 1}\n",
          "unknown key 'material.v_0'" },
        { "law: {theta: ln(psi), psi_ss: 1/v, T: 1/v}\nmaterial: {d: 1}\n",
          "material.d: expected a name of the law's own" },
        { "law: {theta: ln(psi), psi_ss: 1/v, T: 1/v}\nmaterial: {k: x}\n",
          "material.k: 'x' is not allowed, expected a number" },
        { "law: {theta: ln(psi), psi_ss: 1/v, T: 1/v}\nmaterial: {R: 3}\n",
          "material.R: not used by this law" },
    };

    (void) state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[400];
        struct scene s;
        struct fault why = { "" };
        sprintf(text, "%sslope: {alpha: 0.3}\n", cases[i][0]);
        assert_int_equal(scene_of(&s, text, "", &why), STATUS_BAD_SCENE);
        CHECK(strstr(why.text, cases[i][1]), "%zu: %s", i, why.text);
    }
}

#define IN_FOLDER(test)                                                        \
    cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(a_preset_as_formulas_gives_its_numbers),
        IN_FOLDER(a_preset_by_its_rate_alone_gives_its_numbers),
        IN_FOLDER(a_law_with_names_of_its_own_has_its_folds),
        IN_FOLDER(what_is_wrong_is_said_where_it_stands),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
