/* Proofs beside bars. */
#include "study_proof.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "proof_tolerance.h"
#include "slope.h"

static void run(struct slope *s, const char *law)
{
    static const char *const numbers[] = { "products=[equilibria, knees]",
                                           NULL };

    slope_make(s, law, NULL, "0.34", numbers);
}

static void each_bar_of_a_slope_meets_what_is_proved(void **state)
{
    static const char *const laws[] = { "dieterich_gen", "ruina", "perrin",
                                        "spinodal_gen" };
    static struct slope s;

    (void) state;
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        run(&s, laws[i]);
        assert_int_equal(study_prove(&s.study), STATUS_OK);
        assert_string_equal(s.study.proof.lie.text, "");
        const struct quantity *v = &s.study.saddle_numbers.v;
        assert_non_null(v->proved);
        assert_null(v->proved->not_proved);
        CHECK(v->proved->hi - v->proved->lo <= 1e-15 * v->value, "%s: %g",
              laws[i], v->proved->hi - v->proved->lo);
        slope_free(&s);
    }
}

/* How many numbers of a record are proved: each in its bar. */
static int in_bars(const struct record_type *type, const void *record,
                   const char *at)
{
    const struct record_array one = { type, record, 1 };
    int proved = 0;

    for (size_t i = 0; i < type->count; i++) {
        const struct record_field *f = &type->fields[i];
        const struct quantity *q = record_member(&one, 0, f);
        if (f->kind != RECORD_QUANTITY || !q->proved || q->proved->absent ||
            q->proved->not_proved)
            continue;
        const long double v = q->value, e = q->error;
        CHECK(v - e <= q->proved->lo && q->proved->hi <= v + e,
              "%s: %s: %.17Lg +- %.17Lg", at, f->name, v, e);
        proved++;
    }
    return proved;
}

/* Where rounding alpha moves numbers by more than they are computed to. */
static void bars_of_the_decimals_hold_what_is_proved_at_folds(void **state)
{
    static const char *const laws[] = { "spinodal_gen", "spinodal_phi_gen" };
    static struct slope s;
    char alpha[40];

    (void) state;
    for (int i = 0; i < 8; i++) {
        const char *law = laws[i % 2];
        run(&s, law);
        const struct fold_numbers folds = s.study.folds;
        slope_free(&s);
        snprintf(alpha, sizeof alpha, "%.17g",
                 i / 2 % 2 ? folds.alpha_cM.value - (i / 4 ? 1e-10 : 1e-12)
                           : folds.alpha_cm.value + (i / 4 ? 1e-10 : 1e-12));
        slope_make(&s, law, NULL, alpha,
                   (const char *const[]){ "products=[knees]", NULL });
        const double computed = s.study.saddle_numbers.v.error;
        assert_int_equal(study_prove(&s.study), STATUS_OK);
        assert_string_equal(s.study.proof.lie.text, "");
        const int proved =
            in_bars(&record_saddle, &s.study.saddle_numbers, alpha) +
            in_bars(&record_steady, &s.study.slider.steady[1], alpha) +
            in_bars(&record_critical, &s.study.slider.critical, alpha);
        CHECK(proved >= 15 && s.study.saddle_numbers.v.error > computed,
              "%s at %s: %d", law, alpha, proved);
        slope_free(&s);
    }
}

/* A scene of scenes/, its equilibria and its manifold alone. */
static void run_scene(struct slope *s, const char *name)
{
    char path[4096], sets[] = "products=[knees]";
    char *set[] = { sets };
    struct fault why;

    snprintf(path, sizeof path, "%s/scenes/%s.yaml", getenv("SOURCE_ROOT"),
             name);
    CHECK(scene_read(&s->scene, path, set, 1, &why) == STATUS_OK, "%s",
          why.text);
    CHECK(study_run(&s->study, &s->scene, NULL, &why) == STATUS_OK, "%s",
          why.text);
    assert_int_equal(study_prove(&s->study), STATUS_OK);
    assert_string_equal(s->study.proof.lie.text, "");
}

