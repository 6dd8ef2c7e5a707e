/* read_lines.h -- formulas written as text (lines.h), evaluated in 113 bits:
 * numbers, names, + - * / ^, functions, if(u<w)then(..)else(..). */
#pragma once

#include <ctype.h>
#include <string.h>

#include "check.h"
#include "function.h"
#include "quad.h"

enum { LINE_NAMES = 160 };

/* What names stand for: the last of the same name counts. */
struct line_scope {
    struct {
        char name[16];
        quad value;
    } known[LINE_NAMES];
    size_t count;
    quad tangent; /* the value of tan() of anything */
};

struct line_reader {
    const struct line_scope *scope;
    const char *at;
};

static inline void line_know(struct line_scope *s, const char *name,
                             size_t size, quad value)
{
    assert_true(s->count < LINE_NAMES && size < 16);
    memcpy(s->known[s->count].name, name, size);
    s->known[s->count].name[size] = '\0';
    s->known[s->count++].value = value;
}

static quad line_sum(struct line_reader *r);

static inline void line_expect(struct line_reader *r, const char *word)
{
    CHECK(strncmp(r->at, word, strlen(word)) == 0, "%s at %.40s", word, r->at);
    r->at += strlen(word);
}

static inline quad line_at(const struct line_scope *s, const char *text)
{
    struct line_reader r = { s, text };
    const quad value = line_sum(&r);

    CHECK(*r.at == '\0', "%.60s after %.900s", r.at, text);
    return value;
}

static inline quad line_plain(const struct line_scope *s, const char *name,
                              const quad u[])
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

/* A function of function.h: its body, with the arguments known. */
static inline quad line_call(const char *name, const quad u[],
                             const struct line_scope *outer)
{
    static const struct line_scope none;
    struct line_scope own = none;
    const struct function *f = functions;

    for (int i = 0; i < FUNCTIONS; i++, f++)
        if (strcmp(f->name, name) == 0)
            break;
    if (f == functions + FUNCTIONS || !f->body)
        return line_plain(outer, name, u);
    const char *argument = f->arguments;
    for (int i = 0; *argument; i++) {
        const size_t size = strcspn(argument, ",");
        line_know(&own, argument, size, u[i]);
        argument += size + (argument[size] == ',');
    }
    return line_at(&own, f->body);
}

static inline quad line_if(struct line_reader *r)
{
    line_expect(r, "(");
    const quad left = line_sum(r);
    const char sign = *r->at;
    line_expect(r, sign == '=' ? "==" : sign == '<' ? "<" : ">");
    const quad right = line_sum(r);
    line_expect(r, ")then(");
    const quad yes = line_sum(r);
    line_expect(r, ")else(");
    const quad no = line_sum(r);
    line_expect(r, ")");
    const bool holds = sign == '='   ? left >= right && left <= right
                       : sign == '<' ? left < right
                                     : left > right;
    return holds ? yes : no;
}

static inline quad line_word(struct line_reader *r)
{
    char name[16] = "";
    quad u[8];
    size_t n = 0;

    while (isalnum((unsigned char) *r->at) || *r->at == '_') {
        assert_true(n < sizeof name - 1);
        name[n++] = *r->at++;
    }
    if (strcmp(name, "if") == 0)
        return line_if(r);
    if (*r->at == '(') {
        for (n = 0; n == 0 || *r->at == ','; n++) {
            r->at++;
            assert_true(n < 8);
            u[n] = line_sum(r);
        }
        line_expect(r, ")");
        return line_call(name, u, r->scope);
    }
    for (size_t i = r->scope->count; i-- > 0;)
        if (strcmp(r->scope->known[i].name, name) == 0)
            return r->scope->known[i].value;
    CHECK(false, "%s is not known yet", name);
    return 0;
}

static inline quad line_atom(struct line_reader *r)
{
    char *end;
    quad value;

    if (*r->at == '(') {
        r->at++;
        value = line_sum(r);
        line_expect(r, ")");
        return value;
    }
    if (!isdigit((unsigned char) *r->at))
        return line_word(r);
    value = strtof128(r->at, &end);
    r->at = end;
    return value;
}

static inline quad line_power(struct line_reader *r)
{
    const quad value = line_atom(r);

    if (*r->at != '^')
        return value;
    r->at++;
    return powq(value, line_atom(r));
}

static inline quad line_product(struct line_reader *r)
{
    quad value = line_power(r);

    while (*r->at == '*' || *r->at == '/')
        if (*r->at++ == '*')
            value *= line_power(r);
        else
            value /= line_power(r);
    return value;
}

/* A sign stands only where a formula, an argument or a bracket begins. */
static quad line_sum(struct line_reader *r)
{
    const bool minus = *r->at == '-';

    r->at += minus;
    quad value = line_product(r);
    value = minus ? -value : value;
    while (*r->at == '+' || *r->at == '-')
        if (*r->at++ == '+')
            value += line_product(r);
        else
            value -= line_product(r);
    return value;
}
