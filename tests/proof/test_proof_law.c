/* Laws of all kinds: what is known of their formulas over boxes without end,
 * and proofs beside bars and beside the same law in other words. */
#include "proof_numbers.h"

#include <math.h>

#include "check.h"
#include "interval_growth.h"
#include "interval_long.h"
#include "law_typed.h"
#include "proof_fold.h"
#include "reference_rows.h"

/* ---- formulas over boxes ------------------------------------------------- */

enum { BOXES = 60, POINTS = 12 };

/* Any of it: a point, a few, or all beyond. */
static struct interval any_range(uint64_t *rng, double most)
{
    const double at = check_uniform(rng, -most, most);
    const double width = pow(10, check_uniform(rng, -6, 0.5));

    switch (check_bits(rng) % 3) {
        case 0:
            return (struct interval){ at, HUGE_VAL };
        case 1:
            return (struct interval){ -HUGE_VAL, at };
        default:
            return (struct interval){ at, at + width };
    }
}

static double any_point(uint64_t *rng, struct interval u)
{
    const double far = pow(10, check_uniform(rng, -3, 1.5));

    return isinf(u.hi) ? (double) u.lo + far
           : isinf(u.lo)
               ? (double) u.hi - far
               : (double) (u.lo + (u.hi - u.lo) * check_uniform(rng, 0, 1));
}

/* Where a value is lost to the truth's own rounding nothing is told. */
static void holds(const char *what, const struct law *law, struct interval u,
                  long double truth, long double size)
{
    const long double room = 1e-13L * fabsl(size) + 1e-300L;

    if (!isfinite(truth) || !isfinite(size))
        return;
    CHECK(u.lo <= truth + room && truth - room <= u.hi,
          "%s of %s: [%.20Lg, %.20Lg] has no %.20Lg", what, law->preset, u.lo,
          u.hi, truth);
}

/* MU and DY, their slopes and those of ln |DY|, at a point of the box. */
static void check_point(const struct proof_law *p, struct law_long *truth,
                        const double z[2], int by)
{
    static const enum law_number what[] = { LAW_AT_MU, LAW_AT_DY };
    const int leaf = by == 0 ? p->graph->x : p->graph->y;

    for (size_t i = 0; i < sizeof what / sizeof *what; i++) {
        const int node = p->graph->node[what[i]];
        const long double u = law_long_at(truth, z[0], z[1], what[i]);
        const long double slope = law_long_by(truth, what[i], leaf);
        const long double part = what[i] == LAW_AT_MU ? 0 : slope / u;
        holds("value", &p->law, p->growth->value[node].all, u,
              u * (1 + fabsl(slope / u)));
        holds("slope", &p->law, p->growth->by[node].all, slope,
              fabsl(slope) + fabsl(u));
        if (what[i] == LAW_AT_DY)
            holds("slope of ln", &p->law, p->growth->rate[node].all, part,
                  1 + fabsl(part) * (1 + fabsl(part)));
    }
}

static void check_boxes(struct proof_law *p, const struct solved *s,
                        uint64_t *rng)
{
    static struct law_long truth;
    const int variable[] = { p->graph->x, p->graph->y };

    law_long_init(&truth, &s->block.law, &s->block.material,
                  s->block.tan_alpha);
    for (int i = 0; i < BOXES; i++) {
        const struct interval at[] = { any_range(rng, 8), any_range(rng, 4) };
        const struct interval offset[] = { interval_less(at[0], p->x),
                                           interval_less(at[1], p->y) };
        const int by = (int) (check_bits(rng) % 2);
        assert_true(
            interval_growth_run(p->growth, &p->state, variable, offset, by));
        for (int k = 0; k < POINTS; k++) {
            const double z[] = { any_point(rng, at[0]), any_point(rng, at[1]) };
            check_point(p, &truth, z, by);
        }
    }
}

/* ---- laws ---------------------------------------------------------------- */

