#include "parse.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

struct reader {
    struct formula *f;
    const char *text, *at;
    int depth;
    bool failed;
    struct fault *why;
};

/* ---- complaints ---------------------------------------------------------- */

/* The first counts; after it everything is read as 0, at the end. */
__attribute__((format(printf, 3, 4))) static int blame(struct reader *r,
                                                       const char *at,
                                                       const char *format, ...)
{
    int line = 1, column = 1;
    va_list words;

    if (r->failed)
        return 0;
    for (const char *c = r->text; c < at; c++) {
        column = *c == '\n' ? 1 : column + 1;
        line += *c == '\n';
    }
    const int n = snprintf(r->why->text, sizeof r->why->text,
                           "line %d, column %d: ", line, column);
    va_start(words, format);
    vsnprintf(r->why->text + n, sizeof r->why->text - (size_t) n, format,
              words);
    va_end(words);
    r->failed = true;
    r->at += strlen(r->at);
    return 0;
}

/* What stands there, for a message. */
static int blame_letter(struct reader *r, const char *expected)
{
    const unsigned char letter = (unsigned char) *r->at;

    if (letter == '\0')
        return blame(r, r->at, "the formula ends, expected %s", expected);
    if (letter < ' ' || letter > '~')
        return blame(r, r->at, "byte %d, expected %s", letter, expected);
    if (strchr("<>=!&|", letter))
        return blame(r, r->at,
                     "'%c': comparisons are not analytic, expected %s", letter,
                     expected);
    return blame(r, r->at, "'%c', expected %s", letter, expected);
}

/* ---- words --------------------------------------------------------------- */

static void skip_blanks(struct reader *r)
{
    while (isspace((unsigned char) *r->at))
        r->at++;
}

static bool take(struct reader *r, char letter)
{
    skip_blanks(r);
    const bool found = *r->at == letter;
    r->at += found;
    return found;
}

static int digits(struct reader *r, formula_real *value)
{
    int n = 0;

    for (; isdigit((unsigned char) *r->at); n++)
        *value = 10 * *value + (*r->at++ - '0');
    return n;
}

/* e5, e-5 behind a number; an e alone is left. */
static int read_exponent(struct reader *r)
{
    const char *at = r->at;
    formula_real value = 0;

    if (*at != 'e' && *at != 'E')
        return 0;
    const bool minus = at[1] == '-';
    r->at += 1 + (minus || at[1] == '+');
    if (digits(r, &value) == 0) {
        r->at = at;
        return 0;
    }
    return (minus ? -1 : 1) * (value < 9999 ? (int) value : 9999);
}

static int read_number(struct reader *r)
{
    const char *at = r->at;
    formula_real value = 0, power = 1, ten = 10;
    int point = 0, n = digits(r, &value);

    if (*r->at == '.') {
        r->at++;
        point = digits(r, &value);
        n += point;
    }
    if (n == 0)
        return blame(r, at, "'.', expected digits");
    const int exponent = read_exponent(r) - point;
    for (int k = exponent < 0 ? -exponent : exponent; k > 0; k /= 2) {
        power = k % 2 ? power * ten : power;
        ten *= ten;
    }
    value = exponent < 0 ? value / power : value * power;
    if (!(value < 1e300) || (value < 1e-300 && value > 0))
        return blame(r, at, "a number beyond 1e-300 ... 1e300");
    return formula_number(r->f, value);
}

/* ---- grammar ------------------------------------------------------------- */

static int read_sum(struct reader *r);

static int blame_depth(struct reader *r)
{
    return blame(r, r->at, "more than %d brackets and powers in one another",
                 PARSE_DEPTH);
}

static int read_bracket(struct reader *r)
{
    if (++r->depth > PARSE_DEPTH)
        return blame_depth(r);
    const int u = read_sum(r);
    r->depth--;
    if (!take(r, ')'))
        return blame_letter(r, "+ - * / ^ or )");
    return u;
}

static int find_function(const char *name, size_t size)
{
    for (int i = 0; i < FUNCTIONS; i++)
        if (functions[i].typed && strlen(functions[i].typed) == size &&
            strncmp(functions[i].typed, name, size) == 0)
            return i;
    return -1;
}

