/* Statements come in any order: states and parameters first, then each name
 * that a rate needs, behind those it needs itself. */
#include "xpp_model.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "xpp_lines.h"

enum { DEEP = 24 }; /* functions, and names, within one another */

struct reading {
    struct xpp_model *model;
    const char *name;
    struct fault *why;
    struct xpp_lines lines;
    char text[DEEP][PARSE_LETTERS + 2]; /* formulas while they are expanded */
    enum { TIME_REFUSED, TIME_LEAF, TIME_NOTHING } time;
    bool off[XPP_STATEMENTS]; /* parameters that are 0 for good */
};

/* ---- words --------------------------------------------------------------- */

static struct formula_place place_of(const struct reading *r,
                                     const struct xpp_statement *s)
{
    return (struct formula_place){ r->name, s ? s->line : 0, 0 };
}

static bool is_letter(char c)
{
    return isalnum((unsigned char) c) || c == '_';
}

static bool is_word(const char *word, size_t size, const char *name)
{
    return strlen(name) == size && strncmp(word, name, size) == 0;
}

static struct xpp_statement *find(struct reading *r, enum xpp_kind kind,
                                  const char *word, size_t size)
{
    for (int i = 0; i < r->lines.count; i++)
        if (r->lines.at[i].kind == kind &&
            is_word(word, size, r->lines.at[i].name))
            return &r->lines.at[i];
    return NULL;
}

/* The next word that begins with a letter; digits belong to numbers. */
static const char *next_word(const char *at, size_t *size)
{
    while (*at && !isalpha((unsigned char) *at) && *at != '_') {
        if (isdigit((unsigned char) *at) || *at == '.') {
            while (isdigit((unsigned char) *at) || *at == '.')
                at++;
            const char *exponent = at + (*at == 'e');
            exponent += exponent > at && (*exponent == '-' || *exponent == '+');
            if (isdigit((unsigned char) *exponent))
                at = exponent;
        } else {
            at++;
        }
    }
    *size = 0;
    while (is_letter(at[*size]))
        ++*size;
    return at;
}

/* ---- functions written out ----------------------------------------------- */

struct room {
    char *text;
    size_t size;
    bool full;
};

static void put(struct room *out, const char *text, size_t size)
{
    if (out->size + size > PARSE_LETTERS) {
        out->full = true;
        return;
    }
    memcpy(out->text + out->size, text, size);
    out->size += size;
    out->text[out->size] = '\0';
}

/* The argument at `at`: up to its comma or bracket. */
static size_t argument_size(const char *at)
{
    size_t size = 0;
    int depth = 0;

    for (; at[size] && (depth || (at[size] != ',' && at[size] != ')')); size++)
        depth += (at[size] == '(') - (at[size] == ')');
    return size;
}

/* Puts the function's body with (argument) for each argument; `call` is behind
 * the open bracket.  The end of the call, NULL: not as many arguments. */
static const char *put_body(const struct xpp_statement *f, const char *call,
                            struct room *out)
{
    const char *argument[XPP_ARGUMENTS];
    size_t size[XPP_ARGUMENTS], n;

    for (int i = 0; i < f->arguments; i++) {
        argument[i] = call;
        size[i] = argument_size(call);
        call += size[i];
        if (*call != (i + 1 < f->arguments ? ',' : ')'))
            return NULL;
        call++;
    }
    put(out, "(", 1);
    for (const char *at = f->text; *at && !out->full;) {
        const char *word = next_word(at, &n);
        int which = -1;
        put(out, at, (size_t) (word - at));
        for (int i = 0; i < f->arguments; i++)
            which = n && is_word(word, n, f->argument[i]) ? i : which;
        if (which >= 0) {
            put(out, "(", 1);
            put(out, argument[which], size[which]);
            put(out, ")", 1);
        } else {
            put(out, word, n);
        }
        at = word + n;
    }
    put(out, ")", 1);
    return call;
}

/* Adds the formula with its functions written out; bodies at `depth` stand in
 * r->text[depth]. */