/* A composition that may be. */
static bool draw_law(struct law *law, struct material *m, uint64_t *rng)
{
    struct fault why;

    *m = material_bristol_board();
    *law = (struct law){ .preset = "composed", .equation = "composed" };
    if (check_bits(rng) % 4 == 0) {
        *law = *law_preset_find("kato_tullis");
    } else {
        law->theta = (enum theta)(check_bits(rng) % THETAS);
        law->psi_ss = (enum psi_ss)(check_bits(rng) % PSI_SSES);
        law->timescale = (enum timescale)(check_bits(rng) % TIMESCALES);
        law->kinetics = (enum kinetics)(check_bits(rng) % 2);
    }
    law->form = check_bits(rng) % 2 ? FRICTION_LOG : FRICTION_ASINH;
    m->mu_star = check_uniform(rng, 0.2, 0.8);
    m->a = pow(10, check_uniform(rng, -2.5, -1));
    m->b = m->a * check_uniform(rng, 1.05, 2.5);
    m->c = pow(10, check_uniform(rng, -6, -2));
    m->R = check_bits(rng) % 3 ? pow(10, check_uniform(rng, 0.5, 6)) : INFINITY;
    m->V_c = pow(10, check_uniform(rng, -3, 5));
    m->L = pow(10, check_uniform(rng, -6, -3));
    m->V_star = pow(10, check_uniform(rng, -9, -5));
    return law_check(law, m, &why) == STATUS_OK;
}

static bool draw(struct solved *s, double *tan_alpha, uint64_t *rng)
{
    struct law law;
    struct material m;

    if (!draw_law(&law, &m, rng))
        return false;
    *tan_alpha = m.mu_star * check_uniform(rng, 0.7, 1.2);
    if (solve(s, &law, &m, (long double) *tan_alpha, 1e-12) == STATUS_OK &&
        s->has_saddle)
        return true;
    solved_free(s);
    return false;
}

struct pair {
    const char *name;
    size_t proof, number;
};
#define PAIR(proof_, number_)                                                  \
    {                                                                          \
#proof_, offsetof(struct proof_numbers, proof_),                       \
            offsetof(struct solved, number_)                                   \
    }
static const struct pair pairs[] = {
    PAIR(v, steady.v),
    PAIR(psi, steady.psi),
    PAIR(lambda_minus, steady.lambda_minus),
    PAIR(lambda_plus, steady.lambda_plus),
    PAIR(v_plus, numbers.v_plus),
    PAIR(v_minus, numbers.v_minus),
    PAIR(psi_at_v0, numbers.psi_at_v0),
    PAIR(x_excess, numbers.x_excess),
    PAIR(x_deficit, numbers.x_deficit),
    PAIR(mu_s_num, numbers.mu_s_num),
    PAIR(fracture_energy, numbers.fracture_energy),
};
enum { PAIRS = sizeof pairs / sizeof *pairs };

static const struct proof_number *proved(const struct proof_numbers *n,
                                         size_t i)
{
    return (const void *) ((const char *) n + pairs[i].proof);
}

static const struct quantity *computed(const struct solved *s, size_t i)
{
    return (const void *) ((const char *) s + pairs[i].number);
}

/* Numbers that are there, and of these those proved. */
struct tally {
    size_t asked, proved;
};

static void check_bars(const struct solved *s, const struct proof_numbers *n,
                       struct tally *t)
{
    for (size_t i = 0; i < PAIRS; i++) {
        const struct quantity *q = computed(s, i);
        const struct proof_number *p = proved(n, i);
        if (!quantity_exists(q))
            continue;
        t->asked++;
        t->proved += p->not_proved == NULL;
        CHECK(!p->absent, "%s: %s is proved not to be", s->block.law.preset,
              pairs[i].name);
        CHECK(p->not_proved || (q->value - q->error <= p->value.hi &&
                                p->value.lo <= q->value + q->error),
              "%s: %s: the bar of %.17g +- %.1e is beside [%.17g, %.17g]",
              s->block.law.preset, pairs[i].name, q->value, q->error,
              p->value.lo, p->value.hi);
        if (p->not_proved && getenv("SAY"))
            print_message("# %s %d%d%d%d: %s: %s\n", s->block.law.preset,
                          s->block.law.theta, s->block.law.psi_ss,
                          s->block.law.timescale, s->block.law.kinetics,
                          pairs[i].name, p->not_proved);
    }
}

