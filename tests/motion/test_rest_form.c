/* How blocks stop: by the law alone, and as orbits show it. */
#include "rest_form.h"

#include "law_typed.h"
#include "laws.h"
#include "slider.h"
#include "slope.h"

static const char *const steady_only[] = { "products=[equilibria]", NULL };

static struct rest_form form_of(enum theta theta, enum psi_ss psi_ss,
                                enum timescale timescale,
                                enum kinetics kinetics)
{
    const struct law law = { .theta = theta,
                             .psi_ss = psi_ss,
                             .timescale = timescale,
                             .kinetics = kinetics };
    const struct material m = material_bristol_board();

    return rest_form_of(&law, &m);
}

static enum fate preset_fate(const char *name)
{
    const struct material m = material_bristol_board();

    return rest_form_of(law_preset_find(name), &m).fate;
}

static void the_papers_laws_rest_as_it_says(void **state)
{
    (void) state;
    assert_int_equal(preset_fate("dieterich_gen"), FATE_REST_FINITE);
    assert_int_equal(preset_fate("dieterich"), FATE_REST_ASYMPTOTIC);
    assert_int_equal(preset_fate("perrin"), FATE_REST_ASYMPTOTIC);
    assert_int_equal(preset_fate("ruina"), FATE_REST_ASYMPTOTIC);
    assert_int_equal(preset_fate("kato_tullis"), FATE_REST_ASYMPTOTIC);
    assert_int_equal(preset_fate("spinodal"), FATE_CREEP);
    assert_int_equal(preset_fate("spinodal_gen"), FATE_CREEP);
    assert_int_equal(preset_fate("spinodal_phi_gen"), FATE_CREEP);
}

/* The quasi-static block: v = v(psi) at mu = tan(alpha), log form; x = ln v. */
struct drive {
    struct law law;
    struct material m;
    double x0; /* ln v at theta = 0 */
};

static double theta_of(const struct drive *d, double x)
{
    return (d->x0 - x) * d->m.a / d->m.b;
}

/* ln(-dx/dt), far down. */
static double log_rate(const struct drive *d, double x)
{
    const double theta = theta_of(d, x), ratio = d->m.b / d->m.a;
    const bool is_log = d->law.psi_ss == PSI_SS_MINUS_LOG;
    const bool plain = d->law.theta == THETA_PSI;
    const double psi = plain ? theta : exp(theta);
    const double gap = (is_log ? -x : exp(-x)) - psi;
    double rate = log(ratio) - (plain ? 0.0 : theta);

    rate += d->law.kinetics == KINETICS_SINH && gap > 30.0 ? gap - log(2.0)
            : d->law.kinetics == KINETICS_SINH             ? log(sinh(gap))
                                                           : log(gap);
    if (d->law.timescale == TIMESCALE_SPINODAL)
        return rate - log(d->m.R);
    if (d->law.timescale == TIMESCALE_SLIP45)
        return rate - log(d->m.R) - (is_log ? -x : exp(-x));
    return rate + x -
           (d->law.timescale == TIMESCALE_AGEING44 ? log(d->m.R) : 0.0);
}

/* The time still to come is a sum of pieces dx/rate.  It is finite if and only
 * if the pieces fall off like a power of v; those of double exponentials, of
 * logarithms and of powers t^-q do not. */
static bool sum_is_finite(const struct drive *d)
{
    return log_rate(d, -600.0) - log_rate(d, -300.0) > 30.0;
}

static void rests_are_finite_where_their_time_is(void **state)
{
    struct fault why;
    size_t finite = 0, slow = 0;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        struct drive d = { laws_at(i), material_bristol_board(), -5.0 };
        if (d.law.kinetics == KINETICS_COMPOSITE ||
            law_check(&d.law, &d.m, &why) != STATUS_OK)
            continue;
        const struct rest_form form = rest_form_of(&d.law, &d.m);
        if (form.fate == FATE_CREEP)
            continue;
        CHECK((form.fate == FATE_REST_FINITE) == sum_is_finite(&d),
              "%s, %s, %s, kinetics %d: %s", theta_names[d.law.theta],
              psi_ss_names[d.law.psi_ss], timescale_names[d.law.timescale],
              (int) d.law.kinetics, fate_names[form.fate]);
        finite += form.fate == FATE_REST_FINITE;
        slow += form.fate == FATE_REST_ASYMPTOTIC;
    }
    CHECK(finite >= 20 && slow >= 20, "%zu, %zu", finite, slow);
}

/* d ln(rate)/dx -> -1/power. */
static void the_power_is_that_of_the_time_left(void **state)
{
    const struct material m = material_bristol_board();
    const struct law laws[] = {
        { .theta = THETA_LN_PSI, .timescale = TIMESCALE_SPINODAL },
        { .theta = THETA_PSI, .timescale = TIMESCALE_SPINODAL },
        { .theta = THETA_PSI,
          .psi_ss = PSI_SS_MINUS_LOG,
          .timescale = TIMESCALE_SPINODAL,
          .kinetics = KINETICS_SINH },
    };

    (void) state;
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        const struct drive d = { laws[i], m, -5.0 };
        const double slope =
            (log_rate(&d, -500.0) - log_rate(&d, -600.0)) / 100;
        const double power = rest_form_of(&d.law, &d.m).power;
        CHECK(fabs(slope * power + 1.0) < 1e-12, "%g, %g", slope, power);
    }
}

