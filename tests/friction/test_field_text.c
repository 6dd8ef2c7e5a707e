/* The field as text, read back and evaluated in 113 bits, against the formulas
 * of the law in 113 bits (quad_tape.h): for every law they are the same. */
#include "field_text.h"

#include <ctype.h>
#include <string.h>

#include "read_lines.h"
#include "setting.h"

/* What is left when both round: 113 bits less what cancels. */
#define SAME 1e-20

static void know_name(struct line_scope *s, const char *name, quad value)
{
    line_know(s, name, strlen(name), value);
}

/* The parameters as the exact anchor of the setting has them. */
static void know_parameters(struct line_scope *s, const struct setting *set)
{
    for (int p = 0; p < TEXT_PARAMETERS; p++)
        know_name(
            s, text_parameters[p].name,
            (quad) text_parameter_value(&set->b, (enum text_parameter) p));
    know_name(s, "lnv0", (quad) set->x);
    know_name(s, "eps2",
              (quad) set->m.V_star * (quad) set->m.V_star /
                  ((quad) set->m.g * (quad) set->m.L));
    s->tangent = set->exact_tan;
}

static quad known(const struct line_scope *s, const char *name)
{
    return line_at(s, name);
}

static void check_near(const struct setting *set, const char *what, quad found,
                       quad expected)
{
    const double difference = (double) fabsq(found - expected),
                 size = (double) fabsq(expected);

    CHECK(difference <= SAME * size, "law %zu, %s: %.17g, expected %.17g",
          set->number, what, (double) found, (double) expected);
}

static void check_state(const struct setting *set, const struct field_text *f,
                        const struct line_scope *constants, quad X, quad Y)
{
    struct line_scope s = *constants;
    struct quad_field exact;

    know_name(&s, text_state_name(&set->law, 0), set->at.x0 + X);
    know_name(&s, text_state_name(&set->law, 1), set->at.y0 + Y);
    for (size_t i = 0; i < f->lines.lines; i++)
        if (f->lines.line[i].moves)
            know_name(&s, f->lines.line[i].name,
                      line_at(&s, f->lines.line[i].text));
    quad_block_field(&set->at, X, Y, &exact);
    const quad size = expq(known(&s, "scale") - exact.log_scale);
    check_near(set, "fx", known(&s, "fx") * size, exact.direction[0]);
    check_near(set, "fy", known(&s, "fy") * size, exact.direction[1]);
    check_near(set, "mu", known(&s, "mu"),
               quad_block_rate(&set->at, BLOCK_WORK, X, Y) /
                   quad_block_rate(&set->at, BLOCK_SLIP, X, Y));
}

static void check_setting(const struct setting *set, uint64_t *seed)
{
    struct line_scope constants = { .count = 0 };
    struct field_text f;

    field_text(&set->law, &f);
    know_parameters(&constants, set);
    for (size_t i = 0; i < f.lines.lines; i++)
        if (!f.lines.line[i].moves)
            know_name(&constants, f.lines.line[i].name,
                      line_at(&constants, f.lines.line[i].text));
    for (int i = 0; i < 6; i++) {
        const double size = laws_power(seed, -3, 1);
        check_state(set, &f, &constants, check_uniform(seed, -size, size),
                    check_uniform(seed, -size, size));
    }
}

static void text_is_the_formula_of_every_law(void **state)
{
    uint64_t seed = check_seed();
    struct setting set;
    size_t checked = 0;

    (void) state;
    for (size_t i = 0; i < 4 * LAWS; i++) {
        if (!draw_setting(i, 5.0, &seed, &set))
            continue;
        check_setting(&set, &seed);
        checked++;
    }
    CHECK(checked > 3 * LAWS, "%zu of %d", checked, 4 * LAWS);
}

