/* What is left of time and slip on the way to rest: closed forms without
 * inertia, the orbit itself with it, and whole motions in 113 bits. */
#include "rest_left.h"

#include "laws.h"
#include "push.h"
#include "quasistatic.h"
#include "rest_form.h"
#include "rest_lag.h"
#include "slope.h"
#include "transient.h"

static const char *const steady_only[] = { "products=[equilibria]", NULL };

/* ---- closed forms -------------------------------------------------------- */

/* Where the slower of v and psi is by itself: u is ln(psi_ss/psi), psi_ss - psi
 * where psi is a logarithm, k what it grows by with y. */
struct form {
    const char *law[4]; /* theta, psi_ss, timescale, kinetics */
    bool is_sinh, is_time;
};

/* int dy/(e^(ku) - 1), int dy/sinh(ku). */
static double sum_of(bool is_sinh, double k, double u)
{
    return is_sinh ? -log(tanh(0.5 * u)) / k : -log1p(-exp(-u)) / k;
}

static void slope_composed(struct slope *s, const char *const law[4],
                           const char *const more[])
{
    static const char *const key[] = { "theta", "psi_ss", "timescale",
                                       "kinetics" };
    char text[12][160], *set[12];
    size_t n = 0;
    struct fault why;

    for (int i = 0; i < 4; i++)
        snprintf(text[n++], sizeof text[0], "law.%s=%s", key[i], law[i]);
    for (int i = 0; more[i]; i++)
        snprintf(text[n++], sizeof text[0], "%s", more[i]);
    for (size_t i = 0; i < n; i++)
        set[i] = text[i];
    enum status status = scene_read(&s->scene, NULL, set, n, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
    s->scene.products = 1u << PRODUCT_EQUILIBRIA;
    status = study_run(&s->study, &s->scene, NULL, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
}

static void without_inertia_it_is_a_closed_form(void **state)
{
    static const struct form form[] = {
        { { "ln_psi", "inverse", "slip", "linear" }, false, false },
        { { "psi", "minus_log", "slip", "sinh" }, true, false },
        { { "ln_psi", "inverse", "spinodal", "linear" }, false, true },
        { { "psi", "minus_log", "spinodal", "sinh" }, true, true },
    };
    static const char *const b[] = { "0.0489", "0.0352", "0.03491" };
    uint64_t rng = check_seed();

    (void) state;
    for (int i = 0; i < 12; i++) {
        const struct form *f = &form[i / 3];
        char set_b[64];
        snprintf(set_b, sizeof set_b, "material.b=%s", b[i % 3]);
        const char *const more[] = { "material.V_star=1e-14",
                                     "slope.tan_alpha=0.369", set_b,
                                     f->is_time ? "material.R=1e-6" : NULL,
                                     NULL };
        struct slope s;
        slope_composed(&s, f->law, more);
        const struct material *m = &s.scene.material;
        const double k = m->b / m->a - 1.0;
        for (int n = 0; n < 6; n++) {
            double slope;
            const double y = fmin(check_uniform(&rng, 0.1, 3.0) / k,
                                  check_uniform(&rng, 100.0, 400.0));
            const double x = quasistatic_x(&s.study.slider.block, y, &slope);
            const struct vec2 z = { x, y };
            struct rest_left r;
            assert_true(rest_left_find(&s.study.slider, z, 0.0, &r));
            const double unit = f->is_time ? m->R : 1.0;
            const double is = unit * sum_of(f->is_sinh, k, -x - y);
            const double got = f->is_time ? r.time : r.slip;
            const double bar = f->is_time ? r.time_error : r.slip_error;
            const double u = -x - y, rounding = 1e-15 * (y - x) * (1 + 1 / u);
            const double slow =
                f->is_time ? m->R * exp(x + s.study.slider.block.at.x0) : 0.0;
            CHECK(fabs(got - is) <= bar + (rounding + slow) * is,
                  "form %d, b %s, y %g: %.16g +- %g, not %.16g", i / 3,
                  b[i % 3], y, got, bar, is);
            CHECK(bar < 1e-9 * is, "%g of %g", bar, is);
        }
        slope_free(&s);
    }
}

/* ---- orbits -------------------------------------------------------------- */

/* Draws a slope with a saddle below which blocks rest. */
static bool draw(size_t i, uint64_t *rng, struct slope *s)
{
    struct fault why;

    slope_scene(&s->scene, "dieterich", NULL, "0.34", steady_only);
    struct scene *c = &s->scene;
    if (!laws_draw(i, rng, &c->law, &c->material))
        return false;
    const long double x = (long double) check_uniform(rng, -6.0, 6.0);
    if (rest_form_of(&c->law, &c->material).fate == FATE_CREEP ||
        x >= steady_x_max(&c->law))
        return false;
    const double mu = (double) steady_mu(&c->law, &c->material, x);
    c->alpha = atan(mu);
    c->tan_alpha = (long double) mu;
    return mu > 0.05 && mu < 2.0 &&
           study_run(&s->study, c, NULL, &why) == STATUS_OK;
}

/* Follows an orbit until v has fallen by e^fall and what is left is known;
 * false where that does not happen. */
static bool follow(const struct slider *t, struct vec2 z, double fall,
                   struct orbit *o, struct rest_left *left)
{
    struct orbit_options options =
        orbit_defaults(&t->plane.system, t->plane.fastest_rate);

    options.rtol = 1e-12;
    options.observables = 1;
    options.max_steps = 3000;
    bool goes_on = orbit_init(o, &t->plane.system, z, &options) == STATUS_OK;
    while (goes_on) {
        const struct vec2 at = { o->u[0], o->u[1] };
        if (at.x < z.x - fall && rest_left_find(t, at, o->u[2], left))
            return true;
        goes_on = orbit_step(o) == STATUS_OK && o->end == ORBIT_RUNNING;
    }
    return false;
}

/* What goes by on an orbit is what is gone of what is left. */
static bool check_orbit(size_t i, const struct slope *s, struct vec2 z)
{
    const struct slider *t = &s->study.slider;
    struct orbit o, p = { .steps = 0 };
    struct rest_left a, b;

    bool is_known = follow(t, z, -HUGE_VAL, &o, &a);
    const struct vec2 from = { o.u[0], o.u[1] };
    is_known = is_known && isfinite(a.slip) && follow(t, from, 3.0, &p, &b);
    if (is_known) {
        const double slip = p.u[3] + b.slip, time = p.u[2] + b.time;
        CHECK(fabs(a.slip - slip) <=
                  a.slip_error + b.slip_error + 1e-10 * a.slip,
              "law %zu, (%g, %g): slip %.16g +- %g, not %.16g", i, from.x,
              from.y, a.slip, a.slip_error, slip);
        CHECK(isinf(a.time) || fabs(a.time - time) <=
                                   a.time_error + b.time_error + 1e-10 * a.time,
              "law %zu, (%g, %g): time %.16g +- %g, not %.16g", i, from.x,
              from.y, a.time, a.time_error, time);
    }
    orbit_free(&o);
    orbit_free(&p);
    return is_known;
}

static void orbits_take_what_is_gone_of_it(void **state)
{
    uint64_t rng = check_seed();
    int tried = 0;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        struct slope s;
        if (!draw(i, &rng, &s)) {
            scene_free(&s.scene);
            continue;
        }
        const struct vec2 z = { check_uniform(&rng, -4.0, 1.0),
                                check_uniform(&rng, 0.5, 3.0) };
        tried += check_orbit(i, &s, z);
        slope_free(&s);
    }
    CHECK(tried > 10, "%d", tried);
}

/* ---- a law that only inertia slows ----------------------------------------
 */

static void psi_is_as_fast_as_its_lag_makes_it(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "dieterich_gen", NULL, "0.34", steady_only);
    const struct slider *t = &s.study.slider;
    for (double x = -5.0; x > -12.0; x -= 0.7) {
        const struct rest_lag l = rest_lag_at(t, x);
        struct planar_field f;
        t->plane.system.field(t->plane.system.ctx, (struct vec2){ x, l.y }, &f);
        const double slope = f.direction.y / f.direction.x;
        const double slow = exp(-f.log_scale) / -f.direction.x;
        const double v = exp(t->block.at.x0 + x);
        CHECK(fabs(slope - l.y_slope) < 30.0 * v * v + 1e-9 / v,
              "x %g: %.16g, not %.16g", x, l.y_slope, slope);
        CHECK(fabs(slow / l.slowness - 1.0) < 1e-12, "%g, not %g", l.slowness,
              slow);
    }
    slope_free(&s);
}

