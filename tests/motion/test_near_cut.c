/* Runs from the separatrix itself. */
#include "near_cut.h"

#include "followed.h"
#include "labels.h"
#include "sample.h"

static struct transient run(const struct slope *s, double v, double psi)
{
    const struct transient_options o = transient_defaults(&s->scene);

    return follow(s, v, psi, &o);
}

/* The largest difference in the chart where the curve of `on` is, and that of
 * `by` at the same times, outside a disc about the saddle; what is left of the
 * way to it at the end. */
static double apart(const struct slope *s, const struct transient *on,
                    const struct transient *by, double *left)
{
    const struct vec2 saddle = s->study.slider.plane.system.origin;
    double most = 0, u[CURVE_DIM_MAX];

    for (size_t i = 0; i < on->curve.count; i++) {
        curve_at(&on->curve, i, 1, u);
        *left = hypot(u[0], u[1]);
        const struct trajectory_row row =
            sample_at_time(&s->study.slider, by, u[2]);
        if (*left > 0.05)
            most = fmax(most, hypot(log(row.v) - saddle.x - u[0],
                                    log(row.psi) - saddle.y - u[1]));
    }
    return most;
}

static void the_curve_is_what_both_sides_share(void **state)
{
    static const char *const law[] = { "spinodal_gen", "dieterich_gen" };

    (void) state;
    for (int i = 0; i < 4; i++) {
        struct slope s;
        struct labels l;
        struct fate_told told;
        double u[CURVE_DIM_MAX], left;
        slope_make(&s, law[i / 2], NULL, "0.34",
                   (const char *const[]){ "products=[knees]", NULL });
        const struct slider *sl = &s.study.slider;
        const struct vec2 saddle = sl->plane.system.origin;
        assert_int_equal(labels_init(&l, sl, 1e-13, NULL), STATUS_OK);
        const struct curve *c = &l.stable[i % 2].curve;
        curve_at(c, c->count / 2, 0, u);
        assert_int_equal(
            labels_find(&l, (struct vec2){ u[0], u[1] }, NULL, &told),
            STATUS_OK);
        assert_true(told.is_near);
        const double v = exp(saddle.x + u[0]), psi = exp(saddle.y + u[1]);
        struct transient on = run(&s, v, psi), a = run(&s, v * (1 + 1e-9), psi),
                         b = run(&s, v * (1 - 1e-9), psi);
        assert_int_equal(on.sum.end, TRANSIENT_NEAR);
        assert_false(quantity_exists(&on.sum.time));
        assert_int_not_equal(a.sum.fate, b.sum.fate);
        CHECK(on.curve.count > 10 && on.events > 0, "%zu", on.curve.count);
        const double off =
            fmax(apart(&s, &on, &a, &left), apart(&s, &on, &b, &left));
        CHECK(off < 1e-6, "%s %d: off by %g", law[i / 2], i % 2, off);
        CHECK(left < 0.05, "%s %d: ends at %g", law[i / 2], i % 2, left);
        transient_free(&on);
        transient_free(&a);
        transient_free(&b);
        labels_free(&l);
        slope_free(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_curve_is_what_both_sides_share),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