static void bars_of_random_laws_meet_what_is_proved(void **state)
{
    const long runs = getenv("RANDOM") ? atol(getenv("RANDOM")) : 12;
    uint64_t rng = check_seed();
    struct tally t = { 0 };
    static struct solved s;
    double tan_alpha;

    (void) state;
    for (long done = 0; done < runs;) {
        struct proof p;
        if (!draw(&s, &tan_alpha, &rng))
            continue;
        const struct proof_inputs in = { .slope_in = ANGLE_TAN,
                                         .slope = tan_alpha };
        assert_int_equal(proof_at(&s.block, &in, &p), STATUS_OK);
        const struct proof_numbers n = proof_numbers_of(&p);
        check_bars(&s, &n, &t);
        if (p.not_proved.text[0] == '\0')
            check_boxes(&p.law, &s, &rng);
        proof_free(&p);
        solved_free(&s);
        done++;
    }
    print_message("# %zu of %zu numbers of random laws are proved\n", t.proved,
                  t.asked);
    CHECK(t.proved >= 0.9 * (double) t.asked, "%zu of %zu", t.proved, t.asked);
}

/* ---- in other words ------------------------------------------------------ */

static struct proof_numbers prove(struct solved *s, const struct law *law,
                                  const struct material *m, bool decimal,
                                  double tan_alpha, struct proof *p)
{
    const struct proof_inputs in = { decimal, ANGLE_TAN, tan_alpha,
                                     NULL,    NULL,      { 0 } };

    assert_int_equal(solve(s, law, m, (long double) tan_alpha, 1e-10),
                     STATUS_OK);
    assert_true(s->has_saddle);
    assert_int_equal(proof_at(&s->block, &in, p), STATUS_OK);
    return proof_numbers_of(p);
}

/* Both hold the truth; the second is as narrow but for a factor. */
static void check_same(const char *words, const struct law *law[2],
                       const struct material m[2], double tan_alpha)
{
    static struct solved s[2];
    struct proof p[2];
    struct proof_numbers n[2];

    for (int k = 0; k < 2; k++)
        n[k] = prove(&s[k], law[k], &m[k], true, tan_alpha, &p[k]);
    for (size_t i = 0; i < PAIRS; i++) {
        const struct proof_number *u = proved(&n[0], i), *w = proved(&n[1], i);
        CHECK((u->not_proved == NULL) == (w->not_proved == NULL) &&
                  u->absent == w->absent,
              "%s, %s: %s: %s; %s", law[0]->preset, words, pairs[i].name,
              u->not_proved, w->not_proved);
        if (u->not_proved || w->not_proved)
            continue;
        CHECK(u->value.lo <= w->value.hi && w->value.lo <= u->value.hi,
              "%s, %s: %s: [%.17g, %.17g] beside [%.17g, %.17g]",
              law[0]->preset, words, pairs[i].name, u->value.lo, u->value.hi,
              w->value.lo, w->value.hi);
        CHECK(w->value.hi - w->value.lo <=
                  20 * (u->value.hi - u->value.lo) + 1e-300,
              "%s, %s: %s: %g wide, and %g", law[0]->preset, words,
              pairs[i].name, w->value.hi - w->value.lo,
              u->value.hi - u->value.lo);
    }
    for (int k = 0; k < 2; k++) {
        proof_free(&p[k]);
        solved_free(&s[k]);
    }
}

/* A preset's formulas, or dpsi/dt alone: psi_ss is then found. */
static void check_typed(const struct law *preset, bool alone)
{
    static struct law_typed t;
    const struct material m[] = { material_bristol_board(),
                                  material_bristol_board() };
    enum law_part wrong;
    struct fault why;

    law_typed_of_preset(preset, &t);
    if (alone) {
        snprintf(t.text[LAW_RATE], LAW_LETTERS, "-%s(psi - (%.90s))/(%.90s)",
                 preset->kinetics == KINETICS_SINH ? "sinh" : "",
                 t.text[LAW_PSI_SS], t.text[LAW_T]);
        t.text[LAW_PSI_SS][0] = t.text[LAW_T][0] = t.text[LAW_K][0] = '\0';
    }
    assert_int_equal(law_typed_make(&t, &wrong, &why), STATUS_OK);
    const struct law law = law_of_typed(&t);
    const struct law *both[] = { preset, &law };
    check_same(alone ? "by its rate alone" : "typed", both, m, 0.35);
}

static void a_law_that_is_typed_is_proved_as_its_preset_is(void **state)
{
    (void) state;
    for (size_t i = 0; law_preset_at(i); i++) {
        if (law_preset_at(i)->kinetics == KINETICS_COMPOSITE)
            continue;
        check_typed(law_preset_at(i), false);
        check_typed(law_preset_at(i), true);
    }
}

