/* Every number of every row of the reference tables: right to what was
 * promised, and inside its own error bar. */
#include "numbers.h"

#include <math.h>

#include "check.h"
#include "records.h"
#include "reference_rows.h"

/* What became of all the bars. */
struct tally {
    size_t bars, exceeded, loose;
};

struct row {
    const struct csv *csv;
    const struct solved *s;
    double rtol;
    struct tally *tally;
    const struct solved *nearby; /* 2 per input: each a little up and down */
};

/* The table's inputs are decimals, ours their nearest doubles. */
enum { INPUTS = 10 }; /* MATERIAL_KEYS and alpha */
#define NUDGE 1e-7

/* What rounding every input by half an ulp can change a number by: its
 * central differences over the inputs.  `offset` finds it in struct solved. */
static double input_cost(const struct row *r, const struct quantity *q)
{
    const size_t offset = (size_t) ((const char *) q - (const char *) r->s);
    double sum = 0.0;

    for (int i = 0; i < INPUTS; i++) {
        const struct quantity *up =
            (const void *) ((const char *) &r->nearby[2 * i] + offset);
        const struct quantity *down =
            (const void *) ((const char *) &r->nearby[2 * i + 1] + offset);
        if (quantity_exists(up) && quantity_exists(down))
            sum += fabs(up->value - down->value) / (2.0 * NUDGE) * 0x1p-53;
    }
    return sum;
}

static void solve_nearby(const struct csv *c, double rtol, struct solved *near)
{
    for (int i = 0; i < 2 * INPUTS; i++) {
        const struct law law = row_law(c);
        struct material m = row_material(c);
        double alpha = csv_number(c, "alpha", 0);
        double *input = i / 2 < MATERIAL_KEYS
                            ? material_member(&m, (enum material_key)(i / 2))
                            : &alpha;
        *input *= i % 2 == 0 ? 1.0 + NUDGE : 1.0 - NUDGE;
        if (solve(&near[i], &law, &m, tanl((long double) alpha), rtol) !=
            STATUS_OK)
            near[i].numbers = numbers_no_critical();
    }
}

/* Digits the rounding of alpha alone costs, as the table says it. */
static double lost(const struct row *r, const char *column)
{
    const double d = csv_number(r->csv, column, 0.0);
    return fmax(d, 0.0);
}

/* Relative uncertainty of a decimal that was printed with few digits. */
static double printed(const char *text)
{
    int digits = 0;

    for (; *text && *text != 'e'; text++)
        digits += *text >= '0' && *text <= '9' && (digits > 0 || *text != '0');
    return pow(10.0, 1.0 - digits);
}

static void say_row(const struct row *r, char *text, size_t size)
{
    snprintf(text, size, "row %zu %s %s alpha %s %s rtol %g", r->csv->row,
             csv_text(r->csv, "law"), csv_text(r->csv, "form"),
             csv_text(r->csv, "alpha"), csv_text(r->csv, "tag"), r->rtol);
}

/* q against the table's column: |error| <= promise (relative) at full
 * accuracy; and never more than its bar plus what rounding of the inputs costs.
 */
static void check_number(const struct row *r, const char *column,
                         const struct quantity *q, double promise, double d)
{
    const double want = csv_number(r->csv, column, NAN);
    char text[256];

    say_row(r, text, sizeof text);
    if (isnan(want)) {
        CHECK(!quantity_exists(q), "%s: %s = %.17g should not exist", text,
              column, q->value);
        return;
    }
    CHECK(quantity_exists(q), "%s: %s is missing: %s", text, column, q->reason);
    const double off = fabs(q->value - want), size = fabs(want);
    const double input =
        1.1 * input_cost(r, q) + printed(csv_text(r->csv, column)) * size;
    CHECK(r->rtol > 1.1e-12 ||
              off <= (promise + pow(10.0, d - 15.0)) * size + input,
          "%s: %s = %.17g, not %.17g (%.2g)", text, column, q->value, want,
          off / size);
    CHECK(isfinite(q->error) && q->error > 0.0, "%s: %s has no bar", text,
          column);
    CHECK(off <= q->error + input, "%s: %s = %.17g +- %.2g is off by %.2g",
          text, column, q->value, q->error, off);
    r->tally->bars++;
    r->tally->loose += q->error > 100.0 * fmax(off, 1e-13 * size);
}

/* Of the lower end the row then states nothing: reference/README.md. */
static bool gave_up(const struct csv *c)
{
    return strcmp(csv_text(c, "lower_end"), "psi_minus_inf_truncated") == 0;
}

static void check_ends(const struct row *r)
{
    const struct critical_numbers *n = &r->s->numbers;
    const char *lower = csv_text(r->csv, "lower_end");
    char text[256];

    say_row(r, text, sizeof text);
    CHECK(strcmp(end_names[n->upper_end], csv_text(r->csv, "upper_end")) == 0,
          "%s: upper_end %s", text, end_names[n->upper_end]);
    if (gave_up(r->csv))
        lower = end_names[n->lower_end];
    CHECK(strcmp(end_names[n->lower_end], lower) == 0,
          "%s: lower_end %s, not "
          "%s",
          text, end_names[n->lower_end], lower);
}

