/* formula.h -- formulas written as text (expression.h), evaluated in 113 bits:
 * numbers, names, + - * /, functions, if(u<w)then(..)else(..). */
#ifndef TESTS_FORMULA_H
#define TESTS_FORMULA_H

#include <ctype.h>
#include <string.h>

#include "check.h"
#include "quad.h"
#include "scalar_text.h"

enum { FORMULA_NAMES = 160 };

/* What names stand for: the last of the same name counts. */
struct formula_scope {
    struct {
        char name[16];
        quad value;
    } known[FORMULA_NAMES];
    size_t count;
    quad tangent; /* the value of tan() of anything */
};

struct formula_reader {
    const struct formula_scope *scope;
    const char *at;
};

static inline void formula_know(struct formula_scope *s, const char *name,
                                size_t size, quad value)
{
    assert_true(s->count < FORMULA_NAMES && size < 16);
    memcpy(s->known[s->count].name, name, size);
    s->known[s->count].name[size] = '\0';
    s->known[s->count++].value = value;
}

static quad formula_sum(struct formula_reader *r);

static inline void formula_expect(struct formula_reader *r, const char *word)
{
    CHECK(strncmp(r->at, word, strlen(word)) == 0, "%s at %.40s", word, r->at);
    r->at += strlen(word);
}

static inline quad formula_at(const struct formula_scope *s, const char *text)
{
    struct formula_reader r = { s, text };
    const quad value = formula_sum(&r);

    CHECK(*r.at == '\0', "%.60s after %s", r.at, text);
    return value;
}

static inline quad formula_plain(const struct formula_scope *s,
                                 const char *name, const quad u[])
{
    if (strcmp(name, "exp") == 0)
        return expq(u[0]);
    if (strcmp(name, "ln") == 0)
        return logq(u[0]);
    if (strcmp(name, "sqrt") == 0)
        return sqrtq(u[0]);
    if (strcmp(name, "sinh") == 0)
        return sinhq(u[0]);
    if (strcmp(name, "abs") == 0)
        return fabsq(u[0]);
    if (strcmp(name, "sign") == 0)
        return (quad) ((u[0] > 0) - (u[0] < 0));
    if (strcmp(name, "max") == 0)
        return u[0] > u[1] ? u[0] : u[1];
    if (strcmp(name, "min") == 0)
        return u[0] < u[1] ? u[0] : u[1];
    CHECK(strcmp(name, "tan") == 0, "unknown function %s", name);
    return s->tangent;
}

/* A function of scalar_text.h: its body, with the arguments known. */
static inline quad formula_call(const char *name, const quad u[],
                                const struct formula_scope *outer)
{
    static const struct formula_scope none;
    struct formula_scope own = none;
    const struct scalar_text *f = scalar_texts;

    for (int i = 0; i < SCALAR_TEXTS; i++, f++)
        if (strcmp(f->name, name) == 0)
            break;
    if (f == scalar_texts + SCALAR_TEXTS)
        return formula_plain(outer, name, u);
    const char *argument = f->arguments;
    for (int i = 0; *argument; i++) {
        const size_t size = strcspn(argument, ",");
        formula_know(&own, argument, size, u[i]);
        argument += size + (argument[size] == ',');
    }
    return formula_at(&own, f->body);
}

static inline quad formula_if(struct formula_reader *r)
{
    formula_expect(r, "(");
    const quad left = formula_sum(r);
    const char sign = *r->at;
    formula_expect(r, sign == '=' ? "==" : sign == '<' ? "<" : ">");
    const quad right = formula_sum(r);
    formula_expect(r, ")then(");
    const quad yes = formula_sum(r);
    formula_expect(r, ")else(");
    const quad no = formula_sum(r);
    formula_expect(r, ")");
    const bool holds = sign == '='   ? left >= right && left <= right
                       : sign == '<' ? left < right
                                     : left > right;
    return holds ? yes : no;
}

static inline quad formula_word(struct formula_reader *r)
{
    char name[16] = "";
    quad u[8];
    size_t n = 0;

    while (isalnum((unsigned char) *r->at) || *r->at == '_') {
        assert_true(n < sizeof name - 1);
        name[n++] = *r->at++;
    }
    if (strcmp(name, "if") == 0)
        return formula_if(r);
    if (*r->at == '(') {
        for (n = 0; n == 0 || *r->at == ','; n++) {
            r->at++;
            assert_true(n < 8);
            u[n] = formula_sum(r);
        }
        formula_expect(r, ")");
        return formula_call(name, u, r->scope);
    }
    for (size_t i = r->scope->count; i-- > 0;)
        if (strcmp(r->scope->known[i].name, name) == 0)
            return r->scope->known[i].value;
    CHECK(false, "%s is not known yet", name);
    return 0;
}

static inline quad formula_atom(struct formula_reader *r)
{
    char *end;
    quad value;

    if (*r->at == '(') {
        r->at++;
        value = formula_sum(r);
        formula_expect(r, ")");
        return value;
    }
    if (!isdigit((unsigned char) *r->at))
        return formula_word(r);
    value = strtoflt128(r->at, &end);
    r->at = end;
    return value;
}

static inline quad formula_product(struct formula_reader *r)
{
    quad value = formula_atom(r);

    while (*r->at == '*' || *r->at == '/')
        if (*r->at++ == '*')
            value *= formula_atom(r);
        else
            value /= formula_atom(r);
    return value;
}

/* A sign stands only where a formula, an argument or a bracket begins. */
static quad formula_sum(struct formula_reader *r)
{
    const bool minus = *r->at == '-';

    r->at += minus;
    quad value = formula_product(r);
    value = minus ? -value : value;
    while (*r->at == '+' || *r->at == '-')
        if (*r->at++ == '+')
            value += formula_product(r);
        else
            value -= formula_product(r);
    return value;
}

#endif
