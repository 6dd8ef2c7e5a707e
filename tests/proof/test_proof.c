/* Rows of the reference tables - one in eight, every one if EVERY_ROW is set:
 * the reference is inside what is proved, no bar is beside it, and it is as
 * narrow as promised.  And curves that are wrong on purpose, SPOILED times. */
#include "proof_numbers.h"

#include <math.h>
#include <mpfr.h>

#include "check.h"
#include "proof_flow.h"
#include "reference_rows.h"
#include "spoiled.h"

struct tally {
    size_t asked, proved, rows;
    size_t bars, holding; /* that hold all of what is proved */
    size_t none;          /* that there is none is proved */
};

/* Numbers of a table, of a proof and of the ordinary run. */
struct compared {
    const char *column;
    size_t proof, number;
};
#define NUMBER(column_, proof_, number_)                                       \
    {                                                                          \
#column_, offsetof(struct proof_numbers, proof_),                      \
            offsetof(struct solved, number_)                                   \
    }
static const struct compared compared[] = {
    NUMBER(v_sp, v, steady.v),
    NUMBER(psi_sp, psi, steady.psi),
    NUMBER(lambda_minus, lambda_minus, steady.lambda_minus),
    NUMBER(lambda_plus, lambda_plus, steady.lambda_plus),
    NUMBER(v_plus, v_plus, numbers.v_plus),
    NUMBER(x_excess, x_excess, numbers.x_excess),
    NUMBER(mu_s_num, mu_s_num, numbers.mu_s_num),
    NUMBER(mu_s_mean, mu_s_mean, numbers.mu_s_mean),
    NUMBER(G_num, fracture_energy, numbers.fracture_energy),
    NUMBER(v_minus, v_minus, numbers.v_minus),
    NUMBER(psi_at_v0, psi_at_v0, numbers.psi_at_v0),
    NUMBER(x_deficit_lower, x_deficit, numbers.x_deficit),
    NUMBER(knee_up_v, knee[0][0].v, numbers.knee_upper.v),
    NUMBER(knee_up_psi, knee[0][0].psi, numbers.knee_upper.psi),
    NUMBER(knee_lo_v, knee[1][0].v, numbers.knee_lower.v),
    NUMBER(knee_lo_psi, knee[1][0].psi, numbers.knee_lower.psi),
};

static const struct proof_number *proved(const struct proof_numbers *n,
                                         const struct compared *c)
{
    return (const void *) ((const char *) n + c->proof);
}

static const struct quantity *computed(const struct solved *s,
                                       const struct compared *c)
{
    return (const void *) ((const char *) s + c->number);
}

/* How far a decimal may be from what it was rounded from, over its size. */
static double printed(const char *text)
{
    int digits = 0;

    for (; *text && *text != 'e'; text++)
        digits += *text >= '0' && *text <= '9' && (digits > 0 || *text != '0');
    return fmax(pow(10, 1 - digits), 1e-20); /* 22 digits are certain */
}

/* Whether the decimal may be inside. */
static bool holds(struct interval_double u, const char *decimal)
{
    mpfr_t x, slack;

    mpfr_inits2(160, x, slack, NULL);
    mpfr_set_str(x, decimal, 10, MPFR_RNDN);
    mpfr_mul_d(slack, x, printed(decimal), MPFR_RNDN);
    mpfr_abs(slack, slack, MPFR_RNDN);
    mpfr_add(x, x, slack, MPFR_RNDN);
    bool inside = mpfr_cmp_d(x, u.lo) >= 0;
    mpfr_mul_2ui(slack, slack, 1, MPFR_RNDN);
    mpfr_sub(x, x, slack, MPFR_RNDN);
    inside = inside && mpfr_cmp_d(x, u.hi) <= 0;
    mpfr_clears(x, slack, NULL);
    return inside;
}

static void say_row(const struct csv *c, char text[], size_t size)
{
    snprintf(text, size, "row %zu: %s %s alpha %s R %s %s", c->row,
             csv_text(c, "law"), csv_text(c, "form"), csv_text(c, "alpha"),
             csv_text(c, "R"), csv_text(c, "tag"));
}

static void prove(const struct csv *c, const struct solved *s, bool decimal,
                  struct proof *out)
{
    const struct proof_inputs in = {
        decimal, ANGLE_RAD, csv_number(c, "alpha", 0), csv_text(c, "alpha"),
        NULL,    { 0 }
    };

    const enum status status = proof_at(&s->block, &in, out);
    CHECK(status == STATUS_OK, "%s", status_text(status));
}