/* The anchor moves, the field stays: what makes parameters free to change. */
static void any_anchor_gives_the_same_field(void **state)
{
    uint64_t seed = check_seed();
    struct setting set, other;
    size_t checked = 0;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        struct line_scope s = { .count = 0 };
        struct field_text f;
        if (!draw_setting(i, 5.0, &seed, &set))
            continue;
        other = set;
        if (!set_anchor(&other, (double) set.x - 0.5, set.tan_alpha, false))
            continue;
        field_text(&set.law, &f);
        know_parameters(&s, &set);
        know_name(&s, "lnv0", (quad) other.x);
        for (size_t k = 0; k < f.lines.lines; k++)
            if (!f.lines.line[k].moves)
                know_name(&s, f.lines.line[k].name,
                          line_at(&s, f.lines.line[k].text));
        check_state(&set, &f, &s, (quad) 0.7, (quad) -0.3);
        checked++;
    }
    CHECK(checked > LAWS / 2, "%zu of %d", checked, LAWS);
}

/* ---- names --------------------------------------------------------------- */

static bool same_word(const char *a, const char *b)
{
    for (; *a && *b; a++, b++)
        if (tolower((unsigned char) *a) != tolower((unsigned char) *b))
            return false;
    return *a == *b;
}

/* Words with a meaning of their own: in XPPAUT t, pi and functions; in C. */
static const char *const reserved[] = {
    "t",    "pi",   "e",     "i",     "if",       "then", "else",   "sin",
    "cos",  "tan",  "exp",   "ln",    "log",      "sqrt", "abs",    "max",
    "min",  "heav", "sign",  "ran",   "flr",      "mod",  "delay",  "shift",
    "sum",  "of",   "int",   "not",   "set",      "done", "normal", "erf",
    "init", "aux",  "par",   "table", "only",     "dir",  "norm",   "speed",
    "v",    "u",    "f",     "par",   "icp",      "ijac", "ndim",   "dfdu",
    "dfdp", "void", "const", "slope", "friction",
};

static void check_name(const char *name, const char *const taken[],
                       size_t count)
{
    CHECK(strlen(name) <= 9, "%s is longer than 9 letters", name);
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; i++)
        CHECK(!same_word(name, reserved[i]), "%s is reserved", name);
    for (int i = 0; i < FUNCTIONS; i++)
        CHECK(!same_word(name, functions[i].name), "%s: a function", name);
    for (size_t i = 0; i < count; i++)
        CHECK(!same_word(name, taken[i]), "%s, %s", name, taken[i]);
}

static void names_are_short_and_no_two_are_alike(void **state)
{
    const char *taken[TEXT_PARAMETERS + 2 + TEXT_LINES];
    struct field_text f;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        const struct law law = laws_at(i);
        size_t count = 0;
        field_text(&law, &f);
        for (int p = 0; p < TEXT_PARAMETERS; p++)
            taken[count++] = text_parameters[p].name;
        taken[count++] = text_state_name(&law, 0);
        taken[count++] = text_state_name(&law, 1);
        for (size_t k = 0; k < f.lines.lines; k++) {
            check_name(f.lines.line[k].name, taken, count);
            taken[count++] = f.lines.line[k].name;
        }
        for (size_t k = 0; k < count - f.lines.lines; k++)
            check_name(taken[k], taken, k);
    }
}

static void a_law_names_what_it_uses(void **state)
{
    struct field_text f;

    (void) state;
    for (size_t i = 0; i < LAWS; i++) {
        const struct law law = laws_at(i);
        field_text(&law, &f);
        assert_true(f.uses[TEXT_ALPHA] && f.uses[TEXT_A] && f.uses[TEXT_B]);
        assert_int_equal(f.uses[TEXT_C], law_uses(&law, MATERIAL_C));
        assert_int_equal(f.uses[TEXT_V_C], law_uses(&law, MATERIAL_V_C));
        if (f.uses[TEXT_R])
            assert_true(law_uses(&law, MATERIAL_R));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(text_is_the_formula_of_every_law),
        cmocka_unit_test(any_anchor_gives_the_same_field),
        cmocka_unit_test(names_are_short_and_no_two_are_alike),
        cmocka_unit_test(a_law_names_what_it_uses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
