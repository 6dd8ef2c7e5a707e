/* Runs of Figs 14 and 15 against transient.csv. */
#include "followed.h"
#include "sample.h"

/* All levels of the table, in two sets. */
enum { SETS = 2 };
static const struct moment_level levels[SETS][MOMENT_LEVELS_MAX] = {
    { { MOMENT_MU_NEARS, 0.1 },
      { MOMENT_MU_NEARS, 0.01 },
      { MOMENT_MU_NEARS, 1e-3 },
      { MOMENT_MU_NEARS, 1e-4 },
      { MOMENT_MU_NEARS, 1e-5 },
      { MOMENT_MU_NEARS, 1e-7 },
      { MOMENT_MU_NEARS, 3e-6 } },
    { { MOMENT_V, 100 },
      { MOMENT_V, 1 },
      { MOMENT_V, 0.01 },
      { MOMENT_V, 1e-5 },
      { MOMENT_V, 1e-10 },
      { MOMENT_PSI, 90 },
      { MOMENT_MU_NEARS, 0.03 } },
};

static const struct {
    const char *kind;
    enum moment what;
} kinds[] = {
    { "v_sp_crossing", MOMENT_V_SP },
    { "v_minus_crossing", MOMENT_V_MINUS },
    { "psi_minimum", MOMENT_PSI_MIN },
    { "mu_minus_tan_below", MOMENT_MU_NEARS },
    { "mu_minus_tan_above", MOMENT_MU_LEAVES },
    { "v_equals", MOMENT_V },
    { "v_equals_final", MOMENT_V },
    { "psi_rising_to", MOMENT_PSI },
};

/* The runs of one law and form. */
struct table_runs {
    struct slope slope;
    struct transient t[SETS];
    double tolerance; /* relative */
    int rows;
};

static void start_runs(struct table_runs *r, const struct csv *c,
                       const char *rtol)
{
    const char *const more[] = { "products=[knees]", rtol, NULL };
    const bool creeps = strcmp(csv_text(c, "law"), "spinodal_gen") == 0;

    slope_make(&r->slope, csv_text(c, "law"), csv_text(c, "form"), "0.34",
               more);
    for (int i = 0; i < SETS; i++) {
        struct transient_options o = transient_defaults(&r->slope.scene);
        o.level = levels[i];
        o.levels = MOMENT_LEVELS_MAX;
        o.until_time = creeps ? 1e6 : 0.0;
        r->t[i] = follow(&r->slope, pow(10, 3.1), 100, &o);
        CHECK(r->t[i].sum.end ==
                  (creeps ? TRANSIENT_UNTIL_TIME : TRANSIENT_REST),
              "%s", transient_end_names[r->t[i].sum.end]);
    }
}

static void end_runs(struct table_runs *r)
{
    for (int i = 0; i < SETS; i++)
        transient_free(&r->t[i]);
    slope_free(&r->slope);
}

static bool has_level(const struct transient_event *e, double level)
{
    return isnan(e->level) || e->what <= MOMENT_V_PLUS ||
           fabs(e->level - level) <= 1e-12 * level;
}

/* The event of the row; NULL if it was not seen. */
static const struct transient_event *event_of(const struct table_runs *r,
                                              enum moment what,
                                              const struct csv *c)
{
    const double key = csv_number(c, "key", 0), t = csv_number(c, "t", 0);
    const struct transient_event *best = NULL;

    for (int k = 0; k < SETS; k++)
        for (size_t i = 0; i < r->t[k].events; i++) {
            const struct transient_event *e = &r->t[k].event[i];
            if (e->what == (int8_t) what && has_level(e, key) &&
                (best == NULL ||
                 fabs(e->time.value - t) < fabs(best->time.value - t)))
                best = e;
        }
    return best;
}

/* A level of mu - tan(alpha) is known to some roundings of mu along the slow
 * curve (runs at 16 tolerances near the finest scatter by 30), which moves the
 * event by that over the rate, per ln(t), of what is watched. */
static double allowance(const struct table_runs *r,
                        const struct transient_event *e)
{
    const double step = 1e-3 * e->time.value;
    const struct trajectory_row a =
        sample_at_time(&r->slope.study.slider, &r->t[0], e->time.value - step);
    const struct trajectory_row b =
        sample_at_time(&r->slope.study.slider, &r->t[0], e->time.value + step);

    if (e->what != MOMENT_MU_NEARS && e->what != MOMENT_MU_LEAVES)
        return 0.0;
    return 4e-15 * e->mu.value / (fabs(b.mu - a.mu) / 2e-3);
}

