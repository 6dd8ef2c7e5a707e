/* The laws of the literature in 113 bits, by another method. */
#include <stdlib.h>

#include "check.h"
#include "stress_truth.h"
#include "study.h"

static void held(const struct quantity *q, const struct stress_true *t,
                 const char *scene, const char *what)
{
    CHECK(quantity_exists(q) == t->exists, "%s: %s: %s", scene, what,
          q->reason ? q->reason : "is there");
    if (quantity_exists(q))
        CHECK(fabsq((quad) q->value - t->value) <= q->error + t->error,
              "%s: %s %.17g +- %g, not %.17g", scene, what, q->value, q->error,
              (double) t->value);
}

static void hold(const char *name)
{
    static struct study s;
    static struct stress_truth truth;
    struct scene scene;
    struct fault why;
    char path[4096];
    char only[] = "products=[knees]", *set[] = { only };

    snprintf(path, sizeof path, "%s/scenes/%s.yaml", getenv("SOURCE_ROOT"),
             name);
    CHECK(scene_read(&scene, path, set, 1, &why) == STATUS_OK, "%s", why.text);
    CHECK(study_run(&s, &scene, NULL, &why) == STATUS_OK, "%s", why.text);
    stress_truth_find(&scene.law, &scene.material, scene.tan_alpha, &truth);
    const struct critical_numbers *c = &s.slider.critical;
    const struct stress_true *t = truth.number;
    assert_true(truth.saddle);
    held(&s.saddle_numbers.v, &t[STRESS_V_SP], name, "saddle.v");
    held(&s.saddle_numbers.lambda_minus, &t[STRESS_LAMBDA_MINUS], name,
         "lambda_minus");
    held(&s.saddle_numbers.lambda_plus, &t[STRESS_LAMBDA_PLUS], name,
         "lambda_plus");
    held(&c->v_plus, &t[STRESS_V_PLUS], name, "v_plus");
    held(&c->v_minus, &t[STRESS_V_MINUS], name, "v_minus");
    held(&c->psi_at_v0, &t[STRESS_PSI_AT_V0], name, "psi_at_v0");
    held(&c->x_excess, &t[STRESS_X_EXCESS], name, "x_excess");
    held(&c->x_deficit, &t[STRESS_X_DEFICIT], name, "x_deficit");
    study_free(&s);
    scene_free(&scene);
}

static void laws_of_the_literature_hold_in_113_bits(void **state)
{
    static const char *const names[] = { "okubo",         "n_shaped",
                                         "bowden_tabor",  "prz",
                                         "flash_heating", "ageing_slip" };

    (void) state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        hold(names[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(laws_of_the_literature_hold_in_113_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