/* All that is there, to 1e-11, and that the others are not. */
static void is_proved(const char *name, const char *what,
                      const struct quantity *q)
{
    const struct proved *p = q->proved;

    CHECK(p && p->not_proved == NULL && p->absent == !quantity_exists(q),
          "%s: %s: %s", name, what, p ? p->not_proved : "");
    CHECK(p->absent || p->hi - p->lo <= 1e-11 * fabs(q->value), "%s: %s: %g",
          name, what, p->hi - p->lo);
}

static void laws_of_the_literature_are_proved(void **state)
{
    static const char *const names[] = { "okubo",       "prz",
                                         "ageing_slip", "flash_heating",
                                         "n_shaped",    "bowden_tabor" };
    static struct slope s;

    (void) state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        run_scene(&s, names[i]);
        const struct critical_numbers *c = &s.study.slider.critical;
        is_proved(names[i], "v_plus", &c->v_plus);
        is_proved(names[i], "v_minus", &c->v_minus);
        is_proved(names[i], "psi_at_v0", &c->psi_at_v0);
        is_proved(names[i], "x_excess", &c->x_excess);
        is_proved(names[i], "x_deficit", &c->x_deficit);
        is_proved(names[i], "lambda_plus", &s.study.saddle_numbers.lambda_plus);
        slope_free(&s);
    }
}

/* With x = ln v 0.35 - 0.01 x + x^3/2^17 = 0.4 where the block is at rest: the
 * saddle is at v < 1. */
static void whole_powers_of_what_is_negative_are_proved(void **state)
{
    static const char *const sets[] = {
        "law.mu=mu_star + a*ln(v) + k*ln(v)^3 + b*ln(psi)",
        "law.psi_ss=1/v",
        "law.rate=1 - v*psi",
        "material.mu_star=0.35",
        "material.k=7.62939453125e-6",
        "material.a=0.01",
        "material.b=0.02",
        "slope.tan_alpha=0.4",
        "products=[knees]",
    };
    enum { SETS = sizeof sets / sizeof *sets };
    static struct slope s;
    char text[SETS][80], *set[SETS];
    struct fault why;
    long double level[2];

    (void) state;
    for (int i = 0; i < SETS; i++)
        strcpy(set[i] = text[i], sets[i]);
    CHECK(scene_read(&s.scene, NULL, set, SETS, &why) == STATUS_OK &&
              study_run(&s.study, &s.scene, NULL, &why) == STATUS_OK,
          "%s", why.text);
    assert_int_equal(study_prove(&s.study), STATUS_OK);
    assert_string_equal(s.study.proof.lie.text, "");
    const struct saddle_numbers *n = &s.study.saddle_numbers;
    is_proved("ln(v)^3", "v", &n->v);
    is_proved("ln(v)^3", "psi", &n->psi);
    is_proved("ln(v)^3", "psi_at_v0", &s.study.slider.critical.psi_at_v0);
    is_proved("ln(v)^3", "v_plus", &s.study.slider.critical.v_plus);
    for (int i = 0; i < 2; i++) {
        const long double x = logl(i ? n->v.proved->hi : n->v.proved->lo);
        level[i] = 0.35L - 0.01L * x + ldexpl(x * x * x, -17);
    }
    CHECK(level[0] > 0.4L && 0.4L > level[1], "%.20Lg %.20Lg", level[0],
          level[1]);
    slope_free(&s);
}

/* psi falls and rises beyond Nagata's: friction's own rate is in psi's. */
static void what_a_law_does_not_have_is_said_and_nothing_proved(void **state)
{
    static struct slope s;

    (void) state;
    run_scene(&s, "nagata");
    const struct proved *p = s.study.slider.critical.v_plus.proved;
    assert_non_null(p);
    CHECK(p->not_proved && strstr(p->not_proved, "psi is not proved"), "%s",
          p->not_proved);
    assert_false(p->absent);
    assert_null(s.study.saddle_numbers.v.proved->not_proved);
    slope_free(&s);
}

/* Ruina's lower branch has no limit here, and 63,529 cells. */
static void a_branch_without_an_end_is_followed_through_so_many_cells(
    void **state)
{
    static struct slope s;

    (void) state;
    slope_make(&s, "ruina", NULL, "0.05", (const char *const[]){ NULL });
    const struct proof_inputs in = study_proof_inputs(s.study.scene);
    struct proof p;
    assert_int_equal(proof_at(&s.study.slider.block, &in, &p), STATUS_OK);
    CHECK(p.branch[1].cells > PROOF_CELLS &&
              p.branch[1].cells <= PROOF_CELLS + 2 / PROOF_CELL_LEAST,
          "%zu", p.branch[1].cells);
    CHECK(strstr(p.branch[1].not_proved, "rate of psi"), "%s",
          p.branch[1].not_proved);
    proof_free(&p);
    slope_free(&s);
}