static void is_near(const struct csv *c, const char *column, double found,
                    double tolerance)
{
    const double expected = csv_number(c, column, 0);

    CHECK(fabs(found - expected) <= tolerance * fabs(expected),
          "row %zu (%s %s), %s: %.17g, expected %.17g, off by %.1e of it "
          "(%.1e)",
          c->row, csv_text(c, "kind"), csv_text(c, "key"), column, found,
          expected, fabs(found / expected - 1.0), tolerance);
}

static void check_event(const struct table_runs *r, enum moment what,
                        const struct csv *c)
{
    const struct transient_event *e = event_of(r, what, c);

    CHECK(e != NULL, "row %zu: no such event", c->row);
    const double tolerance = r->tolerance + allowance(r, e);
    const struct {
        const char *column;
        const struct quantity *q;
    } part[] = { { "t", &e->time },
                 { "x", &e->slip },
                 { "v", &e->v },
                 { "psi", &e->psi },
                 { "mu", &e->mu } };
    for (int i = 0; i < 5; i++) {
        const double expected = csv_number(c, part[i].column, 0);
        is_near(c, part[i].column, part[i].q->value, tolerance);
        CHECK(fabs(part[i].q->value - expected) <=
                  part[i].q->error + 2.0 * allowance(r, e) * expected,
              "row %zu (%s), %s: %.17g, expected %.17g, bar %.1e, off %.1e",
              c->row, csv_text(c, "kind"), part[i].column, part[i].q->value,
              expected, part[i].q->error, part[i].q->value - expected);
    }
}

static void check_sample(const struct table_runs *r, const struct csv *c)
{
    const bool timed = strcmp(csv_text(c, "kind"), "time") == 0;
    const double key = csv_number(c, "key", 0);
    const struct trajectory_row at =
        timed ? sample_at_time(&r->slope.study.slider, &r->t[0], key)
              : sample_at_slip(&r->slope.study.slider, &r->t[0], key);

    is_near(c, "t", at.time, r->tolerance);
    is_near(c, "x", at.slip, r->tolerance);
    is_near(c, "v", at.v, r->tolerance);
    is_near(c, "psi", at.psi, r->tolerance);
    is_near(c, "mu", at.mu, r->tolerance);
}

/* Minima of mu are flat: their places are exempt, their values are not. */
static void check_table_row(struct table_runs *r, const struct csv *c)
{
    const char *kind = csv_text(c, "kind");

    r->rows++;
    if (strcmp(kind, "time") == 0 || strcmp(kind, "slip") == 0)
        check_sample(r, c);
    else if (strcmp(kind, "mu_minimum") == 0)
        is_near(c, "mu", event_of(r, MOMENT_MU_MIN, c)->mu.value, 1e-13);
    else if (strcmp(kind, "initial") != 0)
        for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
            if (strcmp(kind, kinds[i].kind) == 0)
                check_event(r, kinds[i].what, c);
}

static void check_table(const char *rtol, double tolerance)
{
    struct table_runs r = { .tolerance = tolerance };
    struct csv c;
    char law[64] = "";

    csv_open(&c, "transient.csv");
    while (csv_next(&c)) {
        char name[64];
        snprintf(name, sizeof name, "%s %s", csv_text(&c, "law"),
                 csv_text(&c, "form"));
        if (strcmp(name, law) != 0) {
            if (law[0])
                end_runs(&r);
            strcpy(law, name);
            start_runs(&r, &c, rtol);
        }
        check_table_row(&r, &c);
    }
    end_runs(&r);
    CHECK(r.rows >= 250, "%d rows", r.rows);
}

static void every_reference_row_holds_at_the_default_accuracy(void **state)
{
    (void) state;
    check_table("accuracy.rtol=1e-12", 1e-8);
}

static void every_reference_row_holds_at_the_tightest_accuracy(void **state)
{
    (void) state;
    check_table("accuracy.rtol=1e-14", 1e-11);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_reference_row_holds_at_the_default_accuracy),
        cmocka_unit_test(every_reference_row_holds_at_the_tightest_accuracy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
