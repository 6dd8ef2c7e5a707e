/* AUTO-07p takes equations in C and calls the parameters par[0], par[1], ...;
 * those of the law come to nine at most, before par[9] and what follows, which
 * AUTO needs for itself.  C has expm1, log1p and asinh of its own. */
#include "auto07p.h"

#include <ctype.h>
#include <string.h>

#include "number.h"

/* ---- text as C ----------------------------------------------------------- */

static const struct {
    const char *word, *in_c;
} words[] = {
    { "if", "" },          { "then", " ? " },  { "else", " : " },
    { "ln", "log" },       { "abs", "fabs" },  { "max", "fmax" },
    { "min", "fmin" },     { "em1", "expm1" }, { "ln1p", "log1p" },
    { "asinh0", "asinh" }, { "power", "pow" },
};

static const char *in_c(const char *word, size_t size)
{
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strlen(words[i].word) == size &&
            strncmp(word, words[i].word, size) == 0)
            return words[i].in_c;
    return NULL;
}

static size_t word_size(const char *text)
{
    size_t n = 0;

    while (isalnum((unsigned char) text[n]) || text[n] == '_')
        n++;
    return n;
}

static void write_text(FILE *out, const char *text)
{
    while (*text) {
        const size_t size = word_size(text), n = size ? size : 1;
        const char *other = in_c(text, n);
        fprintf(out, "%.*s", other ? (int) strlen(other) : (int) n,
                other ? other : text);
        text += n;
    }
}

/* "double p_, double u_" of "p_,u_" */
static void write_arguments(FILE *out, const char *arguments)
{
    while (*arguments) {
        const size_t n = word_size(arguments);
        fprintf(out, "double %.*s%s", (int) n, arguments,
                arguments[n] ? ", " : "");
        arguments += n + (arguments[n] == ',');
    }
}

static bool calls_sign(const struct field_text *f)
{
    for (int i = 0; i < FUNCTIONS; i++)
        if (f->lines.calls[i] &&
            function_is_called(functions[i].body, "sign") &&
            !in_c(functions[i].name, strlen(functions[i].name)))
            return true;
    return false;
}

static void write_functions(FILE *out, const struct field_text *f)
{
    if (calls_sign(f))
        fputs("\nstatic double sign(double z_)\n{\n"
              "    return (z_ > 0) - (z_ < 0);\n}\n",
              out);
    for (int i = 0; i < FUNCTIONS; i++) {
        const struct function *s = &functions[i];
        if (!f->lines.calls[i] || in_c(s->name, strlen(s->name)))
            continue;
        fprintf(out, "\n/* %s */\nstatic double %s(", s->meaning, s->name);
        write_arguments(out, s->arguments);
        fputs(")\n{\n    return ", out);
        write_text(out, s->body);
        fputs(";\n}\n", out);
    }
}

/* ---- equations ----------------------------------------------------------- */

static void write_parameters(FILE *out, const struct field_text *f)
{
    int index = 0;

    for (int p = 0; p < TEXT_PARAMETERS; p++) {
        if (!f->uses[p])
            continue;
        fputs("    /* ", out);
        interchange_meaning(out, (enum text_parameter) p);
        fprintf(out, " */\n    const double %s = par[%d];\n",
                text_parameters[p].name, index++);
    }
}

static void write_func(FILE *out, const struct block *b,
                       const struct field_text *f)
{
    const struct law *law = &b->law;

    fputs("\nint func(integer ndim, const doublereal *u, const integer *icp,\n"
          "         const doublereal *par, integer ijac, doublereal *f,\n"
          "         doublereal *dfdu, doublereal *dfdp)\n{\n",
          out);
    write_parameters(out, f);
    for (int i = 0; law->typed && i < law->typed->owns; i++)
        if (f->owns[i])
            fprintf(out, "    const double %s = %s;\n", law->typed->own[i].name,
                    number_shortest(b->material.own[i]).text);
    fputs("    /* the state */\n", out);
    for (int i = 0; i < 2; i++)
        fprintf(out, "    const double %s = u[%d];\n", text_state_name(law, i),
                i);
    fputs("    /* the steady state at lnv0, and differences from there */\n",
          out);
    for (size_t i = 0; i < f->lines.lines; i++) {
        fprintf(out, "    const double %s = ", f->lines.line[i].name);
        write_text(out, f->lines.line[i].text);
        fputs(";\n", out);
    }
    fputs("\n    (void) mu;\n"
          "    f[0] = fx * exp(scale);\n"
          "    f[1] = fy * exp(scale);\n"
          "    return 0;\n}\n",
          out);
}

static void write_stpnt(FILE *out, const struct interchange *x,
                        const struct field_text *f)
{
    int index = 0;

    fputs("\nint stpnt(integer ndim, doublereal t, doublereal *u, "
          "doublereal *par)\n{\n",
          out);
    for (int p = 0; p < TEXT_PARAMETERS; p++)
        if (f->uses[p])
            fprintf(out, "    par[%d] = %s; /* %s */\n", index++,
                    number_shortest(
                        text_parameter_value(x->block, (enum text_parameter) p))
                        .text,
                    text_parameters[p].name);
    fprintf(out, "    u[0] = %s;\n    u[1] = %s;\n    return 0;\n}\n",
            number_shortest(x->steady.x).text,
            number_shortest(x->steady.y).text);
}