static bool is_word(const char *name, size_t size, const char *const words[])
{
    for (; *words; words++)
        if (strlen(*words) == size && strncmp(*words, name, size) == 0)
            return true;
    return false;
}

static int read_call(struct reader *r, const char *at, size_t size)
{
    static const char *const broken[] = { "abs",   "min",  "max", "floor",
                                          "ceil",  "sign", "mod", "heav",
                                          "round", "if",   NULL };
    const int which = find_function(at, size);

    if (is_word(at, size, broken))
        return blame(r, at, "%.*s is not analytic", (int) size, at);
    if (which < 0)
        return blame(r, at, "unknown function %.*s", (int) size, at);
    return formula_of(r->f, (enum formula_function) which, read_bracket(r));
}

static int read_word(struct reader *r)
{
    /* to 113 bits, in two parts */
    const formula_real pi = (formula_real) 3.14159265358979323846L -
                            (formula_real) 5.0165576126683320236e-20L;
    const char *at = r->at;

    while (isalnum((unsigned char) *r->at) || *r->at == '_')
        r->at++;
    const size_t size = (size_t) (r->at - at);
    const int found = formula_find(r->f, at, size);
    if (found < 0 && take(r, '('))
        return read_call(r, at, size);
    if (found < 0 && size == 2 && strncmp(at, "pi", 2) == 0)
        return formula_number(r->f, pi);
    if (found < 0)
        return blame(r, at, "unknown name %.*s", size > 40 ? 40 : (int) size,
                     at);
    return found;
}

static int read_atom(struct reader *r)
{
    skip_blanks(r);
    if (*r->at == '(') {
        r->at++;
        return read_bracket(r);
    }
    if (isdigit((unsigned char) *r->at) || *r->at == '.')
        return read_number(r);
    if (isalpha((unsigned char) *r->at) || *r->at == '_')
        return read_word(r);
    return blame_letter(r, "a number, a name or (");
}

/* An exponent that changes makes it exp(w ln u). */
static int power(struct reader *r, int u, int w)
{
    struct formula *f = r->f;

    if (formula_is(f, w, 1.0))
        return u;
    if (formula_is(f, w, 2.0))
        return formula_times(f, u, u);
    if (f->node[w].moves || (f->node[u].positive && !f->node[u].moves))
        return formula_of(f, FUNCTION_EXP,
                          formula_times(f, w, formula_of(f, FUNCTION_LN, u)));
    return formula_call(f, FUNCTION_POWER, (int[]){ u, w });
}

static int read_sign(struct reader *r);

static int read_power(struct reader *r)
{
    const int u = read_atom(r);

    if (!take(r, '^'))
        return u;
    if (++r->depth > PARSE_DEPTH)
        return blame_depth(r);
    const int w = read_sign(r);
    r->depth--;
    return power(r, u, w);
}

static int read_sign(struct reader *r)
{
    bool minus = false;

    while (take(r, '-'))
        minus = !minus;
    const int u = read_power(r);
    return minus ? formula_less(r->f, 0, u) : u;
}

static int read_product(struct reader *r)
{
    int u = read_sign(r);

    for (;;)
        if (take(r, '*'))
            u = formula_times(r->f, u, read_sign(r));
        else if (take(r, '/'))
            u = formula_over(r->f, u, read_sign(r));
        else
            return u;
}

static int read_sum(struct reader *r)
{
    int u = read_product(r);

    for (;;)
        if (take(r, '+'))
            u = formula_sum(r->f, u, read_product(r));
        else if (take(r, '-'))
            u = formula_less(r->f, u, read_product(r));
        else
            return u;
}

enum status formula_parse(struct formula *f, const char *text, int *out,
                          struct fault *why)
{
    struct reader r = { .f = f, .text = text, .at = text, .why = why };
    const size_t size = strnlen(text, PARSE_LETTERS + 1);

    if (size > PARSE_LETTERS) {
        blame(&r, text, "the formula is longer than %d letters", PARSE_LETTERS);
        return STATUS_BAD_SCENE;
    }
    const int u = read_sum(&r);
    if (*r.at && !r.failed)
        blame_letter(&r, "+ - * / ^ or the end");
    if (f->full)
        blame(&r, text, "the formula has more than %d parts", FORMULA_NODES);
    if (r.failed)
        return STATUS_BAD_SCENE;
    *out = u;
    return STATUS_OK;
}
