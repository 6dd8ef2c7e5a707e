#include "parse.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "spell.h"

struct reader {
    struct formula *f;
    const char *text, *at;
    struct formula_place place;
    int depth;
    bool failed;
    struct fault *why;
};

/* ---- complaints ---------------------------------------------------------- */

/* "FILE:LINE: " or nothing */
static int write_place(struct formula_place at, char *out, size_t size)
{
    out[0] = '\0';
    if (at.name == NULL)
        return 0;
    if (at.line == 0)
        return snprintf(out, size, "%.180s: ", at.name);
    return snprintf(out, size, "%.180s:%zu: ", at.name, at.line);
}

enum status formula_blame(struct formula_place at, struct fault *why,
                          const char *format, ...)
{
    va_list words;
    int n = 0;

    if (at.name && at.line && at.column)
        n = snprintf(why->text, sizeof why->text, "%.180s:%zu:%zu: ", at.name,
                     at.line, at.column);
    else
        n = write_place(at, why->text, sizeof why->text);
    va_start(words, format);
    vsnprintf(why->text + n, sizeof why->text - (size_t) n, format, words);
    va_end(words);
    return STATUS_BAD_SCENE;
}

/* "line 1, column 5: ", "FILE:LINE: column 5 of the formula: " */
static int write_where(const struct reader *r, int line, int column)
{
    char *out = r->why->text;
    const size_t size = sizeof r->why->text;
    int n = write_place(r->place, out, size);

    if (r->place.name == NULL || line > 1)
        n += snprintf(out + n, size - (size_t) n, "line %d, ", line);
    return n + snprintf(out + n, size - (size_t) n, "column %d%s: ", column,
                        r->place.name ? " of the formula" : "");
}

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
    const int n = write_where(r, line, column);
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

static formula_real read_decimal(struct reader *r)
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
    return value;
}

/* ---- names --------------------------------------------------------------- */

enum { NAMES = FORMULA_DEFINITIONS + FUNCTIONS + 400 };

struct names {
    const char *name[NAMES + 1]; /* NULL-ended */
    int names;
};

static void add_name(struct names *n, const char *name)
{
    if (n->names < NAMES && name && name[0])
        n->name[n->names++] = name;
    n->name[n->names] = NULL;
}