static enum status expand(struct reading *r, const struct xpp_statement *s,
                          const char *text, struct room *out, int depth)
{
    size_t n;

    for (const char *at = text; *at;) {
        const char *word = next_word(at, &n);
        put(out, at, (size_t) (word - at));
        const char *behind = word + n;
        while (n && *behind == ' ')
            behind++;
        const struct xpp_statement *f =
            n && *behind == '(' ? find(r, XPP_FUNCTION, word, n) : NULL;
        if (f && depth + 1 == DEEP)
            return formula_blame(place_of(r, s), r->why,
                                 "functions call one another more than %d deep",
                                 DEEP);
        if (f) {
            struct room body = { .text = r->text[depth + 1] };
            at = put_body(f, behind + 1, &body);
            if (at == NULL)
                return formula_blame(place_of(r, s), r->why,
                                     "%s is called without its %d arguments",
                                     f->name, f->arguments);
            out->full = out->full || body.full;
            const enum status status = expand(r, s, body.text, out, depth + 1);
            if (status != STATUS_OK)
                return status;
        } else {
            put(out, word, n);
            at = word + n;
        }
        if (out->full)
            return formula_blame(place_of(r, s), r->why,
                                 "the formula, its functions written out, is "
                                 "longer than %d letters",
                                 PARSE_LETTERS);
    }
    return STATUS_OK;
}

/* ---- names in the order of their needs ----------------------------------- */

/* What makes a system no autonomous plane. */
static const struct {
    const char *word, *reason;
} refused[] = {
    { "t", "depends on t: the system is not autonomous" },
    { "delay", "delay: the system is not planar" },
    { "del_shft", "delay: the system is not planar" },
    { "shift", "shift: the system is not planar" },
    { "int", "an integral: the system is not planar" },
    { "sum", "sum: a network, the system is not planar" },
    { "ran", "ran: noise, the system is not deterministic" },
    { "normal", "normal: noise, the system is not deterministic" },
    { "heav", "heav is not analytic" },
    { "if", "if is not analytic" },
    { "mod", "mod is not analytic" },
    { "sign", "sign is not analytic" },
    { "flr", "flr is not analytic" },
    { "not", "not is not analytic" },
};

/* Adds a name or a rate, its functions written out, behind the names that it
 * needs. */
static enum status add_formula(struct reading *r, const struct xpp_statement *s,
                               int depth);

/* A name that is not there yet is defined. */
static enum status need_word(struct reading *r, const struct xpp_statement *s,
                             const char *word, size_t size, int depth)
{
    struct xpp_statement *name = find(r, XPP_NAME, word, size);

    if (find(r, XPP_RATE, word, size) || find(r, XPP_PARAMETER, word, size))
        return STATUS_OK;
    if (r->time != TIME_REFUSED && is_word(word, size, "t"))
        return STATUS_OK;
    for (size_t i = 0; i < sizeof refused / sizeof *refused && !name; i++)
        if (is_word(word, size, refused[i].word))
            return formula_blame(place_of(r, s), r->why, "%s",
                                 refused[i].reason);
    if (name == NULL || name->state == 2)
        return STATUS_OK; /* the parser knows it, or blames it */
    if (name->state == 1 || depth == DEEP)
        return formula_blame(place_of(r, name), r->why,
                             "%s needs itself, or names %d deep", name->name,
                             DEEP);
    name->state = 1;
    const enum status status = add_formula(r, name, depth + 1);
    name->state = 2;
    return status;
}

static enum status need(struct reading *r, const struct xpp_statement *s,
                        const char *text, int depth)
{
    enum status status = STATUS_OK;
    size_t size;

    for (const char *at = next_word(text, &size); size && status == STATUS_OK;
         at = next_word(at + size, &size))
        status = need_word(r, s, at, size, depth);
    return status;
}

static enum status add_formula(struct reading *r, const struct xpp_statement *s,
                               int depth)
{
    struct room out = { .text = malloc(PARSE_LETTERS + 2) };

    if (out.text == NULL)
        return STATUS_NO_MEMORY;
    out.text[0] = '\0';
    enum status status = expand(r, s, s->text, &out, 0);
    if (status == STATUS_OK)
        status = need(r, s, out.text, depth);
    if (status == STATUS_OK)
        status =
            (s->kind == XPP_RATE ? formula_system_rate : formula_system_define)(
                &r->model->system, s->name, out.text, place_of(r, s), r->why);
    free(out.text);
    return status;
}

