/* Bars never lie, and are believed: the numbers of random laws, presets and
 * materials, at random slopes, some of them beside a fold, against the 113-bit
 * branches of lib/race, at five accuracies and a random one.  CHECK_COUNT sets
 * how many draws, CHECK_SEED which. */
#include "drawn.h"

#include <string.h>

#include "lies.h"
#include "records.h"
#include "reference_rows.h"

enum number {
    V_PLUS,
    V_MINUS,
    X_EXCESS,
    X_DEFICIT,
    FRACTURE_ENERGY,
    PSI_AT_V0,
    MU_S_NUM,
    MU_S_MEAN,
    LN_V_PLUS,
    LN_V_MINUS,
    NUMBERS
};

static const char *const name[NUMBERS] = {
    "v_plus",    "v_minus",  "x_excess",  "x_deficit", "fracture_energy",
    "psi_at_v0", "mu_s_num", "mu_s_mean", "ln_v_plus", "ln_v_minus"
};

/* Loose: above a hundred times the error. */
struct tally {
    size_t rows, bars[NUMBERS], loose[NUMBERS];
    double log_bar; /* sum of log10 of relative bars */
};

static void hold(const struct draw *d, double rtol, enum number what,
                 const struct quantity *q, quad want, struct tally *t)
{
    const double off = (double) fabsq(q->value - want);
    const double size = (double) fabsq(want);

    CHECK(quantity_exists(q), "%s: %s: %s", d->name, name[what], q->reason);
    CHECK(off <= q->error, "%s, rtol %g: %s = %.17g +- %.2g is off by %.2g",
          d->name, rtol, name[what], q->value, q->error, off);
    t->bars[what]++;
    t->loose[what] += q->error > 100.0 * off;
    t->log_bar += log10(q->error / size);
}

static void hold_upper(const struct draw *d, double rtol,
                       const struct critical_numbers *n, struct tally *t)
{
    const quad v0 = d->at.v0, v = v0 * expq(d->upper.x);
    const quad tangent = d->tan_alpha, excess = d->upper.excess;
    const quad eps2 =
        (quad) d->m.V_star * d->m.V_star / ((quad) d->m.g * d->m.L);
    const quad half = eps2 * sqrtq(1 + tangent * tangent) / 2;
    const quad G = half * v0 * v0 * expm1q(2 * d->upper.x);
    const quad mean = half * v0 * v0 * expm1q(d->upper.x) * expm1q(d->upper.x);

    if (d->upper.end != QUAD_PSI_INF)
        return;
    hold(d, rtol, V_PLUS, &n->v_plus, v, t);
    hold(d, rtol, LN_V_PLUS, &n->ln_v_plus, d->at.x0 + d->upper.x, t);
    hold(d, rtol, X_EXCESS, &n->x_excess, excess, t);
    hold(d, rtol, FRACTURE_ENERGY, &n->fracture_energy, G, t);
    if (n->x_excess.error >= n->x_excess.value)
        return; /* nothing can be divided by it */
    hold(d, rtol, MU_S_NUM, &n->mu_s_num, tangent + G / excess, t);
    hold(d, rtol, MU_S_MEAN, &n->mu_s_mean, tangent + mean / excess, t);
}

static void hold_lower(const struct draw *d, double rtol,
                       const struct critical_numbers *n, struct tally *t)
{
    const quad x = d->at.x0 + d->lower.x, y = d->at.y0 + d->lower.y;

    if (d->lower.end == QUAD_PSI_0) {
        hold(d, rtol, V_MINUS, &n->v_minus, expq(x), t);
        hold(d, rtol, LN_V_MINUS, &n->ln_v_minus, x, t);
    } else if (d->lower.end == QUAD_V_0) {
        hold(d, rtol, PSI_AT_V0, &n->psi_at_v0,
             law_psi_is_log(&d->law) ? y : expq(y), t);
    }
    if (d->lower.end != QUAD_TRUNCATED &&
        !(solve_bare && n->x_deficit.reason &&
          strcmp(n->x_deficit.reason, "nobody asked") == 0))
        hold(d, rtol, X_DEFICIT, &n->x_deficit, -d->lower.excess, t);
}