/* Relative widths grow towards a fold as the inputs' own digits are lost. */
static double allowed(const struct csv *c)
{
    const double lost = fmax(csv_number(c, "digits_lost_alpha_vplus", 0),
                             csv_number(c, "digits_lost_alpha_lower", 0));

    return 1e-11 + pow(10, fmax(lost, 0) - 14);
}

/* A bar that does not meet what is proved is a lie. */
static void check_bar(const char *row, const char *name,
                      const struct quantity *q, struct interval_double u,
                      struct tally *t)
{
    const double lo = q->value - q->error, hi = q->value + q->error;

    t->bars++;
    t->holding += lo <= u.lo && u.hi <= hi;
    if (getenv("SAY") && !(lo <= u.lo && u.hi <= hi))
        print_message("# %s: %s: the bar of %.17g +- %.17g is not all around "
                      "[%.17g, %.17g]\n",
                      row, name, q->value, q->error, u.lo, u.hi);
    CHECK(lo <= u.hi && u.lo <= hi,
          "%s: %s: the bar of %.17g +- %.1e is beside [%.17g, %.17g]", row,
          name, q->value, q->error, u.lo, u.hi);
}

static void check_number(const struct csv *c, const struct solved *s,
                         const struct proof_numbers *exact,
                         const struct proof_numbers *as_double,
                         const struct compared *what, struct tally *t)
{
    const char *text = csv_text(c, what->column);
    const struct proof_number *p = proved(exact, what);
    const struct proof_number *d = proved(as_double, what);
    const struct quantity *q = computed(s, what);
    char row[200];

    say_row(c, row, sizeof row);
    CHECK(!p->absent || *text == '\0' || strcmp(text, "none") == 0,
          "%s: %s = %s is proved to be none", row, what->column, text);
    t->none += p->absent;
    if (*text == '\0' || strcmp(text, "none") == 0)
        return;
    t->asked++;
    if (p->not_proved) {
        if (getenv("SAY"))
            print_message("# %s: %s: %s\n", row, what->column, p->not_proved);
        return;
    }
    t->proved++;
    const struct interval_double u = p->value;
    const double width = (u.hi - u.lo) / fmin(fabs(u.lo), fabs(u.hi));
    CHECK(holds(u, text), "%s: %s = %s is not in [%.17g, %.17g]", row,
          what->column, text, u.lo, u.hi);
    if (getenv("SAY") && width > allowed(c))
        print_message("# %s: %s: %.1e wide\n", row, what->column, width);
    else
        CHECK(width <= allowed(c), "%s: %s: %.1e wide", row, what->column,
              width);
    if (d->not_proved == NULL && quantity_exists(q))
        check_bar(row, what->column, q, d->value, t);
}

static void check_row(const struct csv *c, struct tally *t)
{
    struct solved s;
    struct proof exact, as_double;

    if (csv_number(c, "has_saddle", 0) < 0.5)
        return;
    assert_int_equal(solve_row(&s, c, 1e-12), STATUS_OK);
    prove(c, &s, true, &exact);
    prove(c, &s, false, &as_double);
    const struct proof_numbers n = proof_numbers_of(&exact);
    const struct proof_numbers d = proof_numbers_of(&as_double);
    t->rows++;
    for (size_t i = 0; i < sizeof compared / sizeof *compared; i++)
        check_number(c, &s, &n, &d, &compared[i], t);
    if (exact.branch[0].end >= 0)
        assert_int_equal(exact.branch[0].end, s.numbers.upper_end);
    if (exact.branch[1].end >= 0)
        assert_int_equal(exact.branch[1].end, s.numbers.lower_end);
    proof_free(&exact);
    proof_free(&as_double);
    solved_free(&s);
}

static bool is_meant(const struct csv *c)
{
    return getenv("EVERY_ROW") || (c->row + check_seed()) % 8 == 0;
}

static void check_table(const char *name)
{
    static struct csv c;
    struct tally t = { 0 };

    csv_open(&c, name);
    while (csv_next(&c))
        if (is_meant(&c))
            check_row(&c, &t);
    print_message("# %s: %zu of %zu numbers of %zu rows are proved; %zu of %zu "
                  "bars hold all of what is; %zu are proved to be none\n",
                  name, t.proved, t.asked, t.rows, t.holding, t.bars, t.none);
    CHECK(t.proved >= 0.95 * (double) t.asked, "%zu of %zu", t.proved, t.asked);
}