/* By 1e-9 of itself, which no bar here allows. */
static void move(struct quantity *q)
{
    q->value *= 1 + 1e-9;
}

static void a_bar_beside_what_is_proved_is_told_by_name(void **state)
{
    static struct slope s;

    (void) state;
    run(&s, "perrin");
    move(&s.study.slider.critical.x_excess);
    assert_int_equal(study_prove(&s.study), STATUS_OK);
    CHECK(strstr(s.study.proof.lie.text, "x_excess"), "%s",
          s.study.proof.lie.text);
    const struct proved *p = s.study.slider.critical.v_plus.proved;
    assert_true(p[0].lo > 307 && p[0].not_proved == NULL);
    study_proof_withdraw(&s.study.proof);
    assert_string_equal(p[0].not_proved, s.study.proof.lie.text);
    assert_string_equal(p[1].not_proved, s.study.proof.lie.text);
    slope_free(&s);
    run(&s, "perrin");
    move(&s.study.saddle_numbers.lambda_plus);
    assert_int_equal(study_prove(&s.study), STATUS_OK);
    CHECK(strstr(s.study.proof.lie.text, "lambda_plus"), "%s",
          s.study.proof.lie.text);
    slope_free(&s);
}

static void a_number_that_is_proved_to_be_none_is_told_too(void **state)
{
    static struct slope s;

    (void) state;
    run(&s, "ruina");
    s.study.slider.critical.v_plus = quantity_of(1e9, 1.0);
    assert_int_equal(study_prove(&s.study), STATUS_OK);
    CHECK(strstr(s.study.proof.lie.text, "v_plus"), "%s",
          s.study.proof.lie.text);
    slope_free(&s);
}

/* ---- labels -------------------------------------------------------------- */

static void map_at(struct slope *s, const char *law, const char *alpha,
                   const char *cells)
{
    const char *const more[] = { "products=[equilibria, basins]", cells,
                                 "basins.audit=0", "accuracy.proved=true",
                                 NULL };

    slope_make(s, law, NULL, alpha, more);
}

static void map(struct slope *s, const char *law, const char *cells)
{
    map_at(s, law, "0.34", cells);
}

static void count_words(const struct study *s, size_t count[LABEL_PROOFS])
{
    const size_t n = s->basins.rows * s->basins.columns;
    int8_t *word = calloc(n, 1);

    assert_non_null(word);

    assert_int_equal(basin_map_rows(&s->basins, 0, s->basins.rows, word),
                     STATUS_OK);
    basin_proof_rows(s, 0, s->basins.rows, word);
    for (size_t i = 0; i < n; i++)
        count[word[i]]++;
    free(word);
}

static void every_label_away_from_the_manifold_is_proved(void **state)
{
    static const char *const laws[] = { "spinodal_gen", "dieterich", "perrin",
                                        "dieterich_gen" };
    static struct slope s;

    (void) state;
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        size_t count[LABEL_PROOFS] = { 0 };
        map(&s, laws[i], "basins.cells=[90, 70]");
        const struct basin_proof *b = &s.study.label_proof;
        assert_string_equal(s.study.proof.lie.text, "");
        assert_null(b->reason);
        assert_int_equal(b->near + b->beyond, 0);
        CHECK(b->fraction >= 1, "%s: %g", laws[i], b->fraction);
        count_words(&s.study, count);
        assert_int_equal(count[LABEL_PROVED], 90 * 70);
        slope_free(&s);
    }
}

/* A tube that ends early, and a cell that is less than a unit of the last digit
 * away from the manifold. */