/* A lower branch that never settles, but by less than was asked for, is as good
 * as one that meets v = 0. */
static void hold_ends(const struct draw *d, double rtol,
                      const struct critical_numbers *n)
{
    static const enum end_code code[] = {
        [QUAD_PSI_INF] = END_PSI_INF,
        [QUAD_OPEN] = END_OPEN,
        [QUAD_PSI_0] = END_PSI_0,
        [QUAD_V_0] = END_V_0,
    };
    const quad y = d->at.y0 + d->lower.y;
    const quad psi = law_psi_is_log(&d->law) ? y : expq(y);

    CHECK(n->upper_end == (int8_t) code[d->upper.end], "%s: %s, not %s",
          d->name, end_names[n->upper_end], end_names[code[d->upper.end]]);
    if (d->lower.end == QUAD_TRUNCATED && n->lower_end == END_V_0)
        CHECK(fabs(n->psi_at_v0.value - (double) psi) <=
                  n->psi_at_v0.error + rtol * (double) fabsq(psi),
              "%s, rtol %g: psi_at_v0 = %.17g has no limit", d->name, rtol,
              n->psi_at_v0.value);
    else if (d->lower.end != QUAD_TRUNCATED) /* given up, perhaps */
        CHECK(n->lower_end == (int8_t) code[d->lower.end], "%s: %s, not %s",
              d->name, end_names[n->lower_end], end_names[code[d->lower.end]]);
}

/* rtol 1e-4, 1e-6, ... 1e-12, and a random one. */
enum { LEVELS = 5, ANY = LEVELS };

static bool draw_any(uint64_t *seed, struct draw *d)
{
    draw_how *const how = check_bits(seed) % 4 ? draw_slope : draw_near_fold;

    return check_bits(seed) % 2 ? draw_preset(seed, how, d)
                                : draw_one(check_bits(seed), seed, how, d);
}

/* Beside a cusp, or as near a fold as tells. */
static bool draw_beside(uint64_t *seed, struct draw *d)
{
    draw_how *const how =
        check_bits(seed) % 4 ? draw_near_cusp : draw_near_fold;

    return check_bits(seed) % 2 ? draw_preset(seed, how, d)
                                : draw_one(check_bits(seed), seed, how, d);
}

static bool hold_draw(bool (*draw)(uint64_t *seed, struct draw *d),
                      uint64_t *seed, struct tally tally[LEVELS + 1])
{
    struct draw d;
    bool known = false;

    if (!draw(seed, &d))
        return false;
    for (int k = LEVELS + 1; k-- > 0;) {
        const double rtol =
            pow(10.0, k == ANY ? check_uniform(seed, -13, -3) : -4.0 - 2.0 * k);
        struct solved s;
        const enum status status = solve(&s, &d.law, &d.m, d.tan_alpha, rtol);
        CHECK(status == STATUS_OK && s.has_saddle, "%s: %s", d.name,
              status_text(status));
        if (!known && !draw_solve(&d, &s.block))
            fail_msg("%s: no branches in 113 bits", d.name);
        known = true;
        hold_ends(&d, rtol, &s.numbers);
        hold_upper(&d, rtol, &s.numbers, &tally[k]);
        hold_lower(&d, rtol, &s.numbers, &tally[k]);
        tally[k].rows++;
        solved_free(&s);
    }
    return true;
}

static size_t sum_of(const size_t part[NUMBERS])
{
    size_t sum = 0;

    for (int i = 0; i < NUMBERS; i++)
        sum += part[i];
    return sum;
}

/* Nine of ten are below a hundred times the error: of all, whose fates are
 * those of a draw, and of each number that there is a hundred of; but for
 * chance, of three standard deviations. */