static void each_number_of_the_manifold_table_is_proved(void **state)
{
    (void) state;
    check_table("manifold.csv");
}

static void each_number_of_the_extreme_table_is_proved(void **state)
{
    (void) state;
    check_table("extreme.csv");
}

/* ---- spoiled curves ------------------------------------------------------ */

/* To the end, to any accuracy and so of any order. */
static void grow_for_proof(struct solved *s, const struct csv *c, double rtol)
{
    const struct box all = { { -700, -1e300 }, { 700, 1e300 } };

    solve_reach = &all;
    assert_int_equal(solve_row(s, c, rtol), STATUS_OK);
    solve_reach = NULL;
}

/* Gronwall's two bounds at a point of a cell: of step G - p' on p, and of
 * d(step G)/d dep on the rim of the tube. */
static void check_cell(struct proof *p, const struct proof_piece *piece,
                       const struct proof_cell *cell, double theta)
{
    const struct interval at = interval_add(
        interval_point(piece->start),
        interval_times(interval_point(piece->step), interval_point(theta)));
    const struct interval dep =
        proof_poly_at(piece->degree, piece->coef, interval_point(theta));
    const double aside = theta < cell->to ? cell->radius : -cell->radius;
    struct interval rise = { 0, 0 };
    struct proof_flow f, rim;

    for (size_t k = piece->degree; k > 0; k--)
        rise = interval_add(interval_times(rise, interval_point(theta)),
                            interval_times(interval_point((double) k),
                                           interval_point(piece->coef[k])));
    proof_flow_aside(&p->law.tape, piece->ind, at, dep, &f);
    proof_flow_aside(&p->law.tape, piece->ind, at,
                     interval_add(dep, interval_point(aside)), &rim);
    const struct interval step = interval_point(piece->step);
    const struct interval off = interval_less(
        interval_times(step, interval_divide(f.dep.c[0], f.ind.c[0])), rise);
    const struct interval g = interval_divide(rim.dep.c[0], rim.ind.c[0]);
    const struct interval rate = interval_times(
        step, interval_divide(
                  interval_less(rim.dep.c[1], interval_times(g, rim.ind.c[1])),
                  rim.ind.c[0]));
    CHECK(interval_least(off) <= cell->defect,
          "a defect of %Lg in a cell of %g, theta %g of %g .. %g",
          interval_least(off), cell->defect, theta, cell->from, cell->to);
    CHECK(rate.lo <= cell->rate, "a rate of %Lg in a cell of %g", rate.lo,
          cell->rate);
}

static void check_cells(struct proof *p)
{
    for (int b = 0; b < 2; b++)
        for (size_t i = 0; i < p->branch[b].pieces; i++) {
            const struct proof_piece *piece = &p->branch[b].piece[i];
            const struct proof_cell *cell = p->branch[b].cell + piece->first;
            for (size_t k = 0; k < piece->cells; k++) {
                check_cell(p, piece, &cell[k], cell[k].from);
                check_cell(p, piece, &cell[k],
                           cell[k].from / 3 + cell[k].to * 2 / 3);
                check_cell(p, piece, &cell[k], cell[k].to);
            }
        }
}

static void check_spoiled(const struct csv *c, double noise, uint64_t *rng,
                          struct tally *t)
{
    const struct proof_inputs in = {
        true, ANGLE_RAD, csv_number(c, "alpha", 0), csv_text(c, "alpha"),
        NULL, { 0 }
    };
    struct branch both[2];
    struct solved s;
    struct proof p;

    grow_for_proof(&s, c, pow(10, check_uniform(rng, -14, -3)));
    both[0] = s.upper;
    both[1] = s.lower;
    for (int i = 0; i < 2; i++) { /* some end long before the end */
        size_t *count = &both[i].curve.count;
        *count -= check_bits(rng) % 2 ? check_bits(rng) % (*count / 2 + 1) : 0;
        spoil(&both[i], (enum spoil)(check_bits(rng) % SPOILS), noise, rng);
    }
    assert_int_equal(proof_along(&s.block, &in, both, &p), STATUS_OK);
    check_cells(&p);
    const struct proof_numbers n = proof_numbers_of(&p);
    for (size_t i = 4; i < sizeof compared / sizeof *compared; i++) {
        const char *text = csv_text(c, compared[i].column);
        const struct proof_number *q = proved(&n, &compared[i]);
        if (*text == '\0' || strcmp(text, "none") == 0)
            continue;
        t->asked++;
        t->proved += q->not_proved == NULL;
        CHECK(!q->absent && (q->not_proved || holds(q->value, text)),
              "%s with noise %.1e: %s = %s is not in [%.17g, %.17g]",
              csv_text(c, "law"), noise, compared[i].column, text, q->value.lo,
              q->value.hi);
    }
    proof_free(&p);
    solved_free(&s);
}