/* A block on its way there: ln v, psi - psi_ss, time and slip so far. */
enum { LN_V, LEAD, TIME, SLIP, PARTS };

/* By psi' = -v sinh(psi - psi_ss), psi_ss = 1/v. */
static void rates(const struct slider *t, const double q[], double dq[])
{
    const struct vec2 o = t->plane.system.origin;
    const double v = exp(q[LN_V]), y = log1p(v * q[LEAD]) - q[LN_V] - o.y;

    dq[LN_V] = -1.0 / rest_lag_slowness(t, q[LN_V] - o.x, y);
    dq[LEAD] = dq[LN_V] / v - v * sinh(q[LEAD]);
    dq[TIME] = 1.0;
    dq[SLIP] = v;
}

/* One step of Runge's and Kutta's method, so short that its lead changes by a
 * fiftieth at most, and settles by a tenth. */
static void go(const struct slider *t, double q[])
{
    static const double part[] = { 0.0, 0.5, 0.5, 1.0 },
                        weight[] = { 1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6 };
    double k[4][PARTS], at[PARTS], h = 0.0;

    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < PARTS; j++)
            at[j] = q[j] + (i > 0 ? part[i] * h * k[i - 1][j] : 0.0);
        rates(t, at, k[i]);
        if (i == 0)
            h = fmin(0.02 / fabs(k[0][LEAD]),
                     0.1 / (exp(q[LN_V]) * cosh(q[LEAD])));
    }
    for (int j = 0; j < PARTS; j++)
        for (int i = 0; i < 4; i++)
            q[j] += h * weight[i] * k[i][j];
}