static void check_knees(const struct row *r)
{
    const struct critical_numbers *n = &r->s->numbers;
    const double up = lost(r, "digits_lost_alpha_vplus");
    const double low = lost(r, "digits_lost_alpha_lower");

    assert_int_equal(n->crossings_upper,
                     (size_t) csv_number(r->csv, "n_knee_up", 0));
    assert_true(gave_up(r->csv) ||
                n->crossings_lower ==
                    (size_t) csv_number(r->csv, "n_knee_lo", 0));
    check_number(r, "knee_up_v", &n->knee_upper.v, 1e-11, up);
    check_number(r, "knee_up_psi", &n->knee_upper.psi, 1e-11, up);
    check_number(r, "knee_lo_v", &n->knee_lower.v, 1e-11, low);
    check_number(r, "knee_lo_psi", &n->knee_lower.psi, 1e-11, low);
}

static void check_row(const struct row *r, bool all)
{
    const struct critical_numbers *n = &r->s->numbers;
    const double up = lost(r, "digits_lost_alpha_vplus");
    const double low = lost(r, "digits_lost_alpha_lower");

    check_ends(r);
    check_number(r, "v_plus", &n->v_plus, 1e-12, up);
    check_number(r, "v_minus", &n->v_minus, 1e-12, low);
    if (!gave_up(r->csv))
        check_number(r, "psi_at_v0", &n->psi_at_v0, 1e-12, low);
    check_number(r, "x_excess", &n->x_excess, 1e-10, up + 1.0);
    if (csv_text(r->csv, "x_deficit_lower")[0])
        check_number(r, "x_deficit_lower", &n->x_deficit, 1e-10, low + 1.0);
    check_knees(r);
    if (!all)
        return;
    check_number(r, "mu_s_num", &n->mu_s_num, 1e-10, up + 1.0);
    if (csv_text(r->csv, "mu_s_mean")[0]) /* blank where digits ran out */
        check_number(r, "mu_s_mean", &n->mu_s_mean, 1e-10, up + 1.0);
    check_number(r, "G_num", &n->fracture_energy, 1e-10, up + 1.0);
    check_number(r, "v_sp", &r->s->steady.v, 1e-13, up);
    check_number(r, "psi_sp", &r->s->steady.psi, 1e-13, up);
    const double most = fmax(up, low);
    check_number(r, "lambda_minus", &r->s->steady.lambda_minus, 1e-11, most);
    check_number(r, "lambda_plus", &r->s->steady.lambda_plus, 1e-11, most);
}

static size_t check_table(const char *name, double rtol, bool all,
                          struct tally *tally)
{
    struct csv c;
    size_t rows = 0;

    csv_open(&c, name);
    while (csv_next(&c)) {
        struct solved s;
        static struct solved near[2 * INPUTS];
        const struct row r = { &c, &s, rtol, tally, near };
        const bool saddle = csv_number(&c, "has_saddle", 1) > 0;
        const enum status status = solve_row(&s, &c, rtol);
        char text[256];
        say_row(&r, text, sizeof text);
        CHECK(status == STATUS_OK, "%s: %s", text, status_text(status));
        CHECK(s.has_saddle == saddle, "%s: saddle %d", text, s.has_saddle);
        if (saddle) {
            solve_nearby(&c, rtol, near);
            check_row(&r, all);
            for (int i = 0; i < 2 * INPUTS; i++)
                solved_free(&near[i]);
        }
        solved_free(&s);
        rows++;
    }
    return rows;
}

static void bars_are_rarely_loose(const struct tally *t)
{
    print_message("# %zu bars, %zu above 100 times the error\n", t->bars,
                  t->loose);
    CHECK(t->loose * 10 <= t->bars, "%zu of %zu are loose", t->loose, t->bars);
}

static void every_row_is_right_and_inside_its_bars(void **state)
{
    struct tally t = { 0 };

    (void) state;
    assert_int_equal(check_table("manifold.csv", 1e-12, true, &t), 126);
    assert_int_equal(check_table("extreme.csv", 1e-12, true, &t), 82);
    bars_are_rarely_loose(&t);
}

static void bars_cover_the_error_at_every_tolerance(void **state)
{
    static const double rtol[] = { 1e-4, 1e-6, 1e-8, 1e-10 };

    (void) state;
    for (int i = 0; i < 4; i++) {
        struct tally t = { 0 };
        check_table("manifold.csv", rtol[i], false, &t);
        check_table("extreme.csv", rtol[i], false, &t);
        print_message("# rtol %g: %zu bars, %zu loose\n", rtol[i], t.bars,
                      t.loose);
    }
}

/* The median bar of v_plus over the table. */
static double typical_bar(double rtol)
{
    struct csv c;
    double sum = 0.0;
    size_t n = 0;

    csv_open(&c, "manifold.csv");
    while (csv_next(&c)) {
        struct solved s;
        if (solve_row(&s, &c, rtol) == STATUS_OK && s.has_saddle &&
            quantity_exists(&s.numbers.v_plus)) {
            sum += log10(s.numbers.v_plus.error / s.numbers.v_plus.value);
            n++;
        }
        solved_free(&s);
    }
    return pow(10.0, sum / (double) n);
}

static void bars_shrink_with_the_tolerance(void **state)
{
    double last = 1.0;

    (void) state;
    for (int k = 4; k <= 12; k += 2) {
        const double bar = typical_bar(pow(10.0, -k));
        print_message("# rtol 1e-%d: geometric mean bar %.2g\n", k, bar);
        CHECK(bar < 0.1 * last, "rtol 1e-%d: %.3g after %.3g", k, bar, last);
        last = bar;
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_is_right_and_inside_its_bars),
        cmocka_unit_test(bars_cover_the_error_at_every_tolerance),
        cmocka_unit_test(bars_shrink_with_the_tolerance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