static void a_spoiled_curve_is_proved_wider_or_refused_never_wrong(void **state)
{
    const long runs = getenv("SPOILED") ? atol(getenv("SPOILED")) : 12;
    uint64_t rng = check_seed();
    static struct csv c;
    struct tally t = { 0 };

    (void) state;
    for (long done = 0; done < runs;) {
        csv_open(&c, done % 2 ? "extreme.csv" : "manifold.csv");
        while (csv_next(&c) && done < runs)
            if (csv_number(&c, "has_saddle", 0) > 0.5 &&
                check_uniform(&rng, 0, 1) < 0.1) {
                check_spoiled(&c, pow(10, check_uniform(&rng, -12, -2)), &rng,
                              &t);
                done++;
            }
    }
    print_message("# %zu of %zu numbers of %ld spoiled curves are proved\n",
                  t.proved, t.asked, runs);
}

/* ---- random materials ---------------------------------------------------- */

/* Inputs are doubles, of which tan(alpha) is exact. */
static bool draw(struct solved *s, double *tan_alpha, uint64_t *rng)
{
    struct material m = material_bristol_board();
    size_t presets = 0;

    while (law_preset_at(presets))
        presets++;
    struct law law = *law_preset_at(check_bits(rng) % presets);
    if (law.kinetics == KINETICS_COMPOSITE)
        return false;
    law.form = check_bits(rng) % 2 ? FRICTION_LOG : FRICTION_ASINH;
    m.mu_star = check_uniform(rng, 0.2, 0.8);
    m.a = pow(10, check_uniform(rng, -2.5, -1));
    m.b = m.a * check_uniform(rng, 1.05, 2.5);
    m.c = pow(10, check_uniform(rng, -6, -2));
    m.R = pow(10, check_uniform(rng, 0.5, 6));
    m.L = pow(10, check_uniform(rng, -6, -3));
    m.V_star = pow(10, check_uniform(rng, -9, -5));
    *tan_alpha = m.mu_star * check_uniform(rng, 0.7, 1.2);
    if (solve(s, &law, &m, (long double) *tan_alpha, 1e-12) == STATUS_OK &&
        s->has_saddle)
        return true;
    solved_free(s);
    return false;
}

static void check_random(const struct solved *s, double tan_alpha,
                         struct tally *t)
{
    const struct proof_inputs in = { .slope_in = ANGLE_TAN,
                                     .slope = tan_alpha };
    struct proof p;

    assert_int_equal(proof_at(&s->block, &in, &p), STATUS_OK);
    const struct proof_numbers n = proof_numbers_of(&p);
    for (size_t i = 0; i < sizeof compared / sizeof *compared; i++) {
        const struct quantity *q = computed(s, &compared[i]);
        const struct proof_number *found = proved(&n, &compared[i]);
        if (!quantity_exists(q))
            continue;
        t->asked++;
        CHECK(!found->absent, "%s: %s", s->block.law.preset,
              compared[i].column);
        t->proved += found->not_proved == NULL;
        if (found->not_proved == NULL)
            check_bar(s->block.law.preset, compared[i].column, q, found->value,
                      t);
        else if (getenv("SAY"))
            print_message("# %s: %s: %s\n", s->block.law.preset,
                          compared[i].column, found->not_proved);
    }
    proof_free(&p);
}

static void bars_of_random_materials_meet_what_is_proved(void **state)
{
    const long runs = getenv("RANDOM") ? atol(getenv("RANDOM")) : 6;
    uint64_t rng = check_seed();
    struct tally t = { 0 };
    struct solved s;
    double tan_alpha;

    (void) state;
    for (long done = 0; done < runs;) {
        if (!draw(&s, &tan_alpha, &rng))
            continue;
        check_random(&s, tan_alpha, &t);
        solved_free(&s);
        done++;
    }
    print_message("# %zu of %zu numbers of random materials are proved\n",
                  t.proved, t.asked);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_number_of_the_manifold_table_is_proved),
        cmocka_unit_test(each_number_of_the_extreme_table_is_proved),
        cmocka_unit_test(
            a_spoiled_curve_is_proved_wider_or_refused_never_wrong),
        cmocka_unit_test(bars_of_random_materials_meet_what_is_proved),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