/* Compositions typed as formulas are asked, and answer as they are known to. */
static void formulas_tell_what_compositions_are_known_to_do(void **state)
{
    static struct law_typed typed;
    static struct slider s;
    size_t told = 0, unknown = 0, finite = 0, inertial = 0;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        struct law law = laws_at(i);
        struct material m = material_bristol_board();
        enum law_part wrong;
        struct fault why;
        if (law_check(&law, &m, &why) != STATUS_OK)
            continue;
        law_typed_of_preset(&law, &typed);
        assert_int_equal(law_typed_make(&typed, &wrong, &why), STATUS_OK);
        const struct law text = law_of_typed(&typed);
        slider_init(&s, &text, &m, 0.35L);
        const struct rest_form form = rest_form_at(&s.block),
                               known = rest_form_of(&law, &m);
        unknown += form.fate == FATE_UNDECIDED;
        if (form.fate == FATE_UNDECIDED)
            continue;
        CHECK(
            form.fate == known.fate && form.inertial == known.inertial &&
                (known.fate == FATE_CREEP || form.has_slip == known.has_slip) &&
                fabs(form.power - known.power) < 1e-3 * known.power,
            "%s, %s, %s, kinetics %d: %s, not %s; power %g, not %g; slip %d",
            theta_names[law.theta], psi_ss_names[law.psi_ss],
            timescale_names[law.timescale], (int) law.kinetics,
            fate_names[form.fate], fate_names[known.fate], form.power,
            known.power, (int) form.has_slip);
        told++;
        finite += form.fate == FATE_REST_FINITE;
        inertial += form.inertial;
    }
    CHECK(unknown == 0 && told > 200 && finite >= 20 && inertial >= 20,
          "%zu told, %zu unknown, %zu finite, %zu by inertia", told, unknown,
          finite, inertial);
}

static void a_law_without_ageing_at_rest_creeps(void **state)
{
    struct law law = *law_preset_find("dieterich");
    struct material m = material_bristol_board();

    (void) state;
    m.b = 0.5 * m.a;
    assert_int_equal(rest_form_of(&law, &m).fate, FATE_CREEP);
    assert_int_equal(
        form_of(THETA_LN_PSI, PSI_SS_MINUS_LOG, TIMESCALE_SLIP, KINETICS_SINH)
            .fate,
        FATE_CREEP);
    law = *law_preset_find("spinodal");
    m = material_bristol_board();
    m.R = HUGE_VAL;
    assert_int_equal(rest_form_of(&law, &m).fate, FATE_REST_ASYMPTOTIC);
}

/* A law of theta = psi, at a slope with a saddle. */
static void slope_composed(struct slope *s, enum psi_ss psi_ss,
                           enum timescale timescale, enum kinetics kinetics)
{
    struct fault why;

    slope_scene(&s->scene, "perrin", NULL, "0.42", steady_only);
    s->scene.law.psi_ss = psi_ss;
    s->scene.law.timescale = timescale;
    s->scene.law.kinetics = kinetics;
    assert_int_equal(study_run(&s->study, &s->scene, NULL, &why), STATUS_OK);
}

/* Of a state in the quadrant of the saddle where blocks stop, and of one that
 * comes there. */
static void hold_fate(const struct slope *s, double rtol, enum fate fate)
{
    static const struct vec2 from[] = { { -1.0, 0.5 }, { 0.2, 3.0 } };
    struct fate_result r;

    for (int i = 0; i < 3; i++) {
        const struct vec2 z =
            vec2_add(s->study.slider.plane.system.origin, from[i / 2]);
        const bool observe = i == 1 && rtol > 1e-4;
        assert_int_equal(
            fate_find(&s->study.slider, z, rtol, observe, NULL, &r), STATUS_OK);
        CHECK(r.fate == fate, "psi_ss %d, T %d, K %d, rtol %g: %s",
              (int) s->scene.law.psi_ss, (int) s->scene.law.timescale,
              (int) s->scene.law.kinetics, rtol, fate_names[r.fate]);
    }
}

/* v ~ e^(-e^(kt)) leaves the doubles soon, and yet not in a finite time. */
static void fates_of_rest_do_not_depend_on_the_tolerance(void **state)
{
    static const struct {
        enum psi_ss psi_ss;
        enum timescale timescale;
        enum kinetics kinetics;
        enum fate fate;
    } is[] = {
        { PSI_SS_MINUS_LOG, TIMESCALE_SPINODAL, KINETICS_LINEAR,
          FATE_REST_ASYMPTOTIC },
        { PSI_SS_MINUS_LOG, TIMESCALE_SPINODAL, KINETICS_SINH,
          FATE_REST_FINITE },
        { PSI_SS_MINUS_LOG, TIMESCALE_SLIP, KINETICS_SINH,
          FATE_REST_ASYMPTOTIC },
        { PSI_SS_INVERSE, TIMESCALE_SLIP45, KINETICS_SINH,
          FATE_REST_ASYMPTOTIC },
        { PSI_SS_INVERSE, TIMESCALE_SLIP, KINETICS_LINEAR,
          FATE_REST_ASYMPTOTIC },
        { PSI_SS_INVERSE, TIMESCALE_SPINODAL, KINETICS_LINEAR,
          FATE_REST_FINITE },
    };

    (void) state;
    for (size_t i = 0; i < sizeof is / sizeof *is; i++) {
        struct slope s;
        slope_composed(&s, is[i].psi_ss, is[i].timescale, is[i].kinetics);
        assert_int_equal(slider_saddle(&s.study.slider), 0);
        for (double rtol = 1e-3; rtol > 1e-8; rtol *= 0.01)
            hold_fate(&s, rtol, is[i].fate);
        slope_free(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_papers_laws_rest_as_it_says),
        cmocka_unit_test(rests_are_finite_where_their_time_is),
        cmocka_unit_test(the_power_is_that_of_the_time_left),
        cmocka_unit_test(formulas_tell_what_compositions_are_known_to_do),
        cmocka_unit_test(a_law_without_ageing_at_rest_creeps),
        cmocka_unit_test(fates_of_rest_do_not_depend_on_the_tolerance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