static void cells_beyond_or_beside_the_tube_are_not_proved(void **state)
{
    static struct slope s;
    size_t count[LABEL_PROOFS] = { 0 };

    (void) state;
    map(&s, "spinodal_gen", "basins.cells=[90, 70]");
    struct proof *p = s.study.proof.exact;
    struct study_proof *k = &s.study.proof;
    const struct proof_branch whole = p->branch[0];
    p->branch[0].end = -1;
    p->branch[0].pieces = 3;
    basin_proof_free(&s.study.label_proof);
    assert_int_equal(basin_prove(&s.study), STATUS_OK);
    const int64_t beyond = s.study.label_proof.beyond;
    CHECK(beyond > 90 && beyond < 90 * 35, "%lld", (long long) beyond);
    p->branch[0] = whole;
    for (size_t i = 0; i < p->branch[0].cells; i++)
        p->branch[0].cell[i].radius = 0.1;
    basin_proof_free(&s.study.label_proof);
    assert_int_equal(basin_prove(&s.study), STATUS_OK);
    CHECK(s.study.label_proof.near > 5 && s.study.label_proof.near < 300,
          "%lld", (long long) s.study.label_proof.near);
    count_words(&s.study, count);
    assert_int_equal(count[LABEL_NEAR], s.study.label_proof.near);
    assert_int_equal(count[LABEL_BEYOND], s.study.label_proof.beyond);
    assert_string_equal(k->lie.text, "");
    slope_free(&s);
}

static void a_label_that_is_proved_another_is_told(void **state)
{
    static struct slope s;

    (void) state;
    map(&s, "spinodal_gen", "basins.cells=[9, 7]");
    struct regions *r = &s.study.basins.labels.regions;
    for (size_t i = 0; i < r->count; i++)
        if (r->region[i].label == FATE_CREEP)
            r->region[i].label = FATE_REST_FINITE;
    basin_proof_free(&s.study.label_proof);
    assert_int_equal(basin_prove(&s.study), STATUS_OK);
    CHECK(strstr(s.study.proof.lie.text, "basin: another label"), "%s",
          s.study.proof.lie.text);
    slope_free(&s);
}

/* At 1.56 the node is at v = 1e1000. */
static void without_a_saddle_all_labels_are_proved_or_none(void **state)
{
    static const struct {
        const char *law, *alpha;
        double fraction;
    } at[] = { { "spinodal_gen", "0.2", 1 },
               { "spinodal", "0.6", 1 },
               { "spinodal", "1.56", 0 } };
    static struct slope s;

    (void) state;
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        map_at(&s, at[i].law, at[i].alpha, "basins.cells=[9, 7]");
        const struct basin_proof *b = &s.study.label_proof;
        assert_string_equal(s.study.proof.lie.text, "");
        CHECK(b->fraction == at[i].fraction && !b->reason == (b->fraction > 0),
              "%s at %s: %g: %s", at[i].law, at[i].alpha, b->fraction,
              b->reason ? b->reason : "");
        slope_free(&s);
    }
    map_at(&s, "spinodal_gen", "0.2", "basins.cells=[9, 7]");
    struct regions *r = &s.study.basins.labels.regions;
    for (size_t i = 0; i < r->count; i++)
        r->region[i].label = FATE_SLIDING;
    basin_proof_free(&s.study.label_proof);
    assert_int_equal(basin_prove(&s.study), STATUS_OK);
    CHECK(strstr(s.study.proof.lie.text, "another label is proved of 63"), "%s",
          s.study.proof.lie.text);
    slope_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_bar_of_a_slope_meets_what_is_proved),
        cmocka_unit_test(bars_of_the_decimals_hold_what_is_proved_at_folds),
        cmocka_unit_test(laws_of_the_literature_are_proved),
        cmocka_unit_test(whole_powers_of_what_is_negative_are_proved),
        cmocka_unit_test(what_a_law_does_not_have_is_said_and_nothing_proved),
        cmocka_unit_test(
            a_branch_without_an_end_is_followed_through_so_many_cells),
        cmocka_unit_test(a_bar_beside_what_is_proved_is_told_by_name),
        cmocka_unit_test(a_number_that_is_proved_to_be_none_is_told_too),
        cmocka_unit_test(every_label_away_from_the_manifold_is_proved),
        cmocka_unit_test(cells_beyond_or_beside_the_tube_are_not_proved),
        cmocka_unit_test(a_label_that_is_proved_another_is_told),
        cmocka_unit_test(without_a_saddle_all_labels_are_proved_or_none),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