static void hold_loose(const struct tally *t)
{
    const size_t bars = sum_of(t->bars), loose = sum_of(t->loose);

    for (int i = 0; i < NUMBERS; i++) {
        const double n = (double) t->bars[i];
        print_message("# %s: %zu of %zu above 100 times the error\n", name[i],
                      t->loose[i], t->bars[i]);
        CHECK(n < 100 || (double) t->loose[i] <= 0.1 * n + 0.9 * sqrt(n),
              "%zu of %zu bars of %s are loose", t->loose[i], t->bars[i],
              name[i]);
    }
    CHECK((double) loose <=
              (0.1 + 0.9 / sqrt((double) t->rows)) * (double) bars,
          "%zu of %zu bars are loose", loose, bars);
}

/* As many as CHECK_COUNT says. */
static void hold_draws(bool (*draw)(uint64_t *seed, struct draw *d),
                       size_t usual, struct tally tally[LEVELS + 1])
{
    const char *count = getenv("CHECK_COUNT");
    const size_t rows = count ? strtoul(count, NULL, 10) : usual;
    uint64_t seed = check_seed();

    if (laws_emulated())
        skip();
    print_message("# CHECK_SEED=%llu\n", (unsigned long long) seed);
    while (tally[0].rows < rows)
        hold_draw(draw, &seed, tally);
}

static void bars_hold_on_random_laws_and_parameters(void **state)
{
    struct tally tally[LEVELS + 1] = { { 0 } };

    (void) state;
    hold_draws(draw_any, 60, tally);
    double before = HUGE_VAL;
    for (int k = 0; k < LEVELS; k++) {
        const size_t bars = sum_of(tally[k].bars);
        const double bar = pow(10.0, tally[k].log_bar / (double) bars);
        print_message("# rtol 1e-%d: %zu bars, typically %.1e, %zu above 100 "
                      "times the error\n",
                      4 + 2 * k, bars, bar, sum_of(tally[k].loose));
        CHECK(bar < 0.5 * before, "bars do not shrink to 1e-%d", 4 + 2 * k);
        before = bar;
    }
    hold_loose(&tally[LEVELS - 1]);
}

/* Where the saddle's place is known to half its digits, and v_plus, x_excess
 * and the energy go like powers of v there. */
static void bars_hold_beside_cusps_and_folds(void **state)
{
    struct tally tally[LEVELS + 1] = { { 0 } };

    (void) state;
    hold_draws(draw_beside, 30, tally);
    hold_loose(&tally[LEVELS - 1]);
}

/* Loose only where the fine one tells. */
static bool hold_fine(const struct draw *d, double rtol, enum number what,
                      const struct quantity *q, const struct quantity *fine,
                      struct tally *t)
{
    if (!quantity_exists(q) || !quantity_exists(fine))
        return false;
    const double off = fabs(q->value - fine->value);
    CHECK(off <= q->error + fine->error,
          "%s, a %.17g b %.17g c %g R %g, rtol %g: %s = %.17g +- %.2g is off "
          "by %.2g",
          d->name, d->m.a, d->m.b, d->m.c, d->m.R, rtol, name[what], q->value,
          q->error, off);
    if (100.0 * fine->error < q->error) {
        t->bars[what]++;
        t->loose[what] += q->error > 100.0 * off;
    }
    return true;
}

/* Those of two accuracies. */
static size_t hold_both(const struct draw *d, double rtol,
                        const struct critical_numbers *n,
                        const struct critical_numbers *f, struct tally *t)
{
    const struct quantity *of[NUMBERS][2] = {
        [X_EXCESS] = { &n->x_excess, &f->x_excess },
        [X_DEFICIT] = { &n->x_deficit, &f->x_deficit },
        [FRACTURE_ENERGY] = { &n->fracture_energy, &f->fracture_energy },
        [PSI_AT_V0] = { &n->psi_at_v0, &f->psi_at_v0 },
        [MU_S_NUM] = { &n->mu_s_num, &f->mu_s_num },
        [MU_S_MEAN] = { &n->mu_s_mean, &f->mu_s_mean },
        [LN_V_PLUS] = { &n->ln_v_plus, &f->ln_v_plus },
        [LN_V_MINUS] = { &n->ln_v_minus, &f->ln_v_minus },
    };
    size_t held = 0;

    for (int i = 0; i < NUMBERS; i++)
        held += of[i][0] && hold_fine(d, rtol, i, of[i][0], of[i][1], t);
    return held;
}

