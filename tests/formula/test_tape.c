/* Tapes of random formulas, written as lines and read in 113 bits, against the
 * formulas as typed; what must not cancel, overflow or be refused. */
#include "tape.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "lines.h"
#include "parse.h"
#include "read_lines.h"

/* What is left when both round: 113 bits less what cancels. */
#define SAME 1e-20

enum { TEXT = 2000 };

struct plane {
    struct formula f;
    struct plane_formulas p;
    struct tape t;
    struct tape_text made;
    struct text_lines out;
    bool positive[2];
};

static struct plane plane;
static int compared;

/* Rates of (x, y), anchored at parameters (x0, y0); y0 may be replaced. */
static enum status lower(const char *dx, const char *dy, const bool positive[2],
                         const char *y0, struct fault *why)
{
    static const char *const name[] = { "x", "y" };
    struct formula *f = &plane.f;

    formula_init(f);
    plane.p = (struct plane_formulas){ .values = 0 };
    formula_leaf(f, "p", FORMULA_POSITIVE_PARAMETER);
    formula_leaf(f, "s", FORMULA_PARAMETER);
    plane.p.chart[0] = formula_leaf(f, "x0", FORMULA_PARAMETER);
    plane.p.chart[1] = formula_leaf(f, "y0", FORMULA_PARAMETER);
    for (int i = 0; i < 2; i++) {
        plane.positive[i] = positive[i];
        plane.p.at[i] = positive[i]
                            ? formula_of(f, FUNCTION_EXP, plane.p.chart[i])
                            : plane.p.chart[i];
        plane.p.state[i] = formula_leaf(
            f, name[i], positive[i] ? FORMULA_POSITIVE_STATE : FORMULA_STATE);
    }
    enum status s = STATUS_OK;
    if (y0) {
        int at = 0;
        formula_define(f, "x", plane.p.at[0]);
        s = formula_parse(f, y0, &at, why);
        formula_define(f, "x", plane.p.state[0]);
        s = s == STATUS_OK ? tape_anchor(f, &plane.p, 1, at, why) : s;
    }
    for (int i = 0; i < 2 && s == STATUS_OK; i++)
        s = formula_parse(f, i ? dy : dx, &plane.p.rate[i], why);
    return s == STATUS_OK ? tape_lower(&plane.t, f, &plane.p, why) : s;
}

/* As lines in X and Y. */
static void write_tape(void)
{
    const int offset[] = { formula_leaf(&plane.f, "X", FORMULA_STATE),
                           formula_leaf(&plane.f, "Y", FORMULA_STATE) };

    text_of_tape(&plane.f, &plane.t, offset, &plane.made);
    const int result[] = { plane.made.rate[0], plane.made.rate[1],
                           plane.made.scale };
    for (int i = 0; i < 3; i++)
        formula_name(&plane.f, result[i],
                     (const char *const[]){ "fx", "fy", "scale" }[i]);
    assert_true(text_write(&plane.f, result, 3, &plane.out));
}

static void know(struct line_scope *s, const char *name, quad value)
{
    line_know(s, name, strlen(name), value);
}

static void read_all(struct line_scope *s)
{
    for (size_t i = 0; i < plane.out.lines; i++)
        know(s, plane.out.line[i].name, line_at(s, plane.out.line[i].text));
}

/* A result may be a number or a name of something else. */
static quad result(const struct line_scope *s, int i)
{
    const int made = i < 2 ? plane.made.rate[i] : plane.made.scale;
    const struct formula_node *n = &plane.f.node[made];

    return n->kind == FORMULA_NUMBER ? n->number : line_at(s, n->name);
}

/* ---- random formulas ----------------------------------------------------- */

static void put(char *text, const char *word)
{
    assert_true(strlen(text) + strlen(word) < TEXT);
    strcat(text, word);
}

static void put_random(char *text, bool positive, int depth, uint64_t *seed);

static void put_pair(char *text, bool positive, const char *sign, int depth,
                     uint64_t *seed)
{
    put(text, "(");
    put_random(text, positive, depth - 1, seed);
    put(text, sign);
    put_random(text, positive, depth - 1, seed);
    put(text, ")");
}

static void put_call(char *text, const char *name, bool positive, int depth,
                     uint64_t *seed)
{
    put(text, name);
    put(text, "((");
    put_random(text, positive, depth - 1, seed);
    put(text, ")/4)");
}

static void put_leaf(char *text, bool positive, uint64_t *seed)
{
    static const char *const plus[] = { "x", "p", "2", "0.375", "x", "y" };
    static const char *const any[] = { "s", "y", "x", "y", "p", "0.75" };
    const bool y = plane.positive[1];

    put(text, positive ? plus[check_bits(seed) % (y ? 6 : 5)]
                       : any[check_bits(seed) % 6]);
}