/* AUTO links these even where it calls none. */
static void write_unused(FILE *out)
{
    fputs(
        "\nint bcnd(integer ndim, const doublereal *par, const integer *icp,\n"
        "         integer nbc, const doublereal *u0, const doublereal *u1,\n"
        "         integer ijac, doublereal *f, doublereal *dbc)\n"
        "{\n    return 0;\n}\n"
        "\nint icnd(integer ndim, const doublereal *par, const integer *icp,\n"
        "         integer nint, const doublereal *u, const doublereal *uold,\n"
        "         const doublereal *udot, const doublereal *upold,\n"
        "         integer ijac, doublereal *f, doublereal *dint)\n"
        "{\n    return 0;\n}\n"
        "\nint fopt(integer ndim, const doublereal *u, const integer *icp,\n"
        "         const doublereal *par, integer ijac, doublereal *f,\n"
        "         doublereal *dfdu, doublereal *dfdp)\n"
        "{\n    return 0;\n}\n"
        "\nint pvls(integer ndim, const doublereal *u, doublereal *par)\n"
        "{\n    return 0;\n}\n",
        out);
}

void auto07p_write_equations(FILE *out, const struct interchange *x)
{
    struct field_text f;

    field_text(&x->block->law, &f);
    fputs("/*\n", out);
    interchange_remark(out, " * ", x->remarks);
    fputs(" */\n#include \"auto_f2c.h\"\n#include <math.h>\n", out);
    write_functions(out, &f);
    write_func(out, x->block, &f);
    write_stpnt(out, x, &f);
    write_unused(out);
}

/* ---- constants ----------------------------------------------------------- */

static void write_names(FILE *out, const struct law *law)
{
    struct field_text f;
    int index = 0;

    field_text(law, &f);
    fprintf(out, "unames = {1: '%s', 2: '%s'}\nparnames = {",
            text_state_name(law, 0), text_state_name(law, 1));
    for (int p = 0; p < TEXT_PARAMETERS; p++)
        if (f.uses[p]) {
            fprintf(out, "%s%d: '%s'", index ? ", " : "", index + 1,
                    text_parameters[p].name);
            index++;
        }
    fputs("}\nNDIM = 2, IPS = 1, JAC = 0, NTST = 1, NCOL = 4, IAD = 3\n"
          "NBC = 0, NINT = 0, IPLT = 0, NPR = 1000, MXBF = 0\n"
          "ITMX = 20, ITNW = 9, NWTN = 9\n",
          out);
}

void auto07p_write_steady(FILE *out, const struct interchange *x)
{
    fputs("# Steady states in alpha: the folds are the lines LP.\n", out);
    write_names(out, &x->block->law);
    fprintf(out,
            "EPSL = 1e-11, EPSU = 1e-11, EPSS = 1e-9\n"
            "IRS = 0, ISW = 1, ILP = 1, ISP = 0, ICP = ['alpha']\n"
            "NMX = 5000, IID = 2\n"
            "DS = %g, DSMIN = 1e-9, DSMAX = 0.2, IADS = 1\n"
            "UZSTOP = {'alpha': [%.6g, %.6g]}\n",
            0.01 * x->toward, x->alpha[0], x->alpha[1]);
}

/* Accuracies are what AUTO's differences of differences allow. */
void auto07p_write_folds(FILE *out, const struct interchange *x)
{
    const double c = x->block->material.c;

    fputs(
        "# The first fold of s.NAME in alpha and c, through the cusp CP, where "
        "both folds\n# meet, and back along the other.\n",
        out);
    write_names(out, &x->block->law);
    fprintf(out,
            "EPSL = 1e-8, EPSU = 1e-8, EPSS = 1e-6\n"
            "IRS = 'LP1', ISW = 2, ILP = 0, ISP = 2, ICP = ['alpha', 'c']\n"
            "NMX = 2000, IID = 0\n"
            "DS = 0.001, DSMIN = 1e-9, DSMAX = 0.05, IADS = 1\n"
            "UZSTOP = {'c': [%.6g, 100]}\n",
            c > 0.0 ? c / 2.0 : -1e-6);
}

void auto07p_write_script(FILE *out, const struct interchange *x)
{
    const char *name = x->name;

    fprintf(out,
            "# Steady states in alpha, and their folds (LP): auto-07p "
            "%s.auto\n"
            "steady = run('%s')\n"
            "save(steady, '%s')\n",
            name, name, name);
    if (x->has_folds)
        fprintf(out,
                "folds = run('%s', c='%s.folds', s='%s')\n"
                "save(folds, '%s.folds')\n",
                name, name, name, name);
}