/* A thousand slopes, at 1e-8 against the finest accuracy. */
static void bars_are_believed(void **state)
{
    uint64_t seed = check_seed();
    struct tally tally = { 0 };

    (void) state;
    while (tally.rows < 1000) {
        const double rtol = 1e-8;
        struct draw d;
        struct solved fine, s;
        if (!draw_any(&seed, &d))
            continue;
        if (solve(&s, &d.law, &d.m, d.tan_alpha, rtol) == STATUS_OK &&
            solve(&fine, &d.law, &d.m, d.tan_alpha, 1e-14) == STATUS_OK) {
            hold_both(&d, rtol, &s.numbers, &fine.numbers, &tally);
            solved_free(&fine);
        }
        solved_free(&s);
        tally.rows++;
    }
    hold_loose(&tally);
}

/* At all accuracies from one to another against the finest one. */
static void hold_lie(const struct lie *lie, double rtol, double to)
{
    struct draw d = draw_lie(lie);
    struct solved fine, s;
    struct tally tally = { 0 };

    draw_name(&d);
    assert_int_equal(solve(&fine, &d.law, &d.m, d.tan_alpha, 1e-14), STATUS_OK);
    for (; rtol < to; rtol *= 1.01) {
        assert_int_equal(solve(&s, &d.law, &d.m, d.tan_alpha, rtol), STATUS_OK);
        assert_true(hold_both(&d, rtol, &s.numbers, &fine.numbers, &tally) > 0);
        solved_free(&s);
    }
    solved_free(&fine);
}

static void bars_that_lied_once_lie_no_more(void **state)
{
    (void) state;
    hold_lie(&lie_slow, 3e-4, 5e-4);
    hold_lie(&lie_kink, 1e-12, 1e-8);
    hold_lie(&lie_kink, 5.442781596265568e-12, 5.45e-12);
    hold_lie(&lie_tail, 1e-6, 1e-4);
    hold_lie(&lie_tail, 3.6885640652063053e-05, 3.7e-5);
    hold_lie(&lie_bend, 5.2241404144663433e-06, 5.3e-6);
}

/* All numbers of a slope whose branches end like this, from 1e-12 to 1e-6. */
static void hold_slope(const struct lie *lie, enum quad_end lower,
                       enum quad_end upper)
{
    struct draw d = draw_lie(lie);
    struct tally tally = { 0 };
    struct solved s;

    if (laws_emulated())
        skip();
    draw_name(&d);
    for (double rtol = 1e-12; rtol < 1e-5; rtol *= 1e3) {
        assert_int_equal(solve(&s, &d.law, &d.m, d.tan_alpha, rtol), STATUS_OK);
        assert_true(d.lower.steps > 0 || draw_solve(&d, &s.block));
        assert_int_equal(d.lower.end, lower);
        assert_int_equal(d.upper.end, upper);
        hold_ends(&d, rtol, &s.numbers);
        hold_upper(&d, rtol, &s.numbers, &tally);
        hold_lower(&d, rtol, &s.numbers, &tally);
        solved_free(&s);
    }
}

static void bars_hold_where_squares_overflow(void **state)
{
    (void) state;
    hold_slope(&lie_far, QUAD_V_0, QUAD_OPEN);
}

static void bars_hold_where_v_hardly_changes(void **state)
{
    (void) state;
    hold_slope(&lie_still, QUAD_PSI_0, QUAD_PSI_INF);
}

