#include "xpp_lines.h"

#include <ctype.h>
#include <string.h>

struct scanner {
    struct xpp_lines *out;
    const char *name; /* of the file */
    size_t line;      /* where the statement begins */
    struct fault *why;
};

static enum status refuse(const struct scanner *s, const char *reason)
{
    return formula_blame((struct formula_place){ s->name, s->line, 0 }, s->why,
                         "%s", reason);
}

static char *skip(char *at)
{
    while (isspace((unsigned char) *at))
        at++;
    return at;
}

static bool is_letter(char c)
{
    return isalnum((unsigned char) c) || c == '_';
}

static char *end_of_word(char *at)
{
    while (is_letter(*at))
        at++;
    return at;
}

/* Adds a statement; `name` ends where `end` points. */
static enum status add(struct scanner *s, enum xpp_kind kind, const char *name,
                       const char *end, const char *text)
{
    struct xpp_lines *out = s->out;
    struct xpp_statement new = { .kind = kind, .text = text, .line = s->line };

    if (end - name >= FORMULA_NAME || end == name)
        return refuse(s, "a name of 1 to 31 letters was expected");
    if (out->count == XPP_STATEMENTS)
        return refuse(s, "more than 500 statements");
    memcpy(new.name, name, (size_t) (end - name));
    out->at[out->count++] = new;
    return STATUS_OK;
}

/* ---- lists: a=1, b=2 c=3 ------------------------------------------------- */

static enum status read_list(struct scanner *s, enum xpp_kind kind, char *at)
{
    enum status status = STATUS_OK;

    for (at = skip(at); *at && status == STATUS_OK; at = skip(at)) {
        char *const name = at, *const end = end_of_word(at);
        at = skip(end);
        if (*at != '=' && kind != XPP_PARAMETER) { /* left as it is */
            at = end > name ? end : name + 1;
            continue;
        }
        if (*at != '=' || end == name)
            return refuse(s, "NAME=NUMBER was expected");
        char *const text = at = skip(at + 1);
        while (*at && *at != ',' && !isspace((unsigned char) *at))
            at++;
        const bool more = *at != '\0';
        *at = '\0';
        at += more;
        at = skip(at);
        at += *at == ',';
        status = add(s, kind, name, end, text);
    }
    return status;
}

/* ---- directives ---------------------------------------------------------- */

/* What XPPAUT has and a planar flow does not, by its first letters. */
static const struct {
    const char *word, *reason;
} refused[] = {
    { "wi", "wiener: noise, the system is not deterministic" },
    { "w", "wiener: noise, the system is not deterministic" },
    { "glo", "global: jumps, the system is no flow" },
    { "g", "global: jumps, the system is no flow" },
    { "tab", "table: values between points are not analytic" },
    { "t", "table: values between points are not analytic" },
    { "mar", "markov: a random process, the system is not deterministic" },
    { "m", "markov: a random process, the system is not deterministic" },
    { "vol", "volterra: an integral equation, the system is not planar" },
    { "v", "volterra: an integral equation, the system is not planar" },
    { "sol", "solve: an algebraic equation, the system is not planar" },
    { "spe", "special: a network, the system is not planar" },
    { "exp", "export: right-hand sides outside of the file" },
    { "inc", "include: another file" },
    { "opt", "options: another file" },
};

static bool begins(const char *at, const char *word)
{
    return strncmp(at, word, strlen(word)) == 0;
}

static enum status read_directive(struct scanner *s, char *at)
{
    static const char *const unneeded[] = {
        "a", "set", "only", "b", "xp", NULL
    };
    char *const end = end_of_word(at);

    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        const char *word = refused[i].word;
        if (word[1] ? begins(at, word) : end - at == 1 && *at == *word)
            return refuse(s, refused[i].reason);
    }
    if (*at == 'p' || *at == 'n')
        return read_list(s, XPP_PARAMETER, end);
    if (*at == 'i')
        return read_list(s, XPP_START, end);
    for (int i = 0; unneeded[i]; i++)
        if (begins(at, unneeded[i]))
            return STATUS_OK;
    return refuse(s, "no statement that is known");
}

/* ---- equations ----------------------------------------------------------- */

static enum status read_arguments(struct scanner *s, char *at, char *name,
                                  char *name_end)
{
    char *const close = strchr(at, ')');
    char *const equal = close ? skip(close + 1) : NULL;

    if (equal == NULL || *equal != '=')
        return refuse(s, "NAME(ARGUMENT, ...) = FORMULA was expected");
    if (begins(at, "t+1)"))
        return refuse(s, "a map, no flow");
    if (begins(at, "t)") && (strstr(equal, "int{") || strstr(equal, "int[")))
        return refuse(s, "an integral equation, the system is not planar");
    if (begins(at, "0)"))
        return add(s, XPP_START, name, name_end, equal + 1);
    enum status status = add(s, XPP_FUNCTION, name, name_end, equal + 1);
    while (status == STATUS_OK) {
        struct xpp_statement *f = &s->out->at[s->out->count - 1];
        at = skip(at);
        char *const end = end_of_word(at);
        if (end == at || end - at >= FORMULA_NAME ||
            f->arguments == XPP_ARGUMENTS)
            return refuse(s, "1 to 9 names of arguments were expected");
        memcpy(f->argument[f->arguments], at, (size_t) (end - at));
        f->argument[f->arguments++][end - at] = '\0';
        at = skip(end);
        if (at == close)
            break;
        if (*at++ != ',')
            return refuse(s, "a comma between arguments was expected");
    }
    return status;
}