/* Ahead of the curve by g at the offset x, until nothing is left of g. */
static void check_lead(const struct slider *t, double x, double g)
{
    const struct vec2 o = t->plane.system.origin;
    const struct rest_lag l = rest_lag_at(t, x);
    const double v = exp(o.x + x);
    const struct vec2 z = { x, log1p(v * (g - l.lag)) - o.x - x - o.y };
    double q[PARTS] = { o.x + x, g - l.lag, 0.0, 0.0 };
    struct rest_left r, end;

    for (int i = 0; i < 100000 && fabs(q[LEAD] + l.lag) > 1e-3; i++)
        go(t, q);
    assert_true(rest_left_find(t, z, 1e9 * l.slowness, &r));
    assert_true(rest_left_find(
        t, (struct vec2){ q[LN_V] - o.x, rest_lag_at(t, q[LN_V] - o.x).y }, 0.0,
        &end));
    const double off = fabs(q[TIME] + end.time - r.time);
    const double far = fabs(q[SLIP] + end.slip - r.slip);
    CHECK(off <= r.time_error && far <= r.slip_error,
          "g %g: time %g off, bar %g; slip %g, bar %g", g, off, r.time_error,
          far, r.slip_error);
    CHECK(g < 20.0 || r.time_error < 10.0 * off, "g %g: bar %g of %g", g,
          r.time_error, off);
}

static void who_is_ahead_of_the_curve_waits_for_it(void **state)
{
    static const double lead[] = { 1.0, 5.0, 20.0, 50.0, 100.0, 500.0 };
    struct slope s;

    (void) state;
    slope_make(&s, "dieterich_gen", NULL, "0.34", steady_only);
    for (double x = -15.0; x > -18.0; x -= 1.0)
        for (size_t i = 0; i < sizeof lead / sizeof *lead; i++)
            check_lead(&s.study.slider, x, lead[i]);
    slope_free(&s);
}

/* ---- whole motions ------------------------------------------------------- */

static int word(const struct csv *c, const char *column,
                const char *const names[])
{
    int i = 0;

    while (names[i] && strcmp(names[i], csv_text(c, column)) != 0)
        i++;
    return i; /* past the words: kato_tullis */
}

/* A law, material and slope of the table, whose inputs are doubles. */
static void read_row(const struct csv *c, struct scene *s)
{
    struct law *l = &s->law;
    struct material *m = &s->material;

    *l = *law_preset_find("kato_tullis");
    if (strcmp(csv_text(c, "kinetics"), "composite") != 0)
        *l = (struct law){
            .preset = "composed",
            .equation = "",
            .theta = (enum theta) word(c, "theta", theta_names),
            .psi_ss = (enum psi_ss) word(c, "psi_ss", psi_ss_names),
            .timescale = (enum timescale) word(c, "timescale", timescale_names),
            .kinetics = (enum kinetics) word(c, "kinetics", kinetics_names),
        };
    l->form = (enum friction_form) word(c, "form", friction_form_names);
    m->mu_star = csv_number(c, "mu_star", 0);
    m->a = csv_number(c, "a", 0);
    m->b = csv_number(c, "b", 0);
    m->c = csv_number(c, "c", 0);
    m->R = csv_number(c, "R", 0);
    m->V_c = csv_number(c, "V_c", 0);
    m->L = csv_number(c, "L", 0);
    m->V_star = csv_number(c, "V_star", 0);
    s->alpha = csv_number(c, "alpha", 0);
    s->tan_alpha = tanl((long double) s->alpha);
}

