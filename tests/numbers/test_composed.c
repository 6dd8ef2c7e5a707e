/* Composed laws, Kato-Tullis and presets at random parameters against
 * reference/composed.py: right to what was promised, and inside the bars at
 * every accuracy.  Those tables' inputs are the doubles nearest the decimals
 * shown, so nothing is allowed for their rounding. */
#include <math.h>

#include "check.h"
#include "records.h"
#include "reference_rows.h"

enum end { UPPER, LOWER, BOTH };

/* A column of the tables and where its number is; relative error promised at
 * the default accuracy, besides 10^(d - 15 + more). */
static const struct column {
    const char *name;
    size_t offset;
    double promise, more;
    enum end end; /* whose digits are lost to alpha */
} columns[] = {
#define AT(member) offsetof(struct solved, member)
    { "v_sp", AT(steady.v), 1e-13, 0, UPPER },
    { "psi_sp", AT(steady.psi), 1e-13, 0, UPPER },
    { "lambda_minus", AT(steady.lambda_minus), 1e-11, 0, BOTH },
    { "lambda_plus", AT(steady.lambda_plus), 1e-11, 0, BOTH },
    { "v_plus", AT(numbers.v_plus), 1e-12, 0, UPPER },
    { "v_minus", AT(numbers.v_minus), 1e-12, 0, LOWER },
    { "psi_at_v0", AT(numbers.psi_at_v0), 1e-12, 0, LOWER },
    { "knee_up_v", AT(numbers.knee_upper.v), 1e-11, 0, UPPER },
    { "knee_up_psi", AT(numbers.knee_upper.psi), 1e-11, 0, UPPER },
    { "knee_lo_v", AT(numbers.knee_lower.v), 1e-11, 0, LOWER },
    { "knee_lo_psi", AT(numbers.knee_lower.psi), 1e-11, 0, LOWER },
    { "x_excess", AT(numbers.x_excess), 1e-10, 1, UPPER },
    { "x_deficit_lower", AT(numbers.x_deficit), 1e-10, 1, LOWER },
    { "mu_s_num", AT(numbers.mu_s_num), 1e-10, 1, UPPER },
    { "mu_s_mean", AT(numbers.mu_s_mean), 1e-10, 1, UPPER },
    { "G_num", AT(numbers.fracture_energy), 1e-10, 1, UPPER },
#undef AT
};
enum { COLUMNS = sizeof columns / sizeof *columns };

/* What became of all the bars. */
struct tally {
    size_t rows, bars, loose;
    double log_bar; /* sum of log10 of relative bars */
};

struct row {
    const struct csv *csv;
    const struct solved *s;
    double rtol;
    struct tally *tally;
    char name[160];
};

static double digits_lost(const struct row *r, enum end end)
{
    const double up = csv_number(r->csv, "digits_lost_alpha_vplus", 0.0);
    const double low = csv_number(r->csv, "digits_lost_alpha_lower", 0.0);

    return fmax(0.0, end == UPPER ? up : end == LOWER ? low : fmax(up, low));
}

static void check_number(const struct row *r, const struct column *c)
{
    const struct quantity *q = (const void *) ((const char *) r->s + c->offset);
    const char *text = csv_text(r->csv, c->name);
    const double want = csv_number(r->csv, c->name, NAN);

    CHECK(quantity_exists(q) == !isnan(want), "%s: %s = %.17g, not '%s'",
          r->name, c->name, q->value, text);
    if (isnan(want))
        return;
    /* the table's 25 digits, to a long double */
    const double off = (double) fabsl(strtold(text, NULL) - q->value);
    const double size = fabs(want);
    const double promise =
        c->promise + pow(10.0, digits_lost(r, c->end) + c->more - 15.0);
    CHECK(r->rtol > 1e-12 || off <= promise * size,
          "%s: %s = %.17g, not %.17g (%.2g)", r->name, c->name, q->value, want,
          off / size);
    CHECK(isfinite(q->error) && q->error > 0.0, "%s: %s has no bar", r->name,
          c->name);
    CHECK(off <= q->error, "%s: %s = %.17g +- %.2g, not %.17g: off by %.2g",
          r->name, c->name, q->value, q->error, want, off);
    r->tally->bars++;
    r->tally->loose += q->error > 100.0 * fmax(off, 1e-13 * size);
    r->tally->log_bar += log10(q->error / size);
}

static void check_ends(const struct row *r)
{
    const struct critical_numbers *n = &r->s->numbers;

    CHECK(strcmp(end_names[n->upper_end], csv_text(r->csv, "upper_end")) == 0,
          "%s: upper_end %s", r->name, end_names[n->upper_end]);
    CHECK(strcmp(end_names[n->lower_end], csv_text(r->csv, "lower_end")) == 0,
          "%s: lower_end %s", r->name, end_names[n->lower_end]);
    CHECK((double) n->crossings_upper == csv_number(r->csv, "n_knee_up", -1),
          "%s: %zu upper knees", r->name, n->crossings_upper);
    CHECK((double) n->crossings_lower == csv_number(r->csv, "n_knee_lo", -1),
          "%s: %zu lower knees", r->name, n->crossings_lower);
}

static void check_row(const struct csv *csv, double rtol, struct tally *tally)
{
    struct solved s;
    struct row r = { csv, &s, rtol, tally, "" };
    const enum status status = solve_row(&s, csv, rtol);

    snprintf(r.name, sizeof r.name, "row %zu, %s %s alpha %s, rtol %g",
             csv->row, csv_text(csv, "law"), csv_text(csv, "form"),
             csv_text(csv, "alpha"), rtol);
    CHECK(status == STATUS_OK, "%s: %s", r.name, status_text(status));
    CHECK(s.has_saddle, "%s: no saddle", r.name);
    check_ends(&r);
    for (int i = 0; i < COLUMNS; i++)
        check_number(&r, &columns[i]);
    tally->rows++;
    solved_free(&s);
}

/* Every row at 1e-4 ... 1e-12: bars hold, are rarely loose at full accuracy,
 * and shrink with what is asked for. */
static void check_table(const char *name, size_t rows)
{
    double last = HUGE_VAL;

    for (int k = 4; k <= 12; k += 2) {
        struct tally t = { 0 };
        struct csv csv;
        csv_open(&csv, name);
        while (csv_next(&csv))
            check_row(&csv, pow(10.0, -k), &t);
        const double bar = pow(10.0, t.log_bar / (double) t.bars);
        print_message("# %s, rtol 1e-%d: %zu bars, typically %.1e, %zu above "
                      "100 times the error\n",
                      name, k, t.bars, bar, t.loose);
        assert_int_equal(t.rows, rows);
        CHECK(bar < 0.5 * last, "rtol 1e-%d: bar %g after %g", k, bar, last);
        CHECK(k < 12 || 10 * t.loose <= t.bars, "%zu loose bars", t.loose);
        last = bar;
    }
}

static void composed_laws_are_right_and_inside_their_bars(void **state)
{
    (void) state;
    check_table("composed.csv", 18);
}

static void presets_at_random_are_right_and_inside_their_bars(void **state)
{
    (void) state;
    check_table("random.csv", 24);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(composed_laws_are_right_and_inside_their_bars),
        cmocka_unit_test(presets_at_random_are_right_and_inside_their_bars),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