/* ---- states, parameters, window ------------------------------------------ */

static double number(const char *text, double otherwise)
{
    struct fault why;
    formula_real value;

    if (text == NULL ||
        formula_parse_decimal(text, (struct formula_place){ .line = 0 }, &value,
                              &why) != STATUS_OK)
        return otherwise;
    return (double) value;
}

/* XPPAUT's torus: a variable that it folds after 2 pi. */
static bool is_folded(struct reading *r, const char *name)
{
    const double turn = 6.283185307;
    bool folded = false;

    for (int i = 0; i < r->lines.count; i++)
        folded = folded || (r->lines.at[i].kind == XPP_OPTION &&
                            strcmp(r->lines.at[i].name, "fold") == 0 &&
                            strcmp(r->lines.at[i].text, name) == 0);
    return folded && fabs(number(xpp_option(&r->lines, "tor_per", ""), turn) -
                          turn) < 0.01;
}

static enum status add_states(struct reading *r, bool angles)
{
    struct formula_system *s = &r->model->system;
    enum status status = STATUS_OK;

    for (int i = 0; i < r->lines.count && status == STATUS_OK; i++) {
        const struct xpp_statement *e = &r->lines.at[i];
        if (e->kind != XPP_RATE)
            continue;
        if (s->states == 2)
            return formula_blame(place_of(r, e), r->why,
                                 "%s is the third variable, expected two",
                                 e->name);
        status = formula_system_state(
            s, e->name,
            angles && is_folded(r, e->name) ? CHART_ANGLE : CHART_REAL, NULL,
            place_of(r, e), r->why);
    }
    if (status == STATUS_OK && s->states < 2)
        return formula_blame(place_of(r, NULL), r->why,
                             "%d variable%s, expected two", s->states,
                             s->states == 1 ? "" : "s");
    return status;
}

static enum status add_parameters(struct reading *r)
{
    struct formula_system *s = &r->model->system;
    enum status status = STATUS_OK;

    for (int i = 0; i < r->lines.count && status == STATUS_OK; i++) {
        const struct xpp_statement *e = &r->lines.at[i];
        if (e->kind != XPP_PARAMETER)
            continue;
        if (r->off[i]) {
            status =
                formula_system_define(s, e->name, "0", place_of(r, e), r->why);
            continue;
        }
        if (strlen(e->text) >= XPP_DECIMAL)
            return formula_blame(place_of(r, e), r->why,
                                 "a number of %d letters or more", XPP_DECIMAL);
        status = formula_system_parameter(s, e->name, e->text, place_of(r, e),
                                          r->why);
        if (status == STATUS_OK)
            strcpy(r->model->decimal[s->parameters - 1], e->text);
    }
    return status;
}

/* What XPPAUT plots, if that is one variable against the other, else the place
 * around the start. */
static void set_window(struct reading *r)
{
    static const char *const plotted[][2] = { { "xplot", "xp" },
                                              { "yplot", "yp" } };
    static const char *const end[][2] = { { "xlo", "xhi" }, { "ylo", "yhi" } };
    struct xpp_model *m = r->model;

    for (int k = 0; k < 2; k++) {
        const char *name = m->system.state[k].name;
        const struct xpp_statement *e = find(r, XPP_START, name, strlen(name));
        m->start[k] = number(e ? e->text : NULL, 0);
        m->lo[k] = m->start[k] - 2 - 2 * fabs(m->start[k]);
        m->hi[k] = m->start[k] + 2 + 2 * fabs(m->start[k]);
    }
    double lo[2], hi[2];
    int first = -1;
    for (int axis = 0; axis < 2; axis++) {
        const char *name =
            xpp_option(&r->lines, plotted[axis][0], plotted[axis][1]);
        const int k = name ? formula_system_find_state(&m->system, name) : -1;
        if (k < 0 || k == first)
            return;
        first = k;
        lo[k] = number(xpp_option(&r->lines, end[axis][0], ""), 1);
        hi[k] = number(xpp_option(&r->lines, end[axis][1], ""), 0);
    }
    for (int k = 0; k < 2; k++)
        if (lo[k] < hi[k]) {
            m->lo[k] = lo[k];
            m->hi[k] = hi[k];
        }
}