/* `loose`: the bar may be, relative. */
static void hold(const struct csv *c, const char *what,
                 const struct quantity *q, double is, double loose)
{
    CHECK(isnan(is) || (quantity_exists(q) && fabs(q->value - is) <= q->error &&
                        q->error < loose * is),
          "row %zu, %s: %.16g +- %g, not %.16g: %s", c->row, what, q->value,
          q->error, is, q->reason ? q->reason : "");
}

static void check_push(const struct csv *c, const struct scene *scene, double t,
                       double x)
{
    const struct push_state at = { csv_number(c, "v", 0),
                                   csv_number(c, "psi", 0) };
    struct push_answer a;
    struct fault why;
    struct push p;

    assert_int_equal(push_init(&p, scene, NULL, &why), STATUS_OK);
    for (int tabulated = 0; tabulated < 2; tabulated++) {
        if (tabulated)
            assert_int_equal(push_tabulate(&p, NULL), STATUS_OK);
        assert_int_equal(push_find(&p, at, NULL, &a), STATUS_OK);
        hold(c, "time", &a.time, t, 1e-7);
        hold(c, "slip", &a.slip, x, 1e-7);
    }
    push_free(&p);
}

/* A run that only fades has its limits, too. */
static void check_run(const struct csv *c, const struct scene *scene, double t,
                      double x)
{
    const struct scene_start at = { csv_number(c, "v", 0),
                                    csv_number(c, "psi", 0) };
    const struct transient_options o = transient_defaults(scene);
    struct study s;
    struct transient r;
    struct fault why;

    assert_int_equal(study_run(&s, scene, NULL, &why), STATUS_OK);
    assert_int_equal(transient_find(&s.slider, at, &o, NULL, &r), STATUS_OK);
    CHECK((r.sum.end == TRANSIENT_FADED) == isnan(t) &&
              quantity_exists(&r.sum.time) == !isnan(t),
          "row %zu: %s, %g", c->row, transient_end_names[r.sum.end],
          r.sum.time.value);
    hold(c, "time of the run", &r.sum.time, t, 1e-7);
    hold(c, "slip of the run", &r.sum.slip, x, 1e-7);
    transient_free(&r);
    study_free(&s);
}

static void motions_end_as_the_table_says(void **state)
{
    struct csv c;
    int ends = 0, fades = 0;

    (void) state;
    csv_open(&c, "rest.csv");
    while (csv_next(&c)) {
        const double t = csv_number(&c, "t", (double) NAN);
        const double x = csv_number(&c, "x", 0);
        struct scene s;
        slope_scene(&s, "dieterich", NULL, "0.34", steady_only);
        read_row(&c, &s);
        check_push(&c, &s, t, x);
        check_run(&c, &s, t, x);
        ends += !isnan(t);
        fades += isnan(t);
        scene_free(&s);
    }
    CHECK(ends >= 12 && fades >= 8, "%d, %d", ends, fades);
}

static void slips_without_bound_have_no_limit(void **state)
{
    struct slope s;

    (void) state;
    slope_make(&s, "ruina", NULL, "0.34", steady_only);
    double slope;
    const double x = quasistatic_x(&s.study.slider.block, 20.0, &slope);
    const struct vec2 z = { x, 20.0 };
    struct rest_left r;
    assert_true(rest_left_find(&s.study.slider, z, 0.0, &r));
    assert_true(isinf(r.slip) && isinf(r.time));
    const struct vec2 fast = { 1.0, 20.0 }, above = { x + 0.1, 20.0 };
    assert_false(rest_left_find(&s.study.slider, fast, 0.0, &r));
    assert_false(rest_left_find(&s.study.slider, above, 0.0, &r));
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_inertia_it_is_a_closed_form),
        cmocka_unit_test(orbits_take_what_is_gone_of_it),
        cmocka_unit_test(psi_is_as_fast_as_its_lag_makes_it),
        cmocka_unit_test(who_is_ahead_of_the_curve_waits_for_it),
        cmocka_unit_test(motions_end_as_the_table_says),
        cmocka_unit_test(slips_without_bound_have_no_limit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