/* A formula, positive by its form or not, of what has a rule. */
static void put_random(char *text, bool positive, int depth, uint64_t *seed)
{
    if (depth == 0) {
        put_leaf(text, positive, seed);
        return;
    }
    switch (check_bits(seed) % 9) {
        case 0:
            put_pair(text, positive, "*", depth, seed);
            break;
        case 1:
            put_pair(text, true, "/", depth, seed);
            break;
        case 2:
            put_call(text, "exp", false, depth < 2 ? 1 : 2, seed);
            break;
        case 3:
            put_call(text, positive ? "sqrt" : "ln", true, depth, seed);
            break;
        case 4:
            put_call(text, "sinh", positive, depth, seed);
            break;
        case 5:
            put_pair(text, true, positive ? "+" : "-", depth, seed);
            break;
        case 6:
            put_pair(text, positive, positive ? "+" : "-", depth, seed);
            break;
        case 7:
            put_pair(text, positive, "+", depth, seed);
            break;
        default:
            put_leaf(text, positive, seed);
            break;
    }
}

/* As typed; `worst`: all signs turned to plus, a bound on what cancels. */
static quad plain(const struct line_scope *s, const char *text, bool worst)
{
    char copy[TEXT];

    strcpy(copy, text);
    for (char *c = copy; worst && *c; c++)
        *c = *c == '-' ? '+' : *c;
    return line_at(s, copy);
}

/* The state at a point of the chart. */
static void know_state(struct line_scope *s, const quad z[2])
{
    for (int i = 0; i < 2; i++)
        know(s, i ? "y" : "x", plane.positive[i] ? expq(z[i]) : z[i]);
}

/* Differences have digits beside what they are taken from. */
static void check_point(char text[2][TEXT], uint64_t *seed)
{
    struct line_scope s = { .count = 0 };
    const quad at[] = { check_uniform(seed, -1, 1),
                        check_uniform(seed, -1, 1) };
    const quad by[] = { check_uniform(seed, -2, 2),
                        check_uniform(seed, -2, 2) };

    know(&s, "x0", at[0]);
    know(&s, "y0", at[1]);
    know(&s, "X", by[0]);
    know(&s, "Y", by[1]);
    know(&s, "p", check_uniform(seed, 0.1, 3));
    know(&s, "s", check_uniform(seed, -2, 2));
    struct line_scope lines = s, anchor = s;
    know_state(&anchor, at);
    know_state(&s, (quad[]){ at[0] + by[0], at[1] + by[1] });
    read_all(&lines);
    for (int i = 0; i < 2; i++) {
        const quad chart = plane.positive[i] ? plain(&s, i ? "y" : "x", 0) : 1;
        const quad size = fabsq(plain(&s, text[i], true)) +
                          fabsq(plain(&anchor, text[i], true));
        const quad exact = plain(&s, text[i], false),
                   found = result(&lines, i) * chart * expq(result(&lines, 2));
        if (!(size < 1e12 && result(&lines, 2) < 100))
            continue; /* sinh of sinh of sinh */
        CHECK(fabsq(found - exact) <= SAME * fabsq(exact) + 1e-26 * size,
              "%s: %.17g, expected %.17g", text[i], (double) found,
              (double) exact);
        compared++;
    }
}

static void tapes_are_the_formulas_they_were_made_of(void **state)
{
    uint64_t seed = check_seed();
    int lowered = 0;

    (void) state;
    for (int i = 0; i < 1500; i++) {
        const bool positive[] = { true, check_bits(&seed) % 2 == 0 };
        char text[2][TEXT] = { "", "" };
        struct fault why = { "" };
        plane.positive[1] = positive[1];
        for (int k = 0; k < 2; k++)
            put_random(text[k], false, 4, &seed);
        if (lower(text[0], text[1], positive, NULL, &why) != STATUS_OK)
            continue;
        write_tape();
        for (int k = 0; k < 3; k++)
            check_point(text, &seed);
        lowered++;
    }
    CHECK(lowered > 1400 && compared > 2 * 1400, "%d of 1500, %d values",
          lowered, compared);
}

static void whole_powers_and_asinh_have_their_rules(void **state)
{
    const bool positive[] = { true, false };
    uint64_t seed = check_seed();
    struct fault why;

    (void) state;
    assert_int_equal(lower("asinh(x/2*exp(y/3)) - s", "(y - 1)^3 + x^(1/3)",
                           positive, NULL, &why),
                     STATUS_OK);
    write_tape();
    char text[2][TEXT] = { "asinh0(x/2*exp(y/3))-s",
                           "(y-1)*(y-1)*(y-1)+exp(ln(x)/3)" };
    for (int k = 0; k < 50; k++)
        check_point(text, &seed);
}

