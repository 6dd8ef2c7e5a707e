/* Bars where they are hardest to tell: at kinks of friction, and where numbers
 * lied once. */
#include "stress_run.h"

#include <math.h>

#include "check.h"
#include "laws.h"

/* ---- bars at kinks ------------------------------------------------------- */

enum { KINK_SETTINGS = 12, KINK_TEXT = 96 };

/* The study of a scene of these settings. */
static void open_scene(const char *const settings[], const char *rtol,
                       const char *products, struct scene *scene,
                       struct study *study)
{
    static char text[KINK_SETTINGS + 2][KINK_TEXT];
    char *set[KINK_SETTINGS + 2];
    struct fault why;
    size_t n = 0;

    for (; settings[n]; n++)
        snprintf(text[n], KINK_TEXT, "%s", settings[n]);
    snprintf(text[n++], KINK_TEXT, "products=%s", products);
    snprintf(text[n++], KINK_TEXT, "accuracy.rtol=%s", rtol);
    for (size_t i = 0; i < n; i++)
        set[i] = text[i];
    assert_int_equal(scene_read(scene, NULL, set, n, &why), STATUS_OK);
    assert_int_equal(study_run(study, scene, NULL, &why), STATUS_OK);
}

/* What it has for a number. */
static struct quantity number_at(const char *const settings[], const char *rtol,
                                 enum stress_number which)
{
    static struct scene scene;
    static struct study study;

    open_scene(settings, rtol, "[knees]", &scene, &study);
    const struct stress_answer answer = stress_answer_of(&study);
    const struct quantity q = *stress_answer_number(&answer, which);
    study_free(&study);
    scene_free(&scene);
    return q;
}

/* Where b is a hundred times a, friction turns within a hundredth of a unit:
 * between the end of the last step and the first node of a tail, or within one
 * step.  And a step may be long because its last terms are small by chance. */
static void no_kink_hides_from_a_bar(void **state)
{
    static const struct {
        enum stress_number which;
        const char *rtol, *settings[KINK_SETTINGS];
    } kink[] = {
        { STRESS_V_MINUS,
          "1e-13",
          { "law.preset=dieterich_gen", "law.friction=asinh",
            "material.a=7.375516645478843e-05",
            "material.b=0.020745637028719306",
            "slope.alpha=0.34000000000000002" } },
        { STRESS_V_MINUS,
          "1e-11",
          { "law.theta=ln_psi", "law.psi_ss=inverse", "law.timescale=slip",
            "law.kinetics=linear", "law.friction=asinh",
            "material.a=8.8596888343597647e-05",
            "material.b=0.016787612552075861",
            "slope.alpha=0.23815290087523111" } },
        { STRESS_V_MINUS,
          "1e-05",
          { "law.theta=psi", "law.psi_ss=inverse", "law.timescale=ageing44",
            "law.kinetics=sinh", "law.friction=asinh",
            "material.a=0.00091335588937596201",
            "material.b=0.033127089443671126", "material.R=0.17628789392797181",
            "material.L=2.200316809973165e-12", "gravity=319.49663347901463",
            "slope.alpha=0.35718607351081616" } },
        { STRESS_V_MINUS,
          "1e-09",
          { "law.preset=spinodal_gen", "law.friction=asinh",
            "material.a=0.0024542827409434111", "material.b=2.2761097394592613",
            "slope.alpha=1.4298642533090924" } },
        { STRESS_X_EXCESS,
          "1e-13",
          { "law.theta=ln_psi", "law.psi_ss=spinodal", "law.timescale=slip",
            "law.kinetics=sinh", "law.friction=log",
            "material.a=0.0040189215088908608",
            "material.b=0.0054047068631602798",
            "slope.alpha=0.2129675147363243" } },
    };

    (void) state;
    for (size_t i = 0; i < sizeof kink / sizeof *kink; i++) {
        const struct quantity fine =
            number_at(kink[i].settings, "1e-14", kink[i].which);
        const struct quantity q =
            number_at(kink[i].settings, kink[i].rtol, kink[i].which);
        const double off = fabs(q.value - fine.value);
        CHECK(off <= q.error + fine.error, "%zu: off by %.3g, bar %.3g", i, off,
              q.error);
    }
}

/* Found by chance: rates that go like e^-psi beside a fold; an x_excess that is
 * all bar, by which mu_s_num divides; psi of 1e-460, which is 0 in a double. */
static void what_lied_once_lies_no_more(void **state)
{
    static const char *const lied[][KINK_SETTINGS] = {
        { "law.theta=psi", "law.psi_ss=inverse", "law.timescale=slip45",
          "law.kinetics=linear", "law.friction=asinh",
          "material.a=0.0017974407231734733",
          "material.b=0.0017978147098202555", "gravity=0.0091398509213951162",
          "slope.alpha=0.58197308229160094" },
        { "law.preset=spinodal_gen", "law.friction=asinh",
          "material.a=0.00012123394351807162",
          "material.b=0.00025641290192999903",
          "material.c=2.6037778584814112e-09", "material.R=inf",
          "slope.alpha=0.38006806691045708" },
        { "law.theta=ln_psi", "law.psi_ss=minus_log", "law.timescale=spinodal",
          "law.kinetics=linear", "law.friction=asinh",
          "material.a=4.3548023343256409e-05",
          "material.b=4.3548842005610916e-05",
          "material.L=0.00079898988902554974",
          "slope.alpha=0.31266201933586352" },
        { "law.theta=psi", "law.psi_ss=inverse", "law.timescale=slip45",
          "law.kinetics=linear", "law.friction=asinh",
          "material.a=0.96647811098147263", "material.b=0.96684252231139045",
          "material.R=0.67911708118682379", "slope.alpha=1.5673706288719083" },
    };

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < sizeof lied / sizeof *lied; i++) {
        static struct scene scene;
        static struct study study;
        static struct stress_truth truth;
        open_scene(lied[i], "1e-14", "[equilibria, knees, sensitivities]",
                   &scene, &study);
        stress_truth_find(&scene.law, &scene.material, scene.tan_alpha, &truth);
        const struct stress_answer answer = stress_answer_of(&study);
        struct stress_row v = { .agree = -1 };
        stress_judge(&truth, &answer, &v);
        CHECK(v.outcome != STRESS_LIE || !slider_has_manifolds(&study.slider),
              "%zu: %s %s", i, v.reason, v.worst ? v.worst : "");
        CHECK(answer.has_saddle, "%zu", i);
        study_free(&study);
        scene_free(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_kink_hides_from_a_bar),
        cmocka_unit_test(what_lied_once_lies_no_more),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