static enum status read_system(struct reading *r, bool angles)
{
    struct formula_system *s = &r->model->system;

    for (int i = 0; i < r->lines.count; i++)
        r->lines.at[i].state = 0;
    formula_system_init(s);
    enum status status = add_states(r, angles);
    if (status == STATUS_OK && r->time == TIME_LEAF)
        status =
            formula_system_parameter(s, "t", "1", place_of(r, NULL), r->why);
    if (status == STATUS_OK && r->time == TIME_NOTHING)
        status = formula_system_define(s, "t", "0", place_of(r, NULL), r->why);
    if (status == STATUS_OK)
        status = add_parameters(r);
    for (int i = 0; i < r->lines.count && status == STATUS_OK; i++)
        if (r->lines.at[i].kind == XPP_RATE)
            status = add_formula(r, &r->lines.at[i], 0);
    return status;
}

/* ---- forcing that is off ------------------------------------------------- */

/* Whether the rates do not depend on t, as 0 sin(t) does not: 0 u is 0. */
static bool stands_still(struct reading *r, bool angles)
{
    const struct formula_system *s = &r->model->system;
    bool depends[FORMULA_NODES] = { false };

    r->time = TIME_LEAF;
    if (read_system(r, angles) != STATUS_OK)
        return false;
    const int t = formula_find(&s->graph, "t", 1);
    for (int i = 0; i < s->graph.nodes; i++) {
        const struct formula_node *n = &s->graph.node[i];
        depends[i] = i == t;
        for (int k = 0; k < n->arguments; k++)
            depends[i] = depends[i] || depends[n->of[k]];
    }
    return !depends[s->rate[0]] && !depends[s->rate[1]];
}

/* A forcing whose amplitude is 0: the fewest parameters that are 0 stay so. */
static enum status read_still(struct reading *r, bool angles)
{
    struct fault why = *r->why;

    for (int i = 0; i < r->lines.count; i++)
        r->off[i] = r->lines.at[i].kind == XPP_PARAMETER &&
                    !(number(r->lines.at[i].text, 1) != 0);
    if (!stands_still(r, angles)) {
        *r->why = why;
        return STATUS_BAD_SCENE;
    }
    for (int i = 0; i < r->lines.count; i++)
        if (r->off[i]) {
            r->off[i] = false;
            r->off[i] = !stands_still(r, angles);
        }
    r->time = TIME_NOTHING;
    return read_system(r, angles);
}

/* ---- all ----------------------------------------------------------------- */

static enum status read_whole(struct reading *r, bool angles)
{
    enum status status = read_system(r, angles);

    if (status == STATUS_BAD_SCENE && r->time == TIME_REFUSED)
        status = read_still(r, angles);
    return status ? status
                  : formula_system_finish(&r->model->system, place_of(r, NULL),
                                          r->why);
}

static enum status read_model(struct reading *r, const char *text)
{
    enum status status = xpp_lines_read(text, r->name, &r->lines, r->why);

    if (status != STATUS_OK)
        return status;
    const char *method = xpp_option(&r->lines, "meth", "method");
    if (method && strncmp(method, "disc", 4) == 0)
        return formula_blame(place_of(r, NULL), r->why, "a map, no flow");
    status = read_whole(r, true);
    if (status == STATUS_BAD_SCENE && xpp_option(&r->lines, "fold", ""))
        status = read_whole(r, false); /* folded, but not periodic */
    if (status == STATUS_OK)
        set_window(r);
    return status;
}

enum status xpp_model_read(const char *text, const char *name,
                           struct xpp_model *out, struct fault *why)
{
    struct reading *r = calloc(1, sizeof *r);

    if (r == NULL)
        return STATUS_NO_MEMORY;
    r->model = out;
    r->name = name;
    r->why = why;
    const enum status status = read_model(r, text);
    free(r);
    return status;
}
