/* XPPAUT 6.11: names of 9 letters, capitals do not count; lines of 1000; no
 * expm1, log1p, asinh (function.h); a sign may follow no other operator; a
 * run ends where anything that is printed exceeds `bound`. */
#include "xppaut.h"

#include "number.h"

static void write_parameters(FILE *out, const struct interchange *x,
                             const struct field_text *f)
{
    for (int i = 0; i < TEXT_PARAMETERS; i++) {
        const enum text_parameter p = (enum text_parameter) i;
        if (!f->uses[p])
            continue;
        fputs("# ", out);
        interchange_meaning(out, p);
        fprintf(out, "\npar %s=%s\n", text_parameters[p].name,
                number_shortest(text_parameter_value(x->block, p)).text);
    }
}

/* Names of the law's own. */
static void write_owns(FILE *out, const struct block *b,
                       const struct field_text *f)
{
    const struct law_typed *t = b->law.typed;

    for (int i = 0; t && i < t->owns; i++)
        if (f->owns[i])
            fprintf(out, "par %s=%s\n", t->own[i].name,
                    number_shortest(b->material.own[i]).text);
}

static void write_functions(FILE *out, const struct field_text *f)
{
    fputs("\n# functions that XPPAUT has not\n", out);
    for (int i = 0; i < FUNCTIONS; i++)
        if (f->lines.calls[i])
            fprintf(out, "# %s\n%s(%s)=%s\n", functions[i].meaning,
                    functions[i].name, functions[i].arguments,
                    functions[i].body);
}

static void write_lines(FILE *out, const struct field_text *f)
{
    fputs("\n# the steady state at lnv0, and differences from there\n", out);
    for (size_t i = 0; i < f->lines.lines; i++)
        fprintf(out, "%s%s=%s\n", f->lines.line[i].moves ? "" : "!",
                f->lines.line[i].name, f->lines.line[i].text);
}

static void write_rates(FILE *out, const char *const state[2],
                        enum xppaut_form form)
{
    if (form == XPPAUT_TIME) {
        fputs("\n# per unit of time\nspeed=exp(min(scale,700))\n", out);
        fprintf(out, "%s'=fx*speed\n%s'=fy*speed\n", state[0], state[1]);
        return;
    }
    fputs("\n# per unit of arc length; dir is -1 backward in time\n"
          "par dir=-1\nnorm=sqrt(fx*fx+fy*fy)\n",
          out);
    fprintf(out, "%s'=dir*fx/norm\n%s'=dir*fy/norm\n", state[0], state[1]);
}

/* What else is of interest along an orbit. */
static void write_aux(FILE *out, bool psi_is_log)
{
    fputs("\naux v=exp(lnv)\n", out);
    if (!psi_is_log)
        fputs("aux psi=exp(lnpsi)\n", out);
    fprintf(out,
            "aux friction=mu\n"
            "# d %s/d ln v: a knee is where it rises through 1\n"
            "aux slope=if(abs(fx)*1e30>abs(fy))then(fy/fx)else(1e30)\n",
            psi_is_log ? "psi" : "ln psi");
}

static void write_start(FILE *out, const char *const state[2], struct vec2 z)
{
    fprintf(out, "%s=%s,%s=%s", state[0], number_shortest(z.x).text, state[1],
            number_shortest(z.y).text);
}

static void write_branches(FILE *out, const char *const state[2],
                           const struct interchange *x)
{
    fputs("\n# Where the series at the saddle ends: xppaut -silent runs each "
          "set and\n# writes NAME.dat, whose last line is the branch's end.\n",
          out);
    for (size_t i = 0; i < x->branches; i++) {
        fprintf(out, "set %s {", x->branch[i].name);
        write_start(out, state, x->branch[i].start);
        fprintf(out, ",total=%.6g}\n", x->branch[i].length);
    }
}

static void write_options(FILE *out, const char *const state[2],
                          const struct interchange *x, enum xppaut_form form)
{
    const bool time = form == XPPAUT_TIME;
    const double total = time ? x->time : x->branch[0].length;

    fprintf(out, "@ xp=%s,yp=%s,bound=1e300,maxstor=100000\n", state[0],
            state[1]);
    fprintf(out, "@ total=%.6g,dt=%.6g\n", total, time ? total / 1000 : 0.05);
    fputs(time ? "@ meth=cvode,toler=1e-9,atoler=1e-9\n"
               : "@ meth=83dp,toler=1e-13,atoler=1e-13\n",
          out);
    fputs("done\n", out);
}

void xppaut_write(FILE *out, const struct interchange *x, enum xppaut_form form)
{
    const struct law *law = &x->block->law;
    const char *const state[2] = { text_state_name(law, 0),
                                   text_state_name(law, 1) };
    struct field_text f;

    field_text(law, &f);
    interchange_remark(out, "# ", x->remarks);
    fputs("\n", out);
    write_parameters(out, x, &f);
    write_owns(out, x->block, &f);
    write_functions(out, &f);
    write_lines(out, &f);
    write_rates(out, state, form);
    write_aux(out, law_psi_is_log(law));
    fputs("\ninit ", out);
    write_start(out, state,
                form == XPPAUT_TIME ? x->start : x->branch[0].start);
    fputs("\n", out);
    if (form == XPPAUT_ARCLENGTH)
        write_branches(out, state, x);
    write_options(out, state, x, form);
}