/* dx/dt = FORMULA; at: behind the word dx */
static enum status read_fraction(struct scanner *s, char *word, char *at)
{
    char *const below = skip(at + 1);

    if (*word != 'd' || !begins(below, "dt") || is_letter(below[2]) ||
        *skip(below + 2) != '=')
        return refuse(s, "dNAME/dt = FORMULA was expected");
    return add(s, XPP_RATE, word + 1, end_of_word(word), skip(below + 2) + 1);
}

/* A statement; comments and empty ones are none.  *done: the last. */
static enum status read_statement(struct scanner *s, char *at, bool *done)
{
    at = skip(at);
    char *const word = at, *const end = end_of_word(at);
    char *const next = skip(end);

    if (*at == '\0' || *at == '#' || *at == '"')
        return STATUS_OK;
    if (*at == '@')
        return read_list(s, XPP_OPTION, at + 1);
    if (*at == '!') {
        char *const name = skip(at + 1), *const stop = end_of_word(name);
        return *skip(stop) == '=' ? add(s, XPP_NAME, name, stop, skip(stop) + 1)
                                  : refuse(s, "!NAME = FORMULA was expected");
    }
    if (begins(at, "done") ||
        (*at == 'd' && !is_letter(at[1]) && (*next == '\0' || *next == '#'))) {
        *done = true;
        return STATUS_OK;
    }
    if (*at == '0' && *next == '=')
        return refuse(s, "0 = : an algebraic equation, the system is not "
                         "planar");
    if (*at == '{' || *at == '%' || *at == '[' || *next == '[')
        return refuse(s, "an array or a row of a table, the system is not "
                         "planar");
    if (end == at || isdigit((unsigned char) *at))
        return refuse(s, "no statement that is known");
    if (*next == '=')
        return add(s, XPP_NAME, word, end, next + 1);
    if (*next == '\'' && *skip(next + 1) == '=')
        return add(s, XPP_RATE, word, end, skip(next + 1) + 1);
    if (*next == '(')
        return read_arguments(s, skip(next + 1), word, end);
    if (*next == '/')
        return read_fraction(s, word, next);
    return read_directive(s, at);
}

/* ---- text ---------------------------------------------------------------- */

/* Small letters; ** and log as formulas have them, in the same columns. */
static void make_small(char *at)
{
    for (; *at; at++) {
        *at = (char) tolower((unsigned char) *at);
        if (at[0] == '*' && at[1] == '*')
            memcpy(at, "^ ", 2);
    }
}

static void make_ln(char *text)
{
    for (char *at = text; (at = strstr(at, "log(")) != NULL; at++)
        if (at == text || !is_letter(at[-1]))
            memcpy(at, " ln", 3);
}

/* One line in *at, which goes on where it ends with \; 0-ended in place. */
static char *cut_line(char *at, size_t *lines)
{
    for (; *at; at++) {
        if (*at == '\r')
            *at = ' ';
        if (*at == '\\' && strchr("\r\n", at[1]) && at[1]) {
            *lines += 1;
            *at = ' ';
            if (at[1] == '\r')
                *++at = ' ';
            if (at[1] == '\n')
                *++at = ' ';
        }
        if (*at == '\n') {
            *lines += 1;
            *at = '\0';
            return at + 1;
        }
    }
    return at;
}

enum status xpp_lines_read(const char *text, const char *name,
                           struct xpp_lines *out, struct fault *why)
{
    struct scanner s = { .out = out, .name = name, .line = 1, .why = why };
    const size_t size = strnlen(text, XPP_SIZE + 1);
    enum status status = STATUS_OK;
    bool done = false;

    out->count = 0;
    if (size > XPP_SIZE)
        return formula_blame((struct formula_place){ name, 0, 0 }, why,
                             "more than %d letters", XPP_SIZE);
    memcpy(out->letters, text, size + 1);
    for (char *at = out->letters; *at && !done && status == STATUS_OK;) {
        size_t lines = 0;
        char *const next = cut_line(at, &lines);
        make_small(at);
        make_ln(at);
        status = read_statement(&s, at, &done);
        s.line += lines;
        at = next;
    }
    return status;
}

const char *xpp_option(const struct xpp_lines *lines, const char *name,
                       const char *other)
{
    const char *text = NULL;

    for (int i = 0; i < lines->count; i++)
        if (lines->at[i].kind == XPP_OPTION &&
            (strcmp(lines->at[i].name, name) == 0 ||
             strcmp(lines->at[i].name, other) == 0))
            text = lines->at[i].text;
    return text;
}