static void an_infinite_R_is_the_limit_of_the_law(void **state)
{
    struct material m[] = { material_bristol_board(),
                            material_bristol_board() };
    const struct law spinodal = *law_preset_find("spinodal_gen");
    struct law inverse = spinodal;
    const struct law *both[] = { &inverse, &spinodal };

    (void) state;
    inverse.psi_ss = PSI_SS_INVERSE;
    inverse.timescale = TIMESCALE_SLIP;
    m[1].R = INFINITY;
    check_same("R = inf", both, m, 0.35);
    m[1].R = 1e6; /* and not that of any other R */
    static struct solved s[2];
    struct proof p[2];
    const struct proof_numbers a =
        prove(&s[0], both[0], &m[0], true, 0.35, &p[0]);
    const struct proof_numbers b =
        prove(&s[1], both[1], &m[1], true, 0.35, &p[1]);
    CHECK(a.v_plus.value.hi < b.v_plus.value.lo ||
              b.v_plus.value.hi < a.v_plus.value.lo,
          "%.17g and %.17g", a.v_plus.value.lo, b.v_plus.value.lo);
    for (int k = 0; k < 2; k++) {
        proof_free(&p[k]);
        solved_free(&s[k]);
    }
}

/* psi - psi_ss, some 1, is a difference of numbers of 3e20. */
static void all_is_proved_where_psi_is_3e20_at_the_saddle(void **state)
{
    struct material m = material_bristol_board();
    static struct solved s;
    struct tally t = { 0 };
    struct proof p;

    (void) state;
    m.R = INFINITY;
    const struct proof_numbers n =
        prove(&s, law_preset_find("spinodal_gen"), &m, false, tan(0.8), &p);
    CHECK(n.psi.value.lo > 3e20, "%g", n.psi.value.lo);
    check_bars(&s, &n, &t);
    CHECK(t.asked > 8 && t.proved == t.asked, "%zu of %zu", t.proved, t.asked);
    const double lo = n.x_excess.value.lo, hi = n.x_excess.value.hi;
    CHECK(hi - lo < 1e-12 * lo, "[%g, %g]", lo, hi);
    proof_free(&p);
    solved_free(&s);
}

/* ---- fewer bits ---------------------------------------------------------- */

/* The precision of the processor's stack: 3 for 64 bits, 2 for 53. */
static void round_to(unsigned bits)
{
    unsigned short word;

    __asm__ volatile("fnstcw %0" : "=m"(word));
    word = (unsigned short) ((word & ~0x300u) | bits << 8);
    __asm__ volatile("fldcw %0" : : "m"(word));
}

static void nothing_is_proved_where_64_bits_are_rounded_to_53(void **state)
{
    const struct material m = material_bristol_board();
    const struct law *law = law_preset_find("perrin");
    const struct proof_inputs steep = { true, ANGLE_TAN, 3, NULL, NULL, { 0 } };
    static struct solved s;
    struct proof p;
    double window[2];

    (void) state;
    assert_null(prove(&s, law, &m, true, tan(0.34), &p).v_plus.not_proved);
    proof_free(&p);
    solved_free(&s);
    const struct law *other = law_preset_find("spinodal");
    assert_int_equal(proof_no_saddle(other, &m, &steep, window),
                     PROOF_ALONE_FAST);
    round_to(2);
    const struct proof_numbers n = prove(&s, law, &m, true, tan(0.34), &p);
    const enum proof_alone alone = proof_no_saddle(other, &m, &steep, window);
    round_to(3);
    for (size_t i = 0; i < PROOF_NUMBERS; i++)
        CHECK(n.at[i].not_proved && !n.at[i].absent &&
                  strstr(n.at[i].not_proved, "64 bits"),
              "%zu: %s", i, n.at[i].not_proved);
    assert_int_equal(alone, PROOF_ALONE_NOT);
    proof_free(&p);
    solved_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bars_of_random_laws_meet_what_is_proved),
        cmocka_unit_test(a_law_that_is_typed_is_proved_as_its_preset_is),
        cmocka_unit_test(an_infinite_R_is_the_limit_of_the_law),
        cmocka_unit_test(all_is_proved_where_psi_is_3e20_at_the_saddle),
        cmocka_unit_test(nothing_is_proved_where_64_bits_are_rounded_to_53),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