static void add_functions(struct names *n)
{
    for (int i = 0; i < FUNCTIONS; i++)
        add_name(n, functions[i].typed);
    add_name(n, "pi");
    add_name(n, "log10");
    add_name(n, "abs2");
    add_name(n, "acos");
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

static bool is_one(const char *name, size_t size, const char *word)
{
    return strlen(word) == size && strncmp(word, name, size) == 0;
}

static bool is_function(const char *name, size_t size)
{
    return find_function(name, size) >= 0 || is_one(name, size, "abs2") ||
           is_one(name, size, "log10") || is_one(name, size, "acos");
}

bool formula_is_function(const char *name)
{
    return is_function(name, strlen(name));
}

formula_real formula_pi(void)
{
    return (formula_real) 3.14159265358979323846L -
           (formula_real) 5.0165576126683320236e-20L; /* two parts */
}

static bool is_word(const char *name, size_t size, const char *const words[])
{
    for (; *words; words++)
        if (is_one(name, size, *words))
            return true;
    return false;
}

/* A function, or, if it is not called, a name of any kind. */
static int blame_unknown(struct reader *r, const char *at, size_t size,
                         bool called)
{
    struct names known = { .names = 0 };
    char name[41];

    if (!called && is_function(at, size))
        return blame(r, at, "%.*s is a function, expected ( behind it",
                     (int) size, at);
    for (int i = 0; !called && i < r->f->nodes; i++)
        if (r->f->node[i].kind == FORMULA_LEAF)
            add_name(&known, r->f->node[i].name);
    for (int i = 0; !called && i < r->f->definitions; i++)
        add_name(&known, r->f->definition[i].name);
    add_functions(&known);
    snprintf(name, sizeof name, "%.*s", (int) (size < 40 ? size : 40), at);
    const char *near = spell_nearest(name, known.name);
    return blame(r, at, "unknown %s %s%s%s%s", called ? "function" : "name",
                 name, near ? " (did you mean " : "", near ? near : "",
                 near ? "?)" : "");
}

static int read_call(struct reader *r, const char *at, size_t size)
{
    static const char *const broken[] = { "abs",   "min",  "max", "floor",
                                          "ceil",  "sign", "mod", "heav",
                                          "round", "if",   NULL };
    const int which = find_function(at, size);

    if (is_word(at, size, broken))
        return blame(r, at, "%.*s is not analytic", (int) size, at);
    if (which >= 0)
        return formula_of(r->f, (enum formula_function) which, read_bracket(r));
    if (!is_function(at, size))
        return blame_unknown(r, at, size, true);
    const int u = read_bracket(r);
    if (is_one(at, size, "abs2"))
        return formula_times(r->f, u, u);
    if (is_one(at, size, "acos"))
        return formula_less(r->f, formula_number(r->f, formula_pi() / 2),
                            formula_of(r->f, FUNCTION_ASIN, u));
    return formula_over(
        r->f, formula_of(r->f, FUNCTION_LN, u),
        formula_of(r->f, FUNCTION_LN, formula_number(r->f, 10)));
}

static int read_word(struct reader *r)
{
    const char *at = r->at;

    while (isalnum((unsigned char) *r->at) || *r->at == '_')
        r->at++;
    const size_t size = (size_t) (r->at - at);
    const int found = formula_find(r->f, at, size);
    if (found < 0 && take(r, '('))
        return read_call(r, at, size);
    if (found < 0 && is_one(at, size, "pi"))
        return formula_number(r->f, formula_pi());
    return found < 0 ? blame_unknown(r, at, size, false) : found;
}

static int read_atom(struct reader *r)
{
    skip_blanks(r);
    if (*r->at == '(') {
        r->at++;
        return read_bracket(r);
    }
    if (isdigit((unsigned char) *r->at) || *r->at == '.')
        return formula_number(r->f, read_decimal(r));
    if (isalpha((unsigned char) *r->at) || *r->at == '_')
        return read_word(r);
    return blame_letter(r, "a number, a name or (");
}

/* An exponent that changes makes it exp(w ln u); a whole one of what may be < 0
 * is a number. */
static int power(struct reader *r, int u, int w)
{
    struct formula *f = r->f;
    int p;

    if (!f->node[u].positive && formula_whole(f, w, &p))
        w = formula_number(f, p);
    const struct formula_node *n = &f->node[w];
    if (formula_is(f, w, 0.0))
        return formula_number(f, 1);
    if (n->kind == FORMULA_NUMBER && n->number < 0 && !f->node[u].positive)
        return formula_over(f, formula_number(f, 1),
                            power(r, u, formula_number(f, -n->number)));
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

enum status formula_parse_at(struct formula *f, const char *text,
                             struct formula_place at, int *out,
                             struct fault *why)
{
    struct reader r = {
        .f = f, .text = text, .at = text, .place = at, .why = why
    };
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

enum status formula_parse(struct formula *f, const char *text, int *out,
                          struct fault *why)
{
    return formula_parse_at(f, text, (struct formula_place){ .line = 0 }, out,
                            why);
}

enum status formula_parse_decimal(const char *text, struct formula_place at,
                                  formula_real *out, struct fault *why)
{
    struct reader r = { .text = text, .at = text, .place = at, .why = why };
    const bool minus = take(&r, '-');

    if (!minus)
        (void) take(&r, '+');
    skip_blanks(&r);
    if (!isdigit((unsigned char) *r.at) && *r.at != '.') {
        blame_letter(&r, "a decimal");
        return STATUS_BAD_SCENE;
    }
    const formula_real value = read_decimal(&r);
    skip_blanks(&r);
    if (*r.at)
        blame_letter(&r, "the decimal's end");
    if (r.failed)
        return STATUS_BAD_SCENE;
    *out = minus ? -value : value;
    return STATUS_OK;
}