/* ---- what must not be lost ----------------------------------------------- */

/* fy at an offset, and the scale. */
static quad second_rate(double x0, double X, double Y, quad *scale)
{
    struct line_scope s = { .count = 0 };

    know(&s, "x0", x0);
    know(&s, "X", X);
    know(&s, "Y", Y);
    know(&s, "p", 3);
    read_all(&s);
    *scale = result(&s, 2);
    return result(&s, 1);
}

static void a_rate_that_vanishes_at_the_anchor_is_exactly_zero(void **state)
{
    static const char *const steady[] = { "1/x", "(1+p)/(1/p+x)",
                                          "exp(lambert(x/p))/x" };
    const bool positive[] = { true, true };

    (void) state;
    for (int i = 0; i < 3; i++) {
        char rate[200];
        struct fault why;
        quad scale;
        snprintf(rate, sizeof rate, "-sinh(y - %s)*exp(x)",
                 i == 2 ? "1/x" : steady[i]);
        assert_int_equal(
            lower("1", rate, positive, i == 2 ? "1/x" : steady[i], &why),
            STATUS_OK);
        write_tape();
        assert_true(second_rate(0.7, 0, 0, &scale) == 0);
        const quad near = second_rate(0.7, 0, 1e-25, &scale);
        assert_true(near < 0 && near > -1e-20);
    }
}

/* sinh(y - 1/x) e^(-1/x) = -e^(-y)/2 for small y; 1/x = e^61 */
static void exponents_that_cancel_under_a_sinh_keep_their_digits(void **state)
{
    const bool positive[] = { true, true };
    struct fault why;
    quad scale;

    (void) state;
    assert_int_equal(
        lower("x", "-sinh(y - 1/x)*exp(-1/x)", positive, "1/x", &why),
        STATUS_OK);
    write_tape();
    for (int i = 1; i < 12; i++) {
        const quad fy = second_rate(-1, -60, -i, &scale), ln_y = 1 - i,
                   exact = -expq(ln_y) - ln_y - logq(2);
        CHECK(fabsq(logq(fy) + scale - exact) < 1e-24, "%d: %.17g, not %.17g",
              i, (double) (logq(fy) + scale), (double) exact);
    }
}

/* y - 1/x at 1/x = e^20000, exp(1/x) - y at 1/x = 22026 */
static void sums_are_scaled_before_they_overflow(void **state)
{
    const bool positive[] = { true, true };
    struct fault why;
    quad scale;

    (void) state;
    assert_int_equal(lower("1", "-(y - 1/x)", positive, "1/x", &why),
                     STATUS_OK);
    write_tape();
    quad fy = second_rate(0, -20000, 1, &scale);
    assert_true(fy > 0 && fy <= 1);
    assert_true(fabsq(logq(fy) + scale - 19999) < 1e-24);
    assert_int_equal(lower("1", "y*(exp(1/x) - ln(y))", positive, NULL, &why),
                     STATUS_OK);
    write_tape();
    struct line_scope s = { .count = 0 };
    know(&s, "x0", 0);
    know(&s, "y0", 0);
    know(&s, "X", -10);
    know(&s, "Y", 1);
    read_all(&s);
    fy = result(&s, 1);
    assert_true(fy > 0 && fy <= 2);
    assert_true(fabsq(logq(fy) + result(&s, 2) - expq(10)) < 1e-24);
}

static void what_has_no_rule_is_refused_in_one_line(void **state)
{
    static const char *const wrong[] = { "lambert(x)",
                                         "x + sin(lambert(y - x))" };
    const bool positive[] = { true, false };

    (void) state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct fault why = { "" };
        assert_int_equal(lower(wrong[i], "1", positive, NULL, &why),
                         STATUS_BAD_ARGUMENT);
        assert_true(strncmp(why.text, "the formula cannot be used: ", 28) == 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tapes_are_the_formulas_they_were_made_of),
        cmocka_unit_test(whole_powers_and_asinh_have_their_rules),
        cmocka_unit_test(a_rate_that_vanishes_at_the_anchor_is_exactly_zero),
        cmocka_unit_test(exponents_that_cancel_under_a_sinh_keep_their_digits),
        cmocka_unit_test(sums_are_scaled_before_they_overflow),
        cmocka_unit_test(what_has_no_rule_is_refused_in_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