static void bars_hold_what_vanishes_in_a_double(void **state)
{
    const struct draw d = draw_lie(&lie_small);
    struct solved s;

    (void) state;
    if (laws_emulated())
        skip();
    assert_int_equal(solve(&s, &d.law, &d.m, d.tan_alpha, 1e-12), STATUS_OK);
    const struct quantity *q = &s.numbers.x_deficit;
    assert_true(quantity_exists(q));
    CHECK(fabs(q->value - 6.4033198321841302e-288) <= q->error, "%g +- %g",
          q->value, q->error);
    solved_free(&s);
}

/* A law whose friction turns sharply: b up to a thousand times a. */
static bool draw_kink(uint64_t *seed, struct draw *d)
{
    struct fault why;

    d->law = check_bits(seed) % 2 ? *law_preset_at(check_bits(seed) % 7)
                                  : laws_at(check_bits(seed) % LAWS);
    d->law.form = check_bits(seed) % 2 ? FRICTION_LOG : FRICTION_ASINH;
    d->m = laws_material(seed);
    d->m.a = laws_power(seed, -5, -1.5);
    d->m.b = d->m.a * laws_power(seed, 0.3, 3);
    return law_check(&d->law, &d->m, &why) == STATUS_OK &&
           draw_by(check_bits(seed) % 3 ? draw_slope : draw_near_fold, seed, d);
}

/* Series fall slowly beside a kink, and may be small by chance: at random
 * accuracies against the finest one. */
static void bars_hold_where_friction_turns_sharply(void **state)
{
    const char *count = getenv("CHECK_COUNT");
    const size_t rows = 20 * (count ? strtoul(count, NULL, 10) : 100);
    uint64_t seed = check_seed();
    struct tally tally = { 0 };
    size_t held = 0;

    (void) state;
    for (size_t n = 0; n < rows;) {
        struct draw d;
        struct solved fine, s;
        if (!draw_kink(&seed, &d))
            continue;
        n++;
        const enum status status =
            solve(&fine, &d.law, &d.m, d.tan_alpha, 1e-14);
        for (int i = 0; i < 3 && status == STATUS_OK && fine.has_saddle; i++) {
            const double rtol = laws_power(&seed, -13, -3);
            if (solve(&s, &d.law, &d.m, d.tan_alpha, rtol) == STATUS_OK &&
                s.has_saddle)
                held += hold_both(&d, rtol, &s.numbers, &fine.numbers, &tally);
            solved_free(&s);
        }
        solved_free(&fine);
    }
    print_message("# CHECK_SEED=%llu: %zu numbers of %zu draws\n",
                  (unsigned long long) check_seed(), held, rows);
    CHECK(held > 8 * rows, "%zu numbers of %zu draws", held, rows);
}

/* By branches that lean where they may, for their ends alone. */
static int lean(void **state)
{
    (void) state;
    solve_bare = true;
    return 0;
}

static int keep(void **state)
{
    (void) state;
    solve_bare = false;
    return 0;
}

#define LEANING(test) cmocka_unit_test_setup_teardown(test, lean, keep)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bars_hold_on_random_laws_and_parameters),
        cmocka_unit_test(bars_hold_beside_cusps_and_folds),
        cmocka_unit_test(bars_are_believed),
        cmocka_unit_test(bars_that_lied_once_lie_no_more),
        cmocka_unit_test(bars_hold_where_squares_overflow),
        cmocka_unit_test(bars_hold_where_v_hardly_changes),
        cmocka_unit_test(bars_hold_what_vanishes_in_a_double),
        cmocka_unit_test(bars_hold_where_friction_turns_sharply),
        LEANING(bars_hold_on_random_laws_and_parameters),
        LEANING(bars_hold_beside_cusps_and_folds),
        LEANING(bars_are_believed),
        LEANING(bars_that_lied_once_lie_no_more),
        LEANING(bars_hold_where_squares_overflow),
        LEANING(bars_hold_where_v_hardly_changes),
        LEANING(bars_hold_where_friction_turns_sharply),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
